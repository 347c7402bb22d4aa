// label: smoke. Levels in the page: an outline with many points decomposed with a live choice, its sweep dragged with a pen while the
// scales follow, faders, mute and solo, a level redrawn by a stroke, detail copied to another curve, frames shown as
// axes; by keys too; no findings by axe; screenshots in light and dark.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { hintFor, inThemes, launch, open, pictures, place, quiet, settle, state, texts } from './page.mjs';
import { serve } from './server.mjs';

/** A leaf of 72 cubics with scales along its rim, and a plain arch below it. */
function outline() {
  const at = (i) => {
    const a = (2 * Math.PI * i) / 72;
    const r = 1 + (i % 2 ? 0.07 : -0.02);
    return [500 + 330 * r * Math.cos(a), 260 + 170 * r * Math.sin(a) * (1 - 0.3 * Math.cos(a))];
  };
  const text = (p) => p.map((x) => x.toFixed(2)).join(' ');
  const parts = [`M${text(at(0))}`];
  for (let i = 0; i < 72; i++) {
    const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    parts.push(`C${text(b.map((x, k) => x + (c[k] - a[k]) / 6))} ${text(c.map((x, k) => x - (d[k] - b[k]) / 6))} ${text(c)}`);
  }
  return Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 700">
<path d="${parts.join('')}Z" fill="#cfe3d0" stroke="#2d5a3a" stroke-width="2"/>
<path d="M150 640C350 520 650 520 850 640" fill="none" stroke="#8a4b2a" stroke-width="3"/></svg>`);
}

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'leaf.svg', bytes: outline() });
});
after(async () => {
  await browser.close();
  server.close();
});

const objects = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);
const digest = async (page) => (await state(page)).digest;
const rows = (page) => page.locator('.level-row');

test('an outline in levels, with a pen', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  const strings = await texts(page);
  const shot = (name) => pictures(page, `levels-${name}`);
  const key = async (...names) => {
    for (const name of names) {
      await page.keyboard.press(name);
    }
    await settle(page);
  };
  const first = await digest(page);
  assert.equal(await page.locator('.levels').count(), 0);

  await key('t');
  assert.equal((await state(page)).hint, hintFor(strings['hint.levels'], 'mouse'));
  const rim = await place(page, 500, 90);
  await hand.stroke([rim, rim]);
  await page.waitForSelector('.levels:not([hidden])');
  assert.ok(['/levels.js', '/levels.css'].every((name) => asked.some((path) => path.endsWith(name))));
  assert.equal(await rows(page).count(), 0);

  // Decomposing: previewed with live numbers; Esc and Enter.
  await key('Shift+L');
  assert.equal((await state(page)).hint, strings['hint.apart']);
  const suggested = await rows(page).count();
  assert.ok(suggested >= 3);
  await page.locator('#strip-apart-levels').locator('xpath=../preceding-sibling::button').click();
  await settle(page);
  assert.equal(await rows(page).count(), suggested - 1);
  await page.locator('#strip-apart-points').fill('9');
  await page.locator('#strip-apart-points').press('Enter');
  await settle(page);
  assert.match(await rows(page).last().textContent(), /Base.*9 points/);
  await shot('apart');
  assert.equal(await digest(page), first);
  await key('Escape');
  assert.equal(await rows(page).count(), 0);
  await page.getByRole('button', { name: strings['command.take-apart'], exact: true }).last().click();
  await settle(page);
  await page.locator('#strip-apart-levels').fill('3');
  await page.locator('#strip-apart-levels').press('Enter');
  await page.locator('#strip-apart-points').fill('9');
  await page.locator('#strip-apart-points').press('Enter');
  await page.locator('#stage').focus();
  await key('Enter');
  assert.equal(await rows(page).count(), 4);
  const [leaf] = await objects(page);
  assert.equal(leaf.kind, 'shape');
  const apart = await digest(page);

  // Each row shows its line, within its box: a shape for the sweep, waves of their own for the details.
  const lines = () => page.$$eval('.level-picture path', (paths) => paths.map((one) => {
    const { x, y, width, height } = one.getBBox();
    return { d: one.getAttribute('d'), height, within: x >= 0 && y >= 0 && x + width <= 32 && y + height <= 20 };
  }));
  const apartLines = await lines();
  assert.equal(new Set(apartLines.map(({ d }) => d)).size, 4);
  assert.ok(apartLines.every(({ height, within }) => within && height > 4));

  // Dragging the sweep: the point under the pen follows, the scales move along, one step.
  const grip = await place(page, 505, 87);
  await hand.stroke([grip, [grip[0] + 30, grip[1] - 50]], {
    step: 2,
    during: async () => {
      await shot('sweep');
      assert.notEqual(await digest(page), apart);
    },
  });
  const details = (object) => JSON.stringify(object.curves[0].levels.map((level) => level.details));
  const swept = (await objects(page))[0];
  assert.equal(details(swept), details(leaf));
  assert.notEqual(JSON.stringify(swept.curves[0].base), JSON.stringify(leaf.curves[0].base));
  await key('Control+z');
  assert.equal(await digest(page), apart);
  await key('Control+Shift+z');

  // A fader: by keys, then by the pointer, with a preview and one step.
  const fader = page.getByRole('slider', { name: 'Strength of Finest detail' });
  await fader.focus();
  await fader.press('ArrowRight');
  await settle(page);
  assert.equal((await objects(page))[0].curves[0].levels[2].gain, 1.01);
  const louder = await lines();
  assert.ok(louder[0].height >= apartLines[0].height); // to a tenth of a unit
  assert.equal(louder[1].d, apartLines[1].d);
  await key('Control+z');
  const before = await digest(page);
  const box = await fader.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.75, box.y + box.height / 2, { steps: 6 });
  await page.mouse.move(box.x + box.width - 1, box.y + box.height / 2, { steps: 6 });
  await settle(page);
  await shot('fader');
  await page.mouse.up();
  await settle(page);
  assert.ok((await objects(page))[0].curves[0].levels[2].gain > 1.9);
  await page.locator('#stage').focus();
  await key('Control+z');
  assert.equal(await digest(page), before);

  // Mute and solo.
  await page.getByRole('button', { name: 'Hide Detail 2' }).click();
  await settle(page);
  assert.equal((await objects(page))[0].curves[0].levels[1].muted, true);
  await page.getByRole('button', { name: 'Hide Detail 2' }).click();
  await page.getByRole('button', { name: 'Show only up to Base' }).click();
  await settle(page);
  assert.equal((await objects(page))[0].curves[0].levels.filter((level) => level.muted).length, 3);
  await shot('solo');
  await page.getByRole('button', { name: 'Show only up to Base' }).click();
  await settle(page);
  assert.equal((await objects(page))[0].curves[0].levels.filter((level) => level.muted).length, 0);

  // Levels by keys; all of them shown, with their frames.
  await page.locator('#stage').focus();
  await key(']');
  assert.ok(await page.getByRole('radio', { name: /^Detail 1/ }).isChecked());
  await key('[');
  await page.click('.levels summary');
  await page.locator('#strip-show-levels').check();
  await page.locator('#strip-show-frames').check();
  await settle(page);
  await shot('frames-rmf');
  await page.locator('#strip-frame-rule').selectOption({ label: 'Frenet' });
  await settle(page);
  assert.equal((await objects(page))[0].curves[0].frame, 'frenet');
  await shot('frames-frenet');
  await page.locator('#strip-frame-rule').selectOption({ label: 'Rotation-minimising' });
  await page.locator('#strip-show-frames').uncheck();
  await page.locator('#stage').focus();

  // The sweep reapartLines by a stroke over the leaf's lower rim; the strip stays visible.
  await key('n');
  const [near, ...over] = await Promise.all([[500, 426.6], [540, 445], [600, 450], [660, 420], [720, 380]].map(
    ([x, y]) => place(page, x, y)));
  await hand.hover(near);
  assert.equal((await state(page)).hint, strings['hint.level-sketch']);
  const drawn = details((await objects(page))[0]);
  await hand.stroke([near, ...over], { during: () => shot('sketch') });
  const redrawn = (await objects(page))[0];
  assert.equal(redrawn.kind, 'shape');
  assert.equal(details(redrawn), drawn);
  await shot('sketched');
  await page.locator('.levels').waitFor();
  const [chips, strip] = await Promise.all(['.chips', '.levels'].map((box) => page.locator(box).boundingBox()));
  assert.ok(chips.x + chips.width <= strip.x || chips.y + chips.height <= strip.y, 'what else the stroke could mean is not over the strip');
  await key('Control+z', 't');

  // Detail copied to the arch.
  await page.getByRole('button', { name: strings['command.levels-copy'], exact: true }).last().click();
  await quiet(page); // the strip above the drawing changes its height
  assert.equal((await state(page)).hint, hintFor(strings['hint.copy-to']));
  const arch = await place(page, 500, 550);
  await hand.stroke([arch, arch]);
  const copied = (await objects(page))[1];
  assert.equal(copied.kind, 'shape');
  assert.equal(copied.curves[0].levels.length, 3);
  await shot('copied');

  const axe = await import('axe-core');
  await page.evaluate(axe.default.source);
  await inThemes(page, async () => {
    const found = await page.evaluate(() => globalThis.axe.run());
    assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes[0].html}`), []);
  });
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('on a phone the strip is one row, and the drawing ends above it', async () => {
  const { page, context } = await open(browser, server.address, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const command = (...names) => page.evaluate((all) => {
    all.forEach((name) => batten.engine.command(name));
    batten.wake();
  }, names);
  const box = (one) => page.evaluate((selector) => document.querySelector(selector).getBoundingClientRect().toJSON(), one);
  const shot = (name) => pictures(page, `levels-phone${name}`);
  await page.evaluate(() => batten.engine.act('editor_select', JSON.parse(batten.engine.ask('editor_outline', 0, 9)).rows[0].id, 0));
  await command('tool-levels', 'take-apart');
  await page.waitForSelector('.levels:not([hidden])');
  await quiet(page);
  assert.ok(await page.isVisible('#strip-apart-levels'));
  await shot('-apart');
  await command('accept');
  await quiet(page);
  const [strip, stage] = [await box('.levels'), await box('#stage')];
  assert.ok(strip.height <= 44 + 9 && strip.right <= 390 && strip.left >= stage.left, JSON.stringify(strip));
  assert.ok(stage.bottom <= strip.top + 0.5, `${stage.bottom} ${strip.top}`);
  assert.ok(await rows(page).count() >= 3);
  // The level in force is there at once, whichever it is, and so is More.
  const chosen = page.locator('.level-row:has(:checked)');
  for (const level of [0, 1]) {
    await page.evaluate((at) => {
      batten.engine.level(0, at, 0, true);
      batten.wake();
    }, level);
    await quiet(page);
    const { x, width } = await chosen.boundingBox();
    assert.ok(x >= strip.left && x + width <= 390, `level ${level} at ${x}`);
  }
  assert.equal(await chosen.locator('.level-mute .icon').count(), 1, 'eyes are there although the inspector is shut');
  await shot('');
  await page.click('.levels summary');
  await quiet(page);
  assert.ok(await page.isVisible('.levels [data-text="command.take-apart"]'));
  assert.ok((await box('.levels')).height <= 0.5 * (844 - 96));
  await shot('-more');
  await context.close();
});
