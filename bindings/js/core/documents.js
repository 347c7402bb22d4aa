// Documents, what is in them, and files that are read by hand.
import { BattenError, shown, wrong } from './error.js';
import { bytesOf } from './given.js';
import { Handle } from './library.js';
import { readXml } from './xml.js';

/** The bytes of a PNG, JPEG or WebP file. */
export class Picture extends Handle {
  /** The bytes of the file. @returns {Uint8Array} */
  get bytes() {
    const { memory } = this.library;
    return memory.during(() => {
      const cell = memory.borrow(4);
      const at = memory.exports.bat_picture_bytes(this.at_, cell);
      return new Uint8Array(memory.buffer, at, memory.readOne('size_t', cell)).slice();
    });
  }
}

/** An object of a document: a path, a spline, a group, a picture, a surface and so on. It never changes. */
class Item extends Handle {
  /** Its curves. */
  get curves() {
    return Array.from({ length: this.curveCount }, (_, i) => this.curve(i));
  }

  /** The corners of its picture, x and y; null: it has none. @returns {Float64Array | null} */
  get corners() {
    const { memory } = this.library;
    return memory.during(() => {
      const box = memory.borrow(64);
      if (!this.picture()) {
        return null;
      }
      memory.exports.bat_object_corners(this.at_, box);
      return memory.doubles(box, 8);
    });
  }

  /** Of a guide, its axis and where it is; else null. */
  get guide() {
    const { memory } = this.library;
    return memory.during(() => {
      const cell = memory.borrow(8);
      const axis = memory.exports.bat_object_guide(this.at_, cell);
      return axis < 0 ? null : { axis, at: memory.readOne('double', cell) };
    });
  }

  /** The ids of what it is made from. @returns {number[]} */
  get sources() {
    const { memory } = this.library;
    return memory.during(() => {
      const cell = memory.borrow(4);
      const count = memory.exports.bat_object_sources(this.at_, cell);
      return memory.readMany('bat_id', memory.view.getUint32(cell, true), count);
    });
  }

  /** The spline that it is, as the calls take it; else null. */
  get spline() {
    const at = this.library.memory.exports.bat_object_spline(this.at_);
    return at ? arraysOf(this.library, 'bat_spline', at) : null;
  }
}

/** An ordered list of objects, back to front. */
export class Document extends Handle {
  /** All objects, back to front. */
  get objects() {
    return Array.from({ length: this.count }, (_, i) => this.at(i));
  }

  /** Puts an object in front of all others, under a new id, which is returned. @param {Item} object @returns {number} */
  add(object) {
    if (!(object instanceof Item)) {
      throw wrong('object', 'an Object', shown(object));
    }
    const id = this.newId();
    this.insert(this.count, object.withId(id));
    return id;
  }
}

/** A stroke or a spline as the calls take it. */
function arraysOf({ memory, tables }, struct, from) {
  const at = (name) => from + tables.structs[struct].fields.find((field) => field.name === name).at;
  const [dimension, count] = [memory.readOne('int', at('dimension')), memory.readOne('size_t', at('count'))];
  const each = struct === 'bat_stroke' ? { points: dimension, pressure: 1, time: 1 } : { points: dimension, tangents: dimension, tension: 2 };
  const there = Object.keys(each).filter((name) => memory.view.getUint32(at(name), true));
  const found = Object.fromEntries(there.map((name) => [name, memory.doubles(memory.view.getUint32(at(name), true), count * each[name])]));
  return { ...found, dimension, ...(struct === 'bat_spline' && { closed: memory.readOne('bool', at('closed')) }) };
}

/** What a call told of its failure. */
function said({ structs }, problem) {
  const { place, message } = structs.read('bat_problem', problem);
  return [place, message].filter(Boolean).join(': ');
}

/** Reads a stroke or a spline. */
function readArrays(library, struct, text) {
  const { memory, tables } = library;
  return memory.during(() => {
    const bytes = bytesOf(text, 'text', true);
    const [item, block, problem] = [tables.structs[struct].size, 4, tables.structs.bat_problem.size].map((size) => memory.borrow(size));
    const status = memory.exports[`${struct}_read`](memory.placeBytes(bytes), bytes.length, item, block, problem);
    library.check_(status, said(library, problem));
    const { dimension, ...found } = arraysOf(library, struct, item);
    memory.exports.bat_free(memory.view.getUint32(block, true));
    const rows = (numbers) => Array.from({ length: numbers.length / dimension }, (_, i) => numbers.subarray(i * dimension, (i + 1) * dimension));
    return Object.fromEntries(Object.entries(found).map(([name, value]) => [name, name === 'points' || name === 'tangents' ? rows(value) : value]));
  });
}

/** The text of XML in whatever encoding it declares. @param {Uint8Array} bytes @returns {string} */
function textOf(bytes) {
  const begin = new TextDecoder('latin1').decode(bytes.subarray(0, 200));
  const wide = begin.startsWith('\xff\xfe') ? 'utf-16le' : begin.startsWith('\xfe\xff') ? 'utf-16be' : null;
  const label = wide ?? /^<\?xml[^>]*encoding=["']([\w.:-]+)["']/.exec(begin)?.[1] ?? 'utf-8';
  try {
    return new TextDecoder(label).decode(bytes);
  } catch {
    throw new BattenError('unsupported', `text: expected an encoding that is known, found ${shown(label)}`);
  }
}

/** What the library has beside its calls, of documents. */
export const reading = {
  /** A stroke of JSON or CSV, as the calls take it. @param {string | Uint8Array} text */
  readStroke(text) {
    return readArrays(this, 'bat_stroke', text);
  },

  /** A spline of JSON, as the calls take it. @param {string | Uint8Array} text */
  readSpline(text) {
    return readArrays(this, 'bat_spline', text);
  },

  /** An SVG file as a document, whose report says what was left out. Nothing is fetched. @param {string | Uint8Array} text @param {object} options of bat_svg_options */
  readSvg(text, options = {}) {
    const { memory, structs, tables } = this;
    const bytes = bytesOf(text, 'text', true);
    const written = textOf(bytes);
    const place = (words) => memory.placeList([...words.map((one) => memory.placeBytes(bytesOf(one, 'text', true))), 0]);
    const tell = (name, make) => memory.during(() => this.check_(memory.exports[`bat_svg_reader_${name}`](...make())));
    return memory.during(() => {
      const cell = memory.borrow(4);
      tell('create', () => [structs.one('bat_svg_options', options, 'options'), cell]);
      const reader = memory.view.getUint32(cell, true);
      const feed = (name, one) => tell(name, () => [reader, memory.placeBytes(one), one.length]);
      try {
        readXml(written, {
          start: (name, attributes) => tell('start', () => [reader, memory.placeBytes(bytesOf(name, 'text', true)), place(attributes)]),
          text: (characters) => feed('text', bytesOf(characters, 'text', true)),
          end: () => tell('end', () => [reader]),
        });
        if (bytesOf(written, 'text', true).length === bytes.length) { // it is in UTF-8
          feed('source', bytes);
        }
      } catch (error) {
        memory.exports.bat_svg_reader_free(reader);
        throw error;
      }
      const [report, problem] = ['bat_svg_report', 'bat_problem'].map((struct) => memory.borrow(tables.structs[struct].size));
      const status = memory.exports.bat_svg_reader_finish(reader, cell, report, problem);
      this.check_(status, said(this, problem));
      const found = this.make_('Document', memory.view.getUint32(cell, true));
      found.report = Object.freeze(structs.read('bat_svg_report', report));
      return found;
    });
  },
};

export const documents = { Picture, Object: Item, Document };
export { Item as Object };
