// The bar, built from the engine's tables: a command has a button when the sprite has a symbol of its name, which also says
// in which group.

import { tell } from '../page/words.js';

/** @typedef {import('./buttons.js').Buttons} Buttons */
/** @typedef {import('../engine/types.js').Tables} Tables */

const SHEETS = ['settings', 'menu'];

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** A group of buttons. @param {HTMLElement} bar @param {string} name */
export function groupOf(bar, name) {
  const group = tell(document.createElement('div'), { label: `shell.${name}` });
  group.className = 'group';
  group.setAttribute('role', 'group');
  bar.append(group);
  return group;
}

/** @param {Buttons} buttons @param {string} sheet */
function sheetButton(buttons, sheet) {
  const button = buttons.plain(sheet, `shell.${sheet}`);
  button.setAttribute('popovertarget', sheet);
  return button;
}

/**
 * @param {Tables} tables
 * @param {Buttons} buttons
 * @returns {HTMLButtonElement} the button of the theme
 */
export function fillBar(tables, buttons) {
  const bar = part('tools');
  const groups = new Map();
  for (const row of tables.commands) {
    const group = document.getElementById(`icon-${row.name}`)?.dataset.group;
    if (!group || buttons.commands.has(row.name)) {
      continue;
    }
    if (!groups.has(group)) {
      groups.set(group, groupOf(bar, group.toLowerCase()));
    }
    groups.get(group).append(buttons.command(row.name, `command.${row.name}`));
  }
  const zoom = tell(document.createElement('button'), { label: 'shell.zoom' }); // foot.js says how large; requests.js opens its menu
  Object.assign(zoom, { type: 'button', id: 'zoom', className: 'tool zoom', ariaHasPopup: 'menu', ariaExpanded: 'false' });
  groupOf(bar, 'view').append(zoom);
  const leave = buttons.command('export', 'command.export');
  leave.classList.add('leave');
  const theme = buttons.plain('theme', 'shell.theme');
  const inspector = buttons.plain('inspector', 'shell.inspector');
  inspector.setAttribute('aria-controls', 'inspector');
  groupOf(bar, 'window').append(...SHEETS.map((sheet) => sheetButton(buttons, sheet)), theme, leave, inspector);
  return theme;
}
