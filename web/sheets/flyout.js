// The flyout of a slot of the rail: the tools that share it. It opens by a second press, by a press that is held, with which one
// goes on to a tool and lets go, by the other button, and by the arrow key that points to it. Fetched after the page is painted.

import { icon } from '../page/icons.js';
import { tell } from '../page/words.js';
import { Menu } from './menu.js';

const HOLD = 400; // milliseconds that a press is held
const AWAY = 6; // pixels from the slot

export class Flyout {
  /** @param {import('../main.js').Shell} shell @param {import('./rail.js').Rail} rail */
  constructor(shell, rail) {
    this.shell = shell;
    this.rail = rail;
    /** Made when the first is opened. @type {Menu | undefined} */
    this.menu = undefined;
    this.timer = 0;
    /** Whether the last press was held until it opened, and whether it still is. */
    this.held = false;
    this.down = false;
    const box = /** @type {HTMLElement} */ (document.getElementById('rail'));
    box.addEventListener('pointerdown', (event) => this.#down(event));
    box.addEventListener('click', (event) => this.#click(event), true);
    box.addEventListener('keydown', (event) => this.#key(event), true);
    box.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      this.#open(slotOf(event));
    });
    addEventListener('pointermove', (event) => this.held && this.down && itemAt(event)?.focus());
    for (const end of ['pointerup', 'pointercancel']) {
      addEventListener(end, (event) => this.#up(/** @type {PointerEvent} */ (event)));
    }
  }

  /** @param {HTMLButtonElement | null} slot */
  async #open(slot) {
    clearTimeout(this.timer);
    if (!slot || this.#isOpen(slot)) {
      return;
    }
    if (!this.menu) {
      this.menu = new Menu(this.shell, 'flyout', 'shell.tools');
      await Menu.dressed();
    }
    const { menu } = this;
    menu.hide();
    menu.opener = slot;
    const tools = this.rail.slots.get(slot.dataset.slot ?? '') ?? [];
    menu.open([tools.map(({ dataset }) => dataset.name ?? '')], 0, 0);
    for (const button of tools) {
      const item = /** @type {HTMLElement} */ (menu.box.querySelector(`[data-command=${button.dataset.name}]`));
      item.setAttribute('role', 'menuitemradio');
      item.setAttribute('aria-checked', String(button.ariaPressed === 'true'));
      tell(/** @type {HTMLElement} */ (item.firstElementChild), { text: button.dataset.label ?? '' });
      item.prepend(/** @type {Node} */ (icon(button.dataset.name ?? '')));
      if (button === slot) {
        item.focus();
      }
    }
    this.#place(menu, slot);
  }

  /** @param {HTMLElement} slot */
  #isOpen(slot) {
    return this.menu?.opener === slot && this.menu.isOpen;
  }

  /** Beside the rail, or above it where it lies below the drawing. @param {Menu} menu @param {HTMLElement} slot */
  #place(menu, slot) {
    const on = slot.getBoundingClientRect();
    const { width, height } = menu.box.getBoundingClientRect();
    if (isDock()) {
      menu.place(on.left, on.top - AWAY - height);
    } else {
      menu.place(on.left < innerWidth / 2 ? on.right + AWAY : on.left - AWAY - width, on.top);
    }
  }

  /** @param {PointerEvent} event */
  #down(event) {
    const slot = event.button === 0 ? slotOf(event) : null;
    this.held = false;
    this.down = slot !== null;
    clearTimeout(this.timer);
    this.timer = slot ? setTimeout(() => {
      this.held = true;
      void this.#open(slot);
    }, HOLD) : 0;
  }

  /** @param {PointerEvent} event */
  #up(event) {
    clearTimeout(this.timer);
    if (this.held && this.down) {
      itemAt(event)?.click();
    }
    this.down = false;
  }

  /** The second press opens it; the click at the end of a press that was held does nothing. @param {MouseEvent} event */
  #click(event) {
    const slot = slotOf(event);
    const ended = this.held && event.detail > 0;
    if (slot && (ended || slot.ariaPressed === 'true')) {
      event.stopPropagation();
      if (!ended && this.#isOpen(slot)) {
        this.menu?.hide();
      } else if (!ended) {
        void this.#open(slot);
      }
    }
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const slot = slotOf(event);
    const there = isDock() ? 'ArrowUp' : slot && slot.getBoundingClientRect().left < innerWidth / 2 ? 'ArrowRight' : 'ArrowLeft';
    if (slot && event.key === there && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      event.stopPropagation();
      void this.#open(slot);
    }
  }
}

/** Whether the rail lies below the drawing. */
const isDock = () => document.getElementById('rail')?.ariaOrientation === 'horizontal';

/** The slot with several tools in which something happens. @param {Event} event @returns {HTMLButtonElement | null} */
const slotOf = ({ target }) => /** @type {Element} */ (target).closest('[data-slot]');

/** The tool under a pointer. @param {PointerEvent} event @returns {HTMLElement | null | undefined} */
const itemAt = ({ clientX, clientY }) => document.elementFromPoint(clientX, clientY)?.closest('#flyout button');
