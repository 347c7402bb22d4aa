// Rectangles, ellipses and polygons are dragged with a mouse and a pen; each is selected and stays a shape whose handles and numbers
// change it, and undo takes it back.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, SCREENSHOTS, state } from './page.mjs';
import { serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const [locale, colorScheme, pointerType] of [['en', 'light', 'mouse'], ['ko-KR', 'dark', 'pen']]) {
  test(`three shapes, ${locale}, ${pointerType}`, async (t) => {
    const server = await serve();
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme });
    const begun = await state(page);
    const count = () => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.length);
    const first = await count();
    for (const [key, name, x] of [['r', 'rectangle', 250], ['o', 'ellipse', 480], ['Shift+D', 'polygon', 800]]) {
      await page.locator('#stage').focus();
      await page.keyboard.press(key);
      await quiet(page);
      assert.equal(await page.locator(`[data-name=tool-${name}]`).first().getAttribute('aria-pressed'), 'true', name);
      await hand.stroke([[x, 300], [x + 60, 340], [x + 150, 420]], { pointerType });
      await quiet(page);
    }
    assert.equal(await count(), first + 3);
    assert.equal((await state(page)).check, '');
    // What the tool can be told stands in the bar, and is gone with the tool.
    const sides = page.locator('#option-polygon-sides');
    await sides.fill('5');
    await sides.press('Enter');
    await quiet(page);
    assert.equal(await page.evaluate(() => batten.engine.get('polygon-sides')), 5);
    await page.keyboard.press('h');
    await quiet(page);
    assert.equal(await sides.count(), 0);
    await page.screenshot({ path: path.join(SCREENSHOTS, `shapes-${locale}.png`) });
    // Handles at the shape, and its numbers: the polygon becomes a star; a number makes it round.
    await page.keyboard.press('v');
    await quiet(page);
    const number = (name) => page.evaluate((which) => batten.engine.number(which), `shape-${name}`);
    assert.equal(await number('sides'), '6');
    const depth = (await state(page)).digest;
    const at = (angle, radius) => [800 + radius * Math.cos(angle), 300 + radius * Math.sin(angle)];
    const radius = Math.hypot(150, 120), turn = Math.atan2(120, 150) + Math.PI / 6, near = radius * Math.cos(Math.PI / 6);
    await hand.stroke([at(turn, near), at(turn, near * 0.8), at(turn, near / 2)], { pointerType });
    await quiet(page);
    assert.ok(Math.abs(Number(await number('depth')) - 50) < 1, await number('depth'));
    for (const [name, value] of [['sides', '5'], ['roundness', '30']]) {
      await page.fill(`#number-shape-${name}`, value);
      await page.keyboard.press('Enter');
      await quiet(page);
    }
    await page.locator('#stage').focus();
    await page.screenshot({ path: path.join(SCREENSHOTS, `shapes-star-${locale}.png`) });
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('Control+z');
    }
    await quiet(page);
    assert.equal((await state(page)).digest, depth);
    if (pointerType === 'mouse') {
      await page.keyboard.press('r');
      await quiet(page);
      await page.mouse.move(250, 500);
      await page.mouse.down();
      await page.mouse.move(420, 600, { steps: 8 });
      await quiet(page);
      await page.screenshot({ path: path.join(SCREENSHOTS, 'shapes-dragged.png') });
      await page.keyboard.press('Escape');
      await page.mouse.up();
      assert.equal(await count(), first + 3, 'cancelled');
    }
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('Control+z');
    }
    await quiet(page);
    assert.equal((await state(page)).digest, begun.digest);
    await context.close();
  });
}
