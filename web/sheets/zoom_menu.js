// The menu of the zoom in the bar: how large, and from where the drawing is seen. Fetched when it is first opened.

import { Menu } from './menu.js';

const GROUPS = [['zoom-in', 'zoom-out', 'zoom-100'], ['view-fit', 'view-selection', 'view-upright']];
const IN_SPACE = ['view-quarter', 'view-back', 'perspective'];

export class ZoomMenu {
  /** @param {import('../main.js').Shell} shell @param {HTMLElement} button */
  static async make(shell, button) {
    await Menu.dressed();
    return new ZoomMenu(shell, button);
  }

  /** @param {import('../main.js').Shell} shell @param {HTMLElement} button */
  constructor(shell, button) {
    this.shell = shell;
    this.menu = new Menu(shell, 'zoom-menu', 'shell.zoom');
    this.menu.opener = button;
  }

  toggle() {
    this.menu.toggle(this.shell.loop.fetched ? [...GROUPS, IN_SPACE] : GROUPS);
  }
}
