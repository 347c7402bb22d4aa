// Batten in JavaScript: load() gives the library. The methods of the classes come from calls.txt (calls.js); here are those that it
// cannot describe, and who owns what.
import calls from './calls.js';
import { Call, prepare } from './call.js';
import { BattenError } from './error.js';
import { Memory, Numbers } from './memory.js';
import { PathText, trace } from './path.js';

export { BattenError, Numbers };

const dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** Frees what nobody holds any more. */
const lost = new FinalizationRegistry((/** @type {{ free: Function, at: number }} */ { free, at }) => free(at));

class Handle {
  #at;

  constructor(library, at, dim) {
    this.#at = at;
    Object.defineProperty(this, 'library', { value: library });
    Object.defineProperty(this, 'dim', { value: dim });
    lost.register(this, { free: library.memory.exports[calls.frees[this.kind]], at }, this);
  }

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

  free() {
    if (this.#at) {
      this.library.memory.exports[calls.frees[this.kind]](this.#at);
      this.gone();
    }
  }

  [dispose]() {
    this.free();
  }
}

export class Curve extends Handle {
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

  /** @template {import('./index.js').PathLike} P @param {P} path a Path2D, a canvas' context, or whatever has moveTo, bezierCurveTo and closePath @returns {P} */
  trace(path, { tolerance = 0.01 } = {}) {
    return trace(this.toCubics({ tolerance }), this.dimension, this.closed, path);
  }

  toPath2D(options = {}) {
    return this.trace(new globalThis.Path2D(), options);
  }

  /** SVG path data. */
  toSVG({ tolerance = 0.01, decimals = 3 } = {}) {
    return String(this.trace(new PathText(decimals), { tolerance }));
  }
}

export class Finder extends Handle {
  get kind() {
    return 'Finder';
  }

  free() {
    super.free();
    this.own?.free();
  }
}

export class Chain extends Handle {
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

export class Shape extends Handle {
  get kind() {
    return 'Shape';
  }
}

export class LiveShape extends Handle {
  get kind() {
    return 'LiveShape';
  }
}

export class LiveSketch extends Handle {
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
    const exports = /** @type {any} */ (instance.exports);
    this.memory = new Memory(exports, calls.structs, calls.enums);
    this.classes = calls.classes;
    exports._initialize?.();
  }

  get version() {
    return this.memory.text(this.memory.exports.bat_version());
  }

  /** Numbers in the module's memory, for arguments and results (`into`) that are not copied. @param {number} length */
  array(length) {
    return new Numbers(this.memory, length);
  }

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

/** Vite's dev server bundles packages into a folder of its own, without the files beside them: there, the package's own address. */
const beside = (url) => new URL(url.href.replace(/\/node_modules\/\.(?:vite|cache)\/.*\/(?=[^/]*$)/, '/node_modules/batten-core/'));

async function moduleOf(source) {
  if (source instanceof WebAssembly.Module) {
    return source;
  }
  if (ArrayBuffer.isView(source) || source instanceof ArrayBuffer) {
    return WebAssembly.compile(source);
  }
  const url = new URL(source, globalThis.location?.href ?? import.meta.url);
  if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) {
    throw new BattenError('state', `${url}: ${response.status} ${response.statusText}`);
  }
  const bytes = await response.arrayBuffer();
  if (bytes.byteLength < 4 || new DataView(bytes).getUint32(0) !== 0x0061736d) {
    throw new BattenError('state', `${url} is no WebAssembly but ${response.headers.get('content-type')}: where the module is, load({ wasm }) says`);
  }
  return WebAssembly.compile(bytes);
}

/** The modules by the word of `small`; each address in full, since bundlers look for such. */
const MODULES = {
  false: () => new URL('./batten.wasm', import.meta.url),
  true: () => new URL('./batten-sketch.wasm', import.meta.url),
  sketch: () => new URL('./batten-sketch.wasm', import.meta.url),
  levels: () => new URL('./batten-levels.wasm', import.meta.url),
};

/**
 * Loads the library.
 * @param {{ small?: boolean | 'sketch' | 'levels', wasm?: string | URL | BufferSource | WebAssembly.Module }} [options] small: curves
 *   and fits with the sketch hand alone ('sketch', true), or with points with directions and levels ('levels'), in less than half
 *   the bytes; wasm: where the module is, or the module itself, in place of that of the package
 */
export async function load({ small = false, wasm } = {}) {
  if (!Object.hasOwn(MODULES, String(small))) {
    throw new BattenError('argument', `small is true, 'sketch' or 'levels', not ${small}`);
  }
  return new Batten(await WebAssembly.instantiate(await moduleOf(wasm ?? beside(MODULES[String(small)]())), {}));
}
