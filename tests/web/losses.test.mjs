// What overwriting a file would lose: reported when it is opened, listed at any time, asked about before the first save
// that would lose it, and not mentioned when nothing would be lost.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, downloaded, expectFaults, launch, open, pictures, place, quiet, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { edit, EXAMPLE, serve } from './server.mjs';

/** A file whose elements are not all in its text cannot be kept as it is. */
const ART = `<!DOCTYPE svg [<!ENTITY e "<g/>">]><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300"><title>Art</title>&e;
  <pattern id="g" width=".2" height=".2"><rect width="9" height="9" fill="#00f"/></pattern>
  <rect id="box" x="40" y="60" width="120" height="90" fill="url(#g)"/><text x="20" y="40">Hello</text><text>again</text>
  <path d="M200 80C240 20 300 140 360 80" fill="none" stroke="#070" stroke-width="4" stroke-dasharray="9 five"/></svg>`;
const LINE = bezier([60, 220], [140, 200], [220, 250], [340, 220]);

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const art = () => serve({ name: 'art.svg', bytes: Buffer.from(ART) });
const draw = async (page, hand) => hand.stroke(await Promise.all(LINE.map(([x, y]) => place(page, x, y))));
const saved = (server, count) => new Promise((done) => {
  const look = () => (server.saves >= count ? done() : setTimeout(look, 20));
  look();
});

/** Presses Ctrl+S and waits for the question. */
async function ask(page) {
  await page.keyboard.press('Control+S');
  await page.waitForSelector('#lossy[open]');
}

test('asked once, before the first save that would lose something', async (t) => {
  const server = await art();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  assert.equal((await state(page)).notice, "5 items in this file can't be kept.");
  assert.equal(await page.textContent('#unkept'), '5 not kept');
  await draw(page, hand);

  await ask(page);
  assert.equal(server.saves, 0);
  assert.deepEqual(await page.$$eval('#lossy button', (all) => all.map((one) => one.textContent)),
    ['Save a copy', 'Save without 5 items', 'Cancel']);
  assert.deepEqual(await page.$$eval('#lossy li', (all) => all.map((one) => one.textContent)),
    ['Texts 2', 'Patterns 1', 'Dashed strokes 1', 'Titles or descriptions 1']);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Save a copy');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#lossy', { state: 'detached' });
  assert.equal(server.saves, 0);
  assert.equal((await state(page)).unsaved, true);

  await ask(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  assert.match(String(await downloaded(download)), /<svg/);
  assert.equal(server.saves, 0);
  assert.equal(server.bytes.toString(), ART);
  assert.equal((await state(page)).unsaved, true, 'the file is not saved');

  await ask(page);
  await page.click('#lossy button[value=lose]');
  await saved(server, 1);
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(server.bytes.toString(), /batten:document/);
  assert.equal(await page.isVisible('#unkept'), false);

  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(server, 2);
  assert.equal(await page.isVisible('#lossy'), false, 'there is nothing left to lose');
  await page.reload();
  await ready(page);
  assert.equal(await page.isVisible('#unkept'), false);
  await context.close();
});

/** What the transform lays flat cannot leave its line in this file. */
const FLAT = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><!-- by hand --><g transform="matrix(1 0 0 0 0 60)">
  <path id="flat" fill="none" stroke="#000" d="M60 0C140 20 220 100 320 60"/></g></svg>`;
const BOW = bezier([80, 62], [160, 90], [230, 90], [300, 61]);

test('a kept file is not written anew without asking', async (t) => {
  const server = await serve({ name: 'flat.svg', bytes: Buffer.from(FLAT) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await Promise.all(BOW.map(([x, y]) => place(page, x, y))));
  for (const choice of ['', 'copy']) {
    await page.keyboard.press('Control+S');
    await page.waitForSelector('#anew[open]');
    assert.match(await page.textContent('#anew-text'), /“flat.svg”.*rewritten/);
    if (choice) {
      await page.screenshot({ path: path.join(SCREENSHOTS, 'anew.png') });
      const [download] = await Promise.all([page.waitForEvent('download'), page.click('#anew button[value=copy]')]);
      assert.match(String(await downloaded(download)), /<path/);
    } else {
      await page.keyboard.press('Escape');
    }
    await page.waitForSelector('#anew', { state: 'detached' });
    assert.equal(server.bytes.toString(), FLAT);
    assert.equal((await state(page)).unsaved, true);
  }
  await page.keyboard.press('Control+S');
  await page.click('#anew button[value=save]');
  await saved(server, 1);
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.doesNotMatch(server.bytes.toString(), /by hand/);
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(server, 2);
  assert.equal(await page.isVisible('#anew'), false, 'asked once');
  await context.close();
});

/** Two objects that do not look as they do in the file; a line that does. */
const BLENDED = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><path id="road" d="M20 220H300" stroke="#333" stroke-width="6" fill="none"/>
  <path id="hill" d="M40 230Q100 60 200 230" fill="#c84" style="mix-blend-mode:multiply"/>
  <path id="fence" d="M20 240H300" stroke="#070" stroke-width="4" stroke-dasharray="9 five" fill="none"/></svg>`;

