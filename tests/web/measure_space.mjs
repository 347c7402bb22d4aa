// Measures a line that is dragged on a surface of 64 x 64 patches, in a tilted view, in Chromium, and prints a table; --write puts
// it into docs/benchmarks.md. What the graphics card does is painted by the processor here (software rendering), and is
// told apart. Asserts nothing; ./test does not run it. Usage: node tests/web/measure_space.mjs [--write]
import fs from 'node:fs';
import { launch, open, quiet } from './page.mjs';
import { serve } from './server.mjs';

const PATCHES = 64;
const PAGE = new URL('../../docs/benchmarks.md', import.meta.url);

/** A sheet with gentle hills, as a drawing. */
function sheet() {
  const count = PATCHES + 3;
  const knots = Array.from({ length: count + 4 }, (_, i) => Math.min(Math.max(i - 3, 0), PATCHES));
  const points = Array.from({ length: count }, (_, i) => Array.from({ length: count }, (_, j) =>
    [100 + (800 * i) / (count - 1), 50 + (600 * j) / (count - 1), 30 * Math.sin(i / 9) * Math.cos(j / 7)]));
  const surface = { degree: [3, 3], closed: [false, false], knots: [knots, knots], points };
  const own = fs.readFileSync(new URL('../../examples/space/sheet.journal', import.meta.url), 'utf8').split('\n')[0];
  const { document } = JSON.parse(own);
  const like = document.objects.find(({ kind }) => kind === 'surface');
  document.page = [0, 0, 1000, 700];
  document.objects = [{ ...like, id: 1, surface }];
  document.next = 2;
  return Buffer.from(JSON.stringify(document));
}

const sum = (list) => list.reduce((a, b) => a + b, 0);
const middle = (list) => list.slice().sort((a, b) => a - b)[Math.floor(list.length / 2)] ?? NaN;

const browser = await launch({ smooth: true });
const server = await serve({ name: 'sheet.batten', bytes: sheet() });
const { page, hand } = await open(browser, server.address, { viewport: { width: 1000, height: 640 } });
await page.locator('#first button').click().catch(() => {});
await page.locator('#stage').focus();
for (const key of ['Shift+Alt+ArrowUp', 'Shift+Alt+ArrowUp', 'Shift+Alt+ArrowLeft', 'f']) await page.keyboard.press(key);
await page.waitForFunction(() => batten.loop.space?.counts.painted > 0);
await page.keyboard.press('b');
await page.keyboard.press('Tab');
await quiet(page);

/** The lit line, in pixels of the window: the row of vertices in the middle. */
const line = await page.evaluate(() => {
  const { clip, items } = batten.loop.space.read();
  const item = items.find(({ kind }) => kind === 0);
  const all = new Float32Array(batten.engine.wasm.memory.buffer, item.vertices, 7 * item.rows * item.columns).slice();
  const stage = document.getElementById('stage').getBoundingClientRect();
  const row = Math.floor(item.rows / 2);
  return Array.from({ length: item.columns }, (_, j) => {
    const [x, y, z] = all.subarray(7 * (row * item.columns + j));
    const at = (k) => clip[k] * x + clip[4 + k] * y + clip[8 + k] * z + clip[12 + k];
    return [stage.left + ((at(0) / at(3) + 1) / 2) * stage.width, stage.top + ((1 - at(1) / at(3)) / 2) * stage.height];
  });
});
const size = await page.evaluate(() => batten.loop.space.read().items.filter(({ kind }) => kind === 0)
  .map(({ rows, columns }) => ({ rows, columns, bytes: 28 * rows * columns }))[0]);

