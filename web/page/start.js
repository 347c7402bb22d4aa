// The empty page: what to begin with, and at first the three hands, once. Pens draw through all of it (stage/over.js).
// Fetched when a page is empty.

import { dress, want } from './build.js';
import { keep, kept } from './kept.js';
import { tell } from './words.js';
import { PAPERS, SCREENS } from './papers.js';

/** @typedef {import('../main.js').Shell} Shell */

const STORE = 'batten-hands'; // whether the hands have been seen
/** Units of the drawing, in the order of the property unit. */
const UNITS = { px: 1, mm: 96 / 25.4 };
const SIZES = ['A4', 'A3']; // offered lying

/** @param {string} text @param {string} [className] */
function button(text, className = '') {
  const made = document.createElement('button');
  made.type = 'button';
  made.className = className;
  made.textContent = text;
  return made;
}

export class Start {
  /** @param {Shell} shell */
  static async make(shell) {
    const [{ Over }] = await Promise.all([want(import('../stage/over.js')), dress('styles/start.css')]);
    Over.begin(shell);
    return new Start(shell);
  }

  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.box = /** @type {HTMLElement} */ (document.getElementById('welcome'));
    /** The length of the journal when it was last looked at: what is longer has steps. */
    this.steps = shell.engine.journal.length;
    /** @type {import('../sheets/hands.js').Hands | undefined} */
    this.hands = undefined;
    this.fetching = false;
    this.form = this.#form();
    this.row = document.createElement('div');
    this.row.className = 'start';
    this.row.append(...[
      this.#button('shell.start-new', () => this.#ask(this.form.hidden)),
      this.#button('command.open', () => void this.shell.files.pick()),
      this.#button('shell.start-trace', () => this.#trace()),
      this.#button('shell.start-car', async () => (await want(import('./sample.js'))).openCar(shell))]);
    this.box.append(this.row, this.form);
    new MutationObserver(() => this.#turned()).observe(this.box, { attributeFilter: ['hidden'] });
    this.#turned();
  }

  /** @param {string} key @param {() => void} act */
  #button(key, act) {
    const made = tell(button('', 'start-button'), { text: key });
    made.addEventListener('click', act);
    return made;
  }

  /** The empty page has come, or has gone. */
  async #turned() {
    if (this.box.hidden) {
      return;
    }
    if (this.shell.engine.journal.length !== this.steps) { // more than a press has come and gone
      this.#ask(false);
      this.box.classList.remove('chosen');
      this.hands?.end();
    }
    if (!kept(STORE) && !this.fetching) {
      this.fetching = true;
      const { Hands } = await want(import('../sheets/hands.js'));
      this.hands = new Hands(this.shell, this.box);
      keep(STORE, 'seen'); // not before: a page that is left or misses that file has shown nothing
      this.hands.begin();
    }
  }

  // ---- a new page ----

  /** @param {boolean} on */
  #ask(on) {
    this.form.hidden = !on;
    this.row.firstElementChild?.setAttribute('aria-expanded', String(on));
    if (on) {
      this.form.querySelector('input')?.select();
    }
  }

  #form() {
    const form = document.createElement('form');
    form.className = 'start-new';
    form.hidden = true;
    const fields = ['number.width', 'number.height'].map((key, i) => {
      const input = tell(document.createElement('input'), { label: key });
      Object.assign(input, { type: 'number', min: '1', max: '100000', step: 'any', value: String(PAPERS[SIZES[0]][1 - i]), required: true });
      return input;
    });
    const unit = tell(document.createElement('span'), { text: 'unit.mm' });
    const make = tell(button('', 'start-make'), { text: 'shell.start-new' });
    make.type = 'submit';
    const sizes = SIZES.map((name) => {
      const [height, width] = PAPERS[name];
      const made = button(`${name} ${width} × ${height}`);
      made.addEventListener('click', () => this.#new(width, height));
      return made;
    });
    const screens = Object.entries(SCREENS).map(([name, [width, height]]) => {
      const made = button(name);
      made.addEventListener('click', () => this.#new(width, height, 'px'));
      return made;
    });
    const free = tell(button(''), { text: 'command.page-none' });
    free.addEventListener('click', () => this.#chosen());
    const typed = document.createElement('div');
    typed.append(fields[0], '×', fields[1], unit, make);
    const ready = document.createElement('div');
    ready.append(...sizes, ...screens, free);
    form.append(typed, ready);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#new(fields[0].valueAsNumber, fields[1].valueAsNumber);
    });
    form.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') {
        this.#ask(false);
        this.#focus();
        event.stopPropagation();
      }
    });
    return form;
  }

  #focus() {
    /** @type {HTMLElement | null} */ (this.row.firstElementChild)?.focus();
  }

  /** A page of this size, in place of the empty one. @param {number} width @param {number} height @param {keyof UNITS} unit */
  #new(width, height, unit = 'mm') {
    const { engine, files, wake } = this.shell;
    const text = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}${unit}" height="${height}${unit}" ` +
      `viewBox="0 0 ${width * UNITS[unit]} ${height * UNITS[unit]}"/>`;
    try {
      engine.openSvg(text, files.name);
      files.opened = new TextEncoder().encode(text);
      engine.set('unit', Object.keys(UNITS).indexOf(unit));
      engine.command('view-fit');
      this.#chosen();
    } catch (error) {
      files.complain(error);
    }
    wake();
  }

  /** What to begin with has been chosen: the drawing has the focus, and nothing is asked until it is empty again. */
  #chosen() {
    this.#ask(false);
    this.steps = this.shell.engine.journal.length;
    this.box.classList.add('chosen');
    this.shell.stage.focus();
  }

  // ---- what is there already ----

  #trace() {
    const picker = document.createElement('input');
    picker.type = 'file';
    picker.accept = 'image/*';
    picker.multiple = true;
    picker.addEventListener('change', () =>
      void this.shell.files.arrive([...picker.files ?? []].map((file) => ({ file, place: null }))));
    picker.click();
  }
}
