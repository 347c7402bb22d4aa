// The panel: bar and foot, built from the engine's tables, and the parts loaded on demand: the sheets, the level strip,
// the chips at a stroke's end, the row of commands for the selection. No commands are listed here.

import { want } from '../page/build.js';
import { fillBar } from './bar.js';
import { Buttons } from './buttons.js';
import { Controls, SHEET_OF } from './controls.js';
import { Dock } from './dock.js';
import { Foot } from './foot.js';
import { Rail } from './rail.js';
import { tell } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Frame} Frame */
/** @typedef {import('../engine/types.js').Tables} Tables */

/**
 * Fills a sheet: its heading and everything below it. The result's show() is called with every frame.
 * reveal() brings one of its controls to sight.
 * @typedef {{ show(frame: Frame): void, reveal?: (control: Element) => void }} Filled
 * @typedef {{ fill: (panel: Panel, sheet: HTMLElement) => Filled }} Filler
 */

/** @type {Record<string, () => Promise<{ fill: (panel: Panel, sheet: HTMLElement) => Promise<Filled> }>>} */
const SHEETS = {
  settings: () => import('./settings.js'),
};

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

export class Panel {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   */
  constructor(engine, wake) {
    this.engine = engine;
    this.wake = wake;
    this.tables = engine.tables();
    this.controls = new Controls(engine, wake);
    this.buttons = new Buttons(engine, this.controls, wake);
    this.shown = '';
    this.levels = 0;
    this.told = '';
    this.readings = ''; // what the chips show, and where
    /** The sheets opened so far. @type {Map<string, Promise<Filled>>} */
    this.sheets = new Map();
    /** Parts to be given every frame. @type {{ show(frame: Frame): void }[]} */
    this.shows = [];
    /** @type {Promise<import('../stage/chips.js').Chips> | undefined} */
    this.chips = undefined;
    /** @type {Promise<import('./levels.js').LevelStrip> | undefined} */
    this.strip = undefined;
    /** @type {Promise<void> | undefined} */
    this.offers = undefined;
    this.controls.list.push(() => {
      document.documentElement.dataset.hand = engine.get('left-hand') ? 'left' : 'right';
    });
    /** @type {import('../main.js').Shell | undefined} */
    this.shell = undefined;
    /** @type {import('../stage/theme.js').Theme | undefined} */
    this.theme = undefined;
    /** @type {import('../stage/paint.js').Painter | undefined} */
    this.painter = undefined;
    /** @type {import('../page/settings.js').Settings | undefined} */
    this.settings = undefined;
    /** @type {import('../page/words.js').Words | undefined} */
    this.words = undefined;
    /** @type {import('./options.js').Options | undefined} */
    this.options = undefined;
    /** @type {import('./flyout.js').Flyout | undefined} */
    this.flyout = undefined;
    this.rail = new Rail(this.tables, this.buttons);
    this.themeButton = fillBar(this.tables, this.buttons);
    this.dock = new Dock(this);
    this.foot = new Foot(engine, this.tables, this.buttons, this.controls);
    for (const name of Object.keys(SHEETS)) {
      part(name).addEventListener('beforetoggle', () => void this.#sheet(name));
      part(name).addEventListener('toggle', () => this.controls.refresh());
    }
  }

  /** What the page has beside the engine: colours, the painter's and the buttons' that choose them, and bound keys. @param {import('../main.js').Shell} shell */
  follow(shell) {
    const { theme, painter } = shell;
    this.shell = shell;
    this.theme = theme;
    this.painter = painter;
    this.settings = shell.settings;
    this.words = shell.words;
    theme.onchange = () => {
      painter.retheme();
      this.controls.refresh();
      this.wake();
    };
    this.themeButton.addEventListener('click', () => theme.toggle());
  }

  /** Opens a sheet, filling it the first time. @param {string} name */
  #sheet(name) {
    const sheet = this.sheets.get(name) ?? want(SHEETS[name]()).then(async ({ fill }) => {
      const filled = await fill(this, part(name));
      this.shows.push(filled);
      this.controls.refresh();
      this.wake();
      return filled;
    });
    this.sheets.set(name, sheet);
    return sheet;
  }

