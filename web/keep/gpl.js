// Palettes: GIMP's .gpl files, and those that this browser keeps.

import { keep, kept } from '../page/kept.js';
import { Refusal, word } from '../page/words.js';

/** @typedef {{ name: string, colours: { colour: number, name: string }[] }} Palette colours: 0xRRGGBBAA, opaque */

const STORE = 'batten-palettes';
export const GPL = 'application/x-gimp-palette';
const MOST = 4096; // colours of a palette

/** @param {string} text of a .gpl file @param {string} name that it has if it says none @returns {Palette} */
export function readPalette(text, name) {
  const [head, ...lines] = text.replace(/^\ufeff/, '').split(/\r\n?|\n/);
  /** @type {Palette} */
  const palette = { name, colours: [] };
  for (const line of lines) {
    const entry = /^\s*(\d{1,3})\s+(\d{1,3})\s+(\d{1,3})(?:\s+(.*?))?\s*$/.exec(line);
    const channels = entry?.slice(1, 4).map(Number) ?? [];
    const said = /^Name:\s*(.*?)\s*$/.exec(line)?.[1];
    if (entry && channels.every((value) => value < 256)) {
      palette.colours.push({ colour: channels.reduce((sum, value) => sum * 256 + value, 0) * 256 + 255, name: entry[4] ?? '' });
    } else if (said) {
      palette.name = said;
    }
  }
  if (head.trim() !== 'GIMP Palette' || !palette.colours.length || palette.colours.length > MOST) {
    throw new Refusal(word('shell.palette-none.help', name));
  }
  return palette;
}

/** @param {Palette} palette @returns {string} a .gpl file, which has no opacity */
export function writePalette({ name, colours }) {
  const rows = colours.map((one) => `${[24, 16, 8].map((shift) => String((one.colour >>> shift) & 255).padStart(3)).join(' ')}\t${one.name || 'Untitled'}`);
  return ['GIMP Palette', `Name: ${name.replace(/\s+/g, ' ')}`, 'Columns: 0', '#', ...rows, ''].join('\n');
}

/** As they were last kept by this page, in case the browser keeps nothing. @type {Palette[] | undefined} */
let held;

/** @returns {Palette[]} those that this browser keeps */
export function palettes() {
  if (held) {
    return held;
  }
  try {
    const all = JSON.parse(kept(STORE) || '[]');
    return all.filter((/** @type {any} */ one) => typeof one?.name === 'string' && Array.isArray(one.colours));
  } catch {
    return []; // corrupt
  }
}

/** @param {Palette[]} all */
export function keepPalettes(all) {
  held = all;
  keep(STORE, JSON.stringify(all));
}

/** Adds a .gpl file to those that are kept, in place of one of that name; throws why not. @param {File} file @returns {Promise<Palette[]>} all, it is the last */
export async function addPalette(file) {
  const palette = readPalette(await file.text(), file.name.replace(/\.gpl$/i, ''));
  const all = [...palettes().filter(({ name }) => name !== palette.name), palette];
  keepPalettes(all);
  return all;
}
