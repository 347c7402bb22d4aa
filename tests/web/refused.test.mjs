// A save that is refused: the reason stays until the drawing is saved, with a second try and a copy at hand.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, downloaded, expectFaults, GONE, inThemes, launch, open, place, SCREENSHOTS, settle, state } from './page.mjs';
import { edit, EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const CURVE = [[60, 60], [140, 20], [220, 100], [320, 60]];
const UNSAVED = '[data-about=unsaved]';
const draw = async (page, hand) => hand.stroke(bezier(...await Promise.all(CURVE.map(([x, y]) => place(page, x, y)))));
const saved = (page) => page.waitForFunction(() => document.getElementById('unsaved').hidden);

/**
 * Saves and is refused, sees that the reason stays, takes a copy, tries again in vain and, when what stood in the way is gone, with success.
 * @param {{ address: string, bytes: Buffer }} server @param {RegExp} reason @param {() => unknown} mend @param {string} [shot]
 * @param {object} [how] of the page
 */
async function refused(server, reason, mend, shot = '', how = {}) {
  const { page, hand, context } = await open(browser, server.address, how);
  await page.waitForLoadState('networkidle');
  const before = Buffer.from(server.bytes);
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await page.waitForSelector(UNSAVED);
  const told = await page.textContent(`${UNSAVED} span`);
  assert.match(told, reason);
  await draw(page, hand); // a notice that passes goes with the next stroke
  assert.equal(await page.textContent(`${UNSAVED} span`), told);
  assert.equal((await state(page)).unsaved, true);
  assert.deepEqual(server.bytes, before, 'nothing is written');
  if (shot) {
    await page.screenshot({ path: path.join(SCREENSHOTS, shot) });
  }
  const [again, copy] = await page.locator(`${UNSAVED} button`).all();
  const [download] = await Promise.all([page.waitForEvent('download'), copy.click()]);
  assert.match(String(await downloaded(download)), /<path/);
  assert.equal(await page.textContent(`${UNSAVED} span`), told, 'a copy is not the file');
  assert.equal((await state(page)).unsaved, true);
  await again.click();
  await page.waitForSelector(UNSAVED);
  await settle(page);
  assert.equal(await page.textContent(`${UNSAVED} span`), told);
  await mend();
  await page.locator(`${UNSAVED} button`).first().click();
  await saved(page);
  assert.equal(await page.isVisible(UNSAVED), false);
  assert.notDeepEqual(server.bytes, before);
  await context.close();
}

test('a disk that is full', async (t) => {
  expectFaults(/status of 507/);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const limit = (size) => assert.equal(spawnSync('prlimit', ['--pid', String(program.program.pid), `--fsize=${size}:`]).status, 0);
  limit(1000);
  await refused(program, /^Not saved: The disk is full\.$/, () => limit('unlimited'), 'refused.png');
});

test('a file that may not be written', async (t) => {
  expectFaults(/status of 409/);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const file = path.join(program.folder, 'car.svg');
  fs.chmodSync(file, 0o444);
  await refused(program, /^Not saved: The file is read-only\.$/, () => fs.chmodSync(file, 0o644));
});

test('a server that takes no body of that size', async (t) => {
  expectFaults(/status of 413/);
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  server.refused = 413;
  await refused(server, /^저장하지 못했습니다: 서버가 이렇게 큰 파일은 받지 않습니다\.$/, () => { server.refused = 0; }, 'refused_ko.png',
    { locale: 'ko-KR' });
});

test('a server that is gone: one notice says so', async (t) => {
  expectFaults(/status of 403/, ...GONE);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await page.waitForLoadState('networkidle');
  await draw(page, hand);
  await program.kill();
  await page.evaluate(() => dispatchEvent(new Event('focus')));
  await page.waitForSelector('[data-about=silent]');
  await page.keyboard.press('Control+S');
  await page.waitForSelector(`${UNSAVED} >> text=server stopped`);
  assert.equal(await page.isVisible('[data-about=silent]'), false);
  await program.start();
  await page.locator(`${UNSAVED} button`).first().click();
  await saved(page);
  assert.match(program.bytes.toString(), /batten:document/);
  await context.close();
});

test('what is said of a drawing goes when another is opened', async (t) => {
  expectFaults(/status of 413/);
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  server.refused = 413;
  const { page, hand, context } = await open(browser, server.address);
  await page.waitForLoadState('networkidle');
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await page.waitForSelector(UNSAVED);
  await page.evaluate((text) => batten.files.open(new TextEncoder().encode(text), 'other.svg'), fs.readFileSync(EXAMPLE, 'utf8'));
  await settle(page);
  assert.equal(await page.isVisible(UNSAVED), false);
  await context.close();
});

test('a save that takes long says so until it is done', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  let go = () => {};
  const held = new Promise((resolve) => { go = resolve; });
  await page.route('**/document', async (route) => {
    await (route.request().method() === 'PUT' ? held : null);
    await route.continue();
  });
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await page.waitForSelector('[data-about=saving]');
  assert.equal(await page.textContent('[data-about=saving] span'), 'Saving car.svg.');
  await draw(page, hand); // it stays
  await inThemes(page, async (colorScheme) => page.screenshot({ path: path.join(SCREENSHOTS, `saving-${colorScheme}.png`) }));
  assert.equal(await page.isVisible('[data-about=saving]'), true);
  go();
  await page.waitForSelector('[data-about=saving]', { state: 'detached' });
  assert.match((await state(page)).notice, /^Saved/);
  assert.equal((await state(page)).unsaved, true, 'what was drawn meanwhile is not in the file');
  await context.close();
});

/** A drawing that is not written at once. */
const HEAVY = Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">${
  Array.from({ length: 3000 }, (_, i) => `<path d="M${i % 400} 20c2 -3 4 3 6 0s1 2 ${1 + i / 1000} 3" stroke="#000" fill="none"/>`).join('')}</svg>`);

test('what is heavy is written beside the page, and by the page where there is no worker', async (t) => {
  expectFaults(/no worker/);
  const server = await serve({ name: 'heavy.svg', bytes: HEAVY });
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await page.waitForFunction(() => batten.files.bound);
  await page.evaluate(() => {
    const { engine } = batten;
    globalThis.written = 0;
    engine.save = (native) => {
      globalThis.written++;
      return Object.getPrototypeOf(engine).save.call(engine, native);
    };
  });
  const count = () => String(server.bytes).split('<path').length;
  const before = count();
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(page);
  assert.equal(await page.evaluate(() => globalThis.written), 0, 'the page goes on');
  assert.equal(count(), before + 1);
  assert.ok(String(server.bytes).includes(String(HEAVY).slice(100, 5000)), 'the file is kept');
  const { bytes } = server;
  await page.evaluate(() => { globalThis.Worker = class { constructor() { throw new Error('no worker'); } }; });
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await saved(page);
  assert.equal(await page.evaluate(() => globalThis.written), 1);
  assert.notDeepEqual(server.bytes, bytes);
  await context.close();
});
