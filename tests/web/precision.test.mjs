// Precision in the browser: rulers, guides out of them, the grid, a drag that snaps, units, isolation and outlines.
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

const labels = (page) => page.evaluate(() => batten.engine.frame().labels.map(({ role, text }) => [role, text]));

for (const [pointerType, colorScheme] of [['mouse', 'light'], ['pen', 'dark']]) {
  test(`rulers, guides, grid and snapping with a ${pointerType}, ${colorScheme}`, async () => {
    const { page, hand, faults, context } = await open(browser, server.address, { colorScheme });
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
    // Out of the left ruler, then out of the upper one.
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
    // What is dragged near the guide goes to it, and says so.
    const at = await place(page, 592, 103.5);
    await hand.stroke([at, at], { pointerType });
    const left = await page.evaluate(() => batten.engine.frame().selected);
    assert.equal(left, 1);
    await hand.stroke([at, [at[0] + 2, at[1] + 60], [at[0] + 2, at[1] + 61]], { pointerType, during: () => shot('snap') });
    await press('Control+z');
    await press('i');
    await shot('isolated');
    await press('Escape');
    await press('o');
    await shot('outlines');
    await press('o');
    // The guide goes back into its ruler: the drawing is as it was, once the other is undone, too.
    await hand.stroke([[gx, gy + 60], [box.x + 5, gy + 60]], { pointerType });
    await press('Escape');
    for (let i = 0; i < 6 && (await state(page)).digest !== fresh.digest; i++) {
      await press('Control+z');
    }
    assert.equal((await state(page)).digest, fresh.digest);
    assert.equal((await state(page)).check, '');
    assert.deepEqual(faults, []);
    await context.close();
  });
}
