// Files on the user's disk that were opened, latest first: their handles, in the browser's database. The browser asks
// again before the page may read one. Fetched when files come or are listed.

/** @typedef {import('./disk.js').Handle} Handle */
/** @typedef {{ handle: Handle, time: number }} Recent */

const STORE = 'recent';
const MOST = 10;

/**
 * Runs `work` on the store. @template T
 * @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => IDBRequest<T>} work @returns {Promise<T>}
 */
function withStore(mode, work) {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('batten', 1);
    opening.onerror = () => reject(opening.error);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE);
    opening.onsuccess = () => {
      const database = opening.result;
      const transaction = database.transaction(STORE, mode);
      const request = work(transaction.objectStore(STORE));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = () => reject(transaction.error);
      transaction.addEventListener('complete', () => database.close());
      transaction.addEventListener('abort', () => database.close());
    };
  });
}

/** @returns {Promise<Recent[]>} none where the browser keeps nothing */
export async function recent() {
  const all = await withStore('readonly', (store) => store.get(STORE)).catch(() => null);
  return Array.isArray(all) ? all : [];
}

/** @param {Recent[]} all */
async function write(all) {
  await withStore('readwrite', (store) => store.put(all.slice(0, MOST), STORE)).catch(() => null); // a list fewer, no loss
}

/** @param {Recent[]} all @param {Handle} handle */
async function without(all, handle) {
  const same = await Promise.all(all.map((one) => one.handle.isSameEntry(handle)));
  return all.filter((_, i) => !same[i]);
}

/** Puts a file at the head of the list. @param {Handle} handle */
export async function remember(handle) {
  await write([{ handle, time: Date.now() }, ...await without(await recent(), handle)]);
}

/** Takes a file off the list; the file itself stays. @param {Handle} handle */
export async function forget(handle) {
  await write(await without(await recent(), handle));
}
