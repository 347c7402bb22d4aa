// The module's memory: places for arguments and results, which are given back after each call.
import { BattenError, shown, wrong } from './error.js';

/** A member of a struct of C: `at` bytes from its begin; `room`: how many numbers it has, where it is an array; `counted`: the member that
 * says how many; `counts`: whether it is such a member.
 * @typedef {{ name: string, type: string, room: number, at: number, counted?: string, counts: boolean }} Field */
/** @typedef {{ size: number, fields: Field[] }} Struct */
/** The words of each enumeration, and their numbers. @typedef {Record<string, Record<string, number>>} Enums */
/** What is read from memory. @typedef {number | boolean | string | undefined | Float64Array | object} Value */

const SIZES = { double: 8, int: 4, size_t: 4, bool: 1, char: 1, uint32_t: 4, uint64_t: 8, bat_id: 8 };
/** Numbers that results have as an array of their own kind. */
const ARRAYS = { double: Float64Array, int: Int32Array, size_t: Uint32Array };

/** A type of C without const and pointers. @param {string} type */
export const bareOf = (type) => type.replace(/const|[ *]/g, '');

/** Frees the numbers that nobody holds any more. */
const lost = new FinalizationRegistry((/** @type {{ exports: Record<string, Function>, at: number }} */ { exports, at }) => exports.free(at));

/** Numbers in the module's memory, which calls read and write where they are. */
export class Numbers {
  #memory;
  #at;

  /** @param {Memory} memory @param {number} length */
  constructor(memory, length) {
    if (!(Number.isInteger(length) && length > 0 && length <= 1 << 28)) {
      throw wrong('length', '1 to 2^28 numbers', shown(length), 'count');
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

  /** Text or bytes as C has them, with a NUL behind. @param {Uint8Array} bytes @returns {number} */
  placeBytes(bytes) {
    const at = this.borrow(bytes.length + 1);
    new Uint8Array(this.buffer, at, bytes.length).set(bytes);
    return at;
  }

  /** A list of addresses as C has it. @param {number[]} list @returns {number} */
  placeList(list) {
    const at = this.borrow(4 * list.length);
    list.forEach((one, i) => this.view.setUint32(at + 4 * i, one, true));
    return at;
  }

  /** A text of C. @param {number} at @returns {string} */
  text(at) {
    const bytes = new Uint8Array(this.buffer, at);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  /** Bytes of a value of a type. @param {string} type @returns {number} */
  sizeOf(type) {
    return SIZES[type] ?? this.structs[type]?.size ?? 4;
  }

  /** Reads a number, truth or word. @param {string} type @param {number} at @returns {Value} */
  readOne(type, at) {
    switch (type) {
      case 'double': return this.view.getFloat64(at, true);
      case 'bool': return this.view.getUint8(at) !== 0;
      case 'int': return this.view.getInt32(at, true);
      case 'bat_id': return Number(this.view.getBigUint64(at, true));
      case 'uint64_t': return this.view.getBigUint64(at, true);
      default: {
        const number = this.view.getUint32(at, true);
        return type in this.enums ? wordOf(this.enums[type], number) : number;
      }
    }
  }

  /** Writes a number, truth or word. @param {string} type @param {number} at @param {number} value as C takes it */
  writeOne(type, at, value) {
    if (type === 'double') {
      this.view.setFloat64(at, value, true);
    } else if (type === 'bool') {
      this.view.setUint8(at, value);
    } else if (SIZES[type] === 8) {
      this.view.setBigUint64(at, BigInt(value), true);
    } else {
      this.view.setUint32(at, value, true);
    }
  }

  /** A copy of numbers that follow each other, in an array of their kind where there is one. */
  readMany(type, at, count) {
    if (type in ARRAYS) {
      return new ARRAYS[type](this.buffer, at, count).slice();
    }
    return Array.from({ length: count }, (_, i) => this.readOne(type, at + i * this.sizeOf(type)));
  }
}

/** A name of C as one of JavaScript: max_error is maxError. @param {string} name @returns {string} */
export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());

/** The word of a number. @param {Record<string, number>} words @param {number} number @returns {string | undefined} */
export function wordOf(words, number) {
  return Object.keys(words).find((word) => words[word] === number);
}
