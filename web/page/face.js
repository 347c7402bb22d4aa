// The type face of the page, fetched after the first picture. Until it is there, and where it can not be had, words stand
// in the system's face.

import { addressOf } from './build.js';

const FAMILY = 'Batten-Inter'; // not the name of a face that the system may have
const PATIENCE = 1000; // milliseconds that other parts of the page wait for it

/**
 * Nothing is said when it fails: every word can be read without it.
 * @returns {Promise<void>} when it is there, has failed or is late
 */
export function dressWords() {
  const file = document.querySelector('meta[name=batten-face]')?.getAttribute('content');
  if (!file) {
    return Promise.resolve(); // built without one
  }
  const face = new FontFace(FAMILY, `url("${addressOf(file)}")`, { weight: '400 600' });
  return new Promise((done) => {
    const late = setTimeout(done, PATIENCE);
    const end = () => {
      clearTimeout(late);
      done();
    };
    face.load().then(() => document.fonts.add(face)).then(end, end);
  });
}
