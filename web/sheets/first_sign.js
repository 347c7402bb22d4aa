// What is needed as soon as there is a user, and not before: explanations, what is typed early, presses on what floats, and
// strokes that settle.

import { Over } from '../stage/over.js';
import { Settling } from '../stage/settling.js';
import { tips } from '../page/tips.js';
import { keepTyped } from './typed.js';

/** @param {import('../main.js').Shell} shell */
export function begin(shell) {
  tips();
  Over.begin(shell);
  keepTyped(shell);
  shell.settling = new Settling(shell);
}
