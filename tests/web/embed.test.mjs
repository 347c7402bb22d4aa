// batten-editor, the element: packed, installed into a fresh project and used by a page with a strict policy. What somebody made
// is never lost: not when the element is removed, put elsewhere or given another drawing, nor when saving fails.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { bezier, downloaded, expectFaults, Hand, launch, quiet, SCREENSHOTS, settle } from './page.mjs';
import { EXAMPLE, MODULE } from './server.mjs';

const POLICY = "default-src 'none'; script-src 'self'; frame-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'";
/** Of a page whose editor is inside the script. */
const INSIDE = "default-src 'none'; script-src 'self' blob: 'wasm-unsafe-eval'; frame-src 'self' blob:; worker-src blob:; style-src blob:; font-src blob:; " +
  "connect-src 'self' blob:; img-src blob: data:; base-uri 'none'";
const TYPES = { html: 'text/html', js: 'text/javascript', css: 'text/css', svg: 'image/svg+xml', json: 'application/json', wasm: 'application/wasm',
  woff2: 'font/woff2' };
/** What a page that uses it has: elements are made by the tests, and what they tell is noted. */
const HOST = `import 'batten-editor';
globalThis.told = [];
globalThis.make = (attributes, where = document.body) => {
  const editor = document.createElement('batten-editor');
  for (const type of ['ready', 'change', 'error']) {
    editor.addEventListener(type, ({ detail }) => told.push([editor.id, type, detail.message ?? detail.svg.length]));
  }
  editor.addEventListener('save', (event) => {
    told.push([editor.id, 'save', event.detail.name]);
    globalThis.saved = event.detail.text;
    event.detail.waitUntil(globalThis.refuse ? Promise.reject(new Error(globalThis.refuse)) : Promise.resolve());
  });
  globalThis.served && editor.setAttribute('page', globalThis.served);
  Object.entries(attributes).forEach(([name, value]) => editor.setAttribute(name, value));
  where.append(editor);
  return editor;
};
document.documentElement.dataset.host = 'yes';
`;
const here = path.dirname(fileURLToPath(import.meta.url));
const project = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-embed-'));
const run = (command, ...args) => execFileSync(command, args, { cwd: project, encoding: 'utf8',
  env: { ...process.env, npm_config_cache: path.join(project, 'cache'), npm_config_update_notifier: 'false' } });
const SQUARE = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200"><path d="M50 50H250V150H50Z" fill="none" stroke="black"/></svg>';
const WAVE = bezier([60, 130], [140, 90], [220, 170], [320, 130]);

