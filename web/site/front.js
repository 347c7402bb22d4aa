// The front page of a static host: over the editor a band says what it is and has four things to try, each in the editor itself;
// beside the drawing a card says what to do with it and leads on once it is done, and a ghost pen shows it once.

import { want } from '../page/build.js';
import { keep, kept } from '../page/kept.js';
import { ready } from '../page/ready.js';
import { learn, say } from './words.js';

/** @typedef {import('./ghost.js').Ghost} Ghost */
/** @typedef {import('../main.js').Shell} Shell */
/** What can be tried: its name in the words; the address of its journal; what is opened, if not the journal; whether a ghost shows it.
 * @typedef {{ name: string, address: string, open?: string, ghost: boolean }} Play */

const SECONDS = 6;
const STORE = 'batten-front'; // whether the band was closed
const GAP = 20; // pixels between the card and what was drawn
const EDGE = 8;
const OVER = ':is(.levels, .time, .dial, .chips, .actions, .notice, .lens):not([hidden])'; // what the card does not lie over

/** @type {Play[]} */
const TABS = [
  { name: 'car', address: 'demos/car.journal', open: 'open=demos/car.svg', ghost: true },
  { name: 'crocodile', address: 'demos/crocodile.journal', ghost: true },
  { name: 'sculpt', address: 'demos/sculpt.journal', ghost: false },
  { name: 'flight', address: 'demos/flight.journal', ghost: false },
];

/** What is played: the journal that the address names, else the first tab; null: something else is opened. @param {URLSearchParams} asked @returns {Play | null} */
function playOf(asked) {
  const address = asked.get('play');
  if (address === null) {
    return ['open', 'journal', 'study', 'replay'].some((word) => asked.has(word)) ? null : TABS[0];
  }
  const name = /(\w+)\.journal$/.exec(address)?.[1] ?? '';
  return TABS.find((tab) => tab.address === address) ?? { name: say(`${name}.turn`) ? name : 'figure', address, ghost: true };
}

/** @param {string} tag @param {Record<string, string>} attributes @param {...(Node | string)} content */
function make(tag, attributes, ...content) {
  const element = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  element.append(...content);
  return element;
}

/** @param {string} text @param {() => void} run */
function button(text, run) {
  const made = /** @type {HTMLButtonElement} */ (make('button', { type: 'button' }, text));
  made.addEventListener('click', run);
  return made;
}

/** Whether motion is to be reduced. */
const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

