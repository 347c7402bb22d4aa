// label: smoke. The main task from end to end: open the example, redraw the roof line with the pen, undo, redo, save, reload, compare
// the file.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, downloaded, expectFaults, GONE, inked, launch, open, place, ready, SCREENSHOTS, settle, state, texts } from './page.mjs';
import { edit, EXAMPLE, serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** The pen's path: over the middle of the roof, slightly above it. */
const NEW_ROOF = [[440, 135], [490, 88], [580, 80], [690, 115]];

/**
 * Distances of points from the nearest of a file's outlines, as the browser renders the file.
 * @returns {Promise<number[]>}
 */
function distances(page, text, points) {
  return page.evaluate(([svg, asked]) => {
    const root = document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true);
    document.body.append(root);
    const nearest = asked.map(() => Infinity);
    for (const path of root.querySelectorAll('path')) {
      const length = path.getTotalLength();
      const count = Math.ceil(length);
      const places = Array.from({ length: count + 1 }, (_, i) => path.getPointAtLength((length * i) / count));
      for (let i = 1; i < places.length; i++) {
        const [a, b] = [places[i - 1], places[i]];
        const [dx, dy] = [b.x - a.x, b.y - a.y];
        asked.forEach(([x, y], k) => {
          const t = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
          nearest[k] = Math.min(nearest[k], Math.hypot(a.x + t * dx - x, a.y + t * dy - y));
        });
      }
    }
    root.remove();
    return nearest;
  }, [text, points]);
}

/** @param {{ address: string, bytes: Buffer, close: () => void }} server */
async function wholeSession(server) {
  const { page, hand, context } = await open(browser, server.address);
  const opened = await state(page);
  assert.equal(opened.check, '');
  assert.equal(opened.unsaved, false);
  assert.equal(await page.textContent('#name'), 'car.svg');
  assert.ok(await inked(page, 'still') > 10000, 'the drawing is painted');
  assert.equal(await page.isDisabled('[data-name=undo]'), true);

  // The curve lights up before the pen lands.
  assert.equal(await inked(page, 'overlay'), 0);
  await hand.hover(await place(page, 592, 103.5));
  assert.ok(await inked(page, 'overlay') > 500, 'the roof lights up');
  const strings = await texts(page);
  assert.equal((await state(page)).hint, strings['hint.redraw']);

  // The final fit is shown while the pen is down; the document is unchanged.
  const drawn = bezier(...NEW_ROOF);
  const path = await Promise.all(drawn.map(([x, y]) => place(page, x, y)));
  await hand.stroke(path, {
    during: async () => {
      assert.ok(await inked(page, 'overlay') > 500, 'the preview shows');
      assert.equal((await state(page)).digest, opened.digest);
      assert.match(await page.textContent('#readouts'), /Knots\s*\d+ → \d+/);
    },
  });
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, opened.digest);
  assert.equal(redrawn.check, '');
  assert.equal(redrawn.unsaved, true);
  assert.equal(await page.isVisible('#readouts >> text=Knots'), false);

  await page.click('[data-name=undo]');
  await settle(page);
  assert.equal((await state(page)).digest, opened.digest);
  assert.equal((await state(page)).unsaved, false);
  await page.keyboard.press('Control+Shift+Z');
  await settle(page);
  assert.equal((await state(page)).digest, redrawn.digest);

  const before = server.bytes.toString();
  await page.click('[data-name=save]');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);

  await page.reload();
  await ready(page);
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  const reloaded = await state(page);
  assert.equal(reloaded.digest, redrawn.digest, 'every knot is as it was');
  assert.equal(reloaded.unsaved, false);

  // The file in another program: the roof follows the pen, everything else is where it was.
  const saved = server.bytes.toString();
  const inner = drawn.slice(8, -8);
  const far = await distances(page, saved, inner);
  assert.ok(Math.max(...far) < 1.5, `the pen's way is followed: ${Math.max(...far)}`);
  const was = await distances(page, before, inner);
  assert.ok(Math.max(...was) > 4, 'the pen went elsewhere than the old roof');
  const rest = [[806, 160], [842, 170], [70, 243], [744, 224], [232, 360]];
  const moved = await distances(page, saved, rest);
  assert.ok(Math.max(...moved) < 0.2, `the rest stays: ${moved}`);
  await context.close();
}

