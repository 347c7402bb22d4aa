// Measures, in Chromium, what a user feels: the cost of an event and of a frame with 1,000 curves in the drawing, and
// the first load. Nothing is asserted; ./test does not run it. node tests/web/measure.mjs
import fs from 'node:fs';
import zlib from 'node:zlib';
import { bezier, launch, open, place, settle } from './page.mjs';
import { MODULE, serve } from './server.mjs';

/** 1,000 wavy lines of 20 segments on a page of 4000 x 2500. */
function drawing() {
  const paths = [];
  for (let i = 0; i < 1000; i++) {
    const x = 20 + (i % 20) * 198;
    const y = 30 + Math.floor(i / 20) * 49;
    let d = `M${x} ${y}`;
    for (let k = 0; k < 20; k++) {
      const up = (((i * 7 + k * 13) % 11) - 5) * 2;
      d += `C${x + 9 * k + 3} ${y + up} ${x + 9 * k + 6} ${y - up} ${x + 9 * (k + 1)} ${y}`;
    }
    paths.push(`<path d="${d}"/>`);
  }
  return Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4000 2500" fill="none" stroke="#223344">
    ${paths.join('\n')}</svg>`);
}

const reset = (page) => page.evaluate(() => {
  batten.cost = { frames: 0, engine: 0, paint: 0 };
  batten.input.cost = { samples: 0, milliseconds: 0 };
});
const read = (page) => page.evaluate(() => ({ ...batten.cost, ...batten.input.cost }));
const say = (what, value, unit) => console.log(`${what.padEnd(58)} ${value.toFixed(3).padStart(9)} ${unit}`);

const browser = await launch();
const server = await serve({ name: 'thousand.svg', bytes: drawing() });
const { page, hand, context } = await open(browser, server.address, {});
say('curves', await page.evaluate(() => batten.painter.list.length - 1), '');

for (const [name, points] of [
  ['a new curve', bezier([300, 22], [1200, 32], [2200, 14], [3600, 24])],
  ['redrawing a curve', bezier([1030, 1250], [1060, 1262], [1110, 1240], [1160, 1250])],
]) {
  const path = await Promise.all(points.map(([x, y]) => place(page, x, y)));
  await reset(page);
  await hand.stroke(path, { step: 0.5, lift: false });
  const cost = await read(page);
  say(`${name}: samples`, cost.samples, '');
  say(`${name}: engine, an event`, (cost.milliseconds / cost.samples) * 1000, 'us');
  say(`${name}: engine, a frame`, cost.engine / cost.frames, 'ms');
  say(`${name}: painting calls, a frame`, cost.paint / cost.frames, 'ms');
  await page.evaluate(() => globalThis.batten.engine.command('cancel'));
  await hand.client.send('Input.dispatchMouseEvent', { type: 'mouseReleased', x: path[0][0], y: path[0][1],
    button: 'left', pointerType: 'pen' });
  await settle(page);
}

// Canvas calls are recorded and drawn later: reading a pixel back makes the drawing itself part of the time.
const full = await page.evaluate(() => {
  const { painter, engine } = batten;
  const times = [];
  for (let i = 0; i < 5; i++) {
    painter.retheme();
    const frame = engine.frame();
    const start = performance.now();
    painter.paint(frame);
    painter.stillContext.getImageData(0, 0, 1, 1);
    times.push(performance.now() - start);
  }
  return Math.min(...times);
});
say('all 1,000 curves painted anew, pixels included', full, 'ms');
const commit = await page.evaluate(() => {
  const { painter, engine } = batten;
  const times = [];
  for (let i = 0; i < 5; i++) {
    const frame = engine.frame();
    frame.dirty = [1010 - frame.originX, 1230 - frame.originY, 1200 - frame.originX, 1270 - frame.originY];
    const start = performance.now();
    for (let k = 0; k < 20; k++) {
      painter.paint(frame);
      painter.stillContext.getImageData(0, 0, 1, 1);
    }
    times.push((performance.now() - start) / 20);
  }
  return Math.min(...times);
});
say('the rectangle of one curve painted anew, pixels included', commit, 'ms');
const moves = await page.evaluate(async () => {
  const start = performance.now();
  const before = batten.painter.counts.moved;
  for (let i = 0; i < 30; i++) {
    batten.engine.wheel(640, 400, 3, 2, 0, performance.now());
    batten.wake();
    await new Promise((done) => requestAnimationFrame(done));
  }
  return [(performance.now() - start) / 30, batten.painter.counts.moved - before];
});
say('a frame while panning over it', moves[0], 'ms');
say('of 30 frames, layers moved without painting', moves[1], '');
await context.close();
await browser.close();
server.close();

const web = new URL('../../web/', import.meta.url);
const shell = fs.readdirSync(web, { recursive: true }).filter((file) => /\.(html|js|css|svg)$/.test(file))
  .map((file) => zlib.gzipSync(fs.readFileSync(new URL(file, web)), { level: 9 }).length).reduce((a, b) => a + b);
const core = zlib.gzipSync(fs.readFileSync(MODULE), { level: 9 }).length;
say('first load, gzip: shell', shell / 1000, 'kB');
say('first load, gzip: module', core / 1000, 'kB');
