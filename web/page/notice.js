// Notices: what has just happened, told to screen readers, too. One that passes goes by itself, and at the latest when the
// next stroke begins. One that asks for something stays until it is answered, closed or over; they stand one above the
// other, so that none hides another.

import { word } from './words.js';

/** @typedef {{ label: string, run: () => void }} Answer */

const SHORT = 5000; // milliseconds that a notice stays when it asks for nothing

export class Notices {
  constructor() {
    this.box = /** @type {HTMLElement} */ (document.getElementById('notice'));
    this.text = /** @type {HTMLElement} */ (document.getElementById('notice-text'));
    this.asked = /** @type {HTMLElement} */ (document.getElementById('asked'));
    this.timer = 0;
  }

  /** Something passing. @param {string} text */
  say(text) {
    clearTimeout(this.timer);
    this.text.textContent = text;
    this.box.hidden = false;
    this.timer = setTimeout(() => this.pass(), SHORT);
  }

  /** What passes is over. */
  pass() {
    this.box.hidden = true;
    this.text.textContent = '';
  }

  /**
   * @param {string} about another one about the same takes its place
   * @param {string} text
   * @param {Answer[]} answers each ends it
   * @param {boolean} [fixed] it cannot be closed: it says what is so
   */
  ask(about, text, answers, fixed = false) {
    this.over(about);
    const box = document.createElement('div');
    box.className = 'notice';
    box.dataset.about = about;
    const said = document.createElement('span');
    said.textContent = text;
    const close = { label: '×', run: () => {} };
    const buttons = [...answers, ...(fixed ? [] : [close])].map(({ label, run }) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = label;
      button.addEventListener('click', () => {
        this.over(about);
        run();
      });
      return button;
    });
    if (!fixed) {
      buttons[answers.length].ariaLabel = word('step.close');
    }
    const row = document.createElement('div');
    row.append(...buttons);
    box.append(said, row);
    this.asked.append(box);
  }

  /** There is nothing to ask any more. @param {...string} abouts */
  over(...abouts) {
    for (const about of abouts) {
      const box = this.asked.querySelector(`[data-about="${about}"]`);
      if (box?.contains(document.activeElement)) {
        document.getElementById('stage')?.focus();
      }
      box?.remove();
    }
  }
}
