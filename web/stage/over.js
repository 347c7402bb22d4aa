// What floats over the stage takes taps. A press on it that travels was meant for the drawing: a stroke, from where it
// began. What is dragged itself says so by `touch-action: none`, or by being a field.

/** @typedef {import('../main.js').Shell} Shell */

const SLACK = 6; // pixels that a tap may travel, at most,
const SHARE = 0.25; // and this share of what it presses
const FIELDS = 'input, select, textarea, [popover]';

export class Over {
  /** Once a page. @param {Shell} shell */
  static begin(shell) {
    shell.over ??= new Over(shell);
  }

  /** @param {Shell} shell */
  constructor({ stage, input }) {
    this.stage = stage;
    this.input = input;
    /** Presses that have not travelled, by pointer: their events, and how far they may. @type {Map<number, { events: PointerEvent[], slack: number }>} */
    this.presses = new Map();
    /** Whether the last one became a stroke. */
    this.drawn = false;
    addEventListener('pointerdown', (event) => this.#down(event), true);
    addEventListener('pointermove', (event) => this.#move(event), true);
    for (const end of ['pointerup', 'pointercancel']) {
      addEventListener(end, (event) => this.presses.delete(/** @type {PointerEvent} */ (event).pointerId), true);
    }
    for (const other of ['click', 'selectstart', 'dragstart']) {
      addEventListener(other, (event) => {
        if (other === 'click' ? this.drawn && /** @type {MouseEvent} */ (event).detail > 0 : this.presses.size > 0) {
          event.preventDefault();
          event.stopPropagation();
        }
      }, true);
    }
  }

  /** What is pressed, if it floats over the stage and is not dragged itself. @param {PointerEvent} event */
  #pressed({ target, clientX, clientY }) {
    const { left, top, right, bottom } = this.stage.getBoundingClientRect();
    if (!(target instanceof Element) || clientX < left || clientX > right || clientY < top || clientY > bottom) {
      return null;
    }
    const main = /** @type {Element} */ (this.stage.parentElement);
    /** @type {Element | null} */
    let on = target;
    for (; on && on !== this.stage && on !== main; on = on.parentElement) {
      if (on.matches(FIELDS) || getComputedStyle(on).touchAction === 'none') {
        return null;
      }
    }
    return on && target !== this.stage ? target.closest('button, a, summary, label') ?? target : null;
  }

  /** @param {PointerEvent} event */
  #down(event) {
    this.drawn = false;
    const on = event.button === 0 ? this.#pressed(event) : null;
    if (on) {
      const { width, height } = on.getBoundingClientRect();
      this.presses.set(event.pointerId, { events: [event], slack: Math.min(SLACK, SHARE * Math.min(width, height)) });
    }
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const press = this.presses.get(event.pointerId);
    if (!press) {
      return;
    }
    const [{ clientX, clientY }] = press.events;
    press.events.push(event);
    if (event.buttons === 0) { // its end was lost
      this.presses.delete(event.pointerId);
    } else if (Math.hypot(event.clientX - clientX, event.clientY - clientY) > press.slack) {
      this.presses.delete(event.pointerId);
      this.drawn = true;
      this.input.begin(press.events);
    }
  }
}
