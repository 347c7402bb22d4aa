// The chips at the end of a stroke: what else it could mean, and how closely it is fitted. A tap chooses that reading;
// the chips disappear when the next stroke begins. Beside a selection the same for what was done to it: how simple it becomes, or how
// far back it goes, how far beside it a copy lies.

import { Measure } from '../page/measure.js';
import { dress } from '../page/build.js';
import { tell } from '../page/words.js';

/**
 * @typedef {object} Readings
 * @property {number[]} at the stroke's end, view pixels
 * @property {number} chosen
 * @property {number} amount from 0, raw, to 1, fair; -1: the stroke can no longer be refitted
 * @property {string[]} words empty: it has no other reading
 * @property {number} [other] of a second slider
 * @property {string} [of] what was done to a selection and can be chosen otherwise: simplify, earlier, offset, array, blend, match
 * @property {number} [also] of a second group of words, the chosen one
 * @property {number} [ways] how many of the words are chosen one instead of another; what follows them does something
 * @property {string} [typed] the properties that can also be typed
 * @property {number} [step] of the slider
 * @property {number[]} [around] what they must not lie over: x0, y0, x1, y1
 * @property {string} [said] what it has come to
 * @typedef {{ box: HTMLElement, slider: HTMLInputElement, ends: HTMLElement[] }} Gauge a slider between two words
 */

const AWAY = 16; // px from the stroke's end
const EDGE = 4;
const SLACK = 90; // px that what is said can grow by while the slider is dragged

export class Chips {
  /** @param {import('../engine/engine.js').Engine} engine @param {HTMLElement} stage @param {() => void} wake */
  constructor(engine, stage, wake) {
    this.engine = engine;
    this.stage = stage;
    this.wake = wake;
    this.box = document.createElement('div');
    this.box.className = 'chips';
    this.box.setAttribute('role', 'group');
    this.box.hidden = true;
    this.at = [0, 0];
    /** @type {number[] | undefined} */
    this.around = undefined;
    this.points = document.createElement('output');
    /** A slider for each end, where there are two. */
    this.sliders = [0, 1].map((slider) => this.#gauge((amount, done) => engine.refit(slider, amount, done)));
    this.sliders[0].box.append(this.points);
    /** What can be typed, by property. @type {Map<string, Measure>} */
    this.fields = new Map();
    this.shown = '';
    void dress('styles/chips.css').then(() => { // unstyled, it would push the stage aside
      stage.after(this.box);
      this.#place();
    });
  }

  /** @param {boolean} some */
  show(some) {
    const { at, chosen, amount, words, ways = Infinity, typed = '', of = '', around, step = 0.05, said = '', other, also = -1 } = some ? this.engine.readings() : { at: [0, 0], chosen: -1, amount: -1, words: [] };
    this.at = at;
    this.around = around;
    if (amount < 0 && this.box.contains(document.activeElement)) {
      this.stage.focus();
    }
    this.box.hidden = amount < 0;
    const amounts = other === undefined ? [amount] : [amount, other];
    amounts.forEach((one, i) => Object.assign(this.sliders[i].slider, { step: String(step), valueAsNumber: one }));
    const shown = [of, typed, amounts.length, ...words].join('\n');
    if (shown !== this.shown || !(of || this.box.contains(document.activeElement))) { // a slider in use stays where it is
      this.shown = shown;
      const sliders = this.sliders.slice(0, amounts.length);
      this.#dress(sliders, of && `command.${of === 'array' ? of : `curve-${of}`}`, of || 'refit');
      const names = typed.split(' ').filter(Boolean);
      const held = this.#held();
      this.fields = new Map(names.map((name) => [name, this.#field(name, names.length > 1)]));
      this.box.replaceChildren(...words.map((text, i) => this.#chip(text, i)), ...[...this.fields.values()].map(({ box }) => box), ...sliders.map(({ box }) => box));
      if (held >= 0) { // the chip that was pressed, though it may say something else by now
        this.box.querySelectorAll('button')[held]?.focus();
      }
    }
    for (const [name, measure] of this.fields) {
      if (document.activeElement !== measure.input) { // not over what is being typed
        measure.show(this.engine.number(name));
        measure.judge(null);
      }
    }
    this.box.querySelectorAll('button').forEach((chip, i) => chosen < 0 || i >= ways || chip.setAttribute('aria-pressed', String(i === chosen || i === also)));
    this.points.textContent = said;
    this.#place();
  }

  /** Names the sliders and their ends. @param {Gauge[]} sliders @param {string} done a command @param {string} of */
  #dress(sliders, done, of) {
    tell(this.box, { label: done || 'command.reading-next' });
    const [low, high] = [`${of}.low`, `${of}.high`];
    sliders.forEach(({ box, slider, ends }, i) => {
      tell(slider, { label: sliders.length > 1 ? `${of}.${i + 1}` : done || of });
      tell(box, { help: `${of}.help` });
      tell(ends[0], { text: low });
      tell(ends[1], { text: high });
      box.dataset.number = sliders.length > 1 ? String(i + 1) : '';
    });
  }

  /** A slider between two words: previews while it is dragged; one undo step when it is released.
   * @param {(amount: number, done: boolean) => void} take @returns {Gauge} */
  #gauge(take) {
    const slider = document.createElement('input');
    Object.assign(slider, { type: 'range', min: '0', max: '1', step: '0.05' });
    for (const event of ['input', 'change']) {
      slider.addEventListener(event, () => {
        take(slider.valueAsNumber, event === 'change');
        this.wake();
      });
    }
    slider.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') {
        this.engine.command('accept');
        this.wake();
      }
    });
    const box = document.createElement('label');
    const ends = [document.createElement('span'), document.createElement('span')];
    box.className = 'refit';
    box.append(ends[0], slider, ends[1]);
    return { box, slider, ends };
  }

  /** The place among the chips of the one that has the focus; -1: none has. */
  #held() {
    return [...this.box.querySelectorAll('button')].indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
  }

