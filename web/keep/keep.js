// Keeping: the journal of a drawing goes to the browser's own file system (OPFS) with each step, so that a closed or
// crashed page loses the stroke under the pen at most. A drawing has a folder of numbered journals; the newest whole
// one counts. A page begins a new one beside the old, which then goes, and adds to it; a journal without its first
// byte is not whole yet. keeping.js, a worker, does the writing.

import { addressOf } from '../page/build.js';
import { folderOf, journals } from './journals.js';

/** @typedef {{ name: string, journal: Uint8Array, time: number }} Kept */
/** @typedef {'no-room' | 'cleared' | 'not-kept'} Fault why nothing is kept; the page has words for each */

const HEAD = 4096; // bytes of a journal in which its name stands

/**
 * The newest whole journal of a folder, up to its last whole line.
 * @param {FileSystemDirectoryHandle} folder
 * @param {number} [size] only so much of it
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
    /** Told when steps cannot be kept, once for each reason, and when they can again. @type {(fault: Fault | '') => void} */
    this.onfault = () => {};
    /** @type {Worker | null} */
    this.worker = null;
    /** What this page keeps: of which session of the engine, -1 for nothing, and how much of its journal. */
    this.name = '';
    this.session = -1;
    this.length = 0;
    this.unsaved = false;
    /** Why the last write failed. @type {Fault | ''} */
    this.fault = '';
    /** Writes that are not done yet, and who waits for that. */
    this.writes = 0;
    /** @type {(() => void)[]} */
    this.waiting = [];
  }

  /** Has the worker ready: the first step is on the disk although the server has gone meanwhile. */
  async start() {
    this.#work();
    await this.settled();
    this.fault = ''; // when it does not start, the first step tries again
  }

  /**
   * Told at every frame.
   * @param {string} name
   * @param {number} session the engine's; another one has another journal
   * @param {Uint8Array} journal
   * @param {boolean} unsaved
   * @param {boolean} local there is no file elsewhere: kept though it is saved
   */
  note(name, session, journal, unsaved, local) {
    const due = unsaved || local;
    const given = this.unsaved && name !== this.name; // up, after the user was asked
    if (this.session >= 0 && (given || !due)) {
      this.drop(this.name);
    }
    const same = session === this.session && name === this.name;
    if (due && !(same && journal.length === this.length)) {
      const more = same && !this.fault; // after a fault the next step tries with all of it
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

  /** All drawings kept, the latest first; of their journals the beginning. @returns {Promise<Kept[]>} */
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

  /** All that was noted is on the disk, or cannot be. @returns {Promise<void>} */
  settled() {
    return new Promise((resolve) => {
      this.waiting.push(resolve);
      this.#done(0);
    });
  }

  /** Leaves the journal to another page. */
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

  /** The worker; another one when there is none. */
  #work() {
    if (!this.worker) {
      this.worker = new Worker(addressOf('keep/keeping.js'), { type: 'module' });
      this.writes++; // it says when it runs
      this.worker.onmessage = ({ data }) => (data === 'ready' ? this.#done(1) : this.#answered(data));
      this.worker.onerror = (event) => {
        event.preventDefault(); // it is said by the page
        this.#end();
        this.#answered('not-kept');
      };
    }
    return this.worker;
  }

  /** Nothing more comes from this worker. */
  #end() {
    this.worker?.terminate();
    this.worker = null;
    this.writes = 1;
  }

  /** @param {Fault | ''} fault */
  #answered(fault) {
    const before = this.fault;
    this.fault = fault;
    if (fault === 'cleared') { // as long as it holds a file that was cleared, Chromium loses what is written anew, too
      this.#end();
    }
    this.#done(1);
    if (fault === before || this.session < 0) {
      return; // the user knows, or has nothing to lose
    }
    if (fault === 'cleared') {
      this.length = -1; // there is room: at once, with all of it
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
