// Without a network: the page is installable, opens when its server has stopped, and says when a newer build is ready.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { bezier, launch, launchAt, open, place, ready, SCREENSHOTS, settle, state, until } from './page.mjs';
import { edit, EXAMPLE, PROGRAM, serve } from './server.mjs';

const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);
const WEB = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../web');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const controlled = (page) => page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
const tokenOf = (page) => page.getAttribute('meta[name=batten-token]', 'content');

/** Everything that the browser has cached of the shell: addresses and contents. */
const cached = (page) => page.evaluate(async () => {
  const found = {};
  for (const name of await caches.keys()) {
    const cache = await caches.open(name);
    for (const request of await cache.keys()) {
      found[new URL(request.url).pathname] = await (await cache.match(request)).text();
    }
  }
  return found;
});

function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

test('the page opens when its server is gone; a token is never kept', async (t) => {
  const port = String(await freePort());
  let server = await edit(fs.readFileSync(EXAMPLE), 'car.svg', '--port', port);
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await controlled(page);
  const first = await tokenOf(page);
  assert.match(first, /^[0-9a-f]{32}$/);
  const shell = await cached(page);
  assert.ok(shell['/index.html'].includes('%TOKEN%') && shell['/manifest.webmanifest']);
  const parts = Object.keys(shell).map((where) => where.slice(1).split('/')).filter(([, name]) => name);
  assert.deepEqual(['main.js', 'words.ko.json', 'batten-later.wasm'].filter((file) => !parts.some(([, name]) => name === file)), []);
  assert.equal(new Set(parts.map(([build]) => build)).size, 1, 'of one build');
  assert.equal(shell['/'], undefined);
  assert.equal(shell['/document'], undefined);
  assert.ok(!JSON.stringify(shell).includes(first), 'no token in what is kept');
  // The file can be opened and saved through the service worker too.
  await page.reload();
  await ready(page);
  assert.equal(await tokenOf(page), first);
  await hand.stroke(await on(page, SKY));
  const drawn = await state(page);
  await page.evaluate(() => batten.keeper.settled());
  await page.evaluate(() => { batten.files.leaving = true; });
  server.close();
  await page.waitForFunction(() => fetch('/', { cache: 'no-store' }).then(() => false, () => true));

  await page.reload();
  await ready(page);
  assert.equal(await tokenOf(page), '%TOKEN%');
  const alone = await state(page);
  assert.equal(alone.digest, drawn.digest, 'the drawing as it was left');
  assert.equal(await page.textContent('#name'), 'car.svg');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'offline.png') });
  await hand.stroke(await on(page, SKY.map(([x, y]) => [x, y + 330])));
  const more = await state(page);
  assert.notEqual(more.digest, drawn.digest);
  await page.evaluate(() => { batten.files.leaving = true; return batten.keeper.settled(); });

  // The program restarted at the same address: its new token reaches the page, and work done offline is restored.
  server = await edit(fs.readFileSync(EXAMPLE), 'car.svg', '--port', port);
  await page.reload();
  await ready(page);
  const second = await tokenOf(page);
  assert.match(second, /^[0-9a-f]{32}$/);
  assert.notEqual(second, first);
  assert.equal((await state(page)).digest, more.digest);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.ok(server.bytes.length > fs.readFileSync(EXAMPLE).length / 2);
  assert.ok(!JSON.stringify(await cached(page)).includes(second));
  await context.close();
});

test('an address of one start keeps nothing', async (t) => {
  const server = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  await settle(page);
  assert.deepEqual(await page.evaluate(async () => [
    (await navigator.serviceWorker.getRegistrations()).length, (await caches.keys()).length,
    document.querySelectorAll('link[rel=manifest]').length]), [0, 0, 0]);
  await context.close();
});

test('another program at the address is shown, and Batten leaves', async (t) => {
  const server = await serve(undefined, true);
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  await controlled(page);
  server.stranger = '<!doctype html><title>Stranger</title>';
  await page.goto(server.address);
  assert.equal(await page.title(), 'Stranger');
  await page.waitForFunction(() => navigator.serviceWorker.getRegistrations().then((list) => list.length === 0));
  await context.close();
});

test('a newer version is offered, not slipped in; unsaved work goes along', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) }, true);
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await controlled(page);
  const version = () => page.evaluate(() => document.querySelector('script[src]').getAttribute('src').split('/')[0]);
  await page.reload();
  await ready(page);
  assert.equal(await version(), '1');
  server.version = '2';
  await page.reload();
  await page.waitForSelector('[data-about=update]');
  await settle(page);
  assert.equal(await version(), '1', 'still the old one');
  assert.match(await page.textContent('[data-about=update] span'), /new version of Batten is ready/);
  await hand.stroke(await on(page, SKY));
  const drawn = await state(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'update.png') });
  await page.emulateMedia({ colorScheme: 'dark' });
  await settle(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'update-dark.png') });
  await Promise.all([page.waitForEvent('load'), page.click('[data-about=update] button')]);
  await ready(page);
  assert.equal(await version(), '2');
  assert.equal((await state(page)).digest, drawn.digest);
  assert.equal(await page.isVisible('[data-about=update]'), false);
  await until(page, async () => (await caches.keys()).length === 1);
  assert.deepEqual(await page.evaluate(() => caches.keys()), [`batten ${server.address} 2`]);
  await context.close();
});

test('it can be installed; its icons are what the program draws of them', async (t) => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-profile-'));
  const server = await serve(undefined, true);
  const context = await launchAt(profile);
  t.after(async () => {
    await context.close();
    server.close();
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  });
  const page = await context.newPage();
  await page.goto(server.address);
  await ready(page);
  await controlled(page);
  const client = await context.newCDPSession(page);
  const manifest = await client.send('Page.getAppManifest');
  assert.deepEqual(manifest.errors, []);
  const { installabilityErrors } = await client.send('Page.getInstallabilityErrors');
  assert.deepEqual(installabilityErrors, []);
  const { icons } = JSON.parse(manifest.data);
  for (const { src, type } of icons) {
    const response = await page.request.get(server.address + src);
    assert.equal(response.headers()['content-type'], type);
  }
  for (const size of [192, 512]) {
    const drawn = path.join(profile, 'icon.png');
    spawnSync(PROGRAM, ['render', path.join(WEB, 'icons/app.svg'), drawn, '--size', `${size}x${size}`, '--background', 'none']);
    assert.ok(fs.readFileSync(drawn).equals(fs.readFileSync(path.join(WEB, `icons/app-${size}.png`))));
  }
});
