// Hostile files: nothing of them runs or becomes part of the page, what takes long can be cancelled while the page goes on, what
// is too much is said with its number, and what is read in a worker is what would have been read at once.
import assert from 'node:assert/strict';
import path from 'node:path';
import zlib from 'node:zlib';
import { after, before, test } from 'node:test';
import { drop, launch, open, quiet, SCREENSHOTS, state } from './page.mjs';
import { serve } from './server.mjs';

const HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 1000">';
const zigzag = (count) => Array.from({ length: count }, (_, i) => `${(i * 7919) % 1000} ${(i * 104729) % 997}`).join(' ');
const rects = (count) => Array.from({ length: count }, (_, i) => `<rect id="p${i}" class="c${i}" x="${i % 200}" y="${i}" width="1" height="1"/>`).join('');
const pathOf = (count) => `${HEAD}<path fill="none" stroke="#000" d="M0 0L${zigzag(count)}"/></svg>`;

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  server.close();
  await browser.close();
});

/** Chooses a file, as a user does, without waiting for what comes of it. */
const choose = (page, name, content) => page.setInputFiles('#picker', { name, mimeType: 'image/svg+xml', buffer: Buffer.from(content) });

const said = (page, pattern) => page.waitForFunction((source) =>
  [...document.querySelectorAll('#notice-text, #asked span')].some((one) => new RegExp(source).test(one.textContent ?? '')), pattern.source);

/** The page does things while a file is read: each is a turn of its own thread. */
const counting = (page) => page.evaluate(() => {
  globalThis.turns = 0;
  const turn = () => {
    globalThis.turns++;
    requestAnimationFrame(turn);
  };
  requestAnimationFrame(turn);
});

test('what is too much is refused with its number, and the drawing that is open stays', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'first.svg', `${HEAD}<path d="M0 0L10 10"/></svg>`);
  const { digest } = await state(page);
  const bomb = `<!DOCTYPE svg [<!ENTITY a "${'a'.repeat(100000)}">]>${HEAD}<title>${'&a;'.repeat(10000)}</title></svg>`;
  const files = [
    ['million.svg', pathOf(1000000), /more than 300,000 segments/],
    ['spaces.svgz', zlib.gzipSync(Buffer.concat([Buffer.from(HEAD), Buffer.alloc(400 << 20, 32), Buffer.from('</svg>')])), /larger than 128 MB when unpacked/],
    ['entities.svg', bomb, /entities add more than 8 MB/],
    ['attribute.svg', bomb.replace('<title>', '<path id="').replace('</title>', '"/>'), /entities add more than 8 MB/],
    ['elements.svg', `${HEAD}${'<g/>'.repeat(500001)}</svg>`, /more than 500,000 elements/],
    ['deep.svg', `${HEAD}${'<g>'.repeat(100000)}${'</g>'.repeat(100000)}</svg>`, /at most 256 levels/],
    ['cut.svgz', zlib.gzipSync(pathOf(10000)).subarray(0, 5000), /damaged/],
    ['cut.svg', pathOf(10000).slice(0, -8), /Not a well-formed SVG file\. line 1 at column \d+/],
  ];
  for (const [name, content, words] of files) {
    await choose(page, name, content);
    await said(page, new RegExp(`^${name} was not opened.*${words.source}`));
    if (name === 'million.svg') {
      await page.screenshot({ path: path.join(SCREENSHOTS, 'hostile-refused.png') });
    }
    assert.equal(await page.locator('#opening').count(), 0, name);
    assert.equal((await state(page)).digest, digest, name);
    assert.equal(await page.evaluate(() => batten.files.name), 'first.svg');
  }
  await context.close();
});

test('more rules times elements than are tried are refused with the number', async () => {
  const { page, context } = await open(browser, server.address);
  await choose(page, 'rules.svg', `${HEAD}<style>${'rect{fill:red}'.repeat(20000)}</style>${rects(2000)}</svg>`);
  await said(page, /rules.svg was not opened.*33 million style rules/);
  await context.close();
});

test('reading goes on in a worker: the page turns, shows progress, and can cancel', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'first.svg', `${HEAD}<path d="M0 0L10 10"/></svg>`);
  const { digest } = await state(page);
  await counting(page);
  const rules = Array.from({ length: 20000 }, (_, i) => `rect{fill:#${String(i).padStart(6, '0')}}`).join('');
  await choose(page, 'rules.svg', `${HEAD}<style>${rules}</style>${rects(30000)}</svg>`);
  await page.waitForSelector('#opening');
  await page.waitForFunction(() => /rules\.svg/.test(document.getElementById('opening-text')?.textContent ?? ''));
  const before = await page.evaluate(() => globalThis.turns);
  await page.waitForFunction((from) => globalThis.turns > from + 10, before);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'hostile-progress.png') });
  await page.click('#opening button');
  await page.waitForSelector('#opening', { state: 'detached' });
  assert.deepEqual([(await state(page)).digest, await page.evaluate(() => batten.files.name)], [digest, 'first.svg']);
  // The page goes on as before: another file opens.
  await drop(page, 'second.svg', `${HEAD}<path d="M0 0L20 20"/></svg>`);
  assert.notEqual((await state(page)).digest, digest);
  await context.close();
});

