// Counts the cubics of docs/why/cubics.md: node cubics.mjs PROGRAM TREE, after the target site_page has been built in TREE. The
// strokes are those of docs/pictures/car.journal, in pixels.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';

const [program, tree] = process.argv.slice(2).map((word) => path.resolve(word));
const fitCurve = createRequire(`${tree}/site_npm/`)('fit-curve');
const journal = new URL('../../docs/pictures/car.journal', import.meta.url);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'cubics-'));
const file = (name) => path.join(folder, name);
const batten = (...words) => JSON.parse(execFileSync(program, words));

const strokes = [];
for (const line of fs.readFileSync(journal, 'utf8').split('\n').filter((text) => text.startsWith('{"pointer"'))) {
  const { pointer, x, y } = JSON.parse(line);
  if (pointer === 'down') {
    strokes.push([]);
  }
  if (pointer !== 'up') {
    strokes.at(-1).push([x, y]);
  }
}
for (const stroke of strokes) {
  fs.writeFileSync(file('stroke.csv'), stroke.map((place) => `${place}\n`).join(''));
  const fit = batten('fit', file('stroke.csv'), '--tolerance', '0.7');
  fs.writeFileSync(file('fit.json'), JSON.stringify(fit));
  const few = batten('simplify', file('fit.json'), '--tolerance', '0.3', '--continuity', 'G1');
  const error = fit.report.max_error + few.report.max_error;
  console.log(`| ${stroke.length} | ${fitCurve(stroke, 1).length} | ${new Set(few.knots).size - 1} | ${error.toFixed(2)} |`);
}
fs.rmSync(folder, { recursive: true });
