// Everything without a pointer: a curve is drawn and a stretch of it redrawn, points are moved, objects are deleted,
// edits undone and saved, by keys alone; and what the page tells screen readers.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** Presses keys in turn; "3 x ArrowUp" presses three times. */
async function press(page, ...keys) {
  for (const key of keys) {
    const [, times, name] = /^(?:(\d+) x )?(.*)$/.exec(key);
    for (let i = 0; i < Number(times ?? 1); i++) {
      await page.keyboard.press(name);
      if (name.endsWith('F6')) {
        await settle(page); // the page responds once per frame
      }
    }
  }
  await settle(page);
}

const said = (page) => page.textContent('#said');
const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `keyboard-${name}.png`) });
/** The last curve of the drawing, from the file. */
const objects = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
/** Waits until the tree has been brought up to date. */
const calm = (page) => quiet(page);
/** The element that has the focus. */
const focus = (page) => page.evaluate(() => document.activeElement.id || document.activeElement.dataset.name ||
  document.activeElement.textContent);

async function loaded(page) {
  await page.keyboard.press('Shift'); // a sign of a user
  await page.waitForSelector('#mirror', { state: 'attached' });
  // From now on there may be no pointer event at all.
  await page.evaluate(() => {
    globalThis.pointed = 0;
    for (const kind of ['pointerdown', 'pointermove', 'mousedown', 'click', 'touchstart']) {
      addEventListener(kind, (event) => {
        globalThis.pointed += event.detail > 0 || kind !== 'click' ? 1 : 0;
      }, true);
    }
  });
}

test('a session by keys alone', async () => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  const { page, context } = await open(browser, server.address);
  await loaded(page);
  const first = await state(page);
  const count = (await objects(page)).length;

  // Draw: Enter places points, the arrows move the cursor, Enter twice in one place ends the line.
  await press(page, 'F6', 'F6', 'F6');
  assert.equal(await focus(page), 'stage');
  await press(page, 'Enter', '2 x Control+ArrowLeft', '10 x Shift+ArrowUp', '2 x Control+ArrowUp', 'Enter');
  await press(page, '2 x Control+ArrowRight', '6 x Shift+ArrowUp', 'Enter', '2 x Control+ArrowRight');
  await press(page, '6 x Shift+ArrowDown');
  assert.match(await said(page), /^Point 3 of 3: /);
  await inThemes(page, (colorScheme) => shot(page, `drawing-${colorScheme}`));
  await press(page, 'Enter', 'Enter');
  const drawn = await state(page);
  assert.notEqual(drawn.digest, first.digest);
  assert.equal(drawn.check, '');
  assert.equal((await objects(page)).length, count + 1);
  assert.equal((await said(page)).trim(), 'New curve');

  // Redraw a stretch of it: select the curve in the list, set the range by its ends, the path by five waypoints.
  await press(page, 'F6');
  await calm(page);
  await press(page, 'End');
  assert.match(await focus(page), /curve \d+, open, \d+ points/);
  await calm(page);
  assert.match(await said(page), /^Selected: curve/);
  await inThemes(page, (colorScheme) => shot(page, `list-${colorScheme}`));
  await press(page, 'Enter', 'Shift+T');
  assert.equal(await focus(page), 'stage');
  assert.match(await said(page), /Start of the range: /);
  await press(page, '2 x Shift+ArrowLeft', 'ArrowUp', '3 x Shift+ArrowRight');
  assert.match(await said(page), /^End of the range: /);
  await inThemes(page, (colorScheme) => shot(page, `range-${colorScheme}`));
  const before = (await objects(page)).at(-1);
  await press(page, 'Enter', '4 x Shift+ArrowDown');
  assert.match(await said(page), /^Point 3 of 5: /);
  await inThemes(page, (colorScheme) => shot(page, `redrawing-${colorScheme}`));
  assert.equal((await state(page)).digest, drawn.digest, 'nothing has changed yet');
  await press(page, 'Enter');
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, drawn.digest);
  assert.equal(redrawn.check, '');
  assert.equal((await objects(page)).length, count + 1);
  assert.notDeepEqual((await objects(page)).at(-1), before);

  // Points: move the next one; add a knot.
  await press(page, 'a', 'Tab', 'Tab', '3 x ArrowUp');
  assert.match(await said(page), /Point 2 of \d+: /);
  const moved = await state(page);
  assert.notEqual(moved.digest, redrawn.digest);
  await press(page, 'Insert');
  assert.notEqual((await state(page)).digest, moved.digest);
  await inThemes(page, (colorScheme) => shot(page, `points-${colorScheme}`));

  // Erase a stretch, smooth another, select, rotate, scale, delete.
  const busy = await state(page);
  await press(page, 'Shift+T', 'e', 'Enter');
  assert.equal((await objects(page)).length, count + 2);
  await press(page, 'Shift+T', 's', 'Enter');
  const smoothed = await state(page);
  assert.equal(smoothed.check, '');
  await press(page, 'v', 'Tab', 'Control+ArrowRight', 'Control+ArrowUp', 'ArrowLeft');
  await press(page, 'Delete');
  assert.equal((await objects(page)).length, count + 1);
  assert.equal((await said(page)).includes('Delete'), true);

  // Undo everything, and redo.
  for (let i = 0; i < 40 && (await state(page)).digest !== busy.digest; i++) {
    await press(page, 'Control+z');
  }
  assert.equal((await state(page)).digest, busy.digest);
  assert.match((await state(page)).notice, /^Undone: /);
  await press(page, '30 x Control+z');
  assert.equal((await state(page)).digest, first.digest);
  await press(page, '2 x Control+Shift+z');
  assert.equal((await state(page)).digest, redrawn.digest);

  // A spline of the tangents tool, started by keys.
  await press(page, 'Escape', 'p', 'Enter', 'Enter', 'Control+ArrowRight', 'Enter', 'Control+ArrowDown', 'Enter', 'Enter');
  assert.equal((await objects(page)).at(-1).kind, 'spline');
  await press(page, 'Tab', '2 x Shift+ArrowRight');
  await inThemes(page, (colorScheme) => shot(page, `spline-${colorScheme}`));

  // Save.
  await press(page, 'Control+s');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(server.bytes.toString(), /<svg/);
  assert.equal(await page.evaluate(() => globalThis.pointed), 0);
  await context.close();
  server.close();
});

