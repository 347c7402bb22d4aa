// Reads XML: elements, attributes and text, with the entities that a document declares itself. Nothing is fetched.
import { BattenError } from './error.js';

const NAME = '[^\\s<>/=!?"\'&]+';
const TOKEN = new RegExp(`<!--[^]*?-->|<\\?[^]*?\\?>|<!\\[CDATA\\[([^]*?)\\]\\]>|</(${NAME})\\s*>|<(${NAME})((?:\\s+${NAME}\\s*=\\s*(?:"[^<"]*"|'[^<']*'))*)\\s*(/?)>|([^<]+)`, 'y');
const ATTRIBUTE = new RegExp(`(${NAME})\\s*=\\s*(?:"([^"]*)"|'([^']*)')`, 'g');
const ENTITY = new RegExp(`<!ENTITY\\s+(${NAME})\\s+(?:"([^"]*)"|'([^']*)'|(SYSTEM|PUBLIC))`, 'g');
const TYPE = /"[^"]*"|'[^']*'|<!--[^]*?-->|[[\]<>]|[^"'[\]<>]+/y;
const KNOWN = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };
const DEEP = 16; // entities within entities
const MOST = 1 << 22; // characters that entities may become, in all

/** @param {string} text @param {{ start: (name: string, attributes: string[]) => void, text: (text: string) => void, end: () => void }} told */
export function readXml(text, told) {
  const declared = new Map();
  const open = [];
  let at = text.startsWith('\ufeff') ? 1 : 0;
  let roots = 0;
  let expanded = 0;

  const refuse = (why) => {
    const before = text.slice(0, at).split('\n');
    throw new BattenError('syntax', `line ${before.length}, column ${before.at(-1).length + 1}: ${why}`);
  };
  const resolved = (value, depth = 0) => (value.includes('&') ? value.replace(/&([^;&\s]*);?/g, (whole, name) => {
    const code = /^#(?:x([\da-f]+)|(\d+))$/i.exec(name);
    const number = code && parseInt(code[1] ?? code[2], code[1] ? 16 : 10);
    if (code ? number > 0x10ffff : !whole.endsWith(';') || !(name in KNOWN || typeof declared.get(name) === 'string') || depth === DEEP) {
      return refuse(declared.get(name) === null ? `the entity ${name} is in another file` : `expected an entity that is declared, found ${whole.slice(0, 40)}`);
    }
    const found = code ? String.fromCodePoint(number) : KNOWN[name] ?? resolved(declared.get(name), depth + 1);
    expanded += found.length;
    return expanded > MOST ? refuse('entities expand out of proportion') : found;
  }) : value);
  const attributes = (written) => {
    const found = [...written.matchAll(ATTRIBUTE)].flatMap(([, name, double, single]) => [name, resolved(double ?? single).replace(/[\t\r\n]/g, ' ')]);
    const names = found.filter((_, i) => i % 2 === 0);
    return new Set(names).size === names.length ? found : refuse('an attribute is there twice');
  };
  const documentType = () => {
    const from = at;
    for (let depth = 0; at < text.length;) {
      TYPE.lastIndex = at;
      const [part] = TYPE.exec(text) ?? refuse('the document type does not end');
      at += part.length;
      depth += part === '<' || part === '[' ? 1 : part === '>' || part === ']' ? -1 : 0;
      if (depth === 0) {
        break;
      }
    }
    for (const [, name, double, single] of text.slice(from, at).matchAll(ENTITY)) {
      declared.set(name, declared.get(name) ?? double ?? single ?? null);
    }
  };

  while (at < text.length) {
    TOKEN.lastIndex = at;
    const token = TOKEN.exec(text);
    if (!token && text.startsWith('<!DOCTYPE', at) && roots === 0) {
      documentType();
      continue;
    }
    const [whole, data, ended, begun, written, alone, characters] = token ?? refuse(`expected a tag or text, found ${JSON.stringify(text.slice(at, at + 20))}`);
    if (begun !== undefined) {
      roots += open.length === 0 ? 1 : 0;
      if (roots > 1) {
        refuse('there is something behind the end');
      }
      told.start(begun, attributes(written));
      open.push(begun);
    }
    if (ended !== undefined && open.at(-1) !== ended) {
      refuse(`expected ${open.length ? `</${open.at(-1)}>` : 'no end'}, found </${ended}>`);
    }
    if (ended !== undefined || alone === '/') {
      open.pop();
      told.end();
    }
    const said = data ?? (characters && resolved(characters));
    if (said && open.length > 0) {
      told.text(said);
    } else if (said?.trim()) {
      refuse('there is text outside of the elements');
    }
    at += whole.length;
  }
  if (open.length > 0 || roots === 0) {
    refuse(roots ? `<${open.at(-1)}> does not end` : 'there is no element');
  }
}
