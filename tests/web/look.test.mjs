// Appearance and access: accessibility in light and dark, target sizes, themes, screenshots.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, inThemes, launch, open, place, reveal, rulesIn, SCREENSHOTS, setting, settle, violations } from './page.mjs';
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

const SCREENS = [
  ['desk', { viewport: { width: 1280, height: 800 } }],
  ['tablet', { viewport: { width: 1024, height: 1366 }, hasTouch: true }],
];

for (const [screen, options] of SCREENS) {
  test(`${screen}: accessible, and a picture of each state in both themes`, async () => {
    const { page, hand, context } = await open(browser, server.address, options);
    // A picture of a state in both themes, and what axe-core finds in it.
    const look = (name, judged = true) => inThemes(page, async (colorScheme) => {
      if (judged) {
        assert.deepEqual(await violations(page, rulesIn(colorScheme)), [], `${name} ${colorScheme}`);
      }
      await page.screenshot({ path: path.join(SCREENSHOTS, `${screen}-${colorScheme}-${name}.png`) });
    });
    const small = async (name = '') => {
      const least = screen === 'tablet' ? 44 : 32;
      const found = await page.$$eval('button', (buttons, size) => buttons.filter((button) => {
        const { width, height } = button.getBoundingClientRect();
        return width > 0 && (width < size || height < size);
      }).map((button) => button.outerHTML), least);
      assert.deepEqual(found, [], name);
    };
    await look('open');
    await hand.hover(await place(page, 592, 103.5));
    await look('hover', false);
    const stroke = bezier([440, 137], [490, 103], [560, 92], [690, 114]);
    await hand.stroke(await Promise.all(stroke.map(([x, y]) => place(page, x, y))), { during: () => look('drawing', false) });
    await look('drawn');
    for (const sheet of ['settings', 'menu']) {
      await reveal(page, sheet);
      await settle(page);
      await look(sheet);
      await page.keyboard.press('Escape');
    }
    await inThemes(page, small);
    await context.close();
  });
}

test('the empty page, and a notice with something to do', async () => {
  const empty = await serve();
  const { page, context } = await open(browser, empty.address);
  assert.deepEqual(await violations(page), []);
  await page.evaluate(() => {
    batten.notices.ask('changed', 'The file changed on disk since it was opened. It was not touched.',
      [{ label: 'Download a copy', run: () => {} }]);
    batten.notices.say('Nothing to undo');
  });
  await page.evaluate(() => {
    document.getElementById('pending').hidden = false;
    document.getElementById('pending-text').hidden = false;
    document.getElementById('pending-text').textContent = 'The tolerance could not be met.';
    document.querySelectorAll('#pending button').forEach((button, i) => { button.hidden = i === 0; });
  });
  await page.screenshot({ path: path.join(SCREENSHOTS, 'desk-light-notice.png') });
  assert.deepEqual(await violations(page), []);
  await context.close();
  empty.close();
});

test('the theme button overrules the system and is remembered', async () => {
  const { page, context } = await open(browser, server.address, { colorScheme: 'light' });
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await page.click('[data-name=theme]');
  const dark = await ground();
  assert.notEqual(dark, light);
  await page.reload();
  await page.waitForSelector('html[data-ready=yes]');
  assert.equal(await ground(), dark);
  await context.close();
});

/** The colours that the page shows: of its paper, and of what is brightest and darkest on it. */
const shown = (page) => page.evaluate(() => {
  const canvas = document.getElementById('still');
  const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const seen = data.filter((_, i) => i % 4 === 1 && data[i + 2] > 200);
  return { ground: getComputedStyle(document.getElementById('stage')).backgroundColor,
    darkest: seen.reduce((a, b) => Math.min(a, b), 255), brightest: seen.reduce((a, b) => Math.max(a, b), 0) };
});

