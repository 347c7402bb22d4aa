// A day's work by the buttons: strokes become shapes, curves get offsets; the sheet of styles says what is mixed, takes a colour as a
// number and offers those of the drawing; the eyedropper takes a style; the history goes back to any step.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, reveal, SCREENSHOTS, state } from './page.mjs';
import { PROGRAM, serve } from './server.mjs';
import { compareStrokes, MOST } from './strokes.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400"><circle cx="180" cy="200" r="90" fill="none"
stroke="#2a6f97" stroke-width="16"/><path d="M330 300C380 80 460 80 540 260" fill="none" stroke="#e9c46a" stroke-width="24"
stroke-linecap="round"/></svg>`;

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const [locale, colorScheme, size] of [['en', 'light', undefined], ['ko-KR', 'dark', { width: 390, height: 844 }]]) {
  test(`a ring and an arch, ${locale}`, async (t) => {
    const server = await serve({ name: 'two.svg', bytes: Buffer.from(DRAWING) });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme, ...(size ? { viewport: size } : {}) });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `outlines-${name}-${locale}.png`) });
    const objects = () => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
    const command = async (name) => {
      await page.evaluate((one) => { batten.engine.command(one); batten.wake?.(); }, name);
      await page.locator('#stage').focus();
      await quiet(page);
    };
    await page.locator('#stage').focus();
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await quiet(page);
    const begun = await state(page);
    await page.waitForSelector('#actions [data-name=curve-outline]', { state: 'attached' });
    await page.evaluate(() => document.querySelector('#actions [data-name=curve-outline]').click());
    await quiet(page);
    assert.ok((await objects()).every(({ style }) => style.filled && !style.stroked), 'both are shapes');
    await page.evaluate(() => document.querySelector('#actions [data-name=curve-offset]').click());
    await quiet(page);
    await command('accept');
    assert.equal((await objects()).length, 4);
    assert.equal((await state(page)).check, '');
    await shot('offset');
    await command('history');
    await page.waitForSelector('#history:popover-open');
    assert.equal(await page.locator('#history button').count(), 3);
    await shot('history');
    await page.locator('#history button').first().click();
    await quiet(page);
    assert.equal((await state(page)).digest, begun.digest, 'as it was opened');
    await page.keyboard.press('Escape');
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+a');
    await quiet(page);
    await reveal(page, 'style');
    await page.waitForSelector('[data-mixed=stroke-colour]:not([hidden])');
    assert.equal(await page.locator('[data-mixed=stroke-join]').isHidden(), true);
    await shot('mixed');
    const field = page.locator('#style .colour input[type=text]').first();
    await field.fill('#c1121f');
    await field.press('Enter');
    await quiet(page);
    assert.ok((await objects()).every(({ style }) => /c1121f/i.test(JSON.stringify(style))), 'both have the colour');
    assert.equal(await page.locator('[data-mixed=stroke-colour]').isHidden(), true);
    await page.locator('.swatch').first().click();
    await page.keyboard.press('Escape');
    await context.close();
    assert.ok(hand);
  });
}

// All 10,000 of them: node strokes.mjs, a command of its own.
test('outlines of random strokes beside the picture that the browser makes of the strokes', async (t) => {
  const page = await browser.newPage();
  t.after(() => page.close());
  const { all, refused, share } = await compareStrokes(page, path.join(path.dirname(PROGRAM), 'tests/strokes'), 0, 60);
  assert.equal(all.length, 60);
  assert.deepEqual(refused, []);
  assert.ok(share <= MOST, `${100 * share} % of the samples differ`);
});
