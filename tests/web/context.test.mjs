// The menu of what fits here: a right click without a drag, a long press without a stroke, the menu key.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, place, quiet, rulesIn, SCREENSHOTS, settle, state, violations } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(() => browser.close());

const items = (page) => page.locator('#context [role=menuitem]').evaluateAll((list) => list.map((one) => one.dataset.command));
const shown = (page) => page.locator('#context').isVisible();

test('a right click chooses what lies there and offers what fits it; a drag turns the view', async () => {
  const { page, context } = await open(browser, server.address);
  await page.focus('#stage');
  await page.keyboard.press('v');
  const [x, y] = await place(page, 592, 103.5);
  await page.mouse.click(x, y, { button: 'right' });
  await page.waitForSelector('#context:popover-open');
  await quiet(page);
  assert.equal(await page.evaluate(() => glance().selected), 1);
  const one = await items(page);
  assert.ok(['copy', 'order-front', 'curve-reverse', 'delete'].every((name) => one.includes(name)), String(one));
  assert.ok(!one.includes('region-unite') && !one.includes('distribute-across'), String(one));
  await inThemes(page, async (colorScheme) => {
    assert.deepEqual(await violations(page, rulesIn(colorScheme)), []);
    await page.screenshot({ path: path.join(SCREENSHOTS, `context-${colorScheme}.png`) });
  });
  // Arrows go through it, Enter runs; the drawing has the focus again.
  const fresh = await state(page);
  await page.keyboard.press('End');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.command), 'delete');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.notEqual((await state(page)).digest, fresh.digest);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'stage');
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).digest, fresh.digest);
  // Again, elsewhere: nothing is selected, so it offers what fits the drawing.
  await page.keyboard.press('Escape');
  await page.mouse.click(x, y + 300, { button: 'right' });
  await page.waitForSelector('#context:popover-open');
  assert.ok((await items(page)).includes('paste'));
  await page.keyboard.press('Escape');
  assert.equal(await shown(page), false);
  await page.mouse.move(x, y);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(x + 60, y + 20, { steps: 5 });
  await page.mouse.up({ button: 'right' });
  await settle(page);
  assert.equal(await shown(page), false);
  await context.close();
});

test('a long press without a stroke opens it under a finger; a stroke does not, and it stays inside a phone', async () => {
  const { page, hand, context } = await open(browser, server.address, { viewport: { width: 390, height: 844 }, hasTouch: true,
    isMobile: true });
  await page.tap('[data-name=tool-select]');
  const at = await place(page, 592, 103.5);
  const fresh = await state(page);
  await hand.fingers([[at]], { lift: false });
  await page.waitForSelector('#context:popover-open');
  await hand.fingers([], { down: 1 });
  await quiet(page);
  assert.equal(await shown(page), true, 'lifting the finger leaves it');
  assert.equal((await state(page)).digest, fresh.digest);
  const box = await page.locator('#context').boundingBox();
  assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= 390 && box.y + box.height <= 844, JSON.stringify(box));
  await page.screenshot({ path: path.join(SCREENSHOTS, 'context-phone.png') });
  await page.tap('#stage', { position: { x: 20, y: 500 } });
  assert.equal(await shown(page), false);
  await hand.fingers([[at], [[at[0] + 20, at[1] + 8]]], { lift: false });
  await page.waitForTimeout(700);
  assert.equal(await shown(page), false);
  await hand.fingers([], { down: 1 });
  await context.close();
});

test('the menu key opens it with the tool\'s own commands', async () => {
  const { page, context } = await open(browser, server.address, { locale: 'ko-KR' });
  await page.focus('#stage');
  await page.keyboard.press('Shift+F10');
  await page.evaluate(() => document.getElementById('stage').dispatchEvent(new MouseEvent('contextmenu', { bubbles: true, cancelable: true })));
  await page.waitForSelector('#context:popover-open');
  assert.equal((await items(page))[0], 'calm');
  assert.match(await page.locator('#context').textContent(), /^[^a-zA-Z]{2}/);
  await page.keyboard.press('Tab');
  assert.equal(await shown(page), false);
  await context.close();
});
