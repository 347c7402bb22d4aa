// The settings: the properties that belong to no other sheet, by subject. Fetched when it is first opened.

import { want } from '../page/build.js';
import { rescale, scale, SCALES } from '../page/scale.js';
import { tell } from '../page/words.js';
import { SHEET_OF } from './controls.js';
import { keyMap } from './key_map.js';

/** @param {import('./panel.js').Panel} panel */
async function drawPressure({ engine, controls }) {
  const { PressureCurve } = await want(import('./pressure.js'));
  const box = /** @type {HTMLElement} */ (document.getElementById('setting-pressure-curve')).parentElement;
  const curve = new PressureCurve(engine, /** @type {Element} */ (box));
  controls.list.push(() => curve.show());
  curve.show();
}

/** A switch for the paper of the dark theme, which is the page's own. @param {import('./panel.js').Panel} panel */
function dimPaper({ theme, controls }) {
  const row = document.createElement('div');
  const label = tell(document.createElement('label'), { text: 'shell.dim-paper', help: 'shell.dim-paper.help' });
  const input = document.createElement('input');
  row.className = 'control switch';
  Object.assign(input, { type: 'checkbox', id: 'setting-dim-paper', checked: theme?.dim });
  label.htmlFor = input.id;
  input.addEventListener('change', () => theme?.dimPaper(input.checked));
  controls.list.push(() => { input.checked = theme?.dim ?? false; });
  row.append(label, input);
  return row;
}

/** The size of the controls, which is the page's own, too. */
function sizes() {
  const row = document.createElement('div');
  const label = tell(document.createElement('label'), { text: 'shell.scale' });
  const choice = document.createElement('select');
  row.className = 'control';
  choice.id = 'setting-scale';
  label.htmlFor = choice.id;
  choice.append(...SCALES.map((percent) => new Option(`${percent} %`, String(percent), false, percent === scale())));
  choice.addEventListener('change', () => rescale(Number(choice.value)));
  row.append(label, choice);
  return row;
}

/** @type {import('./panel.js').Filler['fill']} */
export function fill(panel, sheet) {
  sheet.append(tell(document.createElement('h2'), { text: 'shell.settings' }));
  let subject = '';
  for (const row of panel.tables.properties) {
    if (SHEET_OF[row.group] || row.group === 'levels') {
      continue; // shown in that sheet, or in the level strip
    }
    if (row.group === '' && row.subject !== subject) {
      subject = row.subject;
      sheet.append(tell(document.createElement('h3'), { text: subject }));
    }
    sheet.append(panel.controls.control(row, 'setting'));
  }
  sheet.append(tell(document.createElement('h3'), { text: 'shell.theme' }), dimPaper(panel), sizes());
  sheet.append(tell(document.createElement('h3'), { text: 'shell.keys' }), keyMap(panel));
  void drawPressure(panel);
  return { show: () => {} };
}
