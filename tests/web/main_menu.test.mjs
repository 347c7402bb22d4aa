// The menu of the logo, and the button that exports: by mouse, touch and keys.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, ready, SCREENSHOTS, violations } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(() => browser.close());

const focused = (page) => page.evaluate(() => document.activeElement.dataset.act ?? document.activeElement.dataset.command ?? document.activeElement.id);
const expanded = (page) => page.getAttribute('#logo', 'aria-expanded');

for (const [colorScheme, locale] of [['light', 'en'], ['dark', 'ko-KR']]) {
  test(`the logo opens the menu of drawings and files, ${colorScheme}, ${locale}`, async () => {
    const { page, context } = await open(browser, server.address, { colorScheme, locale });
    await page.click('#logo');
    await page.waitForSelector('#main-menu:popover-open');
    assert.equal(await expanded(page), 'true');
    await quiet(page);
    assert.deepEqual(await violations(page), []);
    await page.screenshot({ path: path.join(SCREENSHOTS, `main-menu-${colorScheme}.png`) });
    await page.click('#logo'); // once more closes it
    await page.waitForSelector('#main-menu', { state: 'hidden' });
    assert.equal(await expanded(page), 'false');
    // By keys: arrows go round, Escape gives the focus back, and what is chosen is done.
    await page.focus('#logo');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#main-menu:popover-open');
    assert.equal(await focused(page), 'new');
    await page.keyboard.press('ArrowUp');
    assert.equal(await focused(page), 'theme');
    await page.keyboard.press('Escape');
    assert.equal(await focused(page), 'logo');
    await page.keyboard.press('Enter');
    await page.click('#main-menu [data-act=settings]');
    await page.waitForSelector('#settings:popover-open h2');
    await context.close();
  });
}

test('the zoom in the bar opens the menu of zooms and views, by mouse and keys', async () => {
  const { page, context } = await open(browser, server.address);
  await page.click('#zoom');
  await page.waitForSelector('#zoom-menu:popover-open');
  assert.equal(await focused(page), 'zoom-in');
  await quiet(page);
  assert.deepEqual(await violations(page), []);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'zoom-menu.png') });
  await page.click('#zoom-menu [data-command=zoom-100]');
  await quiet(page);
  assert.equal(await page.textContent('#zoom'), '100 %');
  await page.focus('#zoom');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#zoom-menu:popover-open');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.match(await page.textContent('#zoom'), /^\d\d(\.\d+)? %$/, 'smaller');
  // The size of the window is not that of the drawing.
  const zoom = await page.textContent('#zoom');
  await page.setViewportSize({ width: 900, height: 640 });
  await quiet(page);
  assert.equal(await page.textContent('#zoom'), zoom);
  await context.close();
});

test('the button in the bar exports, by touch as well', async () => {
  const { page, context } = await open(browser, server.address, { viewport: { width: 390, height: 844 }, hasTouch: true });
  await page.tap('[data-name=export]');
  await page.waitForSelector('dialog[open]');
  assert.match(await page.textContent('dialog[open]'), /SVG/);
  await page.keyboard.press('Escape');
  await page.tap('#logo');
  await page.tap('#main-menu [data-act=new]');
  await ready(page);
  await page.waitForSelector('#welcome', { state: 'visible' });
  assert.equal(await page.textContent('#name'), 'drawing.svg');
  await context.close();
});
