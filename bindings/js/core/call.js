// Calls of C as calls.txt describes them: arguments are placed in memory, the function is called, results are read.
import { BattenError, shown, STATUSES, wrong } from './error.js';
import { bytesOf, converted, curvesOf, dimensionOf, evaluate, isNumbers, numbersOf, optionsOf, rowOf, snake } from './given.js';
import { bareOf, camel, Numbers, wordOf } from './memory.js';
import { FLAT } from './structs.js';

/** @typedef {import('./plan.js').Argument} Argument */
/** @typedef {import('./plan.js').Plan} Plan */
/** A result: where it is, and how many. @typedef {Argument & { at: number, count: number, isHandle: boolean, into: Numbers | null }} Result */

const LITERALS = { false: false, true: true, inf: Infinity };
const NOTHING = 0xffffffff; // of an index
const MOST = 1 << 26; // numbers of one result: half a GB

/** One call: its arguments by name, and the results that it is to bring. */
export class Call {
  /** @param {import('./library.js').Batten} library @param {Plan} plan @param {import('./library.js').Curve | null} self or an object of another class
   * @param {unknown[]} given what the caller gives */
  constructor(library, plan, self, given) {
    Object.assign(this, { library, plan, self, memory: library.memory, structs: library.structs });
    this.values = new Map();
    this.results = [];
    this.copies = []; // which the call keeps
    this.told = 0;
    plan.positional.forEach((arg, i) => this.values.set(arg.name, given[i]));
    this.name = camel(plan.names[0].split('.')[1].replace(/^_|\(\)$/g, ''));
    this.options = optionsOf(given, plan.positional.map((arg) => camel(arg.name)), plan.options, this.name);
    for (const arg of plan.parsed) {
      if ((arg.missing !== undefined || arg.optional) && !this.values.has(arg.name)) {
        this.values.set(arg.name, this.options[camel(arg.name)]);
      }
    }
    this.dimension = this.#dimension();
  }

