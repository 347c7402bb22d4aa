// The page: connects its parts. engine/ is the module; stage/ the drawing surface; keep/ files and what is kept of
// them; sheets/ the panel and what opens from it; page/ texts, notices and what all of them use.

import { Engine } from './engine/engine.js';
import { Module } from './engine/module.js';
import { Drawings } from './keep/drawings.js';
import { Files } from './keep/files.js';
import { Keeper } from './keep/keep.js';
import { Server } from './keep/server.js';
import { Tabs } from './keep/tabs.js';
import { want } from './page/build.js';
import { loadIcons } from './page/icons.js';
import { kept } from './page/kept.js';
import { Notices } from './page/notice.js';
import './page/ring.js';
import { Settings } from './page/settings.js';
import { Whole } from './page/whole.js';
import { word, Words } from './page/words.js';
import { Panel } from './sheets/panel.js';
import { Requests } from './sheets/requests.js';
import { Input } from './stage/input.js';
import { Loop } from './stage/loop.js';
import { Painter } from './stage/paint.js';
import { Theme } from './stage/theme.js';

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));

export class Shell {
  /**
   * @param {Engine} engine @param {Settings} settings @param {Words} words @param {Keeper} keeper
   * @param {import('./embed/guest.js').Guest | null} guest the page is a part of another
   */
  constructor(engine, settings, words, keeper, guest) {
    this.stage = part('stage');
    this.engine = engine;
    this.settings = settings;
    this.words = words;
    this.keeper = keeper;
    this.loop = new Loop(this);
    this.wake = () => this.loop.wake();
    this.notices = new Notices();
    this.server = guest?.place ?? new Server();
    this.tabs = guest?.tabs ?? new Tabs();
    this.theme = new Theme();
    this.painter = new Painter(canvas('still'), canvas('overlay'), this.theme);
    this.panel = new Panel(engine, this.wake);
    this.files = new Files(engine, this.server, this.notices, this.wake);
    this.input = new Input(this.stage, engine, this.wake);
    this.whole = new Whole(engine, this.notices, () => this.pack(), words);
    this.drawings = new Drawings(this);
    this.requests = new Requests(this);
    /** @type {import('./page/mirror.js').Mirror | undefined} */
    this.mirror = undefined;
    this.mirroring = false;
    /** @type {import('./stage/dial.js').Dial | undefined} */
    this.dial = undefined;
    /** @type {import('./stage/over.js').Over | undefined} */
    this.over = undefined;
    /** @type {import('./stage/settling.js').Settling | undefined} */
    this.settling = undefined;
    this.#connect();
    this.loop.watch();
  }

  #connect() {
    const { engine, painter, theme } = this;
    painter.onidle = this.wake;
    painter.onlate = () => this.notices.say(word('shell.late.help'));
    painter.onpicture = async (picture) => {
      const { decode } = await want(import('./stage/pictures.js'));
      painter.pictures.set(picture, await decode(engine.picture(picture), theme.turned));
      painter.retheme();
      this.wake();
    };
    this.panel.follow(this);
    this.words.onchange = (tables) => {
      this.panel.retold(tables);
      this.requests.commands?.fill();
    };
    this.whole.onpartial = () => this.drawings.showOwner();
    const keep = () => this.drawings.keepNow();
    this.input.onlift = keep;
    addEventListener('pagehide', keep);
    document.addEventListener('visibilitychange', keep);
    this.input.onbegin = () => {
      this.notices.pass();
      this.notices.over('left');
    };
  }

  /** Loads the list of objects and keyboard navigation between regions. */
  async mirrorDrawing() {
    if (!this.mirroring) {
      this.mirroring = true;
      const [{ Mirror }] = await want(Promise.all([import('./page/mirror.js'), import('./page/regions.js')]));
      if (await this.whole.complete()) {
        this.mirror = new Mirror(this.engine, this.stage, this.wake);
      }
    }
  }

  /** Prepares the page to be closed; unsaved work is kept, or else the browser asks. */
  async pack() {
    this.drawings.keepNow();
    await this.keeper.settled();
    this.files.leaving = !this.keeper.fault;
  }
}

async function start() {
  if (kept('batten-scale')) {
    void want(import('./page/scale.js'));
  }
  const settling = want(import('./page/settle_in.js')); // there when it is ready, so that it hears the first key
  const embedded = document.querySelector('meta[name=batten-embedded]');
  const guest = embedded && await (await import('./embed/guest.js')).meet();
  const keeper = guest?.keeper ?? new Keeper();
  const [module] = await Promise.all([Module.load(), loadIcons(), keeper.start()]);
  if (Settings.any) {
    await module.complete().catch(() => {}); // offline only this way of fetching reaches what is cached
  }
  const engine = new Engine(module);
  const settings = new Settings(engine);
  const words = new Words(engine);
  await words.follow();
  const shell = new Shell(engine, settings, words, keeper, guest);
  await (guest ? guest.begin(shell) : shell.server.there ? shell.files.openServed().then(() => shell.drawings.arrived()) : shell.drawings.openLast());
  // For the console, and for tests.
  Object.assign(globalThis, { batten: shell });
  document.documentElement.dataset.ready = 'yes';
  void (await settling).settleIn(shell);
}

start().catch((error) => reportError(error)); // page/starting.js says it
