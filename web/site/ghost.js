// A ghost pen: plays a journal over the drawing, in an engine and on canvases of its own, so that nothing of it enters
// the drawing or its history. The engine is fed the journal's own times; only how many events a frame gets follows the
// clock, so what is drawn is the same on any machine.

import { Device, Phase } from '../engine/codes.js';
import { Engine } from '../engine/engine.js';
import { headOf } from '../keep/address.js';
import { Painter } from '../stage/paint.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {{ x: number, y: number, zoom: number, angle: number }} View */
/** @typedef {import('../engine/types.js').Pointer} Pointer */

const PAUSE = 350; // milliseconds between strokes
const REST = 500; // milliseconds for which the result is shown
/** @type {Record<string, number>} */
const phases = { hover: Phase.HOVER, down: Phase.DOWN, move: Phase.MOVE, up: Phase.UP };
/** @type {Record<string, number>} */
const devices = { mouse: Device.MOUSE, pen: Device.PEN, touch: Device.TOUCH };

/** The frame's view. @param {Engine} engine @returns {View} */
function viewOf(engine) {
  const frame = engine.frame();
  const { x, y, zoom, angle } = frame ?? { x: 0, y: 0, zoom: 1, angle: 0 };
  return { x, y, zoom, angle };
}

/**
 * When each event is due, in milliseconds: strokes as fast as they must be, with pauses between them.
 * @param {any[]} events @param {number} length of all
 */
function scheduleOf(events, length) {
  const strokes = events.filter(({ pointer }) => pointer === 'up').length;
  const gaps = events.map(({ pointer, time }, i) => (i === 0 || pointer === 'down' ? 0 : time - events[i - 1].time));
  const drawn = gaps.reduce((sum, gap) => sum + gap, 0);
  const scale = Math.max(length - strokes * PAUSE - REST, length / 3) / Math.max(drawn, 1);
  let due = 0;
  return gaps.map((gap, i) => (due += events[i].pointer === 'down' ? PAUSE : gap * scale));
}

export class Ghost {
  /** @param {Shell} shell @param {string} journal @param {number} length milliseconds */
  constructor(shell, journal, length) {
    this.shell = shell;
    this.head = new TextEncoder().encode(headOf(journal).filter((line) => !line.startsWith('{"resize"')).join('\n'));
    /** @type {any[]} */
    this.events = journal.split('\n').filter((line) => line.startsWith('{"pointer"')).map((line) => JSON.parse(line));
    this.due = scheduleOf(this.events, length);
    this.length = length;
    this.engine = new Engine(shell.engine.module);
    this.window = JSON.parse(/^\{"resize".*\}$/m.exec(journal)?.[0] ?? '{"resize":[1280,800,1]}').resize;
    this.layer = document.createElement('div');
    this.layer.className = 'layer ghost';
    this.layer.setAttribute('aria-hidden', 'true');
    const canvases = [0, 1].map(() => document.createElement('canvas'));
    canvases.forEach((canvas) => { canvas.className = 'layer'; });
    this.pen = document.createElement('div');
    this.pen.className = 'ghost-pen';
    this.layer.append(...canvases, this.pen);
    this.painter = new Painter(canvases[0], canvases[1], shell.theme);
    /** Called when it has ended, or was stopped. */
    this.onstop = () => {};
    this.running = false;
    this.round = 0;
    this.next = 0;
    /** The journal's view, and the one shown. */
    this.from = this.to = { x: 0, y: 0, zoom: 1, angle: 0 };
    /** @type {[number, number, number]} */
    this.size = [1, 1, 1];
  }

  /** @param {Shell} shell @param {string} address @param {number} length */
  static async make(shell, address, length) {
    const response = await fetch(address);
    return new Ghost(shell, await response.text(), length);
  }

  /** The journal's document in the journal's own window: what the pen does there does not depend on this one. */
  #begin() {
    const { engine, painter } = this;
    engine.resize(this.window[0], this.window[1], this.window[2]);
    engine.replay(this.head);
    engine.command('view-fit');
    this.from = viewOf(engine);
    this.to = this.shell.painter.painted ?? this.from;
    this.size = this.#size();
    painter.resize(...this.size);
    engine.stillVersion = -1;
    this.next = 0;
  }

  /** Of the page's window. @returns {[number, number, number]} */
  #size() {
    const [width, height, ratio] = this.shell.engine.size;
    return [width, height, ratio];
  }

  start() {
    this.stop();
    this.#begin();
    this.shell.stage.append(this.layer);
    this.running = true;
    const round = ++this.round;
    const started = performance.now();
    const step = () => {
      if (!this.running || round !== this.round) {
        return;
      }
      const now = performance.now() - started;
      this.#upTo(now);
      if (now >= this.length) {
        this.stop();
      } else {
        requestAnimationFrame(step);
      }
    };
    step();
  }

  /** @param {number} now */
  #upTo(now) {
    const { engine, events, due } = this;
    this.to = this.shell.painter.painted ?? this.to;
    const size = this.#size();
    if (size.some((value, i) => value !== this.size[i])) { // a panel has opened beside the stage, say
      this.size = size;
      this.painter.resize(...size);
    }
    /** @type {Pointer[]} */
    const samples = [];
    for (; this.next < events.length && due[this.next] <= now; this.next++) {
      samples.push(this.#sample(events[this.next]));
    }
    const last = samples.at(-1);
    if (last) {
      engine.pointer(samples);
      const [x, y] = [this.#map('x', last.x), this.#map('y', last.y)];
      this.pen.style.transform = `translate(${x}px, ${y}px)`;
      this.pen.classList.toggle('down', last.phase === Phase.DOWN || last.phase === Phase.MOVE);
    }
    const frame = engine.frame();
    if (frame) {
      const { x, y, zoom, angle } = this.to;
      this.painter.paint({ ...frame, x, y, zoom, angle });
    }
  }

  /** A place of the journal's window in this one. @param {'x' | 'y'} axis @param {number} value */
  #map(axis, value) {
    return (this.from[axis] + value / this.from.zoom - this.to[axis]) * this.to.zoom;
  }

  /** @param {any} event of the journal @returns {Pointer} */
  #sample(event) {
    const [tiltX, tiltY] = event.tilt ?? [0, 0];
    return { phase: phases[event.pointer] ?? Phase.CANCEL, device: devices[event.device] ?? Device.PEN,
      contact: event.id ?? 1, buttons: event.buttons ?? 0, modifiers: event.modifiers ?? 0, x: event.x, y: event.y,
      pressure: event.pressure ?? 0, tiltX, tiltY, twist: 0, width: 0, height: 0, time: event.time, predicted: false };
  }

  /** Ends it; the visitor's own drawing is under it, as it was. */
  stop() {
    if (this.running) {
      this.running = false;
      this.layer.remove();
      this.onstop();
    }
  }
}
