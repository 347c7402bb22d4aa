// The tree of objects in the inspector: chosen, renamed, hidden, locked, dragged to another place; by keys, too.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, reveal, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(() => browser.close());

const names = (page) => page.locator('.object-name span').allTextContents();
const saved = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
const middle = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 3, y + height / 2];
};

for (const [colorScheme, locale] of [['light', 'en'], ['dark', 'ko-KR']]) {
  test(`objects are listed with pictures, chosen, renamed, hidden, locked and moved, ${colorScheme}, ${locale}`, async () => {
    const { page, context } = await open(browser, server.address, { colorScheme, locale, viewport: { width: 1544, height: 1400 } });
    await reveal(page, 'objects');
    for (const other of ['numbers', 'style']) { // so that all rows are in the window
      await page.click(`[data-name=${other}]`);
    }
    const fresh = await state(page);
    const before = await names(page);
    const all = await saved(page);
    assert.equal(before.length, all.length);
    assert.equal(before[0], all.findLast((one) => !one.parent).name, 'the front first');
    // Pictures have ink.
    assert.ok(await page.locator('.thumbnail').first().evaluate((canvas) =>
      canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some((value) => value > 0)));
    // A click chooses, with Shift one more.
    const rows = page.locator('.object:not(:has([aria-expanded])) .object-name');
    await rows.nth(0).click();
    await rows.nth(1).click({ modifiers: ['Shift'] });
    await settle(page);
    assert.equal(await page.evaluate(() => glance().selected), 2);
    assert.equal(await page.locator('.object.chosen').count(), 2);
    await page.screenshot({ path: path.join(SCREENSHOTS, `objects-${colorScheme}.png`) });
    // A name, by F2; Escape leaves it.
    await rows.nth(0).focus();
    await page.keyboard.press('F2');
    await page.keyboard.type('no');
    await page.keyboard.press('Escape');
    assert.equal((await state(page)).digest, fresh.digest);
    await rows.nth(0).dblclick();
    await page.keyboard.type('left hub');
    await page.keyboard.press('Enter');
    await quiet(page);
    assert.ok((await names(page)).includes('left hub'));
    assert.ok((await saved(page)).some(({ name }) => name === 'left hub'));
    // Hidden and locked, each a step.
    const line = page.locator('.object', { hasText: 'left hub' });
    await line.hover();
    await line.locator('.object-state').nth(0).click();
    await line.hover();
    await line.locator('.object-state').nth(1).click();
    await quiet(page);
    const one = (await saved(page)).find(({ name }) => name === 'left hub');
    assert.deepEqual([one.hidden, one.locked], [true, true]);
    await page.focus('#stage');
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('Control+z');
    }
    await quiet(page);
    assert.equal((await state(page)).digest, fresh.digest);
    // Dragged into another group; undone; moved by a key.
    const from = await middle(rows.nth(0));
    const target = page.locator('.object-name').last();
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...await middle(target), { steps: 6 });
    await page.screenshot({ path: path.join(SCREENSHOTS, `objects-${colorScheme}-drag.png`) });
    await page.mouse.up();
    await quiet(page);
    const moved = await state(page);
    assert.notEqual(moved.digest, fresh.digest);
    assert.equal(moved.check, '');
    assert.equal((await names(page)).length, before.length);
    assert.notDeepEqual(await names(page), before);
    await page.focus('#stage');
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.deepEqual(await names(page), before);
    await rows.nth(0).focus();
    await page.keyboard.press('Alt+ArrowDown');
    await quiet(page);
    assert.notDeepEqual(await names(page), before);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
