// The page's drawing and what the browser has kept of it: opening what a closed or crashed page left, leaving it for another, taking
// it over from another page. Whatever the engine begins anew has an id that no other has: nothing takes the place of what is kept.

import { want } from '../page/build.js';
import { keep as remember, kept } from '../page/kept.js';
import { word } from '../page/words.js';
import { tellBroken, tellUnkept } from './broken.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('./keep.js').Kept} Kept */
/** @typedef {import('./keep.js').Listed} Listed */

/** Notices about a drawing: they disappear with it. */
const OF_DRAWING = ['left', 'kept', 'other', 'unkept', 'changed', 'trap'];
const TOLD = 'batten-told-lasting'; // whether the user knows that the browser may clear it away
const TRIES = 3; // to read what is kept
const PAUSE = 100; // milliseconds between them
const PATIENCE = 5000; // milliseconds for each: a store that does not answer must not keep the page from beginning

/** @param {number} time @returns {Promise<undefined>} */
const pause = (time) => new Promise((resolve) => setTimeout(() => resolve(undefined), time));

/** @param {string} id @param {string} place */
export const keyOf = (id, place) => (place ? `file ${place}` : id);

export class Drawings {
  /** @param {Shell} shell */
  constructor({ engine, files, keeper, notices, settings, tabs, whole, wake }) {
    this.engine = engine;
    this.files = files;
    this.keeper = keeper;
    this.notices = notices;
    this.settings = settings;
    this.tabs = tabs;
    this.whole = whole;
    this.wake = wake;
    /** What this page claims of all pages, and whether it is being decided. */
    this.claimed = '';
    /** @type {Promise<unknown>} */
    this.claiming = Promise.resolve();
    /** Another drawing is being opened: nothing is noted until it is there. */
    this.moving = false;
    /** The file that it is unsaved work on, while its server is not there. */
    this.away = '';
    /** How much of the engine's journal has been looked at. */
    this.seen = { session: -1, length: 0 };
    /** The file has all of it, unless something was drawn meanwhile. */
    this.justSaved = false;
    engine.onrecovery = (all, error) => this.#recovered(all, error);
    keeper.onfault = (fault) => tellUnkept(this, fault);
    keeper.onfirst = () => void this.#askToStay();
    files.onopen = () => this.arrived();
    files.onsaved = () => {
      this.justSaved = true;
    };
    tabs.onleave = async () => {
      await keeper.yield();
      this.showOwner();
    };
  }

  /** The file that this is unsaved work on, whether it can be had now or not. */
  get place() {
    return this.files.served ? this.files.name : this.away;
  }

  /** What only one page may have: the file that the drawing belongs to, else the drawing. */
  get key() {
    return keyOf(this.keeper.id, this.place);
  }

  /** Whether this page may edit the drawing, and keeps it. */
  get ours() {
    return this.tabs.held && this.tabs.name === this.key && !this.engine.partial;
  }