test('the list mirrors the drawing, and the drawing the list', async () => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  const { page, context } = await open(browser, server.address);
  await loaded(page);
  await calm(page);
  const lines = () => page.$$eval('#mirror [role=treeitem]', (all) => all.map((line) => ({
    words: line.textContent, selected: line.ariaSelected, level: line.ariaLevel, expanded: line.ariaExpanded })));
  const all = await objects(page);
  assert.equal((await lines()).length, all.length);
  for (const [i, line] of (await lines()).entries()) {
    assert.ok(!all[i].name || line.words.startsWith(all[i].name), line.words);
  }

  // Selected in the drawing, selected in the list.
  await press(page, 'F6', 'F6', 'F6', 'v', 'Tab', 'Tab');
  await calm(page);
  assert.equal((await lines()).filter((line) => line.selected === 'true').length, 1);
  await press(page, 'F6');
  assert.equal((await focus(page)), (await lines()).find((line) => line.selected === 'true').words);
  assert.match(await focus(page), /group$/); // the select tool selects whole groups
  await press(page, 'ArrowRight');
  await calm(page);
  await press(page, 'Shift+F6');
  const chosen = (await lines()).findIndex((line) => line.selected === 'true');

  // The list starts at the drawing's selection; its points are listed below it.
  await press(page, 'F6');
  assert.equal(await focus(page), (await lines())[chosen].words);
  const one = await page.evaluate(() => document.activeElement.getBoundingClientRect().width);
  assert.ok(one > 100, 'the list is seen while it has the focus');
  await press(page, 'ArrowRight');
  await calm(page);
  const points = (await lines()).filter((line) => /^Point \d+ of/.test(line.words));
  assert.equal(points.length, Number(/(\d+) points/.exec((await lines())[chosen].words)[1]));
  await press(page, 'ArrowRight', 'ArrowDown');
  await calm(page);
  assert.match(await focus(page), /^Point 2 of/);
  assert.equal(await page.getAttribute('[data-name=tool-points]', 'aria-pressed'), 'true');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'keyboard-list-points.png') });

  // Moved in the drawing, moved in the list.
  const was = await focus(page);
  await press(page, 'Enter', '2 x Shift+ArrowDown');
  await calm(page);
  const now = (await lines()).find((line) => /^Point 2 of/.test(line.words)).words;
  assert.notEqual(now, was);
  assert.equal((await said(page)).endsWith(now), true);
  await press(page, 'Tab', 'F6');
  assert.match(await focus(page), /^Point 3 of/);
  await press(page, 'ArrowLeft', 'ArrowLeft');
  await calm(page);
  assert.equal((await lines()).length, all.length);

  // Deleted from the list: the focus stays in it.
  await press(page, 'v', 'Delete');
  await calm(page);
  assert.equal((await lines()).length, all.length - 1);
  assert.equal(await page.evaluate(() => document.getElementById('mirror').contains(document.activeElement)), true);
  await context.close();
  server.close();
});

