// Curves and fits with the sketch hand, in less than half the bytes.
import { loader } from './source.js';
import inside from './batten-sketch.wasm.js';
import { tables } from './library.js';

export * from './library.js';
export const load = loader(inside, tables);
