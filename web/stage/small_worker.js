// The worker that paints small pictures of drawings that are not open, from their journals, one after the other: the page goes on
// meanwhile.

import { Engine } from '../engine/engine.js';
import { Module } from '../engine/module.js';
import { encoded, paintSmall, smallPainter } from './small.js';
import { decode } from './pictures.js';

/** journal: of the drawing; largest: bytes of its picture.
 * @typedef {{ first: WebAssembly.Module, second: WebAssembly.Module | null, journal: Uint8Array, largest: number }} Order */

/** @param {Order} order @returns {Promise<Blob | null>} */
async function paint({ first, second, journal, largest }) {
  const module = new Module(first);
  module.second = second;
  const engine = new Engine(module);
  const painter = smallPainter();
  painter.paints = await import('./gradients.js');
  painter.paints.takeTilesFrom(painter);
  /** @type {Promise<unknown>[]} */
  const coming = [];
  painter.onpicture = (picture) => {
    coming.push(decode(/** @type {Uint8Array<ArrayBuffer>} */ (engine.picture(picture))).then((bitmap) => painter.pictures.set(picture, bitmap)));
  };
  const frame = engine.replay(journal) ? engine.frame() : null;
  if (!frame || !paintSmall(painter, frame.still)) {
    return null;
  }
  if (coming.length > 0) {
    await Promise.all(coming);
    paintSmall(painter);
  }
  return encoded(painter, largest);
}

addEventListener('message', ({ data }) => void paint(data).catch(() => null).then((blob) => postMessage(blob)));
