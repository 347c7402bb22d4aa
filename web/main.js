// The page: ties engine, input, painting, files and panel together, one frame at a time.

import { miss, want, whenMissing } from './build.js';
import { Ask, Engine } from './engine.js';
import { Files } from './files.js';
import { Input } from './input.js';
import { Keeper } from './keep.js';
import { Module } from './module.js';
import { Notices } from './notice.js';
import { loadIcons } from './icons.js';
import { Painter, ROLE_GRID } from './paint.js';
import { Panel } from './panel.js';
import './ring.js';
import { Server } from './server.js';
import { Settings } from './settings.js';
import { Tabs } from './tabs.js';
import { Theme } from './theme.js';
import { Words, word } from './words.js';

/** @typedef {import('./keep.js').Kept} Kept */

const CURSORS = ['cross', 'pen', 'grab', 'grabbing', 'wait', 'arrow', 'move',
  'ew-resize', 'ns-resize', 'nwse-resize', 'nesw-resize', 'zoom-in', 'zoom-out'];

/** What notices about a drawing are about: they go with it. */
const OF_DRAWING = ['left', 'kept', 'other', 'unkept', 'changed', 'trap'];

const UNTOUCHED = 3000; // milliseconds after which the page readies itself for those who do not see it

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));

class Shell {
  /** @param {Engine} engine @param {Settings} settings @param {Words} words @param {Keeper} keeper */
  constructor(engine, settings, words, keeper) {
    this.stage = part('stage');
    this.notices = new Notices();
    this.server = new Server();
    this.keeper = keeper;
    this.engine = engine;
    this.settings = settings;
    this.words = words;
    this.tabs = new Tabs();
    this.theme = new Theme();
    this.painter = new Painter(canvas('still'), canvas('overlay'), this.theme);
    this.wake = this.wake.bind(this);
    this.panel = new Panel(this.engine, this.wake);
    this.files = new Files(this.engine, this.server, this.notices, this.wake);
    this.input = new Input(this.stage, this.engine, this.wake);
    /** @type {import('./clipboard.js').Clipboard | null} */
    this.clipboard = null;
    this.due = false;
    this.noticeVersion = 0;
    /** @type {import('./commands.js').CommandSheet | undefined} */
    this.commands = undefined;
    /** @type {import('./kept.js').KeptSheet | undefined} */
    this.keptSheet = undefined;
    /** @type {import('./mirror.js').Mirror | undefined} */
    this.mirror = undefined;
    this.mirroring = false;
    /** Frames painted and the time they took, for tests and measurements. */
    this.cost = { frames: 0, engine: 0, paint: 0 };
    this.#connect();
  }

  #connect() {
    this.painter.onidle = this.wake;
    this.painter.onpicture = async (picture) => {
      const { decode } = await want(import('./pictures.js'));
      this.painter.pictures.set(picture, await decode(this.engine.picture(picture)));
      this.painter.retheme();
      this.wake();
    };
    this.words.onchange = (tables) => {
      this.panel.retold(tables);
      this.commands?.fill();
    };
    part('unkept').addEventListener('click', () => void this.#showLosses());
    part('menu').addEventListener('beforetoggle', () => void this.#commandSheet());
    this.theme.onchange = () => {
      this.painter.retheme();
      this.wake();
    };
    this.panel.themeButton?.addEventListener('click', () => this.theme.toggle());
    this.engine.onrecovery = (whole, error) => {
      console.error(error);
      this.settings.restore();
      if (!whole) {
        this.keeper.session = -1; // what is kept stays kept, though the drawing shown is not unsaved
      }
      const run = () => this.files.downloadJournal(this.engine.broken);
      this.notices.ask('trap', word(whole ? 'shell.trapped' : 'shell.trapped-part'), [{ label: word('shell.journal'), run }]);
      this.wake();
    };
    this.keeper.onfault = (fault) => this.#notKept(fault);
    whenMissing(() => this.#sayMissing());
    this.stage.addEventListener('pointerdown', () => {
      this.notices.pass();
      this.notices.over('left');
    });
    this.files.find = (name) => this.admit(name);
    this.files.onopen = (kept) => this.resume(kept);
    this.tabs.onleave = async () => {
      await this.keeper.yield();
      this.#showOwner();
    };
    new ResizeObserver(() => this.#resize()).observe(this.stage);
    this.#watchRatio();
    this.#resize();
  }

  /** The window may move to a screen of other density. */
  #watchRatio() {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    query.addEventListener('change', () => {
      this.#resize();
      this.#watchRatio();
    }, { once: true });
  }

