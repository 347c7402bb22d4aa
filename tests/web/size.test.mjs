// The first load, all of it, gzip: 200 kB at most. types.js holds types alone and is not loaded.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import { MODULE } from './server.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));

const WEB = path.resolve(HERE, '../../web');

test('the first load is small', () => {
  const files = fs.readdirSync(WEB, { recursive: true })
    .filter((file) => /\.(html|js|css|svg)$/.test(file) && file !== 'types.js').map((file) => path.join(WEB, file));
  assert.ok(files.length > 10);
  const sizes = [...files, MODULE].map((file) => zlib.gzipSync(fs.readFileSync(file), { level: 9 }).length);
  const total = sizes.reduce((a, b) => a + b);
  console.log(`first load: ${total} bytes gzip, of which ${sizes[sizes.length - 1]} for the module`);
  assert.ok(total < 200000);
});