test('open, redraw the roof, undo, redo, save, reload, compare', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  await wholeSession(server);
  assert.equal(server.saves, 1);
});

test('the same with the program itself, on a file', async (t) => {
  const server = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(server.close);
  await wholeSession(server);
});

test('the program and a native file', async (t) => {
  const native = await edit(Buffer.from(''), 'new.batten');
  t.after(native.close);
  const { page, hand, context } = await open(browser, native.address);
  assert.equal(await page.textContent('#name'), 'new.batten');
  await hand.stroke(bezier([300, 300], [500, 100], [700, 500], [900, 300]));
  const { digest } = await state(page);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  const saved = JSON.parse(native.bytes.toString());
  assert.equal(saved.batten, 7); // a pen's line has widths
  assert.equal(saved.objects.length, 1);
  await page.reload();
  await ready(page);
  assert.equal((await state(page)).digest, digest);
  await context.close();
});

/** The question and its answers. @returns {Promise<string[]>} */
const answers = (page, about = 'changed') => page.locator(`[data-about=${about}] button`).allTextContents();
const shown = (page) => page.waitForFunction(() => [...document.querySelectorAll('#compare img')]
  .filter((picture) => picture.complete && picture.naturalWidth > 0).length === 2);

test('a file that changed on disk: both can be seen, and nothing is written over unless it is wanted', async (t) => {
  expectFaults(/status of 412/, /status of 409/);
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, hand, context } = await open(browser, server.address);
  await hand.stroke(bezier(...await Promise.all([[60, 60], [140, 20], [220, 100], [320, 60]].map(([x, y]) => place(page, x, y)))));
  const foreign = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100"><path d="M10 90Q100 0 190 90" ' +
    'fill="none" stroke="#a00" stroke-width="3"/></svg>');
  server.bytes = foreign;
  await page.keyboard.press('Control+S');
  await page.waitForSelector('[data-about=changed]');
  assert.match((await state(page)).notice, /changed on disk/);
  assert.deepEqual(await answers(page), ['Look at both', 'Overwrite', 'Save beside it', '×']);
  assert.equal((await state(page)).unsaved, true);

  // Nothing can be written beside it: the reason is given, and a download offered instead.
  await page.click('text=Save beside it');
  await page.waitForSelector('[data-about=changed] >> text=read-only');
  assert.deepEqual(await answers(page), ['Look at both', 'Overwrite', 'Download a copy', '×']);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Download a copy')]);
  assert.equal(download.suggestedFilename(), 'car.svg');
  assert.deepEqual(await answers(page), ['Look at both', 'Overwrite', 'Save beside it', '×'], 'it is as it was');

  server.beside = 'car (copy).svg';
  await page.click('text=Save beside it');
  await page.waitForSelector('[data-about=changed] >> text=car (copy).svg');
  assert.equal((await state(page)).unsaved, true, 'the drawing is still that of the file');

  await page.click('text=Look at both');
  await shown(page);
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await settle(page);
    await page.screenshot({ path: path.join(SCREENSHOTS, `compare-${colorScheme}.png`) });
  }
  await page.keyboard.press('Escape');
  await page.waitForSelector('#compare', { state: 'detached' });
  assert.equal(server.bytes, foreign);
  await page.keyboard.press('Control+S');
  await settle(page);
  assert.equal(server.bytes, foreign, 'to have looked allows nothing');

  await page.click('text=Look at both');
  await shown(page);
  const newer = server.bytes = Buffer.from(foreign.toString().replace('#a00', '#00a'));
  await page.click('#compare [value=overwrite]');
  await page.waitForSelector('[data-about=changed]');
  assert.equal(server.bytes, newer, 'only what was looked at is written over');

  await page.click('[data-about=changed] >> text=Overwrite');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(server.bytes.toString(), /batten:document/);
  assert.equal(await page.isVisible('[data-about=changed]'), false);
  await context.close();
});