  /** A property as text: seen while it is typed. @param {string} name @param {boolean} labelled it is one of several */
  #field(name, labelled) {
    const input = document.createElement('input');
    Object.assign(input, { id: labelled ? `refit-${name}` : 'refit-typed', type: 'text', autocomplete: 'off' });
    tell(input, { label: `property.${name}` });
    const measure = new Measure(input);
    measure.box.classList.add('control');
    if (labelled) {
      measure.box.prepend(tell(document.createElement('span'), { text: `label.${name}` }));
      measure.box.classList.add('labelled');
    }
    input.addEventListener('focus', () => input.select());
    input.addEventListener('input', () => {
      measure.judge(!this.engine.enter(name, input.value));
      this.wake();
    });
    input.addEventListener('keydown', (event) => {
      const command = { Enter: 'accept', Escape: 'cancel' }[event.key];
      if (command && (event.key === 'Escape' || input.ariaInvalid !== 'true')) {
        this.engine.command(command);
        this.stage.focus();
        this.wake();
      }
    });
    return measure;
  }

  /** @param {string} text @param {number} index */
  #chip(text, index) {
    const chip = document.createElement('button');
    chip.type = 'button';
    chip.textContent = text;
    chip.addEventListener('click', (event) => {
      this.engine.readAs(index);
      if (event.detail) { // by a pointer: keys go on meaning the drawing
        this.stage.focus();
      }
      this.wake();
    });
    return chip;
  }

  /** Whether the chips at a place of the stage would lie over a strip, what is said or the dial. @param {number[]} place @param {DOMRect} size */
  #covers([x, y], { width, height }) {
    const { left, top } = this.stage.getBoundingClientRect();
    return [...document.querySelectorAll(':is(.levels, .time, .notice, .first, .dial):not([hidden])')].map((one) => one.getBoundingClientRect()).some((box) =>
      left + x < box.right && left + x + width > box.left && top + y < box.bottom && top + y + height > box.top);
  }

  /** Places the chips beside the stroke's end, at the foot of a narrow drawing, or around what is shown, inside the stage. */
  #place() {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.stage;
    const within = (/** @type {number} */ x, /** @type {number} */ most) => Math.max(EDGE, Math.min(x, most - EDGE));
    const scale = /** @type {any} */ (this.box).currentCSSZoom ?? 1;
    this.box.style.maxWidth = `${(offsetWidth - 2 * EDGE) / scale}px`;
    const size = this.box.getBoundingClientRect();
    const { width, height } = size;
    const [x0, y0, x1, y1] = this.around ?? [0, 0, ...this.at];
    const inside = (/** @type {number[]} */ [x, y]) => [within(x, offsetWidth - width), within(y, offsetHeight - height)];
    const places = [[x1 + AWAY, y1 + AWAY]];
    if (this.around) {
      places.push([x0, y1 + AWAY], [x1 + AWAY, y0], [x0, y0 - AWAY - height], [x0 - AWAY - width - SLACK, y0]);
    } else if (this.#covers(inside(places[0]), size)) {
      places.push([x1 - AWAY - width, y1 + AWAY], [x1 + AWAY, y1 - AWAY - height], [x1 - AWAY - width, y1 - AWAY - height]);
    }
    const fits = (/** @type {number[]} */ [x, y]) => x === within(x, offsetWidth - width - SLACK) && y === within(y, offsetHeight - height) &&
      !this.#covers([x, y], size);
    // Where they are as wide as the drawing nearly is: at its foot, under the thumb.
    const foot = [(offsetWidth - width) / 2, offsetHeight - height - EDGE];
    const isWide = 3 * width > 2 * offsetWidth && y1 + AWAY <= foot[1] && !this.#covers(foot, size);
    const [left, top] = isWide ? foot : inside(places.find(fits) ?? places[0]);
    this.box.style.setProperty('left', `${(offsetLeft + left) / scale}px`);
    this.box.style.setProperty('top', `${(offsetTop + top) / scale}px`);
  }
}