let browser;
let server;
let address;
before(async () => {
  execFileSync('cmake', ['--build', path.dirname(MODULE), '--target', 'npm']);
  run('npm', 'init', '-y');
  const packed = run('npm', 'pack', '--silent', path.join(path.dirname(MODULE), 'npm/batten-editor')).trim();
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', path.join(project, packed));
  fs.writeFileSync(path.join(project, 'host.js'), `globalThis.served = 'node_modules/batten-editor/page/';\n${HOST.replace("'batten-editor'", "'./node_modules/batten-editor/bare.js'")}`);
  fs.writeFileSync(path.join(project, 'index.html'), '<!doctype html><html lang="en"><title>Host</title><link rel="icon" href="data:,"><script type="module" src="host.js"></script><h1>A page</h1>');
  // A bundle of one script, as the first that every bundler makes, and nothing beside it.
  fs.mkdirSync(path.join(project, 'bundled'));
  fs.writeFileSync(path.join(project, 'bundle.js'), HOST);
  run('esbuild', 'bundle.js', '--bundle', '--outfile=bundled/host.js');
  fs.writeFileSync(path.join(project, 'bundled/index.html'), fs.readFileSync(path.join(project, 'index.html'), 'utf8').replace('type="module" src="host.js"', 'defer src="/bundled/host.js"'));
  fs.copyFileSync(EXAMPLE, path.join(project, 'car.svg'));
  fs.writeFileSync(path.join(project, 'square.svg'), SQUARE);
  server = http.createServer((request, response) => {
    const asked = new URL(request.url, 'http://x/').pathname.replace(/^\/bundled\/nothing\/.*/, '/bundled/'); // as dev servers do
    const file = path.join(project, asked.replace(/\/$/, '/index.html'));
    if (!file.startsWith(project) || !fs.existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    const own = !file.includes('batten-editor');
    response.writeHead(200, { 'Content-Type': TYPES[file.split('.').pop()], ...(own && { 'Content-Security-Policy': asked.startsWith('/bundled/') ? INSIDE : POLICY }) });
    response.end(fs.readFileSync(file));
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.closeAllConnections();
  server?.close();
  fs.rmSync(project, { recursive: true, force: true });
});

/** The page around, with an element. */
async function visit(attributes = { id: 'one', src: 'square.svg' }, where = '') {
  const context = await browser.newContext({ viewport: { width: 1000, height: 1200 }, acceptDownloads: true });
  const page = await context.newPage();
  await page.goto(address + where);
  await page.waitForSelector('html[data-host=yes]');
  const hand = new Hand(page, await context.newCDPSession(page));
  await page.evaluate((given) => { make(given); }, attributes);
  await said(page, attributes.id, 'ready');
  return { page, hand };
}

/** Waits until an element has told something so many times. */
const said = (page, id, type, times = 1) => page.waitForFunction(([who, what, count]) =>
  told.filter(([name, kind]) => name === who && kind === what).length >= count, [id, type, times]);
/** The editor's own window. */
async function inside(page, id = 'one') {
  const frame = await (await page.evaluateHandle((name) => document.getElementById(name).shadowRoot.querySelector('iframe'), id)).contentFrame();
  await frame.waitForSelector('html[data-ready=yes]');
  await quiet(frame);
  return frame;
}
/** Draws in the window of an element. */
async function draw(page, hand, id = 'one') {
  const frame = await inside(page, id);
  const [x, y] = await page.evaluate((name) => {
    const box = document.getElementById(name).getBoundingClientRect();
    return [box.left, box.top];
  }, id);
  const stage = await frame.evaluate(() => {
    const box = document.getElementById('stage').getBoundingClientRect();
    return [box.left, box.top];
  });
  await hand.stroke(WAVE.map(([a, b]) => [a + x + stage[0], b + y + stage[1]]));
  return frame;
}
const digest = (frame) => frame.evaluate(() => batten.engine.digest());
const of = (page, id, what) => page.evaluate(([name, member]) => document.getElementById(name)[member], [id, what]);
const paths = (svg) => svg.split('<path').length - 1;

test('from one script of a bundler, with nothing beside it: drawing, a worker, a reload; it never shows the page around it inside itself', async () => {
  const { page, hand } = await visit({ id: 'one', src: '../square.svg' }, 'bundled/');
  assert.equal(paths(await of(page, 'one', 'svg')), 1);
  const frame = await draw(page, hand);
  await said(page, 'one', 'change');
  const drawn = await digest(frame);
  assert.equal(paths(await page.evaluate(() => one.read())), 2);
  await frame.evaluate(() => { batten.files.leaving = true; location.reload(); });
  await said(page, 'one', 'ready', 2);
  assert.equal(await digest(await inside(page)), drawn);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'embed-inside.png') });
  // What takes long is read in a worker.
  await page.evaluate(() => one.save());
  await page.waitForFunction(() => !one.unsaved);
  const many = SQUARE.replace(/<path.*\/>/, (one) => one.repeat(20000));
  const [worker, opened] = await Promise.all([page.waitForEvent('worker'), page.evaluate((svg) => one.load(svg, 'many.svg'), many)]);
  assert.match(worker.url(), /^blob:/);
  assert.equal(opened, true);
  await page.evaluate(() => { make({ id: 'lost', page: 'nothing/' }); });
  await said(page, 'lost', 'error');
  assert.match(await page.evaluate(() => told.find(([id]) => id === 'lost')[2]), /serve the folder "page" of batten-editor/);
  assert.equal(await page.evaluate(() => document.getElementById('lost').shadowRoot.querySelector('iframe')), null);
  assert.equal(page.frames().length, 2, 'the page and one editor');
  await page.context().close();
});

