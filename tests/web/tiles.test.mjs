// A drawing in its true size over sheets of paper, from the export sheet: what the browser makes of it, seen by poppler.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { drop, launch, open, SCREENSHOTS } from './page.mjs';
import { PROGRAM, serve } from './server.mjs';

const MM = 8; // pixels
const ART = `<svg xmlns="http://www.w3.org/2000/svg" width="500mm" height="400mm" viewBox="0 0 500 400">
  <path d="M100 50H160V110H100Z" fill="#00f"/><path d="M175 250H235V290H175Z" fill="#f00"/></svg>`;

let browser;
let server;
let folder;
before(async () => {
  browser = await launch();
  server = await serve();
  folder = fs.mkdtempSync(path.join(os.tmpdir(), 'tiles-'));
});
after(async () => {
  await browser.close();
  server.close();
  fs.rmSync(folder, { recursive: true });
});

/** What the print window would make, with these fields of the sheet. */
async function printed(page, fields, shot) {
  await page.evaluate(() => { window.printed = false; window.print = () => { window.printed = true; }; });
  await page.keyboard.press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  await page.selectOption('#export-format', 'pdf');
  for (const [name, value] of Object.entries(fields)) {
    await (name === 'paper' ? page.selectOption('#export-paper', value) : page.fill(`#export-${name}`, value));
  }
  if (shot) {
    await page.screenshot({ path: path.join(SCREENSHOTS, shot) });
  }
  await page.click('#export .strong');
  await page.waitForFunction(() => window.printed);
  const file = path.join(folder, 'page.pdf');
  await page.pdf({ path: file, preferCSSPageSize: true, printBackground: true });
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.evaluate(() => document.getElementById('print')), null);
  return file;
}

const info = (file) => {
  const text = execFileSync('pdfinfo', [file]).toString();
  return { pages: Number(/Pages: +(\d+)/.exec(text)[1]), size: /Page size: +([\d.]+) x ([\d.]+)/.exec(text).slice(1).map((side) => Number(side) * 25.4 / 72) };
};

/** The box of what has that colour on a page, mm: left, top, right, bottom; null: none has it. */
function boxOf(file, number, is) {
  const bytes = execFileSync('pdftoppm', ['-r', String(25.4 * MM), '-f', String(number), '-l', String(number), file], { maxBuffer: 1 << 28 });
  const [head, wide] = /^P6\s+(\d+)\s+\d+\s+255\s/.exec(bytes.subarray(0, 40).toString('latin1'));
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = head.length, k = 0; i + 2 < bytes.length; i += 3, k++) {
    if (is(bytes[i], bytes[i + 1], bytes[i + 2])) {
      const [x, y] = [k % wide, Math.floor(k / wide)];
      [box[0], box[1], box[2], box[3]] = [Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x + 1), Math.max(box[3], y + 1)];
    }
  }
  return box[0] < box[2] ? box.map((value) => value / MM) : null;
}
const blue = (r, g, b) => b > 200 && r < 60 && g < 60;
const red = (r, g, b) => r > 200 && g < 60 && b < 60;
const close = (found, wanted) => wanted.forEach((value, i) => assert.ok(Math.abs(found[i] - value) < 0.3, `${found} is not ${wanted}`));

test('sheets of A4 show the drawing in its true size, and overlap', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'art.svg', ART);
  const file = await printed(page, { paper: 'A4', overlap: '10' }, 'tiles.png');
  // 190 x 277 mm of a sheet are shown, 180 x 267 lie between sheets: 3 columns, 2 rows.
  const { pages, size } = info(file);
  assert.equal(pages, 6);
  close(size, [210, 297]);
  fs.writeFileSync(path.join(folder, 'art.svg'), ART);
  execFileSync(PROGRAM, ['render', path.join(folder, 'art.svg'), path.join(folder, 'program.pdf'), '--tile', 'A4']);
  const theirs = path.join(folder, 'program.pdf');
  assert.equal(info(theirs).pages, pages);
  close(boxOf(file, 1, blue), [110, 60, 170, 120]); // behind the white of 10 mm
  close(boxOf(file, 1, red), [185, 260, 200, 287]);
  close(boxOf(file, 2, red), [10, 260, 65, 287]);
  close(boxOf(file, 4, red), [185, 10, 200, 33]);
  for (let number = 1; number <= pages; number++) {
    for (const colour of [blue, red]) {
      const [ours, other] = [file, theirs].map((one) => boxOf(one, number, colour));
      assert.equal(ours === null, other === null, `page ${number}`);
      close(ours ?? [], other ?? []);
    }
  }
  const words = execFileSync('pdftotext', ['-layout', file, '-']).toString();
  assert.match(words, /50 mm/);
  assert.match(words, /row 2, column 3 \/ 2 × 3/);
  execFileSync('pdftoppm', ['-r', '40', '-png', '-f', '1', '-l', '1', file, path.join(SCREENSHOTS, 'tiles_sheet')]);
  await context.close();
});

test('another size of paper, on its side where that takes fewer sheets; what fits is one sheet', async () => {
  const { page, context } = await open(browser, server.address, { locale: 'ko-KR' });
  await drop(page, 'art.svg', ART);
  const file = await printed(page, { paper: 'own', 'paper-width': '420', 'paper-height': '520' }, 'tiles_ko.png');
  const { pages, size } = info(file);
  assert.equal(pages, 1);
  close(size, [520, 420]);
  close(boxOf(file, 1, blue), [110, 60, 170, 120]);
  const again = await printed(page, {}); // remembered
  assert.equal(info(again).pages, 1);
  await page.evaluate(() => { window.print = () => {}; });
  await page.keyboard.press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  await page.fill('#export-paper-width', '20');
  await page.fill('#export-paper-height', '20');
  await page.click('#export .strong');
  await page.waitForFunction(() => /400/.test(document.getElementById('notice-text').textContent));
  await context.close();
});