/** As when its window becomes visible again. */
const lookedAt = (page) => page.evaluate(() => dispatchEvent(new Event('focus')));

test('the program saves beside a file that changed on disk, which is noticed before the next save', async (t) => {
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await page.waitForLoadState('networkidle');
  await hand.stroke(bezier(...await Promise.all([[60, 60], [140, 20], [220, 100], [320, 60]].map(([x, y]) => place(page, x, y)))));
  await lookedAt(page);
  await settle(page);
  assert.equal(await page.isVisible('[data-about=changed]'), false);
  const foreign = program.bytes = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"><path d="M10 90Q100 0 190 90"/></svg>');
  await lookedAt(page);
  await page.waitForSelector('[data-about=changed] >> text=changed on disk');
  for (const name of ['car (copy).svg', 'car (copy 2).svg']) {
    await page.click('text=Save beside it');
    await page.waitForSelector(`[data-about=changed] >> text=${name}`);
    assert.match(program.beside(name).toString(), /batten:document/);
  }
  await page.screenshot({ path: path.join(SCREENSHOTS, 'beside.png') });
  assert.deepEqual(program.bytes, foreign);
  // Once closed, the question is not asked again about the same version.
  await page.click('[data-about=changed] button:last-of-type');
  await lookedAt(page);
  await settle(page);
  assert.equal(await page.isVisible('[data-about=changed]'), false);
  await context.close();
});

test('a program that ends and is started again is noticed while nobody saves', async (t) => {
  expectFaults(/status of 403/, ...GONE);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await page.waitForLoadState('networkidle');
  await hand.stroke(bezier(...await Promise.all([[60, 60], [140, 20], [220, 100], [320, 60]].map(([x, y]) => place(page, x, y)))));
  await program.kill();
  await lookedAt(page);
  await page.waitForSelector('[data-about=silent] >> text=server stopped');
  // The server is asked again soon, automatically.
  await page.evaluate(() => { globalThis.hasty = true; });
  await lookedAt(page);
  await program.start();
  await page.waitForSelector('[data-about=silent]', { state: 'detached' });
  await page.waitForFunction(() => /Connected to/.test(document.getElementById('notice-text').textContent));
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(program.bytes.toString(), /batten:document/);
  await context.close();
});

test('a server that takes a question and gives no answer is silent, too', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, context } = await open(browser, server.address);
  await page.waitForLoadState('networkidle');
  await page.route('**/document', (route) => (route.request().method() === 'HEAD' ? null : route.continue()));
  await lookedAt(page);
  await page.waitForSelector('[data-about=silent] >> text=server stopped');
  await page.unroute('**/document');
  await lookedAt(page);
  await page.waitForSelector('[data-about=silent]', { state: 'detached' });
  await context.close();
});

test('a page that nobody sees asks for nothing', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, context } = await open(browser, server.address);
  await page.waitForLoadState('networkidle');
  await lookedAt(page);
  await page.waitForLoadState('networkidle');
  await settle(page);
  const heard = server.heard;
  assert.ok(heard > 0);
  const turn = (hidden) => page.evaluate((hidden) => {
    Object.defineProperty(document, 'hidden', { configurable: true, value: hidden });
    document.dispatchEvent(new Event('visibilitychange'));
  }, hidden);
  await turn(true);
  await lookedAt(page);
  await settle(page);
  assert.equal(server.heard, heard);
  await turn(false);
  while (server.heard === heard) {
    await settle(page);
  }
  assert.equal(server.heard, heard + 1);
  await context.close();
});

test('a native file that changed on disk is a picture, too', async (t) => {
  expectFaults(/status of 412/);
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const car = await open(browser, server.address);
  const native = await car.page.evaluate(() => new TextDecoder().decode(batten.engine.save(true)));
  await car.context.close();
  const other = await serve({ name: 'car.batten', bytes: Buffer.from(native) });
  t.after(other.close);
  const { page, hand, context } = await open(browser, other.address);
  await hand.stroke(bezier([300, 300], [500, 100], [700, 500], [900, 300]));
  other.bytes = Buffer.from(`${native}\n`);
  await page.keyboard.press('Control+S');
  await page.click('text=Look at both');
  await shown(page);
  await page.click('#compare [value=overwrite]');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.notEqual(other.bytes.toString().trim(), native.trim());
  await context.close();
});

