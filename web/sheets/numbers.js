// Position, size and rotation of the selection, entered as text, or without one the size of the page: a section of the
// inspector. The engine's table lists the numbers; the engine formats and parses them.

import { tell } from '../page/words.js';
import { Measure } from '../page/measure.js';
import { PageSize } from './page_size.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */

/** Those that stand two in a row, and the signs that they have there. @type {Record<string, string>} */
const SIGNS = { x: 'X', y: 'Y', width: 'W', height: 'H', z: 'Z', depth: 'D', turn: '∠' };

/** Commands that stand above the numbers, and how many objects or chosen points each needs. @type {[string, number][]} */
const LINE_UP = [['align-left', 1], ['align-centre', 1], ['align-right', 1], ['align-top', 1], ['align-middle', 1], ['align-bottom', 1],
  ['distribute-across', 3], ['distribute-down', 3]];

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').Frame} Frame */

class NumbersSheet {
  /**
   * @param {Panel} panel
   * @param {HTMLElement} sheet
   */
  constructor(panel, sheet) {
    const { engine, wake, buttons, tables: { numbers: names } } = panel;
    this.engine = engine;
    this.row = tell(document.createElement('div'), { label: 'shell.arrange' });
    this.row.className = 'line-up';
    this.row.setAttribute('role', 'group');
    this.buttons = LINE_UP.map(([name, least]) => {
      const button = buttons.plain(name, `command.${name}`, { help: `command.${name}.help`, shortcut: name });
      button.addEventListener('click', () => {
        engine.command(name);
        wake();
      });
      this.row.append(button);
      return { button, least };
    });
    this.rows = names.map((name) => {
      const box = document.createElement('div');
      box.className = name in SIGNS ? 'control number pair' : 'control number';
      const input = document.createElement('input');
      input.type = 'text';
      input.id = `number-${name}`;
      input.autocomplete = 'off';
      const measure = new Measure(input);
      const label = tell(document.createElement('label'), { text: `number.${name}` });
      label.htmlFor = input.id;
      label.dataset.sign = SIGNS[name] ?? '';
      input.addEventListener('change', () => {
        if (input.value === measure.shown) {
          return; // unchanged: the text is rounded, so entering it would move things
        }
        const taken = this.engine.enter(name, input.value);
        measure.judge(!taken);
        if (taken) {
          this.show();
        }
        wake();
      });
      input.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') {
          input.dispatchEvent(new Event('change'));
          if (sheet.dataset.asked && input.getAttribute('aria-invalid') !== 'true') {
            document.getElementById('stage')?.focus(); // where it was asked for
          } else {
            input.select();
          }
        } else if (event.key === 'Escape') {
          measure.show(this.engine.number(name));
          input.blur();
        }
      });
      input.addEventListener('focus', () => input.select());
      input.addEventListener('blur', () => this.show());
      box.append(label, measure.box);
      return { name, box, input, measure };
    });
    sheet.addEventListener('focusout', ({ relatedTarget }) => {
      if (!(relatedTarget instanceof Node && sheet.contains(relatedTarget))) {
        delete sheet.dataset.asked;
      }
    });
    this.page = new PageSize(panel);
    sheet.append(this.row, ...this.rows.map((row) => row.box), this.page.box);
    this.show();
  }

  /** Updates the fields after the selection or its position has changed. @param {Frame} [frame] */
  show(frame) {
    let some = false;
    if (frame) {
      this.row.hidden = frame.selected === 0;
      const points = Number(this.engine.number('points')); // they come before objects
      this.buttons.forEach(({ button, least }) => { button.disabled = (points > 1 ? points : frame.selected) < least; });
    }
    for (const { name, box, input, measure } of this.rows) {
      const text = this.engine.number(name);
      box.hidden = text === '';
      some ||= text !== '';
      if (document.activeElement !== input || input.getAttribute('aria-invalid') === 'false') {
        measure.show(text);
        measure.judge(null);
      }
    }
    this.page.box.hidden = some;
    if (!some) {
      this.page.show();
    }
  }
}

/** @type {import('./panel.js').Filler['fill']} */
export function fill(panel, sheet) {
  return new NumbersSheet(panel, sheet);
}
