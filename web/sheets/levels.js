// The level strip: one row per level of the selected curve, finest first, with a fader, an eye and what shows it alone; the
// rest is under "More". Loaded when it is first shown, with its own style sheet. The engine holds all its state.

import { Act } from '../engine/codes.js';
import { dress } from '../page/build.js';
import { icon, loadIcons } from '../page/icons.js';
import { tell, word } from '../page/words.js';

/** @typedef {import('./panel.js').Panel} Panel */
/**
 * @typedef {object} Level
 * @property {number} points
 * @property {number} gain
 * @property {number} muted 0 or 1, like the following
 * @property {number} solo
 * @property {number} active
 *
 * @typedef {object} Levels
 * @property {Level[]} rows base first; empty: the curve has no levels
 * @property {number} points of the curve
 * @property {number} apart the rows show what decomposing the curve would give
 * @property {number} copying the next tap chooses the curve that receives the detail
 * @property {string} [of] width: the levels are those of the width along the curve
 * @property {string[]} [pictures] of each row, as the data of a path in a box of 32 by 20
 */

const LOUDEST = 2; // upper end of the fader; the engine accepts more

/**
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {string} name
 * @returns {HTMLElementTagNameMap[T]}
 */
function make(tag, name) {
  const element = document.createElement(tag);
  element.className = name;
  return element;
}

/** The line of a level, which its row shows. @returns {SVGElement} */
function picture() {
  const box = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  box.setAttribute('class', 'level-picture');
  box.setAttribute('viewBox', '0 0 32 20');
  box.ariaHidden = 'true';
  box.append(document.createElementNS('http://www.w3.org/2000/svg', 'path'));
  return box;
}

export class LevelStrip {
  /** With its style, without which it would push the stage aside, and its icons. @param {Panel} panel @param {HTMLElement} stage */
  static async make(panel, stage) {
    await Promise.all([dress('styles/levels.css'), loadIcons('arrange')]);
    return new LevelStrip(panel, stage);
  }

  /** @param {Panel} panel @param {HTMLElement} stage */
  constructor(panel, stage) {
    this.panel = panel;
    this.engine = panel.engine;
    this.stage = stage;
    this.box = tell(make('section', 'levels'), { label: 'tool.levels' });
    this.box.hidden = true;
    this.list = make('ul', 'level-list');
    this.apart = make('div', 'level-controls');
    for (const name of ['apart-levels', 'apart-points']) {
      this.apart.append(this.#property(name));
    }
    this.apart.append(this.#commands(['accept', 'cancel']));
    this.tools = make('div', 'level-controls');
    this.study = make('div', 'level-controls');
    this.more = this.#commands(['level-add', 'levels-copy', 'levels-flatten']);
    for (const name of ['hold-length', 'hold-area', 'hold-symmetry', 'show-levels', 'show-frames', 'frame-rule', 'level-sketch']) {
      this.study.append(this.#property(name));
    }
    this.apartNow = this.#commands(['take-apart']);
    this.further = document.createElement('details');
    this.further.append(tell(document.createElement('summary'), { text: 'shell.further' }), this.more, this.study);
    this.tools.append(this.apartNow, this.further);
    this.box.append(this.list, this.apart, this.tools);
    stage.after(this.box);
    // Escape takes back the fader's step, or returns to the drawing.
    this.box.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') {
        this.engine.command('cancel');
        this.stage.focus();
        this.#changed();
        event.stopPropagation();
      }
    });
  }

