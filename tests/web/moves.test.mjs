// Camera moves in the page: a camera along a curve, the time strip by pen, touch and keys, play, looking through it; nothing of
// that is an edit, and undo gives the drawing back as it was.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, move, open, pictures, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';
import { SCENE } from './tori.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const journal = (page) => page.evaluate(() => globalThis.batten.engine.journal.length);

/**
 * The space bar goes down and up at once, as soon as the playhead is past a time: on a busy machine what lies between two calls from
 * outside can be longer than a tap, or than what is left of the move.
 */
const tapSpace = (page, after = -1) => page.evaluate(async (time) => {
  const { engine } = globalThis.batten;
  while (JSON.parse(engine.string(engine.wasm.editor_move(engine.editor))).at <= time) {
    await new Promise(requestAnimationFrame);
  }
  for (const type of ['keydown', 'keyup']) {
    document.getElementById('stage').dispatchEvent(new KeyboardEvent(type, { key: ' ', code: 'Space', bubbles: true, cancelable: true }));
  }
}, after);

async function begin(t, options) {
  const server = await serve({ name: 'tori.batten', bytes: SCENE });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, options);
  const first = await state(page);
  await page.keyboard.press('v');
  await page.evaluate(() => {
    globalThis.batten.engine.wasm.editor_select(globalThis.batten.engine.editor, 1, 0);
    globalThis.batten.wake();
  });
  await settle(page);
  return { page, hand, first };
}

test('a camera along a curve: made, played, looked through, undone', async (t) => {
  const { page, hand, first } = await begin(t);
  const shot = (name) => pictures(page, `moves-${name}`);
  await page.waitForSelector('#actions [data-name="camera-along"]:not([hidden]), #actions [data-command="camera-along"]:not([hidden])');
  await shot('offered');
  await page.click('#actions [data-name="camera-along"], #actions [data-command="camera-along"]');
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  await shot('made');
  const made = await state(page);
  assert.notEqual(made.digest, first.digest);
  assert.deepEqual([(await move(page)).duration, (await move(page)).playing], [4, 0], 'four seconds, and nothing plays by itself');
  await hand.stroke([[600, 400], [640, 290]], { pointerType: 'mouse', button: 'right' });
  await quiet(page);
  const written = await journal(page);

  const slider = await page.locator('.time-row input').boundingBox();
  await hand.stroke([[slider.x + 8, slider.y + slider.height / 2], [slider.x + 0.4 * slider.width, slider.y + slider.height / 2]], { pointerType: 'pen' });
  await quiet(page);
  const scrubbed = (await move(page)).at;
  await shot('tilted');
  assert.ok(scrubbed > 1.2 && scrubbed < 2, `a pen scrubs: ${scrubbed}`);

  await page.locator('#stage').focus();
  await page.keyboard.press('.');
  const stepped = (await move(page)).at;
  assert.ok(stepped > scrubbed && stepped - scrubbed <= 1 / 24 + 1e-9 && Math.abs(stepped * 24 - Math.round(stepped * 24)) < 1e-6, `a frame on: ${stepped}`);
  await page.keyboard.press(',');
  assert.ok(Math.abs((await move(page)).at - (stepped - 1 / 24)) < 1e-9);

  await tapSpace(page);
  assert.equal((await move(page)).playing, 1, 'a tap of the space bar plays');
  await tapSpace(page, stepped + 0.3);
  assert.equal((await move(page)).playing, 0, 'and stops');
  assert.ok((await move(page)).at < 4, 'before the end');
  await page.keyboard.down(' ');
  await hand.stroke([[500, 300], [520, 320]], { pointerType: 'mouse' });
  await page.keyboard.up(' ');
  assert.equal((await move(page)).playing, 0, 'held, it pans');

  const outside = await page.locator('#space').screenshot();
  await page.keyboard.press('q');
  await page.waitForSelector('#stage.through');
  await quiet(page);
  await shot('through');
  assert.notDeepEqual(await page.locator('#space').screenshot(), outside);
  await page.keyboard.press('Escape');
  await quiet(page);
  assert.equal((await move(page)).through, 0, 'Esc goes back');
  assert.equal(await page.locator('#stage.through').count(), 0);

  const now = await state(page);
  assert.equal(now.digest, made.digest, 'playing is not editing');
  assert.equal(await journal(page), written, 'nothing entered the journal');
  assert.equal(now.check, '');
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, first.digest);
  assert.ok(await page.locator('.time').isHidden(), 'no camera, no strip');
});

