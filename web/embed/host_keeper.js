// Keeping, in a frame of another page: the journal goes to that page with each step, and the drawing as SVG soon after.
// Nothing is kept in the browser.

import { Keeper } from '../keep/keep.js';

const SOON = 200; // milliseconds from a step until the page is told of the drawing
const LATEST = 1000; // where writing the drawing takes long
const SHARE = 10; // times what writing it takes, until it is written again

export class HostKeeper extends Keeper {
  /** @param {(message: object) => void} send to the page around this one */
  constructor(send) {
    super();
    this.send = send;
    /** The drawing as SVG. @type {() => Uint8Array} */
    this.svg = () => new Uint8Array(0);
    /** Whether it is unsaved. @type {() => boolean} */
    this.isUnsaved = () => false;
    this.unsaved = false;
    /** The name of the drawing that is kept. */
    this.name = '';
    this.timer = 0;
    this.pause = SOON;
    /** What the page was last told. */
    this.text = '';
    this.saved = true;
  }

  /** @returns {Worker} the page, which takes all that is sent */
  hire() {
    const worker = /** @type {any} */ ({
      /** @param {import('../keep/keeping.js').Job} job */
      postMessage: ({ call, with: [about, bytes] }) => {
        this.name = call === 'begin' ? about.name : this.name;
        if (call === 'begin' || call === 'append') {
          this.send({ keep: bytes, more: call === 'append', name: this.name });
        }
        queueMicrotask(() => worker.onmessage({ data: { value: call === 'list' ? [] : null, fault: '' } }));
      },
      terminate() {},
    });
    queueMicrotask(() => worker.onmessage({ data: 'ready' }));
    return worker;
  }

  /** Whether this session's journal has other steps than were noted. @param {number} session @param {number} length */
  isNew(session, length) {
    return session === this.session && length !== this.length;
  }

  /** All is kept, whether it is saved or not. @returns {boolean} */
  get begun() {
    return true;
  }

  /** A saved drawing is there until the next begins. */
  letGo() {}

  /** @param {string} name @param {string} place @param {number} session @param {Uint8Array} journal */
  note(name, place, session, journal) {
    const same = session === this.session && journal.length === this.length && this.isUnsaved() === this.unsaved;
    this.unsaved = this.isUnsaved();
    super.note(name, place, session, journal);
    if (!same) {
      this.timer ||= setTimeout(() => this.tell(true), this.pause);
    }
  }

  /** Tells the page of the drawing. @param {boolean} byUser otherwise the page has asked for what it is */
  tell(byUser) {
    clearTimeout(this.timer);
    this.timer = 0;
    const start = performance.now();
    let text = this.text;
    try {
      text = new TextDecoder().decode(this.svg());
    } catch {
      // It cannot be written now; its journal can.
    }
    this.pause = Math.min(Math.max(SOON, SHARE * (performance.now() - start)), LATEST);
    if (text !== this.text || this.saved === this.unsaved) {
      [this.text, this.saved] = [text, !this.unsaved];
      this.send({ told: text, unsaved: this.unsaved, byUser });
    }
  }
}
