// What does not look here as it does in the file, object by object, and what overwriting a file would lose: the lists, and
// the questions beforehand. Loaded when there is something to tell.

import { totalOf } from '../keep/files.js';
import { answer, question } from './question.js';
import { counted, tell, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/losses.js').Losses} Losses */
/** @typedef {{ rows: { id: number, words: string, lost: string[] }[], total: number }} Unshown */

/** What a kind of loss is called. @param {string} key */
const named = (key) => (word(`loss.${key}.help`) || key).replace(/\.$/, '');

/** The objects that do not look as they do in the file. @param {Engine} engine @returns {Unshown} */
export const unshownOf = (engine) => JSON.parse(engine.ask('editor_unshown') || '{"rows":[],"total":0}');

/** @param {string} text @param {string} tag */
export function made(text, tag) {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}

/**
 * A row an object: its name, and what of it is not shown. With `choose` the name is a button.
 * @param {Unshown} unshown
 * @param {(id: number) => void} [choose]
 */
function objects(unshown, choose) {
  const rows = made('', 'ul');
  rows.className = 'losses';
  rows.id = 'unshown';
  for (const { id, words, lost } of unshown.rows) {
    const row = made('', 'li');
    const name = made(words, choose ? 'button' : 'span');
    if (choose && name instanceof HTMLButtonElement) {
      name.type = 'button';
      name.addEventListener('click', () => choose(id));
    }
    row.append(name, ' ', made(lost.map(named).join(', '), 'span'));
    rows.append(row);
  }
  if (unshown.total > unshown.rows.length) {
    rows.append(made(word('shell.unshown-more.help', unshown.total - unshown.rows.length), 'li'));
  }
  return rows;
}

/** What there is, and how much of it, a row each. @param {[string, string][]} all */
export function tally(all) {
  const rows = made('', 'ul');
  rows.className = 'losses';
  for (const [words, value] of all) {
    const row = made('', 'li');
    row.append(words, ' ', made(value, 'b'));
    rows.append(row);
  }
  return rows;
}

/** @param {Losses} losses */
export const lossList = (losses) => tally(Object.entries(losses).map(([key, count]) => [named(key), String(count)]));

/** @param {Losses} losses @param {string} name @returns {Promise<string>} 'copy', 'lose', or '' for neither */
export function ask(name, losses) {
  return question('lossy', word('shell.may-lose', name), [lossList(losses)], [answer('copy', word('shell.save-copy')),
    answer('lose', counted('shell.save-lose', totalOf(losses))), answer('', word('command.cancel'))]);
}

/**
 * Before the first save over a file of which not all is shown as it is there. @param {string} name @param {Unshown} unshown
 * @returns {Promise<string>} 'save', 'copy', or '' for neither
 */
export function askInexact(name, unshown) {
  return question('inexact', word('shell.save-inexact.help', name), [objects(unshown)], [answer('save', word('command.save')),
    answer('copy', word('shell.save-copy')), answer('', word('command.cancel'))]);
}

/**
 * Before an edit that the file cannot hold as it is. @param {string} name @param {Losses} losses
 * @returns {Promise<string>} 'save', 'copy', or '' for neither
 */
export function askAnew(name, losses) {
  return question('anew', word('shell.save-anew.help', name), [lossList(losses)], [answer('copy', word('shell.save-copy')),
    answer('save', word('shell.save-anew')), answer('', word('command.cancel'))]);
}

/** Shows the lists alone. @param {Engine} engine @param {() => void} wake */
export function show(engine, wake) {
  const old = document.getElementById('losses');
  const sheet = old ?? tell(document.createElement('div'), { label: 'command.losses' });
  const unshown = unshownOf(engine);
  if (!old) {
    Object.assign(sheet, { id: 'losses', className: 'sheet', popover: 'auto', tabIndex: -1 });
    sheet.setAttribute('role', 'dialog');
    document.body.append(sheet);
  }
  sheet.replaceChildren(tell(document.createElement('h2'), { text: 'command.losses' }));
  if (unshown.total) {
    const choose = (/** @type {number} */ id) => {
      engine.act('editor_select', id, 0);
      wake();
    };
    sheet.append(tell(document.createElement('p'), { text: 'shell.unshown-objects.help' }), objects(unshown, choose),
      tell(document.createElement('h2'), { text: 'shell.unshown-file' }));
  }
  sheet.append(lossList(engine.losses));
  sheet.showPopover();
  sheet.focus();
}
