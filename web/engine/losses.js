// What a file contains and the drawing made from it does not, counted by kind.

/** @typedef {import('./instance.js').Instance} Instance */
/** @typedef {Record<string, number>} Losses count by kind */

/** @param {Instance} module @returns {Losses} */
export function readLosses(module) {
  return module.guard(() => {
    const counts = module.wasm.editor_losses(module.editor);
    /** @type {Losses} */
    const losses = {};
    for (let kind = 0, key = 0; (key = module.wasm.loss_key(kind)); kind++) {
      const count = module.view().getInt32(counts + 4 * kind, true);
      if (count > 0) {
        losses[module.string(key)] = count;
      }
    }
    return losses;
  }, {});
}

/** @param {Instance} module @param {Losses} losses */
export function writeLosses(module, losses) {
  module.guard(() => {
    /** @type {number[]} */
    const counts = [];
    for (let key = 0; (key = module.wasm.loss_key(counts.length));) {
      counts.push(losses[module.string(key)] ?? 0);
    }
    module.lend(new Uint8Array(new Int32Array(counts).buffer), (at) => module.wasm.editor_set_losses(module.editor, at));
  }, undefined);
}
