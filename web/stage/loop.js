// The frame loop: paints the engine's frame and passes it to everything that shows part of it.

import { want } from '../page/build.js';
import { word } from '../page/words.js';
import { Cursor, Role, names } from '../engine/codes.js';
import { isPage } from '../engine/frame.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('../engine/types.js').Frame} Frame */

/** CSS cursor names by the engine's numbers. */
const CURSORS = names(Cursor).map((name) => name.replace(/^resize_(.*)/, '$1-resize').replace('_', '-'));

const GLIDE = 250; // milliseconds that the view takes to where it jumps
/** @param {number} share 0..1 */
const ease = (share) => 1 - (1 - Math.min(share, 1)) ** 3;

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Loop {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.due = false;
    this.noticeVersion = 0;
    this.asked = 0; // when the frame that is due was
    this.jumps = -1; // of the view, as far as shown
    this.jumped = 0; // when the last one was first seen, while it is under way
    this.deep = false;
    /** @type {Promise<typeof import('./space.js')> | undefined} */
    this.fetched = undefined;
    /** @type {import('./space.js').Space | undefined} */
    this.space = undefined;
    /** Number of objects chosen. */
    this.selected = 0;
    this.tool = 0;
    /** Frames painted and the time taken, for tests and measurements. */
    this.cost = { frames: 0, engine: 0, paint: 0 };
  }

  /** Follows the stage's size and the pixel density of the window's screen. */
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

  /** Requests a frame, once, unless the engine cannot make one. */
  wake() {
    if (!this.due && !this.shell.engine.dead) {
      this.due = true;
      this.asked = performance.now();
      requestAnimationFrame(() => this.#frame());
    }
  }

  #frame() {
    const { files, painter, panel, mirror, settings, words, requests } = this.shell;
    this.due = false;
    const start = performance.now();
    const frame = this.#glide(start);
    if (!frame) {
      this.wake();
      return;
    }
    const made = performance.now();
    frame.name &&= files.name; // the user may have named it since its journal was begun
    if (frame.tilt || frame.surfaces || frame.moves) {
      void this.#deepen(frame.tilt + frame.moves !== 0);
    }
    this.space?.show(frame, start - this.asked);
    this.shell.settling?.show(frame);
    painter.paint(frame);
    panel.show(frame);
    this.#tell(frame);
    mirror?.show(frame);
    this.shell.dial?.show(frame);
    settings.note();
    void words.follow();
    this.cost.frames++;
    this.cost.engine += made - start;
    this.cost.paint += performance.now() - made;
    requests.grant(frame.requests);
  }

  /**
   * Fetches what paints a tilted view with a depth, at the first tilt or surface; until then it is painted as lines.
   * @param {boolean} tilted
   */
  async #deepen(tilted) {
    this.fetched ??= want(import('./space.js'));
    if (tilted && !this.deep) {
      this.deep = true;
      const { Space } = await this.fetched;
      if (await this.shell.whole.complete()) {
        this.space = new Space(this.shell);
        this.wake();
      }
    }
  }

  /**
   * A frame, on the way of the view's last jump unless motion is to be reduced.
   * @param {number} now
   * @returns {Frame | null}
   */
  #glide(now) {
    const { engine } = this.shell;
    if (this.jumped) {
      engine.glide(ease((now - this.jumped) / GLIDE));
    }
    const frame = engine.frame();
    if (frame && frame.jumps !== this.jumps) {
      const shown = this.jumps >= 0 && !matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.jumps = frame.jumps;
      this.jumped = shown ? now : 0;
      if (!shown) {
        return frame;
      }
      if (frame.stillChanged) { // and what has changed
        engine.stillVersion = -1;
        this.shell.painter.retheme();
      }
      const next = this.#glide(now);
      if (next) {
        next.requests |= frame.requests; // the engine makes each of them once
      }
      return next;
    }
    this.jumped = now - this.jumped < GLIDE ? this.jumped : 0;
    if (this.jumped) {
      this.wake();
    }
    return frame;
  }

  /** Passes on what a frame says besides its picture. @param {Frame} frame */
  #tell(frame) {
    const { stage, files, notices, drawings, painter } = this.shell;
    stage.dataset.cursor = CURSORS[frame.cursor] ?? 'cross';
    const empty = frame.still.length === 0;
    part('welcome').hidden = painter.unseen >= 0 || !frame.still.every(isPage) || frame.live.some((item) => item.role < Role.GRID);
    const { ours } = drawings;
    this.selected = frame.selected;
    this.tool = frame.tool;
    files.unsaved = frame.unsaved && ours;
    files.edited = files.unsaved || frame.canUndo;
    this.#tellLost(frame.lost);
    files.given &&= !files.edited;
    drawings.keepFrame(frame.unsaved, empty);
    if (frame.noticeVersion !== this.noticeVersion) {
      if (frame.notice) {
        notices.say(frame.notice, this.#offer(frame.offer));
      } else {
        notices.pass(); // what it offered has been done
      }
    }
    this.noticeVersion = frame.noticeVersion;
  }

  /** What a notice offers to do. @param {string} name of a command */
  #offer(name) {
    const { engine } = this.shell;
    const run = () => {
      engine.command(name);
      this.wake();
    };
    return name ? { label: word(`command.${name}`), run } : null;
  }

  /** Offers a list of what cannot be kept of the file. @param {number} lost */
  #tellLost(lost) {
    const button = part('unkept');
    const text = lost ? word(this.shell.engine.keeps ? 'shell.unseen' : 'shell.unkept', lost) : '';
    if (button.textContent !== text) {
      button.textContent = text;
      button.hidden = !lost;
    }
  }
}
