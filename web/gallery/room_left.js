// How much of the disk the browser uses for what is kept and has left, and whether it may clear it away.

import { made } from '../page/elements.js';
import { word } from '../page/words.js';

const UNITS = ['kilobyte', 'megabyte', 'gigabyte', 'terabyte'];
const STEP = 1000;

/** @param {number} bytes */
function sizeOf(bytes) {
  let [value, at] = [bytes / STEP, 0];
  for (; value >= STEP && at < UNITS.length - 1; at++) {
    value /= STEP;
  }
  return new Intl.NumberFormat(document.documentElement.lang, { style: 'unit', unit: UNITS[at], maximumFractionDigits: value < 10 ? 1 : 0 }).format(value);
}

/** Says it there; nothing where the browser does not tell. @param {HTMLElement} place */
export async function roomLeft(place) {
  const { usage, quota } = await navigator.storage?.estimate?.().catch(() => null) ?? {};
  const lasting = await navigator.storage?.persisted?.().catch(() => true) ?? true;
  const used = usage !== undefined && quota ? word('shell.kept-room.help', sizeOf(usage)).replace('%', sizeOf(Math.max(0, quota - usage))) : '';
  place.replaceChildren(...[used, lasting ? '' : word('shell.not-lasting')].filter(Boolean).flatMap((text) => [made('span', '', text), ' ']));
}