test('by touch, from a view, looped and in Korean', async (t) => {
  const { page, hand, first } = await begin(t, { locale: 'ko-KR', reducedMotion: 'reduce', hasTouch: true, isMobile: true, viewport: { width: 1024, height: 768 } });
  await page.evaluate(() => globalThis.batten.engine.command('deselect'));
  await hand.stroke([[600, 400], [660, 300]], { pointerType: 'mouse', button: 'right' });
  await page.evaluate(() => globalThis.batten.engine.command('camera-here'));
  await page.evaluate(() => globalThis.batten.wake());
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  assert.equal((await move(page)).playing, 0, 'with reduced motion, too');
  assert.equal((await move(page)).length, 0, 'a tripod');
  for (const button of await page.locator('.time-row button').all()) {
    const box = await button.boundingBox();
    assert.ok(box.width >= 44 && box.height >= 44, 'a target');
    assert.match(await button.getAttribute('title'), /[가-힣]/);
  }
  const tap = async (command) => {
    const box = await page.locator(`.time [data-command=${command}]`).boundingBox();
    await page.touchscreen.tap(box.x + 22, box.y + 22);
    await settle(page);
  };
  await tap('move-loop');
  await page.keyboard.press('End');
  await tap('move-play');
  assert.equal((await move(page)).playing, 1);
  await page.locator('#stage').focus();
  await page.keyboard.press('End');
  assert.equal((await move(page)).at, 4);
  await page.keyboard.press(' ', { delay: 40 });
  await page.waitForFunction(() => {
    const { engine } = globalThis.batten;
    const now = JSON.parse(engine.string(engine.wasm.editor_move(engine.editor)));
    return now.playing && now.at > 0.05 && now.at < 3;
  });
  assert.equal((await move(page)).loop, 1);
  await tap('look-through');
  await settle(page); // it plays
  await page.screenshot({ path: path.join(SCREENSHOTS, 'moves-here-ko.png') });
  await page.keyboard.press('Escape');
  await page.evaluate(() => globalThis.batten.engine.command('undo'));
  await page.evaluate(() => globalThis.batten.wake());
  await quiet(page);
  assert.equal((await state(page)).digest, first.digest);
});

test('from one view and then from others, by pen and keys: a path through them, one step each; a new camera with nothing selected', async (t) => {
  const { page, hand, first } = await begin(t, {});
  const command = (name) => page.evaluate((id) => {
    globalThis.batten.engine.command(id);
    globalThis.batten.wake();
  }, name);
  await command('deselect');
  await hand.stroke([[600, 400], [660, 300]], { pointerType: 'mouse', button: 'right' });
  await command('camera-here');
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  assert.equal((await move(page)).length, 0, 'a tripod');
  const digests = [first.digest, (await state(page)).digest];
  await command('camera-here');
  await quiet(page);
  assert.equal((await state(page)).digest, digests[1], 'the same view is none');
  assert.match(await page.locator('#notice-text').textContent(), /ends at this view already/);
  for (const [from, to] of [[[600, 400], [480, 420]], [[600, 400], [640, 460]], [[500, 300], [700, 330]]]) {
    await hand.stroke([from, to], { pointerType: 'mouse', button: 'right' });
    await page.locator('#stage').focus();
    await page.keyboard.press('+');
    await quiet(page);
    await command('camera-here');
    await quiet(page);
    const now = await move(page);
    assert.deepEqual([now.cameras, now.duration, now.at], [1, 4, 4], 'the same camera, at the view');
    assert.ok(now.length > 0);
    digests.push((await state(page)).digest);
  }
  assert.match(await page.locator('#notice-text').textContent(), /goes through: 4/);
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `moves-${name}.png`) });
  await shot('views-before');
  await page.keyboard.press('q');
  await page.waitForSelector('#stage.through');
  await quiet(page);
  await shot('views-last');
  assert.equal((await move(page)).through, 1);
  await page.keyboard.press('Escape');
  await page.keyboard.press('-');
  await page.keyboard.press('-');
  await page.keyboard.press('-');
  await quiet(page);
  await shot('views');
  await tapSpace(page);
  await page.waitForFunction(() => {
    const { engine } = globalThis.batten;
    const now = JSON.parse(engine.string(engine.wasm.editor_move(engine.editor)));
    return now.playing && now.at > 0.3 && now.at < 3;
  });
  await tapSpace(page);
  assert.equal((await state(page)).digest, digests.at(-1), 'playing is not editing');
  await command('deselect');
  await command('camera-here');
  await quiet(page);
  assert.deepEqual([(await move(page)).cameras, (await move(page)).length], [2, 0], 'a new one');
  for (const digest of digests.reverse()) {
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal((await state(page)).digest, digest);
  }
  assert.equal((await state(page)).check, '');
});

