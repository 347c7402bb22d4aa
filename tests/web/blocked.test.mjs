// What a browser may not allow: the page starts and draws whatever is missing, and work that it does not keep is said to be unkept.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { WINDOWED } from './chromium.mjs';
import { bezier, expectFaults, Hand, launch, launchAt, place, quiet, ready, SCREENSHOTS, settle, state, until } from './page.mjs';
import { serve } from './server.mjs';

const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);
const VIEWPORT = { width: 1280, height: 800 };

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const notices = (page) => page.evaluate(() => Object.fromEntries([...document.querySelectorAll('#asked .notice')]
  .map((notice) => [notice.dataset.about, notice.innerText])));

async function visit(context, address) {
  const page = await context.newPage();
  await page.goto(address);
  await ready(page);
  return { page, hand: new Hand(page, await context.newCDPSession(page)) };
}

/** Draws, and sees that it is drawn. @returns {Promise<string>} the drawing's digest */
async function draw({ page, hand }) {
  const before = (await state(page)).digest;
  await hand.stroke(await Promise.all(SKY.map(([x, y]) => place(page, x, y))));
  const { digest, check } = await state(page);
  assert.notEqual(digest, before);
  assert.equal(check, '');
  await page.evaluate(() => batten.keeper.settled());
  await settle(page);
  return digest;
}

/** A drawing is brought back by a reload, or the page says that it would not be and offers a copy of it. */
async function keptOrSaid({ page }, drawn) {
  const { unkept } = await notices(page);
  if (unkept !== undefined) {
    assert.match(unkept, /does not keep unsaved work|no room[^]*unsaved work/);
    const download = page.waitForEvent('download');
    await page.click('[data-about=unkept] >> text=copy');
    assert.match((await download).suggestedFilename(), /\.svg$/);
    return 'said';
  }
  await page.evaluate(() => { batten.files.leaving = true; });
  await page.reload();
  await ready(page);
  assert.equal((await state(page)).digest, drawn);
  return 'kept';
}

/** Opens what is fetched late: nothing of it may need what is missing. */
async function tour(page) {
  for (const name of ['menu', 'settings']) {
    await page.click(`[data-name=${name}]`);
    await page.waitForSelector(`#${name} > *`);
    await page.keyboard.press('Escape');
  }
  await quiet(page);
  assert.equal(await page.locator('[data-about=missing]').count(), 0);
}

test('all site data is blocked: the page draws, and says that it keeps nothing', async (t) => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-profile-'));
  fs.mkdirSync(path.join(profile, 'Default'));
  fs.writeFileSync(path.join(profile, 'Default/Preferences'), JSON.stringify({ profile: { default_content_setting_values: { cookies: 2 } } }));
  const server = await serve(undefined, true);
  const context = await launchAt(profile, { executablePath: WINDOWED });
  t.after(async () => {
    await context.close();
    server.close();
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  });
  const first = await visit(context, server.address);
  assert.equal(await first.page.evaluate(() => {
    try {
      return localStorage.length;
    } catch (error) {
      return error.name;
    }
  }), 'SecurityError', 'it is blocked');
  const drawn = await draw(first);
  assert.equal(await first.page.isVisible('#failed'), false);
  await first.page.screenshot({ path: path.join(SCREENSHOTS, 'blocked.png') });
  assert.equal(await keptOrSaid(first, drawn), 'said');
  await tour(first.page);
  // A second tab holds its drawing, too: nobody could tell it of the first.
  const second = await visit(context, server.address);
  await draw(second);
  assert.equal(await second.page.evaluate(() => batten.tabs.held), true);
});

for (const locale of ['en', 'ko-KR']) {
  test(`http beyond the loopback: the page draws, and names https, ${locale}`, async (t) => {
    const server = await serve(undefined, true);
    t.after(() => server.close());
    const context = await browser.newContext({ viewport: VIEWPORT, locale });
    await context.route('http://batten.test/**', async (route) => {
      const fetched = () => route.fetch({ url: route.request().url().replace('http://batten.test/', server.address) });
      const response = await fetched().catch(fetched).catch(() => null); // a connection that was kept may be closed by now
      await (response ? route.fulfill({ response }) : route.abort()).catch(() => {}); // and so may the page
    });
    const first = await visit(context, 'http://batten.test/');
    assert.equal(await first.page.evaluate(() => isSecureContext), false);
    await first.page.waitForSelector('[data-about=insecure] >> text=https');
    const drawn = await draw(first);
    await first.page.screenshot({ path: path.join(SCREENSHOTS, `insecure-${locale}.png`) });
    await tour(first.page);
    if (locale === 'en') {
      await keptOrSaid(first, drawn);
    }
    const second = await visit(context, 'http://batten.test/');
    await draw(second);
  });
}

