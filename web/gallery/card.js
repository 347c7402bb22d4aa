// A drawing in the gallery: its picture, its name, when it was drawn last, and what there is to know before opening it.

import { made } from '../page/elements.js';
import { word } from '../page/words.js';

/** @typedef {import('../keep/keep.js').Listed} Listed */

const MINUTE = 60000; // milliseconds
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
/** How a time is told: up to which age, and in what. @type {[number, number, Intl.RelativeTimeFormatUnit][]} */
const AGES = [[MINUTE, MINUTE, 'second'], [HOUR, MINUTE, 'minute'], [DAY, HOUR, 'hour'], [7 * DAY, DAY, 'day']];

/** Formats of a language, each made once. */
const formats = new Map();

/** @param {string} language @returns {{ relative: Intl.RelativeTimeFormat, day: Intl.DateTimeFormat, full: Intl.DateTimeFormat }} */
function formatsOf(language) {
  const known = formats.get(language) ?? { relative: new Intl.RelativeTimeFormat(language, { numeric: 'auto' }),
    day: new Intl.DateTimeFormat(language, { dateStyle: 'medium' }), full: new Intl.DateTimeFormat(language, { dateStyle: 'full', timeStyle: 'short' }) };
  formats.set(language, known);
  return known;
}

/** How long ago that was, or the date of what is older. @param {number} time @param {string} language */
function ago(time, language) {
  const { relative, day } = formatsOf(language);
  const age = Math.max(0, Date.now() - time);
  const [, unit, name] = AGES.find(([until]) => age < until) ?? [];
  return unit && name ? relative.format(-Math.floor(age / unit), name) : day.format(time);
}

/** A time, with all of it as its title. @param {number} time */
export function timeOf(time) {
  const { lang } = document.documentElement;
  const element = made('time', '', ago(time, lang));
  element.dateTime = new Date(time).toISOString();
  element.title = formatsOf(lang).full.format(time);
  return element;
}

export class Card {
  /**
   * @param {Listed} kept @param {boolean} own it is the one that is open
   * @param {{ open: (card: Card) => void, more: (card: Card, x: number, y: number) => void }} acts
   */
  constructor(kept, own, acts) {
    this.kept = kept;
    this.own = own;
    this.name = '';
    this.img = made('img', '');
    this.img.alt = '';
    this.img.hidden = true;
    this.img.addEventListener('load', () => { this.img.hidden = false; });
    this.img.addEventListener('error', () => {
      this.img.hidden = true;
      this.onspoilt();
    });
    /** Called when its picture is none. */
    this.onspoilt = () => {};
    this.title = made('bdi', '');
    const about = made('span', 'about', timeOf(kept.time), ...this.#marks());
    this.open = made('button', 'open', made('span', 'picture', this.img), this.title, about);
    this.open.type = 'button';
    this.open.ariaCurrent = String(own);
    this.open.addEventListener('click', () => acts.open(this));
    this.more = made('button', 'more', '⋯');
    this.more.type = 'button';
    this.more.setAttribute('aria-haspopup', 'menu');
    this.more.addEventListener('click', () => {
      const { left, bottom } = this.more.getBoundingClientRect();
      acts.more(this, left, bottom);
    });
    this.item = made('li', 'card', this.open, this.more);
    this.item.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      const { left, top } = this.item.getBoundingClientRect();
      acts.more(this, event.clientX || left, event.clientY || top); // a key has no place
    });
    this.reached = false;
    this.call(kept.name || word('shell.nameless'));
  }

  /** Shows it under a name. @param {string} name */
  call(name) {
    this.name = this.title.textContent = this.open.title = name;
    this.more.ariaLabel = `${name}: ${word('shell.further')}`;
  }

  #marks() {
    const { broken, aside, place } = this.kept;
    const keys = [this.own && 'open', broken && 'broken', !broken && aside && 'aside', !this.own && place && 'work'].filter((key) => typeof key === 'string' && key);
    return keys.flatMap((key) => [' ', made('small', `mark is-${key}`, word(`shell.kept-${key}`))]);
  }

  /** Whether Tab comes to it: to one card at a time. */
  get reached() {
    return this.open.tabIndex === 0;
  }

  set reached(reached) {
    this.open.tabIndex = this.more.tabIndex = reached ? 0 : -1;
  }

  /** @param {Blob} blob */
  show(blob) {
    URL.revokeObjectURL(this.img.src);
    this.img.src = URL.createObjectURL(blob);
  }

  /** Lets go of its picture. */
  leave() {
    URL.revokeObjectURL(this.img.src);
  }

  /** Lets the user name it in its place. @param {(name: string) => void} then what was typed; '' when given up */
  rename(then) {
    const field = made('input', 'naming');
    field.value = this.name;
    field.maxLength = 200;
    field.ariaLabel = word('step.rename');
    let done = false;
    const end = (/** @type {string} */ name) => {
      if (!done) {
        done = true;
        field.remove();
        then(name);
      }
    };
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' || event.key === 'Escape') {
        event.preventDefault(); // else Escape closes the gallery
        end(event.key === 'Enter' ? field.value : '');
        this.open.focus();
      }
      event.stopPropagation();
    });
    field.addEventListener('blur', () => end(field.value));
    this.item.append(field);
    field.focus();
    field.setSelectionRange(0, this.name.replace(/\.[a-z]{2,6}$/i, '').length);
  }
}
