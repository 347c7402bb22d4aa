// How long it takes from a move of the pen to the end of the frame that shows it: the same strokes in this editor and in two public ink
// programs, in one Chromium, with all of the processor and with a quarter of it. Needs what package.json names (npm install here),
// the browser tests' packages and a build: BATTEN_TREE=build/dev node bench/ink/run.mjs
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, open, timePaint } from '../../tests/web/page.mjs';
import { serve } from '../../tests/web/server.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const EMPTY = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="700"/>');
const [STROKES, SAMPLES, EVERY] = [4, 240, 6]; // ms between two samples
const TYPES = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript' };

const rest = (time) => new Promise((done) => setTimeout(done, time));

/** The two programs, each as a page of its own; their address. */
async function peers(folder) {
  for (const name of ['excalidraw', 'tldraw']) {
    execFileSync(path.join(HERE, 'node_modules/.bin/esbuild'), [path.join(HERE, `${name}.jsx`), '--bundle', '--minify', '--jsx=automatic',
      '--conditions=production', '--loader:.woff2=dataurl', '--define:process.env.NODE_ENV="production"', '--log-level=error',
      '--define:process.env.IS_PREACT="false"', `--outfile=${folder}/${name}.js`]);
    fs.writeFileSync(`${folder}/${name}.html`, `<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="${name}.css">` +
      `<body style="margin: 0"><div style="position: fixed; inset: 0"></div><script src="${name}.js"></script>`);
  }
  const server = http.createServer(({ url }, answer) => {
    const file = path.join(folder, path.basename(url));
    answer.writeHead(fs.existsSync(file) ? 200 : 404, { 'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream' });
    answer.end(fs.existsSync(file) ? fs.readFileSync(file) : '');
  });
  await new Promise((done) => server.listen(0, done));
  return { address: `http://localhost:${server.address().port}`, close: () => server.close() };
}

/** Draws, and returns frames, median and 95th percentile of the times from the oldest move that was not seen to the end of its frame. */
async function measure(page, rate) {
  const client = await page.context().newCDPSession(page);
  await client.send('Emulation.setCPUThrottlingRate', { rate });
  await timePaint(page);
  for (let k = 0; k < STROKES; k++) {
    const send = (type, i) => client.send('Input.dispatchMouseEvent', { type, x: 300 + 2.2 * i, y: 300 + 40 * k + 90 * Math.sin(i / 25),
      button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, pointerType: 'pen', force: 0.5, clickCount: 1 });
    await send('mousePressed', 0);
    for (let i = 1; i < SAMPLES; i++) {
      void send('mouseMoved', i);
      await rest(EVERY);
    }
    await send('mouseReleased', SAMPLES - 1);
    await rest(400);
  }
  const late = (await page.evaluate(() => globalThis.late)).sort((a, b) => a - b);
  return [late.length, late[late.length >> 1].toFixed(1), late[Math.floor(late.length * 0.95)].toFixed(1)];
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-ink-'));
const [browser, others] = await Promise.all([launch(), peers(folder)]);
console.log('| | share of the processor | frames | median, ms | 95 %, ms |\n|---|--:|--:|--:|--:|');
for (const rate of [1, 4]) {
  const server = await serve({ name: 'new.svg', bytes: EMPTY });
  const { page, context } = await open(browser, server.address);
  console.log(`| Batten | 1/${rate} | ${(await measure(page, rate)).join(' | ')} |`);
  await context.close();
  server.close();
  for (const name of ['excalidraw', 'tldraw']) {
    const other = await (await browser.newContext({ viewport: { width: 1544, height: 800 } })).newPage();
    await other.goto(`${others.address}/${name}.html`);
    await other.waitForFunction(() => globalThis.draw);
    await rest(2500); // until it has settled
    await other.evaluate(() => globalThis.draw());
    await rest(500);
    console.log(`| ${name} | 1/${rate} | ${(await measure(other, rate)).join(' | ')} |`);
    await other.context().close();
  }
}
await browser.close();
others.close();
fs.rmSync(folder, { recursive: true });
process.exit(0);
