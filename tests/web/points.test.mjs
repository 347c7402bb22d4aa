// Points, smooth brush and eraser in the page, with a pen; comb and knots by key; screenshots of each.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { hintFor, launch, open, pictures, place, reveal, settle, state, texts } from './page.mjs';
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

const objects = (page) => page.evaluate(() => batten.painter.list.length);
const native = (page) => page.evaluate(() =>
  JSON.parse(new TextDecoder().decode(batten.engine.save(true))));

test('points, smooth brush and eraser with a pen', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const strings = await texts(page);
  const shot = (name) => pictures(page, `points-${name}`);
  const first = (await state(page)).digest;
  const roof = await place(page, 600, 103.5);

  await page.keyboard.press('a');
  await hand.hover(roof);
  await shot('hover');
  assert.equal((await state(page)).hint, hintFor(strings['hint.pull']));
  // Pulling the curve itself: previewed while the pen is down, one step when it is lifted.
  await hand.stroke([roof, [roof[0] + 10, roof[1] - 40]], {
    during: async () => {
      await shot('pulled');
      assert.notEqual((await state(page)).digest, first);
    },
  });
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, first);
  await page.keyboard.press('Control+Shift+z');
  await settle(page);
  const pulled = (await state(page)).digest;
  // Keys: a point is selected, moved, moved back.
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await settle(page);
  await shot('chosen');
  await page.keyboard.press('Shift+ArrowDown');
  await settle(page);
  assert.notEqual((await state(page)).digest, pulled);
  await page.keyboard.press('Control+z');
  // A knot made a corner: its rings show the multiplicity.
  await page.keyboard.press('.');
  await page.keyboard.press('.');
  await page.keyboard.press('Shift+C');
  await settle(page);
  await shot('corner');
  await page.keyboard.press('Escape');

  await page.keyboard.press('c');
  await hand.hover(roof);
  await shot('comb');
  await page.keyboard.press('k');
  await page.keyboard.press('m');
  await hand.hover([roof[0] + 4, roof[1] + 4]);
  await shot('comb-knots-length');
  for (const key of ['c', 'k', 'm']) {
    await page.keyboard.press(key);
  }

  await page.keyboard.press('s');
  await hand.hover(roof);
  await shot('brush');
  const before = (await state(page)).digest;
  await hand.stroke([[roof[0] - 60, roof[1] + 6], roof, [roof[0] + 60, roof[1] + 4]], {
    during: () => shot('brushing'),
  });
  assert.notEqual((await state(page)).digest, before);
  await page.keyboard.press('Control+z');
  // A shaky line is calmed; the roof is smooth already.
  await page.keyboard.press('n');
  const sky = await place(page, 160, 60);
  await hand.stroke(Array.from({ length: 60 }, (_, i) => [sky[0] + 4 * i, sky[1] + 7 * Math.sin(i / 2)]));
  await page.keyboard.press('s');
  await hand.hover([sky[0] + 120, sky[1] + 2]);
  await page.keyboard.down('g');
  await settle(page);
  await shot('calm');
  await page.keyboard.up('g');
  await settle(page);
  assert.match((await state(page)).notice, /Smoothed/);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');

  await page.keyboard.press('e');
  const count = await objects(page);
  await hand.stroke([[roof[0], roof[1] - 60], [roof[0], roof[1] + 30]], { during: () => shot('erasing') });
  await shot('erased');
  assert.notEqual(await objects(page), count - 1);
  assert.equal((await state(page)).check, '');
  // The pen's eraser end erases in any tool.
  await page.keyboard.press('n');
  const here = (await state(page)).digest;
  const knots = JSON.stringify((await native(page)).objects).length;
  await page.evaluate(([x, y]) => {
    const stage = document.getElementById('stage');
    const tell = (type, py, buttons) => stage.dispatchEvent(new PointerEvent(type, {
      pointerId: 9, pointerType: 'pen', isPrimary: true, clientX: x, clientY: py, buttons, button: 5, bubbles: true }));
    tell('pointerdown', y - 40, 32);
    tell('pointermove', y + 20, 32);
    tell('pointerup', y + 20, 0);
  }, [roof[0] + 70, roof[1]]);
  await settle(page);
  assert.notEqual((await state(page)).digest, here);
  assert.ok(knots > 0);
  await context.close();
});

test('points by the many are lined up by the buttons of objects, and with all of them the curve is gone', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const before = await objects(page);
  const sky = await place(page, 120, 70);
  await page.keyboard.press('n');
  await hand.stroke(Array.from({ length: 60 }, (_, i) => [sky[0] + 5 * i, sky[1] + 25 * Math.sin(i / 8)]));
  await settle(page);
  const first = await state(page);
  await page.keyboard.press('a');
  await hand.stroke([[sky[0] + 150, sky[1] + 25 * Math.sin(30 / 8)], [sky[0] + 150, sky[1] + 25 * Math.sin(30 / 8)]]); // the curve
  await hand.stroke([[sky[0] - 30, sky[1] - 60], [sky[0] + 330, sky[1] + 70]]); // a box around it
  await reveal(page, 'numbers');
  const count = Number(await page.evaluate(() => batten.engine.number('points')));
  assert.ok(count > 3, `${count} points`);
  await page.waitForSelector('.line-up [data-name=distribute-across]:enabled');
  await pictures(page, 'points-many');
  await page.click('.line-up [data-name=align-middle]');
  await settle(page);
  const last = JSON.parse(JSON.stringify((await native(page)).objects.at(-1)));
  assert.equal(new Set(last.curves[0].points.map(([, y]) => y.toFixed(6))).size, 1);
  await pictures(page, 'points-in-line');
  await page.focus('#stage');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, first.digest);
  await page.keyboard.press('Delete');
  await settle(page);
  assert.equal(await objects(page), before);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, first.digest);
  assert.equal((await state(page)).check, '');
  await context.close();
});
