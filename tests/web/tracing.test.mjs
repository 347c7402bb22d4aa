// Pictures to trace: dropped, pasted and opened; preserved by saving and after a crash; shown behind the drawing.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import zlib from 'node:zlib';
import { expectFaults, inked, launch, open, pictures, reveal, said, settle, state } from './page.mjs';
import { serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

/** A PNG: left half red, right half blue; base 64. */
function twoHalves(width, height) {
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name), data]);
    const length = Buffer.alloc(4);
    const sum = Buffer.alloc(4);
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(zlib.crc32(body));
    return Buffer.concat([length, body, sum]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width);
  head.writeUInt32BE(height, 4);
  head.set([8, 2], 8);
  const row = Buffer.concat([Buffer.from([0]), ...Array.from({ length: width }, (_, x) =>
    Buffer.from(x < width / 2 ? [255, 0, 0] : [0, 0, 255]))]);
  const pixels = Buffer.concat(Array.from({ length: height }, () => row));
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head),
    chunk('IDAT', zlib.deflateSync(pixels)), chunk('IEND', Buffer.alloc(0))]).toString('base64');
}

/** Passes a file to the page by an event that carries files. */
const give = (page, kind, type, base64) => page.evaluate(([event, mime, data]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], 'picture', { type: mime }));
  const made = event === 'paste' ? new ClipboardEvent(event, { bubbles: true, cancelable: true, clipboardData: transfer }) :
    new DragEvent(event, { bubbles: true, cancelable: true, dataTransfer: transfer });
  document.getElementById('stage').dispatchEvent(made);
}, [kind, type, base64]);

const shownPictures = (page, count) => page.waitForFunction((wanted) =>
  [...batten.painter.pictures.values()].filter(Boolean).length === wanted, count);

/** Red, green, blue and alpha of the still canvas at a window position. */
const colourAt = (page, x, y) => page.evaluate(([left, top]) => {
  const canvas = document.getElementById('still');
  const box = canvas.getBoundingClientRect();
  return [...canvas.getContext('2d').getImageData((left - box.left) * devicePixelRatio, (top - box.top) * devicePixelRatio,
    1, 1).data];
}, [x, y]);

const middle = async (page) => {
  const box = await page.locator('#stage').boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

test('a dropped picture is shown, moved, saved and brought back', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await give(page, 'drop', 'image/png', twoHalves(400, 200));
  await shownPictures(page, 1);
  await settle(page);
  const [x, y] = await middle(page);
  const left = await colourAt(page, x - 100, y);
  const right = await colourAt(page, x + 100, y);
  assert.ok(left[0] > 240 && left[2] < 10 && left[3] > 120 && left[3] < 136, String(left)); // half transparent
  assert.ok(right[2] > 240 && right[0] < 10, String(right));
  assert.equal((await colourAt(page, x - 210, y))[3], 0);
  assert.match((await state(page)).notice, /Picture placed/);
  await pictures(page, 'tracing-placed');
  await hand.stroke([[x, y], [x + 120, y + 60]], { pointerType: 'mouse' });
  assert.ok((await colourAt(page, x + 20, y + 60))[0] > 240);
  assert.equal((await colourAt(page, x - 150, y))[3], 0);
  // Draws over it.
  await page.keyboard.press('n');
  await hand.stroke([[x - 200, y], [x, y - 80], [x + 200, y]]);
  await pictures(page, 'tracing-drawn');
  const { digest, check } = await state(page);
  assert.equal(check, '');
  // Saved in both formats and opened again, it is the same.
  const digests = await page.evaluate(async () => {
    const all = [];
    for (const native of [true, false]) {
      await batten.files.open(batten.engine.save(native), native ? 'a.batten' : 'a.svg');
      all.push(batten.engine.digest());
    }
    return all;
  });
  assert.deepEqual(digests, [digest, digests[1]]);
  await settle(page);
  assert.ok((await colourAt(page, ...(await middle(page))))[3] > 0 || await inked(page, 'still') > 1000);
  await context.close();
});

