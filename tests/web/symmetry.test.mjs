// Symmetry: a stroke on one side of the dashed axis gives two curves, one across it a single curve; a straight line as
// another axis.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const PAGE = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700">' +
  '<path d="M250 200 L500 700" fill="none" stroke="#999"/></svg>');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** An arc from one point to another. */
const bow = ([x0, y0], [x1, y1], lift) => Array.from({ length: 61 }, (_, i) => {
  const t = i / 60;
  return [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t - 4 * lift * t * (1 - t)];
});

for (const [pointerType, colorScheme] of [['pen', 'light'], ['mouse', 'dark']]) {
  test(`${pointerType}: a stroke is drawn on both sides`, async (t) => {
    const server = await serve({ name: 'new.svg', bytes: PAGE });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { colorScheme });
    const opened = await state(page);
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `symmetry-${name}-${colorScheme}.png`) });
    await page.keyboard.press('y');
    await settle(page);
    const draw = async (points, name) => {
      await hand.stroke(points, { pointerType, during: () => (name ? shot(name) : undefined) });
      await settle(page);
      const now = await state(page);
      assert.equal(now.check, '');
      return now.digest;
    };
    const digests = [opened.digest];
    digests.push(await draw(bow([300, 260], [480, 300], 50), 'ghost'));
    digests.push(await draw(bow([330, 520], [700, 540], 40), 'across'));
    digests.push(await draw(bow([380, 235], [440, 245], 14)));
    assert.equal(new Set(digests).size, digests.length);
    await shot('drawn');
    for (let i = digests.length - 2; i >= 0; i--) {
      await page.keyboard.press('Control+z');
      await settle(page);
      assert.equal((await state(page)).digest, digests[i], 'each stroke is one step');
    }
    await page.keyboard.press('Shift+Y'); // nothing is selected
    await page.locator('#notice', { hasText: 'Select one straight line' }).waitFor();
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Shift+Y');
    await page.keyboard.press('Control+Shift+A');
    await page.keyboard.press('n');
    assert.notEqual(await draw(bow([560, 200], [760, 330], 60)), opened.digest);
    await shot('slanted');
    await quiet(page);
  });
}
