// label: smoke. Nothing that floats over the drawing eats a stroke: a press on it that travels draws from where it began, and a
// tap presses it. STROKES=1000 draws so many beside and across the chips.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const STROKES = Number(process.env.STROKES ?? 24);
const POINTERS = ['pen', 'mouse'];

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** Numbers from 0 to 1 that are the same each time (Park and Miller). */
function numbers(seed) {
  let last = seed;
  return () => (last = (last * 48271) % 2147483647) / 2147483647;
}

const middle = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 2, y + height / 2];
};

/** Where the last stroke began, in the window. */
const began = (page) => page.evaluate(() => {
  const lines = new TextDecoder().decode(batten.engine.journal).trim().split('\n').map((line) => JSON.parse(line));
  const [x, y] = lines.filter(({ stroke }) => stroke).at(-1).stroke.points[0];
  const { left, top } = batten.stage.getBoundingClientRect();
  return [x + left, y + top];
});

test('strokes beside and across the chips: none is lost', async (t) => {
  const server = await serve({ name: 'new.svg', bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700"/>') });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const random = numbers(11);
  const lost = [];
  let across = 0;
  for (let i = 0; i < STROKES; i++) {
    if (i % 20 === 0) { // not too many lines
      await page.evaluate(() => ['select-all', 'delete', 'tool-sketch'].forEach((name) => batten.engine.command(name)));
      await hand.stroke([[500, 300], [560, 320], [640, 300]]);
    }
    await page.waitForFunction(() => document.querySelector('.chips')?.hidden === false);
    if (i % 3 === 0) {
      await quiet(page); // all of them have come, the slider too
    }
    const { box, field, chips, stage, digest } = await page.evaluate(() => {
      const rect = (one) => (({ left, top, right, bottom }) => [left, top, right, bottom])(one.getBoundingClientRect());
      const box = document.querySelector('.chips');
      return { box: rect(box), field: rect(box.querySelector('.refit input')),
        chips: [...box.querySelectorAll('button, .refit')].filter((one) => one.checkVisibility({ visibilityProperty: true })).map(rect), stage: rect(batten.stage),
        digest: batten.engine.digest() };
    });
    const inside = ([x0, y0, x1, y1], [x, y]) => x >= x0 && x <= x1 && y >= y0 && y <= y1;
    const near = i % 2 && chips.length > 0 ? chips[Math.floor(random() * chips.length)] : [box[0] - 12, box[1] - 12, box[2] + 12, box[3] + 12];
    let from;
    do {
      from = [near[0] + random() * (near[2] - near[0]), near[1] + random() * (near[3] - near[1])];
    } while (inside(field, from) || !inside(stage, from)); // a slider is dragged
    const angle = 2 * Math.PI * random();
    const length = 20 + 150 * random();
    const limit = (x, most) => Math.max(70, Math.min(x, most));
    const to = [limit(from[0] + length * Math.cos(angle), 1100), limit(from[1] + length * Math.sin(angle), 700)];
    const bow = 0.3 * (random() - 0.5);
    const by = [(from[0] + to[0]) / 2 - bow * (to[1] - from[1]), (from[1] + to[1]) / 2 + bow * (to[0] - from[0])];
    across += chips.some((chip) => inside(chip, from)) ? 1 : 0;
    await hand.stroke([from, by, to], { pointerType: POINTERS[(i >> 1) % 2] });
    if (await page.evaluate(() => batten.engine.digest()) === digest) {
      lost.push(`${i}: ${from} to ${to}`);
    }
    hand.rest(1);
  }
  console.log(`${STROKES} strokes, ${across} of them begun on a chip, ${lost.length} lost`);
  assert.ok(across > STROKES / 5, `${across}`);
  assert.deepEqual(lost, []);
  assert.equal((await state(page)).check, '');
  await context.close();
});

for (const pointerType of POINTERS) {
  test(`${pointerType}: a tap presses what floats, a press that travels draws through it`, async (t) => {
    const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { colorScheme: pointerType === 'pen' ? 'light' : 'dark' });
    const count = () => page.evaluate(() => batten.engine.journal.length);
    const draws = async (locator, name) => {
      const from = await middle(locator);
      const before = await count();
      await hand.stroke([from, [from[0] - 40, from[1] - 60], [from[0] - 90, from[1] - 70]], { pointerType, lift: false });
      await page.screenshot({ path: path.join(SCREENSHOTS, `over-${name}-${pointerType}.png`) });
      await hand.lift([from[0] - 90, from[1] - 70], { pointerType, button: 'left' });
      await quiet(page);
      assert.ok(await count() > before, name);
      const [x, y] = await began(page);
      assert.ok(Math.hypot(x - from[0], y - from[1]) < 1, `${name}: from where it began`);
      await page.keyboard.press('Control+z');
      await quiet(page);
    };
    const roof = bezier([440, 135], [490, 88], [580, 80], [690, 115]);
    const redraw = async () => {
      await hand.stroke(await Promise.all(roof.map(([x, y]) => place(page, x, y))), { pointerType });
      await page.locator('.chips button').first().waitFor();
      await quiet(page);
    };
    await redraw();
    await draws(page.locator('.chips button', { hasText: 'New line' }), 'chip');
    await page.keyboard.press('Control+z');
    await redraw();
    const redrawn = (await state(page)).digest;
    await hand.stroke([await middle(page.locator('.chips button', { hasText: 'New line' }))], { pointerType });
    await quiet(page);
    assert.notEqual((await state(page)).digest, redrawn, 'the tap has chosen it');
    await page.keyboard.press('Control+z');
    // The row of a selection's commands: a box is drawn from there, around nothing.
    const selected = () => page.evaluate(() => batten.loop.selected);
    await page.keyboard.press('Control+a');
    await page.waitForSelector('#actions:not([hidden])');
    await quiet(page);
    assert.ok(await selected() > 0);
    const [x, y] = await middle(page.locator('#actions button').first());
    await hand.stroke([[x, y], [x - 40, y - 60]], { pointerType });
    await quiet(page);
    assert.equal(await selected(), 0);
    await page.keyboard.press('Control+a');
    await quiet(page);
    await hand.stroke([await middle(page.locator('#actions [data-name=further]'))], { pointerType });
    await quiet(page);
    assert.equal(await page.isVisible('#further'), true);
    await page.keyboard.press('n');
    await quiet(page);
    // A note, and what it offers.
    await page.evaluate(() => {
      globalThis.ran = 0;
      batten.notices.say('A note', { label: 'Do it', run: () => { globalThis.ran++; } });
    });
    await page.waitForSelector('#notice button');
    await draws(page.locator('#notice button'), 'note');
    assert.equal(await page.evaluate(() => globalThis.ran), 0);
    await page.evaluate(() => batten.notices.say('A note', { label: 'Do it', run: () => { globalThis.ran++; } }));
    await page.waitForSelector('#notice button');
    await hand.stroke([await middle(page.locator('#notice button'))], { pointerType });
    assert.equal(await page.evaluate(() => globalThis.ran), 1);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
