// Human motion in the page: a BVH file is dropped and is a skeleton; it plays; a pen chooses a joint, its levels are mixed, and a stroke over
// the graph redraws its angle; undo gives the drawing back as it was.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, drop, faceOn, launch, move, open, pictures, place, quiet, SCREENSHOTS, state } from './page.mjs';
import { serve } from './server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const FRAMES = 48;
const BONES = /** name, depth, offset, swing in degrees */ [['Hips', 0, [0, 0, 0], 4], ['Chest', 1, [0, 40, 0], 5], ['Head', 2, [0, 30, 0], 6],
  ['LeftArm', 2, [16, 20, 0], 25], ['LeftHand', 3, [0, -50, 0], 20], ['RightArm', 2, [-16, 20, 0], -25], ['RightHand', 3, [0, -50, 0], 20],
  ['LeftLeg', 1, [9, -4, 0], -30], ['LeftFoot', 2, [0, -44, 0], 20], ['RightLeg', 1, [-9, -4, 0], 30], ['RightFoot', 2, [0, -44, 0], 20]];

/** A walk of eleven joints. */
function walk() {
  const lines = ['HIERARCHY'];
  BONES.forEach(([name, depth, offset], i) => {
    const tab = '\t'.repeat(depth);
    lines.push(`${tab}${depth ? 'JOINT' : 'ROOT'} ${name}`, `${tab}{`, `${tab}\tOFFSET ${offset.join(' ')}`);
    lines.push(`${tab}\tCHANNELS ${depth ? 3 : '6 Xposition Yposition Zposition'} Zrotation Xrotation Yrotation`);
    const next = BONES[i + 1]?.[1] ?? 0;
    if (next <= depth) {
      lines.push(`${tab}\tEnd Site`, `${tab}\t{`, `${tab}\t\tOFFSET 0 ${name === 'Head' ? 20 : -40} 0`, `${tab}\t}`);
    }
    for (let d = depth; d >= next; d--) {
      lines.push(`${'\t'.repeat(d)}}`);
    }
  });
  lines.push('MOTION', `Frames: ${FRAMES}`, 'Frame Time: 0.041666666666666664');
  for (let f = 0; f < FRAMES; f++) {
    const t = (2 * Math.PI * f) / 24;
    const turns = BONES.flatMap(([, , , swing]) => [0.2 * swing * Math.cos(t), swing * Math.sin(t), 3 * Math.sin(2 * t)]);
    lines.push([1.5 * f, 90 + 2 * Math.cos(2 * t), 2 * f, ...turns].join(' '));
  }
  return lines.join('\n');
}

const numbers = (/** @type {string} */ text) => text.slice(text.indexOf('Frame Time')).match(/-?\d[\d.e+-]*/g).map(Number);

/** The numbers of the walk as the page exports it: the time of a frame, then those of all frames. */
async function exported(page) {
  await page.keyboard.press('Control+Shift+E');
  await page.selectOption('#export-format', 'bvh');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export .strong')]);
  assert.equal(download.suggestedFilename(), 'walk.bvh');
  return numbers(String(await downloaded(download)));
}

/** How high the root is in each frame. */
const heights = (values) => Array.from({ length: FRAMES }, (_, f) => values[1 + f * (3 + 3 * BONES.length) + 1]);

