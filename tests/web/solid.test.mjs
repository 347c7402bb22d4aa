// Shapes in space leave by the export sheet, made in the page: true size, upright, outward; a vase from the blank page to STL.
// label: smoke
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { downloaded, drop, launch, open, place, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const JUG = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/jug.batten');
const UNIT = 25.4 / 96; // millimetres

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

/** @param {Buffer} bytes of a binary STL @returns {number[][][]} */
function triangles(bytes) {
  const count = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * count);
  return Array.from({ length: count }, (_, t) => [0, 1, 2].map((k) => [0, 1, 2].map((c) => bytes.readFloatLE(84 + 50 * t + 12 + 12 * k + 4 * c))));
}

/** Triangles of the lines of an OBJ file. @param {string} text */
function faces(text) {
  const points = [...text.matchAll(/^v (\S+) (\S+) (\S+)$/gm)].map((found) => found.slice(1).map(Number));
  return [...text.matchAll(/^f (\d+)\S* (\d+)\S* (\d+)\S*$/gm)].map((found) => found.slice(1).map((corner) => points[Number(corner) - 1]));
}

/** @param {number[][][]} all @returns {[number[], number[]]} low and high */
function box(all) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  for (const point of all.flat()) {
    point.forEach((x, c) => { low[c] = Math.min(low[c], x); high[c] = Math.max(high[c], x); });
  }
  return [low, high];
}

const volume = (all) => all.reduce((sum, [a, b, c]) => sum + (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6, 0);

/** Edges that no other triangle has the other way round. */
function openEdges(all) {
  const edges = new Map();
  for (const corners of all) {
    const names = corners.map((point) => point.join());
    names.forEach((from, k) => {
      const to = names[(k + 1) % 3];
      if (from !== to) {
        const [name, way] = from < to ? [`${from} ${to}`, 1] : [`${to} ${from}`, -1];
        edges.set(name, (edges.get(name) ?? 0) + way);
      }
    });
  }
  return [...edges.values()].reduce((sum, way) => sum + Math.abs(way), 0);
}

/** The sheet, filled in; what it says. */
async function choose(page, fields) {
  if (!await page.locator('#export[open]').count()) {
    await page.keyboard.press('Control+Shift+E');
    await page.waitForSelector('#export[open]');
  }
  for (const [name, value] of Object.entries(fields)) {
    if (name === 'cap') {
      await page.setChecked('#export-cap', value);
    } else if (name === 'tolerance') {
      await page.fill('#export-tolerance', String(value));
    } else {
      await page.selectOption(`#export-${name}`, value);
    }
  }
  await settle(page);
  await quiet(page);
  return page.textContent('#export-told');
}

async function made(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export .strong')]);
  return { name: download.suggestedFilename(), bytes: await downloaded(download) };
}

/** The numbers of "12.3 × 4 × 5 mm". */
const sizes = (told) => /^(\S+) × (\S+) × (\S+) mm/.exec(told.replaceAll(',', '')).slice(1).map(Number);

test('from the blank page to the STL of a vase: draw, revolve, export', async () => {
  const { page, hand, context } = await open(browser, server.address);
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `solid-${name}.png`) });
  const canvas = await page.evaluate(() => {
    const { left, top, width, height } = document.getElementById('still').getBoundingClientRect();
    return [left, top, width, height];
  });
  const at = (x, y) => [canvas[0] + canvas[2] * x, canvas[1] + canvas[3] * y];
  hand.rest(2);
  await hand.stroke([at(0.5, 0.75), at(0.5, 0.25)], { pointerType: 'pen' }); // the axis
  await quiet(page);
  hand.rest(2);
  await hand.stroke(Array.from({ length: 60 }, (_, i) => at(0.6 + 0.06 * Math.sin(i / 59 * 5), 0.75 - 0.45 * i / 59)), { pointerType: 'pen' });
  await quiet(page);
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await settle(page);
  await page.locator('#actions button', { has: page.locator('use[href$="icon-surface-revolve"]') }).click();
  await quiet(page);
  const told = await choose(page, { format: 'stl', part: '1' });
  await shot('open');
  assert.match(told, / mm, [\d,]+ triangles, [\d,]+ open edges$/);
  const [wide, deep, tall] = sizes(told);
  const loose = await made(page);
  assert.match(loose.name, /\.stl$/);
  assert.ok(openEdges(triangles(loose.bytes)) > 0);

  assert.match(await choose(page, { format: 'stl', cap: true }), /, watertight$/);
  await shot('capped');
  const solid = triangles((await made(page)).bytes);
  assert.equal(openEdges(solid), 0);
  assert.ok(volume(solid) > 0.2 * wide * deep * tall && volume(solid) < wide * deep * tall, `${volume(solid)}`);
  const [low, high] = box(solid);
  [wide, deep, tall].forEach((size, c) => assert.ok(Math.abs(high[c] - low[c] - size) < 1e-3 * size, `${high[c] - low[c]} ${size}`));
  // As tall as the strokes were drawn, and the vase stands: its axis is z.
  const { zoom } = await state(page);
  assert.ok(Math.abs(tall - 0.45 * canvas[3] / zoom * UNIT) < 0.03 * tall, `${tall} ${zoom}`);
  assert.ok(Math.abs(wide - deep) < 1e-2 * wide);
  assert.equal((await state(page)).check, '');
  await context.close();
});

