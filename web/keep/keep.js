// Keeping: each step of a drawing's journal is on the disk as soon as it is done, in the browser's own storage, so that a closed
// or crashed page loses at most the stroke under the pen. What is kept is removed only when its file elsewhere has it, or
// when the user says so. keeping.js, a worker, does the reading and the writing.

import { addressOf } from '../page/build.js';

/** @typedef {import('./store.js').Kept} Kept */
/** @typedef {import('./store.js').Listed} Listed */
/** @typedef {'no-room' | 'cleared' | 'not-kept'} Fault why nothing is kept; the page has words for each */
/** @typedef {import('./keeping.js').Answer} Answer */

/** What there was to read could not be read now. */
export class Unread extends Error {}

/** An id that no other drawing has. */
export const newId = () => Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, '0')).join('');

export class Keeper {
  constructor() {
    /**
     * Called when steps cannot be kept, once for each reason, and when they can again.
     * @type {(fault: Fault | '') => void}
     */
    this.onfault = () => {};
    /** Called when the first step of this page is kept. */
    this.onfirst = () => {};
    /** @type {Worker | null} */
    this.worker = null;
    /** What this page keeps: the drawing, by its id and by the engine's count; the engine's session (-1: nothing yet) and how much of its journal. */
    this.id = newId();
    this.drawing = -1;
    this.session = -1;
    this.length = 0;
    /** Its file is open, and more can be added to it. */
    this.open = false;
    /** Why the last write failed. @type {Fault | ''} */
    this.fault = '';
    /** Pending writes, and the callers waiting for them. */
    this.writes = 0;
    /** @type {(() => void)[]} */
    this.waiting = [];
    /** Who hears of each answer, in the order of the jobs. @type {((answer: Answer) => void)[]} */
    this.asked = [];
  }

  /** Starts the worker in advance, so that the first step can be kept even if the server has stopped by then. */
  async start() {
    this.#work();
    await this.settled();
    this.fault = ''; // if the worker does not start, the first step tries again
  }

  /** From now on the page has another drawing; what was kept stays. @param {number} drawing the engine's count @param {string} [id] of one that is kept */
  begin(drawing, id = newId()) {
    if (this.open) {
      this.#write('release');
    }
    [this.id, this.drawing, this.session, this.length, this.open] = [id, drawing, -1, 0, false];
  }

  /**
   * Goes on with a drawing that is kept, as the engine has it now: it is written with its next step.
   * @param {string} id @param {number} drawing the engine's count @param {number} session @param {number} length of its journal
   */
  goOn(id, drawing, session, length) {
    this.begin(drawing, id);
    [this.session, this.length] = [session, length];
  }

  /** Whether anything of this drawing is kept. */
  get begun() {
    return this.session >= 0;
  }

  /**
   * Called at every frame, and when the pen is lifted.
   * @param {string} name
   * @param {string} place of its file, when it is unsaved work on one
   * @param {number} session the engine's; each session has its own journal
   * @param {Uint8Array} journal
   */
  note(name, place, session, journal) {
    const same = session === this.session;
    if (same && journal.length === this.length) {
      return;
    }
    if (same && this.open && !this.fault) {
      this.#write('append', this.id, journal.slice(this.length));
    } else { // after a fault the next step writes all of it
      this.#write('begin', { id: this.id, name, place }, journal.slice());
      this.open = true;
    }
    [this.session, this.length] = [session, journal.length];
  }

  /** The file of this drawing has all of it now. */
  letGo() {
    if (this.begun) {
      this.#write('remove', this.id);
    }
    [this.session, this.length, this.open] = [-1, 0, false];
  }

  /** What is kept of a drawing. Throws Unread. @param {string} id @returns {Promise<Kept | null>} */
  async take(id) {
    return this.ask('take', id);
  }

  /** All drawings kept, the latest first, and those that the user deleted. Throws Unread. @returns {Promise<Listed[]>} */
  async list() {
    return this.ask('list');
  }

