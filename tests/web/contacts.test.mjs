// Contacts that the system loses or takes away, and samples that come out of order.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { SCREENSHOTS, bezier, launch, open, place, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
let page;
let hand;
let context;
let client;

before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
});
beforeEach(async () => {
  ({ page, hand, context, client } = await open(browser, server.address, { hasTouch: true }));
});
afterEach(async () => {
  assert.equal((await state(page)).check, '');
  await context.close();
});

const wave = (x, y) => bezier([x, y], [x + 80, y - 40], [x + 160, y + 40], [x + 260, y]);
const on = (points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const objects = () => page.evaluate(() => batten.painter.list.length);

/** What may come after a pen-up that the system has lost. */
const ends = {
  'a move without buttons': () => hand.hover([900, 500]),
  'the next stroke of the pen': async () => {},
  'a press of the mouse': () => hand.stroke([[900, 500], [900, 501]], { pointerType: 'mouse' }), // which draws a dot
  'the window loses the focus': () => page.evaluate(() => dispatchEvent(new FocusEvent('blur'))),
};
for (const [name, end] of Object.entries(ends)) {
  test(`a lost pen-up: ${name} ends the stroke where it was last seen, and it is kept`, async () => {
    const count = await objects();
    await hand.stroke(await on(wave(60, 60)), { lift: false });
    await end();
    await settle(page);
    await hand.stroke(await on(wave(60, 320)));
    assert.equal(await objects(), count + (name === 'a press of the mouse' ? 3 : 2));
    const [x0, y0, x1, y1] = await page.evaluate((i) => {
      const { x0, y0, x1, y1 } = batten.painter.list[i].item;
      return [x0, y0, x1, y1];
    }, count);
    assert.ok(Math.abs(x0 - 60) < 8 && Math.abs(x1 - 320) < 8 && y0 > 30 && y1 < 90, `hovering drew nothing: ${[x0, y0, x1, y1]}`);
    assert.equal(await page.evaluate(() => batten.input.contacts.size), 0);
  });
}

test('a lost pen-up: after Escape the pen draws again', async () => {
  const count = await objects();
  await hand.stroke(await on(wave(60, 60)), { lift: false });
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => batten.input.contacts.size), 0);
  await hand.stroke(await on(wave(60, 320)), { pointerType: 'mouse' });
  assert.equal(await objects(), count + 1);
});

test('a lost finger: the next one moves the view alone', async () => {
  await hand.fingers([[[300, 300]], [[320, 320]]], { lift: false });
  await page.evaluate(() => { // as if its end had never come
    const stage = document.getElementById('stage');
    for (const type of ['pointerup', 'lostpointercapture']) {
      stage.addEventListener(type, (event) => event.stopImmediatePropagation(), { capture: true, once: true });
    }
  });
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  const { zoom } = await state(page);
  await hand.fingers([[[500, 300]], [[600, 300]], [[700, 300]]]);
  assert.equal((await state(page)).zoom, zoom, 'no pinch');
  assert.equal(await page.evaluate(() => batten.input.contacts.size), 0);
});

test('a stroke that the system takes away is offered back', async () => {
  const count = await objects();
  await hand.stroke(await on(wave(60, 60)), { lift: false });
  await page.evaluate(() => {
    const [[pointerId]] = batten.input.contacts;
    document.getElementById('stage').dispatchEvent(new PointerEvent('pointercancel', { pointerId, pointerType: 'pen', bubbles: true }));
  });
  await page.waitForSelector('#notice button >> text=Restore stroke');
  await page.screenshot({ path: `${SCREENSHOTS}/stroke-taken.png` });
  assert.equal(await objects(), count);
  await page.click('#notice button');
  await settle(page);
  assert.equal(await objects(), count + 1);
  await hand.stroke(await on(wave(60, 320)));
  assert.equal(await objects(), count + 2);
});

test('samples out of order, and some at no place: the stroke is that of the good ones in order', async () => {
  const draw = (spoiled) => page.evaluate(async (spoil) => {
    const { engine, files } = batten;
    await files.reopen();
    const wave = (i) => ({ phase: 2, device: 1, contact: 9, buttons: 1, modifiers: 0, x: 100 + 1.5 * i, y: 600 + 20 * Math.sin(i / 30),
      pressure: 0.5, tiltX: 0, tiltY: 0, twist: 0, width: 1, height: 1, time: 1e6 + 4 * i, predicted: false });
    const moves = Array.from({ length: 180 }, (_, i) => wave(i + 1));
    const told = spoil ? [...moves.filter((_, i) => i % 3 === 1), ...moves.filter((_, i) => i % 3 !== 1).reverse(),
      { ...wave(50), x: NaN }, { ...wave(90), y: 1e308 }, { ...wave(120), x: -Infinity, time: NaN }] : moves;
    engine.pointer([{ ...wave(0), phase: 1 }]);
    engine.pointer(told);
    engine.pointer([{ ...wave(181), phase: 3, buttons: 0 }]);
    return new TextDecoder().decode(engine.journal).split('\n').slice(1);
  }, spoiled);
  const drawn = await draw(false);
  assert.match(drawn[0], /sketch-new/);
  assert.deepEqual(await draw(true), drawn);
});
