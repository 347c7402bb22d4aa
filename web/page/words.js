// The texts of the page. Elements name their texts by the keys of the engine's table, so that a change of language or
// of a shortcut takes one pass over the page.

import { get, miss } from './build.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Tables} Tables */

const MAC = /Mac|iP(hone|ad)/.test(navigator.platform);

/** @type {Record<string, string>} */
let strings = {};
/**
 * The fetched strings: all of a language; the engine keeps only those that it uses itself.
 * @type {Record<string, string>}
 */
let fetched = {};
/** The first shortcut of each command. @type {Record<string, string>} */
let shortcuts = {};

/** Something that cannot be done, with a message for the user. */
export class Refusal extends Error {}

/** An edit cannot be said in the file that the drawing was read from: all of it would have to be written anew. */
export class Anew extends Error {}

/** All texts, for a worker, which speaks as its page does; also those that the page has not fetched yet. */
export async function spoken() {
  const language = document.documentElement.lang;
  const all = Object.keys(fetched).length ? fetched : await get(`words.${language}.json`).then((answer) => answer.json()).catch(() => ({}));
  return { ...strings, ...all };
}

/** @param {Record<string, string>} all */
export function speakAs(all) {
  strings = all;
}

/** The text of a key. @param {string} key @param {string | number} [value] replaces "%" */
export function word(key, value) {
  const text = strings[key] ?? '';
  return value === undefined ? text : text.replace('%', () => String(value));
}

/** The text of a key that has a singular form, for a count. @param {string} key @param {number} count */
export const counted = (key, count) => word(count === 1 ? `${key}-one` : key, count);

/** A shortcut as this platform writes it. @param {string} key */
export function keyName(key) {
  /** @type {Record<string, string>} */
  const known = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', Escape: 'Esc' };
  if (MAC) {
    Object.assign(known, { Ctrl: '⌘', Shift: '⇧', Alt: '⌥' });
  }
  // "Ctrl++" is Ctrl and the key "+".
  const parts = key.split(/\+(?=.)/);
  return parts.map((piece) => known[piece] ?? piece).join(MAC ? '' : '+');
}

/** The first shortcut of a command, as this platform writes it; '' without one. @param {string} command */
export const keyOf = (command) => (shortcuts[command] ? keyName(shortcuts[command]) : '');

/** @param {HTMLElement} element */
function speak(element) {
  const { text, label, help, value, shortcut } = element.dataset;
  const say = (/** @type {string} */ key) => word(key, value && word(value));
  if (text) {
    element.textContent = say(text);
  }
  if (label) {
    element.setAttribute('aria-label', say(label));
    if (element.hasAttribute('placeholder')) { // it says the same
      element.setAttribute('placeholder', say(label));
    }
  }
  if (help !== undefined) {
    const keys = shortcuts[shortcut ?? ''];
    const more = [label ? say(label) : '', word(help)].filter(Boolean).join(': ');
    element.title = keys ? `${more} (${keyName(keys)})` : more;
  }
}

/**
 * Gives an element its texts, now and after every change of language.
 * @template {HTMLElement} T
 * @param {T} element
 * @param {{ text?: string, label?: string, help?: string, value?: string, shortcut?: string }} keys of its text, of its
 *   accessible name and of its title; value: of the replacement for "%"; shortcut: the command whose shortcut to show
 * @returns {T}
 */
export function tell(element, keys) {
  Object.assign(element.dataset, keys);
  speak(element);
  return element;
}

/** Sets all texts again after the strings or the shortcuts have changed. @param {Tables} tables */
export function retell(tables) {
  strings = { ...tables.strings, ...fetched };
  shortcuts = Object.fromEntries(tables.commands.map((row) => [row.name, row.keys[0]]));
  document.documentElement.lang = word('language.code');
  document.documentElement.dir = word('language.direction');
  document.querySelectorAll('[data-text], [data-label], [data-help]').forEach((element) =>
    speak(/** @type {HTMLElement} */ (element)));
}

/**
 * The current language: the one chosen, or the first of the browser's languages that is available.
 * @param {Engine} engine
 */
function languageOf(engine) {
  const row = engine.tables().properties.find((property) => property.name === 'language');
  const codes = (row?.choices ?? []).map((key) => key.split('.')[1]);
  const wishes = navigator.languages.map((tag) => tag.split('-')[0]);
  return codes[engine.get('language') || -1] ?? wishes.find((code) => codes.includes(code)) ?? 'en';
}

export class Words {
  /** @param {Engine} engine */
  constructor(engine) {
    this.engine = engine;
    this.choice = -1;
    this.language = '';
    /** @type {Tables} */
    this.tables = engine.tables();
    /** Called when the texts of the page have changed. @type {(tables: Tables) => void} */
    this.onchange = () => {};
  }

  /**
   * Makes the page follow the language chosen. The module contains English except for explanations; those and other
   * languages are fetched.
   */
  async follow() {
    const choice = this.engine.get('language');
    if (choice === this.choice) {
      return;
    }
    const first = this.choice < 0;
    this.choice = choice;
    this.language = languageOf(this.engine);
    if (first && this.language === 'en') {
      this.retell();
    } else {
      await this.load();
    }
  }

  /** Fetches the strings of the current language. */
  async load() {
    const { language } = this;
    try {
      const bytes = new Uint8Array(await (await get(`words.${language}.json`)).arrayBuffer());
      if (language === this.language) {
        fetched = JSON.parse(new TextDecoder().decode(bytes));
        this.engine.speak(bytes);
      }
    } catch (error) {
      miss(error); // English remains
    }
    this.retell();
  }

  /** Updates the texts after the strings or the shortcuts have changed. */
  retell() {
    this.tables = this.engine.tables();
    retell(this.tables);
    this.onchange(this.tables);
  }
}
