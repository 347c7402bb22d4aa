// What the front page, the race of fits and the study say: front.json, race.json and study.json, English and Korean. They are
// parts of a static host's page alone, so these words are not in the engine's table.

import { get } from '../page/build.js';

/** @type {Record<string, [string, string]>} */
let words = {};

/** Fetches the words of a page. @param {'front' | 'race' | 'study'} page */
export async function learn(page) {
  words = { ...words, ...await (await get(`site/${page}.json`)).json() };
}

/** @param {string} key @returns {string} in the language of the page */
export const say = (key) => words[key]?.[document.documentElement.lang.startsWith('ko') ? 1 : 0] ?? '';
