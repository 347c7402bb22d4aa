// Measures latencies that a user notices, in Chromium, with 10, 1,000 and 5,000 curves in the drawing, and prints a
// table; --write puts it into docs/benchmarks.md. Asserts nothing; ./test does not run it.
// Usage: node tests/web/measure.mjs [--write]
import fs from 'node:fs';
import zlib from 'node:zlib';
import { densify, launch, open, place, settle } from './page.mjs';
import { edit } from './server.mjs';

const COUNTS = [10, 1000, 5000];
const PAGE = new URL('../../docs/benchmarks.md', import.meta.url);

const columnsOf = (count) => Math.max(2, Math.round(Math.sqrt(count / 2.5)));

/** Wavy lines of 20 segments in columns of 198 x rows of 49, on a page of their size. */
function drawing(count) {
  const columns = columnsOf(count);
  const paths = [];
  for (let i = 0; i < count; i++) {
    const x = 20 + (i % columns) * 198;
    const y = 30 + Math.floor(i / columns) * 49;
    let d = `M${x} ${y}`;
    for (let k = 0; k < 20; k++) {
      const up = (((i * 7 + k * 13) % 11) - 5) * 2;
      d += `C${x + 9 * k + 3} ${y + up} ${x + 9 * k + 6} ${y - up} ${x + 9 * (k + 1)} ${y}`;
    }
    paths.push(`<path d="${d}"/>`);
  }
  const size = `${columns * 198 + 40} ${Math.ceil(count / columns) * 49 + 40}`;
  return Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size}" fill="none" stroke="#223344">
    ${paths.join('\n')}</svg>`);
}

/** Times every call of the engine from now on: [call, milliseconds, samples]. */
const watch = (page) => page.evaluate(() => {
  const { engine } = globalThis.batten;
  globalThis.calls = [];
  for (const name of ['pointer', 'frame', 'command']) {
    const call = Object.getPrototypeOf(engine)[name];
    engine[name] = function timed(...values) {
      const start = performance.now();
      const result = call.apply(this, values);
      const phase = name === 'pointer' ? values[0].at(-1).phase : -1;
      globalThis.calls.push([name, performance.now() - start, name === 'pointer' ? values[0].length : 0, phase]);
      return result;
    };
  }
});
const take = (page) => page.evaluate(() => globalThis.calls.splice(0));
const sum = (list) => list.reduce((a, b) => a + b, 0);
const middle = (list) => list.slice().sort((a, b) => a - b)[Math.floor(list.length / 2)] ?? NaN;

/** A wavy path over the page, of about so many samples 0.5 px apart. */
function way(samples, [x, y]) {
  return Array.from({ length: 60 }, (_, i) => [x + (samples * 0.5 * i) / 59, y + 12 * Math.sin(i / 4)]);
}

async function strokes(page, hand, rows, name, path) {
  await hand.hover(path[0]);
  await take(page);
  await page.evaluate(() => { batten.loop.cost = { frames: 0, engine: 0, paint: 0 }; });
  // As from a tablet at 480 samples per second: eight per frame.
  const samples = densify(path, 0.5);
  const send = (type, [x, y]) => hand.client.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1,
    pointerType: 'pen', force: 0.5, timestamp: (hand.time += 0.002), clickCount: type === 'mousePressed' ? 1 : 0 });
  await send('mousePressed', samples[0]);
  for (let i = 1; i < samples.length; i += 8) {
    await Promise.all(samples.slice(i, i + 8).map((sample) => send('mouseMoved', sample)));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
  const calls = await take(page);
  const cost = await page.evaluate(() => ({ ...batten.loop.cost }));
  const told = calls.filter(([what, , , phase]) => what === 'pointer' && phase === 2);
  const frames = calls.filter(([what]) => what === 'frame').map(([, time]) => time);
  rows.push([`${name}: samples, predicted ones too`, sum(told.map(([, , count]) => count)), 0]);
  rows.push([`${name}: engine, an event, us`, (sum(told.map(([, time]) => time)) / sum(told.map(([, , count]) => count))) * 1000, 1]);
  rows.push([`${name}: engine, a frame, mean, ms`, sum(frames) / frames.length, 2]);
  rows.push([`${name}: engine, a frame, longest, ms`, Math.max(...frames), 2]);
  rows.push([`${name}: paint, a frame, mean, ms`, cost.paint / cost.frames, 2]);
  const up = performance.now();
  await hand.client.send('Input.dispatchMouseEvent', { type: 'mouseReleased', x: path.at(-1)[0], y: path.at(-1)[1],
    button: 'left', pointerType: 'pen' });
  await page.waitForFunction(() => batten.keeper.writes === 0 && batten.keeper.length === batten.engine.journal.length,
    null, { polling: 5 });
  rows.push([`${name}: pen up to journal kept, with the test's own way there, ms`, performance.now() - up, 0]);
  await settle(page);
  const lifted = await take(page);
  rows.push([`${name}: commit, engine, ms`, sum(lifted.filter(([, , , phase]) => phase === 3).map(([, time]) => time)), 2]);
}

