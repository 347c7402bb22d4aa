// The bytes of a file, unpacked when it is a gzip file (.svgz).

import { beyond, LIMITS } from '../engine/limits.js';
import { isPacked } from '../engine/reading.js';
import { Refusal, word } from '../page/words.js';

/**
 * @param {Blob} file @param {(share: number) => void} [watch] told how much has been read
 * @returns {Promise<Uint8Array<ArrayBuffer>>} throws for a damaged gzip file, and one that holds too much
 */
export async function bytesOf(file, watch = () => {}) {
  if (!isPacked(new Uint8Array(await file.slice(0, 2).arrayBuffer()))) {
    if (file.size > LIMITS.bytes) {
      throw beyond('bytes');
    }
    return new Uint8Array(await file.arrayBuffer());
  }
  let [read, size] = [0, 0];
  const counted = new TransformStream({
    transform(part, next) {
      read += part.length;
      next.enqueue(part);
    },
  });
  const parts = [];
  try {
    for await (const part of file.stream().pipeThrough(counted).pipeThrough(new DecompressionStream('gzip'))) {
      size += part.length;
      if (size > LIMITS.bytes) {
        throw beyond('bytes');
      }
      parts.push(part);
      watch(read / file.size);
    }
  } catch (error) {
    throw error instanceof Refusal ? error : new Refusal(word('shell.damaged'));
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
