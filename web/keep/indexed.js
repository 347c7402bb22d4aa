// Stores of the browser's database that are asked for something now and then: each request opens the database and closes it again.

/**
 * A store, which is made when it is not there. What it gives runs a request on it, and has the answer when that is done.
 * @param {string} name of its database @param {string} store
 * @returns {<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>) => Promise<T>}
 */
export const storeOf = (name, store) => (mode, work) => new Promise((resolve, reject) => {
  const opening = indexedDB.open(name, 1);
  opening.onerror = () => reject(opening.error);
  opening.onupgradeneeded = () => opening.result.createObjectStore(store);
  opening.onsuccess = () => {
    const database = opening.result;
    database.onversionchange = () => database.close();
    const transaction = database.transaction(store, mode);
    const request = work(transaction.objectStore(store));
    transaction.oncomplete = () => resolve(request.result);
    transaction.onabort = () => reject(transaction.error);
    transaction.addEventListener('complete', () => database.close());
    transaction.addEventListener('abort', () => database.close());
  };
});
