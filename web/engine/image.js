// A copy of all that an engine is, and going on from it in another one of the same build: both are the module's memory, as all of
// its state is there between two calls.

/** @typedef {import('./engine.js').Engine} Engine */
/**
 * @typedef {object} Image
 * @property {Uint8Array<ArrayBuffer>} memory
 * @property {number} editor @property {number} scratch @property {number} events addresses in it
 * @property {number} long @property {number[]} size @property {boolean} readOnly
 */

const PAGE = 1 << 16; // bytes: what a memory grows by

/** @param {Engine} engine @returns {Image} */
export function imageOf({ wasm, editor, scratch, events, long, size, readOnly }) {
  return { memory: new Uint8Array(wasm.memory.buffer).slice(), editor, scratch, events, long, size, readOnly };
}

/**
 * Goes on as the engine did of which this is a copy, with the window and the permission that it has by now.
 * @param {Engine} engine @param {Image} image @param {boolean} opened the drawing is another one
 */
export function adopt(engine, { memory, editor, scratch, events, long }, opened) {
  const { wasm } = engine;
  const more = Math.ceil((memory.length - wasm.memory.buffer.byteLength) / PAGE);
  if (more > 0) {
    wasm.memory.grow(more);
  }
  new Uint8Array(wasm.memory.buffer).set(memory);
  Object.assign(engine, { editor, scratch, events, long, stillVersion: -1 });
  wasm.editor_resize(editor, ...engine.size);
  wasm.editor_read_only(editor, Number(engine.readOnly));
  if (opened) {
    engine.begun(new Uint8Array(0)); // to be copied afresh
  }
}
