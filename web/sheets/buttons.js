// Buttons: of commands, with icon or text; of sheets; and steppers, with which a pen changes a number.

import { icon } from '../page/icons.js';
import { tell } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').CommandRow} CommandRow */
/** @typedef {import('../engine/types.js').PropertyRow} PropertyRow */

export class Buttons {
  /**
   * @param {Engine} engine
   * @param {import('./controls.js').Controls} controls
   * @param {() => void} wake
   */
  constructor(engine, controls, wake) {
    this.engine = engine;
    this.controls = controls;
    this.wake = wake;
    /** The buttons of commands. @type {Map<string, HTMLButtonElement>} */
    this.commands = new Map();
  }

  /** @param {string} command */
  #run(command) {
    this.engine.command(command);
    this.wake();
  }

  /** @param {string} command @param {boolean} able */
  able(command, able) {
    const button = this.commands.get(command);
    if (button) {
      button.disabled = !able;
    }
  }

  /**
   * @param {string} name
   * @param {string} key of its text
   * @param {Record<string, string>} [more] further keys, for tell
   */
  plain(name, key, more = { help: '' }) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'tool';
    button.dataset.name = name;
    const picture = icon(name);
    if (picture) {
      button.append(picture);
    }
    tell(button, { [picture ? 'label' : 'text']: key, ...more });
    // After a pointer click the focus returns to the drawing; after a click by keyboard it stays on the button.
    button.addEventListener('click', (event) => {
      if (event.detail > 0) {
        button.blur();
      }
    });
    return button;
  }

  /** A command's button. @param {string} command @param {string} key of its text */
  command(command, key) {
    const button = this.plain(command, key, { help: `${key}.help`, shortcut: command });
    button.addEventListener('click', () => this.#run(command));
    this.commands.set(command, button);
    return button;
  }

  /** @param {string} command */
  word(command) {
    const button = tell(document.createElement('button'), { text: `command.${command}`, help: `command.${command}.help` });
    button.type = 'button';
    button.addEventListener('click', () => this.#run(command));
    return button;
  }

  /**
   * A button that steps a number, for use with a pen.
   * @param {PropertyRow} row
   * @param {HTMLInputElement} input
   * @param {number} steps
   */
  stepper(row, input, steps) {
    const button = this.plain(steps < 0 ? 'less' : 'more', steps < 0 ? 'shell.less' : 'shell.more',
      { help: '', value: `property.${row.name}` });
    button.addEventListener('click', () => this.controls.step(row, input, steps));
    return button;
  }

  /** Commands as a row of buttons. @param {CommandRow[]} rows */
  row(rows) {
    const row = document.createElement('div');
    row.className = 'layer-commands';
    row.append(...rows.map(({ name }) => this.word(name)));
    return row;
  }
}
