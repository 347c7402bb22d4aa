// Structs of C: what callers give for one is placed in memory, field by field; what the library gives is read from there.
import { shown, wrong } from './error.js';
import { bytesOf, converted, isNumbers, listOf, numbersOf, rowOf } from './given.js';
import { bareOf, camel } from './memory.js';

/** Structs whose points may be given alone, and the rest as options. */
export const FLAT = ['bat_stroke', 'bat_spline'];
/** How many numbers a stroke or spline has for each point, beside its coordinates. */
const EACH = { tension: 2, pressure: 1, time: 1 };

/** What a value that is no object of the fields stands for. @param {import('./library.js').Batten} library @param {string} struct @param {string[]} own */
function alone({ tables: { kinds } }, struct, value, own) {
  const list = Array.isArray(value) ? value : [value];
  const all = (kind) => list.every((one) => one instanceof kinds[kind]);
  if (struct === 'bat_function') {
    return value instanceof kinds.Curve ? { curve: value } : typeof value === 'number' ? { constant: value } : null;
  }
  if (struct === 'bat_region' && all('Curve')) {
    return { curves: list };
  }
  if (struct === 'bat_model' || struct === 'bat_line_scene') {
    const of = (kind) => list.filter((one) => one instanceof kinds[kind]);
    const [mesh, surfaces, curves] = ['Mesh', 'Surface', 'Curve'].map(of);
    const fits = mesh.length + surfaces.length + curves.length === list.length && mesh.length < 2;
    return fits ? { ...(mesh[0] && { mesh: mesh[0] }), ...(surfaces[0] && { surfaces }), ...(curves[0] && { curves }) } : null;
  }
  if (struct === 'bat_width_profile' && Array.isArray(value)) {
    return { stops: value };
  }
  const isOne = struct === 'bat_width_stop' || struct === 'bat_stop';
  return isOne && isNumbers(value) && value.length === own.length ? Object.fromEntries(own.map((name, i) => [name, value[i]])) : null;
}

/** Places structs. */
export class Structs {
  /** @param {import('./library.js').Batten} library */
  constructor(library) {
    this.library = library;
    this.memory = library.memory;
    this.tables = library.tables;
  }

