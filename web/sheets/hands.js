// The card of the first run: the three hands, each with its name, what it does, and a moving picture of it, made by the
// engine. Fetched with the first empty page, and never again.

import { Moving } from './moving.js';
import { tell } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */

/** An arch with ripples: a sweep and its detail. */
function ripples() {
  const COUNT = 44;
  const at = (/** @type {number} */ i) => [16 + (208 * i) / COUNT, 92 - 58 * Math.sin((Math.PI * i) / COUNT) + (i % 2 ? 4 : -4)];
  const pieces = Array.from({ length: COUNT }, (_, i) => {
    const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    const handles = [b[0] + (c[0] - a[0]) / 6, b[1] + (c[1] - a[1]) / 6, c[0] - (d[0] - b[0]) / 6, c[1] - (d[1] - b[1]) / 6];
    return `C${[...handles, ...c].join(' ')}`;
  });
  return `M${at(0).join(' ')}${pieces.join('')}`;
}

const PLAYS = 2; // times that they are shown by themselves
/** In a picture of 240 x 120. @type {(import('./moving.js').Script & { name: string })[]} */
const HANDS = [
  { name: 'sketch', path: 'M16 84C60 40 150 34 224 84', strokes: [[[66, 58], [96, 40], [140, 36], [178, 57]]], meaning: 1 },
  { name: 'levels', path: ripples(), before: ['tool-select', 'select-all', 'tool-levels', 'take-apart', 'accept'],
    strokes: [[[120, 34], [118, 44], [112, 72]]] },
  { name: 'tangents', path: '', strokes: [[[20, 88], [48, 56]], [[112, 34], [150, 40]], [[212, 88], [226, 62]]], after: ['accept'] },
];

export class Hands {
  /** @param {Shell} shell @param {HTMLElement} box */
  constructor(shell, box) {
    this.shell = shell;
    this.gone = false;
    /** @type {Moving[]} */
    this.pictures = [];
    this.card = tell(document.createElement('section'), { label: 'hands.help' });
    this.card.className = 'hands';
    const close = tell(document.createElement('button'), { label: 'first.none', help: '' });
    close.type = 'button';
    close.className = 'hands-close';
    close.textContent = '×';
    close.addEventListener('click', () => this.end());
    this.card.append(...HANDS.map((hand) => this.#hand(hand)), close);
    box.prepend(this.card);
  }

  /** @param {import('./moving.js').Script & { name: string }} hand */
  #hand(hand) {
    const figure = document.createElement('figure');
    const picture = new Moving(this.shell, { before: [`tool-${hand.name}`], ...hand });
    const title = tell(document.createElement('strong'), { text: `tool.${hand.name}` });
    const said = tell(document.createElement('span'), { text: `hands.${hand.name}.help` });
    const caption = document.createElement('figcaption');
    caption.append(title, said);
    figure.append(picture.box, caption);
    this.pictures.push(picture);
    return figure;
  }

  /** Shows them, one after the other; where motion is to be reduced, as they are in the end. */
  async begin() {
    await (this.shell.engine.words ?? this.shell.words.load()); // the explanations
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.pictures.forEach((picture) => picture.begin());
    for (let play = 0; play < (still ? 1 : PLAYS); play++) {
      for (const picture of this.pictures) {
        if (this.gone) {
          return;
        }
        await picture.play(still);
      }
    }
  }

  /** Takes the card away. */
  end() {
    this.gone = true;
    this.pictures.forEach((picture) => picture.end());
    this.card.remove();
  }
}
