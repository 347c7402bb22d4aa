// The drawing, or part of it, in a format of the engine's.

import { Refusal, word } from '../page/words.js';

/**
 * The bytes of that part in a format of the engine's; throws why there are none.
 * @param {import('../engine/engine.js').Engine} engine @param {string} format @param {number} part
 * @param {number} [id] of an object, in place of the part
 * @returns {Uint8Array}
 */
export function excerpt(engine, format, part, id = 0) {
  const problem = engine.scratch + 16; // after where the bytes are told
  const bytes = engine.guard(() => engine.lend(format, (name) => {
    const status = engine.wasm.editor_export(engine.editor, name, part, id, engine.scratch, problem);
    const why = engine.string(problem + engine.layout['problem.message'] - engine.layout['problem.place']);
    return status ? why || engine.string(engine.wasm.status_message(status)) : engine.take();
  }), /** @type {string | Uint8Array} */ (word('shell.not-written')));
  if (typeof bytes === 'string') {
    throw new Refusal(bytes);
  }
  return bytes;
}