// Each part of a frame from now on, in ms.
await page.evaluate(() => {
  const { engine, loop, painter } = batten;
  globalThis.parts = { pointer: [], frame: [], read: [], upload: [], card: [], overlay: [], sent: [] };
  const timed = (owner, name, into, end = () => {}) => {
    const call = owner[name];
    owner[name] = function noted(...values) {
      const start = performance.now();
      const result = call.apply(this, values);
      globalThis.parts[into].push(performance.now() - start);
      end(values);
      return result;
    };
  };
  timed(engine, 'pointer', 'pointer');
  timed(engine, 'frame', 'frame');
  timed(loop.space, 'read', 'read');
  let before = 0;
  timed(loop.space.buffers, 'keep', 'upload', () => {
    globalThis.parts.sent.push(loop.space.counts.sent - before);
    before = loop.space.counts.sent;
  });
  timed(painter, 'paint', 'overlay');
  const { show } = Object.getPrototypeOf(loop.space);
  loop.space.show = function whole(frame) {
    show.call(this, frame);
    const start = performance.now();
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the picture
    globalThis.parts.card.push(performance.now() - start);
  };
});

const within = line.slice(Math.floor(line.length * 0.1), Math.floor(line.length * 0.9));
const way = within.map(([x, y], i) => [x, y - 40 * Math.sin((Math.PI * i) / (within.length - 1)) ** 2]);
const send = (type, [x, y]) => hand.client.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1,
  pointerType: 'pen', force: 0.5, timestamp: (hand.time += 0.004), clickCount: type === 'mousePressed' ? 1 : 0 });
hand.rest(2);
await hand.hover(way[0]);
await page.evaluate(() => { for (const list of Object.values(globalThis.parts)) list.length = 0; });
await send('mousePressed', way[0]);
for (let i = 1; i < way.length; i += 4) {
  await Promise.all(way.slice(i, i + 4).map((sample) => send('mouseMoved', sample)));
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
const parts = await page.evaluate(() => structuredClone(globalThis.parts));
await page.screenshot({ path: new URL('../../build/screenshots/measure-space.png', import.meta.url).pathname });
await page.evaluate(() => { for (const list of Object.values(globalThis.parts)) list.length = 0; });
await hand.client.send('Input.dispatchMouseEvent', { type: 'mouseReleased', x: way.at(-1)[0], y: way.at(-1)[1], button: 'left', pointerType: 'pen' });
await quiet(page);
const up = await page.evaluate(() => structuredClone(globalThis.parts));
const told = await page.evaluate(() => document.getElementById('notice-text').textContent);
await browser.close();
server.close();

const frames = parts.frame.length;
const rows = [
  ['the pen\'s events of a frame: fit, redraw of the surface', middle(parts.pointer)],
  ['the engine\'s frame: triangles and lines that moved', middle(parts.frame)],
  ['asking for the picture', middle(parts.read)],
  ['sending what moved', middle(parts.upload)],
  ['the overlay', middle(parts.overlay)],
];
const all = sum(rows.map(([, time]) => time));
const lines = ['| a line dragged on 64 x 64 patches, median of a frame | ms |', '|---|---:|', ...rows.map(([what, time]) => `| ${what} | ${time.toFixed(2)} |`),
  `| together | ${all.toFixed(2)} |`, `| the picture, by the processor | ${middle(parts.card).toFixed(1)} |`,
  `| pen up: engine, all of it | ${(Math.max(...up.pointer) + up.frame[0]).toFixed(2)} |`, '',
  `${frames} frames; ${size.rows} x ${size.columns} vertices, ${(size.bytes / 1e6).toFixed(2)} MB, of which ${(middle(parts.sent) / 1e6).toFixed(2)} MB are sent.`];
console.log(lines.join('\n'));
console.log(told, parts.frame.map((x) => x.toFixed(1)).join(' '), '|', parts.pointer.map((x) => x.toFixed(1)).join(' '));
if (process.argv.includes('--write')) {
  const text = fs.readFileSync(PAGE, 'utf8');
  fs.writeFileSync(PAGE, text.replace(/(<!-- space -->\n)[^]*?(<!-- end of space -->)/, (_, head, tail) => `${head}\n${lines.join('\n')}\n\n${tail}`));
}
