// What was done, step by step: choosing a step goes back to it, or forward. Fetched when it is first asked for.

import { tell, word } from '../page/words.js';

/** @typedef {{ done: number, steps: string[] }} History */

/** @type {HTMLElement | undefined} */
let sheet;

/**
 * @param {import('../engine/engine.js').Engine} engine
 * @param {() => void} wake
 */
export function show(engine, wake) {
  if (!sheet) {
    sheet = document.createElement('div');
    sheet.id = 'history';
    sheet.className = 'sheet';
    sheet.setAttribute('popover', '');
    document.body.append(sheet);
  }
  const list = document.createElement('ul');
  list.className = 'commands';
  const fill = () => {
    const { done, steps } = /** @type {History} */ (JSON.parse(engine.ask('editor_history') || '{"done":0,"steps":[]}'));
    list.replaceChildren(...['', ...steps].map((text, at) => {
      const button = document.createElement('button');
      button.textContent = at ? `${at}. ${text}` : word('history.begin');
      button.setAttribute('aria-current', String(at === done));
      button.style.opacity = at > done ? '0.55' : '';
      button.addEventListener('click', () => {
        engine.act('editor_go', at);
        wake();
        fill();
        /** @type {HTMLElement} */ (list.children[at].firstChild).focus();
      });
      const row = document.createElement('li');
      row.append(button);
      return row;
    }));
    return list.children[done];
  };
  const now = fill();
  sheet.replaceChildren(tell(document.createElement('h2'), { text: 'command.history' }), list);
  sheet.showPopover();
  now.scrollIntoView({ block: 'nearest' });
  /** @type {HTMLElement} */ (now.firstChild).focus();
}
