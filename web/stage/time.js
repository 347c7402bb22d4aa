// The time strip: plays the move of a camera, and shows where it is. Nothing of this enters the drawing or its journal. The
// engine holds all its state; here it is told what time it is while a move plays.

import { stand } from '../page/build.js';
import { word } from '../page/words.js';
import { Lens } from './lens.js';
import { Timing } from './timing.js';

/** @typedef {import('../engine/types.js').Frame} Frame */
/**
 * @typedef {object} Move
 * @property {number} id 0: there is no camera
 * @property {string} name
 * @property {number} cameras
 * @property {number} at seconds
 * @property {number} duration
 * @property {number} sees whether it is a camera's, which sees a picture; else a skeleton's
 * @property {number} length
 * @property {number} rate frames a second
 * @property {number} playing 0 or 1, as the next ones
 * @property {number} through
 * @property {number} loop
 * @property {number} lens
 * @property {import('./timing.js').Row[]} gaze its levels, the base first
 * @property {import('./timing.js').Row[]} path those of the curve that it follows
 * @property {number[]} graph the share of the distance at even times; of a skeleton that of the range of an angle
 * @property {{id: number, name: string}[]} [joints] of a skeleton, those that turn
 * @property {number} [joint] the one that is chosen
 * @property {string[]} [angles] its axes
 * @property {number} [angle] which of them the graph shows
 * @property {number} [degrees] that at the playhead
 */

const NONE = /** @type {Move} */ ({ id: 0, name: '', cameras: 0, at: 0, duration: 0, sees: 0, length: 0, rate: 24, playing: 0, through: 0, loop: 0, lens: 0, gaze: [], path: [], graph: [] });
const THUMB = 16; // px
const PICTURES = {
  'move-play': '<path d="M7 4l13 8-13 8z" fill="currentColor"/><path class="on" d="M6 4h4v16H6zM14 4h4v16h-4z" fill="currentColor"/>',
  'move-loop': '<path d="M17 3l4 4-4 4M21 7H8a5 5 0 0 0-5 5M7 21l-4-4 4-4M3 17h13a5 5 0 0 0 5-5"/>',
  'move-more': '<path d="M4 20V4M4 20h16M4 20C9 20 9 8 20 7"/>',
  lens: '<path d="M3 5h18v14H3z"/><path d="M13 12h6v5h-6z" fill="currentColor"/>',
  'look-through': '<path d="M2 12s4-7 10-7 10 7 10 7-4 7-10 7S2 12 2 12z"/><circle cx="12" cy="12" r="3"/>',
};

export class TimeStrip {
  /** @param {import('../main.js').Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.move = NONE;
    this.version = 0;
    this.box = document.createElement('section');
    this.box.className = 'time';
    this.box.hidden = true;
    this.buttons = /** @type {Record<string, HTMLButtonElement>} */ ({});
    /** @type {HTMLButtonElement | undefined} */
    this.more = undefined;
    this.slider = document.createElement('input');
    this.slider.type = 'range';
    this.slider.min = '0';
    this.told = document.createElement('output');
    const changed = () => {
      this.version = 0; // what a control changes shows before the next change of the drawing
      shell.wake();
    };
    this.timing = new Timing(shell, changed);
    this.lens = new Lens(shell, changed);
    this.timing.box.hidden = true;
    this.row = document.createElement('div');
    this.row.className = 'time-row';
    this.row.append(this.#button('move-play'), this.slider, this.told, this.#button('move-loop'), this.#button('lens'), this.#button('look-through'), this.#more());
    this.box.append(this.timing.box, this.row);
    this.slider.addEventListener('input', () => this.#seek(this.slider.valueAsNumber));
    this.slider.addEventListener('pointerdown', (event) => this.#grasp(event));
    this.slider.addEventListener('pointermove', (event) => this.#scrub(event));
    this.box.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') {
        shell.engine.command('cancel');
        shell.stage.focus();
        shell.wake();
        event.stopPropagation();
      }
    });
    void stand(this.box, 'styles/time.css', shell);
  }

