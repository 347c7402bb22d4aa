// The sheet of styles: how curves look. Fetched when it is first opened.

import { tell } from '../page/words.js';

/** @type {import('./panel.js').Filler['fill']} */
export function fill({ tables, controls, buttons }, sheet) {
  sheet.append(tell(document.createElement('h2'), { text: 'shell.style' }),
    ...tables.properties.filter((row) => row.group === 'style').map((row) => controls.control(row, 'setting')),
    buttons.row(tables.commands.filter(({ name }) => name.startsWith('style-'))));
  return { show: () => {} };
}
