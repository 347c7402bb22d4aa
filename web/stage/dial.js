// The dial: a small horizon with the three axes of the room, as they lie in the view. A tap brings the page home, a
// drag turns the view, the ends of the axes are the named views.

import { Device, Phase } from '../engine/codes.js';
import { stand } from '../page/build.js';
import { word } from '../page/words.js';
import { Opening } from './opening.js';

const REACH = 16; // px from the middle to the end of an axis that is seen in its full length
const FAST = 2; // a drag on the dial turns so many times as far as one on the drawing
const STILL = 4; // px that a tap may move
const SHORT = 0.4; // of the full length: the end of a shorter axis cannot be tapped
const NOWHERE = -1e5; // view pixels: a drag on the dial has nothing of the drawing under it
const CONTACT = 0xffffff00;
const SECONDARY = 2; // as PointerEvent.buttons has it
/** The ends: commands, and where they point in the room, of which the page is a floor or a wall; z points down. */
const ENDS = /** @type {[string, number[]][]} */ ([
  ['view-front', [0, 1, 0]], ['view-side', [1, 0, 0]], ['view-top', [0, 0, -1]],
]);

/** The faces between two ends, by their numbers: planes to draw on. */
const FACES = /** @type {[string, number, number][]} */ ([
  ['plane-level', 0, 1], ['plane-front', 1, 2], ['plane-side', 0, 2],
]);
const FACE = [0.24, 0.76]; // of the axes: the middle of the dial stays the way home
const THIN = 0.2; // sine of the angle between the axes of a face that is too thin to tap

/** @param {string} name @param {Record<string, string | number>} traits */
function drawn(name, traits) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [trait, value] of Object.entries(traits)) {
    node.setAttribute(trait, String(value));
  }
  return node;
}

export class Dial {
  /** @param {import('../main.js').Shell} shell */
  constructor(shell) {
    const { engine, stage, wake } = shell;
    this.engine = engine;
    this.wake = wake;
    this.opening = new Opening(shell);
    this.box = document.createElement('div');
    this.box.className = 'dial';
    this.box.setAttribute('role', 'group');
    this.home = this.#button('view-upright');
    this.horizon = drawn('ellipse', { class: 'horizon', rx: REACH });
    this.axes = ENDS.map(() => drawn('line', {}));
    const picture = drawn('svg', { viewBox: '-22 -22 44 44', 'aria-hidden': 'true' });
    picture.append(this.horizon, ...this.axes);
    this.home.append(picture);
    this.ends = ENDS.map(([command]) => this.#end(command));
    this.faces = FACES.map(([command]) => this.#end(command, 'face'));
    this.box.append(this.home, ...this.faces, ...this.ends);
    this.shown = '';
    this.said = '';
    this.#listen();
    this.#say();
    void stand(this.box, 'styles/dial.css', { stage, wake });
  }

  /** @param {string} command */
  #button(command) {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.command = command;
    button.addEventListener('click', (event) => {
      if (event.detail === 0) { // by key; a tap is seen by its pointer
        this.#run(button);
      }
    });
    return button;
  }

  /** An end is smaller than a target may be: it is for pens and mice, keys have a command each. @param {string} command @param {string} kind */
  #end(command, kind = 'end') {
    const end = document.createElement('span');
    end.className = kind;
    end.dataset.command = command;
    return end;
  }