test('in the dark theme the paper is dim, and colours are turned over; white paper has them as they are, files keep them', async () => {
  const { page, context } = await open(browser, server.address, { colorScheme: 'light' });
  const light = await shown(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await settle(page);
  assert.equal(await page.getAttribute('[data-name=paper]', 'aria-pressed'), 'true');
  await page.click('[data-name=paper]');
  await settle(page);
  const white = await shown(page);
  assert.deepEqual({ ...white, ground: '' }, { ...light, ground: '' });
  assert.notEqual(white.ground, light.ground, 'the pasteboard is of the theme');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'white-paper-dark.png') });
  await setting(page, 'dim-paper');
  assert.equal(await page.isChecked('#setting-dim-paper'), false);
  await page.check('#setting-dim-paper');
  await settle(page);
  const dim = await shown(page);
  assert.ok(dim.brightest > 180 && dim.darkest < 60 && light.brightest > 240, JSON.stringify(dim));
  await page.screenshot({ path: path.join(SCREENSHOTS, 'dim-paper.png') });
  const text = await page.evaluate(() => new TextDecoder().decode(batten.engine.save(false)));
  assert.match(text, /#22262b/i);
  await page.reload();
  await page.waitForSelector('html[data-ready=yes]');
  await settle(page);
  assert.deepEqual(await shown(page), dim);
  await context.close();
});

test('all of it can be reached by the keyboard, with a visible focus', async () => {
  const { page, context } = await open(browser, server.address);
  await page.keyboard.press('Shift'); // a sign of a user
  await page.waitForSelector('#mirror', { state: 'attached' });
  const reached = new Set();
  const note = async () => reached.add(await page.evaluate(() => {
    const element = document.activeElement;
    const { outlineStyle, outlineWidth } = getComputedStyle(element);
    const seen = outlineStyle !== 'none' && outlineWidth !== '0px';
    const stop = document.getElementById('mirror').contains(element) ? 'mirror' : element.dataset.name ?? element.id;
    return `${stop}${seen || element === document.body ? '' : ' without a ring'}`;
  }));
  for (let i = 0; i < 400 && !reached.has('readout-tolerance'); i++) {
    await page.keyboard.press('Tab');
    await note();
    // A toolbar is one tab stop; the arrows move within it, and in the rail the one to the drawing opens a flyout.
    for (let k = 0; i < 12 && k < 24 && await page.evaluate(() => document.activeElement.closest('[role=toolbar]')); k++) {
      await page.keyboard.press('ArrowDown');
      await note();
    }
  }
  assert.deepEqual([...reached].filter((name) => name.endsWith('ring')), []);
  for (const name of ['tool-sketch', 'tool-pan', 'save', 'settings', 'menu', 'theme', 'stage', 'mirror', 'readout-tolerance']) {
    assert.ok(reached.has(name), name);
  }
  await page.focus('[data-name=menu]');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#menu'); // fetched when it is first opened
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#menu'), false);
  await context.close();
});

