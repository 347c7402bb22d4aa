// label: smoke. When the module traps, the drawing is restored from its journal.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { bezier, downloaded, expectFaults, launch, open, place, settle, state } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

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

const breaks = {
  'a failed check in the module': () => {
    const engine = batten.engine;
    engine.wasm = { ...engine.wasm, editor_pointer: engine.wasm.module_break };
  },
  'a trap: an address out of bounds': () => {
    batten.engine.editor = 0xfffffff0;
  },
};

for (const [name, spoil] of Object.entries(breaks)) {
  test(name, async () => {
    expectFaults(/asked to break|RuntimeError/);
    const { page, hand, context } = await open(browser, server.address);
    const on = (points) => Promise.all(points.map(([x, y]) => place(page, x, y)));
    await hand.stroke(await on(bezier([440, 137], [490, 103], [560, 92], [690, 114])));
    await hand.stroke(await on(bezier([60, 60], [140, 20], [220, 100], [320, 60])));
    await page.keyboard.press('Control+Z');
    await settle(page);
    const before = await state(page);
    await page.evaluate(spoil);
    await hand.hover(await place(page, 100, 100));
    await settle(page);
    const after = await state(page);
    assert.equal(after.digest, before.digest, 'nothing is lost');
    assert.match(after.notice, /brought back/);
    assert.equal(after.unsaved, true);
    // Work continues: the undone step can be redone, and new strokes drawn.
    await page.keyboard.press('Control+Shift+Z');
    await settle(page);
    assert.notEqual((await state(page)).digest, before.digest);
    await hand.stroke(await on(bezier([60, 380], [140, 340], [220, 410], [320, 380])));
    assert.equal((await state(page)).check, '');
    await context.close();
  });
}

for (const [bad, name] of [[5, 'a drawing whose every picture breaks is given up'], [1e9, 'a module that never works']]) {
  test(`${name}, its journal is not`, async () => {
    expectFaults(/asked to break|RuntimeError/);
    const { page, hand, context } = await open(browser, server.address);
    await hand.stroke([await place(page, 60, 60), await place(page, 180, 40), await place(page, 300, 60)]);
    const steps = await page.evaluate(() => batten.engine.journal.length);
    assert.ok(steps > 100);
    await page.evaluate((count) => {
      const Instance = WebAssembly.Instance;
      let left = count;
      globalThis.starts = 0;
      WebAssembly.Instance = function spoiled(module, imports) {
        const { exports } = new Instance(module, imports);
        globalThis.starts++;
        return { exports: left-- > 0 ? { ...exports, editor_frame: exports.module_break } : exports };
      };
      batten.engine.editor = 0xfffffff0;
    }, bad);
    await hand.hover(await place(page, 100, 100));
    await page.waitForSelector('[data-about=trap] >> text=Not all steps');
    // It does not retry for ever: twenty frames without another start, before the hundredth start.
    for (let still = 0, last = 0; still < 10;) {
      await settle(page);
      const starts = await page.evaluate(() => globalThis.starts);
      still = starts === last ? still + 1 : 0;
      last = starts;
      assert.ok(starts < 100, `it tried ${starts} times`);
    }
    assert.match(await page.textContent('[data-about=trap]'), /Not all steps/);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=trap] button')]);
    assert.equal((await downloaded(download)).length, steps);
    await context.close();
  });
}
