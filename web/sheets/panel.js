// The toolbar, the sheets and the readouts, made from the engine's tables. There is no list of commands here: a tool
// always has its button, a command has one when the sprite holds a symbol of its name, and the menu shows them all.

import { want } from '../page/build.js';
import { icon } from '../page/icons.js';
import { LayersSheet } from './layers.js';
import { ROLE_RULER } from '../stage/paint.js';
import { tell, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Frame} Frame */
/** @typedef {import('../engine/types.js').CommandRow} CommandRow */
/** @typedef {import('../engine/types.js').PropertyRow} PropertyRow */
/** @typedef {import('../engine/types.js').Tables} Tables */

/** Where the properties of a group are; the rest are settings. @type {Record<string, string>} */
const SHEETS = { style: 'style', picture: 'pictures' };

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** A length or number, short: three figures. @param {number} value */
function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(3))) : '';
}

export class Panel {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   */
  constructor(engine, wake) {
    this.engine = engine;
    this.wake = wake;
    this.tables = engine.tables();
    /** @type {Map<string, HTMLButtonElement>} */
    this.buttons = new Map();
    /** @type {(() => void)[]} */
    this.controls = [];
    this.shown = '';
    this.levels = 0;
    this.readings = ''; // what the chips show, and from where
    /** @type {Promise<import('../stage/chips.js').Chips> | undefined} */
    this.chips = undefined;
    /** @type {Promise<import('./levels.js').LevelStrip> | undefined} */
    this.strip = undefined;
    /** The row of what the selection makes possible. @type {{ show(frame: Frame): void } | null} */
    this.actions = null;
    this.controls.push(() => {
      document.documentElement.dataset.hand = this.engine.get('left-hand') ? 'left' : 'right';
    });
    this.#fillBar();
    this.#fillSettings();
    this.#fillLayers();
    this.#fillReadouts();
    this.#fillPending();
  }

  // ---- the bar ----

  #fillBar() {
    const bar = part('tools');
    for (const tool of this.tables.tools) {
      if (!document.getElementById(`icon-${tool.command}`)) {
        continue; // one for a moment only, chosen where it is wanted
      }
      part('rail').append(this.button(tool.command, `tool.${tool.name}`));
    }
    const groups = new Map();
    for (const row of this.tables.commands) {
      const symbol = document.getElementById(`icon-${row.name}`);
      const group = symbol?.dataset.group;
      if (!group || this.buttons.has(row.name)) {
        continue;
      }
      if (!groups.has(group)) {
        groups.set(group, this.group(bar, group.toLowerCase()));
      }
      groups.get(group).append(this.button(row.name, `command.${row.name}`));
    }
    const own = this.group(bar, 'window');
    this.themeButton = this.#plainButton('theme', 'shell.theme');
    own.append(...['numbers', 'style', 'layers', 'settings', 'menu'].map((sheet) => this.#sheetButton(sheet)), this.themeButton);
  }

  /** A group of buttons. @param {HTMLElement} bar @param {string} name */
  group(bar, name) {
    const group = tell(document.createElement('div'), { label: `shell.${name}` });
    group.className = 'group';
    group.setAttribute('role', 'group');
    bar.append(group);
    return group;
  }

  /**
   * @param {string} name
   * @param {string} key of its words
   * @param {Record<string, string>} [more] for tell
   */
  #plainButton(name, key, more = { help: '' }) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'tool';
    button.dataset.name = name;
    const picture = icon(name);
    if (picture) {
      button.append(picture);
    }
    tell(button, { [picture ? 'label' : 'text']: key, ...more });
    // A click with the pointer leaves the keyboard to the drawing; one with the keyboard stays where it is.
    button.addEventListener('click', (event) => {
      if (event.detail > 0) {
        button.blur();
      }
    });
    return button;
  }

  /** A command's button. @param {string} command @param {string} key of its words */
  button(command, key) {
    const button = this.#plainButton(command, key, { help: `${key}.help`, shortcut: command });
    button.addEventListener('click', () => this.#run(command));
    this.buttons.set(command, button);
    return button;
  }

  /** @param {string} sheet */
  #sheetButton(sheet) {
    const button = this.#plainButton(sheet, `shell.${sheet}`);
    button.setAttribute('popovertarget', sheet);
    return button;
  }

