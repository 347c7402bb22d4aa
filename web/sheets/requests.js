// Carries out the engine's requests to its host, fetching what they need.

import { Ask } from '../engine/codes.js';
import { want } from '../page/build.js';

/** @typedef {import('../main.js').Shell} Shell */

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Requests {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    /** @type {import('../keep/clipboard.js').Clipboard | null} */
    this.clipboard = null;
    /** @type {import('./commands.js').CommandSheet | undefined} */
    this.commands = undefined;
    /** @type {Promise<import('../gallery/kept.js').KeptSheet> | undefined} */
    this.keptSheet = undefined;
    /** @type {Promise<import('./context.js').Context> | undefined} */
    this.context = undefined;
    /** @type {Promise<import('./main_menu.js').MainMenu> | undefined} */
    this.main = undefined;
    /** @type {Promise<import('./zoom_menu.js').ZoomMenu> | undefined} */
    this.zoom = undefined;
    shell.input.onpress = (x, y, there) => void this.#menu(x, y, there);
    part('logo').addEventListener('click', () => void this.#main());
    part('zoom').addEventListener('click', () => void this.#zoom());
    part('unkept').addEventListener('click', () => void this.#losses());
    part('menu').addEventListener('beforetoggle', () => void this.commandSheet());
  }

  /** @param {number} requests */
  grant(requests) {
    const { files, panel } = this.shell;
    /** @type {[number, () => unknown][]} */
    const ways = [
      [Ask.SAVE, () => files.save()],
      [Ask.SAVE_AS, async () => (await want(import('../keep/copies.js'))).saveAs(this.shell)],
      [Ask.DOWNLOAD_SVG, () => files.download(false)],
      [Ask.DOWNLOAD_NATIVE, () => files.download(true)],
      [Ask.JOURNAL, () => files.downloadJournal()],
      [Ask.EXPORT, () => this.#export(false)],
      [Ask.EXPORT_AGAIN, () => this.#export(true)],
      [Ask.COPY_PICTURE, async () => (await want(import('../export/sheet.js'))).copyPicture(this.shell)],
      [Ask.CUT | Ask.COPY | Ask.PASTE, () => this.clipboard?.ask(requests)],
      [Ask.SPAN, () => panel.ask('picture-span')],
      [Ask.SHORTCUTS, () => this.#shortcuts()],
      [Ask.REGION | Ask.REGION_BACK, () => this.#walk(requests & Ask.REGION ? 1 : -1)],
      [Ask.LOSSES, () => this.#losses()],
      [Ask.KEPT, () => this.#kept()],
      [Ask.OPEN, () => files.pick()],
      [Ask.HISTORY, () => this.#history()],
      [Ask.WIDTH, () => panel.askNumber('width-here')],
      [Ask.SIZE, () => panel.askNumber('width')],
      [Ask.TEXT, async () => (await want(import('../stage/writing.js'))).write(this.shell)],
    ];
    for (const [asked, run] of requests ? ways : []) {
      if (requests & asked) {
        void run();
      }
    }
  }

  /** @param {number} direction */
  async #walk(direction) {
    const { walk } = await want(import('../page/regions.js'));
    walk(direction);
  }

  async #losses() {
    const { show } = await want(import('./losses.js'));
    show(this.shell.engine, this.shell.wake);
  }

  /** @param {boolean} again as it was chosen last */
  async #export(again) {
    const { exportDrawing } = await want(import('../export/sheet.js'));
    await exportDrawing(this.shell, undefined, again);
  }

  async #history() {
    const { show } = await want(import('./history.js'));
    show(this.shell.engine, this.shell.wake);
  }

  async #kept() {
    this.keptSheet ??= want(import('../gallery/kept.js')).then(({ KeptSheet }) => KeptSheet.make(this.shell));
    await (await this.keptSheet).show();
  }

  /** @param {number} x @param {number} y @param {boolean} there */
  async #menu(x, y, there) {
    this.context ??= want(import('./context.js')).then(({ Context }) => Context.make(this.shell));
    const context = await this.context;
    if (await this.shell.whole.complete()) {
      context.show(x, y, there);
    }
  }

  async #main() {
    this.main ??= want(import('./main_menu.js')).then(({ MainMenu }) => MainMenu.make(this.shell, part('logo')));
    (await this.main).toggle();
  }

  async #zoom() {
    this.zoom ??= want(import('./zoom_menu.js')).then(({ ZoomMenu }) => ZoomMenu.make(this.shell, part('zoom')));
    (await this.zoom).toggle();
  }

  /** The sheet of commands, made on demand. */
  async commandSheet() {
    const [{ CommandSheet }, { others }] = await Promise.all([want(import('./commands.js')), want(import('./others.js'))]);
    const { engine, settings, wake, words } = this.shell;
    this.commands ??= new CommandSheet(part('menu'), words, settings, (command) => {
      engine.command(command);
      wake();
    }, () => others(this.shell), () => engine.refused());
    return this.commands;
  }

  async #shortcuts() {
    const sheet = await this.commandSheet();
    sheet.sheet.showPopover();
    sheet.search.focus();
  }
}
