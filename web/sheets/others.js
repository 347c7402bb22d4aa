// What the sheet of commands finds beside commands: settings, formats of an export, and what the page itself does.

import { want } from '../page/build.js';
import { FORMATS } from './formats.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('./commands.js').Other} Other */

const OBJECTS = 500; // that are looked through
const OF_LEVELS = 'levels'; // shown in the level strip alone

/** @param {Shell} shell @returns {Other[]} */
function settings({ panel }) {
  const commands = new Set(panel.tables.commands.map((row) => row.name));
  return panel.tables.properties.filter(({ name, group }) => group !== OF_LEVELS && !commands.has(name)).map(({ name, label, subject }) =>
    ({ name: `setting-${name}`, label, of: word(subject), words: word(`property.${name}.words`), help: word(`property.${name}.help`), run: () => void panel.ask(name) }));
}

/** @param {Shell} shell @returns {Other[]} */
function formats(shell) {
  return FORMATS.map(({ name, of }) => ({ name: `export-${of}`, label: name || word('shell.plain'), of: word('command.export'), words: word(`format.${of}.words`),
    help: '', run: async () => (await want(import('../export/sheet.js'))).exportDrawing(shell, of) }));
}

/** Begins a new drawing; the gallery has a picture of the one that is left. @param {Shell} shell */
async function fresh(shell) {
  await import('../gallery/pictured.js').then(({ pictureOpen }) => pictureOpen(shell)).catch(() => {}); // a picture fewer
  await shell.drawings.openNew();
}

/** What the page itself does, by the names of its words. @param {Shell} shell @returns {Record<string, () => void>} */
export function actsOf(shell) {
  const { panel, theme } = shell;
  return {
    new: () => void fresh(shell),
    duplicate: async () => (await want(import('../keep/copies.js'))).duplicateOpen(shell),
    settings: () => document.getElementById('settings')?.showPopover(),
    theme: () => theme.toggle(),
    share: () => void want(import('../export/share.js')).then((part) => part.share(shell)),
    layers: () => void panel.dock.reveal('layers'),
    numbers: () => void panel.dock.reveal('numbers'),
    'start-car': async () => (await want(import('../page/sample.js'))).openCar(shell),
    ...document.querySelector('meta[name=batten-first]') ? { manual: () => void open('manual/', '_blank') } : {}, // on a site, which has it beside
  };
}

/** @param {Shell} shell @returns {Other[]} */
function page(shell) {
  return Object.entries(actsOf(shell)).map(([name, run]) => ({ name, label: word(`shell.${name}`), of: '', words: word(`shell.${name}.words`), help: '', run }));
}

/** What the drawing has, by the names given there. @param {Shell} shell @returns {Other[]} */
function objects({ engine, wake }) {
  /** @type {{ rows: import('./objects.js').Row[] }} */
  const { rows } = JSON.parse(engine.ask('editor_outline', 0, OBJECTS) || '{"rows":[]}');
  return rows.filter(({ name }) => name).map(({ id, name }) => ({ name: `object-${id}`, label: name, of: word('shell.object'), words: '', help: '', own: true, run: () => {
    engine.act('editor_select', id, 0);
    wake();
  } }));
}

/** @param {Shell} shell */
export const others = (shell) => [...page(shell), ...settings(shell), ...formats(shell), ...objects(shell)];
