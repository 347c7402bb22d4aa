// The loopback server that `batten edit` runs: the file it was started with, and saving back to it.

import { word } from './words.js';

/** The file changed on disk after it was opened. */
export class Changed extends Error {}

/** @typedef {{ name: string, bytes: Uint8Array }} FileBytes */

export class Server {
  constructor() {
    const token = document.querySelector('meta[name=batten-token]')?.getAttribute('content') ?? '';
    /** '' when the page was served by something else. */
    this.token = token.startsWith('%') ? '' : token;
    this.tag = '';
    /** Another program may answer here tomorrow: nothing of the page is to stay in the browser. */
    this.passing = document.querySelector('meta[name=batten-address]')?.getAttribute('content') === 'passing';
  }

  get there() {
    return this.token !== '';
  }

  /** @returns {Promise<FileBytes>} */
  async load() {
    const response = await this.#ask('GET', {}, null);
    this.tag = response.headers.get('ETag') ?? '';
    const name = decodeURIComponent(response.headers.get('X-Batten-Name') ?? 'drawing.svg');
    return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
  }

  /**
   * Puts the bytes where the file was.
   * @param {Uint8Array} bytes
   * @param {string} type media type
   */
  async save(bytes, type) {
    const response = await this.#ask('PUT', { 'Content-Type': type, 'If-Match': this.tag }, bytes);
    this.tag = response.headers.get('ETag') ?? '';
  }

  /**
   * @param {string} method
   * @param {Record<string, string>} headers
   * @param {Uint8Array | null} bytes
   */
  async #ask(method, headers, bytes) {
    let response;
    try {
      const body = /** @type {BodyInit | null} */ (bytes);
      response = await fetch('/document', { method, headers: { ...headers, 'X-Batten-Token': this.token }, body });
    } catch {
      throw new Error(word('shell.no-answer'));
    }
    if (response.status === 412) {
      throw new Changed(word('shell.changed'));
    }
    if (!response.ok) {
      // The server says in one line of plain text what it objects to.
      const reason = (await response.text()).trim();
      throw new Error(reason || word('shell.answered', `${response.status} ${response.statusText}`));
    }
    return response;
  }
}
