// The first load: all that the program serves until the page is ready and nobody has touched it, gzip: 200 kB at most.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import zlib from 'node:zlib';
import { launch, ready } from './page.mjs';
import { EXAMPLE, edit } from './server.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

test('the first load is small', async (t) => {
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close()); // also when it fails: the runner waits for what is open
  const page = await browser.newPage();
  const answers = [];
  page.on('response', (response) => {
    if (response.ok() && response.url().startsWith('http') && new URL(response.url()).pathname !== '/document') {
      answers.push(response);
    }
  });
  await page.goto(program.address);
  await ready(page);
  await page.waitForLoadState('networkidle');
  const sizes = await Promise.all(answers.map(async (response) =>
    [new URL(response.url()).pathname, zlib.gzipSync(await response.body(), { level: 9 }).length]));
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  sizes.sort((a, b) => b[1] - a[1]);
  console.log(`first load: ${total} bytes gzip: ${sizes.map(([path, size]) => `${path} ${size}`).join(', ')}`);
  const later = '/batten-later.wasm'; // when this is asked for, something in web/module/later.txt is called too early
  assert.ok(!sizes.some(([path]) => path === later));
  const coming = page.waitForResponse((response) => response.url().endsWith(later));
  await page.mouse.move(400, 400);
  assert.ok((await coming).ok());
  assert.ok(sizes.length > 5 && sizes.some(([path]) => path === '/batten.wasm'));
  assert.ok(total < 200000);
});
