// Keeping: the journal of an unsaved drawing goes to the browser's own storage soon after each step, so that a
// closed or crashed page loses the stroke under the pen at most.

/** @typedef {{ name: string, journal: Uint8Array }} Kept */

const STORE = 'journals';
const SOON = 150; // milliseconds after a step

export class Keeper {
  constructor() {
    /** null: this browser keeps nothing. @type {Promise<IDBDatabase | null>} */
    this.base = new Promise((resolve) => {
      const request = indexedDB.open('batten', 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: 'name' });
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => resolve(null);
    });
    /** @type {Uint8Array | null} */
    this.noted = null;
    this.timer = 0;
  }

  /**
   * Told at every frame.
   * @param {string} name
   * @param {Uint8Array} journal
   * @param {boolean} unsaved
   */
  note(name, journal, unsaved) {
    const due = unsaved ? journal : null;
    if (due === this.noted) {
      return;
    }
    this.noted = due;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      void this.#write((store) => (due ? store.put({ name, journal: due }) : store.delete(name)));
    }, SOON);
  }

  /** What was kept of a drawing. @param {string} name @returns {Promise<Kept | null>} */
  async find(name) {
    const base = await this.base;
    if (!base) {
      return null;
    }
    return new Promise((resolve) => {
      const request = base.transaction(STORE).objectStore(STORE).get(name);
      request.onsuccess = () => resolve(request.result ?? null);
      request.onerror = () => resolve(null);
    });
  }

  /** @param {string} name */
  drop(name) {
    void this.#write((store) => store.delete(name));
  }

  /** @param {(store: IDBObjectStore) => IDBRequest} work */
  async #write(work) {
    const base = await this.base;
    if (base) {
      work(base.transaction(STORE, 'readwrite').objectStore(STORE));
    }
  }
}
