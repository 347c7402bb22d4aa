// The files of one build belong together: a missing file, or one of another build, is reported with a way out.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, expectFaults, GONE, launch, open, place, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, MODULE, serve } from './server.mjs';

const ROOF = bezier([440, 137], [490, 103], [560, 92], [690, 114]);
const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);
const LATER = fs.readFileSync(MODULE.replace(/\.wasm$/, '-later.wasm'));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const car = () => serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));

/** Waits until the page says that it is incomplete; it offers one action. */
async function said(page, text = 'can only be looked at') {
  await page.waitForSelector(`[data-about=missing] >> text=${text}`);
  assert.equal(await page.locator('[data-about=missing] button').count(), 1);
}

async function reloaded(page) {
  await Promise.all([page.waitForEvent('load'), page.click('[data-about=missing] button')]);
  await ready(page);
}

/** The second part with its imports named as by another build. */
function ofAnotherBuild() {
  const name = WebAssembly.Module.imports(new WebAssembly.Module(LATER))[0].module;
  assert.match(name, /^[0-9a-f]{12}$/);
  return Buffer.from(LATER.toString('latin1').replaceAll(name, 'another_made'), 'latin1');
}

const spoils = {
  'not there': null,
  'of another build': ofAnotherBuild(),
  'cut off': LATER.subarray(0, LATER.length / 2),
  'some page': Buffer.from('<!doctype html>'),
};

for (const [how, body] of Object.entries(spoils)) {
  test(`the second part of the module is ${how}: the page says so, and shows the drawing`, async (t) => {
    const server = await car();
    t.after(() => server.close());
    expectFaults(/batten-later\.wasm/, /status of 404/);
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
    await context.route('**/batten-later.wasm', (route) => (body ?
      route.fulfill({ contentType: 'application/wasm', body }) : route.fulfill({ status: 404 })));
    const { page, hand } = await open(context, server.address);
    await said(page); // without any input
    const opened = await state(page);
    // It is read-only: a pen moves the view, keys change nothing, and there is no error.
    const corner = await place(page, 0, 0);
    await hand.stroke(await on(page, SKY));
    await settle(page); // of what came with the pen's lift
    assert.notDeepEqual(await place(page, 0, 0), corner);
    await page.keyboard.press('v');
    await page.keyboard.press('Control+A');
    await page.keyboard.press('ArrowRight');
    await settle(page);
    assert.equal((await state(page)).digest, opened.digest);
    await said(page);
    await page.screenshot({ path: path.join(SCREENSHOTS, 'missing.png') });
    await context.unrouteAll();
    await reloaded(page);
    assert.equal(await page.locator('[data-about=missing]').count(), 0);
    await hand.stroke(await on(page, ROOF));
    assert.notEqual((await state(page)).digest, opened.digest);
  });
}

test('a drawing that is kept is not drawn over by a page that cannot bring it back', async (t) => {
  const server = await car();
  t.after(() => server.close());
  expectFaults(/batten-later\.wasm/, /status of 404/);
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await on(page, SKY));
  const drawn = await state(page);
  await page.evaluate(() => batten.pack());
  server.without = /batten-later/;
  await page.reload();
  await ready(page);
  await said(page);
  await hand.stroke(await on(page, ROOF));
  await page.keyboard.press('Control+S');
  await page.evaluate(() => batten.pack());
  assert.equal(server.saves, 0);
  server.without = /^$/;
  await reloaded(page);
  assert.equal((await state(page)).digest, drawn.digest);
  await context.close();
});

for (const [colorScheme, locale, text] of [['light', 'en', 'Part of Batten'], ['dark', 'ko-KR', 'Batten의 일부']]) {
  test(`a page older than its server says so when it wants more, and is new after it, ${colorScheme}, ${locale}`, async (t) => {
    const server = await car();
    t.after(() => server.close());
    expectFaults(/status of 404/, /Failed to fetch dynamically imported module/, /words\.\w+\.json/, /batten-later\.wasm/);
    const { page, hand, context } = await open(browser, server.address, { colorScheme, locale });
    await page.waitForLoadState('networkidle');
    server.version = '2';
    await hand.stroke(await on(page, SKY));
    const drawn = await state(page);
    await page.click('[data-name=menu]');
    await said(page, text);
    await page.screenshot({ path: path.join(SCREENSHOTS, `missing-${colorScheme}.png`) });
    await reloaded(page);
    assert.match(await page.evaluate(() => document.querySelector('script[src]').src), /\/2\/main\.js$/);
    assert.equal((await state(page)).digest, drawn.digest);
    await page.click('[data-name=menu]');
    await page.waitForSelector('#menu .search');
    await context.close();
  });
}

test('the second part is missing in the midst of a stroke: what was drawn before is not lost', async (t) => {
  const server = await car();
  t.after(() => server.close());
  expectFaults(/batten-later\.wasm/, /status of 404/);
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await on(page, SKY));
  const drawn = await state(page);
  await page.evaluate(() => batten.keeper.settled());
  server.without = /batten-later/;
  await page.evaluate(() => {
    batten.engine.module.second = null; // as if it had not arrived yet
    batten.engine.editor = 0xfffffff0; // it traps, and its journal must be replayed
  });
  expectFaults(/RuntimeError/);
  await hand.stroke(await on(page, ROOF));
  await said(page);
  assert.equal(await page.evaluate(() => batten.engine.dead), true);
  await hand.stroke(await on(page, ROOF)); // no effect, and no error
  server.without = /^$/;
  await reloaded(page);
  assert.equal((await state(page)).digest, drawn.digest);
  await context.close();
});

test('without an answer the page stays: it is better than none', async (t) => {
  const server = await car();
  t.after(() => server.close());
  expectFaults(/status of 404/, ...GONE);
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await on(page, SKY));
  await page.waitForLoadState('networkidle');
  server.close();
  await page.click('[data-name=settings]');
  await said(page, 'some things do not work');
  await page.click('[data-about=missing] button');
  await page.waitForFunction(() => /server stopped/.test(document.getElementById('notice-text').textContent));
  await said(page, 'some things do not work');
  const { digest } = await state(page);
  await hand.stroke(await on(page, ROOF));
  assert.notEqual((await state(page)).digest, digest, 'it still draws');
  await context.close();
});
