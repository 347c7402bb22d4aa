// What is typed before the sheet of commands is shown goes into its search, not into the drawing. Fetched at the first sign of a user.

import { belongsToControl } from '../stage/input.js';
import { shortcutOf } from './keys.js';

const PATIENCE = 2000; // milliseconds until what is typed means the drawing again, if no sheet comes

/** @param {import('../main.js').Shell} shell */
export function keepTyped({ requests, words }) {
  const menu = /** @type {HTMLElement} */ (document.getElementById('menu'));
  /** What was typed since the sheet was asked for. @type {string | null} */
  let typed = null;
  let timer = 0;
  const end = () => {
    clearTimeout(timer);
    typed = null;
  };
  void requests.commandSheet(); // it is there when it is asked for
  addEventListener('keydown', (event) => {
    const { key } = event;
    const field = belongsToControl(event);
    if (typed === null) {
      const keys = words.tables.commands.find(({ name }) => name === 'shortcuts')?.keys ?? [];
      if (!field && !menu.matches(':popover-open') && keys.includes(shortcutOf(event))) {
        typed = '';
        timer = setTimeout(end, PATIENCE);
      }
    } else if (!field && key.length === 1 && !event.ctrlKey && !event.metaKey && !event.altKey) {
      typed += key;
      event.preventDefault();
      event.stopImmediatePropagation();
    } else if (key === 'Escape') {
      end();
    }
  }, true);
  // Its search has the focus as soon as the sheet is open, before any event tells that it is.
  menu.addEventListener('focusin', ({ target }) => {
    const search = requests.commands?.search;
    if (typed === null || !search || target !== search) {
      return;
    }
    search.value = typed + search.value;
    end();
    search.dispatchEvent(new Event('input'));
  });
}