  /** The latest that is kept under a name, unless it was put aside. @param {string} name @returns {Promise<Kept | null>} null also when nothing can be read */
  async find(name) {
    try {
      const found = (await this.list()).find((kept) => kept.name === name && !kept.aside && !kept.gone);
      return found ? await this.take(found.id) : null;
    } catch {
      return null;
    }
  }

  /** Puts a drawing aside: it is opened only when the user asks for it. @param {string} id */
  putAside(id) {
    this.#write('mark', id, 'aside', true);
  }

  /** Deletes a drawing, or brings it back. @param {string} id @param {boolean} gone */
  setGone(id, gone) {
    this.#write('mark', id, 'gone', gone);
  }

  /** Waits until everything noted is on disk, or has failed. @returns {Promise<void>} */
  settled() {
    return new Promise((resolve) => {
      this.waiting.push(resolve);
      this.#done(0);
    });
  }

  /** Hands the drawing over to another page. */
  async yield() {
    this.begin(this.drawing, this.id);
    await this.settled();
  }

  /** The answer of a call. Throws Unread. @param {import('./keeping.js').Job['call']} call @param {...unknown} values @returns {Promise<any>} */
  async ask(call, ...values) {
    const answer = await /** @type {Promise<Answer>} */ (new Promise((resolve) => this.#send(call, values, resolve)));
    if (answer.fault) {
      throw new Unread(answer.why);
    }
    return answer.value;
  }

  /** @param {import('./keeping.js').Job['call']} call @param {...unknown} values */
  #write(call, ...values) {
    this.#send(call, values, ({ fault }) => this.#wrote(call, fault));
  }

  /** @param {import('./keeping.js').Job['call']} call @param {unknown[]} values @param {(answer: Answer) => void} then */
  #send(call, values, then) {
    const worker = this.#work();
    if (!worker) {
      then({ fault: 'not-kept', why: 'no worker could be started' });
      return;
    }
    this.writes++;
    this.asked.push(then);
    worker.postMessage({ call, with: values }, values.flatMap((value) => (value instanceof Uint8Array ? [value.buffer] : [])));
  }

  /** What does the work: answers each job, after a first 'ready'. @returns {Worker} */
  hire() {
    return new Worker(addressOf('keep/keeping.js'), { type: 'module' });
  }

  /** The worker; starts one when there is none. @returns {Worker | null} null: none can be started */
  #work() {
    if (!this.worker) {
      try {
        this.worker = this.hire();
      } catch (error) {
        console.warn(error);
        return null;
      }
      this.writes++; // it reports when it is running
      this.worker.onmessage = ({ data }) => (data === 'ready' ? this.#done(1) : this.#answered(data));
      this.worker.onerror = (event) => {
        event.preventDefault(); // the page reports it
        this.#end('not-kept');
      };
    }
    return this.worker;
  }

  /** @param {Answer} answer */
  #answered(answer) {
    this.asked.shift()?.(answer);
    this.#done(1);
  }

  /** Drops the worker: nothing more comes from it. @param {Fault} fault */
  #end(fault) {
    this.worker?.terminate();
    this.worker = null;
    this.asked.splice(0).forEach((then) => then({ fault }));
    this.#done(this.writes);
  }

  /** @param {import('./keeping.js').Job['call']} call @param {Fault | ''} fault */
  #wrote(call, fault) {
    const before = this.fault;
    if (call !== 'begin' && call !== 'append') {
      return; // nothing of this drawing is lost by it
    }
    this.fault = fault;
    this.open &&= !fault;
    if (fault === 'cleared') {
      this.length = -1; // there is room again: all of it is written at once
      if (this.worker) {
        this.#end(fault); // while it holds a cleared file open, Chromium loses new ones as well
      }
    }
    if (!fault && call === 'begin') {
      this.onfirst();
    }
    if (fault !== before && (fault || before !== 'cleared')) {
      this.onfault(fault);
    }
  }

  /** @param {number} count */
  #done(count) {
    this.writes = Math.max(0, this.writes - count);
    if (this.writes === 0) {
      this.waiting.splice(0).forEach((resolve) => resolve());
    }
  }
}
