// Batten in JavaScript, with all of curves and hands.
import { loader } from './source.js';
import inside from './batten.wasm.js';

export * from './library.js';
export const load = loader(inside);
