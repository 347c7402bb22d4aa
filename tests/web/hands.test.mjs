// Hands: fingers that draw, pinch, rotate, undo and redo; a pen that takes precedence over them; the left hand.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, inThemes, launch, open, place, quiet, reveal, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const TABLET = { viewport: { width: 1024, height: 768 }, hasTouch: true };

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

const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `hands-${name}.png`) });

/** Two fingers about (x, y), turned from one angle to another (degrees) and spread from one distance to another. */
function pinch([x, y], angles, distances, count = 16) {
  return Array.from({ length: count + 1 }, (_, i) => {
    const [angle, half] = [angles, distances].map(([from, to]) => from + ((to - from) * i) / count);
    const dx = (Math.cos((angle * Math.PI) / 180) * half) / 2;
    const dy = (Math.sin((angle * Math.PI) / 180) * half) / 2;
    return [[x - dx, y - dy], [x + dx, y + dy]];
  });
}

test('a session with fingers alone', async () => {
  const { page, hand, context } = await open(browser, server.address, { ...TABLET });
  const stroke = async () =>
    (await Promise.all(bezier([440, 137], [490, 103], [560, 92], [690, 114]).map(([x, y]) => place(page, x, y))))
      .map((point) => [point]);
  const plain = (await state(page)).digest;
  await hand.fingers(await stroke());
  const drawn = (await state(page)).digest;
  assert.notEqual(drawn, plain, 'one finger draws');

  await hand.tap(2);
  assert.equal((await state(page)).digest, plain, 'two undo');
  await hand.tap(3);
  assert.equal((await state(page)).digest, drawn, 'three redo');

  const middle = [500, 380];
  const before = await state(page);
  hand.time += 1;
  const slight = pinch(middle, [0, 5], [160, 300]);
  await hand.fingers([slight[0].slice(0, 1), ...slight]);
  let now = await state(page);
  assert.ok(now.zoom > before.zoom * 1.6 && now.angle === 0, `a pinch that hardly turns stays upright: ${now.angle}`);
  const turned = pinch(middle, [0, 36], [300, 160]);
  await hand.fingers([turned[0].slice(0, 1), ...turned]);
  now = await state(page);
  assert.ok(Math.abs(now.angle - 30) < 1, `it turns: ${now.angle}`);
  assert.equal(now.digest, drawn);
  assert.match(await page.textContent('#readouts'), /, 30°/);
  await page.keyboard.press('f');
  await settle(page);
  await inThemes(page, (colorScheme) => shot(page, `turned-${colorScheme}`));

  const turnedStroke = await stroke();
  await hand.tap(2);
  await hand.fingers(turnedStroke);
  now = await state(page);
  assert.ok(![plain, drawn].includes(now.digest), 'and draws on the page as it lies');
  assert.equal(now.check, '');

  const back = pinch(middle, [30, -2], [200, 200]);
  await hand.fingers([back[0].slice(0, 1), ...back]);
  assert.equal((await state(page)).angle, 0, 'upright again');

  // In a rotated view, painting in parts gives the same as painting everything.
  await page.keyboard.press('6');
  await settle(page);
  await hand.tap(2);
  const different = await page.evaluate(async () => {
    const canvas = document.getElementById('still');
    // Colours weighted by alpha: those of an almost transparent pixel mean nothing.
    const read = () => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data
      .map((value, i, all) => ((i & 3) < 3 ? (value * all[i | 3]) / 255 : value));
    const parts = read();
    batten.painter.retheme();
    batten.wake();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const whole = read();
    return whole.reduce((count, value, i) => count + (Math.abs(value - parts[i]) > 90 ? 1 : 0), 0);
  });
  assert.equal(different, 0);
  await context.close();
});

test('after the pen fingers only navigate, until the switch says otherwise', async () => {
  const { page, hand, context } = await open(browser, server.address, TABLET);
  const line = (y) => Array.from({ length: 20 }, (_, i) => [[300 + 12 * i, y]]);
  await hand.hover([500, 300]);
  hand.time += 1;
  const plain = await state(page);
  await hand.fingers(line(500));
  assert.equal((await state(page)).digest, plain.digest);
  await page.click('[data-name=settings]');
  const box = page.locator('#settings [data-property=palm-rejection]');
  assert.equal(await box.isChecked(), true);
  await box.uncheck();
  await page.keyboard.press('Escape');
  await settle(page);
  hand.time += 1;
  await hand.fingers(line(500));
  assert.notEqual((await state(page)).digest, plain.digest);
  await context.close();
});

