// From the page into the room and home again: a jug's rim is redrawn by the pen and the page is as it was; ten random gestures
// and one way home; everything by the keyboard alone; three points and the dial's faces give planes.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, quiet, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const EXAMPLES = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples');
const JUG = fs.readFileSync(path.join(EXAMPLES, 'jug.batten'));
const CAR = fs.readFileSync(path.join(EXAMPLES, 'car.svg'));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const tilt = (page) => page.evaluate(() => glance().tilt);
const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `rim-${name}.png`) });
/** Keeps what is painted of the drawing under a name, painted in one piece: the soft edge of a line is another one by some
 * shades where only a part is painted anew. */
async function keep(page, name) {
  await page.evaluate(() => {
    batten.painter.retheme();
    batten.wake();
  });
  await quiet(page);
  await page.evaluate((as) => {
    const { width, height } = batten.painter.still;
    globalThis.kept = { ...globalThis.kept, [as]: batten.painter.still.getContext('2d').getImageData(0, 0, width, height) };
  }, name);
}
/** The box of the pixels in which two kept pictures differ; null: none. */
const differs = (page, a, b) => page.evaluate(([one, other]) => {
  const [p, q] = [globalThis.kept[one], globalThis.kept[other]];
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < p.data.length; i += 4) {
    if ([0, 1, 2, 3].some((k) => p.data[i + k] !== q.data[i + k])) {
      const [x, y] = [(i / 4) % p.width, Math.floor(i / 4 / p.width)];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  }
  return box[0] <= box[2] ? box : null;
}, [a, b]);

/** The near half of the jug's rim, from left to right, in pixels of the window; and the jug's number. */
const rim = (page) => page.evaluate(() => {
  const { clip, items } = batten.loop.space.read();
  const jug = items.find(({ kind }) => kind === 0);
  const { rows, columns, id } = jug;
  const all = new Float32Array(batten.engine.wasm.memory.buffer, jug.vertices, 7 * rows * columns).slice();
  const point = (i, j) => [...all.slice(7 * (i * columns + j), 7 * (i * columns + j) + 3)];
  const edges = [
    Array.from({ length: columns }, (_, j) => point(0, j)), Array.from({ length: columns }, (_, j) => point(rows - 1, j)),
    Array.from({ length: rows }, (_, i) => point(i, 0)), Array.from({ length: rows }, (_, i) => point(i, columns - 1)),
  ];
  const round = (edge) => Math.max(...edge.map((at) => Math.hypot(...at.map((x, d) => x - edge[0][d]))));
  const pole = edges.findIndex((edge) => round(edge) < 1e-3);
  const stage = document.getElementById('still').getBoundingClientRect();
  const seen = edges[pole ^ 1].map(([x, y, z]) => {
    const at = (k) => clip[k] * x + clip[4 + k] * y + clip[8 + k] * z + clip[12 + k];
    return [stage.left + ((at(0) / at(3) + 1) / 2) * stage.width, stage.top + ((1 - at(1) / at(3)) / 2) * stage.height, at(2) / at(3)];
  });
  const middle = (seen.reduce((sum, at) => sum + at[2], 0)) / seen.length;
  const near = seen.filter((at) => at[2] < middle).sort((a, b) => a[0] - b[0]);
  return { id, near: near.map(([x, y]) => [x, y]) };
});

test('a jug\'s rim is redrawn in the room, and at home the page is as it was', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  await page.locator('#first button').click();
  await page.locator('#stage').focus();
  await page.keyboard.press('f');
  await quiet(page);
  const begun = await state(page);
  await keep(page, 'before');
  await page.keyboard.press('b');
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
  }
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  await page.keyboard.press('f');
  await quiet(page);
  const { id, near } = await rim(page);
  const pick = (from, to, down = 0) => near.slice(Math.round(from * near.length), Math.round(to * near.length))
    .map(([x, y]) => [x, y + down]);
  hand.rest(2);
  await hand.stroke(pick(0.35, 0.65, 2), { pointerType: 'pen' }); // on the near side of the wall
  await settle(page);
  await shot(page, 'lit');
  const line = pick(0.2, 0.8);
  const lifted = line.map(([x, y], i) => [x, y - 14 * Math.sin((Math.PI * i) / (line.length - 1)) ** 2]);
  hand.rest(2);
  await hand.stroke(lifted, { pointerType: 'pen', during: () => shot(page, 'drawing') });
  await quiet(page);
  await shot(page, 'redrawn');
  const now = await state(page);
  assert.notEqual(now.digest, begun.digest, now.notice);
  assert.equal(now.check, '');
  await page.keyboard.press('Escape');
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await tilt(page), 0);
  await keep(page, 'home');
  const jug = await page.evaluate((own) => {
    const frame = glance();
    const item = batten.painter.list.find(({ item: { id: one } }) => one === own).item;
    return [item.x0 + frame.originX, item.y0 + frame.originY, item.x1 + frame.originX, item.y1 + frame.originY]
      .map((value, i) => (value - (i & 1 ? frame.y : frame.x)) * frame.zoom);
  }, id);
  const changed = await differs(page, 'before', 'home');
  if (changed) { // only where the jug is
    assert.ok(changed[0] >= jug[0] - 3 && changed[1] >= jug[1] - 3 && changed[2] <= jug[2] + 3 && changed[3] <= jug[3] + 3,
      `${changed} beside ${jug}`);
  }
  while ((await state(page)).digest !== begun.digest) {
    await page.keyboard.press('Control+z');
    await settle(page);
  }
  await page.keyboard.press('Escape');
  await quiet(page);
  await keep(page, 'undone');
  assert.equal(await differs(page, 'before', 'undone'), null, 'to the pixel');
});