  /** The fields of a struct by name, as what is given has them. */
  #members(struct, value, name) {
    const own = this.tables.structs[struct].fields.filter((field) => field.name !== 'size' && !field.counts).map((field) => camel(field.name));
    const isPlain = typeof value === 'object' && value !== null && !isNumbers(value) && !('kind_' in value);
    const given = isPlain ? value : alone(this.library, struct, value, own);
    const other = given ? Object.keys(given).find((one) => !own.includes(one)) : undefined;
    if (!given || other !== undefined) {
      throw wrong(name, `an object of ${own.join(', ')}`, other === undefined ? shown(value) : `one with ${other}`);
    }
    return given;
  }

  /** Structs that follow each other. @param {string} struct @param {unknown} values @param {string} name @returns {number} where they are */
  list(struct, values, name) {
    if (!Array.isArray(values)) {
      throw wrong(name, 'an array', shown(values));
    }
    const { size } = this.tables.structs[struct];
    const at = this.memory.borrow(size * values.length);
    values.forEach((value, i) => this.fill(at + i * size, struct, value, `${name}[${i}]`));
    return at;
  }

  /** One struct. @returns {number} where it is */
  one(struct, value, name) {
    const at = this.memory.borrow(this.tables.structs[struct].size);
    this.fill(at, struct, value, name);
    return at;
  }

  /** Fills a struct with its defaults. */
  defaults(at, struct) {
    const { exports, structs } = this.memory;
    if (struct === 'bat_style') {
      exports.bat_style_defaults(at);
    } else if (struct in this.tables.inits) {
      exports[this.tables.inits[struct]](at, structs[struct].size);
    }
  }

  /** Fills a struct with its defaults, and with what is given. */
  fill(at, struct, value, name) {
    this.defaults(at, struct);
    const { fields } = this.tables.structs[struct];
    const members = this.#members(struct, value, name);
    for (const field of fields) {
      const one = members[camel(field.name)] ?? this.tables.rules.defaults[struct]?.[field.name];
      if (one !== undefined && one !== null) {
        this.set(at, struct, field, one, `${name}.${camel(field.name)}`);
      }
    }
  }

  /** Options: the defaults, and what is given of them. @returns {number} where they are */
  options(struct, given, dimension) {
    const { size, fields } = this.tables.structs[struct];
    const at = this.memory.borrow(size);
    this.defaults(at, struct);
    for (const field of fields) {
      const value = given[camel(field.name)];
      if (field.name !== 'size' && value !== undefined && value !== null) {
        this.set(at, struct, field, value, camel(field.name), dimension);
      }
    }
    return at;
  }

  /** A stroke or a spline: points, and the rest by name. @returns {number} where it is */
  flat(struct, given, dimension, name) {
    const { size, fields } = this.tables.structs[struct];
    const numbers = numbersOf(given.points, dimension, name);
    const count = numbers.length / dimension;
    if (!Number.isInteger(count)) {
      throw wrong(name, `points of ${dimension} numbers`, `${numbers.length} numbers`, 'count');
    }
    const at = this.memory.borrow(size);
    const written = { ...given, points: numbers, dimension, count };
    for (const field of fields) {
      const one = written[camel(field.name)];
      if (one !== undefined && one !== null && field.name === 'count') {
        this.memory.writeOne('size_t', at + field.at, count);
      } else if (one !== undefined && one !== null) {
        const each = EACH[field.name] ?? dimension;
        const many = field.type.endsWith('*') && numbersOf(one, each, field.name).length;
        if (many !== false && many !== count * each) {
          throw wrong(camel(field.name), `${count * each} numbers for ${count} points`, `${many}`, 'count');
        }
        this.set(at, struct, field, one, camel(field.name), dimension, each);
      }
    }
    return at;
  }

  /** Numbers, truths or words of a type, in a row. @returns {[number, number]} where they are, and how many */
  row(type, value, name, size = 1) {
    const { memory } = this;
    if (type === 'double') {
      const numbers = numbersOf(value, size, name);
      return [memory.place(numbers), numbers.length];
    }
    const list = rowOf(value, name);
    const each = memory.sizeOf(type);
    const at = memory.borrow(each * list.length);
    list.forEach((one, i) => memory.writeOne(type, at + i * each, converted(this.tables, type, one, `${name}[${i}]`)));
    return [at, list.length];
  }

  /** Sets one field of a struct, and the one that counts it. */
  set(from, struct, field, value, name, dimension = 3, size = undefined) {
    const { memory, library, tables } = this;
    const { structs, enums, classes } = tables;
    const at = from + field.at;
    const kind = bareOf(field.type);
    const stars = field.type.split('*').length - 1;
    const point = (to) => memory.view.setUint32(at, to, true);
    const count = (many) => field.counted && memory.view.setUint32(from + structs[struct].fields.find((one) => one.name === field.counted).at, many, true);
    if (stars > 1) {
      if (!Array.isArray(value)) {
        throw wrong(name, 'an array', shown(value));
      }
      point(memory.placeList(value.map((one, i) => library.handleOf_(one, classes[kind], `${name}[${i}]`))));
      count(value.length);
    } else if (stars && kind in classes) {
      point(library.handleOf_(value, classes[kind], name));
    } else if (stars && kind === 'char') {
      point(memory.placeBytes(bytesOf(value, name, false)));
    } else if (stars && kind in structs) {
      point(field.counted ? this.list(kind, value, name) : this.one(kind, value, name));
      count(value.length);
    } else if (stars) {
      const each = size ?? tables.rules.each[`${struct}.${field.name}`] ?? 1;
      const [to, many] = this.row(kind, value, name, each);
      if (many % each) {
        throw wrong(name, `records of ${each} numbers`, `${many} numbers`, 'count');
      }
      point(to);
      count(many / each);
    } else if (field.room) {
      const list = isNumbers(value) ? listOf(value) : null;
      if (!list || (kind in enums ? list.length > field.room : list.length !== field.room && list.length !== dimension)) {
        throw wrong(name, kind in enums ? `${field.room} words at most` : `${field.room} numbers`, shown(value), list ? 'count' : 'argument');
      }
      list.forEach((one, i) => memory.writeOne(kind, at + i * memory.sizeOf(kind), converted(tables, kind, one, `${name}[${i}]`)));
      count(list.length);
      const there = structs[struct].fields.find((one) => one.name === `has_${field.name}`);
      if (there) {
        memory.view.setUint8(from + there.at, 1);
      }
    } else if (kind in structs) {
      this.fill(at, kind, value, name);
    } else {
      memory.writeOne(kind, at, converted(tables, kind, value, name));
    }
  }

  /** A struct as an object. Arrays that no field counts are left out. @param {string} type @param {number} from @param {number} [dimension] of what it is about @returns {object} */
  read(type, from, dimension = 3) {
    const { memory } = this;
    const { structs, enums } = this.tables;
    const { fields } = structs[type];
    const found = {};
    for (const field of fields) {
      const at = from + field.at;
      const kind = bareOf(field.type);
      const counted = field.counted && fields.find((one) => one.name === field.counted);
      const count = counted && memory.view.getUint32(from + counted.at, true);
      const name = camel(field.name);
      if (field.counts || name === 'size') {
        continue;
      }
      if (field.type.endsWith('*')) {
        const value = this.#pointed(field.type, memory.view.getUint32(at, true), count, dimension);
        if (value !== undefined) {
          found[name] = value;
        }
      } else if (kind === 'char') {
        found[name] = memory.text(at);
      } else if (field.room) {
        found[name] = this.many(kind, at, kind in enums ? count : field.each ? dimension : field.room);
      } else {
        found[name] = kind in structs ? this.read(kind, at, dimension) : memory.readOne(kind, at);
      }
    }
    return found;
  }

  /** Values or structs that follow each other. */
  many(type, at, count, dimension = 3) {
    const { size } = this.tables.structs[type] ?? {};
    return size ? Array.from({ length: count }, (_, i) => this.read(type, at + i * size, dimension)) : this.memory.readMany(type, at, count);
  }

  /** What a pointer in a struct points to; undefined where nothing says how many. */
  #pointed(type, to, count, dimension) {
    const { library, memory } = this;
    const { structs, classes } = this.tables;
    const kind = bareOf(type);
    if (kind === 'char') {
      return to ? memory.text(to) : null;
    }
    if (kind in classes && count === undefined) {
      return type.split('*').length > 2 ? undefined : to ? library.copied_(kind, to) : null;
    }
    if (count === undefined) {
      return kind in structs ? (to ? this.read(kind, to, dimension) : null) : undefined;
    }
    if (kind in classes) {
      return Array.from({ length: to ? count : 0 }, (_, i) => library.copied_(kind, memory.view.getUint32(to + 4 * i, true)));
    }
    return to || !count ? this.many(kind, to, to ? count : 0, dimension) : null;
  }
}
