// batten-core in Chromium, from a plain file server under a sub-path, with a strict policy: page, worker, canvas, and the same bits as
// under Node (for the same numbers: sines of the two may differ).
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, SCREENSHOTS } from '../web/page.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const home = path.join(root, 'build/wasm/npm');
const TYPES = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };
const PAGES = {
  '/some/where/index.html': '<!doctype html><meta charset="utf-8"><title>t</title><link rel="icon" href="data:,"><canvas width="400" height="200"></canvas><script type="module" src="main.js"></script>',
  '/some/where/main.js': `import { load } from './batten-core/index.js';
globalThis.b = await load();
globalThis.told = new Promise((done) => {
  new Worker('worker.js', { type: 'module' }).onmessage = ({ data }) => done(data);
});
globalThis.ready = true;`,
  '/some/where/worker.js': `import { load } from './batten-core/sketch.js';
const b = await load();
const live = b.live();
for (let x = 0; x < 60; x++) live.add(x, x * (60 - x) / 90);
postMessage(live.commit().toSVG());`,
};
let server;
let browser;

before(async () => {
  server = http.createServer((request, response) => {
    const file = request.url.replace('/some/where/', '');
    const text = PAGES[request.url] ?? (/^batten-core\/[\w.-]+$/.test(file) && fs.existsSync(path.join(home, file)) ? fs.readFileSync(path.join(home, file)) : null);
    response.writeHead(text === null ? 404 : 200, { 'content-type': TYPES[path.extname(request.url)] ?? 'text/plain',
      'content-security-policy': "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; img-src data:" });
    response.end(text);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server.close();
});

test('a page and a worker draw with it', async () => {
  const context = await browser.newContext({ viewport: { width: 420, height: 220 } });
  const page = await context.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/some/where/index.html`);
  await page.waitForFunction(() => globalThis.ready);
  const { text, inked } = await page.evaluate(() => {
    const context2d = document.querySelector('canvas').getContext('2d');
    const live = globalThis.b.live({ tolerance: 1 });
    for (let x = 20; x < 380; x += 3) {
      live.add(x, 40 + (x - 200) * (x - 200) / 300);
    }
    context2d.lineWidth = 3;
    context2d.stroke(live.preview().toPath2D());
    const alpha = (x, y) => context2d.getImageData(x, y, 1, 1).data[3];
    const curve = live.commit();
    return { text: curve.toSVG({ decimals: 17 }), inked: [alpha(200, 40), alpha(200, 170)] };
  });
  await page.screenshot({ path: path.join(SCREENSHOTS, 'batten-core.png') });
  assert.deepEqual(inked, [255, 0]);
  const b = await (await import(path.join(home, 'batten-core/index.js'))).load();
  const same = b.live({ tolerance: 1 });
  for (let x = 20; x < 380; x += 3) {
    same.add(x, 40 + (x - 200) * (x - 200) / 300);
  }
  assert.equal(same.commit().toSVG({ decimals: 17 }), text);
  assert.match(await page.evaluate(() => globalThis.told), /^M0 0C/);
});
