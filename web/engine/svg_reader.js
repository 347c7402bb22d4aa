// Passes an SVG document to the module, element by element.

import { Refusal, word } from '../page/words.js';
import { OK } from './instance.js';
import { readXml, XmlFault } from './xml.js';

/** @typedef {import('./instance.js').Instance} Instance */
/**
 * Follows the reading of a file, and may throw to end it. expanded: characters that its entities may add.
 * @typedef {{ expanded: number, see: (share: number, attributes: string[]) => void }} Watch
 */

/** Of what is read at once, which is small. @type {Watch} */
const NONE = { expanded: 0, see: () => {} };

/** The module takes no more. */
class Refused extends Error {
  /** @param {number} status */
  constructor(status) {
    super();
    this.status = status;
  }
}

/** @param {number} status */
function check(status) {
  if (status !== OK) {
    throw new Refused(status);
  }
}

/** Passes every element to the reader. @param {Instance} module @param {number} reader @param {string} text @param {Watch} watch */
function feed(module, reader, text, { expanded, see }) {
  const { wasm } = module;
  readXml(text, {
    start: (name, attributes, at) => {
      see(at / text.length, attributes);
      check(module.lend([name, ...attributes].join('\0'), (strings) => wasm.svg_start(reader, strings, attributes.length / 2)));
    },
    text: (part) => check(module.lend(part, (address, size) => wasm.svg_text(reader, address, size))),
    end: () => check(wasm.svg_end(reader)),
  }, expanded);
}

/**
 * Passes an SVG document to a reader, then says what to do with it.
 * @param {Instance} module
 * @param {string} text of the whole file
 * @param {boolean} kept the document keeps the text
 * @param {(reader: number) => number} finish frees the reader
 * @param {Watch} [watch]
 * @returns {number} status
 */
export function readSvg(module, text, kept, finish, watch = NONE) {
  const reader = module.wasm.svg_begin();
  if (!reader) {
    throw new Refusal(word('shell.no-memory'));
  }
  try {
    feed(module, reader, text, watch);
    if (kept) {
      check(module.lend(text, (source, size) => module.wasm.svg_source(reader, source, size)));
    }
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      throw error; // the whole instance is given up
    }
    module.wasm.svg_cancel(reader, module.scratch);
    if (error instanceof Refused) {
      return error.status;
    }
    throw error instanceof XmlFault ? new Refusal(`${word('shell.not-xml')} line ${error.line} at column ${error.column}`) : error;
  }
  watch.see(1, []);
  return finish(reader);
}
