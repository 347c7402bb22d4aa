// The picture that the camera of the time strip sees, docked in a corner of the drawing: a second view, in which the move is
// corrected by the gestures that move the view. Seen through the camera, the two change places. It is painted with the
// programs and buffers of the tilted view, and copied to a canvas of its own.

import { stand } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('./time.js').Move} Move */

/** As bat_correction (panels.h). */
const Correct = Object.freeze({ TURN: 0, ROLL: 1, ORBIT: 2, PAN: 3, DOLLY: 4 });
const SHAPE = 16 / 9;
const [LEAST, MOST] = [160, 800]; // px wide
const STILL = 4;        // px that a tap may travel
const DOUBLE = 350;     // ms between the taps of a double tap
const WHEEL_ENDS = 300; // ms after its last step a wheel's correction is whole
const NEAR = 24;        // px between a pen that draws and the view
const STEP = 12;        // px, of an arrow key
const CORNERS = ['end', 'top', 'start']; // as lines of text run
const NAVIGATING = 2 | 4; // buttons: what orbits and what pans

/**
 * @typedef {object} Drag
 * @property {number} kind
 * @property {[number, number]} from
 * @property {[number, number]} to
 * @property {boolean} moved
 */

export class Lens {
  /**
   * @param {import('../main.js').Shell} shell
   * @param {() => void} changed what a correction changes shows in the strip
   */
  constructor(shell, changed) {
    this.shell = shell;
    this.changed = changed;
    this.move = /** @type {Move | null} */ (null);
    this.box = document.createElement('section');
    this.box.className = 'lens';
    this.box.hidden = true;
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.role = 'application';
    this.pen = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    this.grip = document.createElement('button');
    this.grip.type = 'button';
    this.grip.className = 'lens-grip';
    this.box.append(this.canvas, this.grip);
    this.width = 0; // px; 0: the style's
    this.corner = CORNERS[0];
    /** @type {Map<number, PointerEvent>} that are down */
    this.down = new Map();
    /** @type {Drag | null} */
    this.drag = null;
    this.tapped = 0;
    this.flew = false; // it played when the pen came down
    this.turning = 0;  // timer of the wheel
    this.#listen(this.canvas);
    this.#listen(shell.stage, () => this.move?.through === 1);
    this.#listenGrip();
    shell.stage.addEventListener('pointermove', (event) => this.#makeWay(event));
    this.canvas.addEventListener('keydown', (event) => this.#key(event));
    addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && (this.drag || this.turning)) {
        this.#drop();
        event.stopPropagation();
      }
    }, { capture: true });
    void stand(this.box, 'styles/lens.css', shell);
  }

  /** In device pixels: how large the picture is. */
  get size() {
    const { ratio } = this.shell.painter;
    const { clientWidth, clientHeight } = this.canvas;
    return { width: Math.round(clientWidth * ratio), height: Math.round(clientHeight * ratio), wide: clientWidth, tall: clientHeight };
  }

  /** @param {Move} move */
  show(move) {
    this.move = move;
    this.box.hidden = !move.sees || !move.lens;
    this.box.dataset.corner = this.corner;
    this.box.ariaLabel = word(move.through ? 'lens.room' : 'lens.name', move.name);
    this.canvas.ariaLabel = this.box.ariaLabel;
    this.canvas.title = word('lens.how');
    this.grip.title = this.grip.ariaLabel = word('lens.size');
    const { offsetLeft, offsetTop, offsetWidth } = this.shell.stage;
    const beside = document.dir === 'rtl' ? document.body.clientWidth - offsetLeft - offsetWidth : offsetLeft;
    this.box.style.setProperty('--beside', `${beside}px`);
    this.box.style.setProperty('--below', `${offsetTop}px`);
    if (this.width) {
      this.box.style.width = `${this.width}px`;
    }
  }

  /** Takes the picture over from the canvas it was painted on, whose bottom left corner it is in. @param {HTMLCanvasElement} from */
  copy(from) {
    const { width, height } = this.size;
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.pen.clearRect(0, 0, width, height);
    this.pen.drawImage(from, 0, from.height - height, width, height, 0, 0, width, height);
  }

  // ---- corrections ----

  /** @param {Drag} drag @param {boolean} done @param {HTMLElement} on */
  #correct({ kind, from, to }, done, on) {
    const { engine, wake } = this.shell;
    engine.act('editor_correct', kind, on.clientWidth, on.clientHeight, ...from, ...to, Number(done));
    this.changed();
    wake();
  }

  #drop() {
    clearTimeout(this.turning);
    this.turning = 0;
    this.drag = null;
    this.flew = false;
    this.shell.engine.command('cancel');
    this.changed();
    this.shell.wake();
  }

  /** @param {boolean} on */
  #play(on) {
    if ((this.move?.playing === 1) !== on) {
      this.shell.engine.command('move-play');
      this.changed();
    }
  }

  /** What a contact does: as over the drawing, but a pen that would draw turns the camera. @param {PointerEvent} event */
  #kindOf(event) {
    if (event.buttons & 2 || (event.buttons & 4 && event.altKey)) {
      return Correct.ORBIT;
    }
    if (event.buttons & 4) {
      return Correct.PAN;
    }
    return event.shiftKey ? Correct.ROLL : Correct.TURN;
  }

  /** The middle of what is down, and how far apart it is. @param {HTMLElement} on @returns {{ at: [number, number], apart: number }} */
  #hand(on) {
    const { left, top } = on.getBoundingClientRect();
    const list = [...this.down.values()];
    const mean = (/** @type {(event: PointerEvent) => number} */ of) => list.reduce((sum, event) => sum + of(event), 0) / list.length;
    const at = /** @type {[number, number]} */ ([mean(({ clientX }) => clientX) - left, mean(({ clientY }) => clientY) - top]);
    const [a, b] = list;
    return { at, apart: b ? Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) : 0 };
  }

  /** @param {HTMLElement} on @param {() => boolean} [when] */
  #listen(on, when = () => this.move?.through !== 1) {
    on.addEventListener('pointerdown', (event) => when() && this.#begin(event, on));
    on.addEventListener('pointermove', (event) => this.down.has(event.pointerId) && this.#go(event, on));
    on.addEventListener('pointerup', (event) => this.#end(event, on));
    on.addEventListener('pointercancel', (event) => {
      if (this.down.delete(event.pointerId) && this.drag) {
        this.#drop();
      }
    });
    on.addEventListener('contextmenu', (event) => event.preventDefault());
    on.addEventListener('wheel', (event) => when() && this.#wheel(event, on), { passive: false });
    if (on === this.canvas) { // the room, small: a double tap brings it back
      on.addEventListener('pointerup', (event) => !when() && this.#tap(event));
    }
  }

  /** @param {PointerEvent} event @param {HTMLElement} on */
  #begin(event, on) {
    event.preventDefault();
    on.focus({ preventScroll: true });
    try {
      on.setPointerCapture(event.pointerId);
    } catch {
      // It is already gone; its end follows as an event.
    }
    if (this.down.size === 0) {
      this.flew = this.move?.playing === 1;
      this.#play(false); // what is corrected stands still
    } else if (this.drag?.moved) {
      return; // a finger that joins what has begun
    }
    this.down.set(event.pointerId, event);
    const { at, apart } = this.#hand(on);
    this.apart = apart;
    this.drag = { kind: this.down.size > 1 ? Correct.PAN : this.#kindOf(event), from: at, to: at, moved: false };
  }

  /** @param {PointerEvent} event @param {HTMLElement} on */
  #go(event, on) {
    this.down.set(event.pointerId, event);
    const { drag } = this;
    if (!drag) {
      return;
    }
    const { at, apart } = this.#hand(on);
    const spread = this.apart && apart ? Math.log2(apart / this.apart) * 200 : 0;
    const far = Math.hypot(at[0] - drag.from[0], at[1] - drag.from[1]);
    if (!drag.moved && Math.max(far, Math.abs(spread)) <= STILL) {
      return;
    }
    if (!drag.moved && this.down.size > 1 && Math.abs(spread) > far) {
      drag.kind = Correct.DOLLY;
    }
    drag.moved = true;
    drag.to = drag.kind === Correct.DOLLY ? [drag.from[0], drag.from[1] - spread] : at;
    this.#correct(drag, false, on);
  }

  /** @param {PointerEvent} event @param {HTMLElement} on */
  #end(event, on) {
    if (!this.down.delete(event.pointerId)) {
      return;
    }
    const { drag } = this;
    if (drag?.moved) {
      this.drag = null;
      this.#correct(drag, true, on);
    }
    if (this.down.size === 0) {
      const tap = drag && !drag.moved;
      this.drag = null;
      if (this.flew) {
        this.#play(true); // and flies on
      }
      this.flew = false;
      if (tap) {
        this.#tap(event);
      }
    }
  }

  /** Two taps: the views change places. @param {PointerEvent} event */
  #tap(event) {
    const again = event.timeStamp - this.tapped < DOUBLE;
    this.tapped = again ? 0 : event.timeStamp;
    if (again && !(event.buttons & NAVIGATING)) {
      this.#swap();
    }
  }

  #swap() {
    this.shell.engine.command('look-through');
    this.changed();
    this.shell.wake();
  }

  /** @param {WheelEvent} event @param {HTMLElement} on */
  #wheel(event, on) {
    event.preventDefault();
    if (this.drag) {
      return;
    }
    const { left, top } = on.getBoundingClientRect();
    const way = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
    if (!this.turning) {
      const at = /** @type {[number, number]} */ ([event.clientX - left, event.clientY - top]);
      this.rolls = { kind: Correct.DOLLY, from: at, to: at, moved: true };
      this.#play(false);
    }
    const rolls = /** @type {Drag} */ (this.rolls);
    rolls.to = [rolls.from[0], rolls.to[1] + way];
    this.#correct(rolls, false, on);
    clearTimeout(this.turning);
    this.turning = setTimeout(() => {
      this.turning = 0;
      this.#correct(rolls, true, on);
    }, WHEEL_ENDS);
  }

  /** Arrow keys turn, with Shift pan; + and - go nearer and away. @param {KeyboardEvent} event */
  #key(event) {
    const { wide, tall } = this.size;
    const way = { ArrowLeft: [STEP, 0], ArrowRight: [-STEP, 0], ArrowUp: [0, STEP], ArrowDown: [0, -STEP], '+': [0, -STEP], '-': [0, STEP] }[event.key];
    if (event.key === 'Enter') {
      this.#swap();
    } else if (way && !event.ctrlKey && !event.altKey && !event.metaKey && !this.drag && this.move?.through !== 1) {
      const from = /** @type {[number, number]} */ ([wide / 2, tall / 2]);
      const kind = event.key.length === 1 ? Correct.DOLLY : event.shiftKey ? Correct.PAN : Correct.TURN;
      this.#play(false);
      this.#correct({ kind, from, to: [from[0] + way[0], from[1] + way[1]], moved: true }, true, this.canvas);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  // ---- where it is ----

  /** Never over a pen that draws: it goes to the next corner that is free. @param {PointerEvent} event */
  #makeWay({ buttons, clientX, clientY }) {
    if (!buttons || this.box.hidden || this.move?.through === 1) {
      return;
    }
    for (let i = 0; i < CORNERS.length && this.#over(clientX, clientY); i++) {
      this.corner = CORNERS[(CORNERS.indexOf(this.corner) + 1) % CORNERS.length];
      this.box.dataset.corner = this.corner;
    }
  }

  /** @param {number} x @param {number} y */
  #over(x, y) {
    const { left, right, top, bottom } = this.box.getBoundingClientRect();
    return x > left - NEAR && x < right + NEAR && y > top - NEAR && y < bottom + NEAR;
  }

  #listenGrip() {
    const { grip } = this;
    const resize = (/** @type {number} */ width) => {
      const { clientWidth, clientHeight } = this.shell.stage;
      this.width = Math.round(Math.min(Math.max(width, LEAST), MOST, 0.6 * clientWidth, 0.6 * clientHeight * SHAPE));
      this.box.style.width = `${this.width}px`;
      this.shell.wake();
    };
    grip.addEventListener('pointerdown', (event) => grip.setPointerCapture(event.pointerId));
    grip.addEventListener('pointermove', ({ pointerId, clientX }) => {
      if (grip.hasPointerCapture(pointerId)) {
        const { left, right } = this.box.getBoundingClientRect();
        resize((this.corner === 'end') === (document.dir !== 'rtl') ? right - clientX : clientX - left);
      }
    });
    grip.addEventListener('keydown', (event) => {
      const way = { ArrowUp: 16, ArrowRight: 16, ArrowDown: -16, ArrowLeft: -16 }[event.key];
      if (way) {
        resize(this.box.clientWidth + way);
        event.preventDefault();
        event.stopPropagation();
      }
    });
  }
}
