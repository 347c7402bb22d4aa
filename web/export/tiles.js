// A drawing in its true size over sheets of paper, as `batten render --tile` lays them out, which the browser prints or keeps as PDF.

import { PAPERS } from '../page/papers.js';
import { isolated } from '../stage/pictures.js';
import { Refusal, word } from '../page/words.js';
import { row, select } from './fields.js';
import { printAlone } from './picture.js';

/** @typedef {import('../page/papers.js').Sides} Sides in mm */
/** @typedef {{ paper: string, sheet: Sides, overlap: number }} Paper paper: '': one page of the drawing's own size */
/** In mm, each for x and y. @typedef {{ sheet: Sides, shown: Sides, step: Sides, margin: Sides, count: Sides }} Layout */

const MOST = 400; // sheets
const PIXEL = 25.4 / 96; // mm
const OWN = 'own';
const LEAST = 20; // mm: a side of paper
const LARGEST = 5080; // mm: a side of a page of PDF
const SQUARES = [50, 20, 10]; // mm
const NAMESPACE = 'http://www.w3.org/2000/svg';
const SHARE = 10; // of a sheet's shorter side is white around, but no more than so many mm

/** What the printer leaves white around. @param {Sides} sheet */
const white = (sheet) => Math.min(SHARE, Math.min(...sheet) / SHARE);

/** @template T @param {(axis: 0 | 1) => T} of @returns {[T, T]} */
const both = (of) => [of(0), of(1)];

/** @param {Sides} size @param {Sides} sheet @param {number} overlap @returns {Layout} */
function plan(size, sheet, overlap) {
  const room = both((d) => sheet[d] - 2 * white(sheet));
  const lap = Math.min(overlap, Math.min(...room) / 4);
  const same = both((d) => 1e-9 * sheet[d]); // rounding makes no sheet
  const whole = both((d) => size[d] <= sheet[d] + same[d]);
  const shown = both((d) => (whole[d] ? size[d] : room[d]));
  const step = both((d) => (whole[d] ? size[d] : room[d] - lap));
  return { sheet, shown, step, margin: both((d) => (sheet[d] - shown[d]) / 2),
    count: both((d) => (whole[d] ? 1 : Math.ceil((size[d] - room[d] - same[d]) / step[d]) + 1)) };
}

/** Paper upright or on its side, whichever takes fewer sheets. @param {Sides} size @param {Paper} paper */
export function layoutOf(size, { paper, sheet, overlap }) {
  const sides = PAPERS[paper] ?? sheet;
  const [upright, aside] = [plan(size, sides, overlap), plan(size, [sides[1], sides[0]], overlap)];
  return aside.count[0] * aside.count[1] < upright.count[0] * upright.count[1] ? aside : upright;
}

/** Of a file of ours. @param {Uint8Array} svg @returns {Sides} */
function sizeOf(svg) {
  const root = new DOMParser().parseFromString(new TextDecoder().decode(svg), 'image/svg+xml').documentElement;
  const { width, height } = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (root));
  return [width.baseVal.value * PIXEL, height.baseVal.value * PIXEL];
}

/** @param {Element} parent @param {string} name @param {Record<string, string | number>} attributes */
function add(parent, name, attributes) {
  const element = document.createElementNS(NAMESPACE, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, String(value)));
  parent.append(element);
  return element;
}

/** Where what is shown ends, longer, and where that of the neighbours does. @param {Layout} layout @param {Sides} at */
function marks({ sheet, shown, step, margin, count }, at) {
  let path = '';
  for (const d of /** @type {(0 | 1)[]} */ ([0, 1])) {
    const [from, to, room] = [margin[d], margin[d] + shown[d], margin[1 - d]];
    const places = [from, to, at[d] > 0 ? to - step[d] : from, at[d] + 1 < count[d] ? from + step[d] : to];
    for (const [k, place] of [...places, ...places].entries()) {
      const size = room * (k % 4 < 2 ? 0.6 : 0.3);
      const start = room * 0.8 - size;
      const along = k < 4 ? start : sheet[1 - d] - start - size;
      path += d ? `M${along} ${place}h${size}` : `M${place} ${along}v${size}`;
    }
  }
  return path;
}

/**
 * A square to check the printer by, in the corner of the first sheet where it lies over the least.
 * @param {Element} over @param {Layout} layout @param {HTMLImageElement} image @param {Sides} size
 */
function addSquare(over, { sheet, margin }, image, size) {
  const gap = white(sheet) * 1.5;
  const side = SQUARES.find((one) => one + 2 * gap <= Math.min(...sheet));
  if (!side) {
    return;
  }
  const context = new OffscreenCanvas(Math.ceil(sheet[0]), Math.ceil(sheet[1])).getContext('2d'); // a pixel a mm
  context?.drawImage(image, margin[0], margin[1], size[0], size[1]);
  const corners = [0, 1, 2, 3].map((k) => {
    const [x, y] = both((d) => ((d ? k & 2 : k & 1) ? sheet[d] - gap - side : gap));
    const data = [...context?.getImageData(x, y, side, side).data ?? []];
    return { x, y, ink: data.reduce((sum, value, i) => sum + (i % 4 === 3 ? value : 0), 0) };
  });
  const { x, y } = corners.reduce((best, one) => (one.ink < best.ink ? one : best));
  add(over, 'rect', { x, y, width: side, height: side, fill: 'none' });
  const text = add(over, 'text', { x: x + side / 20, y: y + side * 0.95, 'font-size': side / 10, stroke: 'none' });
  text.textContent = [side, word('unit.mm')].join(' ');
}

