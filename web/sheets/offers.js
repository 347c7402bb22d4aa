// The row of commands for the selection: order, align, group, cut and mend. Fetched with its icons when something is
// first selected.

import { dress } from '../page/build.js';
import { loadIcons } from '../page/icons.js';
import { tell } from '../page/words.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').Frame} Frame */

const FAMILIES = [/^(un)?group$/, /^region-/, /^(combine|release)$/, /^mirror-/, /^(curve-|to-page$)/, /^(surface|wire)-/, /^(camera-along|body-path)$/, /^order-/, /^align-/, /^distribute-/, /^delete$/];

export class Offers {
  /** @param {Panel} panel */
  static async make(panel) {
    const [{ rove }] = await Promise.all([import('../page/regions.js'), dress('styles/offers.css'), loadIcons('arrange')]);
    const offers = new Offers(panel);
    rove(offers.row);
    return offers;
  }

  /** @param {Panel} panel */
  constructor(panel) {
    this.engine = panel.engine;
    this.shown = '';
    this.row = tell(document.createElement('div'), { label: 'shell.actions' });
    this.row.id = 'actions';
    this.row.className = 'actions';
    this.row.setAttribute('role', 'toolbar');
    this.row.hidden = true;
    /** @type {Map<string, HTMLElement>} */
    this.buttons = new Map();
    for (const family of FAMILIES) {
      const group = document.createElement('div');
      group.className = 'group';
      for (const { name } of panel.tables.commands) {
        if (family.test(name) && document.getElementById(`icon-${name}`)) {
          const button = panel.buttons.command(name, `command.${name}`);
          this.buttons.set(name, button);
          group.append(button);
        }
      }
      this.row.append(group);
    }
    document.querySelector('main')?.append(this.row);
  }

  /** @param {Frame} frame */
  show(frame) {
    const now = `${frame.selection} ${frame.revision} ${frame.tool}`;
    if (now === this.shown || frame.busy) {
      return;
    }
    this.shown = now;
    const possible = frame.selected > 0 ? this.engine.actions() : [];
    this.row.hidden = possible.length === 0;
    for (const [name, button] of this.buttons) {
      const on = possible.includes(`${name}*`);
      button.hidden = !on && !possible.includes(name);
      if (name === 'wire-frames') {
        button.setAttribute('aria-pressed', String(on));
      }
    }
    for (const group of this.row.children) {
      /** @type {HTMLElement} */ (group).hidden = [...group.children].every((one) => /** @type {HTMLElement} */ (one).hidden);
    }
  }
}