  /** Opens and closes what lies above the strip. */
  #more() {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'time-more';
    button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true">${PICTURES['move-more']}</svg>`;
    button.addEventListener('click', () => {
      this.timing.box.hidden = !this.timing.box.hidden;
      this.#fill();
    });
    this.more = button;
    return button;
  }

  /** @param {'move-play' | 'move-loop' | 'lens' | 'look-through'} command */
  #button(command) {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.command = command;
    button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true">${PICTURES[command]}</svg>`;
    button.addEventListener('click', () => {
      this.shell.engine.command(command);
      this.version = 0; // the loop is a setting, which changes no frame
      this.shell.wake();
    });
    this.buttons[command] = button;
    return button;
  }

  /** Browsers differ in what a pen or a finger does to a slider; here it goes where it is pressed. @param {PointerEvent} event */
  #grasp(event) {
    if (event.pointerType === 'mouse') {
      return;
    }
    event.preventDefault();
    this.slider.focus();
    this.slider.setPointerCapture(event.pointerId);
    this.#scrub(event);
  }

  /** @param {PointerEvent} event */
  #scrub(event) {
    if (!this.slider.hasPointerCapture(event.pointerId) || event.pointerType === 'mouse') {
      return;
    }
    const { left, width } = this.slider.getBoundingClientRect();
    const share = Math.min(Math.max((event.clientX - left - THUMB / 2) / (width - THUMB), 0), 1);
    const frame = (document.dir === 'rtl' ? 1 - share : share) * this.move.duration * this.move.rate;
    this.#seek(Math.min(Math.round(frame) / this.move.rate, this.move.duration));
  }

  /** @param {number} seconds */
  #seek(seconds) {
    const { engine, wake } = this.shell;
    engine.guard(() => engine.wasm.editor_seek(engine.editor, seconds), 0);
    wake();
  }

  /** @param {Frame} frame */
  show({ moves }) {
    const { engine, wake } = this.shell;
    if (moves !== this.version || (moves && engine.get('lens') !== this.move.lens)) { // a setting changes no frame
      this.version = moves;
      this.move = moves ? engine.guard(() => JSON.parse(engine.string(engine.wasm.editor_move(engine.editor))), NONE) : NONE;
      this.#fill();
    }
    if (this.move.playing) {
      engine.guard(() => engine.wasm.editor_play(engine.editor, performance.now()), 0);
      wake();
    }
  }

  #fill() {
    const { id, name, at, duration, sees, rate, playing, through, loop, lens } = this.move;
    const states = { 'move-play': playing, 'move-loop': loop, lens, 'look-through': through };
    this.box.hidden = !id;
    this.lens.show(this.move);
    this.box.ariaLabel = name || word('moves.name');
    this.shell.stage.classList.toggle('through', through !== 0);
    this.slider.max = String(duration);
    this.slider.step = String(1 / rate);
    if (this.slider.valueAsNumber !== at) {
      this.slider.step = 'any'; // the playhead may lie between two frames
      this.slider.value = String(at);
    }
    const digits = duration < 100 ? 2 : 0;
    this.told.textContent = word('moves.at', `${at.toFixed(digits)} / ${duration.toFixed(digits)}`);
    this.slider.ariaLabel = word('moves.name');
    this.slider.setAttribute('aria-valuetext', this.told.textContent);
    if (this.more) {
      this.more.title = this.more.ariaLabel = word('moves.more');
      this.more.ariaExpanded = String(!this.timing.box.hidden);
    }
    if (!this.timing.box.hidden) {
      this.timing.show(this.move);
    }
    for (const [command, on] of Object.entries(states)) {
      const button = this.buttons[command];
      button.ariaPressed = String(on !== 0);
      button.title = button.ariaLabel = word(`command.${command}`);
      button.hidden = !sees && (command === 'lens' || command === 'look-through');
    }
  }
}
