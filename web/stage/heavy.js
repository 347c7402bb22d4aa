// Paths that take long to paint: a worker makes a picture of each, for the window as it is, so that the page never waits. Fetched
// with the first such path.

import { addressOf, miss, Missing } from '../page/build.js';

/** @typedef {import('./paint.js').Context} Context */
/** @typedef {import('./paint.js').Look} Look */
/** @typedef {import('../engine/types.js').Item} Item */
/** @typedef {{ key: string, matrix: DOMMatrix, picture: ImageBitmap | null }} Made picture null: it takes too long */

const LONGEST = 20000; // milliseconds

export class Heavy {
  /** @param {() => void} ready called when there is something new to paint @param {() => void} late called when one takes too long */
  constructor(ready, late) {
    this.ready = ready;
    this.late = late;
    /** What was painted last, by object. @type {Map<number, Made>} */
    this.made = new Map();
    /** What is to be painted, by object; the first is under way. @type {Map<number, { key: string, order: object, matrix: DOMMatrix }>} */
    this.wanted = new Map();
    /** @type {Worker | null} */
    this.worker = null;
    this.timer = 0;
  }

  /**
   * Paints what there is of it, and asks for what is not.
   * @param {Context} context @param {Item} item @param {Float32Array} path of the item @param {Look} look
   */
  draw(context, { id, version }, path, look) {
    const matrix = context.getTransform();
    const { a, b, c, d, e, f } = matrix;
    const { width, height } = context.canvas;
    const order = { width, height, matrix: [a, b, c, d, e, f], look: { ...look, opacity: 1 } };
    const key = version + JSON.stringify(order);
    const made = this.made.get(id);
    if (made?.key !== key && this.wanted.get(id)?.key !== key) {
      this.#want(id, { key, matrix, order: { ...order, path } });
    }
    if (made?.picture) {
      context.save();
      context.setTransform(made.key === key ? new DOMMatrix() : matrix.multiply(made.matrix.inverse()));
      context.globalAlpha = look.opacity;
      context.drawImage(made.picture, 0, 0);
      context.restore();
    }
  }

  /** @param {number} id @param {{ key: string, order: object, matrix: DOMMatrix }} what */
  #want(id, what) {
    const [first] = this.wanted.keys();
    if (first === id) {
      this.#stop(); // it is painting what is no longer wanted
    }
    this.wanted.delete(id);
    this.wanted.set(id, what);
    this.#next();
  }

  #stop() {
    clearTimeout(this.timer);
    this.worker?.terminate();
    this.worker = null;
    this.timer = 0;
  }

  #next() {
    const [id] = this.wanted.keys();
    const what = this.wanted.get(id);
    if (!what || this.timer) {
      return;
    }
    if (!this.worker) {
      this.worker = new Worker(addressOf('stage/heavy_worker.js'), { type: 'module' });
      this.worker.addEventListener('message', ({ data }) => this.#done(data));
      this.worker.addEventListener('error', () => miss(new Missing('heavy_worker.js')));
    }
    this.timer = setTimeout(() => {
      this.#stop();
      this.#done(null);
      this.late();
    }, LONGEST);
    this.worker.postMessage(what.order);
  }

  /** @param {ImageBitmap | null} picture */
  #done(picture) {
    const [id] = this.wanted.keys();
    const what = this.wanted.get(id);
    clearTimeout(this.timer);
    this.timer = 0;
    if (what) {
      this.wanted.delete(id);
      this.made.get(id)?.picture?.close();
      this.made.set(id, { key: what.key, matrix: what.matrix, picture });
      this.ready();
    }
    this.#next();
  }

  /** Forgets what is no longer in the drawing. @param {Set<number>} ids */
  keep(ids) {
    for (const [id, { picture }] of this.made) {
      if (!ids.has(id)) {
        picture?.close();
        this.made.delete(id);
      }
    }
    const [first] = this.wanted.keys();
    for (const id of this.wanted.keys()) {
      if (!ids.has(id)) {
        this.wanted.delete(id);
        if (id === first) {
          this.#stop();
        }
      }
    }
    this.#next();
  }
}
