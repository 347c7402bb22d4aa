// The sample that comes with the editor. Fetched when it is asked for.

import { addressOf } from './build.js';
import { word } from './words.js';

const NAME = 'car.svg';

/** Opens it as a file that somebody brings. @param {import('../main.js').Shell} shell */
export async function openCar({ files, notices }) {
  const answer = await fetch(addressOf(`examples/${NAME}`)).catch(() => null);
  if (!answer?.ok) {
    notices.say(word('shell.not-opened', NAME));
    return;
  }
  await files.arrive([{ file: new File([await answer.blob()], NAME, { type: 'image/svg+xml' }), place: null }]);
  files.given = !files.bound;
}