  /** Loads the strip with the first curve whose levels are viewed. */
  async #showLevels() {
    this.strip ??= want(import('./levels.js')).then(({ LevelStrip }) => LevelStrip.make(this, part('stage')));
    (await this.strip).show(this.levels > 0);
  }

  /** Fetches the chips before the first stroke ends: the server may have stopped by then. */
  fetchChips() {
    this.chips ??= want(import('../stage/chips.js')).then(({ Chips }) => new Chips(this.engine, part('stage'), this.wake));
    return this.chips;
  }

  /** @param {boolean} some */
  async #showReadings(some) {
    (await this.fetchChips()).show(some);
  }

  /** Loads the row of commands with the first selection. */
  async #showOffers() {
    const { Offers } = await want(import('./offers.js'));
    this.shows.push(await want(Offers.make(this)));
    this.wake();
  }

  /** Lets the user type a property's value. @param {string} property */
  async ask(property) {
    const { homeOf } = await want(import('./options.js'));
    const home = homeOf(property);
    if (home) {
      this.engine.command(home);
      this.wake();
      this.options?.reveal(property);
      return;
    }
    const group = this.tables.properties.find((row) => row.name === property)?.group ?? '';
    const section = SHEET_OF[group];
    const sheet = await (section ? this.dock.reveal(section) : this.#sheet('settings'));
    if (!section) {
      part('settings').showPopover();
    }
    const input = /** @type {HTMLInputElement} */ (part(`setting-${property}`));
    sheet?.reveal?.(input);
    input.closest('details')?.setAttribute('open', '');
    input.focus();
    input.select?.();
  }

  /** Lets the user type a number of what is chosen; Enter returns to the drawing. @param {string} name */
  async askNumber(name) {
    await this.dock.reveal('numbers');
    part('numbers-body').dataset.asked = 'yes';
    part(`number-${name}`).focus();
  }

  /** Called after texts or shortcuts have changed. @param {Tables} tables */
  retold(tables) {
    this.tables = tables;
    this.shown = '';
    this.wake();
  }

  /** @param {Frame} frame */
  show(frame) {
    const readings = frame.readings ? [frame.readings, frame.x, frame.y, frame.zoom, frame.angle].join() : '';
    if (readings !== this.readings) {
      this.readings = readings;
      void this.#showReadings(readings !== '');
    }
    if (frame.levels !== this.levels) {
      this.levels = frame.levels;
      void this.#showLevels();
    }
    if (frame.selected > 0) {
      this.offers ??= this.#showOffers();
    }
    this.shows.forEach((one) => one.show(frame));
    // Changing the page costs more than comparing a line of text. While a stroke is drawn only what the foot says of it changes.
    const values = Foot.values(frame);
    const reach = this.engine.number('tolerance');
    const meaning = this.engine.get('stroke-meaning');
    const told = [values, frame.knotsBefore, frame.knotsAfter].join('\n');
    const shown = [reach, meaning, frame.name, frame.unsaved, frame.canUndo, frame.canRedo, frame.tool, frame.tolerance, frame.zoom,
      frame.angle, frame.hint, frame.pending && frame.error, frame.pending, frame.first, frame.selection,
      frame.selected > 0 ? frame.revision : 0].join('\n');
    if (told !== this.told) {
      this.told = told;
      this.foot.follow(frame, values);
    }
    if (shown === this.shown) {
      return;
    }
    this.shown = shown;
    this.buttons.able('undo', frame.canUndo);
    this.buttons.able('redo', frame.canRedo);
    this.rail.show(frame.tool);
    this.#showMeaning(meaning);
    this.foot.show(frame, reach);
    this.controls.refresh();
  }

  /** What strokes may mean stands on its button unless they may mean anything. @param {number} meaning */
  #showMeaning(meaning) {
    const button = this.buttons.commands.get('meaning-next');
    const said = button?.querySelector('span') ?? document.createElement('span');
    button?.setAttribute('aria-pressed', String(meaning > 0));
    if (said.parentElement !== button) {
      button?.append(said);
    }
    said.hidden = meaning === 0;
    tell(said, { text: `meaning.${['drawn', 'redraw', 'new'][meaning]}` });
  }
}
