// Unsaved work survives the end of a page, however sudden: its journal is in the browser's private file system.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, expectFaults, GONE, Hand, launch, launchAt, open, place, ready, SCREENSHOTS, settle, state, until, violations } from './page.mjs';
import { edit, EXAMPLE, serve } from './server.mjs';

const ROOF = bezier([440, 137], [490, 103], [560, 92], [690, 114]);
const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const car = () => serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const kept = (page, name = 'car.svg') => page.evaluate(async (title) => {
  await batten.keeper.settled();
  return (await batten.keeper.find(title))?.journal.length ?? 0;
}, name);

/** '' when the process has ended. */
function commandOf(pid) {
  try {
    return fs.readFileSync(`/proc/${pid}/cmdline`, 'utf8');
  } catch {
    return '';
  }
}

/** Kills the renderer: no event of closing runs in the page. */
async function crash(page, client) {
  const crashed = page.waitForEvent('crash');
  client.send('Page.crash').catch(() => {});
  await crashed;
}

/** Presses a key as often, as fast as the page hears it: no frame is waited for. */
async function press(client, count, key) {
  await Promise.all(Array.from({ length: 2 * count }, (_, i) => client.send('Input.dispatchKeyEvent', { type: i % 2 ? 'keyUp' : 'rawKeyDown', ...key })));
}

/** Another page of the same browser, in place of one that has ended. */
async function again(context, address) {
  const page = await context.newPage();
  await page.goto(address);
  await ready(page);
  const client = await context.newCDPSession(page);
  return { page, client, hand: new Hand(page, client) };
}

for (const [real, name] of [[false, 'a renderer killed in the middle of a stroke loses that stroke alone'],
  [true, 'the same with the program\'s own server']]) {
  test(name, async (t) => {
    const server = real ? await edit(fs.readFileSync(EXAMPLE), 'car.svg') : await car();
    t.after(() => server.close());
    const { page, client, hand, context } = await open(browser, server.address);
    const opened = await state(page);
    await hand.stroke(await on(page, SKY));
    await hand.stroke(await on(page, ROOF));
    const before = await state(page);
    assert.notEqual(before.digest, opened.digest);
    await hand.stroke(await on(page, bezier([60, 380], [140, 340], [220, 410], [320, 380])), { lift: false });
    await crash(page, client);
    await page.close();

    const next = await again(context, server.address);
    let now = await state(next.page);
    assert.equal(now.digest, before.digest, 'all but the stroke under the pen');
    assert.equal(now.check, '');
    assert.equal(now.unsaved, true);
    assert.match(now.notice, /Unsaved work on car\.svg was brought back/);
    await next.page.screenshot({ path: path.join(SCREENSHOTS, 'brought-back.png') });
    await next.page.emulateMedia({ colorScheme: 'dark' });
    await settle(next.page);
    await next.page.screenshot({ path: path.join(SCREENSHOTS, 'brought-back-dark.png') });
    // Its history was restored too.
    await next.page.keyboard.press('Control+Z');
    await next.page.keyboard.press('Control+Z');
    await settle(next.page);
    assert.equal((await state(next.page)).digest, opened.digest);
    await next.page.keyboard.press('Control+Shift+Z');
    await next.page.keyboard.press('Control+Shift+Z');
    await settle(next.page);
    assert.equal((await state(next.page)).digest, before.digest);
    // Saved work is not restored again.
    await next.page.keyboard.press('Control+S');
    await next.page.waitForFunction(() => document.getElementById('unsaved').hidden);
    await settle(next.page);
    assert.equal(await kept(next.page), 0);
    await next.page.reload();
    await ready(next.page);
    now = await state(next.page);
    assert.equal(now.notice, '');
    assert.equal(now.digest, before.digest);
    await context.close();
  });
}

