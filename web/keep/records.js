// What a kept drawing looks like on the disk: text, records one after the other, each with its number and a checksum, so that
// one that is spoilt costs no other. A record is a line "#KIND NUMBER LENGTH CHECKSUM", its content, and a line break. The last
// one is the end, which the next records overwrite: where it is missing, something has been cut off.

/** The kinds. HEAD: what drawing it is, as JSON; LINE: a line of its journal; READY: all before it was read back. */
export const Kind = { HEAD: 'H', LINE: 'J', READY: 'R', END: 'E' };

/** @typedef {{ id: string, name: string, place: string }} Head place: the file that it is unsaved work on; '' when there is none */
/** What a file holds. number: of the next record; end: where it is written; whole: nothing is spoilt or cut off.
 * @typedef {{ head: Head | null, journal: Uint8Array, ready: boolean, number: number, end: number, whole: boolean }} Content */

const NEWLINE = 10;
const MARK = 35;
const LONGEST = 64; // bytes of a record's first line
const TITLE = /^#([A-Z]) (\d{1,15}) (\d{1,15}) ([0-9a-f]{8})$/;
const encoder = new TextEncoder();
const decoder = new TextDecoder();

const BREAK = encoder.encode('\n');
/** In place of a line that is spoilt: no reader knows it, so that it counts as a step that is missing. */
const GAP = encoder.encode('{"spoilt":true}');

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; bit++) {
    sum = sum & 1 ? 0xedb88320 ^ (sum >>> 1) : sum >>> 1;
  }
  return sum;
});

/** CRC-32 as in zip files. @param {Uint8Array[]} parts @returns {string} eight hexadecimal digits */
export function checksum(...parts) {
  let sum = 0xffffffff;
  for (const part of parts) {
    for (let i = 0; i < part.length; i++) {
      sum = TABLE[(sum ^ part[i]) & 255] ^ (sum >>> 8);
    }
  }
  return (~sum >>> 0).toString(16).padStart(8, '0');
}

/** @param {Uint8Array[]} parts @returns {Uint8Array} */
export function joined(parts) {
  const all = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  parts.reduce((at, part) => (all.set(part, at), at + part.length), 0);
  return all;
}

/** @param {string} kind @param {number} number @param {Uint8Array} content */
function record(kind, number, content) {
  const title = `#${kind} ${number} ${content.length}`;
  return [encoder.encode(`${title} ${checksum(encoder.encode(title), content)}\n`), content, BREAK];
}

/** The lines of a journal without their line breaks, the last one even when it has none. @param {Uint8Array} journal */
function linesOf(journal) {
  const lines = [];
  for (let at = 0; at < journal.length;) {
    const next = journal.indexOf(NEWLINE, at);
    const end = next < 0 ? journal.length : next;
    lines.push(journal.subarray(at, end));
    at = end + 1;
  }
  return lines;
}

/** The end of a file. @param {number} number @returns {Uint8Array} */
export const endOf = (number) => joined(record(Kind.END, number, new Uint8Array(0)));

/** A journal's lines as records. @param {Uint8Array} journal @param {number} number of the first @returns {{ bytes: Uint8Array, number: number }} */
export function recordsOf(journal, number) {
  const lines = linesOf(journal);
  return { bytes: joined(lines.flatMap((line, i) => record(Kind.LINE, number + i, line))), number: number + lines.length };
}

/** @param {Head} head @returns {Uint8Array} */
export const headOf = (head) => joined(record(Kind.HEAD, 0, encoder.encode(JSON.stringify(head))));

/** @param {number} number @returns {Uint8Array} */
export const readyOf = (number) => joined(record(Kind.READY, number, new Uint8Array(0)));

/**
 * What the first line of a record says. null: there is none.
 * @param {Uint8Array} bytes @param {number} at
 */
