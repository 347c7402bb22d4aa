// What an export holds: a part of the drawing, or each selected object or each layer as a file of its own, by its name; of pictures,
// each size.

import { chosenOf } from '../engine/chosen.js';
import { Refusal, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** id: of the object; 0: the part itself. @typedef {{ id: number, name: string }} Piece */

/** As bat_excerpt counts parts, and behind them. */
export const PARTS = ['shell.the-page', 'shell.everything', 'shell.selection', 'shell.each-selected', 'shell.each-layer'];
export const [SELECTION, EACH_SELECTED, EACH_LAYER] = [2, 3, 4];
const LONGEST = 80; // of a file's name

/** The objects that are selected, without what is in them. @param {Engine} engine @returns {Piece[]} */
const selected = (engine) => chosenOf(engine).filter(({ root }) => root).map(({ id, name, words }) => ({ id, name: name || words.split(',')[0] }));

/** The pieces of a part; throws where there are none. @param {Engine} engine @param {number} part @returns {Piece[]} */
export function piecesOf(engine, part) {
  if (part < EACH_SELECTED) {
    return [{ id: 0, name: '' }];
  }
  const layers = () => engine.layers().layers.filter(({ hidden, depth, members }) => !hidden && !depth && members);
  const found = part === EACH_LAYER ? layers() : selected(engine);
  if (!found.length) {
    throw new Refusal(word(part === EACH_LAYER ? 'shell.no-layer' : 'notice.select-first'));
  }
  return found;
}

/** Names of files, none of them twice, whatever a file system takes for the same. @param {string[]} names @returns {string[]} */
export function namesOf(names) {
  const taken = new Set();
  return names.map((name) => {
    const plain = name.replace(/[\\/:*?"<>|\u0000-\u001f]+/g, '-').replace(/^[\s.]+|[\s.]+$/g, '').slice(0, LONGEST) || word('shell.nameless');
    let one = plain;
    for (let n = 2; taken.has(one.toLowerCase()); n++) {
      one = `${plain} ${n}`;
    }
    taken.add(one.toLowerCase());
    return one;
  });
}
