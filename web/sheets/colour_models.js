// A colour as the numbers that people give it: red, green, blue; hue, saturation, value; lightness, chroma, hue (OKLCH).

import { fromLab, toLab } from '../stage/theme.js';

/** Red, green, blue 0..1. @typedef {[number, number, number]} Rgb */
/** tops: of each number, from 0; digits: behind the point. @typedef {{ names: string[], tops: number[], digits: number[], from: (rgb: Rgb) => number[], to: (numbers: number[]) => Rgb }} Model */

const LAST = 1e-4; // of chroma that is nothing to see
const RIM = 1e-5; // by which rounding leaves the colours of a screen

/** @param {Rgb} rgb @returns {[number, number, number]} degrees, and 0..1 twice */
export function toHsv([red, green, blue]) {
  const value = Math.max(red, green, blue);
  const span = value - Math.min(red, green, blue);
  const sixth = span === 0 ? 0 : value === red ? ((green - blue) / span + 6) % 6 : value === green ? (blue - red) / span + 2 : (red - green) / span + 4;
  return [sixth * 60, value === 0 ? 0 : span / value, value];
}

/** @param {number[]} hsv @returns {Rgb} */
export function fromHsv([hue, saturation, value]) {
  const channel = (/** @type {number} */ shift) => {
    const at = (shift + hue / 60) % 6;
    return value - value * saturation * Math.max(0, Math.min(at, 4 - at, 1));
  };
  return [channel(5), channel(3), channel(1)];
}

/** @param {Rgb} rgb @returns {[number, number, number]} 0..1, chroma, degrees */
export function toLch(rgb) {
  const [light, a, b] = toLab(...rgb);
  const chroma = Math.hypot(a, b);
  return [light, chroma, chroma < LAST ? 0 : (Math.atan2(b, a) * 180 / Math.PI + 360) % 360];
}

/** With less chroma where no screen shows it. @param {number[]} lch @returns {Rgb} */
export function fromLch([light, chroma, hue]) {
  const turn = hue * Math.PI / 180;
  const at = (/** @type {number} */ c) => fromLab(light, c * Math.cos(turn), c * Math.sin(turn));
  const shown = (/** @type {Rgb} */ rgb) => rgb.every((value) => value > -RIM && value < 1 + RIM);
  let [low, high] = [0, chroma];
  if (shown(at(chroma))) {
    low = chroma;
  }
  while (high - low > LAST) {
    const middle = (low + high) / 2;
    [low, high] = shown(at(middle)) ? [middle, high] : [low, middle];
  }
  return /** @type {Rgb} */ (at(low).map((value) => Math.min(1, Math.max(0, value))));
}

/** @type {Record<string, Model>} */
export const MODELS = {
  hsv: { names: ['H', 'S', 'V'], tops: [360, 100, 100], digits: [0, 0, 0],
    from: (rgb) => toHsv(rgb).map((value, i) => value * (i ? 100 : 1)), to: ([h, s, v]) => fromHsv([h, s / 100, v / 100]) },
  oklch: { names: ['L', 'C', 'H'], tops: [100, 0.4, 360], digits: [1, 3, 1],
    from: (rgb) => toLch(rgb).map((value, i) => value * (i ? 1 : 100)), to: ([l, c, h]) => fromLch([l / 100, c, h]) },
  rgb: { names: ['R', 'G', 'B'], tops: [255, 255, 255], digits: [0, 0, 0],
    from: (rgb) => rgb.map((value) => value * 255), to: (numbers) => /** @type {Rgb} */ (numbers.map((value) => value / 255)) },
};

/** @param {number} colour 0xRRGGBBAA @returns {Rgb} */
export const rgbOf = (colour) => [(colour >>> 24) / 255, ((colour >>> 16) & 255) / 255, ((colour >>> 8) & 255) / 255];

/** @param {Rgb} rgb @param {number} alpha 0..255 @returns {number} 0xRRGGBBAA */
export const colourWith = (rgb, alpha) => rgb.reduce((sum, value) => sum * 256 + Math.round(value * 255), 0) * 256 + alpha;
