// Texts about the drawing: its name, the hint, the readouts in the foot, first-use hints, and the question about a fit
// that misses the tolerance.

import { tell, word } from '../page/words.js';
import { Role } from '../engine/codes.js';
import { short } from './controls.js';

/** @typedef {import('./buttons.js').Buttons} Buttons */
/** @typedef {import('./controls.js').Controls} Controls */
/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Frame} Frame */
/** @typedef {import('../engine/types.js').Tables} Tables */

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Foot {
  /**
   * @param {Engine} engine
   * @param {Tables} tables
   * @param {Buttons} buttons
   * @param {Controls} controls
   */
  constructor(engine, tables, buttons, controls) {
    this.engine = engine;
    this.tables = tables;
    this.buttons = buttons;
    this.controls = controls;
    /** The buttons "done", "yes" and "no". @type {HTMLButtonElement[]} */
    this.pending = [];
    const list = part('readouts');
    this.knots = this.#readout(list, 'shell.knots');
    this.tolerance = this.#readout(list, 'property.tolerance');
    this.#fillTolerance();
    this.zoom = this.#readout(list, 'shell.zoom');
    this.pending = this.#pending();
  }

  #fillTolerance() {
    const row = this.tables.properties.find((property) => property.name === 'tolerance');
    if (row) {
      const control = this.controls.control(row, 'readout');
      control.querySelector('label')?.classList.add('hidden');
      const input = /** @type {HTMLInputElement} */ (control.querySelector('input'));
      input.parentElement?.before(this.buttons.stepper(row, input, -1));
      input.parentElement?.after(this.buttons.stepper(row, input, 1));
      this.tolerance.before(control);
      this.tolerance.parentElement?.classList.add('with-control');
    }
  }

  /** @param {HTMLElement} list @param {string} key */
  #readout(list, key) {
    const group = document.createElement('div');
    const term = tell(document.createElement('dt'), { text: key });
    const value = document.createElement('dd');
    const text = document.createElement('span');
    text.className = 'value';
    value.append(text);
    group.append(term, value);
    list.append(group);
    return text;
  }

  /**
   * Buttons for those without an Enter key, such as a pen: yes and no for a fit that misses the tolerance, done for an
   * object made with several presses.
   */
  #pending() {
    part('first').querySelector('button')?.addEventListener('click', () => {
      this.engine.set('first-hints', 3);
      this.controls.wake();
    });
    const done = tell(this.buttons.word('accept'), { text: 'shell.done', help: '' });
    const buttons = [done, this.buttons.word('accept'), this.buttons.word('cancel')];
    part('pending').append(...buttons);
    return buttons;
  }

  /** What changes while a stroke is drawn. @param {Frame} frame @param {string | null} values null: still changing */
  follow(frame, values) {
    if (values !== null) {
      part('values').textContent = values;
    }
    /** @type {HTMLElement} */ (this.knots.closest('div')).hidden = frame.knotsBefore <= 0 && frame.knotsAfter <= 0;
    const before = frame.knotsBefore > 0 ? `${frame.knotsBefore} → ` : '';
    this.knots.textContent = `${before}${frame.knotsAfter}`;
  }

  /** What else it says. @param {Frame} frame @param {string} reach the tolerance, in the drawing */
  show(frame, reach) {
    this.#showName(frame);
    part('hint').textContent = frame.hint;
    part('first').hidden = frame.first === 0;
    part('first').querySelectorAll('p').forEach((hint, i) => {
      hint.hidden = !(frame.first >> i & 1);
    });
    part('pending').hidden = !frame.pending;
    this.pending.forEach((button, i) => {
      button.hidden = frame.pending !== (i ? 1 : 2);
    });
    const missed = frame.error > 0 ? word('shell.missed-by', this.engine.number('missed')) : word('shell.missed');
    part('pending-text').textContent = frame.pending === 1 ? missed : '';
    part('pending-text').hidden = frame.pending !== 1;
    this.tolerance.textContent = word('shell.in-drawing', reach);
    const zoom = [`${short(frame.zoom * 100)} %`, ...(frame.tilt || frame.angle === 0 ? [] : [`${frame.angle.toFixed(0)}°`])].join(', ');
    this.zoom.textContent = zoom;
    part('zoom').textContent = zoom;
    part('zoom').ariaLabel = `${word('shell.zoom')} ${zoom}`;
  }

  /** @param {Frame} frame */
  #showName(frame) {
    const name = frame.name || word('shell.untitled');
    part('name').textContent = name;
    part('unsaved').hidden = !frame.unsaved;
    document.title = `${frame.unsaved ? '• ' : ''}${name} – Batten`;
  }

  /** The live values on the canvas, for screen readers; not while they are still changing. @param {Frame} frame */
  static values(frame) {
    return frame.busy ? null : frame.labels.filter((label) => label.role !== Role.RULER).map((label) => label.text).join(', ');
  }
}
