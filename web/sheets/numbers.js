// Position, size and rotation of the selection, entered as text: a section of the inspector. The engine's table lists the
// numbers; the engine formats and parses them.

import { tell } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */

/** Those that stand two in a row, and the signs that they have there. @type {Record<string, string>} */
const SIGNS = { x: 'X', y: 'Y', width: 'W', height: 'H', turn: '∠' };

class NumbersSheet {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   * @param {HTMLElement} sheet
   * @param {string[]} names
   */
  constructor(engine, wake, sheet, names) {
    this.engine = engine;
    this.rows = names.map((name) => {
      const box = document.createElement('div');
      box.className = name in SIGNS ? 'control number pair' : 'control number';
      const input = document.createElement('input');
      input.type = 'text';
      input.id = `number-${name}`;
      input.autocomplete = 'off';
      const label = tell(document.createElement('label'), { text: `number.${name}` });
      label.htmlFor = input.id;
      label.dataset.sign = SIGNS[name] ?? '';
      input.addEventListener('change', () => {
        if (input.value === this.engine.number(name)) {
          return; // unchanged: the text is rounded, so entering it would move things
        }
        const taken = this.engine.enter(name, input.value);
        input.setAttribute('aria-invalid', String(!taken));
        if (taken) {
          this.show();
        }
        wake();
      });
      input.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') {
          input.dispatchEvent(new Event('change'));
          input.select();
        } else if (event.key === 'Escape') {
          input.value = this.engine.number(name);
          input.blur();
        }
      });
      input.addEventListener('focus', () => input.select());
      input.addEventListener('blur', () => this.show());
      box.append(label, input);
      return { name, box, input };
    });
    this.none = tell(document.createElement('p'), { text: 'notice.select-first' });
    sheet.append(...this.rows.map((row) => row.box), this.none);
    this.show();
  }

  /** Updates the fields after the selection or its position has changed. */
  show() {
    let some = false;
    for (const { name, box, input } of this.rows) {
      const text = this.engine.number(name);
      box.hidden = text === '';
      some ||= text !== '';
      if (document.activeElement !== input || input.getAttribute('aria-invalid') === 'false') {
        input.value = text;
        input.removeAttribute('aria-invalid');
      }
    }
    this.none.hidden = some;
  }
}

/** @type {import('./panel.js').Filler['fill']} */
export function fill({ engine, wake, tables }, sheet) {
  const numbers = new NumbersSheet(engine, wake, sheet, tables.numbers);
  return numbers;
}
