// label: smoke. Pen, mouse, fingers, wheel and keys.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, beforeEach, afterEach, test } from 'node:test';
import { bezier, inked, launch, open, place, settle, state, texts } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
let page;
let hand;
let context;
let client;
let strings;

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
  strings = await texts(page);
});
afterEach(async () => {
  assert.equal((await state(page)).check, '');
  await context.close();
});

const wave = (x, y) => bezier([x, y], [x + 80, y - 40], [x + 160, y + 40], [x + 260, y]);
const on = (points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const objects = () => page.evaluate(() => batten.painter.list.length);

test('away from curves the pen draws a new one', async () => {
  const count = await objects();
  const { digest } = await state(page);
  await hand.hover(await place(page, 60, 60));
  assert.equal((await state(page)).hint, strings['hint.new']);
  await hand.stroke(await on(wave(60, 60)));
  assert.equal(await objects(), count + 1);
  assert.notEqual((await state(page)).digest, digest);
  const [x, y] = await place(page, 190, 60);
  const dark = await page.evaluate(([px, py]) => {
    const canvas = document.getElementById('still');
    const box = canvas.getBoundingClientRect();
    const data = canvas.getContext('2d').getImageData(px - box.left - 3, py - box.top - 3, 6, 6).data;
    return [...data].some((value, i) => i % 4 === 0 && value < 128 && data[i + 3] > 128);
  }, [x, y]);
  assert.ok(dark, 'the new curve is painted');
});

test('the mouse draws as well', async () => {
  const count = await objects();
  await hand.stroke(await on(wave(60, 60)), { pointerType: 'mouse' });
  assert.equal(await objects(), count + 1);
});

test('Alt smooths what the pen passes over', async () => {
  const { digest } = await state(page);
  const count = await objects();
  // A bump in the roof first, then a smoothing stroke over it.
  const bump = [[540, 104.5], [556, 99], [570, 107], [584, 99], [600, 103.6]];
  await hand.stroke(await on(bump));
  const bumped = await state(page);
  assert.notEqual(bumped.digest, digest);
  await page.keyboard.down('Alt');
  await hand.hover(await place(page, 570, 104));
  await hand.stroke(await on(bezier([500, 113], [540, 104], [600, 102], [660, 108])), { modifiers: 1 });
  await page.keyboard.up('Alt');
  const smoothed = await state(page);
  assert.notEqual(smoothed.digest, bumped.digest);
  assert.equal(await objects(), count, 'no new curve');
});

test('Escape cancels the stroke under the pen', async () => {
  const { digest } = await state(page);
  await hand.stroke(await on(wave(60, 60)), {
    during: async () => {
      assert.ok(await inked(page, 'overlay') > 0);
      await page.keyboard.press('Escape');
      await settle(page);
    },
  });
  assert.equal((await state(page)).digest, digest);
  assert.equal((await state(page)).unsaved, false);
});

test('every sample of a stroke reaches the engine, several in one frame', async () => {
  await page.evaluate(() => {
    batten.input.cost = { samples: 0, milliseconds: 0 };
    batten.loop.cost.frames = 0;
  });
  const sent = await hand.stroke(await on(wave(60, 60)), { step: 1 });
  const { samples, frames } = await page.evaluate(() => ({
    samples: batten.input.cost.samples, frames: batten.loop.cost.frames }));
  assert.ok(samples >= sent.length, `${samples} of ${sent.length}`);
  assert.ok(frames < sent.length / 2, `${frames} frames for ${sent.length} samples`);
});

test('pressure goes with the stroke', async () => {
  await page.evaluate(() => {
    const engine = batten.engine;
    const plain = engine.pointer.bind(engine);
    globalThis.told = [];
    engine.pointer = (samples) => {
      globalThis.told.push(...samples);
      plain(samples);
    };
  });
  await hand.stroke(await on(wave(60, 60)));
  const told = await page.evaluate(() => globalThis.told);
  const moves = told.filter((sample) => sample.phase === 2 && !sample.predicted);
  assert.ok(moves.length > 20);
  assert.ok(moves.every((sample) => sample.device === 1));
  assert.ok(moves[moves.length - 1].pressure > moves[0].pressure + 0.2);
  assert.ok(moves.some((sample) => sample.tiltX === 20));
  assert.ok(moves.every((sample, i) => i === 0 || sample.time >= moves[i - 1].time));
});

test('the wheel with Ctrl zooms about the pointer; fit brings the drawing back', async () => {
  const before = await state(page);
  // Wheel events have whole pixels only.
  const [x, y] = [640, 391];
  const [dx, dy] = await page.evaluate(([px, py]) => {
    const { x: left, y: top, zoom } = batten.painter.painted;
    const box = document.getElementById('stage').getBoundingClientRect();
    return [(px - box.left) / zoom + left, (py - box.top) / zoom + top];
  }, [x, y]);
  await page.mouse.move(x, y);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -300);
  await page.keyboard.up('Control');
  await settle(page);
  const after = await state(page);
  assert.ok(after.zoom > before.zoom * 1.2, `${before.zoom} to ${after.zoom}`);
  const [x1, y1] = await place(page, dx, dy);
  assert.ok(Math.hypot(x1 - x, y1 - y) < 0.5, 'the point under the pointer stays');
  assert.match(await page.textContent('#zoom'), /^[\d.]+ %$/);
  await page.click('#zoom');
  await page.click('#zoom-menu [data-command=view-fit]');
  await settle(page);
  assert.ok(Math.abs((await state(page)).zoom / before.zoom - 1) < 1e-9);
  assert.equal((await state(page)).unsaved, false);
});

