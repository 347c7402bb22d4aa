// Passes an SVG document to the module, element by element.

import { Refusal, word } from '../page/words.js';
import { OK } from './instance.js';
import { plain } from './svg.js';

/** @typedef {import('./instance.js').Instance} Instance */

/**
 * Passes an element and everything in it to the reader, in document order, without recursion: files may nest deeply.
 * @param {Instance} module
 * @param {number} reader
 * @param {Element} root
 * @returns {number} status
 */
function walk(module, reader, root) {
  /** @type {Node | null} */
  let node = root;
  while (node) {
    let status = OK;
    if (node.nodeType === Node.ELEMENT_NODE) {
      const element = /** @type {Element} */ (node);
      const strings = [element.nodeName];
      for (const attribute of element.attributes) {
        strings.push(attribute.name, plain(attribute.value));
      }
      const pairs = element.attributes.length;
      status = module.lend(strings.join('\0'), (text) => module.wasm.svg_start(reader, text, pairs));
    } else if (node.nodeType === Node.TEXT_NODE || node.nodeType === Node.CDATA_SECTION_NODE) {
      status = module.lend(plain(node.nodeValue ?? ''), (text, size) => module.wasm.svg_text(reader, text, size));
    }
    if (status !== OK) {
      return status;
    }
    if (node.firstChild) {
      node = node.firstChild;
      continue;
    }
    for (;;) {
      if (node.nodeType === Node.ELEMENT_NODE) {
        status = module.wasm.svg_end(reader);
        if (status !== OK) {
          return status;
        }
      }
      if (node === root) {
        return OK;
      }
      if (node.nextSibling) {
        node = node.nextSibling;
        break;
      }
      node = /** @type {Node} */ (node.parentNode);
    }
  }
  return OK;
}

/**
 * Passes an SVG document to a reader, then says what to do with it.
 * @param {Instance} module
 * @param {Element} root
 * @param {string} text of the whole file, '' when it is not to be kept
 * @param {(reader: number) => number} finish frees the reader
 * @returns {number} status
 */
export function readSvg(module, root, text, finish) {
  const reader = module.wasm.svg_begin();
  if (!reader) {
    throw new Refusal(word('shell.no-memory'));
  }
  const refused = walk(module, reader, root) ||
    (text ? module.lend(text, (source, size) => module.wasm.svg_source(reader, source, size)) : OK);
  if (refused !== OK) {
    module.wasm.svg_cancel(reader, module.scratch);
    return refused;
  }
  return finish(reader);
}
