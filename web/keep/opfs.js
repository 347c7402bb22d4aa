// A room of files in the browser's private file system. Only workers can write in place there and know when it is done.

/** @typedef {import('./store.js').Room} Room */
/** @typedef {import('./store.js').Access} Access */
/** What the browser gives for a file that is open. @typedef {{ write: (data: Uint8Array, options: { at: number }) => number,
 * read: (data: Uint8Array, options: { at: number }) => number, getSize: () => number, flush: () => void, close: () => void }} Sync */

const FOLDER = 'drawings';

/** @implements {Room} */
export class Opfs {
  /** @param {FileSystemDirectoryHandle} root */
  constructor(root) {
    this.root = root;
    /** Those that were there when names were last asked for. @type {Map<string, FileSystemFileHandle>} */
    this.seen = new Map();
    /** Those that are open here. @type {Map<string, Sync>} */
    this.open_ = new Map();
  }

  /** The browser's, if it can be written; throws if not. */
  static async find() {
    const room = new Opfs(await navigator.storage.getDirectory());
    const trial = `${crypto.getRandomValues(new Uint32Array(2)).join('')}.trial`; // no drawing's: one that is left does no harm
    const access = await room.open(trial);
    await access.close();
    await room.remove(trial).catch(() => {});
    return room;
  }

  /** The folder is looked up each time: it may have been cleared away. */
  #folder() {
    return this.root.getDirectoryHandle(FOLDER, { create: true });
  }

  async names() {
    this.seen = new Map();
    for await (const [name, handle] of /** @type {any} */ (await this.#folder()).entries()) {
      this.seen.set(name, handle);
    }
    return [...this.seen.keys()];
  }

  /** @param {string} name */
  async has(name) {
    return (await this.#folder()).getFileHandle(name).then(() => true, () => false);
  }

  /** @param {string} name */
  async #file(name) {
    return (this.seen.get(name) ?? await (await this.#folder()).getFileHandle(name)).getFile();
  }

  /** @param {string} name */
  async time(name) {
    return (await this.#file(name)).lastModified;
  }

  /** @param {string} name @param {number} [size] at most so many bytes */
  async read(name, size) {
    const open = this.open_.get(name);
    return open ? readAll(open).subarray(0, size) : new Uint8Array(await (await this.#file(name)).slice(0, size).arrayBuffer());
  }

  /** @param {string} name @returns {Promise<Access>} */
  async open(name) {
    const handle = /** @type {any} */ (await (await this.#folder()).getFileHandle(name, { create: true }));
    /** @type {Sync} */
    const sync = await handle.createSyncAccessHandle();
    this.open_.set(name, sync);
    return {
      write: (bytes, at) => sync.write(bytes, { at }),
      read: () => readAll(sync),
      flush: () => sync.flush(),
      close: async () => {
        this.open_.delete(name);
        if (await this.has(name)) { // Chromium never closes one that was cleared away
          sync.close();
        }
      },
    };
  }

  /** @param {string} name */
  async remove(name) {
    await (await this.#folder()).removeEntry(name);
  }
}

/** @param {Sync} sync */
function readAll(sync) {
  const bytes = new Uint8Array(sync.getSize());
  return bytes.subarray(0, sync.read(bytes, { at: 0 }));
}
