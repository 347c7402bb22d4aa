// The tangents tool in the page, with a pen: points, directions, tension, values, and what remains after a reload.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { hintFor, launch, open, pictures, place, settle, state, texts } from './page.mjs';
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
const labels = (page) => page.evaluate(() => glance().labels.map((label) => label.text));
/** The native document's last object. */
const newest = (page) => page.evaluate(() =>
  JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.at(-1));

async function tap(page, hand, point) {
  hand.rest(0.45); // two taps, not a double one
  await hand.stroke([point]);
}

/** Ends of a direction's arrow at a window position: the circle's radius is 44 px. */
const around = ([x, y], degrees, radius = 44) =>
  [x + radius * Math.cos((degrees * Math.PI) / 180), y + radius * Math.sin((degrees * Math.PI) / 180)];

const SPOTS = [[300, 560], [470, 420], [640, 560], [820, 440], [1000, 540]];

test('points, directions and tension with a pen', async () => {
  const blank = await serve();
  const { page, hand, context } = await open(browser, blank.address);
  const strings = await texts(page);
  const shot = (name) => pictures(page, `tangents-${name}`);
  const count = await objects(page);
  await page.keyboard.press('p');
  await settle(page);
  assert.equal((await state(page)).hint, hintFor(strings['hint.place'], 'mouse'));
  for (const spot of SPOTS.slice(0, 4)) {
    await tap(page, hand, spot);
  }
  await hand.hover([960, 560]);
  await shot('placing');
  assert.equal((await state(page)).hint, hintFor(strings['hint.place-next']));
  await tap(page, hand, SPOTS[4]);
  await page.keyboard.press('Enter');
  assert.equal(await objects(page), count + 1);
  const plain = await newest(page);
  assert.equal(plain.kind, 'spline');
  assert.equal(plain.spline.points.length, 5);
  assert.equal(plain.spline.tangents, undefined);

  // The arrow of the middle point: dragged to the horizontal, through all directions outside the wedge.
  await tap(page, hand, SPOTS[2]);
  await hand.hover(around(SPOTS[2], 30));
  await shot('chosen');
  const turn = Array.from({ length: 12 }, (_, i) => around(SPOTS[2], 30 + 5 * i));
  await hand.stroke(turn, { during: async () => {
    assert.equal((await state(page)).hint, strings['hint.beyond']);
    assert.ok((await labels(page)).includes(strings['value.beyond']));
    await shot('beyond');
  } });
  await hand.stroke(Array.from({ length: 18 }, (_, i) => around(SPOTS[2], 85 - 5 * i)), { during: async () => {
    const shown = await labels(page);
    assert.match(shown[0], /^in \d+\.\d°\s+out \d+\.\d°$/);
    assert.match(shown[1], /^k 0\.\d{3} \| 0\.\d{3}$/);
    await shot('inside');
  } });
  const turned = await newest(page);
  const [dx, dy] = turned.spline.tangents[2];
  assert.ok(Math.abs(Math.atan2(dy, dx)) < 0.02, 'the direction is where the pen left it');
  assert.equal(turned.spline.tangents[1], null);

  // Farther out: tension.
  await hand.stroke([around(SPOTS[2], 0), around(SPOTS[2], 0, 124)], { during: () => shot('tension') });
  const pulled = await newest(page);
  assert.ok(Math.abs(pulled.spline.tension[2][0] - 2) < 0.05);

  // A double tap resets both.
  hand.rest(0.45);
  await hand.stroke([SPOTS[2]]);
  await hand.stroke([SPOTS[2]]);
  assert.equal((await newest(page)).spline.tangents, undefined);
  assert.equal((await state(page)).check, '');

  // The journal replays to the same document.
  const { digest } = await state(page);
  assert.ok(await page.evaluate(() => batten.engine.replay(batten.engine.journal.slice())));
  assert.equal((await state(page)).digest, digest);
  await context.close();
  blank.close();
});

test('closing, moving, inserting, deleting, and a stroke that frees the curve', async () => {
  const blank = await serve();
  const { page, hand, context } = await open(browser, blank.address);
  const strings = await texts(page);
  await page.keyboard.press('p');
  for (const spot of SPOTS.slice(0, 3)) {
    await tap(page, hand, spot);
  }
  await tap(page, hand, SPOTS[0]);
  assert.equal((await state(page)).notice, strings['notice.closed']);
  assert.equal((await newest(page)).spline.closed, true);
  await hand.stroke([SPOTS[1], [480, 380]]);
  const [x, y] = (await newest(page)).spline.points[1];
  const [px, py] = await place(page, x, y);
  assert.ok(Math.hypot(px - 480, py - 380) < 0.1, 'the point is where the pen left it');
  const { digest } = await state(page);

  await page.keyboard.press('Insert');
  assert.equal((await newest(page)).spline.points.length, 4);
  await settle(page);
  assert.match((await state(page)).notice, /0\.000 px/);
  await page.keyboard.press('Delete');
  assert.equal((await newest(page)).spline.points.length, 3);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).digest, digest);

  // The sketch tool draws over a stretch of it.
  await page.keyboard.press('n');
  const along = await page.evaluate(() => {
    const f = glance();
    const item = f.still.at(-1);
    const p = item.path; // move x y, cubic ...
    const at = (t, k) => {
      const s = 1 - t;
      return s * s * s * p[1 + k] + 3 * s * s * t * p[4 + k] + 3 * s * t * t * p[6 + k] + t * t * t * p[8 + k];
    };
    return Array.from({ length: 20 }, (_, i) => [at(0.2 + i * 0.03, 0) + f.originX, at(0.2 + i * 0.03, 1) + f.originY]);
  });
  const stroke = await Promise.all(along.map(([u, v], i) =>
    place(page, u, v - 6 * Math.sin((Math.PI * i) / 19))));
  await hand.stroke(stroke);
  assert.equal((await newest(page)).kind, 'path');
  assert.equal((await state(page)).notice, strings['notice.freed']);
  await page.keyboard.press('Control+z');
  assert.equal((await newest(page)).kind, 'spline');
  assert.equal((await state(page)).digest, digest);
  await context.close();
  blank.close();
});

test('the keyboard alone: choose, turn, read, convert', async () => {
  const blank = await serve();
  const { page, hand, context } = await open(browser, blank.address);
  await page.keyboard.press('p');
  for (const spot of SPOTS.slice(0, 3)) {
    await tap(page, hand, spot);
  }
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Shift+ArrowRight');
  const { spline } = await newest(page);
  assert.equal(spline.tangents.filter(Boolean).length, 1);
  assert.match((await labels(page))[0], /^out \d+\.\d°$/);
  await settle(page);
  assert.match(await page.textContent('#values'), /^out \d+\.\d°, tension|^out \d+\.\d°$/);
  await page.keyboard.press('d');
  assert.equal((await newest(page)).spline.tangents, undefined);
  await page.evaluate(() => batten.engine.command('free-curve'));
  assert.equal((await newest(page)).kind, 'path');
  await context.close();
  blank.close();
});

test('a spline beside a drawing: saved as SVG, it comes back as a spline', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await page.keyboard.press('p');
  for (const [x, y] of [[60, 60], [160, 100], [260, 60]]) {
    await tap(page, hand, await place(page, x, y));
  }
  await page.keyboard.press('Enter');
  const before = await newest(page);
  const again = await page.evaluate(async () => {
    await batten.files.open(batten.engine.save(false), 'again.svg');
    return JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.at(-1);
  });
  assert.deepEqual(again, before);
  await context.close();
});
