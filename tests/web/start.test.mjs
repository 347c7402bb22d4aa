// The empty page: what it offers, drawn through, gone with the first stroke and back when all is gone; the card of the
// first run, once.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { expectFaults, inThemes, launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const PICTURE = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==', 'base64');

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const middle = async (locator) => {
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 2, y + height / 2];
};
const saved = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))));
const start = (page, key) => page.locator(`.start [data-text="${key}"]`);

async function empty(options) {
  const server = await serve();
  const opened = await open(browser, server.address, options);
  await opened.page.waitForSelector('.start');
  await settle(opened.page);
  return { ...opened, server };
}

for (const [name, viewport, begun] of [['wide', { width: 1280, height: 800 }, 'dark'], ['phone', { width: 390, height: 844 }, 'light']]) {
  test(`the first run, ${name}, from ${begun} on`, async () => {
    const touch = name === 'phone';
    const server = await serve();
    const context = await browser.newContext({ viewport, colorScheme: begun, hasTouch: touch, isMobile: touch });
    await context.addInitScript(() => { // nobody has been here; the second page of the same browser has
      if (/^http/.test(location.protocol) && !localStorage.getItem('been')) {
        localStorage.removeItem('batten-hands');
        localStorage.setItem('been', 'here');
      }
    });
    const page = await context.newPage();
    await page.goto(server.address);
    await page.waitForSelector('.hands');
    await page.waitForSelector('.start');
    const inked = (index) => page.evaluate((at) => [...document.querySelectorAll('.hands figure')[at].querySelectorAll('canvas')]
      .map((canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.filter((v) => v > 0).length), index);
    await page.waitForFunction(() => document.querySelectorAll('.moving i.down').length > 0);
    await page.screenshot({ path: path.join(SCREENSHOTS, `start-${name}-${begun}-drawing.png`) });
    // The last hand has drawn something where nothing was.
    await page.waitForFunction(() => {
      const [canvas] = document.querySelectorAll('.hands figure:nth-child(3) canvas');
      return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some((value) => value > 0) &&
        !document.querySelector('.moving i.down');
    });
    for (const index of [0, 1, 2]) {
      assert.ok((await inked(index))[0] > 100, `picture ${index}`);
    }
    await inThemes(page, async (colorScheme) => {
      await page.screenshot({ path: path.join(SCREENSHOTS, `start-${name}-${colorScheme}.png`) });
      // Nothing is cut off, and the card covers none of the buttons.
      const boxes = await page.evaluate(() => ['.hands', '.start'].map((one) => document.querySelector(one).getBoundingClientRect().toJSON()));
      for (const box of boxes) {
        assert.ok(box.left >= 0 && box.right <= viewport.width && box.top >= 0 && box.bottom <= viewport.height, JSON.stringify(box));
      }
      assert.ok(boxes[0].bottom <= boxes[1].top);
    });
    await page.click('.hands-close');
    assert.equal(await page.locator('.hands').count(), 0);
    await page.reload();
    await page.waitForSelector('.start');
    await quiet(page);
    assert.equal(await page.locator('.hands').count(), 0, 'dismissed for good');
    await context.close();
  });
}

test('the hands come in a browser that is never idle, count as seen only then, and with reduced motion show what they have done', async () => {
  const server = await serve();
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  await context.addInitScript(() => {
    globalThis.requestIdleCallback = (run, { timeout } = {}) => timeout && setTimeout(run, timeout);
    if (/^http/.test(location.protocol)) {
      localStorage.removeItem('batten-hands');
    }
  });
  const page = await context.newPage();
  expectFaults(/sheets\/hands\.js/, /status of 404/);
  server.without = /^sheets\/hands\.js$/;
  await page.goto(server.address);
  await page.waitForSelector('[data-about=missing]');
  assert.equal(await page.evaluate(() => localStorage.getItem('batten-hands')), null, 'nothing has been seen');
  server.without = /^$/;
  await page.reload();
  await page.waitForSelector('.hands');
  assert.equal(await page.evaluate(() => localStorage.getItem('batten-hands')), 'seen');
  await quiet(page);
  assert.equal(await page.evaluate(() => document.querySelectorAll('.moving i.down').length), 0);
  const ink = await page.evaluate(() => {
    const [canvas] = document.querySelectorAll('.hands figure:nth-child(3) canvas');
    return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.filter((value) => value > 0).length;
  });
  assert.ok(ink > 100);
  await context.close();
});

test('pens draw through what an empty page offers; it goes with the first stroke and comes back', async () => {
  const { page, hand, context } = await empty();
  const from = await middle(start(page, 'shell.start-car'));
  await hand.stroke([from, [from[0] + 80, from[1] + 60], [from[0] + 200, from[1] + 20]]);
  await quiet(page);
  assert.equal((await saved(page)).objects.length, 1);
  assert.equal(await page.isVisible('.start'), false);
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await page.isVisible('.start'), true);
  await context.close();
});

