// The inspector: position and size, style, layers and objects, in sections that stay while one draws. Fetched after the
// first paint, with its style sheet.

import { dress } from '../page/build.js';
import { loadIcons } from '../page/icons.js';
import { keep, kept } from '../page/kept.js';
import { tell } from '../page/words.js';
import { fill as layers } from './layers.js';
import { fill as numbers } from './numbers.js';
import { fill as objects } from './objects.js';
import { scrub } from './scrub.js';
import { fill as style } from './style.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').Frame} Frame */

/** @type {[string, import('./panel.js').Filler['fill']][]} */
const SECTIONS = [['numbers', numbers], ['style', style], ['objects', objects], ['layers', layers]];
const STORE = 'batten-sections'; // names of those that are shut
const CALM = 80; // milliseconds between two looks while something moves
const ONE = matchMedia('(max-width: 700px)'); // room for one section

export class Inspector {
  /** @param {Panel} panel @param {HTMLElement} box */
  static async make(panel, box) {
    await Promise.all([dress('styles/inspector.css'), dress('styles/style.css'), dress('styles/objects.css'), loadIcons('arrange')]);
    return new Inspector(panel, box);
  }

  /** @param {Panel} panel @param {HTMLElement} box */
  constructor(panel, box) {
    this.panel = panel;
    this.box = box;
    this.timer = 0;
    this.seen = 0;
    /** @type {Frame | undefined} */
    this.frame = undefined;
    /** @type {Map<string, { head: HTMLElement, body: HTMLElement, show(frame: Frame): void }>} */
    this.parts = new Map();
    const shut = kept(STORE).split(' ');
    for (const [name, fill] of SECTIONS) {
      this.#section(name, fill);
      this.open(name, ONE.matches ? name === 'style' : !shut.includes(name));
    }
    scrub(box);
    // Keys that a field does not use go on meaning the drawing; Escape returns to it.
    box.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !event.defaultPrevented) {
        document.getElementById('stage')?.focus();
      }
    });
    panel.shows.push(this);
    panel.controls.refresh();
    panel.wake();
  }

  /** @param {string} name @param {import('./panel.js').Filler['fill']} fill */
  #section(name, fill) {
    const section = /** @type {HTMLElement} */ (document.getElementById(name));
    const head = tell(document.createElement('button'), { text: name === 'objects' ? 'shell.part-objects' : `shell.${name}` });
    head.type = 'button';
    head.className = 'part-head';
    head.dataset.name = name;
    const body = document.createElement('div');
    body.className = 'part-body';
    body.id = `${name}-body`;
    head.setAttribute('aria-controls', body.id);
    head.addEventListener('click', () => this.open(name, body.hidden, true));
    const title = document.createElement('h2');
    title.append(head);
    section.append(title, body);
    const filled = fill(this.panel, body);
    this.parts.set(name, { head, body, show: (frame) => filled.show(frame) });
  }

  /** @param {string} name @param {boolean} on @param {boolean} [asked] by the user, who finds it so again */
  open(name, on, asked = false) {
    for (const [other, { head, body }] of this.parts) {
      const open = other === name ? on || (ONE.matches && asked) : !body.hidden && !(ONE.matches && on);
      body.hidden = !open;
      head.setAttribute('aria-expanded', String(open));
    }
    if (asked && !ONE.matches) {
      keep(STORE, [...this.parts].filter(([, { body }]) => body.hidden).map(([one]) => one).join(' '));
    }
    this.#look();
  }

  /** Every frame; while something moves it looks only now and then. @param {Frame} frame */
  show(frame) {
    this.frame = frame;
    if (!frame.busy || performance.now() - this.seen > CALM) {
      this.#look();
    } else {
      this.timer ||= setTimeout(() => this.#look(), CALM);
    }
  }

  #look() {
    clearTimeout(this.timer);
    this.timer = 0;
    this.seen = performance.now();
    for (const { body, show } of this.frame && !this.box.hidden ? this.parts.values() : []) {
      if (!body.hidden) {
        show(/** @type {Frame} */ (this.frame));
      }
    }
  }
}
