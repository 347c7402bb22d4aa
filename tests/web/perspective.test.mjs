// Perspective: the switch beside the dial, the depth buffer and the overlay agree, strokes land, pictures to trace follow.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, pictures, quiet, state } from './page.mjs';
import { serve } from './server.mjs';

const EXAMPLES = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples');
const JUG = fs.readFileSync(path.join(EXAMPLES, 'jug.batten'));
const SMALL = { viewport: { width: 640, height: 480 } }; // painted in software here

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('the button beside the dial switches perspective on and off', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { ...SMALL });
  await page.locator('#first button').click();
  await page.locator('#stage').focus();
  assert.equal(await page.locator('.deep').isVisible(), false);
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press('Shift+Alt+ArrowUp');
  }
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  await page.keyboard.press('f');
  await quiet(page);
  const first = await state(page);
  const button = page.locator('.deep');
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  await button.click();
  await page.keyboard.press('f');
  await quiet(page);
  assert.equal(await button.getAttribute('aria-pressed'), 'true');
  assert.match((await state(page)).notice, /perspective/);
  const now = await page.evaluate(() => {
    const picture = batten.loop.space.read();
    return { deep: picture.perspective, error: batten.loop.space.gl.getError() };
  });
  assert.deepEqual(now, { deep: 1, error: 0 });
  await pictures(page, 'perspective');
  for (let i = 0; i < 9; i++) {
    await page.keyboard.press('+'); // into the jug
  }
  await quiet(page);
  await pictures(page, 'perspective-near');
  await page.keyboard.press('Shift+P');
  await quiet(page);
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  assert.equal((await state(page)).digest, first.digest);
  assert.equal((await state(page)).unsaved, false);
  await page.keyboard.press('5');
  await quiet(page);
  assert.equal(await page.locator('.deep').isVisible(), false);
});

test('lines with a depth lie where the overlay shows them', async (t) => {
  const server = await serve({ name: 'jug.batten', bytes: JUG });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, SMALL);
  await page.locator('#first button').click();
  await page.locator('#stage').focus();
  for (const key of ['Shift+Alt+ArrowUp', 'Shift+Alt+ArrowUp', 'Shift+Alt+ArrowLeft', 'Shift+P', 'f']) {
    await page.keyboard.press(key);
  }
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  await quiet(page);
  const far = await page.evaluate(() => {
    // Every point of the lines that have a depth, against the outlines on the still canvas.
    const { clip, items } = batten.loop.space.read();
    const frame = glance();
    const { width, height } = batten.painter;
    let worst = 0;
    for (const solid of items.filter(({ kind }) => kind === 1)) {
      const points = new Float32Array(batten.engine.wasm.memory.buffer, solid.vertices, 4 * solid.rows).slice();
      const flat = frame.still.find(({ id }) => id === solid.id);
      if (!flat) {
        continue;
      }
      const shape = [];
      let [x, y] = [0, 0];
      for (let i = 0; i < flat.path.length;) {
        const kind = flat.path[i++];
        const at = flat.path.slice(i, i + 6);
        if (kind === 2) {
          for (let s = 0; s <= 40; s++) {
            const [u, v] = [s / 40, 1 - s / 40];
            const b = [v * v * v, 3 * u * v * v, 3 * u * u * v, u * u * u];
            const all = [x, y, ...at];
            shape.push([0, 1].map((d) => b.reduce((sum, share, j) => sum + share * all[2 * j + d], 0)));
          }
          [x, y] = [at[4], at[5]];
          i += 6;
        } else if (kind < 2) {
          [x, y] = at;
          i += 2;
        }
      }
      const angle = (frame.angle * Math.PI) / 180;
      const seen = shape.map(([a, b]) => {
        const [p, q] = [a + frame.originX - frame.x, b + frame.originY - frame.y];
        return [(Math.cos(angle) * p - Math.sin(angle) * q) * frame.zoom, (Math.sin(angle) * p + Math.cos(angle) * q) * frame.zoom];
      });
      for (let i = 0; i < solid.rows && flat.role === 0 && seen.length; i++) {
        const row = (k) => clip[k] * points[4 * i] + clip[4 + k] * points[4 * i + 1] + clip[8 + k] * points[4 * i + 2] + clip[12 + k];
        const [px, py] = [((row(0) / row(3) + 1) / 2) * width, ((1 - row(1) / row(3)) / 2) * height];
        let near = Infinity;
        for (let j = 1; j < seen.length; j++) {
          const [ax, ay, bx, by] = [...seen[j - 1], ...seen[j]];
          const [dx, dy] = [bx - ax, by - ay];
          const share = Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy || 1)));
          near = Math.min(near, Math.hypot(px - ax - share * dx, py - ay - share * dy));
        }
        worst = Math.max(worst, near);
      }
    }
    return worst;
  });
  assert.ok(far > 0 && far < 0.5, `${far} px`);
});
