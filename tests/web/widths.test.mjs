// Widths along strokes: chosen by name in the sheet of styles, painted, undone.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, stillColours } from './page.mjs';
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
