// Builds that follow each other: half an upload is not taken, a cache that lost something is cured, an older tab keeps its own files;
// what was drawn is still there.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { expectFaults, launch, quiet, ready, settle, state, until } from './page.mjs';
import { caches, controlled, kept, said, tryAgain, updated, version } from './starting.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const halves = {
  'the page is still the old one': (server) => { server.stale = { 'index.html': '1' }; },
  'a file is not there yet': (server) => { server.without = /^sheets\/settings\.js$/; },
  'a file is cut off': (server) => { server.spoil = (name, body) => (name === 'batten-later.wasm' ? body.subarray(0, body.length / 2) : body); },
  'a file is another of the same size': (server) => {
    server.spoil = (name, body) => (name === 'icons/arrange.svg' ? Buffer.from(body.toString().replace('s', 't')) : body);
  },
};

for (const [what, halve] of Object.entries(halves)) {
  test(`half an upload, ${what}: the old build stays whole, and the new one is taken when it is`, async (t) => {
    const { server, page, drawn } = await kept(t, browser);
    server.version = '2';
    halve(server);
    assert.equal(await updated(page), 'redundant');
    assert.deepEqual(await caches(page), ['1'], 'what is incomplete is thrown away');
    await page.evaluate(() => { batten.files.leaving = true; });
    await page.reload();
    await ready(page);
    assert.equal(await version(page), '1');
    assert.equal((await state(page)).digest, drawn);
    await page.evaluate(() => { batten.files.leaving = true; });
    [server.stale, server.without, server.spoil] = [{}, /^$/, (name, body) => body];
    await page.reload();
    await page.waitForSelector('[data-about=update]');
    await Promise.all([page.waitForEvent('load'), page.locator('[data-about=update] button').first().evaluate((one) => one.click())]);
    await ready(page);
    assert.equal(await version(page), '2');
    assert.equal((await state(page)).digest, drawn);
  });
}

/** Takes files from what the browser has cached. @param {string} pattern of their names */
const lose = (page, pattern) => page.evaluate(async (lost) => {
  for (const name of await globalThis.caches.keys()) {
    const cache = await globalThis.caches.open(name);
    for (const request of (await cache.keys()).filter(({ url }) => new RegExp(lost).test(url))) {
      await cache.delete(request);
    }
  }
  batten.files.leaving = true;
}, pattern);

test('a cache that lost a file of a build that is gone: three reloads say so, Try again cures it', async (t) => {
  const { server, page, drawn } = await kept(t, browser);
  await lose(page, 'main\\.js$');
  server.version = '2';
  for (let i = 0; i < 3; i++) {
    await page.reload();
    assert.match(await said(page), /main\.js/);
  }
  await tryAgain(page);
  assert.equal(await version(page), '2');
  assert.equal((await state(page)).digest, drawn, 'what was drawn is kept');
  await controlled(page);
  assert.deepEqual(await caches(page), ['2']);
});

test('a cache that lost the page: the page of the server comes, whole', async (t) => {
  const { server, page, drawn } = await kept(t, browser);
  await lose(page, '.');
  server.version = '2';
  await page.reload();
  await ready(page);
  assert.equal(await version(page), '2');
  assert.equal((await state(page)).digest, drawn);
});

test('without a server Try again forgets nothing', async (t) => {
  const { server, page } = await kept(t, browser);
  expectFaults(/ERR_FAILED/);
  await lose(page, 'main\\.js$');
  server.close();
  await page.reload();
  await said(page);
  await Promise.all([page.waitForEvent('load'), page.click('#failed-again')]);
  assert.match(await said(page), /main\.js/);
  assert.deepEqual(await caches(page), ['1']);
});

test('an order to forget: no worker and nothing cached, but what was drawn', async (t) => {
  const { page, drawn } = await kept(t, browser);
  await page.evaluate(() => navigator.serviceWorker.controller.postMessage('forget'));
  await until(page, async () => !await navigator.serviceWorker.getRegistration() && (await globalThis.caches.keys()).length === 0);
  await page.evaluate(() => { batten.files.leaving = true; });
  await page.reload();
  await ready(page);
  assert.equal((await state(page)).digest, drawn);
});

test('a tab older than an update gets its parts from its own build, as long as it is there', async (t) => {
  const { server, context, page } = await kept(t, browser);
  const other = await context.newPage();
  await other.goto(server.address);
  await ready(other);
  server.version = '2';
  assert.equal(await updated(other), 'installed');
  await Promise.all([other.waitForEvent('load'), other.click('[data-about=update] button')]);
  await ready(other);
  assert.equal(await version(other), '2');
  assert.equal(await version(page), '1');
  assert.deepEqual(await caches(other), ['1', '2']);
  await page.bringToFront();
  await page.waitForSelector('[data-about=update]'); // the other tab has switched to it
  for (const name of ['menu', 'settings']) { // fetched when they are first opened
    await page.click(`[data-name=${name}]`);
    await page.waitForSelector(`#${name} > *`);
    await page.keyboard.press('Escape');
    await quiet(page);
  }
  assert.equal(await page.locator('[data-about=missing]').count(), 0);
  // Another reload of the new one leaves the old one its files; without the old tab they go.
  await other.evaluate(() => { batten.files.leaving = true; });
  await other.reload();
  await ready(other);
  await settle(other);
  assert.deepEqual(await caches(other), ['1', '2']);
  await page.evaluate(() => { batten.files.leaving = true; });
  await page.close();
  await until(other, async () => !(await navigator.locks.query()).held.some(({ name }) => name.endsWith(' 1')));
  await other.evaluate(() => { batten.files.leaving = true; });
  await other.reload();
  await ready(other);
  await until(other, async () => (await globalThis.caches.keys()).length === 1);
  assert.deepEqual(await caches(other), ['2']);
});

test('a build that waits is not swept away by the one before', async (t) => {
  const { server, page } = await kept(t, browser);
  server.version = '2';
  assert.equal(await updated(page), 'installed');
  await page.evaluate(() => navigator.serviceWorker.controller.postMessage('sweep'));
  await page.evaluate(() => { batten.files.leaving = true; });
  await page.reload();
  await page.waitForSelector('[data-about=update]');
  await settle(page);
  assert.deepEqual(await caches(page), ['1', '2']);
});
