// Many copies: an array is seen before it is made, its numbers typed with units; the last transform is repeated by a key; what lies below
// is chosen with Alt.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="600" fill="none" stroke="#22262b" stroke-width="3">
<rect x="300" y="40" width="240" height="200" fill="#dde"/><path fill="#fc9" d="M380 100h80l20 60h-120z"/></svg>`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

for (const [locale, colorScheme, pointerType, viewport] of [['en', 'light', 'mouse'], ['ko-KR', 'dark', 'touch', { width: 390, height: 844 }]]) {
  test(`arrays, repetition and what lies below, ${locale}, ${colorScheme}, ${pointerType}`, async (t) => {
    const server = await serve({ name: 'bell.svg', bytes: Buffer.from(DRAWING) });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme, ...viewport && { viewport } });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `array-${name}-${colorScheme}.png`) });
    const said = (english, korean) => (locale === 'en' ? english : korean);
    await page.keyboard.press('v');
    const at = await place(page, 420, 130);
    await hand.stroke([at, at], { pointerType });
    await settle(page);
    const first = await state(page);
    const outline = () => page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 200)));
    const count = async () => (await outline()).total;
    const steps = () => page.evaluate(() => JSON.parse(batten.engine.ask('editor_history')).done);
    const done = await steps();
    const command = async (name) => {
      await page.evaluate((one) => { batten.engine.command(one); batten.wake(); }, name);
      await settle(page);
    };

    // From the row of buttons, or what is behind it where there is no room.
    await page.waitForSelector('#actions [data-name=array]', { state: 'attached' });
    await page.evaluate(() => document.querySelector('#actions [data-name=array]').click());
    const slider = page.locator('.chips input[type=range]');
    await slider.waitFor();
    await settle(page);
    assert.equal(await slider.getAttribute('aria-label'), said('Array', '배열'));
    assert.deepEqual(await page.locator('.chips .labelled > span:first-child').allTextContents(), said(['Count', 'Gap', 'Direction'], ['개수', '간격', '방향']));
    const field = (name) => page.locator(`#refit-array-${name}`);
    await field('count').fill('3');
    await field('gap').fill('5 mm');
    await field('direction').fill('30');
    await settle(page);
    assert.ok(Math.abs(await page.evaluate(() => batten.engine.get('array-gap')) - 5 * 96 / 25.4) < 1e-6, 'typed with its unit');
    assert.equal((await state(page)).digest, first.digest, 'only shown');
    await new Promise((resolve) => { setTimeout(resolve, 700); }); // the slider comes a moment later
    await shot('row');
    await field('count').fill('0');
    assert.equal(await field('count').getAttribute('aria-invalid'), 'true');
    await field('count').press('Enter');
    await settle(page);
    assert.equal(await page.locator('.chips').isVisible(), true);
    await field('count').press('Escape');
    await settle(page);
    assert.equal((await state(page)).digest, first.digest);
    assert.equal(await steps(), done);

    // A circle by the chips, kept by the last of them.
    await command('array');
    await page.locator('.chips button').nth(2).click();
    await settle(page);
    assert.equal(await page.locator('.chips [aria-pressed=true]').textContent(), said('Circle', '원'));
    await field('count').fill('7');
    await field('radius').fill('150');
    await settle(page);
    await shot('circle');
    await page.locator('.chips button').nth(3).click();
    await settle(page);
    assert.equal(await page.locator('.chips button').nth(3).textContent(), said('Turn along', '따라 돌리기'));
    await page.locator('.chips button').nth(3).click();
    await settle(page);
    await page.locator('.chips button').nth(4).click();
    await settle(page);
    const kept = await state(page);
    assert.equal(kept.check, '');
    assert.equal(await steps(), done + 1);
    assert.equal(await page.locator('.chips').isVisible(), false);
    await shot('kept');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, first.digest);

    // By keys alone: a grid, with too many first.
    await hand.stroke([at, at], { pointerType });
    await command('array');
    await page.locator('#stage').focus();
    for (let i = 0; i < 2; i++) { // the circle was last
      await page.keyboard.press('Tab');
      await settle(page);
    }
    assert.equal(await page.locator('.chips [aria-pressed=true]').textContent(), said('Grid', '격자'));
    await field('rows').fill('9000');
    await field('count').fill('9000');
    await settle(page);
    assert.match(await page.locator('.chips output').textContent(), /10,000/);
    await field('rows').fill('2');
    await field('count').fill('3');
    await settle(page);
    await shot('grid');
    await field('count').press('Enter');
    await settle(page);
    assert.equal(await steps(), done + 1);
    await page.keyboard.press('Control+z');
    await settle(page);

    // Repeated by its key.
    await hand.stroke([at, at], { pointerType });
    const before = await count();
    await page.keyboard.press('Control+d');
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('Shift+ArrowDown');
    }
    await page.keyboard.press('Control+Shift+d');
    await page.keyboard.press('Control+Shift+d');
    await settle(page);
    assert.equal(await count(), before + 3);
    assert.equal(await steps(), done + 6);
    await shot('repeated');
    for (let i = 0; i < 6; i++) {
      await page.keyboard.press('Control+z');
    }
    await settle(page);
    assert.equal((await state(page)).digest, first.digest);

    // What is covered.
    const chosen = async () => (await outline()).rows.filter((one) => one.selected).map((one) => one.id);
    await page.keyboard.press('Escape');
    await hand.stroke([at, at], { pointerType });
    await settle(page);
    const [front] = await chosen();
    if (pointerType === 'mouse') {
      await hand.stroke([at, at], { pointerType, modifiers: 1 });
    } else {
      await command('select-below');
    }
    await settle(page);
    const [below] = await chosen();
    assert.ok(below && below !== front);
    await command('select-same-width');
    assert.equal((await chosen()).length, 2);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
