// The page: ties engine, input, painting, files and panel together, one frame at a time.

import { Ask, Engine, loadModule } from './engine.js';
import { Files } from './files.js';
import { Input } from './input.js';
import { Keeper } from './keep.js';
import { Notice } from './notice.js';
import { Painter } from './paint.js';
import { loadIcons, Panel } from './panel.js';
import { Server } from './server.js';
import { Theme } from './theme.js';

const CURSORS = ['cross', 'pen', 'grab', 'grabbing', 'wait', 'arrow', 'move',
  'ew-resize', 'ns-resize', 'nwse-resize', 'nesw-resize'];

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));

class Shell {
  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.stage = part('stage');
    this.notice = new Notice();
    this.server = new Server();
    this.keeper = new Keeper();
    this.engine = new Engine(module);
    this.theme = new Theme();
    this.painter = new Painter(canvas('still'), canvas('overlay'), this.theme);
    this.wake = this.wake.bind(this);
    this.panel = new Panel(this.engine, this.wake);
    this.files = new Files(this.engine, this.server, this.notice, this.wake);
    this.input = new Input(this.stage, this.engine, this.wake);
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
    this.theme.onchange = () => {
      this.painter.retheme();
      this.wake();
    };
    this.panel.themeButton?.addEventListener('click', () => this.theme.toggle());
    this.engine.onrecovery = (whole, error) => {
      console.error(error);
      let text = 'Something broke inside. The drawing was brought back from its journal.';
      if (!whole) {
        text = 'Something broke inside. Not all steps could be brought back.';
        this.keeper.noted = null; // what is kept stays kept, though the drawing shown is not unsaved
      }
      const run = () => this.files.downloadJournal(this.engine.broken);
      this.notice.say(text, { label: 'Download the journal', run });
      this.wake();
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
    part('welcome').hidden = frame.still.length > 0 || frame.live.length > 0;
    this.files.unsaved = frame.unsaved;
    this.keeper.note(this.files.name, this.engine.journal, frame.unsaved);
    if (frame.notice && frame.noticeVersion !== this.noticeVersion) {
      this.notice.say(frame.notice);
    }
    this.noticeVersion = frame.noticeVersion;
    this.cost.frames++;
    this.cost.engine += made - start;
    this.cost.paint += performance.now() - made;
    this.#grant(frame.requests);
  }

  /** What a crashed or closed page left unsaved of this drawing can be brought back. */
  async offerKept() {
    const kept = await this.keeper.find(this.files.name);
    if (kept) {
      this.notice.say(`There is unsaved work on ${kept.name} from before.`, {
        label: 'Bring it back',
        run: () => {
          if (!this.engine.replay(kept.journal)) {
            this.notice.say('It could not be brought back.');
          }
          this.wake();
        },
      });
    }
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
    if (requests & Ask.OPEN) {
      this.files.pick();
    }
  }
}

async function start() {
  try {
    const [module] = await Promise.all([loadModule('batten.wasm'), loadIcons()]);
    const shell = new Shell(module);
    if (shell.server.there) {
      await shell.files.openServed();
    }
    await shell.offerKept();
    // For the console, and for tests.
    Object.assign(globalThis, { batten: shell });
    document.documentElement.dataset.ready = 'yes';
  } catch (error) {
    console.error(error);
    new Notice().say(`Batten could not start. ${error instanceof Error ? error.message : ''}`, {
      label: 'Try again', run: () => location.reload() });
  }
}

void start();
