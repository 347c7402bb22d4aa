// The select tool, style and layers in the browser: once with a mouse, once with a pen.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
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

for (const [pointerType, colorScheme] of [['mouse', 'light'], ['pen', 'dark']]) {
  test(`select, move, style and layers with a ${pointerType}, ${colorScheme}`, async () => {
    const { page, hand, faults, context } = await open(browser, server.address, { colorScheme });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `select-${colorScheme}-${name}.png`) });
    const fresh = await state(page);
    await page.focus('#stage');
    await page.keyboard.press('v');
    const at = await place(page, 592, 103.5);
    await hand.stroke([at, at], { pointerType });
    assert.equal(await page.evaluate(() => batten.engine.frame().selected), 1);
    await shot('selected');
    await hand.stroke([at, [at[0] + 40, at[1] - 30]], { pointerType });
    const moved = await state(page);
    assert.notEqual(moved.digest, fresh.digest);
    await shot('moved');
    await page.keyboard.press('Control+a');
    await settle(page);
    await shot('all');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, fresh.digest);
    await page.click('[data-name="style"]');
    await settle(page);
    await shot('style');
    await page.keyboard.press('Escape');
    await page.click('[data-name="layers"]');
    await page.click('#layers .layer-commands button >> nth=0');
    await settle(page);
    assert.equal(await page.locator('#layers .layer-row').count(), 2);
    await shot('layers');
    assert.equal((await state(page)).check, '');
    assert.deepEqual(faults, []);
    await context.close();
  });
}

for (const colorScheme of ['light', 'dark']) {
  test(`a copy dragged off with Alt, a group entered by a double click, ${colorScheme}`, async () => {
    const { page, hand, faults, context } = await open(browser, server.address, { colorScheme });
    const objects = () => page.evaluate(() =>
      JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.length);
    const selected = () => page.evaluate(() => batten.engine.frame().selected);
    const fresh = await state(page);
    await page.focus('#stage');
    await page.keyboard.press('v');
    const at = await place(page, 592, 103.5);
    const before = await objects();
    await hand.stroke([at, [at[0] + 60, at[1] + 40]], { pointerType: 'mouse', modifiers: 1 });
    assert.ok(await objects() > before);
    await page.screenshot({ path: path.join(SCREENSHOTS, `select-${colorScheme}-copy.png`) });
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, fresh.digest);
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Control+g');
    await page.keyboard.press('Control+Shift+a');
    await settle(page);
    await page.mouse.dblclick(...at);
    await settle(page);
    assert.equal(await selected(), 1);
    assert.ok((await page.evaluate(() => batten.engine.frame().labels.length)) > 0);
    await page.mouse.move(640, 200);
    await settle(page);
    assert.match((await state(page)).hint, /In a group/);
    await page.screenshot({ path: path.join(SCREENSHOTS, `select-${colorScheme}-entered.png`) });
    await page.keyboard.press('Escape');
    await settle(page);
    assert.equal(await page.evaluate(() => batten.engine.frame().labels.length), 0);
    assert.equal((await state(page)).check, '');
    assert.deepEqual(faults, []);
    await context.close();
  });
}
