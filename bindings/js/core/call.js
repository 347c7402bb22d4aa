// Calls of C as calls.txt describes them: arguments are placed in memory, the function is called, results are read.
import { BattenError, STATUSES } from './error.js';
import { dimensionOf, evaluate, isNumbers, numbersOf } from './given.js';
import { camel, countOf, intOf, Numbers, numberOf, valueOf } from './memory.js';

/** A call as calls.txt describes it. @typedef {{ c: string, names: string[], args: [string, string][], returns: string, returned?: string }} Description */
/** An argument of C: what kind it is of, its type with and without pointers, and what its word says of it.
 * @typedef {{ word: string, type: string, bare: string, kind: string, name: string, formula?: string, missing?: string, least?: string, optional?: boolean,
 *   whole?: boolean, handed?: boolean, back?: boolean, ends?: boolean }} Argument */
/** @typedef {Description & { parsed: Argument[], positional: Argument[], options: Set<string>, writes: Argument | null }} Plan */
/** A result: where it is, and how many. @typedef {Argument & { at: number, count: number, isHandle: boolean, into: Numbers | null }} Result */

/** A type of C without const and pointers. @param {string} type */
const bareOf = (type) => type.replace(/const|[ *]/g, '');
const LITERALS = { false: false, true: true, inf: Infinity };