/**
 * One sheet. @param {Layout} layout @param {Sides} at column and row @param {HTMLImageElement} image @param {Sides} size
 */
function sheetOf(layout, at, image, size) {
  const { sheet, shown, step, margin, count } = layout;
  const box = document.createElement('div');
  const frame = document.createElement('div');
  const part = new Image();
  part.src = image.src;
  /** @param {HTMLElement} element @param {number} x @param {number} y @param {Sides} sides */
  const place = (element, x, y, sides) => Object.assign(element.style, { position: 'absolute', left: `${x}mm`, top: `${y}mm`,
    width: `${sides[0]}mm`, height: `${sides[1]}mm`, maxWidth: 'none' });
  place(frame, margin[0], margin[1], shown).overflow = 'hidden';
  place(part, -at[0] * step[0], -at[1] * step[1], size);
  frame.append(part);
  const over = document.createElementNS(NAMESPACE, 'svg');
  over.setAttribute('viewBox', `0 0 ${sheet[0]} ${sheet[1]}`);
  add(over, 'path', { d: marks(layout, at), fill: 'none' });
  const letters = white(sheet) * 0.35;
  const number = add(over, 'text', { x: white(sheet) * 1.5, y: sheet[1] - letters, 'font-size': letters, stroke: 'none' });
  number.textContent = `${word('shell.sheet-row', at[1] + 1)}, ${word('shell.sheet-column', at[0] + 1)} / ${count[1]} × ${count[0]}`;
  if (at[0] + at[1] === 0) {
    addSquare(over, layout, image, size);
  }
  box.append(frame, over);
  return box;
}

/** Opens the browser's print window with the drawing over sheets of paper. @param {Uint8Array} svg @param {Paper} paper */
export async function printTiled(svg, paper) {
  const image = await isolated(svg);
  const size = sizeOf(svg);
  const layout = layoutOf(size, paper);
  const [columns, rows] = layout.count;
  if (!(columns * rows <= MOST)) {
    throw new Refusal(word('shell.many-sheets', columns * rows));
  }
  const all = document.createElement('div');
  all.append(...Array.from({ length: rows * columns }, (_, i) =>
    sheetOf(layout, [i % columns, Math.floor(i / columns)], image, size)));
  await Promise.all([...all.querySelectorAll('img')].map((part) => part.decode()));
  const [width, height] = layout.sheet.map((side) => `${side}mm`);
  printAlone(all, `@page { size: ${width} ${height}; margin: 0 }
    #print > div { position: relative; width: ${width}; height: ${height}; overflow: hidden; break-after: page }
    #print > div:last-child { break-after: auto }
    #print svg { position: absolute; inset: 0; width: ${width}; height: ${height}; stroke: #000; stroke-width: .2; fill: #000; font-family: sans-serif }`);
}

/** The fields of the paper. */
export class PaperFields {
  /** @param {Paper} chosen */
  constructor({ paper, sheet, overlap }) {
    /** @type {[string, string][]} */
    const named = Object.keys(PAPERS).map((name) => [name, name]);
    this.paper = select([['', word('shell.one-page')], ...named, [OWN, word('shell.own-size')]], paper);
    const [width, height, lap] = [...sheet, overlap].map((value) => {
      const field = document.createElement('input');
      return Object.assign(field, { type: 'number', min: '0', max: String(LARGEST), step: 'any', value: String(value) });
    });
    this.sides = [width, height];
    this.lap = lap;
    const mm = word('unit.mm');
    this.first = row('paper', word('shell.paper'), this.paper);
    this.own = [row('paper-width', word('number.width'), width, mm), row('paper-height', word('number.height'), height, mm)];
    this.over = row('overlap', word('shell.overlap'), lap, mm);
    this.hint = document.createElement('p');
    this.hint.textContent = word('shell.true-size');
    this.rows = [this.first, ...this.own, this.over, this.hint];
  }

  /** @param {boolean} printed */
  show(printed) {
    this.first.hidden = !printed;
    this.own.forEach((one) => { one.hidden = !printed || this.paper.value !== OWN; });
    this.over.hidden = this.hint.hidden = !printed || !this.paper.value;
  }

  /** @returns {Paper} */
  read() {
    const side = (/** @type {0 | 1} */ d) => Math.max(LEAST, Math.min(LARGEST, Number(this.sides[d].value) || PAPERS.A4[d]));
    return { paper: this.paper.value, sheet: both(side), overlap: Math.max(0, Number(this.lap.value) || 0) };
  }
}
