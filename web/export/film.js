// How a drawing was drawn, as a film of some seconds: its journal is run again in an engine and on canvases of its own, so that nothing
// of it enters the drawing. Each stroke is drawn by a pen, then what it did is there.

import { Engine } from '../engine/engine.js';
import { Gif } from './gif.js';
import { ready } from '../page/ready.js';
import { Painter } from '../stage/paint.js';
import { THEME } from '../stage/small.js';

/** @typedef {{ x: number, y: number, zoom: number, angle: number }} View */
/** A line of the journal; what a pen drew, in the drawing; when it begins, and for how long, milliseconds.
 * @typedef {{ line: Uint8Array, trail: [number, number][], from: number, length: number }} Step */

export const LENGTH = 6000; // milliseconds
const REST = 900; // of them, for the drawing as it is in the end
const STROKE = 250; // what a stroke counts beside its own time, which weighs less the longer it is
const STEP = 200; // what anything else counts
const PEN = 5; // radius of the pen's tip, pixels
const AROUND = '#f1f2f4'; // the page is white, whatever the theme
const BETWEEN = 80; // milliseconds between the pictures of a file

/** Places of a stroke in the drawing; none in a view that is tilted. @param {any} step @returns {[number, number][]} */
function trailOf({ stroke, view }) {
  if (!stroke?.points || !Array.isArray(view) || view.length > 4) {
    return [];
  }
  const [x, y, zoom, angle = 0] = view;
  const [cos, sin] = [Math.cos(angle * Math.PI / 180) / zoom, Math.sin(angle * Math.PI / 180) / zoom];
  return stroke.points.map((/** @type {number[]} */ [px, py]) => [x + cos * px + sin * py, y - sin * px + cos * py]);
}

/** How much of the film a step gets, beside others. @param {any} step */
function weightOf({ do: kind, stroke }) {
  const time = stroke?.time?.at?.(-1) ?? (stroke?.points?.length ?? 0) * 8;
  return stroke ? STROKE + Math.sqrt(Math.max(time, 1) * 1000) : kind ? STEP : 0;
}

export class Film {
  /**
   * @param {import('../main.js').Shell} shell @param {Uint8Array} journal
   * @param {[number, number, number]} size of the picture in pixels, and device pixels in one
   */
  constructor(shell, journal, size) {
    this.journal = journal;
    this.size = size;
    this.engine = new Engine(shell.engine.module);
    const canvases = [0, 1].map(() => document.createElement('canvas'));
    this.canvas = document.createElement('canvas');
    [this.canvas.width, this.canvas.height] = [size[0] * size[2], size[1] * size[2]];
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d', { willReadFrequently: true }));
    this.painter = new Painter(canvases[0], canvases[1], THEME);
    this.painter.resize(...size);
    this.accent = getComputedStyle(document.documentElement).accentColor;
    const lines = new TextDecoder().decode(journal).split('\n').filter((line) => line && !line.startsWith('#'));
    const bytes = new TextEncoder();
    this.head = bytes.encode(`${lines[0]}\n`);
    /** @type {Step[]} */
    this.steps = [];
    const parsed = lines.slice(1).map((line) => JSON.parse(line));
    const sum = parsed.reduce((total, step) => total + weightOf(step), 0);
    let from = 0;
    parsed.forEach((step, i) => {
      const length = weightOf(step) / Math.max(sum, 1) * (LENGTH - REST);
      this.steps.push({ line: bytes.encode(`${lines[i + 1]}\n`), trail: trailOf(step), from, length });
      from += length;
    });
    this.view = this.#final();
    /** The step that is shown. */
    this.next = 0;
    this.rewind();
  }

