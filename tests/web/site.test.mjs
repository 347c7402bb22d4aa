// The site: the editor as a static host serves it, from Python's file server under a sub-path. No request leaves its
// folder; its policy, which no header sends, is obeyed (page.mjs counts what it refuses as errors); it opens offline.
// The ghost pen leaves nothing in the drawing. The race fetches its two libraries, and no other page does.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import zlib from 'node:zlib';
import { bezier, expectFaults, Hand, launch, place, quiet, ready, SCREENSHOTS, state, until } from './page.mjs';
import { PROGRAM } from './server.mjs';
import { buildSite, ROOT, serveSite, SITE } from './static.mjs';

let browser;
let site;
before(async () => {
  buildSite();
  [browser, site] = await Promise.all([launch(), serveSite()]);
});
after(async () => {
  await browser.close();
  await site.close();
});

/** A page of the site; every request of it is noted, and must stay in the folder. */
async function visit(address = '', options = {}, host = site) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const asked = [];
  context.on('request', (request) => asked.push(request.url()));
  const page = await context.newPage();
  const open = async (where) => {
    await page.goto(host.address + where);
    await ready(page);
    await page.waitForFunction(() => globalThis.race ?? batten.painter.painted);
  };
  await open(address);
  const stays = () => assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(host.address)), []);
  return { context, page, asked, open, stays, hand: new Hand(page, await context.newCDPSession(page)) };
}

const turn = (page) => page.waitForSelector('html[data-turn=yes]');
const lines = (page) => page.evaluate(() => new TextDecoder().decode(batten.engine.journal).trim().split('\n').length);
const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const ROOF = bezier([388, 176], [460, 90], [700, 60], [842, 169]);
const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `site-${name}.png`) });

test('two sites of one origin leave each other their caches', async (t) => {
  const own = await serveSite();
  t.after(() => own.close());
  const { page, open } = await visit('', {}, own);
  const active = () => page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  const names = () => page.evaluate(async () => (await caches.keys()).sort());
  await active();
  const [first] = await names();
  assert.ok(first.startsWith(`batten ${own.address} `));
  // What an earlier build of the other has left goes when the other becomes active; what is of this one stays.
  await page.evaluate((other) => caches.open(`batten ${other} 0123456789abcdef`), own.other);
  await page.evaluate(() => batten.pack());
  await page.goto(own.other);
  await ready(page);
  await active();
  assert.deepEqual(await names(), [first.replace(own.address, own.other), first].sort());
  await page.evaluate(() => batten.pack());
  expectFaults(/ERR_CONNECTION_REFUSED/, /Failed to fetch/);
  await own.close();
  await open(''); // without the server
});

test('a tab of the band stays under the pointer that comes down on it, though that stops the ghost, and opens in the page', async () => {
  for (const [viewport, locale, other] of [[{ width: 1280, height: 800 }, 'en', 'flight'], [{ width: 390, height: 780 }, 'ko-KR', 'crocodile']]) {
    const { page, context } = await visit('', { viewport, locale });
    await page.waitForSelector('.ghost-pen', { state: 'attached' });
    await page.evaluate(() => { globalThis.same = true; });
    const boxes = () => page.$$eval('.front nav a', (all) => all.map((link) => JSON.stringify(link.getBoundingClientRect())));
    const before = await boxes();
    assert.equal(before.length, 4);
    assert.equal(await page.evaluate(() => document.querySelector('.front').offsetHeight), 57, 'with its edge');
    const link = await page.locator(`.front a[href*=${other}]`).boundingBox();
    await page.mouse.move(link.x + link.width / 2, link.y + link.height / 2);
    await page.mouse.down();
    await turn(page);
    assert.deepEqual(await boxes(), before);
    await page.mouse.up();
    await page.waitForFunction((name) => batten.files.name === `${name}.svg`, other);
    await page.waitForSelector(`.front a[href*=${other}][aria-current]`);
    assert.deepEqual(await boxes(), before);
    assert.equal(await page.evaluate(() => globalThis.same), true, 'without another page');
    if (other === 'flight') { // it flies by itself
      await page.waitForSelector('.time:not([hidden])');
    }
    await context.close();
  }
});