test('fingers beside a pen that draws neither undo nor end the stroke', async () => {
  const { page, hand, context } = await open(browser, server.address, TABLET);
  const stroke = await Promise.all(bezier([440, 137], [490, 103], [560, 92], [690, 114]).map(([x, y]) => place(page, x, y)));
  const plain = (await state(page)).digest;
  await hand.stroke(stroke, { lift: false });
  await hand.fingers([[[300, 500]], [[300, 500], [380, 500]]]);
  assert.equal((await state(page)).digest, plain);
  await hand.stroke(stroke.slice(-2), {});
  assert.notEqual((await state(page)).digest, plain);
  await context.close();
});

test('the pen wins over a finger that rests, drags or draws, and palms do nothing', async () => {
  const { page, hand, context } = await open(browser, server.address, TABLET);
  const stroke = await Promise.all(bezier([440, 137], [490, 103], [560, 92], [690, 114]).map(([x, y]) => place(page, x, y)));
  const plain = await state(page);
  const view = () => page.evaluate(() => Object.fromEntries(Object.entries(batten.painter.painted)
    .map(([name, value]) => [name, Math.round(value * 1e9) / 1e9])));
  const seen = await view();

  // A palm before the first pen: its size reaches the engine.
  await hand.fingers([[[700, 600]], [[640, 560]], [[600, 500]]], { radius: 45 });
  await hand.tap(2, [400, 400], { radius: 45 });
  assert.equal((await state(page)).digest, plain.digest, 'a palm does not draw');
  assert.deepEqual(await view(), seen);

  // A finger draws and then rests there: the pen takes over, and the finger's stroke is removed.
  await hand.fingers([[[700, 600]], [[640, 560]], [[600, 500]]], { lift: false });
  await hand.stroke(stroke, { lift: false });
  await shot(page, 'pen-beside-finger');
  await hand.lift(stroke.at(-1));
  const drawn = await state(page);
  assert.notEqual(drawn.digest, plain.digest);
  assert.equal(drawn.check, '');
  await hand.fingers([[[600, 500]]], { down: 1 });
  assert.equal((await state(page)).digest, drawn.digest);
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).digest, plain.digest, 'one step, the pen\'s');

  // Fingers that pan: the view returns to where it was when the pen takes over.
  hand.time += 1;
  await hand.fingers([[[700, 600]], [[640, 560]], [[600, 500]]], { lift: false });
  assert.notDeepEqual(await view(), seen);
  await hand.stroke(stroke);
  assert.deepEqual(await view(), seen);
  const again = (await state(page)).digest;
  assert.notEqual(again, plain.digest);
  await hand.fingers([[[600, 500]]], { down: 1 });

  // Dabs of palms undo nothing; those of fingers do.
  await hand.tap(2, [400, 400], { radius: 45 });
  assert.equal((await state(page)).digest, again);
  await hand.tap(2);
  assert.equal((await state(page)).digest, plain.digest);
  await context.close();
});

/** Touch targets smaller than 44 px; a checkbox counts together with its label. */
function small(page) {
  return page.$$eval('button, input:not([type=file]), select, summary, a', (targets) => targets.filter((target) => {
    const { width, height } = (target.type === 'checkbox' ? target.labels[0] : target).getBoundingClientRect();
    return target.checkVisibility() && (width < 44 || height < 44);
  }).map((target) => `${target.id || target.dataset.name || target.textContent} ${target.offsetWidth} x ${target.offsetHeight}`));
}

for (const [screen, viewport] of [['tablet', { width: 1024, height: 768 }], ['narrow', { width: 820, height: 1180 }]]) {
  test(`${screen}: every target is 44 px under a finger, for either hand`, async () => {
    const { page, context } = await open(browser, server.address, { viewport, hasTouch: true });
    assert.equal(await page.evaluate(() => matchMedia('(pointer: coarse)').matches), true);
    for (const hand of ['right', 'left']) {
      assert.deepEqual(await small(page), []);
      for (const sheet of ['style', 'layers', 'settings', 'menu']) {
        await reveal(page, sheet);
        await page.waitForSelector(`#${sheet} :is(button, input):visible`);
        await settle(page);
        assert.deepEqual(await small(page), [], sheet);
        const inside = await page.$eval(`#${sheet}`, (element) => {
          const { left, right } = element.getBoundingClientRect();
          return left >= 0 && right <= innerWidth;
        });
        assert.ok(inside, sheet);
        if (sheet === 'settings' && hand === 'right') {
          await page.locator('#settings [data-property=left-hand]').check();
        }
        await page.keyboard.press('Escape');
      }
    }
    await context.close();
  });
}