  /** The dimension: of the object, as an option says, or as the points show it. @returns {number} */
  #dimension() {
    const arrays = this.plan.parsed.filter(({ kind, formula, bare }) => (kind === 'array' && /dim/.test(formula)) || (kind === 'struct' && FLAT.includes(bare)));
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
      return this.self.countOf_(this.values.get('level'));
    }
    const value = this.values.get(name) ?? this.self[camel(name)];
    return typeof value === 'function' ? value.call(this.self, this.values.get('direction')) : value;
  };

  /** How many records an argument has: points, or what its formula says. @param {string} name @returns {number} */
  #records(name) {
    const value = this.values.get(name);
    const arg = this.plan.parsed.find((one) => one.name === name && ['array', 'struct', 'text'].includes(one.kind));
    if (value === undefined || value === null) {
      if (arg.optional) {
        return 0;
      }
      throw wrong(camel(name), 'a value', shown(value));
    }
    if (arg.kind === 'text') {
      return bytesOf(value, name, true).length;
    }
    if (FLAT.includes(arg.bare)) {
      return numbersOf(isNumbers(value) ? value : value.points, this.dimension, camel(name)).length / this.dimension;
    }
    if (arg.kind === 'struct' || arg.bare in this.library.tables.classes) {
      if (!Array.isArray(value)) {
        throw wrong(camel(name), 'an array', shown(value));
      }
      return value.length;
    }
    const each = arg.whole ? 1 : evaluate(arg.formula, this.#look);
    return (arg.bare === 'double' ? numbersOf(value, this.#each(arg), camel(name)).length : rowOf(value, camel(name)).length) / each;
  }

  /** How many numbers a point of an array has. @param {Argument} arg @returns {number} */
  #each({ formula, whole }) {
    return !/dim/.test(formula) && !whole && formula !== '1' ? evaluate(formula, this.#look) : this.dimension;
  }

  /** A number, truth, word or handle, as C takes it. @param {Argument} arg @returns {number | bigint} */
  #scalar(arg) {
    const { missing, least, bare } = arg;
    const name = camel(arg.name);
    let value = this.values.get(arg.name);
    if ((value === undefined || value === null) && missing !== undefined) {
      const ends = { start: 0, end: 1 };
      value = missing in ends ? this.self.domain[ends[missing]] : missing in LITERALS ? LITERALS[missing] : Number.isNaN(Number(missing)) ? missing : Number(missing);
      this.values.set(arg.name, value);
    }
    if (bare in this.library.tables.classes) {
      return this.#handle(value, arg, name);
    }
    if (value === Infinity && missing === 'inf') {
      return value;
    }
    const found = converted(this.library.tables, bare, value, name, `${this.plan.names[0].split('.')[0]}.${name}`);
    if (least !== undefined && !(found >= Number(least) && found <= this.self.levels_)) {
      throw wrong(name, `a level from ${least} to ${this.self.levels_}`, shown(value));
    }
    return bare === 'bat_id' || bare === 'uint64_t' ? BigInt(found) : found;
  }

  /** The address of an object; of one that the call keeps, that of a copy. @param {unknown} value @param {Argument} arg @param {string} name @returns {number} */
  #handle(value, { bare, name: own, kept }, name) {
    const { library } = this;
    const at = library.handleOf_(value, library.tables.classes[bare], name);
    if ((own === 'b' || own === 'onto') && this.self?.dim && value.dim && value.dim !== this.dimension && this.name !== 'isEqual') {
      throw wrong(name, `one of dimension ${this.dimension}`, `one of ${value.dim}`, 'dimension');
    }
    if (kept) {
      this.copies.push(library.copied_(bare, at));
    }
    return kept ? this.copies.at(-1).at_ : at;
  }

  /** Places numbers or objects in memory. @param {Argument} arg @returns {number} their address; 0: none were given */
  #array(arg) {
    const { whole, formula, optional, bare, back } = arg;
    const { memory, library } = this;
    const name = camel(arg.name);
    const value = this.values.get(arg.name);
    if (optional && (value === undefined || value === null)) {
      return 0;
    }
    if (bare in library.tables.classes) {
      const count = this.#records(arg.name);
      if (whole && count !== evaluate(formula, this.#look)) {
        throw wrong(name, `${evaluate(formula, this.#look)} of them`, `${count}`, 'count');
      }
      return memory.placeList(value.map((one, i) => this.#handle(one, arg, `${name}[${i}]`)));
    }
    const numbers = bare === 'double' ? numbersOf(value, this.#each(arg), name) : null;
    const size = evaluate(formula, this.#look);
    const length = numbers?.length ?? rowOf(value, name).length;
    if (whole ? length !== size : length % size !== 0) {
      throw wrong(name, whole ? `${size} numbers` : `points of ${size} numbers`, `${length} numbers`, 'count');
    }
    if (!numbers) {
      return this.structs.row(bare, value, name)[0];
    }
    const at = back ? memory.place(numbers instanceof Numbers ? numbers.values.slice() : Array.from(numbers)) : memory.place(numbers);
    if (back) {
      this.results.push({ ...arg, at, count: numbers.length, isHandle: false, into: null });
    }
    return at;
  }

  /** Text and bytes. @param {Argument} arg @returns {number} its address; 0: none was given */
  #text({ name, optional, many }) {
    const value = this.values.get(name);
    return optional && (value === undefined || value === null) ? 0 : this.memory.placeBytes(bytesOf(value, camel(name), many));
  }

  /** Places a struct, or several. @param {Argument} arg @returns {number} its address */
  #struct({ name, bare, optional, many }) {
    const value = this.values.get(name);
    if (FLAT.includes(bare)) {
      return this.structs.flat(bare, isNumbers(value) ? { ...this.options, points: value } : { ...this.options, ...value }, this.dimension, camel(name));
    }
    if (many) {
      return this.structs.list(bare, value, camel(name));
    }
    const isMissing = optional && (value === undefined || value === null);
    return isMissing && bare !== 'bat_style' ? 0 : this.structs.one(bare, isMissing ? {} : value, camel(name));
  }

  /** Makes room for a result. @param {Argument} arg @returns {number} its address */
  #result(arg) {
    const { memory } = this;
    const { bare, formula, handed, name } = arg;
    const isHandle = bare in this.library.tables.classes;
    const waits = /\broom\b/.test(formula ?? '') && this.values.get('room') === 0;
    const count = handed || formula === undefined ? 1 : evaluate(formula, this.#look);
    if (!(Number.isInteger(count) && count >= 0 && count <= MOST)) {
      throw wrong(camel(name), `0 to ${MOST} of them`, shown(count), 'count');
    }
    const size = handed || isHandle ? 4 : memory.sizeOf(bare) * count;
    const into = this.plan.writes === arg && this.options.into instanceof Numbers ? this.options.into : null;
    if (into && into.length < count) {
      throw wrong('into', `${count} numbers`, `${into.length}`, 'count');
    }
    const at = waits ? 0 : into ? into.at : memory.borrow(size);
    this.results.push({ ...arg, at, count, isHandle, into });
    return at;
  }

  /** One argument, as C takes it. @param {Argument} arg @returns {number | bigint} */
  #argument(arg) {
    switch (arg.kind) {
      case 'self': return this.self ? this.library.handleOf_(this.self, this.self.kind_, 'this') : 0;
      case 'dim': return converted(this.library.tables, 'int', this.dimension, 'dimension');
      case 'null': return 0;
      case 'follows': return this.#whole(evaluate(arg.formula, this.#look), arg.formula);
      case 'count': return this.#whole(this.#records(arg.name), arg.name);
      case 'room': return this.values.get('room');
      case 'scalar': return this.#scalar(arg);
      case 'array': return this.#array(arg);
      case 'text': return this.#text(arg);
      case 'told': return this.#tell(arg);
      case 'struct': return this.#struct(arg);
      case 'options': return this.#kept(arg);
      default: return this.#result(arg);
    }
  }

  /** Room for what the call says of its failure. @param {Argument} arg @returns {number} */
  #tell({ bare }) {
    this.told = this.memory.borrow(this.memory.sizeOf(bare));
    if (bare === 'size_t') {
      this.memory.writeOne(bare, this.told, NOTHING);
    }
    return this.told;
  }

  /** Options, which are read again after the call where they bring something back. @param {Argument} arg @returns {number} */
  #kept(arg) {
    const at = this.structs.options(arg.bare, this.options, this.dimension);
    if (arg.back) {
      this.results.push({ ...arg, at, count: 1 });
    }
    return at;
  }

  /** A count, which has to be whole. @param {number} count @param {string} name @returns {number} */
  #whole(count, name) {
    if (!Number.isInteger(count)) {
      throw wrong(camel(name.match(/[a-z]\w*/)?.[0] ?? name), 'whole points', `${count} of them`, 'count');
    }
    return count;
  }

  /** Makes the call: twice where the first says how much room the second needs. @returns {unknown} */
  run() {
    return this.memory.during(() => {
      if (this.plan.parsed.some(({ kind }) => kind === 'room')) {
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
    const { plan, memory, library } = this;
    const last = (arg) => (arg.kind === 'result' ? 1 : arg.kind === 'self' ? 2 : 0); // getters of what is given may end the object
    const args = new Map();
    let returned;
    try {
      [...plan.parsed].sort((a, b) => last(a) - last(b)).forEach((arg) => args.set(arg, this.#argument(arg)));
      const guard = library.tables.rules.checked[plan.c];
      if (guard) {
        this.told = memory.borrow(memory.sizeOf('bat_problem'));
        const refused = memory.exports[guard](args.get(plan.parsed[0]), this.told);
        if (refused) {
          throw new BattenError(STATUSES[refused], `${camel(plan.parsed[0].name)}.${this.#said('')} (${this.name})`);
        }
      }
    } catch (error) {
      this.copies.forEach((one) => one.free());
      throw error;
    }
    returned = memory.exports[plan.c](...plan.parsed.map((arg) => args.get(arg)));
    this.copies.forEach((one) => one.gone()); // whatever it returns, they are the call's
    if (plan.parsed[0]?.ends) {
      this.self.gone();
    }
    if (this.counting) {
      return returned;
    }
    for (const { name, at, bare, formula, handed, isHandle } of this.results) {
      if (!isHandle && !handed && formula === undefined && (bare === 'int' || bare === 'size_t')) {
        this.values.set(name, this.memory.readOne(bare, at));
      }
    }
    if (plan.returns !== 'bat_status') {
      return plan.returns === 'void' || this.values.has('room') ? this.#assemble() : this.#returned(returned);
    }
    const status = STATUSES[returned];
    if (status === 'ok') {
      return this.#assemble();
    }
    const best = status === 'tolerance' && this.results.some(({ isHandle, at }) => isHandle && memory.view.getUint32(at, true)) ? this.#assemble() : undefined;
    const given = [...this.values, ...Object.entries(this.options)].filter(([name, value]) => name !== 'room' && value !== undefined && !this.results.some((one) => one.name === name));
    const written = [...new Map(given.map(([name, value]) => [camel(name), shown(value)]))].map((one) => one.join(': ')).join(', ');
    const why = this.#explained(args) || (this.told ? '' : this.#outside(status)) || this.#said('');
    const of = this.self && !why && !plan.parsed[0]?.ends && library.tables.rules.of_object.includes(status) ? `${this.self}.` : '';
    const within = Object.values(library.tables.rules.explained_struct).includes(plan.c) ? `${camel(plan.parsed[0].name)}.` : '';
    throw new BattenError(status, `${within}${why || [memory.text(memory.exports.bat_status_message(returned)), library.tables.why[plan.c]?.[status]].filter(Boolean).join(': ')} (${of}${this.name}(${written}))`, best);
  }

  /** What another call says of the arguments that were refused: of all, or of a struct among them. @param {Map<Argument, number | bigint>} args @returns {string} */
  #explained(args) {
    const { plan, memory, library: { tables: { rules } } } = this;
    const asked = [{ name: '', explains: rules.explained[plan.c], given: plan.parsed.filter(({ kind }) => kind !== 'result' && kind !== 'told') }];
    for (const arg of this.told ? [] : plan.parsed.filter(({ kind, many }) => kind === 'struct' && !many)) {
      asked.push({ name: `${camel(arg.name)}.`, explains: rules.explained_struct[arg.bare], given: [arg] });
    }
    for (const { name, explains, given } of asked) {
      const call = memory.exports[explains];
      if (call && (name === '' || args.get(given[0]))) {
        const told = memory.borrow(memory.sizeOf('bat_problem'));
        if (call(...given.map((arg) => args.get(arg)), told)) {
          const { place, message } = this.structs.read('bat_problem', told);
          return name + [place, message].filter(Boolean).join(': ');
        }
      }
    }
    return '';
  }

  /** A bound of the ranges of the table: a number, or what the object has. @param {number | string} of @returns {number} */
  #bound(of) {
    return typeof of === 'number' ? of : of === 'start' || of === 'end' ? this.self.domain[Number(of === 'end')]
      : of === 'level_total' ? this.self.levels_ : of === 'degree' ? this.self.degree : this.#look(of.replace(/-$/, '')) - Number(of.endsWith('-'));
  }

  /** Which number is not in its range, when that is what the status can mean. @param {string} status @returns {string} */
  #outside(status) {
    const { ranges } = this.library.tables.rules;
    const numbers = [...this.values, ...Object.entries(this.options).map(([name, value]) => [snake(name), value])].filter(([name, value]) => name !== 'room' && typeof value === 'number');
    for (const [name, value] of ['argument', 'number', 'parameter', 'count', 'degree', 'knots'].includes(status) ? numbers : []) {
      const [from, to, above] = ranges[`${this.plan.c}.${name}`] ?? ranges[name] ?? [-1e75, 1e75];
      try {
        const [low, high] = [this.#bound(from), this.#bound(to)];
        if (value < low || value > high || (above && value === low)) {
          return `${camel(name)}: expected ${high < low ? 'none' : above && value <= low ? `more than ${low}` : `${low} to ${high}`}, found ${value}`;
        }
      } catch {
        // the object has no such thing
      }
    }
    return this.#listOutside(status);
  }

  /** The same of a list: a curve of a region, or the list that the status is about. @param {string} status @returns {string} */
  #listOutside(status) {
    const isRegion = (name) => this.library.tables.rules.regions.includes(name) && (status === 'argument' || status === 'dimension');
    for (const [name, value] of this.values) {
      for (const [place, curve] of isRegion(name) ? curvesOf(value, camel(name)) : []) {
        if (curve.dimension !== 2 || !curve.closed) {
          return `${place}: expected a closed curve in the plane, found ${curve.dimension === 2 ? 'an open one' : 'one in space'}`;
        }
      }
    }
    const meant = ['count', 'parameter', 'singular'].includes(status) ? [...this.values].find(([, value]) => isNumbers(value)) : undefined;
    return meant ? `${camel(meant[0])}: ${this.memory.text(this.memory.exports.bat_status_message(STATUSES.indexOf(status)))}, found ${shown(meant[1])}` : '';
  }

  /** What the call told of its failure: by a problem, or by the index of what is wrong. @param {string} message @returns {string} */
  #said(message) {
    const { memory, told } = this;
    const bare = told ? this.plan.parsed.find(({ kind }) => kind === 'told')?.bare ?? 'bat_problem' : undefined;
    if (bare === 'bat_problem') {
      const { place, message: why } = this.structs.read(bare, told);
      return [place, why].filter(Boolean).join(': ') || message;
    }
    const index = bare ? memory.readOne('size_t', told) : NOTHING;
    return index === NOTHING ? message : `${message} (number ${index})`;
  }

  /** What the function itself returned. @param {number | bigint} value @returns {unknown} */
  #returned(value) {
    const { plan, memory, library } = this;
    const bare = bareOf(plan.returns);
    if (plan.returned) {
      return this.structs.many(bare, value, evaluate(plan.returned, this.#look));
    }
    if (bare === 'char') {
      return value ? memory.text(value) : null;
    }
    if (bare in library.tables.classes) {
      return value ? library.copied_(bare, value, this.dimension) : null;
    }
    if (plan.returns.endsWith('*')) {
      return value ? this.structs.read(bare, value) : null;
    }
    return bare === 'bool' ? Boolean(value) : bare === 'bat_id' ? Number(value) : bare === 'uint64_t' ? BigInt.asUintN(64, value)
      : bare in memory.enums ? wordOf(memory.enums[bare], value) : value;
  }

  /** Reads one result. @param {Result} result @returns {unknown} */
  #read({ at, bare, formula, handed, count, isHandle, into, name, kind }) {
    const { memory, library } = this;
    const { structs, classes } = library.tables;
    if (isHandle && !handed) {
      const address = memory.view.getUint32(at, true);
      return address && library.make_(classes[bare], address, this.values.get('dimension') ?? this.dimension);
    }
    if (handed) {
      const from = memory.view.getUint32(at, true);
      const many = evaluate(/** @type {string} */ (formula), this.#look);
      const bytes = bare === 'char' && new Uint8Array(memory.buffer, from, many);
      const found = bytes ? (name === 'text' ? new TextDecoder().decode(bytes) : bytes.slice())
        : isHandle ? Array.from({ length: many }, (_, i) => library.make_(classes[bare], memory.view.getUint32(from + 4 * i, true), this.dimension))
          : from ? this.structs.many(bare, from, many, this.dimension) : [];
      memory.exports.bat_free(from);
      return found;
    }
    if (into) {
      return into.values.subarray(0, count);
    }
    if (formula !== undefined) {
      return this.structs.many(bare, at, count, this.dimension);
    }
    if (kind !== 'options' && !(bare in structs)) {
      return memory.readOne(bare, at);
    }
    const found = this.structs.read(bare, at, this.dimension);
    const end = kind === 'result' && (memory.exports[`${bare}_free`] ?? memory.exports[`${bare}_clear`]);
    if (end) {
      end(at); // what the library has put into it
    }
    if (bare === 'bat_sketch_live_info') {
      const { fields } = structs[bare];
      const [size, target] = ['target_count', 'target'].map((field) => memory.view.getUint32(at + fields.find((one) => one.name === field).at, true));
      found.target = memory.doubles(target, size * this.dimension);
    }
    return found;
  }

  /** The results as one value. */
  #assemble() {
    const used = (name) => this.results.some(({ formula, kind }) => kind === 'result' && formula?.match(/\w+/g)?.includes(name)) || this.plan.returned?.match(/\w+/g)?.includes(name)
      || (name === 'count' && this.values.has('room'));
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
