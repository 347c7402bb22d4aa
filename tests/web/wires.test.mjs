// Wires in the browser: a sheet is bound to a curve with a button of the bar; its tube of reach is shown face-on and in the
// tilted view; the wire is moved and the sheet follows; it is freed as it was; undo leads back. With touch, and by keys, too.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, pictures, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const SIDE = 20; // fine enough not to be refined when it is bound
const COLUMN = [[440, 180], [500, 280], [440, 400], [480, 520]];
const even = [0, 0, 0, ...Array.from({ length: SIDE - 2 }, (_, i) => i), SIDE - 3, SIDE - 3, SIDE - 3];
const points = Array.from({ length: SIDE }, (_, i) => Array.from({ length: SIDE }, (_, j) => [
  200 + (550 * i) / (SIDE - 1), 120 + (440 * j) / (SIDE - 1), 30 * Math.cos((11 * i) / (3 * (SIDE - 1))),
]));
const bytes = Buffer.from(JSON.stringify({
  batten: 2, page: [0, 0, 1000, 700], next: 3, objects: [
    { id: 1, kind: 'surface', name: 'sheet', surface: { degree: [3, 3], closed: [false, false], knots: [even, even], points } },
    { id: 2, kind: 'path', name: 'wire', curves: [{
      degree: 3, knots: [0, 0, 0, 0, 1, 1, 1, 1], points: COLUMN.map(([x, y]) => [x, y, 0]),
    }] },
  ],
}));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('a sheet is bound to a wire and follows it', async (t) => {
  const server = await serve({ name: 'bound.batten', bytes });
  t.after(() => server.close());
  const { page, context, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `wires-${name}`);
  const button = (name) => page.locator('#actions button', { has: page.locator(`use[href$="icon-${name}"]`) });
  const fresh = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await quiet(page);
  await shot('offered');
  await button('wire-bind').click();
  await quiet(page);
  const bound = await state(page);
  assert.notEqual(bound.digest, fresh.digest);
  assert.match(bound.notice, /^Bound: [1-9]\d* points follow the wire/);
  assert.equal(await button('wire-revert').count(), 1);
  await shot('bound');
  await page.keyboard.press('ArrowRight'); // the wire is selected: it is moved, and what it leads with it
  await quiet(page);
  const moved = await state(page);
  assert.notEqual(moved.digest, bound.digest);
  assert.equal(moved.check, '');
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, bound.digest);
  await page.keyboard.press('n'); // redrawn with a pen: the sheet is shown where it will be, with numbers
  const line = bezier(...COLUMN, 40).slice(6, 35);
  const over = await Promise.all(line.map(([x, y], i) => place(page, x + 60 * Math.sin((Math.PI * i) / 28) ** 2, y)));
  let during;
  await hand.stroke(over, { pointerType: 'pen', during: async () => {
    during = await state(page);
    await shot('redrawing');
  } });
  await quiet(page);
  assert.match(during.hint, /\d+ points move, by up to [\d.]+ px/);
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, bound.digest);
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, bound.digest);
  await page.keyboard.press('v');
  for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('Shift+Alt+ArrowLeft');
  await quiet(page);
  await shot('tilted');
  await button('wire-revert').click();
  await quiet(page);
  const freed = await state(page);
  assert.equal(freed.digest, fresh.digest);
  assert.equal(freed.check, '');
  await shot('freed');
  await context.close();
});

const saved = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
const wire = async (page) => (await saved(page)).find((one) => one.bound)?.bound.wires[0];
/** The stretch of the wire that is redrawn, pushed aside in the middle. */
const aside = (page) => Promise.all(bezier(...COLUMN, 40).slice(6, 35)
  .map(([x, y], i) => place(page, x + 60 * Math.sin((Math.PI * i) / 28) ** 2, y)));

