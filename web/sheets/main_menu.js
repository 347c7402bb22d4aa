// The menu of the logo: drawings and files, and what concerns the editor as a whole. Fetched when it is first opened.

import { Menu } from './menu.js';

/** @typedef {import('../main.js').Shell} Shell */

const GAP = 4; // pixels between the logo and the menu

export class MainMenu {
  /** @param {Shell} shell @param {HTMLElement} logo */
  static async make(shell, logo) {
    await Menu.dressed();
    return new MainMenu(shell, logo);
  }

  /** @param {Shell} shell @param {HTMLElement} logo */
  constructor(shell, logo) {
    const { drawings, theme } = shell;
    this.menu = new Menu(shell, 'main-menu', 'shell.main-menu');
    this.menu.opener = logo;
    /** @type {(string | import('./menu.js').Act)[][]} */
    this.groups = [
      [{ name: 'new', key: 'shell.new', run: () => void drawings.openNew() }, 'open', 'open-kept'],
      ['save', 'download-svg', 'download-native', 'export'],
      ['history', 'losses'],
      ['shortcuts', { name: 'settings', key: 'shell.settings', run: () => document.getElementById('settings')?.showPopover() },
        { name: 'theme', key: 'shell.theme', run: () => theme.toggle() }],
    ];
  }

  toggle() {
    if (this.menu.isOpen) {
      this.menu.hide();
    } else {
      const { left, bottom } = /** @type {HTMLElement} */ (this.menu.opener).getBoundingClientRect();
      this.menu.open(this.groups, left, bottom + GAP);
    }
  }
}
