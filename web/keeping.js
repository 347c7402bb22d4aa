// The worker behind keep.js: writes journals. Only workers can write in place and know when it is done.

import { folderOf, journals } from './keep.js';

const DRAWINGS = 30; // kept at most; the one untouched for longest goes

/** @typedef {{ write: (data: Uint8Array, options: { at: number }) => number, flush: () => void, close: () => void }} Access */
/** @typedef {{ name: string, bytes?: Uint8Array, more?: boolean }} Job what to do: add `bytes` or, without `more`,
 * begin with them; without bytes drop the drawing; without a name let go of the file */

/** The journal being written. @type {Access | null} */
let access = null;
let size = 0;

/** @param {Uint8Array} bytes @param {number} at */
function put(bytes, at) {
  if (!access || access.write(bytes, { at }) < bytes.length) {
    throw new Error('there is no room');
  }
  access.flush();
}

function close() {
  access?.close();
  access = null;
}

/** @param {string} name @param {Uint8Array} bytes */
async function begin(name, bytes) {
  close();
  const all = await journals();
  const key = await folderOf(name);
  const folder = await all.getDirectoryHandle(key, { create: true });
  const others = [];
  for await (const other of folder.keys()) {
    others.push(other);
  }
  const number = String(Math.max(0, ...others.map(Number)) + 1);
  const handle = /** @type {any} */ (await folder.getFileHandle(number, { create: true }));
  access = /** @type {Access} */ (await handle.createSyncAccessHandle());
  try {
    const first = bytes.slice(0, 1);
    bytes[0] = 0;
    put(bytes, 0);
    put(first, 0);
    size = bytes.length;
  } catch (error) {
    close();
    await folder.removeEntry(number);
    throw error;
  }
  // What another page still holds cannot be removed, and is left.
  await Promise.allSettled(others.map((other) => folder.removeEntry(other)));
  await prune(all, key);
}

/** @param {FileSystemDirectoryHandle} all @param {string} own */
async function prune(all, own) {
  /** @type {[number, string][]} */
  const ages = [];
  for await (const [key, folder] of all.entries()) {
    let time = 0;
    for await (const file of /** @type {FileSystemDirectoryHandle} */ (folder).values()) {
      time = Math.max(time, (await /** @type {FileSystemFileHandle} */ (file).getFile()).lastModified);
    }
    ages.push([key === own ? Infinity : time, key]);
  }
  const old = ages.sort(([a], [b]) => b - a).slice(DRAWINGS);
  await Promise.allSettled(old.map(([, key]) => all.removeEntry(key, { recursive: true })));
}

/** @param {Job} job */
async function work({ name, bytes, more }) {
  if (bytes && more && access) {
    put(bytes, size);
    size += bytes.length;
  } else if (bytes && !more) {
    await begin(name, bytes);
  } else if (bytes) {
    throw new Error('there is no journal to add to');
  } else {
    close();
    if (name) {
      const all = await journals();
      await all.removeEntry(await folderOf(name), { recursive: true }).catch(() => {});
    }
  }
}

/** One job after the other. */
let last = Promise.resolve();
onmessage = ({ data }) => {
  last = last.then(() => work(data)).then(() => postMessage(''), (error) => {
    close();
    postMessage(String(error));
  });
};
