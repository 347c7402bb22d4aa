// The type face of the page: it comes after the first picture, nothing moves when it does, and nothing is missed without it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, expectFaults, Hand, launch, place, quiet, ready, reveal, SCREENSHOTS, state } from './page.mjs';
import { edit, EXAMPLE, serve } from './server.mjs';

const FONT = '**/fonts/*.woff2';
const PLACES = '.bar, .bar button, .rail button, .inspector, .inspector :is(section, h2, h3, button, input, select, label), .foot, .foot button, .foot input';

let browser;
let program;
before(async () => {
  browser = await launch();
  program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
});
after(async () => {
  await browser.close();
  program.close();
});

/** A page whose requests for the face are answered by `answer`; what it asks for is noted. */
async function visit(answer, { address = program.address, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  const asked = [];
  context.on('request', (request) => asked.push(request.url()));
  await page.route(FONT, answer);
  await page.goto(address);
  await ready(page);
  return { page, asked, hand: new Hand(page, await context.newCDPSession(page)) };
}

const loaded = (page) => page.evaluate(() => [...document.fonts].filter(({ status }) => status === 'loaded').map(({ family }) => family.replaceAll('"', '')));

/** How wide the page's own words are: a line of text, and ones and zeros in fields and elsewhere. */
const widths = (page) => page.evaluate(() => ['Hamburgefonstiv', '1111', '0000', '1111 tabular-nums', '0000 tabular-nums'].map((text) => {
  const [words, variant = ''] = text.split(' ');
  const span = document.createElement('span');
  span.textContent = words;
  span.style.fontVariantNumeric = variant;
  span.style.position = 'absolute';
  document.body.append(span);
  const { width } = span.getBoundingClientRect();
  span.remove();
  return width;
}));

const boxes = (page) => page.evaluate((what) => [...document.querySelectorAll(what)].map((part) => {
  const { x, y, width, height } = part.getBoundingClientRect();
  return [part.dataset.name || part.id || part.className || part.textContent, x, y, part.matches('label') ? 0 : width, height];
}), PLACES);

for (const [name, options] of Object.entries({ 'en-light': { colorScheme: 'light' }, 'en-dark': { colorScheme: 'dark' },
  'ko-dark': { colorScheme: 'dark', locale: 'ko-KR' } })) {
  test(`${name}: it comes after the first picture, from this server, and no control moves`, async () => {
    let bring = () => {};
    const held = new Promise((done) => { bring = done; });
    const { page, asked } = await visit(async (route) => {
      await held;
      await route.continue();
    }, options);
    for (const part of ['numbers', 'style', 'objects', 'layers']) {
      await reveal(page, part);
    }
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await page.waitForFunction(() => batten.engine.words);
    await quiet(page);
    const [early, before] = [await widths(page), await boxes(page)];
    assert.ok(before.length > 100);
    assert.deepEqual(await loaded(page), []);
    await page.screenshot({ path: path.join(SCREENSHOTS, `face-${name}-before.png`) });

    bring();
    await page.waitForFunction(() => document.fonts.size > 0);
    await quiet(page);
    assert.deepEqual(await loaded(page), ['Batten-Inter']);
    assert.equal(await page.evaluate(() => document.fonts.check('600 13px "Batten-Inter"')), true);
    const late = await widths(page);
    assert.ok(Math.abs(late[0] - early[0]) > 1, 'the words are in another face');
    assert.ok(late[2] - late[1] > 1, 'its ones are narrower than its zeros');
    assert.equal(late[3], late[4], 'but not where figures stand below each other');
    const now = await boxes(page);
    const moved = before.filter((box, i) => box.slice(1).some((value, k) => Math.abs(now[i][k + 1] - value) > 1));
    assert.deepEqual(moved, []);
    assert.equal(now.length, before.length);
    await page.screenshot({ path: path.join(SCREENSHOTS, `face-${name}-after.png`) });

    const fetched = asked.filter((url) => url.endsWith('.woff2'));
    assert.equal(fetched.length, 1);
    assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(program.address)), []);
    const [asks, painted] = await page.evaluate(() => [performance.getEntriesByType('resource').find((entry) => entry.name.endsWith('.woff2')).startTime,
      performance.getEntriesByName('first-contentful-paint')[0].startTime]);
    assert.ok(asks >= painted, `asked for after ${asks} ms, painted after ${painted} ms`);
    const licence = await page.evaluate(async (url) => (await fetch(url)).text(), fetched[0].replace(/[^/]*$/, 'OFL.txt'));
    assert.match(licence, /Copyright .* The Inter Project Authors[\s\S]*SIL OPEN FONT LICENSE\n\nVersion 1\.1/);
  });
}

for (const [what, answer] of Object.entries({ missing: (route) => route.fulfill({ status: 404 }), 'cut off': (route) => route.abort(),
  'no font': (route) => route.fulfill({ body: 'no font', contentType: 'font/woff2' }), silent: () => {} })) {
  test(`${what}: everything works, and nothing is said`, async () => {
    expectFaults(/status of 404/, /ERR_FAILED/, /Failed to decode|OTS parsing/);
    const { page, hand } = await visit(answer);
    await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/page/face.js')));
    await quiet(page);
    const before = (await state(page)).digest;
    await hand.stroke(await Promise.all(bezier([388, 176], [460, 90], [700, 60], [842, 169]).map(([x, y]) => place(page, x, y))));
    await quiet(page);
    const { digest, notice } = await state(page);
    assert.notEqual(digest, before);
    assert.equal(notice, '');
    assert.deepEqual(await loaded(page), []);
  });
}

test('an empty page offers what to begin with, whether the face comes or not', async () => {
  const empty = await edit(Buffer.alloc(0), 'new.svg');
  for (const answer of [(route) => route.continue(), () => {}]) {
    const { page } = await visit(answer, { address: empty.address });
    await page.waitForSelector('.start-button');
  }
  empty.close();
});

test('a build without it does not ask for it', async () => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  const { page, asked } = await visit((route) => route.continue(), { address: server.address });
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/page/face.js')));
  await quiet(page);
  assert.deepEqual(asked.filter((url) => /fonts|FACE/.test(url)), []);
  assert.deepEqual(await loaded(page), []);
  server.close();
});
