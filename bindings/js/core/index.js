// Batten in JavaScript, whole.
import { loader } from './source.js';
import inside from './batten.wasm.js';
import { tables } from './whole.js';

export * from './library.js';
export { Picture, Object, Document } from './documents.js';
export { Surface, SurfaceFinder, Tessellation, Relief, Sweep, Mesh, Reference, Binding, Tracks, LineDrawing, Camera, Take, Motion } from './space.js';
export const load = loader(inside, tables);
