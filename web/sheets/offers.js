// The row of commands for the selection, beside it: what changes it stands in the row, the rest under "more". Fetched with
// its icons when something is first selected.

import { Role } from '../engine/codes.js';
import { dress } from '../page/build.js';
import { loadIcons } from '../page/icons.js';
import { tell } from '../page/words.js';
import { Dot } from './dot.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').Frame} Frame */

/** What stands in the row as long as there is room. */
const FIRST = [/^duplicate$/, /^(un)?group$/, /^region-/, /^(combine|release)$/, /^(curve-(close|open|join|split|offset|outline)|to-page)$/, /^(surface|wire)-/,
  /^(camera-along|body-path)$/];
const REST = [/^curve-(blend|match|reverse|simplify|earlier)$/, /^points-at-/, /^deviation$/, /^(mirror-.*|array)$/, /^order-/, /^align-/, /^distribute-/];
const AWAY = 12; // pixels between the selection's box and the row
const RULER = 30; // pixels that rulers take at the top and the left
const EDGE = 8;

// What is selected, and the shape that it had or could have.
/** @type {number[]} */
const SEEN = [Role.HANDLE, Role.SELECTION, Role.FIT, Role.AXIS_X, Role.AXIS_Y, Role.AXIS_Z];

/**
 * Where what is selected is seen, with its handles: x0, y0, x1, y1 on the stage. Null: nothing of it is drawn.
 * @param {Frame} frame
 */
function seen({ live, x, y, zoom, angle, originX, originY }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  const cosine = Math.cos((angle * Math.PI) / 180) * zoom;
  const sine = Math.sin((angle * Math.PI) / 180) * zoom;
  for (const item of live) {
    if (!SEEN.includes(item.role)) {
      continue;
    }
    for (const [px, py] of [[item.x0, item.y0], [item.x1, item.y0], [item.x1, item.y1], [item.x0, item.y1]]) {
      const [dx, dy] = [px + originX - x, py + originY - y];
      const [sx, sy] = [dx * cosine - dy * sine, dx * sine + dy * cosine];
      box[0] = Math.min(box[0], sx);
      box[1] = Math.min(box[1], sy);
      box[2] = Math.max(box[2], sx);
      box[3] = Math.max(box[3], sy);
    }
  }
  return box.every(Number.isFinite) ? box : null;
}

export class Offers {
  /** @param {Panel} panel */
  static async make(panel) {
    const [{ rove }] = await Promise.all([import('../page/regions.js'), dress('styles/offers.css'), loadIcons('arrange')]);
    const offers = new Offers(panel);
    rove(offers.row);
    return offers;
  }

