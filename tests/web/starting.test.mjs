// A start that fails: whatever is missing, wrong or late, the page says what, and Try again cures it when the server has it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { expectFaults, launch, ready, SCREENSHOTS, settle } from './page.mjs';
import { begun, exactly, forgotten, said, tryAgain, version } from './starting.mjs';

const WEB = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../web');
/** main.js and what it stands on; rooms.test.mjs compares the list with the imports. */
const MODULES = ['main.js', ...[...fs.readFileSync(path.join(WEB, 'index.html'), 'utf8').matchAll(/modulepreload" href="%BUILD%\/([^"]+)"/g)]
  .map(([, file]) => file)];

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** Of a page that has only begun there is no picture before its first frame. @param {string} name */
async function photograph(page, name) {
  await settle(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, name) });
}

for (const half of [0, 1]) {
  test(`each module that the page starts with is missing in turn, ${half + 1} of 2`, async (t) => {
    const { server, context } = await begun(t, browser, {}, false);
    assert.ok(MODULES.length > 30);
    const page = await context.newPage();
    for (const [i, file] of MODULES.filter((_, j) => j % 2 === half).entries()) {
      server.without = exactly(file);
      await page.goto(server.address, { waitUntil: 'commit' });
      assert.match(await said(page, file), /could not start/);
      if (file === 'main.js') {
        await photograph(page, 'starting-missing.png');
        await page.emulateMedia({ colorScheme: 'dark' });
        await photograph(page, 'starting-missing-dark.png');
      }
      server.without = /^$/;
      if (i % 6 === 0) {
        await tryAgain(page);
        await page.evaluate(() => { batten.files.leaving = true; });
      }
    }
  });
}

const spoils = {
  'main.js has a syntax error': ['main.js', 'let let = 1;', /SyntaxError/],
  'a module has a syntax error': ['engine/frame.js', 'export const = 1;', /SyntaxError/],
  'a module is of another build': ['page/icons.js', 'export const other = 1;', /SyntaxError/],
  'a module throws': ['stage/theme.js', 'export const Theme = null.theme;', /TypeError/],
  'a module is some page': ['page/words.js', '<!doctype html><title>Not found</title>', /SyntaxError/],
  'the module does not compile': ['batten.wasm', 'not wasm', /CompileError/],
  'the module is empty': ['batten.wasm', '', /CompileError/],
};

for (const [what, [file, bytes, reason]] of Object.entries(spoils)) {
  test(`${what}: said, and cured`, async (t) => {
    const { server, context } = await begun(t, browser, {}, false);
    expectFaults(/^uncaught/, /^Uncaught/, /^SyntaxError/, /^TypeError/, /^CompileError/);
    const page = await context.newPage();
    server.spoil = (name, body) => (name === file ? Buffer.from(bytes) : body);
    await page.goto(server.address);
    assert.match(await said(page), reason);
    await photograph(page, `starting-${what.replaceAll(/\W+/g, '-')}.png`);
    server.spoil = (name, body) => body;
    await tryAgain(page);
  });
}

for (const file of ['batten.wasm', 'icons/sprite.svg']) {
  test(`${file} is not there: said, and cured`, async (t) => {
    const { server, context } = await begun(t, browser);
    expectFaults(/^uncaught/, /^Missing/, /^TypeError/);
    const page = await context.newPage();
    server.without = exactly(file);
    await page.goto(server.address);
    await said(page, file);
    server.without = /^$/;
    await tryAgain(page);
    await forgotten(page); // its worker has come, too
  });
}

test('nothing of the build is there: said without a style sheet', async (t) => {
  const { server, context } = await begun(t, browser, { viewport: { width: 390, height: 844 } }, false);
  const page = await context.newPage();
  server.without = /^(?!index\.html)/;
  await page.goto(server.address);
  assert.match(await said(page), /could not start[^]*시작할 수 없습니다/);
  await photograph(page, 'starting-nothing.png');
  server.without = /^$/;
  await tryAgain(page);
});

test('a style sheet is not there: the page says that a part is missing', async (t) => {
  const { server, context } = await begun(t, browser, {}, false);
  expectFaults(/^Missing/);
  const page = await context.newPage();
  server.without = exactly('styles/sheets.css');
  await page.goto(server.address);
  await page.waitForSelector('[data-about=missing] >> text=Part of Batten');
  assert.equal(await page.isVisible('#failed'), false);
});

/** Runs in a page: the timers that wait for seconds are over soon. */
function hasten() {
  const later = globalThis.setTimeout;
  globalThis.setTimeout = (run, delay = 0, ...values) => later(run, delay >= 2000 ? 300 : delay, ...values);
}

for (const [what, file] of [['a module that does not come', 'page/words.js'], ['the module that does not come', 'batten.wasm']]) {
  test(`${what}: it takes long, and the page says so until it is there`, async (t) => {
    const { server, context } = await begun(t, browser, {}, false);
    await context.addInitScript(hasten);
    const page = await context.newPage();
    let go = () => {};
    const come = new Promise((resolve) => { go = resolve; });
    await page.route(`**/${file}`, async (route) => {
      await come;
      await route.continue();
    });
    await page.goto(server.address, { waitUntil: 'commit' });
    assert.match(await said(page), /taking long[^]*오래/);
    assert.doesNotMatch(await said(page), /could not start/);
    if (file === 'batten.wasm') { // before its scripts are there a page can not be photographed
      await photograph(page, 'starting-late.png');
    }
    go();
    await ready(page);
    assert.equal(await page.isVisible('#failed'), false);
  });
}

test('a script that does nothing: it takes long, and Try again helps', async (t) => {
  const { server, context } = await begun(t, browser, {}, false);
  await context.addInitScript(hasten);
  const page = await context.newPage();
  server.spoil = (name, body) => (name === 'main.js' ? Buffer.alloc(0) : body);
  await page.goto(server.address);
  assert.match(await said(page), /taking long/);
  server.spoil = (name, body) => body;
  await tryAgain(page);
});

test('a new visitor to a page that is older than its files: said, and cured when it is not', async (t) => {
  const { server, context } = await begun(t, browser);
  server.version = '2';
  server.stale = { 'index.html': '1' };
  const page = await context.newPage();
  await page.goto(server.address);
  assert.match(await said(page), /could not start/);
  server.stale = {};
  await tryAgain(page);
  assert.equal(await version(page), '2');
});

test('a server that does not know what a .wasm file is', async (t) => {
  const { server, context } = await begun(t, browser, {}, false);
  await context.route('**/*.wasm', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), 'content-type': 'application/octet-stream' } });
  });
  const page = await context.newPage();
  await page.goto(server.address);
  await ready(page);
  await page.evaluate(() => batten.engine.module.complete());
  assert.equal(await page.locator('[data-about=missing]').count(), 0);
});
