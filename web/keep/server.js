// The loopback server run by `batten edit`: loads the file that it was started with, and saves back to it.

import { word } from '../page/words.js';

/** The file changed on disk after it was opened. */
export class Changed extends Error {}

/** @typedef {{ name: string, bytes: Uint8Array, tag: string }} FileBytes tag: identifies this version of the file */

const PATIENCE = 10000; // milliseconds: whoever has not answered by then does not answer
const FORBIDDEN = 403;
const CHANGED = 412;
/** What the page says better than the server. @type {Record<number, string>} */
const REASONS = { 413: 'shell.too-heavy', 507: 'shell.disk-full' };
const TOKEN = /name="batten-token" content="([0-9a-f]+)"/;

/** @param {Response} response */
const nameIn = (response) => decodeURIComponent(response.headers.get('X-Batten-Name') ?? 'drawing.svg');

export class Server {
  constructor() {
    const token = document.querySelector('meta[name=batten-token]')?.getAttribute('content') ?? '';
    /** '' when the page was served by something else. */
    this.token = token.startsWith('%') ? '' : token;
    this.name = '';
    /** The tag of the version that the drawing was opened from. */
    this.tag = '';
    /** Another program may use this address tomorrow: nothing of the page may stay in the browser. */
    this.passing = document.querySelector('meta[name=batten-address]')?.getAttribute('content') === 'passing';
    /** Whatever is opened is saved here, too. */
    this.sole = false;
  }

  get there() {
    return this.token !== '';
  }

  /** Loads the file as the version that the drawing is based on. @returns {Promise<FileBytes>} */
  async load() {
    const file = await this.look();
    [this.name, this.tag] = [file.name, file.tag];
    return file;
  }

  /** Reads the file as it is now. @returns {Promise<FileBytes>} */
  async look() {
    const response = await this.#ask('GET', {}, null);
    return { name: nameIn(response), bytes: new Uint8Array(await response.arrayBuffer()),
      tag: response.headers.get('ETag') ?? '' };
  }

  /**
   * Replaces the file's content with the bytes.
   * @param {Uint8Array} bytes
   * @param {string} type media type
   * @param {string} [over] the tag of the version that they replace
   */
  async save(bytes, type, over = this.tag) {
    const response = await this.#ask('PUT', { 'Content-Type': type, 'If-Match': over }, bytes);
    this.tag = response.headers.get('ETag') ?? '';
  }

  /**
   * Writes a new file beside it, overwriting nothing. @param {Uint8Array} bytes @param {string} type
   * @returns {Promise<string>} its name
   */
  async saveBeside(bytes, type) {
    return nameIn(await this.#ask('POST', { 'Content-Type': type }, bytes));
  }

  /** Asks the server for the file's version; accepts a restarted server. @returns {Promise<string>} the tag */
  async hear() {
    return (await this.#ask('HEAD', {}, null, AbortSignal.timeout(PATIENCE))).headers.get('ETag') ?? '';
  }

  /**
   * @param {string} method
   * @param {Record<string, string>} headers
   * @param {Uint8Array | null} bytes
   * @param {AbortSignal} [signal] ends the waiting
   * @returns {Promise<Response>}
   */
  async #ask(method, headers, bytes, signal) {
    let response = await this.#send(method, headers, bytes, signal);
    if (response.status === FORBIDDEN && await this.#meet(signal)) {
      response = await this.#send(method, headers, bytes, signal);
    }
    if (response.status === CHANGED) {
      throw new Changed(word('shell.changed'));
    }
    if (!response.ok && method === 'HEAD') {
      return this.#ask('GET', headers, bytes, signal); // for the reason
    }
    if (!response.ok) {
      // The server gives its reason in one line of plain text.
      const known = REASONS[response.status];
      const reason = known ? word(known) : (await response.text()).trim();
      throw new Error(reason || word('shell.answered', `${response.status} ${response.statusText}`));
    }
    return response;
  }

  /**
   * @param {string} method
   * @param {Record<string, string>} headers
   * @param {Uint8Array | null} bytes
   * @param {AbortSignal} [signal]
   */
  async #send(method, headers, bytes, signal) {
    try {
      const body = /** @type {BodyInit | null} */ (bytes);
      return await fetch('/document', { method, headers: { ...headers, 'X-Batten-Token': this.token }, body, signal });
    } catch {
      throw new Error(word('shell.no-answer'));
    }
  }

  /**
   * Fetches the token of a restarted server.
   * @param {AbortSignal} [signal] @returns {Promise<boolean>} whether it serves the same file
   */
  async #meet(signal) {
    const page = await fetch('/', { cache: 'no-store', signal }).then((answer) => answer.text()).catch(() => '');
    const token = TOKEN.exec(page)?.[1];
    if (!token || token === this.token) {
      return false;
    }
    const before = this.token;
    this.token = token;
    const file = await this.#send('GET', {}, null, signal);
    const same = file.ok && (!this.name || nameIn(file) === this.name);
    if (!same) {
      this.token = before;
    }
    return same;
  }
}