  /** The view of all that is there in the end. @returns {View} */
  #final() {
    const { engine } = this;
    engine.resize(...this.size);
    engine.replay(this.journal);
    engine.resize(...this.size);
    engine.command('view-fit');
    const { x, y, zoom, angle } = engine.frame() ?? { x: 0, y: 0, zoom: 1, angle: 0 };
    return { x, y, zoom, angle };
  }

  rewind() {
    this.engine.replay(this.head);
    this.engine.resize(...this.size);
    this.engine.stillVersion = -1;
    this.next = 0;
  }

  /** @param {number} time milliseconds from its beginning, not before the time shown last */
  show(time) {
    const { engine, painter, steps, view } = this;
    for (; this.next < steps.length && steps[this.next].from + steps[this.next].length <= time; this.next++) {
      engine.replayLine(steps[this.next].line);
    }
    const frame = engine.frame();
    if (frame) {
      painter.paint({ ...frame, ...view });
    }
    this.#compose(steps[this.next], time);
  }

  /** The picture, and the pen over it. @param {Step | undefined} step @param {number} time */
  #compose(step, time) {
    const { context, painter, size: [, , ratio], view } = this;
    context.fillStyle = AROUND;
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(painter.still, 0, 0);
    context.drawImage(painter.overlay, 0, 0);
    const count = step ? Math.ceil(step.trail.length * Math.min((time - step.from) / step.length, 1)) : 0;
    if (!step || count < 1) {
      return;
    }
    const [cos, sin] = [Math.cos(view.angle * Math.PI / 180), Math.sin(view.angle * Math.PI / 180)];
    const places = step.trail.slice(0, count).map(([x, y]) => {
      const [dx, dy] = [(x - view.x) * view.zoom * ratio, (y - view.y) * view.zoom * ratio];
      return [cos * dx - sin * dy, sin * dx + cos * dy];
    });
    context.strokeStyle = context.fillStyle = this.accent;
    context.lineWidth = 2 * ratio;
    context.lineCap = context.lineJoin = 'round';
    context.beginPath();
    places.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.stroke();
    context.beginPath();
    context.arc(...(/** @type {[number, number]} */ (places[count - 1])), PEN * ratio, 0, 2 * Math.PI);
    context.fill();
  }

  /**
   * Shows it once, in its own time.
   * @param {AbortSignal} signal ends it
   * @returns {Promise<boolean>} whether it came to its end
   */
  play(signal) {
    this.rewind();
    const from = performance.now();
    return new Promise((resolve) => {
      const step = () => {
        const time = performance.now() - from;
        if (signal.aborted) {
          resolve(false);
          return;
        }
        this.show(Math.min(time, LENGTH));
        if (time >= LENGTH) {
          resolve(true);
        } else {
          requestAnimationFrame(step);
        }
      };
      step();
    });
  }
}

/** Plays it over the drawing until it ends or anything is touched. @param {Uint8Array} journal */
export async function playOver(journal) {
  const shell = await ready();
  const [width, height, ratio] = shell.engine.size;
  const film = new Film(shell, journal, [width, height, ratio]);
  const end = new AbortController();
  film.canvas.className = 'layer film';
  film.canvas.setAttribute('aria-hidden', 'true');
  shell.stage.append(film.canvas);
  for (const event of ['pointerdown', 'wheel', 'keydown', 'resize']) {
    addEventListener(event, () => end.abort(), { capture: true, passive: true, signal: end.signal });
  }
  await film.play(end.signal);
  end.abort();
  film.canvas.remove();
}

/**
 * The film as a GIF file, made as fast as it can be.
 * @param {Film} film @param {AbortSignal} signal @param {(share: number) => void} watch
 * @returns {Promise<Uint8Array<ArrayBuffer> | null>} null: it was cancelled
 */
export async function gifOf(film, signal, watch) {
  const { canvas: { width, height }, context } = film;
  const picture = (/** @type {number} */ time) => {
    film.show(time);
    return context.getImageData(0, 0, width, height);
  };
  film.rewind();
  const gif = new Gif(width, height, [0.1, 0.3, 0.5, 0.7, 1].map((share) => picture(share * LENGTH)));
  film.rewind();
  for (let time = 0; time < LENGTH - REST + BETWEEN; time += BETWEEN) {
    const last = time + BETWEEN >= LENGTH - REST + BETWEEN;
    gif.add(picture(time), last ? 2 * REST : BETWEEN);
    watch(time / LENGTH);
    await new Promise((done) => setTimeout(done));
    if (signal.aborted) {
      return null;
    }
  }
  return gif.end();
}
