// The site: the editor as a static host serves it, from Python's file server under a sub-path. No request leaves its
// folder; its policy, which no header sends, is obeyed (page.mjs counts what it refuses as errors); it opens offline.
// The ghost pen leaves nothing in the drawing. The race fetches its two libraries, and no other page does.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import zlib from 'node:zlib';
import { bezier, expectFaults, Hand, launch, place, quiet, ready, SCREENSHOTS, state } from './page.mjs';
import { buildSite, serveSite, SITE } from './static.mjs';

let browser;
let site;
before(async () => {
  buildSite();
  [browser, site] = await Promise.all([launch(), serveSite()]);
});
after(async () => {
  await browser.close();
  await site.close();
});

/** A page of the site; every request of it is noted, and must stay in the folder. */
async function visit(address = '', options = {}, host = site) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const asked = [];
  context.on('request', (request) => asked.push(request.url()));
  const page = await context.newPage();
  const open = async (where) => {
    await page.goto(host.address + where);
    await ready(page);
    await page.waitForFunction(() => globalThis.race ?? batten.painter.painted);
  };
  await open(address);
  const stays = () => assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(host.address)), []);
  return { context, page, asked, open, stays, hand: new Hand(page, await context.newCDPSession(page)) };
}

const turn = (page) => page.waitForSelector('html[data-turn=yes]');
const lines = (page) => page.evaluate(() => new TextDecoder().decode(batten.engine.journal).trim().split('\n').length);
const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const ROOF = bezier([388, 176], [460, 90], [700, 60], [842, 169]);
const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `site-${name}.png`) });

test('two sites of one origin leave each other their caches', async (t) => {
  const own = await serveSite();
  t.after(() => own.close());
  const { page, open } = await visit('', {}, own);
  const active = () => page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  const names = () => page.evaluate(async () => (await caches.keys()).sort());
  await active();
  const [first] = await names();
  assert.ok(first.startsWith(`batten ${own.address} `));
  // What an earlier build of the other has left goes when the other becomes active; what is of this one stays.
  await page.evaluate((other) => caches.open(`batten ${other} 0123456789abcdef`), own.other);
  await page.evaluate(() => batten.pack());
  await page.goto(own.other);
  await ready(page);
  await active();
  assert.deepEqual(await names(), [first.replace(own.address, own.other), first].sort());
  await page.evaluate(() => batten.pack());
  expectFaults(/ERR_CONNECTION_REFUSED/, /Failed to fetch/);
  await own.close();
  await open(''); // without the server
});

test('the editor is the front page; a touch stops the ghost, which leaves nothing; it opens offline', async (t) => {
  const own = await serveSite();
  t.after(() => own.close());
  const { page, asked, open, stays, hand } = await visit('', {}, own);
  assert.equal(await page.textContent('#name'), 'car.svg');
  assert.match(await page.getAttribute('meta[http-equiv=Content-Security-Policy]', 'content'), /default-src 'none'/);
  await page.waitForSelector('.ghost-pen.down', { state: 'attached' });
  const before = await state(page);
  await shot(page, 'ghost');
  // The touch that stops it draws at once: the visitor's stroke, and only that, is in the history.
  await hand.stroke(await on(page, ROOF));
  assert.equal(await page.locator('.ghost').count(), 0);
  assert.match(await page.textContent('.front p'), /Your turn: draw a new roof/);
  assert.notEqual((await state(page)).digest, before.digest);
  await page.keyboard.press('Control+Z');
  assert.equal((await state(page)).digest, before.digest);
  assert.equal(await page.evaluate(() => glance().canUndo), false);
  assert.equal(await lines(page), 3, 'the drawing, the stroke, undo');
  await page.keyboard.press('Control+Shift+Z');
  const drawn = (await state(page)).digest;
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  await page.evaluate(() => batten.engine.set('tolerance', 2));
  await page.evaluate(() => batten.wake());
  await page.waitForFunction(() => JSON.parse(localStorage.getItem('batten-settings') ?? '{}').values?.tolerance === 2);
  await page.evaluate(() => batten.pack());
  stays();
  assert.deepEqual(asked.filter((url) => url.includes('/peers/')), []);

  // Without its server: the drawing as it was left, then the drawings to begin with.
  expectFaults(/ERR_CONNECTION_REFUSED/, /Failed to fetch/, /ERR_FAILED .*\/peers\//);
  await own.close();
  await open('');
  assert.equal((await state(page)).digest, drawn, 'kept as today');
  await page.waitForFunction(() => document.fonts.check('13px "Batten-Inter"') && document.fonts.size === 1);
  assert.equal(await page.evaluate(() => batten.engine.get('tolerance')), 2, 'settings, too');
  await page.evaluate(() => batten.pack());
  await open('race.html');
  assert.equal(await page.locator('tbody tr').count(), 1);
  assert.equal(await page.isVisible('#missing'), true);
});

test('the licence of the type face is beside it', () => {
  const [fonts] = fs.readdirSync(SITE).map((name) => path.join(SITE, name, 'fonts')).filter((folder) => fs.existsSync(folder));
  assert.deepEqual(fs.readdirSync(fonts).sort(), ['OFL.txt', 'inter.woff2']);
});

test('what the page loads first is small', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  const answers = new Map();
  page.on('response', (response) => answers.set(response.url(), response));
  await page.addInitScript(() => new MutationObserver(() => performance.mark('ready'))
    .observe(document, { subtree: true, attributeFilter: ['data-ready'] }));
  await page.goto(site.address);
  await ready(page);
  const early = await page.evaluate(() => performance.getEntriesByType('resource')
    .filter((entry) => entry.startTime < performance.getEntriesByName('ready')[0].startTime).map((entry) => entry.name));
  const once = new Set([site.address, ...early]); // the second time the browser has it: a transfer of 0 bytes
  const sizes = await Promise.all([...once].map(async (url) =>
    zlib.gzipSync(await answers.get(url).body(), { level: 9 }).length));
  const total = sizes.reduce((sum, size) => sum + size, 0);
  console.log(`first load of the site: ${total} bytes gzip, ${sizes.length} files`);
  assert.ok(sizes.length > 20 && total < 200000, `${total}`);
});

