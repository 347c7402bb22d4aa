// The chips at the end of a stroke: what else it could mean; a tap, or Tab, chooses a reading; the next stroke settles
// it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, settle, SCREENSHOTS, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const ROOF = bezier([440, 135], [490, 88], [580, 80], [690, 115]);

test('a stroke is read again', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const opened = await state(page);
  await hand.stroke(await Promise.all(ROOF.map(([x, y]) => place(page, x, y))));
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, opened.digest);
  const chips = page.locator('.chips button');
  await chips.first().waitFor();
  const words = await chips.allTextContents();
  assert.ok(words.length >= 2 && words.includes('New line'), `${words}`);
  assert.equal(await page.locator('.chips [aria-pressed=true]').count(), 1);
  assert.match(await page.locator('.chips [aria-pressed=true]').textContent(), /^Redraw/);
  const box = await page.locator('.chips').boundingBox();
  const end = await place(page, 690, 115);
  assert.ok(Math.hypot(box.x - end[0], box.y - end[1]) < 60, 'they stand at the end of the stroke');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'chips.png') });
  await page.locator('.chips button', { hasText: 'New line' }).click();
  await settle(page);
  const fresh = await state(page);
  assert.notEqual(fresh.digest, redrawn.digest);
  assert.equal(fresh.check, '');
  const refit = page.locator('.chips input');
  await refit.waitFor(); // appears when the hand has paused
  assert.equal(await refit.inputValue(), '0.5');
  await page.locator('#stage').focus();
  for (let i = 0; i < 9 && !await page.evaluate(() => document.activeElement.closest('.chips')); i++) {
    await page.keyboard.press('F6');
    await settle(page);
  }
  assert.equal(await page.evaluate(() => document.activeElement.closest('.chips') !== null), true, 'F6 goes there, too');
  await refit.focus();
  const amount = () => page.evaluate(() => batten.engine.readings().amount);
  for (const [key, wanted] of [['End', 1], ['Home', 0]]) {
    await page.keyboard.press(key);
    await settle(page);
    assert.equal(await amount(), wanted, 'the slider refits it');
    assert.equal((await state(page)).check, '');
  }
  assert.equal(await page.evaluate(() => document.activeElement.type), 'range', 'and keeps the focus');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'chips-refit.png') });
  await page.locator('#stage').focus();
  await page.keyboard.press('Shift+Tab');
  await settle(page);
  assert.equal((await state(page)).digest, redrawn.digest, 'and back');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest, 'all of it is one step');
  assert.equal(await page.locator('.chips').isVisible(), false);
  await page.keyboard.press('Control+Shift+z');
  await hand.stroke(await Promise.all(ROOF.map(([x, y]) => place(page, x, y + 220))));
  await context.close();
});

test('what comes late does not push the drawing aside', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  let come;
  const late = new Promise((resolve) => { come = resolve; });
  await context.route(/\/styles\/(chips|levels)\.css$/, async (route) => {
    await late;
    await route.continue();
  });
  const { page, hand } = await open(context, server.address);
  await page.evaluate(() => {
    globalThis.sizes = new Set();
    new ResizeObserver(([{ contentRect: { width, height } }]) => sizes.add(`${width} ${height}`)).observe(batten.stage);
  });
  await page.keyboard.press('t');
  await settle(page);
  const roof = await place(page, 535, 104.5);
  await hand.stroke([roof, roof]);
  await page.waitForFunction(() => batten.panel.strip !== undefined); // it waits for its style
  await page.keyboard.press('n');
  await hand.stroke(await Promise.all(ROOF.map(([x, y]) => place(page, x, y))));
  await settle(page);
  come();
  await page.locator('section.levels').waitFor({ state: 'attached' });
  await settle(page);
  assert.deepEqual(await page.evaluate(() => [...sizes].length), 1);
});
