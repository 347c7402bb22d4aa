// What writing over a file would lose: a list of it, and the question before. Loaded when there is something to tell.

import { totalOf } from './files.js';
import { counted, tell, word } from './words.js';

/** @typedef {import('./engine.js').Losses} Losses */

/** @param {Losses} losses */
function list(losses) {
  const rows = document.createElement('ul');
  rows.className = 'losses';
  for (const [key, count] of Object.entries(losses)) {
    const row = document.createElement('li');
    const number = document.createElement('b');
    number.textContent = String(count);
    row.append((word(`loss.${key}.help`) || key).replace(/\.$/, ''), ' ', number);
    rows.append(row);
  }
  return rows;
}

/** @param {string} value @param {string} text */
function answer(value, text) {
  const button = document.createElement('button');
  button.value = value;
  button.textContent = text;
  return button;
}

/**
 * Asks, before a file is written over.
 * @param {string} name
 * @param {Losses} losses
 * @returns {Promise<string>} 'copy', 'lose', or '' for neither
 */
export function ask(name, losses) {
  const dialog = document.createElement('dialog');
  const form = document.createElement('form');
  const text = document.createElement('p');
  const answers = document.createElement('div');
  Object.assign(dialog, { id: 'lossy', className: 'question' });
  dialog.setAttribute('aria-labelledby', 'lossy-text');
  text.id = 'lossy-text';
  text.textContent = word('shell.may-lose', name);
  form.method = 'dialog';
  answers.className = 'answers';
  const copy = answer('copy', word('shell.save-copy'));
  copy.className = 'strong';
  copy.autofocus = true;
  answers.append(copy, answer('lose', counted('shell.save-lose', totalOf(losses))), answer('', word('command.cancel')));
  form.append(text, list(losses), answers);
  dialog.append(form);
  document.body.append(dialog);
  dialog.addEventListener('keydown', (event) => {
    event.stopPropagation(); // nothing of it is for the drawing
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault(); // nor does the browser save the page
    }
  });
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue);
    }, { once: true });
  });
}

/** The list alone, to look at. @param {Losses} losses */
export function show(losses) {
  const old = document.getElementById('losses');
  const sheet = old ?? tell(document.createElement('div'), { label: 'command.losses' });
  if (!old) {
    Object.assign(sheet, { id: 'losses', className: 'sheet', popover: 'auto', tabIndex: -1 });
    sheet.setAttribute('role', 'dialog');
    document.body.append(sheet);
  }
  sheet.replaceChildren(tell(document.createElement('h2'), { text: 'command.losses' }), list(losses));
  sheet.showPopover();
  sheet.focus();
}
