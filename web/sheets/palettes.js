// Palettes in the picker: the colours of the drawing, and GIMP's .gpl files, which are opened, kept in this browser, and saved.

import { addPalette, GPL, keepPalettes, palettes, writePalette } from '../keep/gpl.js';
import { tell, word } from '../page/words.js';
import { hexOf } from './swatches.js';

/** @typedef {import('../keep/gpl.js').Palette} Palette */

export class Palettes {
  /** @param {import('../main.js').Shell} shell @param {(colour: number) => void} give */
  constructor(shell, give) {
    this.shell = shell;
    this.give = give;
    /** @type {Palette[]} */
    this.kept = [];
    this.select = tell(document.createElement('select'), { label: 'shell.palette' });
    this.select.id = 'picker-palette';
    this.swatches = tell(document.createElement('div'), { label: 'shell.palette' });
    this.swatches.className = 'swatches';
    this.swatches.setAttribute('role', 'toolbar');
    this.file = document.createElement('input');
    Object.assign(this.file, { type: 'file', accept: '.gpl', hidden: true, id: 'picker-file' });
    this.remove = this.#button('shell.palette-remove', () => this.#remove());
    const row = document.createElement('div');
    row.className = 'line';
    row.append(this.#button('shell.palette-open', () => this.file.click()), this.#button('shell.palette-save', () => this.#save()), this.remove);
    this.box = document.createElement('div');
    this.box.className = 'palettes';
    this.box.append(this.select, this.swatches, row, this.file);
    this.select.addEventListener('change', () => this.#fill());
    this.file.addEventListener('change', () => void this.#open());
  }

  /** @param {string} key @param {() => void} run */
  #button(key, run) {
    const button = tell(document.createElement('button'), { text: key });
    button.type = 'button';
    button.addEventListener('click', run);
    return button;
  }

  /** The one that is chosen. @returns {Palette} */
  get #chosen() {
    const numbers = this.shell.engine.ask('editor_colours').split(' ').filter(Boolean).map(Number);
    return this.kept[Number(this.select.value) - 1] ??
      { name: this.shell.files.name.replace(/\.[^.]*$/, '') || word('shell.swatches'), colours: numbers.map((colour) => ({ colour, name: '' })) };
  }

  /** Lists them anew. @param {number} [at] the one to choose */
  show(at = Number(this.select.value)) {
    this.kept = palettes();
    const names = [word('shell.swatches'), ...this.kept.map(({ name }) => name)];
    this.select.replaceChildren(...names.map((name, i) => new Option(name, String(i), false, i === at)));
    this.#fill();
  }

  #fill() {
    this.remove.disabled = this.select.value === '0';
    this.swatches.replaceChildren(...this.#chosen.colours.map(({ colour, name }) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.className = 'swatch';
      button.style.backgroundColor = hexOf(colour);
      button.title = name || hexOf(colour);
      button.ariaLabel = name ? `${name}, ${hexOf(colour)}` : hexOf(colour);
      button.addEventListener('click', () => this.give(colour));
      return button;
    }));
  }

  async #open() {
    const [file] = this.file.files ?? [];
    this.file.value = '';
    try {
      await addPalette(file);
      this.show(palettes().length);
    } catch (error) {
      this.shell.files.complain(error);
    }
  }

  #save() {
    const palette = this.#chosen;
    this.shell.files.deliver(new TextEncoder().encode(writePalette(palette)), 'gpl', GPL, `${palette.name}.gpl`);
  }

  #remove() {
    const before = this.kept;
    const { name } = this.#chosen;
    const put = (/** @type {Palette[]} */ all, /** @type {number} */ at) => {
      keepPalettes(all);
      this.show(at);
    };
    const at = Number(this.select.value);
    put(before.filter((one) => one.name !== name), 0);
    this.shell.notices.ask('palette', word('shell.kept-gone', name), [{ label: word('command.undo'), run: () => put(before, at) }]);
  }
}