// Two lines, Revolve, Export, STL, the file.
for (const device of ['pen', 'mouse', 'touch']) {
  test(`a vase from the blank page to STL in six actions, by ${device}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { hasTouch: device === 'touch' });
    let actions = 0;
    const at = await page.evaluate(() => {
      const { left, top, width, height } = document.getElementById('still').getBoundingClientRect();
      return [left, top, width, height];
    }).then(([left, top, width, height]) => (x, y) => [left + width * x, top + height * y]);
    const press = async (found) => {
      actions++;
      await (device === 'touch' ? found.tap() : found.click());
    };
    for (const points of [[at(0.5, 0.75), at(0.5, 0.25)],
      Array.from({ length: 60 }, (_, i) => at(0.6 + 0.06 * Math.sin(i / 59 * 5), 0.75 - 0.45 * i / 59))]) {
      actions++;
      hand.rest(2);
      await hand.stroke(points, { pointerType: device });
      await quiet(page);
    }
    await page.waitForSelector('#notice button >> text=Revolve');
    await page.screenshot({ path: path.join(SCREENSHOTS, `solid-offered-${device}.png`) });
    await press(page.locator('#notice button', { hasText: 'Revolve' }));
    await quiet(page);
    await press(page.getByRole('button', { name: 'Export', exact: true }).first());
    await page.waitForSelector('#export[open]');
    actions++;
    await page.selectOption('#export-format', 'stl');
    await quiet(page);
    const [download] = await Promise.all([page.waitForEvent('download'), press(page.locator('#export .strong'))]);
    const solid = triangles(await downloaded(download));
    const [low, high] = box(solid), tall = high[2] - low[2];
    const { zoom, check } = await state(page);
    assert.ok(Math.abs(tall - (at(0, 0.75)[1] - at(0, 0.3)[1]) / zoom * UNIT) < 0.03 * tall, `${tall} ${zoom}`);
    assert.equal(check, '');
    assert.equal(actions, 6);
    await context.close();
  });
}

// The same lines by their points: Enter begins and places, arrow keys move, Enter twice ends; F6 goes to the offer and to the bar.
test('a vase from the blank page to STL in six actions, by keyboard', async () => {
  const { page, context } = await open(browser, server.address);
  let actions = 0;
  await page.evaluate(() => {
    globalThis.pointed = 0;
    addEventListener('pointerdown', () => { globalThis.pointed++; }, true);
  });
  const press = async (...keys) => {
    for (const key of keys) {
      const [, times, name] = /^(?:(\d+) x )?(.*)$/.exec(key);
      for (let i = 0; i < Number(times ?? 1); i++) { await page.keyboard.press(name); }
    }
    await settle(page);
  };
  const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `solid-keyboard-${name}.png`) });
  /** To a button, by region and within it. @param {string} selector @param {string} key that goes on within the region */
  const go = async (selector, key) => {
    const there = () => page.evaluate((found) => document.activeElement.matches(found), selector);
    const inside = () => page.evaluate((found) => document.activeElement.parentElement.querySelector(found) !== null, selector);
    for (let i = 0; i < 12 && !await there() && !await inside(); i++) { await press('F6'); }
    for (let i = 0; i < 30 && !await there(); i++) { await press(key); }
    assert.ok(await there(), selector);
  };
  await page.locator('#stage').focus();
  await press('Enter', '15 x Shift+ArrowDown', 'Enter', '30 x Shift+ArrowUp', 'Enter', 'Enter'); // the axis
  actions++;
  await quiet(page);
  await shot('axis');
  await press('Escape', 'Enter', '8 x Shift+ArrowRight', '15 x Shift+ArrowDown', 'Enter', '5 x Shift+ArrowRight', '8 x Shift+ArrowUp', 'Enter',
    '8 x Shift+ArrowLeft', '9 x Shift+ArrowUp', 'Enter', '3 x Shift+ArrowRight', '8 x Shift+ArrowUp', 'Enter', 'Enter');
  actions++;
  await quiet(page);
  await shot('offered');
  await go('#notice button', 'Tab');
  await press('Enter');
  actions++;
  await quiet(page);
  await press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  actions++;
  await go('#export-format', 'Tab');
  await page.keyboard.type('STL');
  await quiet(page);
  actions++;
  await shot('export');
  assert.equal(await page.inputValue('#export-format'), 'stl');
  await go('#export .strong', 'Tab');
  const [download] = await Promise.all([page.waitForEvent('download'), press('Enter')]);
  actions++;
  const [low, high] = box(triangles(await downloaded(download)));
  const { zoom, check } = await state(page);
  assert.ok(Math.abs(high[2] - low[2] - 250 / zoom * UNIT) < 0.03 * (high[2] - low[2]), `${high[2] - low[2]} ${zoom}`);
  assert.equal(check, '');
  assert.equal(actions, 6);
  assert.equal(await page.evaluate(() => globalThis.pointed), 0);
  await context.close();
});

test('a jug in every format, on the wall and on the floor', async () => {
  const { page, context } = await open(browser, server.address);
  await drop(page, 'jug.batten', fs.readFileSync(JUG, 'utf8'));
  const digest = (await state(page)).digest;
  const said = await choose(page, { format: 'glb', part: '0' });
  await page.screenshot({ path: path.join(SCREENSHOTS, 'solid-jug.png') });
  const stands = await page.inputValue('#export-stand');
  const glb = (await made(page)).bytes;
  assert.equal(glb.toString('latin1', 0, 4), 'glTF');
  assert.equal(glb.readUInt32LE(8), glb.length);
  const scene = JSON.parse(glb.toString('utf8', 20, 20 + glb.readUInt32LE(12)));
  const ends = scene.accessors.filter(({ min }) => min);
  const height = Math.max(...ends.map(({ max }) => max[1])) - Math.min(...ends.map(({ min }) => min[1]));
  assert.ok(Math.abs(1000 * height - sizes(said)[2]) < 1e-3 * sizes(said)[2], `${height} ${said}`); // metres, y up

  const asked = [];
  page.on('request', (request) => { if (request.url().startsWith('http')) { asked.push(request.url()); } });
  await choose(page, { format: 'stl', stand: stands, cap: false });
  const one = box(triangles((await made(page)).bytes));
  await choose(page, { format: 'stl', stand: stands === 'wall' ? 'floor' : 'wall', cap: false });
  const other = box(triangles((await made(page)).bytes));
  const [a, b] = [one, other].map(([low, high]) => high.map((x, c) => x - low[c]));
  [[0, 0], [1, 2], [2, 1]].forEach(([i, k]) => assert.ok(Math.abs(a[i] - b[k]) < 1e-3 * Math.max(...a), `${a} ${b}`));

  const fine = await choose(page, { format: 'mesh', stand: stands, tolerance: 0.1 });
  const obj = await made(page);
  assert.match(obj.name, /\.obj$/);
  const [low, high] = box(faces(obj.bytes.toString()));
  assert.ok(Math.abs(high[1] - low[1] - sizes(fine)[2]) < 2e-3 * sizes(fine)[2]); // y up
  for (const [format, head] of [['3mf', 'PK'], ['ply', 'ply'], ['usda', '#usda 1.0']]) {
    await choose(page, { format, stand: stands, tolerance: 0.1 });
    const file = await made(page);
    assert.ok(file.name.endsWith(`.${format}`) && file.bytes.toString('latin1', 0, 9).startsWith(head));
  }
  for (const [format, head] of [['step', 'ISO-10303-21'], ['iges', 'B-spline']]) {
    assert.doesNotMatch(await choose(page, { format, stand: stands }), /triangles/);
    assert.equal(await page.isVisible('#export-tolerance'), false);
    const file = await made(page);
    assert.ok(file.name.endsWith(`.${format}`));
    assert.ok(file.bytes.toString('latin1', 0, 80).includes(head));
  }
  assert.equal((await state(page)).digest, digest);
  assert.deepEqual(asked, []); // all are made in the page
  await context.close();
});

test('a flat drawing is offered none of them; asked for by name, it says why; in Korean too', async () => {
  const { page, context } = await open(browser, server.address, { locale: 'ko' });
  const [x, y] = await place(page, 0, 0);
  assert.ok(Number.isFinite(x + y));
  await drop(page, 'flat.svg', '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M1 1L5 5"/></svg>');
  await page.keyboard.press('Control+Shift+E');
  await page.waitForSelector('#export[open]');
  const offered = await page.$$eval('#export-format option', (options) => options.map(({ value }) => value));
  assert.ok(offered.includes('dxf') && !offered.includes('stl') && !offered.includes('glb'));
  await page.keyboard.press('Escape');
  await page.waitForSelector('#export', { state: 'detached' });
  await page.keyboard.press('Control+k');
  await page.waitForSelector('#menu .search');
  await page.waitForFunction(() => document.activeElement?.classList.contains('search'));
  await page.keyboard.type('stl');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('3D 형태'));
  await drop(page, 'jug.batten', fs.readFileSync(JUG, 'utf8'));
  assert.match(await choose(page, { format: 'stl' }), /삼각형/);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'solid-korean.png') });
  await context.close();
});
