// The rail of tools in groups, the name and key of a button that is pointed at, and the size of the controls.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, quiet, ready, setting, settle, state, until, violations } from './page.mjs';
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
  assert.deepEqual(groups.map(([name]) => name), ['Select', 'Draw', 'Reshape', 'View']);
  assert.deepEqual(groups[0].slice(1), ['select']);
  assert.equal(await page.locator('.rail button:visible').count(), 10, 'slots');
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
  assert.equal(await page.textContent('.tip kbd'), 'R');
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

const flyout = '#flyout:popover-open';
const seen = (page) => page.$$eval('.rail button', (all) => all.filter((one) => one.checkVisibility()).map((one) => one.dataset.name.slice(5)));
const shown = async (page) => {
  await page.waitForSelector(flyout);
  await quiet(page);
  return page.$$eval(`${flyout} button`, (all) => all.map((one) => `${one.dataset.command.slice(5)}${one.ariaChecked === 'true' ? '*' : ''}`).join(' '));
};
const chosen = (page) => page.$eval('.rail [aria-pressed=true]', (one) => one.dataset.name);

for (const [locale, options] of [['en', {}], ['ko-KR', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }]]) {
  test(`a slot's flyout by mouse, pen, finger and keys, ${locale}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { locale, ...options });
    await page.keyboard.press('Shift'); // a sign of a user
    await until(page, () => batten.panel.flyout !== undefined);
    await quiet(page);
    const at = async (name) => {
      const { left, top, width, height } = await box(page, `[data-name=tool-${name}]`);
      return [left + width / 2, top + height / 2];
    };
    // The first press takes the tool, the second opens the others; a press beside them shuts them.
    await page.click('[data-name=tool-rectangle]');
    assert.equal(await page.locator(flyout).count(), 0);
    await page.click('[data-name=tool-rectangle]');
    assert.equal(await shown(page), 'rectangle* ellipse line polygon circle text');
    const [menu, rail] = [await box(page, flyout), await box(page, '.rail')];
    assert.ok(menu.left >= rail.right || menu.bottom <= rail.top, 'beside the rail');
    assert.ok(menu.right <= page.viewportSize().width && menu.top >= 0);
    assert.deepEqual(await violations(page), []);
    await pictures(page, `flyout-${locale}`);
    await page.click('[data-command=tool-ellipse]');
    await quiet(page);
    assert.equal(await chosen(page), 'tool-ellipse');
    assert.ok((await seen(page)).includes('ellipse') && !(await seen(page)).includes('rectangle'), 'the one used last is seen');
    // A pen that is held, goes on to a tool and lets go.
    const from = await at('smooth');
    await page.evaluate(() => { globalThis.rests = true; });
    await hand.stroke([from, from], { lift: false });
    assert.equal(await shown(page), 'smooth eraser width');
    const width = await box(page, '[data-command=tool-width]');
    const to = [width.left + 30, width.top + 10];
    await hand.drag(from, to);
    await hand.lift(to);
    await quiet(page);
    assert.equal(await chosen(page), 'tool-width');
    assert.equal(await page.locator(flyout).count(), 0);
    // A finger that is held and lets go where it is: the flyout stays, the tool in hand too.
    await hand.fingers([[await at('surface')]], { lift: false });
    assert.equal(await shown(page), 'surface lift');
    await hand.client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await quiet(page);
    assert.equal(await chosen(page), 'tool-width');
    await page.click('[data-command=tool-lift]');
    await quiet(page);
    assert.equal(await chosen(page), 'tool-lift');
    // Keys: the tool in hand is the rail's stop; the arrow towards the drawing opens, Escape goes back, Enter takes.
    await page.focus('#stage');
    await page.keyboard.press('Shift+F6');
    await settle(page);
    assert.equal(await page.evaluate(() => document.activeElement.dataset.name), 'tool-lift');
    const there = await page.getAttribute('#rail', 'aria-orientation') === 'horizontal' ? 'ArrowUp' : 'ArrowRight';
    await page.keyboard.press(there);
    assert.equal(await shown(page), 'surface lift*');
    await page.keyboard.press('Escape');
    assert.equal(await page.evaluate(() => document.activeElement.dataset.name), 'tool-lift');
    await page.keyboard.press(there);
    await shown(page);
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await quiet(page);
    assert.equal(await chosen(page), 'tool-surface');
    await page.keyboard.press('l'); // by its key, from another slot
    await quiet(page);
    assert.ok((await seen(page)).includes('line'));
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}

test('the keys that people know, and those of before as a choice', async () => {
  const { page, context } = await open(browser, server.address);
  const tools = async (...keys) => {
    const all = [];
    for (const key of keys) {
      await page.focus('#stage');
      await page.keyboard.press(key);
      await quiet(page);
      all.push((await chosen(page)).slice(5));
    }
    return all.join(' ');
  };
  assert.equal(await tools('p', 'r', 'o', 'l', 'i', 'v'), 'tangents rectangle ellipse line eyedropper select');
  await setting(page, 'key-map');
  await page.selectOption('#setting-key-map', 'earlier');
  await page.keyboard.press('Escape');
  assert.equal(await tools('t', 'Shift+M', 'Shift+O', 'u', 'Shift+I', 'l', 'p'), 'tangents rectangle ellipse line eyedropper levels lift');
  await page.reload();
  await ready(page);
  assert.equal(await tools('u', 'Shift+M'), 'line rectangle', 'kept');
  await setting(page, 'key-map');
  assert.equal(await page.inputValue('#setting-key-map'), 'earlier');
  await page.selectOption('#setting-key-map', 'standard');
  await page.keyboard.press('Escape');
  assert.equal(await tools('r', 'l'), 'rectangle line');
  assert.deepEqual(await page.evaluate(() => batten.settings.kept.keys), {});
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
  await setting(page, 'scale');
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
