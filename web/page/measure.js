// A field of two parts: the number that is typed, and its unit in the soft tone inside the field's frame.

import { tell } from './words.js';

export class Measure {
  /** @param {HTMLInputElement} input which has its id */
  constructor(input) {
    this.input = input;
    this.shown = '';
    this.unit = document.createElement('span');
    this.unit.id = `${input.id}-unit`;
    this.unit.className = 'unit';
    this.box = document.createElement('span');
    this.box.className = 'measure';
    this.box.dir = 'auto'; // a measure reads as its unit does, whatever is around it
    this.box.append(input, this.unit);
    input.setAttribute('aria-describedby', this.unit.id);
    // Whoever types a unit says another one, or this one again.
    input.addEventListener('input', () => { this.unit.hidden = !/^[\d\s.,()+*/-]*$/.test(input.value); });
  }

  /** Shows whether what is typed is taken, and what would be. @param {boolean | null} wrong null: nothing is typed */
  judge(wrong) {
    const { input } = this;
    if (wrong) {
      tell(input, { help: 'shell.number-refused.help' });
    } else {
      delete input.dataset.help;
      input.removeAttribute('title');
    }
    input.ariaInvalid = wrong === null ? null : String(wrong);
  }

  /** @param {string} text a number and its unit */
  show(text) {
    const number = /^\S*\d/.exec(text)?.[0] ?? '';
    this.input.value = this.shown = number;
    this.unit.textContent = text.slice(number.length).trim();
    this.unit.hidden = false;
  }
}
