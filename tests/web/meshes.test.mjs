// Meshes and surfaces of other programs, dropped on the page: each opens as what it is, and one that is broken leaves the drawing alone.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, SCREENSHOTS, settle } from './page.mjs';
import { serve } from './server.mjs';

const SEEDS = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../fuzz/corpus/shells');

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

/** Lets a file of bytes arrive, as when it is dropped. */
const arrive = (page, name, bytes) => page.evaluate(([called, list]) =>
  batten.files.arrive([{ file: new File([new Uint8Array(list)], called), place: null }]), [name, [...bytes]]);
const drawing = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))));

test('STEP and IGES open as surfaces and curves in millimetres', async () => {
  const { page, context } = await open(browser, server.address);
  for (const [seed, name, kinds] of [['step/surface', 'surface.step', ['surface']], ['step/curves', 'curves.stp', ['path', 'path']],
    ['iges/surface', 'surface.igs', ['surface']], ['iges/curves', 'curves.iges', ['path', 'path']]]) {
    await arrive(page, name, fs.readFileSync(path.join(SEEDS, '..', seed)));
    await page.waitForFunction((called) => document.getElementById('name').textContent === called, name);
    const { unit, objects } = await drawing(page);
    assert.equal(unit, 'mm', name);
    assert.deepEqual(objects.map(({ kind }) => kind), kinds, name);
    await settle(page);
    await page.screenshot({ path: path.join(SCREENSHOTS, `opened-${name}.png`) });
  }
  await context.close();
});

test('STL, PLY, glTF and 3MF open as meshes in millimetres', async () => {
  const { page, context } = await open(browser, server.address);
  for (const [name, faces] of [['wedge.stl', 4], ['text.stl', 4], ['binary_big_endian.ply', 4], ['wedge.glb', 4], ['text.gltf', 4],
    ['deflated.3mf', 8]]) {
    await arrive(page, name, fs.readFileSync(path.join(SEEDS, name)));
    await page.waitForFunction((called) => document.getElementById('name').textContent === called, name);
    const { unit, objects } = await drawing(page);
    assert.equal(unit, 'mm', name);
    assert.deepEqual(objects.map(({ kind }) => kind), ['mesh'], name);
    assert.equal(objects[0].mesh.faces.length, faces, name);
    await settle(page);
  }
  await page.screenshot({ path: path.join(SCREENSHOTS, 'meshes.png') });
  const broken = fs.readFileSync(path.join(SEEDS, 'deflated.3mf')).subarray(0, 200);
  await arrive(page, 'broken.3mf', broken);
  await page.waitForFunction(() => document.querySelector('.notices').textContent.includes('broken.3mf was not opened'));
  assert.equal((await drawing(page)).objects[0].mesh.faces.length, 8);
  await context.close();
});
