// The drawing for screen readers: a tree of its objects and points beside the canvas, kept in step with the engine, and
// a live region that announces what has happened. The tree is visible while it has the focus. Fetched once the page
// has loaded.

import { tell } from './words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Frame} Frame */
/**
 * @typedef {object} Row
 * @property {number} id
 * @property {number} level
 * @property {number} points
 * @property {boolean} selected
 * @property {string} words
 *
 * @typedef {object} Item a line of the tree: an object, or a point of one
 * @property {string} key
 * @property {number} id
 * @property {number} point -1: the object itself
 * @property {number} level
 * @property {boolean} selected
 * @property {boolean | null} open null: cannot be expanded
 * @property {string} words
 * @property {number} place position among its siblings, from 1; 0: left to the browser
 * @property {number} total
 */

const WINDOW = 200; // objects on the page at once
const CALM = 80; // milliseconds without a frame before the tree is brought up to date

export class Mirror {
  /**
   * @param {Engine} engine
   * @param {HTMLElement} stage
   * @param {() => void} wake
   */
  constructor(engine, stage, wake) {
    this.engine = engine;
    this.stage = stage;
    this.wake = wake;
    this.first = 0;
    this.total = 0;
    /** @type {Set<number>} */
    this.opened = new Set();
    /** @type {Item[]} */
    this.items = [];
    /** What each line of the tree shows. @type {string[]} */
    this.lines = [];
    this.active = '';
    this.timer = 0;
    /** The tree itself is moving the focus. */
    this.own = false;
    this.tree = tell(document.createElement('div'), { label: 'outline' });
    this.tree.id = 'mirror';
    this.tree.className = 'mirror';
    this.tree.setAttribute('role', 'tree');
    this.tree.hidden = true;
    this.voice = document.createElement('p');
    this.voice.id = 'said';
    this.voice.className = 'hidden';
    this.voice.setAttribute('role', 'status');
    stage.after(this.tree, this.voice);
    this.tree.addEventListener('keydown', (event) => this.#key(event));
    this.tree.addEventListener('focusin', (event) => this.#focused(event));
    this.tree.addEventListener('click', (event) => this.#focused(event));
    new MutationObserver(() => this.#follow()) // when the language changes
      .observe(document.documentElement, { attributeFilter: ['lang'] });
    this.engine.ask('editor_said'); // discards earlier announcements
    this.#follow();
  }

  /** After each frame. @param {Frame} frame */
  show(frame) {
    const said = this.engine.ask('editor_said');
    if (said) {
      // A repeated announcement is a second event, so its text must differ.
      this.voice.textContent = said === this.voice.textContent ? `${said}\u00a0` : said;
    }
    clearTimeout(this.timer);
    if (!frame.busy) {
      this.timer = setTimeout(() => this.#follow(), CALM);
    }
  }

  // ---- the tree ----

  /** Brings the tree up to date. @param {boolean} [entered] the focus has just come in */
  #follow(entered = false) {
    let outline = this.#outline();
    const focused = this.tree.contains(document.activeElement);
    const led = entered || !focused; // the drawing decides where the tree stands
    if (led && outline.at >= 0 && (outline.at < this.first || outline.at >= this.first + WINDOW)) {
      this.first = Math.max(0, outline.at - WINDOW / 2);
      outline = this.#outline();
    }
    /** @type {Item[]} */
    const items = [];
    let chosen = '';
    for (const [index, row] of outline.rows.entries()) {
      const open = row.points > 0 ? this.opened.has(row.id) : null;
      const windowed = outline.total > WINDOW;
      items.push({ key: `${row.id}`, id: row.id, point: -1, level: row.level, selected: row.selected, open,
        words: row.words, place: windowed ? this.first + index + 1 : 0, total: outline.total });
      if (row.selected && !chosen) {
        chosen = `${row.id}`;
      }
      if (open) {
        const { at, points } = JSON.parse(this.engine.ask('editor_outline_points', row.id) || '{"at":-1,"points":[]}');
        for (const [point, words] of points.entries()) {
          items.push({ key: `${row.id}/${point}`, id: row.id, point, level: row.level + 1, selected: point === at,
            open: null, words, place: 0, total: 0 });
        }
        if (at >= 0) {
          chosen = `${row.id}/${at}`;
        }
      }
    }
    if (chosen && led) {
      this.active = chosen;
    }
    if (!items.some((item) => item.key === this.active)) {
      this.active = items[0]?.key ?? '';
    }
    const lines = items.map((item) => JSON.stringify([item, item.key === this.active]));
    if (entered || lines.length !== this.lines.length || lines.some((line, i) => line !== this.lines[i])) {
      this.#fill(items, lines, focused);
    }
  }

  /** @returns {{ total: number, at: number, rows: Row[] }} */
  #outline() {
    const outline = JSON.parse(this.engine.ask('editor_outline', this.first, WINDOW) ||
      '{"total":0,"at":-1,"rows":[]}');
    this.total = outline.total;
    return outline;
  }

  /** @param {Item[]} items @param {string[]} lines what each shows @param {boolean} focused */
  #fill(items, lines, focused) {
    const same = items.length === this.items.length && items.every((item, i) => item.key === this.items[i].key);
    this.items = items;
    if (!same) {
      this.tree.replaceChildren(...items.map((item) => {
        const line = document.createElement('div');
        line.setAttribute('role', 'treeitem');
        line.dataset.key = item.key;
        return line;
      }));
    }
    const before = same ? this.lines : [];
    this.lines = lines;
    for (const [i, item] of items.entries()) {
      if (lines[i] === before[i]) {
        continue;
      }
      const line = /** @type {HTMLElement} */ (this.tree.children[i]);
      line.textContent = item.words;
      line.tabIndex = item.key === this.active ? 0 : -1;
      line.setAttribute('aria-level', String(item.level));
      line.setAttribute('aria-selected', String(item.selected));
      line.style.setProperty('--level', String(item.level - 1));
      for (const [name, value] of /** @type {[string, string][]} */ ([
        ['aria-expanded', item.open === null ? '' : String(item.open)],
        ['aria-posinset', item.place ? String(item.place) : ''],
        ['aria-setsize', item.place ? String(item.total) : ''],
      ])) {
        if (value) {
          line.setAttribute(name, value);
        } else {
          line.removeAttribute(name);
        }
      }
    }
    this.tree.hidden = items.length === 0;
    if (focused) {
      this.#focus(this.active);
    }
  }

  /** @param {string} key */
  #focus(key) {
    this.own = true; // the line that had the focus may be gone
    /** @type {HTMLElement | null} */ (this.tree.querySelector(`[data-key="${key}"]`))?.focus();
    this.own = false;
  }

  // ---- input ----

  /** @param {Event} event */
  #item(event) {
    const line = event.target instanceof Element ? event.target.closest('[data-key]') : null;
    return this.items.find((item) => item.key === /** @type {HTMLElement | null} */ (line)?.dataset.key);
  }

