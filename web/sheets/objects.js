// The objects as a tree, front first: groups and layers with what they hold, each with a picture and a name. A section of
// the inspector. Dragged to other places, renamed, hidden, locked; the engine holds all of it.

import { icon } from '../page/icons.js';
import { tell, word } from '../page/words.js';
import { thumbnail } from './thumbnail.js';

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
    this.list = tell(document.createElement('ul'), { label: 'shell.objects-list' });
    this.list.className = 'objects';
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
    /** @type {HTMLElement[]} */
    const rows = [];
    for (const row of outline.rows.length > 0 ? frontFirst(outline.rows) : []) {
      const depth = row.level - 1;
      if (depth > hidden) {
        continue;
      }
      hidden = this.shut.has(row.id) ? depth : Infinity;
      rows.push(this.#row(row, depth));
    }
    this.list.replaceChildren(...rows);
    this.none.hidden = rows.length > 0;
    /** @type {HTMLElement | null} */ (held ? this.list.querySelector(`[data-key="${held}"]`) : null)?.focus();
  }

  /** @param {Row} row @param {number} depth */
  #row(row, depth) {
    const line = document.createElement('li');
    line.className = 'object';
    line.dataset.id = String(row.id);
    line.classList.toggle('chosen', row.selected);
    line.classList.toggle('unseen', (row.state & 2) !== 0);
    line.style.setProperty('--depth', String(depth));
    const name = row.name || row.words.split(',')[0];
    line.append(this.#choose(row, name));
    if (row.state & 1) {
      const shut = this.shut.has(row.id);
      line.prepend(this.#button(shut ? 'fold-shut' : 'fold-open', `${row.id}fold`, name, () => {
        this.shut[shut ? 'delete' : 'add'](row.id);
        this.#fill();
      }, ['aria-expanded', !shut]));
    }
    for (const [bit, on, off, label] of /** @type {[number, string, string, string][]} */ ([[2, 'hidden', 'shown', 'shell.hide'],
      [4, 'locked', 'free', 'shell.lock']])) {
      const set = (row.state & bit) !== 0;
      line.append(this.#button(set ? on : off, `${row.id}${on}`, word(label, name), () => {
        const state = row.state ^ bit;
        this.engine.setState(row.id, (state & 2) !== 0, (state & 4) !== 0);
        this.panel.wake();
      }, ['aria-pressed', set]));
    }
    this.#drags(line, row.id);
    return line;
  }

  /** What chooses an object: its picture and name. @param {Row} row @param {string} name */
  #choose(row, name) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'object-name';
    button.dataset.key = String(row.id);
    button.setAttribute('aria-pressed', String(row.selected));
    button.title = row.words;
    const text = document.createElement('span');
    text.textContent = name;
    button.append(row.state & 1 ? icon('group') ?? '' : thumbnail(this.panel, row.id), text);
    button.addEventListener('click', (event) => {
      this.engine.act('editor_select', row.id, Number(event.shiftKey || event.ctrlKey || event.metaKey));
      this.panel.wake();
    });
    button.addEventListener('dblclick', () => this.#rename(row, text));
    button.addEventListener('keydown', (event) => {
      const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      const all = /** @type {HTMLElement[]} */ ([...this.list.querySelectorAll('.object-name')]);
      const other = step ? all[all.indexOf(button) + step] : undefined;
      if (event.key === 'F2') {
        this.#rename(row, text);
      } else if (step && event.altKey && other) {
        this.#place(row.id, Number(other.dataset.key));
      } else if (step) {
        other?.focus();
      } else {
        return;
      }
      event.preventDefault();
      event.stopPropagation();
    });
    return button;
  }

  /**
   * @param {string} picture @param {string} key @param {string} label
   * @param {() => void} act @param {[string, boolean]} state
   */
  #button(picture, key, label, act, [attribute, on]) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'object-state';
    button.dataset.key = key;
    button.append(icon(picture) ?? '');
    button.setAttribute('aria-label', label);
    button.title = label;
    button.setAttribute(attribute, String(on));
    button.addEventListener('click', act);
    return button;
  }

  /** @param {Row} row @param {HTMLElement} text */
  #rename(row, text) {
    const button = /** @type {HTMLElement} */ (text.parentElement);
    const input = document.createElement('input');
    input.type = 'text';
    input.value = row.name;
    input.placeholder = text.textContent ?? '';
    input.setAttribute('aria-label', word('shell.object-name', text.textContent ?? ''));
    let left = false;
    /** @param {boolean} keep */
    const end = (keep) => {
      if (left) {
        return;
      }
      left = true;
      const { value } = input;
      input.replaceWith(button);
      if (keep && value !== row.name) {
        this.engine.rename(row.id, value);
      }
      this.#fill();
      this.panel.wake();
      /** @type {HTMLElement | null} */ (this.list.querySelector(`[data-key="${row.id}"]`))?.focus();
    };
    input.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' || event.key === 'Escape') {
        end(event.key === 'Enter');
      }
    });
    input.addEventListener('blur', () => end(true));
    button.replaceWith(input);
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