test('after ten random gestures one key is home', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: CAR });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  await quiet(page);
  assert.equal(await page.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => /stage\/space/.test(name))), false,
    'nothing of space is fetched for a drawing in the page');
  const begun = await state(page);
  await keep(page, 'before');
  let seed = 20;
  const any = (low, high) => {
    seed = (seed * 1664525 + 1013904223) % 4294967296;
    return low + ((high - low) * seed) / 4294967296;
  };
  await hand.stroke([[600, 400], [640, 320]], { pointerType: 'mouse', button: 'right' });
  for (let i = 0; i < 9; i++) {
    const [x, y] = [any(300, 900), any(200, 600)];
    const to = [x + any(-120, 120), y + any(-60, 60)];
    const kind = i % 4;
    if (kind === 0) {
      await hand.stroke([[x, y], to], { pointerType: 'mouse', button: 'right' });
    } else if (kind === 1) {
      await hand.stroke([[x, y], to], { pointerType: 'mouse', button: 'middle' });
    } else if (kind === 2) {
      await page.mouse.move(x, y);
      await page.keyboard.down('Control');
      await page.mouse.wheel(0, any(-200, 200));
      await page.keyboard.up('Control');
    } else {
      await page.keyboard.press(['7', '8', 'Shift+P', 'Shift+Alt+ArrowLeft'][Math.floor(any(0, 4))]);
    }
    await settle(page);
    assert.ok(await tilt(page) > 0);
  }
  await quiet(page);
  await shot(page, 'lost');
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await tilt(page), 0);
  await keep(page, 'home');
  assert.equal(await differs(page, 'before', 'home'), null, 'to the pixel');
  const now = await state(page);
  assert.equal(now.digest, begun.digest);
  assert.equal(now.unsaved, false);
});

test('by keys alone: orbit, look, plane, home', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { viewport: { width: 640, height: 480 } });
  await page.reload(); // it opens as it was left, face-on
  await ready(page);
  await page.locator('#stage').focus();
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => /stage\/space/.test(name)),
    null, { timeout: 10000 }); // a surface is there
  assert.equal(await page.evaluate(() => batten.loop.space === undefined), true);
  const begun = await state(page);
  await keep(page, 'before');
  for (const key of ['Shift+Alt+ArrowUp', 'Shift+Alt+ArrowUp', 'Shift+Alt+ArrowRight']) {
    await page.keyboard.press(key);
  }
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  assert.equal(await tilt(page), 30);
  await page.keyboard.press('x');
  await settle(page);
  assert.match((await state(page)).notice, /Zebra/);
  await page.keyboard.press('Shift+J');
  await settle(page);
  const planed = await state(page);
  assert.notEqual(planed.digest, begun.digest);
  assert.match(planed.hint, /plane/);
  await shot(page, 'keys');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await tilt(page), 0);
  assert.equal((await state(page)).digest, begun.digest);
  await keep(page, 'home');
  assert.equal(await differs(page, 'before', 'home'), null, 'to the pixel');
});

test('a face of the dial and three taps give planes', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  await page.locator('#first button').click();
  await page.locator('#stage').focus();
  const begun = await state(page);
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
    await page.keyboard.press('Shift+Alt+ArrowLeft');
  }
  await page.keyboard.press('f');
  await quiet(page);
  await shot(page, 'faces');
  // Where the face is: the middle of its corners.
  const [x, y] = await page.locator('.dial [data-command=plane-side]').evaluate((face) => {
    const box = face.getBoundingClientRect();
    const corners = [...getComputedStyle(face).clipPath.matchAll(/([-\d.]+)px ([-\d.]+)px/g)];
    return [1, 2].map((k) => corners.reduce((sum, corner) => sum + Number(corner[k]), 0) / corners.length + (k === 1 ? box.left : box.top));
  });
  await page.mouse.click(x, y);
  await settle(page);
  const one = await state(page);
  assert.notEqual(one.digest, begun.digest);
  assert.ok(await tilt(page) > 0, 'not the way home');
  assert.match(one.hint, /plane/);
  await page.evaluate(() => {
    batten.engine.command('plane-of-points');
    batten.wake();
  });
  await settle(page);
  assert.match((await state(page)).hint, /three points/);
  for (const [px, py] of [[500, 330], [700, 360], [610, 520]]) {
    hand.rest(2);
    await hand.stroke([[px, py], [px, py]], { pointerType: 'pen' });
    await settle(page);
  }
  await shot(page, 'three');
  const three = await state(page);
  assert.notEqual(three.digest, one.digest, three.notice);
  assert.equal(three.check, '');
  await page.keyboard.press('5');
  await quiet(page);
  for (let i = 0; i < 2; i++) {
    await page.keyboard.press('Control+z');
    await quiet(page);
  }
  assert.equal((await state(page)).digest, begun.digest);
});
