// Without a module inside: for runtimes that compile modules by themselves, and pages that fetch batten.wasm as a file.
import { loader } from './source.js';
import { tables } from './whole.js';

export * from './library.js';
export { Picture, Object, Document } from './documents.js';
export { Surface, SurfaceFinder, Tessellation, Relief, Sweep, Mesh, Reference, Binding, Tracks, LineDrawing, Camera, Take, Motion } from './space.js';
export const load = loader(null, tables);
