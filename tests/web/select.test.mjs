// The select tool, style and layers in the browser: once with a mouse, once with a pen.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, reveal, SCREENSHOTS, settle, state, violations } from './page.mjs';
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

for (const [pointerType, colorScheme] of [['mouse', 'light'], ['pen', 'dark']]) {
  test(`select, move, style and layers with a ${pointerType}, ${colorScheme}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { colorScheme });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `select-${colorScheme}-${name}.png`) });
    const fresh = await state(page);
    await page.focus('#stage');
    await page.keyboard.press('v');
    const at = await place(page, 592, 103.5);
    await hand.stroke([at, at], { pointerType });
    assert.equal(await page.evaluate(() => glance().selected), 1);
    await shot('selected');
    await hand.stroke([at, [at[0] + 40, at[1] - 30]], { pointerType });
    const moved = await state(page);
    assert.notEqual(moved.digest, fresh.digest);
    await shot('moved');
    await page.keyboard.press('Control+a');
    await settle(page);
    await shot('all');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, fresh.digest);
    await reveal(page, 'style');
    await settle(page);
    await shot('style');
    await page.keyboard.press('Escape');
    await reveal(page, 'layers');
    await page.click('#layers .layer-commands button >> nth=0');
    await settle(page);
    assert.equal(await page.locator('#layers .layer-row').count(), 2);
    await shot('layers');
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}

test('a copy dragged off with Alt, a group entered by a double click', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const objects = () => page.evaluate(() =>
    JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.length);
  const selected = () => page.evaluate(() => glance().selected);
  const fresh = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  const at = await place(page, 592, 103.5);
  const before = await objects();
  await hand.stroke([at, [at[0] + 60, at[1] + 40]], { pointerType: 'mouse', modifiers: 1 });
  assert.ok(await objects() > before);
  await pictures(page, 'select-copy');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, fresh.digest);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Control+g');
  await page.keyboard.press('Control+Shift+a');
  await settle(page);
  await page.mouse.dblclick(...at);
  await settle(page);
  assert.equal(await selected(), 1);
  assert.ok((await page.evaluate(() => glance().labels.length)) > 0);
  await page.mouse.move(640, 200);
  await settle(page);
  assert.match((await state(page)).hint, /In a group/);
  await pictures(page, 'select-entered');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal(await page.evaluate(() => glance().labels.length), 0);
  assert.equal((await state(page)).check, '');
  await context.close();
});

// At any width, and however many rows the bar has: the drawing's rulers are 22 px wide.
for (const [name, hand, options] of [['desk', 0, {}], ['desk-left', 1, {}],
  ['tablet', 0, { viewport: { width: 700, height: 800 }, hasTouch: true, colorScheme: 'dark' }],
  ['phone', 1, { viewport: { width: 420, height: 800 }, hasTouch: true }]]) {
  test(`the row of actions lies off the bar, the tools and the rulers, ${name}`, async () => {
    const { page, context } = await open(browser, server.address, options);
    await page.evaluate((value) => batten.engine.set('left-hand', value), hand);
    await page.focus('#stage');
    for (const keys of ['v', 'Shift+R', 'Control+a']) {
      await page.keyboard.press(keys);
    }
    await page.waitForSelector('#actions:not([hidden])');
    await settle(page);
    const row = await page.locator('#actions').boundingBox();
    const stage = await page.locator('#stage').boundingBox();
    await page.screenshot({ path: path.join(SCREENSHOTS, `select-actions-${name}.png`) });
    assert.ok(row.y >= stage.y + 22 && row.x >= stage.x + 22, JSON.stringify([row, stage]));
    assert.ok(row.x + row.width <= stage.x + stage.width, JSON.stringify([row, stage]));
    // Off what is selected and its handles, which are seen in the live items.
    const off = await page.evaluate(() => {
      const { live, x, y, zoom, originX, originY } = glance();
      const all = live.filter(({ role }) => role === 10 || role === 11); // selection, handle
      const top = Math.min(...all.map((item) => (item.y0 + originY - y) * zoom));
      const bottom = Math.max(...all.map((item) => (item.y1 + originY - y) * zoom));
      const box = document.getElementById('actions').getBoundingClientRect();
      const from = document.getElementById('stage').getBoundingClientRect().top;
      return Math.max(top - (box.bottom - from), box.top - from - bottom);
    });
    assert.ok(Math.abs(off - 12) < 2, String(off));
    await context.close();
  });
}

test('buttons for the selection, layers dragged, a colour that lets through', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const shown = () => page.locator('#actions button:visible').evaluateAll((list) => list.map((one) => one.dataset.name));
  await page.focus('#stage');
  await page.keyboard.press('v');
  const at = await place(page, 592, 103.5);
  await hand.stroke([at, at], { pointerType: 'mouse' });
  await page.waitForSelector('#actions:not([hidden])');
  assert.equal((await shown()).at(-1), 'delete');
  for (const width of [480, 1280]) { // a row that is narrower than what "more" adds, too
    await page.setViewportSize({ width, height: 800 });
    await settle(page);
    const row = () => page.locator('#actions > .group button').evaluateAll((list) => list.map((button) => JSON.stringify(button.getBoundingClientRect())));
    const closed = await row();
    await page.click('#actions [data-name=further]');
    await settle(page);
    assert.deepEqual(await row(), closed, 'no button moves from under the pointer');
    if (width < 1280) {
      await page.click('#actions [data-name=further]'); // closes it
    }
  }
  const one = await shown();
  assert.ok(one.includes('order-front') && one.includes('curve-reverse') && !one.includes('group'), String(one));
  await pictures(page, 'select-actions-one');
  // The colour of its line stands in the row, and beside it a second one of the same.
  const outline = await page.evaluate(() => batten.engine.get('stroke-colour'));
  await page.click('#actions .dot.stroked button');
  await page.waitForSelector('#picker-sheet:popover-open');
  await page.fill('#picker-hex', '#c1121f');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.get('stroke-colour') >>> 8), 0xc1121f);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.get('stroke-colour')), outline);
  const had = await page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 500)).total);
  await page.click('#actions [data-name=duplicate]');
  await settle(page);
  assert.ok(await page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 500)).total) > had);
  await page.keyboard.press('Control+z');
  await page.focus('#stage');
  await page.keyboard.press('Control+a');
  await settle(page);
  assert.ok((await shown()).includes('group'));
  await pictures(page, 'select-actions');
  assert.deepEqual(await violations(page), [], 'the row of actions');
  await page.click('#actions [data-name="group"]');
  await settle(page);
  assert.equal(await page.evaluate(() => glance().selected), 1);
  assert.ok((await shown()).includes('ungroup'));
  await page.keyboard.press('Control+Shift+a');
  await settle(page);
  assert.equal(await page.isVisible('#actions'), false);
  // Three layers; the front one is dragged to the back by its grip, then moved up again with the keyboard.
  await reveal(page, 'layers');
  for (let i = 0; i < 3; i++) {
    await page.click('#layers [data-text="command.layer-add"]');
  }
  await settle(page);
  const names = () => page.evaluate(() => batten.engine.layers().layers.map((layer) => layer.name.at(-1)).join(''));
  assert.equal(await names(), '123');
  const middle = async (locator) => {
    const box = await locator.boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const grips = page.locator('#layers .grip');
  assert.deepEqual(await violations(page), [], 'layers with grips');
  await page.mouse.move(...await middle(grips.nth(0)));
  await page.mouse.down();
  await page.mouse.move(...await middle(grips.nth(2)), { steps: 4 });
  await pictures(page, 'select-layers-drag');
  await page.mouse.up();
  await settle(page);
  assert.equal(await names(), '312');
  await page.keyboard.press('ArrowUp');
  assert.equal(await names(), '132');
  await page.click('#layers [aria-label^="Hide"] >> nth=0');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.layers().layers.at(-1).hidden), true);
  await pictures(page, 'select-layers-icons');
  // A new colour keeps the old opacity, which is set beside it.
  await page.keyboard.press('Escape');
  await reveal(page, 'style');
  await page.locator('#style input[type=range]').first().fill('128');
  assert.equal(await page.evaluate(() => batten.engine.get('stroke-colour') & 255), 128);
  await page.locator('#setting-stroke-colour').fill('#ff0000');
  await page.locator('#setting-stroke-colour').dispatchEvent('change');
  assert.equal(await page.evaluate(() => batten.engine.get('stroke-colour')), 0xff000080);
  await pictures(page, 'select-style-alpha');
  // A fill whose own colour is transparent is seen when it is turned on.
  await page.evaluate(() => {
    batten.engine.set('fill-colour', 0);
    batten.engine.set('filled', 0);
    batten.wake();
  });
  await settle(page);
  assert.ok(await page.locator('#setting-fill-colour').isHidden());
  await page.check('#setting-filled');
  await settle(page);
  assert.deepEqual(await page.evaluate(() => [batten.engine.get('filled'), batten.engine.get('fill-colour') & 255]), [1, 255]);
  assert.ok(await page.locator('#setting-fill-colour').isVisible());
  assert.equal((await state(page)).check, '');
  await context.close();
});
