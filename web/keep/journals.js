// Where journals lie in the browser's own file system: keep.js reads them, keeping.js writes them.

/** Where all folders are. */
export async function journals() {
  return (await navigator.storage.getDirectory()).getDirectoryHandle('journals', { create: true });
}

/** The name of a drawing's folder: any name becomes a file system's. @param {string} name */
export async function folderOf(name) {
  const digest = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(name));
  return Array.from(new Uint8Array(digest, 0, 16), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
