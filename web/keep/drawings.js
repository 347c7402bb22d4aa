// The page's drawing and what the browser has kept of it: opening it with what a closed or crashed page left, leaving
// it for another, taking it over from another page.

import { want } from '../page/build.js';
import { counted, word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('./keep.js').Fault} Fault */
/** @typedef {import('./keep.js').Kept} Kept */

/** Notices about a drawing: they disappear with it. */
const OF_DRAWING = ['left', 'kept', 'other', 'unkept', 'changed', 'trap'];

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
    engine.onrecovery = (all, error) => this.#recovered(all, error);
    keeper.onfault = (fault) => this.#notKept(fault);
    files.find = (name) => this.admit(name);
    files.onopen = (kept) => this.resume(kept);
    tabs.onleave = async () => {
      await keeper.yield();
      this.showOwner();
    };
  }

  /** Whether this page may edit the drawing, and keeps it. */
  get ours() {
    return this.tabs.held && this.tabs.name === this.files.name && !this.engine.partial;
  }

  /** A text of the shell about this drawing. @param {string} key @returns {string} */
  #text(key) {
    return word(`shell.${key}`, this.files.name);
  }

  /**
   * Leaves this drawing for another.
   * @param {string} name
   * @returns {Promise<Kept | null>} what was kept of it; also null when another page has it
   */
  async admit(name) {
    if (this.files.unsaved) {
      this.keeper.drop(this.files.name); // the user was asked
      await this.keeper.settled();
    }
    return await this.tabs.claim(name) ? this.#kept(name) : null;
  }

  /**
   * What was kept of a drawing; completes the module first, because a call during the replay cannot wait for it.
   * @param {string} name
   */
  async #kept(name) {
    const kept = await this.keeper.find(name);
    return kept && await this.whole.complete() ? kept : null;
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
    await this.tabs.take();
    const kept = await this.#kept(this.files.name);
    await this.files.reopen();
    this.resume(kept);
  }

  /** Opens the server's file, with what was kept of it. */
  async openServed() {
    await this.files.openServed();
    this.resume(await this.admit(this.files.name));
  }

  /** What an address asks for. @param {string} asked @returns {Promise<boolean>} whether it is open now */
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
    for (const { name } of await this.keeper.list()) {
      const kept = await this.admit(name);
      if (kept) {
        this.files.name = name;
        if (this.engine.replay(kept.journal)) {
          this.wake();
          this.notices.ask('left', this.#text('as-left'), [{ label: this.#text('new'), run: () => void this.openNew() }]);
          return;
        }
      }
    }
    const first = document.querySelector('meta[name=batten-first]')?.getAttribute('content') ?? '';
    if (!await this.#openAsked(first)) {
      await this.openNew();
    }
  }

  /** Opens an empty drawing; the previous one stays kept. @param {string} [stem] of its name */
  async openNew(stem = 'drawing') {
    const taken = (await this.keeper.list()).map((kept) => kept.name);
    this.#leave();
    let name = `${stem}.svg`;
    for (let number = 2; taken.includes(name) || !(await this.tabs.claim(name)); number++) {
      name = `${stem} ${number}.svg`;
    }
    this.#become(name);
    await this.files.reopen();
    this.showOwner();
  }

  /** Opens a kept drawing in place of this one, which stays kept. @param {string} name */
  async openKept(name) {
    await this.keeper.settled();
    this.#leave();
    const kept = await this.admit(name);
    if (!kept) {
      await this.tabs.claim(this.files.name);
      this.notices.say(word('shell.kept-not.help', name));
    } else {
      this.#become(name);
      if (!this.engine.replay(kept.journal)) {
        this.#lost(kept);
      }
    }
    this.showOwner();
  }

  /** Removes the drawing from the page, but not from what is kept. */
  #leave() {
    this.notices.over(...OF_DRAWING);
    this.keeper.session = -1;
    this.keeper.unsaved = this.files.unsaved = false;
  }

  /** Makes it a drawing without a file. @param {string} name */
  #become(name) {
    this.files.name = name;
    this.files.given = false;
    this.files.bind(null);
    this.files.opened = new Uint8Array(0);
  }

  /** Restores what a closed or crashed page had not saved. @param {Kept | null} kept */
  resume(kept) {
    this.notices.over(...OF_DRAWING);
    this.showOwner();
    if (!kept) {
      return;
    }
    // Either its steps pass through the file as it is now, or the file has changed since and the user must decide.
    if (new TextDecoder().decode(kept.journal).includes(`"digest":"${this.engine.digest()}"`)) {
      this.#bringBack(kept);
    } else {
      this.notices.ask('other', this.#text('kept-other'), [{
        label: this.#text('bring-back'), run: () => this.#bringBack(kept) }]);
    }
  }

  /** @param {Kept} kept */
  #bringBack(kept) {
    if (this.engine.replay(kept.journal)) {
      this.engine.losses = this.files.losses; // of the file as it is now, not as it was
      this.notices.ask('kept', this.#text('brought-back'), [{
        label: this.#text('without'), run: () => void this.files.reopen() }]);
    } else {
      this.#lost(kept);
    }
    this.wake();
  }

  /** What was kept cannot be restored. @param {Kept} kept */
  #lost(kept) {
    void this.files.reopen();
    this.notices.ask('other', this.#text('lost'), [{
      label: this.#text('journal'), run: () => this.files.downloadJournal(kept.journal) }]);
  }

  /**
   * A call into the module broke off: says what came of it, and offers what is left.
   * @param {import('../engine/instance.js').Outcome} outcome @param {unknown} error
   */
  #recovered(outcome, error) {
    console.error(error);
    const { engine, files, notices, whole } = this;
    const { left, more, dead, fresh, scarce } = outcome;
    if (more > 0) {
      this.keeper.session = -1; // what is kept on disk stays as it is, what follows is kept as another drawing
    }
    if (fresh) {
      this.settings.restore();
    }
    const again = () => this.#recovered({ ...outcome, more: 0, fresh: false }, error);
    const copy = { label: word('shell.copy'), run: () => void files.download() };
    const journal = { label: word('shell.journal'), run: () => files.downloadJournal(engine.broken) };
    const reload = { label: word('shell.reload'), run: () => void whole.reload(again) };
    if (dead) {
      const stay = [copy, journal].map(({ label, run }) => ({ label, run: () => {
        run();
        again(); // the other ways out are still needed
      } }));
      const anew = { label: word('shell.new'), run: () => void (engine.revive() && this.openNew()) };
      notices.ask('trap', word('shell.dead'), [...stay, reload, ...(files.server.sole ? [] : [anew])], true);
    } else if (left.length > 0) {
      const aside = { label: word('shell.left-out'), run: async () =>
        files.deliver(new Uint8Array(await new Blob(/** @type {BlobPart[]} */ (left)).arrayBuffer()), 'left.journal', 'application/x-ndjson') };
      notices.ask('trap', counted('shell.trapped-part', left.length), [aside, journal]);
    } else if (scarce) {
      notices.ask('trap', word(fresh ? 'shell.freed' : 'shell.scarce'), [copy, fresh ? journal : reload]);
    } else {
      notices.ask('trap', word('shell.trapped'), [journal]);
    }
    this.wake();
  }

  /** The browser has stopped keeping steps, or keeps them again. @param {Fault | ''} fault */
  #notKept(fault) {
    this.notices.over('unkept');
    if (!fault) {
      return;
    }
    const copy = { label: this.#text('copy'), run: () => void this.files.download() };
    const save = { label: this.#text('save-now'), run: () => void this.files.save() };
    this.notices.ask('unkept', this.#text(fault), this.files.bound ? [save, copy] : [copy]);
    this.wake();
  }
}