test('a program started again is found without a reload; one with another file is not taken for it', async (t) => {
  expectFaults(/status of 403/, ...GONE);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await page.waitForLoadState('networkidle');
  const line = bezier(...await Promise.all([[60, 60], [140, 20], [220, 100], [320, 60]].map(([x, y]) => place(page, x, y))));
  await hand.stroke(line);
  const { address } = program;
  await program.kill();
  await page.keyboard.press('Control+S');
  await page.waitForSelector('[data-about=unsaved] >> text=server stopped');
  assert.deepEqual(await answers(page, 'unsaved'), ['Try again', 'Download a copy', '×']);
  assert.equal((await state(page)).unsaved, true);

  await program.start();
  assert.equal(program.address, address);
  await page.click('[data-about=unsaved] >> text=Try again');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.equal(await page.isVisible('[data-about=unsaved]'), false);
  assert.match(program.bytes.toString(), /batten:document/);

  await program.kill();
  const stranger = await edit(fs.readFileSync(EXAMPLE), 'bus.svg', '--port', new URL(address).port);
  t.after(() => stranger.close());
  await hand.stroke(line.map(([x, y]) => [x, y + 40]));
  await page.keyboard.press('Control+S');
  await page.waitForSelector('[data-about=unsaved] >> text=token');
  assert.deepEqual(stranger.bytes, fs.readFileSync(EXAMPLE));
  assert.equal((await state(page)).unsaved, true);
  await context.close();
});

test('what was said goes when the next stroke begins', async (t) => {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  t.after(server.close);
  const { page, hand, context } = await open(browser, server.address);
  await page.keyboard.press('Control+Z');
  await page.waitForSelector('#notice >> text=Nothing to undo');
  await hand.stroke(bezier([300, 300], [500, 100], [700, 500], [900, 300]), {
    during: async () => assert.equal(await page.isVisible('#notice'), false),
  });
  assert.doesNotMatch(await page.textContent('#notice-text'), /Nothing to undo/);
  await context.close();
});

test('a folder that was moved: it is said where the file may be, and a copy is offered', async (t) => {
  expectFaults(/status of 409/);
  const program = await edit(fs.readFileSync(EXAMPLE), 'car.svg');
  t.after(() => program.close());
  const { page, hand, context } = await open(browser, program.address);
  await page.waitForLoadState('networkidle');
  await hand.stroke(bezier(...await Promise.all([[60, 60], [140, 20], [220, 100], [320, 60]].map(([x, y]) => place(page, x, y)))));
  const away = `${program.folder}-away`;
  t.after(() => fs.rmSync(away, { recursive: true, force: true }));
  fs.renameSync(program.folder, away);
  await lookedAt(page);
  for (const [about, buttons] of [['silent', ['Download a copy', '×']], ['unsaved', ['Try again', 'Download a copy', '×']]]) {
    if (about === 'unsaved') {
      await page.keyboard.press('Control+S'); // refused, which is said in place of the first
    }
    await page.waitForSelector(`[data-about=${about}] >> text=may now be in ${away}`);
    assert.deepEqual(await answers(page, about), buttons);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-about=${about}] >> text=Download a copy`)]);
    assert.match((await downloaded(download)).toString(), /batten:document/);
  }
  assert.deepEqual(fs.readFileSync(`${away}/car.svg`), fs.readFileSync(EXAMPLE));
  assert.equal((await state(page)).unsaved, true);

  fs.renameSync(away, program.folder);
  await page.keyboard.press('Control+S');
  await page.waitForFunction(() => document.getElementById('unsaved').hidden);
  assert.match(program.bytes.toString(), /batten:document/);
  await context.close();
});
