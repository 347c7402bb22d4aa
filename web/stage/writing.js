// Text that is typed in place: a field over the drawing, shaped by the browser as the drawing's picture of it is. Fetched with the
// first text.

import { stand, want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/**
 * A text as the engine says it (bat_editor_writing).
 * @typedef {{ id: number, text: string, family: string, size: number, weight: number, italic: boolean, spacing: number, line: number,
 *   align: 'start' | 'middle' | 'end', at: [number, number], box: number[], matrix: number[], fill: string, opacity?: number, screen: number[] }} Text
 */

const EM = 64; // pixels of letters while they are measured and typed; a matrix makes them as large as they are
const SLACK = 0.02; // of the letters' size, around what is painted
const PATIENCE = 30; // frames that the field waits for the drawing's picture of what was typed

/** Of the text written last, which the next new one begins with. @type {Partial<Text>} */
let last = {};

/** @param {Text} text @returns {string} for a canvas, at EM pixels */
const fontOf = ({ italic, weight, family }) => `${italic ? 'italic ' : ''}${weight} ${EM}px ${family}`;

/** How wide the widest line is and where the ink of the text lies, in pixels at EM, and the font's own height. @param {Text} text */
function shaped(text) {
  const context = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
  context.font = fontOf(text);
  context.textAlign = /** @type {CanvasTextAlign} */ ({ start: 'left', middle: 'center', end: 'right' }[text.align]);
  context.letterSpacing = `${text.spacing * EM / text.size}px`;
  const step = text.line * EM;
  const lines = text.text.split('\n').map((line) => context.measureText(line));
  const { fontBoundingBoxAscent: ascent, fontBoundingBoxDescent: descent } = context.measureText('x');
  const from = { start: 0, middle: -0.5, end: -1 }[text.align];
  /** @type {[number, number, number, number]} */
  const ink = [0, -ascent, 0, descent];
  lines.forEach((line, i) => {
    ink[0] = Math.min(ink[0], from * line.width, -line.actualBoundingBoxLeft);
    ink[1] = Math.min(ink[1], i * step - line.actualBoundingBoxAscent);
    ink[2] = Math.max(ink[2], (from + 1) * line.width, line.actualBoundingBoxRight);
    ink[3] = Math.max(ink[3], i * step + descent, i * step + line.actualBoundingBoxDescent);
  });
  return { ink, ascent, descent, wide: Math.max(0, ...lines.map((line) => line.width)) };
}

/** The box of what is seen of a text, in its own units: low x, low y, high x, high y. @param {Text} text */
export function boxOf(text) {
  const slack = SLACK * EM;
  return shaped(text).ink.map((at, k) => (at + (k < 2 ? -slack : slack)) * text.size / EM + text.at[k % 2]);
}

/** The text that the engine asks for. @param {{ engine: import('../engine/engine.js').Engine }} shell @returns {Text | null} */
function asked({ engine }) {
  const said = engine.ask('editor_writing');
  return said ? JSON.parse(said) : null;
}

/**
 * Gives texts to the engine, measured, as one step.
 * @param {{ engine: import('../engine/engine.js').Engine, wake: () => void }} shell @param {Text | Text[]} texts a single one is then selected
 * @returns {boolean} whether it took them
 */
export function put({ engine, wake }, texts) {
  const measured = (/** @type {Text} */ text) => ({ ...text, ...(text.text ? { box: boxOf(text) } : {}) });
  const json = JSON.stringify(Array.isArray(texts) ? texts.map(measured) : measured(texts));
  const { family, weight, italic } = [texts].flat()[0];
  last = { family, weight, italic };
  const taken = engine.guard(() => engine.lend(json, (at) => engine.wasm.editor_write(engine.editor, at)) === 0, false);
  wake();
  return taken;
}

/** The field of the text that is being typed. @type {Field | null} */
let open = null;

class Field {
  /** @param {Shell} shell @param {Text} text @param {DOMMatrix} [inner] from its units to those that the engine speaks of */
  constructor(shell, text, inner = new DOMMatrix()) {
    this.shell = shell;
    this.text = text;
    this.inner = inner;
    this.before = text.text;
    this.done = false;
    this.room = document.createElement('div');
    this.room.className = 'writing';
    this.area = document.createElement('textarea');
    this.area.value = text.text;
    this.area.spellcheck = false;
    this.area.dir = 'auto';
    this.area.setAttribute('aria-label', word('tool.text'));
    this.room.append(this.area);
    this.area.addEventListener('input', () => this.#fit());
    this.area.addEventListener('keydown', (event) => this.#key(event));
    this.area.addEventListener('blur', () => document.activeElement !== this.area && this.close()); // else the window lost it
    for (const own of ['keyup', 'copy', 'cut', 'paste']) {
      this.area.addEventListener(own, (event) => event.stopPropagation());
    }
    this.hidden = () => document.hidden && this.close(); // before the drawing is kept, as a phone may end the page then
    document.addEventListener('visibilitychange', this.hidden, true);
  }

  async begin() {
    const { shell, area } = this;
    await stand(this.room, 'styles/writing.css', shell);
    shell.painter.unseen = this.text.id;
    shell.painter.retheme();
    shell.panel.shows.push(this);
    this.#fit();
    area.focus({ preventScroll: true });
    area.select();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    event.stopPropagation();
    if (!event.isComposing && (event.key === 'Escape' || (event.key === 'Enter' && (event.ctrlKey || event.metaKey)))) {
      event.preventDefault();
      this.shell.stage.focus();
    }
  }

  /** As large as what it says. */
  #fit() {
    const { text, area } = this;
    text.text = area.value;
    const { ascent, descent, wide } = shaped(text);
    const { style } = area;
    const high = text.line * EM;
    const aside = { start: 0, middle: -50, end: -100 }[text.align];
    style.font = fontOf(text);
    style.lineHeight = `${high}px`;
    style.letterSpacing = `${text.spacing * EM / text.size}px`;
    style.textAlign = { start: 'left', middle: 'center', end: 'right' }[text.align];
    style.color = this.shell.theme.colour(Number.parseInt(text.fill.slice(1), 16));
    style.opacity = String(text.opacity ?? 1);
    style.width = `${wide + EM}px`;
    style.height = `${text.text.split('\n').length * high}px`;
    this.shift = `translate(${aside}%, ${-(high - ascent - descent) / 2 - ascent}px)`;
    this.show();
  }

  /** Every frame: it stays where it is in the drawing. */
  show() {
    const { stage } = this.shell;
    const { text, room, area } = this;
    const { screen } = asked(this.shell) ?? text;
    const scale = text.size / EM;
    const [a, b, c, d, e, f] = screen;
    const matrix = new DOMMatrix([a, b, c, d, e, f]).multiply(this.inner).translate(text.at[0], text.at[1]).scale(scale);
    room.style.inset = `${stage.offsetTop}px auto auto ${stage.offsetLeft}px`;
    room.style.width = `${stage.clientWidth}px`;
    room.style.height = `${stage.clientHeight}px`;
    area.style.transform = `${matrix} ${this.shift}`;
    area.style.setProperty('--pixel', `${1 / (Math.hypot(matrix.a, matrix.b) || 1)}px`);
  }

  /** Accepts what it says; it goes when the drawing shows it. */
  async close() {
    if (this.done) {
      return;
    }
    this.done = true;
    open = null;
    document.removeEventListener('visibilitychange', this.hidden, true);
    const { shell, text, area } = this;
    const { painter } = shell;
    const said = area.value.replace(/\s+$/, '').replace(/\t/g, ' ');
    area.readOnly = true;
    const taken = said !== this.before && put(shell, { ...text, text: said });
    const id = asked(shell)?.id;
    for (let i = 0; i < PATIENCE && taken && said && id; i++) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const item = painter.list.find((one) => one.item.id === id)?.item;
      painter.paints?.pictureOf(painter, item?.picture ?? 0);
      if (item && painter.pictures.get(item.picture)) {
        break;
      }
    }
    painter.unseen = open ? /** @type {Field} */ (open).text.id : -1;
    painter.retheme();
    shell.wake();
    shell.panel.shows.splice(shell.panel.shows.indexOf(this), 1);
    requestAnimationFrame(() => this.room.remove());
  }
}

/** Foreign content as a text, where it is plain; else the user is told. @param {Shell} shell @param {Text & { picture: number }} foreign */
async function adopted(shell, foreign) {
  const { plainOf } = await want(import('./plain.js'));
  const plain = plainOf(shell.engine.picture(foreign.picture));
  if (!plain) {
    shell.notices.say(word('notice.text-not-plain'));
    return null;
  }
  const { a, b, c, d, e, f } = new DOMMatrix(foreign.matrix).multiply(plain.inner);
  return { text: /** @type {Text} */ ({ ...foreign, ...plain.text, matrix: [a, b, c, d, e, f] }), inner: plain.inner };
}

/** Lets the text be typed that the engine asks for. @param {Shell} shell */
export async function write(shell) {
  await open?.close();
  const text = asked(shell);
  const found = !text ? null : 'picture' in text ? await adopted(shell, /** @type {Text & { picture: number }} */ (text)) :
    { text: text.id ? text : { ...text, ...last }, inner: undefined };
  if (found) {
    open = new Field(shell, found.text, found.inner);
    await open.begin();
  }
}
