import { Batten, Wasm } from './index.js';
export * from './index.js';
/** Loads the library of a module that the caller has: batten.wasm, batten-sketch.wasm or batten-levels.wasm of this package. */
export function load(options: { wasm: Wasm }): Promise<Batten>;
