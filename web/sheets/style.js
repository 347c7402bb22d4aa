// How curves look, what is mixed in the selection, the colours of the drawing: a section of the inspector. What a line or a fill has
// is seen while it is on; what is rarely asked for is folded.

import { want } from '../page/build.js';
import { keep, kept } from '../page/kept.js';
import { tell, word } from '../page/words.js';
import { choose, colourOf, Swatches } from './swatches.js';

/** A switch, what is seen while it is on (a colour, and more in a row), and the colour where none has been seen. */
const PARTS = [
  { name: 'stroked', colour: 'stroke-colour', more: ['stroke-width', 'widths'], first: 0x000000ff },
  { name: 'filled', colour: 'fill-colour', more: [], first: 0xd9d9d9ff },
];

/** What is shown while it is open; something else opens it. @param {HTMLElement[]} rows */
function fold(rows) {
  const box = document.createElement('details');
  const summary = document.createElement('summary');
  summary.hidden = true;
  box.append(summary, ...rows);
  return box;
}

/** What is rarely asked for, under its name; whether it is open is kept. @param {string} name @param {HTMLElement[]} rows */
function rare(name, rows) {
  const box = fold(rows);
  const summary = /** @type {HTMLElement} */ (box.firstElementChild);
  tell(summary, { text: `shell.${name}` });
  summary.hidden = false;
  box.className = 'rare';
  box.open = kept(`batten-${name}`) === 'yes';
  box.addEventListener('toggle', () => keep(`batten-${name}`, box.open ? 'yes' : ''));
  return box;
}

/** @type {import('./panel.js').Filler['fill']} */
export function fill(panel, sheet) {
  const { tables, controls, buttons, engine, wake } = panel;
  const changed = () => {
    controls.refresh();
    wake();
  };
  const swatches = new Swatches(engine, changed);
  const rest = new Map(tables.properties.filter((row) => row.group === 'style').map((row) => [row.name, row]));

  /** A property's control with a place for the word that it is mixed. @param {string} name */
  const control = (name) => {
    const row = rest.get(name);
    if (!row) {
      throw new Error(`no property ${name}`);
    }
    const box = controls.control(row, 'setting');
    const mark = document.createElement('span');
    mark.className = 'unit';
    mark.dataset.mixed = name;
    mark.hidden = true;
    box.append(mark);
    rest.delete(name);
    return box;
  };

  /** Controls in one row: what they are is said by what they show, and to those who listen. @param {string[]} names */
  const together = (names) => {
    const boxes = names.map(control);
    for (const box of boxes) {
      box.classList.add('together');
    }
    const row = document.createElement('div');
    row.className = 'row';
    row.append(...boxes);
    return row;
  };

  const parts = PARTS.map(({ name, colour, more, first }) => {
    const box = control(name);
    const row = together([colour]);
    const number = swatches.make(colour);
    const input = (/** @type {HTMLElement} */ from, /** @type {string} */ type) => /** @type {HTMLInputElement} */ (from.querySelector(`[type=${type}]`));
    const [toggle, well, alpha] = [input(box, 'checkbox'), input(row, 'color'), input(row, 'range')];
    alpha.before(number.field);
    well.addEventListener('click', (event) => {
      event.preventDefault(); // the browser's own
      void choose(panel, colour, well);
    });
    const part = { name, toggle, well, alpha, last: first, on: false, folded: fold([row, number.row, together(more)]) };
    // Turned on, it is seen: a colour that cannot be seen gives way to the last one that could.
    box.addEventListener('input', (event) => {
      if (toggle.checked && (engine.get(colour) & 255) === 0) {
        event.stopPropagation();
        engine.set(colour, part.last);
        changed();
      }
    }, true);
    sheet.append(box, part.folded);
    return part;
  });
  const family = (/** @type {string} */ start) => buttons.row(tables.commands.filter(({ name }) => name.startsWith(start)));
  sheet.append(control('opacity'), rare('style-more', [...rest.keys()].map(control)), family('style-'),
    rare('select-same', [family('select-same-')]));

  // After the controls have read their values. What else opens one, a command that asks for its colour, leaves it open until the
  // switch changes.
  controls.list.push(() => {
    for (const part of parts) {
      const { toggle: { checked }, well, alpha } = part;
      part.last = alpha.valueAsNumber ? colourOf(well.value) - 255 + alpha.valueAsNumber : part.last;
      part.folded.open = part.on === checked ? part.folded.open : checked;
      part.on = checked;
    }
  });

  /** Of texts. @type {import('./lettering.js').Lettering | undefined} */
  let lettering;
  let asked = false;
  const letters = async () => {
    asked ||= engine.ask('editor_texts') !== '[]';
    if (asked && !lettering) {
      const { Lettering } = await want(import('./lettering.js'));
      lettering ??= new Lettering(panel);
      sheet.prepend(lettering.box);
    }
    lettering?.show();
  };

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
      void letters();
      for (const { name, on, folded } of parts) {
        folded.open = on || mixed.includes(name);
      }
    },
  };
}
