// The tilted view: a right drag and three fingers turn it, home brings back the very same pixels, and what is not ready
// for it says so and offers the way home.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { densify, launch, open, pictures, quiet, ready, SCREENSHOTS, settle, state, until } from './page.mjs';
import { fileURLToPath } from 'node:url';
import { serve } from './server.mjs';

const CAR = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/car.svg'));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** What is painted of the drawing. */
const pixels = async (page) => createHash('sha1').update(await page.evaluate(() =>
  document.getElementById('still').toDataURL())).digest('hex');
const tilt = (page) => page.evaluate(() => glance().tilt);

test('a right drag tilts the page, 5 brings it home', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `space-${name}`);
  await page.keyboard.press('Shift+G');
  await quiet(page);
  const first = await state(page);
  const before = await pixels(page);
  const orbit = (to, during) => hand.stroke([[600, 400], to], { pointerType: 'mouse', button: 'right', during });
  await orbit([640, 290], () => shot('orbit'));
  assert.ok(await tilt(page) > 40);
  await shot('tilted');
  await orbit([560, 150]);
  assert.ok(await tilt(page) > 100);
  await shot('behind');
  await page.keyboard.press('Shift+H'); // a guide
  await settle(page);
  const now = await state(page);
  assert.equal(now.digest, first.digest, 'nothing is changed where it was not shown');
  await shot('refused');
  await page.locator('#notice button').click();
  await quiet(page);
  assert.equal(await tilt(page), 0);
  assert.equal(await pixels(page), before, 'the page is as it was, to the pixel');
  await page.keyboard.press('Shift+Z');
  await quiet(page);
  assert.ok(await tilt(page) > 100, 'a step back');
  assert.equal((await state(page)).digest, first.digest);
  assert.equal((await state(page)).check, '');
});

test('the dial: a drag turns, a tap brings home, its ends are views', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { locale: 'ko-KR' });
  await page.waitForSelector('.dial svg');
  await quiet(page);
  const before = await pixels(page);
  const box = await page.locator('.dial').boundingBox();
  assert.deepEqual([box.width, box.height], [44, 44]);
  const [x, y] = [box.x + 22, box.y + 22];
  await hand.stroke([[x, y], [x + 20, y - 45]], { pointerType: 'mouse' });
  await quiet(page);
  assert.ok(await tilt(page) > 30);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'space-dial.png') });
  await page.locator('.dial [data-command=view-side]').click();
  await quiet(page);
  assert.equal(await tilt(page), 90);
  await page.locator('.dial [data-command=view-upright]').focus();
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.equal(await tilt(page), 0);
  assert.equal(await pixels(page), before);
  const names = await page.locator('.dial [data-command]').evaluateAll((all) => all.map((one) => one.title));
  assert.equal(new Set(names).size, 7);
  assert.ok(names.every((name) => /[가-힣]/.test(name)), names.join());
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('9');
  await quiet(page);
  assert.equal(await tilt(page), 0);
});

test('with reduced motion the view is home at once', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { reducedMotion: 'reduce' });
  await page.keyboard.press('7');
  await page.keyboard.press('5');
  await settle(page);
  assert.equal(await tilt(page), 0);
});

test('a pen draws and redraws on the tilted page', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `space-${name}`);
  const first = await state(page);
  const before = await pixels(page);
  await hand.stroke([[600, 400], [660, 300]], { pointerType: 'mouse', button: 'right' });
  await hand.hover([400, 620]);
  assert.match((await state(page)).hint, /^On the page/);
  await shot('disc');
  await hand.stroke([[360, 640], [460, 600], [560, 640], [700, 590]], { during: () => shot('drawing') });
  const drawn = await state(page);
  assert.notEqual(drawn.digest, first.digest);
  await hand.stroke([[400, 640], [470, 560], [560, 600]], { during: () => shot('redrawing') });
  assert.equal((await state(page)).check, '');
  await page.keyboard.press('5');
  await quiet(page);
  await shot('drawn');
  await page.keyboard.press('Shift+Z');
  await quiet(page);
  while ((await state(page)).digest !== first.digest) {
    await page.keyboard.press('Control+z');
    await settle(page);
  }
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await pixels(page), before, 'undone, the page is as it was, to the pixel');
});

