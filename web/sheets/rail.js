// The rail of tools: slots with one tool each, or with several of a kind, of which the one used last is seen. The others are
// in the slot's flyout (flyout.js). The sprite says which tools, in which order: data-group and data-slot.

import { groupOf } from './bar.js';

const GROUPS = ['select', 'draw', 'shape', 'view']; // from the top
const DOCK = matchMedia('(max-width: 700px)'); // below the drawing, as room.css has it

export class Rail {
  /** @param {import('../engine/types.js').Tables} tables @param {import('./buttons.js').Buttons} buttons */
  constructor(tables, buttons) {
    this.shown = -1;
    const box = /** @type {HTMLElement} */ (document.getElementById('rail'));
    const turn = () => box.setAttribute('aria-orientation', DOCK.matches ? 'horizontal' : 'vertical');
    DOCK.addEventListener('change', turn);
    turn();
    const groups = new Map(GROUPS.map((name) => [name, groupOf(box, `rail-${name}`)]));
    /** The tools of each slot. @type {Map<string, HTMLButtonElement[]>} */
    this.slots = new Map();
    /** The button of each tool; the others are brief: chosen elsewhere. @type {(HTMLButtonElement | undefined)[]} */
    this.tools = [];
    for (const { id, dataset } of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('symbol[id^=icon-tool-]'))) {
      const command = id.slice('icon-'.length);
      const number = tables.tools.findIndex((tool) => tool.command === command);
      const button = buttons.command(command, `tool.${tables.tools[number].name}`);
      this.tools[number] = button;
      groups.get(dataset.group ?? '')?.append(button);
      this.#put(button, dataset.slot);
    }
  }

  /** @param {HTMLButtonElement} button @param {string | undefined} slot */
  #put(button, slot) {
    if (slot) {
      const beside = this.slots.get(slot) ?? [];
      this.slots.set(slot, [...beside, button]);
      button.dataset.slot = slot;
      button.hidden = beside.length > 0;
      button.setAttribute('aria-haspopup', 'menu');
      button.setAttribute('aria-expanded', 'false');
    }
  }

  /** The tool in hand is pressed, and seen in its slot. @param {number} tool */
  show(tool) {
    if (tool === this.shown) {
      return;
    }
    this.shown = tool;
    this.tools.forEach((button, number) => button?.setAttribute('aria-pressed', String(number === tool)));
    const now = this.tools[tool];
    const slot = this.slots.get(now?.dataset.slot ?? '') ?? [];
    const focused = slot.some((button) => button === document.activeElement);
    slot.forEach((button) => { button.hidden = button !== now; });
    if (focused) {
      now?.focus();
    }
  }
}