  #resize() {
    const { clientWidth, clientHeight } = this.stage;
    this.engine.resize(clientWidth, clientHeight, devicePixelRatio);
    this.painter.resize(clientWidth, clientHeight, devicePixelRatio);
    this.wake();
  }

  /** Asks for a frame, once; not of an engine that cannot make one. */
  wake() {
    if (!this.due && !this.engine.dead) {
      this.due = true;
      requestAnimationFrame(() => this.#frame());
    }
  }

  #frame() {
    this.due = false;
    const start = performance.now();
    const frame = this.engine.frame();
    if (!frame) {
      this.wake();
      return;
    }
    const made = performance.now();
    this.painter.paint(frame);
    this.panel.show(frame);
    this.stage.dataset.cursor = CURSORS[frame.cursor] ?? 'cross';
    const empty = frame.still.length === 0;
    part('welcome').hidden = !empty || frame.live.some((item) => item.role < ROLE_GRID);
    const ours = this.tabs.held && this.tabs.name === this.files.name && !this.engine.partial;
    this.files.unsaved = frame.unsaved && ours;
    this.#tellLost(frame.lost);
    if (ours) {
      this.keeper.note(this.files.name, this.engine.session, this.engine.journal, frame.unsaved,
        !this.files.bound && !empty);
    }
    if (frame.notice && frame.noticeVersion !== this.noticeVersion) {
      this.notices.say(frame.notice);
    }
    this.noticeVersion = frame.noticeVersion;
    this.mirror?.show(frame);
    this.settings.note();
    void this.words.follow();
    this.cost.frames++;
    this.cost.engine += made - start;
    this.cost.paint += performance.now() - made;
    this.#grant(frame.requests);
  }

  /** What of the file cannot be kept, to be looked at. @param {number} lost */
  #tellLost(lost) {
    const button = part('unkept');
    const text = lost ? word('shell.unkept', lost) : '';
    if (button.textContent !== text) {
      button.textContent = text;
      button.hidden = !lost;
    }
  }

  /** What the shell says of itself. @param {string} key @returns {string} */
  text(key) {
    return word(`shell.${key}`, this.files.name);
  }

  /**
   * Leaves this drawing for another.
   * @param {string} name
   * @returns {Promise<Kept | null>} what was kept of it; null, too, when another page has it
   */
  async admit(name) {
    if (this.files.unsaved) {
      this.keeper.drop(this.files.name); // the user was asked
      await this.keeper.settled();
    }
    return await this.tabs.claim(name) ? this.#kept(name) : null;
  }

  /** What was kept of a drawing, and what it takes to replay it: a call in the midst of it cannot wait for a worker. */
  async #kept(/** @type {string} */ name) {
    const kept = await this.keeper.find(name);
    return kept && await this.complete() ? kept : null;
  }

  /** Says when another page has the drawing; it can be had from there. */
  #showOwner() {
    this.engine.setReadOnly(!this.tabs.held || this.engine.partial);
    this.notices.over('owner');
    if (!this.tabs.held) {
      this.notices.ask('owner', this.text('elsewhere'), [{
        label: this.text('take-over'), run: () => void this.#takeOver() }], true);
    }
    this.wake();
  }

  async #takeOver() {
    await this.tabs.take();
    const kept = await this.#kept(this.files.name);
    await this.files.reopen();
    this.resume(kept);
  }

  /** Without a file: the drawing kept last that no other page has, else an empty one. */
  async openLast() {
    for (const { name } of await this.keeper.list()) {
      const kept = await this.admit(name);
      if (kept) {
        this.files.name = name;
        if (this.engine.replay(kept.journal)) {
          this.wake();
          this.notices.ask('left', this.text('as-left'), [{ label: this.text('new'), run: () => void this.openNew() }]);
          return;
        }
      }
    }
    await this.openNew();
  }

  /** An empty drawing; what was there before stays kept. */
  async openNew() {
    const taken = (await this.keeper.list()).map((kept) => kept.name);
    this.#leave();
    let name = 'drawing.svg';
    for (let number = 2; taken.includes(name) || !(await this.tabs.claim(name)); number++) {
      name = `drawing ${number}.svg`;
    }
    this.#become(name);
    await this.files.reopen();
    this.#showOwner();
  }

  /** A drawing that is kept, in place of this one, which stays kept. @param {string} name */
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
    this.#showOwner();
  }

  /** What there is goes from the page, not from what is kept. */
  #leave() {
    this.notices.over(...OF_DRAWING);
    this.keeper.session = -1;
    this.keeper.unsaved = this.files.unsaved = false;
  }

  /** No file is behind it. @param {string} name */
  #become(name) {
    this.files.name = name;
    this.files.bound = false;
    this.files.opened = new Uint8Array(0);
  }

  /** The drawing as a closed or crashed page left it: what it had not saved comes back. @param {Kept | null} kept */
  resume(kept) {
    this.notices.over(...OF_DRAWING);
    this.#showOwner();
    if (!kept) {
      return;
    }
    // Its steps lead through the file as it is, or the file has changed since, and the user is to say.
    if (new TextDecoder().decode(kept.journal).includes(`"digest":"${this.engine.digest()}"`)) {
      this.#bringBack(kept);
    } else {
      this.notices.ask('other', this.text('kept-other'), [{
        label: this.text('bring-back'), run: () => this.#bringBack(kept) }]);
    }
  }

  /** @param {Kept} kept */
  #bringBack(kept) {
    if (this.engine.replay(kept.journal)) {
      this.engine.losses = this.files.losses; // the file as it is, not as it was
      this.notices.ask('kept', this.text('brought-back'), [{
        label: this.text('without'), run: () => void this.files.reopen() }]);
    } else {
      this.#lost(kept);
    }
    this.wake();
  }

  /** What was kept leads nowhere. @param {Kept} kept */
  #lost(kept) {
    void this.files.reopen();
    this.notices.ask('other', this.text('lost'), [{
      label: this.text('journal'), run: () => this.files.downloadJournal(kept.journal) }]);
  }

  async #showLosses() {
    const { show } = await want(import('./losses.js'));
    show(this.engine.losses);
  }

  async #showKept() {
    const { KeptSheet } = await want(import('./kept.js'));
    this.keptSheet ??= new KeptSheet(this);
    await this.keptSheet.show();
  }

  /** The sheet of commands, made when it is first wanted. */
  async #commandSheet() {
    const { CommandSheet } = await want(import('./commands.js'));
    this.commands ??= new CommandSheet(part('menu'), this.words, this.settings, (command) => {
      this.engine.command(command);
      this.wake();
    });
    return this.commands;
  }

  async #showShortcuts() {
    const sheet = await this.#commandSheet();
    sheet.sheet.showPopover();
    sheet.search.focus();
  }

  /** The list of objects, and the keyboard's ways. */
  async mirrorDrawing() {
    if (!this.mirroring) {
      this.mirroring = true;
      const [{ Mirror }] = await want(Promise.all([import('./mirror.js'), import('./regions.js')]));
      if (await this.complete()) {
        this.mirror = new Mirror(this.engine, this.stage, this.wake);
      }
    }
  }

  /** The browser keeps nothing of what was drawn last, or does so again. @param {import('./keep.js').Fault | ''} fault */
  #notKept(fault) {
    this.notices.over('unkept');
    if (!fault) {
      return;
    }
    const copy = { label: this.text('copy'), run: () => void this.files.download() };
    const save = { label: this.text('save-now'), run: () => void this.files.save() };
    this.notices.ask('unkept', this.text(fault), this.files.bound ? [save, copy] : [copy]);
    this.wake();
  }

  /** The page may go; what is not saved is kept, or the browser asks. */
  async pack() {
    await this.keeper.settled();
    this.files.leaving = !this.keeper.fault;
  }

  /**
   * Fetches the second part of the module. Without it the drawing can only be looked at, and nothing is kept of it.
   * @returns {Promise<boolean>} it is here
   */
  async complete() {
    await (this.engine.partial || this.engine.module.complete().catch((error) => {
      this.engine.partial = true;
      miss(error);
      this.#showOwner();
    }));
    return !this.engine.partial;
  }

  /** The page is not whole. */
  #sayMissing() {
    this.notices.ask('missing', word(this.engine.partial || this.engine.dead ? 'shell.partial' : 'shell.missing'), [{ label: word('shell.reload'), run: async () => {
      const answer = await fetch(location.href, { cache: 'no-store' }).catch(() => null);
      if (answer?.ok) {
        await this.pack();
        location.reload();
      } else { // this page is better than none
        this.#sayMissing();
        this.notices.say(word('shell.no-answer'));
      }
    } }], true);
  }

  /** What the engine asks of its host. @param {number} requests */
  #grant(requests) {
    if (requests & Ask.SAVE) {
      void this.files.save();
    }
    if (requests & Ask.DOWNLOAD_SVG) {
      this.files.download(false);
    }
    if (requests & Ask.DOWNLOAD_NATIVE) {
      this.files.download(true);
    }
    if (requests & Ask.JOURNAL) {
      this.files.downloadJournal();
    }
    if (requests & (Ask.CUT | Ask.COPY | Ask.PASTE)) {
      void this.clipboard?.ask(requests);
    }
    if (requests & Ask.SPAN) {
      this.panel.ask('picture-span');
    }
    if (requests & Ask.SHORTCUTS) {
      void this.#showShortcuts();
    }
    if (requests & (Ask.REGION | Ask.REGION_BACK)) {
      void want(import('./regions.js')).then(({ walk }) => walk(requests & Ask.REGION ? 1 : -1));
    }
    if (requests & Ask.LOSSES) {
      void this.#showLosses();
    }
    if (requests & Ask.KEPT) {
      void this.#showKept();
    }
    if (requests & Ask.OPEN) {
      this.files.pick();
    }
  }
}

