// Precision in the browser: rulers, guides dragged from them, the grid, snapping, units, isolation and outline mode.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, pictures, place, reveal, rulesIn, said, SCREENSHOTS, setting, settle, state, violations } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
});

const labels = (page) => page.evaluate(() => glance().labels.map(({ role, text }) => [role, text]));

for (const [pointerType, colorScheme] of [['mouse', 'light'], ['pen', 'dark']]) {
  test(`rulers, guides, grid and snapping with a ${pointerType}, ${colorScheme}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { colorScheme });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `precision-${colorScheme}-${name}.png`) });
    const press = async (keys) => {
      await page.keyboard.press(keys);
      await settle(page);
    };
    const fresh = await state(page);
    await page.focus('#stage');
    await press('v');
    await press('Shift+R');
    const box = await page.locator('#stage').boundingBox();
    assert.ok((await labels(page)).filter(([role]) => role === 29).length > 10);
    assert.equal(await page.textContent('#values'), '', 'the rulers are not read out');
    // From the left ruler, then from the upper one.
    const [gx, gy] = await place(page, 400, 240);
    await hand.stroke([[box.x + 9, gy], [gx, gy]], { pointerType });
    await hand.stroke([[gx + 100, box.y + 9], [gx + 100, gy]], { pointerType });
    assert.notEqual((await state(page)).digest, fresh.digest);
    await shot('guides');
    // The grid, in millimetres.
    await page.evaluate(() => {
      batten.engine.set('unit', 1);
      batten.engine.set('grid-spacing', 96 / 25.4);
    });
    await press('Shift+G');
    await shot('grid');
    await press('Shift+G');
    // An object dragged near the guide snaps to it, and a text says so.
    const at = await place(page, 592, 103.5);
    await hand.stroke([at, at], { pointerType });
    const left = await page.evaluate(() => glance().selected);
    assert.equal(left, 1);
    await hand.stroke([at, [at[0] + 2, at[1] + 60], [at[0] + 2, at[1] + 61]], { pointerType, during: () => shot('snap') });
    await press('Control+z');
    await press('Shift+I');
    await shot('isolated');
    await press('Escape');
    await press('Shift+O');
    await shot('outlines');
    await press('Shift+O');
    // The guide is dragged back into its ruler: with the other one undone too, the drawing is as it was.
    await hand.stroke([[gx, gy + 60], [box.x + 5, gy + 60]], { pointerType });
    await press('Escape');
    for (let i = 0; i < 6 && (await state(page)).digest !== fresh.digest; i++) {
      await press('Control+z');
    }
    assert.equal((await state(page)).digest, fresh.digest);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}

/** Drags a field's label. @param {number} by pixels */
async function drag(page, id, by) {
  const { x, y, width, height } = await page.locator(`label[for=${id}]`).boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + by, y + height / 2);
  await page.mouse.up();
  await settle(page);
}

test('numbers of the selection and of the grid, in the unit in force', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const fresh = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await reveal(page, 'numbers');
  await page.waitForSelector('#number-x', { state: 'attached' });
  const shown = page.locator('#numbers .control:visible:not(.page-size *)'); // the page's own stand where nothing is selected
  assert.equal(await shown.count(), 0);
  const at = await place(page, 592, 103.5);
  await hand.stroke([at, at], { pointerType: 'mouse' });
  assert.equal(await shown.count(), 5);
  await page.fill('#number-x', '1in + 3mm');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await said(page, '#number-x'), '107.339 px');
  await page.fill('#number-x', '2 in');
  assert.equal(await page.isVisible('#number-x-unit'), false, 'the unit typed stands alone');
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#number-x-unit'), true);
  await drag(page, 'number-x', 12);
  assert.equal(await said(page, '#number-x'), '113.339 px');
  const ends = () => page.$eval('#number-x', (input) => {
    const [field, unit] = [input, input.nextElementSibling].map((part) => part.getBoundingClientRect());
    return { within: unit.left > field.left && unit.right <= field.right && unit.top >= field.top, behind: field.right - unit.right < 2 };
  });
  assert.deepEqual(await ends(), { within: true, behind: true });
  await page.evaluate(() => { document.documentElement.dir = 'rtl'; });
  assert.deepEqual(await ends(), { within: true, behind: true }, 'a number stands before its unit');
  await pictures(page, 'precision-rtl');
  await page.evaluate(() => { document.documentElement.dir = ''; });
  await page.keyboard.press('Control+z');
  await settle(page);
  await page.evaluate(() => batten.engine.set('unit', 1));
  await page.fill('#number-width', '150');
  await page.keyboard.press('Tab');
  await settle(page);
  assert.equal(await said(page, '#number-width'), '150 mm');
  assert.equal(await said(page, '#number-x'), '28.4 mm');
  await page.fill('#number-y', 'up');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await page.getAttribute('#number-y', 'aria-invalid'), 'true');
  await inThemes(page, async (colorScheme) => {
    await page.screenshot({ path: path.join(SCREENSHOTS, `precision-${colorScheme}-numbers.png`) });
    assert.deepEqual(await violations(page, rulesIn(colorScheme)), [], colorScheme);
  });
  await page.keyboard.press('Escape');
  assert.match(await said(page, '#number-y'), /^[0-9.]+ mm$/);
  await page.focus('#stage');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, fresh.digest);
  await page.click('[data-name=numbers]');
  assert.equal(await page.isVisible('#numbers-body'), false);
  await setting(page, 'grid-spacing');
  await page.fill('#setting-grid-spacing', '1/4in');
  await page.keyboard.press('Tab');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.get('grid-spacing')), 24);
  assert.equal(await said(page, '#setting-grid-spacing'), '6.35 mm');
  assert.match(await page.textContent('#readouts'), /= [0-9.]+ mm/);
  await page.locator('#setting-unit').scrollIntoViewIfNeeded();
  await pictures(page, 'precision-settings');
  await context.close();
});
