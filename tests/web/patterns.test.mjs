// Patterns on the page: as the browser paints the file itself, on curves that can be shaped, and kept in the file.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, quiet, SCREENSHOTS, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const FILE = `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300" viewBox="0 0 400 300" fill="teal">
<defs><pattern id="dots" width="20" height="20" patternUnits="userSpaceOnUse" x="3" y="4"><circle cx="6" cy="6" r="5" fill="red"/>
<rect x="12" y="12" width="8" height="8"/></pattern><pattern id="turned" href="#dots" patternTransform="rotate(30) scale(.7)"/>
<pattern id="part" width=".25" height=".2"><rect width="10" height="8" fill="#36c"/></pattern>
<pattern id="box" width=".2" height=".2" patternContentUnits="objectBoundingBox"><circle cx=".1" cy=".1" r=".07" fill="purple"/></pattern>
<pattern id="view" width="30" height="20" patternUnits="userSpaceOnUse" viewBox="0 0 10 10" fill="green"><path d="M0 0H10L5 10Z"/></pattern></defs>
<rect x="10" y="10" width="110" height="80" fill="url(#dots)"/><circle cx="190" cy="55" r="45" fill="url(#turned)" fill-opacity=".5"/>
<path d="M250 10H380V90H260Z" fill="url(#part)"/><ellipse cx="70" cy="160" rx="50" ry="40" fill="url(#box)" stroke="url(#dots)" stroke-width="12"/>
<g transform="translate(150 110) rotate(10) scale(1.3 .8)"><rect width="100" height="90" fill="url(#view)"/></g>
<path id="line" d="M300 120C330 100 380 150 350 200S280 280 390 280" fill="none" stroke="url(#turned)" stroke-width="20"/>
<path id="faded" d="M20 230H120V290H20Z" fill="url(#part)" opacity=".6"/></svg>`;
const STEP = 4; // between the points that are compared

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** What the browser paints of the file itself: the colours at points, and whether they are those around them. */
function painted(page, file, points) {
  return page.evaluate(async ([text, all]) => {
    const image = new Image();
    image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
    await image.decode();
    const canvas = new OffscreenCanvas(400, 300);
    const context = canvas.getContext('2d');
    context.fillStyle = '#fff';
    context.fillRect(0, 0, 400, 300);
    context.drawImage(image, 0, 0);
    const at = (x, y) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3);
    return all.map(([x, y]) => {
      const own = at(x, y);
      const plain = [-2, 2].every((d) => `${at(x + d, y)}` === `${own}` && `${at(x, y + d)}` === `${own}`);
      return plain ? own : null;
    });
  }, [file, points]);
}

test('they are painted as the browser paints the file, and again in a shape that was moved', async (t) => {
  const server = await serve({ name: 'patterns.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints && [...globalThis.batten.painter.pictures.values()].length > 3
    && [...globalThis.batten.painter.pictures.values()].every(Boolean));
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'patterns.png') });
  const grid = [];
  for (let x = 4; x < 397; x += STEP) {
    for (let y = 4; y < 297; y += STEP) {
      grid.push([x, y]);
    }
  }
  const compare = async (file, least) => {
    const wanted = await painted(page, file, grid);
    const points = grid.map((point, i) => [...point, wanted[i]]).filter(([, , colour], i) => colour && (i % 8 === 0 || `${colour}` !== '255,255,255'));
    assert.ok(points.filter(([, , colour]) => `${colour}` !== '255,255,255').length > least, `there is something to compare: ${points.filter(([, , colour]) => `${colour}` !== '255,255,255').length}`);
    const found = await stillColours(page, points);
    const bad = points.filter(([, , colour], i) => colour.some((value, k) => Math.abs(value - found[i][k]) > 24));
    assert.ok(bad.length <= points.length / 200, `${bad.length} of ${points.length}: ${JSON.stringify(bad.slice(0, 6))}`);
  };
  await compare(FILE, 100);
  assert.equal(await page.evaluate(() => globalThis.batten.engine.save(false).length), FILE.length);

  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 20, 20));
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Escape');
  await quiet(page);
  const saved = await page.evaluate(() => new TextDecoder().decode(globalThis.batten.engine.save(false)));
  assert.match(saved, /<path id="line" d="M300 120C330 100 380 150 350 200S280 280 390 280" fill="none" stroke="url\(#turned\)" stroke-width="20"\/>/);
  await compare(saved, 100);
});

test('a curve with a pattern is redrawn, and its paint stays in the file', async (t) => {
  const server = await serve({ name: 'patterns.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  const stroke = bezier([347, 134], [362, 140], [368, 158], [359, 171]);
  await hand.stroke(await Promise.all(stroke.map(([x, y]) => place(page, x, y))));
  await quiet(page);
  const saved = await page.evaluate(() => new TextDecoder().decode(globalThis.batten.engine.save(false)));
  const [line] = saved.match(/<path[^>]*id="line"[^>]*>/) ?? [''];
  assert.match(line, /stroke="url\(#turned\)"/);
  assert.doesNotMatch(line, /S280 280 390 280" fill/, 'the line has another shape');
  assert.equal(saved.split('<pattern').length, FILE.split('<pattern').length);
});
