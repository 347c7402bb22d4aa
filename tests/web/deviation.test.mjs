// Deviation: curves coloured by their distance from the one selected last, with a legend, from the palette by the name that other programs
// have; followed while a curve is dragged and redrawn; sheets in space; the drawing stays as it is; Escape ends.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="500" fill="none" stroke="#22262b" stroke-width="2">
<path d="M100 250C250 150 500 150 700 250"/><path stroke="#c33" d="M100 260C250 190 500 120 700 300"/></svg>`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const labels = (page) => page.evaluate(() => glance().labels.map(({ text }) => text));
const numbers = async (page) => (await labels(page)).find((text) => text.includes('rms')) ?? '';

test('curves are coloured by their distance, and followed', async (t) => {
  const server = await serve({ name: 'lines.svg', bytes: Buffer.from(DRAWING) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const opened = await state(page);
  await page.keyboard.press('Control+k');
  await page.waitForSelector('#menu .search');
  await page.waitForFunction(() => document.activeElement?.classList.contains('search'));
  await page.keyboard.type('PointDeviation');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('two or more'));
  await page.keyboard.press('v');
  await page.evaluate(() => {
    batten.engine.act('editor_select', 2, 0);
    batten.engine.act('editor_select', 1, 1);
    batten.wake();
  });
  await page.click('#actions [data-name=further]');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'deviation-offered.png') });
  await page.click('#actions [data-name=deviation]');
  await settle(page);
  assert.match(await numbers(page), /^greatest [\d.]+ px, mean [\d.]+ px, rms [\d.]+ px$/);
  assert.ok((await labels(page)).some((text) => text.startsWith('Distance from')));
  assert.equal((await state(page)).digest, opened.digest);
  await pictures(page, 'deviation');
  const was = await numbers(page);

  // The measured curve alone is moved by the pen: the numbers follow, and settle when it is lifted.
  await page.evaluate(() => { batten.engine.act('editor_select', 2, 0); batten.wake(); });
  const from = await place(page, 100, 260);
  await hand.stroke([from, [from[0], from[1] + 20], [from[0], from[1] + 60]], { pointerType: 'mouse' });
  await settle(page);
  const moved = await numbers(page);
  assert.notEqual(moved, was);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'deviation-moved.png') });
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal(await numbers(page), was);
  assert.equal((await state(page)).check, '');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal(await numbers(page), '');
  assert.equal((await state(page)).digest, opened.digest);
  await context.close();
});

test('sheets in space are coloured, too', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: readFileSync(new URL('../../examples/jug.batten', import.meta.url)) });
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  for (const command of ['select-all', 'duplicate', 'select-all', 'deviation']) {
    await page.evaluate((name) => { batten.engine.command(name); batten.wake(); }, command);
    await settle(page);
  }
  assert.match(await numbers(page), /rms/);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'deviation-sheets.png') });
  for (const shown of [/^$/, /rms/]) {
    await page.keyboard.press('Shift+E');
    await settle(page);
    assert.match(await numbers(page), shown);
  }
  assert.equal((await state(page)).check, '');
  await context.close();
});
