// What a browser keeps is never lost: each row is something that happens to a page or to its storage, and what is there
// afterwards. The drawings are of a page without a file, so that the browser alone has them.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, drop, expectFaults, Hand, HANG, launch, open, ready, SCREENSHOTS, settle, state, until } from './page.mjs';
import { serve } from './server.mjs';

const STROKES = 5;
const line = (k) => [[250, 200 + 90 * k], [500, 170 + 90 * k], [750, 200 + 90 * k]];

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

const curves = (page) => page.evaluate(() => batten.engine.layers().loose);
const list = (page) => page.evaluate(async () => (await batten.keeper.list()).map(({ name, aside }) => `${name}${aside ? ' aside' : ''}`).sort());
const said = (page) => page.evaluate(() => document.querySelector('.notices').innerText);
/** @param {RegExp} words that the page says, or comes to say */
const says = async (page, words) => {
  for (const from = Date.now(); !words.test(await said(page)) && Date.now() - from < HANG;) {
    await new Promise((done) => setTimeout(done, 50));
  }
  assert.match(await said(page), words);
};

/** A page in which strokes were drawn and kept. */
async function drawn(count = STROKES) {
  const { page, hand, context, client } = await open(browser, server.address);
  for (let k = 0; k < count; k++) {
    await hand.stroke(line(k));
  }
  await page.keyboard.press('Escape');
  await page.evaluate(() => batten.keeper.settled());
  assert.equal(await curves(page), count);
  return { page, hand, context, client };
}

/** Another page of the same browser. */
async function another(context, prepare = async () => {}) {
  const page = await context.newPage();
  await prepare(page);
  await page.goto(server.address);
  await ready(page);
  return { page, hand: new Hand(page, await context.newCDPSession(page)) };
}

/** What the files hold now. */
const filesOf = (page) => page.evaluate(async () => {
  const folder = await (await navigator.storage.getDirectory()).getDirectoryHandle('drawings');
  const all = {};
  for await (const [name, handle] of folder.entries()) {
    all[name] = [...new Uint8Array(await (await handle.getFile()).arrayBuffer())];
  }
  return all;
});

/** What a page has kept of strokes: drawn once, for all that is done to it. @type {Promise<Record<string, number[]>> | undefined} */
let made;

async function make() {
  const { page, context } = await drawn();
  const files = await filesOf(page);
  await context.close();
  return files;
}

/**
 * A browser in which files are kept that have been changed, while no page is open.
 * @param {(bytes: number[], given: any) => number[]} change
 */
async function spoilt(change, given) {
  made ??= make();
  const files = Object.entries(await made).map(([name, bytes]) => [name, bytes.length > 1 ? [...change([...bytes], given)] : bytes]);
  expectFaults(/favicon/);
  const context = await browser.newContext({ viewport: { width: 1544, height: 800 }, acceptDownloads: true });
  const page = await context.newPage();
  await page.goto(new URL('1/icons/batten.svg', server.address).href);
  await page.evaluate(async (all) => {
    const folder = await (await navigator.storage.getDirectory()).getDirectoryHandle('drawings', { create: true });
    for (const [name, bytes] of all) {
      const stream = await (await folder.getFileHandle(name, { create: true })).createWritable();
      await stream.write(new Uint8Array(bytes));
      await stream.close();
    }
  }, files);
  await page.close();
  return { context, files: files.filter(([, bytes]) => bytes.length > 1) };
}

