// The sheet of commands: opened by its key, searched, commands run from it; keys assigned, removed, reported when other
// commands use them too, restored, and kept across a reload. All by keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, quiet, ready, SCREENSHOTS, settle, violations } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

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
  await page.keyboard.press('ArrowDown'); // the first is marked
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.command), found[2]);
  await page.keyboard.press('ArrowUp');
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

/** What people who know other programs type, and what comes first; several where the word means several things. */
const WORDS = {
  'pencil': 'tool-sketch', 'pen tool': 'tool-tangents', 'brush': 'tool-sketch', 'bezier': 'tool-tangents', 'flip': 'mirror-across',
  'reflect': 'mirror-across', 'union': 'region-unite', 'boolean': 'region-unite', 'merge': 'region-unite combine', 'subtract': 'region-subtract',
  'rotate': 'rotate-left rotate-right', 'delete': 'delete', 'color': 'setting-stroke-colour setting-fill-colour',
  'colour': 'setting-stroke-colour setting-fill-colour', 'fill': 'setting-filled setting-fill-colour', 'gradient': 'setting-fill-colour',
  'image': 'open', '3d': 'orbit-up tool-lift', 'extrude': 'tool-lift surface-ruled', 'lathe': 'surface-revolve', 'revolve': 'surface-revolve',
  'camera': 'camera-here camera-new camera-along', 'animation': 'move-play', 'loft': 'surface-loft', 'surface': 'tool-surface',
  'mirror': 'mirror-across', 'symmetry': 'symmetry', 'dark': 'theme', 'theme': 'theme', 'zoom': 'tool-zoom zoom-in', 'fit': 'view-fit',
  'png': 'export-png', 'pdf': 'export-pdf', 'dxf': 'export-dxf', 'save as': 'save-as', 'new': 'new', 'blank': 'new', 'undo': 'undo',
  'layers': 'layers', 'settings': 'settings', 'preferences': 'settings', 'help': 'shortcuts', 'manual': 'shortcuts', 'shortcuts': 'shortcuts',
  'smooth': 'tool-smooth', 'align': 'align-left align-top', 'trim': 'curve-split', 'scissors': 'curve-split', 'node': 'tool-points',
  'corner': 'corner-make', 'dash': 'setting-dashes', 'ruler': 'show-rulers', 'snap': 'snap', 'language': 'setting-language',
  'taper': 'setting-widths', 'units': 'setting-unit', 'artboard': 'numbers', 'print': 'export-pdf', 'import': 'open',
  'zebra': 'setting-look look-next', 'mask': 'region-intersect', 'example': 'start-car', 'sample': 'start-car',
};

test('what is meant is found by the word that one has, and what is typed too early is not lost', async () => {
  const { page, context } = await open(browser, server.address);
  await page.mouse.move(600, 300); // the sheet is fetched at the first sign of a user
  await page.waitForFunction(() => batten.requests.commands);
  await settle(page);
  const digest = await page.evaluate(() => batten.engine.digest());
  await page.keyboard.press('Control+k');
  await page.keyboard.press('h');
  await page.keyboard.press('a');
  await page.waitForFunction(() => document.activeElement?.classList.contains('search'));
  await page.keyboard.type('iry');
  assert.equal(await page.inputValue('#menu .search'), 'hairy');
  assert.equal(await page.evaluate(() => batten.engine.digest()), digest);
  const wrong = await page.evaluate((words) => {
    const { search } = batten.requests.commands;
    return Object.entries(words).map(([word, meant]) => {
      search.value = word;
      search.dispatchEvent(new Event('input'));
      const first = document.querySelector('#menu .best [data-command]')?.dataset.command ?? '';
      return meant.split(' ').includes(first) ? '' : `${word}: ${first}`;
    }).filter(Boolean);
  }, WORDS);
  assert.deepEqual(wrong, []);
  await page.fill('#menu .search', 'union');
  await shot(page, 'union');
  await page.fill('#menu .search', 'quux');
  assert.match(await page.textContent('#menu'), /Nothing found for “quux”/);
  // What the drawing has is found after what the editor has, and selected.
  await page.fill('#menu .search', 'rear-hub');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 500)).rows.find(({ selected }) => selected)?.name.toLowerCase()), 'rear-hub');
  await page.keyboard.press('Escape');
  await sheet(page, 'Control+k');
  // A setting and a format open where they are.
  await page.fill('#menu .search', 'stabilizer');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement?.id === 'option-stabiliser');
  await page.keyboard.press('Escape');
  await sheet(page, 'Control+k');
  await page.keyboard.type('pdf');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#export-format');
  assert.equal(await page.inputValue('#export-format'), 'pdf');
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
    assert.deepEqual(await violations(page), []);
    await page.keyboard.type(locale === 'en' ? 'zoom in' : '확대');
    await settle(page);
    assert.equal((await shown(page))[0], 'zoom-in');
    assert.ok((await shown(page)).length <= 5, `${await shown(page)}`);
    await page.fill('#menu .search', 'ctrl+shift+z');
    assert.deepEqual(await shown(page), ['redo']);
    await page.click('#menu [data-focus=redo]');
    await settle(page);
    await shot(page, `${colorScheme}-${locale}-change`);
    assert.deepEqual(await violations(page), []);
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

test('Z: a click comes nearer, Alt goes away, a rectangle fills the window', async () => {
  const { page, hand, context } = await open(browser, server.address);
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
  await hand.stroke([[560, 240], [800, 420]], { during: () => inThemes(page, (colorScheme) => shot(page, `zoom-${colorScheme}`)) });
  await quiet(page);
  assert.ok((await zoom()) / before > 3);
  await inThemes(page, (colorScheme) => shot(page, `zoomed-${colorScheme}`));
  await context.close();
});
