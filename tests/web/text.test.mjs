// Texts: typed in place with the browser's shaping, kept as text in every file, moved, turned, copied and undone as other objects are.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { drop, launch, open, place, quiet, reveal, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

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

const PAGE = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300"></svg>';
const field = '.writing textarea';

/** Files as they would be saved. */
const saved = (page) => page.evaluate(() => {
  const text = (native) => new TextDecoder().decode(batten.engine.save(native));
  return { svg: text(false), native: JSON.parse(text(true)) };
});
/** Texts of the drawing as the native file has them. */
const texts = async (page) => (await saved(page)).native.objects.filter(({ kind }) => kind === 'text');

/** Types a text at a place of the page, and waits until the drawing shows it. */
async function write(page, x, y, words) {
  await page.focus('#stage');
  await page.keyboard.press('F8');
  await page.mouse.click(...await place(page, x, y));
  await page.waitForSelector(field);
  await page.waitForFunction(() => document.activeElement.matches('.writing textarea'));
  await page.keyboard.insertText(words);
}
async function accept(page) {
  await page.keyboard.press('Escape');
  await page.waitForSelector(field, { state: 'detached' });
  await quiet(page);
}

/** Where there is ink in a box of the page: low x, low y, high x, high y in its units, or null. */
const inkIn = (page, box) => page.evaluate(([x0, y0, x1, y1]) => {
  const { still, ratio } = batten.painter;
  const { x, y, zoom } = batten.painter.painted;
  const at = (u, v) => [Math.round((u - x) * zoom * ratio), Math.round((v - y) * zoom * ratio)];
  const [left, top] = at(x0, y0);
  const [right, bottom] = at(x1, y1);
  const { data, width } = still.getContext('2d').getImageData(left, top, right - left, bottom - top);
  const found = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i] < 128) {
      const [u, v] = [(left + i / 4 % width) / ratio / zoom + x, (top + Math.floor(i / 4 / width)) / ratio / zoom + y];
      found[0] = Math.min(found[0], u), found[1] = Math.min(found[1], v), found[2] = Math.max(found[2], u), found[3] = Math.max(found[3], v);
    }
  }
  return found[0] < found[2] ? found : null;
}, box);

test('typed, accepted, edited, moved, undone, and kept as text', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'page.svg', PAGE);
  const empty = (await state(page)).digest;
  await write(page, 60, 100, 'Hello 한글');
  const typed = await page.locator(field).boundingBox();
  await page.screenshot({ path: path.join(SCREENSHOTS, 'text-typed.png') });
  await accept(page);
  let [text] = await texts(page);
  assert.equal(text.text, 'Hello 한글');
  assert.deepEqual(text.matrix.slice(0, 4), [1, 0, 0, 1]);
  assert.equal(await page.evaluate(() => batten.loop.selected), 1);
  const [px, py] = await place(page, text.matrix[4] + text.box[0], text.matrix[5] + text.box[1]);
  assert.ok(Math.abs(px - typed.x) < 4 && py > typed.y - 8 && py < typed.y + typed.height, 'it stands where it was typed');
  const ink = await inkIn(page, [0, 0, 400, 300]);
  assert.ok(ink && ink[0] >= 59 && ink[1] < 100 && ink[3] < 115 && Math.abs(ink[2] - text.matrix[4] - text.box[2]) < 3, String(ink));
  await page.screenshot({ path: path.join(SCREENSHOTS, 'text-placed.png') });
  await reveal(page, 'objects'); // named by what it says, with a picture
  assert.equal(await page.textContent('#objects [role=row] .object-name'), 'Hello 한글');
  await page.waitForFunction(() => {
    const { width, height } = document.querySelector('#objects .thumbnail');
    return document.querySelector('#objects .thumbnail').getContext('2d').getImageData(0, 0, width, height).data.some((value) => value > 0);
  });

  // A double click edits it; Enter begins a line; undo and redo go over it.
  const middle = await place(page, 70, 95);
  await page.mouse.dblclick(...middle);
  await page.waitForFunction(() => document.activeElement.matches('.writing textarea'));
  assert.equal(await page.inputValue(field), 'Hello 한글');
  assert.equal(await inkIn(page, [0, 0, 400, 300]), null, 'the drawing\'s own picture makes room');
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.type('you');
  await accept(page);
  [text] = await texts(page);
  assert.equal(text.text, 'Hello 한글\nyou');
  assert.ok(text.box[3] > 1.2 * text.size);
  const two = (await state(page)).digest;
  await page.keyboard.press('Control+z');
  assert.equal((await texts(page))[0].text, 'Hello 한글');
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).digest, empty);
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+Shift+z');
  assert.equal((await state(page)).digest, two);

  // Dragged, turned and doubled as any object; the file says it as text, and it is opened as one.
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 40, middle[1] + 30, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.press('Control+ArrowRight');
  await page.keyboard.press('Control+d');
  await settle(page);
  const [first, second] = await texts(page);
  assert.ok(first.matrix[4] !== text.matrix[4] && first.matrix[1] !== 0 && second.text === text.text);
  const { svg } = await saved(page);
  assert.equal(svg.match(/<text /g).length, 2);
  assert.ok(!svg.includes('<image') && svg.includes('<tspan'));
  const { digest } = await state(page);
  const journal = await page.evaluate(() => batten.engine.journal);
  assert.ok(!String(journal).includes('"data"'), 'the journal says what was written, not what it looks like');
  for (const [name, file] of [['again.svg', svg], ['bare.svg', svg.replace(/<metadata>.*<\/metadata>/s, '')]]) {
    await drop(page, name, file);
    await quiet(page);
    assert.deepEqual((await texts(page)).map(({ text: words, matrix }) => [words, matrix]), [first, second].map(({ text: words, matrix }) => [words, matrix]), name);
  }
  assert.notEqual(digest, empty);
  await context.close();
});