for (const width of [390, 620, 820]) {
  test(`under a finger, ${width} wide: sheets open below the bar, and what is said covers neither hints nor foot`, async () => {
    const { page, context } = await open(browser, server.address, { viewport: { width, height: 844 }, hasTouch: true,
      isMobile: true });
    const box = (name) => page.locator(name).boundingBox();
    const bar = await box('#bar');
    for (const sheet of ['style', 'settings', 'layers']) {
      await reveal(page, sheet);
      await settle(page);
      const { x, y, width: wide, height } = await box(sheet === 'settings' ? '#settings' : '#inspector');
      assert.ok(y >= bar.y + bar.height && y + height <= 844 && x >= 0 && x + wide <= width, sheet);
      await page.keyboard.press('Escape');
    }
    if (width < 700) { // there the inspector takes the place of the hints
      await page.click('[data-name=inspector]');
    }
    await page.evaluate(() => {
      const run = () => {};
      batten.notices.ask('kept', 'Unsaved work on car.svg was brought back.', [{ label: 'Open it as saved', run }]);
      batten.notices.ask('changed', 'The file changed on disk since it was opened. It was not touched.',
        [{ label: 'Look at both', run }, { label: 'Overwrite it', run }, { label: 'Save beside it', run }]);
      batten.notices.say('Undo: Sketch a curve');
    });
    const boxes = [await box('#first'), await box('[data-about=kept]'), await box('[data-about=changed]'), await box('#notice'),
      await box('.foot')];
    for (let i = 1; i < boxes.length; i++) {
      assert.ok(boxes[i - 1].y + boxes[i - 1].height <= boxes[i].y, 'nothing hides another');
      assert.ok(boxes[i].x >= 0 && boxes[i].x + boxes[i].width <= width);
    }
    for (const button of await page.locator('.asked button').all()) {
      const { x, width: wide } = await button.boundingBox();
      assert.ok(x >= 0 && x + wide <= width, `${await button.textContent()} can be reached`);
    }
    const [hint, readouts] = [await box('#hint'), await box('#readouts')];
    assert.ok(width < 700 ? hint.x + hint.width <= readouts.x : hint.y + hint.height <= readouts.y);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
    await page.screenshot({ path: path.join(SCREENSHOTS, `narrow-${width}.png`) });
    for (const [wide, high] of width < 700 ? [[width, 844], [360, 640]] : []) { // a phone: the drawing has four fifths of it
      await page.setViewportSize({ width: wide, height: high });
      await settle(page);
      const [stage, rail, top] = [await box('#stage'), await box('#rail'), await box('#bar')];
      assert.equal(top.height, 48);
      assert.ok((stage.width * stage.height) / (wide * high) >= 0.8, `${stage.width} x ${stage.height} of ${wide} x ${high}`);
      assert.ok(rail.y >= stage.y + stage.height && rail.y + rail.height === high, 'the tools are at the bottom');
      assert.equal(await page.locator('.rail button:visible').count(), 10);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= wide);
    }
    await context.close();
  });
}

test('every command and every property of the engine is in the page', async () => {
  const { page, context } = await open(browser, server.address);
  await page.click('[data-name=menu]');
  await page.waitForSelector('#menu [data-command]');
  const listed = await page.$$eval('#menu [data-command]', (all) => all.map((one) => one.dataset.command)); // it goes with the sheet
  await page.keyboard.press('Escape');
  for (const sheet of ['style', 'layers', 'settings']) {
    await reveal(page, sheet);
    await page.waitForSelector(`#${sheet} h2`);
    await page.keyboard.press('Escape');
  }
  await page.click('[data-name=tool-levels]');
  const [x, y] = await place(page, 592, 103.5);
  await page.mouse.click(x, y);
  await page.waitForSelector('.levels:not([hidden])'); // the strip has controls too
  await page.waitForSelector('.options', { state: 'attached' });
  const found = () => page.$$eval('[data-property]', (all) => all.map((one) => one.dataset.property));
  const shown = new Set(await found());
  for (const tool of ['sketch', 'tangents', 'rectangle', 'polygon', 'smooth', 'eraser', 'select', 'surface']) { // its options are in the bar
    await page.evaluate((name) => {
      batten.engine.command(`tool-${name}`);
      batten.wake();
    }, tool);
    await settle(page);
    (await found()).forEach((name) => shown.add(name));
  }
  const missing = await page.evaluate(([menu, there]) => {
    const { commands, properties, tools } = batten.panel.tables;
    const lost = [];
    for (const row of commands) {
      if (!menu.includes(row.name)) lost.push(row.name);
    }
    for (const row of properties) {
      if (!there.includes(row.name) && !/^(array|offset)-/.test(row.name)) lost.push(row.name); // those are asked beside the selection
    }
    for (const row of tools) {
      const shown = `#rail [data-name="${row.command}"], #pictures [data-text="command.${row.command}"]`;
      if (!document.querySelector(shown)) lost.push(row.name);
    }
    return lost;
  }, [listed, [...shown]]);
  assert.deepEqual(missing, []);
  await context.close();
});
