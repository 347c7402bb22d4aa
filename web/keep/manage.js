// What is done to kept drawings as wholes: naming one and copying one, whether it is open or not. Fetched when first asked for.

import { endOf, headOf, joined } from './records.js';
import { Store } from './store.js';

/** @typedef {import('./records.js').Head} Head */

/**
 * Names a drawing. Its file stays as it is: the name is written beside it, with the generation that had another, and counts
 * until a later one is begun. Half written it is none.
 * @param {Store} store @param {string} id @param {string} name
 */
export async function rename({ room }, id, name) {
  const generations = (await room.names()).filter((file) => /^[^.]*\.\d+$/.test(file) && file.startsWith(`${id}.`)).map((file) => Number(file.split('.')[1]));
  if (generations.length === 0) {
    throw new Error('there is no such drawing');
  }
  const access = await room.open(`${id}.name`);
  try {
    const bytes = joined([headOf({ id, name, place: String(Math.max(...generations)) }), endOf(1)]);
    const written = await access.write(bytes, 0);
    await access.flush();
    if (written !== bytes.length) {
      throw new Error('there is no room');
    }
  } finally {
    await access.close();
  }
}

/**
 * Keeps a copy as a drawing of its own. Throws when not all of it can be read, and leaves nothing then.
 * @param {Store} store @param {Head} head the copy's @param {string | Uint8Array} from the id of one that is kept, or a journal
 */
export async function copy({ room, now }, head, from) {
  const other = new Store(room, now); // the file that is being written stays open
  const found = typeof from === 'string' ? await other.take(from) : { journal: from, whole: true };
  if (!found?.whole || found.journal.length === 0) {
    throw new Error('not all of it can be read');
  }
  await other.begin(head, found.journal);
  await other.release();
}
