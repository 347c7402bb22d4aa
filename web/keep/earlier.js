// Drawings as earlier versions kept them, a folder of numbered journals each: taken over into the room, and removed only when
// they have been read back there. Fetched when there are any.

/** @typedef {import('./store.js').Store} Store */

const HEAD = 4096; // the name of a drawing is within the first 4,096 bytes of its journal

/** The newest complete journal of a folder, up to its last complete line. @param {FileSystemDirectoryHandle} folder */
async function newest(folder) {
  const numbers = [];
  for await (const name of folder.keys()) {
    numbers.push(Number(name));
  }
  for (const number of numbers.sort((a, b) => b - a)) {
    const file = await (await folder.getFileHandle(String(number))).getFile();
    const bytes = new Uint8Array(await file.arrayBuffer());
    if (bytes[0]) { // written last
      return bytes.subarray(0, bytes.lastIndexOf(10) + 1);
    }
  }
  return null;
}

/** @param {Uint8Array} journal */
function nameIn(journal) {
  const head = /"name":("(?:[^"\\]|\\.)*")/.exec(new TextDecoder().decode(journal.subarray(0, HEAD)));
  try {
    return head ? String(JSON.parse(head[1])) : '';
  } catch {
    return head?.[1].slice(1, -1) ?? '';
  }
}

/**
 * Takes over what is there. A folder that cannot be read now, or that another page holds, is left for another time.
 * @param {Store} store @param {FileSystemDirectoryHandle} all the folders
 */
export async function takeOver(store, all) {
  for await (const [key, folder] of /** @type {any} */ (all)) {
    try {
      const journal = await newest(folder);
      if (journal) {
        await store.begin({ id: key, name: nameIn(journal) || key, place: '' }, journal);
        await store.release();
        await all.removeEntry(key, { recursive: true });
      }
    } catch {
      await store.release().catch(() => {});
    }
  }
}
