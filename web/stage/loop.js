// One frame at a time: the engine's picture is painted, and told to all that show something of it.

import { word } from '../page/words.js';
import { Cursor, Role, names } from '../engine/codes.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('../engine/types.js').Frame} Frame */

/** Cursors by their numbers, as style sheets name them. */
const CURSORS = names(Cursor).map((name) => name.replace(/^resize_(.*)/, '$1-resize').replace('_', '-'));

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Loop {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.due = false;
    this.noticeVersion = 0;
    /** Frames painted and the time they took, for tests and measurements. */
    this.cost = { frames: 0, engine: 0, paint: 0 };
  }

  /** Follows the stage's size, and the density of the screen that the window is on. */
  watch() {
    new ResizeObserver(() => this.#resize()).observe(this.shell.stage);
    this.#watchRatio();
    this.#resize();
  }

  #watchRatio() {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    query.addEventListener('change', () => {
      this.#resize();
      this.#watchRatio();
    }, { once: true });
  }

  #resize() {
    const { engine, painter, stage: { clientWidth, clientHeight } } = this.shell;
    engine.resize(clientWidth, clientHeight, devicePixelRatio);
    painter.resize(clientWidth, clientHeight, devicePixelRatio);
    this.wake();
  }

  /** Asks for a frame, once; not of an engine that cannot make one. */
  wake() {
    if (!this.due && !this.shell.engine.dead) {
      this.due = true;
      requestAnimationFrame(() => this.#frame());
    }
  }

  #frame() {
    const { engine, painter, panel, mirror, settings, words, requests } = this.shell;
    this.due = false;
    const start = performance.now();
    const frame = engine.frame();
    if (!frame) {
      this.wake();
      return;
    }
    const made = performance.now();
    painter.paint(frame);
    panel.show(frame);
    this.#tell(frame);
    mirror?.show(frame);
    settings.note();
    void words.follow();
    this.cost.frames++;
    this.cost.engine += made - start;
    this.cost.paint += performance.now() - made;
    requests.grant(frame.requests);
  }

  /** What a frame says beside its picture. @param {Frame} frame */
  #tell(frame) {
    const { stage, engine, files, keeper, notices, drawings } = this.shell;
    stage.dataset.cursor = CURSORS[frame.cursor] ?? 'cross';
    const empty = frame.still.length === 0;
    part('welcome').hidden = !empty || frame.live.some((item) => item.role < Role.GRID);
    const { ours } = drawings;
    files.unsaved = frame.unsaved && ours;
    this.#tellLost(frame.lost);
    if (ours) {
      keeper.note(files.name, engine.session, engine.journal, frame.unsaved, !files.bound && !empty);
    }
    if (frame.notice && frame.noticeVersion !== this.noticeVersion) {
      notices.say(frame.notice);
    }
    this.noticeVersion = frame.noticeVersion;
  }

  /** What of the file cannot be kept, to be looked at. @param {number} lost */
  #tellLost(lost) {
    const button = part('unkept');
    const text = lost ? word('shell.unkept', lost) : '';
    if (button.textContent !== text) {
      button.textContent = text;
      button.hidden = !lost;
    }
  }
}
