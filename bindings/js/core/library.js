// The library's classes. Their methods come from calls.txt (core.js); here are those that it cannot describe, and who owns what.
import { Call } from './call.js';
import core from './core.js';
import { BattenError, shown, wrong } from './error.js';
import { converted, listOf, numbersOf, optionsOf } from './given.js';
import { Memory, Numbers } from './memory.js';
import { PathText, trace } from './path.js';
import { prepare } from './plan.js';
import { Structs } from './structs.js';

export { BattenError, Numbers };

/** What is known of the library: structs, enums, classes; kinds: the classes of JavaScript, by name; why: what each status means of a call. */
export const tables = { structs: {}, inits: {}, enums: {}, classes: {}, frees: {}, kinds: {}, why: {}, rules: core.rules };

const inspect = Symbol.for('nodejs.util.inspect.custom');
const dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** Frees what nobody holds any more. */
const lost = new FinalizationRegistry((/** @type {{ free: Function, at: number }} */ { free, at }) => free(at));

/** An object in the module's memory, which is freed by free(), by `using`, or when nobody holds it any more. */
export class Handle {
  #at;
  #owned = [];

  constructor(library, at, dim) {
    if (!(library instanceof Batten)) {
      throw new TypeError(`a ${this.kind_} is made by a function of the library that load() gives`);
    }
    this.#at = at;
    Object.defineProperty(this, 'library', { value: library });
    Object.defineProperty(this, 'dim', { value: dim });
    lost.register(this, { free: library.memory.exports[tables.frees[this.kind_]], at }, this);
  }

  /** Its address; throws when it has been freed. @returns {number} */
  get at_() {
    if (!this.#at) {
      throw new BattenError('state', `this ${this.kind_} has been freed`);
    }
    return this.#at;
  }

  /** Whether it has been freed. */
  get isFree_() {
    return !this.#at;
  }

  /** What consoles show. */
  toString() {
    return `<${this.kind_}${this.#at ? '' : ', freed'}>`;
  }

  /** As toString(): for the console of Node. */
  [inspect]() {
    return this.toString();
  }

  /** For JSON.stringify: what the function that reads such an object reads. */
  toJSON() {
    if (typeof this.write !== 'function' || this.kind_ === 'Motion') {
      throw new BattenError('unsupported', `a ${this.kind_} has no JSON`);
    }
    return JSON.parse(this.write());
  }

  /** The call that has just been made freed it. */
  gone() {
    this.#at = 0;
    lost.unregister(this);
  }

  /** Keeps copies of what it looks at. @template T @param {T} owned @returns {this} */
  keep_(...owned) {
    this.#owned.push(...owned);
    return this;
  }

  /** Gives its memory back at once. */
  free() {
    if (this.#at) {
      this.library.memory.exports[tables.frees[this.kind_]](this.#at);
      this.gone();
      this.#owned.forEach((one) => one.free());
    }
  }

  /** As free(): for `using`. */
  [dispose]() {
    this.free();
  }
}

/** A B-spline curve. */
export class Curve extends Handle {
  /** Frames at n places, or at parameters: arrays of three numbers each. @param {number | ArrayLike<number>} n */
  frames(n, options = {}) {
    const chain = this.frameChain(options);
    try {
      const u = typeof n === 'number' ? this.spread(n) : Float64Array.from(listOf(numbersOf(n, 1, 'n')));
      return { u, ...chain.many(u) };
    } finally {
      chain.free();
    }
  }

  /** A finder looks at the curve it is made of, so it keeps one of its own. */
  finder() {
    const own = this.copy();
    return own.finder_().keep_(own);
  }

