// The module's memory: places for arguments and results, which are given back after each call.
import { BattenError } from './error.js';

/** A member of a struct of C: `at` bytes from its begin; `room`: how many numbers it has, where it is an array.
 * @typedef {{ name: string, type: string, room: number, at: number }} Field */
/** @typedef {{ size: number, fields: Field[] }} Struct */
/** The words of each enumeration, and their numbers. @typedef {Record<string, Record<string, number>>} Enums */
/** What is read from memory. @typedef {number | boolean | string | undefined | Float64Array | object} Value */

const SIZES = { double: 8, int: 4, size_t: 4, bool: 1 };

/** Frees the numbers that nobody holds any more. */
const lost = new FinalizationRegistry((/** @type {{ exports: Record<string, Function>, at: number }} */ { exports, at }) => exports.free(at));

/** Numbers in the module's memory, which calls read and write where they are. */
export class Numbers {
  #memory;
  #at;

  /** @param {Memory} memory @param {number} length */
  constructor(memory, length) {
    if (!(Number.isInteger(length) && length > 0 && length <= 1 << 28)) {
      throw new BattenError('count', 'an array has 1 to 2^28 numbers');
    }
    this.#memory = memory;
    this.#at = memory.allocate(8 * length);
    this.length = length;
    lost.register(this, { exports: memory.exports, at: this.#at }, this);
    this.values.fill(0);
  }

  /** Where they are; throws when they have been freed. @returns {number} */
  get at() {
    if (!this.#at) {
      throw new BattenError('state', 'the array has been freed');
    }
    return this.#at;
  }

  /** A view of the numbers. Any call may enlarge the memory, which leaves the view empty: ask again after each. */
  get values() {
    return new Float64Array(this.#memory.buffer, this.at, this.length);
  }

  /** Gives the memory back at once. */
  free() {
    if (this.#at) {
      this.#memory.exports.free(this.#at);
      lost.unregister(this);
      this.#at = 0;
    }
  }

  /** As free(): for `using`. */
  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() {
    this.free();
  }
}

/** The memory of an instance. */
export class Memory {
  /** @type {number[]} */
  #held = [];
  /** @type {DataView | null} */
  #view = null;

  /** @param {Record<string, Function>} exports @param {Record<string, Struct>} structs @param {Enums} enums */
  constructor(exports, structs, enums) {
    this.exports = exports;
    this.structs = structs;
    this.enums = enums;
  }

  /** The memory as it is now: it is another when it has grown. @returns {ArrayBuffer} */
  get buffer() {
    return this.exports.memory.buffer;
  }

  /** A view of the memory as it is now. @returns {DataView} */
  get view() {
    if (this.#view?.buffer !== this.buffer) {
      this.#view = new DataView(this.buffer);
    }
    return /** @type {DataView} */ (this.#view);
  }

  /** Memory that the caller frees. */
  allocate(bytes) {
    const at = this.exports.malloc(bytes > 0 ? bytes : 8) >>> 0;
    if (!at) {
      throw new BattenError('memory', 'an allocation failed');
    }
    return at;
  }

  /** Memory until the call ends, filled with zeros. */
  borrow(bytes) {
    const at = this.allocate(bytes);
    this.#held.push(at);
    new Uint8Array(this.buffer, at, bytes).fill(0);
    return at;
  }

  /** Runs what borrows, and gives back what it borrowed. @template T @param {() => T} what @returns {T} */
  during(what) {
    const mark = this.#held.length;
    try {
      return what();
    } finally {
      this.#held.splice(mark).forEach((at) => this.exports.free(at));
    }
  }

  /** Numbers as they lie in memory: without a copy where they are there already. */
  place(numbers) {
    if (numbers instanceof Numbers) {
      return numbers.at;
    }
    if (numbers instanceof Float64Array && numbers.buffer === this.buffer) {
      return numbers.byteOffset;
    }
    const at = this.borrow(8 * numbers.length);
    new Float64Array(this.buffer, at, numbers.length).set(numbers);
    return at;
  }

  /** A copy of numbers. @param {number} at @param {number} count @returns {Float64Array} */
  doubles(at, count) {
    return new Float64Array(this.buffer, at, count).slice();
  }

  /** A text of C. @param {number} at @returns {string} */
  text(at) {
    const bytes = new Uint8Array(this.buffer, at);
    return String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Bytes of a value of a type. @param {string} type @returns {number} */
  sizeOf(type) {
    return SIZES[type] ?? this.structs[type]?.size ?? 4;
  }

  /** Reads a value. @param {string} type @param {number} at @returns {Value} */
  readOne(type, at) {
    if (type === 'double') {
      return this.view.getFloat64(at, true);
    }
    if (type === 'bool') {
      return this.view.getUint8(at) !== 0;
    }
    if (type in this.structs) {
      return this.readStruct(type, at);
    }
    const number = type === 'int' ? this.view.getInt32(at, true) : this.view.getUint32(at, true);
    return type in this.enums ? wordOf(this.enums[type], number) : number;
  }

  /** Writes a value. @param {string} type @param {number} at @param {unknown} value @param {string} name for errors */
  writeOne(type, at, value, name) {
    if (type === 'double') {
      this.view.setFloat64(at, numberOf(value, name), true);
    } else if (type === 'bool') {
      this.view.setUint8(at, value ? 1 : 0);
    } else if (type === 'int') {
      this.view.setInt32(at, intOf(value, name), true);
    } else {
      this.view.setUint32(at, type in this.enums ? valueOf(this.enums[type], value, name) : countOf(value, name), true);
    }
  }

  /** Numbers or structs that follow each other. */
  readMany(type, at, count) {
    if (type === 'double') {
      return this.doubles(at, count);
    }
    return Array.from({ length: count }, (_, i) => this.readOne(type, at + i * this.sizeOf(type)));
  }

  /** Pointers are left out, but for those with a count before them. */
  readStruct(type, at) {
    const found = {};
    let count = 0;
    for (const { name, type: of, room, at: offset } of this.structs[type].fields) {
      if (of.endsWith('*')) {
        const from = this.view.getUint32(at + offset, true);
        const bare = of.replace(/const |[ *]/g, '');
        if (from && this.structs[bare]) {
          found[camel(name)] = this.readMany(bare, from, count);
        }
      } else if (room) {
        found[camel(name)] = this.readMany(of, at + offset, room);
      } else {
        const value = this.readOne(of, at + offset);
        if (of === 'size_t' && /(^|_)count$/.test(name)) {
          count = value;
        } else if (name !== 'size') {
          found[camel(name)] = value;
        }
      }
    }
    return found;
  }
}

/** A name of C as one of JavaScript: max_error is maxError. @param {string} name @returns {string} */
export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());

/** A value that has to be a number. @param {unknown} value @param {string} name for errors @returns {number} */
export function numberOf(value, name) {
  if (typeof value !== 'number') {
    throw new BattenError('argument', `${name} is not a number`);
  }
  return value;
}

/** A value that has to be a whole number of 32 bits. @param {unknown} value @param {string} name for errors @returns {number} */
export function intOf(value, name) {
  if (!Number.isInteger(value) || Math.abs(value) > 0x7fffffff) {
    throw new BattenError('argument', `${name} is not a whole number`);
  }
  return value;
}

/** A value that has to be a number of things. @param {unknown} value @param {string} name for errors @returns {number} */
export function countOf(value, name) {
  if (!Number.isInteger(value) || value < 0 || value > 1 << 28) {
    throw new BattenError('count', `${name} is not a number of things`);
  }
  return value;
}

/** The number of a word. @param {Record<string, number>} words @param {unknown} value @param {string} name for errors @returns {number} */
export function valueOf(words, value, name) {
  if (!Object.hasOwn(words, value)) {
    throw new BattenError('argument', `${name} is one of ${Object.keys(words).join(', ')}`);
  }
  return words[value];
}

/** The word of a number. @param {Record<string, number>} words @param {number} number @returns {string | undefined} */
function wordOf(words, number) {
  return Object.keys(words).find((word) => words[word] === number);
}
