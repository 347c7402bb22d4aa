// Without a module inside: for runtimes that compile modules by themselves, and pages that fetch batten.wasm as a file.
import { loader } from './source.js';

export * from './library.js';
export const load = loader(null);
