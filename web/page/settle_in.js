// What the page does once it is there; nobody waits for it.

import { want } from './build.js';

const UNTOUCHED = 3000; // milliseconds after which the page readies itself for those who do not see it

/** @param {import('../main.js').Shell} shell */
export async function settleIn(shell) {
  // Safari has no time of idleness.
  (globalThis.requestIdleCallback ?? setTimeout)(async () => (await shell.whole.complete()) && shell.panel.fetchChips());
  const { Clipboard } = await want(import('../keep/clipboard.js'));
  shell.requests.clipboard = new Clipboard(shell.engine, shell.files, shell.notices, shell.wake);
  // What explains, and what is seldom called, is fetched when somebody is there.
  const seen = new AbortController();
  for (const event of ['pointermove', 'pointerdown', 'keydown', 'focusin']) {
    addEventListener(event, () => {
      seen.abort();
      void (shell.engine.words ?? shell.words.load());
      void shell.mirrorDrawing();
    }, { signal: seen.signal });
  }
  // A screen reader may read without touching anything.
  setTimeout(() => void shell.mirrorDrawing(), UNTOUCHED);
  if (shell.server.there) {
    const { watch } = await want(import('../keep/watch.js'));
    watch(shell.server, shell.files, shell.notices);
  }
  if (!shell.server.passing) {
    const { settle } = await want(import('../keep/offline.js'));
    await settle(shell.notices, () => shell.pack());
  }
}
