// Tabs: of all pages that show a drawing, only the one that holds its lock may edit it. Another can ask for the lock.

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
    this.channel = new BroadcastChannel('batten');
    this.channel.onmessage = ({ data }) => void this.#hear(data);
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
      this.over = navigator.locks.request(`batten ${name}`, how, (lock) => {
        this.held = lock !== null;
        resolve(this.held);
        return lock && new Promise((done) => {
          this.release = () => done(null);
        });
      }).catch(() => {
        if (this.held && this.name === name) { // the lock was stolen
          this.held = false;
          void this.onleave();
        }
      });
    });
  }

  /** Asks the page that holds this drawing to leave it, and takes it in any case. */
  async take() {
    await new Promise((resolve) => {
      this.left = () => resolve(null);
      setTimeout(resolve, PATIENCE);
      this.channel.postMessage({ leave: this.name });
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
      this.channel.postMessage({ left: leave });
    } else if (left === this.name) {
      this.left();
    }
  }
}
