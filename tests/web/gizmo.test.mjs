// The gizmo about what is selected in a tilted view: with the mouse, the pen and a finger; in light and dark; on a phone.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, quiet, SCREENSHOTS, state, until } from './page.mjs';
import { serve } from './server.mjs';

const bytes = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/space/turned.batten'));

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'turned.batten', bytes });
});
after(async () => {
  await browser.close();
  server.close();
});

const labels = (page) => page.evaluate(() => glance().labels.map(({ text }) => text));
/** Where the tip of an arm is, in the window: its name stands 15 px beyond. */
async function tip(page, axis) {
  const { x, y, dx, dy } = await page.evaluate((name) => {
    const { labels: all, originX, originY } = glance();
    const label = all.find(({ text }) => text === name);
    return { x: label.x + originX, y: label.y + originY, dx: label.dx, dy: label.dy };
  }, axis);
  const at = await place(page, x, y);
  return { at, way: [dx / 15, dy / 15] };
}
const along = ({ at, way }, far) => [at[0] + far * way[0], at[1] + far * way[1]];

for (const [name, options, device] of [
  ['', {}, 'mouse'],
  ['phone-', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, locale: 'ko-KR' }, 'touch'],
]) {
  test(`what is selected in space follows ${device === 'touch' ? 'a finger on a phone' : 'mouse and pen'}`, async () => {
    const { page, hand, context } = await open(browser, server.address, options);
    await quiet(page);
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await quiet(page);
    await page.keyboard.press('Shift+5'); // three quarters
    await until(page, () => glance().tilt > 0);
    await quiet(page);
    const first = (await state(page)).digest;
    assert.ok((await labels(page)).filter((text) => /^[xyz]$/.test(text)).length >= 2);
    await pictures(page, `gizmo-${name}shown`);
    const arm = await tip(page, 'z');
    const to = along(arm, 60);
    const said = async () => {
      const text = (await labels(page)).join();
      assert.match(text, device === 'touch' ? /z 방향: -?\d/ : /along z: -?\d/);
      assert.doesNotMatch(text, /(^|,)[xy](,|$)/, 'the others are away');
      await page.screenshot({ path: path.join(SCREENSHOTS, `gizmo-${name}dragged.png`) });
    };
    if (device === 'touch') {
      const frames = Array.from({ length: 12 }, (_, i) => [along(arm, 5 * (i + 1))]);
      await hand.fingers([[along(arm, 8)], ...frames], { lift: false }); // beside it: a finger reaches further
      await said();
      await hand.fingers([], {});
    } else {
      await hand.stroke([arm.at, to], { pointerType: 'mouse', during: said });
    }
    await quiet(page);
    const moved = (await state(page)).digest;
    assert.notEqual(moved, first);
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal((await state(page)).digest, first);
    if (device === 'mouse') {
      await hand.stroke([arm.at, to], { lift: false });
      await page.keyboard.press('Escape');
      await hand.lift(to);
      assert.equal((await state(page)).digest, first, 'Escape takes it back');
    }
    await page.keyboard.press('5');
    await quiet(page);
    assert.equal((await labels(page)).filter((text) => /^[xyz]$/.test(text)).length, 0, 'face-on there is none');
    await page.screenshot({ path: path.join(SCREENSHOTS, `gizmo-${name}face-on.png`) });
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
