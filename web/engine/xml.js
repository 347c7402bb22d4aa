// XML taken apart in one pass (XML 1.0, fifth edition), without a DOM: so that it can be done in a worker, nothing of a file
// becomes part of a page, and the work grows with the size. As the program's parser does, it takes prefixes that no namespace
// is bound to, expands the entities that the file itself declares, and fetches nothing.

/**
 * @typedef {object} Sink
 * @property {(name: string, attributes: string[], at: number) => void} start at: how many characters have been read
 * @property {(text: string) => void} text
 * @property {() => void} end
 */
/** @typedef {{ text: string, outside: boolean }} Entity outside: what it stands for is in another file */

/** Entities within each other. */
const NESTED = 64;

const WRONG = /[\0-\x08\x0B\x0C\x0E-\x1F\uFFFE\uFFFF]/;
/** In no name; and not at its beginning. */
const APART = /[\0-,/;-@[-^`{-\xB6\xB8-\xBF\xD7\xF7\u037E\u2000-\u200B\u200E-\u203E\u2041-\u206F\u2190-\u2BFF\u2FF0-\u3000\uE000-\uF8FF\uFDD0-\uFDEF]/;
const LATER = /[-.\d\xB7\u0300-\u036F\u203F\u2040]/;
const NUMBER = /^#(?:0*([0-9]{1,9})|x0*([0-9A-Fa-f]{1,8}))$/;
const DECLARATION = /^<\?xml\s+version\s*=\s*(["'])1\.\d+\1(\s+encoding\s*=\s*(["'])[A-Za-z][\w.-]*\3)?(\s+standalone\s*=\s*(["'])(yes|no)\5)?\s*\?>$/;
/** @type {Record<string, string>} */
const FIXED = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };

/** The ASCII characters that may be in a name. */
const PLAIN = Array.from({ length: 128 }, (_, code) => !APART.test(String.fromCharCode(code)));

/** What is not XML, and where. */
export class XmlFault extends Error {
  /** @param {string} text @param {number} at */
  constructor(text, at) {
    super('not well-formed XML');
    const lines = text.slice(0, at).split('\n');
    this.line = lines.length;
    this.column = lines[lines.length - 1].length + 1;
  }
}

/** Its entities add more than they may. */
export class XmlBomb extends Error {}

/** @param {number} code */
const isSpace = (code) => code === 32 || code === 10 || code === 9;

/** Where the spaces from `at` on end. @param {string} s @param {number} at */
export function skip(s, at) {
  while (isSpace(s.charCodeAt(at))) {
    at++;
  }
  return at;
}

/** Where the name that begins at `at` ends; `at` itself: there is none. @param {string} s @param {number} at */
export function nameEnd(s, at) {
  if (at >= s.length || LATER.test(s[at])) {
    return at;
  }
  let i = at;
  while (PLAIN[s.charCodeAt(i)] ?? (i < s.length && !APART.test(s[i]))) {
    i++;
  }
  return i;
}

/** The character of a reference such as "#65"; '': there is none. @param {string} name */
export function character(name) {
  const found = NUMBER.exec(name);
  const code = found ? (found[1] ? parseInt(found[1], 10) : parseInt(found[2], 16)) : 0;
  const good = code === 9 || code === 10 || code === 13 || (code >= 32 && code < 0xd800) || (code > 0xdfff && code < 0xfffe) ||
    (code > 0xffff && code < 0x110000);
  return good ? String.fromCodePoint(code) : '';
}

/** What reads a document type, where that has been imported. @type {{ read: ((reader: Reader, s: string, at: number) => number) | null }} */
export const types = { read: null };

export class Reader {
  /** @param {string} text @param {Sink} sink @param {number} most */
  constructor(text, sink, most) {
    this.text = text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text;
    this.sink = sink;
    /** The elements that are open. @type {string[]} */
    this.open = [];
    /** @type {Map<string, Entity>} */
    this.entities = new Map();
    /** @type {Map<string, Entity>} */
    this.parameters = new Map();
    /** Values of attributes that the file's document type gives, by element. @type {Map<string, Map<string, string>>} */
    this.given = new Map();
    /** Declarations may be in another file: what is not declared is left out. */
    this.partial = false;
    /** No declaration is in another file. */
    this.alone = false;
    /** The entities that are being expanded. @type {string[]} */
    this.inside = [];
    /** Characters that entities may still add. */
    this.room = most;
    /** Where in the file what is being read begins. */
    this.place = 0;
  }

  /** @returns {never} */
  fail() {
    throw new XmlFault(this.text, this.place);
  }

  /** @param {unknown} good */
  need(good) {
    return good || this.fail();
  }

  /** Goes to a place, which in an entity is the place of its reference. @param {number} at */
  go(at) {
    if (this.inside.length === 0) {
      this.place = at;
    }
  }

  /** Where `what` is. @param {string} s @param {string} what @param {number} at */
  find(s, what, at) {
    const found = s.indexOf(what, at);
    this.need(found >= 0);
    return found;
  }

  /** @param {string} s @param {number} at @returns {number} where the name ends */
  name(s, at) {
    const end = nameEnd(s, at);
    this.need(end > at);
    return end;
  }

  // ---- what all parts are made of ----

  /** A text in quotes. @param {string} s @param {number} at @returns {[string, number]} it, and where it ends */
  quoted(s, at) {
    this.need(s[at] === '"' || s[at] === "'");
    const end = this.find(s, s[at], at + 1);
    return [s.slice(at + 1, end), end + 1];
  }

  // ---- entities ----

  /** @param {number} size characters that are added */
  expand(size) {
    this.room -= size;
    if (this.room < 0) {
      throw new XmlBomb();
    }
  }

  /**
   * Does something with what an entity stands for.
   * @param {string} name @param {Map<string, Entity>} known @param {(text: string) => void} work
   */
  within(name, known, work) {
    const entity = known.get(name);
    if (!entity && this.partial) {
      return;
    }
    if (!entity || entity.outside || this.inside.includes(name) || this.inside.length >= NESTED) {
      this.fail();
    }
    this.expand(entity.text.length);
    this.inside.push(name);
    work(entity.text);
    this.inside.pop();
  }

  /** A value as read: references resolved, and every kind of space is a space. @param {string} raw @returns {string} */
  value(raw) {
    this.need(!raw.includes('<'));
    const plain = /[\t\n]/.test(raw) ? raw.replace(/[\t\n]/g, ' ') : raw;
    let from = plain.indexOf('&');
    if (from < 0) {
      return plain;
    }
    const parts = [plain.slice(0, from)];
    while (from >= 0) {
      const end = this.find(plain, ';', from);
      const name = plain.slice(from + 1, end);
      const fixed = name.startsWith('#') ? this.need(character(name)) : FIXED[name];
      if (fixed) {
        parts.push(String(fixed));
      } else {
        this.need(nameEnd(name, 0) === name.length && name);
        this.within(name, this.entities, (text) => parts.push(this.value(text)));
      }
      from = plain.indexOf('&', end);
      parts.push(plain.slice(end + 1, from < 0 ? undefined : from));
    }
    return parts.join('');
  }

  // ---- what is in a document ----

  /** @param {string} s @param {number} at @returns {number} past it */
  comment(s, at) {
    const end = this.find(s, '--', at + 4);
    this.need(s[end + 2] === '>');
    return end + 3;
  }

  /** @param {string} s @param {number} at @returns {number} past it */
  instruction(s, at) {
    const end = this.name(s, at + 2);
    this.need(!/^xml$/i.test(s.slice(at + 2, Math.min(end, at + 6))));
    this.need(isSpace(s.charCodeAt(end)) || s.startsWith('?>', end));
    return this.find(s, '?>', end) + 2;
  }

  /** A start tag. @param {string} s @param {number} at @returns {number} past it */
  #tag(s, at) {
    let end = this.name(s, at + 1);
    const name = s.slice(at + 1, end);
    /** @type {string[]} */
    const attributes = [];
    let i = skip(s, end);
    while (s[i] !== '>' && s[i] !== '/') {
      this.need(i > end); // a space comes first
      end = this.name(s, i);
      attributes.push(s.slice(i, end));
      i = skip(s, end);
      this.need(s[i] === '=');
      const [raw, next] = this.quoted(s, skip(s, i + 1));
      attributes.push(this.value(raw));
      end = next;
      i = skip(s, end);
    }
    this.#complete(name, attributes);
    this.open.push(name);
    this.sink.start(name, attributes, this.place);
    if (s[i] === '/') {
      this.need(s[i + 1] === '>');
      this.open.pop();
      this.sink.end();
      i++;
    }
    return i + 1;
  }

  /** Adds what the document type gives; each attribute is there once. @param {string} name @param {string[]} attributes */
  #complete(name, attributes) {
    const given = this.given.get(name);
    if (attributes.length <= 2 && !given) {
      return;
    }
    const names = new Set(attributes.filter((_, k) => k % 2 === 0));
    this.need(2 * names.size === attributes.length);
    for (const [other, value] of given ?? []) {
      if (!names.has(other)) {
        this.expand(value.length);
        attributes.push(other, value);
      }
    }
  }

  /** Text between tags, of which only spaces may be outside the root. @param {string} text */
  #text(text) {
    this.need(!text.includes(']]>') && (this.open.length > 0 || skip(text, 0) === text.length));
    if (text && this.open.length > 0) {
      this.sink.text(text);
    }
  }

  /** What stands after "&". @param {string} s @param {number} at @returns {number} past it */
  #reference(s, at) {
    const end = this.find(s, ';', at);
    const name = s.slice(at + 1, end);
    this.need(this.open.length > 0);
    const fixed = name.startsWith('#') ? this.need(character(name)) : FIXED[name];
    if (fixed) {
      this.sink.text(String(fixed));
    } else {
      this.need(name && nameEnd(name, 0) === name.length);
      this.within(name, this.entities, (text) => this.content(text, 0));
    }
    return end + 1;
  }

  /** What begins with "<". @param {string} s @param {number} at @param {number} base @returns {number} past it */
  #markup(s, at, base) {
    if (s[at + 1] === '/') {
      const name = this.open.length > base ? this.open[this.open.length - 1] : '';
      const end = skip(s, at + 2 + name.length);
      this.need(name && s.startsWith(name, at + 2) && s[end] === '>');
      this.open.pop();
      this.sink.end();
      return end + 1;
    }
    if (s[at + 1] === '?') {
      return this.instruction(s, at);
    }
    if (s.startsWith('<!--', at)) {
      return this.comment(s, at);
    }
    if (s.startsWith('<![CDATA[', at)) {
      const end = this.find(s, ']]>', at + 9);
      this.need(this.open.length > 0);
      this.sink.text(s.slice(at + 9, end));
      return end + 3;
    }
    return this.#tag(s, at);
  }

  /** Elements and text, to the end of `s`: of the document from its root on, or of an entity. @param {string} s @param {number} at */
  content(s, at) {
    const base = this.open.length;
    let reference = -2; // the next one; -1: none
    while (at < s.length) {
      this.go(at);
      let tag = s.indexOf('<', at);
      tag = tag < 0 ? s.length : tag;
      if (reference !== -1 && reference < at) {
        reference = s.indexOf('&', at);
      }
      const next = reference >= 0 && reference < tag ? reference : tag;
      this.#text(s.slice(at, next));
      this.go(next);
      at = next;
      if (next === reference) {
        at = this.#reference(s, next);
      } else if (next < s.length) {
        at = this.#markup(s, next, base);
        if (this.open.length === 0) {
          return at;
        }
      }
    }
    this.go(at);
    this.need(this.open.length === base && base > 0);
    return at;
  }

  /** What is around the root. @param {number} at @param {boolean} before @returns {number} where it ends */
  #around(at, before) {
    const s = this.text;
    let type = before;
    for (let i = skip(s, at); ; i = skip(s, i)) {
      this.go(i);
      if (s.startsWith('<!--', i)) {
        i = this.comment(s, i);
      } else if (s.startsWith('<?', i)) {
        i = this.instruction(s, i);
      } else if (type && types.read && s.startsWith('<!DOCTYPE', i)) {
        i = types.read(this, s, i);
        type = false;
      } else {
        return i;
      }
    }
  }

  document() {
    const s = this.text;
    this.place = Math.max(0, s.search(WRONG));
    this.need(!WRONG.test(s));
    let at = 0;
    if (/^<\?xml\s/.test(s)) {
      at = this.find(s, '?>', 0) + 2;
      const found = DECLARATION.exec(s.slice(0, Math.min(at, 1000)));
      this.need(found);
      this.alone = found?.[6] === 'yes';
    }
    at = this.#around(at, true);
    this.partial &&= !this.alone;
    this.need(s[at] === '<' && nameEnd(s, at + 1) > at + 1);
    at = this.#around(this.content(s, at), false);
    this.need(at === s.length);
  }
}

/**
 * Takes an XML document apart, in its order. Throws XmlFault, XmlBomb, and whatever the sink throws.
 * @param {string} text @param {Sink} sink attributes: name, value, name, value, ...
 * @param {number} most characters that its entities may add
 */
export function readXml(text, sink, most) {
  new Reader(text, sink, most).document();
}
