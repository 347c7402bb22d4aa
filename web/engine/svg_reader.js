// Passes an SVG document to the module, element by element.

import { Refusal, word } from '../page/words.js';
import { OK } from './instance.js';
import { beyond, LIMITS } from './limits.js';
import { readXml, XmlBomb, XmlFault } from './xml.js';

/** @typedef {import('./instance.js').Instance} Instance */

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

/** How many numbers path data or a list of points has, at least. @param {string} text */
function numbersIn(text) {
  let [count, within] = [0, false];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    const digit = (code >= 48 && code < 58) || code === 46;
    count += Number(digit && !within);
    within = digit;
  }
  return count;
}

/**
 * Passes every element to the reader.
 * @param {Instance} module @param {number} reader @param {string} text @param {(share: number) => void} watch
 */
function feed(module, reader, text, watch) {
  const { wasm } = module;
  let [count, numbers] = [0, 0];
  readXml(text, {
    start: (name, attributes, at) => {
      if (++count > LIMITS.elements) {
        throw beyond('elements');
      }
      for (let i = 0; i < attributes.length; i += 2) {
        numbers += attributes[i] === 'd' || attributes[i] === 'points' ? numbersIn(attributes[i + 1]) : 0;
      }
      if (numbers > 6 * LIMITS.segments) { // even if all are of cubics
        throw beyond('segments');
      }
      watch(at / text.length);
      check(module.lend([name, ...attributes].join('\0'), (strings) => wasm.svg_start(reader, strings, attributes.length / 2)));
    },
    text: (part) => check(module.lend(part, (address, size) => wasm.svg_text(reader, address, size))),
    end: () => check(wasm.svg_end(reader)),
  }, LIMITS.expanded);
}

/** What the user is told. @param {unknown} error */
function said(error) {
  if (error instanceof XmlFault) {
    return new Refusal(`${word('shell.not-xml')} line ${error.line} at column ${error.column}`);
  }
  return error instanceof XmlBomb ? beyond('expanded') : error;
}

/**
 * Passes an SVG document to a reader, then says what to do with it.
 * @param {Instance} module
 * @param {string} text of the whole file
 * @param {boolean} kept the document keeps the text
 * @param {(reader: number) => number} finish frees the reader
 * @param {(share: number) => void} [watch] told how much has been read
 * @returns {number} status
 */
export function readSvg(module, text, kept, finish, watch = () => {}) {
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
    throw said(error);
  }
  watch(1);
  return finish(reader);
}
