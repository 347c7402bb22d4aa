// Watches the place that the drawing is saved to: whether it still answers, was restarted, or has a different version of the file now.
// Asks when the page becomes visible, regularly while it is visible, and soon again after no answer; never while
// hidden.

import { word } from '../page/words.js';

const NOW_AND_THEN = 30000; // milliseconds
const SOON = 2000;

/**
 * @param {import('./files.js').Files} files
 * @param {import('../page/notice.js').Notices} notices
 */
export function watch(files, notices) {
  let timer = 0;
  let pause = 0; // before the next attempt, after no answer
  let told = ''; // the changed version that the user was last told of
  let asking = false;

  async function hear() {
    clearTimeout(timer);
    if (document.hidden || asking || !files.bound) {
      return;
    }
    asking = true;
    try {
      const tag = await files.place.hear();
      if (pause) {
        notices.over('silent');
        notices.say(word('shell.back'));
      }
      pause = 0;
      if (tag !== told) {
        told = tag;
        files.tellOf(tag);
      }
    } catch (error) {
      if (!pause && !notices.asks('unsaved')) {
        notices.ask('silent', error instanceof Error ? error.message : String(error),
          [{ label: word('shell.copy'), run: () => void files.download() }]);
      }
      pause = Math.min(pause ? 2 * pause : SOON, NOW_AND_THEN);
    } finally {
      asking = false;
      timer = setTimeout(() => void hear(), pause || NOW_AND_THEN);
    }
  }

  document.addEventListener('visibilitychange', () => void hear());
  addEventListener('focus', () => void hear());
  timer = setTimeout(() => void hear(), NOW_AND_THEN);
}
