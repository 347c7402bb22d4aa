// Files without a server: dropped, picked, refused, downloaded.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, drop, launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

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

/** Drops a file on the drawing. */
const count = (page) => page.evaluate(() => batten.painter.list.length);

test('a page without a server starts empty and says what to do', async () => {
  const { page, context } = await open(browser, server.address);
  assert.equal(await page.isVisible('#welcome'), true);
  await drop(page, 'car.svg', fs.readFileSync(EXAMPLE, 'utf8'));
  assert.equal(await page.isVisible('#welcome'), false);
  assert.equal(await page.textContent('#name'), 'car.svg');
  assert.ok(await count(page) > 20);
  await context.close();
});

test('download as SVG and as Batten file; both open again as they were', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await drop(page, 'car.svg', fs.readFileSync(EXAMPLE, 'utf8'));
  await hand.stroke([await place(page, 100, 60), await place(page, 200, 80), await place(page, 300, 50)]);
  const { digest } = await state(page);
  for (const [command, name] of [['download-svg', 'car.svg'], ['download-native', 'car.batten']]) {
    await page.click('[data-name=menu]');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-command=${command}]`)]);
    assert.equal(download.suggestedFilename(), name);
    const text = String(await downloaded(download));
    const other = await open(browser, server.address);
    await drop(other.page, name, text);
    assert.equal((await state(other.page)).digest, digest, name);
    await other.context.close();
  }
  await context.close();
});

test('the picker opens a file; Save without a server downloads where pages may not write files', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await page.evaluate(() => delete window.showOpenFilePicker);
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('[data-name=open]')]);
  await chooser.setFiles(EXAMPLE);
  await page.waitForFunction(() => document.getElementById('name').textContent === 'car.svg');
  await hand.stroke([await place(page, 100, 60), await place(page, 300, 50)]);
  assert.equal((await state(page)).unsaved, true);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+S')]);
  assert.equal(download.suggestedFilename(), 'car.svg');
  await settle(page);
  assert.equal((await state(page)).unsaved, false);
  await context.close();
});

test('every format that the engine reads opens, with another name too', async () => {
  const { page, context } = await open(browser, server.address);
  const lines = ['v 10 10 0', 'v 60 110 0', 'v 120 -40 0', 'v 200 60 0', 'cstype bspline', 'deg 3', 'curv 0 1 1 2 3 4',
    'parm u 0 0 0 0 1 1 1 1', 'end'];
  const curve = JSON.stringify({ degree: 3, points: [[0, 0], [40, 80], [90, -20], [160, 30]], knots: [0, 0, 0, 0, 1, 1, 1, 1] });
  for (const [name, text] of [['lines.obj', lines.join('\n')], ['curve.json', curve], ['curve', curve]]) {
    await drop(page, name, text);
    await page.waitForFunction((title) => document.getElementById('name').textContent === title, name);
    const saved = {};
    for (const [command, ending] of [['download-native', 'batten'], ['download-svg', 'svg']]) {
      await page.click('[data-name=menu]');
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-command=${command}]`)]);
      assert.equal(download.suggestedFilename(), `${name.replace(/\..*/, '')}.${ending}`);
      saved[ending] = String(await downloaded(download));
    }
    const { objects } = JSON.parse(saved.batten);
    assert.equal(objects.length, 1, name);
    assert.equal(objects[0].curves[0].points.length, 4, name);
  }
  await context.close();
});

test('bad files are refused with a reason, and change nothing', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'car.svg', fs.readFileSync(EXAMPLE, 'utf8'));
  const { digest } = await state(page);
  const bad = [['broken.svg', '<svg><path'], ['broken.batten', '{"format":"batten", '], ['other.html', 'hello']];
  for (const [name, text] of bad) {
    await drop(page, name, text);
    const now = await state(page);
    assert.ok(now.notice.startsWith(`${name} was not opened.`), now.notice);
    assert.ok(now.notice.length > name.length + 25, `a reason: ${now.notice}`);
    assert.equal(now.digest, digest);
  }
  await context.close();
});

