// What is said when a call into the engine broke off or the browser keeps no more steps, and the ways out that are offered.

import { counted, word } from '../page/words.js';

/**
 * @param {import('./drawings.js').Drawings} drawings @param {import('../engine/instance.js').Outcome} outcome
 * @param {unknown} error
 */
export function tellBroken(drawings, outcome, error) {
  const { engine, files, notices, whole } = drawings;
  const { left, dead, fresh, scarce } = outcome;
  const again = () => tellBroken(drawings, { ...outcome, fresh: false }, error);
  const copy = { label: word('shell.copy'), run: () => void files.download() };
  const journal = { label: word('shell.journal'), run: () => files.downloadJournal(engine.broken) };
  const reload = { label: word('shell.reload'), run: () => void whole.reload(again) };
  if (dead) {
    const stay = [copy, journal].map(({ label, run }) => ({ label, run: () => {
      run();
      again(); // the other ways out are still needed
    } }));
    const anew = { label: word('shell.new'), run: () => void (engine.revive() && drawings.openNew()) };
    notices.ask('trap', word('shell.dead'), [...stay, reload, ...(files.server.sole ? [] : [anew])], true);
  } else if (left.length > 0) {
    const aside = { label: word('shell.left-out'), run: async () =>
      files.deliver(new Uint8Array(await new Blob(/** @type {BlobPart[]} */ (left)).arrayBuffer()), 'left.journal', 'application/x-ndjson') };
    notices.ask('trap', counted('shell.trapped-part', left.length), [aside, journal]);
  } else if (scarce) {
    notices.ask('trap', word(fresh ? 'shell.freed' : 'shell.scarce'), [copy, fresh ? journal : reload]);
  } else {
    notices.ask('trap', word('shell.trapped'), [journal]);
  }
}

/**
 * The browser has stopped keeping steps, or keeps them again.
 * @param {import('./drawings.js').Drawings} drawings @param {import('./keep.js').Fault | ''} fault
 */
export function tellUnkept({ files, notices, wake }, fault) {
  notices.over('unkept');
  if (!fault) {
    return;
  }
  const copy = { label: word('shell.copy', files.name), run: () => void files.download() };
  const save = { label: word('shell.save-now', files.name), run: () => void files.save() };
  notices.ask('unkept', word(`shell.${fault}`, files.name), files.bound ? [save, copy] : [copy]);
  wake();
}