  /** @param {Panel} panel */
  constructor(panel) {
    this.engine = panel.engine;
    this.shown = '';
    this.at = '';
    /** @type {Frame | undefined} */
    this.frame = undefined;
    this.stage = /** @type {HTMLElement} */ (document.getElementById('stage'));
    this.row = tell(document.createElement('div'), { label: 'shell.actions' });
    this.row.id = 'actions';
    this.row.className = 'actions';
    this.row.setAttribute('role', 'toolbar');
    this.row.hidden = true;
    this.main = document.createElement('div');
    this.main.className = 'group';
    /** Colours of the line and the fill. */
    this.dots = [new Dot(panel, 'stroke-colour', 'stroked'), new Dot(panel, 'fill-colour', 'filled')];
    this.rest = document.createElement('div');
    this.rest.className = 'rest';
    this.rest.id = 'further';
    this.rest.hidden = true;
    this.further = panel.buttons.plain('further', 'shell.further');
    this.further.setAttribute('aria-controls', 'further');
    this.further.addEventListener('click', () => this.#open(this.rest.hidden));
    /** In the order in which they stand. @type {Map<string, HTMLElement>} */
    this.buttons = new Map();
    for (const family of [...FIRST, ...REST, /^delete$/]) {
      for (const { name } of panel.tables.commands) {
        if (family.test(name) && document.getElementById(`icon-${name}`)) {
          const button = panel.buttons.command(name, `command.${name}`);
          button.append(tell(document.createElement('span'), { text: `command.${name}` }));
          this.buttons.set(name, button);
        }
      }
    }
    this.row.append(this.main, this.rest);
    this.row.addEventListener('click', ({ target }) => {
      if (target instanceof Element && this.rest.contains(target)) {
        this.#open(false);
      }
    });
    this.row.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !this.rest.hidden) {
        this.#open(false);
        this.further.focus();
        event.stopPropagation();
      }
    });
    document.querySelector('main')?.append(this.row);
  }

  /** @param {boolean} on the rest is shown */
  #open(on) {
    this.rest.hidden = !on;
    this.further.setAttribute('aria-expanded', String(on));
    this.at = '';
    this.#place();
  }

  /** @param {Frame} frame */
  show(frame) {
    this.frame = frame;
    const now = `${frame.selection} ${frame.revision} ${frame.tool} ${this.stage.clientWidth}`;
    if (now !== this.shown && !frame.busy) {
      this.shown = now;
      this.#fill(frame.selected > 0 ? this.engine.actions() : []);
    }
    this.row.classList.toggle('away', frame.busy); // not over what is being moved
    if (!this.row.hidden && !frame.busy) {
      this.#place();
    }
  }

  /** @param {string[]} possible */
  #fill(possible) {
    this.row.hidden = possible.length === 0;
    /** @type {HTMLElement[]} */
    const offered = [];
    for (const [name, button] of this.buttons) {
      const on = possible.includes(`${name}*`);
      if (on || possible.includes(name)) {
        offered.push(button);
      }
      if (name === 'wire-frames') {
        button.setAttribute('aria-pressed', String(on));
      }
    }
    const remove = offered.pop();
    const dots = possible.includes('duplicate') ? this.dots.filter((dot) => dot.show()).map(({ box }) => box) : [];
    const size = ((this.further.offsetWidth || 44) + 2) * this.#scale;
    const room = Math.max(2, Math.floor((this.stage.clientWidth - 2 * EDGE - RULER) / size) - 2 - dots.length);
    const first = offered.filter((button) => FIRST.some((family) => family.test(button.dataset.name ?? ''))).slice(0, room);
    const rest = offered.filter((button) => !first.includes(button));
    const last = remove ? [...rest.length > 0 ? [this.further] : [], remove] : [];
    const focus = document.activeElement;
    this.main.replaceChildren(...dots, ...first, ...last);
    this.rest.replaceChildren(...rest);
    this.#open(false);
    if (focus instanceof HTMLElement && this.row.contains(focus)) {
      focus.focus();
    }
  }

  /** How far down the drawing is free: the time strip lies over its foot. */
  #low() {
    const strip = /** @type {HTMLElement | null} */ (document.querySelector('.time:not([hidden])'));
    return strip ? strip.getBoundingClientRect().top - this.stage.getBoundingClientRect().top : this.stage.clientHeight;
  }

  /** How large it is shown: its own lengths are in smaller pixels. @returns {number} */
  get #scale() {
    return /** @type {any} */ (this.row).currentCSSZoom ?? 1;
  }

  /** Where the chips are, on the stage. @returns {number[] | null} */
  get #chips() {
    const box = document.querySelector('.chips:not([hidden])')?.getBoundingClientRect();
    const { left, top } = this.stage.getBoundingClientRect();
    return box?.width ? [box.left - left, box.top - top, box.right - left, box.bottom - top] : null;
  }

  /** Above the selection, else below it, else in the corner that hides the least of it; not over the chips. */
  #place() {
    const { stage, row, frame } = this;
    const box = (frame && seen(frame)) ?? [0, 0, stage.clientWidth, 0];
    const low = this.#low();
    const chips = this.#chips;
    const now = `${[...box, ...chips ?? []].map(Math.round)} ${row.offsetWidth} ${row.offsetHeight} ${stage.clientWidth} ${low} ${stage.offsetLeft}`;
    if (now === this.at) {
      return;
    }
    this.at = now;
    const { offsetLeft, offsetTop, clientWidth } = stage;
    const scale = this.#scale;
    const [wide, high] = [this.main.offsetWidth, this.main.offsetHeight].map((size) => (size + 2 * (row.clientTop + 4)) * scale);
    const above = box[1] - AWAY - high;
    const below = box[3] + AWAY;
    const fits = above >= RULER || below + high <= low - EDGE;
    const top = above >= RULER ? above : fits ? below : RULER;
    const middle = fits ? (box[0] + box[2]) / 2 : clientWidth / 2;
    let left = Math.max(RULER, Math.min(middle - wide / 2, clientWidth - wide - EDGE));
    if (chips && left < chips[2] + EDGE && left + wide > chips[0] - EDGE && top < chips[3] + EDGE && top + high > chips[1] - EDGE) {
      const beside = chips[0] - EDGE - wide;
      left = beside >= RULER ? beside : Math.min(chips[2] + EDGE, clientWidth - wide - EDGE);
    }
    const grown = row.offsetHeight * scale - high; // what "more" adds goes down where there is room
    const up = top + high + grown > low - EDGE ? Math.max(0, Math.min(grown, top - RULER)) : 0;
    // And to the sides: no button moves from under the pointer.
    const out = Math.max(0, left + row.offsetWidth * scale - clientWidth + EDGE);
    row.classList.toggle('upwards', up > 0);
    this.main.style.setProperty('margin-left', `${out / scale}px`);
    row.style.setProperty('left', `${(offsetLeft + left - out) / scale}px`);
    row.style.setProperty('top', `${(offsetTop + top - up) / scale}px`);
  }
}