test('after what was tried the next thing is offered beside it, from the car to a drawing of one\'s own', async () => {
  const { page, hand, stays } = await visit('', { reducedMotion: 'reduce' });
  const next = page.locator('.told .then button').first();
  await turn(page);
  await hand.stroke(await on(page, ROOF));
  await page.waitForSelector('.told[style*=top]');
  assert.match(await page.textContent('.told p'), /It followed/);
  const [[card], others] = await Promise.all(['.told', '.chips, .dial, .front'].map((which) =>
    page.$$eval(which, (all) => all.map((one) => one.getBoundingClientRect().toJSON()))));
  for (const box of others) {
    assert.ok(card.right <= box.left || card.left >= box.right || card.bottom <= box.top || card.top >= box.bottom, JSON.stringify([card, box]));
  }
  await shot(page, 'followed');
  await next.click();
  await page.waitForFunction(() => batten.files.name === 'crocodile.svg');
  await page.waitForFunction(() => /Your turn: pull/.test(document.querySelector('.told p').textContent));
  assert.equal(await page.evaluate(() => glance().canUndo), false);
  const [back, higher] = await on(page, [[500, 172], [510, 120]]);
  await hand.stroke([back, back]);
  await hand.stroke(bezier(back, back, higher, higher));
  await page.waitForFunction(() => /Now in 3D/.test(document.querySelector('.told p').textContent));
  await next.click();
  await page.waitForFunction(() => batten.files.name === 'sculpt.svg' && batten.loop.space?.counts.painted);
  await quiet(page);
  await hand.stroke(bezier([290, 400], [420, 460], [600, 500], [800, 420]));
  await page.waitForFunction(() => /Now fly/.test(document.querySelector('.told p').textContent));
  await shot(page, 'sculpted');
  // What was changed is kept; a closed band stays closed.
  await page.click('.front button');
  await page.evaluate(() => batten.pack());
  await page.goto('about:blank');
  await page.goto(`${site.address}#play=demos/car.journal`);
  await ready(page);
  await turn(page);
  assert.equal(await page.locator('.front').count(), 0);
  assert.ok((await page.evaluate(async () => (await batten.drawings.list()).map(({ name }) => name))).includes('crocodile.svg'));
  stays();
});

