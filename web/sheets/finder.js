// How well what is searched fits what can be found: by its name, by words that others have for it, by its explanation.

/** What can be found. label, words, more: in small letters. @typedef {{ label: string, words: string, more: string }} Findable */

const OF_LABEL = 4;
const OF_WORDS = 5; // chosen for it, where a name may have the word in passing
const OF_MORE = 0.5;
const INSIDE = 3; // letters that are also looked for in the midst of words
const FAR = 0.25; // share of the best score below which nothing is shown
const LATER = 0.01; // what a word less counts for each before it: the chief ones stand first
const LONG = 1e-4; // what each letter counts: of two names that fit alike the shorter is first

/** The words of a text. @param {string} text */
const wordsOf = (text) => text.split(/[\s,.:;()]+/).filter(Boolean);

/** Whether a word is searched whole, from its start, or somewhere in it. @param {string[]} words @param {string} part */
const fit = (words, part) => words.reduce((best, one, i) => Math.max(best,
  (one === part ? 3 : one.startsWith(part) ? 2 : part.length >= INSIDE && one.includes(part) ? 1 : 0) * (1 - Math.min(LATER * i, 0.5))), 0);

/**
 * 0: it does not have all that is searched.
 * @param {Findable} one @param {string[]} parts what is searched, in small letters
 */
function scoreOf({ label, words, more }, parts) {
  const [name, others, help] = [label, words, more].map(wordsOf);
  let sum = 0;
  for (const part of parts) {
    const fits = OF_LABEL * fit(name, part) + OF_WORDS * fit(others, part) || OF_MORE * Math.max(fit(help, part), Number(part.length >= INSIDE && more.includes(part)));
    if (!fits) {
      return 0;
    }
    sum += fits;
  }
  const whole = parts.join(' ');
  const together = parts.length > 1 && (label.includes(whole) || ` ${words} `.includes(` ${whole} `)) ? OF_WORDS * 2 : 0;
  return sum + together - LONG * label.length;
}

/**
 * Those that have all that is searched, the best first.
 * @template {Findable} T
 * @param {T[]} all @param {string} search @returns {T[]}
 */
export function found(all, search) {
  const parts = search.toLowerCase().split(/\s+/).filter(Boolean);
  const scored = all.map((one) => ({ one, score: scoreOf(one, parts) })).filter(({ score }) => score > 0);
  const least = FAR * Math.max(0, ...scored.map(({ score }) => score));
  return scored.filter(({ score }) => score >= least).sort((a, b) => b.score - a.score).map(({ one }) => one);
}
