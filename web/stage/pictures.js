// Pictures to trace: the browser's part. Fetched with a drawing's first picture.

/** Formats that the engine keeps unchanged; any other that the browser can show becomes a PNG. */
const KEPT = ['image/png', 'image/jpeg', 'image/webp'];

/** @param {File} file @returns {Promise<Uint8Array>} unchanged if it cannot be converted: the engine then refuses it */
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
      // The browser cannot decode it either.
    }
  }
  return new Uint8Array(await blob.arrayBuffer());
}

const TAG = 60; // "<"

const TURN = '<style>:root{filter:invert(1) hue-rotate(180deg)}</style>';

/** An SVG file with its colours turned over, as dim paper needs them; one that shows a photograph stays as it is. @param {string} text */
function turnedOver(text) {
  const end = text.lastIndexOf('</');
  return /<image\b/.test(text) || end < 0 ? text : text.slice(0, end) + TURN + text.slice(end);
}

/**
 * Foreign content, an SVG file, as an image: the browser then runs nothing in it and fetches nothing for it.
 * @param {Uint8Array} bytes @param {boolean} [turned] its colours are turned over
 */
export async function isolated(bytes, turned = false) {
  const image = new Image();
  const text = new TextDecoder().decode(bytes);
  image.src = `data:image/svg+xml,${encodeURIComponent(turned ? turnedOver(text) : text)}`; // a blob's would taint the canvas
  image.dataset.turned = String(turned);
  await image.decode();
  return image;
}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes @param {boolean} [turned] an SVG file's colours are turned over
 * @returns {Promise<ImageBitmap | HTMLImageElement | null>} null when it cannot be decoded
 */
export async function decode(bytes, turned = false) {
  try {
    if (bytes[0] === TAG) {
      return await isolated(bytes, turned);
    }
    return await createImageBitmap(new Blob([bytes]));
  } catch {
    return null;
  }
}
