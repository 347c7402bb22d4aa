// Earlier shape: a slider with the shapes that one curve had; the drawing stays as it is until one is kept, which is one step.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="400" fill="none" stroke="#22262b" stroke-width="4">
<path d="M100 200C200 50 400 50 500 200"/><path stroke="#c33" d="M80 340C300 280 500 380 740 320"/></svg>`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** Where the shape that is only shown is seen in the window, and what stands beside it. */
const lies = (page) => page.evaluate(() => {
  const { live, x, y, zoom, originX, originY } = glance();
  const stage = document.getElementById('stage').getBoundingClientRect();
  const [item] = live.filter(({ role, x1 }) => role === 5 && Number.isFinite(x1));
  const box = (part) => {
    const { left, top, right, bottom } = document.querySelector(part).getBoundingClientRect();
    return [left, top, right, bottom];
  };
  return { shape: item && [stage.left + (item.x0 + originX - x) * zoom, stage.top + (item.y0 + originY - y) * zoom,
    stage.left + (item.x1 + originX - x) * zoom, stage.top + (item.y1 + originY - y) * zoom], row: box('#actions'), chips: box('.chips'), stage: box('#stage') };
});
const apart = (a, b) => a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
const within = (a, b) => a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3];

test('it is offered only for a curve that had another shape, and nothing lies over that shape', async (t) => {
  const server = await serve({ name: 'roof.svg', bytes: Buffer.from(DRAWING) });
  t.after(() => server.close());
  for (const [locale, colorScheme] of [['en', 'light'], ['ko', 'dark']]) {
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme, viewport: { width: 1280, height: 800 } });
    await page.keyboard.press('v');
    const at = await place(page, 300, 87.5);
    await hand.stroke([at, at], { pointerType: 'mouse' });
    await page.waitForSelector('#actions [data-name=further]');
    const offered = () => page.locator('#actions [data-name=curve-earlier]').count();
    assert.equal(await offered(), 0);
    const enter = async (...numbers) => {
      await page.evaluate((all) => {
        all.forEach(([name, text]) => batten.engine.enter(name, text));
        batten.wake();
      }, numbers);
      await settle(page);
    };
    await page.evaluate(() => { batten.engine.set('stroke-width', 6); batten.wake(); });
    await settle(page);
    assert.equal(await offered(), 0, 'a look is no shape');
    // Smaller in each corner and in the middle, where it was larger; then larger than it was.
    const ways = [[['width', '90'], ['height', '40'], ['x', '120'], ['y', '180']], [['x', '400'], ['y', '60']], [['x', '560'], ['y', '300']],
      [['x', '20'], ['y', '340']], [['x', '600'], ['y', '20']], [['width', '700'], ['height', '300'], ['x', '40'], ['y', '40']]];
    for (const [i, numbers] of ways.entries()) {
      await enter(...numbers);
      assert.equal(await offered(), 1);
      await page.evaluate(() => { batten.engine.command('curve-earlier'); batten.wake(); });
      await page.locator('.chips input').waitFor();
      const first = await lies(page);
      for (const amount of [0, 0.5]) {
        await page.evaluate((share) => { batten.engine.refit(0, share, true); batten.wake(); }, amount);
        await settle(page);
        await settle(page);
        const { shape, row, chips, stage } = await lies(page);
        const told = `${locale} ${i} ${amount}: ${JSON.stringify({ shape, row, chips })}`;
        assert.ok(shape && apart(row, shape), `the row of commands: ${told}`);
        assert.ok(apart(chips, shape), `the slider: ${told}`);
        assert.ok(apart(row, chips), told);
        assert.ok(within(row, stage) && within(chips, stage), told);
        assert.deepEqual(chips.slice(0, 2), first.chips.slice(0, 2), 'the slider stays under the hand');
      }
      await page.screenshot({ path: path.join(SCREENSHOTS, `earlier-beside-${locale}-${i}.png`) });
      await page.keyboard.press('Escape');
      await settle(page);
    }
    await context.close();
  }
});

test('a curve is seen as it was, and one shape is kept', async (t) => {
  const server = await serve({ name: 'roof.svg', bytes: Buffer.from(DRAWING) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const opened = await state(page);
  await page.keyboard.press('v');
  const at = await place(page, 300, 87.5);
  await hand.stroke([at, at], { pointerType: 'mouse' });
  await page.evaluate(() => {
    for (const [name, text] of [['width', '560'], ['height', '60'], ['y', '180']]) {
      batten.engine.enter(name, text);
    }
    batten.wake();
  });
  await settle(page);
  const changed = await state(page);
  const steps = () => page.evaluate(() => JSON.parse(batten.engine.ask('editor_history')));
  const before = await steps();
  await page.click('#actions [data-name=further]');
  await page.click('#actions [data-name=curve-earlier]');
  const slider = page.locator('.chips input');
  await slider.waitFor();
  await settle(page);
  assert.equal(await slider.getAttribute('aria-label'), 'Earlier shape');
  assert.equal(await page.locator('.chips output').textContent(), 'Move');
  assert.deepEqual(await page.locator('.refit > span').allTextContents(), ['Before', 'Now']);

  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width - 8, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 4, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await settle(page);
  assert.equal(await page.locator('.chips output').textContent(), 'Opened');
  assert.equal((await state(page)).digest, changed.digest, 'only shown');
  await pictures(page, 'earlier');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal((await state(page)).digest, changed.digest, 'Escape leaves nothing');
  assert.equal(await page.locator('.chips').isVisible(), false);

  // By keys alone: the second shape, kept.
  await page.evaluate(() => {
    batten.engine.command('curve-earlier');
    batten.wake();
  });
  await slider.waitFor();
  await slider.focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await settle(page);
  assert.equal(await page.locator('.chips output').textContent(), 'Scale');
  await page.locator('.chips button', { hasText: 'Keep this' }).focus();
  await page.keyboard.press('Enter');
  await settle(page);
  const kept = await state(page);
  assert.equal(kept.check, '');
  assert.equal(await page.locator('.chips').isVisible(), false);
  assert.equal((await steps()).done, before.done + 1);
  assert.equal((await steps()).steps.at(-1), 'Earlier shape');
  assert.equal(await page.evaluate(() => batten.engine.number('width')), '560 px');
  assert.notEqual(await page.evaluate(() => batten.engine.number('height')), '60 px');
  await page.locator('#stage').focus();
  for (let i = 0; i <= before.done; i++) {
    await page.keyboard.press('Control+z');
  }
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest);
  await context.close();
});
