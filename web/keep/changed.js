// A file that another program has changed since it was opened: nothing is overwritten until the user says so. Fetched when
// that happens.

import { want } from '../page/build.js';
import { isNative } from '../engine/reading.js';
import { word } from '../page/words.js';

/** @typedef {import('./files.js').Files} Files */

const SVG = 'image/svg+xml';
const JSON_TYPE = 'application/json';

/**
 * @param {Files} files
 * @param {string} text
 * @param {boolean} [apart] no file can be written beside it: offer a download instead
 */
export function tellChanged(files, text, apart = false) {
  files.notices.ask('changed', text, [
    { label: word('shell.look-both'), run: () => void compareBoth(files, text) },
    { label: word('shell.overwrite'), run: () => void overwrite(files) },
    apart ? { label: word('shell.copy'), run: () => {
      void files.download();
      tellChanged(files, text); // still changed
    } } : { label: word('shell.beside'), run: () => void saveBeside(files) }]);
}

/** Saves a new file beside the changed one, which stays as it is; the drawing still belongs to the changed file. @param {Files} files */
async function saveBeside(files) {
  const native = isNative(files.name);
  try {
    const name = await files.place.saveBeside(files.engine.save(native), native ? JSON_TYPE : SVG);
    tellChanged(files, word('shell.saved-beside', name));
  } catch (error) {
    tellChanged(files, error instanceof Error ? error.message : String(error), true);
  }
}

/** @param {Files} files */
async function overwrite(files) {
  try {
    files.saveNow((await files.place.look()).tag);
  } catch (error) {
    files.complain(error);
  }
}

/** Shows the drawing and the file beside each other. @param {Files} files @param {string} text */
async function compareBoth(files, text) {
  try {
    const { compare } = await want(import('../sheets/compare.js'));
    const file = await files.place.look();
    const answer = await compare(files.engine, file);
    if (answer === 'overwrite') {
      files.saveNow(file.tag); // overwrites the version that was compared, nothing newer
    } else if (answer === 'beside') {
      await saveBeside(files);
    } else {
      tellChanged(files, text);
    }
  } catch (error) {
    files.complain(error);
  }
}