test('a line, a spline and the eraser on the tilted page', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `space-${name}`);
  const first = await state(page);
  const before = await pixels(page);
  const changed = async (since) => {
    await quiet(page);
    const now = await state(page);
    assert.equal(now.check, '');
    assert.notEqual(now.digest, since);
    return now.digest;
  };
  await hand.stroke([[600, 400], [660, 300]], { pointerType: 'mouse', button: 'right' });
  await page.keyboard.press('l');
  await hand.hover([360, 640]);
  assert.match((await state(page)).hint, /^On the page/);
  hand.rest(1);
  await hand.stroke([[360, 640], [520, 600]], { during: () => shot('line') });
  let now = await changed(first.digest);
  await page.keyboard.press('Enter');
  await page.keyboard.press('p');
  for (const [from, to] of [[[360, 690], [400, 660]], [[520, 700], [540, 690]], [[640, 640], [680, 650]]]) {
    hand.rest(1);
    await hand.stroke([from, to], { during: () => shot('tangents-turning') });
  }
  now = await changed(now);
  await hand.hover([700, 690]);
  await shot('tangents');
  await page.keyboard.press('Enter');
  await page.keyboard.press('e');
  hand.rest(1);
  await hand.stroke([[440, 560], [460, 730]], { during: () => shot('erasing') });
  now = await changed(now);
  await shot('erased');
  while ((await state(page)).digest !== first.digest) {
    await page.keyboard.press('Control+z');
    await settle(page);
  }
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await pixels(page), before, 'undone, the page is as it was, to the pixel');
});

test('three fingers turn the view, a tap of three does not', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { hasTouch: true });
  const before = await pixels(page);
  const at = (dx, dy) => [[500, 420], [570, 430], [640, 420]].map(([x, y]) => [x + dx, y + dy]);
  const down = [at(0, 0).slice(0, 1), at(0, 0).slice(0, 2), at(0, 0)];
  await hand.fingers([...down, at(3, 4)]);
  assert.equal(await tilt(page), 0);
  hand.rest(2);
  await hand.fingers([...down, ...Array.from({ length: 10 }, (_, i) => at(3 * i, -10 * i))]);
  assert.ok(await tilt(page) > 20);
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await pixels(page), before);
});

test('the barrel button of the pen turns a tilted view, and only that', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const barrel = (during) => hand.stroke([[560, 640], [660, 590]], { pointerType: 'pen', button: 'right', during });
  await barrel();
  assert.equal(await tilt(page), 0, 'face-on it keeps its property: it smooths');
  for (let i = 0; i < 2; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
  }
  await quiet(page);
  assert.equal(await tilt(page), 30);
  const first = await state(page);
  const angle = await page.evaluate(() => glance().angle);
  await barrel(() => page.screenshot({ path: path.join(SCREENSHOTS, 'space-barrel.png') }));
  await quiet(page);
  assert.notEqual(await tilt(page), 30);
  assert.notEqual(await page.evaluate(() => glance().angle), angle);
  assert.equal((await state(page)).digest, first.digest, 'nothing was drawn');
  await hand.stroke([[360, 640], [460, 600], [560, 640]]);
  assert.notEqual((await state(page)).digest, first.digest, 'without the button the pen draws');
  assert.equal((await state(page)).check, '');
});

test('two fingers that twist roll the page face-on, and never tilt it', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { hasTouch: true });
  const twist = (from, to) => hand.fingers([0, ...Array.from({ length: 21 }, (_, i) => i / 20)].map((share, k) => {
    const turn = ((from + (to - from) * share) * Math.PI) / 180;
    const [x, y] = [110 * Math.cos(turn), 110 * Math.sin(turn)];
    return [[600 - x, 420 - y], [600 + x, 420 + y]].slice(0, k === 0 ? 1 : 2);
  }));
  const angle = () => page.evaluate(() => glance().angle);
  await twist(0, 40);
  await quiet(page);
  assert.ok(Math.abs(Math.abs(await angle()) - 40) < 8, String(await angle()));
  assert.equal(await tilt(page), 0);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'space-twist.png') });
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await angle(), 0);
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await quiet(page);
  const was = [await angle(), await tilt(page)];
  hand.rest(2);
  await twist(0, 40);
  await quiet(page);
  assert.deepEqual([await angle(), await tilt(page)], was, 'tilted, two fingers only pan and zoom');
});