test('each object that does not look as in the file is named, and the first save asks once', async (t) => {
  const server = await serve({ name: 'hill.svg', bytes: Buffer.from(BLENDED) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await page.mouse.move(400, 400);
  await page.waitForFunction(() => batten.mirror); // its texts have loaded
  await page.click('#unkept');
  await page.waitForSelector('#losses:popover-open');
  assert.deepEqual(await page.$$eval('#unshown li', (all) => all.map((one) => one.textContent)),
    ['hill, curve Blend modes', 'fence, curve Dashed strokes']);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'unshown.png') });
  await page.click('#unshown li:nth-child(2) button');
  await settle(page);
  const rows = await page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 10)).rows);
  assert.deepEqual(rows.map(({ selected }) => selected), [false, false, true], 'the row of an object chooses it');
  assert.match(rows[2].words, /^fence.*looks different here$/);
  assert.doesNotMatch(rows[0].words, /not shown/);
  await page.keyboard.press('Escape');
  await draw(page, hand);

  await page.keyboard.press('Control+S');
  await page.waitForSelector('#inexact[open]');
  assert.deepEqual(await page.$$eval('#inexact button', (all) => all.map((one) => one.textContent)),
    ['Save', 'Save a copy', 'Cancel']);
  assert.deepEqual(await page.$$eval('#inexact li', (all) => all.map((one) => one.textContent)),
    ['hill, curve Blend modes', 'fence, curve Dashed strokes']);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'inexact.png') });
  await page.keyboard.press('Escape');
  await page.waitForSelector('#inexact', { state: 'detached' });
  assert.equal(server.saves, 0, 'nothing was decided');

  await page.keyboard.press('Control+S');
  await page.waitForSelector('#inexact[open]');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#inexact button[value=copy]')]);
  assert.match(String(await downloaded(download)), /mix-blend-mode:multiply/);
  assert.equal(server.saves, 0);
  assert.equal(server.bytes.toString(), BLENDED);

  await page.keyboard.press('Control+S');
  await saved(server, 1);
  assert.match(server.bytes.toString(), /mix-blend-mode:multiply"/);
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(server, 2);
  assert.equal(await page.isVisible('#inexact'), false, 'asked once');
  await context.close();
});

test('the question and the list in Korean', async (t) => {
  const server = await serve({ name: 'hill.svg', bytes: Buffer.from(BLENDED) });
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address, { locale: 'ko-KR' });
  await page.mouse.move(400, 400);
  await page.waitForFunction(() => batten.mirror);
  await page.keyboard.press('Control+S');
  await page.waitForSelector('#inexact[open]');
  assert.match(await page.textContent('#inexact-text'), /^“hill.svg”에는 .*다르게 보이는 것이 있습니다/);
  assert.deepEqual(await page.$$eval('#inexact li', (all) => all.map((one) => one.textContent)),
    ['hill, 곡선 혼합 모드', 'fence, 곡선 점선']);
  await page.click('#inexact button[value=save]');
  await saved(server, 1);
  assert.equal(server.bytes.toString(), BLENDED);
  await context.close();
});