/** A word of calls.txt, taken apart. */
function parse([word, type]) {
  const found = { word, type, bare: bareOf(type) };
  const is = (kind, more) => ({ ...found, kind, ...more });
  if (/^@/.test(word)) {
    return is('self', { ends: word === '@!' });
  }
  if (word === 'dim' || word === 'null') {
    return is(word);
  }
  let match;
  if ((match = /^=(.+)/.exec(word))) {
    return is('follows', { formula: match[1] });
  }
  if ((match = /^[#%](\w+)/.exec(word))) {
    return is(word[0] === '#' ? 'count' : 'room', { name: match[1] });
  }
  if ((match = /^\((\w+)\)|^\{(>?)(\w+)\}/.exec(word))) {
    return is(match[1] ? 'struct' : 'options', { name: match[1] ?? match[3], back: Boolean(match[2]) });
  }
  if ((match = /^>(\w+)(\*?)(?:\[(.*)\])?/.exec(word))) {
    return is('result', { name: match[1], handed: Boolean(match[2]), formula: match[3] });
  }
  if ((match = /^(\w+)\[(=?)(.*)\](\??)/.exec(word))) {
    return is('array', { name: match[1], whole: Boolean(match[2]), formula: match[3], optional: Boolean(match[4]) });
  }
  match = /** @type {RegExpExecArray} */ (/^(\w+)(?:=(.+)|:(\d))?/.exec(word));
  return is('scalar', { name: match[1], missing: match[2], least: match[3] });
}

/** What a call of calls.txt needs, found once. @param {Description} call @param {Record<string, import('./memory.js').Struct>} structs @returns {Plan} */
export function prepare(call, structs) {
  const args = call.args.map(parse);
  const has = (arg) => ['scalar', 'array', 'struct'].includes(arg.kind);
  const isOptional = (arg) => arg.optional || arg.missing !== undefined;
  const options = new Set(args.filter((arg) => has(arg) && isOptional(arg)).map((arg) => camel(arg.name)));
  for (const { kind, bare } of args) {
    if (kind === 'options' || kind === 'struct') {
      structs[bare].fields.forEach(({ name }) => options.add(camel(name)));
    }
  }
  options.add('dimension');
  const written = args.filter(({ kind, bare, formula, handed }) => kind === 'result' && bare === 'double' && formula !== undefined && !handed);
  if (written.length === 1) {
    options.add('into');
  }
  return { ...call, writes: written.length === 1 ? written[0] : null, parsed: args, options, positional: args.filter((arg) => has(arg) && !isOptional(arg)) };
}

/** One call: its arguments by name, and the results that it is to bring. */
export class Call {
  /** @param {import('./library.js').Batten} library @param {Plan} plan @param {import('./library.js').Curve | null} self or an object of another class
   * @param {unknown[]} given what the caller gives */
  constructor(library, plan, self, given) {
    Object.assign(this, { library, plan, self, memory: library.memory });
    this.values = new Map();
    this.results = [];
    plan.positional.forEach((arg, i) => this.values.set(arg.name, given[i]));
    this.options = given[plan.positional.length] ?? {};
    for (const name of Object.keys(this.options)) {
      if (!plan.options.has(name)) {
        throw new BattenError('argument', `${camel(plan.names[0].split('.')[1])} has no option ${name}`);
      }
    }
    for (const arg of plan.parsed) {
      if ((arg.missing !== undefined || arg.optional) && !this.values.has(arg.name)) {
        this.values.set(arg.name, this.options[camel(arg.name)]);
      }
    }
    this.dimension = this.#dimension();
  }

  /** The dimension: of the object, as an option says, or as the points show it. @returns {number} */
  #dimension() {
    const arrays = this.plan.parsed.filter(({ kind, formula, name }) => (kind === 'array' && /dim/.test(formula)) || (kind === 'struct' && name !== 'regions'));
    const [first] = arrays.map(({ name }) => this.values.get(name));
    const points = isNumbers(first) ? first : first?.points;
    const vector = arrays[0]?.whole && arrays[0].formula === 'dim' ? points?.length : undefined;
    return this.self?.dim ?? this.options.dimension ?? dimensionOf(points) ?? vector ?? 2;
  }

  /** What a name in a formula stands for. */
  #look = (name) => {
    if (name === 'dim') {
      return this.dimension;
    }
    if (name[0] === '#') {
      return this.#records(name.slice(1));
    }
    if (name === 'level_count') {
      return this.self.curve(this.values.get('level')).count;
    }
    return this.values.get(name) ?? this.self[camel(name)];
  };

  /** How many records an argument has: points, or what its formula says. @param {string} name @returns {number} */
  #records(name) {
    const value = this.values.get(name);
    const arg = this.plan.parsed.find((one) => one.name === name && (one.kind === 'array' || one.kind === 'struct'));
    if (value === undefined || value === null) {
      if (arg.optional) {
        return 0;
      }
      throw new BattenError('argument', `${name} is missing`);
    }
    if (arg.kind === 'struct') {
      return arg.name === 'regions' ? value.length : numbersOf(isNumbers(value) ? value : value.points, this.dimension, name).length / this.dimension;
    }
    const numbers = numbersOf(value, this.dimension, name);
    return numbers.length / (arg.whole ? 1 : evaluate(arg.formula, this.#look));
  }

  /** A number, truth, word or handle, as C takes it. @param {Argument} arg @returns {number} */
  #scalar({ name, missing, least, type, bare }) {
    let value = this.values.get(name);
    if (value === undefined && missing !== undefined) {
      const ends = { start: 0, end: 1 };
      value = missing in ends ? this.self.domain[ends[missing]] : missing in LITERALS ? LITERALS[missing] : Number.isNaN(Number(missing)) ? missing : Number(missing);
      this.values.set(name, value);
    }
    if (bare in this.library.classes) {
      return this.library.handleOf(value, this.library.classes[bare], name);
    }
    if (least !== undefined && !(value >= Number(least) && value <= this.#levels())) {
      throw new BattenError('argument', `there is no level ${value}`);
    }
    if (bare in this.memory.enums) {
      return valueOf(this.memory.enums[bare], value, name);
    }
    return type === 'double' ? numberOf(value, name) : type === 'bool' ? Number(Boolean(value)) : type === 'size_t' ? countOf(value, name) : intOf(value, name);
  }

  /** How many levels the shape has that this is, or is an edit of. @returns {number} */
  #levels() {
    return this.self.levels ?? this.memory.exports.bat_shape_levels(this.memory.exports.bat_shape_live_shape(this.self.at_));
  }

  /** Places numbers in memory. @param {Argument} arg @returns {number} their address; 0: none were given */
  #array({ name, whole, formula, optional }) {
    const value = this.values.get(name);
    if (optional && (value === undefined || value === null)) {
      return 0;
    }
    const numbers = numbersOf(value, this.dimension, name);
    const size = evaluate(formula, this.#look);
    if (whole ? numbers.length !== size : numbers.length % size !== 0) {
      throw new BattenError('count', `${name} has ${numbers.length} numbers${whole ? `, not ${size}` : `, in points of ${size}`}`);
    }
    return this.memory.place(numbers);
  }

  /** Writes a field and, before it, its count or the truth that it is there. */
  #field(at, fields, field, value, dimension) {
    const { memory } = this;
    const i = fields.indexOf(field);
    if (field.type.endsWith('*')) {
      const numbers = numbersOf(value, dimension, field.name);
      const ints = field.bare === 'int';
      const place = ints ? memory.borrow(4 * numbers.length) : memory.place(numbers);
      if (ints) {
        Array.from(numbers, (one, k) => memory.writeOne('int', place + 4 * k, one, field.name));
      }
      memory.view.setUint32(at + field.at, place, true);
      if (/_count$/.test(fields[i - 1]?.name)) {
        memory.view.setUint32(at + fields[i - 1].at, numbers.length, true);
      }
    } else if (field.room) {
      const numbers = numbersOf(value, field.room, field.name);
      if (numbers.length > field.room) {
        throw new BattenError('count', `${field.name} has ${numbers.length} numbers, not ${field.room}`);
      }
      Array.from(numbers, (one, k) => memory.writeOne(field.type, at + field.at + k * memory.sizeOf(field.type), one, field.name));
      const there = fields.find(({ name }) => name === `has_${field.name}`);
      if (there) {
        memory.view.setUint8(at + there.at, 1);
      }
    } else {
      memory.writeOne(field.type, at + field.at, value, camel(field.name));
    }
  }

  /** Places a struct of options: the defaults, and what was given. @param {Argument} arg @returns {number} its address */
  #options({ bare }) {
    const { memory } = this;
    const { size, fields } = memory.structs[bare];
    const at = memory.borrow(size);
    memory.exports[`${bare}_init`](at, size);
    for (const field of fields) {
      const value = this.options[camel(field.name)];
      if (field.name !== 'size' && value !== undefined) {
        this.#field(at, fields, { ...field, bare: bareOf(field.type) }, value, this.dimension);
      }
    }
    return at;
  }

  /** Places a stroke, a spline or regions. @param {Argument} arg @returns {number} its address */
  #struct({ name, bare }) {
    const { memory } = this;
    const value = this.values.get(name);
    if (name === 'regions') {
      return this.#regions(value);
    }
    const given = isNumbers(value) ? { ...this.options, points: value } : { ...this.options, ...value };
    const numbers = numbersOf(given.points, this.dimension, name);
    const { size, fields } = memory.structs[bare];
    const at = memory.borrow(size);
    const count = numbers.length / this.dimension;
    if (!Number.isInteger(count)) {
      throw new BattenError('count', `${name} has ${numbers.length} numbers, in points of ${this.dimension}`);
    }
    const each = { points: this.dimension, tangents: this.dimension, tension: 2, pressure: 1, time: 1 };
    const written = { ...given, points: numbers, dimension: this.dimension, count };
    for (const field of fields) {
      const one = written[camel(field.name)];
      if (one !== undefined && one !== null) {
        if (field.type.endsWith('*') && numbersOf(one, each[field.name], field.name).length !== count * each[field.name]) {
          throw new BattenError('count', `there are not as many ${field.name} as points`);
        }
        this.#field(at, fields, { ...field, bare: bareOf(field.type) }, one, each[field.name]);
      }
    }
    return at;
  }

  /** Regions: each a curve, a list of curves, or {curves, evenOdd}. */
  #regions(value) {
    const { memory } = this;
    const at = memory.borrow(12 * value.length);
    value.forEach((region, i) => {
      const curves = Array.isArray(region) ? region : region.curves ?? [region];
      const list = memory.borrow(4 * curves.length);
      curves.forEach((curve, k) => memory.view.setUint32(list + 4 * k, this.library.handleOf(curve, 'Curve', 'regions'), true));
      memory.view.setUint32(at + 12 * i, curves.length, true);
      memory.view.setUint32(at + 12 * i + 4, list, true);
      memory.view.setUint8(at + 12 * i + 8, region.evenOdd ? 1 : 0);
    });
    return at;
  }

  /** Makes room for a result. @param {Argument} arg @returns {number} its address */
  #result(arg) {
    const { memory } = this;
    const { bare, formula, handed, name } = arg;
    const isHandle = bare in this.library.classes;
    const waits = /^room$/.test(formula ?? '') && this.values.get('room') === 0;
    const count = handed || formula === undefined ? 1 : evaluate(formula, this.#look);
    const size = handed || isHandle ? 4 : memory.sizeOf(bare) * countOf(count, name);
    const into = this.plan.writes === arg && this.options.into instanceof Numbers ? this.options.into : null;
    if (into && into.length < count) {
      throw new BattenError('count', `into has ${into.length} numbers, not ${count}`);
    }
    const at = waits ? 0 : into ? into.at : memory.borrow(size);
    this.results.push({ ...arg, at, count, isHandle, into });
    return at;
  }

  /** One argument, as C takes it. @param {Argument} arg @returns {number} */
  #argument(arg) {
    switch (arg.kind) {
      case 'self': return this.self ? this.library.handleOf(this.self, this.self.kind, 'this') : 0;
      case 'dim': return intOf(this.dimension, 'dimension');
      case 'null': return 0;
      case 'follows': return this.#whole(evaluate(arg.formula, this.#look));
      case 'count': return this.#whole(this.#records(arg.name));
      case 'room': return this.values.get('room');
      case 'scalar': return this.#scalar(arg);
      case 'array': return this.#array(arg);
      case 'struct': return this.#struct(arg);
      case 'options': return this.#kept(arg);
      default: return this.#result(arg);
    }
  }

  /** Options, which are read again after the call where they bring something back. @param {Argument} arg @returns {number} */
  #kept(arg) {
    const at = this.#options(arg);
    if (arg.back) {
      this.results.push({ ...arg, at, count: 1 });
    }
    return at;
  }

  /** A count, which has to be whole. @param {number} count @returns {number} */
  #whole(count) {
    if (!Number.isInteger(count)) {
      throw new BattenError('count', 'the numbers do not make whole points');
    }
    return count;
  }

  /** Makes the call: twice where the first says how much room the second needs. @returns {unknown} */
  run() {
    return this.memory.during(() => {
      const room = this.plan.parsed.find(({ kind }) => kind === 'room');
      if (room) {
        this.values.set('room', 0);
        this.counting = true;
        const returned = this.#once();
        const counted = this.results.find(({ name }) => name === 'count');
        this.values.set('room', counted ? this.memory.readOne('size_t', counted.at) : returned);
        this.results = [];
        this.counting = false;
      }
      return this.#once();
    });
  }

  /** Places the arguments, calls, and reads the results; throws when the status is not ok. @returns {unknown} */
  #once() {
    const { plan, memory } = this;
    const args = plan.parsed.filter((arg) => arg.kind !== 'result').reduce((map, arg) => map.set(arg, this.#argument(arg)), new Map());
    plan.parsed.filter((arg) => arg.kind === 'result').forEach((arg) => args.set(arg, this.#argument(arg)));
    const returned = memory.exports[plan.c](...plan.parsed.map((arg) => args.get(arg)));
    if (plan.parsed[0]?.ends) {
      this.self.gone();
    }
    if (this.counting) {
      return returned;
    }
    if (plan.returns !== 'bat_status') {
      return plan.returns === 'void' || this.values.has('room') ? this.#assemble() : this.#returned(returned);
    }
    const status = STATUSES[returned];
    if (status === 'ok') {
      return this.#assemble();
    }
    const best = status === 'tolerance' && this.results.some(({ isHandle, at }) => isHandle && memory.view.getUint32(at, true)) ? this.#assemble() : undefined;
    throw new BattenError(status, memory.text(memory.exports.bat_status_message(returned)), best);
  }

  /** What the function itself returned. @param {number} value @returns {unknown} */
  #returned(value) {
    const { plan, memory, library } = this;
    const bare = bareOf(plan.returns);
    if (plan.returned) {
      return memory.readMany(bare, value, evaluate(plan.returned, this.#look));
    }
    if (bare in library.classes) {
      return library.copied(bare, value, this.dimension);
    }
    if (plan.returns.endsWith('*')) {
      return memory.readStruct(bare, value);
    }
    return bare === 'bool' ? Boolean(value) : value;
  }

  /** Reads one result. @param {Result} result @returns {unknown} */
  #read({ at, bare, formula, handed, count, isHandle, into, name, kind }) {
    const { memory, library } = this;
    if (isHandle && !handed) {
      const address = memory.view.getUint32(at, true);
      return address && library.make(library.classes[bare], address, this.values.get('dimension') ?? this.dimension);
    }
    if (handed) {
      const from = memory.view.getUint32(at, true);
      const many = evaluate(/** @type {string} */ (formula), this.#look);
      const found = isHandle
        ? Array.from({ length: many }, (_, i) => library.make(library.classes[bare], memory.view.getUint32(from + 4 * i, true), this.dimension))
        : from ? memory.readMany(bare, from, many) : [];
      memory.exports.bat_free(from);
      return found;
    }
    if (into) {
      return into.values.subarray(0, count);
    }
    if (formula !== undefined) {
      return memory.readMany(bare, at, count);
    }
    const found = kind === 'options' || bare in memory.structs ? memory.readStruct(bare, at) : memory.readOne(bare, at);
    if (bare === 'bat_meeting') {
      memory.exports.bat_meeting_free(at);
    }
    if (bare === 'bat_sketch_live_info') {
      const { fields } = memory.structs[bare];
      const [size, target] = ['target_count', 'target'].map((field) => memory.view.getUint32(at + fields.find((one) => one.name === field).at, true));
      found.target = memory.doubles(target, size * this.dimension);
    }
    return found;
  }

  /** The results as one value. */
  #assemble() {
    for (const { name, at, bare, formula, handed, isHandle } of this.results) {
      if (!isHandle && !handed && formula === undefined && (bare === 'int' || bare === 'size_t')) {
        this.values.set(name, this.memory.readOne(bare, at));
      }
    }
    const used = (name) => this.results.some(({ formula }) => formula?.match(/\w+/g)?.includes(name)) || (name === 'count' && this.values.has('room'));
    const found = this.results.filter(({ name }) => !used(name)).map((result) => ({ ...result, value: this.#read(result) }));
    const handles = found.filter(({ isHandle, handed }) => isHandle && !handed);
    const rest = found.filter((one) => !handles.includes(one));
    if (handles.length === 1) {
      const [{ value }] = handles;
      if (value && rest.length > 0) {
        value.report = Object.freeze(Object.assign({}, ...rest.map(({ name, value: own, bare }) =>
          (bare === 'bat_sketch_live_info' ? { ...own.report, ...own, report: undefined } : name === 'report' ? own : { [camel(name)]: own }))));
      }
      return value;
    }
    if (handles.length > 1) {
      return handles.map(({ value }) => value);
    }
    if (found.length === 0) {
      return this.self;
    }
    return found.length === 1 ? found[0].value : Object.fromEntries(found.map(({ name, value }) => [camel(name), value]));
  }
}
