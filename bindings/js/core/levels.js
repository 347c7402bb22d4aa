// Curves, fits, points with directions and levels of detail, in less than half the bytes.
import { loader } from './source.js';
import inside from './batten-levels.wasm.js';
import { tables } from './library.js';

export * from './library.js';
export const load = loader(inside, tables);
