// The module's memory and its failures, beneath the engine's calls. Views into the memory are made anew after each
// call, since any call may grow the memory and detach them. When the module traps, its instance is dropped and the
// journal is replayed into a new one.

import { miss, Missing } from '../page/build.js';
import { Refusal, word } from '../page/words.js';
import { readString } from './frame.js';

/** @typedef {import('./types.js').Item} Item */
/** @typedef {Record<string, (...args: any[]) => any> & { memory: WebAssembly.Memory }} Exports */

const SCRATCH = 1024; // bytes for a call's results
export const EVENTS = 64; // pointer events sent in one call
export const OK = 0;
const LONG = 8 << 20; // bytes: a longer journal is compacted
const HOPELESS = 3; // after so many traps in a row the journal is given up
const DEAD = 6;

const encoder = new TextEncoder();

/** A check inside the module failed. */
class Panic extends Error {}

export class Instance {
  /**
   * @param {import('./module.js').Module} module
   */
  constructor(module) {
    this.module = module;
    /** Called after a trap. whole: every step was restored. @type {(whole: boolean, error: unknown) => void} */
    this.onrecovery = () => {};
    /** The journal up to the last call that returned, outside the module's memory. @type {Uint8Array} */
    this.journal = new Uint8Array(0);
    /** Counts the journals so far: each new journal begins a session. */
    this.session = 0;
    /** Counts the drawings so far: a session that does not go on with the one before begins one. */
    this.drawing = 0;
    /** The length at which the journal is compacted. */
    this.long = LONG;
    /** The journal at the last trap, for a bug report. @type {Uint8Array} */
    this.broken = new Uint8Array(0);
    /** Traps since the last complete frame. */
    this.traps = 0;
    /** The module's second part is missing: keys and commands, which may need it, do nothing. */
    this.partial = false;
    /** Given up: even an empty editor traps, or part of the module is missing. It answers no further calls. */
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
      throw new Refusal(word('shell.no-memory'));
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
    if (!address) {
      throw new Refusal(word('shell.no-memory'));
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
   * @returns {T}
   */
  guard(work, fallback) {
    if (this.dead) {
      return fallback;
    }
    try {
      return work();
    } catch (error) {
      if (error instanceof Missing) {
        this.halt(error);
        return fallback;
      }
      if (!(error instanceof WebAssembly.RuntimeError || error instanceof Panic || error instanceof RangeError)) {
        throw error;
      }
      this.#recover(error);
      return fallback;
    }
  }

  /** Stops for good: a call broke off midway because part of the module is missing. @param {unknown} error */
  halt(error) {
    this.dead = true;
    miss(error);
  }

  /** @param {unknown} error */
  #recover(error) {
    const whole = this.journal;
    if (this.traps++ === 0) {
      this.broken = whole;
    }
    this.dead = this.traps > DEAD;
    // If even painting the replayed journal traps, start with an empty drawing.
    let part = this.traps > HOPELESS ? whole.subarray(0, 0) : whole;
    // The step that broke the module may break it again: give up the last steps, one by one.
    for (let lost = 0; lost < 8 && part.length > 0; lost++) {
      try {
        this.#start();
        const status = this.lend(part, (text, size) =>
          this.wasm.editor_replay(this.editor, text, size, 0, this.scratch));
        if (status === OK) {
          this.begun(part, lost === 0);
          this.onrecovery(lost === 0, error);
          return;
        }
      } catch (again) {
        if (again instanceof Missing) {
          this.halt(again);
          return;
        }
        // This instance is broken; the next iteration makes another.
      }
      part = part.subarray(0, part.lastIndexOf(10, part.length - 2) + 1);
    }
    this.#start();
    this.begun(new Uint8Array(0), whole.length === 0);
    this.onrecovery(whole.length === 0, error);
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

  /**
   * Begins another journal.
   * @param {Uint8Array} journal as far as it is known @param {boolean} [same] of the same drawing
   */
  begun(journal, same = false) {
    this.journal = journal;
    this.session++;
    this.drawing += same ? 0 : 1;
  }

  /** Copies what has been added to the journal. */
  keepJournal() {
    const address = this.wasm.editor_journal(this.editor, this.scratch);
    const size = this.view().getUint32(this.scratch, true);
    if (size === this.journal.length || !address) {
      return;
    }
    if (size > this.long) {
      const done = this.wasm.editor_compact(this.editor) === OK;
      this.long = 2 * size;
      if (done) {
        this.begun(new Uint8Array(0), true);
        this.keepJournal();
        this.long = Math.max(LONG, 2 * this.journal.length);
        return;
      }
    }
    this.journal = new Uint8Array(this.wasm.memory.buffer).slice(address, address + size);
  }
}
