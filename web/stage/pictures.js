// Pictures to trace, as far as the browser deals with them: fetched when a drawing has the first one.

/** Kinds that the engine keeps as they are; what else the browser can show becomes a PNG. */
const KEPT = ['image/png', 'image/jpeg', 'image/webp'];

/** @param {File} file @returns {Promise<Uint8Array>} as it is when nothing else can be done: the engine then says no */
export async function bytesOf(file) {
  /** @type {Blob} */
  let blob = file;
  if (!KEPT.includes(file.type)) {
    try {
      const bitmap = await createImageBitmap(file);
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
      blob = await canvas.convertToBlob();
    } catch {
      // No picture for the browser either.
    }
  }
  return new Uint8Array(await blob.arrayBuffer());
}

/** @param {Uint8Array<ArrayBuffer>} bytes @returns {Promise<ImageBitmap | null>} null: it cannot be shown */
export async function decode(bytes) {
  try {
    return await createImageBitmap(new Blob([bytes]));
  } catch {
    return null;
  }
}
