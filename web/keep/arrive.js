// Files that were chosen or dropped: one drawing is opened, several are added; pictures are placed, palettes are kept. An edited drawing is
// replaced only after the user has seen what the file holds. Fetched when files come.

import { remember } from './recent.js';
import { want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('./files.js').Files} Files */
/** @typedef {import('./files.js').Arrival} Arrival */
/** @typedef {import('../sheets/holds.js').Content} Content */

/** @param {Files} files @param {Arrival[]} all */
export async function arrive(files, all) {
  const pictures = all.filter(({ file }) => /^image\/(?!svg)/.test(file.type));
  const palettes = all.filter(({ file }) => /\.gpl$/i.test(file.name));
  const drawings = all.filter((one) => !pictures.includes(one) && !palettes.includes(one));
  for (const { file } of palettes) {
    await takePalette(files, file);
  }
  for (const { file } of pictures) {
    await files.addPicture(file);
  }
  if (drawings.length === 1) {
    await openOne(files, drawings[0]);
  } else if (drawings.length) {
    await addTo(files, drawings);
  }
}

/** @param {Files} files @param {File} file */
async function takePalette(files, file) {
  const { addPalette } = await want(import('./gpl.js'));
  try {
    files.notices.say(word('shell.palette-added', (await addPalette(file)).slice(-1)[0].name));
  } catch (error) {
    files.complain(error);
  }
}

/** @param {Files} files @param {Arrival[]} drawings */
async function addTo(files, drawings) {
  const { addAll } = await want(import('./several.js'));
  await addAll(files, drawings.map(({ file }) => file));
}

/** @param {Files} files @param {Arrival} arrival */
async function openOne(files, arrival) {
  const { file, place } = arrival;
  let read = await files.read(file, file.name, files.edited);
  if (read && files.edited && !read.content) { // something was drawn while it was read
    read = await files.read(file, file.name, true);
  }
  const answer = read?.content ? await ask(files, read.content, file.name) : 'open';
  if (answer === 'add') {
    await addTo(files, [arrival]);
  }
  if (!read || answer !== 'open') {
    return;
  }
  if (!files.take(read, file.name)) {
    return;
  }
  files.bind(place);
  const listed = place && !files.server.passing ? remember(place.handle) : null; // begun at once: the page may be left any moment
  await files.onopen();
  await listed;
}

/** Shows what the file holds, beside what is open. @param {Files} files @param {Content} content @param {string} name */
async function ask(files, content, name) {
  const { askToOpen } = await want(import('../sheets/holds.js'));
  return askToOpen(files, name, content);
}
