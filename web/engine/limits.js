// What a file may hold that is opened in a page. What goes beyond is refused in a sentence with the number.

import { Refusal, word } from '../page/words.js';

const MB = 20; // 1 << MB bytes

export const LIMITS = {
  /** Bytes, when it is unpacked. */
  bytes: 1 << 27,
  /** Characters that its entities add. */
  expanded: 1 << 23,
  /** Elements of an SVG file. */
  elements: 500000,
  /** Of the curves that are painted; each has at most six coordinates. */
  segments: 300000,
};

/** @param {keyof typeof LIMITS} limit @returns {Refusal} */
export function beyond(limit) {
  const most = LIMITS[limit];
  return new Refusal(word(`shell.beyond-${limit}.help`, most % (1 << MB) ? most.toLocaleString('en') : `${most >> MB} MB`));
}