test('empty ones are taken away, and nothing is written where nothing was typed', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'page.svg', PAGE);
  const { digest } = await state(page);
  await write(page, 50, 50, ' ');
  await accept(page);
  assert.equal((await state(page)).digest, digest);
  await write(page, 50, 50, 'gone');
  await accept(page);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement.matches('.writing textarea'));
  await page.keyboard.press('Delete');
  await page.mouse.click(...await place(page, 300, 250));
  await page.waitForSelector(field, { state: 'detached' });
  assert.deepEqual(await texts(page), []);
  await page.keyboard.press('Control+z');
  assert.equal((await texts(page))[0].text, 'gone');

  // The page is hidden while something is typed, as on a phone that then ends it.
  await write(page, 50, 150, 'half a wor');
  await page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  assert.equal((await texts(page))[1].text, 'half a wor');
  await context.close();
});

test('how letters look is said in the inspector, of several texts in one step', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'page.svg', PAGE);
  await write(page, 60, 80, 'one');
  await accept(page);
  await write(page, 60, 160, 'two\nlines');
  await accept(page);
  await page.waitForSelector('#text-size');
  await page.fill('#text-size', '40');
  await page.locator('#text-size').blur();
  await page.selectOption('#text-align', 'middle');
  await page.check('#text-italic');
  await settle(page);
  let [first, second] = await texts(page);
  assert.deepEqual([second.size, second.align, second.italic], [40, 'middle', true]);
  assert.ok(second.box[0] < -20 && second.box[2] > 20, String(second.box));
  assert.equal(first.size === 40, false);
  await page.focus('#stage');
  await page.keyboard.press('Control+a');
  await quiet(page);
  assert.equal(await page.inputValue('#text-size'), '', 'they differ');
  await page.selectOption('#text-weight', '700');
  await page.fill('#text-family', 'serif');
  await page.locator('#text-family').blur();
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'text-inspector.png') });
  [first, second] = await texts(page);
  assert.deepEqual([first, second].map(({ weight, family }) => [weight, family]), [[700, 'serif'], [700, 'serif']]);
  await page.focus('#stage');
  await page.keyboard.press('Control+z');
  [first, second] = await texts(page);
  assert.deepEqual([first.family, second.family], ['sans-serif', 'sans-serif'], 'one step');
  await page.evaluate(() => { batten.engine.set('fill-colour', 0xff0000ff); batten.wake(); });
  await quiet(page);
  assert.deepEqual((await texts(page)).map(({ fill }) => fill), ['#ff0000ff', '#ff0000ff']);
  await context.close();
});

const BROUGHT = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">
  <g transform="translate(20 10) rotate(10)"><text id="title" x="40" y="60" style="font-size:24px;font-family:sans-serif;fill:#0000aa;font-weight:bold">Old words</text></g>
  <text x="40" y="200" font-size="20">one <tspan fill="red">red</tspan> word</text>
  <rect x="300" y="20" width="40" height="40" fill="#00f"/>
</svg>`;

test('a plain text that a file brings is edited as text; any other stays as it is, and that is said', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'brought.svg', BROUGHT);
  await page.keyboard.press('v');
  await page.waitForFunction(() => [...batten.painter.pictures.values()].filter((picture) => picture).length === 2);
  await quiet(page);
  const before = await inkIn(page, [0, 0, 280, 120]);
  assert.deepEqual(await texts(page), []);
  await page.mouse.dblclick(...await place(page, 75, 80));
  await page.waitForFunction(() => document.activeElement.matches('.writing textarea'));
  assert.equal(await page.inputValue(field), 'Old words');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'text-brought.png') });
  await accept(page); // nothing was changed: it stays foreign
  assert.deepEqual(await texts(page), []);
  await page.mouse.dblclick(...await place(page, 75, 80));
  await page.waitForFunction(() => document.activeElement.matches('.writing textarea'));
  await page.keyboard.press('End');
  await page.keyboard.type('!');
  await accept(page);
  const [text] = await texts(page);
  assert.equal(text.text, 'Old words!');
  assert.deepEqual([text.size, text.weight, text.fill, text.family], [24, 700, '#0000aaff', 'sans-serif']);
  const after = await inkIn(page, [0, 0, 280, 120]);
  for (const k of [0, 1]) {
    assert.ok(Math.abs(after[k] - before[k]) < 1.5, `${before} and ${after}`); // in the same place, turned as it was
  }
  const { svg } = await saved(page);
  assert.match(svg, />Old words!</);
  assert.match(svg, /<tspan fill="red">red<\/tspan>/);
  assert.match(svg, /<rect x="300" y="20" width="40" height="40" fill="#00f"\/>/);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await texts(page), []);

  await page.mouse.dblclick(...await place(page, 60, 195));
  await page.waitForSelector('text=one font and one colour');
  assert.equal(await page.locator(field).count(), 0);
  await context.close();
});
