// The colour picker of a property: a field of saturation and value, hue and opacity, numbers, an eyedropper, and palettes, of which
// the first is the colours of the drawing. The selection is seen in what is dragged; it is given when the pointer is lifted, as one
// step of undo. Fetched with the first colour that is chosen.

import { dress } from '../page/build.js';
import { icon } from '../page/icons.js';
import { keep, kept } from '../page/kept.js';
import { rove } from '../page/regions.js';
import { tell } from '../page/words.js';
import { Trial } from '../stage/trial.js';
import { colourWith, fromHsv, MODELS, rgbOf, toHsv } from './colour_models.js';
import { Palettes } from './palettes.js';
import { colourOf, hexOf } from './swatches.js';

/** @typedef {import('../main.js').Shell} Shell */

const EDGE = 8; // pixels that it keeps from the window's edges
const STORE = 'batten-colour-model';
const NUDGE = [0.01, 0.1]; // of the field, by an arrow key, and with Shift

/** @type {Promise<Picker> | undefined} */
let made;

/** Lets the colour of a property be chosen. @param {Shell} shell @param {string} property @param {HTMLElement} anchor it stands beside this */
export async function open(shell, property, anchor) {
  made ??= Promise.all([dress('styles/picker.css'), shell.engine.words ?? shell.words.load()]).then(() => new Picker(shell));
  (await made).open(property, anchor);
}

/** @param {string} type @param {Record<string, string>} keys of its words @param {Record<string, string>} [traits] */
function field(type, keys, traits = {}) {
  const input = tell(document.createElement('input'), keys);
  return Object.assign(input, { type, spellcheck: false, ...traits });
}

class Picker {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.trial = new Trial(shell);
    this.property = '';
    this.before = 0;
    this.hsv = [0, 0, 0];
    this.alpha = 255;
    /** @type {HTMLElement | undefined} */
    this.anchor = undefined;
    this.box = document.createElement('div');
    this.box.id = 'picker-sheet';
    this.box.className = 'picker';
    this.box.popover = 'auto';
    this.box.setAttribute('role', 'dialog');
    this.plane = this.#plane();
    this.hue = field('range', { label: 'shell.picker-hue' }, { id: 'picker-hue', min: '0', max: '360', step: '1' });
    this.opacity = field('range', { label: 'shell.alpha' }, { id: 'picker-opacity', min: '0', max: '255', step: '1' });
    this.hex = field('text', { label: 'shell.hex' }, { id: 'picker-hex' });
    this.model = this.#models();
    this.numbers = [0, 1, 2].map((i) => field('number', { label: 'shell.hex' }, { id: `picker-number-${i}`, min: '0', step: 'any', inputMode: 'decimal' }));
    this.seen = document.createElement('i');
    this.back = tell(document.createElement('button'), { label: 'shell.picker-back', help: '' });
    this.palettes = new Palettes(shell, (colour) => this.#give(colour));
    this.#lay();
    this.#listen();
    document.querySelector('main')?.append(this.box);
  }

