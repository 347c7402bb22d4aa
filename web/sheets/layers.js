// The layers sheet: the engine's list, front first, each layer with its name, an eye and a lock; below it the commands,
// and below those the pictures to trace: a section of the inspector.

import { icon } from '../page/icons.js';
import { tell, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').CommandRow} CommandRow */
/** @typedef {import('../engine/types.js').Frame} Frame */
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
 * @property {number} pictures how many there are to trace
 * @property {Aid[]} aids
 *
 * @typedef {object} Aid a plane, a saved view, a camera
 * @property {number} id
 * @property {string} name
 * @property {string} kind in words
 * @property {boolean} hidden
 * @property {boolean} locked
 */

class LayersSheet {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   */
  constructor(engine, wake) {
    this.engine = engine;
    this.wake = wake;
    this.shown = '';
    this.list = document.createElement('ul');
    this.list.className = 'layer-list';
    this.aids = document.createElement('ul');
    this.aids.className = 'layer-list';
    this.aids.id = 'aids';
  }

  /** @param {Frame} frame */
  show(frame) {
    const now = `${frame.revision} ${frame.layer} ${document.documentElement.lang}`;
    if (now !== this.shown) {
      this.shown = now;
      this.#fill();
    }
  }

  #fill() {
    if (document.activeElement instanceof HTMLInputElement && document.activeElement.type === 'text' &&
      document.activeElement.closest('.layer-list')) {
      return; // a name is being typed
    }
    const { layers, active, loose, pictures, aids } = this.engine.layers();
    this.#fillAids(aids);
    /** @type {HTMLElement} */ (document.getElementById('pictures')).hidden = pictures === 0;
    const rows = layers.slice().reverse().map((layer) => this.#row(layer, layer.id === active));
    const none = { id: 0, name: word('shell.no-layer'), hidden: false, locked: false, depth: 0, members: loose };
    rows.unshift(this.#row(none, active === 0));
    // The rows are rebuilt; the focus returns to the same control.
    const held = document.activeElement?.closest('.layer-row');
    const parts = (/** @type {HTMLElement} */ row) => /** @type {HTMLElement[]} */ ([...row.querySelectorAll('input, button')]);
    const id = held instanceof HTMLElement && this.list.contains(held) ? held.dataset.id : null;
    const index = id ? parts(/** @type {HTMLElement} */ (held)).indexOf(/** @type {HTMLElement} */ (document.activeElement)) : -1;
    this.list.replaceChildren(...rows);
    const again = rows.find((row) => row.dataset.id === id);
    if (again) {
      parts(again)[index]?.focus();
    }
  }

  /** What has a name and is in no picture. @param {Aid[]} aids */
  #fillAids(aids) {
    /** @type {HTMLElement} */ (this.aids.parentElement).hidden = aids.length === 0;
    const held = document.activeElement?.closest('#aids li');
    const again = held ? [...this.aids.children].indexOf(held) : -1;
    this.aids.replaceChildren(...aids.map((aid) => {
      const row = document.createElement('li');
      row.className = 'layer-row';
      row.dataset.id = String(aid.id);
      row.append(this.#name(aid.id, aid.name, word('shell.aid-name', aid.kind), aid.kind),
        this.#toggle(aid.hidden ? 'hidden' : 'shown', aid.hidden, word('shell.hide', aid.name || aid.kind),
          () => this.engine.setState(aid.id, !aid.hidden, aid.locked)));
      return row;
    }));
    if (again >= 0) {
      this.aids.children[Math.min(again, aids.length - 1)]?.querySelector('button')?.focus();
    }
  }

  /** A field for a name. @param {number} id @param {string} value @param {string} label @param {string} [empty] */
  #name(id, value, label, empty = '') {
    const name = document.createElement('input');
    name.type = 'text';
    name.className = 'layer-name';
    name.value = value;
    name.placeholder = empty;
    name.setAttribute('aria-label', label);
    name.addEventListener('change', () => this.engine.rename(id, name.value));
    name.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' || event.key === 'Escape') {
        name.blur();
      }
      event.stopPropagation();
    });
    name.addEventListener('blur', () => this.#change(() => {}));
    return name;
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
    row.dataset.id = String(layer.id);
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
      row.append(this.#name(layer.id, layer.name, word('shell.layer-name')));
    }
    const members = document.createElement('span');
    members.className = 'layer-members';
    members.textContent = String(layer.members);
    members.title = word('shell.objects', layer.members);
    row.append(members);
    if (layer.id !== 0) {
      row.append(
        this.#toggle(layer.hidden ? 'hidden' : 'shown', layer.hidden, word('shell.hide', layer.name),
          () => this.engine.setState(layer.id, !layer.hidden, layer.locked)),
        this.#toggle(layer.locked ? 'locked' : 'free', layer.locked, word('shell.lock', layer.name),
          () => this.engine.setState(layer.id, layer.hidden, !layer.locked)),
        this.#grip(layer, row));
    }
    return row;
  }

  /**
   * The handle for dragging a row, or for moving it with the arrow keys.
   * @param {Layer} layer
   * @param {HTMLElement} row
   */
  #grip(layer, row) {
    const grip = this.#iconButton('grip', word('shell.move-layer', layer.name), word('shell.move-layer', layer.name));
    const rows = () => /** @type {HTMLElement[]} */ ([...this.list.children]).filter((one) => one.dataset.id !== '0');
    /** @param {HTMLElement | undefined} target */
    const place = (target) => {
      if (target && target !== row) {
        grip.focus();
        this.#change(() => this.engine.placeLayer(layer.id, Number(target.dataset.id)));
      }
    };
    /** @param {PointerEvent} event */
    const under = (event) => rows().find((one) => event.clientY < one.getBoundingClientRect().bottom) ?? rows().at(-1);
    grip.classList.add('grip');
    grip.addEventListener('pointerdown', (event) => grip.setPointerCapture(event.pointerId));
    grip.addEventListener('pointermove', (event) => {
      if (grip.hasPointerCapture(event.pointerId)) {
        rows().forEach((one) => one.classList.toggle('target', one === under(event) && one !== row));
      }
    });
    grip.addEventListener('pointerup', (event) => place(under(event)));
    grip.addEventListener('pointercancel', () => this.#fill());
    grip.addEventListener('keydown', (event) => {
      const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (step) {
        event.preventDefault();
        event.stopPropagation();
        place(rows()[rows().indexOf(row) + step]);
      }
    });
    return grip;
  }

  /** @param {string} name @param {string} label @param {string} title */
  #iconButton(name, label, title) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'tool';
    button.append(icon(name) ?? '');
    button.setAttribute('aria-label', label);
    button.title = title;
    return button;
  }

  /**
   * @param {string} name of the icon, and of its text
   * @param {boolean} pressed
   * @param {string} label
   * @param {() => void} act
   */
  #toggle(name, pressed, label, act) {
    const button = this.#iconButton(name, label, word(`shell.${name}`));
    button.setAttribute('aria-pressed', String(pressed));
    button.addEventListener('click', () => this.#change(act));
    return button;
  }
}

/** @type {import('./panel.js').Filler['fill']} */
export function fill({ engine, wake, tables, controls, buttons }, sheet) {
  /** @param {string} name */
  const heading = (name) => tell(document.createElement('h3'), { text: `shell.${name}` });
  /** @param {(row: CommandRow) => boolean} chosen */
  const row = (chosen) => buttons.row(tables.commands.filter(chosen));
  const pictures = document.createElement('div');
  pictures.id = 'pictures';
  pictures.hidden = true;
  pictures.append(heading('pictures'),
    ...tables.properties.filter(({ group }) => group === 'picture').map((property) => controls.control(property, 'setting')),
    row(({ name }) => name.startsWith('picture-') || name === 'tool-span'));
  const layers = new LayersSheet(engine, wake);
  const aids = document.createElement('div');
  aids.append(heading('aids'), layers.aids);
  sheet.append(layers.list, row(({ name }) => name.startsWith('layer-')), aids, pictures);
  return layers;
}
