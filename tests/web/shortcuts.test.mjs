// The sheet of commands: opened by its key, searched, commands run from it; keys assigned, removed, reported when other
// commands use them too, restored, and kept across a reload. All by keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, quiet, ready, SCREENSHOTS, settle } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const AXE = fs.readFileSync(path.join(HERE, 'node_modules/axe-core/axe.min.js'), 'utf8');

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
});

const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `shortcuts-${name}.png`) });
const shown = (page) => page.$$eval('#menu .command > [data-command]', (all) =>
  all.filter((one) => one.checkVisibility()).map((one) => one.dataset.command));
const keys = (page, command) => page.evaluate((name) =>
  batten.engine.tables().commands.find((row) => row.name === name).keys, command);
const tool = (page) => page.evaluate(() => batten.panel.tables.tools[glance().tool].name);
const type = async (page, key) => {
  await page.keyboard.press(key);
  await settle(page);
};
const wanted = (page, text) => page.waitForFunction((words) => document.querySelector('#menu').textContent.includes(words), text);

async function sheet(page, key = '?') {
  await type(page, key);
  await page.waitForSelector('#menu .search');
  await page.waitForFunction(() => document.activeElement?.classList.contains('search'));
}

test('Ctrl+K, a few letters and Enter run a command; arrows go through what was found; the last used come first', async () => {
  const { page, context } = await open(browser, server.address);
  await sheet(page, 'Control+k');
  await page.keyboard.type('zoom in');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#menu', { state: 'hidden' });
  await sheet(page, 'Control+/');
  assert.deepEqual((await shown(page)).slice(0, 1), ['zoom-in']);
  await page.keyboard.type('tool');
  const found = await shown(page);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.command), found[1]);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'search');
  await page.fill('#menu .search', 'select all');
  assert.equal(await page.locator('#menu .best').count(), 1);
  await shot(page, 'best');
  await page.keyboard.press('Enter');
  await sheet(page, 'Control+k');
  assert.deepEqual((await shown(page)).slice(0, 2), ['select-all', 'zoom-in']);
  await shot(page, 'last-used');
  await page.keyboard.type('nothing like that');
  await page.keyboard.press('Enter');
  assert.deepEqual(await shown(page), []);
  await page.keyboard.press('Escape');
  await page.reload();
  await ready(page);
  await sheet(page, 'Control+k');
  assert.deepEqual((await shown(page)).slice(0, 2), ['select-all', 'zoom-in']);
  await context.close();
});

for (const [colorScheme, locale] of [['light', 'en'], ['dark', 'ko']]) {
  test(`the sheet holds every command under its section, and finds them; ${colorScheme}, ${locale}`, async () => {
    const { page, context } = await open(browser, server.address, { colorScheme, locale });
    await sheet(page, locale === 'en' ? '?' : 'F1');
    const all = await page.evaluate(() => batten.panel.tables.commands.map((row) => row.name));
    assert.deepEqual(await shown(page), all);
    assert.ok((await page.$$('#menu h3')).length >= 10);
    await shot(page, `${colorScheme}-${locale}`);
    await page.evaluate(AXE);
    const violations = async () => (await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] })))
      .violations.map(({ id, nodes }) => `${id} ${nodes.map((node) => node.html)}`);
    assert.deepEqual(await violations(), []);
    await page.keyboard.type(locale === 'en' ? 'zoom in' : '확대');
    await settle(page);
    assert.ok((await shown(page)).includes('zoom-in'));
    assert.ok((await shown(page)).length <= 5);
    await page.fill('#menu .search', 'ctrl+shift+z');
    assert.deepEqual(await shown(page), ['redo']);
    await page.click('#menu [data-focus=redo]');
    await settle(page);
    await shot(page, `${colorScheme}-${locale}-change`);
    assert.deepEqual(await violations(), []);
    await type(page, 'Escape'); // ends the change
    assert.equal(await page.isVisible('#menu'), true);
    await type(page, 'Escape');
    assert.equal(await page.isVisible('#menu'), false);
    await context.close();
  });
}

