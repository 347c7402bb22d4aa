// Where the inspector stands: beside the drawing where there is room, below it on a phone. What it shows is fetched after
// the page has been painted: inspector.js.

import { want } from '../page/build.js';
import { keep, kept } from '../page/kept.js';

/** @typedef {import('./panel.js').Panel} Panel */

const STORE = 'batten-inspector';
const ROOM = matchMedia('(min-width: 1100px)'); // it is open there unless it was shut

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Dock {
  /** @param {Panel} panel */
  constructor(panel) {
    this.panel = panel;
    this.box = part('inspector');
    this.button = /** @type {HTMLElement} */ (document.querySelector('[data-name=inspector]'));
    /** @type {Promise<import('./inspector.js').Inspector> | undefined} */
    this.inspector = undefined;
    this.button.addEventListener('click', () => this.open(this.box.hidden, true));
    ROOM.addEventListener('change', () => this.#settle());
    this.#settle();
  }

  /** As it was last left on a wide window; shut on a narrow one. */
  #settle() {
    this.open(ROOM.matches && kept(STORE) !== 'shut');
  }

  /** @param {boolean} on @param {boolean} [asked] by the user, who finds it so again */
  open(on, asked = false) {
    this.box.hidden = !on;
    this.button.setAttribute('aria-expanded', String(on));
    if (asked) {
      if (ROOM.matches) {
        keep(STORE, on ? 'open' : 'shut');
      }
      void this.fetch();
    }
  }

  /** Fetches what it shows. */
  fetch() {
    this.inspector ??= want(import('./inspector.js')).then(({ Inspector }) => Inspector.make(this.panel, this.box));
    return this.inspector;
  }

  /** Opens a section. @param {string} section */
  async reveal(section) {
    this.open(true);
    (await this.fetch()).open(section, true);
  }
}
