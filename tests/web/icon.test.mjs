// An icon of 24 x 24, by mouse and keys from an empty page to files in three sizes, which look as rsvg paints the SVG.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, launch, open, place, quiet, SCREENSHOTS } from './page.mjs';
import { serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

/** Red, green and blue of a picture's pixels, as the browser decodes it. */
const pixels = (page, bytes) => page.evaluate(async (data) => {
  const bitmap = await createImageBitmap(new Blob([new Uint8Array(data)]));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return { width: bitmap.width, data: [...context.getImageData(0, 0, bitmap.width, bitmap.height).data].filter((value, i) => i % 4 < 3) };
}, [...bytes]);

test('an icon from an empty page to files', async () => {
  const { page, context } = await open(browser, server.address);
  await page.locator('.start [data-text="shell.start-new"]').click();
  await page.locator('.start-new button', { hasText: '24 × 24 px' }).click();
  await quiet(page);
  const drag = async (from, to) => {
    await page.mouse.move(...await place(page, ...from));
    await page.mouse.down();
    await page.mouse.move(...await place(page, ...to), { steps: 4 });
    await page.mouse.up();
    await quiet(page);
  };
  /** A colour for what is selected, by its number. */
  const colour = async (part, hex) => {
    await page.keyboard.press('v');
    await page.click(`#actions .dot.${part} button`);
    await page.waitForSelector('#picker-sheet:popover-open');
    await page.fill('#picker-hex', hex);
    await page.keyboard.press('Enter');
    await quiet(page);
  };
  const tick = (name) => page.locator(`#setting-${name}`).click();
  // A disc, and a bar over it.
  await page.keyboard.press('o');
  await drag([2, 2], [22, 22]);
  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 2, 12));
  await quiet(page);
  await tick('filled');
  await tick('stroked');
  await colour('filled', '#2d6cdf');
  await page.keyboard.press('Escape');
  await page.keyboard.press('r');
  await drag([6, 10], [18, 14]);
  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 12, 12));
  await quiet(page);
  assert.equal(await page.evaluate(() => batten.loop.selected), 1);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'icon.png') });
  await colour('filled', '#ffd166');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'icon-coloured.png') });
  // Three sizes at once.
  await page.keyboard.press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  await page.selectOption('#export-format', 'png');
  await page.selectOption('#export-part', '0');
  await page.selectOption('#export-size', 'all');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export .strong')]);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'icon-'));
  fs.writeFileSync(path.join(folder, 'all.zip'), await downloaded(download));
  execFileSync('python3', ['-m', 'zipfile', '-e', path.join(folder, 'all.zip'), folder]);
  const files = fs.readdirSync(folder).filter((name) => name.endsWith('.png')).sort((a, b) => a.length - b.length || a.localeCompare(b));
  assert.equal(files.length, 3);
  fs.writeFileSync(path.join(folder, 'icon.svg'), Buffer.from(await page.evaluate(() => [...batten.engine.save(false)])));
  for (const [i, file] of files.entries()) {
    const ours = await pixels(page, fs.readFileSync(path.join(folder, file)));
    const theirs = await pixels(page, execFileSync('rsvg-convert', ['-b', 'white', '-z', String(i + 1), path.join(folder, 'icon.svg')]));
    assert.equal(ours.width, 24 * (i + 1));
    assert.equal(theirs.width, ours.width);
    const apart = ours.data.map((value, k) => Math.abs(value - theirs.data[k]));
    assert.ok(Math.max(...apart) < 24, `${file}: ${Math.max(...apart)}`); // along edges, which each smooths in its way
    assert.ok(apart.reduce((sum, value) => sum + value) / apart.length < 0.3, file);
    const middle = 3 * (12 * (i + 1) * ours.width + 12 * (i + 1));
    assert.deepEqual(ours.data.slice(middle, middle + 3), [0xff, 0xd1, 0x66]);
  }
  fs.rmSync(folder, { recursive: true });
  await context.close();
});
