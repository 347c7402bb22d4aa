// Several drawings at once: all are added to the one that is open, each as a group, and nothing is replaced.

import { bytesOf } from './gzip.js';
import { parseSvg } from '../engine/svg.js';
import { word } from '../page/words.js';

/** @param {import('./files.js').Files} files @param {import('./files.js').Arrival[]} drawings */
export async function addAll({ engine, notices, wake }, drawings) {
  const failed = [];
  for (const { file } of drawings) {
    try {
      const bytes = await bytesOf(file);
      if (/\.svgz?$/i.test(file.name)) {
        engine.pasteSvg(parseSvg(new TextDecoder().decode(bytes)));
      } else {
        engine.pasteFile(bytes, file.name);
      }
      if (engine.actions().includes('group')) { // more than one object
        engine.command('group');
      }
    } catch (error) {
      failed.push(`${word('shell.not-opened', file.name)} ${error instanceof Error ? error.message : ''}`);
    }
  }
  wake();
  if (failed.length) {
    notices.ask('unopened', failed.join(' '), []); // stays, unlike what is said of the pasted ones
  }
}
