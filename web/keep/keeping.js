// The worker of keep.js, which writes the journals: only workers can write in place and know when it is done.

import { folderOf, journals } from './journals.js';

const DRAWINGS = 30; // kept at most; the least recently changed is removed

/** @typedef {{ write: (data: Uint8Array, options: { at: number }) => number, flush: () => void, close: () => void }} Access */
/** @typedef {{ name: string, bytes?: Uint8Array, more?: boolean }} Job what to do: append `bytes` or, without `more`,
 * begin with them; without bytes drop the drawing; without a name release the file */

/** The journal being written. @type {{ access: Access, folder: FileSystemDirectoryHandle, number: string } | null} */
let file = null;
let size = 0;

/** Whether the file is still where it was made: writing to one that was cleared away appears to succeed. */
async function stands() {
  try {
    await file?.folder.getFileHandle(file.number);
    return true;
  } catch {
    return false;
  }
}

/** @param {Uint8Array} bytes @param {number} at */
async function put(bytes, at) {
  const written = file?.access.write(bytes, { at });
  file?.access.flush();
  if (!(await stands())) {
    throw new DOMException('it was cleared away', 'NotFoundError');
  }
  if (written !== bytes.length) {
    throw new DOMException('there is no room', 'QuotaExceededError');
  }
}

/** Releases the file. Chromium never closes one that was cleared away. */
async function close() {
  const there = await stands();
  if (there) {
    file?.access.close();
  }
  file = null;
  if (!there) {
    throw new DOMException('it was cleared away', 'NotFoundError');
  }
}

/** @param {string} name @param {Uint8Array} bytes */
async function begin(name, bytes) {
  await close();
  const all = await journals();
  const key = await folderOf(name);
  const folder = await all.getDirectoryHandle(key, { create: true });
  const others = [];
  for await (const other of folder.keys()) {
    others.push(other);
  }
  const number = String(Math.max(0, ...others.map(Number)) + 1);
  const handle = /** @type {any} */ (await folder.getFileHandle(number, { create: true }));
  file = { access: /** @type {Access} */ (await handle.createSyncAccessHandle()), folder, number };
  try {
    const first = bytes.slice(0, 1);
    bytes[0] = 0;
    await put(bytes, 0);
    await put(first, 0);
    size = bytes.length;
  } catch (error) {
    await close().catch(() => {});
    await folder.removeEntry(number).catch(() => {});
    throw error;
  }
  // Files that another page still holds cannot be removed, and are left.
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
  if (bytes && more) {
    await put(bytes, size);
    size += bytes.length;
  } else if (bytes) {
    await begin(name, bytes);
  } else {
    await close();
    if (name) {
      const all = await journals();
      await all.removeEntry(await folderOf(name), { recursive: true }).catch(() => {});
    }
  }
}

/** The fault reported to the page for an error. @type {Record<string, import('./keep.js').Fault>} */
const FAULTS = { NotFoundError: 'cleared', QuotaExceededError: 'no-room' };

/** Why there is no file to append to. @type {import('./keep.js').Fault} */
let fault = 'not-kept';

/** @param {Job} job */
async function answer(job) {
  if (job.more && !file) {
    return fault;
  }
  try {
    await work(job);
    return '';
  } catch (error) {
    fault = FAULTS[error instanceof DOMException ? error.name : ''] ?? 'not-kept';
    await close().catch(() => {});
    return fault;
  }
}

/** Jobs run one after the other; the first reports that the worker runs. */
let last = Promise.resolve(postMessage('ready'));
onmessage = ({ data }) => {
  last = last.then(() => answer(data)).then((told) => postMessage(told));
};
