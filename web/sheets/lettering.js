// How the letters of the selected texts look: the head of the inspector's Style, while a text is selected. Fetched with the first.

import { tell, word } from '../page/words.js';
import { put } from '../stage/writing.js';

/** @typedef {import('../stage/writing.js').Text} Text */
/** @typedef {import('./panel.js').Panel} Panel */

/** Fonts that every system has in some form, and those that most people have. */
const FAMILIES = ('sans-serif,serif,monospace,cursive,system-ui,Arial,Georgia,Helvetica,Times_New_Roman,Courier_New,Verdana,Noto_Sans,Noto_Serif,' +
  'Noto_Sans_KR,Noto_Sans_CJK_KR,Malgun_Gothic,Apple_SD_Gothic_Neo').replaceAll('_', ' ').split(',');
const WEIGHTS = [100, 200, 300, 400, 500, 600, 700, 800, 900];
const ALIGNS = /** @type {const} */ (['start', 'middle', 'end']);

/** How much larger letters are in the drawing than in units of their own. @param {Text} text */
const scaleOf = ({ matrix: [a, b, c, d] }) => Math.sqrt(Math.abs(a * d - b * c)) || 1;
/** @param {number} value */
const short = (value) => String(Number(value.toPrecision(4)));

/** What may be said of a text: what a field shows, and the text that it means. @type {Record<string, [(text: Text) => string, (text: Text, value: string) => Partial<Text>]>} */
const WAYS = {
  family: [({ family }) => family, (_, value) => ({ family: value.trim() || 'sans-serif' })],
  size: [(text) => short(text.size * scaleOf(text)), (text, value) => {
    const size = Math.max(Number(value), 1e-3) / scaleOf(text);
    return { size, spacing: text.spacing * size / text.size };
  }],
  weight: [({ weight }) => String(weight), (_, value) => ({ weight: Number(value) })],
  italic: [({ italic }) => String(italic), (_, value) => ({ italic: value === 'true' })],
  spacing: [({ spacing, size }) => short(100 * spacing / size), ({ size }, value) => ({ spacing: Number(value) / 100 * size })],
  line: [({ line }) => short(100 * line), (_, value) => ({ line: Math.min(100, Math.max(0, Number(value) / 100)) })],
  align: [({ align }) => align, (_, value) => ({ align: /** @type {Text['align']} */ (value) })],
};

export class Lettering {
  /** @param {Panel} panel */
  constructor(panel) {
    this.panel = panel;
    this.box = document.createElement('div');
    this.box.className = 'lettering';
    /** @type {Text[]} */
    this.texts = [];
    /** @type {Record<string, HTMLInputElement | HTMLSelectElement>} */
    this.fields = {};
    const fonts = document.createElement('datalist');
    fonts.id = 'text-families';
    fonts.append(...FAMILIES.map((name) => new Option(name, name)));
    this.box.append(fonts);
    this.#field('family', this.#input('text', { list: fonts.id }));
    this.#field('size', this.#input('number', { min: '0', step: 'any' }));
    this.#field('weight', this.#select(WEIGHTS.map((weight) => [String(weight), String(weight)])));
    this.#field('italic', this.#input('checkbox', {}));
    this.#field('spacing', this.#input('number', { step: 'any' }), '%');
    this.#field('line', this.#input('number', { min: '0', step: 'any' }), '%');
    this.#field('align', this.#select(ALIGNS.map((name) => [name, `shell.text-${name}`])));
  }

  /** @param {string} type @param {Record<string, string>} more */
  #input(type, more) {
    const input = document.createElement('input');
    input.type = type;
    Object.entries(more).forEach(([name, value]) => input.setAttribute(name, value));
    return input;
  }

  /** @param {[string, string][]} options values and their words, or keys of these */
  #select(options) {
    const select = document.createElement('select');
    select.append(...options.map(([value, text]) => {
      const option = new Option(text, value);
      return text.startsWith('shell.') ? tell(option, { text }) : option;
    }));
    return select;
  }

  /** @param {string} name @param {HTMLInputElement | HTMLSelectElement} field @param {string} [unit] */
  #field(name, field, unit = '') {
    const row = document.createElement('div');
    row.className = field.type === 'checkbox' ? 'control switch' : `control ${field.type === 'number' ? 'number' : 'choice'}`;
    field.id = `text-${name}`;
    const label = tell(document.createElement('label'), { text: `shell.text-${name}` });
    label.htmlFor = field.id;
    row.append(label, field);
    if (unit) {
      const sign = document.createElement('span');
      sign.className = 'unit';
      sign.textContent = unit;
      row.append(sign);
    }
    field.addEventListener('change', () => this.#change(name));
    field.addEventListener('keydown', (event) => /** @type {KeyboardEvent} */ (event).key === 'Enter' && field.blur());
    this.fields[name] = field;
    this.box.append(row);
  }

  /** @param {string} name */
  #valueOf(name) {
    const field = this.fields[name];
    return field instanceof HTMLInputElement && field.type === 'checkbox' ? String(field.checked) : field.value;
  }

  /** All selected texts become so, in one step. @param {string} name */
  #change(name) {
    const value = this.#valueOf(name);
    const [show, mean] = WAYS[name];
    if (value !== '' && this.texts.some((text) => show(text) !== value)) {
      put(this.panel, this.texts.map((text) => ({ ...text, ...mean(text, value) })));
    }
    this.show();
  }

  /** Shows what is selected, and nothing while no text is. */
  show() {
    const said = this.panel.engine.ask('editor_texts');
    this.texts = said ? JSON.parse(said) : [];
    this.box.hidden = this.texts.length === 0;
    for (const [name, field] of this.texts.length ? Object.entries(this.fields) : []) {
      const values = new Set(this.texts.map(WAYS[name][0]));
      const value = values.size > 1 ? '' : [...values][0];
      if (field instanceof HTMLInputElement && field.type === 'checkbox') {
        field.checked = value === 'true';
        field.indeterminate = values.size > 1;
      } else {
        field.value = value;
        /** @type {HTMLInputElement} */ (field).placeholder = values.size > 1 ? word('shell.mixed') : '';
      }
    }
  }
}