/** What takes something from the page and from its workers. */
const missing = {
  'no locks': () => Object.defineProperty(navigator, 'locks', { value: undefined }),
  'locks that are refused': () => { LockManager.prototype.request = async () => { throw new DOMException('denied', 'SecurityError'); }; },
  'locks that throw': () => { LockManager.prototype.request = () => { throw new DOMException('denied', 'SecurityError'); }; },
  'no channel between tabs': () => { delete globalThis.BroadcastChannel; },
  'a channel that throws': () => { globalThis.BroadcastChannel = class { constructor() { throw new DOMException('denied', 'SecurityError'); } }; },
  'no service worker': () => globalThis.Navigator && delete Navigator.prototype.serviceWorker,
  'no digests': () => Object.defineProperty(crypto, 'subtle', { value: undefined }),
  'no private files': () => { delete StorageManager.prototype.getDirectory; },
  'private files that are refused': () => {
    StorageManager.prototype.getDirectory = async () => { throw new DOMException('denied', 'SecurityError'); };
  },
  'no storage at all': () => Object.defineProperty(navigator, 'storage', { value: undefined }),
  'no IndexedDB': () => { delete globalThis.indexedDB; },
  'an IndexedDB that throws': () => { IDBFactory.prototype.open = () => { throw new DOMException('denied', 'SecurityError'); }; },
  'neither private files nor IndexedDB': () => {
    delete StorageManager.prototype.getDirectory;
    IDBFactory.prototype.open = () => { throw new DOMException('denied', 'SecurityError'); };
  },
  'no local storage': () => globalThis.document && Object.defineProperty(globalThis, 'localStorage', {
    get: () => { throw new DOMException('denied', 'SecurityError'); } }),
};

/** Where what is taken is asked for by what keeps the page's files, they are kept. */
const LASTING = ['no locks', 'no service worker', 'no digests', 'no storage at all'];

for (const [what, take] of Object.entries(missing)) {
  test(`${what}: the page draws, and what it does not keep it says`, async (t) => {
    const server = await serve(undefined, LASTING.includes(what));
    t.after(() => server.close());
    const lost = `try { (${take})(); } catch { } // a blank page and a worker may not have had it\n`;
    server.spoil = (name, body) => (/^keep\/.*\.js$/.test(name) ? Buffer.from(lost + body) : body);
    const context = await browser.newContext({ viewport: VIEWPORT });
    await context.addInitScript(lost);
    const first = await visit(context, server.address);
    const how = await keptOrSaid(first, await draw(first));
    if (what.startsWith('neither')) {
      assert.equal(how, 'said');
    }
    if (/lock|channel/.test(what)) {
      await draw(await visit(context, server.address));
    }
  });
}

test('two tabs without a channel: the second takes the drawing, and the first learns it', async (t) => {
  const server = await serve({ name: 'some.svg', bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 600"/>') });
  t.after(() => server.close());
  const context = await browser.newContext({ viewport: VIEWPORT });
  await context.addInitScript(missing['no channel between tabs']);
  const first = await visit(context, server.address);
  const drawn = await draw(first);
  const second = await visit(context, server.address);
  await second.page.waitForSelector('[data-about=owner] >> text=open in another tab');
  await second.page.click('[data-about=owner] button');
  await second.page.waitForSelector('[data-about=kept] >> text=brought back');
  await settle(second.page);
  assert.equal((await state(second.page)).digest, drawn);
  await first.page.waitForSelector('[data-about=owner] >> text=open in another tab');
});

test('a quota of 1 MB: what has no room is said, and the page draws on', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const context = await browser.newContext({ viewport: VIEWPORT });
  const first = await visit(context, server.address);
  const { page, hand } = first;
  await hand.client.send('Storage.overrideQuotaForOrigin', { origin: new URL(server.address).origin, quotaSize: 1 << 20 });
  await draw(first);
  assert.equal((await notices(page)).unkept, undefined, 'there is room');
  const path = (i) => `<path d="M0 ${i}${' c1.25 2.125 3.375 4.0625 5.03125 1.015625'.repeat(300)}" fill="none" stroke="black"/>`;
  await page.evaluate((text) => {
    void batten.files.arrive([{ file: new File([text], 'large.svg'), place: null }]);
  }, `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 600">${Array.from({ length: 100 }, (_, i) => path(i)).join('')}</svg>`);
  await page.click('dialog >> text=Discard changes and open >> nth=-1');
  await page.waitForFunction(() => document.getElementById('name').textContent === 'large.svg');
  assert.equal(await keptOrSaid(first, await draw(first)), 'said');
});

test('a quota without room for the files of the page: nothing of them takes the room of a drawing', async (t) => {
  const server = await serve(undefined, true);
  t.after(() => server.close());
  const context = await browser.newContext({ viewport: VIEWPORT });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send('Storage.overrideQuotaForOrigin', { origin: new URL(server.address).origin, quotaSize: 1 << 20 });
  await page.goto(server.address);
  await ready(page);
  await until(page, async () => !await navigator.serviceWorker.getRegistration() && (await caches.keys()).length === 0);
  await draw({ page, hand: new Hand(page, client) });
});