test('levels and timing over the strip: shake, a stroke over the graph, the duration; undo takes all back', async (t) => {
  const { page, hand, first } = await begin(t, {});
  await page.evaluate(() => globalThis.batten.engine.command('camera-along'));
  await page.evaluate(() => globalThis.batten.wake());
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  const made = (await state(page)).digest;
  await page.click('.time-more');
  await page.waitForSelector('.timing:not([hidden])');
  await page.click('.timing [data-command="shake-add"]');
  await quiet(page);
  assert.equal((await move(page)).gaze.length, 2, 'the base, and the shake');
  const shaken = (await state(page)).digest;
  await page.click('.timing-level:last-child button:last-child'); // solo of the base
  await quiet(page);
  assert.deepEqual((await move(page)).gaze.map(({ muted }) => muted), [0, 1]);
  await page.click('.timing-level:last-child button:last-child');
  await quiet(page);
  assert.equal((await state(page)).digest, shaken);

  const graph = await page.locator('.timing-graph').boundingBox();
  const at = (x, y) => [graph.x + x * graph.width, graph.y + (1 - y) * graph.height];
  await hand.stroke([at(0.3, 0.6), at(0.5, 0.6), at(0.7, 0.6)], { pointerType: 'pen' });
  await quiet(page);
  const drawn = await move(page);
  assert.ok(drawn.graph.every((y, i) => i === 0 || y >= drawn.graph[i - 1] - 1e-12), 'time never runs back');
  assert.ok(Math.abs(drawn.graph[48] - 0.6) < 0.01, `a pause where it is flat: ${drawn.graph[48]}`);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'moves-timing.png') });
  const end = await page.locator('.ease-width').boundingBox();
  const middle = [end.x + end.width / 2, end.y + end.height / 2];
  await hand.stroke([middle, [middle[0] - graph.width / 2, middle[1]]], { pointerType: 'pen' });
  await quiet(page);
  assert.ok(Math.abs((await move(page)).duration - 2) < 0.25, 'the right end is the duration');
  await page.fill('.timing-seconds input', '6');
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.equal((await move(page)).duration, 6);
  await page.click('.timing-end.ease-in');
  await quiet(page);
  assert.ok((await move(page)).graph[1] < drawn.graph[1] / 2, 'a tap eases both ends');
  for (const button of await page.locator('.timing button:visible').all()) {
    const box = await button.boundingBox();
    assert.ok(box.width >= 32 && box.height >= 32, 'a target: 32 px for a mouse, as in the bar');
    assert.ok(await button.evaluate((b) => b.ariaLabel || b.textContent), 'a name');
  }
  assert.equal((await state(page)).check, '');
  const digests = [];
  for (let i = 0; i < 12 && digests.at(-1) !== first.digest; i++) {
    await page.evaluate(() => {
      globalThis.batten.engine.command('undo');
      globalThis.batten.wake();
    });
    await quiet(page);
    digests.push((await state(page)).digest);
  }
  assert.equal(digests.at(-1), first.digest);
  assert.ok(digests.includes(made));
});

test('gaze handles: a pen turns the gaze, a tap adds a key, keys choose, turn and delete it', async (t) => {
  const { page, hand, first } = await begin(t, {});
  await page.evaluate(() => globalThis.batten.engine.command('camera-along'));
  await page.evaluate(() => globalThis.batten.wake());
  await page.waitForSelector('.time:not([hidden])');
  await hand.stroke([[600, 400], [640, 290]], { pointerType: 'mouse', button: 'right' });
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'moves-gazes.png') });
  const made = (await state(page)).digest;
  await page.locator('#stage').focus();
  await page.keyboard.press('>');
  await page.keyboard.press('>');
  await page.keyboard.press('Shift+ArrowUp');
  await quiet(page);
  const up = (await state(page)).digest;
  assert.notEqual(up, made);
  await page.keyboard.press('Insert');
  await page.keyboard.press('Delete');
  await quiet(page);
  assert.equal((await state(page)).check, '');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'moves-gaze-key.png') });
  for (let i = 0; i < 8 && (await state(page)).digest !== first.digest; i++) {
    await page.keyboard.press('Control+z');
    await quiet(page);
  }
  assert.equal((await state(page)).digest, first.digest);
});