const WAVE = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 700"><path d="M200 400C400 250 600 550 800 400" fill="none" stroke="#000" stroke-width="3"/></svg>';

/** Where the only line is seen in the tilted view, in pixels of the window. */
const seenLine = (page) => page.evaluate(() => {
  const { clip, items } = batten.loop.space.read();
  const { rows, vertices } = items.find(({ kind }) => kind === 1);
  const all = [...new Float32Array(batten.engine.wasm.memory.buffer, vertices, 4 * rows)];
  const stage = document.getElementById('still').getBoundingClientRect();
  return Array.from({ length: rows - 2 }, (_, i) => {
    const [x, y, z] = all.slice(4 * (i + 1));
    const at = (k) => clip[k] * x + clip[4 + k] * y + clip[8 + k] * z + clip[12 + k];
    return [stage.left + ((at(0) / at(3) + 1) / 2) * stage.width, stage.top + ((1 - at(1) / at(3)) / 2) * stage.height];
  });
});

test('a finger pulls a curve off the page by its second view, and draws lines; the page stays to the pixel', async (t) => {
  const server = await serve({ name: 'wave.svg', bytes: Buffer.from(WAVE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { hasTouch: true });
  const finger = (points) => hand.fingers(densify(points, 6).map((at) => [at]));
  const before = await pixels(page);
  const first = await state(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('u');
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
  }
  await quiet(page);
  await page.waitForFunction(() => batten.loop.space?.read());
  const line = await seenLine(page);
  const [low, high] = [line[0][0], line.at(-1)[0]];
  await finger(line.map(([x, y]) => [x, y - 90 * Math.sin((Math.PI * (x - low)) / (high - low))]));
  await quiet(page);
  const lifted = await state(page);
  assert.equal(lifted.check, '');
  assert.notEqual(lifted.digest, first.digest);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'space-lift-touch.png') });
  const now = await seenLine(page);
  const middle = (points) => points.reduce((best, at) => (Math.abs(at[0] - 640) < Math.abs(best[0] - 640) ? at : best));
  assert.ok(Math.abs(middle(now)[1] - (middle(line)[1] - 90)) < 12, 'its second view is the stroke');
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await pixels(page), before, 'its first view is what it was');
  await page.keyboard.press('7');
  await page.keyboard.press('Shift+Alt+ArrowDown');
  await page.keyboard.press('l');
  await quiet(page);
  hand.rest(2);
  await finger([[500, 560], [700, 600]]);
  await quiet(page);
  const drawn = await state(page);
  assert.equal(drawn.check, '');
  assert.notEqual(drawn.digest, lifted.digest, 'a line on the tilted page');
  await page.keyboard.press('Enter');
  while ((await state(page)).digest !== first.digest) {
    await page.keyboard.press('Control+z');
    await settle(page);
  }
});

test('a drawing in space opens from three quarters, and later as it was left', async (t) => {
  const jug = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/jug.batten'));
  const server = await serve({ name: 'jug.batten', bytes: jug });
  t.after(() => server.close());
  const context = await browser.newContext();
  const page = await context.newPage();
  const opened = async (room) => {
    await ready(page);
    await until(page, (wanted) => batten.dial && batten.engine.number('room').split(' ').map((angle) => Math.round(Number(angle))).join() === wanted, room);
    await quiet(page);
  };
  await page.goto(server.address);
  await opened('30,65,0');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'space-opened.png') });
  const [dial, looks, deep] = await Promise.all(['.dial', '.looks button', '.deep'].map((one) => page.locator(one).boundingBox()));
  assert.ok(looks.y >= dial.y + dial.height && deep.x + deep.width <= dial.x, 'what is beside the dial does not lie over it');
  await page.keyboard.press('Shift+Alt+ArrowLeft');
  await opened('45,65,0');
  await page.reload();
  await opened('45,65,0');
  await page.keyboard.press('5');
  await until(page, () => JSON.parse(batten.engine.number('view')).view[4] === 0);
});
