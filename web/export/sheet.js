// Export: a file of the page, of everything, of the selection, or of each object or layer, in a format of choice; or a picture on the
// clipboard. The last choice is remembered. Fetched with the first export.

import { answer, question } from '../sheets/question.js';
import { excerpt } from './excerpt.js';
import { row, select } from './fields.js';
import { pictureOf, print } from './picture.js';
import { FORMATS, PNG } from '../sheets/formats.js';
import { EACH_LAYER, EACH_SELECTED, namesOf, PARTS, piecesOf, SELECTION } from './several.js';
import { Space, standing } from './space.js';
import { PaperFields, printTiled } from './tiles.js';
import { want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** size: of pictures: a key of SIZES. @typedef {{ format: string, part: number, size: string, width: number, white: boolean, tolerance: number, cap: boolean } & import('./tiles.js').Paper} Choice */

const STORE = 'batten-export';
const WIDEST = 16384; // pixels that browsers paint
const DPI = [150, 300, 600];
const INCH = 96; // units of the drawing
/** Sizes of pictures: pixels for each unit, several of them one after the other; none: by a width in pixels. @type {Record<string, number[]>} */
const SIZES = { 1: [1], 2: [2], 3: [3], all: [1, 2, 3], ...Object.fromEntries(DPI.map((dpi) => [`${dpi}dpi`, [dpi / INCH]])), width: [] };

const USUAL = /** @type {Choice} */ ({ format: 'svg', part: 0, size: '1', width: 0, white: true, tolerance: 0, cap: false, paper: '', sheet: [210, 297], overlap: 10 });

/** What was exported last. @returns {Choice | null} null: nothing yet */
function last() {
  try {
    const kept = localStorage.getItem(STORE);
    const choice = { ...USUAL, size: '', ...JSON.parse(kept ?? '{}') };
    choice.size = choice.size in SIZES ? choice.size : choice.width ? 'width' : '1';
    return kept ? choice : null;
  } catch {
    return null; // corrupt
  }
}

/** @param {string} name */
const formatOf = (name) => FORMATS.find(({ of }) => of === name) ?? FORMATS[0];

/** Whether it is one file, whatever it holds: in space, where pieces belong together, and where the browser prints. @param {string} name */
const single = (name) => Boolean(formatOf(name).space) || name === 'pdf';

/**
 * The fields of the sheet, and what they say.
 * @param {import('../engine/engine.js').Engine} engine @param {Choice} choice @param {boolean} selected
 * @param {boolean} [floor] whether the page is one; without: nothing is in space
 */
function fields(engine, choice, selected, floor) {
  const format = select(FORMATS.filter(({ space }) => !space || floor !== undefined).map(({ name, of }) => [of, name || word('shell.plain')]), choice.format);
  const layered = engine.layers().layers.length > 0;
  const parts = PARTS.map((key, part) => /** @type {[string, string]} */ ([String(part), word(key)]))
    .filter(([part]) => (Number(part) === EACH_LAYER ? layered : selected || Number(part) < SELECTION));
  const part = select(parts, String(choice.part));
  const called = (/** @type {string} */ name) => ({ all: word('shell.all-sizes'), width: word('shell.by-width') }[name] ?? (SIZES[name][0] % 1 ? name.replace('dpi', ' dpi') : `${name}×`));
  const size = select(['1', '2', '3', 'all', ...DPI.map((dpi) => `${dpi}dpi`), 'width'].map((name) => [name, called(name)]), choice.size);
  const width = document.createElement('input');
  Object.assign(width, { type: 'number', min: '1', max: String(WIDEST), step: '1', value: String(choice.width || '') });
  const white = document.createElement('input');
  Object.assign(white, { type: 'checkbox', checked: choice.white });
  const hint = document.createElement('p');
  hint.textContent = word('shell.print');
  const wide = row('width', word('number.width'), width, word('unit.px'));
  const picture = [row('size', word('shell.size'), size), row('white', word('shell.white'), white)];
  const space = new Space(engine, choice.tolerance, choice.cap, floor === true);
  const paper = new PaperFields(choice);
  const show = () => {
    for (const option of part.options) {
      option.disabled = single(format.value) && Number(option.value) >= EACH_SELECTED;
    }
    if (part.selectedOptions[0]?.disabled) {
      part.value = '0';
    }
    space.show(FORMATS.find(({ of }) => of === format.value), Number(part.value));
    const { painted } = formatOf(format.value);
    picture.forEach((control) => { control.hidden = !painted; });
    wide.hidden = !painted || size.value !== 'width';
    hint.hidden = format.value !== 'pdf';
    paper.show(!hint.hidden);
  };
  for (const field of [format, part, size, paper.paper]) {
    field.addEventListener('change', show);
  }
  show();
  const box = document.createElement('div');
  box.className = 'export';
  box.append(row('format', word('shell.format'), format), row('part', word('shell.part'), part), picture[0], wide, picture[1], ...space.rows, ...paper.rows, hint);
  const read = () => ({ format: format.value, part: Number(part.value), size: size.value, white: white.checked,
    width: Math.max(0, Math.min(WIDEST, Math.round(Number(width.value) || 0))) });
  return { box, read: () => ({ ...read(), tolerance: space.tolerance, cap: space.cap, ...paper.read() }), space };
}

/** A picture for each size. @param {Uint8Array} svg @param {Choice} choice @param {string} type @returns {Promise<{ mark: string, blob: Blob }[]>} mark: of its name */
async function pictures(svg, { size, width, white }, type) {
  const scales = size === 'width' ? [1] : SIZES[size] ?? [1];
  return Promise.all(scales.map(async (scale) => ({ mark: scales.length > 1 && scale > 1 ? `@${scale}x` : '',
    blob: await pictureOf(svg, { width: size === 'width' ? width : 0, scale, white }, type) })));
}

/** The files, each with its name without the end of it; '': as the drawing. @param {import('../engine/engine.js').Engine} engine @param {Choice} choice */
async function filesOf(engine, choice) {
  const { of, type, painted } = formatOf(choice.format);
  const pieces = piecesOf(engine, choice.part);
  const names = choice.part < EACH_SELECTED ? [''] : namesOf(pieces.map(({ name }) => name));
  /** @type {import('./zip.js').Entry[]} */
  const files = [];
  for (const [i, piece] of pieces.entries()) {
    const bytes = excerpt(engine, painted ? 'plain' : of, choice.part, piece.id);
    for (const { mark, blob } of painted ? await pictures(bytes, choice, type) : [{ mark: '', blob: null }]) {
      files.push({ name: names[i] + mark, bytes: blob ? new Uint8Array(await blob.arrayBuffer()) : bytes });
    }
  }
  return files;
}

/** Onto the clipboard, as one picture. @param {Shell} shell @param {Choice} choice */
async function copy({ engine, notices }, choice) {
  const part = choice.part === EACH_SELECTED ? SELECTION : choice.part % EACH_SELECTED;
  const size = choice.size === 'all' ? '1' : choice.size;
  const picture = pictures(excerpt(engine, 'plain', part), { ...choice, size }, PNG).then(([{ blob }]) => blob);
  await navigator.clipboard.write([new ClipboardItem({ [PNG]: picture })]);
  notices.say(word('notice.copied'));
}

const LETTERED = ['svg', 'plain', 'pdf', 'batten']; // and pictures of pixels: what has texts

/** A file, or several. @param {Shell} shell @param {Choice} choice @param {Space} model */
async function deliver({ engine, files, notices }, choice, model) {
  const { of, end, type, space, painted } = formatOf(choice.format);
  const silent = !painted && !LETTERED.includes(of) && engine.ask('editor_holds').includes(JSON.stringify(word('kind.text')));
  if (space) {
    files.deliver(model.made(), end, type);
  } else if (of === 'pdf') {
    const svg = excerpt(engine, 'plain', choice.part);
    await (choice.paper ? printTiled(svg, choice) : print(svg));
  } else {
    const all = await filesOf(engine, choice);
    if (all.length === 1) {
      files.deliver(all[0].bytes, end, type, all[0].name ? `${all[0].name}.${end}` : undefined);
    } else {
      const { ZIP, zipOf } = await want(import('./zip.js'));
      const stem = files.name.replace(/\.[^.]*$/, '') || word('shell.untitled');
      files.deliver(zipOf(all.map(({ name, bytes }) => ({ name: `${name === '' || name.startsWith('@') ? stem : ''}${name}.${end}`, bytes }))), 'zip', ZIP);
    }
    notices.say(word('shell.exported', all.length === 1 ? formatOf(choice.format).name || word('shell.plain') : `${all.length} × ${end}`));
  }
  if (silent) {
    notices.say(word('shell.without-texts', end));
  }
}

/**
 * Asks what, and makes it.
 * @param {Shell} shell @param {string} [format] to begin with; the last one without
 * @param {boolean} [again] as it was made last, without a question if there is such a one
 */
export async function exportDrawing(shell, format, again = false) {
  const kept = last();
  const choice = { ...USUAL, ...kept, ...format ? { format } : {} };
  const selected = shell.loop.selected > 0;
  const floor = standing(shell.engine);
  await (shell.engine.words ?? shell.words.load()); // the sheet has words that come late
  if (floor === undefined && formatOf(choice.format).space && (format || again)) {
    shell.notices.say(word('shell.not-in-space.help'));
    return;
  }
  const asked = !again || !kept;
  if (!asked && !selected && [SELECTION, EACH_SELECTED].includes(choice.part)) {
    shell.notices.say(word('notice.select-first'));
    return;
  }
  const part = selected || choice.part === EACH_LAYER ? choice.part : choice.part < SELECTION ? choice.part : 0;
  const { box, read, space } = fields(shell.engine, { ...choice, part }, selected, floor);
  const chosen = asked ? await question('export', word('command.export'), [box], [answer('file', word('command.export')),
    answer('copy', word('command.copy-picture')), answer('', word('command.cancel'))]) : 'file';
  if (!chosen) {
    return;
  }
  const wanted = read();
  try {
    localStorage.setItem(STORE, JSON.stringify(wanted));
  } catch {
    // It is for this time only then.
  }
  await carryOut(shell, chosen === 'copy' ? copy(shell, wanted) : deliver(shell, wanted, space));
}

/** Tells why nothing came of it. @param {Shell} shell @param {Promise<void>} work */
async function carryOut({ notices, wake }, work) {
  try {
    await work;
  } catch (error) {
    notices.say(error instanceof Error ? error.message : String(error));
  }
  wake();
}

/** The selection, or else the page, onto the clipboard, as the last picture was made. @param {Shell} shell */
export const copyPicture = (shell) => carryOut(shell, copy(shell, { ...USUAL, ...last(), part: shell.loop.selected > 0 ? SELECTION : 0 }));
