// label: smoke. The first load: all that the program serves until the page is ready, before any input, is at most 200 kB with gzip.
// The second part of the module and what the inspector shows follow when the page has been painted.
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
  t.after(() => program.close()); // also after a failure: the runner waits for open handles
  const page = await browser.newPage();
  const answers = [];
  page.on('response', (response) => {
    if (response.ok() && response.url().startsWith('http') && new URL(response.url()).pathname !== '/document') {
      answers.push(response);
    }
  });
  const nameOf = (url) => new URL(url).pathname.replace(/^\/[0-9a-f]{16}/, '');
  const later = '/batten-later.wasm'; // requested before the page is ready: record first.txt anew, first_part.mjs
  const beside = /^\/(sheets\/(options|flyout|menu|inspector|objects|layers|numbers|page_size|style|swatches|scrub|thumbnail)\.js|styles\/(inspector|style|options)\.css|page\/(face|papers)\.js|fonts\/inter\.woff2|icons\/arrange\.svg)$/;
  await page.addInitScript(() => new MutationObserver(() => performance.mark('ready'))
    .observe(document, { subtree: true, attributeFilter: ['data-ready'] }));
  await page.goto(program.address);
  await ready(page);
  await page.waitForLoadState('networkidle');
  const late = new Set(await page.evaluate(() => performance.getEntriesByType('resource')
    .filter(({ startTime }) => startTime > performance.getEntriesByName('ready')[0].startTime).map(({ name }) => name)));
  const sizes = await Promise.all(answers.filter((response) => nameOf(response.url()) === later || !late.has(response.url())).map(async (response) =>
    [nameOf(response.url()), zlib.gzipSync(await response.body(), { level: 9 }).length]));
  const first = sizes.filter(([name]) => name !== later && !beside.test(name)).sort((a, b) => b[1] - a[1]);
  const total = first.reduce((sum, [, size]) => sum + size, 0);
  console.log(`first load: ${total} bytes gzip: ${first.map(([name, size]) => `${name} ${size}`).join(', ')}`);
  console.log(`after it: ${sizes.filter(([name]) => name === later).map(([name, size]) => `${name} ${size}`)}`);
  assert.ok(first.length > 5 && first.some(([name]) => name === '/batten.wasm'));
  assert.ok(total < 200000);
  const [asked, shown] = await page.evaluate((names) => [
    Math.min(...names.map((name) => performance.getEntriesByType('resource').find((entry) => entry.name.endsWith(name))?.startTime)),
    performance.getEntriesByName('ready')[0].startTime], [later, '/sheets/inspector.js']);
  assert.ok(asked >= shown, `the second part is asked for after ${asked} ms, the page is ready after ${shown} ms`);
});
