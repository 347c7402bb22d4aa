// The chips at the end of a stroke: what else it could mean. A tap reads the stroke that way; they go when the next begins.

import { dress } from '../page/build.js';
import { word } from '../page/words.js';

/**
 * @typedef {object} Readings
 * @property {number[]} at the stroke's end, view pixels
 * @property {number} chosen
 * @property {string[]} words none: the stroke is settled
 */

const AWAY = 16; // px from the stroke's end
const EDGE = 4;

export class Chips {
  /** @param {import('../engine/engine.js').Engine} engine @param {HTMLElement} stage @param {() => void} wake */
  constructor(engine, stage, wake) {
    this.engine = engine;
    this.stage = stage;
    this.wake = wake;
    void dress('styles/chips.css').then(() => this.#place());
    this.box = document.createElement('div');
    this.box.className = 'chips';
    this.box.setAttribute('role', 'group');
    this.box.hidden = true;
    this.at = [0, 0];
    stage.after(this.box);
  }

  /** @param {boolean} some */
  show(some) {
    const { at, chosen, words } = some ? this.engine.readings() : { at: [0, 0], chosen: -1, words: [] };
    this.at = at;
    this.box.hidden = words.length === 0;
    this.box.setAttribute('aria-label', word('command.reading-next'));
    this.box.replaceChildren(...words.map((text, i) => this.#chip(text, i, i === chosen)));
    this.#place();
  }

  /** @param {string} text @param {number} index @param {boolean} chosen */
  #chip(text, index, chosen) {
    const chip = document.createElement('button');
    chip.type = 'button';
    chip.textContent = text;
    chip.setAttribute('aria-pressed', String(chosen));
    chip.addEventListener('click', () => {
      this.engine.readAs(index);
      this.wake();
    });
    return chip;
  }

  /** Beside the stroke's end, inside the stage. */
  #place() {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.stage;
    const within = (/** @type {number} */ x, /** @type {number} */ most) => Math.max(EDGE, Math.min(x, most - EDGE));
    const left = within(this.at[0] + AWAY, offsetWidth - this.box.offsetWidth);
    const top = within(this.at[1] + AWAY, offsetHeight - this.box.offsetHeight);
    this.box.style.setProperty('left', `${offsetLeft + left}px`);
    this.box.style.setProperty('top', `${offsetTop + top}px`);
  }
}