  /** @param {string} command */
  #run(command) {
    this.engine.command(command);
    this.wake();
  }

  // ---- the sheets ----

  #fillSettings() {
    const sheet = part('settings');
    sheet.append(this.#heading('settings'));
    const style = part('style');
    style.append(this.#heading('style'));
    let subject = '';
    for (const row of this.tables.properties) {
      if (row.group === 'levels') {
        continue; // in the strip, once it is seen
      }
      if (row.group === '' && row.subject !== subject) {
        subject = row.subject;
        sheet.append(tell(document.createElement('h3'), { text: subject }));
      }
      part(SHEETS[row.group] ?? 'settings').append(this.control(row, 'setting'));
    }
    part('pictures').append(this.#commandRow((name) => name.startsWith('picture-') || name === 'tool-span'));
    style.append(this.#commandRow((name) => name.startsWith('style-')));
    for (const one of [sheet, style, part('layers')]) {
      one.addEventListener('toggle', () => this.refresh());
    }
    sheet.addEventListener('toggle', () => this.#drawPressure(), { once: true });
    part('numbers').addEventListener('toggle', () => this.#fillNumbers(), { once: true });
  }

  async #fillNumbers() {
    const { NumbersSheet } = await want(import('./numbers.js'));
    const sheet = part('numbers');
    sheet.append(this.#heading('numbers'));
    this.numbers = new NumbersSheet(this.engine, this.wake, sheet, this.tables.numbers);
  }

  async #drawPressure() {
    const { PressureCurve } = await want(import('./pressure.js'));
    const curve = new PressureCurve(this.engine, /** @type {Element} */ (part('setting-pressure-curve').parentElement));
    this.controls.push(() => curve.show());
    curve.show();
  }

  #fillLayers() {
    const sheet = part('layers');
    const list = new LayersSheet(this.engine, this.wake, sheet);
    sheet.prepend(this.#heading('layers'), list.list, this.#commandRow((name) => name.startsWith('layer-')));
    part('pictures').prepend(this.#heading('pictures'));
    this.layers = list;
  }

  /** The strip comes with the first curve whose levels are looked at. */
  async #showLevels() {
    this.strip ??= want(import('./levels.js')).then(({ LevelStrip }) => new LevelStrip(this, part('stage')));
    (await this.strip).show(this.levels > 0);
  }

  /** The chips come with the first stroke that could have meant something else. @param {boolean} some */
  async #showReadings(some) {
    this.chips ??= want(import('../stage/chips.js')).then(({ Chips }) => new Chips(this.engine, part('stage'), this.wake));
    (await this.chips).show(some);
  }

  /** Lets a property be typed. @param {string} property */
  ask(property) {
    const input = /** @type {HTMLInputElement} */ (document.getElementById(`setting-${property}`));
    /** @type {HTMLElement} */ (input.closest('[popover]')).showPopover();
    input.focus();
    input.select();
  }

  /** Commands as buttons in a row. @param {(name: string) => boolean} chosen */
  #commandRow(chosen) {
    const row = document.createElement('div');
    row.className = 'layer-commands';
    row.append(...this.#wordButtons(chosen));
    return row;
  }

  /** Commands as buttons with their words. @param {(name: string) => boolean} chosen */
  #wordButtons(chosen) {
    return this.tables.commands.filter((row) => chosen(row.name)).map((row) => this.wordButton(row.name));
  }

  /** @param {string} command */
  wordButton(command) {
    const button = tell(document.createElement('button'), { text: `command.${command}`, help: `command.${command}.help` });
    button.type = 'button';
    button.addEventListener('click', () => this.#run(command));
    return button;
  }

  /** @param {string} name */
  #heading(name) {
    return tell(document.createElement('h2'), { text: `shell.${name}` });
  }

  /** The label of a property's control. @param {PropertyRow} row @param {HTMLElement} control */
  #label(row, control) {
    const label = tell(document.createElement('label'), { text: `property.${row.name}`, help: `property.${row.name}.help` });
    label.htmlFor = control.id;
    return label;
  }

  /**
   * A labelled control of a property.
   * @param {PropertyRow} row
   * @param {string} kind
   */
  control(row, kind) {
    if (row.type === 'choice') {
      return this.#choice(row, kind);
    }
    const box = document.createElement('div');
    box.className = `control ${row.type}`;
    const input = document.createElement('input');
    input.id = `${kind}-${row.name}`;
    input.dataset.property = row.name;
    const length = row.unit === 'unit'; // as text, in the unit in force
    input.type = row.type === 'switch' ? 'checkbox' : row.type === 'colour' ? 'color' : length ? 'text' : 'number';
    if (row.type === 'number') {
      input.min = String(row.low);
      input.max = String(row.high);
      input.step = 'any';
      input.inputMode = 'decimal';
      input.addEventListener('keydown', (event) => {
        if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
          event.preventDefault();
          this.#step(row, input, event.key === 'ArrowUp' ? 1 : -1);
        } else if (event.key === 'Enter' || event.key === 'Escape') {
          input.blur(); // the keys belong to the drawing again
        }
      });
    }
    const alpha = row.type === 'colour' ? this.#alpha(row) : null;
    const write = () => {
      if (length) {
        this.engine.enter(row.name, input.value);
        this.refresh();
        this.wake();
        return;
      }
      const value = row.type === 'switch' ? Number(input.checked) :
        alpha ? Number.parseInt(input.value.slice(1), 16) * 256 + alpha.valueAsNumber : input.valueAsNumber;
      this.engine.set(row.name, Math.min(row.high, Math.max(row.low, value)));
      if (row.type === 'number') {
        input.value = short(this.engine.get(row.name)); // refused, it is what it was
      }
      this.refresh();
      this.wake();
    };
    input.addEventListener(row.type === 'switch' ? 'input' : 'change', write);
    this.controls.push(() => {
      if (length) {
        input.value = this.engine.number(row.name);
        return;
      }
      const value = this.engine.get(row.name);
      if (row.type === 'switch') {
        input.checked = value !== 0;
      } else if (alpha) {
        input.value = `#${(value >>> 8).toString(16).padStart(6, '0')}`;
        alpha.value = String(value & 255);
      } else if (document.activeElement !== input) { // what is being typed stays
        input.value = short(value);
      }
    });
    const unit = document.createElement('span');
    unit.className = 'unit';
    unit.textContent = length ? '' : row.unit;
    box.append(this.#label(row, input), input, alpha ?? unit);
    alpha?.addEventListener('change', write);
    return box;
  }

  /** How much a colour covers, beside it. @param {PropertyRow} row */
  #alpha(row) {
    const input = tell(document.createElement('input'), { label: 'shell.alpha', value: `property.${row.name}` });
    Object.assign(input, { type: 'range', min: '0', max: '255' });
    return input;
  }

  /**
   * @param {PropertyRow} row
   * @param {string} kind
   */
  #choice(row, kind) {
    const box = document.createElement('div');
    box.className = 'control choice';
    const select = document.createElement('select');
    select.id = `${kind}-${row.name}`;
    select.dataset.property = row.name;
    for (const [index, text] of (row.choices ?? []).entries()) {
      select.add(tell(new Option('', String(index)), { text }));
    }
    select.addEventListener('change', () => {
      this.engine.set(row.name, Number(select.value));
      this.wake();
    });
    this.controls.push(() => {
      select.value = String(this.engine.get(row.name));
    });
    box.append(this.#label(row, select), select);
    return box;
  }

  /**
   * Walks in the table's steps.
   * @param {PropertyRow} row
   * @param {HTMLInputElement} input
   * @param {number} steps
   */
  #step(row, input, steps) {
    const value = input.valueAsNumber + steps * row.step;
    input.value = short(Math.min(row.high, Math.max(row.low, value)));
    input.dispatchEvent(new Event('change'));
  }

  // ---- the readouts ----

  #fillReadouts() {
    const list = part('readouts');
    this.knots = this.#readout(list, 'shell.knots');
    const row = this.tables.properties.find((property) => property.name === 'tolerance');
    this.tolerance = this.#readout(list, 'property.tolerance');
    if (row) {
      const control = this.control(row, 'readout');
      control.querySelector('label')?.classList.add('hidden');
      const input = /** @type {HTMLInputElement} */ (control.querySelector('input'));
      input.before(this.stepper(row, input, -1));
      input.after(this.stepper(row, input, 1));
      this.tolerance.before(control);
      this.tolerance.parentElement?.classList.add('with-control');
    }
    this.zoom = this.#readout(list, 'shell.zoom');
  }

  /**
   * A button for those who hold a pen.
   * @param {PropertyRow} row
   * @param {HTMLInputElement} input
   * @param {number} steps
   */
  stepper(row, input, steps) {
    const button = this.#plainButton(steps < 0 ? 'less' : 'more', steps < 0 ? 'shell.less' : 'shell.more',
      { help: '', value: `property.${row.name}` });
    button.addEventListener('click', () => this.#step(row, input, steps));
    return button;
  }

  /** @param {HTMLElement} list @param {string} key */
  #readout(list, key) {
    const group = document.createElement('div');
    const term = tell(document.createElement('dt'), { text: key });
    const value = document.createElement('dd');
    const text = document.createElement('span');
    text.className = 'value';
    value.append(text);
    group.append(term, value);
    list.append(group);
    return text;
  }

  /** A fit that misses the tolerance waits for a yes or a no; a pen has no Enter key. */
  #fillPending() {
    part('first').querySelector('button')?.addEventListener('click', () => {
      this.engine.set('first-hints', 3);
      this.wake();
    });
    for (const name of ['accept', 'cancel']) {
      part('pending').append(this.wordButton(name));
    }
  }

  /** Other words or shortcuts. @param {Tables} tables */
  retold(tables) {
    this.tables = tables;
    this.shown = '';
    this.wake();
  }

  /** Reads every control's value again. */
  refresh() {
    for (const control of this.controls) {
      control();
    }
  }

  /** @param {Frame} frame */
  show(frame) {
    this.layers?.show(frame);
    const readings = frame.readings ? [frame.readings, frame.x, frame.y, frame.zoom, frame.angle].join() : '';
    if (readings !== this.readings) {
      this.readings = readings;
      void this.#showReadings(readings !== '');
    }
    if (frame.levels !== this.levels) {
      this.levels = frame.levels;
      void this.#showLevels();
    }
    if (part('numbers').matches(':popover-open')) {
      this.numbers?.show();
    }
    if (frame.selected > 0 && !this.actions) {
      this.actions = { show: () => {} };
      void want(import('./offers.js').then(({ Actions }) => Actions.make(this))).then((actions) => {
        this.actions = actions;
        this.wake();
      });
    }
    this.actions?.show(frame);
    const drawing = frame.knotsBefore > 0 || frame.knotsAfter > 0;
    // Touching the page costs more than comparing a line of text.
    // Values that the canvas shows, for those who do not see it; not while they still run.
    const values = frame.busy ? null : frame.labels.filter((label) => label.role !== ROLE_RULER)
      .map((label) => label.text).join(', ');
    const reach = this.engine.number('tolerance');
    const shown = [values, reach, frame.name, frame.unsaved, frame.canUndo, frame.canRedo, frame.tool, frame.knotsBefore,
      frame.knotsAfter, frame.tolerance, frame.zoom, frame.angle, frame.hint, frame.pending, frame.error,
      frame.first, frame.selection, frame.selected > 0 ? frame.revision : 0].join('\n');
    if (shown === this.shown) {
      return;
    }
    this.shown = shown;
    const name = frame.name || word('shell.untitled');
    part('name').textContent = name;
    part('unsaved').hidden = !frame.unsaved;
    document.title = `${frame.unsaved ? '• ' : ''}${name} – Batten`;
    part('hint').textContent = frame.hint;
    if (values !== null) {
      part('values').textContent = values;
    }
    part('first').hidden = frame.first === 0;
    part('first').querySelectorAll('p').forEach((hint, i) => {
      hint.hidden = !(frame.first >> i & 1);
    });
    this.#able('undo', frame.canUndo);
    this.#able('redo', frame.canRedo);
    this.tables.tools.forEach((tool, index) => {
      this.buttons.get(tool.command)?.setAttribute('aria-pressed', String(index === frame.tool));
    });
    part('pending').hidden = !frame.pending;
    const missed = frame.error > 0 ? word('shell.missed-by', short(frame.error)) : word('shell.missed');
    part('pending-text').textContent = frame.pending ? missed : '';
    const knots = /** @type {HTMLElement} */ (this.knots);
    /** @type {HTMLElement} */ (knots.closest('div')).hidden = !drawing;
    const before = frame.knotsBefore > 0 ? `${frame.knotsBefore} → ` : '';
    knots.textContent = `${before}${frame.knotsAfter}`;
    /** @type {HTMLElement} */ (this.tolerance).textContent = word('shell.in-drawing', reach);
    /** @type {HTMLElement} */ (this.zoom).textContent = [`${short(frame.zoom * 100)} %`,
      ...(frame.angle === 0 ? [] : [`${frame.angle.toFixed(0)}°`])].join(', ');
    this.refresh();
  }

  /** @param {string} command @param {boolean} able */
  #able(command, able) {
    const button = this.buttons.get(command);
    if (button) {
      button.disabled = !able;
    }
  }
}
