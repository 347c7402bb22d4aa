// Notices: what has just happened, announced to screen readers too. A passing notice disappears by itself, at the
// latest when the next stroke begins. A notice that asks for something stays until it is answered, closed or obsolete;
// such notices are stacked, so that none hides another.

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

  /**
   * Shows a passing notice.
   * @param {string} text
   * @param {Answer | null} [offer] what it offers to do about it
   */
  say(text, offer = null) {
    clearTimeout(this.timer);
    this.text.textContent = text;
    this.box.querySelector('button')?.remove();
    if (offer) {
      this.box.append(this.#button(offer.label, () => {
        this.pass();
        offer.run();
      }));
    }
    this.box.hidden = false;
    this.timer = setTimeout(() => this.pass(), SHORT);
  }

  /** @param {string} label @param {() => void} run */
  #button(label, run) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = label;
    button.addEventListener('click', run);
    return button;
  }

  /** Removes the passing notice. */
  pass() {
    this.box.hidden = true;
    this.text.textContent = '';
  }

  /**
   * @param {string} about a later notice about the same thing replaces it
   * @param {string} text
   * @param {Answer[]} answers any of them closes it
   * @param {boolean} [fixed] it cannot be closed: it describes a lasting state
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
      return this.#button(label, () => {
        this.over(about);
        run();
      });
    });
    if (!fixed) {
      buttons[answers.length].ariaLabel = word('step.close');
    }
    const row = document.createElement('div');
    row.append(...buttons);
    box.append(said, row);
    this.asked.append(box);
  }

  /** Whether a notice about it is shown. @param {string} about */
  asks(about) {
    return this.asked.querySelector(`[data-about="${about}"]`) !== null;
  }

  /** Removes the notices about things that are settled. @param {...string} abouts */
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
