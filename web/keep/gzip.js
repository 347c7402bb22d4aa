// The bytes of a file, unpacked when it is a gzip file (.svgz).

const MOST = 1 << 29; // bytes; more is no drawing
const GZIP = 0x8b1f;

/** @param {Blob} file @returns {Promise<Uint8Array<ArrayBuffer>>} throws for a damaged gzip file */
export async function bytesOf(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length < 2 || bytes[0] + 256 * bytes[1] !== GZIP) {
    return bytes;
  }
  const parts = [];
  let size = 0;
  for await (const part of file.stream().pipeThrough(new DecompressionStream('gzip'))) {
    size += part.length;
    if (size > MOST) {
      throw new Error('too large');
    }
    parts.push(part);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
