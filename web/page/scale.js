// The size of all that stands around the drawing, for screens on which the browser's own pixels are small. The page's own
// and kept in this browser, like the theme. The style sheets take it from --scale.

import { keep, kept } from './kept.js';

export const SCALES = [100, 125, 150, 175, 200]; // percent
const STORE = 'batten-scale';
const LEAST = 780; // pixels of width that are left: on a narrower window nothing is larger

/** What was chosen, in percent. */
export const scale = () => SCALES.find((one) => one === Number(kept(STORE))) ?? 100;

/** As much of it as the window has room for. */
function apply() {
  const room = Math.max(1, innerWidth / LEAST);
  document.documentElement.style.setProperty('--scale', String(Math.min(scale() / 100, room)));
}

/** @param {number} percent */
export function rescale(percent) {
  keep(STORE, String(percent));
  apply();
}

addEventListener('resize', apply);
apply();