for (const share of [0.02, 0.5, 0.97]) { // store.test.mjs changes each byte
  test(`a byte at ${100 * share} % is changed: the other steps are there, it is said, and the file stays as it is`, async () => {
    const { context, files: [[name, bytes]] } = await spoilt((all, where) => {
      all[Math.floor(where * all.length)] ^= 0x15;
      return all;
    }, share);
    const next = await another(context);
    assert.ok(await curves(next.page) >= STROKES - 1, `${await curves(next.page)} of ${STROKES} strokes`);
    await says(next.page, /Only part of drawing.svg could be read/);
    await next.page.screenshot({ path: path.join(SCREENSHOTS, 'kept-part.png') });
    const [download] = await Promise.all([next.page.waitForEvent('download'), next.page.click('[data-about=other] button')]);
    assert.deepEqual([...await downloaded(download)], bytes);
    await next.hand.stroke(line(STROKES));
    await next.page.evaluate(() => batten.keeper.settled());
    assert.deepEqual((await filesOf(next.page))[name], bytes, 'the damaged one is as it was');
    assert.deepEqual(await list(next.page), ['drawing.svg', 'drawing.svg aside']);
    // The next page opens the one that is whole.
    const now = await state(next.page);
    await next.page.close();
    const third = await another(context);
    assert.equal((await state(third.page)).digest, now.digest);
    await says(third.page, /as you left it/);
    await context.close();
  });
}

for (const share of [0.4, 0.995]) {
  test(`what is kept is cut at ${100 * share} %: what comes before is there, and it is said`, async () => {
    const { context } = await spoilt((all, where) => all.slice(0, Math.floor(where * all.length)), share);
    const next = await another(context);
    assert.ok(await curves(next.page) >= Math.floor(share * STROKES) - 1);
    await says(next.page, /Only part of/);
    const whole = await curves(next.page) > 0; // what could be read is kept as a drawing of its own
    await until(next.page, async (count) => (await batten.keeper.list()).length >= count, whole ? 2 : 1);
    assert.deepEqual(await list(next.page), ['drawing.svg', 'drawing.svg aside'].slice(whole ? 0 : 1));
    await context.close();
  });
}

test('one that cannot be read at all is put aside, and new work goes elsewhere', async () => {
  const { context, files: [[name, bytes]] } = await spoilt((all) => all.fill(7));
  const next = await another(context);
  assert.equal(await curves(next.page), 0);
  await next.hand.stroke(line(0));
  await next.page.evaluate(() => batten.keeper.settled());
  assert.deepEqual((await filesOf(next.page))[name], bytes);
  await next.page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
  await next.page.waitForSelector('#kept:popover-open');
  await next.page.screenshot({ path: path.join(SCREENSHOTS, 'kept-damaged.png') });
  assert.match(await next.page.textContent('#kept'), /Untitled.*damaged/);
  const strokes = await state(next.page);
  await next.page.click('#kept >> text=Untitled');
  await next.page.waitForSelector('[data-about=other] >> text=could not be opened');
  assert.equal((await state(next.page)).digest, strokes.digest, 'what is open stays');
  await next.hand.stroke(line(1));
  await next.page.evaluate(() => batten.keeper.settled());
  assert.deepEqual((await filesOf(next.page))[name], bytes);
  await context.close();
});

for (const [what, from, to, told] of [
  ['of a newer version', '"version":1', '"version":2', null],
  ['with a step that this version does not know', '"do":"sketch-new"', '"do":"of-the-future"', /Only part of/]]) {
  test(`a journal ${what}: said, kept, offered`, async () => {
    const { page, context } = await drawn();
    // Written by the page's own code, so that its checksums are right.
    const lines = await page.evaluate(([before, after]) => new TextDecoder().decode(batten.engine.journal).replace(before, after), [from, to]);
    await page.evaluate(async (journal) => {
      const { keeper, drawings } = batten;
      drawings.moving = true; // the page itself keeps nothing more
      keeper.begin(-5, '0123456789abcdef01234567');
      keeper.note('later.svg', '', 1, new TextEncoder().encode(journal));
      await keeper.settled();
    }, lines);
    await page.close();
    const next = await another(context);
    await next.page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
    await next.page.waitForSelector('#kept:popover-open');
    await next.page.click('#kept >> text=later.svg');
    await next.page.waitForSelector('[data-about=other]');
    if (told) {
      await says(next.page, told);
      assert.equal(await curves(next.page), STROKES - 1);
    } else {
      await says(next.page, /later.svg could not be opened.*newer version/s);
      assert.equal(await curves(next.page), STROKES, 'what is open stays');
    }
    const [download] = await Promise.all([next.page.waitForEvent('download'), next.page.click('[data-about=other] button')]);
    assert.ok((await downloaded(download)).toString().includes(lines.split('\n')[1]));
    assert.ok((await list(next.page)).some((name) => name.startsWith('later.svg')));
    await context.close();
  });
}

