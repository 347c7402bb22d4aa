// Files: opened by drop, picker or server; saved to where they came from, or as a download.

import { want } from '../page/build.js';
import { Changed } from './server.js';
import { isNative, isPlain, isQuick, readInto } from '../engine/reading.js';
import { counted, word } from '../page/words.js';
import { overOwn, written } from './writing.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../page/notice.js').Notices} Notices */
/** @typedef {import('./server.js').Server} Server */
/** @typedef {import('./disk.js').Disk} Disk */
/** @typedef {import('../sheets/holds.js').Content} Content */
/**
 * A file that has been read, beside the drawing that is open.
 * @typedef {object} Read
 * @property {Uint8Array} bytes unpacked
 * @property {() => void} take opens it; throws its refusal
 * @property {Content | null} content what it holds, where that was asked
 */
/** A file to open, and where it is saved back to, if anywhere. @typedef {{ file: File, place: Disk | null }} Arrival */

const SVG = 'image/svg+xml';
const JSON_TYPE = 'application/json';
const PATIENCE = 500; // milliseconds of a save before it is said that it is under way

/** @param {import('../engine/losses.js').Losses} losses */
export const totalOf = (losses) => Object.values(losses).reduce((sum, count) => sum + count, 0);

/** @param {unknown} error */
const textOf = (error) => (error instanceof Error ? error.message : String(error));

/** @param {string} name */
const stemOf = (name) => name.replace(/\.[a-z]{2,6}$/i, '');

export class Files {
  /**
   * @param {Engine} engine
   * @param {Server} server
   * @param {Notices} notices
   * @param {() => void} wake
   */
  constructor(engine, server, notices, wake) {
    this.engine = engine;
    this.server = server;
    /** Where the drawing is saved to, if it is bound. @type {Server | Disk} */
    this.place = server;
    this.notices = notices;
    this.wake = wake;
    this.name = 'drawing.svg';
    /** The bytes that were opened, unchanged. @type {Uint8Array} */
    this.opened = new Uint8Array(0);
    /** Called as soon as a file is open that the user chose. @type {() => Promise<void>} */
    this.onopen = async () => {};
    /** Called when its place has all of it. */
    this.onsaved = () => {};
    /** What was in the opened file and is not in the drawing. @type {import('../engine/losses.js').Losses} */
    this.losses = {};
    /** Whether the user was asked about what is not shown as it is in the file. */
    this.asked = false;
    /** Whether the user has let the file be written anew. */
    this.anew = false;
    /** The document is the file of its place, and is saved there. */
    this.bound = false;
    this.unsaved = false;
    /** The page brought the drawing itself: it is worth keeping once it has been edited. */
    this.given = false;
    /** Something was drawn or changed since the drawing was opened. */
    this.edited = false;
    /** The page is being reloaded and will restore what is not saved. */
    this.leaving = false;
    this.saving = false;
    /** The version that the save which was asked for is to overwrite. @type {string | undefined} */
    this.over = undefined;
    this.picker = /** @type {HTMLInputElement} */ (document.getElementById('picker'));
    this.#listen();
  }

