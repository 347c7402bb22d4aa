// Offset: its distance is dragged or typed and its side chosen, over the drawing, which stays as it is until one is kept by one step.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="500" fill="none" stroke="#22262b" stroke-width="4">
<path d="M250 120C330 80 450 90 480 170C510 250 430 300 330 290C220 280 180 160 250 120Z"/>
<path stroke="#c33" d="M80 440C300 380 500 480 740 420"/></svg>`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

for (const [locale, colorScheme, viewport] of [['en', 'light'], ['ko-KR', 'dark', { width: 390, height: 844 }]]) {
  test(`an offset is seen before it is made, ${locale}, ${colorScheme}`, async (t) => {
    const server = await serve({ name: 'bean.svg', bytes: Buffer.from(DRAWING) });
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { locale, colorScheme, ...viewport && { viewport } });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `offset-${name}-${colorScheme}.png`) });
    await page.keyboard.press('v');
    const at = await place(page, 330, 290);
    await hand.stroke([at, at], { pointerType: 'mouse' });
    await settle(page);
    const before = await state(page);
    const steps = () => page.evaluate(() => JSON.parse(batten.engine.ask('editor_history')));
    const { done } = await steps();
    const distance = () => page.evaluate(() => batten.engine.get('offset-distance'));
    const command = async (name) => {
      await page.evaluate((one) => { batten.engine.command(one); batten.wake(); }, name);
      await settle(page);
    };
    await page.locator('#actions [data-name=curve-offset]').click();
    const slider = page.locator('.chips input[type=range]');
    const field = page.locator('#refit-typed');
    await slider.waitFor();
    await settle(page);
    assert.equal(await slider.getAttribute('aria-label'), locale === 'en' ? 'Offset' : '간격 띄우기');
    assert.equal(await field.getAttribute('aria-label'), locale === 'en' ? 'Offset distance' : '띄울 간격');
    assert.equal(await field.inputValue(), '10');
    assert.deepEqual(await page.locator('.chips button').evaluateAll((chips) => chips.map((chip) => chip.getAttribute('aria-pressed'))),
      ['true', 'false', 'false', null]);

    const box = await slider.boundingBox();
    await page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.6, box.y + box.height / 2, { steps: 4 });
    await settle(page);
    const dragged = await distance();
    assert.ok(dragged > 30 && dragged < 90, `${dragged}`);
    assert.equal(Number(await field.inputValue()), dragged, 'seen while it is dragged');
    await page.mouse.up();
    await settle(page);
    assert.equal((await state(page)).digest, before.digest, 'only shown');
    await shot('dragged');

    // Typed: seen with each key; what is no distance is said to be none, and Enter does not take it.
    await field.fill('22');
    await settle(page);
    assert.equal(await distance(), 22);
    await field.fill('0');
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
    assert.equal(await distance(), 22);
    await field.press('Enter');
    await settle(page);
    assert.equal(await page.locator('.chips').isVisible(), true);
    await field.press('Escape');
    await settle(page);
    assert.equal(await page.locator('.chips').isVisible(), false);
    assert.equal((await state(page)).digest, before.digest, 'Escape leaves nothing');
    assert.equal((await steps()).done, done);

    // Too far inside: said, and not kept.
    await command('curve-offset');
    await page.locator('.chips button').nth(1).click();
    await settle(page);
    await field.fill('140');
    await settle(page);
    assert.match(await page.locator('.chips output').textContent(), locale === 'en' ? /^Nothing is left/ : /남는 것이 없습니다/);
    await new Promise((resolve) => { setTimeout(resolve, 700); }); // the slider comes a moment later
    await shot('nothing');
    await page.locator('.chips button').nth(3).click();
    await settle(page);
    assert.equal((await state(page)).digest, before.digest);

    // By keys alone: both sides, typed, kept.
    await page.locator('#stage').focus();
    await page.keyboard.press('Tab');
    await settle(page);
    assert.equal(await page.locator('.chips [aria-pressed=true]').textContent(), locale === 'en' ? 'Both' : '양쪽');
    await field.fill('22.5');
    await settle(page);
    await shot('both');
    await field.press('Enter');
    await settle(page);
    const kept = await state(page);
    assert.equal(kept.check, '');
    assert.notEqual(kept.digest, before.digest);
    assert.equal(await page.locator('.chips').isVisible(), false);
    assert.equal((await steps()).done, done + 1);
    await shot('kept');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, before.digest);

    // Another tool leaves nothing.
    await page.keyboard.press('v');
    await hand.stroke([at, at], { pointerType: 'mouse' });
    await command('curve-offset');
    await command('tool-sketch');
    assert.equal(await page.locator('.chips').isVisible(), false);
    assert.equal((await state(page)).digest, before.digest);
    await context.close();
  });
}

const BENDS = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="500" fill="none" stroke="#22262b" stroke-width="4">
<path d="M80 120C130 240 230 270 320 220"/><path d="M740 420C660 300 600 290 520 360"/></svg>`;

test('a blend is seen with its comb, and a slider for each end, before it is made', async (t) => {
  const server = await serve({ name: 'bends.svg', bytes: Buffer.from(BENDS) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await settle(page);
  const before = await state(page);
  await page.evaluate(() => { batten.engine.command('curve-blend'); batten.wake(); });
  const sliders = page.locator('.chips input[type=range]');
  await sliders.nth(1).waitFor();
  await settle(page);
  assert.deepEqual(await sliders.evaluateAll((all) => all.map((one) => one.getAttribute('aria-label'))), ['At end 1', 'At end 2']);
  assert.deepEqual(await page.locator('.chips button').allTextContents(), [1, 2].flatMap((end) => ['G0', 'G1', 'G2', 'G3'].map((way) => `${end}: ${way}`)).concat('Keep this'));
  await page.locator('.chips button', { hasText: '1: G3' }).click();
  await page.locator('.chips button', { hasText: '2: G1' }).click();
  await settle(page);
  assert.deepEqual(await page.locator('.chips [aria-pressed=true]').allTextContents(), ['1: G3', '2: G1'], 'each end its own');
  const far = () => page.evaluate(() => batten.engine.readings());
  await sliders.nth(1).focus();
  for (let i = 0; i < 12; i++) {
    await page.keyboard.press('ArrowRight');
  }
  await settle(page);
  const { amount, other } = await far();
  assert.ok(amount === 0.5 && Math.abs(other - 0.62) < 1e-9, `${amount} ${other}`);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'blend.png') });
  assert.equal((await state(page)).digest, before.digest, 'only shown');
  await page.locator('.chips button').last().click();
  await settle(page);
  assert.notEqual((await state(page)).digest, before.digest);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, before.digest, 'one step');
});