test('with touch alone', async (t) => {
  const server = await serve({ name: 'bound.batten', bytes });
  t.after(() => server.close());
  const { page, context, hand } = await open(browser, server.address, { hasTouch: true });
  const shot = (name) => pictures(page, `wires-touch-${name}`);
  const button = (name) => page.locator('#actions button', { has: page.locator(`use[href$="icon-${name}"]`) });
  const tool = (name) => page.locator(`#rail [data-tool="${name}"], #rail button[data-name="tool-${name}"]`).first();
  const swipe = async (way, during) => {
    hand.rest(2);
    await hand.fingers(way.map((one) => [one]), { lift: false });
    await during?.();
    await hand.fingers([]);
    await quiet(page);
  };
  const between = (a, b, count = 20) => Array.from({ length: count + 1 }, (_, i) => a.map((from, k) => from + ((b[k] - from) * i) / count));
  const undo = async () => {
    hand.rest(2);
    await hand.tap(2, [900, 560]);
    await quiet(page);
  };
  const fresh = await state(page);
  await tool('select').tap();
  await quiet(page);
  await swipe(between(await place(page, 150, 90), await place(page, 800, 620)));
  await button('wire-bind').tap();
  await quiet(page);
  const bound = await state(page);
  assert.match(bound.notice, /^Bound: [1-9]\d* points follow the wire/);
  // The wall of the tube, beside the stop at three quarters: 30 px further away.
  const { radius } = await wire(page);
  const [at, beyond] = bezier(...COLUMN, 1000).slice(750, 752);
  const [dx, dy] = [beyond[0] - at[0], beyond[1] - at[1]];
  const out = [dy / Math.hypot(dx, dy), -dx / Math.hypot(dx, dy)];
  const wall = (more) => place(page, at[0] + (radius + more) * out[0], at[1] + (radius + more) * out[1]);
  await swipe(between(await wall(0), await wall(-40)), () => shot('radius'));
  const narrower = await wire(page);
  assert.ok(narrower.radius.values.some((value) => Math.abs(value - radius) < 1e-9));
  assert.ok(narrower.radius.values.some((value) => Math.abs(value - radius + 40) < 8));
  const narrow = await state(page);
  await tool('sketch').tap();
  await quiet(page);
  let during;
  await swipe(await aside(page), async () => {
    during = await state(page);
    await shot('redrawing');
  });
  assert.match(during.hint, /\d+ points move, by up to [\d.]+ px/);
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, narrow.digest);
  await tool('select').tap();
  const on = await place(page, 440 + 30, 300);
  await swipe([on, on]);
  const others = () => button('wire-bake').isVisible();
  for (let i = 0; i < 4 && !await others(); i++) await swipe([on, on]); // what lies below
  await button('wire-bake').tap();
  await quiet(page);
  assert.equal(await wire(page), undefined);
  assert.match((await state(page)).notice, /^Detached; it keeps its shape/);
  await shot('baked');
  await undo();
  assert.equal((await state(page)).digest, redrawn.digest);
  await button('wire-revert').tap();
  await quiet(page);
  assert.equal(await wire(page), undefined);
  await shot('reverted');
  for (let i = 0; i < 3; i++) await undo();
  assert.equal((await state(page)).digest, bound.digest);
  await undo();
  assert.equal((await state(page)).digest, fresh.digest);
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('by keys alone', async (t) => {
  const server = await serve({ name: 'bound.batten', bytes });
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `wires-keys-${name}.png`) });
  const press = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    await quiet(page);
  };
  const holds = (selector) => page.evaluate((css) => document.activeElement.matches(css), selector);
  /** Walks with F6 and the arrows to a button, as a user would. */
  const walk = async (region, selector) => {
    for (let i = 0; i < 10 && !await holds(`${region} *`); i++) await press('F6');
    for (let i = 0; i < 60 && !await holds(selector); i++) await press('ArrowRight');
    assert.ok(await holds(selector), selector);
  };
  const offered = (name) => walk('#actions', `#actions button:has(use[href$="icon-${name}"])`);
  const back = async () => {
    for (let i = 0; i < 10 && !await holds('#stage'); i++) await press('F6');
  };
  await press('Shift');
  await page.evaluate(() => {
    globalThis.pointed = 0;
    for (const kind of ['pointerdown', 'pointermove', 'touchstart']) addEventListener(kind, () => globalThis.pointed++, true);
  });
  const fresh = await state(page);
  await back();
  await press('v', 'Control+a');
  await offered('wire-bind');
  await press('Enter');
  const bound = await state(page);
  assert.match(bound.notice, /^Bound: [1-9]\d* points follow the wire/);
  await offered('wire-frames');
  await press('Enter');
  assert.equal((await wire(page)).turn, 'frames');
  assert.ok(await holds('[aria-pressed="true"]'));
  await shot('frames');
  // The radius, as a number.
  for (let i = 0; i < 10 && !await holds('#inspector *'); i++) await press('F6');
  for (let i = 0; i < 40 && !await holds('#number-wire-radius'); i++) await press('Tab');
  assert.ok(await holds('#number-wire-radius'));
  await page.keyboard.type('60 px');
  await press('Enter');
  assert.ok((await wire(page)).radius.values.some((value) => Math.abs(value - 60) < 1e-9));
  await shot('radius');
  await back();
  // The wire is selected: its second point is moved, and what is bound follows.
  const narrow = await state(page);
  await press('a', 'Tab', 'Tab', ...Array(3).fill('Shift+ArrowRight'));
  await shot('redrawing');
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, narrow.digest);
  assert.equal(redrawn.check, '');
  await press('v');
  await offered('wire-bake');
  await press('Enter');
  assert.equal(await wire(page), undefined);
  await back();
  await press('Control+z');
  assert.equal((await state(page)).digest, redrawn.digest);
  await offered('wire-revert');
  await press('Enter');
  assert.equal(await wire(page), undefined);
  await back();
  for (let i = 0; i < 9 && (await state(page)).digest !== bound.digest; i++) await press('Control+z');
  assert.equal((await state(page)).digest, bound.digest);
  await press('Control+z');
  assert.equal((await state(page)).digest, fresh.digest);
  assert.equal(await page.evaluate(() => globalThis.pointed), 0);
  await context.close();
});
