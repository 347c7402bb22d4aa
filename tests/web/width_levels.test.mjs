// The levels of the width along a stroke: the strip in the tool for widths; the sweep pulled with the pen keeps the fine detail, faders
// and eyes damp it; by keys too, no findings by axe, nothing after Escape and undo.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const LINE = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 800 400"><path d="M80 200H720" fill="none" stroke="#1d3557" stroke-width="20"/></svg>';
const STOPS = 25;
const WAVE = Array.from({ length: STOPS }, (_, i) => [i / (STOPS - 1), 1.6 + (i % 2 ? 0.35 : -0.35)]);

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const objects = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
const widths = async (page) => (await objects(page))[0].paint.widths.map(([, share]) => share);

/** The line with those stops, as a file. */
async function brush() {
  const server = await serve({ name: 'line.svg', bytes: Buffer.from(LINE) });
  const { page, context } = await open(browser, server.address);
  const file = JSON.parse(await page.evaluate(() => new TextDecoder().decode(batten.engine.save(true))));
  file.batten = 7;
  file.objects[0].paint = { ...file.objects[0].paint, widths: WAVE };
  await context.close();
  server.close();
  return Buffer.from(JSON.stringify(file));
}

for (const [locale, colorScheme, viewport] of [['en', 'light'], ['ko-KR', 'dark', { width: 390, height: 844 }]]) {
  test(`a swell under the detail, ${locale}, ${colorScheme}`, async (t) => {
    const server = await serve({ name: 'brush.batten', bytes: await brush() });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme, ...viewport && { viewport } });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `width-levels-${name}-${colorScheme}.png`) });
    const digest = async () => (await state(page)).digest;
    const first = await digest();
    const strip = page.locator('.levels');
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Shift+W');
    await strip.waitFor();
    await quiet(page);
    const rows = page.locator('.level-row');
    assert.equal(await rows.count(), 3);
    assert.equal(await strip.getAttribute('aria-label'), locale === 'en' ? 'Width profile' : '두께 프로파일');
    assert.equal(await rows.last().locator('small').textContent(), locale === 'en' ? '4 points' : '점 4개');
    assert.equal(await rows.first().locator('.level-choose').isChecked(), true);
    assert.equal(await strip.locator('.level-commands:visible, details:visible').count(), 0, 'nothing that is for curves alone');
    await shot('strip');

    // The sweep, pulled: wider all along, and as wavy.
    await rows.last().locator('.level-choose').check();
    await quiet(page);
    const stroke = [await place(page, 400, 208), await place(page, 400, 270)];
    await hand.stroke(stroke, { lift: false });
    await quiet(page);
    await page.keyboard.press('Escape');
    await quiet(page);
    assert.equal(await digest(), first, 'Escape takes it back');
    await hand.lift(stroke[1]);
    await hand.stroke(stroke);
    await quiet(page);
    await shot('swell');
    const swollen = await widths(page);
    assert.equal(swollen.length, STOPS);
    for (const i of [6, 18]) {
      assert.ok(swollen[i] - WAVE[i][1] > 0.5, `far from the pen, too: ${swollen}`);
    }
    const bends = swollen.slice(0, -2).map((share, i) => share - 2 * swollen[i + 1] + swollen[i + 2]);
    assert.ok(bends.every((bend, i) => Math.abs(bend) > 0.5 && (i === 0 || bend * bends[i - 1] < 0)), `as wavy: ${bends}`);
    assert.equal((await state(page)).check, '');

    // The detail, damped by its fader: seen while it is dragged, one step.
    const wide = await digest();
    const fader = rows.first().locator('.level-fader');
    await fader.evaluate((input) => {
      for (const value of ['0.6', '0.1']) {
        input.value = value;
        input.dispatchEvent(new Event('input'));
      }
      input.dispatchEvent(new Event('change'));
    });
    await settle(page);
    assert.equal(await rows.first().locator('.level-gain').textContent(), '0.10');
    const calm = await widths(page);
    assert.ok(calm.slice(0, -2).every((share, i) => Math.abs(share - 2 * calm[i + 1] + calm[i + 2]) < 0.3), `calm: ${calm}`);
    await shot('calm');
    await page.locator('#stage').focus();
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal(await digest(), wide);
    assert.equal(await rows.first().locator('.level-gain').textContent(), '1.00');
    await rows.first().locator('.level-mute').evaluate((eye) => eye.click());
    await quiet(page);
    assert.equal(await rows.first().locator('.level-mute').getAttribute('aria-pressed'), 'true');
    await rows.first().locator('.level-mute').evaluate((eye) => eye.click());
    await quiet(page);
    assert.equal(await digest(), wide, 'heard again, to the bit');

    // Keys: a finer level, a coarser one.
    await page.locator('#stage').focus();
    await page.keyboard.press(']');
    await quiet(page);
    assert.equal(await rows.nth(1).locator('.level-choose').isChecked(), true);
    const axe = await import('axe-core');
    await page.evaluate(axe.default.source);
    const { violations } = await page.evaluate(() => globalThis.axe.run('.levels'));
    assert.deepEqual(violations.map(({ id }) => id), []);
    await page.keyboard.press('v');
    await quiet(page);
    assert.equal(await strip.isVisible(), false);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal(await digest(), first);
    await context.close();
  });
}
