// Controls of the engine's properties, built from its table: in the foot, in sheets and in the level strip.

import { tell } from '../page/words.js';
import { Measure } from '../page/measure.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').PropertyRow} PropertyRow */

/** The sheet that has the properties of a group; the rest are in the settings. @type {Record<string, string>} */
export const SHEET_OF = { style: 'style', picture: 'layers' };

/** A length or number to three significant figures. @param {number} value */
export function short(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(3))) : '';
}

export class Controls {
  /**
   * @param {Engine} engine
   * @param {() => void} wake
   */
  constructor(engine, wake) {
    this.engine = engine;
    this.wake = wake;
    /** Functions that read a control's value again. @type {(() => void)[]} */
    this.list = [];
  }

  /** Reads every control's value again. */
  refresh() {
    for (const control of this.list) {
      control();
    }
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
    const length = row.unit === 'unit'; // a length is entered as text, in the current unit
    input.type = row.type === 'switch' ? 'checkbox' : row.type === 'colour' ? 'color' : length ? 'text' : 'number';
    if (row.type === 'number') {
      input.min = String(row.low);
      input.max = String(row.high);
      input.step = 'any';
      input.inputMode = 'decimal';
      input.addEventListener('keydown', (event) => {
        if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
          event.preventDefault();
          this.step(row, input, event.key === 'ArrowUp' ? 1 : -1);
        } else if (event.key === 'Enter' || event.key === 'Escape') {
          input.blur(); // return the keyboard to the drawing
        }
      });
    }
    const alpha = row.type === 'colour' ? this.#alpha(row) : null;
    const measure = length || row.type === 'number' ? new Measure(input) : null;
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
        input.value = short(this.engine.get(row.name)); // refused: restore the value
      }
      this.refresh();
      this.wake();
    };
    input.addEventListener(row.type === 'switch' ? 'input' : 'change', write);
    this.list.push(() => {
      if (length) {
        measure?.show(this.engine.number(row.name));
        return;
      }
      const value = this.engine.get(row.name);
      if (row.type === 'switch') {
        input.checked = value !== 0;
      } else if (alpha) {
        input.value = `#${(value >>> 8).toString(16).padStart(6, '0')}`;
        alpha.value = String(value & 255);
      } else if (document.activeElement !== input) { // do not overwrite what is being typed
        measure?.show(`${short(value)} ${row.unit}`);
      }
    });
    box.append(this.#label(row, input), measure?.box ?? input, alpha ?? '');
    alpha?.addEventListener('change', write);
    return box;
  }

  /** The opacity of a colour, shown beside it. @param {PropertyRow} row */
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
    this.list.push(() => {
      select.value = String(this.engine.get(row.name));
    });
    box.append(this.#label(row, select), select);
    return box;
  }

  /**
   * Changes a value by the table's steps.
   * @param {PropertyRow} row
   * @param {HTMLInputElement} input
   * @param {number} steps
   */
  step(row, input, steps) {
    const value = input.valueAsNumber + steps * row.step;
    input.value = short(Math.min(row.high, Math.max(row.low, value)));
    input.dispatchEvent(new Event('change'));
  }
}
