// Saved views and planes in the layers sheet: each has a field for its name and an eye; the name is in the drawing, and undone.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, quiet, ready, reveal, SCREENSHOTS, state, until } from './page.mjs';
import { serve } from './server.mjs';

const JUG = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/jug.batten'));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const objects = (page, kind) => page.evaluate((name) =>
  JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.filter((object) => object.kind === name), kind);

for (const [locale, colorScheme, words] of [['en', 'light', /^Name \(/], ['ko-KR', 'dark', /^이름 \(/]]) {
  test(`a view and a plane are named, ${locale}`, async (t) => {
    const server = await serve({ name: 'jug.batten', bytes: JUG });
    t.after(() => server.close());
    const { page } = await open(browser, server.address, { locale, colorScheme });
    await page.locator('#stage').focus();
    await reveal(page, 'layers');
    await page.waitForSelector('.layer-list li');
    assert.equal(await page.locator('#aids').isVisible(), false, 'nothing to name');
    await reveal(page, 'layers');
    await page.locator('#stage').focus();
    for (const key of ['Shift+Alt+ArrowUp', 'Shift+Alt+ArrowUp', 'Shift+Q', 'Shift+J']) {
      await page.keyboard.press(key);
    }
    await quiet(page);
    await reveal(page, 'layers');
    const fields = page.locator('#aids input');
    await fields.first().waitFor();
    assert.equal(await fields.count(), 2);
    assert.match(await fields.first().getAttribute('aria-label'), words);
    const begun = await state(page);
    await fields.first().fill('from the left');
    await fields.first().press('Enter');
    await fields.nth(1).fill('facing');
    await fields.nth(1).press('Enter');
    await quiet(page);
    const names = async () => [...await objects(page, 'view'), ...await objects(page, 'plane')].map(({ name }) => name ?? '');
    assert.deepEqual(await names(), ['from the left', 'facing']);
    await page.locator('#aids button').first().click();
    await quiet(page);
    assert.equal((await objects(page, 'view'))[0].hidden, true);
    await page.screenshot({ path: path.join(SCREENSHOTS, `named-${locale}.png`) });
    await reveal(page, 'layers');
    await page.locator('#stage').focus();
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press('Control+z');
    }
    await quiet(page);
    const now = await state(page);
    assert.equal(now.digest, begun.digest);
    assert.equal(now.check, '');
  });
}

test('a drawing with a saved view opens in it, and offers it when one has turned away; taken, the offer goes', async (t) => {
  const keeping = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => keeping.close());
  const first = await open(browser, keeping.address);
  await first.page.locator('#stage').focus();
  for (const key of ['Shift+Alt+ArrowUp', 'Shift+Alt+ArrowUp', 'Shift+Q']) await first.page.keyboard.press(key);
  await quiet(first.page);
  const bytes = Buffer.from(await first.page.evaluate(() => Array.from(batten.engine.save(true))));
  const server = await serve({ name: 'seen.batten', bytes });
  t.after(() => server.close());
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.address);
  await ready(page);
  await until(page, () => batten.loop.space?.counts.painted > 0);
  await quiet(page);
  const tilt = () => page.evaluate(() => glance().tilt);
  const offer = page.locator('#notice button');
  assert.equal(await tilt(), 30, 'it opens in it');
  assert.equal(await offer.isVisible(), false);
  await page.keyboard.press('5');
  await offer.waitFor();
  assert.equal(await offer.textContent(), 'Saved view');
  const before = await state(page);
  await offer.click();
  await quiet(page);
  assert.equal(await offer.isVisible(), false);
  assert.equal(await tilt(), 30, 'the view is tilted');
  const now = await state(page);
  assert.equal(now.digest, before.digest, 'seeing is not editing');
  assert.equal(now.check, '');
});