test('a browser killed as soon as a stroke is said to be kept has it on its disk', async (t) => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-profile-'));
  const server = await car();
  t.after(() => server.close());
  const context = await launchAt(profile);
  const page = await context.newPage();
  await page.goto(server.address);
  await ready(page);
  const hand = new Hand(page, await context.newCDPSession(page));
  await hand.stroke(await on(page, SKY));
  await hand.stroke(await on(page, ROOF));
  await kept(page);
  const pids = fs.readdirSync('/proc').filter((pid) => /^\d+$/.test(pid) && commandOf(pid).includes(profile)).map(Number);
  assert.ok(pids.length > 0);
  const digest = page.evaluate(() => batten.engine.digest());
  const before = await digest;
  const closed = new Promise((done) => context.on('close', done));
  for (const pid of pids) {
    process.kill(pid, 'SIGKILL');
  }
  await closed;

  const next = await launchAt(profile);
  const { page: other } = await again(next, server.address);
  assert.equal((await state(other)).digest, before);
  await next.close();
  fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
});

test('two hundred steps and more can be undone after the page was killed', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, client, context } = await open(browser, server.address);
  const opened = await state(page);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+A');
  await press(client, 230, { key: 'ArrowRight', code: 'ArrowRight', windowsVirtualKeyCode: 39 });
  await settle(page);
  const before = await state(page);
  await kept(page);
  await crash(page, client);
  await page.close();
  const next = await again(context, server.address);
  assert.equal((await state(next.page)).digest, before.digest);
  const undo = { key: 'z', code: 'KeyZ', windowsVirtualKeyCode: 90, modifiers: 2 };
  await press(next.client, 200, undo);
  await settle(next.page);
  assert.equal((await state(next.page)).check, '');
  assert.notEqual((await state(next.page)).digest, opened.digest);
  await press(next.client, 29, undo);
  await settle(next.page);
  assert.notEqual((await state(next.page)).digest, opened.digest, 'each press was a step');
  await press(next.client, 1, undo);
  await settle(next.page);
  assert.equal((await state(next.page)).digest, opened.digest);
  await context.close();
});

test('a browser without room says so and offers a copy, and keeps again when there is room', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, client, hand, context } = await open(browser, server.address);
  const { origin } = new URL(server.address);
  await client.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 10 });
  await hand.stroke(await on(page, SKY));
  await page.waitForSelector('[data-about=unkept] >> text=no room to keep');
  assert.deepEqual(await page.locator('[data-about=unkept] button').allTextContents(), ['Save now', 'Download a copy', '×']);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'no-room.png') });
  assert.equal(await kept(page), 0);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=unkept] >> text=Download a copy')]);
  assert.equal(download.suggestedFilename(), 'car.svg');
  await hand.stroke(await on(page, SKY.map(([x, y]) => [x, y + 300])));
  await page.evaluate(() => batten.keeper.settled());
  assert.equal(await page.isVisible('[data-about=unkept]'), false, 'once is enough');
  await client.send('Storage.overrideQuotaForOrigin', { origin });
  await hand.stroke(await on(page, ROOF));
  assert.equal(await kept(page), await page.evaluate(() => batten.engine.journal.length), 'all of it');
  await client.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 10 });
  await hand.stroke(await on(page, SKY.map(([x, y]) => [x + 400, y])));
  await page.click('[data-about=unkept] >> text=Save now');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.equal(server.saves, 1);
  await context.close();
});

