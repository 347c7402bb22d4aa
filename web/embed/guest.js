// The editor as a part of another page, in a frame that the element of batten-editor makes (bindings/js/editor). That
// page gives the drawing and takes it back; it also holds the journal, so that nothing is lost when the frame goes.
// Nothing of the drawing is kept in the browser, and no drawing that the browser has kept is shown. Fetched in a frame only.

import { HostKeeper } from './host_keeper.js';
import { Server } from '../keep/server.js';
import { Tabs } from '../keep/tabs.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** What to open. first: in a new frame, with the journal of an earlier one; why: it could not be got, for this reason.
 * @typedef {{ bytes: Uint8Array, name: string, first?: boolean, journal?: Uint8Array, unsaved?: boolean, why?: string }} Opening */
/** @typedef {{ opened?: boolean, why?: string }} Answer */

/** A frame's drawing is its own. */
class Alone extends Tabs {
  constructor() {
    super();
    this.channel?.close();
  }

  /** @param {string} name */
  async claim(name) {
    this.name = name;
    this.held = true;
    return true;
  }
}

/** Where drawings are saved to: the page around this one. */
class Place extends Server {
  /** @param {Guest} guest */
  constructor(guest) {
    super();
    this.token = '';
    this.passing = this.sole = true;
    this.guest = guest;
  }

  /** @param {Uint8Array} bytes @param {string} type */
  async save(bytes, type) {
    const text = new TextDecoder().decode(bytes);
    await this.guest.ask({ save: text, type, name: this.guest.shell?.files.name });
  }

  async hear() {
    return this.tag; // no other program writes it
  }
}

export class Guest {
  /** @param {MessagePort} port to the element */
  constructor(port) {
    this.port = port;
    this.keeper = new HostKeeper((message) => port.postMessage(message));
    this.place = new Place(this);
    this.tabs = new Alone();
    /** @type {Shell | undefined} */
    this.shell = undefined;
    /** Who waits for an answer of the element. @type {Map<number, (why: string) => void>} */
    this.waiting = new Map();
    this.asked = 0;
    /** Drawings are opened one after the other. @type {Promise<unknown>} */
    this.last = Promise.resolve();
  }

  /** Opens what the element gives first. @param {Shell} shell @returns {Promise<void>} */
  begin(shell) {
    this.shell = shell;
    this.keeper.svg = () => shell.engine.save(false);
    this.keeper.isUnsaved = () => shell.files.unsaved;
    addEventListener('pagehide', () => {
      this.#note();
      this.keeper.tell(true);
    });
    return new Promise((resolve) => {
      this.port.onmessage = ({ data }) => {
        this.#hear(shell, data);
        void this.last.then(() => resolve());
      };
    });
  }

  /** Asks the element; rejects with the reason that it gives. @param {object} message @returns {Promise<void>} */
  ask(message) {
    const id = ++this.asked;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, (why) => (why ? reject(new Error(why)) : resolve()));
      this.port.postMessage({ ...message, id });
    });
  }

  /**
   * @param {Shell} shell
   * @param {{ id: number, open?: Opening, save?: boolean, answered?: number, why?: string }} data
   */
  #hear(shell, { id, open, save, answered, why }) {
    const answer = (/** @type {Answer} */ told) => {
      this.#note();
      this.keeper.tell(false);
      this.port.postMessage({ answered: id, ...told });
    };
    if (answered) {
      this.waiting.get(answered)?.(why ?? '');
      this.waiting.delete(answered);
    } else if (open) {
      this.last = this.last.then(() => this.#open(shell, open)).then(answer, (error) => answer({ why: String(error) }));
    } else {
      if (save) {
        shell.engine.command('save');
        shell.wake();
      }
      answer({});
    }
  }

  /** @param {Shell} shell @param {Opening} opening @returns {Promise<Answer>} */
  async #open(shell, opening) {
    const { bytes, name, first, why } = opening;
    const { files, notices } = shell;
    const told = this.#note();
    if (!why && !first && files.unsaved) {
      return { opened: await this.#ask(shell, bytes, name) };
    }
    if (first && !bytes.length && !opening.journal && !why) {
      await shell.drawings.openNew();
      return { opened: true };
    }
    if (!why && (await this.#resume(shell, opening) || await this.#replace(shell, bytes, name))) {
      return { opened: true };
    }
    if (why) {
      notices.say(`${word('shell.not-opened', name)} ${why}`);
    }
    const reason = notices.text.textContent ?? '';
    if (first) {
      await shell.drawings.openNew();
    } else {
      files.unsaved = told;
    }
    return { opened: false, why: reason };
  }

  /** The user decides, for something would be lost. @param {Shell} shell @param {Uint8Array} bytes @param {string} name */
  async #ask({ engine, files }, bytes, name) {
    const { session } = engine;
    files.edited = true;
    await files.arrive([{ file: new File([/** @type {BlobPart} */ (bytes)], name), place: null }]);
    const opened = engine.session !== session;
    files.unsaved &&= !opened;
    return opened;
  }

  /** Goes on where an earlier frame was. @param {Shell} shell @param {Opening} opening @returns {Promise<boolean>} */
  async #resume(shell, { bytes, name, journal, unsaved }) {
    const { drawings, engine, files, notices, whole } = shell;
    if (!journal?.length || !await whole.complete()) {
      return false;
    }
    if (!engine.replay(journal)) {
      notices.ask('other', word('shell.lost', name), [{
        label: word('shell.journal', name), run: () => files.downloadJournal(journal) }]);
      return false;
    }
    files.bind(null);
    [files.name, files.opened, files.unsaved] = [name, bytes, unsaved === true];
    if (!unsaved) {
      engine.saved();
    }
    await drawings.settle();
    return true;
  }

  /** @param {Shell} shell @param {Uint8Array} bytes @param {string} name @returns {Promise<boolean>} */
  async #replace({ drawings, files }, bytes, name) {
    files.unsaved = false;
    if (!await files.open(bytes, name)) {
      return false;
    }
    files.bind(null);
    await drawings.settle();
    return true;
  }

  /** Hands on what the journal has by now. @returns {boolean} whether any of it is unsaved */
  #note() {
    const { drawings, engine, files } = /** @type {Shell} */ (this.shell);
    if (drawings.ours && !engine.dead) {
      engine.guard(() => engine.keepJournal(), undefined);
      files.unsaved ||= this.keeper.isNew(engine.session, engine.journal.length);
      drawings.keep(true);
    }
    return files.unsaved;
  }
}

/** Meets the element: it answers this page's word with a port, which is all that the two share. @returns {Promise<Guest>} */
export function meet() {
  return new Promise((resolve) => {
    addEventListener('message', function hear({ source, data, ports }) {
      if (source === parent && data === 'batten-editor' && ports[0]) {
        removeEventListener('message', hear);
        resolve(new Guest(ports[0]));
      }
    });
    parent.postMessage('batten-editor', '*');
  });
}
