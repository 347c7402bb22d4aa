// Two pages on one drawing: one edits it, the other is read-only and may take it over with all unsaved work.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, Hand, launch, open, place, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const SKY = bezier([60, 60], [140, 20], [220, 100], [320, 60]);
const ROOF = bezier([440, 137], [490, 103], [560, 92], [690, 114]);

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const on = (page, points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
const standing = (page) => page.evaluate(() => document.querySelector('[data-about=owner] span')?.textContent ?? '');

async function another(context, address) {
  const page = await context.newPage();
  await page.goto(address);
  await ready(page);
  return { page, hand: new Hand(page, await context.newCDPSession(page)) };
}

/** Takes the drawing over, and waits until this page has it. */
async function take(page) {
  await page.click('[data-about=owner] button');
  await page.waitForSelector('[data-about=kept] >> text=brought back');
  await settle(page);
}

async function until(page, text) {
  await page.waitForSelector(`[data-about=owner] >> text=${text}`);
}

test('the second page looks on, takes over, and gives back', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const first = await open(browser, server.address);
  await first.hand.stroke(await on(first.page, SKY));
  const drawn = await state(first.page);
  assert.equal(await standing(first.page), '');

  const second = await another(first.context, server.address);
  assert.match(await standing(second.page), /car\.svg is open in another tab/);
  const shown = await state(second.page);
  // A pen moves the view and keys change nothing; what the first page keeps is not overwritten.
  await second.hand.stroke(await on(second.page, ROOF));
  await second.page.keyboard.press('Control+A');
  await second.page.keyboard.press('Delete');
  await second.page.keyboard.press('Control+S');
  await settle(second.page);
  assert.equal((await state(second.page)).digest, shown.digest);
  assert.equal(server.saves, 0);
  await second.page.screenshot({ path: path.join(SCREENSHOTS, 'elsewhere.png') });
  await second.page.emulateMedia({ colorScheme: 'dark' });
  await settle(second.page);
  await second.page.screenshot({ path: path.join(SCREENSHOTS, 'elsewhere-dark.png') });

  await take(second.page);
  assert.equal(await standing(second.page), '');
  await until(first.page, 'open in another tab');
  assert.equal((await state(second.page)).digest, drawn.digest, 'unsaved work came along');
  await second.page.keyboard.press('Escape');
  await second.hand.stroke(await on(second.page, ROOF));
  const more = await state(second.page);
  assert.notEqual(more.digest, drawn.digest);
  await first.hand.stroke(await on(first.page, ROOF));
  assert.equal((await state(first.page)).digest, drawn.digest, 'the first looks on now');

  await first.page.bringToFront();
  await take(first.page);
  assert.equal(await standing(first.page), '');
  assert.equal((await state(first.page)).digest, more.digest, 'and back');
  await first.page.keyboard.press('Control+S');
  await first.page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.equal(server.saves, 1);
  await first.context.close();
});

test('a page that was killed holds nothing; one that hangs is overruled', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(() => server.close());
  const first = await open(browser, server.address);
  await first.hand.stroke(await on(first.page, SKY));
  const drawn = await state(first.page);
  await first.page.evaluate(() => batten.keeper.settled());
  // It hangs and will not answer.
  await first.page.evaluate(() => {
    batten.tabs.channel.onmessage = null;
  });
  const second = await another(first.context, server.address);
  await second.page.evaluate(() => { globalThis.hasty = true; });
  await take(second.page);
  assert.equal((await state(second.page)).digest, drawn.digest);
  await until(first.page, 'open in another tab');
  const crashed = second.page.waitForEvent('crash');
  (await first.context.newCDPSession(second.page)).send('Page.crash').catch(() => {});
  await crashed;
  const third = await another(first.context, server.address);
  assert.equal(await standing(third.page), '');
  assert.equal((await state(third.page)).digest, drawn.digest);
  await first.context.close();
});

test('without a server the last drawing opens as it was left, and another tab begins a new one', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const first = await open(browser, server.address);
  await first.hand.stroke(await on(first.page, SKY));
  await first.page.keyboard.press('Escape');
  const drawn = await state(first.page);
  await first.page.evaluate(() => batten.keeper.settled());
  const second = await another(first.context, server.address);
  assert.equal(await standing(second.page), '');
  assert.equal(await second.page.textContent('#name'), 'drawing 2.svg');
  assert.equal(await second.page.isVisible('#welcome'), true);
  await second.hand.stroke(await on(second.page, ROOF));
  const other = await state(second.page);
  await second.page.evaluate(() => batten.keeper.settled());
  await first.page.close();
  await second.page.close();
  // The latest one first, then the other.
  const third = await another(first.context, server.address);
  assert.equal(await third.page.textContent('#name'), 'drawing 2.svg');
  assert.equal((await state(third.page)).digest, other.digest);
  assert.match((await state(third.page)).notice, /as you left it/);
  await third.page.screenshot({ path: path.join(SCREENSHOTS, 'as-left.png') });
  const fourth = await another(first.context, server.address);
  assert.equal(await fourth.page.textContent('#name'), 'drawing.svg');
  assert.equal((await state(fourth.page)).digest, drawn.digest);
  await fourth.page.click('[data-about=left] button');
  await fourth.page.waitForFunction(() => document.getElementById('name').textContent === 'drawing 3.svg');
  await settle(fourth.page);
  assert.equal(await fourth.page.isVisible('#welcome'), true);
  assert.deepEqual((await fourth.page.evaluate(() => batten.keeper.list())).map(({ name }) => name).sort(), ['drawing 2.svg', 'drawing.svg']);
  await first.context.close();
});
