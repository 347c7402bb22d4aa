// The module's memory and its failures, beneath the engine's calls. Views into the memory are made anew after each
// call, since any call may grow the memory and detach them. When the module traps, its instance is dropped and the
// journal is replayed into a new one.

import { miss, Missing } from '../page/build.js';
import { Refusal, word } from '../page/words.js';
import { readString } from './frame.js';
import { Steps } from './steps.js';

/** @typedef {import('./types.js').Item} Item */
/** @typedef {Record<string, (...args: any[]) => any> & { memory: WebAssembly.Memory }} Exports */

const SCRATCH = 1024; // bytes for a call's results
export const EVENTS = 64; // pointer events for which there is always room
export const OK = 0;
export const NO_MEMORY = 1; // as BAT_MEMORY
export const UNSUPPORTED = 14; // as BAT_UNSUPPORTED
const SOON = 200; // milliseconds after which a long journal is compacted: not while the pen is lifted
const SHORT = 1 << 20; // bytes that a journal may always grow by before it is compacted
const HOPELESS = 8; // after so many traps in a row in calls of a kind the editor is given up
const LARGE = 64; // share of the module's memory for which there may be no room though there is for others
const STARTS = 40; // instances that one trap may cost
export const FAILS = -1; // in place of a status: the call broke off

const encoder = new TextEncoder();

/** A check inside the module failed. */
class Panic extends Error {}

/** There is no memory for what was asked. */
class NoMemory extends Refusal {}

/** There is none for anything: a new instance has some, since memory is never given back. */
class Exhausted extends NoMemory {}

/** @param {unknown} error */
const isTrap = (error) => error instanceof WebAssembly.RuntimeError || error instanceof Panic || error instanceof RangeError ||
  error instanceof Exhausted;

/**
 * What came of a call that broke off. left: the steps that could not be repeated, as lines of the journal; more: how many
 * of them this time. dead: the editor is given up; fresh: it is a new one. scarce: there was no memory for the call.
 * @typedef {{ left: Uint8Array[], more: number, dead: boolean, fresh: boolean, scarce: boolean }} Outcome
 */

export class Instance {
  /**
   * @param {import('./module.js').Module} module
   */
  constructor(module) {
    this.module = module;
    /** Called after a call broke off. @type {(outcome: Outcome, error: unknown) => void} */
    this.onrecovery = () => {};
    /** There was no memory for the last call that needed some. */
    this.scarce = false;
    /** The journal up to the last call that returned, outside the module's memory. @type {Uint8Array} */
    this.journal = new Uint8Array(0);
    /** Counts the journals so far: each new journal begins a session. */
    this.session = 0;
    /** Counts the drawings so far: a session that does not go on with the one before begins one. */
    this.drawing = 0;
    /** What the journal is the first part of: room to grow. @type {Uint8Array} */
    this.room = this.journal;
    /** The length at which the journal is compacted: half as long again as when it was new. */
    this.long = SHORT;
    /** The timer of the compaction that is due. @type {ReturnType<typeof setTimeout> | 0} */
    this.due = 0;
    /** The journal before the first step was left out, or else at the last trap. @type {Uint8Array} */
    this.broken = new Uint8Array(0);
    /** The steps left out of this drawing, as lines of its journal. @type {Uint8Array[]} */
    this.left = [];
    /** Traps in a row, by the kind of call: in frames nothing is wrong with the last step. */
    this.traps = { call: 0, pointer: 0, frame: 0 };
    /** The module's second part is missing: keys and commands, which may need it, do nothing. */
    this.partial = false;
    /** Given up: it traps whatever is tried, or part of the module is missing. It answers no further calls. */
    this.dead = false;
    this.size = [1, 1, 1];
    /** The strings of another language, as fetched. @type {Uint8Array | null} */
    this.words = null;
    this.readOnly = false;
    /** @type {Exports} */
    this.wasm = /** @type {any} */ (null);
    /** @type {Record<string, number>} */
    this.layout = {};
    this.editor = 0;
    this.scratch = 0;
    this.events = 0;
    /** @type {Item[]} */
    this.still = [];
    this.stillVersion = -1;
    this.#start();
  }

