// Files that were chosen or dropped: one drawing is opened, several are added; pictures are placed. An edited drawing is
// replaced only after the user has seen what the file holds. Fetched when files come.

import { bytesOf } from './gzip.js';
import { remember } from './recent.js';
import { want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('./files.js').Files} Files */
/** @typedef {import('./files.js').Arrival} Arrival */

/** @param {Files} files @param {Arrival[]} all */
export async function arrive(files, all) {
  const pictures = all.filter(({ file }) => /^image\/(?!svg)/.test(file.type));
  const drawings = all.filter((one) => !pictures.includes(one));
  for (const { file } of pictures) {
    await files.addPicture(file);
  }
  if (drawings.length === 1) {
    await openOne(files, drawings[0]);
  } else if (drawings.length) {
    await addTo(files, drawings);
  }
}

/** @param {Files} files @param {Arrival[]} drawings */
async function addTo(files, drawings) {
  const { addAll } = await want(import('./several.js'));
  await addAll(files, drawings);
}

/** @param {Files} files @param {Arrival} arrival */
async function openOne(files, arrival) {
  const { file, place } = arrival;
  const bytes = await bytesOf(file).catch(() => null);
  if (!bytes) {
    files.notices.say(`${word('shell.not-opened', file.name)} ${word('shell.damaged')}`);
    return;
  }
  const answer = files.edited ? await ask(files, bytes, file.name) : 'open';
  if (answer === 'add') {
    await addTo(files, [arrival]);
  }
  if (answer !== 'open') {
    return;
  }
  if (!files.open(bytes, file.name)) {
    return;
  }
  files.bind(place);
  await files.onopen();
  if (place && !files.server.passing) {
    await remember(place.handle);
  }
}

/**
 * Shows what the file holds, beside what is open. @param {Files} files @param {Uint8Array} bytes @param {string} name
 * @returns {Promise<string>} 'open', 'add', or '' for neither
 */
async function ask(files, bytes, name) {
  const { askToOpen, holdsOf } = await want(import('../sheets/holds.js'));
  try {
    return await askToOpen(files, name, holdsOf(files.engine, bytes, name));
  } catch (error) {
    files.refuse(name, error);
    return '';
  }
}
