// What is held in the page: a place and a direction pinned by double taps, the length by its switch, while a level is dragged with a
// pen; two surfaces matched; a wavy ring lifted by a stroke round its picture.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, pictures, place, quiet, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const ring = (waves, depth, count) => {
  const at = (i) => {
    const a = (2 * Math.PI * i) / count;
    const r = 200 * (1 + depth * Math.sin(waves * a));
    return [500 + r * Math.cos(a), 380 + 0.7 * r * Math.sin(a)];
  };
  const text = (p) => p.map((x) => x.toFixed(2)).join(' ');
  const parts = [`M${text(at(0))}`];
  for (let i = 0; i < count; i++) {
    const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    parts.push(`C${text(b.map((x, k) => x + (c[k] - a[k]) / 6))} ${text(c.map((x, k) => x - (d[k] - b[k]) / 6))} ${text(c)}`);
  }
  return Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 800"><path d="${parts.join('')}Z" fill="none" stroke="#2d5a3a" stroke-width="2"/></svg>`);
};

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const digest = async (page) => (await state(page)).digest;

test('pins and the length are held while a level is dragged', async (t) => {
  const server = await serve({ name: 'ring.svg', bytes: ring(3, 0.08, 48) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const key = async (...names) => {
    for (const name of names) {
      await page.keyboard.press(name);
      await quiet(page); // the strip is fetched when it is first shown
    }
  };
  const double = async (at) => {
    hand.rest(1);
    await hand.stroke([at]);
    hand.rest(0.1);
    await hand.stroke([at]);
    hand.rest(1);
    await settle(page);
  };
  await key('t');
  const right = await place(page, 700, 380);
  await hand.stroke([right, right]);
  await page.waitForSelector('.levels:not([hidden])');
  await key('Shift+L', 'Enter');
  await page.evaluate(() => batten.engine.set('hold-length', 1));
  await double(await place(page, 300, 380)); // its place
  await double(right); // its place,
  await double(right); // and then its direction
  await settle(page);
  await pictures(page, 'held-pins');
  const before = await digest(page);
  const top = await place(page, 500, 240);
  await hand.stroke([top, [top[0] + 20, top[1] - 60]], { step: 2, during: () => pictures(page, 'held-drag') });
  await settle(page);
  assert.notEqual(await digest(page), before);
  assert.equal((await state(page)).check, '');
  await pictures(page, 'held-after');
  await key('Control+z');
  assert.equal(await digest(page), before);
});

test('a stroke round a wavy ring lifts it', async (t) => {
  const server = await serve({ name: 'ring.svg', bytes: ring(9, 0.08, 90) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  await page.keyboard.press('u');
  const right = await place(page, 700, 380);
  await hand.stroke([right]);
  await settle(page);
  await page.evaluate(() => batten.engine.command('view-front'));
  await settle(page);
  await pictures(page, 'held-ring');
});
