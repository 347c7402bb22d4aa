// A stroke held at its end is offered a figure: a chip makes it; drawn on, the stroke is whole.
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

for (const [pointerType, colorScheme, viewport] of [['pen', 'light', { width: 1544, height: 800 }], ['mouse', 'dark', { width: 1544, height: 800 }],
  ['pen', 'dark', { width: 390, height: 844 }]]) {
  const name = `${pointerType}-${viewport.width}`;
  test(`${name}: a rest offers a figure in place of the stroke`, async (t) => {
    const server = await serve({ name: 'new.svg', bytes: EMPTY });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { colorScheme, viewport });
    await page.evaluate(() => { globalThis.rests = true; });
    const opened = await state(page);
    const held = () => page.waitForFunction(() => document.getElementById('hint').textContent.startsWith('Lift'));
    const [from, end, away] = viewport.width > 700 ? [[300, 240], [700, 330], [760, 420]] : [[80, 340], [300, 400], [320, 460]];
    const line = careless(from, end);
    await hand.stroke(line, { pointerType, during: async () => {
      await held();
      await page.screenshot({ path: path.join(SCREENSHOTS, `hold-line-${name}.png`) });
    } });
    await quiet(page);
    const drawn = await state(page);
    const chips = page.locator('.chips button');
    await chips.first().waitFor();
    assert.deepEqual(await chips.allTextContents(), ['New line', 'Straight line']);
    assert.equal(await page.locator('.chips [aria-pressed=true]').textContent(), 'New line', 'as it was drawn');
    await page.screenshot({ path: path.join(SCREENSHOTS, `hold-chips-${name}.png`) });
    await chips.nth(1).click();
    await settle(page);
    assert.notEqual((await state(page)).digest, drawn.digest);
    assert.equal((await state(page)).check, '');
    await page.screenshot({ path: path.join(SCREENSHOTS, `hold-taken-${name}.png`) });
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, opened.digest, 'all of it is one step');
    // Drawn on, nothing is left of the offer.
    await hand.stroke(line, { pointerType, during: async () => {
      await held();
      await hand.drag(end, away, pointerType);
      await page.waitForFunction(() => !document.getElementById('hint').textContent.startsWith('Lift'));
    }, end: away });
    await quiet(page);
    assert.ok(!(await chips.allTextContents()).includes('Straight line'));
    await page.keyboard.press('Control+z');
    await settle(page);
    if (viewport.width > 700) {
      await hand.stroke(round([560, 480], 130), { pointerType, during: async () => {
        await held();
        await page.screenshot({ path: path.join(SCREENSHOTS, `hold-ellipse-${name}.png`) });
        await page.keyboard.press('Escape');
        await settle(page);
      } });
    }
    assert.equal((await state(page)).digest, opened.digest, 'cancelled, nothing is left');
    await quiet(page);
  });
}
