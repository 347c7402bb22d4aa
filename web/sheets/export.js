// Export: a file of the page, of everything or of the selection, in a format of choice; or a picture on the clipboard.
// The last choice is remembered. Fetched with the first export.

import { answer, question } from './question.js';
import { Measure } from '../page/measure.js';
import { pictureOf, print } from './picture.js';
import { FORMATS, PNG } from './formats.js';
import { Refusal, word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {{ format: string, part: number, width: number, white: boolean }} Choice */

const STORE = 'batten-export';
const WIDEST = 16384; // pixels that browsers paint
/** As bat_excerpt counts them. */
const PARTS = ['shell.the-page', 'shell.everything', 'shell.selection'];
const SELECTION = 2;

/** @returns {Choice} */
function remembered() {
  const usual = { format: 'svg', part: 0, width: 0, white: true };
  try {
    return { ...usual, ...JSON.parse(localStorage.getItem(STORE) ?? '{}') };
  } catch {
    return usual; // corrupt
  }
}

/**
 * The bytes of that part in a format of the engine's; throws why there are none.
 * @param {import('../engine/engine.js').Engine} engine @param {string} format @param {number} part
 * @returns {Uint8Array}
 */
export function excerpt(engine, format, part) {
  const problem = engine.scratch + 16; // after where the bytes are told
  const bytes = engine.guard(() => engine.lend(format, (name) => {
    const status = engine.wasm.editor_export(engine.editor, name, part, engine.scratch, problem);
    const why = engine.string(problem + engine.layout['problem.message'] - engine.layout['problem.place']);
    return status ? why || engine.string(engine.wasm.status_message(status)) : engine.take();
  }), /** @type {string | Uint8Array} */ (word('shell.not-written')));
  if (typeof bytes === 'string') {
    throw new Refusal(bytes);
  }
  return bytes;
}

/** @param {string} id @param {string} words @param {HTMLInputElement | HTMLSelectElement} field @param {string} [unit] of a number */
function row(id, words, field, unit) {
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
function select(options, chosen) {
  const field = document.createElement('select');
  for (const [value, text] of options) {
    field.add(new Option(text, value, false, value === chosen));
  }
  return field;
}

/** The fields of the sheet, and what they say. @param {Choice} choice @param {boolean} selected */
function fields(choice, selected) {
  const format = select(FORMATS.map(({ name, of }) => [of, name || word('shell.plain')]), choice.format);
  const parts = PARTS.map((key, part) => /** @type {[string, string]} */ ([String(part), word(key)]));
  const part = select(selected ? parts : parts.slice(0, SELECTION), String(choice.part));
  const width = document.createElement('input');
  Object.assign(width, { type: 'number', min: '1', max: String(WIDEST), step: '1', value: String(choice.width || '') });
  const white = document.createElement('input');
  Object.assign(white, { type: 'checkbox', checked: choice.white });
  const hint = document.createElement('p');
  hint.textContent = word('shell.print');
  const picture = [row('width', word('number.width'), width, word('unit.px')), row('white', word('shell.white'), white)];
  const show = () => {
    picture.forEach((control) => { control.hidden = format.value !== 'png'; });
    hint.hidden = format.value !== 'pdf';
  };
  format.addEventListener('change', show);
  show();
  const box = document.createElement('div');
  box.className = 'export';
  box.append(row('format', word('shell.format'), format), row('part', word('shell.part'), part), ...picture, hint);
  const read = () => ({ format: format.value, part: Number(part.value), white: white.checked,
    width: Math.max(0, Math.min(WIDEST, Math.round(Number(width.value) || 0))) });
  return { box, read };
}

/** Carries it out. @param {Shell} shell @param {Choice} choice @param {boolean} copied to the clipboard, as a picture */
async function carryOut({ engine, files, notices }, choice, copied) {
  const { of, end, type } = FORMATS.find(({ of }) => of === choice.format) ?? FORMATS[0];
  if (copied) {
    const picture = pictureOf(excerpt(engine, 'plain', choice.part), choice);
    await navigator.clipboard.write([new ClipboardItem({ [PNG]: picture })]);
    notices.say(word('notice.copied'));
  } else if (of === 'pdf') {
    await print(excerpt(engine, 'plain', choice.part));
  } else if (of === 'png') {
    const picture = await pictureOf(excerpt(engine, 'plain', choice.part), choice);
    files.deliver(new Uint8Array(await picture.arrayBuffer()), end, type);
  } else {
    files.deliver(excerpt(engine, of, choice.part), end, type);
  }
}

/** Asks what, and makes it. @param {Shell} shell @param {string} [format] to begin with; the last one without */
export async function exportDrawing(shell, format) {
  const choice = { ...remembered(), ...format ? { format } : {} };
  const selected = shell.loop.selected > 0;
  const { box, read } = fields({ ...choice, part: selected ? choice.part : choice.part % SELECTION }, selected);
  const chosen = await question('export', word('command.export'), [box], [answer('file', word('command.export')),
    answer('copy', word('shell.copy-picture')), answer('', word('command.cancel'))]);
  if (!chosen) {
    return;
  }
  const wanted = read();
  try {
    localStorage.setItem(STORE, JSON.stringify(wanted));
  } catch {
    // It is for this time only then.
  }
  try {
    await carryOut(shell, wanted, chosen === 'copy');
  } catch (error) {
    shell.notices.say(error instanceof Error ? error.message : String(error));
  }
  shell.wake();
}
