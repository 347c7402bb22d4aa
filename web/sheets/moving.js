// A small moving picture: strokes of a pen, drawn by an engine of its own on canvases of its own.

import { Device, Phase } from '../engine/codes.js';
import { Engine } from '../engine/engine.js';
import { Painter } from '../stage/paint.js';

/** @typedef {import('../main.js').Shell} Shell */
/**
 * @typedef {object} Script in a picture of WIDTH x HEIGHT
 * @property {string} path of the curve that is there already; '': none
 * @property {number} [meaning] of the strokes, as the property says
 * @property {string[]} [before] commands, and keys
 * @property {[number, number][][]} strokes each a row of places that the pen passes
 * @property {string[]} [after] commands
 */

const [WIDTH, HEIGHT] = [240, 120];
const STROKE = 1100; // milliseconds that a stroke takes
const PAUSE = 350; // between two
const STEP = 8; // milliseconds from sample to sample

/** A place on the way of a stroke (Catmull and Rom 1974, uniform). @param {[number, number][]} way @param {number} part 0..1 */
function along(way, part) {
  const at = Math.min(part * (way.length - 1), way.length - 1.000001);
  const i = Math.floor(at);
  const t = at - i;
  const [a, b, c, d] = [way[Math.max(i - 1, 0)], way[i], way[i + 1], way[Math.min(i + 2, way.length - 1)]];
  return [0, 1].map((k) => b[k] + t / 2 * (c[k] - a[k] + t * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] +
    t * (3 * (b[k] - c[k]) + d[k] - a[k]))));
}

/** Slow at both ends. @param {number} part 0..1 */
const eased = (part) => part * part * (3 - 2 * part);

export class Moving {
  /** @param {Shell} shell @param {Script} script */
  constructor(shell, script) {
    this.script = script;
    this.engine = new Engine(shell.engine.module);
    this.box = document.createElement('div');
    this.box.className = 'moving';
    this.box.setAttribute('aria-hidden', 'true');
    const [still, overlay] = [0, 1].map(() => document.createElement('canvas'));
    this.pen = document.createElement('i');
    this.box.append(still, overlay, this.pen);
    this.painter = new Painter(still, overlay, shell.theme);
    this.painter.onidle = () => this.#paint();
    this.time = 0; // the engine's own, in milliseconds
    this.gone = false;
  }

  /** What is there before the pen comes. */
  begin() {
    const { engine, painter, script } = this;
    const shape = script.path && `<path d="${script.path}" fill="none" stroke="#22262b" stroke-width="2.5" stroke-linecap="round"/>`;
    const text = `<svg xmlns="http://www.w3.org/2000/svg">${shape}</svg>`;
    const ratio = Math.max(1, devicePixelRatio);
    engine.resize(WIDTH, HEIGHT, ratio);
    engine.openSvg(text, 'hand.svg');
    engine.command('zoom-100');
    engine.set('first-hints', 3);
    engine.set('stroke-meaning', script.meaning ?? 0);
    (script.before ?? []).forEach((name) => (name.length > 1 ? engine.command(name) : engine.key(name, true, 0, 0)));
    painter.resize(WIDTH, HEIGHT, ratio);
    engine.stillVersion = -1;
    this.#paint();
  }

  /** Draws the strokes, in their time or at once. @param {boolean} [atOnce] */
  async play(atOnce = false) {
    this.begin();
    for (const way of this.script.strokes) {
      await this.#stroke(way, atOnce);
    }
    (this.gone ? [] : this.script.after ?? []).forEach((name) => this.engine.command(name));
    this.#paint();
    await this.#rest(atOnce ? 0 : 2 * PAUSE);
  }

  /** @param {number} length milliseconds */
  #rest(length) {
    return new Promise((done) => { setTimeout(done, length); });
  }

  /** @param {[number, number][]} way @param {boolean} atOnce */
  async #stroke(way, atOnce) {
    await this.#rest(atOnce ? 0 : PAUSE);
    const started = performance.now();
    const count = STROKE / STEP;
    this.time += 1000;
    let done = -1;
    while (!this.gone && done < count) {
      const due = atOnce ? count : Math.min(count, Math.floor((performance.now() - started) / STEP));
      const samples = [];
      for (; done < due; done++) {
        samples.push(this.#sample(done < 0 ? Phase.DOWN : Phase.MOVE, along(way, eased(Math.max(done, 0) / count))));
      }
      this.engine.pointer(samples);
      this.#paint();
      if (done < count) {
        await new Promise(requestAnimationFrame);
      }
    }
    if (!this.gone) {
      this.engine.pointer([this.#sample(Phase.UP, way[way.length - 1])]);
      this.#paint();
    }
  }

  /** @param {number} phase @param {number[]} at @returns {import('../engine/types.js').Pointer} */
  #sample(phase, [x, y]) {
    this.time += STEP;
    const view = this.painter.painted ?? { x: 0, y: 0, zoom: 1 };
    const [left, top] = [(x - view.x) * view.zoom, (y - view.y) * view.zoom];
    this.pen.style.transform = `translate(${(100 * left) / WIDTH}cqw, ${(100 * top) / HEIGHT}cqh)`;
    this.pen.classList.toggle('down', phase !== Phase.UP);
    return { phase, device: Device.PEN, contact: 1, buttons: phase === Phase.UP ? 0 : 1, modifiers: 0, x: left, y: top,
      pressure: phase === Phase.UP ? 0 : 0.5, tiltX: 0, tiltY: 0, twist: 0, width: 0, height: 0, time: this.time, predicted: false };
  }

  #paint() {
    const frame = this.gone ? null : this.engine.frame();
    if (frame) {
      this.painter.paint(frame);
    }
  }

  end() {
    this.gone = true;
  }
}
