// The drawing as the bytes of a file, and what to do where its own file cannot stay as it is.

import { want } from '../page/build.js';
import { Anew } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */

const LIGHT = 1 << 16; // bytes of a journal: what it makes is written at once, while the page waits

/**
 * Made at once if that takes no time, else while the page goes on.
 * @param {Engine} engine @param {boolean} native @param {boolean} [kept] as of Engine.save
 */
export async function written(engine, native, kept = false) {
  const { drawing } = engine;
  if (engine.journal.length > LIGHT) {
    try {
      const { writeApart } = await want(import('./apart.js'));
      return await writeApart(engine, native, kept);
    } catch (error) {
      if (error instanceof Anew || drawing !== engine.drawing) {
        throw error;
      }
      console.error(error); // no memory for a copy, or no worker
    }
  }
  return engine.save(native, kept);
}

/**
 * What a drawing's own file is to hold; null: that would have to be written anew, which the user does not want.
 * @param {import('./files.js').Files} files @param {boolean} native
 */
export async function overOwn(files, native) {
  try {
    return await written(files.engine, native, !files.anew);
  } catch (error) {
    if (!(error instanceof Anew)) {
      throw error;
    }
    const { askAnew } = await want(import('../sheets/losses.js'));
    const answer = await askAnew(files.name, files.engine.losses);
    if (answer === 'copy') {
      await files.download(false);
    }
    files.anew = answer === 'save';
    return files.anew ? written(files.engine, native) : null;
  }
}