for (const [screen, options] of [['desk', { viewport: { width: 1280, height: 800 } }], ['tablet', TABLET]]) {
  test(`the left hand: the rail to the right, the bar the other way round; ${screen}`, async () => {
    const { page, context } = await open(browser, server.address, options);
    const sides = () => page.evaluate(() => Object.fromEntries(['#rail', '#tools'].map((id) => {
      const { left, right } = document.querySelector(id).getBoundingClientRect();
      return [id, (left + right) / 2 < innerWidth / 2 ? 'left' : 'right'];
    })));
    await page.click('[data-name=settings]');
    await page.waitForSelector('#settings [data-property=left-hand]');
    assert.deepEqual(Object.values(await sides()), ['left', 'right']);
    await page.locator('#settings [data-property=left-hand]').check();
    await settle(page);
    await inThemes(page, async (colorScheme) => {
      assert.deepEqual(Object.values(await sides()), ['right', 'left']);
      await shot(page, `left-${screen}-${colorScheme}`);
    });
    await page.locator('#settings [data-property=left-hand]').uncheck();
    await settle(page);
    assert.deepEqual(Object.values(await sides()), ['left', 'right']);
    await context.close();
  });
}

test('the pressure curve is drawn as the engine has it', async () => {
  const { page, context } = await open(browser, server.address);
  await page.click('[data-name=settings]');
  const heights = () => page.$eval('.pressure-curve polyline', (line) => [...line.points].map(({ y }) => 1 - y / 40));
  await page.waitForSelector('.pressure-curve');
  for (const curve of [1, 3, 0.4]) {
    await page.fill('#setting-pressure-curve', String(curve));
    await page.press('#setting-pressure-curve', 'Tab');
    for (const [i, height] of (await heights()).entries()) {
      assert.ok(Math.abs(height - (0.25 + 0.75 * (i / 40) ** curve)) < 1e-3);
    }
  }
  await page.locator('.pressure-curve').scrollIntoViewIfNeeded();
  await shot(page, 'pressure');
  await page.locator('#settings [data-property=pressure]').uncheck();
  assert.ok((await heights()).every((height) => height === 1));
  await context.close();
});

/** The first hints have gone and do not come back. */
async function goneForGood(page) {
  await settle(page);
  assert.equal(await page.isVisible('#first'), false);
  await quiet(page); // what was set is kept
  await page.reload();
  await page.waitForSelector('html[data-ready=yes]');
  await settle(page);
  assert.equal(await page.isVisible('#first'), false, 'they do not come back');
}

for (const [screen, options] of [['desk', { viewport: { width: 1280, height: 800 } }], ['tablet', TABLET]]) {
  test(`the first minute: hints go as they are followed, and stay away; ${screen}`, async () => {
    const { page, hand, context } = await open(browser, server.address, options);
    const hints = () => page.$$eval('#first p', (list) => list.filter((hint) => hint.checkVisibility()).length);
    assert.equal(await hints(), 3);
    assert.equal(await page.locator('dialog[open], :popover-open').count(), 0, 'no dialog stands in the way');
    await inThemes(page, async (colorScheme) => {
      assert.equal(await hints(), 3);
      await shot(page, `first-${screen}-${colorScheme}`);
    });
    const stroke = bezier([440, 137], [490, 103], [560, 92], [690, 114]);
    await hand.stroke(await Promise.all(stroke.map(([x, y]) => place(page, x, y))));
    assert.equal(await hints(), 2);
    await hand.tap(2);
    assert.equal(await hints(), 1);
    await page.click('[data-name=tool-points]');
    await goneForGood(page);
    await context.close();
  });
}

test('the first hints: sent away at once, drawn through, and none over an empty page', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const { x, y, width, height } = await page.locator('#first').boundingBox();
  const plain = (await state(page)).digest;
  await hand.stroke([[x + 10, y + height / 2], [x + width / 2, y + height - 8], [x + width + 90, y + 20]]);
  assert.notEqual((await state(page)).digest, plain, 'the pen draws through them');
  await page.click('#first button');
  await goneForGood(page);
  await context.close();
  const empty = await serve();
  const other = await open(browser, empty.address);
  assert.equal(await other.page.isVisible('#first'), false);
  assert.equal(await other.page.isVisible('#welcome'), true);
  await other.context.close();
  empty.close();
});
