// The library's classes. Their methods come from calls.txt (calls.js); here are those that it cannot describe, and who owns what.
import calls from './calls.js';
import { Call, prepare } from './call.js';
import { BattenError } from './error.js';
import { Memory, Numbers } from './memory.js';
import { PathText, trace } from './path.js';

export { BattenError, Numbers };

const dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** Frees what nobody holds any more. */
const lost = new FinalizationRegistry((/** @type {{ free: Function, at: number }} */ { free, at }) => free(at));

/** An object in the module's memory, which is freed by free(), by `using`, or when nobody holds it any more. */
class Handle {
  #at;

  constructor(library, at, dim) {
    this.#at = at;
    Object.defineProperty(this, 'library', { value: library });
    Object.defineProperty(this, 'dim', { value: dim });
    lost.register(this, { free: library.memory.exports[calls.frees[this.kind]], at }, this);
  }

  /** Its address; throws when it has been freed. @returns {number} */
  get at_() {
    if (!this.#at) {
      throw new BattenError('state', `this ${this.kind} has been freed`);
    }
    return this.#at;
  }

  /** The call that has just been made freed it. */
  gone() {
    this.#at = 0;
    lost.unregister(this);
  }

  /** Gives its memory back at once. */
  free() {
    if (this.#at) {
      this.library.memory.exports[calls.frees[this.kind]](this.#at);
      this.gone();
    }
  }

  /** As free(): for `using`. */
  [dispose]() {
    this.free();
  }
}

/** A B-spline curve. */
export class Curve extends Handle {
  /** The name of its class. */
  get kind() {
    return 'Curve';
  }

  /** Frames at n places, or at parameters: arrays of three numbers each. @param {number | ArrayLike<number>} n */
  frames(n, options = {}) {
    const chain = this.frameChain(options);
    try {
      const u = typeof n === 'number' ? this.spread(n) : Float64Array.from(n);
      return { u, ...chain.many(u) };
    } finally {
      chain.free();
    }
  }

  /** A finder looks at the curve it is made of, so it keeps one of its own. */
  finder() {
    const own = this.copy();
    const finder = own.finder_();
    Object.defineProperty(finder, 'own', { value: own });
    return finder;
  }

  /** @template {import('./library.js').PathLike} P @param {P} path a Path2D, a canvas' context, or whatever has moveTo, bezierCurveTo and closePath @returns {P} */
  trace(path, { tolerance = 0.01 } = {}) {
    return trace(this.toCubics({ tolerance }), this.dimension, this.closed, path);
  }

  /** The curve as a path for a canvas. @param {{ tolerance?: number }} options */
  toPath2D(options = {}) {
    return this.trace(new globalThis.Path2D(), options);
  }

  /** SVG path data. */
  toSVG({ tolerance = 0.01, decimals = 3 } = {}) {
    return String(this.trace(new PathText(decimals), { tolerance }));
  }
}

/** Finds the nearest places of a curve. */
export class Finder extends Handle {
  /** The name of its class. */
  get kind() {
    return 'Finder';
  }

  /** Gives its memory back at once. */
  free() {
    super.free();
    this.own?.free();
  }
}

/** Rotation-minimising frames along a curve. */
export class Chain extends Handle {
  /** The name of its class. */
  get kind() {
    return 'Chain';
  }

  /** Frames at many parameters. @param {ArrayLike<number>} u */
  many(u) {
    const { memory } = this.library;
    const count = u.length;
    return memory.during(() => {
      const from = memory.place(Float64Array.from(u));
      const names = ['point', 't', 's', 'r'];
      const arrays = memory.borrow(16);
      const places = names.map((_, i) => {
        const place = memory.borrow(24 * count);
        memory.view.setUint32(arrays + 4 * i, place, true);
        return place;
      });
      this.library.check(memory.exports.bat_frame_chain_many(this.at_, count, from, arrays));
      return Object.fromEntries(names.map((name, i) => [name, memory.doubles(places[i], 3 * count)]));
    });
  }
}

/** A curve with levels of detail. */
export class Shape extends Handle {
  /** The name of its class. */
  get kind() {
    return 'Shape';
  }
}

/** An edit of a shape while the pen is down. */
export class LiveShape extends Handle {
  /** The name of its class. */
  get kind() {
    return 'LiveShape';
  }
}

/** A stroke while the pen is down. */
export class LiveSketch extends Handle {
  /** The name of its class. */
  get kind() {
    return 'LiveSketch';
  }

  /** Adds a sample: its coordinates. @param {...number} place */
  add(...place) {
    return this.addMany(place);
  }
}

const CLASSES = { Curve, Finder, Chain, Shape, LiveShape, LiveSketch };

/** The library, loaded. */
export class Batten {
  /** @param {WebAssembly.Instance} instance */
  constructor(instance) {
    const exports = /** @type {Record<string, Function>} */ (instance.exports);
    this.memory = new Memory(exports, calls.structs, calls.enums);
    this.classes = calls.classes;
    exports._initialize?.();
  }

  /** The library's version. @returns {string} */
  get version() {
    return this.memory.text(this.memory.exports.bat_version());
  }

  /** Numbers in the module's memory, for arguments and results (`into`) that are not copied. @param {number} length */
  array(length) {
    return new Numbers(this.memory, length);
  }

  /** The object at an address. @param {string} kind its class @param {number} at @param {number} dim */
  make(kind, at, dim) {
    return new CLASSES[kind](this, at, dim);
  }

  /** The address of an object of a class, which must be alive and of this library. */
  handleOf(value, kind, name) {
    if (!(value instanceof CLASSES[kind]) || value.library !== this) {
      throw new BattenError('argument', `${name} is no ${kind} of this library`);
    }
    return value.at_;
  }

  /** A copy of what another object owns. */
  copied(type, at, dim) {
    const { memory } = this;
    return memory.during(() => {
      const cell = memory.borrow(4);
      this.check(memory.exports[`${type}_copy`](at, cell));
      return this.make(this.classes[type], memory.view.getUint32(cell, true), dim);
    });
  }

  /** Throws unless a status is ok. @param {number} status */
  check(status) {
    if (status !== 0) {
      throw new BattenError(Object.keys(calls.enums.bat_status)[status], this.memory.text(this.memory.exports.bat_status_message(status)));
    }
  }
}

/** Puts the calls where their names say. */
for (const call of calls.calls) {
  const plan = prepare(call, calls.structs);
  for (const called of call.names) {
    const [kind, name] = called.replace('()', '').split('.');
    const target = kind === 'b' ? Batten.prototype : CLASSES[kind].prototype;
    const plain = plan.parsed.every(({ kind: what }) => what === 'self' || what === 'result');
    const makes = plan.parsed.some(({ kind: what, bare }) => what === 'result' && bare in calls.classes) || plan.returns.includes('bat_shape *');
    const run = function run(...given) {
      const library = kind === 'b' ? this : this.library;
      if (!(call.c in library.memory.exports)) {
        throw new BattenError('unsupported', `${name} is not in this small module: load() brings all`);
      }
      return new Call(library, plan, kind === 'b' ? null : this, given).run();
    };
    const isProperty = kind !== 'b' && plain && !makes && !called.endsWith('()') && call.c !== 'bat_shape_commit';
    const placed = Object.hasOwn(target, name) ? `${name}_` : name; // written by hand, above
    Object.defineProperty(target, placed, isProperty ? { get: run, configurable: true } : { value: run, configurable: true, writable: true });
  }
}
