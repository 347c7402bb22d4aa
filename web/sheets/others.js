// What the sheet of commands finds beside commands: settings, formats of an export, and what the page itself does.

import { want } from '../page/build.js';
import { FORMATS } from './formats.js';
import * as keywords from './keywords.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('./commands.js').Other} Other */

const OF_LEVELS = 'levels'; // shown in the level strip alone

/** @param {Shell} shell @returns {Other[]} */
function settings({ panel }) {
  const commands = new Set(panel.tables.commands.map((row) => row.name));
  return panel.tables.properties.filter(({ name, group }) => group !== OF_LEVELS && !commands.has(name)).map(({ name, label, subject }) =>
    ({ name: `setting-${name}`, label, of: word(subject), words: keywords.SETTINGS[name] ?? '', help: word(`property.${name}.help`), run: () => void panel.ask(name) }));
}

/** @param {Shell} shell @returns {Other[]} */
function formats(shell) {
  return FORMATS.map(({ name, of }) => ({ name: `export-${of}`, label: name || word('shell.plain'), of: word('command.export'), words: keywords.FORMATS[of] ?? '',
    help: '', run: async () => (await want(import('./export.js'))).exportDrawing(shell, of) }));
}

/** @param {Shell} shell @returns {Other[]} */
function page({ drawings, panel, theme }) {
  /** @type {[string, string, () => void][]} */
  const all = [
    ['new', 'shell.new', () => void drawings.openNew()],
    ['settings', 'shell.settings', () => document.getElementById('settings')?.showPopover()],
    ['theme', 'shell.theme', () => theme.toggle()],
    ['layers', 'shell.layers', () => void panel.dock.reveal('layers')],
    ['position', 'shell.numbers', () => void panel.dock.reveal('numbers')],
  ];
  return all.map(([name, key, run]) => ({ name, label: word(key), of: '', words: keywords.PAGE[name], help: '', run }));
}

/** @param {Shell} shell */
export const others = (shell) => [...page(shell), ...settings(shell), ...formats(shell)];
