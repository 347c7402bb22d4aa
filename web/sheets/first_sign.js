// What is needed as soon as there is a user, and not before: explanations, what is typed early, presses on what floats, and
// strokes that settle, pictures for the gallery.

import { Over } from '../stage/over.js';
import { Settling } from '../stage/settling.js';
import { tips } from '../page/tips.js';
import { pictureAtRest } from '../keep/resting.js';
import { keepTyped } from './typed.js';

/** @param {import('../main.js').Shell} shell */
export function begin(shell) {
  tips();
  Over.begin(shell);
  keepTyped(shell);
  if (!shell.server.sole) { // else another page keeps it
    pictureAtRest(shell);
  }
  shell.settling = new Settling(shell);
}