test('a heavy path is painted apart: the page turns, and the path is there in the end', async () => {
  const { page, context } = await open(browser, server.address);
  await choose(page, 'heavy.svg', pathOf(20000));
  await page.waitForFunction(() => batten.files.name === 'heavy.svg' && batten.painter.heavy?.made.size === 1, null, { timeout: 60000 });
  await quiet(page);
  const inked = await page.evaluate(() => {
    const still = document.getElementById('still');
    const { data } = still.getContext('2d').getImageData(still.width / 2 - 50, still.height / 2 - 50, 100, 100);
    return data.filter((value, i) => i % 4 === 0 && value < 100).length;
  });
  assert.ok(inked > 1000, `${inked} dark pixels`);
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('what is read in a worker is what is read at once', async () => {
  const { page, context } = await open(browser, server.address);
  const file = `<?xml version="1.0"?><!-- kept -->\n<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="90mm" viewBox="0 0 90 90">
    <style>.a{stroke:red;fill:none} #b{opacity:.5}</style><defs><linearGradient id="l"><stop stop-color="blue"/></linearGradient></defs>
    <g id="layer"><path class="a" d="M1 1C5 9 9 9 20 20S40 3 50 9"/><circle id="b" r="9" cx="30" cy="30" fill="url(#l)"/></g>
    <use xlink:href="#b" x="20"/><text x="5" y="80">words</text>${rects(40)}</svg>\n`;
  const found = await page.evaluate(async ([text]) => {
    const { files, engine } = globalThis.batten;
    const all = [];
    const look = () => all.push([engine.digest(), engine.check(), engine.keeps, engine.losses, new TextDecoder().decode(engine.save(false)),
      new TextDecoder().decode(engine.save(true)), engine.ask('editor_unshown')]);
    engine.openSvg(text, 'a.svg');
    look();
    files.take(await files.read(new TextEncoder().encode(text), 'a.svg', true), 'a.svg');
    look();
    engine.command('select-all');
    engine.command('delete');
    engine.command('undo');
    look();
    return all;
  }, [file]);
  assert.equal(found[0][4], file);
  assert.deepEqual(found[1], found[0]);
  assert.equal(found[2][0], found[0][0]);
  await context.close();
});

test('nothing of a file becomes part of the page, however its namespaces are spelt', async () => {
  const { page, context } = await open(browser, server.address);
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  page.on('dialog', (dialog) => asked.push(dialog.message()));
  const foreign = () => page.evaluate(() => ['script', 'handler', 'iframe', 'foreignObject', 'object', 'embed'].map((name) =>
    document.querySelectorAll(name).length + document.getElementsByTagNameNS('http://www.w3.org/2000/svg', name).length));
  const handlers = () => page.evaluate(() => [...document.querySelectorAll('*')].flatMap((one) => [...one.attributes])
    .filter(({ name, value }) => /^on/i.test(name) || /javascript:/i.test(value)).length);
  const before = await foreign();
  const body = 'onload="document.title=\'ran\'"><script>document.title="ran"</script><handler>x</handler><rect width="9" height="9" onclick="1"/>' +
    '<foreignObject><iframe xmlns="http://www.w3.org/1999/xhtml" src="javascript:parent.document.title=1"/></foreignObject></svg>';
  for (const space of ['http://www.w3.org/2000/svg', '&#104;ttp://www.w3.org/2000/svg', 'http://www.w3.org/2000/&#x73;vg', '&n;']) {
    const name = 'spelt.svg';
    await drop(page, name, `<!DOCTYPE svg [<!ENTITY n "http://www.w3.org/2000/svg">]><svg xmlns="${space}" ${body}`);
    await page.waitForFunction((one) => batten.files.name === one, name);
    await quiet(page);
    assert.equal(await page.evaluate(() => batten.engine.still.some((item) => item.id > 0)), true, space);
    assert.equal(await handlers(), 0);
    assert.notEqual(await page.title(), 'ran');
    await page.evaluate(() => { batten.files.name = 'none.svg'; });
  }
  assert.deepEqual(await foreign(), before);
  assert.deepEqual(asked.filter((address) => !address.startsWith(server.address) && !/^(blob|data):/.test(address)), []);
  await context.close();
});