test('a walk: dropped, played, a joint chosen, mixed, redrawn, undone', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  const shot = (name) => pictures(page, `body-${name}`);
  await drop(page, 'walk.bvh', walk());
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  await shot('opened');
  const first = await state(page);
  const opened = await move(page);
  assert.ok(Math.abs(opened.duration - (FRAMES - 1) / 24) < 1e-9);
  assert.equal(opened.joints.length, BONES.length);
  assert.equal(await page.locator('.time [data-command=look-through]').isVisible(), false, 'it sees nothing');

  await page.click('.time-more');
  await quiet(page);
  assert.deepEqual(await page.locator('.timing-joint option').allTextContents(), BONES.map(([name]) => name));
  await page.selectOption('.timing-joint', { label: 'LeftLeg' });
  await page.selectOption('.timing-angle', { label: 'X' });
  const slider = await page.locator('.time-row input').boundingBox();
  await hand.stroke([[slider.x + 8, slider.y + slider.height / 2], [slider.x + 0.3 * slider.width, slider.y + slider.height / 2]], { pointerType: 'pen' });
  await quiet(page);
  await shot('joint');
  assert.equal((await move(page)).angles[(await move(page)).angle], 'X');
  assert.equal((await state(page)).digest, first.digest, 'looking and choosing are not editing');

  const box = await page.locator('.timing-graph').boundingBox();
  const { graph, range } = await move(page);
  const stroke = Array.from({ length: 13 }, (_, i) => {
    const x = 0.25 + i / 24;
    return [box.x + x * box.width, box.y + (1 - graph[Math.round(96 * x)] - 0.2 * Math.sin((Math.PI * i) / 12)) * box.height];
  });
  await hand.stroke(stroke, { pointerType: 'pen' });
  await quiet(page);
  await shot('redrawn');
  const redrawn = await move(page);
  const degrees = (share, [low, high]) => low + share * (high - low); // the range may have grown
  const change = graph.map((share, i) => degrees(redrawn.graph[i], redrawn.range) - degrees(share, range));
  const wanted = 0.2 * (range[1] - range[0]);
  assert.ok(Math.abs(change[48] - wanted) < 0.05 * wanted, `the angle is where the stroke is: ${change[48]} degrees, not ${wanted}`);
  assert.ok(Math.max(...change.slice(0, 10).map(Math.abs)) < 1e-6, 'and elsewhere where it was');
  assert.notEqual((await state(page)).digest, first.digest);

  const muted = page.locator('.timing-levels').nth(1).locator('li').first().locator('button').nth(1);
  await muted.click();
  await quiet(page);
  assert.equal(await muted.getAttribute('aria-pressed'), 'true');
  for (const target of await page.locator('.timing button:visible, .timing select:visible').all()) {
    const size = await target.boundingBox();
    assert.ok(size.height >= 32, `${size.height} px high`);
  }
  await page.locator('#stage').focus();
  await page.keyboard.press('Control+Z');
  await page.keyboard.press('Control+Z');
  await quiet(page);
  const now = await state(page);
  assert.equal(now.digest, first.digest, 'undone');
  assert.equal(now.check, '');

  const [written, given] = [await exported(page), numbers(walk())];
  assert.equal(written.length, given.length);
  assert.ok(written.every((value, i) => Math.abs(value - given[i]) < 1e-9), 'exported as it was dropped');
  await context.close();
});

