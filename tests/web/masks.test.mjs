// Masks on the page: as the browser paints the file itself, on curves that can be shaped, and kept in the file.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, quiet, SCREENSHOTS, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const FILE = `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300" viewBox="0 0 400 300">
<defs><linearGradient id="fade"><stop offset="0" stop-color="white"/><stop offset="1" stop-color="#222"/></linearGradient>
<mask id="box"><rect width="100%" height="100%" fill="url(#fade)"/></mask>
<mask id="unit" maskContentUnits="objectBoundingBox"><circle cx=".5" cy=".5" r=".45" fill="#ddd"/><rect width=".3" height=".3" fill="red"/></mask>
<mask id="user" maskUnits="userSpaceOnUse" x="0" y="0" width="400" height="300"><circle cx="60" cy="150" r="38" fill="#fff"/>
<path d="M30 140H90V160H30Z"/></mask>
<mask id="alpha" mask-type="alpha"><rect width="400" height="300" fill-opacity=".4"/></mask>
<mask id="two"><g mask="url(#user)"><rect width="400" height="300" fill="#bbb"/></g></mask><mask id="none"/>
<mask id="along" maskUnits="userSpaceOnUse" x="240" y="200" width="160" height="100"><rect x="240" y="200" width="160" height="100" fill="url(#fade)"/></mask></defs>
<rect x="10" y="10" width="100" height="80" fill="#c33" stroke="#000" stroke-width="6" mask="url(#box)"/>
<path d="M130 10H230V90H130Z" fill="#3a3" mask="url(#unit)" transform="rotate(12 180 50)"/>
<rect x="250" y="10" width="140" height="80" fill="teal" mask="url(#missing)"/>
<ellipse cx="60" cy="150" rx="50" ry="40" fill="#33c" mask="url(#two)"/>
<path id="veil" d="M130 110H230V190H130Z" fill="#a60" style="mask:url(#alpha)" opacity=".8"/>
<rect x="250" y="110" width="100" height="80" mask="url(#none)"/>
<path id="line" d="M260 260C300 220 340 280 390 230" fill="none" stroke="#063" stroke-width="16" mask="url(#along)"/>
<g mask="url(#box)"><path d="M10 210H110V290H10Z" fill="#f80"/><path d="M60 230H160V270H60Z" fill="#08f"/></g>
<g mask="url(#user)" transform="translate(180 70)" opacity=".7"><path d="M20 120H110V200H20Z" fill="#f80"/><path d="M60 130H160V190H60Z" fill="#08f"/></g></svg>`;
const STEP = 4; // between the points that are compared

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** What the browser paints of the file itself: the colours at points where they are nearly those around them, else null. */
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
      const plain = [-2, 2].every((d) => [at(x + d, y), at(x, y + d)].every((near) => near.every((value, k) => Math.abs(value - own[k]) < 12)));
      return plain ? own : null;
    });
  }, [file, points]);
}

test('they are painted as the browser paints the file, also in a drawing that was moved and saved', async (t) => {
  const server = await serve({ name: 'masks.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints && [...globalThis.batten.painter.pictures.values()].length > 4
    && [...globalThis.batten.painter.pictures.values()].every(Boolean));
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'masks.png') });
  const grid = [];
  for (let x = 4; x < 397; x += STEP) {
    for (let y = 4; y < 297; y += STEP) {
      grid.push([x, y]);
    }
  }
  const compare = async (file) => {
    const wanted = await painted(page, file, grid);
    const points = grid.map((point, i) => [...point, wanted[i]]).filter(([, , colour]) => colour);
    assert.ok(points.filter(([, , colour]) => `${colour}` !== '255,255,255').length > 1000, 'there is something to compare');
    const found = await stillColours(page, points);
    const bad = points.filter(([, , colour], i) => colour.some((value, k) => Math.abs(value - found[i][k]) > 16));
    assert.ok(bad.length <= points.length / 200, `${bad.length} of ${points.length}: ${JSON.stringify(bad.slice(0, 6))}`);
  };
  const save = () => page.evaluate(() => new TextDecoder().decode(globalThis.batten.engine.save(false)));
  await compare(FILE);
  assert.equal(await save(), FILE);

  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 20, 80)); // a curve, and a group, which are masked
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Escape');
  await page.mouse.click(...await place(page, 30, 250));
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Escape');
  await quiet(page);
  const saved = await save();
  assert.notEqual(saved, FILE);
  assert.match(saved, /<path id="veil" d="M130 110H230V190H130Z" fill="#a60" style="mask:url\(#alpha\)" opacity=".8"\/>/);
  assert.equal(await page.evaluate(() => globalThis.batten.engine.check?.() ?? ''), '');
  await quiet(page);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'masks-moved.png') });
  await compare(saved);
});

test('a curve with a mask is redrawn, and its mask stays in the file', async (t) => {
  const server = await serve({ name: 'masks.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => globalThis.batten.painter.paints);
  await quiet(page);
  const stroke = bezier([285, 246], [305, 232], [330, 240], [350, 252]);
  await hand.stroke(await Promise.all(stroke.map(([x, y]) => place(page, x, y))));
  await quiet(page);
  const saved = await page.evaluate(() => new TextDecoder().decode(globalThis.batten.engine.save(false)));
  const [line] = saved.match(/<path[^>]*id="line"[^>]*>/) ?? [''];
  assert.match(line, /mask="url\(#along\)"/);
  assert.doesNotMatch(line, /C300 220 340 280 390 230"/, 'the line has another shape');
  assert.ok(saved.includes(FILE.slice(FILE.indexOf('<defs>'), FILE.indexOf('</defs>'))), 'the masks are as they were');
});
