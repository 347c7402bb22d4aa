// Where journals are stored in the browser's private file system: keep.js reads them, keeping.js writes them.

/** The folder of all drawings' folders. */
export async function journals() {
  return (await navigator.storage.getDirectory()).getDirectoryHandle('journals', { create: true });
}

/** The name of a drawing's folder, valid in a file system whatever the drawing is called. @param {string} name */
export async function folderOf(name) {
  const digest = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(name));
  return Array.from(new Uint8Array(digest, 0, 16), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
