// label: smoke. Gradients, dashes and uneven strokes as the page paints them, against what SVG says they are at a point.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const STOPS = '<stop stop-color="#ff0000"/><stop offset="1" stop-color="#0000ff"/>';
const FILE = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
<linearGradient id="a">${STOPS}</linearGradient>
<linearGradient id="b" href="#a" x2="0" y2=".25" spreadMethod="reflect"/>
<linearGradient id="c" href="#a" gradientUnits="userSpaceOnUse" x1="20" x2="40" spreadMethod="repeat"/>
<radialGradient id="d" href="#a"/>
<rect x="20" y="20" width="100" height="60" fill="url(#a)"/>
<rect x="140" y="20" width="100" height="80" fill="url(#b)"/>
<rect x="260" y="20" width="120" height="60" fill="url(#c)"/>
<ellipse cx="100" cy="150" rx="80" ry="40" fill="url(#d)"/>
<path d="M210 150H370" stroke="url(#c)" stroke-width="20" fill="none"/>
<ellipse cx="290" cy="230" rx="80" ry="40" fill="none" stroke="url(#d)" stroke-width="20"/>
<path d="M20 220H180" stroke="#008000" stroke-width="12" stroke-dasharray="30 10" stroke-dashoffset="5"/>
<g transform="scale(4,1)"><path d="M10 250V290M20 270H40" stroke="#804000" stroke-width="4"/></g>
<rect x="280" y="100" width="80" height="24" fill="#ff0000" stroke="#0000ff" stroke-width="8" opacity=".5"/></svg>`;

/** The colour at t between the stops. */
const mix = (t) => [255 * (1 - t), 0, 255 * t];
const PAPER = [255, 255, 255];
const POINTS = [
  [30, 50, mix(0.1)], [70, 30, mix(0.5)], [115, 70, mix(0.95)], // the box's width
  [190, 30, mix(0.5)], [150, 45, mix(0.75)], [230, 70, mix(0.5)], [190, 79, mix(0.95)], // there and back
  [265, 50, mix(0.25)], [285, 30, mix(0.25)], [375, 70, mix(0.75)], // again and again
  [100, 150, mix(0)], [140, 150, mix(0.5)], [100, 170, mix(0.5)], [44, 150, mix(0.7)], // rings are ellipses
  [215, 150, mix(0.75)], [305, 145, mix(0.25)],
  [210, 230, mix(1)], [290, 190, mix(1)], [218, 230, mix(0.9)], // a stroke of uniform width
  [22, 220, [0, 128, 0]], [50, 220, PAPER], [60, 224, [0, 128, 0]], [90, 220, PAPER], [130, 220, PAPER],
  [33, 270, [128, 64, 0]], [47, 270, [128, 64, 0]], [120, 271, [128, 64, 0]], [120, 275, PAPER], // a pen four times as wide as high
  [320, 112, [255, 128, 128]], [320, 102, [128, 128, 255]], [320, 98, [128, 128, 255]], // translucent as a whole
];

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('curves are painted with what the file says', async (t) => {
  const server = await serve({ name: 'paint.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'gradients.png') });
  const found = await stillColours(page, POINTS);
  POINTS.forEach(([x, y, expected], i) => {
    const far = Math.max(...expected.map((value, k) => Math.abs(value - found[i][k])));
    assert.ok(far <= 16, `${x} ${y}: expected ${expected}, found ${found[i]}`);
  });
});

test('a gradient is moved with its curve, and undone', async (t) => {
  const server = await serve({ name: 'paint.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  const before = await page.evaluate(() => globalThis.batten.engine.digest());
  await page.keyboard.press('v');
  const at = await place(page, 70, 40);
  await page.mouse.click(...at);
  await page.keyboard.press('Shift+ArrowDown');
  await quiet(page);
  const after = await page.evaluate(() => globalThis.batten.engine.digest());
  assert.notEqual(after, before);
  const [[red, , blue]] = await stillColours(page, [[30, 50]]);
  assert.ok(Math.abs(red - 229) <= 16 && Math.abs(blue - 26) <= 16, `${red} ${blue}`);
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await page.evaluate(() => globalThis.batten.engine.digest()), before);
});

const GROUPS = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
<g opacity=".5"><rect x="20" y="20" width="100" height="100" fill="#f00"/><rect x="70" y="20" width="100" height="100" fill="#00f"/>
<g opacity=".5"><rect x="20" y="150" width="100" height="100" fill="#f00"/><rect x="70" y="150" width="100" height="100" fill="#00f"/>
</g></g></svg>`;