function titleAt(bytes, at) {
  const stop = bytes[at] === MARK ? bytes.subarray(at, at + LONGEST).indexOf(NEWLINE) : -1;
  const found = stop >= 0 ? TITLE.exec(decoder.decode(bytes.subarray(at, at + stop))) : null;
  return found && { kind: found[1], number: Number(found[2]), sum: found[4], from: at + stop + 1, to: at + stop + 1 + Number(found[3]),
    title: bytes.subarray(at, at + stop - 1 - found[4].length) };
}

/**
 * The record that begins at a place. sound: its checksum is right. null: none begins there, or what spoilt it may be its length.
 * @param {Uint8Array} bytes @param {number} at @param {number} number that is expected
 */
function recordAt(bytes, at, number) {
  const found = titleAt(bytes, at);
  if (!found || found.to > bytes.length) {
    return null;
  }
  const content = bytes.subarray(found.from, found.to);
  const sound = checksum(found.title, content) === found.sum;
  if (sound ? found.number < number || found.number > number + bytes.length :
    found.kind !== Kind.LINE || found.number !== number || titleAt(bytes, found.to + 1)?.number !== number + 1) {
    return null;
  }
  return { kind: found.kind, number: found.number, content, end: found.to + 1, sound, closed: bytes[found.to] === NEWLINE };
}

/** Where the next record may begin after one that is spoilt. @param {Uint8Array} bytes @param {number} at */
function nextMark(bytes, at) {
  for (let i = bytes.indexOf(NEWLINE, at); i >= 0; i = bytes.indexOf(NEWLINE, i + 1)) {
    if (bytes[i + 1] === MARK) {
      return i + 1;
    }
  }
  return bytes.length;
}

/** @param {Uint8Array} content @returns {Head | null} */
function readHead(content) {
  try {
    const { id, name, place } = JSON.parse(decoder.decode(content));
    return { id: String(id), name: String(name), place: String(place) };
  } catch {
    return null;
  }
}

/** In how many letters a text differs from a word at its beginning. @param {string} text @param {string} word */
const differs = (text, word) => [...word].filter((letter, i) => text[i] !== letter).length;

/**
 * What stands in for a line that is spoilt: the document that a journal begins with as it is, for without it nothing
 * follows; undo and redo, whose few letters can still be recognised.
 * @param {Uint8Array} content @param {boolean} first
 */
function substitute(content, first) {
  const text = decoder.decode(content.subarray(0, LONGEST));
  const known = ['{"do":"undo"', '{"do":"redo"'].find((step) => differs(text, step) <= 1);
  return first ? content : known ? encoder.encode(`${known}}`) : GAP;
}

/** Reads a file, whatever has happened to it. @param {Uint8Array} bytes @returns {Content} */
export function read(bytes) {
  /** @type {Uint8Array[]} */
  const lines = [];
  /** @type {Content} */
  const content = { head: null, journal: bytes.subarray(0, 0), ready: false, number: 0, end: 0, whole: true };
  let closed = false;
  /** @param {Uint8Array} line */
  const add = (line) => lines.push(line, BREAK);
  for (let at = 0; at < bytes.length && !closed;) {
    const one = recordAt(bytes, at, content.number);
    if (!one) {
      content.whole = false;
      at = nextMark(bytes, at);
      continue;
    }
    for (; content.number < one.number; content.number++) { // what was there cannot be found
      content.whole = false;
      if (content.number > 0) {
        add(GAP);
      }
    }
    closed = one.kind === Kind.END;
    if (one.kind === Kind.LINE) {
      add(one.sound ? one.content : substitute(one.content, lines.length === 0));
    }
    content.head ??= one.kind === Kind.HEAD ? readHead(one.content) : null;
    content.ready ||= one.kind === Kind.READY;
    content.whole &&= one.sound && one.closed;
    content.number += closed ? 0 : 1;
    content.end = closed ? at : one.end;
    at = one.end;
  }
  return { ...content, journal: joined(lines), whole: content.whole && closed };
}