class Front {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.asked = new URLSearchParams(location.hash.slice(1));
    this.play = playOf(this.asked);
    /** @type {Ghost | null} */
    this.ghost = null;
    /** Counts what was begun: what was fetched for an earlier one comes too late. */
    this.round = 0;
    /** The visitor has done it. */
    this.done = false;
    this.text = make('p', { role: 'status' });
    this.buttons = make('span', { class: 'then' });
    this.told = make('section', { class: 'told', 'aria-label': say('links') }, this.text, this.buttons);
    /** The box of the last stroke, in the window. @type {[number, number, number, number]} */
    this.drawn = [0, 0, 0, 0];
    document.querySelector('main')?.append(this.told);
    this.#band();
    this.#watch();
  }

  // ---- the band ----

  #band() {
    if (!document.documentElement.dataset.front) {
      return;
    }
    const tabs = make('nav', { 'aria-label': say('links') }, ...TABS.map((tab) => {
      const link = make('a', { href: `#play=${tab.address}` }, say(tab.name));
      link.addEventListener('click', (event) => {
        const { ctrlKey, metaKey, shiftKey } = /** @type {MouseEvent} */ (event);
        if (!ctrlKey && !metaKey && !shiftKey) { // else it opens beside this one
          event.preventDefault();
          void this.show(tab);
        }
      });
      return link;
    }));
    const close = button('×', () => {
      keep(STORE, 'closed');
      this.#close();
    });
    close.setAttribute('aria-label', say('close'));
    this.band = make('header', { class: 'front', 'aria-label': 'Batten' },
      make('p', {}, make('b', {}, 'Batten'), make('span', {}, say('promise')), make('small', {}, say('free'))),
      tabs, make('a', { href: 'manual/', class: 'manual' }, say('manual')), close);
    document.body.prepend(this.band);
    this.#mark();
  }

  #close() {
    delete document.documentElement.dataset.front;
    this.band?.remove();
  }

  #mark() {
    this.band?.querySelectorAll('nav a').forEach((link, i) => {
      link.toggleAttribute('aria-current', TABS[i] === this.play);
    });
  }

  /** Opens what a tab has in place of what is open, which stays kept. @param {Play} play */
  async show(play) {
    const { drawings, wake } = this.shell;
    this.stop();
    const round = ++this.round;
    this.play = play;
    this.#mark();
    this.told.hidden = true;
    history.replaceState(null, '', `#play=${play.address}`); // a link to it, and what a reload shows
    drawings.keepNow();
    const { openAsked } = await want(import('../keep/address.js'));
    if (await openAsked(drawings, play.open ?? `play=${play.address}`) && round === this.round) {
      wake();
      this.shell.stage.focus();
      await this.#begin();
    }
  }

  // ---- what is tried ----

  /** What is open when the page comes. */
  async begin() {
    if (this.asked.has('study')) {
      this.#close();
      await (await want(import('./study.js'))).begin(this.shell, this.told);
    } else if (this.play && this.shell.files.given) {
      await this.#begin();
    } else {
      this.#end(); // the visitor's own drawing is open
    }
  }

  #end() {
    this.told.remove();
    this.#close();
  }

  /** Shows at once what can be done, or offers to where motion is to be reduced. */
  async #begin() {
    const play = /** @type {Play} */ (this.play);
    const { round } = this;
    this.done = false;
    this.ghost = null;
    if (!await this.shell.whole.complete() || round !== this.round) {
      return;
    }
    if (play.ghost) {
      const { Ghost } = await want(import('./ghost.js'));
      const ghost = await want(Ghost.make(this.shell, play.address, SECONDS * 1000));
      if (round !== this.round) {
        return;
      }
      this.ghost = ghost;
      ghost.onstop = () => this.#turn();
    }
    if (still() || this.shell.files.edited) {
      this.#turn(say('show'));
    } else {
      this.#start();
    }
  }

  #start() {
    this.#say(`${this.play?.name}.ghost`);
    if (this.ghost) {
      this.ghost.start();
    } else {
      this.#fly();
      this.#turn();
    }
  }

  /** Lets the camera of the drawing fly, where it has one. */
  #fly() {
    if (this.play?.name === 'flight') {
      this.shell.engine.command('move-play');
      this.shell.wake();
    }
  }

  stop() {
    this.ghost?.stop();
  }

  /** It is the visitor's turn. @param {string} [again] what the button says */
  #turn(again = say('again')) {
    const shows = this.ghost || this.play?.name === 'flight';
    this.#say(`${this.play?.name}.turn`, ...shows ? [button(again, () => this.#start())] : []);
    document.documentElement.dataset.turn = 'yes';
  }

  /** @param {string} key @param {...HTMLElement} buttons */
  #say(key, ...buttons) {
    this.told.hidden = false;
    this.text.textContent = say(key);
    this.buttons.replaceChildren(...buttons);
    this.told.style.removeProperty('left');
    this.told.style.removeProperty('top');
  }

  // ---- what the visitor does ----

  #watch() {
    // The first touch of anything stops the ghost, and does what it does without it.
    for (const event of ['pointerdown', 'wheel', 'keydown']) {
      addEventListener(event, ({ target }) => this.told.contains(/** @type {Node} */ (target)) || this.stop(), { capture: true, passive: true });
    }
    const { stage } = this.shell;
    const note = (/** @type {PointerEvent} */ event) => {
      const all = [event, ...event.type === 'pointermove' ? event.getCoalescedEvents() : []];
      const xs = all.map(({ clientX }) => clientX);
      const ys = all.map(({ clientY }) => clientY);
      const [x0, y0, x1, y1] = event.type === 'pointerdown' ? [Infinity, Infinity, -Infinity, -Infinity] : this.drawn;
      this.drawn = event.buttons ? [Math.min(x0, ...xs), Math.min(y0, ...ys), Math.max(x1, ...xs), Math.max(y1, ...ys)] : this.drawn;
    };
    stage.addEventListener('pointerdown', note, true);
    stage.addEventListener('pointermove', note, true);
    this.shell.panel.shows.push({ show: (frame) => this.#look(frame) });
  }

  /** At each frame: has it been done? @param {import('../engine/types.js').Frame} frame */
  #look(frame) {
    if (this.done || !frame.canUndo || frame.busy || !this.told.isConnected || !TABS.includes(/** @type {Play} */ (this.play))) {
      return;
    }
    this.done = true;
    const next = TABS[TABS.indexOf(/** @type {Play} */ (this.play)) + 1];
    const go = next ? button(say(next.name), () => void this.show(next)) : button(say('own'), () => {
      this.#end();
      void this.shell.drawings.openNew();
    });
    const away = button('×', () => { this.told.hidden = true; });
    away.setAttribute('aria-label', say('close'));
    away.className = 'close';
    this.#say(`${this.play?.name}.done`, go, away);
    setTimeout(() => this.#place(), 100); // what else stands beside it has its place by then
  }

  /** At what was drawn, and over nothing else. */
  #place() {
    const main = /** @type {HTMLElement} */ (this.told.parentElement);
    const room = main.getBoundingClientRect();
    const scale = /** @type {any} */ (this.told).currentCSSZoom ?? 1;
    const { width, height } = this.told.getBoundingClientRect();
    const [x0, y0, x1, y1] = this.drawn;
    const middle = Math.max(room.left + EDGE, Math.min((x0 + x1 - width) / 2, room.right - EDGE - width));
    const others = [...document.querySelectorAll(OVER)].map((one) => one.getBoundingClientRect()).filter((one) => one.width > 0);
    const free = [y0 - GAP - height, y1 + GAP].find((y) => y > room.top + EDGE && y + height < room.bottom - EDGE &&
      !others.some((one) => one.left < middle + width && one.right > middle && one.top < y + height && one.bottom > y));
    if (x1 > x0 && free !== undefined) {
      this.told.style.setProperty('left', `${(middle - room.left + width / 2) / scale}px`);
      this.told.style.setProperty('top', `${(free - room.top) / scale}px`);
    }
  }
}

// The band has its room from the start, so that nothing moves when it comes.
if (kept(STORE) !== 'closed') {
  document.documentElement.dataset.front = 'yes';
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
