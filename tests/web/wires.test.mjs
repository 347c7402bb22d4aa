// Wires in the browser: a sheet is bound to a curve with a button of the bar; its tube of reach is shown face-on and in the
// tilted view; the wire is moved and the sheet follows; it is freed as it was; undo leads back.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const SIDE = 20; // fine enough not to be refined when it is bound
const even = [0, 0, 0, ...Array.from({ length: SIDE - 2 }, (_, i) => i), SIDE - 3, SIDE - 3, SIDE - 3];
const points = Array.from({ length: SIDE }, (_, i) => Array.from({ length: SIDE }, (_, j) => [
  200 + (550 * i) / (SIDE - 1), 120 + (440 * j) / (SIDE - 1), 30 * Math.cos((11 * i) / (3 * (SIDE - 1))),
]));
const bytes = Buffer.from(JSON.stringify({
  batten: 2, page: [0, 0, 1000, 700], next: 3, objects: [
    { id: 1, kind: 'surface', name: 'sheet', surface: { degree: [3, 3], closed: [false, false], knots: [even, even], points } },
    { id: 2, kind: 'path', name: 'wire', curves: [{
      degree: 3, knots: [0, 0, 0, 0, 1, 1, 1, 1], points: [[440, 180, 0], [500, 280, 0], [440, 400, 0], [480, 520, 0]],
    }] },
  ],
}));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const colorScheme of ['light', 'dark']) {
  test(`a sheet is bound to a wire and follows it, ${colorScheme}`, async (t) => {
    const server = await serve({ name: 'bound.batten', bytes });
    t.after(() => server.close());
    const { page, context, hand } = await open(browser, server.address, { colorScheme });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `wires-${name}-${colorScheme}.png`) });
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
    const line = bezier([440, 180], [500, 280], [440, 400], [480, 520], 40).slice(6, 35);
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
}
