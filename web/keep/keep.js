// Keeping: each step of a drawing's journal is written to the browser's private file system (OPFS), so that a closed or
// crashed page loses at most the stroke under the pen. A drawing has a folder of numbered journals; the newest complete
// one counts. A page begins a new journal beside the old one, which is then removed, and appends to it; a journal whose
// first byte is not yet written is incomplete. keeping.js, a worker, does the writing.

import { addressOf } from '../page/build.js';
import { folderOf, journals } from './journals.js';

/** @typedef {{ name: string, journal: Uint8Array, time: number }} Kept */
/** @typedef {'no-room' | 'cleared' | 'not-kept'} Fault why nothing is kept; the page has words for each */

const HEAD = 4096; // the name of a drawing is within the first 4,096 bytes of its journal

/**
 * The newest complete journal of a folder, up to its last complete line.
 * @param {FileSystemDirectoryHandle} folder
 * @param {number} [size] read no more bytes than this
 * @returns {Promise<Kept | null>}
 */
async function newest(folder, size) {
  /** @type {number[]} */
  const numbers = [];
  for await (const name of folder.keys()) {
    numbers.push(Number(name));
  }
  for (const number of numbers.sort((a, b) => b - a)) {
    const file = await (await folder.getFileHandle(String(number))).getFile();
    const bytes = new Uint8Array(await file.slice(0, size).arrayBuffer());
    if (bytes[0]) {
      const head = /"name":("(?:[^"\\]|\\.)*")/.exec(new TextDecoder().decode(bytes.subarray(0, HEAD)));
      return { name: head ? JSON.parse(head[1]) : '', journal: bytes.subarray(0, bytes.lastIndexOf(10) + 1),
        time: file.lastModified };
    }
  }
  return null;
}

export class Keeper {
  constructor() {
    /**
     * Called when steps cannot be kept, once for each reason, and when they can again.
     * @type {(fault: Fault | '') => void}
     */
    this.onfault = () => {};
    /** @type {Worker | null} */
    this.worker = null;
    /** What this page keeps: the drawing's name, the engine's session (-1: nothing) and how much of its journal. */
    this.name = '';
    this.session = -1;
    this.length = 0;
    this.unsaved = false;
    /** Why the last write failed. @type {Fault | ''} */
    this.fault = '';
    /** Pending writes, and the callers waiting for them. */
    this.writes = 0;
    /** @type {(() => void)[]} */
    this.waiting = [];
  }

  /** Starts the worker in advance, so that the first step can be kept even if the server has stopped by then. */
  async start() {
    this.#work();
    await this.settled();
    this.fault = ''; // if the worker does not start, the first step tries again
  }

  /**
   * Called at every frame.
   * @param {string} name
   * @param {number} session the engine's; each session has its own journal
   * @param {Uint8Array} journal
   * @param {boolean} unsaved
   * @param {boolean} local there is no file elsewhere: kept even when saved
   */
  note(name, session, journal, unsaved, local) {
    const due = unsaved || local;
    const given = this.unsaved && name !== this.name; // given up, after the user was asked
    if (this.session >= 0 && (given || !due)) {
      this.drop(this.name);
    }
    const same = session === this.session && name === this.name;
    if (due && !(same && journal.length === this.length)) {
      const more = same && !this.fault; // after a fault the next step writes all of it
      this.#write({ name, bytes: journal.slice(more ? this.length : 0), more });
      [this.name, this.session, this.length] = [name, session, journal.length];
    }
    this.unsaved = unsaved;
  }

  /** What was kept of a drawing. @param {string} name @returns {Promise<Kept | null>} */
  async find(name) {
    try {
      return await newest(await (await journals()).getDirectoryHandle(await folderOf(name)));
    } catch {
      return null;
    }
  }

  /** All drawings kept, latest first, each with the beginning of its journal. @returns {Promise<Kept[]>} */
  async list() {
    /** @type {Kept[]} */
    const list = [];
    try {
      for await (const handle of (await journals()).values()) {
        const kept = await newest(/** @type {FileSystemDirectoryHandle} */ (handle), HEAD);
        if (kept?.name) {
          list.push(kept);
        }
      }
    } catch {
      // Nothing can be kept here, so nothing is.
    }
    return list.sort((a, b) => b.time - a.time);
  }

  /** @param {string} name */
  drop(name) {
    this.session = -1;
    this.unsaved = false;
    this.#write({ name });
  }

  /** Waits until everything noted is on disk, or has failed. @returns {Promise<void>} */
  settled() {
    return new Promise((resolve) => {
      this.waiting.push(resolve);
      this.#done(0);
    });
  }

  /** Hands the journal over to another page. */
  async yield() {
    this.session = -1;
    this.unsaved = false;
    this.#write({ name: '' });
    await this.settled();
  }

  /** @param {{ name: string, bytes?: Uint8Array, more?: boolean }} job */
  #write(job) {
    this.writes++;
    this.#work().postMessage(job, job.bytes ? [job.bytes.buffer] : []);
  }

  /** What does the writing: answers each job with its fault, after a first 'ready'. @returns {Worker} */
  hire() {
    return new Worker(addressOf('keep/keeping.js'), { type: 'module' });
  }

  /** The worker; starts one when there is none. */
  #work() {
    if (!this.worker) {
      this.worker = this.hire();
      this.writes++; // it reports when it is running
      this.worker.onmessage = ({ data }) => (data === 'ready' ? this.#done(1) : this.#answered(data));
      this.worker.onerror = (event) => {
        event.preventDefault(); // the page reports it
        this.#end();
        this.#answered('not-kept');
      };
    }
    return this.worker;
  }

  /** Drops the worker: nothing more comes from it. */
  #end() {
    this.worker?.terminate();
    this.worker = null;
    this.writes = 1;
  }

  /** @param {Fault | ''} fault */
  #answered(fault) {
    const before = this.fault;
    this.fault = fault;
    if (fault === 'cleared') { // while the worker holds a cleared file open, Chromium loses new ones as well
      this.#end();
    }
    this.#done(1);
    if (fault === before || this.session < 0) {
      return; // the user was told already, or has nothing to lose
    }
    if (fault === 'cleared') {
      this.length = -1; // there is room again: write all of it at once
    }
    if (fault || before !== 'cleared') {
      this.onfault(fault);
    }
  }

  /** @param {number} count */
  #done(count) {
    this.writes -= count;
    if (this.writes <= 0) {
      this.writes = 0;
      this.waiting.splice(0).forEach((resolve) => resolve());
    }
  }
}