test('two fingers zoom and pan', async () => {
  const before = await state(page);
  const [x, y] = await place(page, 500, 200);
  const frames = Array.from({ length: 12 }, (_, i) => [[x - 40 - 8 * i, y], [x + 40 + 8 * i, y]]);
  await hand.fingers([[frames[0][0]], ...frames]);
  const after = await state(page);
  assert.ok(after.zoom > before.zoom * 1.8, `${before.zoom} to ${after.zoom}`);
  assert.equal(after.digest, before.digest);
  const [x1] = await place(page, 500, 200);
  assert.ok(Math.abs(x1 - x) < 12, 'the middle between the fingers stays');
});

test('after the pen a finger only moves the view', async () => {
  await hand.stroke(await on(wave(60, 60)));
  const before = await state(page);
  const [x, y] = await place(page, 500, 380);
  await hand.fingers(Array.from({ length: 12 }, (_, i) => [[x + 10 * i, y - 5 * i]]));
  const after = await state(page);
  assert.equal(after.digest, before.digest);
  const [x1, y1] = await place(page, 500, 380);
  assert.ok(x1 - x > 60 && y - y1 > 30, `moved by ${x1 - x}, ${y1 - y}`);
});

test('a second contact does not end a stroke', async () => {
  const count = await objects();
  const points = await on(wave(60, 60));
  await hand.stroke(points, {
    during: async () => {
      await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x: 900, y: 600, id: 7 }] });
      await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
      await settle(page);
      assert.equal(await objects(), count, 'still drawing');
    },
  });
  assert.equal(await objects(), count + 1);
});

test('Space and a drag move the view', async () => {
  const before = await state(page);
  const [x, y] = await place(page, 500, 200);
  await page.keyboard.down('Space');
  await hand.stroke([[x, y], [x + 90, y + 40]], { pointerType: 'mouse' });
  await page.keyboard.up('Space');
  const [x1, y1] = await place(page, 500, 200);
  assert.ok(Math.abs(x1 - x - 90) < 1 && Math.abs(y1 - y - 40) < 1, `moved by ${x1 - x}, ${y1 - y}`);
  assert.equal((await state(page)).digest, before.digest);
});

test('a commit repaints a part, not the whole', async () => {
  await settle(page);
  const before = (await state(page)).counts;
  await hand.stroke(await on(wave(60, 60)));
  const after = (await state(page)).counts;
  assert.equal(after.full, before.full);
  assert.ok(after.part >= before.part + 1 && after.part <= before.part + 2);
});

test('what is painted in parts is what is painted whole', async () => {
  await hand.stroke(await on(bezier([440, 137], [490, 103], [560, 92], [690, 114])));
  await hand.stroke(await on(wave(60, 60)));
  await hand.hover(await place(page, 20, 400));
  const different = await page.evaluate(async () => {
    const canvas = document.getElementById('still');
    const read = () => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    const parts = read();
    batten.painter.retheme();
    batten.wake();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const whole = read();
    let count = 0;
    for (let i = 0; i < whole.length; i++) {
      // A curve cut into other pieces is flattened slightly differently; a missing or stale line differs far more.
      count += Math.abs(whole[i] - parts[i]) > 90 ? 1 : 0;
    }
    return count;
  });
  assert.equal(different, 0);
});

test('the tolerance is shown in pixels and in units, and can be set', async () => {
  await page.fill('#readout-tolerance', '2.5');
  await page.press('#readout-tolerance', 'Enter');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.get('tolerance')), 2.5);
  const { zoom } = await state(page);
  assert.ok((await page.textContent('#readouts')).includes(`= ${Number((2.5 / zoom).toFixed(3))} px in the drawing`));
  assert.equal(await page.evaluate(() => document.activeElement === document.body), true);
  await page.press('#readout-tolerance', 'ArrowUp');
  assert.equal(await page.evaluate(() => batten.engine.get('tolerance')), 2.6);
});