/** What the page does once it is there; nobody waits for it. @param {Shell} shell */
async function settleIn(shell) {
  // Safari has no time of idleness.
  (globalThis.requestIdleCallback ?? setTimeout)(() => void shell.complete());
  const { Clipboard } = await want(import('./clipboard.js'));
  shell.clipboard = new Clipboard(shell.engine, shell.files, shell.notices, shell.wake);
  // What explains, and what is seldom called, is fetched when somebody is there.
  const seen = new AbortController();
  for (const event of ['pointermove', 'pointerdown', 'keydown', 'focusin']) {
    addEventListener(event, () => {
      seen.abort();
      void (shell.engine.words ?? shell.words.load());
      void shell.mirrorDrawing();
    }, { signal: seen.signal });
  }
  // A screen reader may read without touching anything.
  setTimeout(() => void shell.mirrorDrawing(), UNTOUCHED);
  if (!shell.server.passing) {
    const { settle } = await want(import('./offline.js'));
    await settle(shell.notices, () => shell.pack());
  }
}

async function start() {
  try {
    const keeper = new Keeper();
    const [module] = await Promise.all([Module.load(), loadIcons(), keeper.start()]);
    const engine = new Engine(module);
    const settings = new Settings(engine);
    const words = new Words(engine);
    await words.follow();
    const shell = new Shell(engine, settings, words, keeper);
    if (shell.server.there) {
      await shell.files.openServed();
      shell.resume(await shell.admit(shell.files.name));
    } else {
      await shell.openLast();
    }
    // For the console, and for tests.
    Object.assign(globalThis, { batten: shell });
    document.documentElement.dataset.ready = 'yes';
    void settleIn(shell);
  } catch (error) {
    console.error(error);
    part('failed').hidden = false;
    part('failed').append(error instanceof Error ? error.message : '');
  }
}

void start();