  /** Makes a new instance with an empty editor. */
  #start() {
    const host = {
      /** @param {number} file @param {number} line @param {number} text */
      panic: (file, line, text) => {
        throw new Panic(`${this.string(file)}:${line}: ${this.string(text)}`);
      },
    };
    const instance = this.module.instantiate(host);
    this.wasm = /** @type {any} */ (instance.exports);
    this.wasm._initialize?.();
    this.layout = this.#readLayout();
    this.scratch = this.alloc(SCRATCH);
    this.events = this.alloc(EVENTS * this.layout['pointer.size']);
    this.editor = this.wasm.editor_create();
    if (!this.editor) {
      throw new Exhausted(word('shell.no-memory'));
    }
    this.stillVersion = -1;
    this.wasm.editor_resize(this.editor, ...this.size);
    if (this.words) {
      this.speak(this.words);
    }
    this.wasm.editor_read_only(this.editor, Number(this.readOnly));
  }

  /** Sets the strings of a language. @param {Uint8Array} words */
  speak(words) {
    this.words = words;
    this.lend(words, (text, size) => this.wasm.editor_words(this.editor, text, size));
  }

  // ---- memory ----

  view() {
    return new DataView(this.wasm.memory.buffer);
  }

  /** @param {number} size */
  alloc(size) {
    const address = this.wasm.memory_alloc(size);
    this.scarce = !address;
    if (!address) {
      const large = size > this.wasm.memory.buffer.byteLength / LARGE;
      throw new (large ? NoMemory : Exhausted)(word('shell.no-memory'));
    }
    return address;
  }

  /** @param {number} address */
  string(address) {
    return readString(this.wasm.memory, address);
  }

  /**
   * Runs `work` with the address of the bytes, copied into the module and followed by a NUL.
   * @template T
   * @param {Uint8Array | string} data
   * @param {(address: number, size: number) => T} work
   * @returns {T}
   */
  lend(data, work) {
    const bytes = typeof data === 'string' ? encoder.encode(data) : data;
    const address = this.alloc(bytes.length + 1);
    const memory = new Uint8Array(this.wasm.memory.buffer);
    memory.set(bytes, address);
    memory[address + bytes.length] = 0;
    const result = work(address, bytes.length);
    this.wasm.memory_free(address);
    return result;
  }

  /** @returns {Record<string, number>} */
  #readLayout() {
    const view = this.view();
    /** @type {Record<string, number>} */
    const layout = {};
    for (let at = this.wasm.module_layout(); view.getUint32(at, true); at += 8) {
      layout[this.string(view.getUint32(at, true))] = view.getUint32(at + 4, true);
    }
    return layout;
  }

  // ---- traps ----

  /**
   * Runs a call into the module. After a trap the editor is rebuilt and `fallback` is returned.
   * @template T
   * @param {() => T} work
   * @param {T} fallback
   * @param {'call' | 'pointer' | 'frame'} [kind] of the call
   * @returns {T}
   */
  guard(work, fallback, kind = 'call') {
    if (this.dead) {
      return fallback;
    }
    try {
      const result = work();
      this.keepJournal();
      this.traps[kind] = 0;
      return result;
    } catch (error) {
      if (error instanceof Missing) {
        this.halt(error);
      } else if (isTrap(error)) {
        this.#recover(error, kind);
      } else if (error instanceof NoMemory) {
        this.#tell(null, error);
      } else {
        throw error;
      }
      return fallback;
    }
  }

  /** Stops for good: a call broke off midway because part of the module is missing. @param {unknown} error */
  halt(error) {
    this.dead = true;
    miss(error);
  }

  /** @param {unknown} error @param {'call' | 'pointer' | 'frame'} kind */
  #recover(error, kind) {
    if (this.left.length === 0) {
      this.broken = this.journal;
    }
    if (++this.traps[kind] > HOPELESS) {
      this.dead = true;
      this.#tell(null, error);
    } else {
      this.bring(this.journal, error);
    }
  }

  /**
   * Replays a journal into a new instance, without the steps that trap, and tells what came of it. An empty one leaves
   * an empty editor.
   * @param {Uint8Array} journal @param {unknown} error the trap that made it necessary
   */
  bring(journal, error) {
    const before = this.left;
    const left = this.#rebuild(journal);
    this.dead ||= left === null;
    if (left) {
      this.wasm.editor_journal(this.editor, this.scratch);
      if (left.length > 0 || this.view().getUint32(this.scratch, true) !== journal.length) {
        this.begun(new Uint8Array(0), left.length === 0);
        this.keepJournal();
      } // else it is the same to the byte, and what is kept of it goes on
      this.left = [...before, ...left];
    }
    this.#tell(left, error);
  }

  /** @param {Uint8Array[] | null} left what this replay left out; null: there was none @param {unknown} error */
  #tell(left, error) {
    this.onrecovery({ left: this.left, more: left?.length ?? 0, dead: this.dead, fresh: left !== null,
      scarce: error instanceof NoMemory }, error);
  }

  /** @param {Uint8Array} journal @returns {Uint8Array[] | null} the lines left out; null: nothing helps */
  #rebuild(journal) {
    const steps = new Steps(journal);
    for (let start = 0; start < STARTS; start++) {
      try {
        this.#start();
        return steps.play((line, first) => (first ? this.#replayed(line) : this.replayLine(line)) === OK) ? steps.left : null;
      } catch (error) {
        if (error instanceof Missing) {
          this.halt(error);
          return null;
        }
        if (!isTrap(error) && !(error instanceof NoMemory)) { // a line may be too long for what memory there is
          throw error;
        }
        steps.trapped();
      }
    }
    return null;
  }

  /** Begins anew with an empty editor after it was given up. @returns {boolean} whether that works */
  revive() {
    this.traps = { call: 0, pointer: 0, frame: 0 };
    this.dead = this.#rebuild(new Uint8Array(0)) === null;
    this.begun(new Uint8Array(0));
    return !this.dead;
  }

  /** Takes the bytes that a call has left in the scratch area. @returns {Uint8Array<ArrayBuffer>} */
  take() {
    const view = this.view();
    const data = view.getUint32(this.scratch + this.layout['bytes.data'], true);
    const size = view.getUint32(this.scratch + this.layout['bytes.size'], true);
    const copy = new Uint8Array(this.wasm.memory.buffer).slice(data, data + size);
    this.wasm.memory_free(data);
    return copy;
  }

  /** @param {Uint8Array} journal @returns {number} the status */
  #replayed(journal) {
    return this.lend(journal, (text, size) => this.wasm.editor_replay(this.editor, text, size, 0, this.scratch));
  }

  /** Runs one line more of a journal. @param {Uint8Array} line @returns {number} the status */
  replayLine(line) {
    return this.lend(line, (text, size) => this.wasm.editor_replay_line(this.editor, text, size, this.scratch));
  }

  /**
   * Replaces the document by replaying a journal from its first line.
   * @param {Uint8Array} journal
   * @returns {boolean} whether every line could be replayed
   */
  replay(journal) {
    this.begun(journal); // to be brought back if it traps
    const status = this.guard(() => this.afresh(this.#replayed(journal)), FAILS);
    if (status === FAILS && this.scarce && !this.dead) { // a new instance has all its memory, and takes a line at a time
      this.bring(journal, null);
    }
    return status === OK || (status === FAILS && !this.dead);
  }

  /**
   * The same with a journal that is damaged: what can be run is.
   * @param {Uint8Array} journal
   * @returns {number} how many lines could not; -1: nothing could be run, and the document is as it was
   */
  salvage(journal) {
    return this.guard(() => {
      const lost = this.lend(journal, (text, size) => this.wasm.editor_salvage(this.editor, text, size));
      return this.afresh(lost, lost >= 0);
    }, -1);
  }

  /**
   * The result of a call; the journal that it began is copied afresh.
   * @param {number} result @param {boolean} [any] whether it began one
   */
  afresh(result, any = true) {
    if (any) {
      this.begun(new Uint8Array(0));
    }
    return result;
  }

  /**
   * Begins another journal.
   * @param {Uint8Array} journal as far as it is known @param {boolean} [same] of the same drawing
   */
  begun(journal, same = false) {
    this.journal = this.room = journal;
    this.left = same ? this.left : [];
    this.session++;
    this.drawing += same ? 0 : 1;
  }

  /** Copies what has been added to the journal, and compacts it when it has become long. */
  keepJournal() {
    const address = this.wasm.editor_journal(this.editor, this.scratch);
    const size = this.view().getUint32(this.scratch, true);
    const { length } = this.journal;
    if (size === length || !address) {
      return;
    }
    if (size < length) { // another one: who opened it begins a session
      this.journal = this.room = new Uint8Array(0);
      this.keepJournal();
    } else {
      this.#append(new Uint8Array(this.wasm.memory.buffer, address + length, size - length));
      if (length === 0) {
        this.long = size + Math.max(SHORT, size / 2);
      } else if (size > 1.5 * this.long) { // the hand never rests
        this.#compact();
      } else if (size > this.long) {
        this.due ||= setTimeout(() => this.guard(() => this.#compact(), undefined), SOON);
      }
    }
  }

  #compact() {
    clearTimeout(this.due);
    this.due = 0;
    if (this.journal.length > this.long && this.wasm.editor_compact(this.editor) === OK) { // not during a stroke
      this.begun(new Uint8Array(0), true);
      this.keepJournal();
    }
  }

  /** @param {Uint8Array} more */
  #append(more) {
    const { length } = this.journal;
    const size = length + more.length;
    if (size > this.room.length) {
      this.room = new Uint8Array(size + size / 4);
      this.room.set(this.journal);
    }
    this.room.set(more, length); // behind all that was handed out
    this.journal = this.room.subarray(0, size);
  }
}
