// Small pictures of the drawings that the browser keeps, in a database of their own: nothing of a drawing hangs on them. One that is
// missing, too old or not a picture is made anew. Fetched when there is something to look at.

import { storeOf } from './indexed.js';

/** @typedef {{ blob: Blob, time: number }} Pictured time: when it was made */

const TYPES = ['image/webp', 'image/png'];
/** Bytes that a picture may have. */
export const LARGEST = 1 << 16;

const withStore = storeOf('batten-pictures', 'pictures');

/** Takes nothing on trust: another version, or another program at this address, may have written it. @param {any} value @returns {Pictured | null} */
function checked(value) {
  const { bytes, type, time } = value ?? {};
  const sound = bytes instanceof Uint8Array && bytes.length > 0 && bytes.length <= LARGEST && TYPES.includes(type) && time <= Date.now();
  return sound ? { blob: new Blob([/** @type {BlobPart} */ (bytes)], { type }), time } : null;
}

/** @param {string} id of a drawing @returns {Promise<Pictured | null>} null also where the browser keeps none */
export async function pictureFor(id) {
  return checked(await withStore('readonly', (store) => store.get(id)).catch(() => null));
}

/** Puts it in place of the one before; failing costs a picture, and nothing else. @param {string} id @param {Blob} blob @param {number} time */
export async function keepPicture(id, blob, time) {
  if (blob.size <= LARGEST && TYPES.includes(blob.type)) {
    const bytes = new Uint8Array(await blob.arrayBuffer());
    await withStore('readwrite', (store) => store.put({ bytes, type: blob.type, time }, id)).catch(() => null);
  }
}

/** Removes those of drawings that are no longer there. @param {Set<string>} ids of those that are */
export async function keepOnly(ids) {
  const all = await withStore('readonly', (store) => store.getAllKeys()).catch(() => []);
  const gone = all.filter((id) => !ids.has(String(id)));
  await Promise.all(gone.map((id) => withStore('readwrite', (store) => store.delete(id)).catch(() => null)));
}
