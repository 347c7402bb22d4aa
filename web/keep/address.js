// What the page's address asks for, after "?" or "#": open=ADDRESS, a file of the page's own server; journal=ADDRESS, a
// journal, which is replayed into a drawing of its own; play=ADDRESS and study=ADDRESS, the drawing that a journal
// begins with; replay=TEXT, the journal that the address itself carries (export/link.js). Fetched when an address asks.

import { want } from '../page/build.js';
import { word } from '../page/words.js';

/** @typedef {import('./drawings.js').Drawings} Drawings */

/** What a journal does before the first event of a pen. @param {string} journal @returns {string[]} its lines */
export function headOf(journal) {
  const lines = journal.split('\n');
  const first = lines.findIndex((line) => line.startsWith('{"pointer"'));
  return lines.slice(0, first < 0 ? undefined : first);
}

/** The drawing that a journal begins with and its tool; not its window, nor its settings. @param {Uint8Array} journal */
const startOf = (journal) => new TextEncoder().encode(headOf(new TextDecoder().decode(journal))
  .filter((line) => !/^\{"(resize|set)"/.test(line)).join('\n'));

/**
 * The file at an address, of the page's own server only.
 * @param {string} asked relative to the page @returns {Promise<{ file: Blob, name: string }>}
 */
async function fetched(asked) {
  const address = new URL(asked, location.href);
  if (address.origin !== location.origin) {
    throw new Error(word('shell.other-origin'));
  }
  const response = await fetch(address);
  if (!response.ok) {
    throw new Error(word('shell.answered', `${response.status} ${response.statusText}`));
  }
  return { file: await response.blob(), name: decodeURIComponent(address.pathname.split('/').pop() ?? '') };
}

/** @param {Drawings} drawings @param {string} asked @returns {Promise<boolean>} */
async function openFile(drawings, asked) {
  const { file, name: given } = await fetched(asked);
  const name = given || 'drawing.svg';
  if (!await drawings.files.open(file, name)) {
    return false;
  }
  drawings.files.given = true;
  await drawings.arrived();
  return true;
}

/** @param {Drawings} drawings @param {string} asked @param {boolean} whole or only what it begins with */
async function openJournal(drawings, asked, whole) {
  const { file, name } = await fetched(asked);
  const { bytesOf } = await want(import('./gzip.js')); // what a drawing of the page's own does not need
  const bytes = await bytesOf(file);
  return run(drawings, asked, name.replace(/\.[a-z]+$/i, ''), whole ? bytes : startOf(bytes), !whole);
}

/**
 * Replays a journal into a drawing of its own.
 * @param {Drawings} drawings @param {string} asked what is named when it cannot be opened @param {string} name without its ending
 * @param {Uint8Array} journal @param {boolean} given the page shows it, the visitor did not bring it
 */
async function run(drawings, asked, name, journal, given) {
  const { engine, files } = drawings;
  await drawings.whole.complete();
  await drawings.openNew(name || undefined);
  const [width, height, ratio] = engine.size;
  const done = engine.replay(journal);
  engine.resize(width, height, ratio); // the journal's window had another
  engine.command('view-fit');
  files.given = given;
  drawings.wake();
  if (!done) {
    drawings.notices.say(`${word('shell.not-opened', asked)} ${word('shell.damaged')}`);
  }
  return true; // what could be replayed is there, in a drawing of its own
}

/** How somebody drew something: shown once, and then it is the visitor's drawing. @param {Drawings} drawings @param {string} text */
async function openReplay(drawings, text) {
  const [{ journalOf }, { playOver }] = await Promise.all([want(import('../export/link.js')), want(import('../export/film.js'))]);
  const journal = await journalOf(text);
  const { name = '' } = JSON.parse(new TextDecoder().decode(journal).split('\n', 1)[0]);
  await run(drawings, String(name), String(name).replace(/\.[a-z]+$/i, ''), journal, false);
  history.replaceState(null, '', location.pathname + location.search); // a reload brings back the drawing, not another one
  const play = () => void playOver(journal);
  drawings.notices.ask('replayed', word('shell.replayed'), [{ label: word('shell.play-again'), run: play }]);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
    play();
  }
  return true;
}

/**
 * @param {Drawings} drawings @param {string} words of the address
 * @returns {Promise<boolean>} whether something that it asks for is open now; if not, the user was told why
 */
export async function openAsked(drawings, words) {
  const asked = new URLSearchParams(words.replace(/[?#]/g, '&'));
  const [kind] = ['open', 'journal', 'play', 'study', 'replay'].filter((word) => asked.get(word));
  const address = asked.get(kind) ?? '';
  try {
    return kind !== undefined && await (kind === 'open' ? openFile(drawings, address) :
      kind === 'replay' ? openReplay(drawings, address) : openJournal(drawings, address, kind === 'journal'));
  } catch (error) {
    const name = kind === 'replay' ? word('shell.share') : address;
    drawings.notices.say(`${word('shell.not-opened', name)} ${error instanceof Error ? error.message : ''}`);
    return false;
  }
}
