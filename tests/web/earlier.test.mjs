// Earlier shape: a slider with the shapes that one curve had; the drawing stays as it is until one is kept, which is one step.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="400" fill="none" stroke="#22262b" stroke-width="4">
<path d="M100 200C200 50 400 50 500 200"/><path stroke="#c33" d="M80 340C300 280 500 380 740 320"/></svg>`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

for (const colorScheme of ['light', 'dark']) {
  test(`a curve is seen as it was, and one shape is kept, ${colorScheme}`, async (t) => {
    const server = await serve({ name: 'roof.svg', bytes: Buffer.from(DRAWING) });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { colorScheme });
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
    assert.equal(await page.locator('.chips output').textContent(), 'As it was opened');
    assert.equal((await state(page)).digest, changed.digest, 'only shown');
    await page.screenshot({ path: path.join(SCREENSHOTS, `earlier-${colorScheme}.png`) });
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
}
