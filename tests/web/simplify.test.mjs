// Simplify: the slider beside what was simplified, with the points before and after; shown while it is dragged, one step
// when it is released; Escape gives the curves back, Enter keeps them.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open, pictures, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('curves are simplified', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  const opened = await state(page);
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  const simplify = () => page.evaluate(() => {
    batten.engine.command('curve-simplify');
    batten.wake();
  });
  const readings = () => page.evaluate(() => batten.engine.readings());
  await simplify();
  const slider = page.locator('.chips input');
  await slider.waitFor();
  await settle(page);
  const middle = await readings();
  assert.ok(middle.points[1] < middle.points[0], `${middle.points}`);
  assert.equal(await page.locator('.chips output').textContent(), `Simplified: ${middle.points.join(' \u2192 ')} points`);
  const simplified = await state(page);
  assert.notEqual(simplified.digest, opened.digest);

  // Dragged: shown only.
  const box = await slider.boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 2, y);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, y, { steps: 4 });
  await settle(page);
  assert.equal((await state(page)).digest, simplified.digest);
  const dragged = await readings();
  assert.ok(dragged.points[1] < middle.points[1], `${dragged.points}`);
  await pictures(page, 'simplify');
  await page.mouse.up();
  await settle(page);
  const few = await state(page);
  assert.notEqual(few.digest, simplified.digest);
  assert.equal(few.check, '');
  assert.ok(Math.abs((await slider.boundingBox()).x - box.x) < 8, 'the slider stays under the pointer');

  await page.keyboard.press('Home');
  await settle(page);
  assert.ok((await readings()).points[1] > middle.points[1]);
  assert.equal(await page.evaluate(() => document.activeElement.type), 'range', 'the keys go on');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest, 'Escape leaves all as it was');
  assert.equal(await page.locator('.chips').isVisible(), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'stage');

  await simplify();
  await slider.waitFor();
  await slider.focus();
  await page.keyboard.press('End');
  await settle(page);
  const kept = await state(page);
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await page.locator('.chips').isVisible(), false, 'Enter keeps them');
  assert.equal((await state(page)).digest, kept.digest);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest, 'all of it is one step');

  // C2 or G1: by a chip and by Tab.
  await simplify();
  await slider.waitFor();
  const chips = page.locator('.chips button');
  assert.deepEqual(await chips.evaluateAll((all) => all.map((chip) => chip.getAttribute('aria-pressed'))), ['true', 'false']);
  const c2 = await readings();
  await chips.nth(1).click();
  await settle(page);
  const g1 = await readings();
  assert.ok(g1.cubics[1] < c2.cubics[1], `${g1.cubics}, ${c2.cubics}`);
  assert.equal(await page.locator('.chips output').textContent(), `Simplified: ${g1.cubics.join(' \u2192 ')} cubics`);
  assert.deepEqual(await chips.evaluateAll((all) => all.map((chip) => chip.getAttribute('aria-pressed'))), ['false', 'true']);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'stage', 'the keys go on meaning the drawing');
  await pictures(page, 'simplify-g1');
  await page.keyboard.press('Tab');
  await settle(page);
  assert.deepEqual((await readings()).points, c2.points);
  await chips.nth(1).focus();
  await page.keyboard.press('Enter');
  await settle(page);
  assert.deepEqual((await readings()).cubics, g1.cubics);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-pressed')), 'true', 'the chip keeps the focus');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest);
  await context.close();
});
