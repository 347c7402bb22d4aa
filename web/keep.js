// Keeping: the journal of a drawing goes to the browser's own file system (OPFS) with each step, so that a closed or
// crashed page loses the stroke under the pen at most. A drawing has a folder of numbered journals; the newest whole
// one counts. A page begins a new one beside the old, which then goes, and adds to it; a journal without its first
// byte is not whole yet. keeping.js, a worker, does the writing.

/** @typedef {{ name: string, journal: Uint8Array, time: number }} Kept */

const HEAD = 4096; // bytes of a journal in which its name stands

/** Where all folders are. */
export async function journals() {
  return (await navigator.storage.getDirectory()).getDirectoryHandle('journals', { create: true });
}

/** The name of a drawing's folder: any name becomes a file system's. @param {string} name */
export async function folderOf(name) {
  const digest = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(name));
  return Array.from(new Uint8Array(digest, 0, 16), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

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
    /** Told once when nothing can be kept, until it can again. @type {() => void} */
    this.onfault = () => {};
    /** @type {Worker | null} */
    this.worker = null;
    /** What this page keeps: of which session of the engine, -1 for nothing, and how much of its journal. */
    this.name = '';
    this.session = -1;
    this.length = 0;
    this.unsaved = false;
    this.faulty = false;
    /** Writes that are not done yet, and who waits for that. */
    this.writes = 0;
    /** @type {(() => void)[]} */
    this.waiting = [];
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
      this.#write({ name, bytes: journal.slice(same ? this.length : 0), more: same });
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
    if (!this.worker) {
      this.worker = new Worker('keeping.js', { type: 'module' });
      this.worker.onmessage = ({ data }) => this.#answered(data);
      this.worker.onerror = () => this.#answered('it does not start');
    }
    this.writes++;
    this.worker.postMessage(job, job.bytes ? [job.bytes.buffer] : []);
  }

  /** @param {string} fault '' for none */
  #answered(fault) {
    if (fault) {
      this.session = -1; // the next step tries again, with all of it
      if (!this.faulty) {
        this.onfault();
      }
    }
    this.faulty = fault !== '';
    this.#done(1);
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
