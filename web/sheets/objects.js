// The objects as a tree, front first: groups and layers with what they hold, each with a picture and a name. A section of
// the inspector. Dragged to other places, renamed, hidden, locked; the engine holds all of it. For the keyboard it is one
// stop, the row that was last used, with arrows from row to row and into a row's buttons: the treegrid of the WAI-ARIA
// Authoring Practices, since rows have buttons.

import { icon } from '../page/icons.js';
import { tell, word } from '../page/words.js';
import { painted, thumbnail } from './thumbnail.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').Frame} Frame */
/**
 * @typedef {object} Row of the engine's outline
 * @property {number} id
 * @property {number} state bits: 1 holds others, 2 hidden, 4 locked
 * @property {string} name
 * @property {number} level
 * @property {boolean} selected
 * @property {string} words
 */

const WINDOW = 200; // objects at once
const SLACK = 4; // pixels that a press may move before it is a drag

/** Siblings the other way round, what they hold behind them: the front first. @param {Row[]} rows @returns {Row[]} */
function frontFirst(rows) {
  /** @type {Row[][]} */
  const blocks = [];
  const top = Math.min(...rows.map(({ level }) => level));
  for (const row of rows) {
    if (row.level <= top || blocks.length === 0) {
      blocks.push([row]);
    } else {
      blocks[blocks.length - 1].push(row);
    }
  }
  return blocks.reverse().flatMap(([first, ...inner]) => [first, ...inner.length > 0 ? frontFirst(inner) : []]);
}

class ObjectTree {
  /** @param {Panel} panel @param {HTMLElement} body */
  constructor(panel, body) {
    this.panel = panel;
    this.engine = panel.engine;
    this.shown = '';
    this.shut = new Set();
    /** The rows by what they show, so that those that stay are not made anew. @type {Map<string, HTMLElement>} */
    this.made = new Map();
    this.stop = ''; // the key of the row that Tab comes to
    this.list = tell(document.createElement('div'), { label: 'shell.objects-list' });
    this.list.className = 'objects';
    this.list.setAttribute('role', 'treegrid');
    this.list.setAttribute('aria-multiselectable', 'true');
    this.list.addEventListener('keydown', (event) => this.#key(event));
    this.list.addEventListener('focusin', ({ target }) => this.#settle(/** @type {Element} */ (target).closest('.object')));
    this.none = tell(document.createElement('p'), { text: 'shell.no-objects' });
    body.append(this.list, this.none);
  }

  /** @param {Frame} frame */
  show(frame) {
    const now = `${frame.revision} ${frame.selection} ${document.documentElement.lang}`;
    if (now !== this.shown && !this.list.querySelector('input')) { // not while a name is being typed
      this.shown = now;
      this.#fill();
    }
  }

  #fill() {
    /** @type {{ total: number, at: number, rows: Row[] }} */
    let outline = JSON.parse(this.engine.ask('editor_outline', 0, WINDOW) || '{"total":0,"at":-1,"rows":[]}');
    if (outline.at >= WINDOW) {
      outline = JSON.parse(this.engine.ask('editor_outline', outline.at - WINDOW / 2, WINDOW));
    }
    const held = document.activeElement instanceof HTMLElement && this.list.contains(document.activeElement) ?
      document.activeElement.dataset.key : undefined;
    let hidden = Infinity; // the depth below which rows are folded away
    /** @type {typeof this.made} */
    const made = new Map();
    for (const row of outline.rows.length > 0 ? frontFirst(outline.rows) : []) {
      const depth = row.level - 1;
      if (depth > hidden) {
        continue;
      }
      hidden = this.shut.has(row.id) ? depth : Infinity;
      const { selected, ...rest } = row;
      const shows = JSON.stringify([rest, depth, hidden, document.documentElement.lang, this.panel.theme?.turned,
        painted(this.panel, row.id)?.item.version]);
      const line = this.made.get(shows) ?? this.#row(row, depth);
      line.setAttribute('aria-selected', String(selected));
      line.classList.toggle('chosen', selected);
      made.set(shows, line);
    }
    this.made = made;
    const rows = [...made.values()];
    if (rows.length !== this.list.children.length || rows.some((row, i) => row !== this.list.children[i])) {
      this.list.replaceChildren(...rows);
    }
    this.list.hidden = rows.length === 0;
    this.none.hidden = rows.length > 0;
    const chosen = rows.find((row) => row.classList.contains('chosen'));
    this.#settle((held ? null : chosen) ?? this.#at(this.stop) ?? chosen ?? rows[0] ?? null);
    (held ? this.#at(held) : null)?.focus();
  }

  /** @param {string} key @returns {HTMLElement | null} */
  #at(key) {
    return key ? this.list.querySelector(`[data-key="${key}"]`) : null;
  }

  /** Tab comes to this row from now on. @param {Element | null} row */
  #settle(row) {
    for (const one of this.list.querySelectorAll('.object[tabindex="0"]')) {
      /** @type {HTMLElement} */ (one).tabIndex = -1;
    }
    if (row instanceof HTMLElement) {
      row.tabIndex = 0;
      this.stop = row.dataset.key ?? '';
    }
  }

