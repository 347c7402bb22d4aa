// The menu of what fits here: by a right click without a drag, a long press without a stroke, or the menu key. Made from
// the table of commands; for what is selected the engine says which of them apply. Fetched when it is first opened.

import { Device, Phase } from '../engine/codes.js';
import { dress } from '../page/build.js';
import { keyName, tell, word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */

const EDGE = 8; // pixels that it keeps from the window's edges
/** For what is selected, a line of the menu's rules between them: those that the engine offers. */
const CHOSEN = [/^(un)?group$|^combine$|^release$|^isolate$/, /^region-/, /^order-/, /^curve-|^to-page$|^mirror-(across|down)$/,
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
    await dress('styles/context.css');
    return new Context(shell);
  }

  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.box = tell(document.createElement('div'), { label: 'shell.context' });
    this.box.id = 'context';
    this.box.className = 'context';
    this.box.popover = 'manual'; // the lift of a long press would dismiss it otherwise
    this.box.setAttribute('role', 'menu');
    this.box.addEventListener('keydown', (event) => this.#key(event));
    this.box.addEventListener('contextmenu', (event) => event.preventDefault());
    addEventListener('pointerdown', ({ target }) => {
      if (!this.box.contains(/** @type {Node} */ (target))) {
        this.box.hidePopover();
      }
    }, true);
    addEventListener('blur', () => this.box.hidePopover());
    addEventListener('wheel', () => this.box.hidePopover(), { passive: true });
    document.querySelector('main')?.append(this.box);
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
    this.#fill(offered.length > 0 ? this.#chosen(offered) : [HELD[tool] ?? [], ...EMPTY]);
    this.box.showPopover();
    const { width, height } = this.box.getBoundingClientRect();
    const scale = /** @type {any} */ (this.box).currentCSSZoom ?? 1;
    this.box.style.setProperty('left', `${Math.max(EDGE, Math.min(x, innerWidth - width - EDGE)) / scale}px`);
    this.box.style.setProperty('top', `${Math.max(EDGE, Math.min(y, innerHeight - height - EDGE)) / scale}px`);
    this.#items()[0]?.focus();
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
    return [['cut', 'copy', 'paste', 'duplicate'], ...groups.slice(0, -1), ['calm'], groups[groups.length - 1]];
  }

  /** @param {string[][]} groups */
  #fill(groups) {
    const { commands } = this.shell.panel.tables;
    this.box.replaceChildren();
    for (const group of groups) {
      const items = group.flatMap((name) => commands.filter((row) => row.name === name).slice(0, 1));
      if (items.length > 0 && this.box.children.length > 0) {
        this.box.append(document.createElement('hr'));
      }
      this.box.append(...items.map((row) => this.#item(row)));
    }
  }

  /** @param {import('../engine/types.js').CommandRow} row */
  #item({ name, keys }) {
    const item = document.createElement('button');
    item.type = 'button';
    item.setAttribute('role', 'menuitem');
    item.dataset.command = name;
    const label = document.createElement('span');
    label.textContent = word(`command.${name}`);
    item.append(label);
    if (keys.length > 0) {
      const key = document.createElement('kbd');
      key.textContent = keyName(keys[0]);
      item.append(key);
    }
    item.addEventListener('click', () => {
      this.box.hidePopover();
      this.shell.stage.focus();
      this.shell.engine.command(name);
      this.shell.wake();
    });
    return item;
  }

  #items() {
    return [...this.box.querySelectorAll('button')];
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const items = this.#items();
    const at = items.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
    const count = items.length;
    const to = { ArrowDown: (at + 1) % count, ArrowUp: (at + count - 1) % count, Home: 0, End: count - 1 }[event.key];
    if (to !== undefined) {
      items[to].focus();
      event.preventDefault();
    } else if (event.key === 'Tab' || event.key === 'Escape') {
      this.box.hidePopover();
      this.shell.stage.focus();
      event.preventDefault();
    }
    event.stopPropagation();
  }
}
