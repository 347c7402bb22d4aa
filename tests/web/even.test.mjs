// Even curvature in the page: chosen in the settings, for the spline at hand and for the next; dragged by its points.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, pictures, settle, state } from './page.mjs';
import { serve } from './server.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const SPOTS = [[300, 560], [470, 420], [640, 560], [820, 440], [1000, 540]];
/** The native document's last object. */
const newest = (page) => page.evaluate(() =>
  JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.at(-1));

test('a spline of even curvature', async () => {
  const blank = await serve();
  const { page, hand, context } = await open(browser, blank.address);
  const shot = (name) => pictures(page, `even-${name}`);
  await page.keyboard.press('p');
  await settle(page);
  for (const spot of SPOTS) {
    hand.rest(0.45);
    await hand.stroke([spot]);
  }
  await page.keyboard.press('Enter');
  assert.equal((await newest(page)).spline.points.length, SPOTS.length);
  hand.rest(0.45);
  await hand.stroke([SPOTS[2]]);
  await page.selectOption('#option-spline-mode', '2');
  await settle(page);
  await shot('options');
  assert.equal((await newest(page)).spline.mode, 'even');
  await shot('chosen');
  const { digest } = await state(page);
  await hand.stroke([SPOTS[2], [650, 600], [680, 640]], { during: () => shot('dragging') });
  assert.equal((await newest(page)).spline.mode, 'even');
  assert.notEqual((await state(page)).digest, digest);
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).digest, digest);
  await page.keyboard.press('Control+z'); // the choice was a step
  assert.equal((await newest(page)).spline.mode, 'round');
  await page.keyboard.press('Control+Shift+z');
  assert.equal((await state(page)).digest, digest);

  await page.keyboard.press('Escape'); // the next one
  for (const spot of SPOTS.slice(0, 3)) {
    hand.rest(0.45);
    await hand.stroke([[spot[0], spot[1] - 250]]);
  }
  await hand.hover([900, 250]);
  await shot('placing');
  await page.keyboard.press('Enter');
  const next = await newest(page);
  assert.equal(next.spline.mode, 'even');
  assert.equal(next.spline.points.length, 3);
  assert.equal((await state(page)).check, '');
  await context.close();
  blank.close();
});
