// Naming and duplicating drawings that the browser keeps, and saving the open one as another file. Fetched when first asked for.

import { newId } from './keep.js';
import { keyOf } from './drawings.js';
import { isNative } from '../engine/reading.js';
import { want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {{ id: string, name: string, place: string }} One a drawing that is kept */
/** @typedef {{ drawings: import('./drawings.js').Drawings, engine: import('../engine/engine.js').Engine, files: import('./files.js').Files,
 * keeper: import('./keep.js').Keeper, notices: import('../page/notice.js').Notices, tabs: import('./tabs.js').Tabs, wake: () => void }} Shell */

const END = /(\.[a-z]{2,6})?$/i;
const TYPES = [
  { description: 'SVG', accept: { 'image/svg+xml': ['.svg'] } },
  { description: 'Batten', accept: { 'application/json': ['.batten'] } }];
const LONGEST = 200; // letters of a name

/** A name of a copy that no other has. @param {string} name @param {string[]} taken */
function nameOfCopy(name, taken) {
  const [end] = END.exec(name) ?? [''];
  const stem = word('shell.copy-of', name.slice(0, name.length - end.length));
  let found = `${stem}${end}`;
  for (let number = 2; taken.includes(found); number++) {
    found = `${stem} ${number}${end}`;
  }
  return found;
}

/** What can be a name of it. @param {string} text '' if nothing can */
export const nameFrom = (text) => text.replace(/\s+/g, ' ').trim().slice(0, LONGEST);

/** Whether it has a name of its own, not that of a file. @param {Shell} shell @param {One & { broken: boolean }} one */
export const isNamed = ({ files, keeper }, { id, place, broken }) => !place && !broken && !(id === keeper.id && files.bound);

/**
 * Gives a kept drawing another name. @param {Shell} shell @param {One} one @param {string} name
 * @returns {Promise<boolean>} whether it has it now
 */
export async function rename({ files, keeper, notices, tabs, wake }, one, name) {
  try {
    if (await tabs.isElsewhere(keyOf(one.id, one.place))) {
      notices.say(word('shell.kept-not.help', one.name));
      return false;
    }
    await keeper.ask('rename', one.id, name);
    if (one.id === keeper.id) {
      files.name = name;
      wake();
    }
    return true;
  } catch (error) {
    console.warn(error);
    notices.say(word('shell.kept-unnamed.help', one.name));
    return false;
  }
}

/**
 * Makes a copy of a drawing. @param {Shell} shell @param {One} [one] that is kept; else the one that is open
 * @returns {Promise<One | null>} null: the user was told why there is none
 */
export async function duplicate({ drawings, engine, files, keeper, notices }, one = { id: keeper.id, name: files.name, place: '' }) {
  try {
    drawings.keepNow();
    await keeper.settled();
    const taken = (await keeper.list()).map(({ name }) => name);
    const copy = { id: newId(), name: nameOfCopy(one.name, taken), place: '' };
    await keeper.ask('copy', copy, one.id === keeper.id ? engine.journal.slice() : one.id);
    return copy;
  } catch (error) {
    console.warn(error);
    notices.say(word('shell.kept-uncopied.help', one.name));
    return null;
  }
}

/** Duplicates the open drawing and opens the copy. @param {Shell} shell */
export async function duplicateOpen(shell) {
  const { drawings, files: { name }, keeper, notices } = shell;
  const copy = await duplicate(shell);
  if (copy) {
    await drawings.openKept({ ...copy, time: 0, aside: false, gone: false, broken: false }, copy.name);
    if (keeper.id === copy.id) {
      notices.say(word('shell.duplicated.help', name));
    }
  }
}

/** Asks for a name. @param {string} name that is offered @returns {Promise<string>} '' when dismissed */
async function askName(name) {
  const { answer, question } = await want(import('../sheets/question.js'));
  const field = document.createElement('input');
  Object.assign(field, { className: 'search', value: name, maxLength: LONGEST, ariaLabel: word('shell.file-name') });
  field.size = 32;
  field.style.setProperty('margin-top', 'var(--space-2)');
  const asked = question('save-as', word('command.save-as'), [field], [answer('save', word('command.save')), answer('', word('command.cancel'))]);
  field.focus();
  field.setSelectionRange(0, name.length - (END.exec(name)?.[0].length ?? 0));
  return await asked === 'save' ? nameFrom(field.value) : '';
}

/** As a download, named by the user. @param {Shell} shell */
async function downloadAs({ engine, files }) {
  const name = await askName(files.name);
  if (name) {
    const native = isNative(name);
    files.deliver(engine.save(native), native ? 'batten' : 'svg', native ? 'application/json' : 'image/svg+xml', name);
  }
}

/**
 * Saves the open drawing as a file that the user chooses, and goes on with that. What was kept of it until now stays. Where the
 * browser lets no page write files it is a download.
 * @param {Shell} shell
 */
export async function saveAs(shell) {
  const { drawings, engine, files, keeper } = shell;
  const picker = /** @type {any} */ (window).showSaveFilePicker;
  try {
    if (!picker) {
      await downloadAs(shell);
      return;
    }
    const name = isNative(files.name) ? files.name : files.name.replace(END, '.svg');
    const handle = await picker.call(window, { suggestedName: name, types: isNative(name) ? [...TYPES].reverse() : TYPES });
    const { Disk } = await want(import('./disk.js'));
    const disk = new Disk(handle, await handle.getFile());
    drawings.keepNow();
    await keeper.settled();
    keeper.begin(engine.drawing);
    drawings.away = '';
    files.bind(disk);
    files.name = handle.name;
    await drawings.settle();
    files.saveNow(disk.tag);
    const { remember } = await want(import('./recent.js'));
    await remember(handle);
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'AbortError')) { // else nothing was chosen
      files.complain(error);
    }
  }
}
