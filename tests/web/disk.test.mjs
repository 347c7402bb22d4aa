// label: smoke. Files on disk that the page may write; several files at once; a file named by the page's address. The handles are those
// of the browser's private file system, which is the same interface as that of the picker, without its window.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { expectFaults, launch, open, place, ready, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const ART = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300"><!-- kept -->
  <path d="M50 50H150V150H50Z" fill="#00f"/></svg>
`;

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

/** Makes files, and lets the picker give them; none: nothing is chosen. */
const offer = (page, files) => page.evaluate(async (all) => {
  const folder = await navigator.storage.getDirectory();
  const handles = await Promise.all(all.map(async ([name, text]) => {
    const handle = await folder.getFileHandle(name, { create: true });
    const writable = await handle.createWritable();
    await writable.write(text);
    await writable.close();
    return handle;
  }));
  window.showOpenFilePicker = () => (handles.length ? Promise.resolve(handles) :
    Promise.reject(new DOMException('nothing was chosen', 'AbortError')));
}, files);

const content = (page, name) => page.evaluate(async (file) => {
  const handle = await (await navigator.storage.getDirectory()).getFileHandle(file);
  return (await handle.getFile()).text();
}, name);

const named = (page, name) => page.waitForFunction((text) => document.getElementById('name').textContent === text, name);
const asked = (page) => page.textContent('.asked');
const objects = (page) => page.evaluate(() => batten.engine.layers().loose + batten.painter.list.length);

async function begin(files, { address } = server) {
  const opened = await open(browser, address);
  await offer(opened.page, files);
  await opened.page.click('[data-name=open]');
  return opened;
}

const draw = async (page, hand) => hand.stroke(await Promise.all([[200, 60], [260, 80], [330, 50]].map(([x, y]) => place(page, x, y))));

test('a drawing is saved back to the file that was chosen, and what was not edited stays', async () => {
  const { page, hand, context } = await begin([['art.svg', ART]]);
  await named(page, 'art.svg');
  await draw(page, hand);
  assert.equal((await state(page)).unsaved, true);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => !batten.files.unsaved);
  const text = await content(page, 'art.svg');
  assert.ok(text.includes('<!-- kept -->') && text.match(/<path/g).length >= 2, text);
  await draw(page, hand);
  await page.keyboard.press('Control+S'); // its own writing is no change by another
  await page.waitForFunction(() => !batten.files.unsaved);
  assert.ok((await content(page, 'art.svg')).length > text.length);
  await context.close();
});

test('a file that another program has changed is not overwritten before the user says so', async () => {
  const { page, hand, context } = await begin([['art.svg', ART]]);
  await named(page, 'art.svg');
  await draw(page, hand);
  const other = ART.replace('#00f', '#0f0f0f');
  await offer(page, [['art.svg', other]]);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.querySelector('.asked')?.textContent.length > 10);
  assert.equal(await content(page, 'art.svg'), other);
  assert.equal((await state(page)).unsaved, true);
  await page.getByRole('button', { name: 'Overwrite' }).click();
  await page.waitForFunction(() => !batten.files.unsaved);
  assert.match(await content(page, 'art.svg'), /#00f/);
  await context.close();
});

test('nothing chosen: nothing happens; a format that cannot hold the drawing is saved as a download', async () => {
  const { page, hand, context } = await begin([]);
  await settle(page);
  assert.equal(await page.textContent('#name'), 'drawing.svg');
  await offer(page, [['points.csv', 'x,y\n10,10\n60,110\n120,40\n200,60\n']]);
  await page.click('[data-name=open]');
  await named(page, 'points.csv');
  await draw(page, hand);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+S')]);
  assert.equal(download.suggestedFilename(), 'points.svg');
  assert.match(await content(page, 'points.csv'), /^x,y/);
  await context.close();
});

test('a packed file opens as what is in it; a damaged one is refused in words', async () => {
  const { page, context } = await open(browser, server.address);
  const packed = gzipSync(ART);
  const dropped = (name, bytes) => page.evaluate(([title, data]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([new Uint8Array(data)], title));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, [name, [...bytes]]);
  await dropped('art.svgz', packed);
  await named(page, 'art.svgz');
  assert.ok(await objects(page) >= 1);
  await dropped('bad.svgz', packed.subarray(0, packed.length - 12));
  await page.waitForFunction(() => document.querySelector('.notices').textContent.includes('bad.svgz was not opened. It is damaged'));
  assert.equal(await page.textContent('#name'), 'art.svgz');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+S')]);
  assert.equal(download.suggestedFilename(), 'art.svg');
  await context.close();
});

test('several files are added to the drawing, each as a group; undo takes them away', async () => {
  const { page, hand, context } = await open(browser, server.address);
  await draw(page, hand);
  const { digest } = await state(page);
  const two = ART.replace('</svg>', '<path d="M200 200H300" stroke="#000"/></svg>');
  await offer(page, [['one.svg', two], ['two.csv', 'x,y\n10,10\n60,110\n120,40\n'], ['bad.svg', '<svg']]);
  await page.click('[data-name=open]');
  await page.waitForFunction(() => document.querySelector('.asked').textContent.includes('bad.svg'));
  await settle(page);
  assert.equal(await page.textContent('#name'), 'drawing.svg');
  assert.ok(await objects(page) >= 4);
  assert.match(await asked(page), /bad\.svg was not opened/);
  for (let step = 0; step < 6 && (await state(page)).digest !== digest; step++) {
    await page.keyboard.press('Control+Z');
    await settle(page);
  }
  assert.equal((await state(page)).digest, digest);
  await context.close();
});

test('the address opens a file of the same server, says what it cannot open, and asks no other server', async () => {
  const { page, context } = await open(browser, `${server.address}?open=1/icons/batten.svg`);
  assert.equal(await page.textContent('#name'), 'batten.svg');
  assert.ok(await page.evaluate(() => batten.painter.list.length) > 1);
  for (const [asked, why] of [['https://example.org/a.svg', 'another server'], ['nothing.svg', '404']]) {
    if (why === '404') {
      expectFaults(/404/);
    }
    await page.goto(`${server.address}?open=${encodeURIComponent(asked)}`);
    await ready(page);
    await page.waitForFunction((text) => document.querySelector('.notices').textContent.includes(text), why);
  }
  await context.close();
});

test('files that were opened are listed, open again to be saved where they are, and are taken off the list', async (t) => {
  const lasting = await serve(undefined, true);
  t.after(() => lasting.close());
  const { page, hand, context } = await begin([['art.svg', ART]], lasting);
  await named(page, 'art.svg');
  await offer(page, [['two.svg', ART.replace('#00f', '#0a0')]]);
  await page.click('[data-name=open]');
  await named(page, 'two.svg');
  const rows = () => page.$$eval('#kept ul:last-of-type li bdi', (all) => all.map((one) => one.textContent));
  const list = async () => {
    await page.evaluate(() => batten.engine.command('open-kept') && batten.wake());
    await page.waitForSelector('#kept:popover-open');
  };
  await list();
  await page.reload();
  await ready(page);
  await list();
  assert.deepEqual(await rows(), ['two.svg', 'art.svg']);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'recent.png') });
  await page.click('#kept ul:last-of-type li:nth-child(2) button:first-child');
  await named(page, 'art.svg');
  await draw(page, hand);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => !batten.files.unsaved);
  assert.match(await content(page, 'art.svg'), /kept -->[^]*<path[^]*<path/);
  await list();
  assert.deepEqual(await rows(), ['art.svg', 'two.svg'], 'the latest first, none twice');
  await page.evaluate(async () => (await navigator.storage.getDirectory()).removeEntry('two.svg'));
  await page.click('#kept ul:last-of-type li:nth-child(2) button:first-child');
  await page.waitForFunction(() => document.querySelector('.notices').textContent.includes('two.svg could not be read'));
  await list();
  await page.click('#kept ul:last-of-type li:nth-child(2) button.keys');
  await page.waitForFunction(() => document.querySelectorAll('#kept ul:last-of-type li').length === 1);
  assert.match(await content(page, 'art.svg'), /kept -->/, 'the file itself stays');
  await context.close();
});
