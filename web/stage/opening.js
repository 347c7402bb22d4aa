// How a drawing in space opens: as it was last seen in this browser, else by its saved view, else from three quarters.

import { keep, kept } from '../page/kept.js';

const STORE = 'batten-views';
const MOST = 50; // drawings that are remembered

/** By drawing, the last one seen last. @returns {[string, string][]} */
function remembered() {
  try {
    const all = JSON.parse(kept(STORE) || '[]');
    return Array.isArray(all) ? all : [];
  } catch {
    return [];
  }
}

export class Opening {
  /** @param {import('../main.js').Shell} shell */
  constructor(shell) {
    this.shell = shell;
    /** The drawing that is open, by the engine's number and by the name that it is kept under, and its view. */
    this.drawing = NaN;
    this.key = '';
    this.view = '';
    const leave = () => this.#remember();
    addEventListener('pagehide', leave);
    document.addEventListener('visibilitychange', leave);
  }

  #remember() {
    const { key, view } = this;
    if (view) {
      const others = remembered().filter(([other]) => other !== key);
      keep(STORE, JSON.stringify([...others, [key, view]].slice(-MOST)));
    }
  }

  /** At each frame. */
  show() {
    const { drawings, engine, wake } = this.shell;
    if (drawings.moving || drawings.keeper.drawing !== engine.drawing) {
      return; // it is being opened
    }
    if (engine.drawing !== this.drawing) {
      this.#remember();
      this.drawing = engine.drawing;
      this.key = drawings.key;
      const [, view = ''] = remembered().find(([key]) => key === this.key) ?? [];
      if (engine.enter('view', view)) {
        wake();
      }
    }
    this.view = engine.number('view');
  }
}
