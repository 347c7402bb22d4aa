// label: all (three openings of a drawing)
// A drawing of another program in the page: edited and saved it stays light, opened again it is what it was bit for bit, and
// what another program changes then is read while the rest stays.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, state } from './page.mjs';
import { serve } from './server.mjs';

const WAVES = Array.from({ length: 30 }, (_, i) =>
  `<path id="w${i}" fill="none" stroke="#24${i % 10}" stroke-width="2" d="M20 ${10 + 9 * i}c60 -8 120 8 180 0s120 8 180 0"/>`);
const FILE = `<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">\n${WAVES.join('\n')}\n</svg>\n`;

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const digest = async (page) => (await state(page)).digest;

test('saved, opened again, and changed by another program', async (t) => {
  const server = await serve({ name: 'waves.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await Promise.all(bezier([22, 60], [120, 90], [260, 20], [378, 70]).map(([x, y]) => place(page, x, y))));
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  const text = server.bytes.toString(), before = await digest(page);
  assert.match(text, /<batten:document xmlns:batten="urn:batten:1" drawing="[0-9a-f]{16}"/);
  assert.ok(text.length < FILE.length + 3000, `${text.length - FILE.length} bytes more`);
  await context.close();

  const second = await open(browser, server.address);
  assert.equal(await digest(second.page), before, 'it is what it was');
  await second.context.close();

  const other = await serve({ name: 'waves.svg', bytes: Buffer.from(text.replaceAll('stroke-width="2"', 'stroke-width="3"')) });
  t.after(() => other.close());
  const third = await open(browser, other.address);
  assert.notEqual(await digest(third.page), before);
  for (let saves = 1; saves < 3; saves++) { // what it was before the other program's change is lost once
    await third.hand.stroke(await Promise.all(bezier([22, 160], [120, 190], [260, 120], [378, 170 + saves]).map(([x, y]) => place(third.page, x, y))));
    await third.page.keyboard.press('Control+S');
    if (saves === 1) {
      await third.page.click('#lossy button[value=lose]');
    }
    await third.page.waitForFunction(() => document.getElementById('unsaved').hidden);
    assert.equal(other.saves, saves);
  }
  await third.context.close();
});
