// ?open=ADDRESS: opens a file of the page's own server. Fetched when the page's address asks for it.

import { bytesOf } from './gzip.js';
import { word } from '../page/words.js';

/**
 * @param {import('./drawings.js').Drawings} drawings @param {string} asked relative to the page
 * @returns {Promise<boolean>} whether it is open now; if not, the user was told why
 */
export async function openAt(drawings, asked) {
  const { files, notices } = drawings;
  try {
    const address = new URL(asked, location.href);
    if (address.origin !== location.origin) {
      throw new Error(word('shell.other-origin'));
    }
    const response = await fetch(address);
    if (!response.ok) {
      throw new Error(word('shell.answered', `${response.status} ${response.statusText}`));
    }
    const name = decodeURIComponent(address.pathname.split('/').pop() ?? '') || 'drawing.svg';
    const kept = await drawings.admit(name);
    if (!files.open(await bytesOf(await response.blob()), name)) {
      return false;
    }
    drawings.resume(kept);
    return true;
  } catch (error) {
    notices.say(`${word('shell.not-opened', asked)} ${error instanceof Error ? error.message : ''}`);
    return false;
  }
}