test('names are data: a control character, quotes, a path, an empty one; all are listed and open', async () => {
  const { page, context } = await drawn(1);
  const names = ['a\u0000b\u0007.svg', '"}\n{".svg', '../../x.svg', '<b>.svg', '가나.svg', 'x'.repeat(3000)];
  await page.evaluate(async (all) => {
    const { keeper, engine, drawings } = batten;
    drawings.moving = true; // the page itself keeps nothing more
    for (const name of all) {
      keeper.begin(-5);
      keeper.note(name, '', 1, engine.journal);
      await keeper.settled();
    }
  }, names);
  await page.close();
  const next = await another(context);
  assert.deepEqual([...new Set(await list(next.page))].sort(), [...names, 'drawing.svg'].sort());
  await next.page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
  await next.page.waitForSelector('#kept:popover-open');
  assert.equal(await next.page.locator('#kept ul:first-of-type li bdi').count(), names.length + 1);
  await next.hand.stroke(line(2));
  await next.page.evaluate(() => batten.keeper.settled());
  assert.equal((await list(next.page)).length, names.length + 1);
  await context.close();
});

test('the store cannot be read for a moment: tried again; for long: said, and nothing is written over', async () => {
  const { page, context } = await drawn();
  const before = await filesOf(page);
  await page.close();
  const fails = (count) => (other) => other.addInitScript((times) => {
    let left = times;
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function spoilt(job, moved) {
      return post.call(this, job.call === 'list' && left-- > 0 ? { ...job, call: 'no such call' } : job, moved);
    };
  }, count);
  const soon = await another(context, fails(1));
  assert.equal(await curves(soon.page), STROKES);
  await soon.page.close();
  const never = await another(context, fails(1e9));
  await says(never.page, /can't be read now/);
  await never.hand.stroke(line(0));
  await never.page.evaluate(() => batten.keeper.settled());
  const files = await filesOf(never.page);
  for (const [name, bytes] of Object.entries(before)) {
    assert.deepEqual(files[name], bytes);
  }
  await context.close();
});

test('a file that is named as a kept drawing: both are kept', async () => {
  const { page, hand, context } = await drawn();
  const kept = await state(page);
  await page.evaluate(() => batten.drawings.openNew());
  await drop(page, 'drawing.svg', '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 900"><path d="M100 700H500" stroke="#000"/></svg>');
  await page.waitForFunction(() => batten.painter.list.length > 0);
  await says(page, /unsaved work on drawing.svg from before/);
  await hand.stroke(line(1));
  const other = await state(page);
  await page.reload();
  await ready(page);
  assert.deepEqual(await list(page), ['drawing.svg', 'drawing.svg']);
  assert.equal((await state(page)).digest, other.digest);
  await page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
  await page.waitForSelector('#kept:popover-open');
  await page.click('#kept li:nth-child(2) button');
  await page.waitForFunction((digest) => batten.engine.digest() === digest, kept.digest);
  await context.close();
});

for (const [how, event, count] of [['killed', '', STROKES], ['killed', '', 0], ['hidden, then killed', 'visibilitychange', STROKES],
  ['left, then killed', 'pagehide', STROKES]]) {
  test(`a page that is ${how} right after a stroke, before another frame, has it and the ${count} before`, async () => {
    const { page, hand, context } = await drawn(count);
    const [at] = line(STROKES);
    const end = line(STROKES).at(-1);
    await hand.stroke(line(STROKES), { lift: false });
    // No frame comes any more; the stroke ends, and what the page has told its keeper by then is all that counts.
    const steps = await page.evaluate(([x, y, name]) => {
      globalThis.requestAnimationFrame = () => 0;
      const stage = document.getElementById('stage');
      if (name) { // an event of the page's end alone keeps it
        batten.input.onlift = () => {};
      }
      stage.dispatchEvent(new PointerEvent('pointerup', { pointerId: [...batten.input.contacts.keys()][0], pointerType: 'pen', clientX: x, clientY: y, bubbles: true }));
      if (name) {
        (name === 'pagehide' ? globalThis : document).dispatchEvent(new Event(name));
      }
      return batten.keeper.length;
    }, [...end, event]);
    assert.ok(at && steps > 0);
    await page.waitForFunction(() => batten.keeper.writes === 0, null, { polling: 5 });
    const crashed = page.waitForEvent('crash');
    (await context.newCDPSession(page)).send('Page.crash').catch(() => {});
    await crashed;
    await page.close();
    const next = await another(context);
    assert.equal(await curves(next.page), count + 1);
    await context.close();
  });
}

test('where the private file system cannot be written, the database keeps the same', async () => {
  const context = await browser.newContext({ viewport: { width: 1544, height: 800 } });
  await context.route(/keep\/opfs\.js$/, (route) => route.fulfill({ contentType: 'text/javascript',
    body: 'export class Opfs { static find() { return Promise.reject(new Error("none")); } }' }));
  const { page, hand } = await another(context);
  for (let k = 0; k < STROKES; k++) {
    await hand.stroke(line(k));
  }
  await page.evaluate(() => batten.keeper.settled());
  assert.equal(await page.locator('[data-about=unkept]').count(), 0);
  const before = await state(page);
  const crashed = page.waitForEvent('crash');
  (await context.newCDPSession(page)).send('Page.crash').catch(() => {});
  await crashed;
  await page.close();
  const next = await another(context);
  assert.equal((await state(next.page)).digest, before.digest);
  await says(next.page, /as you left it/);
  await next.hand.stroke(line(STROKES));
  await next.page.evaluate(() => batten.drawings.openNew());
  await next.page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
  await next.page.waitForSelector('#kept:popover-open');
  assert.equal(await next.page.locator('#kept ul:first-of-type li bdi').count(), 1);
  await context.close();
});

test('where neither keeps anything, the page says so at the first stroke, and goes on', async () => {
  const context = await browser.newContext({ viewport: { width: 1544, height: 800 } });
  await context.route(/keep\/(opfs|database)\.js$/, (route) => route.fulfill({ contentType: 'text/javascript',
    body: 'const find = () => Promise.reject(new Error("none")); export const Opfs = { find }; export const Database = { find };' }));
  const { page, hand } = await another(context);
  await hand.stroke(line(0));
  await page.waitForSelector('[data-about=unkept] >> text=does not keep unsaved work');
  await hand.stroke(line(1));
  assert.equal(await curves(page), 2);
  await context.close();
});

test('the browser is asked once, at the first stroke, not to clear away what it keeps; a refusal is said once', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await page.evaluate(() => {
    localStorage.removeItem('batten-told-lasting');
    globalThis.persisted = 0;
    navigator.storage.persist = async () => {
      globalThis.persisted++;
      return false;
    };
  });
  assert.equal(await page.evaluate(() => globalThis.persisted), 0);
  await hand.stroke(line(0));
  await page.waitForSelector('#notice-text >> text=may clear kept drawings');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'not-lasting.png') });
  await hand.stroke(line(1));
  await settle(page);
  assert.equal(await page.evaluate(() => globalThis.persisted), 1);
  assert.doesNotMatch(await said(page), /may clear kept drawings/);
  await context.close();
});
