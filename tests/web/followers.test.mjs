// What follows a curve while the pen is down: the lines of a surface as it will be, torn edges in red, folds hatched, and the numbers
// behind the hint, those of a made surface too (twist and scale, angle).
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { bezier, launch, open, pictures, place, quiet, state } from './page.mjs';
import { serve } from './server.mjs';

const SIDE = 24;
const even = [0, 0, 0, ...Array.from({ length: SIDE - 2 }, (_, i) => i), SIDE - 3, SIDE - 3, SIDE - 3];
const points = Array.from({ length: SIDE }, (_, i) => Array.from({ length: SIDE }, (_, j) => [
  60 + (400 * i) / (SIDE - 1), 120 + (460 * j) / (SIDE - 1), 0,
]));
const BEND = [[190, 520], [190, 120], [330, 120], [330, 520]];
const PATH = [[620, 560], [620, 190], [860, 190], [860, 560]];
const cubic = [0, 0, 0, 0, 1, 1, 1, 1];
const bytes = Buffer.from(JSON.stringify({
  batten: 2, page: [0, 0, 1000, 700], next: 5, objects: [
    { id: 1, kind: 'surface', name: 'sheet', style: { stroke: '#22262bff', width: 1 },
      surface: { degree: [3, 3], closed: [false, false], knots: [even, even], points } },
    { id: 2, kind: 'path', name: 'wire', curves: [{ degree: 3, knots: cubic, points: BEND }] },
    { id: 3, kind: 'path', name: 'path', curves: [{ degree: 3, knots: cubic, points: PATH }] },
    { id: 4, kind: 'path', name: 'profile', curves: [{ degree: 1, knots: [0, 0, 1, 1], points: [[560, 630], [680, 630]] }] },
  ],
}));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('torn edges, folds and numbers before the pen is lifted', async (t) => {
  const server = await serve({ name: 'followers.batten', bytes });
  t.after(() => server.close());
  const { page, context, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `followers-${name}`);
  const button = (name) => page.locator('#actions button', { has: page.locator(`use[href$="icon-${name}"]`) });
  const select = async (...ids) => {
    await page.evaluate((all) => {
      const { engine } = globalThis.batten;
      all.forEach((id, i) => engine.wasm.editor_select(engine.editor, id, i > 0 ? 1 : 0));
      globalThis.batten.panel.wake();
    }, ids);
    await quiet(page);
  };
  /** Redraws a stretch of a bend, its middle pushed aside. */
  const redraw = async (bend, [from, to], [dx, dy], during) => {
    hand.rest(2);
    const line = bezier(...bend, 60).slice(from, to + 1);
    const share = (i) => Math.sin((Math.PI * i) / (to - from)) ** 2;
    await hand.stroke(await Promise.all(line.map(([x, y], i) => place(page, x + dx * share(i), y + dy * share(i)))), { during });
    await quiet(page);
  };
  const fresh = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await select(1, 2);
  await button('wire-bind').click();
  await quiet(page);
  await shot('bound');
  await page.keyboard.press('n');
  let during;
  await redraw(BEND, [8, 31], [-40, 0], async () => {
    during = await state(page);
    await shot('torn');
  });
  assert.match(during.hint, /\d+ points move, by up to [\d.]+ px, \d+ torn edges/);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('v');
  await select(3, 4);
  await button('surface-sweep').click();
  await quiet(page);
  const swept = await state(page);
  assert.equal(swept.check, '');
  assert.match(swept.hint, /places folded over: 1, twist 0°, scale 1 at the end$/);
  await shot('swept');
  await page.keyboard.press('n');
  await redraw(PATH, [6, 26], [-30, 0], async () => {
    during = await state(page);
    await shot('folded');
  });
  assert.match(during.hint, /places folded over: [1-9]\d*, twist 0°, scale 1 at the end$/);
  await quiet(page);
  await shot('after');
  for (let i = 0; i < 6 && (await state(page)).digest !== fresh.digest; i++) {
    await page.keyboard.press('Control+z');
    await quiet(page);
  }
  assert.equal((await state(page)).digest, fresh.digest);
  await context.close();
});
