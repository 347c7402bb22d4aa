// A heavy picture that moves has fewer pixels, not fewer frames; at rest it has all of them.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { Pace } from '../../web/stage/pace.js';
import { launch, open, quiet, SCREENSHOTS, until } from './page.mjs';
import { serve } from './server.mjs';

/** Frames so far apart, and what is due at rest. @param {number[]} gaps */
function moved(gaps, waited = 0) {
  const due = [], after = [];
  let rested = 0;
  const pace = new Pace(() => { rested += 1; }, (work, delay) => { due.push(work); after.push(delay); });
  let now = 1000;
  const shares = gaps.map((gap) => {
    pace.moved(now += gap, waited);
    return pace.share;
  });
  return { shares, after, rest: () => { due.at(-1)?.(); return { rested, share: pace.share }; } };
}

test('quick frames keep every pixel', () => {
  const { shares, rest } = moved(Array(30).fill(16));
  assert.ok(shares.every((share) => share === 1));
  assert.equal(rest().rested, 0, 'nothing is to be painted again');
});

test('slow frames lose pixels, down to a least share, and get them back at rest', () => {
  const { shares, rest } = moved(Array(12).fill(60));
  assert.equal(shares[1], 1, 'one slow frame is none');
  assert.ok(shares[2] < 1);
  shares.slice(1).forEach((share, i) => assert.ok(share <= shares[i]));
  assert.equal(shares.at(-1), 0.35);
  assert.deepEqual(rest(), { rested: 1, share: 1 });
});

test('steps with pauses between them are no movement, nor is one frame that took long', () => {
  assert.ok(moved([400, 500, 900, 400]).shares.every((share) => share === 1));
  assert.ok(moved([16, 60, 16, 60, 16]).shares.every((share) => share === 1));
});

test('frames that take longer than a pause lose pixels, too, and are not at rest before the next', () => {
  const { shares, after } = moved(Array(12).fill(900), 700);
  assert.ok(shares[2] < 1);
  assert.equal(shares.at(-1), 0.35);
  assert.ok(after.slice(-9).every((delay) => delay > 900), `${after}`);
  assert.equal(moved(Array(5).fill(60)).after.at(-1), 150);
});

test('in the page: coarse while it turns, sharp when it has come to rest', async (t) => {
  const bytes = fs.readFileSync(new URL('../../examples/space/turned.batten', import.meta.url));
  const browser = await launch();
  const server = await serve({ name: 'turned.batten', bytes });
  t.after(async () => {
    await browser.close();
    server.close();
  });
  const { page } = await open(browser, server.address, { viewport: { width: 800, height: 600 } });
  await page.keyboard.press('Shift+5');
  await until(page, () => glance().tilt > 0);
  await quiet(page);
  const sides = () => page.evaluate(() => ['space', 'still'].map((id) => document.getElementById(id).width));
  const [whole, still] = await sides();
  assert.equal(whole, still);
  await page.evaluate(() => {
    const { pace } = batten.loop.space;
    globalThis.rest = () => {};
    pace.later = (work) => { globalThis.rest = work; }; // as long as it lasts on a slow machine
    pace.share = 0.5;
  });
  await page.keyboard.press('Shift+Alt+ArrowLeft');
  await quiet(page);
  const [coarse] = await sides();
  assert.ok(Math.abs(coarse - whole / 2) <= 1, `${coarse} of ${whole}`);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'pace-coarse.png') });
  await page.evaluate(() => globalThis.rest());
  await quiet(page);
  assert.deepEqual(await sides(), [whole, still]);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'pace-sharp.png') });
});