test('the editor is the front page; a touch stops the ghost, which leaves nothing; it opens offline', async (t) => {
  const own = await serveSite();
  t.after(() => own.close());
  const { page, asked, open, stays, hand } = await visit('', {}, own);
  assert.equal(await page.textContent('#name'), 'car.svg');
  assert.match(await page.getAttribute('meta[http-equiv=Content-Security-Policy]', 'content'), /default-src 'none'/);
  await page.waitForSelector('.ghost-pen.down', { state: 'attached' });
  const before = await state(page);
  await shot(page, 'ghost');
  // The touch that stops it draws at once: the visitor's stroke, and only that, is in the history.
  await hand.stroke(await on(page, ROOF));
  assert.equal(await page.locator('.ghost').count(), 0);
  assert.match(await page.textContent('.told p'), /It followed/);
  assert.notEqual((await state(page)).digest, before.digest);
  await page.keyboard.press('Control+Z');
  assert.equal((await state(page)).digest, before.digest);
  assert.equal(await page.evaluate(() => glance().canUndo), false);
  assert.equal(await lines(page), 3, 'the drawing, the stroke, undo');
  await page.keyboard.press('Control+Shift+Z');
  const drawn = (await state(page)).digest;
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  await page.evaluate(() => batten.engine.set('tolerance', 2));
  await page.evaluate(() => batten.wake());
  await page.waitForFunction(() => JSON.parse(localStorage.getItem('batten-settings') ?? '{}').values?.tolerance === 2);
  await page.evaluate(() => batten.pack());
  stays();
  assert.deepEqual(asked.filter((url) => url.includes('/peers/')), []);

  // Without its server: the drawing as it was left, then the drawings to begin with.
  expectFaults(/ERR_CONNECTION_REFUSED/, /Failed to fetch/, /ERR_FAILED .*\/peers\//);
  await own.close();
  await open('');
  assert.equal((await state(page)).digest, drawn, 'kept as today');
  await page.waitForFunction(() => document.fonts.check('13px "Batten-Inter"') && document.fonts.size === 1);
  assert.equal(await page.evaluate(() => batten.engine.get('tolerance')), 2, 'settings, too');
  await page.evaluate(() => batten.pack());
  await open('race.html');
  assert.equal(await page.locator('tbody tr').count(), 1);
  assert.equal(await page.isVisible('#missing'), true);
});

test('the licence of the type face is beside it', () => {
  const [fonts] = fs.readdirSync(SITE).map((name) => path.join(SITE, name, 'fonts')).filter((folder) => fs.existsSync(folder));
  assert.deepEqual(fs.readdirSync(fonts).sort(), ['OFL.txt', 'inter.woff2']);
});

test('what the page loads first is small', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  const answers = new Map();
  page.on('response', (response) => answers.set(response.url(), response));
  await page.addInitScript(() => new MutationObserver(() => performance.mark('ready'))
    .observe(document, { subtree: true, attributeFilter: ['data-ready'] }));
  await page.goto(site.address);
  await ready(page);
  const early = await page.evaluate(() => performance.getEntriesByType('resource')
    .filter((entry) => entry.startTime < performance.getEntriesByName('ready')[0].startTime).map((entry) => entry.name));
  const once = new Set([site.address, ...early]); // the second time the browser has it: a transfer of 0 bytes
  const sizes = await Promise.all([...once].map(async (url) =>
    zlib.gzipSync(await answers.get(url).body(), { level: 9 }).length));
  const total = sizes.reduce((sum, size) => sum + size, 0);
  console.log(`first load of the site: ${total} bytes gzip, ${sizes.length} files`);
  assert.ok(sizes.length > 20 && total < 200000, `${total}`);
});

test('less motion: it waits to be asked; a ghost drags the crocodile and gives it back', async () => {
  const { page, stays } = await visit('#play=demos/crocodile.journal', { reducedMotion: 'reduce', viewport: { width: 390, height: 844 } });
  await turn(page);
  assert.equal(await page.locator('.ghost').count(), 0);
  const before = (await state(page)).digest;
  await page.click('.told button');
  await page.waitForSelector('.ghost-pen.down', { state: 'attached' });
  assert.notEqual(await page.evaluate(() => front.ghost.engine.digest()), undefined);
  await page.evaluate(() => { front.ghost.length = 0; });
  await page.waitForFunction(() => !document.querySelector('.ghost'));
  assert.equal((await state(page)).digest, before);
  assert.match(await page.textContent('.told p'), /pull the back or the tail/);
  await shot(page, 'crocodile');
  stays();
});

/** The manual without its moving pictures, once. */
let manual = () => {
  execFileSync('/usr/bin/python3', ['-B', path.join(ROOT, 'tools/site/manual.py'), PROGRAM, path.join(SITE, 'manual'), '--bare']);
  manual = () => {};
};

