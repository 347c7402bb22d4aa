// What a file holds, told before it replaces an edited drawing: its picture, its objects in numbers, what cannot be kept
// of it. A separate engine reads it. Loaded with the first such question.

import { Engine } from '../engine/engine.js';
import { figure } from './compare.js';
import { answer, question } from './question.js';
import { lossList, made, tally } from './losses.js';
import { readInto, totalOf } from '../keep/files.js';
import { counted, word } from '../page/words.js';
import { dress } from '../page/build.js';

/** @typedef {{ kinds: { words: string, count: number }[], page: string[] }} Holds */
/** @typedef {{ svg: Uint8Array, holds: Holds, losses: import('../engine/losses.js').Losses, keeps: boolean }} Content */

/**
 * Reads a file beside the drawing. Throws the reader's refusal.
 * @param {Engine} engine of the drawing @param {Uint8Array} bytes @param {string} name @returns {Content}
 */
export function holdsOf(engine, bytes, name) {
  const other = new Engine(engine.module);
  if (engine.words) {
    other.speak(engine.words);
  }
  readInto(other, bytes, name);
  return { svg: other.save(false), holds: JSON.parse(other.ask('editor_holds')), losses: other.losses, keeps: other.keeps };
}

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
export async function askToOpen(files, name, { svg, holds, losses, keeps }) {
  await dress('styles/compare.css');
  const both = document.createElement('div');
  both.className = 'both';
  const box = document.createElement('div');
  box.append(numbers(holds));
  const lost = totalOf(losses);
  if (lost) {
    box.append(made(counted(keeps ? 'shell.unshown' : 'shell.loses', lost), 'p'), ...(keeps ? [] : [lossList(losses)]));
  }
  both.append(figure(svg, name), box);
  const words = word(files.unsaved ? 'shell.may-replace' : 'shell.may-close', files.name);
  return question('holds', words, [both], [answer('add', word('shell.add-to')), answer('open', word('shell.replace')),
    answer('', word('shell.keep'))]);
}