test('it opens src, tells changes and saves to the page', async () => {
  const { page, hand } = await visit();
  const begun = await of(page, 'one', 'svg');
  assert.equal(paths(begun), 1);
  assert.equal(await of(page, 'one', 'unsaved'), false);
  const frame = await draw(page, hand);
  await said(page, 'one', 'change');
  const drawn = await of(page, 'one', 'svg');
  assert.equal(paths(drawn), 2);
  assert.equal(await of(page, 'one', 'unsaved'), true);
  assert.equal(await page.evaluate(() => one.read()), drawn);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'embed.png') });
  await page.evaluate(() => { globalThis.refuse = 'The disk is full.'; });
  await frame.locator('#stage').press('Control+S');
  await said(page, 'one', 'save');
  const refused = '[data-about=unsaved]:has-text("Not saved: The disk is full.")';
  await frame.waitForSelector(refused);
  assert.equal(await of(page, 'one', 'unsaved'), true, 'still unsaved');
  await page.evaluate(() => { globalThis.refuse = ''; return one.save(); });
  await said(page, 'one', 'save', 2);
  await page.waitForFunction(() => !one.unsaved);
  await frame.waitForSelector(refused, { state: 'detached' });
  assert.equal(await page.evaluate(() => saved), drawn);
  assert.equal(await page.evaluate(() => told.find(([, type]) => type === 'save')[2]), 'square.svg');
  // What it has written opens with every knot as it was.
  assert.equal(await page.evaluate((text) => one.load(text), drawn), true);
  assert.equal(await of(page, 'one', 'svg'), drawn);
  // Nothing of it stays in the browser.
  assert.deepEqual(await frame.evaluate(async () => [(await navigator.serviceWorker.getRegistrations()).length, (await caches.keys()).length,
    (await Array.fromAsync((await navigator.storage.getDirectory()).keys())).length]), [0, 0, 0]);
});

test('nobody takes what is saved: it is downloaded', async () => {
  const { page, hand } = await visit();
  await draw(page, hand);
  await page.evaluate(() => one.addEventListener('save', (event) => event.stopImmediatePropagation(), { capture: true }));
  const [download] = await Promise.all([page.waitForEvent('download'), page.evaluate(() => one.save())]);
  assert.equal(download.suggestedFilename(), 'square.svg');
  assert.equal(paths(String(await downloaded(download))), 2);
});

test('removed, put back and put elsewhere it goes on, with undo; two are apart', async () => {
  const { page, hand } = await visit();
  await page.evaluate(() => { make({ id: 'two', src: 'car.svg' }); });
  await said(page, 'two', 'ready');
  const [first, other] = [await digest(await inside(page)), await digest(await inside(page, 'two'))];
  let frame = await draw(page, hand);
  const drawn = await digest(frame);
  assert.notEqual(drawn, first);
  // At once after the stroke, before anything could be told.
  await page.evaluate(() => { globalThis.away = one; one.remove(); });
  await page.waitForFunction(() => away.svg.split('<path').length === 3);
  assert.equal(await page.evaluate(() => away.read()), await page.evaluate(() => away.svg));
  assert.equal(await page.evaluate(() => away.unsaved), true);
  await page.evaluate(() => document.body.append(away));
  await said(page, 'one', 'ready', 2);
  frame = await inside(page);
  assert.equal(await digest(frame), drawn);
  assert.equal(await frame.textContent('#name'), 'square.svg');
  await frame.locator('#stage').press('Control+Z');
  await settle(page);
  assert.equal(await digest(frame), first, 'undone');
  await frame.locator('#stage').press('Control+Shift+Z');
  await quiet(frame);
  // Into another place, in one step; and its frame loaded anew.
  await page.evaluate(() => {
    const box = document.body.appendChild(document.createElement('div'));
    box.append(one);
  });
  await said(page, 'one', 'ready', 3);
  assert.equal(await digest(await inside(page)), drawn);
  await (await inside(page)).evaluate(() => { batten.files.leaving = true; location.reload(); });
  await said(page, 'one', 'ready', 4);
  assert.equal(await digest(await inside(page)), drawn);
  assert.equal(await of(page, 'one', 'unsaved'), true);
  assert.equal(await digest(await inside(page, 'two')), other, 'the other is as it was');
  assert.equal(await of(page, 'two', 'unsaved'), false);
});

test('another src: what is unsaved stays unless the user agrees', async () => {
  const { page, hand } = await visit();
  const frame = await draw(page, hand);
  const drawn = await digest(frame);
  await page.evaluate(() => { one.src = 'car.svg'; });
  await frame.waitForSelector('dialog.question');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'embed-question.png') });
  assert.equal(paths(await page.evaluate(() => one.read())), 2, 'it can be read while the user is asked');
  await frame.locator('dialog.question').press('Escape');
  await frame.waitForSelector('dialog.question', { state: 'detached' });
  assert.equal(await digest(frame), drawn);
  const answer = page.evaluate(() => one.load('<svg xmlns="http://www.w3.org/2000/svg"/>', 'empty.svg'));
  await frame.waitForSelector('dialog.question');
  await frame.locator('dialog.question').press('Escape');
  assert.equal(await answer, false);
  // Saved: nobody is asked.
  await page.evaluate(() => one.save());
  await page.waitForFunction(() => !one.unsaved);
  assert.equal(await page.evaluate(() => one.load('<svg xmlns="http://www.w3.org/2000/svg"/>', 'empty.svg')), true);
  assert.equal(paths(await of(page, 'one', 'svg')), 0);
});

