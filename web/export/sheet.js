// Export: a file of the page, of everything or of the selection, in a format of choice; or a picture on the clipboard.
// The last choice is remembered. Fetched with the first export.

import { answer, question } from '../sheets/question.js';
import { excerpt } from './excerpt.js';
import { row, select } from './fields.js';
import { pictureOf, print } from './picture.js';
import { FORMATS, PNG } from '../sheets/formats.js';
import { Space, standing } from './space.js';
import { PaperFields, printTiled } from './tiles.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {{ format: string, part: number, width: number, white: boolean, tolerance: number, cap: boolean } & import('./tiles.js').Paper} Choice */

const STORE = 'batten-export';
const WIDEST = 16384; // pixels that browsers paint
/** As bat_excerpt counts them. */
const PARTS = ['shell.the-page', 'shell.everything', 'shell.selection'];
const SELECTION = 2;

/** @returns {Choice} */
function remembered() {
  const usual = { format: 'svg', part: 0, width: 0, white: true, tolerance: 0, cap: false, paper: '', sheet: /** @type {[number, number]} */ ([210, 297]), overlap: 10 };
  try {
    return { ...usual, ...JSON.parse(localStorage.getItem(STORE) ?? '{}') };
  } catch {
    return usual; // corrupt
  }
}

/**
 * The fields of the sheet, and what they say.
 * @param {import('../engine/engine.js').Engine} engine @param {Choice} choice @param {boolean} selected
 * @param {boolean} [floor] whether the page is one; without: nothing is in space
 */
function fields(engine, choice, selected, floor) {
  const format = select(FORMATS.filter(({ space }) => !space || floor !== undefined).map(({ name, of }) => [of, name || word('shell.plain')]), choice.format);
  const parts = PARTS.map((key, part) => /** @type {[string, string]} */ ([String(part), word(key)]));
  const part = select(selected ? parts : parts.slice(0, SELECTION), String(choice.part));
  const width = document.createElement('input');
  Object.assign(width, { type: 'number', min: '1', max: String(WIDEST), step: '1', value: String(choice.width || '') });
  const white = document.createElement('input');
  Object.assign(white, { type: 'checkbox', checked: choice.white });
  const hint = document.createElement('p');
  hint.textContent = word('shell.print');
  const picture = [row('width', word('number.width'), width, word('unit.px')), row('white', word('shell.white'), white)];
  const space = new Space(engine, choice.tolerance, choice.cap, floor === true);
  const paper = new PaperFields(choice);
  const show = () => {
    space.show(FORMATS.find(({ of }) => of === format.value), Number(part.value));
    picture.forEach((control) => { control.hidden = format.value !== 'png'; });
    hint.hidden = format.value !== 'pdf';
    paper.show(!hint.hidden);
  };
  format.addEventListener('change', show);
  part.addEventListener('change', show);
  paper.paper.addEventListener('change', show);
  show();
  const box = document.createElement('div');
  box.className = 'export';
  box.append(row('format', word('shell.format'), format), row('part', word('shell.part'), part), ...picture, ...space.rows, ...paper.rows, hint);
  const read = () => ({ format: format.value, part: Number(part.value), white: white.checked,
    width: Math.max(0, Math.min(WIDEST, Math.round(Number(width.value) || 0))) });
  return { box, read: () => ({ ...read(), tolerance: space.tolerance, cap: space.cap, ...paper.read() }), space };
}

/** Carries it out. @param {Shell} shell @param {Choice} choice @param {Space} model @param {boolean} copied to the clipboard, as a picture */
async function carryOut({ engine, files, notices }, choice, model, copied) {
  const { of, end, type, space } = FORMATS.find(({ of }) => of === choice.format) ?? FORMATS[0];
  if (copied) {
    const picture = pictureOf(excerpt(engine, 'plain', choice.part), choice);
    await navigator.clipboard.write([new ClipboardItem({ [PNG]: picture })]);
    notices.say(word('notice.copied'));
  } else if (space) {
    files.deliver(model.made(), end, type);
  } else if (of === 'pdf') {
    const svg = excerpt(engine, 'plain', choice.part);
    await (choice.paper ? printTiled(svg, choice) : print(svg));
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
  const floor = standing(shell.engine);
  await (shell.engine.words ?? shell.words.load()); // the sheet has words that come late
  if (floor === undefined && FORMATS.some(({ of, space }) => space && of === format)) {
    shell.notices.say(word('shell.not-in-space.help'));
    return;
  }
  const { box, read, space } = fields(shell.engine, { ...choice, part: selected ? choice.part : choice.part % SELECTION }, selected, floor);
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
    await carryOut(shell, wanted, space, chosen === 'copy');
  } catch (error) {
    shell.notices.say(error instanceof Error ? error.message : String(error));
  }
  shell.wake();
}
