// Fields of the export sheet, each a row with its label.

import { Measure } from '../page/measure.js';

/** @param {string} id @param {string} words @param {HTMLInputElement | HTMLSelectElement} field @param {string} [unit] of a number */
export function row(id, words, field, unit) {
  const control = document.createElement('div');
  const label = document.createElement('label');
  control.className = 'control';
  field.id = `export-${id}`;
  label.htmlFor = field.id;
  label.textContent = words;
  control.append(label, field);
  if (unit) {
    const measure = new Measure(/** @type {HTMLInputElement} */ (field));
    measure.show(`${field.value} ${unit}`);
    control.append(measure.box);
  }
  return control;
}

/** @param {[string, string][]} options @param {string} chosen */
export function select(options, chosen) {
  const field = document.createElement('select');
  for (const [value, text] of options) {
    field.add(new Option(text, value, false, value === chosen));
  }
  return field;
}
