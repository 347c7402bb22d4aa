// Files on the user's disk that the page may write: the drawing is saved back to the one that was opened, where the
// browser has File System Access. Fetched when files are chosen or dropped.

import { Changed } from './server.js';
import { word } from '../page/words.js';

/** What the browser gives for a file: its type is not in every version of the DOM's declarations. */
/** @typedef {{ kind: string, name: string, getFile: () => Promise<File>, createWritable: () => Promise<any>,
 * isSameEntry: (other: Handle) => Promise<boolean>, requestPermission?: (how: { mode: string }) => Promise<string> }} Handle */

/** Only these are written as they were read. */
const OURS = /\.(svg|batten)$/i;

/** @param {File} file */
const tagOf = (file) => `${file.lastModified}-${file.size}`;

/** A file with the calls of the server's file. */
export class Disk {
  /** @param {Handle} handle @param {File} file as it was opened */
  constructor(handle, file) {
    this.handle = handle;
    this.tag = tagOf(file);
  }

  /** Reads it as the version that the drawing is based on. @returns {Promise<import('./server.js').FileBytes>} */
  async load() {
    const file = await this.look();
    this.tag = file.tag;
    return file;
  }

  /** Reads it as it is now. @returns {Promise<import('./server.js').FileBytes>} */
  async look() {
    const file = await this.handle.getFile();
    return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()), tag: tagOf(file) };
  }

  /** @returns {Promise<string>} the tag of the file now */
  async hear() {
    return tagOf(await this.handle.getFile());
  }

  /**
   * Replaces its content; the browser may ask first. It is written whole or not at all.
   * @param {Uint8Array} bytes @param {string} _type
   * @param {string} [over] the tag of the version that they replace
   */
  async save(bytes, _type, over = this.tag) {
    if (await this.hear() !== over) {
      throw new Changed(word('shell.changed'));
    }
    const writable = await this.handle.createWritable().catch((/** @type {unknown} */ error) => {
      throw new Error(word('shell.not-allowed', this.handle.name), { cause: error });
    });
    try {
      await writable.write(bytes);
      await writable.close();
    } catch (error) {
      const full = error instanceof DOMException && error.name === 'QuotaExceededError';
      throw full ? new Error(word('shell.disk-full'), { cause: error }) : error;
    }
    this.tag = await this.hear();
  }

  /** A page may not write beside a file. @returns {Promise<string>} */
  saveBeside() {
    return Promise.reject(new Error(word('shell.not-beside')));
  }
}

/** @param {Handle} handle @param {File} file */
const placeOf = (handle, file) => (OURS.test(file.name) ? new Disk(handle, file) : null);

/** Asks for files. @returns {Promise<import('./files.js').Arrival[]>} */
export async function ask() {
  try {
    const handles = /** @type {Handle[]} */ (await /** @type {any} */ (window).showOpenFilePicker({ multiple: true }));
    return await Promise.all(handles.map(async (handle) => {
      const file = await handle.getFile();
      return { file, place: placeOf(handle, file) };
    }));
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') {
      return []; // nothing was chosen
    }
    throw error;
  }
}

/** A file that was opened before. @param {Handle} handle @returns {Promise<import('./files.js').Arrival | null>} null: it cannot be read */
export async function again(handle) {
  try {
    const may = await handle.requestPermission?.({ mode: 'read' }) ?? 'granted';
    const file = may === 'granted' ? await handle.getFile() : null;
    return file && { file, place: placeOf(handle, file) };
  } catch {
    return null;
  }
}

/**
 * What was dropped. @param {Promise<{ file: File | null, handle: Handle | null | undefined }>[]} dropped
 * @returns {Promise<import('./files.js').Arrival[]>}
 */
export async function placed(dropped) {
  const all = await Promise.all(dropped);
  return all.flatMap(({ file, handle }) => (file ? [{ file, place: handle?.kind === 'file' ? placeOf(handle, file) : null }] : []));
}