test('scaled by two points, faded, locked', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await give(page, 'drop', 'image/png', twoHalves(400, 200));
  await shownPictures(page, 1);
  const [x, y] = await middle(page);
  await reveal(page, 'layers');
  await page.waitForSelector('#pictures'); // fetched when it is first opened
  await page.click('#pictures [data-text="command.tool-span"]');
  await page.keyboard.press('Escape');
  await settle(page);
  for (const at of [[x - 200, y], [x + 200, y]]) {
    await hand.stroke([at, at], { pointerType: 'mouse' });
  }
  await page.waitForSelector('#setting-picture-span:focus');
  await pictures(page, 'tracing-span');
  await page.keyboard.type('800');
  await page.keyboard.press('Enter');
  await settle(page);
  const matrix = await page.evaluate(() =>
    JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects[0].matrix);
  assert.ok(Math.abs(matrix[0] - 2) < 1e-9, String(matrix));
  await page.fill('#setting-picture-opacity', '1');
  await page.press('#setting-picture-opacity', 'Enter');
  await page.click('#pictures [data-text="command.picture-lock"]');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal((await colourAt(page, x + 100, y + 50))[3], 255);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await hand.stroke([[x, y + 50], [x, y + 50]], { pointerType: 'mouse' });
  assert.equal(await page.evaluate(() => glance().selected), 0);
  await pictures(page, 'tracing-locked');
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('pasted by the keyboard, scaled by two points in millimetres', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate(async (data) => {
    const blob = new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], { type: 'image/png' });
    await navigator.clipboard.write([new ClipboardItem({ 'image/png': blob })]);
  }, twoHalves(400, 200));
  await page.focus('#stage');
  await page.keyboard.press('Control+v');
  await shownPictures(page, 1);
  await settle(page);
  assert.match((await state(page)).notice, /Picture placed/);
  const [x, y] = await middle(page);
  assert.ok((await colourAt(page, x - 100, y))[0] > 240);
  await page.evaluate(() => batten.engine.set('unit', 1));
  await reveal(page, 'layers');
  await page.click('#pictures [data-text="command.tool-span"]');
  await page.keyboard.press('Escape');
  for (const at of [[x - 150, y], [x + 150, y]]) {
    await hand.stroke([at, at], { pointerType: 'mouse' });
  }
  await page.waitForSelector('#setting-picture-span:focus');
  const label = () => page.evaluate(() => glance().labels.map(({ text }) => text).join());
  const span = (300 / await page.evaluate(() => batten.painter.painted.zoom)) * (25.4 / 96);
  assert.equal(await label(), `${Number(span.toFixed(3))} mm`);
  assert.equal(await said(page, '#setting-picture-span'), await label());
  await page.keyboard.type('120');
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await label(), '120 mm');
  assert.equal(await page.textContent('#values'), '120 mm'); // for screen readers
  const { matrix } = await page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects[0]);
  assert.ok(Math.abs(matrix[0] - (120 * 96 / 25.4) / 300) < 1e-9, String(matrix));
  await pictures(page, 'tracing-millimetres');
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('a crash of the module brings the picture back from the journal', async () => {
  expectFaults(/RuntimeError: test/);
  const { page, context } = await open(browser, server.address);
  await give(page, 'drop', 'image/png', twoHalves(100, 100));
  await shownPictures(page, 1);
  await settle(page);
  const { digest } = await state(page);
  await page.evaluate(() => {
    glance();
    const { resize } = batten.engine;
    batten.engine.wasm = { ...batten.engine.wasm, editor_resize: () => batten.engine.module && (() => {
      throw new WebAssembly.RuntimeError('test');
    })() };
    resize.call(batten.engine, 800, 600, 1);
  });
  await settle(page);
  assert.equal((await state(page)).digest, digest);
  await context.close();
});

test('what is no picture is refused in one line; other kinds become PNG', async () => {
  const { page, context } = await open(browser, server.address);
  await give(page, 'drop', 'image/png', btoa('GIF89a nonsense'));
  await page.waitForFunction(() => /Not a PNG/.test(document.getElementById('notice-text').textContent));
  // A GIF of one pixel.
  await give(page, 'drop', 'image/gif', 'R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7');
  await shownPictures(page, 1);
  assert.match(await page.evaluate(() => new TextDecoder().decode(batten.engine.save(false))), /data:image\/png/);
  await context.close();
});
