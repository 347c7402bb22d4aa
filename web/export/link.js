// A journal in the fragment of an address, which no server sees: packed, in letters that addresses may have.

import { Refusal, word } from '../page/words.js';

export const MOST = 8192; // characters of a link that every program passes on whole
const UNPACKED = 1 << 24; // bytes
const KEY = 'replay';

/** What comes out of a stream; too much is refused. @param {ReadableStream<Uint8Array>} stream */
async function unpacked(stream) {
  /** @type {Uint8Array[]} */
  const parts = [];
  let size = 0;
  for await (const part of /** @type {any} */ (stream)) {
    size += part.length;
    if (size > UNPACKED) {
      throw new Refusal(word('shell.damaged'));
    }
    parts.push(part);
  }
  return new Uint8Array(await new Blob(/** @type {BlobPart[]} */ (parts)).arrayBuffer());
}

/** Without the digests, which only check it. @param {Uint8Array} journal */
const bare = (journal) => new Blob([new TextDecoder().decode(journal).replace(/,"digest":"[0-9a-f]{16}"\}$/gm, '}')]);

/**
 * The address of this page that replays a journal.
 * @param {Uint8Array} journal @returns {Promise<string>}
 */
export async function linkOf(journal) {
  const stream = bare(journal).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const packed = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = '';
  for (let i = 0; i < packed.length; i += 0x8000) {
    letters += String.fromCharCode(...packed.subarray(i, i + 0x8000));
  }
  const text = btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  return `${location.origin}${location.pathname}#${KEY}=${text}`;
}

/** The journal in what an address carries. @param {string} text @returns {Promise<Uint8Array>} */
export async function journalOf(text) {
  try {
    const letters = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
    const packed = new Blob([Uint8Array.from(letters, (letter) => letter.charCodeAt(0))]);
    return await unpacked(packed.stream().pipeThrough(new DecompressionStream('deflate-raw')));
  } catch {
    throw new Refusal(word('shell.damaged'));
  }
}