test('a reader of the manual bends the crocodile of a paper, and sees a figure redone by hand', async () => {
  manual();
  const { page, hand, stays } = await visit();
  await page.goto(`${site.address}manual/index.html`);
  const begun = performance.now();
  await page.click('nav summary:text-is("The papers")');
  await page.click('nav a:has-text("Sweep and detail apart")');
  await page.click('h2:has-text("Figure 7") ~ p a:text-is("Open it in the editor")');
  await ready(page);
  await page.waitForFunction(() => batten.files.name === 'examples-papers-2016-7.batten');
  console.log(`from the manual's contents to the crocodile: ${Math.round(performance.now() - begun)} ms`);
  const before = (await state(page)).digest;
  await page.keyboard.press('t');
  const drawing = JSON.parse(fs.readFileSync(path.join(ROOT, 'examples/papers/2016-7.batten'), 'utf8'));
  const ask = (input, ...words) => JSON.parse(execFileSync(PROGRAM, words, { input: JSON.stringify(input), encoding: 'utf8' }));
  const outline = ask(ask(drawing.objects[0].curves[0], 'levels', '-').curves.at(-1), 'eval', '-', '--samples', '2000').points;
  const [x, y] = outline.reduce((best, point) => (point[1] < best[1] ? point : best)); // the top of the back
  const [back, higher] = await on(page, [[x, y], [x, y - 40]]);
  await hand.stroke([back, back]);
  await hand.stroke(bezier(back, back, higher, higher));
  await page.waitForFunction((before) => batten.engine.digest() !== before, before);
  await shot(page, 'crocodile-bent');
  await page.goto(`${site.address}manual/papers/tangents-1994.html`);
  await page.click('h2:has-text("Figure 5") ~ p a:text-is("See it redone by hand")');
  await turn(page);
  assert.match(await page.textContent('.told p'), /change it/);
  await page.click('.told button'); // again
  await page.waitForSelector('.ghost', { state: 'attached' });
  assert.match(await page.textContent('.told p'), /redoes the figure/);
  stays();
});

