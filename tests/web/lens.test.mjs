// What the camera sees, docked in a corner of the drawing: corrected by pen, mouse, wheel and keys, at rest and while it flies; it
// makes way for the pen, has the size one gives it, and changes places with the room; undo takes all back.
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

const box = (page) => page.locator('.lens canvas').boundingBox();
/** Different colours in the docked picture. */
const colours = (page) => page.evaluate(() => {
  const canvas = document.querySelector('.lens canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return new Set(new Uint32Array(data.buffer)).size;
});
const shown = (page) => page.evaluate(() => document.querySelector('.lens canvas').toDataURL());

async function begin(t, options) {
  const server = await serve({ name: 'tori.batten', bytes: SCENE });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, options);
  // Its style sheet comes when all that is there has long been painted.
  await page.route('**/lens.css', async (route) => {
    await quiet(page);
    await route.continue();
  });
  const first = await state(page);
  await page.keyboard.press('v');
  await page.evaluate(() => {
    globalThis.batten.engine.wasm.editor_select(globalThis.batten.engine.editor, 1, 0);
    globalThis.batten.engine.command('camera-along');
    globalThis.batten.wake();
  });
  await page.waitForSelector('.lens:not([hidden])');
  await quiet(page);
  return { page, hand, first };
}

async function undone(page, digest) {
  for (let i = 0; i < 12 && (await state(page)).digest !== digest; i++) {
    await page.evaluate(() => {
      globalThis.batten.engine.command('undo');
      globalThis.batten.wake();
    });
    await quiet(page);
  }
  assert.equal((await state(page)).digest, digest);
}

test('the docked view shows what the camera sees', async (t) => {
  const { page, hand, first } = await begin(t);
  assert.ok(await colours(page) > 20, `surfaces are painted: ${await colours(page)}`);
  await pictures(page, 'lens-face-on');
  const still = await shown(page);
  await hand.stroke([[600, 400], [640, 290]], { pointerType: 'mouse', button: 'right' });
  await quiet(page);
  assert.ok(await colours(page) > 20);
  assert.equal(await shown(page), still, 'the room turns, and the camera sees what it saw');
  await page.evaluate(() => {
    const { engine, wake } = globalThis.batten;
    engine.wasm.editor_seek(engine.editor, 1.5);
    wake();
  });
  await quiet(page);
  assert.notEqual(await shown(page), still, 'the playhead moves it');
  await pictures(page, 'lens-tilted');
  const { width, height } = await box(page);
  assert.ok(Math.abs(width / height - 16 / 9) < 0.02);
  const name = await page.locator('.lens canvas').getAttribute('aria-label');
  assert.ok(name && name !== 'lens.name', name);
  await page.click('.time [data-command=lens]');
  await quiet(page);
  assert.ok(await page.locator('.lens').isHidden());
  await page.locator('#stage').focus();
  await page.keyboard.press('Shift+U');
  await quiet(page);
  assert.ok(await page.locator('.lens').isVisible());
  await undone(page, first.digest);
  assert.ok(await page.locator('.lens').isHidden(), 'no camera, no view');
});

test('corrected by pen, mouse, wheel and keys; Esc takes a correction back; it flies on', async (t) => {
  const { page, hand, first } = await begin(t, {});
  const made = (await state(page)).digest;
  const { x, y, width, height } = await box(page);
  const at = (u, v) => [x + u * width, y + v * height];
  const still = await shown(page);
  await hand.stroke([at(0.4, 0.5), at(0.5, 0.55), at(0.6, 0.6)], { pointerType: 'pen' });
  await quiet(page);
  const turned = (await state(page)).digest;
  assert.notEqual(turned, made, 'a pen turns the gaze');
  assert.notEqual(await shown(page), still);
  await hand.stroke([at(0.4, 0.5), at(0.5, 0.55)], { pointerType: 'mouse', button: 'right' });
  await quiet(page);
  const orbited = (await state(page)).digest;
  assert.notEqual(orbited, turned);
  await page.mouse.move(...at(0.5, 0.5));
  await page.evaluate(([x, y]) => { // at once, however busy the machine is: rolls that are apart are two steps
    for (let roll = 0; roll < 2; roll++) {
      document.elementFromPoint(x, y).dispatchEvent(new WheelEvent('wheel', { deltaY: -40, clientX: x, clientY: y, bubbles: true, cancelable: true }));
    }
  }, at(0.5, 0.5));
  await page.waitForTimeout(500);
  await quiet(page);
  const near = (await state(page)).digest;
  assert.notEqual(near, orbited);
  await page.evaluate(() => globalThis.batten.engine.command('undo'));
  assert.equal((await state(page)).digest, orbited, 'a roll of the wheel is one step');
  await page.locator('.lens canvas').focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('+');
  await quiet(page);
  assert.notEqual((await state(page)).digest, orbited, 'keys, too');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'lens-corrected.png') });
  await undone(page, made);

  await page.mouse.move(...at(0.4, 0.5));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.6), { steps: 4 });
  await settle(page);
  assert.notEqual((await state(page)).digest, made, 'shown while it is dragged');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await quiet(page);
  assert.equal((await state(page)).digest, made, 'Esc takes it back');

  await page.locator('#stage').focus();
  await page.keyboard.press(' ', { delay: 60 });
  assert.equal((await move(page)).playing, 1);
  await page.waitForTimeout(300);
  await page.mouse.move(...at(0.4, 0.5));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.6), { steps: 4 });
  assert.equal((await move(page)).playing, 0, 'it stands still while it is corrected');
  await page.mouse.up();
  await settle(page);
  assert.equal((await move(page)).playing, 1, 'and flies on');
  assert.notEqual((await state(page)).digest, made);
  await page.keyboard.press(' ', { delay: 60 });
  await undone(page, first.digest);
});

