// How a drawing was drawn, shared as a link that carries it, and as a film made in the page.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, downloaded, expectFaults, Hand, inThemes, launch, open, quiet, ready, SCREENSHOTS, state } from './page.mjs';
import { serve } from './server.mjs';

const EMPTY = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 600"/>');
const WAVE = bezier([500, 300], [600, 180], [760, 460], [900, 300]);
const HUMP = bezier([560, 268], [620, 210], [680, 250], [700, 320]);

let browser;
let server;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve({ name: 'hill.svg', bytes: EMPTY })]);
});
after(async () => {
  await browser.close();
  server.close();
});

async function drawn(options = {}) {
  const all = await open(browser, server.address, { permissions: ['clipboard-read', 'clipboard-write'], ...options });
  await all.hand.stroke(WAVE);
  await all.hand.stroke(HUMP);
  await quiet(all.page);
  return all;
}

async function ask(page) {
  await page.click('#logo');
  await page.click('[data-act=share]');
  await page.waitForSelector('#share[open]');
}

const paths = (page) => page.evaluate(() => new TextDecoder().decode(batten.engine.save(false)).match(/ d="[^"]*"/g));
const shot = (page, name) => page.screenshot({ path: path.join(SCREENSHOTS, `share-${name}.png`) });

test('a link carries the drawing and how it was drawn; whoever opens it sees that, and has a drawing of their own', async () => {
  const { page, context } = await drawn();
  await ask(page);
  await page.waitForTimeout(3500); // in the midst of the film
  await inThemes(page, async (scheme) => shot(page, scheme));
  await page.click('#share button[value=link]');
  await page.waitForFunction(() => document.querySelector('.notices').textContent.includes('The link is copied'));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(link.startsWith(`${server.address}#replay=`) && link.length < 8192, `${link.length}`);
  const wanted = await paths(page);
  await context.close();

  const other = await serve();
  const second = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const visitor = await second.newPage();
  await visitor.goto(link.replace(server.address, other.address));
  await ready(visitor);
  await visitor.waitForSelector('canvas.film');
  await visitor.waitForTimeout(2500);
  await shot(visitor, 'seen');
  await visitor.mouse.move(300, 300);
  await visitor.keyboard.press('Escape');
  await visitor.waitForFunction(() => !document.querySelector('canvas.film'));
  assert.deepEqual(await paths(visitor), wanted);
  assert.equal((await state(visitor)).check, '');
  // It is theirs: they draw on, and a reload brings that back, not the film.
  const hand = new Hand(visitor, await second.newCDPSession(visitor));
  await hand.stroke(bezier([300, 500], [400, 420], [500, 580], [600, 500]));
  await visitor.evaluate(() => batten.keeper.settled());
  const now = await paths(visitor);
  assert.equal(now.length, wanted.length + 1);
  await visitor.evaluate(() => { batten.files.leaving = true; });
  await visitor.reload();
  await ready(visitor);
  assert.deepEqual(await paths(visitor), now);
  assert.equal(await visitor.locator('canvas.film').count(), 0);
  await second.close();
  other.close();
});

test('with reduced motion it is offered, and a link that is cut off is said to be damaged', async (t) => {
  expectFaults(t, /./);
  const { page, context } = await drawn({ reducedMotion: 'reduce' });
  await ask(page);
  await shot(page, 'still');
  await page.click('#share button[value=link]');
  await page.waitForFunction(() => document.querySelector('.notices').textContent.includes('The link is copied'));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await context.close();
  const other = await serve();
  const second = await browser.newContext({ reducedMotion: 'reduce' });
  for (const [fragment, told] of [[link.split('#')[1], 'This is how it was drawn'], [link.split('#')[1].slice(0, -40), 'damaged'], ['replay=@@', 'damaged']]) {
    const visitor = await second.newPage();
    await visitor.goto(`${other.address}#${fragment}`);
    await ready(visitor);
    await visitor.waitForFunction((text) => document.querySelector('.notices').textContent.includes(text), told);
    assert.equal(await visitor.locator('canvas.film').count(), 0);
    await visitor.close();
  }
  await second.close();
  other.close();
});

test('a film of six seconds is made, and can be cancelled', async () => {
  const { page, context } = await drawn();
  const film = async () => {
    await ask(page);
    await page.click('#share button[value=film]');
    await page.waitForSelector('#film[open]');
  };
  await film();
  await page.click('#film button');
  await page.waitForFunction(() => !document.getElementById('film'));
  const download = page.waitForEvent('download');
  await film();
  await shot(page, 'film');
  const file = await download;
  assert.equal(file.suggestedFilename(), 'hill.gif');
  const bytes = await downloaded(file);
  fs.writeFileSync(path.join(SCREENSHOTS, 'share.gif'), bytes);
  const times = [];
  for (let at = bytes.indexOf('21f904', 'hex'); at >= 0; at = bytes.indexOf('21f904', at + 1, 'hex')) {
    times.push(bytes.readUInt16LE(at + 4) / 100);
  }
  const length = times.reduce((sum, time) => sum + time, 0);
  assert.ok(times.length > 40 && length > 5.5 && length < 7.5, `${times.length} pictures, ${length} s`);
  // As the browser's own reader has it: empty at first, and the drawing in the end.
  const dark = await page.evaluate(async (data) => {
    const decoder = new ImageDecoder({ data: Uint8Array.from(atob(data), (c) => c.charCodeAt(0)), type: 'image/gif' });
    await Promise.all([decoder.completed, decoder.tracks.ready]);
    const context = new OffscreenCanvas(800, 450).getContext('2d');
    const count = async (frameIndex) => {
      const { image } = await decoder.decode({ frameIndex });
      context.drawImage(image, 0, 0);
      image.close();
      return context.getImageData(0, 0, 800, 450).data.filter((value, i) => i % 4 === 0 && value < 60).length;
    };
    return [await count(0), await count(decoder.tracks.selectedTrack.frameCount - 1)];
  }, bytes.toString('base64'));
  assert.ok(dark[0] < 20 && dark[1] > 200, `${dark}`);
  await context.close();
});

test('what is too much for a link says so, and leaves the film and the journal', async () => {
  const long = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 600">${Array.from({ length: 900 }, (_, i) =>
    `<path d="M${(i * 7919) % 900} ${(i * 104729) % 600}c${i % 97}.${i} 3 ${i % 31} 11 ${i % 89} ${(i * 31) % 41}" fill="none" stroke="#${(i * 2654435761 % 0xffffff).toString(16).padStart(6, '0')}"/>`).join('')}</svg>`;
  const large = await serve({ name: 'large.svg', bytes: Buffer.from(long) });
  const { page, context } = await open(browser, large.address, { locale: 'ko-KR', viewport: { width: 390, height: 780 } });
  await ask(page);
  assert.match(await page.innerText('#share'), /링크에 담기에는 너무 큽니다: \d+\.\dkB/);
  assert.equal(await page.locator('#share button[value=link]').count(), 0);
  await shot(page, 'large-phone');
  const download = page.waitForEvent('download');
  await page.click('#share button[value=journal]');
  assert.match((await download).suggestedFilename(), /\.journal$/);
  await context.close();
  large.close();
});
