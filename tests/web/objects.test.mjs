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
    const rows = page.locator('.object:not([aria-expanded]) .object-name');
    await rows.nth(0).click();
    await rows.nth(1).click({ modifiers: ['Shift'] });
    await settle(page);
    assert.equal(await page.evaluate(() => glance().selected), 2);
    assert.equal(await page.locator('.object.chosen').count(), 2);
    await page.screenshot({ path: path.join(SCREENSHOTS, `objects-${colorScheme}.png`) });
    // A name, by F2; Escape leaves it.
    await rows.nth(0).locator('..').focus();
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
    await rows.nth(0).locator('..').focus();
    await page.keyboard.press('Alt+ArrowDown');
    await quiet(page);
    assert.notDeepEqual(await names(page), before);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}

for (const direction of ['ltr', 'rtl']) {
  test(`the tree is one stop of the Tab key, with arrows within, ${direction}`, async () => {
    const { page, context } = await open(browser, server.address, { viewport: { width: 1544, height: 1400 } });
    const [forth, back] = direction === 'ltr' ? ['ArrowRight', 'ArrowLeft'] : ['ArrowLeft', 'ArrowRight'];
    await reveal(page, 'objects');
    await quiet(page);
    await page.evaluate(async (dir) => {
      await batten.words.load(); // which sets the direction
      document.documentElement.dir = dir;
    }, direction);
    const at = () => page.evaluate(() => {
      const row = document.activeElement.closest('.object');
      return row && [[...row.parentElement.children].indexOf(row), document.activeElement.tagName];
    });
    const press = async (...keys) => {
      for (const key of keys) {
        await page.keyboard.press(key);
        await (key === 'Enter' || key === ' ' ? quiet(page) : settle(page));
      }
    };
    const expanded = (index) => page.locator('.object').nth(index).getAttribute('aria-expanded');
    const count = await page.locator('.object').count();
    assert.ok(count > 20, `${count} rows`);
    assert.equal(await page.locator('.objects [tabindex="0"], .objects button:not([tabindex="-1"])').count(), 1);
    // From the section's head one press comes in, and one goes on.
    await page.focus('[data-name=objects]');
    await press('Tab');
    assert.deepEqual(await at(), [0, 'DIV']);
    await press('Tab');
    assert.equal(await at(), null);
    await press('Shift+Tab', 'ArrowDown', 'ArrowDown');
    assert.deepEqual(await at(), [2, 'DIV']);
    await press('Tab', 'Shift+Tab');
    assert.deepEqual(await at(), [2, 'DIV'], 'it comes back to where it was');
    await press('End', 'ArrowDown');
    assert.deepEqual(await at(), [count - 1, 'DIV']);
    await press('Home', 'ArrowUp');
    assert.deepEqual(await at(), [0, 'DIV']);
    // A group folds and opens; from what it holds one comes back to it.
    const group = await page.evaluate(() => [...document.querySelectorAll('.object')].findIndex((row) => row.ariaExpanded));
    await press(...Array(group).fill('ArrowDown'), back);
    assert.equal(await expanded(group), 'false');
    assert.deepEqual(await at(), [group, 'DIV'], 'the focus stays');
    assert.ok(await page.locator('.object').count() < count);
    await press(forth);
    assert.equal(await expanded(group), 'true');
    assert.equal(await page.locator('.object').count(), count);
    await press('ArrowDown', back);
    assert.deepEqual(await at(), [group, 'DIV']);
    // Chosen, hidden and shown again: the focus stays on what was pressed.
    await press('ArrowDown', 'Enter', 'ArrowDown', 'Shift+Enter');
    assert.equal(await page.evaluate(() => glance().selected), 2);
    await page.screenshot({ path: path.join(SCREENSHOTS, `objects-keys-${direction}.png`) });
    await press(forth, 'Enter');
    assert.equal(await page.evaluate(() => document.activeElement.ariaPressed), 'true');
    await press(' ');
    assert.equal(await page.evaluate(() => document.activeElement.ariaPressed), 'false');
    await press(forth, forth);
    assert.deepEqual(await at(), [group + 2, 'BUTTON']);
    await press(back, back);
    assert.deepEqual(await at(), [group + 2, 'DIV']);
    // As any button's: Space presses it when it is released.
    await page.focus('[data-name=tool-pan]');
    await press(' ');
    assert.equal(await page.getAttribute('[data-name=tool-pan]', 'aria-pressed'), 'true');
    // What the tree does not use still means the drawing.
    await page.locator('.object').nth(group).focus();
    await press('ArrowDown', 'Control+z', 'Control+z');
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
