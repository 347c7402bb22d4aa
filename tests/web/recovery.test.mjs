// label: smoke. When the module traps, the drawing is restored from its journal.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { after, before, test } from 'node:test';
import { SCREENSHOTS, bezier, downloaded, expectFaults, launch, open, place, quiet, settle, state } from './page.mjs';
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


for (const often of [1, 4]) {
  test(`${often} traps in a row while it is painted: all steps are back, and kept`, async () => {
    expectFaults(/asked to break|RuntimeError/);
    const { page, hand, context } = await five(browser, server.address);
    const before = { digest: (await state(page)).digest, journal: await lines(page), session: await page.evaluate(() => batten.engine.session) };
    await spoil(page, { editor_frame: often });
    await trip(page, hand);
    await page.waitForSelector('[data-about=trap] >> text=brought back');
    await quiet(page);
    assert.equal((await state(page)).digest, before.digest);
    assert.deepEqual(await lines(page), before.journal);
    assert.equal(await page.evaluate(() => batten.engine.session), before.session, 'what is kept on disk goes on');
    await hand.stroke(await Promise.all(row(6).map(([x, y]) => place(page, x, y))));
    assert.equal(await curves(page), STROKES + 1);
    await page.evaluate(() => batten.keeper.settled());
    const kept = await page.evaluate(async () => (await batten.keeper.find(batten.files.name)).journal.length);
    assert.equal(kept, await page.evaluate(() => batten.engine.journal.length));
    await context.close();
  });
}

test('a drawing that cannot be painted: the page says so, and offers the drawing, the journal and a reload', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  const before = await page.evaluate(() => [new TextDecoder().decode(batten.engine.save(false)), batten.engine.journal.length]);
  await spoil(page, { editor_frame: 1e9 });
  await trip(page, hand);
  await page.waitForSelector('[data-about=trap] >> text=cannot go on');
  assert.ok(await page.evaluate(() => globalThis.starts) < 100, 'it does not try for ever');
  await page.screenshot({ path: `${SCREENSHOTS}/trap-dead.png` });
  const get = async (label) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-about=trap] button >> text=${label}`)]);
    return downloaded(download);
  };
  assert.equal((await get('Download a copy')).toString(), before[0], 'a copy is all of it');
  assert.equal((await get('Download the journal')).length, before[1]);
  await page.click('[data-about=trap] button >> text=Reload');
  await page.waitForSelector('html[data-ready=yes]');
  await context.close();
});

test('a step that traps twice is left out, kept aside and said; those after it are repeated', async () => {
  expectFaults(/asked to break|RuntimeError/);
  const { page, hand, context } = await five(browser, server.address);
  const bad = (await lines(page))[3]; // the third stroke
  const digest = /"digest":"(\w+)"[}]$/.exec(bad)[1];
  await spoil(page, { editor_replay_line: 2 }, digest);
  await trip(page, hand);
  await page.waitForSelector('[data-about=trap] >> text=One step');
  await settle(page);
  await page.screenshot({ path: `${SCREENSHOTS}/trap-step.png` });
  assert.equal(await curves(page), STROKES - 1);
  assert.equal((await state(page)).check, '');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-about=trap] button >> text=left out')]);
  assert.equal((await downloaded(download)).toString(), `${bad}\n`);
  // The next trap is told from this one: the rest is brought back whole.
  await hand.stroke(await Promise.all(row(6).map(([x, y]) => place(page, x, y))));
  const after = (await state(page)).digest;
  await trip(page, hand);
  await page.waitForSelector('[data-about=trap]');
  await settle(page);
  assert.equal((await state(page)).digest, after);
  assert.equal(await curves(page), STROKES);
  await context.close();
});
