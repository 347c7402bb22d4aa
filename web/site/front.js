// The front page of a static host: under the editor a card says what to try and leads on, and a ghost pen shows it once.

import { want } from '../page/build.js';
import { ready } from '../page/ready.js';
import { learn, say } from './words.js';

/** @typedef {import('./ghost.js').Ghost} Ghost */
/** @typedef {import('../main.js').Shell} Shell */

const SECONDS = 6;
const LINKS = [['hairs', '#play=demos/hairs.journal'], ['crocodile', '#play=demos/crocodile.journal'],
  ['race', 'race.html'], ['manual', 'manual/']];

/** What is played: the journal that the address names, else the one of the car. @param {URLSearchParams} asked */
function playOf(asked) {
  const address = asked.get('play') ?? (['open', 'journal', 'study'].some((word) => asked.has(word)) ? '' : 'demos/car.journal');
  const name = /(\w+)\.journal$/.exec(address)?.[1] ?? '';
  return { address, name: say(`${name}.turn`) ? name : address && 'figure' };
}

/** @param {string} tag @param {Record<string, string>} attributes @param {string} [text] */
function make(tag, attributes, text = '') {
  const element = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  element.textContent = text;
  return element;
}

class Front {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.asked = new URLSearchParams(location.hash.slice(1));
    this.play = playOf(this.asked);
    /** @type {Ghost | null} */
    this.ghost = null;
    this.text = make('p', { role: 'status' });
    this.again = make('button', { type: 'button', class: 'away' }, say('again'));
    this.again.addEventListener('click', () => this.#start());
    this.card = make('section', { class: 'front', 'aria-label': say('links') });
    const close = make('button', { type: 'button', 'aria-label': say('close'), class: 'close' }, '×');
    close.addEventListener('click', () => {
      this.stop();
      this.card.remove();
    });
    const links = make('nav', { 'aria-label': say('links') });
    links.append(...LINKS.map(([key, href]) => make('a', { href }, say(key))));
    // There is room for all that will be said, so that no link moves under a pointer that comes down.
    const words = make('div', { class: 'words' });
    words.append(this.text, ...['ghost', 'turn'].map((part) => make('span', { 'aria-hidden': 'true' }, say(`${this.play.name}.${part}`))));
    this.told = make('div', { class: 'told' });
    this.told.append(words, this.again);
    this.card.append(this.told, links, close);
    document.querySelector('.notices')?.append(this.card);
  }

  /** Shows the ghost at once, or offers to where motion is to be reduced. */
  async begin() {
    if (this.asked.has('study')) {
      await (await want(import('./study.js'))).begin(this.shell, this.told);
      return;
    }
    if (!this.play.name || !this.shell.files.given) {
      this.told.remove(); // the visitor's own drawing is open
      return;
    }
    const { Ghost } = await want(import('./ghost.js'));
    if (!await this.shell.whole.complete()) {
      return;
    }
    const ghost = await want(Ghost.make(this.shell, this.play.address, SECONDS * 1000));
    this.ghost = ghost;
    ghost.onstop = () => this.#ended();
    // The first touch of anything stops it, and does what it does without the ghost.
    for (const event of ['pointerdown', 'wheel', 'keydown']) {
      addEventListener(event, ({ target }) => target !== this.again && this.stop(), { capture: true, passive: true });
    }
    if (matchMedia('(prefers-reduced-motion: reduce)').matches || this.shell.files.edited) {
      this.#ended();
      this.again.textContent = say('show');
    } else {
      this.#start();
    }
  }

  #start() {
    this.again.className = 'away';
    this.text.textContent = say(`${this.play.name}.ghost`);
    this.ghost?.start();
  }

  stop() {
    this.ghost?.stop();
  }

  #ended() {
    this.text.textContent = say(`${this.play.name}.turn`);
    this.again.textContent = say('again');
    this.again.className = '';
    document.documentElement.dataset.turn = 'yes';
  }
}

const [shell] = await Promise.all([ready(), learn('front')]);
// A link to another drawing: what is open is kept by the browser first.
addEventListener('hashchange', async () => {
  await shell.pack();
  location.reload();
});
const front = new Front(shell);
Object.assign(globalThis, { front }); // for tests
await front.begin();

