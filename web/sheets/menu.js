// A menu: items in groups, at a place of the window, by pointer and keys. An item is a command, or whatever the page does itself.

import { dress } from '../page/build.js';
import { keyName, tell, word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** What the page does itself: `key` of its text. @typedef {{ name: string, key: string, run: () => void }} Act */

const EDGE = 8; // pixels that it keeps from the window's edges
const GAP = 4; // pixels between it and what has opened it

export class Menu {
  /**
   * @param {Shell} shell
   * @param {string} id @param {string} label the key of its name
   */
  constructor(shell, id, label) {
    this.shell = shell;
    this.box = tell(document.createElement('div'), { label });
    this.box.id = id;
    this.box.className = 'context';
    this.box.popover = 'manual'; // the lift of a long press would dismiss it otherwise
    this.box.setAttribute('role', 'menu');
    this.box.addEventListener('keydown', (event) => this.#key(event));
    this.box.addEventListener('contextmenu', (event) => event.preventDefault());
    /** What has opened it: a press there is not one beside it. @type {HTMLElement | null} */
    this.opener = null;
    addEventListener('pointerdown', ({ target }) => {
      const at = /** @type {Node} */ (target);
      if (!this.box.contains(at) && !this.opener?.contains(at)) {
        this.hide();
      }
    }, true);
    addEventListener('blur', () => this.hide());
    addEventListener('wheel', ({ target }) => this.box.contains(/** @type {Node} */ (target)) || this.hide(), { passive: true });
    document.querySelector('main')?.append(this.box);
  }

  /** The look of every menu. */
  static dressed() {
    return dress('styles/context.css');
  }

  hide() {
    this.box.hidePopover();
    this.opener?.setAttribute('aria-expanded', 'false');
  }

  get isOpen() {
    return this.box.matches(':popover-open');
  }

  /** @param {(string | Act)[][]} groups names of commands, and acts @param {number} x of the window @param {number} y */
  open(groups, x, y) {
    this.#fill(groups);
    this.box.showPopover();
    this.opener?.setAttribute('aria-expanded', 'true');
    this.place(x, y);
    this.#items()[0]?.focus();
  }

  /** Opens it below its opener, or closes it. @param {(string | Act)[][]} groups */
  toggle(groups) {
    if (this.isOpen || !this.opener) {
      this.hide();
    } else {
      const { left, bottom } = this.opener.getBoundingClientRect();
      this.open(groups, left, bottom + GAP);
    }
  }

  /** Moves it, within the window. @param {number} x of the window @param {number} y */
  place(x, y) {
    const { width, height } = this.box.getBoundingClientRect();
    const scale = /** @type {any} */ (this.box).currentCSSZoom ?? 1;
    this.box.style.setProperty('left', `${Math.max(EDGE, Math.min(x, innerWidth - width - EDGE)) / scale}px`);
    this.box.style.setProperty('top', `${Math.max(EDGE, Math.min(y, innerHeight - height - EDGE)) / scale}px`);
  }

  /** @param {(string | Act)[][]} groups */
  #fill(groups) {
    const { commands } = this.shell.panel.tables;
    this.box.replaceChildren();
    for (const group of groups) {
      const items = group.flatMap((one) => (typeof one === 'string' ?
        commands.filter((row) => row.name === one).slice(0, 1).map((row) => this.#command(row)) : [this.#act(one)]));
      if (items.length > 0 && this.box.children.length > 0) {
        this.box.append(document.createElement('hr'));
      }
      this.box.append(...items);
    }
  }

  /** @param {import('../engine/types.js').CommandRow} row */
  #command({ name, keys }) {
    const item = this.#item(word(`command.${name}`), () => {
      this.shell.engine.command(name);
      this.shell.wake();
    });
    item.dataset.command = name;
    if (keys.length > 0) {
      const key = document.createElement('kbd');
      key.textContent = keyName(keys[0]);
      item.append(key);
    }
    return item;
  }

  /** @param {Act} act */
  #act({ name, key, run }) {
    const item = this.#item(word(key), run);
    item.dataset.act = name;
    return item;
  }

  /** @param {string} text @param {() => void} run */
  #item(text, run) {
    const item = document.createElement('button');
    item.type = 'button';
    item.setAttribute('role', 'menuitem');
    const label = document.createElement('span');
    label.textContent = text;
    item.append(label);
    item.addEventListener('click', () => {
      this.hide();
      this.shell.stage.focus();
      run();
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
      this.hide();
      (this.opener ?? this.shell.stage).focus();
      event.preventDefault();
    }
    event.stopPropagation();
  }
}