test('a heavy drawing: the layer moves with the view at once and is painted when the hand rests', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const paths = Array.from({ length: 600 }, (_, i) => {
    const [x, y] = [10 + (i % 20) * 50, 10 + Math.floor(i / 20) * 20];
    const parts = Array.from({ length: 12 }, (_, k) => `q1.5 ${k % 2 ? -6 : 6} 3 0`).join('');
    return `<path d="M${x} ${y}${parts}"/>`;
  });
  await drop(page, 'heavy.svg', `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1020 620" fill="none"
    stroke="#000">${paths.join('')}</svg>`);
  assert.equal(await count(page), 601);
  const before = (await state(page)).counts;
  await page.mouse.move(600, 400);
  await page.evaluate(() => holdTimers(true)); // the hand never counts as resting
  for (let i = 0; i < 5; i++) {
    await page.mouse.wheel(20, 10);
    await settle(page);
  }
  const moved = await page.evaluate(() => ({
    ...batten.painter.counts, transform: document.getElementById('still').style.transform }));
  assert.ok(moved.moved > before.moved, 'the layer moved');
  await page.evaluate(() => holdTimers(false));
  await page.waitForFunction(() => document.getElementById('still').style.transform === '');
  await settle(page);
  const rested = await page.evaluate(() => ({
    ...batten.painter.counts, transform: document.getElementById('still').style.transform }));
  assert.ok(rested.full > before.full && rested.full <= before.full + 3, `painted ${rested.full - before.full} times`);
  assert.equal(rested.transform, '');
  // Memory has grown meanwhile; strokes and frames still read valid views.
  await hand.stroke([[100, 60], [300, 50], [500, 62]]);
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('what is not shown of an SVG file is told when it is opened', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'mixed.svg', `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
    <text x="5" y="5">Hi</text><image href="b.png" width="5" height="5"/><image href="a.png" width="5" height="5"/><path d="M10 10C20 0 30 20 40 10"/></svg>`);
  const { notice } = await state(page);
  assert.equal(notice, '2 items look different here; saving keeps them.');
  assert.equal(await count(page), 3, 'the page, the text and one path');
  await context.close();
});

test('markup, entities and scripts in a file stay inert', async () => {
  const { page, context } = await open(browser, server.address);
  const text = `<svg xmlns="http://www.w3.org/2000/svg" onload="globalThis.bad = 1"><script>bad = 1</script>
    <style>path { fill: red }</style><metadata><p xmlns="http://www.w3.org/1999/xhtml" style="color: red">x</p></metadata>
    <path id="&lt;b&gt;http://www.w3.org/2000/svg" d="M10 10C20 0 30 20 40 10" style="stroke: #123456" onclick="bad = 2"/></svg>`;
  await drop(page, 'x.svg', text);
  assert.equal(await page.evaluate(() => globalThis.bad), undefined);
  assert.equal(await count(page), 1);
  // The style is read all the same, text that looks like a namespace is unchanged, and the file is saved as it was.
  const [saved, object] = await page.evaluate(() => [new TextDecoder().decode(batten.engine.save(false)),
    JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.at(-1)]);
  assert.equal(saved, text);
  assert.match(JSON.stringify(object), /#123456/);
  await context.close();
});

test('an edited drawing is not replaced before the user has seen what the file holds', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await drop(page, 'car.svg', fs.readFileSync(EXAMPLE, 'utf8'));
  assert.equal(await page.textContent('#name'), 'car.svg', 'nothing was edited: nothing to ask');
  await hand.stroke([await place(page, 100, 60), await place(page, 300, 50)]);
  const { digest } = await state(page);
  const other = `<!DOCTYPE svg [<!ENTITY e "<g/>">]><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 96 48" width="96" height="48">&e;
    <path d="M0 0C20 0 30 20 40 10" stroke="#000"/><path d="M0 9h9" stroke="#000"/><text y="20">Hi</text></svg>`;
  await drop(page, 'other.svg', other);
  await page.waitForSelector('#holds[open]');
  assert.match(await page.textContent('#holds-text'), /“car\.svg” has changes that are not saved/);
  assert.deepEqual(await page.$$eval('#holds li', (all) => all.map((one) => one.textContent)),
    ['page 96 px × 48 px', 'curve 2', 'Texts 1']);
  assert.match(await page.textContent('#holds'), /1 item in this file can't be kept/);
  await page.waitForFunction(() => document.querySelector('#holds img').naturalWidth > 0);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'holds.png') });
  await page.keyboard.press('Escape');
  await page.waitForSelector('#holds', { state: 'detached' });
  assert.equal((await state(page)).digest, digest);

  await drop(page, 'other.svg', other);
  await page.click('#holds button[value=add]');
  await page.waitForFunction((was) => batten.engine.digest() !== was, digest);
  assert.equal(await page.textContent('#name'), 'car.svg');
  await page.keyboard.press('Control+Z');
  await page.keyboard.press('Control+Z');
  await settle(page);
  assert.equal((await state(page)).digest, digest, 'what was added is undone');

  await drop(page, 'other.svg', other);
  await page.click('#holds button[value=open]');
  await page.waitForFunction(() => document.getElementById('name').textContent === 'other.svg');
  assert.notEqual((await state(page)).digest, digest);
  await context.close();
});

test('a file that cannot be read is refused without a question, and the edited drawing stays', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke([[100, 60], [300, 50], [400, 90]]);
  const { digest } = await state(page);
  const refused = () => page.waitForFunction(() => document.querySelector('.notices').textContent.includes('bad.dxf was not opened'));
  await page.evaluate(() => batten.files.arrive([{ file: new File(['0\nSECTION\nzwei'], 'bad.dxf'), place: null }]));
  await refused();
  assert.equal(await page.isVisible('#holds'), false);
  assert.equal((await state(page)).digest, digest);
  assert.equal(await page.textContent('#name'), 'drawing.svg');
  await context.close();
});

