// Runs the browser tests: node run.mjs [FILE...]. The last line is "N passed, N failed".
import fs from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { spec } from 'node:test/reporters';
import { fileURLToPath } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

const asked = process.argv.slice(2).map((file) => path.resolve(file));
const all = fs.readdirSync(HERE).filter((file) => file.endsWith('.test.mjs')).map((file) => path.join(HERE, file));
let passed = 0;
let failed = 0;

const stream = run({ files: asked.length > 0 ? asked : all.sort(), concurrency: 1, timeout: 240000 });
stream.on('test:pass', () => passed++);
stream.on('test:fail', () => failed++);
stream.compose(spec).pipe(process.stdout);
stream.on('end', () => {
  setImmediate(() => {
    process.stdout.write(`\n${passed} passed, ${failed} failed\n`);
    process.exitCode = failed === 0 && passed > 0 ? 0 : 1;
  });
});
