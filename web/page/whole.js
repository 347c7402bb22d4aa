// Completeness of the build: fetches the module's second part, and reports what is missing with one way out.

import { miss, Missing, whenMissing } from './build.js';
import { word } from './words.js';

/** @typedef {import('./words.js').Words} Words */

export class Whole {
  /**
   * @param {import('../engine/engine.js').Engine} engine
   * @param {import('./notice.js').Notices} notices
   * @param {() => Promise<void>} pack prepares the page to be closed
   * @param {Words} words told when more of them have come
   */
  constructor(engine, notices, pack, words) {
    this.engine = engine;
    this.notices = notices;
    this.pack = pack;
    /** @type {Words | null} */
    this.words = words;
    /** Called when the second part is not available. */
    this.onpartial = () => {};
    whenMissing(() => this.#say());
    document.querySelectorAll('link[rel=stylesheet][data-missing]').forEach((link) => miss(new Missing(link.getAttribute('href') ?? '')));
  }

  /**
   * Fetches the second part of the module. Without it the drawing is read-only and is not kept.
   * @returns {Promise<boolean>} whether it has arrived
   */
  async complete() {
    const { engine } = this;
    await (engine.partial || engine.module.complete().catch((error) => {
      engine.partial = true;
      miss(error);
      this.onpartial();
    }));
    if (!engine.partial && this.words) {
      this.words.retell(); // the second part has texts, too
      this.words = null;
    }
    return !engine.partial;
  }

  #say() {
    const text = this.engine.partial || this.engine.dead ? 'shell.partial' : 'shell.missing';
    this.notices.ask('missing', word(text), [{ label: word('shell.reload'), run: () => void this.reload(() => this.#say()) }], true);
  }

  /** Loads the page anew, with what is kept. @param {() => void} otherwise called when the server does not answer */
  async reload(otherwise) {
    const answer = await fetch(location.href, { cache: 'no-store' }).catch(() => null);
    if (answer?.ok) {
      await this.pack();
      location.reload();
    } else { // the server does not answer: this page is better than none
      otherwise();
      this.notices.say(word('shell.no-answer'));
    }
  }
}
