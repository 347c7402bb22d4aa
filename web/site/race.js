// The race of fits: the visitor's stroke through Batten and through two other libraries, while it is drawn.

import { Engine } from '../engine/engine.js';
import { Module } from '../engine/module.js';
import { errorOf, fitCurveOf, ours, paperOf, peers } from './fits.js';
import { learn, say } from './words.js';

/** @typedef {import('./fits.js').Fit} Fit */
/** @typedef {import('./fits.js').Place} Place */

const COLUMNS = ['race.pieces', 'race.points', 'race.error', 'race.joints', 'race.time'];
const STROKE = [[0.06, 0.7], [0.2, 0.16], [0.34, 0.36], [0.47, 0.8], [0.6, 0.72], [0.72, 0.24], [0.86, 0.2], [0.95, 0.62]];

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

class Race {
  /** @param {Engine} engine */
  constructor(engine) {
    this.engine = engine;
    this.canvas = /** @type {HTMLCanvasElement} */ (part('canvas'));
    this.tolerance = /** @type {HTMLInputElement} */ (part('tolerance'));
    /** @type {Place[]} */
    this.stroke = [];
    /** @type {{ name: string, fit: (stroke: Place[], tolerance: number) => Fit | null, lane: number }[]} */
    this.runners = [{ name: 'Batten', fit: (stroke, tolerance) => ours(engine, stroke, tolerance), lane: 0 }];
    this.width = 0;
    this.height = 0;
    this.down = false;
    this.due = false;
    this.canvas.addEventListener('pointerdown', (event) => this.#down(event));
    this.canvas.addEventListener('pointermove', (event) => this.#move(event));
    for (const end of ['pointerup', 'pointercancel']) {
      this.canvas.addEventListener(end, () => { this.down = false; });
    }
    this.tolerance.addEventListener('input', () => this.wake());
    part('clear').addEventListener('click', () => {
      this.stroke = [];
      this.wake();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.wake());
    new ResizeObserver(() => this.#resize()).observe(part('ground'));
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = part('ground');
    const first = !this.width;
    [this.width, this.height] = [width, height];
    this.canvas.width = Math.round(width * devicePixelRatio);
    this.canvas.height = Math.round(height * devicePixelRatio);
    this.engine.resize(width, height, 1);
    if (first) {
      this.stroke = this.#example();
    }
    this.wake();
  }

  /** A stroke to begin with, so that the page shows what it is about. @returns {Place[]} */
  #example() {
    const { width, height } = this;
    /** @type {Place[]} */
    const way = [];
    const place = (/** @type {number} */ i) => STROKE[Math.min(Math.max(i, 0), STROKE.length - 1)];
    for (let i = 0; i + 1 < STROKE.length; i++) {
      const [a, b, c, d] = [place(i - 1), place(i), place(i + 1), place(i + 2)];
      for (let t = 0; t < 1; t += 1 / 24) {
        const [x, y] = [0, 1].map((k) => b[k] + (t / 2) * (c[k] - a[k] +
          t * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] + t * (3 * (b[k] - c[k]) + d[k] - a[k]))));
        way.push([Math.round(x * width), Math.round(y * height)]); // whole pixels, as of a mouse
      }
    }
    return way;
  }

  /** @param {PointerEvent} event */
  #down(event) {
    event.preventDefault();
    this.canvas.setPointerCapture(event.pointerId);
    this.down = true;
    this.stroke = [];
    this.#add(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (this.down) {
      this.#add(event);
    }
  }

  /** @param {PointerEvent} event */
  #add(event) {
    const box = this.canvas.getBoundingClientRect();
    const all = event.getCoalescedEvents?.() ?? [];
    for (const { clientX, clientY } of all.length ? all : [event]) {
      const [x, y] = [clientX - box.left, clientY - box.top];
      const last = this.stroke.at(-1);
      if (!last || last[0] !== x || last[1] !== y) {
        this.stroke.push([x, y]);
      }
    }
    this.wake();
  }

  wake() {
    if (!this.due) {
      this.due = true;
      requestAnimationFrame(() => {
        this.due = false;
        this.#run();
      });
    }
  }

  #run() {
    const tolerance = Math.min(Math.max(Number(this.tolerance.value) || 1, 0.1), 100);
    const results = this.runners.map((runner) => {
      if (this.stroke.length < 3) {
        return { ...runner, made: null, took: 0, error: NaN };
      }
      const start = performance.now();
      const made = runner.fit(this.stroke, tolerance);
      const took = performance.now() - start;
      return { ...runner, made, took, error: made ? errorOf(made.segments, this.stroke) : NaN };
    });
    part('body').replaceChildren(...results.map(({ name, lane, made, took, error }) => {
      const row = document.createElement('tr');
      row.className = `lane-${lane}`;
      const cells = made ? [made.segments.length, made.points, error.toFixed(2), made.joints, took.toFixed(1)] : COLUMNS.map(() => '–');
      for (const text of [name, ...cells]) {
        row.append(Object.assign(document.createElement(text === name ? 'th' : 'td'), { textContent: String(text) }));
      }
      return row;
    }));
    this.#paint(results);
  }

  /** @param {{ made: Fit | null, lane: number }[]} results */
  #paint(results) {
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    const style = getComputedStyle(document.body);
    const colour = (/** @type {string} */ name) => style.getPropertyValue(`--${name}`);
    const probe = part('draw');
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.lineCap = context.lineJoin = 'round';
    context.strokeStyle = getComputedStyle(probe).color;
    context.globalAlpha = 0.18;
    context.lineWidth = 9;
    context.beginPath();
    this.stroke.forEach(([x, y]) => context.lineTo(x, y));
    context.stroke();
    context.globalAlpha = 1;
    for (const { made, lane } of [...results].reverse()) {
      context.strokeStyle = context.fillStyle = colour(`lane-${lane}`);
      context.lineWidth = lane ? 1.5 : 2.5;
      for (const [x0, y0, x1, y1, x2, y2, x3, y3] of made?.segments ?? []) {
        context.beginPath();
        context.moveTo(x0, y0);
        context.bezierCurveTo(x1, y1, x2, y2, x3, y3);
        context.stroke();
        context.beginPath();
        context.arc(x3, y3, lane ? 2.5 : 4, 0, 2 * Math.PI);
        context.fill();
      }
    }
  }
}

async function start() {
  await learn('race');
  document.documentElement.lang = navigator.language.startsWith('ko') ? 'ko' : 'en';
  for (const id of ['back', 'heading', 'draw', 'tolerance-label', 'clear', 'note', 'missing']) {
    part(id).textContent = say(`race.${id}`);
  }
  part('controls').hidden = false;
  const heads = document.createElement('tr');
  heads.append(document.createElement('td'), ...COLUMNS.map((key) => Object.assign(document.createElement('th'), { textContent: say(key) })));
  part('head').append(heads);
  const module = await Module.load();
  await module.complete();
  const race = new Race(new Engine(module));
  try {
    const { fitCurve, paper } = await peers();
    race.runners.push({ name: 'fit-curve', fit: (stroke, tolerance) => fitCurveOf(fitCurve, stroke, tolerance), lane: 1 },
      { name: 'paper.js', fit: (stroke, tolerance) => paperOf(paper, stroke, tolerance), lane: 2 });
    race.wake();
  } catch {
    part('missing').hidden = false;
  }
  Object.assign(globalThis, { race }); // for tests
  document.documentElement.dataset.ready = 'yes';
  void import('../page/face.js').then(({ dressWords }) => dressWords());
}

void start();
