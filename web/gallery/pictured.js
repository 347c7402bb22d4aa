// The pictures of the gallery: kept ones are shown when their cards come into view; one that is missing, or older than its drawing, is
// made in a worker, one at a time.

import { encoded, paintSmall, smallPainter } from '../stage/small.js';
import { keepPicture, LARGEST, pictureFor } from '../keep/pictures.js';
import { addressOf } from '../page/build.js';

/** @typedef {import('../keep/drawings.js').Drawings} Drawings */
/** @typedef {import('./card.js').Card} Card */

const HEAVIEST = 1000000; // numbers in paths that are painted at once; what is heavier is left to the worker
const LONGEST = 32 << 20; // bytes of a journal
const PATIENCE = 10000; // milliseconds that a picture may take

/**
 * Makes a picture of the drawing that is open, if it is kept. @param {{ drawings: Drawings, keeper: import('../keep/keep.js').Keeper,
 * painter: import('../stage/paint.js').Painter }} shell @returns {Promise<Blob | null>}
 */
export async function pictureOpen({ drawings, keeper, painter }) {
  const { id } = keeper;
  if (!keeper.begun || !drawings.ours || drawings.moving || painter.list.reduce((sum, { weight }) => sum + weight, 0) > HEAVIEST) {
    return null;
  }
  const time = Date.now();
  const small = smallPainter();
  Object.assign(small, { list: painter.list, pictures: painter.pictures, paints: painter.paints });
  const blob = paintSmall(small) ? await encoded(small, LARGEST).catch(() => null) : null;
  await keeper.settled(); // what was just drawn is not newer than its picture
  if (blob) {
    await keepPicture(id, blob, Math.max(time, Date.now()));
  }
  return blob;
}

/** Paints pictures of drawings from their journals, in a worker that lives as long as it answers. */
class Studio {
  /** @param {import('../engine/module.js').Module} module */
  constructor(module) {
    this.module = module;
    /** @type {Worker | null} */
    this.worker = null;
  }

  /** @param {Uint8Array} journal @returns {Promise<Blob | null>} */
  async paint(journal) {
    const { first, second } = this.module;
    const worker = this.worker ??= new Worker(addressOf('stage/small_worker.js'), { type: 'module' });
    let timer = 0;
    const answer = await new Promise((resolve) => {
      timer = setTimeout(resolve, PATIENCE);
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = (event) => {
        event.preventDefault();
        resolve(undefined);
      };
      worker.postMessage({ first, second, journal, largest: LARGEST }, [journal.buffer]);
    });
    clearTimeout(timer);
    if (answer === undefined) {
      this.close();
    }
    return answer instanceof Blob ? answer : null;
  }

  close() {
    this.worker?.terminate();
    this.worker = null;
  }
}

export class Pictured {
  /** @param {{ keeper: import('../keep/keep.js').Keeper, engine: import('../engine/engine.js').Engine }} shell @param {HTMLElement} sheet */
  constructor({ keeper, engine }, sheet) {
    this.keeper = keeper;
    this.studio = new Studio(engine.module);
    /** @type {WeakMap<Element, Card>} */
    this.cards = new WeakMap();
    /** Cards that wait for a picture, as long as they can be seen. @type {Set<Card>} */
    this.wanting = new Set();
    this.working = false;
    /** Drawings of which no picture could be made. @type {Set<string>} */
    this.without = new Set();
    this.eye = new IntersectionObserver((entries) => entries.forEach((entry) => void this.#see(entry)), { root: sheet, rootMargin: '200px' });
  }

  /** @param {Card[]} cards in place of those before */
  watch(cards) {
    this.eye.disconnect();
    this.wanting.clear();
    for (const card of cards) {
      this.cards.set(card.item, card);
      this.eye.observe(card.item);
    }
  }

  /** The gallery is closed: nothing more is made. */
  rest() {
    this.watch([]);
  }

  /** @param {IntersectionObserverEntry} entry */
  async #see({ target, isIntersecting }) {
    const card = this.cards.get(target);
    if (!card || !isIntersecting) {
      this.wanting.delete(/** @type {Card} */ (card));
      return;
    }
    if (!card.img.src) {
      const found = await pictureFor(card.kept.id);
      card.onspoilt = () => this.#want(card);
      if (found && !card.img.src) {
        card.show(found.blob);
      }
      if ((found?.time ?? 0) < card.kept.time) {
        this.#want(card);
      }
    }
  }

  /** @param {Card} card */
  #want(card) {
    if (!card.own && !card.kept.broken && !this.without.has(card.kept.id)) {
      this.wanting.add(card);
      void this.#work();
    }
  }

  /** Makes those that are wanted, one after the other. */
  async #work() {
    if (this.working) {
      return;
    }
    this.working = true;
    for (let [card] = this.wanting; card; [card] = this.wanting) {
      this.wanting.delete(card);
      await this.#make(card);
    }
    this.working = false;
    this.studio.close(); // each works in a memory of its own, which it gives back so
  }

  /** @param {Card} card */
  async #make(card) {
    const { id, time } = card.kept;
    const found = await this.keeper.take(id).catch(() => null);
    const blob = found?.whole && found.journal.length < LONGEST ? await this.studio.paint(found.journal) : null;
    card.onspoilt = () => {}; // it is not tried twice
    if (blob) {
      card.show(blob);
      await keepPicture(id, blob, time);
    } else {
      this.without.add(id);
    }
  }
}