test('no src, one that is not there, one that is no drawing; no editor', async () => {
  expectFaults(/404/);
  const { page, hand } = await visit({ id: 'one' });
  assert.equal(paths(await of(page, 'one', 'svg')), 0);
  const frame = await draw(page, hand);
  const drawn = await digest(frame);
  await page.evaluate(() => { one.src = 'gone.svg'; });
  await said(page, 'one', 'error');
  assert.match(await page.evaluate(() => told.find(([, type]) => type === 'error')[2]), /gone\.svg.*404/);
  assert.match(await frame.textContent('#notice-text'), /gone\.svg.*404/);
  assert.equal(await digest(frame), drawn);
  await page.evaluate(() => { make({ id: 'two', src: 'gone.svg' }); });
  await said(page, 'two', 'ready');
  await said(page, 'two', 'error');
  await page.evaluate(() => two.load('not SVG at all', 'odd.svg'));
  await said(page, 'two', 'error', 2);
  assert.equal(paths(await of(page, 'two', 'svg')), 0);
  await page.evaluate(() => {
    globalThis.hasty = true;
    const words = document.createElement('p');
    words.append('No editor here.');
    make({ id: 'three', page: 'nowhere' }).append(words);
  });
  await said(page, 'three', 'error');
  assert.ok(await page.getByText('No editor here.').isVisible());
  await page.evaluate(() => { three.page = 'node_modules/batten-editor/page'; });
  await said(page, 'three', 'ready');
  assert.ok(await page.getByText('No editor here.').isHidden());
});

test('everything is in the package; it is imported where there is no page, and has types', () => {
  const folder = path.join(project, 'node_modules/batten-editor');
  assert.deepEqual(fs.readdirSync(folder).sort(), ['LICENSE', 'README.md', 'bare.d.ts', 'bare.js', 'element.js', 'index.d.ts', 'index.js', 'inside.js',
    'package.json', 'page', 'page.js']);
  assert.deepEqual(fs.readdirSync(path.join(folder, 'page')).filter((name) => !/^[0-9a-f]{16}$/.test(name)), ['index.html']);
  const [build] = fs.readdirSync(path.join(folder, 'page')).filter((name) => name !== 'index.html');
  // A dev server looks up every script that another names, also those that this page never asks for.
  const scripts = fs.readdirSync(path.join(folder, 'page', build), { recursive: true }).filter((name) => name.endsWith('.js'));
  assert.ok(scripts.length > 50);
  for (const name of scripts) {
    const text = fs.readFileSync(path.join(folder, 'page', build, name), 'utf8');
    assert.doesNotMatch(text, /new URL\(`[^`]*\$\{[^`]*`, *import\.meta\.url/, name);
    for (const [, named] of text.matchAll(/(?:\bfrom|\bimport\(?) *"(\.[^"]+)"/g)) {
      assert.ok(fs.existsSync(path.join(folder, 'page', build, path.dirname(name), named)), `${name}: ${named}`);
    }
  }
  assert.deepEqual(fs.readdirSync(path.join(folder, 'page', build, 'fonts')).sort(), ['OFL.txt', 'inter.woff2']);
  fs.writeFileSync(path.join(project, 'use.mjs'), "import { BattenEditor } from 'batten-editor';\nconsole.log(typeof BattenEditor);");
  assert.equal(run('node', 'use.mjs'), 'function\n');
  fs.writeFileSync(path.join(project, 'use.mts'), `import 'batten-editor';
const editor = document.querySelector('batten-editor')!;
editor.addEventListener('save', ({ detail }) => detail.waitUntil(fetch(editor.src, { method: 'PUT', body: detail.text })));
editor.addEventListener('change', (event) => event.detail.svg.length);
const open: Promise<boolean> = editor.load('<svg/>', 'a.svg');
// @ts-expect-error: it is loaded, not set
editor.svg = '';
export { open };`);
  run(path.join(here, 'node_modules/.bin/tsc'), '--noEmit', '--strict', '--target', 'es2022', '--module', 'nodenext', '--lib', 'es2022,dom', 'use.mts');
});
