// The test of the sketching paper (section 5.3), for a visitor: one outline drawn twice, by sketching and with control points, in an
// order of chance. A task is timed from the first touch to Done. What comes of it stays in this browser until the visitor hands it in.

import { learn, say } from './words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {{ way: string, seconds: number, error: number, device: string }} Result */

const KEY = 'batten-study';
const SAMPLES = 800; // of a curve
export const COLUMNS = 'date,first,sketch_seconds,sketch_error_px,points_seconds,points_error_px,device';

/** Where a visitor is: the order of the tasks, and what came of those that are done. */
function begun() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '');
    if (kept.order.length === 2 && Array.isArray(kept.results)) {
      return kept;
    }
  } catch {
    // nothing kept yet, or not by this page
  }
  const order = crypto.getRandomValues(new Uint8Array(1))[0] % 2 ? ['sketch', 'points'] : ['points', 'sketch'];
  return { order, results: /** @type {Result[]} */ ([]) };
}

/** Points along a path, evenly. @param {SVGPathElement} path @returns {number[][]} */
function walk(path) {
  const length = path.getTotalLength();
  return Array.from({ length: SAMPLES + 1 }, (_, i) => path.getPointAtLength(length * i / SAMPLES)).map(({ x, y }) => [x, y]);
}

/** How far a point is from a polyline. @param {number[]} point @param {number[][]} line */
const away = ([x, y], line) => Math.min(...line.slice(1).map(([bx, by], i) => {
  const [ax, ay] = line[i];
  const [dx, dy] = [bx - ax, by - ay];
  const share = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}));

/** The greatest distance of points of lines from the nearest of others. @param {number[][][]} lines @param {number[][][]} others */
const furthest = (lines, others) => Math.max(...lines.flat().map((point) => Math.min(...others.map((line) => away(point, line)))));

/** How far what is drawn and the outline, which is locked, are apart at most, both ways; in the drawing's pixels. @param {Shell} shell */
function errorOf(shell) {
  const svg = new DOMParser().parseFromString(new TextDecoder().decode(shell.engine.save(false)), 'image/svg+xml');
  const paths = /** @type {SVGPathElement[]} */ ([...svg.querySelectorAll('path')]);
  const [target, drawn] = [true, false].map((locked) =>
    paths.filter((path) => Boolean(path.closest('[data-locked]')) === locked).map(walk));
  return drawn.length && target.length ? Math.max(furthest(drawn, target), furthest(target, drawn)) : Infinity;
}

/** A visitor's two results as a line of the columns. @param {{ order: string[], results: Result[] }} state */
export function lineOf({ order, results }) {
  const of = (/** @type {string} */ way) => results.find((result) => result.way === way);
  const cells = ['sketch', 'points'].flatMap((way) => [of(way)?.seconds.toFixed(1), of(way)?.error.toFixed(2)]);
  return [new Date().toISOString().slice(0, 10), order[0], ...cells, results.map(({ device }) => device).join('+')].join(',');
}

class Study {
  /** @param {Shell} shell @param {HTMLElement} told the card's text and buttons */
  constructor(shell, told) {
    this.shell = shell;
    this.told = told;
    this.state = begun();
    this.text = document.createElement('p');
    this.text.setAttribute('role', 'status');
    /** @type {number | null} */
    this.start = null;
    this.device = '';
  }

  show() {
    const done = this.state.results.length;
    if (done === 2) {
      this.#results();
    } else {
      this.#task(this.state.order[done], done);
    }
  }

  /** @param {string} text @param {[string, () => void][]} buttons words and what they do */
  #say(text, buttons) {
    this.text.textContent = text;
    this.told.replaceChildren(this.text, ...buttons.map(([key, run]) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = say(key);
      button.addEventListener('click', run);
      return button;
    }));
  }

  /** @param {string} way @param {number} done */
  #task(way, done) {
    const task = say(`${way}.task`).replace('{1}', String(done + 1));
    this.shell.engine.command(`tool-${way}`);
    this.shell.wake();
    this.#say(task, []);
    const stage = /** @type {HTMLElement} */ (document.getElementById('stage'));
    stage.addEventListener('pointerdown', (event) => {
      this.start ??= performance.now();
      this.device = event.pointerType;
    }, { capture: true, passive: true });
    stage.addEventListener('pointerup', () => setTimeout(() => {
      if (this.state.results.length === done) {
        const error = errorOf(this.shell);
        this.#say(`${task} ${say('off').replace('{1}', error.toFixed(1))}`, [['done', () => void this.#done(way, error)]]);
      }
    }, 300), { capture: true, passive: true }); // the stroke has settled by then
  }

  /** @param {string} way @param {number} error */
  async #done(way, error) {
    const seconds = (performance.now() - (this.start ?? performance.now())) / 1000;
    this.state.results.push({ way, seconds, error, device: this.device });
    localStorage.setItem(KEY, JSON.stringify(this.state));
    if (this.state.results.length === 2) {
      this.#results();
      return;
    }
    await this.shell.pack(); // what was drawn is kept as any drawing
    location.reload();
  }

  #results() {
    const line = lineOf(this.state);
    const told = this.state.results.map((/** @type {Result} */ { way, seconds, error }) =>
      say(`${way}.result`).replace('{1}', seconds.toFixed(0)).replace('{2}', error.toFixed(1)));
    this.#say(`${told.join(' ')} ${say('kept')}`, [
      ['copy', () => void navigator.clipboard.writeText(`${COLUMNS}\n${line}\n`)],
      ['save', () => this.shell.files.deliver(new TextEncoder().encode(`${COLUMNS}\n${line}\n`), 'csv', 'text/csv')],
      ['again', () => {
        localStorage.removeItem(KEY);
        location.reload();
      }]]);
  }
}

/** Takes the front page's card for the study. @param {Shell} shell @param {HTMLElement} told */
export async function begin(shell, told) {
  await learn('study');
  const study = new Study(shell, told);
  Object.assign(globalThis, { study }); // for tests
  study.show();
}