test('each page of Learn opens its session in the editor, and once it was seen without a network, too', async (t) => {
  manual();
  const own = await serveSite();
  t.after(() => own.close());
  const { page, stays } = await visit('', {}, own);
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  const learn = async (name, seen = async () => {}) => {
    await page.goto(`${own.address}manual/learn/${name}.html`);
    await seen();
    await page.click('a.button:text-is("Open this in the editor")');
    await page.waitForURL(/#play=/);
    await ready(page);
    assert.match(await page.evaluate(() => batten.files.name), new RegExp(`^${name}`));
  };
  for (const name of ['draw', 'levels', 'tangents', 'surfaces']) {
    await learn(name);
  }
  await learn('camera', () => until(page, async () => Boolean(await caches.match('camera.journal'))));
  stays();
  expectFaults(/ERR_CONNECTION_REFUSED/, /Failed to fetch/);
  await own.close();
  await learn('camera');
});

test('the manual answers what people ask: of 40 questions at least 36 by the first page that it finds', async () => {
  manual();
  const { page, stays } = await visit();
  await page.goto(`${site.address}manual/index.html`);
  const questions = JSON.parse(fs.readFileSync(path.join(ROOT, 'tests/web/questions.json'), 'utf8'));
  const answers = await page.evaluate((asked) => Promise.all(asked.map((question) => manualSearch(question))), questions.map(([question]) => question));
  const missed = questions.filter(([, wanted], i) => !new RegExp(`^(${wanted})`).test(answers[i][0] ?? '')).map(([question]) => question);
  console.log(`of ${questions.length} questions to the manual not answered first: ${missed.join('; ')}`);
  assert.ok(questions.length - missed.length >= 36, missed.join('; '));
  await page.fill('#search', 'undo');
  await page.click('#found a');
  await page.waitForURL(/commands\.html#command-undo/);
  await shot(page, 'commands');
  stays();
});

test('the study: two tasks in turn, timed, with the error that the program measures, as a line of CSV', async () => {
  const { page, hand, stays } = await visit('#study=demos/sketch.journal');
  const shown = page.locator('.told p');
  const ways = [];
  for (const task of [1, 2]) {
    await page.waitForFunction((task) => new RegExp(`Task ${task} of 2`).test(document.querySelector('.told p')?.textContent ?? ''), task);
    ways.push(/points/.test(await shown.textContent()) ? 'points' : 'sketch');
    assert.equal(await page.locator('.told button').count(), 0, 'Done is offered once something was drawn');
    await hand.stroke(await on(page, bezier([300, 180], [420, 120], [520, 120], [640, 180])));
    await page.waitForSelector('.told button');
    const native = await page.evaluate(() => new TextDecoder().decode(batten.engine.save(true)));
    const measured = Number(execFileSync('/usr/bin/python3', ['-c',
      'import json, sys; sys.path.insert(0, sys.argv[1]); import measure; print(measure.greatest_error(json.load(sys.stdin)))',
      path.join(ROOT, 'examples/silhouette')], { input: native, encoding: 'utf8' }));
    const said = Number(/at most ([\d.]+) px/.exec(await shown.textContent())[1]);
    if (JSON.parse(native).objects.length === 4) { // the stroke changed the line and made no other
      assert.ok(Math.abs(said - measured) < 0.2, `${said}, measured ${measured}`);
    }
    await shot(page, `study-${task}`);
    await page.click('.told button');
  }
  assert.deepEqual([...ways].sort(), ['points', 'sketch']);
  await page.waitForFunction(() => document.querySelectorAll('.told button').length === 3);
  await shot(page, 'study-results');
  const line = await page.evaluate(async () => (await import(document.querySelector('script[src*="site/front.js"]').src.replace('front.js', 'study.js'))).lineOf(study.state));
  assert.match(line, new RegExp(`^\\d{4}-\\d\\d-\\d\\d,${ways[0]},[\\d.]+,[\\d.]+,[\\d.]+,[\\d.]+,pen\\+pen$`));
  stays();
});

test('#open= and #journal=, of this server alone', async () => {
  const { page, stays } = await visit('#journal=demos/car.journal');
  assert.equal(await page.evaluate(() => batten.engine.digest()), await page.evaluate(async () => {
    const bytes = new Uint8Array(await (await fetch('demos/car.journal')).arrayBuffer());
    batten.engine.replay(bytes);
    return batten.engine.digest();
  }));
  assert.equal(await page.evaluate(() => glance().canUndo), true);
  await page.evaluate(() => { globalThis.before = true; location.hash = '#open=demos/car.svg'; });
  await page.waitForFunction(() => !globalThis.before && globalThis.batten?.files.name === 'car.svg' && document.documentElement.dataset.ready === 'yes');
  await page.evaluate(() => { location.hash = '#open=https://example.org/car.svg'; });
  await page.waitForFunction(() => /example\.org/.test(document.getElementById('notice-text')?.textContent ?? ''));
  stays();
});

test('the race counts three fits of a stroke', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, hand, stays, asked } = await visit('race.html', { colorScheme });
    await page.waitForFunction(() => document.querySelectorAll('tbody tr').length === 3);
    assert.equal(asked.filter((url) => /\/peers\/[\w.-]+\.js$/.test(url)).length, 2);
    const box = await page.locator('#canvas').boundingBox();
    await hand.stroke(bezier([box.x + 60, box.y + 250], [box.x + 200, box.y - 40], [box.x + 420, box.y + 460], [box.x + 700, box.y + 60]), { pointerType: 'mouse' });
    await quiet(page);
    const rows = await page.$$eval('tbody tr', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map(([name]) => name), ['Batten', 'fit-curve', 'paper.js']);
    for (const [, pieces, points, error] of rows) {
      assert.ok(Number(pieces) >= 1 && Number(pieces) < 40 && Number(points) > Number(pieces), `${rows}`);
      assert.ok(Number(error) > 0 && Number(error) < 4, `${rows}`);
    }
    await shot(page, `race-${colorScheme}`);
    const ring = Array.from({ length: 60 }, (_, i) => [box.x + 440 + 260 * Math.cos(i / 9.4), box.y + 180 + 130 * Math.sin(i / 9.4)]);
    await hand.stroke(ring, { pointerType: 'mouse' });
    await quiet(page);
    const [[pieces, , error]] = await page.$$eval('tbody tr', (all) => all.map((row) => [...row.children].slice(1).map((cell) => Number(cell.textContent))));
    assert.ok(pieces >= 2 && error > 0 && error < 4, `a closed stroke: ${pieces} pieces, ${error} px`);
    stays();
  }
});
