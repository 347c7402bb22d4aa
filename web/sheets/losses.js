// What overwriting a file would lose: the list, and the question beforehand. Loaded when there is something to lose.

import { totalOf } from '../keep/files.js';
import { answer, question } from './question.js';
import { counted, tell, word } from '../page/words.js';

/** @typedef {import('../engine/losses.js').Losses} Losses */

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

/** @param {Losses} losses @param {string} name @returns {Promise<string>} 'copy', 'lose', or '' for neither */
export function ask(name, losses) {
  return question('lossy', word('shell.may-lose', name), [list(losses)], [answer('copy', word('shell.save-copy')),
    answer('lose', counted('shell.save-lose', totalOf(losses))), answer('', word('command.cancel'))]);
}

/** Shows the list alone. @param {Losses} losses */
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