  /** A text of the shell about this drawing. @param {string} key @returns {string} */
  #text(key) {
    return word(`shell.${key}`, this.files.name);
  }

  /** Claims a drawing, in place of the one held. @param {string} [key] @returns {Promise<boolean>} whether this page may edit it */
  async #claim(key = this.key) {
    if (this.claimed !== key || !this.tabs.held) {
      this.claimed = key;
      this.claiming = this.claiming.then(() => this.tabs.claim(key));
    }
    await this.claiming;
    return this.tabs.held;
  }

  // ---- keeping ----

  /** Notes what is new. @param {boolean} due whether there is anything worth keeping; once begun, all is */
  keep(due) {
    const { engine, files, keeper } = this;
    if (this.moving) {
      return;
    }
    this.seen = { session: engine.session, length: engine.journal.length };
    if (engine.drawing !== keeper.drawing) {
      keeper.begin(engine.drawing);
    }
    if (this.claimed !== this.key) {
      void this.#claim().then(this.wake);
    }
    if (this.ours && (due || keeper.begun)) {
      keeper.note(files.name, this.place, engine.session, engine.journal);
    }
  }

  /** Notes what a frame says. @param {boolean} unsaved @param {boolean} empty */
  keepFrame(unsaved, empty) {
    const { files, keeper } = this;
    if (this.justSaved) {
      this.justSaved = false;
      if (!unsaved && files.bound) {
        keeper.letGo();
      }
    }
    this.keep(unsaved || (!files.bound && !files.given && !empty));
  }

  /** Notes what has been done since the last frame, without waiting for one: a page may be gone before it. */
  keepNow() {
    const { engine, seen } = this;
    engine.guard(() => engine.keepJournal(), undefined);
    const fresh = engine.journal.subarray(seen.session === engine.session ? seen.length : 0);
    this.keep(new TextDecoder().decode(fresh).includes('{"do":'));
  }

  /** Asks the browser once not to clear away what it keeps. */
  async #askToStay() {
    this.keeper.onfirst = () => {};
    const lasting = await navigator.storage?.persist?.().catch(() => false) ?? false;
    if (!lasting && !kept(TOLD)) {
      remember(TOLD, 'yes');
      this.notices.say(word('shell.not-lasting'));
    }
  }

  // ---- opening ----

  /** All drawings kept that the user has not deleted; tries again before it says that they cannot be read. @returns {Promise<Listed[] | null>} */
  async list() {
    for (let tries = 0; tries < TRIES; tries++) {
      try {
        const all = await Promise.race([this.keeper.list(), pause(PATIENCE)]);
        if (all) {
          this.notices.over('unread');
          return all.filter(({ gone }) => !gone);
        }
      } catch (error) {
        console.warn(error);
        await pause(PAUSE);
      }
    }
    this.notices.ask('unread', word('shell.kept-unread'), [{ label: word('shell.again'), run: () => void (this.files.edited ? this.list() : this.openLast()) }]);
    return null;
  }

  /** Says so when another page has the drawing, and offers to take it over. */
  showOwner() {
    this.engine.setReadOnly(!this.tabs.held || this.engine.partial);
    this.notices.over('owner');
    if (!this.tabs.held) {
      this.notices.ask('owner', this.#text('elsewhere'), [{
        label: this.#text('take-over'), run: () => void this.#takeOver() }], true);
    }
    this.wake();
  }

  async #takeOver() {
    const { files, keeper, tabs } = this;
    await tabs.take();
    const found = files.served ? await this.#ofFile() : await keeper.take(keeper.id).catch(() => null);
    await files.reopen();
    keeper.begin(this.engine.drawing);
    await this.resume(found);
  }

  /** The unsaved work on the file that is open. @returns {Promise<Kept | null>} */
  async #ofFile() {
    const all = (await this.list() ?? []).filter(({ aside }) => !aside);
    const found = all.find(({ place }) => place === this.files.name) ?? all.find(({ name }) => name === this.files.name);
    return found ? this.keeper.take(found.id).catch(() => null) : null;
  }

  /** A file has been opened: shows who has it, and what is kept of it. */
  async arrived() {
    const { engine, files, keeper } = this;
    this.away = '';
    keeper.begin(engine.drawing);
    const held = await this.#claim();
    await this.resume(!files.served ? await keeper.find(files.name) : held ? await this.#ofFile() : null);
  }

  /** @param {string} asked by an address @returns {Promise<boolean>} whether it is open now */
  async #openAsked(asked) {
    return asked !== '' && (await want(import('./address.js'))).openAsked(this, asked);
  }

  /**
   * Without a file: opens what the page's address asks for, else the last drawing kept that no other page has, else what
   * the page names to begin with, else an empty one.
   */
  async openLast() {
    if (await this.#openAsked(location.search + location.hash)) {
      return;
    }
    for (const { id, aside, name, place } of await this.list() ?? []) {
      if (!aside && await this.#claim(keyOf(id, place)) && await this.#openKept(id, name)) {
        if (this.keeper.id === id) {
          this.notices.ask('left', this.#text('as-left'), [{ label: this.#text('new'), run: () => void this.openNew() }]);
        }
        this.wake();
        return;
      }
    }
    const first = document.querySelector('meta[name=batten-first]')?.getAttribute('content') ?? '';
    if (!await this.#openAsked(first)) {
      await this.openNew();
    }
  }

  /** Opens an empty drawing; the previous one stays kept. @param {string} [stem] of its name */
  async openNew(stem = 'drawing') {
    this.keepNow();
    const taken = (await this.list() ?? []).map(({ name }) => name);
    let name = `${stem}.svg`;
    for (let number = 2; taken.includes(name); number++) {
      name = `${stem} ${number}.svg`;
    }
    this.#become(name);
    await this.files.reopen();
    await this.settle();
  }

  /** What is open now is a drawing of its own. */
  async settle() {
    if (this.engine.drawing !== this.keeper.drawing) {
      this.keeper.begin(this.engine.drawing);
    }
    await this.#claim();
    this.showOwner();
  }

  /** Opens a kept drawing in place of this one, which stays kept. @param {Listed} kept @param {string} name that it is called by */
  async openKept({ id, place }, name) {
    this.keepNow();
    await this.keeper.settled();
    this.moving = true;
    if (!await this.#claim(keyOf(id, place))) {
      this.notices.say(word('shell.kept-not.help', name));
    } else {
      await this.#openKept(id, name);
    }
    this.moving = false;
    await this.#claim();
    this.showOwner();
  }

  /**
   * Shows what is kept of a drawing that this page has claimed.
   * @param {string} id @param {string} name @returns {Promise<boolean>} whether anything of it is shown
   */
  async #openKept(id, name) {
    const found = await this.keeper.take(id).catch(() => null);
    if (!found) {
      this.notices.say(word('shell.kept-missing.help', name));
      return false;
    }
    if (!await this.whole.complete()) {
      return false;
    }
    const { away, files: { name: before, given, place, bound, opened } } = this;
    this.#become(found.name || before);
    if (this.#bring(found)) {
      return true;
    }
    this.away = away;
    Object.assign(this.files, { name: before, given, place, bound, opened });
    return false;
  }

  /** Makes it a drawing without a file. @param {string} name */
  #become(name) {
    this.notices.over(...OF_DRAWING);
    this.away = '';
    this.files.unsaved = false;
    this.files.edited = false; // the frame that tells comes later, and a file may come before it
    this.files.name = name;
    this.files.given = false;
    this.files.bind(null);
    this.files.opened = new Uint8Array(0);
  }

  // ---- what is kept ----

  /**
   * Puts what is kept of a drawing in place of what is shown. What cannot be read of it stays as it is, and is said.
   * @param {Kept} found @returns {boolean} whether anything of it is shown
   */
  #bring(found) {
    const { engine, files, keeper } = this;
    const { moving } = this;
    this.moving = true;
    const replayed = found.whole && engine.replay(found.journal);
    const whole = replayed && engine.left.length === 0;
    const shown = replayed || engine.salvage(found.journal) >= 0;
    this.moving = moving;
    if (shown) {
      engine.guard(() => engine.keepJournal(), undefined);
      keeper.begin(engine.drawing);
    }
    this.away = shown && whole && !files.served ? found.place : this.away;
    // Earlier versions, whose ids are longer than 24 letters, noted no file: what is brought back to one goes on with it.
    if (whole && (found.place === this.place || (!found.place && found.id[24]))) {
      keeper.goOn(found.id, engine.drawing, engine.session, engine.journal.length);
    } else if (!whole) {
      const run = () => files.deliver(found.raw, 'journal', 'application/x-ndjson');
      this.notices.ask('other', word(shown ? 'shell.kept-part' : 'shell.lost', found.name || files.name), [{ label: word('shell.kept-raw'), run }]);
      if (shown) {
        keeper.putAside(found.id);
      }
    }
    return shown;
  }

  /** Restores what a closed or crashed page had not saved. @param {Kept | null} found */
  async resume(found) {
    this.notices.over(...OF_DRAWING);
    this.showOwner();
    if (!found || !await this.whole.complete()) {
      return;
    }
    // Either its steps pass through the file as it is now, or the file has changed since and the user must decide.
    if (new TextDecoder().decode(found.journal).includes(`"digest":"${this.engine.digest()}"`)) {
      await this.#bringBack(found);
    } else {
      this.notices.ask('other', this.#text('kept-other'), [{
        label: this.#text('bring-back'), run: () => void this.#bringBack(found) }]);
    }
  }

  /** @param {Kept} found */
  async #bringBack(found) {
    const { engine, files } = this;
    const digest = engine.digest();
    this.moving = true;
    const mine = (files.served && found.place) || await this.#claim(keyOf(found.id, found.place));
    if (!mine) {
      this.notices.say(word('shell.kept-not.help', found.name));
    } else if (!this.#bring(found)) {
      await files.reopen();
    } else if (found.whole && engine.digest() !== digest) {
      engine.losses = files.losses; // of the file as it is now, not as it was
      this.notices.ask('kept', this.#text('brought-back'), [{ label: this.#text('without'), run: () => void this.#without() }]);
    }
    this.moving = false;
    await this.#claim();
    this.wake();
  }

  /** The file as it is, without what was brought back, which is put aside. */
  async #without() {
    this.keepNow();
    this.keeper.putAside(this.keeper.id);
    await this.files.reopen();
  }

  /**
   * A call into the module broke off: says what came of it, and offers what is left.
   * @param {import('../engine/instance.js').Outcome} outcome @param {unknown} error
   */
  #recovered(outcome, error) {
    console.error(error);
    const { more, fresh } = outcome;
    if (more > 0 && this.keeper.begun && !this.moving) {
      this.keeper.putAside(this.keeper.id); // it stays as it is; what is shown now is kept as another drawing
    }
    if (fresh) {
      this.settings.restore();
    }
    tellBroken(this, outcome, error);
    this.wake();
  }
}