for (const [lasting, name] of [[false, 'a private window'], [true, 'a profile']]) {
  test(`storage cleared in mid-session, in ${name}: said at the next step, offered as a download, kept anew`, async (t) => {
    const server = await car();
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-profile-'));
    const context = lasting ? await launchAt(profile) : await browser.newContext({ viewport: { width: 1280, height: 800 } });
    t.after(() => {
      server.close();
      fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    });
    const { page, client, hand } = await again(context, server.address);
    await hand.stroke(await on(page, SKY));
    assert.ok(await kept(page) > 0);
    const { origin } = new URL(server.address);
    for (const shift of [300, 250]) { // a second time, too
      await client.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
      assert.equal(await kept(page), 0);
      await hand.stroke(await on(page, SKY.map(([x, y]) => [x, y + shift])));
      await page.waitForSelector('[data-about=unkept] >> text=cleared the unsaved work');
      await until(page, async () => {
        await batten.keeper.settled();
        return (await batten.keeper.find('car.svg'))?.journal.length === batten.engine.journal.length;
      });
      const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=unkept] >> text=Download')]);
      assert.equal(download.suggestedFilename(), 'car.svg');
    }
    // Keeping continues: what is drawn now is kept and restored.
    await hand.stroke(await on(page, ROOF));
    const before = await state(page);
    await page.evaluate(() => batten.keeper.settled());
    await crash(page, client);
    await page.close();
    const next = await again(context, server.address);
    assert.equal((await state(next.page)).digest, before.digest);
    // Cleared while nothing is being written, then saved: nothing hangs.
    await next.client.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
    await next.page.keyboard.press('Control+S');
    await next.page.waitForFunction(() => document.getElementById('unsaved').hidden);
    await next.page.evaluate(() => batten.keeper.settled());
    await context.close();
  });
}

test('the first stroke is kept although the server went before it', async (t) => {
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  expectFaults(...GONE);
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.goto(program.address);
  await page.waitForFunction(() => globalThis.batten?.engine.module.second);
  await program.kill();
  const client = await context.newCDPSession(page);
  await new Hand(page, client).stroke(await on(page, SKY));
  const before = await state(page);
  assert.equal(await kept(page), await page.evaluate(() => batten.engine.journal.length));
  await crash(page, client);
  await page.close();
  await program.start();
  const next = await again(context, program.address);
  const now = await state(next.page);
  assert.equal(now.digest, before.digest);
  assert.match(now.notice, /brought back/);
});

test('no other notice hides that work was brought back', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, client, hand, context } = await open(browser, server.address);
  await hand.stroke(await on(page, SKY));
  const { digest } = await state(page);
  await kept(page);
  await crash(page, client);
  await page.close();
  const next = await again(context, server.address);
  await next.page.keyboard.press('Control+Z');
  await next.page.keyboard.press('Control+Z'); // reports that there is nothing to undo
  await next.page.waitForSelector('#notice:visible');
  await next.page.keyboard.press('Control+Shift+Z');
  server.bytes = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"/>');
  expectFaults(/status of 412/);
  await next.page.keyboard.press('Control+S');
  await next.page.waitForSelector('[data-about=changed]');
  await next.hand.stroke(await on(next.page, ROOF));
  assert.equal(await next.page.isVisible('#notice'), false, 'what passed has gone with the stroke');
  assert.equal(await next.page.isVisible('[data-about=changed]'), true);
  assert.match(await next.page.textContent('[data-about=kept] span'), /Unsaved work on car\.svg was brought back/);
  await next.page.click('[data-about=kept] [aria-label=Close]');
  assert.equal(await next.page.locator('[data-about=kept]').count(), 0);
  await next.page.keyboard.press('Control+Z');
  await settle(next.page);
  assert.equal((await state(next.page)).digest, digest);
});

test('unsaved work is announced on leaving, saved work is not', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const asked = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.dismiss();
  });
  await hand.stroke(await on(page, SKY));
  const before = await state(page);
  const asking = page.waitForEvent('dialog');
  page.reload().catch(() => {}); // the user stays, so this never resolves
  await asking;
  assert.deepEqual(asked, ['beforeunload']);
  assert.equal((await state(page)).digest, before.digest);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  await settle(page);
  await page.reload();
  await ready(page);
  assert.deepEqual(asked, ['beforeunload']);
  await context.close();
});