  /** @template {import('./library.js').PathLike} P @param {P} path a Path2D, a canvas' context, or whatever has moveTo, bezierCurveTo and closePath @param {{ tolerance?: number } | null} [given] @returns {P} */
  trace(path, given) {
    const { tolerance = 0.01 } = optionsOf([path, given], ['path'], ['tolerance'], 'trace');
    if (typeof path?.moveTo !== 'function' || typeof path.bezierCurveTo !== 'function' || typeof path.closePath !== 'function') {
      throw wrong('path', 'what has moveTo, bezierCurveTo and closePath', shown(path));
    }
    return trace(this.toCubics({ tolerance }), this.dimension, this.closed, path);
  }

  /** The curve as a path for a canvas. @param {{ tolerance?: number }} options */
  toPath2D(options = {}) {
    if (!globalThis.Path2D) {
      throw new BattenError('unsupported', 'toPath2D: there is no Path2D here; trace(path) takes whatever has its methods');
    }
    return this.trace(new globalThis.Path2D(), options);
  }

  /** SVG path data. @param {{ tolerance?: number, decimals?: number } | null} [given] */
  toSVG(given) {
    const { tolerance = 0.01, decimals = 3 } = optionsOf([given], [], ['tolerance', 'decimals'], 'toSVG');
    return String(this.trace(new PathText(converted(this.library.tables, 'int', decimals, 'decimals')), { tolerance }));
  }

  /** As toString() of what is not freed. */
  toString() {
    return this.isFree_ ? super.toString() : `<Curve of degree ${this.degree}, ${this.count} points${this.closed ? ', closed' : ''}>`;
  }

  /** For JSON.stringify: what readCurve reads. */
  toJSON() {
    const { degree, closed, dimension, points } = this;
    return { degree, closed, knots: [...this.knots], points: Array.from({ length: this.count }, (_, i) => [...points.subarray(i * dimension, (i + 1) * dimension)]) };
  }
}

/** Finds the nearest places of a curve. */
export class Finder extends Handle {}

/** Rotation-minimising frames along a curve. */
export class Chain extends Handle {
  /** Frames at many parameters. @param {ArrayLike<number>} u */
  many(u) {
    const { memory } = this.library;
    return memory.during(() => {
      const [from, count] = this.library.structs.row('double', u, 'u');
      const names = ['point', 't', 's', 'r'];
      const arrays = memory.borrow(16);
      const places = names.map((_, i) => {
        const place = memory.borrow(24 * count);
        memory.view.setUint32(arrays + 4 * i, place, true);
        return place;
      });
      this.library.check_(memory.exports.bat_frame_chain_many(this.at_, count, from, arrays));
      return Object.fromEntries(names.map((name, i) => [name, memory.doubles(places[i], 3 * count)]));
    });
  }
}

/** A curve with levels of detail. */
export class Shape extends Handle {
  /** How many levels there are. @returns {number} */
  get levels_() {
    return this.levels;
  }

  /** How many control points a level has. @param {number} level @returns {number} */
  countOf_(level) {
    return this.curve(level).count;
  }
}

/** An edit of a shape while the pen is down. */
export class LiveShape extends Handle {
  /** How many levels the shape has. @returns {number} */
  get levels_() {
    const { exports } = this.library.memory;
    return exports.bat_shape_levels(exports.bat_shape_live_shape(this.at_));
  }
}

/** A stroke while the pen is down. */
export class LiveSketch extends Handle {
  /** Adds a sample: its coordinates. @param {...number} place */
  add(...place) {
    return this.addMany(place);
  }
}

/** The library, loaded. */
export class Batten {
  /** @param {WebAssembly.Instance} instance @param {typeof tables} known */
  constructor(instance, known) {
    const exports = /** @type {Record<string, Function>} */ (instance.exports);
    this.memory = new Memory(exports, known.structs, known.enums);
    this.tables = known;
    this.structs = new Structs(this);
    exports._initialize?.();
  }

  /** What the console of Node shows. */
  [inspect]() {
    return `<Batten ${this.version}>`;
  }

  /** The library's version. @returns {string} */
  get version() {
    return this.memory.text(this.memory.exports.bat_version());
  }

