// How curves look, what is mixed in the selection, the colours of the drawing: a section of the inspector.

import { Swatches } from './swatches.js';
import { word } from '../page/words.js';

/** @type {import('./panel.js').Filler['fill']} */
export function fill({ tables, controls, buttons, engine, wake }, sheet) {
  const swatches = new Swatches(engine, () => {
    controls.refresh();
    wake();
  });
  const rows = tables.properties.filter((row) => row.group === 'style').map((row) => {
    const box = controls.control(row, 'setting');
    const mark = document.createElement('span');
    mark.className = 'unit';
    mark.dataset.mixed = row.name;
    mark.hidden = true;
    box.append(mark);
    return row.type === 'colour' ? [box, swatches.make(row.name)] : [box];
  });
  sheet.append(...rows.flat(), ...['style-', 'select-same-'].map((family) =>
    buttons.row(tables.commands.filter(({ name }) => name.startsWith(family)))));
  let shown = '';
  return {
    show(frame) {
      const now = `${frame.selection} ${frame.revision} ${document.documentElement.lang}`;
      if (now === shown || frame.busy) {
        return;
      }
      shown = now;
      const mixed = engine.ask('editor_mixed').split(' ');
      for (const mark of sheet.querySelectorAll('[data-mixed]')) {
        const element = /** @type {HTMLElement} */ (mark);
        element.hidden = !mixed.includes(element.dataset.mixed ?? '');
        element.textContent = element.hidden ? '' : word('shell.mixed');
      }
      swatches.refresh();
      controls.refresh();
    },
  };
}