test('what earlier versions kept is taken over, and their folder goes only then', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(await on(page, SKY));
  const before = await state(page);
  await kept(page);
  const journal = await page.evaluate(() => new TextDecoder().decode(batten.engine.journal));
  await page.close();
  expectFaults(/favicon/);
  const other = await context.newPage();
  await other.goto(new URL('1/icons/batten.svg', server.address).href);
  await other.evaluate(async (text) => {
    const root = await navigator.storage.getDirectory();
    await freed(() => root.removeEntry('drawings', { recursive: true }));
    const all = await root.getDirectoryHandle('journals', { create: true });
    const write = async (key, name, content) => {
      const folder = await all.getDirectoryHandle(key, { create: true });
      const stream = await (await folder.getFileHandle(name, { create: true })).createWritable();
      await stream.write(content);
      await stream.close();
    };
    const key = '0123456789abcdef0123456789abcdef';
    await write(key, '1', `${text}{"do":"sketch-new","obj`); // broken off in the middle of a line
    await write(key, '2', '\0"journal":"batten","version":1,"name":"car.svg"}\n'); // never finished
    await write('fedcba9876543210fedcba9876543210', '1', '{"journal":"batten","version":1,"name":"a \u0007 bell.svg"}\n');
  }, journal);
  const next = await again(context, server.address);
  assert.equal((await state(next.page)).digest, before.digest);
  const listed = () => next.page.evaluate(async () => (await batten.keeper.list()).map(({ id, name, place }) => [id, name, place]).sort());
  const bell = ['fedcba9876543210fedcba9876543210', 'a \u0007 bell.svg', ''];
  assert.deepEqual(await listed(), [['0123456789abcdef0123456789abcdef', 'car.svg', ''], bell]);
  // What is drawn on top of it goes on with it, as unsaved work on the file, and is no second drawing.
  await next.hand.stroke([[200, 120], [300, 80], [400, 120]]);
  await kept(next.page);
  assert.deepEqual(await listed(), [['0123456789abcdef0123456789abcdef', 'car.svg', 'car.svg'], bell]);
  assert.deepEqual(await next.page.evaluate(async () => {
    const names = [];
    for await (const name of (await (await navigator.storage.getDirectory()).getDirectoryHandle('journals')).keys()) {
      names.push(name);
    }
    return names;
  }), []);
  await context.close();
});

test('a large drawing that is opened or brought back is not made short', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const { page, context } = await open(browser, server.address);
  const compacted = await page.evaluate(() => {
    const { engine } = batten;
    const count = { compacted: 0 };
    const { editor_compact: compact } = engine.wasm;
    engine.wasm = { ...engine.wasm, editor_compact: (...all) => (count.compacted++, compact(...all)) };
    const path = `<path d="M0 0${'c1 2 3 4 5 6'.repeat(100)}"/>`;
    engine.openSvg(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">${path.repeat(1500)}</svg>`, 'large.svg');
    const journal = engine.journal.slice();
    const { length } = new TextDecoder().decode(journal).trimEnd().split('\n');
    engine.replay(journal);
    engine.salvage(journal);
    return { ...count, lines: length, long: journal.length > 4e6, same: engine.journal.length === journal.length };
  });
  assert.deepEqual(compacted, { compacted: 0, lines: 1, long: true, same: true });
  await context.close();
});

test('a long journal is made short aside; what it leads to and its undo stay', async (t) => {
  const server = await car();
  t.after(() => server.close());
  const { page, client, context } = await open(browser, server.address);
  await page.focus('#stage');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+A');
  for (let i = 0; i < 40; i++) {
    await page.keyboard.press('ArrowRight');
  }
  await settle(page);
  const [long, session] = await page.evaluate(() => {
    const { engine } = batten;
    engine.long = 1000; // makes this journal count as long
    return [engine.journal.length, engine.session];
  });
  await page.keyboard.press('ArrowDown');
  await settle(page);
  assert.equal(await page.evaluate(() => batten.engine.session), session + 1);
  assert.ok(Math.abs(await page.evaluate(() => batten.engine.journal.length) - long) < long / 2, 'all steps are there');
  await page.keyboard.press('ArrowDown');
  await settle(page);
  const before = await state(page);
  await kept(page);
  await crash(page, client);
  await page.close();
  const next = await again(context, server.address);
  assert.equal((await state(next.page)).digest, before.digest);
  const first = await next.page.evaluate(async () => {
    const { engine } = batten;
    while (glance().canUndo) {
      engine.key('z', true, 2, 0);
    }
    return engine.digest();
  });
  const fresh = await open(browser, server.address);
  const { digest } = await state(fresh.page);
  assert.equal(first, digest);
  await context.close();
});

