// Share: how the drawing was drawn, as a link that carries it or as a film made here. Fetched when it is asked for.

import { answer, question } from '../sheets/question.js';
import { Film, gifOf } from './film.js';
import { linkOf, MOST } from './link.js';
import { word } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */

/** @type {[number, number, number]} */
const SIZE = [800, 450, 1]; // of the film

const kilobytes = (/** @type {number} */ size) => (size / 1000).toFixed(1);

/** @param {string} text */
function line(text) {
  const paragraph = document.createElement('p');
  paragraph.textContent = text;
  return paragraph;
}

/** Shows the film again and again while the question stands. @param {Film} film @param {AbortSignal} signal */
async function loop(film, signal) {
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    film.show(Infinity);
    return;
  }
  while (!signal.aborted && await film.play(signal)) {
    await new Promise((done) => setTimeout(done, 600));
  }
}

/** Makes the file, and says how far it is. @param {Shell} shell @param {Film} film */
async function save({ files }, film) {
  const end = new AbortController();
  const bar = document.createElement('progress');
  bar.ariaLabel = word('shell.film');
  const asked = question('film', word('shell.filming'), [film.canvas, bar], [answer('', word('command.cancel'))]);
  void asked.then(() => end.abort());
  const made = await gifOf(film, end.signal, (share) => { bar.value = share; });
  /** @type {HTMLDialogElement | null} */ (document.getElementById('film'))?.close();
  if (made) {
    files.deliver(made, 'gif', 'image/gif');
  }
}

/** @param {Shell} shell */
export async function share(shell) {
  if (!await shell.whole.complete()) {
    return;
  }
  const { engine, files, notices } = shell;
  await (engine.words ?? shell.words.load());
  const journal = engine.journal.slice();
  const link = await linkOf(journal);
  const film = new Film(shell, journal, SIZE);
  film.canvas.setAttribute('role', 'img');
  film.canvas.setAttribute('aria-label', word('shell.film'));
  const size = link.length - link.indexOf('#');
  const fits = size <= MOST;
  /** @type {HTMLElement[]} */
  const shown = [film.canvas];
  if (!fits) {
    shown.push(line(word('shell.link-long', kilobytes(size))));
  } else if (/^(localhost|127\.|\[::1\])/.test(location.hostname)) {
    shown.push(line(word('shell.link-here')));
  }
  const end = new AbortController();
  const asked = question('share', word('shell.share-how', files.name), shown, [
    ...(fits ? [answer('link', word('shell.copy-link'))] : []), answer('film', word('shell.film')),
    answer('journal', word('command.download-journal')), answer('', word('command.cancel'))]);
  void loop(film, end.signal);
  const chosen = await asked;
  end.abort();
  if (chosen === 'link') {
    await navigator.clipboard.writeText(link).then(() => notices.say(word('shell.link-copied', kilobytes(size))),
      () => void prompt(word('shell.copy-link'), link)); // the browser may refuse the clipboard
  } else if (chosen === 'film') {
    await save(shell, film);
  } else if (chosen === 'journal') {
    files.downloadJournal();
  }
  shell.wake();
}
