// A whole session by trusted input: a path is drawn, a camera flies along it, looks at something and along again, gets keys, shakes, is
// edited at a level and timed by a stroke, plays, is downloaded and written for players; undone to the beginning, the drawing is
// what it was.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, launch, move, open, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { PROGRAM, serve } from './server.mjs';
import { SCENE } from './tori.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('from a stroke to a flight, and back', async (t) => {
  const server = await serve({ name: 'tori.batten', bytes: SCENE });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-flight-'));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  const first = await state(page);
  const seen = [first.digest];
  const changed = async (what) => {
    await quiet(page);
    const { digest, check } = await state(page);
    assert.equal(check, '');
    assert.ok(!seen.includes(digest), what);
    seen.push(digest);
  };
  const key = async (name) => {
    await page.keyboard.press(name);
    await quiet(page);
  };

  await key('n'); // the sketch tool
  const way = Array.from({ length: 40 }, (_, i) => [150 + 20 * i, 260 + 60 * Math.sin(i / 6)]);
  await hand.stroke(way, { pointerType: 'pen' });
  await changed('a path is drawn');
  await page.locator('#stage').focus();
  await key('v');
  await page.mouse.click(...way[20]);
  await quiet(page);
  await page.click('#actions [data-name="camera-along"], #actions [data-command="camera-along"]');
  await page.waitForSelector('.time:not([hidden])');
  await changed('a camera flies along it');
  await page.locator('#stage').focus();
  await page.mouse.move(600, 520);
  await key('Shift+A');
  await changed('it looks at what the pen is over');
  await key('Shift+W');
  await quiet(page);
  assert.equal((await state(page)).digest, seen[2], 'and along the path again, as before');
  await key('>');
  await key('Shift+ArrowUp');
  await changed('a key is turned');
  await key('End');
  await key(',');
  await key('Insert');
  await changed('a key is added');

  await page.click('.time-more');
  await page.click('.timing [data-command="shake-add"]');
  await changed('it shakes');
  await page.locator('.timing-choose', { hasText: '1' }).last().click();
  await quiet(page);
  assert.deepEqual((await move(page)).gaze.map(({ active }) => active), [0, 1]);
  await page.locator('#stage').focus();
  await key('>');
  await key('ArrowLeft');
  await changed('it is turned at the level of the shake');
  const graph = await page.locator('.timing-graph').boundingBox();
  const at = (x, y) => [graph.x + x * graph.width, graph.y + (1 - y) * graph.height];
  await hand.stroke([at(0.3, 0.5), at(0.5, 0.5), at(0.6, 0.5)], { pointerType: 'pen' });
  await changed('it pauses');
  await page.click('.time-more');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'flight.png') });

  const lens = await page.locator('.lens canvas').boundingBox();
  await hand.stroke([[lens.x + 100, lens.y + 80], [lens.x + 140, lens.y + 90]], { pointerType: 'pen' });
  await changed('it is corrected in what it sees');
  const written = await page.evaluate(() => globalThis.batten.engine.journal.length);
  await page.click('.time [data-command="move-play"]');
  await page.waitForFunction(() => {
    const { engine } = globalThis.batten;
    return JSON.parse(engine.string(engine.wasm.editor_move(engine.editor))).at > 0.3;
  });
  await page.click('.time [data-command="move-play"]');
  await settle(page);
  assert.equal(await page.evaluate(() => globalThis.batten.engine.journal.length), written, 'playing is not editing');

  await page.click('[data-name=menu]');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-command=download-native]')]);
  const drawing = JSON.parse(String(await downloaded(download)));
  const camera = drawing.objects.find(({ kind }) => kind === 'camera');
  fs.writeFileSync(path.join(folder, 'move.json'), JSON.stringify(camera.move));
  execFileSync(PROGRAM, ['camera', path.join(folder, 'move.json'), '--fps', '24', '--out', path.join(folder, 'flight.glb')]);
  assert.equal(fs.readFileSync(path.join(folder, 'flight.glb')).subarray(0, 4).toString(), 'glTF');

  await page.locator('#stage').focus();
  for (let i = 0; i < 20 && (await state(page)).digest !== first.digest; i++) {
    await key('Control+z');
  }
  assert.equal((await state(page)).digest, first.digest, 'undone to the beginning');
});
