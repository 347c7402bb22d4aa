// Surfaces from curves in the browser: a jug is made from its profile and a line with a button of the bar, with a pen, with
// touch and with the keyboard alone; the profile is edited and the jug follows; its angle is entered; it is freed.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5];
const points = [[590, 560], [620, 552], [665, 490], [675, 410], [640, 330], [595, 270], [588, 230], [620, 200]];
const bytes = Buffer.from(JSON.stringify({
  batten: 1, page: [0, 0, 1000, 700], next: 3, objects: [
    { id: 1, kind: 'path', name: 'profile', curves: [{ degree: 3, knots, points }] },
    { id: 2, kind: 'path', name: 'axis', curves: [{ degree: 1, knots: [0, 0, 1, 1], points: [[480, 600], [480, 160]] }] },
  ],
}));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const [pointerType, colorScheme] of [['pen', 'light'], ['touch', 'dark'], ['keyboard', 'light']]) {
  test(`a jug from its profile, ${pointerType}`, async (t) => {
    const server = await serve({ name: 'jug.batten', bytes });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { colorScheme, hasTouch: pointerType === 'touch' });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `making-${name}-${pointerType}.png`) });
    const shown = () => page.evaluate(() => glance());
    const fresh = await state(page);
    await page.focus('#stage');
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await settle(page);
    await quiet(page);
    await page.locator('#actions').waitFor({ state: 'visible' });
    await shot('offered');
    const button = page.locator('#actions button', { has: page.locator('use[href$="icon-surface-revolve"]') });
    assert.equal(await button.count(), 1);
    if (pointerType === 'keyboard') {
      await button.focus();
      await page.keyboard.press('Enter');
    } else if (pointerType === 'touch') {
      await button.tap();
    } else {
      await button.click();
    }
    await quiet(page);
    const made = await state(page);
    assert.notEqual(made.digest, fresh.digest);
    assert.equal((await shown()).notice, 'The surface follows its curves');
    await shot('made');
    for (let i = 0; i < 4; i++) {
      await page.keyboard.press('Shift+Alt+ArrowUp');
    }
    await quiet(page);
    await shot('tilted');
    await page.keyboard.press('5');
    await quiet(page);
    if (pointerType !== 'keyboard') {
      await page.keyboard.press('a');
      const on = await place(page, 654, 370);
      const stroke = async (way, during) => {
        hand.rest(2);
        if (pointerType === 'touch') {
          await hand.fingers(way.map((one) => [one]), { lift: false });
          await during?.();
          return hand.fingers([], {});
        }
        return hand.stroke(way, { pointerType, during });
      };
      await stroke([on, on]);
      await settle(page);
      const from = await place(page, 675, 410), to = await place(page, 735, 410);
      await stroke(Array.from({ length: 20 }, (_, i) => [from[0] + (to[0] - from[0]) * i / 19, from[1]]),
        () => shot('dragging'));
      await quiet(page);
      const edited = await state(page);
      assert.notEqual(edited.digest, made.digest);
      assert.equal(edited.check, '');
      await shot('edited');
      await page.keyboard.press('Control+z');
      await quiet(page);
      assert.equal((await state(page)).digest, made.digest);
    }
    assert.equal((await state(page)).check, '');
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal((await state(page)).digest, fresh.digest);
    await context.close();
  });
}
