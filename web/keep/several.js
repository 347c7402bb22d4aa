// Drawings that are added to the one that is open, each as a group; nothing is replaced.

import { addTo, isQuick } from '../engine/reading.js';
import { want } from '../page/build.js';
import { word } from '../page/words.js';

const SMALL = 1 << 16; // bytes: a larger file is not looked at here

/** @param {import('./files.js').Files} files @param {Blob} file @param {string} name @returns {Promise<boolean>} false: cancelled */
async function add({ engine }, file, name) {
  const bytes = file.size <= SMALL ? new Uint8Array(await file.arrayBuffer()) : null;
  if (bytes && isQuick(bytes)) {
    addTo(engine, bytes, name, true);
    return true;
  }
  const { addApart } = await want(import('./apart.js'));
  return addApart(engine, file, name, true);
}

/** @param {import('./files.js').Files} files @param {File[]} drawings */
export async function addAll(files, drawings) {
  const failed = [];
  for (const file of drawings) {
    try {
      if (!await add(files, file, file.name)) {
        break;
      }
    } catch (error) {
      failed.push(`${word('shell.not-opened', file.name)} ${error instanceof Error ? error.message : ''}`);
    }
  }
  files.wake();
  if (failed.length) {
    files.notices.ask('unopened', failed.join(' '), []); // stays, unlike what is said of the pasted ones
  }
}