test('a key is given, told to be another command\'s too, taken there, kept, and brought back', async () => {
  const { page, context } = await open(browser, server.address);
  await page.mouse.move(400, 300); // causes the explanations to be fetched
  await page.waitForFunction(() => batten.engine.words);
  assert.equal(await tool(page), 'sketch');
  await type(page, 'h');
  assert.equal(await tool(page), 'pan');
  await type(page, 'n');

  await sheet(page);
  await page.focus('#menu [data-focus=tool-pan]');
  await type(page, 'Enter'); // change its keys
  await type(page, 'q');
  assert.deepEqual(await keys(page, 'tool-pan'), ['H', 'Q']);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.focus), 'tool-pan', 'the focus stays');
  await type(page, 'a');
  assert.deepEqual(await keys(page, 'tool-pan'), ['H', 'Q', 'A']);
  await wanted(page, 'Also on: Points tool.');
  await shot(page, 'conflict');
  await page.click('#menu button:text("Use it only here")');
  assert.deepEqual(await keys(page, 'tool-points'), []);
  await page.click('#menu .rebinding button:has(kbd:text-is("H"))');
  assert.deepEqual(await keys(page, 'tool-pan'), ['Q', 'A']);
  await page.focus('#menu [data-focus=tool-pan]');
  await type(page, 'Control+Shift+ArrowLeft');
  await page.waitForFunction(() => /Also on: [^.]*\bRotate left\b[^.]*\./.test(document.querySelector('#menu').textContent));
  await type(page, '"'); // not a key that a table can hold
  await wanted(page, '" cannot be used.');
  assert.deepEqual(await keys(page, 'tool-pan'), ['Q', 'A', 'Ctrl+Shift+ArrowLeft']);
  await type(page, 'Escape');
  await type(page, 'Escape');

  for (const [key, name] of [['q', 'pan'], ['n', 'sketch'], ['a', 'pan'], ['n', 'sketch'], ['h', 'sketch']]) {
    await type(page, key);
    assert.equal(await tool(page), name, key);
  }
  assert.match(await page.getAttribute('[data-name=tool-pan]', 'title'), /\(Q\)$/);

  await quiet(page); // what was set is kept
  await page.reload();
  await ready(page);
  await type(page, 'q');
  assert.equal(await tool(page), 'pan');
  await type(page, 'n');
  await sheet(page, 'F1');
  await wanted(page, 'All keys back to the default');
  await page.focus('#menu [data-focus=tool-pan]');
  await type(page, 'Enter');
  await page.click('#menu button:text-is("Back to the default")');
  assert.deepEqual(await keys(page, 'tool-pan'), ['H']);
  assert.deepEqual(await keys(page, 'tool-points'), []);
  await page.click('#menu button:text-is("All keys back to the default")');
  assert.deepEqual(await keys(page, 'tool-points'), ['A']);
  assert.equal(await page.evaluate(() => Object.keys(batten.settings.kept.keys).length), 0);
  await context.close();
});

test('letters work while Hangul is typed', async () => {
  const { page, client, context } = await open(browser, server.address);
  await page.focus('#stage');
  const press = async (key, code, modifiers = 0) => {
    for (const kind of ['keyDown', 'keyUp']) {
      await client.send('Input.dispatchKeyEvent', { type: kind, key, code, modifiers });
    }
    await settle(page);
  };
  await press('ㅗ', 'KeyH');
  assert.equal(await tool(page), 'pan');
  await press('ㅜ', 'KeyN');
  assert.equal(await tool(page), 'sketch');
  await context.close();
});

for (const colorScheme of ['light', 'dark']) {
  test(`Z: a click comes nearer, Alt goes away, a rectangle fills the window; ${colorScheme}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { colorScheme });
    const zoom = () => page.evaluate(() => batten.painter.painted.zoom);
    await type(page, 'z');
    assert.equal(await tool(page), 'zoom');
    const before = await zoom();
    const cursor = () => page.evaluate(() => getComputedStyle(document.getElementById('stage')).cursor);
    await hand.stroke([[600, 400], [600, 400]], { pointerType: 'mouse' });
    await quiet(page);
    assert.ok(Math.abs((await zoom()) / before - 2) < 1e-6);
    assert.equal(await cursor(), 'zoom-in');
    await hand.stroke([[600, 400], [600, 400]], { pointerType: 'mouse', modifiers: 1 });
    await quiet(page);
    assert.ok(Math.abs((await zoom()) / before - 1) < 1e-6);
    await hand.stroke([[560, 240], [800, 420]], { during: () => shot(page, `zoom-${colorScheme}`) });
    await quiet(page);
    assert.ok((await zoom()) / before > 3);
    await shot(page, `zoomed-${colorScheme}`);
    await context.close();
  });
}
