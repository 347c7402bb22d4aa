// Widths along strokes: chosen by name in the sheet of styles, painted, undone.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, said, SCREENSHOTS, state, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const FILE = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
<path d="M40 80H360" fill="none" stroke="#008000" stroke-width="40"/>
<path d="M40 180C120 80 200 300 360 200" fill="#ffcc00" stroke="#0000ff" stroke-width="24" opacity=".5"/></svg>`;

const near = (found, wanted) => Math.max(...wanted.map((value, k) => Math.abs(value - found[k]))) <= 16;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('a stroke is pointed at its end, by name, and undone', async (t) => {
  const server = await serve({ name: 'widths.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  const digest = () => page.evaluate(() => globalThis.batten.engine.digest());
  const first = await digest();
  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 100, 80));
  await page.keyboard.press('Control+a');
  await page.selectOption('select[id$="widths"]', { index: 1 });
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'widths.png') });
  const found = await stillColours(page, [[60, 94], [340, 94], [340, 80]]);
  assert.ok(near(found[0], [0, 128, 0]), `at the start: ${found[0]}`);
  assert.ok(near(found[1], [255, 255, 255]), `beside the end: ${found[1]}`);
  assert.notEqual(await digest(), first);
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await digest(), first);
});

test('the width tool pulls a stroke wider with the pen, and a number is typed', async (t) => {
  const server = await serve({ name: 'widths.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { colorScheme: 'dark' });
  await page.evaluate(() => batten.theme.dimPaper(false)); // colours as they are in the file
  const first = (await state(page)).digest;
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `width-tool-${name}.png`) });
  await page.locator('#stage').focus();
  await page.keyboard.press('Shift+W');
  await quiet(page);
  assert.equal(await page.locator('[data-name=tool-width]').first().getAttribute('aria-pressed'), 'true');
  await hand.hover(await place(page, 200, 90));
  await shot('hover');
  await hand.stroke([await place(page, 200, 99), await place(page, 200, 130)], { lift: false });
  await quiet(page);
  await shot('drag');
  const live = await stillColours(page, [[200, 124], [60, 94], [60, 106]]);
  assert.ok(near(live[0], [0, 128, 0]), `in the middle, while the pen is down: ${live[0]}`);
  await page.keyboard.press('Escape');
  await quiet(page);
  assert.equal((await state(page)).digest, first, 'Escape takes it back');
  await hand.lift(await place(page, 200, 130));
  await hand.stroke([await place(page, 200, 99), await place(page, 200, 130)]);
  await quiet(page);
  const wide = await stillColours(page, [[200, 124], [60, 94], [60, 116]]);
  assert.ok(near(wide[0], [0, 128, 0]) && near(wide[1], [0, 128, 0]), `in the middle ${wide[0]}, at the start ${wide[1]}`);
  assert.ok(near(wide[2], [255, 255, 255]), `beside the start: ${wide[2]}`);
  await page.keyboard.press('Enter');
  await page.waitForSelector('#number-width-here:focus');
  assert.match(await said(page, '#number-width-here'), /^10[0-9.]+ px$/);
  await page.fill('#number-width-here', '8');
  await page.keyboard.press('Enter');
  await quiet(page);
  await shot('number');
  const thin = await stillColours(page, [[200, 88], [60, 94]]);
  assert.ok(near(thin[0], [255, 255, 255]) && near(thin[1], [0, 128, 0]), `in the middle ${thin[0]}, at the start ${thin[1]}`);
  await page.locator('#stage').focus();
  await page.keyboard.press('Delete');
  await quiet(page);
  assert.equal((await state(page)).check, '');
  assert.equal((await state(page)).digest, first, 'without its stop the stroke is flat again');
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('Control+z');
  }
  await quiet(page);
  assert.equal((await state(page)).digest, first);
});