test('of a thousand curves the list has a window, and walks through all', async () => {
  const paths = Array.from({ length: 1000 }, (_, i) => `<path d="M${i % 100} ${Math.floor(i / 100)}h.5"/>`);
  const server = await serve({ name: 'many.svg', bytes: Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 10"
    fill="none" stroke="#000" stroke-width=".1">${paths.join('')}</svg>`) });
  const { page, context } = await open(browser, server.address);
  await loaded(page);
  await calm(page);
  assert.ok(await page.$$eval('#mirror [role=treeitem]', (all) => all.length) <= 200);
  await press(page, 'F6', 'F6', 'F6', 'F6', 'End');
  await calm(page);
  const place = () => page.evaluate(() => [document.activeElement.getAttribute('aria-posinset'),
    document.activeElement.getAttribute('aria-setsize')]);
  assert.deepEqual(await place(), ['1000', '1000']);
  await press(page, '205 x ArrowUp');
  await calm(page);
  assert.deepEqual(await place(), ['795', '1000']);
  await press(page, 'Home', '205 x ArrowDown');
  await calm(page);
  assert.deepEqual(await place(), ['206', '1000']);
  await context.close();
  server.close();
});

test('the Tab key passes each toolbar in one stop, F6 each region, and nothing holds the keyboard', async () => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  const { page, context } = await open(browser, server.address);
  await loaded(page);
  const stops = [];
  for (let i = 0; i < 12; i++) {
    await press(page, 'Tab');
    stops.push(await page.evaluate(() => document.activeElement.closest('#tools, #rail, #stage, #mirror, .foot')?.id ?? ''));
  }
  for (const region of ['tools', 'rail', 'stage', 'mirror']) {
    assert.equal(stops.filter((stop, i) => stop === region && stops.indexOf(stop) === i).length, 1, region);
  }
  await press(page, 'F6');
  const regions = new Set();
  for (let i = 0; i < 10; i++) {
    await press(page, 'Shift+F6');
    regions.add(await page.evaluate(() => document.activeElement.closest('#tools, #rail, #stage, #mirror, #inspector, .foot').className));
  }
  assert.equal(regions.size, 6);
  // In a toolbar the arrows cycle through all enabled buttons.
  await page.focus('#tools button:not(:disabled)');
  const able = await page.$$eval('#tools button:not(:disabled)', (all) => all.filter((one) => one.checkVisibility()).length);
  const names = new Set();
  for (let i = 0; i < able; i++) {
    await press(page, 'ArrowRight');
    names.add(await focus(page));
  }
  assert.equal(names.size, able);
  // Tab leaves the drawing in any tool, range and points included.
  for (const keys of [['n'], ['n', 'Shift+T'], ['n', 'Enter'], ['a', 'Tab'], ['v', 'Tab'], ['p', 'Tab'], ['s', 'Shift+T'], ['e', 'Shift+T']]) {
    await page.focus('#stage');
    await press(page, ...keys, 'F6');
    assert.notEqual(await focus(page), 'stage', keys.join(' '));
    await press(page, '3 x Escape');
  }
  await context.close();
  server.close();
});

test('the ring around what has the focus comes with the Tab key, and goes with a pointer', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, context } = await open(browser, server.address);
  const focused = () => page.evaluate(() => {
    const { activeElement: element } = document;
    return [element.id || element.dataset.name, getComputedStyle(element).outlineStyle !== 'none'];
  });
  await page.mouse.click(600, 650);
  await page.keyboard.press('c');
  await settle(page);
  assert.deepEqual(await focused(), ['stage', false], 'a key for the drawing rings nothing');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'ring-none.png') });
  await page.mouse.click(600, 650);
  for (let i = 0; i < 3; i++) {
    const before = (await focused())[0];
    await page.keyboard.press('F6');
    await page.waitForFunction((name) => (document.activeElement.id || document.activeElement.dataset.name) !== name, before);
    assert.deepEqual((await focused())[1], true);
  }
  await page.mouse.click(600, 650);
  assert.deepEqual(await focused(), ['stage', false]);
  await page.keyboard.press('Shift+Tab'); // from the drawing, past the list beside it, to the tools
  await page.keyboard.press('Shift+Tab');
  assert.deepEqual((await focused())[1], true);
  await page.keyboard.press('ArrowDown');
  assert.deepEqual((await focused())[1], true);
  await context.close();
});

test('a key that is pressed as soon as the page is ready has the list come', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const context = await browser.newContext();
  let go;
  const held = new Promise((done) => (go = done));
  await context.route(/keep\/(clipboard|watch|offline)\.js$/, async (route) => {
    await held;
    await route.continue();
  });
  const { page } = await open(context, server.address);
  await page.keyboard.press('v');
  await page.waitForSelector('#mirror', { state: 'attached' });
  go();
  await context.close();
});
