// A room of files in the browser's database, for browsers whose private file system cannot be written in place. A file is the
// pieces that were written to it, by their places; a piece is written whole or not at all. Fetched when needed.

/** @typedef {import('./store.js').Room} Room */
/** @typedef {import('./store.js').Access} Access */
/** @typedef {{ bytes: Uint8Array, time: number }} Piece */

const STORE = 'pieces';

/** @param {string} name */
const rangeOf = (name) => IDBKeyRange.bound([name], [name, []]);

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
const answered = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

/** @implements {Room} */
export class Database {
  /** @param {IDBDatabase} database */
  constructor(database) {
    this.database = database;
  }

  /** The browser's; throws if there is none. */
  static async find() {
    const opening = indexedDB.open('batten-kept', 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE);
    return new Database(await answered(opening));
  }

  /** @template T @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => IDBRequest<T>} work @returns {Promise<T>} when it is on the disk */
  #do(mode, work) {
    return new Promise((resolve, reject) => {
      const transaction = this.database.transaction(STORE, mode, { durability: 'strict' });
      const request = work(transaction.objectStore(STORE));
      const fail = () => reject(transaction.error ?? request.error);
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = fail;
      transaction.onerror = fail;
    });
  }

  async names() {
    const keys = /** @type {[string, number][]} */ (await this.#do('readonly', (store) => store.getAllKeys()));
    return [...new Set(keys.map(([name]) => name))];
  }

  /** @param {string} name */
  async has(name) {
    return await this.#do('readonly', (store) => store.count(rangeOf(name))) > 0;
  }

  /** @param {string} name @returns {Promise<[number, Piece][]>} by their places */
  async #pieces(name) {
    const keys = /** @type {[string, number][]} */ (await this.#do('readonly', (store) => store.getAllKeys(rangeOf(name))));
    const pieces = /** @type {Piece[]} */ (await this.#do('readonly', (store) => store.getAll(rangeOf(name))));
    if (keys.length === 0) {
      throw new DOMException(name, 'NotFoundError');
    }
    return pieces.map((piece, i) => [keys[i][1], piece]);
  }

  /** @param {string} name */
  async time(name) {
    return Math.max(...(await this.#pieces(name)).map(([, { time }]) => time));
  }

  /** @param {string} name @param {number} [size] at most so many bytes */
  async read(name, size) {
    const pieces = await this.#pieces(name);
    const all = new Uint8Array(Math.max(...pieces.map(([at, { bytes }]) => at + bytes.length)));
    pieces.forEach(([at, { bytes }]) => all.set(bytes, at));
    return all.subarray(0, size);
  }

  /** @param {string} name @returns {Promise<Access>} */
  async open(name) {
    return {
      write: async (bytes, at) => {
        await this.#do('readwrite', (store) => store.put({ bytes, time: Date.now() }, [name, at]));
        return bytes.length;
      },
      read: () => this.read(name),
      flush: () => {},
      close: () => {},
    };
  }

  /** @param {string} name */
  async remove(name) {
    await this.#do('readwrite', (store) => store.delete(rangeOf(name)));
  }
}
