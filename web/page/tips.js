// The name of a button with its key, beside it, as soon as it is pointed at, or reached by a key. The browser's own
// explanation comes later and says more: it stays away while this is shown. Fetched at the first sign of a user.

import { dress } from './build.js';
import { keyOf } from './words.js';

const SOON = 150; // milliseconds
const WHERE = ':is(.bar, .rail, .actions) button';
const AWAY = 6; // pixels from the button
const EDGE = 4; // from the window

class Tips {
  constructor() {
    this.timer = 0;
    /** @type {HTMLElement | null} */
    this.at = null;
    this.box = document.createElement('div');
    this.box.className = 'tip';
    this.box.popover = 'manual';
    this.box.setAttribute('aria-hidden', 'true'); // the buttons have these names
    this.name = document.createElement('span');
    this.key = document.createElement('kbd');
    this.box.append(this.name, this.key);
    document.body.append(this.box);
    addEventListener('pointerover', ({ target, pointerType }) =>
      pointerType !== 'touch' && this.#soon(/** @type {Element} */ (target).closest?.(WHERE)));
    addEventListener('focusin', ({ target }) =>
      this.#soon(document.documentElement.dataset.ring ? /** @type {Element} */ (target).closest(WHERE) : null));
    for (const event of ['pointerdown', 'keydown', 'blur', 'wheel']) {
      addEventListener(event, () => this.#soon(null), { capture: true, passive: true });
    }
    document.documentElement.addEventListener('pointerleave', () => this.#soon(null));
    new MutationObserver(() => this.#soon(null)).observe(document.documentElement, { attributeFilter: ['lang'] });
    if (matchMedia('(hover: hover)').matches) {
      this.#soon(document.querySelector(`${WHERE}:hover`)); // what has been pointed at meanwhile
    }
  }

  /** @param {Element | null | undefined} button */
  #soon(button) {
    if (button === this.at) {
      return;
    }
    clearTimeout(this.timer);
    if (this.at?.dataset.title !== undefined) {
      this.at.title ||= this.at.dataset.title;
      delete this.at.dataset.title;
    }
    this.box.hidePopover();
    this.name.textContent = ''; // in another language, perhaps, by the next time
    this.at = button instanceof HTMLElement ? button : null;
    if (this.at) {
      this.timer = setTimeout(() => this.#show(/** @type {HTMLElement} */ (button)), SOON);
    }
  }

  /** @param {HTMLElement} button */
  #show(button) {
    this.name.textContent = button.getAttribute('aria-label') ?? '';
    this.key.textContent = keyOf(button.dataset.shortcut ?? '');
    this.key.hidden = this.key.textContent === '';
    if (!this.name.textContent || !button.checkVisibility() || button.matches('[aria-haspopup][aria-expanded=true]')) {
      return;
    }
    button.dataset.title = button.title;
    button.title = '';
    this.box.showPopover();
    const on = button.getBoundingClientRect();
    const { width, height } = this.box.getBoundingClientRect();
    const middle = [(on.left + on.right - width) / 2, (on.top + on.bottom - height) / 2];
    const below = on.bottom + AWAY + height < innerHeight ? on.bottom + AWAY : on.top - AWAY - height;
    const beside = on.left < innerWidth / 2 ? on.right + AWAY : on.left - AWAY - width;
    const [left, top] = button.closest('[aria-orientation=vertical]') ? [beside, middle[1]] : [middle[0], below];
    const scale = /** @type {any} */ (this.box).currentCSSZoom ?? 1;
    this.box.style.setProperty('left', `${Math.max(EDGE, Math.min(left, innerWidth - width - EDGE)) / scale}px`);
    this.box.style.setProperty('top', `${top / scale}px`);
  }
}

export async function tips() {
  await dress('styles/tips.css');
  return new Tips();
}
