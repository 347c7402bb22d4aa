// Tabs: of all pages that show a drawing, only the one that holds its lock may edit it. Another can ask for the lock. Where the
// browser allows no locks, a page holds its drawing without one.

const PATIENCE = 2000; // milliseconds that the holder has to write its journal

export class Tabs {
  constructor() {
    /**
     * Called when another page takes the drawing over: everything must be on disk when it resolves.
     * @type {() => Promise<void>}
     */
    this.onleave = async () => {};
    this.name = '';
    this.held = false;
    this.release = () => {};
    /** @type {Promise<unknown>} */
    this.over = Promise.resolve();
    this.left = () => {};
    /** @type {BroadcastChannel | null} null: this browser has none */
    this.channel = null;
    try {
      this.channel = new BroadcastChannel('batten');
      this.channel.onmessage = ({ data }) => void this.#hear(data);
    } catch {
      // A page that is to leave a drawing learns it from the lock.
    }
  }

  /**
   * Releases the drawing held and claims another.
   * @param {string} name
   * @param {LockOptions} [how]
   * @returns {Promise<boolean>} whether this page may edit it
   */
  async claim(name, how = { ifAvailable: true }) {
    this.held = false;
    this.release();
    await this.over;
    this.name = name;
    return new Promise((resolve) => {
      const hold = (/** @type {boolean} */ held) => {
        this.held = held;
        resolve(held);
      };
      this.over = this.#lock(name, how, (lock) => {
        hold(lock !== null);
        return lock && new Promise((done) => {
          this.release = () => done(null);
        });
      }).catch((error) => {
        const left = this.held && this.name === name;
        hold(error.name !== 'AbortError'); // else the lock was stolen; any other error: the browser allows none
        if (left && !this.held) {
          void this.onleave();
        }
      });
    });
  }

  /** @param {string} name @param {LockOptions} how @param {(lock: Lock | null) => Promise<unknown> | null} run */
  async #lock(name, how, run) {
    await navigator.locks.request(`batten ${name}`, how, run);
  }

  /** Whether another page has a drawing. @param {string} name @returns {Promise<boolean>} */
  async isElsewhere(name) {
    const all = await navigator.locks?.query().catch(() => null);
    return name !== this.name && (all?.held ?? []).some((lock) => lock.name === `batten ${name}`);
  }

  /** Asks the page that holds this drawing to leave it, and takes it in any case. */
  async take() {
    await new Promise((resolve) => {
      this.left = () => resolve(null);
      setTimeout(resolve, this.channel ? PATIENCE : 0);
      this.channel?.postMessage({ leave: this.name });
    });
    await this.claim(this.name, { steal: true });
  }

  /** @param {{ leave?: string, left?: string }} word */
  async #hear({ leave, left }) {
    if (leave === this.name && this.held) {
      this.held = false;
      await this.onleave();
      this.release();
      await this.over;
      this.channel?.postMessage({ left: leave });
    } else if (left === this.name) {
      this.left();
    }
  }
}
