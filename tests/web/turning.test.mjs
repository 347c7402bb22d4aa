// While the view turns: no picture that reaches the screen is empty, what lies on the overlay goes with the curve, and home is
// reached within a quarter of a second.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, quiet, settle } from './page.mjs';
import { serve } from './server.mjs';

const WAVE = Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 700">
  <path d="M250 350C400 150 600 550 750 350" fill="none" stroke="#e00000" stroke-width="16"/></svg>`);
const SMALL = { viewport: { width: 640, height: 480 }, colorScheme: 'light' };

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** Of each picture: how many pixels are red, and the middle of those and of what is drawn on them: blue, with red beside it. */
const analyse = (page, pictures) => page.evaluate(async (all) => {
  const results = [];
  for (const data of all) {
    const bytes = Uint8Array.from(atob(data), (one) => one.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, image.width, image.height);
    const sums = { red: [0, 0, 0], blue: [0, 0, 0] };
    const isRed = (x, y) => {
      const [r, g, b] = pixels.subarray(4 * (y * image.width + x));
      return r > 150 && g < 90 && b < 90;
    };
    const isBeside = (x, y) => [[8, 0], [-8, 0], [0, 8], [0, -8]].some(([right, down]) => isRed(x + right, y + down));
    for (let y = 60; y < image.height - 40; y++) {
      for (let x = 60; x < image.width - 60; x++) {
        const [r, g, b] = pixels.subarray(4 * (y * image.width + x));
        const sum = isRed(x, y) ? sums.red : b > 120 && b > r + 60 && b > g + 20 && isBeside(x, y) ? sums.blue : null;
        if (sum) {
          sum[0]++;
          sum[1] += x;
          sum[2] += y;
        }
      }
    }
    const middle = ([count, x, y]) => ({ count, x: x / count, y: y / count });
    results.push({ red: middle(sums.red), blue: middle(sums.blue) });
  }
  return results;
}, pictures);

test('no picture of an orbit is empty, and the overlay goes along', async (t) => {
  const server = await serve({ name: 'wave.svg', bytes: WAVE });
  t.after(() => server.close());
  const { page, client, context } = await open(browser, server.address, SMALL);
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
  await quiet(page);
  await page.waitForSelector('.dot', { state: 'attached' });
  await page.evaluate(() => { // a red dot and coloured arrows with an edge, which are no part of the drawing
    document.querySelectorAll('.dot').forEach((dot) => dot.replaceChildren());
    for (const role of ['chosen', 'axis-x', 'axis-x-fill', 'axis-y', 'axis-y-fill', 'axis-z', 'axis-z-fill']) {
      document.documentElement.style.setProperty(`--role-${role}`, '#0000');
    }
    CanvasRenderingContext2D.prototype.fillText = CanvasRenderingContext2D.prototype.strokeText = () => {}; // their names, too
    batten.painter.theme.choose('light');
  });
  await settle(page); // what is filmed first has been painted after it
  const pictures = [];
  client.on('Page.screencastFrame', ({ data, sessionId }) => {
    pictures.push(data);
    void client.send('Page.screencastFrameAck', { sessionId });
  });
  await client.send('Page.startScreencast', { format: 'png', everyNthFrame: 1 });
  await page.mouse.move(300, 240);
  await page.mouse.down({ button: 'right' });
  for (let i = 1; i <= 40; i++) {
    await page.mouse.move(300 + 3 * i, 240 - 2 * Math.round(20 * Math.sin(i / 6)));
    await settle(page);
  }
  await page.mouse.up({ button: 'right' });
  await quiet(page);
  await client.send('Page.stopScreencast');
  const lab = await context.newPage();
  const seen = await analyse(lab, pictures);
  await lab.close();
  assert.ok(new Set(pictures).size > 10, `${pictures.length} pictures`);
  const [{ red: first, blue: over }] = seen;
  assert.ok(first.count > 500 && over.count > 200, 'the curve, and the selection drawn over it');
  seen.forEach(({ red, blue }, i) => {
    assert.ok(red.count > 0.5 * first.count && red.count < 2 * first.count, `picture ${i}: ${red.count} of ${first.count} pixels`);
    assert.ok(blue.count > 0.5 * over.count, `picture ${i}: ${blue.count} of ${over.count} pixels over it`);
    assert.ok(Math.hypot(red.x - blue.x, red.y - blue.y) < 8, `picture ${i}: ${[red.x - blue.x, red.y - blue.y]} px apart`);
  });
});

test('home is reached within a quarter of a second, step by step', async (t) => {
  const server = await serve({ name: 'wave.svg', bytes: WAVE });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, SMALL);
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await quiet(page);
  await page.evaluate(() => {
    const { engine, loop } = batten;
    const { glide } = Object.getPrototypeOf(engine);
    globalThis.way = [];
    engine.glide = function noted(share) {
      globalThis.way.push([share, loop.jumped]);
      return glide.call(this, share);
    };
  });
  await page.keyboard.press('5');
  await quiet(page);
  const { way, tilt } = await page.evaluate(() => ({ way: globalThis.way, tilt: glance().tilt }));
  assert.equal(tilt, 0);
  assert.equal(new Set(way.map(([, from]) => from)).size, 1, 'one way');
  const shares = way.map(([share]) => share);
  shares.slice(1).forEach((share, i) => assert.ok(share >= shares[i], 'never back'));
  assert.equal(shares.at(-1), 1);
  assert.ok(shares.filter((share) => share === 1).length <= 2, 'and there it ends');
});
