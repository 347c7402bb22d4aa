// A stroke held at its end becomes a figure, dragged while it is held; the chips offer the stroke as drawn.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const EMPTY = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700"/>');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** The path of a hand that trembles and bows, from one point to another. */
const careless = ([x0, y0], [x1, y1]) => Array.from({ length: 81 }, (_, i) => {
  const t = i / 80;
  return [x0 + (x1 - x0) * t + 0.5 * Math.sin(50 * t), y0 + (y1 - y0) * t + 5 * Math.sin(3.1 * t) + 0.6 * Math.sin(70 * t)];
});
const round = ([x, y], r) => Array.from({ length: 91 }, (_, i) => {
  const angle = 1 + (6.15 * i) / 90;
  return [x + r * (1 + 0.03 * Math.sin(3 * angle)) * Math.cos(angle), y + 0.62 * r * Math.sin(angle)];
});

for (const [pointerType, colorScheme] of [['pen', 'light'], ['mouse', 'dark']]) {
  test(`${pointerType}: a rest makes a figure of the stroke`, async (t) => {
    const server = await serve({ name: 'new.svg', bytes: EMPTY });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { colorScheme });
    await page.evaluate(() => { globalThis.rests = true; });
    const opened = await state(page);
    const held = (hint) => page.waitForFunction((text) => document.getElementById('hint').textContent.startsWith(text), hint);
    const away = [760, 300];
    await hand.stroke(careless([300, 240], [700, 330]), { pointerType, during: async () => {
      await held('Drag to fit the shape');
      await page.screenshot({ path: path.join(SCREENSHOTS, `hold-line-${colorScheme}.png`) });
      await hand.drag([700, 330], away, pointerType);
    }, end: away });
    const line = await state(page);
    assert.notEqual(line.digest, opened.digest);
    assert.equal(line.check, '');
    const chips = page.locator('.chips button');
    await chips.first().waitFor();
    assert.deepEqual(await chips.allTextContents(), ['Straight line', 'As drawn']);
    await page.screenshot({ path: path.join(SCREENSHOTS, `hold-chips-${colorScheme}.png`) });
    await chips.nth(1).click();
    await settle(page);
    assert.notEqual((await state(page)).digest, line.digest);
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, opened.digest, 'all of it is one step');
    await hand.stroke(round([560, 480], 130), { pointerType, during: async () => {
      await held('Drag to fit the shape');
      await page.screenshot({ path: path.join(SCREENSHOTS, `hold-ellipse-${colorScheme}.png`) });
      await page.keyboard.press('Escape');
      await settle(page);
    } });
    assert.equal((await state(page)).digest, opened.digest, 'cancelled, nothing is left');
    await quiet(page);
  });
}