test('groups are translucent as one picture', async (t) => {
  const server = await serve({ name: 'groups.svg', bytes: Buffer.from(GROUPS) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  const points = [[40, 60, [255, 128, 128]], [90, 60, [128, 128, 255]], [150, 60, [128, 128, 255]],
    [40, 200, [255, 191, 191]], [90, 200, [191, 191, 255]], [10, 10, [255, 255, 255]]];
  const check = async () => {
    const found = await stillColours(page, points);
    points.forEach(([x, y, expected], i) => {
      const far = Math.max(...expected.map((value, k) => Math.abs(value - found[i][k])));
      assert.ok(far <= 3, `${x} ${y}: expected ${expected}, found ${found[i]}`);
    });
  };
  await check();
  await page.keyboard.press('v'); // what is repainted in part is the same
  await page.mouse.click(...await place(page, 40, 60));
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Escape');
  await quiet(page);
  await check();
});

// A shape in a circle; a group in a ring, translucent, of which a part is clipped again; a clip path of shapes that go round in
// opposite ways, within another.
const CLIPS = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><clipPath id="c"><circle cx="70" cy="70" r="50"/></clipPath>
<clipPath id="d"><path clip-rule="evenodd" d="M150 20H250V120H150ZM180 50H220V90H180Z"/></clipPath><clipPath id="e"><path d="M140 10H260V40H140Z"/></clipPath>
<clipPath id="f" clip-path="url(#g)"><path d="M20 150H80V250H20Z"/><path d="M60 150V250H120V150Z"/></clipPath><clipPath id="g"><path d="M0 140H400V200H0Z"/></clipPath>
<rect x="10" y="10" width="120" height="120" fill="#f00" clip-path="url(#c)"/>
<g clip-path="url(#d)" opacity=".5"><rect x="140" y="10" width="120" height="120" fill="#0f0"/><rect x="140" y="10" width="120" height="120" fill="#00f" clip-path="url(#e)"/></g>
<rect y="140" width="200" height="160" fill="#f00" clip-path="url(#f)"/></svg>`;

test('only what lies within clip paths is painted', async (t) => {
  const server = await serve({ name: 'clips.svg', bytes: Buffer.from(CLIPS) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  const [white, red, blue, green] = [[255, 255, 255], [255, 0, 0], [128, 128, 255], [128, 255, 128]];
  const points = [[70, 30, red], [25, 25, white], [115, 115, white], [165, 30, blue], [165, 60, green], [200, 70, white], [145, 60, white],
    [30, 170, red], [70, 170, red], [110, 170, red], [130, 170, white], [70, 210, white]];
  const check = async (dy = 0) => {
    const found = await stillColours(page, points.map(([x, y]) => [x, y + (x < 130 && y < 130 ? dy : 0)]));
    points.forEach(([x, y, expected], i) => {
      const far = Math.max(...expected.map((value, k) => Math.abs(value - found[i][k])));
      assert.ok(far <= 3, `${x} ${y}: expected ${expected}, found ${found[i]}`);
    });
  };
  await check();
  await page.keyboard.press('v'); // what is moved takes its clip along, and what is repainted in part is the same
  await page.mouse.click(...await place(page, 70, 60));
  await page.keyboard.press('Shift+ArrowDown');
  await quiet(page);
  await page.keyboard.press('Escape');
  await quiet(page);
  await check(10);
  await page.keyboard.press('Control+z');
  await quiet(page);
  await check();
});

const ORDERS = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><g fill="#f00" stroke="#00f" stroke-width="20">
<rect x="30" y="30" width="80" height="80" style="paint-order:stroke"/><rect x="160" y="30" width="80" height="80"/>
<rect x="30" y="160" width="80" height="80" paint-order="stroke" opacity=".5"/></g></svg>`;

test('a stroke can lie under its fill', async (t) => {
  const server = await serve({ name: 'orders.svg', bytes: Buffer.from(ORDERS) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  const points = [[35, 70, [255, 0, 0]], [25, 70, [0, 0, 255]], [165, 70, [0, 0, 255]], [175, 70, [255, 0, 0]], [35, 200, [255, 128, 128]],
    [25, 200, [128, 128, 255]]];
  const found = await stillColours(page, points.map(([x, y]) => [x, y]));
  points.forEach(([x, y, expected], i) => {
    const far = Math.max(...expected.map((value, k) => Math.abs(value - found[i][k])));
    assert.ok(far <= 3, `${x} ${y}: expected ${expected}, found ${found[i]}`);
  });
});
