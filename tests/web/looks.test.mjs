// The tilted view with a depth: every look, light and dark; lines lie where the still canvas has them; a drag sends only what
// moves; a lost context comes back; without WebGL 2 there are lines, and a word about it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const EXAMPLES = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples');
const SHEET = Buffer.from(JSON.stringify(
  JSON.parse(fs.readFileSync(path.join(EXAMPLES, 'space/sheet.journal'), 'utf8').split('\n')[0]).document));
const JUG = fs.readFileSync(path.join(EXAMPLES, 'jug.batten'));
const RINGS = Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><g fill="none" stroke="black" stroke-width="2">
  <circle cx="200" cy="150" r="120"/><path d="M20 280C120 20 260 300 380 30"/></g></svg>`);
const SMALL = { viewport: { width: 640, height: 480 } }; // painted in software here

let browser;
before(async () => {
  browser = await launch({ smooth: true });
});
after(() => browser.close());

/** Tilts the view and waits until it is painted with a depth. */
async function tilted(page, steps = 3) {
  for (let i = 0; i < steps; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
  }
  await page.keyboard.press('Shift+Alt+ArrowLeft');
  await page.keyboard.press('f');
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  await quiet(page);
}

/** The strokes that each column of a picture crosses: how dark they are, and at which height, in device pixels. */
const columns = (page, flat) => page.evaluate((onStill) => {
  const { painter, loop } = batten;
  const { width, height } = painter.still;
  let data;
  if (onStill) {
    painter.flat = false;
    const frame = glance();
    painter.paint(frame); // takes the items, of which only the curves are left below
    const paged = painter.list;
    painter.list = paged.filter(({ item }) => item.role === 0);
    painter.retheme();
    painter.paint({ ...frame, stillChanged: false });
    painter.list = paged;
    painter.retheme();
    data = painter.still.getContext('2d').getImageData(0, 0, width, height).data;
  } else {
    const { gl } = loop.space;
    loop.space.shown = '';
    loop.space.show(glance());
    const flipped = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, flipped);
    data = new Uint8Array(flipped.length);
    for (let y = 0; y < height; y++) {
      data.set(flipped.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
    }
  }
  return Array.from({ length: width }, (_, x) => {
    const strokes = [];
    let last = -2;
    for (let y = 0; y < height; y++) {
      const at = 4 * (y * width + x);
      const dark = (data[at + 3] / 255) * (1 - data[at] / (onStill ? 255 : Math.max(data[at + 3], 1)));
      if (dark > 0.02) {
        if (last < y - 1) {
          strokes.push([0, 0]);
        }
        last = y;
        strokes.at(-1)[0] += dark;
        strokes.at(-1)[1] += dark * y;
      }
    }
    return strokes.map(([sum, moment]) => [sum, moment / sum]);
  });
}, flat);

/** The same strokes in each column, within half a pixel across the stroke; where a column only is near where one begins or
 * ends, it grazes its side, and there is no place to compare. @param {number} wide of a stroke, device pixels */
function agree(one, other, wide) {
  let [compared, alike] = [0, 0];
  one.forEach((strokes, x) => {
    if (strokes.length !== other[x].length) {
      return;
    }
    alike++;
    if ([x - 4, x + 4].some((k) => one[k]?.length !== strokes.length || other[k]?.length !== strokes.length)) {
      return;
    }
    strokes.forEach(([dark, height], i) => {
      const [same, there] = other[x][i];
      if (dark < 9 && same < 9) {
        compared++;
        assert.ok(Math.abs(height - there) * Math.min(1, wide / dark) < 0.5, `column ${x}: ${height} and ${there}`);
        assert.ok(Math.abs(same - dark) < 0.15 * dark + 0.3, `column ${x} at ${height} has ${dark} and ${same}`);
      }
    });
  });
  assert.ok(alike > 0.97 * one.length && compared > 300, `${alike} columns, ${compared} strokes`);
}

for (const [name, bytes] of [['jug', JUG], ['sheet', SHEET]]) {
  for (const colorScheme of ['light', 'dark']) {
    test(`X steps through the looks, ${name}, ${colorScheme}`, async (t) => {
      const server = await serve({ name: `${name}.batten`, bytes });
      t.after(() => server.close());
      const fetched = [];
      const context = await browser.newContext({ ...SMALL, colorScheme });
      context.on('request', (request) => fetched.push(request.url()));
      const { page } = await open(context, server.address);
      const first = await state(page);
      await page.locator('#first button').click();
      await tilted(page);
      assert.ok(fetched.some((url) => url.endsWith('/styles/space.css')), 'the rest at the first tilt');
      const seen = new Set();
      for (const look of ['matte', 'zebra', 'gauss', 'mean', 'lines']) {
        const now = await page.evaluate(() => {
          const picture = batten.loop.space.read();
          return { look: picture.look, error: batten.loop.space.gl.getError(), said: document.querySelector('.looks button').textContent,
            legend: !document.querySelector('.looks .scale').hidden };
        });
        assert.equal(now.error, 0);
        assert.equal(now.legend, look === 'gauss' || look === 'mean');
        if (now.legend) {
          const [low, high] = await page.locator('.looks .scale span').evaluateAll((all) => [0, 2].map((i) => all[i].textContent));
          assert.equal(low.slice(1), high.slice(1), 'a symmetric range');
          assert.match(high, /^\+\d(\.\d)?( · 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?$|^\+0\.0{0,2}\d{1,2}$|^\+\d{2,4}$/);
        }
        seen.add(now.said);
        await page.screenshot({ path: path.join(SCREENSHOTS, `look-${name}-${look}-${colorScheme}.png`) });
        await (look === 'zebra' ? page.locator('.looks button').click() : page.keyboard.press('x'));
        await quiet(page);
      }
      assert.equal(seen.size, 5);
      const now = await state(page);
      assert.equal(now.digest, first.digest);
      assert.equal(now.unsaved, false);
      assert.match(now.notice, /Matte/);
      await page.keyboard.press('5');
      await quiet(page);
      assert.equal(await page.locator('#space').isVisible(), false);
    });
  }
}

for (const deviceScaleFactor of [1, 1.5]) {
  test(`lines lie where the still canvas has them, face-on and tilted, at ${deviceScaleFactor} pixels`, async (t) => {
    const server = await serve({ name: 'rings.svg', bytes: RINGS });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { viewport: { width: 561, height: 421 }, deviceScaleFactor });
    await quiet(page);
    await hand.stroke([[300, 250], [300, 246]], { pointerType: 'mouse', button: 'right', step: 1 });
    await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
    await quiet(page);
    const tilt = await page.evaluate(() => glance().tilt);
    assert.ok(tilt > 0 && tilt <= 1, `${tilt} degrees`);
    const wide = 2 * deviceScaleFactor * (await state(page)).zoom;
    const slanted = await columns(page, false);
    agree(await columns(page, true), slanted, wide);
    await page.keyboard.press('5');
    await page.waitForFunction(() => glance().tilt === 0);
    await quiet(page);
    agree(await columns(page, true), slanted, wide);
    await tilted(page);
    agree(await columns(page, true), await columns(page, false), 2 * deviceScaleFactor * (await state(page)).zoom);
  });
}

test('a drag of a line sends only the rows that move', async (t) => {
  const server = await serve({ name: 'sheet.batten', bytes: SHEET });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, SMALL);
  await page.locator('#first button').click();
  await page.locator('#stage').focus();
  await tilted(page, 1);
  await page.keyboard.press('b');
  await page.keyboard.press('Tab');
  await quiet(page);
  const line = await page.evaluate(() => {
    const { clip, items } = batten.loop.space.read();
    const sheet = items.find(({ kind }) => kind === 0);
    const all = new Float32Array(batten.engine.wasm.memory.buffer, sheet.vertices, 7 * sheet.rows * sheet.columns);
    const stage = document.getElementById('stage').getBoundingClientRect();
    const row = Math.floor(sheet.rows / 2);
    return Array.from({ length: sheet.columns }, (_, j) => {
      const [x, y, z] = all.subarray(7 * (row * sheet.columns + j));
      const at = (k) => clip[k] * x + clip[4 + k] * y + clip[8 + k] * z + clip[12 + k];
      return [stage.left + ((at(0) + 1) / 2) * stage.width, stage.top + ((1 - at(1)) / 2) * stage.height];
    });
  });
  const counts = () => page.evaluate(() => ({ ...batten.loop.space.counts, frames: batten.loop.cost.frames }));
  const all = await counts();
  const within = line.slice(Math.floor(line.length * 0.15), Math.floor(line.length * 0.85));
  const path_ = within.map(([x, y], i) => [x, y - 20 * Math.sin((Math.PI * i) / (within.length - 1)) ** 2]);
  let during;
  await hand.stroke(path_, { during: async () => {
    during = await counts();
    await page.screenshot({ path: path.join(SCREENSHOTS, 'look-drag.png') });
  } });
  await quiet(page);
  const painted = during.painted - all.painted;
  assert.ok(painted > 0, 'it follows the pen');
  assert.equal(during.whole, all.whole, 'the whole is not sent again');
  const size = await page.evaluate(() => batten.loop.space.read().items.filter(({ kind }) => kind === 0)
    .reduce((sum, { rows, columns: across }) => sum + 28 * rows * across, 0));
  assert.ok(during.sent > all.sent && during.sent - all.sent < 0.9 * size * painted, `${during.sent - all.sent} bytes in ${painted} pictures of ${size}`);
  const now = await state(page);
  assert.equal(now.check, '');
  assert.equal(now.unsaved, true);
});

test('a lost context comes back; until then there are lines', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, SMALL);
  await tilted(page);
  const first = await columns(page, false);
  const strokes = () => page.evaluate(() => !batten.painter.flat);
  assert.equal(await strokes(), false);
  await page.evaluate(() => {
    globalThis.loser = batten.loop.space.gl.getExtension('WEBGL_lose_context');
    globalThis.loser.loseContext();
  });
  await page.waitForFunction(() => !batten.painter.flat);
  await quiet(page);
  assert.equal(await page.locator('#space').isVisible(), false);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'look-lost.png') });
  await page.evaluate(() => globalThis.loser.restoreContext());
  await page.waitForFunction(() => batten.painter.flat);
  await quiet(page);
  assert.equal(await page.locator('#space').isVisible(), true);
  assert.deepEqual(await columns(page, false), first);
});

test('without WebGL 2 there are lines, and this is said once', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const context = await browser.newContext(SMALL);
  await context.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function get(kind, ...more) {
      return kind === 'webgl2' ? null : getContext.call(this, kind, ...more);
    };
  });
  const { page } = await open(context, server.address);
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.waitForFunction(() => /WebGL 2/.test(document.getElementById('notice-text').textContent));
  await page.screenshot({ path: path.join(SCREENSHOTS, 'look-none.png') });
  await page.evaluate(() => batten.notices.pass());
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('5');
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await quiet(page);
  assert.doesNotMatch((await state(page)).notice, /WebGL/);
  assert.equal(await page.evaluate(() => batten.painter.flat), false);
  await settle(page);
});
