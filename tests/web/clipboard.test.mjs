// The clipboard, by real keys and the browser's own clipboard: between two windows, and from other programs.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
let elsewhere; // another file: one that is opened twice is read-only
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  elsewhere = await serve({ name: 'other.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
  elsewhere.close();
});

/** Knots and points of the topmost objects, from the native file. */
const objects = (page, count) => page.evaluate((wanted) =>
  JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.slice(-wanted), count);
const size = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.length);
const clipboardThere = (page) => page.waitForFunction(() => batten.requests.clipboard !== null);

test('copied in one window, pasted in another, knot by knot', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await clipboardThere(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  const at = await place(page, 592, 103.5);
  await hand.stroke([at, at], { pointerType: 'mouse', modifiers: 2 }); // Ctrl: the curve, not its group
  await page.keyboard.press('Control+c');
  await settle(page);
  assert.match((await state(page)).notice, /Copied/);
  assert.equal((await state(page)).unsaved, false);
  const source = await page.evaluate(() => batten.engine.copy(false));
  const other = await context.newPage();
  await other.goto(elsewhere.address);
  await ready(other);
  await clipboardThere(other);
  await other.bringToFront();
  await other.focus('#stage');
  const before = await size(other);
  await other.keyboard.press('Control+v');
  await settle(other);
  assert.match((await state(other)).notice, /Pasted/);
  assert.equal(await size(other), before + 1);
  assert.equal(await other.evaluate(() => glance().selected), 1);
  await pictures(other, 'clipboard-pasted');
  const [pasted] = await objects(other, 1);
  const zoom = (await state(other)).zoom;
  const [first] = await page.evaluate((text) => {
    const json = new DOMParser().parseFromString(text, 'image/svg+xml').getElementsByTagName('batten:document')[0];
    return JSON.parse(json.textContent).objects;
  }, source);
  pasted.curves.forEach((curve, i) => {
    assert.deepEqual(curve.knots, first.curves[i].knots);
    curve.points.forEach((point, k) => point.forEach((value, axis) =>
      assert.ok(Math.abs(value - first.curves[i].points[k][axis] - 10 / zoom) < 1e-9)));
  });
  // Pasted in place: exactly where it was. Then cut, and undo restores it.
  await other.keyboard.press('Control+Shift+v');
  await settle(other);
  const [inPlace] = await objects(other, 1);
  assert.deepEqual(inPlace.curves, first.curves);
  const { digest } = await state(other);
  await other.keyboard.press('Control+x');
  await settle(other);
  assert.equal(await size(other), before + 1);
  await other.keyboard.press('Control+z');
  await settle(other);
  assert.equal((await state(other)).digest, digest);
  assert.equal((await state(other)).check, '');
  await context.close();
});

/** Puts text on the browser's clipboard, then pastes it by the key. */
async function pasteText(page, text) {
  await page.evaluate((words) => {
    const give = (event) => {
      event.clipboardData.setData('text/plain', words);
      event.preventDefault();
      event.stopImmediatePropagation();
    };
    addEventListener('copy', give, { capture: true, once: true });
    document.execCommand('copy');
  }, text);
  await page.keyboard.press('Control+v');
  await settle(page);
}

test('SVG of other programs: whole files, elements, path data; refused in one line', async () => {
  const { page, context } = await open(browser, server.address);
  await clipboardThere(page);
  await page.focus('#stage');
  const before = await size(page);
  const figma = '<svg width="24" height="24" viewBox="0 0 24 24" fill="none" xmlns="http://www.w3.org/2000/svg">\n' +
    '<path d="M2 2H22V22H2V2Z" fill="#D9D9D9" stroke="black"/>\n</svg>\n';
  const illustrator = '<?xml version="1.0" encoding="UTF-8"?>\n<svg id="a" xmlns="http://www.w3.org/2000/svg" ' +
    'viewBox="0 0 100 100"><defs><style>.b{fill:none;stroke:#f00}</style></defs><g transform="rotate(30)">' +
    '<polyline class="b" points="0 0 50 50 100 0"/></g></svg>';
  const fragment = '<g inkscape:label="x" transform="scale(2)"><path d="M0 0C1 1 2 1 3 0" style="stroke:#00f;fill:none"/></g>';
  for (const [i, text] of [figma, illustrator, fragment, 'M 10 10 L 30 10 20 30 Z'].entries()) {
    await pasteText(page, text);
    const [last] = await objects(page, 1);
    assert.equal(last.kind, 'path', text);
    assert.match((await state(page)).notice, /Pasted/);
    assert.ok(await size(page) >= before + i + 1);
  }
  await page.screenshot({ path: path.join(SCREENSHOTS, 'clipboard-others.png') });
  const { digest } = await state(page);
  for (const [text, says] of [['Hello, world', /holds no drawing/], ['<svg><path', /Not a well-formed SVG/],
    ['<p>text</p>', /holds no drawing/]]) {
    await pasteText(page, text);
    assert.match((await state(page)).notice, says);
    assert.equal((await state(page)).digest, digest);
  }
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('the commands of the menu ask the browser', async () => {
  const { page, context } = await open(browser, server.address, { permissions: ['clipboard-read', 'clipboard-write'] });
  await clipboardThere(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  const before = await size(page);
  for (const name of ['copy', 'paste']) {
    await page.click('[data-name="menu"]');
    await page.click(`#menu [data-command="${name}"]`);
    await settle(page);
  }
  await page.waitForFunction(() => /Pasted/.test(document.getElementById('notice-text').textContent));
  assert.equal(await size(page), 2 * before);
  await context.close();
});

test('other programs get it as SVG, too', async () => {
  const { page, context } = await open(browser, server.address, { permissions: ['clipboard-read', 'clipboard-write'] });
  await clipboardThere(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Control+c');
  const found = await page.evaluate(async () => {
    for (;;) { // the browser takes a while; the test's time limit ends this
      const [item] = await navigator.clipboard.read();
      if (item?.types.includes('image/svg+xml')) {
        return Promise.all(item.types.map(async (type) => [type, await (await item.getType(type)).text()]));
      }
      await new Promise((done) => setTimeout(done, 50));
    }
  });
  const { 'text/plain': text, 'image/svg+xml': svg } = Object.fromEntries(found);
  assert.equal(text, await page.evaluate(() => batten.engine.copy(false)), 'with every knot');
  const paths = (source) => source.match(/ d="[^"]+"/g);
  assert.deepEqual(paths(svg), paths(text));
  await context.close();
});
