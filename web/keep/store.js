// The drawings that a browser keeps, in a room of files (opfs.js, database.js). Each has an id and a file, ID.GENERATION, to
// which the lines of its journal are added as records (records.js). A shorter journal goes into a new generation; the one
// before is removed only when that has been read back. Small files beside it say more of a drawing: ID.aside, ID.gone, and ID.name
// (manage.js). There is no other directory: what the files say is all.

import { endOf, headOf, joined, read, readyOf, recordsOf } from './records.js';

/** @typedef {import('./records.js').Head} Head */
/** @typedef {import('./records.js').Content} Content */
/** Marks. aside: not opened unless the user asks. gone: deleted by the user, and can be brought back. @typedef {'aside' | 'gone'} Mark */
/** One of those that are kept. broken: the name of its file or nothing of it can be read. @typedef {{ id: string, name: string, place: string,
 * time: number, aside: boolean, gone: boolean, broken: boolean }} Listed */
/** What is kept of a drawing; raw: its file as it is. @typedef {Listed & { journal: Uint8Array, whole: boolean, raw: Uint8Array }} Kept */
/** A file that is open for writing. @typedef {{ write: (bytes: Uint8Array, at: number) => number | Promise<number>, read: () => Uint8Array | Promise<Uint8Array>,
 * flush: () => void | Promise<void>, close: () => void | Promise<void> }} Access */
/** Where files are. @typedef {{ names: () => Promise<string[]>, has: (name: string) => Promise<boolean>, time: (name: string) => Promise<number>,
 * read: (name: string, size?: number) => Promise<Uint8Array>, open: (name: string) => Promise<Access>,
 * remove: (name: string) => Promise<void> }} Room */

const HEAD = 4096; // the head of a file is within its first bytes
const LATER = 30 * 24 * 3600 * 1000; // milliseconds until what the user deleted is deleted for good
const FILE = /^([0-9a-f]{8,64})\.(\d{1,15})$/;

/** There is no room. */
export class Full extends Error {}
/** What was kept has been cleared away. */
export class Cleared extends Error {}
/** Whoever wants to add to a drawing does not have its file. */
export class Closed extends Error {}

/** @param {unknown} error */
const isFull = (error) => error instanceof Full || (error instanceof Error && error.name === 'QuotaExceededError');

export class Store {
  /** @param {Room} room @param {() => number} [now] milliseconds */
  constructor(room, now = Date.now) {
    this.room = room;
    this.now = now;
    /** The file that is being written. @type {{ id: string, file: string, access: Access, number: number, end: number } | null} */
    this.open = null;
    /** The heads of files, which never change. @type {Map<string, Head>} */
    this.heads = new Map();
  }

