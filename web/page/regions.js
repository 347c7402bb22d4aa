// Keyboard navigation of the page: from region to region, and with the arrow keys within a toolbar, which is a single
// tab stop. Fetched once the page has loaded.

/** In page order. */
const REGIONS = ['#tools', '#rail', '#stage', '#mirror', '#actions', '#inspector', '.foot', '.sheet:popover-open', '#asked', '#pending', '.chips'];
const STOPS = 'button, input, select, textarea, [tabindex]';

/** @param {Element} element */
const usable = (element) => element.checkVisibility() && !element.matches(':disabled');

/** The element of a region that receives the focus. @param {string} region @returns {HTMLElement | undefined} */
function stop(region) {
  const root = /** @type {HTMLElement | null} */ (document.querySelector(region));
  if (!root || (region !== '#mirror' && !root.checkVisibility())) {
    return undefined;
  }
  const all = /** @type {HTMLElement[]} */ (root.tabIndex === 0 ? [root] : [...root.querySelectorAll(STOPS)]);
  return all.find((element) => element.tabIndex === 0 && (region === '#mirror' || usable(element)));
}

/** Moves the focus to the next region. @param {number} step 1 or -1 */
export function walk(step) {
  const there = REGIONS.filter(stop);
  const now = there.findIndex((region) => document.querySelector(region)?.contains(document.activeElement));
  const start = now < 0 && step < 0 ? 0 : now;
  const next = there[(start + step + there.length) % there.length];
  stop(next)?.focus();
}

/** Makes a toolbar a single tab stop, with arrow keys inside. @param {HTMLElement} bar */
export function rove(bar) {
  const buttons = () => [...bar.querySelectorAll('button')].filter(usable);
  const settle = () => {
    const there = buttons();
    const now = there.find((button) => button === document.activeElement) ??
      there.find((button) => bar.id === 'rail' && button.ariaPressed === 'true') ??
      there.find((button) => button.tabIndex === 0 && bar.dataset.roving) ?? there[0];
    bar.dataset.roving = 'yes';
    for (const button of bar.querySelectorAll('button')) {
      const index = button === now ? 0 : -1;
      if (button.tabIndex !== index) {
        button.tabIndex = index;
      }
    }
  };
  bar.addEventListener('focusin', settle);
  bar.addEventListener('keydown', (event) => {
    const there = buttons();
    const at = there.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
    const back = getComputedStyle(bar).direction === 'rtl' ? 'ArrowRight' : 'ArrowLeft';
    const step = event.key === 'ArrowUp' || event.key === back ? -1 : 1;
    const next = event.key === 'Home' ? 0 : event.key === 'End' ? there.length - 1 :
      event.key.startsWith('Arrow') ? (at + step + there.length) % there.length : -1;
    if (next < 0 || at < 0 || event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    there[next].focus();
    event.preventDefault();
    event.stopPropagation();
  });
  // Buttons appear, disappear and become disabled.
  new MutationObserver(settle).observe(bar, { subtree: true, childList: true, attributeFilter: ['disabled', 'hidden', 'aria-pressed'] });
  settle();
}

for (const bar of document.querySelectorAll('[role=toolbar]')) {
  rove(/** @type {HTMLElement} */ (bar));
}
