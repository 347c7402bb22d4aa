// Drawings whose module is made to trap.
import assert from 'node:assert/strict';
import { bezier, open, place, settle } from './page.mjs';

export const STROKES = 5;
export const row = (i) => bezier([60, 40 + 60 * i], [160, 10 + 60 * i], [260, 70 + 60 * i], [360, 40 + 60 * i]);

/** An empty drawing with five curves in it. */
export async function five(browser, address) {
  const opened = await open(browser, address);
  await opened.page.evaluate(() => batten.drawings.openNew());
  await settle(opened.page);
  for (let i = 0; i < STROKES; i++) {
    await opened.hand.stroke(await Promise.all(row(i).map(([x, y]) => place(opened.page, x, y))));
  }
  assert.equal(await curves(opened.page), STROKES);
  return opened;
}

/** How many curves the drawing has, by what would be saved of it. */
export const curves = (page) => page.evaluate(() => (new TextDecoder().decode(batten.engine.save(false)).match(/<path /g) ?? []).length);
export const lines = (page) => page.evaluate(() => new TextDecoder().decode(batten.engine.journal).trim().split('\n'));

/** Lets instances made from now on trap in these calls so often; `where`: only when the line that is run has this in it. */
export const spoil = (page, calls, where = '') => page.evaluate(([left, part]) => {
  const Instance = WebAssembly.Instance;
  globalThis.starts = 0;
  WebAssembly.Instance = function spoiled(module, imports) {
    const { exports } = new Instance(module, imports);
    globalThis.starts++;
    const has = (text, size) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, text, size)).includes(part);
    const broken = Object.fromEntries(Object.keys(left).filter((name) => exports[name]).map((name) => [name, (...values) =>
      ((!part || has(values[1], values[2])) && left[name]-- > 0 ? exports.module_break() : exports[name](...values))]));
    return { exports: { ...exports, ...broken } };
  };
}, [calls, where]);

/** The next call traps, whatever it is. */
export async function trip(page, hand) {
  await page.evaluate(() => {
    batten.engine.editor = 0xfffffff0;
  });
  await hand.hover(await place(page, 100, 100));
}
