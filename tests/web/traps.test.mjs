// When the module traps or has no memory: what is kept, said and offered, case by case; recovery.test.mjs has the first ones.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { Steps } from '../../web/engine/steps.js';
import { SCREENSHOTS, downloaded, expectFaults, launch, place, quiet, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';
import { STROKES, curves, five, lines, row, spoil, trip } from './spoil.mjs';

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

test('a drawing that cannot be painted can be left for another', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  await spoil(page, { editor_frame: 9 }); // as often as it is tried
  await trip(page, hand);
  await page.click('[data-about=trap] button >> text=New drawing');
  await quiet(page);
  await hand.stroke(await Promise.all(row(1).map(([x, y]) => place(page, x, y))));
  assert.equal(await curves(page), 1);
  assert.equal((await state(page)).check, '');
  await context.close();
});

test('a trap while replaying: the replay is tried again, and no step is given up', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  const before = (await state(page)).digest;
  await spoil(page, { editor_replay: 1, editor_replay_line: 1 });
  await trip(page, hand);
  await page.waitForSelector('[data-about=trap] >> text=brought back');
  assert.equal((await state(page)).digest, before);
  await hand.stroke(await Promise.all(row(6).map(([x, y]) => place(page, x, y))));
  assert.equal(await curves(page), STROKES + 1, 'nor by the next stroke');
  await context.close();
});

test('a kept drawing with such a step is opened without it', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, context } = await five(browser, server.address);
  const digest = /"digest":"(\w+)"[}]$/.exec((await lines(page))[3])[1];
  await spoil(page, { editor_replay_line: 2 }, digest);
  await page.evaluate(() => {
    batten.engine.wasm = { ...batten.engine.wasm, editor_replay: batten.engine.wasm.module_break };
  });
  assert.equal(await page.evaluate(() => batten.engine.replay(batten.engine.journal.slice())), true);
  await page.waitForSelector('[data-about=trap] >> text=One step');
  assert.equal(await curves(page), STROKES - 1);
  await context.close();
});

test('every event traps: it is said, and a reload is offered', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  await spoil(page, { editor_pointer: 1e9 });
  await trip(page, hand);
  for (let i = 0; i < 12; i++) {
    await hand.hover([300 + i, 300]);
  }
  await page.waitForSelector('[data-about=trap] >> text=cannot go on');
  assert.ok(await page.isVisible('[data-about=trap] button >> text=Reload'));
  await context.close();
});

test('no memory for a file that is too large: it is said, and a copy is offered, which is all of the drawing', async () => {
  expectFaults(/Not enough memory/);
  const { page, context } = await five(browser, server.address);
  const before = await page.evaluate(() => new TextDecoder().decode(batten.engine.save(false)));
  await page.evaluate(() => {
    const { engine } = batten;
    const { memory_alloc: alloc } = engine.wasm;
    engine.wasm = { ...engine.wasm, memory_alloc: (size) => (size > 1e6 ? 0 : alloc(size)), editor_save: () => 1 };
    try { // as a file's own reader would, in the page itself
      engine.openNative(new Uint8Array(2e6).fill(32), 'large.batten');
    } catch {
      // The notice says it.
    }
  });
  await page.waitForSelector('[data-about=trap] >> text=not enough memory');
  assert.ok(await page.isVisible('[data-about=trap] button >> text=Reload'));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=trap] button >> text=copy')]);
  assert.equal((await downloaded(download)).toString(), before);
  await context.close();
});

test('no memory is left: it is said, the drawing is brought back into a new instance, and work goes on', async () => {
  expectFaults(/Not enough memory/);
  const { page, hand, context } = await five(browser, server.address);
  const before = await page.evaluate(() => [batten.engine.digest(), new TextDecoder().decode(batten.engine.save(false))]);
  await page.evaluate(() => {
    const { wasm } = batten.engine;
    for (let size = 1 << 28; size >= 8; size /= 2) {
      while (wasm.memory_alloc(size)) { /* until there is none */ }
    }
  });
  await hand.hover(await place(page, 100, 100)); // what the page then asks the engine has no memory
  await page.waitForSelector('[data-about=trap] >> text=Memory ran out');
  await quiet(page);
  await page.screenshot({ path: `${SCREENSHOTS}/trap-memory.png` });
  assert.equal((await state(page)).digest, before[0]);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=trap] button >> text=copy')]);
  assert.equal((await downloaded(download)).toString(), before[1]);
  await hand.stroke(await Promise.all(row(6).map(([x, y]) => place(page, x, y))));
  assert.equal(await curves(page), STROKES + 1);
  await context.close();
});

test('memory that never suffices: the page says so, and offers the journal', async () => {
  expectFaults(/Not enough memory|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  const steps = await page.evaluate(() => batten.engine.journal.length);
  await page.evaluate(() => {
    const Instance = WebAssembly.Instance;
    WebAssembly.Instance = function spoiled(module, imports) {
      const { exports } = new Instance(module, imports);
      return { exports: { ...exports, memory_alloc: () => 0 } };
    };
  });
  await trip(page, hand);
  await page.waitForSelector('[data-about=trap] >> text=cannot go on');
  await page.click('[data-about=trap] button >> text=copy');
  await page.waitForSelector('[data-about=uncopied] >> text=No copy could be made');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=trap] button >> text=journal')]);
  assert.equal((await downloaded(download)).length, steps);
  await context.close();
});

test('undoing a step that was left out is left out with it', () => {
  const text = (list) => new TextEncoder().encode(list.map((line) => `${line}\n`).join(''));
  const change = (n) => `{"do":"change","n":${n}}`;
  const [undo, redo] = ['{"do":"undo"}', '{"do":"redo"}'];
  const run = (list, bad) => {
    const steps = new Steps(text(['{}', ...list]));
    const ran = [];
    for (let tries = 0; tries < 5; tries++) {
      ran.length = 0;
      try {
        assert.equal(steps.play((line) => {
          const one = new TextDecoder().decode(line);
          assert.notEqual(one, 'trap');
          if (one === bad) {
            throw new RangeError('trap');
          }
          ran.push(one);
          return true;
        }), true);
        break;
      } catch (error) {
        assert.ok(error instanceof RangeError);
        steps.trapped();
      }
    }
    return [ran.slice(1), steps.left.map((line) => new TextDecoder().decode(line).trim())];
  };
  assert.deepEqual(run([change(1), change(2), undo, undo, redo], change(2)), [[change(1), undo, redo], [change(2)]]);
  assert.deepEqual(run([change(1), change(2), undo, change(3), undo], change(2)), [[change(1), change(3), undo], [change(2)]]);
  assert.deepEqual(run([change(1), undo, redo, change(2)], change(9)), [[change(1), undo, redo, change(2)], []]);
});
