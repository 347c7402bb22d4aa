// The menu of the logo: drawings and files, and what concerns the editor as a whole. Fetched when it is first opened.

import { Menu } from './menu.js';
import { actsOf } from './others.js';

/** @typedef {import('../main.js').Shell} Shell */

export class MainMenu {
  /** @param {Shell} shell @param {HTMLElement} logo */
  static async make(shell, logo) {
    await Menu.dressed();
    return new MainMenu(shell, logo);
  }

  /** @param {Shell} shell @param {HTMLElement} logo */
  constructor(shell, logo) {
    const acts = actsOf(shell);
    const act = (/** @type {string} */ name) => ({ name, key: `shell.${name}`, run: acts[name] });
    this.menu = new Menu(shell, 'main-menu', 'shell.main-menu');
    this.menu.opener = logo;
    /** @type {(string | import('./menu.js').Act)[][]} */
    this.groups = [
      [act('new'), 'open', 'open-kept'],
      ['save', 'save-as', act('duplicate')],
      ['download-svg', 'download-native', 'export', act('share')],
      ['history', 'losses'],
      [act('start-car'), ...acts.manual ? [act('manual')] : []],
      ['shortcuts', act('settings'), act('theme')],
    ];
  }

  toggle() {
    this.menu.toggle(this.groups);
  }
}