test('it makes way for the pen, is resized, and changes places with the room', async (t) => {
  const { page, hand, first } = await begin(t, { locale: 'ko-KR' });
  const before = await box(page);
  await page.keyboard.press('n');
  await hand.stroke([[300, 300], [before.x - 60, before.y + 40], [before.x + 20, before.y + 40]], { pointerType: 'pen' });
  await quiet(page);
  const aside = await box(page);
  assert.ok(aside.x + aside.width < before.x, 'it goes to another corner');
  await page.keyboard.press('v');
  const grip = await page.locator('.lens-grip').boundingBox();
  assert.ok(grip.width >= 44 && grip.height >= 44);
  assert.match(await page.locator('.lens-grip').getAttribute('title'), /[가-힣]/);
  await hand.stroke([[grip.x + 22, grip.y + 22], [grip.x + 102, grip.y + 22]], { pointerType: 'mouse' });
  await quiet(page);
  assert.ok(Math.abs((await box(page)).width - aside.width - 80) <= 12, 'the corner is dragged');
  await page.evaluate(() => {
    globalThis.batten.engine.wasm.editor_select(globalThis.batten.engine.editor, 1, 0);
    globalThis.batten.wake();
  });
  const { x, y, width, height } = await box(page);
  await page.mouse.dblclick(x + width / 2, y + height / 2);
  await quiet(page);
  assert.equal((await move(page)).through, 1, 'a double tap');
  assert.ok(await colours(page) > 20, 'the room is the small one now');
  await page.screenshot({ path: path.join(SCREENSHOTS, 'lens-swapped-ko.png') });
  const digest = (await state(page)).digest;
  await hand.stroke([[500, 300], [540, 330]], { pointerType: 'pen' });
  await quiet(page);
  assert.notEqual((await state(page)).digest, digest, 'the large one is corrected');
  await page.mouse.dblclick(x + width / 2, y + height / 2);
  await quiet(page);
  assert.equal((await move(page)).through, 0);
  assert.equal((await state(page)).check, '');
  await undone(page, first.digest);
});

/** The parts of a camera's move in the document, as text: the curve that it follows, and its gaze. */
const parts = (page) => page.evaluate(() => {
  const { objects } = JSON.parse(new TextDecoder().decode(globalThis.batten.engine.save(true)));
  const { move } = objects.find(({ kind }) => kind === 'camera');
  return { path: JSON.stringify(move.path), gaze: JSON.stringify(move.orientation) };
});

test('by touch: a finger turns the camera at the playhead, two pan it, a pinch brings it nearer; a step each', async (t) => {
  const { page, hand, first } = await begin(t, { hasTouch: true });
  await page.evaluate(() => {
    const { engine, wake } = globalThis.batten;
    engine.wasm.editor_seek(engine.editor, 1.2);
    wake();
  });
  await quiet(page);
  const { x, y, width, height } = await box(page);
  const at = (u, v) => [x + u * width, y + v * height];
  const ramp = (n, of) => Array.from({ length: n }, (_, i) => of(i / (n - 1)));
  const made = { digest: (await state(page)).digest, ...await parts(page) };

  await hand.fingers(ramp(8, (s) => [at(0.4 + 0.2 * s, 0.5 + 0.1 * s)]));
  await quiet(page);
  const turned = { digest: (await state(page)).digest, ...await parts(page) };
  assert.equal(turned.path, made.path, 'one finger: the camera stays where it is');
  assert.notEqual(turned.gaze, made.gaze, 'and looks elsewhere');

  hand.rest(2);
  await hand.fingers([[at(0.4, 0.5)], ...ramp(8, (s) => [at(0.4 + 0.2 * s, 0.5), at(0.6 + 0.2 * s, 0.5)])]);
  await quiet(page);
  const panned = { digest: (await state(page)).digest, ...await parts(page) };
  assert.notEqual(panned.path, turned.path, 'two fingers: it goes aside');
  assert.equal(panned.gaze, turned.gaze, 'and looks the same way');

  hand.rest(2);
  const shownBefore = await shown(page);
  await hand.fingers([[at(0.45, 0.5)], ...ramp(10, (s) => [at(0.45 - 0.15 * s, 0.5), at(0.55 + 0.15 * s, 0.5)])]);
  await quiet(page);
  const near = { digest: (await state(page)).digest, ...await parts(page) };
  assert.notEqual(near.path, panned.path, 'a pinch: it goes nearer');
  assert.equal(near.gaze, panned.gaze);
  assert.notEqual(await shown(page), shownBefore);
  const { at: time, duration } = await move(page);
  assert.ok(time > 0.2 * duration && time < 0.8 * duration, `the playhead is where the camera was: ${time}`); // of a longer path
  await page.screenshot({ path: path.join(SCREENSHOTS, 'lens-touch.png') });
  for (const before of [panned, turned, made]) {
    await page.evaluate(() => globalThis.batten.engine.command('undo'));
    assert.equal((await state(page)).digest, before.digest, 'a gesture is one step');
  }
  assert.equal((await state(page)).check, '');
  await undone(page, first.digest);
});
