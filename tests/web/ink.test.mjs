// label: smoke. What is seen while drawing is what one gets: the line in its own colour and width. Farther than one width of the
// line from the pen's path, few of its pixels differ between the last frame before the pen is lifted and the drawing after it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, inThemes, launch, open, place, quiet, SCREENSHOTS, state, timePaint } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const SHARE = 0.02;
const CLOSE = 0.08; // of lines that are hardly wider than the last fit is off the one of the whole stroke, half a pixel
const HAIRLINE = 0.75; // pixels that a line is wide at least, as it is painted

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/**
 * Both canvases as they are seen, over white; and beside the last look: how many pixels the line has, how many differ farther
 * than `width` from the path, and how many in all. What the line had covered before (`old`) is left out.
 */
const look = (page, name) => page.evaluate((key) => {
  const { still, overlay } = batten.painter;
  const canvas = new OffscreenCanvas(still.width, still.height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.fillStyle = 'white';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(still, 0, 0);
  context.drawImage(overlay, 0, 0);
  (globalThis.looks ??= {})[key] = context.getImageData(0, 0, canvas.width, canvas.height);
}, name);

const compare = (page, points, width) => page.evaluate(([along, wide]) => {
  const { before, live, after } = globalThis.looks;
  const { left, top } = batten.stage.getBoundingClientRect();
  const near = new OffscreenCanvas(live.width, live.height).getContext('2d');
  near.lineWidth = 2 * wide;
  near.lineCap = near.lineJoin = 'round';
  near.beginPath();
  along.forEach(([x, y], i) => near[i ? 'lineTo' : 'moveTo']((x - left) * devicePixelRatio, (y - top) * devicePixelRatio));
  near.stroke();
  const by = near.getImageData(0, 0, live.width, live.height).data;
  const counts = { line: 0, far: 0, changed: 0, accent: 0 };
  const differs = (a, b, i) => Math.max(Math.abs(a.data[i] - b.data[i]), Math.abs(a.data[i + 1] - b.data[i + 1]), Math.abs(a.data[i + 2] - b.data[i + 2])) > 24;
  for (let i = 0; i < by.length; i += 4) {
    const old = before.data[i] < 216; // a line was there, if only its edge
    counts.line += differs(before, after, i) && !old ? 1 : 0;
    const changed = !old && differs(live, after, i);
    counts.changed += changed ? 1 : 0;
    counts.far += changed && by[i + 3] === 0 ? 1 : 0;
    counts.accent += live.data[i + 2] > live.data[i] + 100 ? 1 : 0; // strong blue
  }
  return counts;
}, [points, width]);

/** White paper, in the dark theme too: a line is what is not white. */
async function whitened(page) {
  await page.evaluate(() => batten.theme.dimPaper(false));
  await quiet(page);
}

const wave = (x, y) => bezier([x, y], [x + 150, y - 190], [x + 260, y + 210], [x + 420, y - 20]);

for (const [name, style] of [['thin', { 'stroke-width': 2 }], ['thick', { 'stroke-width': 14, 'stroke-colour': 0xc23616ff }], ['pressed', { 'stroke-width': 16, 'pressure-width': 1 }]]) {
  for (const [device, options] of [['desk', {}], ['phone', { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, colorScheme: 'dark' }]]) {
    test(`a new line, ${name}, ${device}: it is drawn as it will be`, async (t) => {
      const server = await serve({ name: 'new.svg', bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700"/>') });
      t.after(() => server.close());
      const { page, hand, context } = await open(browser, server.address, options);
      const scale = device === 'phone' ? 0.7 : 1;
      await whitened(page);
      await page.evaluate((values) => Object.entries(values).forEach(([key, value]) => batten.engine.set(key, value)), style);
      await look(page, 'before');
      const points = wave(90, 300).map(([x, y]) => [x * scale, y]);
      await hand.stroke(points, { during: async () => {
      await hand.drag(points.at(-1), points.at(-1)); // a pen that is lifted has come to rest
        await look(page, 'live');
        await page.screenshot({ path: path.join(SCREENSHOTS, `ink-${name}-${device}.png`) });
      } });
      await page.screenshot({ path: path.join(SCREENSHOTS, `ink-${name}-${device}-settling.png`) });
      await hand.hover([120, 700]); // nothing is lit
      await quiet(page);
      await look(page, 'after');
      await page.screenshot({ path: path.join(SCREENSHOTS, `ink-${name}-${device}-settled.png`) });
      const zoom = (await state(page)).zoom;
      const counts = await compare(page, points, Math.max(style['stroke-width'] * zoom, HAIRLINE) * (options.deviceScaleFactor ?? 1));
      console.log(`${name}, ${device}: ${JSON.stringify(counts)}`);
      assert.ok(counts.line > 500, JSON.stringify(counts));
      assert.ok(counts.far < (name === 'thin' && device === 'phone' ? CLOSE : SHARE) * counts.line, JSON.stringify(counts));
      assert.equal(counts.accent, 0, 'no accent but a halo');
      assert.equal((await state(page)).check, '');
      await context.close();
    });
  }
}

test('a redraw in both themes: the old curve is pale, the new one as it will be', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await whitened(page);
  await inThemes(page, async (colorScheme) => {
    await look(page, 'before');
    const points = await Promise.all(bezier([440, 135], [490, 78], [580, 60], [690, 115]).map(([x, y]) => place(page, x, y)));
    await hand.stroke(points, { during: async () => {
      await hand.drag(points.at(-1), points.at(-1)); // a pen that is lifted has come to rest
      await look(page, 'live');
      await page.screenshot({ path: path.join(SCREENSHOTS, `ink-redraw-${colorScheme}.png`) });
    } });
    await page.screenshot({ path: path.join(SCREENSHOTS, `ink-redraw-${colorScheme}-settling.png`) });
    await hand.hover([120, 700]); // nothing is lit
    await quiet(page);
    await look(page, 'after');
    await page.screenshot({ path: path.join(SCREENSHOTS, `ink-redraw-${colorScheme}-settled.png`) });
    const counts = await compare(page, points, 3);
    console.log(`redraw, ${colorScheme}: ${JSON.stringify(counts)}`);
    assert.ok(counts.line > 300, JSON.stringify(counts));
    assert.ok(counts.far < CLOSE * counts.line, JSON.stringify(counts));
    assert.equal(counts.accent, 0, 'no accent but a halo');
    await page.keyboard.press('Control+z');
    await quiet(page);
  });
  await context.close();
});

test('from the pen to the paint', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await timePaint(page);
  const moves = wave(200, 400);
  await hand.hover(moves[0]);
  await page.evaluate(async (points) => {
    const send = (kind, [clientX, clientY], buttons) => batten.stage.dispatchEvent(new PointerEvent(kind, { pointerId: 9,
      pointerType: 'pen', pressure: buttons / 2, clientX, clientY, buttons, bubbles: true }));
    send('pointerdown', points[0], 1);
    for (const point of points) {
      send('pointermove', point, 1);
      await new Promise((done) => setTimeout(done, 8));
    }
    send('pointerup', points.at(-1), 0);
  }, moves);
  await quiet(page);
  const late = await page.evaluate(() => globalThis.late.sort((a, b) => a - b));
  console.log(`from event to paint: ${late[late.length >> 1].toFixed(1)} ms in the median, ${late[Math.floor(late.length * 0.95)].toFixed(1)} ms of 95 % (${late.length} frames)`);
  assert.ok(late.length > 5 && late[late.length >> 1] < 1000, `${late}`);
  assert.equal(await page.evaluate(() => batten.painter.overlayContext.getContextAttributes().alpha), true);
  await context.close();
});

test('with reduced motion nothing fades', async (t) => {
  const server = await serve({ name: 'new.svg', bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700"/>') });
  t.after(() => server.close());
  for (const [reducedMotion, fades] of [['no-preference', 1], ['reduce', 0]]) {
    const { page, hand, context } = await open(browser, server.address, { reducedMotion });
    await hand.stroke([[300, 200], [340, 220], [380, 200]]);
    await page.waitForFunction(() => batten.settling);
    await page.evaluate(() => {
      globalThis.fades = 0;
      const { animate } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.animate = function (...words) {
        globalThis.fades++;
        return animate.apply(this, words);
      };
    });
    await hand.stroke(wave(200, 400));
    await quiet(page);
    assert.equal(await page.evaluate(() => globalThis.fades), fades, reducedMotion);
    assert.equal(await page.locator('#stage > canvas').count(), 2, 'the layer has gone');
    await context.close();
  }
});
