// The rail of tools in groups, the name and key of a button that is pointed at, and the size of the controls.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, quiet, ready, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(() => browser.close());

const box = (page, one) => page.evaluate((selector) => document.querySelector(selector).getBoundingClientRect().toJSON(), one);

test('tools in groups; a name and a key beside what is pointed at', async () => {
  const { page, context } = await open(browser, server.address, { viewport: { width: 1280, height: 800 } });
  await page.mouse.move(600, 500); // a sign of a user
  await page.waitForSelector('.tip', { state: 'attached' });
  await page.evaluate(() => batten.words.load()); // titles say more then
  await quiet(page);
  const groups = await page.evaluate(() => [...document.querySelectorAll('.rail [role=group]')].map((group) =>
    [group.ariaLabel, ...[...group.querySelectorAll('button')].map((button) => button.dataset.name.slice(5))]));
  assert.deepEqual(groups.map(([name]) => name), ['Select', 'Draw', 'Shape and change', 'View']);
  assert.deepEqual(groups[0].slice(1), ['select']);
  assert.ok(groups[1].includes('sketch') && groups[2].includes('levels') && groups[3].includes('zoom'));
  // Every tool with an icon has one button there.
  const tools = await page.evaluate(() => batten.engine.tables().tools.map(({ command }) => command)
    .filter((name) => document.getElementById(`icon-${name}`)).map((name) => name.slice(5)));
  assert.deepEqual(groups.flatMap(([, ...names]) => names).sort(), tools.sort());
  // The browser's title waits while the name is shown, and is back afterwards.
  const button = page.locator('[data-name=tool-rectangle]');
  const title = await button.getAttribute('title');
  const shown = await page.evaluate(() => new Promise((done) => {
    const tip = document.querySelector('.tip');
    const on = document.querySelector('[data-name=tool-rectangle]');
    const start = performance.now();
    tip.addEventListener('toggle', () => done(performance.now() - start), { once: true });
    on.dispatchEvent(new PointerEvent('pointerover', { bubbles: true, pointerType: 'mouse' }));
  }));
  console.log(`the name is shown after ${Math.round(shown)} ms`);
  assert.equal(await page.textContent('.tip span'), 'Rectangle');
  assert.equal(await page.textContent('.tip kbd'), 'Shift+M');
  assert.equal(await button.getAttribute('title'), '');
  const [tip, on] = [await box(page, '.tip'), await box(page, '[data-name=tool-rectangle]')];
  assert.ok(tip.left >= on.right && Math.abs((tip.top + tip.bottom - on.top - on.bottom) / 2) < 1);
  await pictures(page, 'rail');
  await page.mouse.move(1100, 300);
  await quiet(page);
  assert.equal(await page.isVisible('.tip'), false);
  assert.equal(await button.getAttribute('title'), title);
  // In the bar below the button, within the window; by keys as well.
  await page.focus('#stage');
  for (const key of ['Shift+F6', 'Shift+F6', 'End']) {
    await page.keyboard.press(key);
    await quiet(page);
  }
  await quiet(page);
  const [below, last] = [await box(page, '.tip'), await page.evaluate(() => document.activeElement.getBoundingClientRect().toJSON())];
  assert.ok(below.top >= last.bottom && below.right <= 1280);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('.tip'), false);
  await context.close();
});

test('controls of twice the size at 3840 x 2160, the drawing as it was', async () => {
  const { page, hand, context } = await open(browser, server.address, { viewport: { width: 3840, height: 2160 } });
  await page.waitForSelector('.dial');
  await quiet(page);
  const parts = ['.bar', '.rail', '.inspector', '.foot', '.bar .tool', '.dial'];
  const sizes = () => Promise.all(parts.map(async (one) => {
    const { width, height } = await box(page, one);
    return one === '.bar' || one === '.foot' ? height : width;
  }));
  const once = await sizes();
  await page.click('[data-name=settings]');
  await page.selectOption('#setting-scale', '200');
  await quiet(page);
  await pictures(page, 'scale-settings');
  await page.keyboard.press('Escape');
  const twice = await sizes();
  parts.forEach((part, i) => assert.ok(Math.abs(twice[i] - 2 * once[i]) <= 3, `${part}: ${once[i]}, ${twice[i]}`));
  await page.reload();
  await ready(page);
  await page.waitForSelector('.dial');
  await quiet(page);
  assert.deepEqual(await sizes(), twice, 'kept');
  // The drawing is as sharp as the screen, and a stroke is where the pen was.
  const canvas = await page.evaluate(() => [document.getElementById('still').width, document.getElementById('stage').clientWidth]);
  assert.equal(canvas[0], canvas[1]);
  const [x, y] = await place(page, 300, 40);
  await hand.stroke([[x, y], [x + 200, y + 50], [x + 500, y]]);
  await quiet(page);
  const ends = await page.evaluate(() => {
    const { points } = JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.at(-1).curves[0];
    return points[0];
  });
  assert.ok(Math.hypot(ends[0] - 300, ends[1] - 40) < 2, `${ends}`);
  // What stands at a place of the drawing is there: the row of commands above the selection.
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await quiet(page);
  await page.waitForSelector('.actions:not([hidden])');
  await quiet(page);
  const [row, stage] = [await box(page, '.actions'), await box(page, '#stage')];
  assert.ok(row.left >= stage.left && row.right <= stage.right && row.top >= stage.top && row.bottom <= stage.bottom, JSON.stringify(row));
  const top = Math.min((await place(page, 0, 10))[1], (await place(page, 0, 116))[1]);
  assert.ok(row.bottom <= top + 400);
  await pictures(page, 'scale');
  // The menu opens at the pointer.
  const at = await place(page, 500, 300);
  await page.mouse.click(at[0], at[1], { button: 'right' });
  await page.waitForSelector('.context', { state: 'visible' });
  const menu = await box(page, '.context');
  assert.ok(Math.abs(menu.left - at[0]) < 2 && (Math.abs(menu.top - at[1]) < 2 || menu.bottom > 2100), `${JSON.stringify(menu)} ${at}`);
  await pictures(page, 'scale-menu');
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('on a narrow window nothing is larger', async () => {
  const { page, context } = await open(browser, server.address, { viewport: { width: 390, height: 844 } });
  await page.evaluate(() => localStorage.setItem('batten-scale', '200'));
  await page.reload();
  await ready(page);
  await quiet(page);
  assert.equal(await page.evaluate(() => document.documentElement.style.getPropertyValue('--scale')), '1');
  await page.setViewportSize({ width: 1170, height: 800 });
  await settle(page);
  assert.equal(await page.evaluate(() => document.documentElement.style.getPropertyValue('--scale')), '1.5');
  await context.close();
});
