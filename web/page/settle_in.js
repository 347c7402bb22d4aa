// What the page does after it has loaded; nothing waits for it.

import { want } from './build.js';

const BUSY = 1000; // milliseconds that a browser may be busy before the rest of the page comes all the same
const UNTOUCHED = 3000; // milliseconds without input before the list for screen readers is loaded

/** What an empty page offers is fetched with the first one. @param {import('../main.js').Shell} shell */
function greet(shell) {
  const welcome = /** @type {HTMLElement} */ (document.getElementById('welcome'));
  const look = async () => {
    if (!welcome.hidden) {
      empty.disconnect();
      const { Start } = await want(import('./start.js'));
      await Start.make(shell);
    }
  };
  const empty = new MutationObserver(look);
  empty.observe(welcome, { attributeFilter: ['hidden'] });
  void look();
}

/** @param {import('../main.js').Shell} shell */
export async function settleIn(shell) {
  // Safari has no requestIdleCallback.
  const soon = globalThis.requestIdleCallback ?? ((/** @type {() => void} */ run) => setTimeout(run));
  soon(async () => {
    const dressed = import('./face.js').then(({ dressWords }) => dressWords(), () => {}); // without it nothing is missed
    if (await shell.whole.complete()) {
      if (!shell.panel.dock.box.hidden) {
        void shell.panel.dock.fetch();
      }
      const { Dial } = await want(import('../stage/dial.js'));
      shell.dial = new Dial(shell);
      shell.wake();
      const { Options } = await want(import('../sheets/options.js'));
      shell.panel.options = await Options.make(shell.panel, dressed); // what stands in the middle would change its width
      shell.panel.shows.push(shell.panel.options);
      shell.wake();
      const { Flyout } = await want(import('../sheets/flyout.js'));
      shell.panel.flyout = new Flyout(shell, shell.panel.rail);
      if (!shell.server.sole) { // else another page says what is drawn
        greet(shell);
      }
    }
  }, { timeout: BUSY });
  // Explanations and rarely used code are fetched at the first sign of a user.
  const seen = new AbortController();
  for (const event of ['pointermove', 'pointerdown', 'keydown', 'focusin']) {
    addEventListener(event, () => {
      seen.abort();
      void (shell.engine.words ?? shell.words.load());
      void shell.whole.complete().then((whole) => void (whole && shell.panel.fetchChips()));
      void shell.mirrorDrawing();
      void want(import('../sheets/first_sign.js')).then(({ begin }) => begin(shell));
    }, { signal: seen.signal });
  }
  const { Clipboard } = await want(import('../keep/clipboard.js'));
  shell.requests.clipboard = new Clipboard(shell.engine, shell.files, shell.notices, shell.wake);
  // A screen reader may read without any input.
  setTimeout(() => void shell.mirrorDrawing(), UNTOUCHED);
  const { watch } = await want(import('../keep/watch.js'));
  watch(shell.files, shell.notices);
  if (!shell.server.passing) {
    const { settle } = await want(import('../keep/offline.js'));
    await settle(shell.notices, () => shell.pack());
  }
}