  /** Numbers in the module's memory, for arguments and results (`into`) that are not copied. @param {number} length */
  array(length) {
    return new Numbers(this.memory, length);
  }

  /** The object at an address. @param {string} kind its class @param {number} at @param {number} [dim] of what it was made of */
  make_(kind, at, dim) {
    const { exports } = this.memory;
    const curve = kind === 'Curve' ? at : kind === 'Shape' ? exports.bat_shape_curve(at, 0) : 0; // which knows it better
    return new tables.kinds[kind](this, at, curve ? exports.bat_curve_dimension(curve) : CURVED.includes(kind) ? dim : undefined);
  }

  /** The address of an object of a class, which must be alive and of this library. */
  handleOf_(value, kind, name) {
    if (!(value instanceof tables.kinds[kind])) {
      throw wrong(name, `${/^[AEIO]/.test(kind) ? 'an' : 'a'} ${kind}`, shown(value));
    }
    if (value.library !== this) {
      throw wrong(name, `a ${kind} of this library`, 'one of another load()');
    }
    return value.at_;
  }

  /** An object of its own for one that something else owns: a copy, or a user more. */
  copied_(type, at, dim) {
    const { memory } = this;
    const kind = tables.classes[type];
    const retain = memory.exports[`${type}_retain`];
    if (retain) {
      retain(at);
      return this.make_(kind, at, dim);
    }
    return memory.during(() => {
      const cell = memory.borrow(4);
      this.check_(memory.exports[`${type}_copy`](at, cell));
      return this.make_(kind, memory.view.getUint32(cell, true), dim);
    });
  }

  /** Throws unless a status is ok. @param {number} status @param {string} [told] what the call said of it */
  check_(status, told = '') {
    if (status !== 0) {
      throw new BattenError(Object.keys(tables.enums.bat_status)[status], told || this.memory.text(this.memory.exports.bat_status_message(status)));
    }
  }
}

/** Puts the calls of a part of the table where their names say; what is written by hand stays, and finds them behind a name with _. */
export function install(part, kinds) {
  ['structs', 'inits', 'enums', 'classes', 'frees', 'why'].forEach((name) => Object.assign(tables[name], part[name]));
  Object.assign(tables.kinds, kinds);
  for (const [name, kind] of Object.entries(kinds)) {
    Object.defineProperty(kind.prototype, 'kind_', { value: name });
  }
  part.calls.forEach(attach);
  return tables;
}

/** Puts a call where its names say. @param {import('./plan.js').Description} call */
function attach(call) {
  const plan = prepare(call, tables);
  const plain = plan.parsed.every(({ kind: what }) => what === 'self' || what === 'result');
  const makes = plan.parsed.some(({ kind: what, bare }) => what === 'result' && bare in tables.classes) || plan.returns.endsWith('*') && plan.returns.replace(/const|[ *]/g, '') in tables.classes;
  for (const called of call.names) {
    const [kind, name] = called.replace('()', '').split('.');
    const target = kind === 'b' ? Batten.prototype : tables.kinds[kind].prototype;
    const run = function run(...given) {
      const library = kind === 'b' ? this : this.library;
      if (!(call.c in library.memory.exports)) {
        throw new BattenError('unsupported', `${name} is not in this small module: load() brings all`);
      }
      return new Call(library, plan, kind === 'b' ? null : this, given).run();
    };
    const isProperty = kind !== 'b' && plain && !makes && !called.endsWith('()') && call.c !== 'bat_shape_commit';
    const placed = name[0] === '_' ? `${name.slice(1)}_` : Object.hasOwn(target, name) ? `${name}_` : name;
    Object.defineProperty(target, placed, isProperty ? { get: run, configurable: true } : { value: run, configurable: true, writable: true });
  }
}

const CORE = { Curve, Finder, Chain, Shape, LiveShape, LiveSketch };
const CURVED = Object.keys(CORE);
install(core, CORE);
