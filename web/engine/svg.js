// SVG files as parsed by the browser's XML parser. Elements outside the SVG namespace are plain elements: the browser
// does not apply or run the styles and scripts in them, which the page's policy would then have to block.

import { Refusal, word } from '../page/words.js';

const SPACES = 'http://www.w3.org/';
const INERT = 'urn:batten:inert:';
const KNOWN = new RegExp(`${SPACES}(2000/svg|1999/xhtml|1998/Math/MathML)`, 'g');

/**
 * @param {string} text
 * @returns {Element} the root
 */
export function parseSvg(text) {
  const tree = new DOMParser().parseFromString(text.replace(KNOWN, `${INERT}$1`), 'image/svg+xml');
  const problem = tree.getElementsByTagName('parsererror')[0];
  if (problem) {
    const line = /line \d+[^:]*/.exec(problem.textContent ?? '')?.[0] ?? '';
    throw new Refusal(`${word('shell.not-xml')} ${line}`.trim());
  }
  return tree.documentElement;
}

/** A value or text of such a file, as written in it. @param {string} text */
export const plain = (text) => text.replaceAll(INERT, SPACES);
