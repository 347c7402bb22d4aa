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

/** What unzip says of the entries, and their bytes. */
function unzipped(bytes) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'export-'));
  fs.writeFileSync(path.join(folder, 'all.zip'), bytes);
  const script = 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; z.extractall(sys.argv[2]); print(chr(10).join(z.namelist()))';
  const names = execFileSync('python3', ['-c', script, path.join(folder, 'all.zip'), folder]).toString().trim().split('\n');
  const entries = new Map(names.map((name) => [name, fs.readFileSync(path.join(folder, name))]));
  fs.rmSync(folder, { recursive: true });
  return entries;
}

test('several at once: each object by its name, in each size, each layer; and once more by a key', async () => {
  const { page, context } = await begin();
  const { digest } = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await settle(page);
  const objects = await made(page, { format: 'plain', part: '3' });
  assert.equal(objects.name, 'art.zip');
  const files = unzipped(objects.bytes);
  assert.deepEqual([...files.keys()], ['blue.svg', 'red.svg']);
  assert.deepEqual([...files.values()].map((bytes) => bytes.toString().match(/<path/g).length), [1, 1]);
  assert.match(files.get('blue.svg').toString(), /viewBox="50 50 100 100"/);
  const again = page.waitForEvent('download');
  await page.keyboard.press('Control+Alt+e');
  assert.deepEqual(unzipped(await downloaded(await again)), files);
  // Pictures in three sizes; of the page they are named as the drawing.
  const sizes = unzipped((await made(page, { format: 'webp', part: '0', size: 'all', white: true })).bytes);
  assert.deepEqual([...sizes.keys()], ['art.webp', 'art@2x.webp', 'art@3x.webp']);
  for (const [i, bytes] of [...sizes.values()].entries()) {
    assert.equal(bytes.toString('latin1', 8, 12), 'WEBP');
    assert.deepEqual((await pixels(page, bytes, [])).size, [400 * (i + 1), 300 * (i + 1)]);
  }
  const fine = await made(page, { format: 'png', part: '0', size: '300dpi' });
  assert.deepEqual((await pixels(page, fine.bytes, [])).size, [1250, 938]);
  // Where pieces belong together they are not offered one by one.
  await choose(page, { format: 'pdf' });
  assert.equal(await page.locator('#export-part option[value="3"]').isDisabled(), true);
  await page.selectOption('#export-format', 'png');
  await page.selectOption('#export-part', '3');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'export-several.png') });
  await page.keyboard.press('Escape');
  // A layer of its own; nothing selected is said.
  await page.evaluate(() => batten.engine.command('layer-add'));
  await page.evaluate(() => batten.engine.command('layer-take'));
  await settle(page);
  const layer = await made(page, { format: 'plain', part: '4' });
  assert.match(layer.name, /^(?!art).*\.svg$/);
  assert.equal(layer.bytes.toString().match(/<path/g).length, 2);
  await made(page, { format: 'plain', part: '2' });
  await page.evaluate(() => batten.engine.act('editor_select', 0, 0));
  await settle(page);
  await page.keyboard.press('Control+Alt+e');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('Select something first'));
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
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
  const white = await made(page, { format: 'png', part: '0', size: 'width', width: 1600, white: true });
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
  await choose(page, { format: 'png', part: '0', size: 'width', width: 16000 });
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
  await choose(page, { format: 'png', part: '0', size: 'width', width: 200, white: true });
  await page.click('#export button[value=copy]');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('Copied'));
  const size = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const bitmap = await createImageBitmap(await item.getType('image/png'));
    return [bitmap.width, bitmap.height];
  });
  assert.deepEqual(size, [200, 150]);
  // By a key, the selection alone.
  await page.evaluate(() => navigator.clipboard.writeText(''));
  await page.evaluate(() => batten.engine.act('editor_select', 1, 0));
  await settle(page);
  await page.focus('#stage');
  await page.keyboard.press('Control+Shift+C');
  const square = await page.evaluate(async () => {
    let [item] = await navigator.clipboard.read();
    while (!item?.types.includes('image/png')) {
      await new Promise(requestAnimationFrame);
      [item] = await navigator.clipboard.read();
    }
    const bitmap = await createImageBitmap(await item.getType('image/png'));
    return [bitmap.width, bitmap.height];
  });
  assert.deepEqual(square, [200, 200]); // of the width chosen last
  await context.close();
});
