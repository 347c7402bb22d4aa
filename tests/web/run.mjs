// Runs the browser tests: node run.mjs [FILE...]. The last line is "N passed, N failed".
// Reads the runner's events itself, because node 18 and later versions construct reporters differently.
import fs from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { fileURLToPath } from 'node:url';

const HANG = 3600000; // milliseconds: a file that takes longer counts as hanging, however busy the machine
const HERE = path.dirname(fileURLToPath(import.meta.url));

const asked = process.argv.slice(2).map((file) => path.resolve(file));
const all = fs.readdirSync(HERE).filter((file) => file.endsWith('.test.mjs')).map((file) => path.join(HERE, file));
let passed = 0;
/** What failed, and the first lines of why. @type {string[]} */
const failed = [];

// What reads well in a test and is wrong. A frame that a test takes from the engine is one that the page does not paint.
const WRONG = [[/engine\.frame\(/, 'takes a frame from the page: use glance()'],
  [/waitForFunction\(async/, 'waits for a promise, which is true at once: use until()']];
for (const file of all) {
  for (const [pattern, why] of WRONG.filter(([pattern]) => pattern.test(fs.readFileSync(file, 'utf8')))) {
    failed.push(`${path.basename(file)}: ${pattern}`);
    console.log(`FAIL  ${path.basename(file)} ${why}`);
  }
}

/** The error of a failed test, without the runner's wrapping. */
function reason({ error }) {
  const cause = error?.cause ?? error ?? 'skipped';
  return String(cause?.stack ?? cause).replace(/^/gm, '    ');
}

for await (const { type, data } of run({ files: asked.length > 0 ? asked : all.sort(), concurrency: 2, timeout: HANG })) {
  if (type === 'test:pass' && data.skip === undefined) {
    passed++;
    console.log(`ok    ${data.name} (${Math.round(data.details.duration_ms)} ms)`);
  } else if (type === 'test:pass' || type === 'test:fail') {
    failed.push(`${data.name}\n${reason(data.details).split('\n').slice(0, 6).join('\n')}`); // a skipped test should have run
    console.log(`FAIL  ${data.name} (${Math.round(data.details.duration_ms)} ms)\n${reason(data.details)}`);
  } else if (type === 'test:stdout' || type === 'test:stderr') {
    process.stdout.write(data.message);
  }
}
failed.forEach((what) => console.log(`Failed: ${what}`)); // once more: the log is long, and its end is what is read
console.log(`${passed} passed, ${failed.length} failed`);
process.exitCode = failed.length === 0 && passed > 0 ? 0 : 1;