  /** @param {number} id */
  #fold(id) {
    this.shut[this.shut.has(id) ? 'delete' : 'add'](id);
    this.#fill();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const target = /** @type {HTMLElement} */ (event.target);
    const row = /** @type {HTMLElement | null} */ (target.closest('.object'));
    if (!row || target instanceof HTMLInputElement || event.ctrlKey || event.metaKey) {
      return;
    }
    const rows = /** @type {HTMLElement[]} */ ([...this.list.children]);
    const stops = [row, ...row.querySelectorAll('button')]; // of this row, from its name on
    const id = Number(row.dataset.id);
    const at = rows.indexOf(row);
    const place = stops.indexOf(target);
    const forth = getComputedStyle(this.list).direction === 'rtl' ? 'ArrowLeft' : 'ArrowRight';
    const { key } = event;
    /** @type {Element | undefined} */
    let next;
    if (event.altKey && (key === 'ArrowUp' || key === 'ArrowDown')) {
      const other = rows[at + (key === 'ArrowUp' ? -1 : 1)];
      if (other) {
        this.#place(id, Number(other.dataset.id));
      }
    } else if (event.altKey) {
      return;
    } else if (key === 'ArrowUp' || key === 'ArrowDown') {
      next = rows[at + (key === 'ArrowUp' ? -1 : 1)];
    } else if (key === 'Home' || key === 'End') {
      next = rows.at(key === 'Home' ? 0 : -1);
    } else if (key === forth && place === 0 && row.ariaExpanded === 'false') {
      this.#fold(id);
    } else if (key === forth) {
      next = stops[place + 1];
    } else if (key.startsWith('Arrow') && place > 0) {
      next = stops[place - 1];
    } else if (key.startsWith('Arrow') && row.ariaExpanded === 'true') {
      this.#fold(id);
    } else if (key.startsWith('Arrow')) { // to what holds it
      next = rows.slice(0, at).reverse().find((one) => Number(one.ariaLevel) < Number(row.ariaLevel));
    } else if (key === 'F2') {
      this.#rename(row);
    } else if (place === 0 && (key === 'Enter' || key === ' ')) {
      this.#choose(id, event.shiftKey);
    } else {
      return;
    }
    /** @type {HTMLElement | undefined} */ (next)?.focus();
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {number} id @param {boolean} more beside what is chosen, or no longer */
  #choose(id, more) {
    this.engine.act('editor_select', id, Number(more));
    this.panel.wake();
  }

  /** @param {Row} row @param {number} depth */
  #row(row, depth) {
    const line = document.createElement('div');
    line.className = 'object';
    line.tabIndex = -1;
    line.dataset.id = line.dataset.key = String(row.id);
    line.setAttribute('role', 'row');
    line.setAttribute('aria-level', String(depth + 1));
    line.classList.toggle('unseen', (row.state & 2) !== 0);
    line.style.setProperty('--depth', String(depth));
    if (row.state & 1) {
      const shut = this.shut.has(row.id);
      const fold = document.createElement('span'); // for a pointer: keys fold the row itself
      fold.className = 'object-fold';
      fold.ariaHidden = 'true';
      fold.append(icon(shut ? 'fold-shut' : 'fold-open') ?? '');
      fold.addEventListener('click', () => this.#fold(row.id));
      line.setAttribute('aria-expanded', String(!shut));
      line.append(fold);
    }
    const name = row.name || row.words.split(',')[0];
    line.append(this.#name(row, name));
    for (const [bit, on, off, label] of /** @type {[number, string, string, string][]} */ ([[2, 'hidden', 'shown', 'shell.hide'],
      [4, 'locked', 'free', 'shell.lock']])) {
      const set = (row.state & bit) !== 0;
      line.append(this.#button(set ? on : off, `${row.id}${on}`, word(label, name), set, () => {
        const state = row.state ^ bit;
        this.engine.setState(row.id, (state & 2) !== 0, (state & 4) !== 0);
        this.panel.wake();
      }));
    }
    this.#drags(line, row.id);
    return line;
  }

  /** What chooses an object: its picture and name. @param {Row} row @param {string} name */
  #name(row, name) {
    const cell = document.createElement('div');
    cell.className = 'object-name';
    cell.setAttribute('role', 'gridcell');
    cell.dataset.name = row.name;
    cell.title = row.words;
    const text = document.createElement('span');
    text.textContent = name;
    cell.append(row.state & 1 ? icon('group') ?? '' : thumbnail(this.panel, row.id), text);
    cell.addEventListener('click', ({ shiftKey, ctrlKey, metaKey }) => this.#choose(row.id, shiftKey || ctrlKey || metaKey));
    cell.addEventListener('dblclick', () => this.#rename(/** @type {HTMLElement} */ (cell.parentElement)));
    return cell;
  }

  /** @param {string} picture @param {string} key @param {string} label @param {boolean} on @param {() => void} act */
  #button(picture, key, label, on, act) {
    const cell = document.createElement('div');
    cell.setAttribute('role', 'gridcell');
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'object-state';
    button.tabIndex = -1;
    button.dataset.key = key;
    button.append(icon(picture) ?? '');
    button.setAttribute('aria-label', label);
    button.title = label;
    button.setAttribute('aria-pressed', String(on));
    button.addEventListener('click', act);
    cell.append(button);
    return cell;
  }

  /** @param {HTMLElement} row */
  #rename(row) {
    const id = Number(row.dataset.id);
    const cell = /** @type {HTMLElement} */ (row.querySelector('.object-name'));
    const shown = cell.textContent ?? '';
    const named = cell.dataset.name ?? '';
    const input = document.createElement('input');
    input.type = 'text';
    input.value = named;
    input.placeholder = shown;
    input.setAttribute('aria-label', word('shell.object-name', shown));
    let left = false;
    /** @param {boolean} keep @param {boolean} back the focus returns to the row */
    const end = (keep, back) => {
      if (left) {
        return;
      }
      left = true;
      const { value } = input;
      if (keep && value !== named) {
        this.engine.rename(id, value);
      }
      this.made.clear(); // one of them holds the field
      this.#fill();
      this.panel.wake();
      if (back) {
        this.#at(String(id))?.focus();
      }
    };
    input.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' || event.key === 'Escape') {
        end(event.key === 'Enter', true);
      }
    });
    input.addEventListener('blur', () => end(true, false));
    const field = document.createElement('div');
    field.className = 'object-field';
    field.setAttribute('role', 'gridcell');
    field.append(input);
    cell.replaceWith(field);
    input.focus();
    input.select();
  }

  /** @param {number} id @param {number} target */
  #place(id, target) {
    if (id !== target && this.engine.placeLayer(id, target)) {
      this.panel.wake();
    }
  }

  /** A row dragged over another one goes to its place. @param {HTMLElement} line @param {number} id */
  #drags(line, id) {
    const mark = (/** @type {Element | null} */ over) => {
      for (const row of this.list.children) {
        row.classList.toggle('target', row === over && over !== line);
      }
    };
    const under = (/** @type {PointerEvent} */ { clientY }) => [...this.list.children].find((row) =>
      clientY < row.getBoundingClientRect().bottom) ?? this.list.lastElementChild;
    line.addEventListener('pointerdown', (press) => {
      if (press.button !== 0 || press.pointerType === 'touch' || !(press.target instanceof Element && press.target.closest('.object-name'))) {
        return; // a finger scrolls
      }
      const done = new AbortController();
      const { signal } = done;
      const end = (/** @type {PointerEvent | null} */ event) => {
        const dragged = line.classList.contains('dragged');
        done.abort();
        line.classList.remove('dragged');
        mark(null);
        if (dragged && event) {
          this.#place(id, Number(/** @type {HTMLElement} */ (under(event)).dataset.id));
        }
      };
      addEventListener('pointermove', (event) => { // the pointer may have left the row at once
        if (Math.abs(event.clientY - press.clientY) > SLACK) {
          line.classList.add('dragged');
          mark(under(event) ?? null);
        }
      }, { signal });
      addEventListener('pointerup', end, { signal });
      addEventListener('pointercancel', () => end(null), { signal });
    });
  }
}

/** @type {import('./panel.js').Filler['fill']} */
export const fill = (panel, body) => new ObjectTree(panel, body);
