// Several files as one: a zip file whose entries are stored as they are, which pictures and small files lose nothing by.

import { checksum, joined } from '../keep/records.js';

/** @typedef {{ name: string, bytes: Uint8Array }} Entry */

export const ZIP = 'application/zip';
const UTF8 = 1 << 11; // of the names
const VERSION = 20;

/** Numbers of 2 or 4 bytes. @param {[number, number][]} fields size and value @returns {Uint8Array} */
function packed(fields) {
  const view = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  fields.reduce((at, [size, value]) => {
    if (size === 2) {
      view.setUint16(at, value, true);
    } else {
      view.setUint32(at, value, true);
    }
    return at + size;
  }, 0);
  return new Uint8Array(view.buffer);
}

/** @param {Entry[]} entries fewer than 65,536, and 4 GB @param {Date} [time] of all of them @returns {Uint8Array} */
export function zipOf(entries, time = new Date()) {
  const clock = (time.getHours() << 11) | (time.getMinutes() << 5) | (time.getSeconds() >> 1);
  const day = (Math.max(0, time.getFullYear() - 1980) << 9) | ((time.getMonth() + 1) << 5) | time.getDate();
  /** @type {Uint8Array[]} */
  const parts = [];
  /** @type {Uint8Array[]} */
  const list = [];
  let at = 0;
  for (const { name, bytes } of entries) {
    const title = new TextEncoder().encode(name);
    /** @type {[number, number][]} */
    const both = [[2, VERSION], [2, UTF8], [2, 0], [2, clock], [2, day], [4, Number.parseInt(checksum(bytes), 16)], [4, bytes.length], [4, bytes.length],
      [2, title.length], [2, 0]];
    const head = packed([[4, 0x04034b50], ...both]);
    parts.push(head, title, bytes);
    list.push(packed([[4, 0x02014b50], [2, VERSION], ...both, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]]), title);
    at += head.length + title.length + bytes.length;
  }
  const directory = joined(list);
  return joined([...parts, directory, packed([[4, 0x06054b50], [2, 0], [2, 0], [2, entries.length], [2, entries.length], [4, directory.length], [4, at], [2, 0]])]);
}