for (const [colorScheme, locale] of [['light', 'en'], ['dark', 'ko-KR']]) {
  test(`the drawings kept are listed, opened and deleted by keys alone, ${colorScheme}, ${locale}`, async (t) => {
    const server = await serve();
    t.after(() => server.close());
    const { page, hand, context } = await open(browser, server.address, { colorScheme, locale });
    const rows = () => page.locator('#kept li bdi').allTextContents();
    const list = async () => {
      await page.keyboard.press('F1');
      await page.waitForSelector('#menu .search:focus');
      await page.keyboard.type(locale === 'en' ? 'my drawings' : '내 그림');
      await page.keyboard.press('Tab');
      await page.keyboard.press('Enter');
      await page.waitForSelector('#kept button:focus');
    };
    const become = (name) => page.waitForFunction((wanted) => batten.files.name === wanted && batten.tabs.held, name);
    await page.focus('#stage');
    await hand.stroke([[300, 300], [500, 250], [700, 300]]);
    const first = await state(page);
    await list();
    assert.deepEqual(await rows(), ['drawing.svg']);
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Enter'); // a new one
    await become('drawing 2.svg');
    await settle(page);
    await page.focus('#stage');
    await hand.stroke([[300, 500], [500, 450], [700, 500]]);
    const second = await state(page);
    assert.notEqual(second.digest, first.digest);
    await list();
    assert.deepEqual(await rows(), ['drawing 2.svg', 'drawing.svg']);
    assert.equal(await page.getAttribute('#kept button:focus', 'aria-current'), 'true');
    assert.deepEqual(await violations(page), []);
    await page.screenshot({ path: path.join(SCREENSHOTS, `kept-${colorScheme}.png`) });
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await become('drawing.svg');
    await settle(page);
    assert.equal((await state(page)).digest, first.digest);
    await hand.stroke([[300, 600], [500, 650], [700, 600]]); // drawing continues, and is kept
    const more = await state(page);
    // A drawing open in another tab is neither opened nor removed.
    const other = await again(context, server.address);
    await other.page.waitForFunction(() => batten.files.name === 'drawing 2.svg' && batten.tabs.held);
    assert.equal((await state(other.page)).digest, second.digest);
    await list();
    await page.click('#kept li >> text=drawing 2.svg');
    await page.waitForFunction((text) => document.getElementById('notice-text').textContent.includes(text),
      locale === 'en' ? 'open in another tab' : '다른 탭에');
    await become('drawing.svg');
    assert.equal((await state(page)).digest, more.digest);
    await other.page.close();
    await until(page, async () => (await navigator.locks.query()).held.length === 2);
    // Deleted by one press, and brought back by another.
    await page.focus('#stage');
    await list();
    const at = (await rows()).indexOf('drawing 2.svg');
    await page.locator('#kept .open').nth(at).focus();
    await page.keyboard.press('Delete');
    await page.waitForFunction(() => document.querySelectorAll('#kept bdi').length === 1);
    await page.screenshot({ path: path.join(SCREENSHOTS, `kept-${colorScheme}-deleted.png`) });
    await page.click('#kept .said button');
    await page.waitForFunction(() => document.querySelectorAll('#kept bdi').length === 2);
    assert.deepEqual((await rows()).sort(), ['drawing 2.svg', 'drawing.svg']);
    await page.locator('#kept .open').nth((await rows()).indexOf('drawing 2.svg')).focus();
    await page.keyboard.press('Delete');
    await page.waitForFunction(() => document.querySelectorAll('#kept bdi').length === 1);
    await page.waitForSelector('#kept button:focus');
    await page.keyboard.press('Escape');
    await settle(page);
    assert.ok(await kept(page, 'drawing.svg') > 0, 'what is shown is kept as before');
    await page.reload();
    await ready(page);
    assert.equal((await state(page)).digest, more.digest);
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}