test('what is not shown is kept by saving', async (t) => {
  const kept = ART.replace(/^.*\]>/, '').replace('&e;', '');
  const server = await serve({ name: 'art.svg', bytes: Buffer.from(kept) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  assert.equal((await state(page)).notice, '1 item looks different here; saving keeps it.');
  assert.equal(await page.textContent('#unkept'), '1 approximated');
  await page.keyboard.press('Control+S');
  await page.click('#inexact button[value=save]');
  await saved(server, 1);
  assert.equal(server.bytes.toString(), kept);
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(server, 2);
  const now = server.bytes.toString();
  for (const line of kept.split('\n').slice(1)) {
    assert.ok(now.includes(line.replace('</svg>', '')), line);
  }
  assert.match(now, /<path style="[^>]*\/><\/svg>$/); // a pen's line is as wide as it was pressed
  await page.reload();
  await ready(page);
  assert.equal(await page.textContent('#unkept'), '1 approximated');
  await context.close();
});

test('never asked when nothing is lost', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  assert.equal(await page.isVisible('#unkept'), false);
  await hand.stroke(await Promise.all(LINE.map(([x, y]) => place(page, x, y))));
  await page.keyboard.press('Control+S');
  await saved(server, 1);
  await page.waitForFunction(() => !document.getElementById('notice').hidden); // "Saved": the page knows it too
  await page.evaluate(() => batten.engine.command('losses') && batten.wake());
  await settle(page);
  assert.equal((await state(page)).notice, 'Saving keeps everything in the file');
  await context.close();
});

test('with the program\'s own server', async (t) => {
  const program = await edit(Buffer.from(ART), 'art.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await draw(page, hand);
  await ask(page);
  assert.equal(program.bytes.toString(), ART);
  await page.click('#lossy button[value=lose]');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(program.bytes.toString(), /batten:document/);
  await context.close();
});

test('the list is there at any time, in the language in force', async (t) => {
  const server = await art();
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address, { locale: 'ko-KR' });
  await page.mouse.move(400, 400);
  await page.waitForFunction(() => batten.mirror); // its texts have loaded
  assert.equal(await page.textContent('#unkept'), '유지 안 됨 5개');
  await page.click('#unkept');
  await page.waitForSelector('#losses:popover-open');
  assert.deepEqual(await page.$$eval('#losses li', (all) => all.map((one) => one.textContent)),
    ['글자 2', '무늬 1', '점선 1', '제목이나 설명 1']);
  await page.keyboard.press('Escape');
  await page.evaluate(() => batten.engine.command('losses') && batten.wake());
  await page.waitForSelector('#losses:popover-open');
  await context.close();
});

test('a page that was killed, and a module that broke, ask all the same', async (t) => {
  expectFaults(/RuntimeError/); // the module traps
  const server = await art();
  t.after(() => server.close());
  const { page, hand, client, context } = await open(browser, server.address);
  await draw(page, hand);
  await page.evaluate(() => { batten.engine.editor = 0xfffffff0; }); // a trap with the next call
  await hand.hover(await place(page, 100, 100));
  assert.match((await state(page)).notice, /brought back/);
  assert.equal(await page.textContent('#unkept'), '5 not kept');
  await draw(page, hand);
  await page.evaluate(() => batten.keeper.settled());
  const crashed = page.waitForEvent('crash');
  client.send('Page.crash').catch(() => {});
  await crashed;
  await page.close();

  const next = await context.newPage();
  await next.goto(server.address);
  await ready(next);
  assert.equal((await state(next)).unsaved, true, 'it came back');
  await ask(next);
  assert.equal(server.saves, 0);
  await context.close();
});

test('how it looks', async (t) => {
  const server = await art();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  for (const width of [360, 640, 900]) {
    await page.setViewportSize({ width, height: 640 });
    await quiet(page);
    await page.screenshot({ path: path.join(SCREENSHOTS, `losses-${width}.png`) });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
    assert.equal(wide, false, `${width}`);
  }
  await page.setViewportSize({ width: 1544, height: 800 });
  await quiet(page);
  await draw(page, hand);
  await ask(page);
  await pictures(page, 'lossy');
  await page.keyboard.press('Escape');
  await page.click('#unkept');
  await page.waitForSelector('#losses:popover-open');
  await pictures(page, 'losses');
  await context.close();
});