test('less motion: it waits to be asked; a ghost drags the crocodile and gives it back', async () => {
  const { page, stays } = await visit('#play=demos/crocodile.journal', { reducedMotion: 'reduce', viewport: { width: 390, height: 844 } });
  await turn(page);
  assert.equal(await page.locator('.ghost').count(), 0);
  const before = (await state(page)).digest;
  await page.click('.front .told button');
  await page.waitForSelector('.ghost-pen.down', { state: 'attached' });
  assert.notEqual(await page.evaluate(() => front.ghost.engine.digest()), undefined);
  await page.evaluate(() => { front.ghost.length = 0; });
  await page.waitForFunction(() => !document.querySelector('.ghost'));
  assert.equal((await state(page)).digest, before);
  assert.match(await page.textContent('.front p'), /pull the back or the tail/);
  await shot(page, 'crocodile');
  stays();
});

test('#open= and #journal=, of this server alone', async () => {
  const { page, stays } = await visit('#journal=demos/car.journal');
  assert.equal(await page.evaluate(() => batten.engine.digest()), await page.evaluate(async () => {
    const bytes = new Uint8Array(await (await fetch('demos/car.journal')).arrayBuffer());
    batten.engine.replay(bytes);
    return batten.engine.digest();
  }));
  assert.equal(await page.evaluate(() => glance().canUndo), true);
  await page.evaluate(() => { globalThis.before = true; location.hash = '#open=demos/car.svg'; });
  await page.waitForFunction(() => !globalThis.before && globalThis.batten?.files.name === 'car.svg' && document.documentElement.dataset.ready === 'yes');
  await page.evaluate(() => { location.hash = '#open=https://example.org/car.svg'; });
  await page.waitForFunction(() => /example\.org/.test(document.getElementById('notice-text')?.textContent ?? ''));
  stays();
});

test('the race counts three fits of a stroke', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, hand, stays, asked } = await visit('race.html', { colorScheme });
    await page.waitForFunction(() => document.querySelectorAll('tbody tr').length === 3);
    assert.equal(asked.filter((url) => /\/peers\/[\w.-]+\.js$/.test(url)).length, 2);
    const box = await page.locator('#canvas').boundingBox();
    await hand.stroke(bezier([box.x + 60, box.y + 250], [box.x + 200, box.y - 40], [box.x + 420, box.y + 460], [box.x + 700, box.y + 60]), { pointerType: 'mouse' });
    await quiet(page);
    const rows = await page.$$eval('tbody tr', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map(([name]) => name), ['Batten', 'fit-curve', 'paper.js']);
    for (const [, pieces, points, error] of rows) {
      assert.ok(Number(pieces) >= 1 && Number(pieces) < 40 && Number(points) > Number(pieces), `${rows}`);
      assert.ok(Number(error) > 0 && Number(error) < 4, `${rows}`);
    }
    await shot(page, `race-${colorScheme}`);
    const ring = Array.from({ length: 60 }, (_, i) => [box.x + 440 + 260 * Math.cos(i / 9.4), box.y + 180 + 130 * Math.sin(i / 9.4)]);
    await hand.stroke(ring, { pointerType: 'mouse' });
    await quiet(page);
    const [[pieces, , error]] = await page.$$eval('tbody tr', (all) => all.map((row) => [...row.children].slice(1).map((cell) => Number(cell.textContent))));
    assert.ok(pieces >= 2 && error > 0 && error < 4, `a closed stroke: ${pieces} pieces, ${error} px`);
    stays();
  }
});