async function measure(browser, count) {
  const rows = [];
  const program = await edit(drawing(count), 'lines.svg');
  const { page, hand, context } = await open(browser, program.address, {});
  await page.mouse.move(300, 300);
  await page.waitForTimeout(500);
  await watch(page);
  rows.push(['curves', count, 0]);
  await page.evaluate(() => batten.engine.command('zoom-100'));
  await page.waitForTimeout(1500); // everything is painted
  const box = await page.locator('#stage').boundingBox();
  await strokes(page, hand, rows, 'a new curve', way(2400, [box.x + 20, box.y + box.height - 22]).map(([x, y]) =>
    [Math.min(x, box.x + box.width - 20), y]));
  const shown = await page.evaluate(() => ({ ...batten.painter.painted }));
  const columns = columnsOf(count); // a line that is wholly visible
  const column = Math.min(columns - 1, Math.max(0, Math.ceil((shown.x + 80) / 198)));
  const row = Math.min(Math.ceil(count / columns) - 1, Math.max(0, Math.ceil((shown.y + 80) / 49)));
  const from = await place(page, 20 + column * 198 + 30, 30 + row * 49);
  await strokes(page, hand, rows, 'redrawing a curve', [from, [from[0] + 50, from[1] - 8], [from[0] + 110, from[1]]]);
  const undo = [];
  for (let i = 0; i < 9; i++) {
    await take(page);
    await page.evaluate((name) => { batten.engine.command(name); batten.engine.frame(); }, i % 2 ? 'redo' : 'undo');
    undo.push(sum((await take(page)).map(([, time]) => time)));
  }
  rows.push(['undo or redo, and its frame, ms', middle(undo), 2]);
  const paint = await page.evaluate(() => { // reading back a pixel includes the drawing itself in the time
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
  rows.push(['all that is seen painted anew, pixels included, ms', paint, 1]);
  const pan = await page.evaluate(async () => {
    const start = performance.now();
    for (let i = 0; i < 30; i++) {
      batten.engine.wheel(640, 400, 3, 2, 0, performance.now());
      batten.wake();
      await new Promise((done) => requestAnimationFrame(done));
    }
    return (performance.now() - start) / 30;
  });
  rows.push(['a frame while panning, ms (16.7: none is missed)', pan, 1]);
  const memory = await page.evaluate(() => [batten.engine.wasm.memory.buffer.byteLength,
    performance.memory?.usedJSHeapSize ?? NaN]);
  rows.push(["the module's memory, MB", memory[0] / 1e6, 1], ["the page's heap of scripts, MB", memory[1] / 1e6, 1]);
  await context.close();
  await program.close();
  return rows;
}

async function firstLoad(browser) {
  const program = await edit(drawing(10), 'lines.svg');
  const page = await browser.newPage();
  const bodies = [];
  page.on('response', (response) => {
    const later = /\/(document|batten-later\.wasm)$/.test(response.url()); // the module's second part is not of the first load
    if (response.ok() && response.url().startsWith('http') && !later) bodies.push(response.body());
  });
  const start = performance.now();
  await page.goto(program.address);
  await page.waitForSelector('html[data-ready=yes]');
  const time = performance.now() - start;
  await page.waitForLoadState('networkidle');
  const sizes = (await Promise.all(bodies)).map((body) => zlib.gzipSync(body, { level: 9 }).length);
  await page.close();
  await program.close();
  return [sum(sizes) / 1000, time];
}

const browser = await launch();
const tables = [];
for (const count of COUNTS) {
  tables.push(await measure(browser, count));
}
const [size, time] = await firstLoad(browser);
await browser.close();
const lines = ['| | ' + COUNTS.map((count) => count.toLocaleString('en')).join(' | ') + ' |', '|---|' + '---:|'.repeat(COUNTS.length)];
tables[0].slice(1).forEach(([what]) => lines.push(`| ${what} | ` + tables.map((rows) => {
  const row = rows.find(([other]) => other === what);
  return row && Number.isFinite(row[1]) ? row[1].toFixed(row[2]) : '';
}).join(' | ') + ' |'));
lines.push('', `First load: ${size.toFixed(1)} kB gzip, ready after ${time.toFixed(0)} ms.`);
console.log(lines.join('\n'));
if (process.argv.includes('--write')) {
  const page = fs.readFileSync(PAGE, 'utf8');
  fs.writeFileSync(PAGE, page.replace(/(<!-- browser -->\n)[^]*?(<!-- end -->)/, (_, head, tail) => `${head}\n${lines.join('\n')}\n\n${tail}`));
}