  /** Makes the engine work on the item that has the focus. @param {Event} event */
  #focused(event) {
    const from = event instanceof FocusEvent && !this.own ? event.relatedTarget : this.tree;
    if (!this.tree.contains(/** @type {Node | null} */ (from))) {
      this.#follow(true); // go to what the drawing has selected
      return;
    }
    const item = this.#item(event);
    if (!item || (item.key === this.active && item.selected)) {
      return;
    }
    this.active = item.key;
    if (item.point >= 0) {
      this.engine.act('editor_choose', item.id, item.point);
    } else {
      this.engine.act('editor_select', item.id, 0);
    }
    this.wake();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const item = this.#item(event);
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    if (!item || !plain || !this.#take(event.key, item)) {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {string} key @param {Item} item @returns {boolean} whether the tree used the key */
  #take(key, item) {
    const at = this.items.indexOf(item);
    switch (key) {
      case 'ArrowDown': this.#go(at + 1); break;
      case 'ArrowUp': this.#go(at - 1); break;
      case 'Home': this.#jump(0); break;
      case 'End': this.#jump(this.total - 1); break;
      case 'ArrowRight':
        if (item.open === false) {
          this.#open(item.id, true);
        } else if (item.open || this.items[at + 1]?.level > item.level) {
          this.#go(at + 1);
        }
        break;
      case 'ArrowLeft':
        if (item.open) {
          this.#open(item.id, false);
        } else {
          this.#go(this.items.slice(0, at).map((other) => other.level < item.level).lastIndexOf(true));
        }
        break;
      case ' ': // adds to the selection
        this.engine.act('editor_select', item.id, 1);
        this.wake();
        break;
      case 'Enter': this.stage.focus(); break;
      default: return false;
    }
    return true;
  }

  /** @param {number} id @param {boolean} open */
  #open(id, open) {
    if (open) {
      this.opened.add(id);
    } else {
      this.opened.delete(id);
    }
    this.#follow();
  }

  /** Moves the focus to an item; beyond the window's edge the window moves along. @param {number} index */
  #go(index) {
    const last = this.first + WINDOW >= this.total;
    if (index >= this.items.length && !last) {
      this.#jump(this.first + WINDOW);
    } else if (index < 0 && this.first > 0) {
      this.#jump(this.first - 1);
    } else if (this.items[index]) {
      this.#focus(this.items[index].key);
    }
  }

  /** @param {number} object its number in the document */
  #jump(object) {
    if (object < this.first || object >= this.first + WINDOW) {
      this.first = Math.max(0, Math.min(object - WINDOW / 2, this.total - WINDOW));
      this.active = '';
      this.#follow();
    }
    const objects = this.items.filter((item) => item.point < 0);
    this.#focus(objects[object - this.first]?.key ?? '');
  }
}