test('a camera that stands still sees the walk: docked and looked through, scrubbed and played', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await drop(page, 'walk.bvh', walk());
  await page.waitForSelector('.time:not([hidden])');
  await quiet(page);
  await page.evaluate(() => {
    globalThis.batten.engine.command('deselect');
    globalThis.batten.engine.command('camera-here');
    globalThis.batten.wake();
  });
  await page.waitForSelector('.lens:not([hidden])');
  await quiet(page);
  const made = await state(page);
  const docked = () => page.evaluate(() => document.querySelector('.lens canvas').toDataURL());
  const seek = async (seconds) => {
    await page.evaluate((time) => {
      globalThis.batten.engine.wasm.editor_seek(globalThis.batten.engine.editor, time);
      globalThis.batten.wake();
    }, seconds);
    await quiet(page);
  };
  const first = await docked();
  await page.screenshot({ path: path.join(SCREENSHOTS, 'body-docked-first.png') });
  await seek(0.25);
  const later = await docked();
  await page.screenshot({ path: path.join(SCREENSHOTS, 'body-docked-later.png') });
  assert.notEqual(later, first, 'the body stands elsewhere');
  await seek(0);
  assert.equal(await docked(), first);
  await hand.stroke([[600, 300], [640, 250]], { pointerType: 'mouse', button: 'right' });
  await quiet(page);
  await seek(0.25);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'body-docked-turned.png') });
  await seek(0);
  await page.locator('#stage').focus();
  await page.keyboard.press('q');
  await page.waitForSelector('#stage.through');
  await quiet(page);
  const through = await page.locator('#space').screenshot();
  await seek(0.25);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'body-through.png') });
  assert.notDeepEqual(await page.locator('#space').screenshot(), through);
  await page.keyboard.press('Escape');
  await seek(0);
  await page.click('.time [data-command=move-play]');
  await page.waitForFunction((still) => document.querySelector('.lens canvas').toDataURL() !== still, first);
  await page.click('.time [data-command=move-play]');
  assert.equal((await state(page)).digest, made.digest);
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('the path of a walk is a curve: laid out by a button, moved by keys, redrawn by a pen, and the walk follows; undone', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const { page, hand, context } = await open(browser, server.address);
  await drop(page, 'walk.bvh', walk());
  await page.waitForSelector('.time:not([hidden])');
  await faceOn(page); // where places of the drawing are seen
  await quiet(page);
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `body-path-${name}.png`) });
  const first = await state(page);
  await page.locator('#stage').focus();
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await page.click('#actions [data-name="body-path"], #actions [data-command="body-path"]');
  await quiet(page);
  const laid = await state(page);
  assert.notEqual(laid.digest, first.digest);
  assert.equal(laid.check, '');
  await shot('laid-out');
  const seek = (seconds) => page.evaluate((time) => {
    globalThis.batten.engine.wasm.editor_seek(globalThis.batten.engine.editor, time);
    globalThis.batten.wake();
  }, seconds);
  await seek(1.9);
  await quiet(page);
  const before = await page.locator('#overlay').screenshot();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowUp');
  await quiet(page);
  await shot('raised');
  const raised = await state(page);
  assert.notEqual(raised.digest, laid.digest);
  assert.equal(raised.check, '');
  assert.notDeepEqual(await page.locator('#overlay').screenshot(), before, 'the body at the playhead has moved');
  const up = heights(await exported(page));
  const given = heights(numbers(walk()));
  assert.ok(up.every((height, f) => Math.abs(height - given[f] - 12) < 1e-6), 'the whole walk is higher by what the keys say');

  // Over the middle of the path, higher by 14 there.
  await page.evaluate(() => globalThis.batten.engine.command('tool-sketch'));
  const stroke = [];
  for (let i = 0; i <= 24; i++) {
    stroke.push(await place(page, 10 + 2 * i, -102.5 - 14 * Math.sin((Math.PI * i) / 24)));
  }
  await seek(1);
  await quiet(page);
  const stood = await page.locator('#overlay').screenshot();
  await hand.stroke(stroke, { pointerType: 'pen' });
  await quiet(page);
  await page.getByRole('button', { name: 'Redraw', exact: true }).click(); // it could be a line of its own
  await quiet(page);
  await seek(1);
  await quiet(page);
  await shot('redrawn');
  const redrawn = await state(page);
  assert.notEqual(redrawn.digest, raised.digest);
  assert.equal(redrawn.check, '');
  assert.notDeepEqual(await page.locator('#overlay').screenshot(), stood, 'the body at the playhead has moved');
  const bent = heights(await exported(page));
  const change = bent.map((height, f) => height - up[f]);
  assert.ok(Math.max(...change) > 8 && change.indexOf(Math.max(...change)) > FRAMES / 4, `the walk goes over the bump: ${change.map((x) => x.toFixed(1))}`);
  assert.ok(Math.abs(change[0]) < 1.5 && Math.abs(change[FRAMES - 1]) < 1.5, 'and begins and ends where it did');
  await page.locator('#stage').focus();
  for (let i = 0; i < 8 && (await state(page)).digest !== first.digest; i++) {
    await page.keyboard.press('Control+z');
    await quiet(page);
  }
  assert.equal((await state(page)).digest, first.digest);
  await context.close();
});