  /** The generations of each drawing, the latest first. @param {string[]} names @returns {Map<string, number[]>} */
  #generations(names) {
    /** @type {Map<string, number[]>} */
    const all = new Map();
    for (const [, id, generation] of names.map((name) => FILE.exec(name)).filter((found) => found !== null)) {
      all.set(id, [...all.get(id) ?? [], Number(generation)].sort((a, b) => b - a));
    }
    return all;
  }

  /**
   * The file that counts: the latest that was read back; else, of those that were left unfinished, the latest that says anything.
   * @param {string} id @param {number[]} generations @returns {Promise<{ file: string, raw: Uint8Array, content: Content }>}
   */
  async #latest(id, generations) {
    const files = [];
    for (const generation of generations) {
      const file = `${id}.${generation}`;
      const raw = await this.room.read(file);
      files.push({ file, raw, content: read(raw) });
      if (files.at(-1)?.content.ready) {
        break;
      }
    }
    return files.find(({ content }) => content.ready) ?? files.find(({ content }) => content.journal.length > 0) ?? files[0];
  }

  /** @param {string} id @param {number[]} generations @param {string[]} names @returns {Promise<Listed>} */
  async #listed(id, generations, names) {
    const listed = { id, name: '', place: '', time: 0, aside: names.includes(`${id}.aside`), gone: names.includes(`${id}.gone`), broken: false };
    try {
      const file = `${id}.${generations[0]}`;
      listed.time = await this.room.time(file);
      const head = this.heads.get(file) ?? read(await this.room.read(file, HEAD)).head;
      if (head) {
        this.heads.set(file, head);
      }
      const { name, place } = head ?? (await this.#latest(id, generations)).content.head ?? { name: '', place: '' };
      return { ...listed, name: await this.#given(id, generations[0], names) || name, place, broken: name === '' };
    } catch {
      return { ...listed, broken: true }; // it is there, and may be read another time
    }
  }

  /** The name that the user gave it since that generation was begun; '' without one. @param {string} id @param {number} generation @param {string[]} names */
  async #given(id, generation, names) {
    const { head } = read(names.includes(`${id}.name`) ? await this.room.read(`${id}.name`).catch(() => new Uint8Array(0)) : new Uint8Array(0));
    return head && Number(head.place) >= generation ? head.name : '';
  }

  /** All drawings, the latest first; those that the user deleted, too. @returns {Promise<Listed[]>} */
  async list() {
    const names = await this.room.names();
    const all = await Promise.all([...this.#generations(names)].map(([id, generations]) => this.#listed(id, generations, names)));
    return all.sort((a, b) => b.time - a.time);
  }

  /** What is kept of a drawing. null: nothing. Throws when it cannot be read now. @param {string} id @returns {Promise<Kept | null>} */
  async take(id) {
    const names = await this.room.names();
    const generations = this.#generations(names).get(id);
    if (!generations) {
      return null;
    }
    const listed = await this.#listed(id, generations, names);
    const { raw, content: { head, journal, whole } } = await this.#latest(id, generations);
    return { ...listed, name: listed.name || head?.name || '', place: head?.place ?? listed.place, broken: !head, journal, whole, raw };
  }

  /**
   * Keeps a drawing anew: all of its journal, in place of what was kept of it.
   * @param {Head} head @param {Uint8Array} journal
   */
  async begin(head, journal) {
    try {
      await this.#begin(head, journal);
    } catch (error) {
      if (!isFull(error) || !await this.purge(-Infinity)) {
        throw error;
      }
      await this.#begin(head, journal); // what the user had deleted made room
    }
  }

  /** @param {Head} head @param {Uint8Array} journal */
  async #begin(head, journal) {
    await this.release();
    const { id } = head;
    const before = this.#generations(await this.room.names()).get(id) ?? [];
    const file = `${id}.${(before[0] ?? 0) + 1}`;
    const title = headOf(head);
    const { bytes, number } = recordsOf(journal, 1);
    const ready = readyOf(number);
    this.heads.delete(file);
    this.open = { id, file, access: await this.room.open(file), number, end: 0 };
    try {
      await this.#put(joined([title, bytes]));
      const back = await this.open.access.read();
      if (!read(joined([back, endOf(number)])).whole || back.length !== this.open.end) {
        throw new Error('it was not read back as it was written');
      }
      this.open.number++;
      await this.#put(ready, endOf(number + 1));
    } catch (error) {
      await this.release().catch(() => {});
      await this.room.remove(file).catch(() => {});
      throw error;
    }
    // A file that another page holds cannot be removed, and is left.
    await Promise.allSettled(before.map((generation) => this.room.remove(`${id}.${generation}`)));
  }

  /** Adds to the drawing that is being kept. @param {string} id @param {Uint8Array} journal its new lines */
  async append(id, journal) {
    if (this.open?.id !== id) {
      throw new Closed('its file is not open');
    }
    const { bytes, number } = recordsOf(journal, this.open.number);
    try {
      await this.#put(bytes, endOf(number));
      this.open.number = number;
    } catch (error) {
      await this.#giveUp().catch(() => this.release()).catch(() => {});
      throw error;
    }
  }

  /** What follows goes into a new generation; this one ends where it did. */
  async #giveUp() {
    const { open } = this;
    await open?.access.write(endOf(open.number), open.end);
    await open?.access.flush();
    await this.release();
  }

  /** Writes at the end, and knows that it is on the disk. @param {Uint8Array} bytes @param {Uint8Array} [end] that the next one overwrites */
  async #put(bytes, end = new Uint8Array(0)) {
    const { open } = this;
    if (!open) {
      return;
    }
    const all = joined([bytes, end]);
    const written = await open.access.write(all, open.end);
    await open.access.flush();
    if (!await this.room.has(open.file)) { // writing to a file that was cleared away appears to succeed
      throw new Cleared('it was cleared away');
    }
    if (written !== all.length) {
      throw new Full('there is no room');
    }
    open.end += bytes.length;
  }

  /** Leaves the file that is being written. */
  async release() {
    const { open } = this;
    this.open = null;
    await open?.access.close();
  }

  /** Removes a drawing for good: its file elsewhere has it all, or the user says so. @param {string} id */
  async remove(id) {
    if (this.open?.id === id) {
      await this.release();
    }
    const own = (await this.room.names()).filter((name) => name.split('.')[0] === id);
    for (const name of own.sort((a, b) => Number(!FILE.test(a)) - Number(!FILE.test(b)))) { // its marks last
      await this.room.remove(name);
    }
  }

  /** @param {string} id @param {Mark} mark @param {boolean} on */
  async mark(id, mark, on) {
    const name = `${id}.${mark}`;
    if (on) {
      const access = await this.room.open(name);
      await access.write(new Uint8Array(1), 0);
      await access.flush();
      await access.close();
    } else if (await this.room.has(name)) {
      await this.room.remove(name);
    }
  }

  /** Removes for good what the user deleted long ago. @param {number} [age] milliseconds @returns {Promise<number>} how many drawings */
  async purge(age = LATER) {
    let count = 0;
    for (const name of (await this.room.names()).filter((one) => one.endsWith('.gone'))) {
      if (this.now() - await this.room.time(name) >= age) {
        await this.remove(name.split('.')[0]);
        count++;
      }
    }
    return count;
  }
}
