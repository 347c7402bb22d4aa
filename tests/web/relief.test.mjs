// A surface with levels in the browser: the jug of docs/relief.md is opened and bent while its scales ride along, their level is
// muted and made louder, a line is redrawn at a level, detail is copied to another surface; undo leads all the way back.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, pictures, place, quiet, state, texts } from './page.mjs';
import { serve } from './server.mjs';

const bytes = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/space/relief.batten'));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const [SCALES, JUG] = [0, 1];
const relief = (page, which) => page.evaluate((index) => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects[index].relief, which);
const details = ({ levels }) => JSON.stringify(levels.map((level) => level.details));

test('scales on a jug', async (t) => {
  const server = await serve({ name: 'relief.batten', bytes });
  t.after(() => server.close());
  const { page, context, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `relief-${name}`);
  const strings = await texts(page);
  const rows = page.locator('.level-row');
  const tap = async (x, y) => {
    hand.rest(2);
    const at = await place(page, x, y);
    await hand.stroke([at, at]);
    await quiet(page);
  };
  let steps = 0;
  let last = (await state(page)).digest;
  const first = last;
  const changed = async () => { // one step more
    await quiet(page);
    const { digest, check } = await state(page);
    assert.notEqual(digest, last);
    assert.equal(check, '');
    last = digest;
    steps++;
  };

  await page.focus('#stage');
  await page.keyboard.press('t');
  await tap(480, 400);
  await page.waitForSelector('.levels:not([hidden])');
  assert.equal(await rows.count(), 2);
  assert.equal((await state(page)).digest, first);
  const plain = await relief(page, JUG);

  // The sweep is bent: it follows the pen, and the numbers of the detail stay.
  await rows.last().locator('input[type=radio]').check();
  const from = await place(page, 480, 300);
  hand.rest(2);
  await hand.stroke([from, [from[0] + 50, from[1] - 20]], { during: async () => {
    assert.notEqual((await state(page)).digest, first);
    await shot('bending');
  } });
  await changed();
  const bent = await relief(page, JUG);
  assert.equal(details(bent), details(plain));
  assert.notEqual(JSON.stringify(bent.base), JSON.stringify(plain.base));
  await shot('bent');

  // The level of the scales: louder by its fader, by one step of a key; then muted.
  const fader = page.getByRole('slider', { name: /^Strength of (Detail 1|Finest detail)$/ });
  await fader.focus();
  await fader.press('ArrowRight');
  await changed();
  assert.equal((await relief(page, JUG)).levels[0].gain, 1.01);
  await page.getByRole('button', { name: /^Hide (Detail 1|Finest detail)$/ }).click();
  await changed();
  assert.equal((await relief(page, JUG)).levels[0].muted, true);
  await shot('muted');
  await page.getByRole('button', { name: /^Hide (Detail 1|Finest detail)$/ }).click();
  await changed();

  // A line across the jug is redrawn at the base, on the base's own few knots.
  await page.focus('#stage');
  await page.keyboard.press('b');
  const line = (dx) => Promise.all(Array.from({ length: 31 }, (_, i) => place(page, 430 + 4 * i, 440 + dx * Math.sin((Math.PI * i) / 30) ** 2)));
  hand.rest(2);
  await hand.stroke(await line(0));
  await quiet(page);
  assert.equal((await state(page)).digest, last);
  await shot('line');
  hand.rest(2);
  await hand.stroke(await line(-25), { during: () => shot('line-drawing') });
  await changed();
  const redrawn = await relief(page, JUG);
  assert.equal(details(redrawn), details(bent));
  assert.deepEqual(redrawn.base.knots, bent.base.knots);
  assert.notEqual(JSON.stringify(redrawn.base.points), JSON.stringify(bent.base.points));
  await shot('line-redrawn');

  // The jug's detail goes to the square.
  const square = await relief(page, SCALES);
  await page.keyboard.press('t');
  await tap(480, 400);
  await page.click('.levels summary');
  await page.getByRole('button', { name: strings['command.levels-copy'], exact: true }).click();
  await quiet(page);
  await tap(100, 130);
  await changed();
  assert.notEqual(details(await relief(page, SCALES)), details(square));
  await shot('copied');

  await page.focus('#stage');
  for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+Alt+ArrowUp');
  await quiet(page);
  await shot('tilted');
  for (let i = 0; i < steps; i++) await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, first);
  await context.close();
});
