// The layers sheet: the engine's list, front first, with a name, an eye and a lock each; the commands stand below it.

import { word } from './words.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./types.js').Frame} Frame */
/**
 * @typedef {object} Layer
 * @property {number} id
 * @property {string} name
 * @property {boolean} hidden
 * @property {boolean} locked
 * @property {number} depth
 * @property {number} members
 *
 * @typedef {object} Layers
 * @property {Layer[]} layers back to front
 * @property {number} active
 * @property {number} loose objects in no layer
 * @property {number} pictures to trace
 */

export class LayersSheet {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   * @param {HTMLElement} sheet
   */
  constructor(engine, wake, sheet) {
    this.engine = engine;
    this.wake = wake;
    this.sheet = sheet;
    this.shown = '';
    this.list = document.createElement('ul');
    this.list.className = 'layer-list';
    sheet.addEventListener('toggle', () => this.#fill());
  }

  /** @param {Frame} frame */
  show(frame) {
    const now = `${frame.revision} ${frame.layer}`;
    if (now !== this.shown) {
      this.shown = now;
      if (this.sheet.matches(':popover-open')) {
        this.#fill();
      }
    }
  }

  #fill() {
    if (this.list.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement &&
      document.activeElement.type === 'text') {
      return; // a name is being written
    }
    const { layers, active, loose, pictures } = this.engine.layers();
    /** @type {HTMLElement} */ (document.getElementById('pictures')).hidden = pictures === 0;
    const rows = layers.slice().reverse().map((layer) => this.#row(layer, layer.id === active));
    const none = { id: 0, name: word('shell.no-layer'), hidden: false, locked: false, depth: 0, members: loose };
    rows.unshift(this.#row(none, active === 0));
    this.list.replaceChildren(...rows);
  }

  /** @param {() => void} change */
  #change(change) {
    change();
    this.#fill();
    this.wake();
  }

  /** @param {Layer} layer @param {boolean} active */
  #row(layer, active) {
    const row = document.createElement('li');
    row.className = 'layer-row';
    row.style.paddingInlineStart = `${layer.depth * 16}px`;
    const choose = document.createElement('input');
    choose.type = 'radio';
    choose.name = 'layer';
    choose.checked = active;
    choose.setAttribute('aria-label', word('shell.draw-in', layer.name));
    choose.addEventListener('change', () => this.#change(() => this.engine.activateLayer(layer.id)));
    row.append(choose);
    if (layer.id === 0) {
      const name = document.createElement('span');
      name.className = 'layer-name';
      name.textContent = layer.name;
      row.append(name);
    } else {
      const name = document.createElement('input');
      name.type = 'text';
      name.className = 'layer-name';
      name.value = layer.name;
      name.setAttribute('aria-label', word('shell.layer-name'));
      name.addEventListener('change', () => this.engine.rename(layer.id, name.value));
      name.addEventListener('keydown', (event) => {
        if (event.key === 'Enter' || event.key === 'Escape') {
          name.blur();
        }
        event.stopPropagation();
      });
      name.addEventListener('blur', () => this.#change(() => {}));
      row.append(name);
    }
    const members = document.createElement('span');
    members.className = 'layer-members';
    members.textContent = String(layer.members);
    members.title = word('shell.objects', layer.members);
    row.append(members);
    if (layer.id !== 0) {
      row.append(
        this.#toggle(word(layer.hidden ? 'shell.hidden' : 'shell.shown'), layer.hidden, word('shell.hide', layer.name),
          () => this.engine.setState(layer.id, !layer.hidden, layer.locked)),
        this.#toggle(word(layer.locked ? 'shell.locked' : 'shell.free'), layer.locked, word('shell.lock', layer.name),
          () => this.engine.setState(layer.id, layer.hidden, !layer.locked)));
    }
    return row;
  }

  /**
   * @param {string} text
   * @param {boolean} pressed
   * @param {string} label
   * @param {() => void} act
   */
  #toggle(text, pressed, label, act) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = text;
    button.setAttribute('aria-pressed', String(pressed));
    button.setAttribute('aria-label', label);
    button.addEventListener('click', () => this.#change(act));
    return button;
  }
}
