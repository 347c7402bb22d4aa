// What a file holds, told before it replaces an edited drawing: its picture, its objects in numbers, what cannot be kept
// of it. Loaded with the first such question.

import { figure } from './compare.js';
import { answer, question } from './question.js';
import { lossList, made, tally } from './losses.js';
import { counted, word } from '../page/words.js';
import { dress } from '../page/build.js';

const SHOWN = 1 << 20; // bytes: the browser paints a larger file too slowly

/** @typedef {{ kinds: { words: string, count: number }[], page: string[] }} Holds */
/** @typedef {{ svg: Uint8Array, holds: Holds, losses: import('../engine/losses.js').Losses, lost: number, keeps: boolean }} Content */

/** The page and each kind of object with its number. @param {Holds} holds */
function numbers({ kinds, page }) {
  const rows = kinds.map(({ words, count }) => /** @type {[string, string]} */ ([words, String(count)]));
  if (page[0]) {
    rows.unshift([word('shell.holds-page'), page.join(' × ')]);
  }
  return tally(rows.length ? rows : [[word('shell.holds-nothing'), '']]);
}

/**
 * @param {import('../keep/files.js').Files} files @param {string} name @param {Content} content
 * @returns {Promise<string>} 'open', 'add', or '' for neither
 */
export async function askToOpen(files, name, { svg, holds, losses, lost, keeps }) {
  await dress('styles/compare.css');
  const both = document.createElement('div');
  both.className = 'both';
  const box = document.createElement('div');
  box.append(numbers(holds));
  if (lost) {
    box.append(made(counted(keeps ? 'shell.unshown' : 'shell.loses', lost), 'p'), ...(keeps ? [] : [lossList(losses)]));
  }
  both.append(...(svg.length <= SHOWN ? [figure(svg, name)] : []), box);
  const words = word(files.unsaved ? 'shell.may-replace' : 'shell.may-close', files.name);
  return question('holds', words, [both], [answer('add', word('shell.add-to')), answer('open', word(files.unsaved ? 'shell.replace' : 'command.open')),
    answer('', word('shell.keep'))]);
}
