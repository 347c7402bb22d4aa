// Markers on the page: at the vertices of a curve, also of one that is moved, and as translucent as it is.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const FILE = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
<marker id="square" markerWidth="4" markerHeight="4" refX="2" refY="2"><path d="M0 0H9V9H0Z" fill="context-stroke"/></marker>
<marker id="dot" markerUnits="userSpaceOnUse" markerWidth="40" markerHeight="40" refX="20" refY="20"><circle cx="20" cy="20" r="20" fill="#0000ff"/></marker>
<g fill="none" stroke="#c00000" stroke-width="10" marker-start="url(#square)"><path d="M50 60H200V150" marker-mid="url(#dot)"/>
<path d="M300 60V150" opacity=".5" marker-end="url(#dot)"/><path d="M50 250H200" stroke="#008000" paint-order="markers" marker-end="url(#dot)"/></g></svg>`;

const [RED, BLUE, GREEN, PAPER, ROSE, PALE] = [[192, 0, 0], [0, 0, 255], [0, 128, 0], [255, 255, 255], [224, 128, 128], [128, 128, 255]];

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

async function expect(page, points) {
  await quiet(page);
  const found = await stillColours(page, points);
  points.forEach(([x, y, colour], i) => assert.ok(colour.every((value, k) => Math.abs(value - found[i][k]) < 12), `at ${x},${y}: ${found[i]}`));
}

test('they are seen at the vertices, go with the curve, and come back', async (t) => {
  const server = await serve({ name: 'marked.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  await page.waitForFunction(() => Boolean(globalThis.batten.painter.paints));
  const first = [[65, 75, RED], [35, 45, RED], [75, 85, PAPER], [200, 60, BLUE], [215, 60, BLUE], [200, 150, PAPER]];
  await expect(page, [...first, [315, 45, ROSE], [300, 60, ROSE], [300, 150, PALE], [190, 250, GREEN], [210, 250, BLUE]]);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'markers.png') });

  await page.keyboard.press('v');
  const [from, to] = [await place(page, 120, 60), await place(page, 150, 90)];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...await place(page, 140, 80));
  await page.mouse.move(...to);
  await page.mouse.up();
  await page.keyboard.press('Escape');
  await expect(page, [[95, 105, RED], [230, 90, BLUE], [245, 90, BLUE], [215, 60, PAPER]]);
  await page.keyboard.press('Control+z');
  await expect(page, first);
});
