// Working with a pen and no keyboard: ending a curve made point by point, and the barrel button.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('Done ends a curve made point by point', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const done = page.locator('#pending button:visible');
  const tap = (at) => hand.stroke([at, at]);
  for (const [key, sheet] of [['p', 'tangents'], ['l', 'line']]) {
    await page.focus('#stage');
    await page.keyboard.press(key);
    await tap([300, 600]);
    await tap([500, 560]);
    assert.deepEqual(await done.allTextContents(), ['Done']);
    await pictures(page, `done-${sheet}`);
    await done.click();
    await settle(page);
    assert.equal(await done.count(), 0);
    assert.equal((await state(page)).check, '');
  }
});

test('the button on the barrel smooths, or moves the view', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const over = await Promise.all([[500, 113], [560, 100], [640, 104]].map(([x, y]) => place(page, x, y)));
  const opened = await state(page);
  const view = () => page.evaluate(() => glance().x);
  const x = await view();
  await hand.stroke(over, { button: 'right' });
  assert.equal(await view(), x);
  assert.equal((await state(page)).check, '');
  await page.evaluate(() => batten.engine.set('barrel-button', 1));
  const { digest } = await state(page);
  await hand.stroke(over, { button: 'right' });
  assert.notEqual(await view(), x);
  assert.equal((await state(page)).digest, digest);
  await page.evaluate(() => batten.engine.command('undo'));
  assert.equal((await state(page)).digest, opened.digest);
});