  #listen() {
    const drop = /** @type {HTMLElement} */ (document.getElementById('drop'));
    this.picker.addEventListener('change', () => {
      const all = [...this.picker.files ?? []];
      this.picker.value = '';
      void this.arrive(all.map((file) => ({ file, place: null })));
    });
    addEventListener('dragover', (event) => {
      event.preventDefault();
      drop.hidden = !event.dataTransfer?.types.includes('Files');
    });
    addEventListener('dragleave', (event) => {
      drop.hidden = event.relatedTarget === null || drop.hidden;
    });
    addEventListener('drop', (event) => {
      event.preventDefault();
      drop.hidden = true;
      const items = [...event.dataTransfer?.items ?? []].filter(({ kind }) => kind === 'file');
      // Only in the event itself: where each lies, if the browser tells.
      const arrived = items.map(async (item) => ({ file: item.getAsFile(), handle: await /** @type {any} */ (item).getAsFileSystemHandle?.() }));
      void want(import('./disk.js')).then(async ({ placed }) => this.arrive(await placed(arrived)));
    });
    addEventListener('beforeunload', (event) => {
      if (this.unsaved && !this.leaving) {
        event.preventDefault();
      }
    });
  }

  /** Asks for files. */
  async pick() {
    if ('showOpenFilePicker' in window) {
      const { ask } = await want(import('./disk.js'));
      await this.arrive(await ask());
    } else {
      this.picker.click();
    }
  }

  /** Sets where the drawing is saved to. @param {Disk | null} place */
  bind(place) {
    const { server } = this;
    this.bound = place !== null || server.sole;
    this.place = server.sole ? server : place ?? server;
  }

  /** Whether it is the file that the server of this page has. */
  get served() {
    return this.bound && this.place === this.server && this.server.there;
  }

  /** Opens the server's file, if there is a server. */
  async openServed() {
    try {
      const { name, bytes } = await this.place.load();
      this.bound = await this.open(bytes, name);
    } catch (error) {
      this.complain(error);
    }
  }

  /** Opens the drawing again as it was first opened, or an empty one. */
  async reopen() {
    if (this.bound && !this.server.sole) {
      await this.openServed();
    } else if (this.opened.length > 0) {
      await this.open(this.opened, this.name);
    } else {
      const head = JSON.stringify({ journal: 'batten', version: 1, name: this.name });
      this.engine.replay(new TextEncoder().encode(head));
      this.wake();
    }
  }

  /** Files that were chosen or dropped. @param {Arrival[]} all */
  async arrive(all) {
    const { arrive } = await want(import('./arrive.js'));
    await arrive(this, all);
  }

  /** Adds a picture to trace, behind the drawing. @param {File} file */
  async addPicture(file) {
    const { bytesOf } = await want(import('../stage/pictures.js'));
    this.engine.addPicture(await bytesOf(file), file.name);
    this.wake();
  }

  /**
   * Reads a file beside the drawing: at once what is small, in a worker what may take long.
   * @param {Blob | Uint8Array} file @param {string} name @param {boolean} [asked] whether what it holds is to be told
   * @returns {Promise<Read | null>} null: it was refused, and the user was told why, or cancelled
   */
  async read(file, name, asked = false) {
    const { engine } = this;
    try {
      const bytes = file instanceof Uint8Array ? file : file.size < 1 << 16 ? new Uint8Array(await file.arrayBuffer()) : null;
      if (!bytes || !isPlain(bytes, name)) {
        await engine.module.complete().catch(() => {}); // the engine then says what it lacks
      }
      if (!bytes || asked || !isQuick(bytes)) {
        const { readApart } = await want(import('./apart.js'));
        return await readApart(engine, file, name, asked);
      }
      return { bytes, take: () => readInto(engine, bytes, name), content: null };
    } catch (error) {
      this.refuse(name, error);
      return null;
    }
  }

  /**
   * Opens what has been read. @param {Read} read @param {string} name
   * @returns {boolean} whether it is open now; if not, the user was told why
   */
  take({ bytes, take }, name) {
    try {
      take();
      this.losses = this.engine.losses;
      const { lost } = this.engine;
      if (lost) {
        this.notices.say(counted(this.engine.keeps ? 'shell.unshown' : 'shell.loses', lost));
      }
      this.notices.over('unsaved', 'uncopied'); // of another drawing
      this.name = name;
      this.opened = bytes;
      this.asked = this.anew = this.given = false;
      return true;
    } catch (error) {
      this.refuse(name, error);
      return false;
    } finally {
      this.wake();
    }
  }

  /**
   * @param {Blob | Uint8Array} file
   * @param {string} name
   * @returns {Promise<boolean>} whether it is open now; if not, the user was told why, or cancelled it
   */
  async open(file, name) {
    const read = await this.read(file, name);
    return read !== null && this.take(read, name);
  }

  /**
   * Saves to its place, else as a download.
   * @param {string} [over] the version to overwrite, when not the one that the drawing was opened from
   */
  async save(over = this.over) {
    const native = isNative(this.name);
    this.over = undefined;
    if (!this.bound) {
      if (await this.download(native, () => this.saveNow())) {
        this.engine.saved();
        this.wake();
      }
      return;
    }
    if (this.saving) {
      return;
    }
    this.saving = true;
    let slow = 0;
    try {
      if (!native && !over && !(await this.#mayLose())) {
        return;
      }
      slow = setTimeout(() => this.notices.ask('saving', word('shell.saving.help', this.name), [], true), PATIENCE);
      // Another drawing may be opened meanwhile.
      const { place, engine: { drawing } } = this;
      const bytes = await (over ? written(this.engine, native) : overOwn(this, native));
      if (!bytes) {
        return;
      }
      // The engine remembers the state that it asked to have saved: anything drawn meanwhile stays unsaved.
      await place.save(bytes, native ? JSON_TYPE : SVG, over);
      if (drawing !== this.engine.drawing) {
        return;
      }
      this.engine.saved();
      this.onsaved();
      // What no longer agreed with the drawing is no longer in the file.
      this.losses = this.engine.losses = this.engine.keeps ? { ...this.losses, native: 0 } : {};
      this.notices.over('kept', 'unkept', 'changed', 'unsaved');
      this.notices.say(word('shell.saved', this.name));
    } catch (error) {
      this.#tellUnsaved(error, over);
    } finally {
      clearTimeout(slow);
      this.notices.over('saving');
      this.saving = false;
      this.wake();
    }
  }

  /** Tells the user at once that the file changed on disk, not at the next save. @param {string} tag of the file now */
  tellOf(tag) {
    if (this.bound && !this.saving && tag !== this.place.tag) {
      void this.#tellChanged(word('shell.changed'));
    }
  }

  /**
   * Asks before overwriting loses anything, and once where not all is shown as it is in the file.
   * @returns {Promise<boolean>} whether the file may be overwritten
   */
  async #mayLose() {
    const { losses } = this.engine;
    const kept = this.engine.keeps && !losses.native;
    if (!totalOf(losses) || (kept && this.asked)) {
      return true;
    }
    const { ask, askInexact, unshownOf } = await want(import('../sheets/losses.js'));
    const unshown = unshownOf(this.engine);
    if (kept && !unshown.total) {
      return true;
    }
    const answer = await (kept ? askInexact(this.name, unshown) : ask(this.name, losses));
    if (answer === 'copy') {
      await this.download(false);
    }
    this.asked ||= kept && answer !== '';
    return answer === 'lose' || answer === 'save';
  }

  /** Saves the drawing as it is now. @param {string} [over] the version to overwrite, as for save() */
  saveNow(over) {
    this.over = over;
    this.engine.command('save'); // the state that is asked for anew
    this.wake();
  }

  /** Says why the drawing is not saved, until it is or the user closes it. @param {unknown} error @param {string} [over] */
  #tellUnsaved(error, over) {
    if (error instanceof Changed) {
      this.complain(error);
      return;
    }
    this.notices.over('silent'); // says the same
    this.notices.ask('unsaved', word('shell.not-saved', textOf(error)), [
      { label: word('shell.again'), run: () => this.saveNow(over) },
      { label: word('shell.copy'), run: () => {
        this.#tellUnsaved(error, over); // a copy is not the file
        void this.download();
      } }]);
  }

  /** Saves a copy in the browser's download folder. @param {boolean} [native] @param {() => void} [again] @returns {Promise<boolean>} */
  async download(native = isNative(this.name), again = () => void this.download(native)) {
    try {
      const { name } = this;
      this.deliver(await written(this.engine, native), native ? 'batten' : 'svg', native ? JSON_TYPE : SVG, name);
      this.notices.over('uncopied');
      return true;
    } catch (error) {
      this.notices.ask('uncopied', word('shell.not-saved', textOf(error)), [{ label: word('shell.again'), run: again }]);
      return false;
    }
  }

  /** Downloads the journal: all steps since opening. */
  downloadJournal(journal = this.engine.journal) {
    this.deliver(journal, 'journal', 'application/x-ndjson');
  }

  /**
   * Into the browser's download folder, named as the drawing. @param {Uint8Array} bytes
   * @param {string} end of its name @param {string} type @param {string} [name]
   */
  deliver(bytes, end, type, name = this.name) {
    const address = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)], { type }));
    const link = document.createElement('a');
    link.href = address;
    link.download = `${stemOf(name)}.${end}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }

  /** Says why a file is not open. @param {string} name @param {unknown} error */
  refuse(name, error) {
    this.complain(new Error(`${word('shell.not-opened', name)} ${error instanceof Error ? error.message : ''}`));
  }

  /** @param {unknown} error */
  complain(error) {
    if (error instanceof Changed) {
      void this.#tellChanged(error.message);
    } else {
      this.notices.say(textOf(error));
    }
  }

  /** @param {string} text */
  async #tellChanged(text) {
    const { tellChanged } = await want(import('./changed.js'));
    tellChanged(this, text);
  }
}
