// Dashes chosen while nothing is selected are those of what is drawn next; the section of styles shows them then.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, quiet, state } from './page.mjs';
import { serve } from './server.mjs';

const PAPER = '<svg xmlns="http://www.w3.org/2000/svg" width="800" height="400"/>';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('what is drawn next has the dashes chosen', async (t) => {
  const server = await serve({ name: 'paper.svg', bytes: Buffer.from(PAPER) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const first = await state(page);
  await page.click('#style .rare summary >> nth=0');
  await page.selectOption('#setting-dashes', '1');
  await page.locator('#stage').focus();
  for (const [tool, y] of [['tool-sketch', 120], ['tool-line', 260]]) {
    await page.evaluate((name) => batten.engine.command(name), tool);
    const ends = [await place(page, 100, y), await place(page, 700, y)];
    await hand.stroke([ends[0], await place(page, 300, y), await place(page, 500, y), ends[1]]);
    await quiet(page);
    await page.keyboard.press('Escape');
  }
  await quiet(page);
  const drawn = await state(page);
  assert.equal(drawn.check, '');
  assert.equal(await page.inputValue('#setting-dashes'), '1');
  const dashes = await page.evaluate(() => new TextDecoder().decode(batten.engine.save(false)).match(/stroke-dasharray[=:]"?[^";]*/g));
  assert.equal(dashes?.length, 2, String(dashes));
  await pictures(page, 'dashes');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, first.digest);
  assert.equal(await page.inputValue('#setting-dashes'), '1', 'it is the pen that is dashed');
  await context.close();
});
