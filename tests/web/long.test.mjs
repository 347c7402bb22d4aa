// Long work: the journal and the engine's memory stay in proportion to the drawing and its undo steps.
// BATTEN_OPERATIONS=10000 node --test long.test.mjs does more of it, and prints what it measures.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, open } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

const OPERATIONS = Number(process.env.BATTEN_OPERATIONS ?? 700);
let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
});

/** Strokes of 300 samples over a drawing of 40 lines, each of which is redrawn many times; every tenth is undone. */
const work = (page, from, to) => page.evaluate(async ([first, end]) => {
  const { engine } = batten;
  let most = 0;
  for (let n = first; n < end; n++) {
    const row = (n * 17) % 40;
    const sample = (phase, i) => ({ phase, device: 1, contact: 9, buttons: phase === 3 ? 0 : 1, modifiers: 0,
      x: 80 + 500 * (row % 2) + 1.4 * i, y: 40 + 30 * Math.floor(row / 2) + (n % 7) * Math.sin(i / 60 + n), pressure: 0.5 + (i % 9) / 30,
      tiltX: i % 4, tiltY: 0, twist: 0, width: 1, height: 1, time: 1e6 + 5000 * n + 4 * i, predicted: false });
    engine.pointer([sample(1, 0)]);
    engine.pointer(Array.from({ length: 299 }, (_, i) => sample(2, i + 1)));
    engine.pointer([sample(3, 300)]);
    if (n % 10 === 9) {
      engine.command('undo');
    }
    most = Math.max(most, engine.journal.length);
    if (n % 50 === 49) {
      await new Promise((done) => setTimeout(done, 250)); // as a hand rests at times
    }
  }
  return { most, journal: engine.journal.length, session: engine.session, memory: engine.wasm.memory.buffer.byteLength };
}, [from, to]);

const undone = (page) => page.evaluate(() => {
  const { engine } = batten;
  while (engine.command('redo')) { /* to the end */ }
  const digests = [];
  while (engine.command('undo')) {
    digests.push(engine.digest());
  }
  while (engine.command('redo')) { /* back */ }
  return digests;
});

test('after long work the journal is short, memory small, and every step can be undone, now and after a replay', async () => {
  const { page, context } = await open(browser, server.address);
  await page.evaluate(() => batten.drawings.openNew());
  const sessions = await page.evaluate(() => batten.engine.session);
  const end = await work(page, 0, OPERATIONS);
  assert.ok(end.session > sessions, 'it was compacted');
  const [compacted, steps] = [await page.evaluate(() => {
    const { engine } = batten;
    const other = new engine.constructor(engine.module);
    other.replay(engine.journal.slice());
    other.wasm.editor_compact(other.editor);
    other.begun(new Uint8Array(0));
    other.keepJournal();
    return other.journal.length;
  }), await undone(page)];
  if (process.env.BATTEN_OPERATIONS) {
    console.log({ ...end, compacted, steps: steps.length });
  }
  assert.ok(end.journal <= 4 * compacted, `${end.journal} bytes, and ${compacted} when compacted`);
  assert.ok(end.memory < 64 << 20, `${end.memory} bytes of memory`);
  const digest = await page.evaluate(() => batten.engine.digest());
  assert.ok(await page.evaluate(() => batten.engine.replay(batten.engine.journal.slice())));
  assert.equal(await page.evaluate(() => batten.engine.digest()), digest);
  assert.ok(JSON.stringify(await undone(page)) === JSON.stringify(steps), `the same ${steps.length} steps`);
  await context.close();
});
