// Export: parts of the drawing in other formats, pictures, prints, and a picture on the clipboard.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, drop, launch, open, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const ART = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">
  <path id="blue" d="M50 50H150V150H50Z" fill="#00f"/><path id="red" d="M300 100C330 100 350 120 350 150" fill="none" stroke="#f00" stroke-width="10"/></svg>`;

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

async function begin() {
  const opened = await open(browser, server.address);
  await drop(opened.page, 'art.svg', ART);
  return opened;
}

/** Opens the sheet and fills it in. */
async function choose(page, fields) {
  await page.keyboard.press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  for (const [name, value] of Object.entries(fields)) {
    if (name === 'white') {
      await page.setChecked('#export-white', value);
    } else if (name === 'width') {
      await page.fill('#export-width', String(value));
    } else {
      await page.selectOption(`#export-${name}`, value);
    }
  }
}

/** The file that the sheet makes. */
async function made(page, fields) {
  await choose(page, fields);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export .strong')]);
  return { name: download.suggestedFilename(), bytes: await downloaded(download) };
}

/** Width, height and some pixels of a PNG, as the browser decodes it. */
const pixels = (page, bytes, at) => page.evaluate(async ([data, places]) => {
  const bitmap = await createImageBitmap(new Blob([new Uint8Array(data)]));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return { size: [bitmap.width, bitmap.height], found: places.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data]) };
}, [[...bytes], at]);

test('the page, everything or the selection, in formats of the table', async () => {
  const { page, context } = await begin();
  const { digest } = await state(page);
  const plain = await made(page, { format: 'plain', part: '0' });
  assert.equal(plain.name, 'art.svg');
  assert.match(plain.bytes.toString(), /viewBox="0 0 400 300"/);
  assert.doesNotMatch(plain.bytes.toString(), /batten:/);
  const whole = (await made(page, { format: 'plain', part: '1' })).bytes.toString();
  const box = /viewBox="([^"]+)"/.exec(whole)[1].split(' ').map(Number);
  assert.ok(box[0] > 30 && box[0] <= 50 && box[2] > 300 && box[2] < 330, box.join(' '));

  await page.evaluate(() => batten.engine.act('editor_select', 1, 0));
  await settle(page);
  const one = (await made(page, { format: 'plain', part: '2' })).bytes.toString();
  assert.equal(one.match(/<path/g).length, 1);
  const drawing = (await made(page, { format: 'dxf', part: '1' })).bytes.toString();
  assert.match(drawing, /SECTION[\s\S]*SPLINE|SECTION[\s\S]*LINE/);
  const native = await made(page, { format: 'batten', part: '0' });
  assert.equal(native.name, 'art.batten');
  assert.equal((await state(page)).digest, digest);
  await context.close();
});

test('a glyph of a font is opened, and written with its points', async () => {
  const { page, context } = await open(browser, server.address);
  const glyph = fs.readFileSync(new URL('../../fuzz/corpus/glif/ring', import.meta.url), 'utf8');
  await drop(page, 'a.glif', glyph);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'glyph.png') });
  const result = await made(page, { format: 'glif', part: '0' });
  assert.equal(result.name, 'a.glif');
  const points = (text) => text.match(/<point[^>]*>/g);
  assert.deepEqual(points(result.bytes.toString()), points(glyph));
  await drop(page, 'b.glif', glyph.replace('x="100"', 'x="wide"'));
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('b.glif'));
  assert.match(await page.textContent('.notices'), /x and y/);
  await context.close();
});

test('a picture of the size asked for, white or see-through; the last choice is remembered', async () => {
  const { page, context } = await begin();
  const at = [[10, 10], [200, 200], [1290, 500]];
  const white = await made(page, { format: 'png', part: '0', width: 1600, white: true });
  assert.equal(white.name, 'art.png');
  assert.deepEqual(await pixels(page, white.bytes, at),
    { size: [1600, 1200], found: [[255, 255, 255, 255], [0, 0, 255, 255], [255, 255, 255, 255]] });
  const clear = await made(page, { white: false });
  assert.deepEqual((await pixels(page, clear.bytes, at)).found[0], [0, 0, 0, 0]);
  await page.reload();
  await ready(page);
  await choose(page, {});
  await page.screenshot({ path: path.join(SCREENSHOTS, 'export.png') });
  assert.equal(await page.inputValue('#export-format'), 'png');
  assert.equal(await page.inputValue('#export-width'), '1600');
  assert.equal(await page.isChecked('#export-white'), false);
  assert.equal(await page.evaluate(() => document.activeElement.className), 'strong');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#export', { state: 'detached' });
  await context.close();
});

test('what cannot be made is said: an empty drawing, a picture too large', async () => {
  const { page, context } = await open(browser, server.address);
  await choose(page, { format: 'dxf' });
  await page.click('#export .strong');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('curve'));
  await drop(page, 'tall.svg', ART.replace('0 0 400 300', '0 0 4 30000').replace('width="400" height="300"', 'width="4" height="30000"'));
  await choose(page, { format: 'png', part: '0', width: 16000 });
  await page.click('#export .strong');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('too large'));
  await context.close();
});

test('a browser that keeps nothing exports all the same', async () => {
  const { page, context } = await begin();
  await page.evaluate(() => {
    const set = Storage.prototype.setItem;
    Storage.prototype.setItem = function setItem(key, value) {
      if (key === 'batten-export') {
        throw new DOMException('full', 'QuotaExceededError');
      }
      set.call(this, key, value);
    };
  });
  const file = await made(page, { format: 'plain', part: '0' });
  assert.match(file.bytes.toString(), /id="blue"/);
  await context.close();
});

test('printing shows the drawing alone on a page of its size, as vectors', async () => {
  const { page, context } = await begin();
  await page.evaluate(() => { window.print = () => { window.printed = true; }; });
  await choose(page, { format: 'pdf', part: '0' });
  assert.equal(await page.isVisible('#export p:last-child'), true);
  await page.click('#export .strong');
  await page.waitForFunction(() => window.printed);
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'export-')), 'art.pdf');
  await page.pdf({ path: file, preferCSSPageSize: true, printBackground: true });
  assert.match(execFileSync('pdfinfo', [file]).toString(), /Pages: +1\n[\s\S]*Page size: +300 x 22[45]\.?\d* pts/);
  const svg = execFileSync('pdftocairo', ['-svg', file, '-']).toString();
  assert.match(svg, /<path[^>]*(fill="rgb\(0%, 0%, 100%\)"|fill:rgb\(0%,0%,100%\))/);
  assert.doesNotMatch(svg, /<image/);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.evaluate(() => document.getElementById('print')), null);
  fs.rmSync(path.dirname(file), { recursive: true });
  await context.close();
});

test('a picture on the clipboard', async () => {
  const { page, context } = await begin();
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await choose(page, { format: 'png', part: '0', width: 200, white: true });
  await page.click('#export button[value=copy]');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('Copied'));
  const size = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const bitmap = await createImageBitmap(await item.getType('image/png'));
    return [bitmap.width, bitmap.height];
  });
  assert.deepEqual(size, [200, 150]);
  await context.close();
});
