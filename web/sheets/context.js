// The menu of what fits here: by a right click without a drag, a long press without a stroke, or the menu key. Made from
// the table of commands; for what is selected the engine says which of them apply. Fetched when it is first opened.

import { Device, Phase } from '../engine/codes.js';
import { Menu } from './menu.js';

/** @typedef {import('../main.js').Shell} Shell */

/** For what is selected, a line of the menu's rules between them: those that the engine offers. */
const CHOSEN = [/^(un)?group$|^combine$|^release$|^isolate$/, /^region-/, /^order-/, /^curve-|^to-page$|^mirror-(across|down)$|^array$/,
  /^(surface|wire)-|^camera-along$|^body-path$/, /^delete$/];
/** Always possible while something is selected. */
const ALWAYS = ['isolate'];
/** For what a tool works on. @type {Record<string, string[]>} */
const HELD = { sketch: ['calm', 'range', 'meaning-next'], points: ['point-add', 'corner-make', 'corner-smooth', 'point-delete'],
  tangents: ['point-add', 'corner-make', 'corner-smooth', 'point-delete'], levels: ['take-apart', 'level-add', 'levels-flatten'],
  smooth: ['calm', 'curve-simplify'] };
/** Where nothing is selected. */
const EMPTY = [['undo', 'redo'], ['paste', 'paste-in-place', 'select-all'], ['view-fit', 'zoom-100', 'show-grid', 'show-rulers'],
  ['export', 'shortcuts']];

export class Context {
  /** @param {Shell} shell */
  static async make(shell) {
    await Menu.dressed();
    return new Context(shell);
  }

  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.menu = new Menu(shell, 'context', 'shell.context');
  }

  /**
   * @param {number} x of the window @param {number} y
   * @param {boolean} there it was pointed at, so that what lies there is chosen first
   */
  show(x, y, there) {
    const { engine, wake } = this.shell;
    if (there) {
      this.#choose(x, y);
    }
    const offered = engine.actions().map((name) => name.replace('*', ''));
    const tool = this.shell.panel.tables.tools[this.shell.loop.tool]?.name ?? '';
    this.menu.open(offered.length > 0 ? this.#chosen(offered) : [HELD[tool] ?? [], ...EMPTY], x, y);
    wake();
  }

  /** Chooses what lies there, as a click would, unless it is chosen. @param {number} x @param {number} y */
  #choose(x, y) {
    const { engine, stage, loop, panel } = this.shell;
    if (panel.tables.tools[loop.tool]?.name !== 'select' || /move|resize/.test(stage.dataset.cursor ?? '') && loop.selected > 0) {
      return;
    }
    const box = stage.getBoundingClientRect();
    const at = { device: Device.MOUSE, contact: -7, modifiers: 0, x: x - box.left, y: y - box.top, pressure: 0.5, tiltX: 0, tiltY: 0,
      twist: 0, width: 1, height: 1, predicted: false, time: performance.now() };
    engine.pointer([{ ...at, phase: Phase.DOWN, buttons: 1 }, { ...at, phase: Phase.UP, buttons: 0 }]);
  }

  /** @param {string[]} offered */
  #chosen(offered) {
    const names = this.shell.panel.tables.commands.map(({ name }) => name);
    const groups = CHOSEN.map((family) => names.filter((name) => family.test(name) && (offered.includes(name) || ALWAYS.includes(name))));
    return [['cut', 'copy', 'copy-picture', 'paste', 'duplicate', 'repeat'], ...groups.slice(0, -1), ['calm'], groups[groups.length - 1]];
  }
}
