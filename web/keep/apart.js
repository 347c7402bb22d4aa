// Reads what may take long in a worker, with its progress and a way to cancel, and writes it there. Fetched with the first such file.

import { adopt, imageOf } from '../engine/image.js';
import { addressOf, miss, Missing, want } from '../page/build.js';
import { Anew, Refusal, spoken, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/image.js').Image} Image */
/** @typedef {import('../sheets/holds.js').Content} Content */
/**
 * @typedef {object} Order what the worker is to do
 * @property {WebAssembly.Module} first @property {WebAssembly.Module | null} second
 * @property {Image} image of the page's engine @property {Record<string, string>} texts
 * @property {Blob} file @property {string} name
 * @property {'open' | 'add' | 'paste'} how in place of the drawing, or added to it: as a group, or as it is
 * @property {boolean} asked what it holds is to be told
 * @property {boolean} [native] the drawing is to be written, in the native format or as SVG, and nothing is read
 * @property {boolean} [kept] not where the file that it was read from would have to be written anew
 */
/** @typedef {{ image: Image, bytes: Uint8Array<ArrayBuffer>, content: Content | null }} Answer */
/** @typedef {{ share?: number, answer?: Answer, written?: Uint8Array, anew?: boolean, refused?: string }} Said */

const PATIENCE = 300; // milliseconds before progress is shown
const ID = 'opening';

/** What is shown of the progress, once it takes long. */
class Progress {
  /** @param {string} name @param {Record<string, string>} texts @param {() => void} cancel */
  constructor(name, texts, cancel) {
    this.name = name;
    this.made = (texts['shell.opening-made.help'] ?? '').replace('%', () => name);
    this.bar = document.createElement('progress');
    this.share = 0;
    this.timer = setTimeout(() => void this.#show(cancel), PATIENCE);
  }

  /** @param {() => void} cancel */
  async #show(cancel) {
    const { answer, question } = await want(import('../sheets/question.js'));
    if (this.timer < 0) {
      return; // it has ended meanwhile
    }
    this.timer = 0;
    this.bar.setAttribute('aria-labelledby', `${ID}-text`);
    const asked = question(ID, '', [this.bar], [answer('cancel', word('command.cancel'))]);
    this.tell(this.share);
    void asked.then(() => this.timer < 0 || cancel());
  }

  /** @param {number} share 1: read, and being made a drawing */
  tell(share) {
    this.share = share;
    const text = document.getElementById(`${ID}-text`);
    if (text && this.timer === 0) {
      const read = Math.floor(100 * share);
      text.textContent = share < 1 ? `${word('shell.opening', this.name)} ${read} %` : this.made;
      if (share < 1) {
        this.bar.value = share;
      } else {
        this.bar.removeAttribute('value');
      }
    }
  }

  end() {
    clearTimeout(this.timer);
    this.timer = -1;
    /** @type {HTMLDialogElement | null} */ (document.getElementById(ID))?.close();
  }
}

/**
 * Has a copy of the engine do it in a worker. Throws the refusal.
 * @param {Engine} engine @param {Partial<Order>} what @param {(share: number) => void} tell
 * @param {Promise<null>} [cancelled]
 * @returns {Promise<Answer | Uint8Array | null>} null: cancelled
 */
async function work(engine, what, tell, cancelled = new Promise(() => {})) {
  const texts = await spoken();
  const { module: { first, second } } = engine;
  const image = imageOf(engine);
  const worker = new Worker(addressOf('keep/apart_worker.js'), { type: 'module' });
  try {
    const done = new Promise((resolve, reject) => {
      worker.addEventListener('message', ({ data }) => {
        const { share, answer: made, written, anew, refused } = /** @type {Said} */ (data);
        if (share !== undefined) {
          tell(share);
        } else if (made ?? written) {
          resolve(made ?? written);
        } else {
          reject(anew ? new Anew() : new Refusal(refused));
        }
      });
      worker.addEventListener('error', (event) => {
        miss(new Missing(`apart_worker.js: ${event.message ?? ''}`));
        reject(new Refusal(''));
      });
    });
    worker.postMessage({ first, second, image, texts, ...what }, [image.memory.buffer]);
    return await Promise.race([done, cancelled]);
  } finally {
    worker.terminate();
  }
}

/**
 * @param {Engine} engine @param {Blob} file @param {string} name @param {Order['how']} how @param {boolean} asked
 * @returns {Promise<Answer | null>} null: cancelled. Throws the refusal.
 */
async function send(engine, file, name, how, asked) {
  let cancel = () => {};
  const cancelled = new Promise((resolve) => { cancel = () => resolve(null); });
  const progress = new Progress(name, await spoken(), () => cancel());
  try {
    return /** @type {Answer | null} */ (await work(engine, { file, name, how, asked }, (share) => progress.tell(share), cancelled));
  } finally {
    progress.end();
  }
}

/** @param {Blob | Uint8Array} file */
const blobOf = (file) => (file instanceof Blob ? file : new Blob([/** @type {BlobPart} */ (file)]));

/**
 * Reads a file beside the drawing. Throws its refusal.
 * @param {Engine} engine @param {Blob | Uint8Array} file @param {string} name @param {boolean} asked
 * @returns {Promise<import('./files.js').Read | null>} null: cancelled
 */
export async function readApart(engine, file, name, asked) {
  const made = await send(engine, blobOf(file), name, 'open', asked);
  return made && { bytes: made.bytes, content: made.content, take: () => adopt(engine, made.image, true) };
}

/**
 * Adds a file to the drawing. Throws its refusal.
 * @param {Engine} engine @param {Blob} file @param {string} name @param {boolean} grouped as one group
 * @returns {Promise<boolean>} false: cancelled
 */
export async function addApart(engine, file, name, grouped) {
  for (;;) {
    const before = engine.journal.length + engine.digest();
    const made = await send(engine, file, name, grouped ? 'add' : 'paste', false);
    if (made && before !== engine.journal.length + engine.digest()) {
      continue; // something was drawn before the progress was shown
    }
    if (made) {
      adopt(engine, made.image, false);
    }
    return made !== null;
  }
}

/**
 * The drawing as the bytes of a file, written while the page goes on. Throws if that cannot be, as Engine.save does.
 * @param {Engine} engine @param {boolean} native @param {boolean} kept
 */
export async function writeApart(engine, native, kept) {
  await engine.module.complete();
  return /** @type {Uint8Array} */ (await work(engine, { native, kept }, () => {}));
}
