// Colours: of each role, and a drawing's own colours as they appear on paper that is dim. The colours of roles are tokens
// in styles/page.css.

import { Role, names } from '../engine/codes.js';
import { keep, kept } from '../page/kept.js';

/** Names of roles in the tokens, by the engine's numbers. */
const ROLES = names(Role).map((name) => name.replace('_', '-'));
const CHOICES = ['system', 'light', 'dark'];
const STORE = 'batten-theme';
const DIM = 'batten-dim-paper';

/** @param {number} value 0..1, sRGB */
const linear = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
/** @param {number} value 0..1, linear light */
const gamma = (value) => (value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055);

/**
 * sRGB to OKLab (Ottosson 2020): lightness 0..1, a and b. @param {number} red 0..1 @param {number} green @param {number} blue
 * @returns {[number, number, number]}
 */
export function toLab(red, green, blue) {
  const [r, g, b] = [linear(red), linear(green), linear(blue)];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s];
}

/** OKLab to sRGB, beyond 0..1 where no screen shows it. @param {number} light @param {number} a @param {number} b @returns {[number, number, number]} */
export function fromLab(light, a, b) {
  const l = (light + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (light - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (light - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    gamma(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    gamma(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    gamma(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/**
 * The colour with its lightness inverted and hue and chroma kept, so that black lines show on a dark ground and white
 * paper becomes dark. For display only: the document keeps its own colours.
 * @param {number} red 0..1
 * @param {number} green
 * @param {number} blue
 */
export function turnOver(red, green, blue) {
  const [light, a, b] = toLab(red, green, blue);
  // Spreads the dark end, so that ink is not grey.
  return fromLab(0.97 - 0.75 * Math.max(0, light) ** 1.4, a, b).map((value) => Math.min(1, Math.max(0, value)));
}

export class Theme {
  constructor() {
    /** @type {{ stroke: string, fill: string }[]} */
    this.roles = [];
    /** The ground beneath a drawing: without a page, and with one. */
    this.ground = '';
    this.paper = '';
    this.dark = false;
    /** Whether the paper is dark in the dark theme; otherwise it is white, on a pasteboard that is dark. */
    this.dim = kept(DIM) !== 'no';
    /** Whether the drawing's own colours are turned over. */
    this.turned = false;
    /** @type {Map<number, string>} */
    this.colours = new Map();
    /** Called when the colours have changed. */
    this.onchange = () => {};
    const stored = kept(STORE);
    this.choice = CHOICES.includes(stored) ? stored : 'system';
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#apply());
    matchMedia('(forced-colors: active)').addEventListener('change', () => this.#apply());
    this.#apply();
  }

  /** @param {string} choice system, light or dark */
  choose(choice) {
    this.choice = choice;
    keep(STORE, choice);
    this.#apply();
  }

  /** Switches between light and dark. */
  toggle() {
    this.choose(this.dark ? 'light' : 'dark');
  }

  /** @param {boolean} dim */
  dimPaper(dim) {
    this.dim = dim;
    keep(DIM, dim ? '' : 'no');
    this.#apply();
  }

  #apply() {
    const root = document.documentElement;
    root.dataset.paper = this.dim ? 'dim' : 'white';
    if (this.choice === 'system') {
      delete root.dataset.theme;
    } else {
      root.dataset.theme = this.choice;
    }
    this.dark = this.choice === 'dark' ||
      (this.choice === 'system' && matchMedia('(prefers-color-scheme: dark)').matches);
    this.turned = this.dark && this.dim;
    // A token holds both the light and the dark colour; an element that uses it gives the computed one.
    const probe = document.createElement('i');
    probe.style.forcedColorAdjust = 'none';
    document.getElementById('stage')?.append(probe);
    const token = (/** @type {string} */ name) => {
      probe.style.color = `var(--${name}, transparent)`;
      return getComputedStyle(probe).color;
    };
    this.roles = ROLES.map((role) => ({ stroke: token(`role-${role}`), fill: token(`role-${role}-fill`) }));
    this.ground = token('ground');
    this.paper = token('role-page-fill');
    probe.remove();
    this.colours.clear();
    this.onchange();
  }

  /** A colour of the drawing, as painted. @param {number} rgba 0xRRGGBBAA @returns {string} */
  colour(rgba) {
    let text = this.colours.get(rgba);
    if (text === undefined) {
      let channels = [(rgba >>> 24) / 255, ((rgba >>> 16) & 255) / 255, ((rgba >>> 8) & 255) / 255];
      if (this.turned) {
        channels = turnOver(channels[0], channels[1], channels[2]);
      }
      const [red, green, blue] = channels.map((value) => Math.round(value * 255));
      text = `rgb(${red} ${green} ${blue} / ${(rgba & 255) / 255})`;
      this.colours.set(rgba, text);
    }
    return text;
  }
}
