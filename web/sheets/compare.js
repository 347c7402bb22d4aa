// A file that changed on disk while it was edited: shows the drawing and the file side by side, with the choices.
// Loaded on demand.

import { dress } from '../page/build.js';
import { Engine } from '../engine/engine.js';
import { isNative } from '../engine/reading.js';
import { answer, question } from './question.js';
import { word } from '../page/words.js';

/**
 * The file as SVG; a native file is converted by a separate engine.
 * @param {Engine} engine @param {import('../keep/server.js').FileBytes} file
 */
function pictureOf(engine, { name, bytes }) {
  if (!isNative(name)) {
    return bytes;
  }
  const other = new Engine(engine.module);
  other.openNative(bytes, name);
  return other.save(false);
}

/** @param {Uint8Array} svg @param {string} title */
export function figure(svg, title) {
  const box = document.createElement('figure');
  const picture = document.createElement('img');
  const caption = document.createElement('figcaption');
  caption.textContent = title;
  picture.src = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (svg)], { type: 'image/svg+xml' }));
  picture.alt = '';
  for (const event of ['load', 'error']) {
    picture.addEventListener(event, () => URL.revokeObjectURL(picture.src));
  }
  box.append(picture, caption);
  return box;
}

/**
 * @param {Engine} engine of the drawing
 * @param {import('../keep/server.js').FileBytes} file
 * @returns {Promise<string>} 'overwrite', 'beside', or '' for neither
 */
export async function compare(engine, file) {
  await dress('styles/compare.css');
  const both = document.createElement('div');
  both.className = 'both';
  both.append(figure(engine.save(false), word('shell.drawn-here')), figure(pictureOf(engine, file), word('shell.on-disk')));
  return question('compare', word('shell.changed'), [both], [answer('beside', word('shell.beside')),
    answer('overwrite', word('shell.overwrite')), answer('', word('command.cancel'))]);
}