  /** @param {HTMLElement} button */
  #run(button) {
    this.engine.command(button.dataset.command ?? '');
    this.wake();
  }

  #listen() {
    /** @type {PointerEvent | null} */
    let start = null;
    /** @type {HTMLElement | null} */
    let pressed = null;
    const tell = (/** @type {number} */ phase, /** @type {PointerEvent} */ event) => {
      const [x, y] = start ? [event.clientX - start.clientX, event.clientY - start.clientY].map((way) => FAST * way) : [0, 0];
      this.engine.pointer([{
        phase, device: Device.MOUSE, contact: CONTACT, buttons: SECONDARY, modifiers: 0, x: NOWHERE + x, y: NOWHERE + y,
        pressure: 0, tiltX: 0, tiltY: 0, twist: 0, width: 0, height: 0, time: event.timeStamp, predicted: false,
      }]);
      this.wake();
    };
    let dragged = false;
    this.box.addEventListener('pointerdown', (event) => {
      start = event;
      dragged = false;
      pressed = event.target instanceof HTMLElement ? /** @type {HTMLElement | null} */ (event.target.closest('[data-command]')) : null;
      this.box.setPointerCapture(event.pointerId); // a quick drag leaves the dial at once
    });
    this.box.addEventListener('pointermove', (event) => {
      if (!start || event.pointerId !== start.pointerId) {
        return;
      }
      if (!dragged && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) > STILL) {
        dragged = true;
        tell(Phase.DOWN, start);
      }
      if (dragged) {
        tell(Phase.MOVE, event);
      }
    });
    const end = (/** @type {PointerEvent} */ event) => {
      if (start && dragged) {
        tell(event.type === 'pointerup' ? Phase.UP : Phase.CANCEL, event);
      } else if (start && event.type === 'pointerup' && pressed) {
        this.#run(pressed);
      }
      start = null;
    };
    this.box.addEventListener('pointerup', end);
    this.box.addEventListener('pointercancel', end);
  }

  /** Names all of it, in the language of now. */
  #say() {
    const buttons = [this.home, ...this.ends, ...this.faces];
    const words = buttons.map((button) => word(`command.${button.dataset.command}`));
    const said = [word('dial.name'), ...words].join('\n');
    if (said !== this.said) {
      this.said = said;
      this.box.ariaLabel = word('dial.name');
      buttons.forEach((button, i) => {
        button.title = words[i];
      });
      [this.home.ariaLabel] = words;
    }
  }

  /** @param {import('../engine/types.js').Frame} frame */
  show(frame) {
    this.#say();
    this.opening.show();
    const shown = [frame.angle, frame.tilt, frame.revision].join();
    if (shown === this.shown) {
      return;
    }
    this.shown = shown;
    this.box.classList.toggle('tilted', frame.tilt !== 0);
    const [turn, tilt, roll] = this.engine.number('room').split(' ').map((degrees) => (Number(degrees) * Math.PI) / 180);
    const [c, s, k, h] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const [head, over] = [Math.cos(roll), Math.sin(roll)];
    this.horizon.setAttribute('ry', String(REACH * Math.abs(k)));
    this.horizon.setAttribute('transform', `rotate(${(roll * 180) / Math.PI})`);
    const places = ENDS.map(([, [x, y, z]], i) => {
      const level = c * x - s * y;
      const back = s * x + c * y;
      const below = back * k + z * h;
      const along = head * level - over * below;
      const down = over * level + head * below;
      const [endX, endY, ahead] = [REACH * along, REACH * down, z * k - back * h];
      this.axes[i].setAttribute('x2', String(endX));
      this.axes[i].setAttribute('y2', String(endY));
      const end = this.ends[i];
      end.style.translate = `${endX}px ${endY}px`;
      end.hidden = Math.hypot(along, down) < SHORT;
      for (const part of [end, this.axes[i]]) {
        part.classList.toggle('far', ahead > 0.05);
      }
      return [endX, endY];
    });
    FACES.forEach(([, a, b], i) => {
      const [[ax, ay], [bx, by]] = [places[a], places[b]];
      this.faces[i].hidden = frame.tilt === 0 || Math.abs(ax * by - ay * bx) < THIN * REACH * REACH;
      const [near, far] = FACE;
      const corners = [[near, near], [far, near], [far, far], [near, far]]
        .map(([along, over]) => `${22 + along * ax + over * bx}px ${22 + along * ay + over * by}px`);
      this.faces[i].style.clipPath = `polygon(${corners.join()})`;
    });
  }
}
