// label: smoke. The structure of the page's scripts: files stay short, imports run downwards, what the page starts with is fetched at
// once, and each sheet is fetched separately when it is first opened.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const WEB = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../web');

/** What each room may import; a file fetched later may be of any. @type {Record<string, string[]>} */
const BELOW = {
  page: ['page'],
  engine: ['page', 'engine'],
  stage: ['page', 'engine', 'stage'],
  keep: ['page', 'engine', 'keep'],
  embed: ['page', 'engine', 'keep', 'embed'],
  sheets: ['page', 'engine', 'stage', 'keep', 'sheets'],
  gallery: ['page', 'engine', 'stage', 'keep', 'sheets', 'gallery'],
  export: ['page', 'engine', 'stage', 'keep', 'sheets', 'export'],
  '.': ['page', 'engine', 'stage', 'keep', 'sheets'],
  site: ['page', 'engine', 'stage', 'keep', 'sheets', 'site'],
};

const files = fs.readdirSync(WEB, { recursive: true }).filter((file) => /\.(js|css|html)$/.test(file));
const textOf = (file) => fs.readFileSync(path.join(WEB, file), 'utf8');
const importsOf = (file) => [...textOf(file).matchAll(/^import (?:.*? from )?'(\.[^']+)'/gm)]
  .map(([, from]) => path.join(path.dirname(file), from));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('no file is long, and main.js only wires', () => {
  assert.ok(files.length > 50);
  const long = files.filter((file) => textOf(file).split('\n').length > (file === 'main.js' ? 150 : 401));
  assert.deepEqual(long, []);
});

test('imports run downwards, from room to room', () => {
  const upwards = files.filter((file) => file.endsWith('.js')).flatMap((file) => importsOf(file)
    .filter((from) => !BELOW[path.dirname(file)].includes(path.dirname(from))).map((from) => `${file}: ${from}`));
  assert.deepEqual(upwards, []);
});

test('what main.js stands on is fetched at once, not import by import', () => {
  const whole = new Set();
  const add = (file) => {
    if (!whole.has(file)) {
      whole.add(file);
      importsOf(file).forEach(add);
    }
  };
  add('main.js');
  whole.delete('main.js');
  const preloaded = [...textOf('index.html').matchAll(/modulepreload" href="%BUILD%\/([^"]+)"/g)].map(([, file]) => file);
  assert.deepEqual(preloaded, [...whole].sort());
});

test('the inspector is fetched when the page has been painted, the settings when they are first opened, the commands at the first sign of a user', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, context } = await open(browser, server.address);
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname.slice(3)));
  const already = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname));
  const sheets = { settings: 'settings', menu: 'commands' };
  await page.waitForSelector('#layers-body .layer-row');
  assert.ok(!textOf('index.html').includes('sheets/inspector.js'), 'not with what the page starts with');
  for (const file of Object.values(sheets)) {
    assert.ok(!already.some((where) => where.endsWith(`/sheets/${file}.js`)), `${file} is not there yet`);
  }
  assert.equal(await page.locator('#settings > *').count(), 0);
  asked.length = 0;
  await page.click('[data-name=settings]');
  await page.waitForSelector('#settings > *');
  assert.ok(asked.includes('sheets/settings.js'), `${asked}`);
  await page.waitForFunction(() => batten.requests.commands); // fetched at the first sign of a user: what is typed is searched at once
  asked.length = 0;
  await page.click('[data-name=menu]');
  await page.waitForSelector('#menu:popover-open .search');
  assert.deepEqual(asked, [], 'nothing more for the commands');
  await context.close();
});
