// What strokes are taken for: the switch between as drawn, redraw only and new only, by key and in the sheet; careless
// strokes that converge, or of which the last wins; lines of class A.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const PAGE = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 700" width="1000" height="700"/>');

/** A bow from one place of the window to another, `lift` px high. */
const bow = ([x0, y0], [x1, y1], lift) => Array.from({ length: 61 }, (_, i) => {
  const t = i / 60;
  return [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t - 4 * lift * t * (1 - t)];
});

for (const pointerType of ['pen', 'mouse', 'touch']) {
  test(`${pointerType}: redraw only, new only, as drawn`, async (t) => {
    const server = await serve({ name: 'new.svg', bytes: PAGE });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address);
    const draw = async (points) => {
      await hand.stroke(points, { pointerType });
      await settle(page);
      const now = await state(page);
      assert.equal(now.check, '');
      return now.digest;
    };
    await page.evaluate(() => batten.engine.set('many-strokes', 1));
    const over = bow([320, 290], [580, 290], 62);
    const first = await draw(bow([280, 320], [620, 320], 80));
    const button = page.locator('#tools [data-name=meaning-next]');
    const next = async (said) => {
      await (pointerType === 'pen' ? page.keyboard.press('w') : button.evaluate((one) => one.click())); // a pointer's click may be lost on a machine under load
      await page.waitForFunction((meaning) => batten.engine.get('stroke-meaning') === meaning, ['', 'Redraw', 'New line'].indexOf(said));
      await quiet(page);
      assert.equal(await button.locator('span').isVisible(), said !== '');
      assert.equal(await button.locator('span').textContent(), said || 'Auto');
      assert.equal(await button.getAttribute('aria-pressed'), String(said !== ''));
    };
    await page.locator('#stage').focus();
    await next('Redraw');
    await page.screenshot({ path: path.join(SCREENSHOTS, `meant-redraw-${pointerType}.png`) });
    assert.equal(await draw(bow([300, 560], [500, 560], 20)), first, 'away from all lines it draws nothing');
    const redrawn = await draw(over);
    assert.notEqual(redrawn, first);
    await page.keyboard.press('Control+z');
    await next('New line');
    const fresh = await draw(over);
    assert.notEqual(fresh, first);
    await page.screenshot({ path: path.join(SCREENSHOTS, `meant-new-${pointerType}.png`) });
    await page.keyboard.press('Control+z');
    await next('');
    assert.equal(await draw(over), redrawn);
    assert.match(await page.locator('.chips [aria-pressed=true]').textContent(), /^Redraw/);
    await page.locator('.chips button', { hasText: 'New line' }).click();
    await settle(page);
    assert.notEqual((await state(page)).digest, redrawn);
    assert.equal((await state(page)).check, '');
  });
}

test('careless strokes converge, or the last one wins', async (t) => {
  const server = await serve({ name: 'new.svg', bytes: PAGE });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const digests = [];
  for (const way of [0, 1]) {
    await page.evaluate((value) => batten.engine.set('many-strokes', value), way);
    await hand.stroke(bow([280, 320], [660, 320], 80));
    await hand.stroke(bow([660, 327], [280, 327], 80));
    await hand.stroke(bow([282, 324], [655, 322], 83));
    await settle(page);
    const now = await state(page);
    assert.equal(now.check, '');
    digests.push(now.digest);
    const words = await page.locator('.chips button').allTextContents();
    assert.equal(words.includes('All strokes'), way === 0, `${words}`);
    await page.screenshot({ path: path.join(SCREENSHOTS, `meant-strokes-${way ? 'last' : 'converge'}.png`) });
    for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
    await settle(page);
  }
  assert.notEqual(digests[0], digests[1]);
});

test('a line of class A', async (t) => {
  const server = await serve({ name: 'new.svg', bytes: PAGE });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const opened = await state(page);
  const digests = [];
  for (const on of [0, 1]) {
    await page.evaluate((value) => batten.engine.set('class-a', value), on);
    await hand.stroke(bow([280, 320], [660, 320], 80));
    await settle(page);
    const now = await state(page);
    assert.equal(now.check, '');
    digests.push(now.digest);
    await page.screenshot({ path: path.join(SCREENSHOTS, `meant-class-${on ? 'a' : 'cubic'}.png`) });
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, opened.digest);
  }
  assert.notEqual(digests[0], digests[1]);
});
