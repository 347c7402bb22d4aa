// The page: ties engine, input, painting, files and panel together, one frame at a time.

import { Ask, Engine, loadModule } from './engine.js';
import { Files } from './files.js';
import { Input } from './input.js';
import { Keeper } from './keep.js';
import { Notice } from './notice.js';
import { Painter } from './paint.js';
import { loadIcons, Panel } from './panel.js';
import { Server } from './server.js';
import { Settings } from './settings.js';
import { Theme } from './theme.js';
import { Words, word } from './words.js';

/** @typedef {import('./keep.js').Kept} Kept */

const CURSORS = ['cross', 'pen', 'grab', 'grabbing', 'wait', 'arrow', 'move',
  'ew-resize', 'ns-resize', 'nwse-resize', 'nesw-resize'];

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));

class Shell {
  /** @param {Engine} engine @param {Settings} settings @param {Words} words */
  constructor(engine, settings, words) {
    this.stage = part('stage');
    this.notice = new Notice();
    this.server = new Server();
    this.keeper = new Keeper();
    this.engine = engine;
    this.settings = settings;
    this.words = words;
    this.theme = new Theme();
    this.painter = new Painter(canvas('still'), canvas('overlay'), this.theme);
    this.wake = this.wake.bind(this);
    this.panel = new Panel(this.engine, this.wake);
    this.files = new Files(this.engine, this.server, this.notice, this.wake);
    this.input = new Input(this.stage, this.engine, this.wake);
    /** @type {import('./clipboard.js').Clipboard | null} */
    this.clipboard = null;
    this.due = false;
    this.noticeVersion = 0;
    /** Frames painted and the time they took, for tests and measurements. */
    this.cost = { frames: 0, engine: 0, paint: 0 };
    this.#connect();
  }

  #connect() {
    this.painter.onidle = this.wake;
    this.painter.onpicture = async (picture) => {
      const { decode } = await import('./pictures.js');
      this.painter.pictures.set(picture, await decode(this.engine.picture(picture)));
      this.painter.retheme();
      this.wake();
    };
    this.words.onchange = (tables) => this.panel.retold(tables);
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
      this.notice.say(word(whole ? 'shell.trapped' : 'shell.trapped-part'), { label: word('shell.journal'), run });
      this.wake();
    };
    this.keeper.onfault = () => this.notice.say(this.text('not-kept'), {
      label: this.text('save-now'), run: () => void this.files.save() });
    this.files.find = (name) => this.keeper.find(name);
    this.files.onopen = (kept) => this.resume(kept);
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
    part('welcome').hidden = !empty || frame.live.length > 0;
    this.files.unsaved = frame.unsaved;
    this.keeper.note(this.files.name, this.engine.session, this.engine.journal, frame.unsaved,
      !this.files.bound && !empty);
    if (frame.notice && frame.noticeVersion !== this.noticeVersion) {
      this.notice.say(frame.notice);
    }
    this.noticeVersion = frame.noticeVersion;
    this.settings.note();
    void this.words.follow();
    this.cost.frames++;
    this.cost.engine += made - start;
    this.cost.paint += performance.now() - made;
    this.#grant(frame.requests);
  }

  /** What the shell says of itself. @param {string} key @returns {string} */
  text(key) {
    return word(`shell.${key}`, this.files.name);
  }

  /** The drawing as a closed or crashed page left it: what it had not saved comes back. @param {Kept | null} kept */
  resume(kept) {
    if (!kept) {
      return;
    }
    // Its steps lead through the file as it is, or the file has changed since, and the user is to say.
    if (new TextDecoder().decode(kept.journal).includes(`"digest":"${this.engine.digest()}"`)) {
      this.#bringBack(kept);
    } else {
      this.notice.say(this.text('kept-other'), { label: this.text('bring-back'), run: () => this.#bringBack(kept) });
    }
  }

  /** @param {Kept} kept */
  #bringBack(kept) {
    if (this.engine.replay(kept.journal)) {
      this.notice.say(this.text('brought-back'), { label: this.text('without'), run: () => void this.files.reopen() });
    } else {
      void this.files.reopen();
      this.notice.say(this.text('lost'), {
        label: this.text('journal'), run: () => this.files.downloadJournal(kept.journal) });
    }
    this.wake();
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
    if (requests & Ask.OPEN) {
      this.files.pick();
    }
  }
}

async function start() {
  try {
    const [module] = await Promise.all([loadModule('batten.wasm'), loadIcons()]);
    const engine = new Engine(module);
    const settings = new Settings(engine);
    const words = new Words(engine);
    await words.follow();
    const shell = new Shell(engine, settings, words);
    if (shell.server.there) {
      await shell.files.openServed();
    }
    shell.resume(await shell.keeper.find(shell.files.name));
    // For the console, and for tests.
    Object.assign(globalThis, { batten: shell });
    document.documentElement.dataset.ready = 'yes';
    const { Clipboard } = await import('./clipboard.js');
    shell.clipboard = new Clipboard(shell.engine, shell.files, shell.notice, shell.wake);
    // What explains is fetched when somebody is there.
    const seen = new AbortController();
    for (const event of engine.words ? [] : ['pointermove', 'pointerdown', 'keydown', 'focusin']) {
      addEventListener(event, () => {
        seen.abort();
        void words.load();
      }, { signal: seen.signal });
    }
  } catch (error) {
    console.error(error);
    part('failed').hidden = false;
    part('failed').append(error instanceof Error ? error.message : '');
  }
}

void start();
