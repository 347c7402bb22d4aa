// Two shapes that overlap are united, subtracted, intersected and excluded by the buttons of the row; undo gives both back.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, quiet, SCREENSHOTS, state } from './page.mjs';
import { serve } from './server.mjs';

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400"><circle cx="240" cy="200" r="110" fill="#2a6f97"/>
<rect x="260" y="120" width="200" height="160" rx="20" fill="#e9c46a"/></svg>`;

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const [locale, colorScheme] of [['en', 'light'], ['ko-KR', 'dark']]) {
  test(`a disc and a plate, ${locale}`, async (t) => {
    const server = await serve({ name: 'two.svg', bytes: Buffer.from(DRAWING) });
    t.after(() => server.close());
    const { page, context } = await open(browser, server.address, { locale, colorScheme });
    await page.locator('#stage').focus();
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await quiet(page);
    await page.waitForSelector('#actions [data-name=region-unite]');
    await page.screenshot({ path: path.join(SCREENSHOTS, `regions-${locale}.png`) });
    const begun = await state(page);
    const count = () => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects.length);
    assert.equal(await count(), 2);
    for (const name of ['unite', 'subtract', 'intersect', 'exclude']) {
      await page.click(`#actions [data-name=region-${name}]`);
      await quiet(page);
      assert.equal(await count(), 1, name);
      assert.equal((await state(page)).check, '');
      await page.keyboard.press('Escape');
      await quiet(page);
      await page.screenshot({ path: path.join(SCREENSHOTS, `regions-${name}-${locale}.png`) });
      await page.keyboard.press('Control+z');
      await quiet(page);
      assert.equal((await state(page)).digest, begun.digest);
      await page.keyboard.press('Control+a');
      await page.waitForSelector('#actions [data-name=region-unite]');
    }
    await context.close();
  });
}
