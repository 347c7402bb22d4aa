// Files on the user's disk that were opened, latest first: their handles, in the browser's database. The browser asks
// again before the page may read one. Fetched when files come or are listed.

import { storeOf } from './indexed.js';

/** @typedef {import('./disk.js').Handle} Handle */
/** @typedef {{ handle: Handle, time: number }} Recent */

const STORE = 'recent';
const MOST = 10;
const KEPT = 4 * MOST; // with those that are there more than once, which are left out when the list is read

const withStore = storeOf('batten', STORE);

/**
 * Writes a list made from the one that is there, in one transaction: whatever is begun later finds it.
 * @param {(all: Recent[]) => Recent[]} change
 */
async function rewrite(change) {
  await withStore('readwrite', (store) => {
    const reading = store.get(STORE);
    reading.onsuccess = () => store.put(change(Array.isArray(reading.result) ? reading.result : []), STORE);
    return reading;
  }).catch(() => null); // a list fewer, no loss
}

/** Which of them are that file. @param {Recent[]} all @param {Handle} handle */
const areSame = (all, handle) => Promise.all(all.map((one) => one.handle.isSameEntry(handle)));

/** @returns {Promise<Recent[]>} each file once, where it was opened last; none where the browser keeps nothing */
export async function recent() {
  const all = await withStore('readonly', (store) => store.get(STORE)).catch(() => null);
  /** @type {Recent[]} */
  const once = [];
  for (const one of Array.isArray(all) ? all : []) {
    if (!(await areSame(once, one.handle)).includes(true)) {
      once.push(one);
    }
  }
  return once.slice(0, MOST);
}

/** Puts a file at the head of the list. @param {Handle} handle */
export async function remember(handle) {
  await rewrite((all) => [{ handle, time: Date.now() }, ...all].slice(0, KEPT));
}

/** Takes a file off the list; the file itself stays. @param {Handle} handle */
export async function forget(handle) {
  const all = await recent();
  const same = await areSame(all, handle);
  await rewrite(() => all.filter((_, i) => !same[i]));
}