  /** @param {string} name */
  #property(name) {
    const row = /** @type {import('../engine/types.js').PropertyRow} */ (
      this.panel.tables.properties.find((property) => property.name === name));
    const control = this.panel.controls.control(row, 'strip');
    const input = control.querySelector('input');
    if (row.type === 'number' && input) {
      input.parentElement?.before(this.panel.buttons.stepper(row, input, -1));
      input.parentElement?.after(this.panel.buttons.stepper(row, input, 1));
    }
    return control;
  }

  /** @param {string[]} names */
  #commands(names) {
    const row = make('div', 'level-commands');
    row.append(...names.map((name) => this.panel.buttons.word(name)));
    return row;
  }

  #changed() {
    this.show(!this.box.hidden);
    this.panel.wake();
  }

  /** @param {number} act @param {number} level @param {number} value @param {boolean} done */
  #act(act, level, value, done = true) {
    this.engine.level(act, level, value, done);
    this.#changed();
  }

  /** @param {boolean} visible */
  show(visible) {
    this.box.hidden = !visible;
    if (!visible) {
      return;
    }
    const { rows, apart, copying, of, pictures = [] } = this.engine.levels();
    tell(this.box, { label: of ? 'property.widths' : 'tool.levels' });
    this.apart.hidden = apart === 0;
    this.tools.hidden = apart !== 0 || of !== undefined;
    this.study.hidden = rows.length === 0;

    for (const button of /** @type {NodeListOf<HTMLButtonElement>} */ (this.more.querySelectorAll('[data-text^="command.levels-"]'))) {
      button.hidden = rows.length === 0;
      if (button.dataset.text === 'command.levels-copy') {
        button.setAttribute('aria-pressed', String(copying !== 0));
      }
    }
    while (this.list.children.length > rows.length) {
      this.list.firstElementChild?.remove(); // the finest comes first
    }
    while (this.list.children.length < rows.length) {
      this.list.prepend(this.#row(this.list.children.length));
    }
    rows.forEach((level, index) => {
      const row = /** @type {HTMLElement} */ (this.list.children[rows.length - 1 - index]);
      this.#fill(row, level, index, index === rows.length - 1, apart !== 0);
      row.querySelector('path')?.setAttribute('d', pictures[index]);
    });
    this.panel.controls.refresh();
  }

  /** @param {number} index */
  #row(index) {
    const row = make('li', 'level-row');
    const choose = make('input', 'level-choose');
    choose.type = 'radio';
    choose.name = 'level';
    choose.addEventListener('change', () => this.#act(Act.CHOOSE, index, 0));
    const label = make('label', 'level-name');
    label.append(choose, picture(), make('span', ''), make('small', ''));
    row.append(label);
    if (index > 0) {
      const fader = make('input', 'level-fader');
      fader.type = 'range';
      fader.min = '0';
      fader.max = String(LOUDEST);
      fader.step = '0.01';
      fader.addEventListener('input', () => this.#act(Act.GAIN, index, fader.valueAsNumber, false));
      fader.addEventListener('change', () => this.#act(Act.GAIN, index, fader.valueAsNumber));
      fader.addEventListener('dblclick', () => this.#act(Act.GAIN, index, 1));
      tell(fader, { label: 'levels.gain' });
      row.append(fader, make('output', 'level-gain'));
    }
    for (const [name, act] of /** @type {[string, number][]} */ ([['mute', Act.MUTE], ['solo', Act.SOLO]])) {
      if (index === 0 && act === Act.MUTE) {
        continue;
      }
      const button = make('button', `level-${name}`);
      button.type = 'button';
      button.append(icon(name === 'mute' ? 'shown' : 'only') ?? '');
      button.addEventListener('click', () => this.#act(act, index, Number(button.ariaPressed !== 'true')));
      row.append(button);
    }
    return row;
  }

  /** @param {HTMLElement} row @param {Level} level @param {number} index @param {boolean} finest @param {boolean} still */
  #fill(row, level, index, finest, still) {
    const [choose, fader] = row.querySelectorAll('input');
    const [name, points] = row.querySelectorAll('span, small');
    row.toggleAttribute('data-muted', level.muted !== 0);
    choose.checked = level.active !== 0;
    const called = index === 0 ? word('levels.base') : finest && index > 1 ? word('levels.finest') : word('levels.level', index);
    name.textContent = called;
    points.textContent = word('levels.points', level.points);
    if (fader) {
      fader.value = String(level.gain);
      fader.setAttribute('aria-label', word('levels.gain', called));
      /** @type {HTMLElement} */ (row.querySelector('output')).textContent = level.gain.toFixed(2);
    }
    for (const [part, on] of /** @type {[string, number][]} */ ([['mute', level.muted], ['solo', level.solo]])) {
      const button = row.querySelector(`.level-${part}`);
      button?.setAttribute('aria-pressed', String(on !== 0));
      if (part === 'mute') {
        button?.querySelector('use')?.setAttribute('href', `#icon-${on ? 'hidden' : 'shown'}`);
      }
      button?.setAttribute('aria-label', word(`levels.${part}`, called));
      button?.setAttribute('title', word(`levels.${part}`, called));
    }
    for (const control of /** @type {NodeListOf<HTMLInputElement>} */ (row.querySelectorAll('input, button'))) {
      control.disabled = still;
    }
  }
}
