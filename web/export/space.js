// Export of what is in space: how the page stands, how fine the triangles are, and what the file will hold.

import { excerpt } from './excerpt.js';
import { row, select } from './fields.js';
import { Refusal, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {{ wide: number, deep: number, tall: number, triangles: number, open: number, bytes: number }} Told millimetres */

const EVERYTHING = 1; // as bat_excerpt counts it

/** @param {Uint8Array} bytes */
const parsed = (bytes) => JSON.parse(new TextDecoder().decode(bytes));

/** Whether the page is a floor; undefined: nothing of the drawing is in space. @param {Engine} engine @returns {boolean | undefined} */
export function standing(engine) {
  try {
    return parsed(excerpt(engine, 'space', EVERYTHING)).floor;
  } catch (error) {
    if (error instanceof Refusal) {
      return undefined;
    }
    throw error;
  }
}

/** A length to be read, in three digits. @param {number} length */
const readable = (length) => Number(length.toPrecision(4)).toLocaleString('en', { maximumSignificantDigits: 4 });

export class Space {
  /** @param {Engine} engine @param {number} tolerance 0: in proportion to the size @param {boolean} cap @param {boolean} floor */
  constructor(engine, tolerance, cap, floor) {
    this.engine = engine;
    this.stand = select(['wall', 'floor'].map((name) => /** @type {[string, string]} */ ([name, word(`shell.${name}`)])), floor ? 'floor' : 'wall');
    this.finest = document.createElement('input');
    Object.assign(this.finest, { type: 'number', min: '0', step: 'any', value: tolerance ? String(tolerance) : '', placeholder: word('shell.by-itself') });
    this.capped = document.createElement('input');
    Object.assign(this.capped, { type: 'checkbox', checked: cap });
    this.told = document.createElement('output');
    this.told.id = 'export-told';
    this.divided = true;
    /** Rows for triangles. @type {HTMLElement[]} */
    this.dividing = [row('tolerance', word('property.tolerance'), this.finest, word('unit.mm')), row('cap', word('shell.cap'), this.capped)];
    /** @type {HTMLElement[]} */
    this.rows = [row('stand', word('shell.page-stands'), this.stand), ...this.dividing, this.told];
    this.shown = 0;
    this.part = EVERYTHING;
    /** @type {string | undefined} */
    this.space = undefined;
    /** What was asked last, and the answer. @type {{ asked: string, told: Told } | undefined} */
    this.known = undefined;
    for (const field of [this.stand, this.finest, this.capped]) {
      field.addEventListener('input', () => this.tell());
    }
  }

  get tolerance() {
    return Math.max(0, Number(this.finest.value) || 0);
  }

  get cap() {
    return this.capped.checked;
  }

  /** Shows what belongs to the format. @param {{ space?: string, divided?: boolean } | undefined} format @param {number} part */
  show(format, part) {
    this.space = format?.space;
    this.part = part;
    this.rows.forEach((control) => { control.hidden = !this.space; });
    this.divided = Boolean(format?.divided);
    this.dividing.forEach((control) => { control.hidden = !this.divided; });
    this.tell();
  }

  /** What is asked of the engine. @param {string} [more] */
  asked(more = '') {
    const how = this.divided ? ` ${this.tolerance}${this.cap ? ' cap' : ''}` : '';
    return `${this.space} ${this.stand.value}${how}${more}`;
  }

  /** Says what the file will hold, once the fields have been painted. */
  tell() {
    clearTimeout(this.shown);
    if (this.space) {
      this.shown = setTimeout(() => { this.told.textContent = this.summary(); });
    }
  }

  /** What the file will hold: asked once for each way of making it, since all triangles are made for it. @returns {Told} */
  holds() {
    const asked = `${this.part} ${this.asked(' tell')}`;
    if (this.known?.asked !== asked) {
      this.known = { asked, told: parsed(excerpt(this.engine, this.asked(' tell'), this.part)) };
    }
    return this.known.told;
  }

  summary() {
    try {
      const told = this.holds();
      if (!told.bytes) {
        return word('shell.not-in-space.help');
      }
      const size = [told.wide, told.deep, told.tall].map(readable).join(' × ');
      const open = told.open ? word('shell.open-edges', told.open.toLocaleString('en')) : word('shell.watertight');
      const faces = told.triangles && this.divided ? [word('shell.triangles', told.triangles.toLocaleString('en')), open] : [];
      return [`${size} ${word('unit.mm')}`, ...faces].join(', ');
    } catch (error) {
      return error instanceof Error ? error.message : String(error);
    }
  }

  /** The file. */
  made() {
    if (!this.holds().bytes) {
      throw new Refusal(word('shell.not-in-space.help'));
    }
    return excerpt(this.engine, this.asked(), this.part);
  }
}