test('a new page has the size asked for, in millimetres', async () => {
  const { page, hand, context } = await empty({ colorScheme: 'dark' });
  // By keys: the form opens, Escape leaves it.
  await start(page, 'shell.start-new').focus();
  await page.keyboard.press('Enter');
  assert.equal(await page.isVisible('.start-new'), true);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('.start-new'), false);
  // Tab goes on from one to the next.
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.text), 'command.open');
  // By a pen's tap.
  await hand.stroke([await middle(start(page, 'shell.start-new'))]);
  await page.waitForSelector('.start-new', { state: 'visible' });
  await quiet(page);
  assert.equal((await state(page)).notice, '', 'the tap was no stroke that failed');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'start-new.png') });
  await page.fill('.start-new input >> nth=0', '254');
  await page.fill('.start-new input >> nth=1', '127');
  await page.keyboard.press('Enter');
  await quiet(page);
  const { page: sheet } = await saved(page);
  [0, 0, 960, 480].forEach((value, i) => assert.ok(Math.abs(sheet[i] - value) < 1e-6, `${sheet}`));
  assert.equal(await page.isVisible('.start'), false, 'chosen');
  assert.equal((await state(page)).unsaved, false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'stage');
  // Something is drawn and taken away: the page is empty again.
  await hand.stroke([[400, 300], [500, 340], [640, 300]]);
  await quiet(page);
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await page.isVisible('.start'), true);
  assert.ok(Math.abs((await saved(page)).page[2] - 960) < 1e-6, 'with its page');
  await context.close();
});

test('a new page in pixels: an icon', async () => {
  const { page, hand, context } = await empty();
  await hand.stroke([await middle(start(page, 'shell.start-new'))]);
  await page.locator('.start-new button', { hasText: '24 × 24 px' }).click();
  await quiet(page);
  assert.deepEqual((await saved(page)).page, [0, 0, 24, 24]);
  assert.match(await page.evaluate(() => new TextDecoder().decode(batten.engine.save(false))), /width="24(px)?" height="24(px)?" viewBox="0 0 24 24"/);
  assert.equal(await page.evaluate(() => batten.engine.get('unit')), 0);
  await page.waitForSelector('#page-sizes');
  assert.equal(await page.$eval('#page-sizes', (select) => select.value), '24 × 24 px');
  await page.selectOption('#page-sizes', '1080 × 1080 px');
  await quiet(page);
  assert.deepEqual((await saved(page)).page, [0, 0, 1080, 1080]);
  await context.close();
});

test('the car, a picture to trace, and a file, from an empty page', async () => {
  const { page, hand, context } = await empty();
  let chooser = page.waitForEvent('filechooser');
  await hand.stroke([await middle(start(page, 'shell.start-trace'))]);
  await (await chooser).setFiles([{ name: 'photo.png', mimeType: 'image/png', buffer: PICTURE }]);
  await page.waitForFunction(() => document.getElementById('welcome').hidden);
  await quiet(page);
  assert.deepEqual((await saved(page)).objects.map(({ kind }) => kind), ['image']);
  await page.keyboard.press('Control+z');
  await quiet(page);
  await page.evaluate(() => { delete window.showOpenFilePicker; });
  chooser = page.waitForEvent('filechooser');
  await page.click('.start [data-text="command.open"]');
  await chooser;
  await start(page, 'shell.start-car').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.getElementById('name').textContent === 'car.svg');
  await quiet(page);
  assert.ok((await saved(page)).objects.length > 20);
  assert.equal(await page.isVisible('.start'), false);
  assert.equal((await state(page)).check, '');
  await context.close();
});

for (const [said, options] of [['Tap', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }], ['Click', {}]]) {
  test(`before the first touch hints say ${said}`, async () => {
    const { page, context } = await empty(options);
    await page.evaluate(() => { batten.engine.command('tool-zoom'); batten.wake(); });
    await settle(page);
    assert.equal((await state(page)).hint.split(' ')[0], said);
    await context.close();
  });
}