  /** The field of saturation, across, and value, upwards. */
  #plane() {
    const plane = tell(document.createElement('div'), { label: 'shell.picker-plane' });
    plane.className = 'plane';
    plane.tabIndex = 0;
    plane.setAttribute('role', 'slider');
    plane.append(document.createElement('i'));
    return plane;
  }

  #models() {
    const select = tell(document.createElement('select'), { label: 'shell.picker-model' });
    select.id = 'picker-model';
    select.append(...Object.keys(MODELS).map((name) => new Option(name.toUpperCase(), name)));
    select.value = kept(STORE) in MODELS ? kept(STORE) : 'hsv';
    return select;
  }

  #lay() {
    const pick = tell(document.createElement('button'), { label: 'shell.picker-page', help: '' });
    pick.id = 'picker-page';
    pick.className = 'tool';
    pick.append(icon('tool-eyedropper') ?? '');
    pick.addEventListener('click', () => void this.#fromPage());
    this.back.className = 'back';
    this.seen.className = 'seen';
    const row = (/** @type {string} */ name, /** @type {HTMLElement[]} */ ...parts) => {
      const box = document.createElement('div');
      box.className = name;
      box.append(...parts);
      return box;
    };
    this.box.append(this.plane, row('sliders', row('pair', this.back, this.seen), row('bars', this.hue, this.opacity)),
      row('line', this.hex, pick), row('line', this.model, ...this.numbers), this.palettes.box);
    rove(this.palettes.swatches);
  }

  #listen() {
    const { plane, hue, opacity, hex, model, numbers, back, box } = this;
    plane.addEventListener('pointerdown', (event) => {
      if (event.button === 0) {
        plane.setPointerCapture(event.pointerId);
        this.#drag(event);
      }
    });
    plane.addEventListener('pointermove', (event) => plane.hasPointerCapture(event.pointerId) && this.#drag(event));
    plane.addEventListener('pointerup', () => this.#give());
    plane.addEventListener('pointercancel', () => {
      this.trial.end();
      this.#read();
    });
    plane.addEventListener('keydown', (event) => this.#nudge(event));
    for (const bar of [hue, opacity]) {
      bar.addEventListener('input', () => {
        this.hsv[0] = hue.valueAsNumber;
        this.alpha = opacity.valueAsNumber;
        this.#try();
      });
      bar.addEventListener('change', () => this.#give());
    }
    hex.addEventListener('change', () => {
      const colour = colourOf(hex.value);
      this.#give(colour < 0 ? this.shell.engine.get(this.property) : colour); // refused: as it was
    });
    model.addEventListener('change', () => {
      keep(STORE, model.value);
      this.#show();
    });
    for (const number of numbers) {
      number.addEventListener('change', () => this.#typed());
    }
    back.addEventListener('click', () => this.#give(this.before));
    box.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && event.target instanceof HTMLInputElement) {
        event.target.blur();
        box.hidePopover();
      }
      event.stopPropagation(); // it is not meant for the drawing
    });
    box.addEventListener('toggle', (event) => {
      if (/** @type {ToggleEvent} */ (event).newState === 'closed') {
        this.trial.end();
        if (this.anchor?.closest('.dot')) {
          this.shell.stage.focus(); // keys mean the drawing again
        }
      }
    });
  }

  /** @param {string} property @param {HTMLElement} anchor */
  open(property, anchor) {
    this.property = property;
    this.anchor = anchor;
    this.before = this.shell.engine.get(property);
    tell(this.box, { label: 'shell.picker', value: `property.${property}` });
    tell(this.hex, { label: 'shell.hex', value: `property.${property}` });
    tell(this.opacity, { label: 'shell.alpha', value: `property.${property}` });
    this.#read();
    this.palettes.show();
    this.box.showPopover();
    this.#place(anchor.getBoundingClientRect());
    this.plane.focus();
  }

  /** Left of what asked for it, and where there is no room beside the rail, below; within the window. @param {DOMRect} at */
  #place(at) {
    const { width, height } = this.box.getBoundingClientRect();
    const stage = document.getElementById('stage')?.getBoundingClientRect() ?? at;
    const scale = /** @type {any} */ (this.box).currentCSSZoom ?? 1;
    const most = innerWidth - width - EDGE;
    const left = Math.max(EDGE, Math.min(Math.max(at.left - width - EDGE, stage.left + EDGE), most));
    const top = left + width > at.left ? at.bottom + EDGE : at.top;
    this.box.style.setProperty('left', `${left / scale}px`);
    this.box.style.setProperty('top', `${Math.max(EDGE, Math.min(top, innerHeight - height - EDGE)) / scale}px`);
  }

  /** As the property has it. */
  #read() {
    const colour = this.shell.engine.get(this.property);
    const [hue, saturation, value] = toHsv(rgbOf(colour));
    // Greys have no hue, and black no saturation: as they were.
    this.hsv = [saturation === 0 ? this.hsv[0] : hue, value === 0 ? this.hsv[1] : saturation, value];
    this.alpha = colour & 255;
    this.#show();
  }

  /** @param {number} [colour] as 0xRRGGBBAA; without: what is shown */
  #give(colour = this.colour) {
    this.trial.end();
    if (colour !== this.shell.engine.get(this.property)) {
      this.shell.engine.set(this.property, colour);
      this.shell.panel.controls.refresh();
      this.shell.wake();
    }
    if (colour !== this.colour) {
      this.#read();
    }
    this.#show();
  }

  /** The selection is seen in what is shown. */
  #try() {
    this.trial.show(this.property, this.colour);
    this.#show();
  }

  get colour() {
    return colourWith(fromHsv(this.hsv), this.alpha);
  }

  #show() {
    const [hue, saturation, value] = this.hsv;
    const rgb = fromHsv(this.hsv);
    const percent = (/** @type {number} */ share) => `${Math.round(share * 100)}%`;
    const style = this.box.style;
    style.setProperty('--hue', `hsl(${hue} 100% 50%)`);
    style.setProperty('--opaque', hexOf(colourWith(rgb, 255)));
    style.setProperty('--colour', hexOf(this.colour));
    style.setProperty('--before', hexOf(this.before));
    style.setProperty('--across', percent(saturation));
    style.setProperty('--down', percent(1 - value));
    this.plane.setAttribute('aria-valuenow', String(Math.round(saturation * 100)));
    this.plane.setAttribute('aria-valuetext', `S ${percent(saturation)}, V ${percent(value)}`);
    this.hue.value = String(hue);
    this.opacity.value = String(this.alpha);
    if (document.activeElement !== this.hex) {
      this.hex.value = hexOf(this.colour);
    }
    const { names, tops, digits, from } = MODELS[this.model.value];
    const all = this.model.value === 'hsv' ? [hue, saturation * 100, value * 100] : from(rgb);
    this.numbers.forEach((number, i) => {
      number.max = String(tops[i]);
      number.title = names[i];
      number.setAttribute('aria-label', names[i]);
      number.value = String(Number(all[i].toFixed(digits[i])));
    });
  }

  #typed() {
    const { tops, to } = MODELS[this.model.value];
    const all = this.numbers.map((number, i) => Math.min(tops[i], Math.max(0, number.valueAsNumber || 0)));
    if (this.model.value === 'hsv') {
      this.hsv = [all[0], all[1] / 100, all[2] / 100];
      this.#give();
    } else {
      this.#give(colourWith(to(all), this.alpha));
    }
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const box = this.plane.getBoundingClientRect();
    const share = (/** @type {number} */ at, /** @type {number} */ low, /** @type {number} */ size) => Math.min(1, Math.max(0, (at - low) / size));
    this.hsv = [this.hsv[0], share(event.clientX, box.left, box.width), 1 - share(event.clientY, box.top, box.height)];
    this.#try();
  }

  /** @param {KeyboardEvent} event */
  #nudge(event) {
    const step = NUDGE[Number(event.shiftKey)];
    const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[event.key];
    if (by) {
      event.preventDefault();
      this.hsv = this.hsv.map((value, i) => (i ? Math.min(1, Math.max(0, value + by[i - 1])) : value));
      this.#give();
    }
  }

  async #fromPage() {
    const { probe } = await import('../stage/probe.js');
    this.box.hidePopover();
    const colour = await probe(this.shell);
    if (colour !== null) {
      this.#give(colour);
    }
    if (this.anchor?.isConnected) {
      this.open(this.property, this.anchor);
    }
  }
}
