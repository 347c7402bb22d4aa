// Beside a colour: a field for its number, and the colours that the drawing has.

import { want } from '../page/build.js';
import { tell } from '../page/words.js';

const SHOWN = 12;

/** '#rrggbb', '#rgb' or the same without '#', with two digits more for how opaque it is. @param {string} text @returns {number} 0xRRGGBBAA, or -1 */
export function colourOf(text) {
  const digits = text.trim().replace(/^#/, '');
  if (!/^([0-9a-f]{3}|[0-9a-f]{6}|[0-9a-f]{8})$/i.test(digits)) {
    return -1;
  }
  const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join('') : digits;
  return Number.parseInt(long.length === 6 ? `${long}ff` : long, 16);
}

/** @param {number} colour */
export const hexOf = (colour) => `#${(colour >>> 0).toString(16).padStart(8, '0').replace(/ff$/, '')}`;

/** Opens the colour picker. @param {import('./panel.js').Panel} panel @param {string} property @param {HTMLElement} anchor it stands beside this */
export async function choose({ shell }, property, anchor) {
  const { open } = await want(import('./picker.js'));
  await open(/** @type {import('../main.js').Shell} */ (shell), property, anchor);
}

export class Swatches {
  /**
   * @param {import('../engine/engine.js').Engine} engine
   * @param {() => void} changed
   */
  constructor(engine, changed) {
    this.engine = engine;
    this.changed = changed;
    /** @type {{ name: string, field: HTMLInputElement, row: HTMLElement }[]} */
    this.made = [];
  }

  /** @param {string} name of the property @param {number} colour */
  #set(name, colour) {
    this.engine.set(name, colour);
    this.changed();
    this.refresh();
  }

  /** The field and the colours for one property. @param {string} name */
  make(name) {
    const field = tell(document.createElement('input'), { label: 'shell.hex', value: `property.${name}` });
    Object.assign(field, { type: 'text', spellcheck: false, size: 9 });
    field.addEventListener('change', () => {
      const colour = colourOf(field.value);
      if (colour >= 0) {
        this.#set(name, colour);
      } else {
        this.refresh(); // refused: as it was
      }
    });
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' || event.key === 'Escape') {
        field.blur();
      }
    });
    const row = tell(document.createElement('div'), { label: 'shell.swatches' });
    row.className = 'swatches';
    row.setAttribute('role', 'group');
    const made = { name, field, row };
    this.made.push(made);
    return made;
  }

  /** Reads the colours of the drawing again. */
  refresh() {
    const colours = this.engine.ask('editor_colours').split(' ').filter(Boolean).slice(0, SHOWN).map(Number);
    for (const { name, field, row } of this.made) {
      if (document.activeElement !== field) {
        field.value = hexOf(this.engine.get(name));
      }
      row.replaceChildren(...colours.map((colour) => {
        const button = document.createElement('button');
        button.className = 'swatch';
        button.style.backgroundColor = hexOf(colour);
        button.title = hexOf(colour);
        button.setAttribute('aria-label', hexOf(colour));
        button.addEventListener('click', () => this.#set(name, colour));
        return button;
      }));
    }
  }
}
