// Foreign content, which the page does not edit: seen where it lies and in its order; chosen, moved and deleted; and isolated,
// so that a hostile file fetches and runs nothing.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, place, quiet, SCREENSHOTS, state, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const FILE = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 400 300">
<style>.words{font:bold 60px sans-serif;fill:#c00000} @import url(http://localhost:9/style.css);</style>
<filter id="f" x="0" y="0" width="1" height="1"><feFlood flood-color="#008000"/></filter>
<mask id="m"><rect x="20" y="200" width="50" height="60" fill="#fff"/></mask>
<filter id="n"><feOffset dx="0"/></filter><g filter="url(#n)"><rect x="300" y="20" width="60" height="60"/><text onclick="alert(1)">a<script>fetch('/script')</script></text>
<image width="9" height="9" xlink:href="http://localhost:9/picture.png"/><image width="9" height="9" href="/own.png"/>
<foreignObject width="50" height="50"><iframe xmlns="http://www.w3.org/1999/xhtml" src="/frame.html"/></foreignObject></g>
<rect id="flood" x="20" y="20" width="100" height="60" filter="url(#f)"/>
<rect id="cover" x="60" y="20" width="20" height="60" fill="#ffff00"/>
<circle id="dots" cx="200" cy="60" r="40" fill="#0000ff" filter="url(#n)"/>
<rect id="half" x="20" y="200" width="100" height="60" mask="url(#m)"/>
<text id="words" class="words" x="150" y="260">████</text></svg>`;

const [GREEN, YELLOW, BLUE, BLACK, RED, PAPER] = [[0, 128, 0], [255, 255, 0], [0, 0, 255], [0, 0, 0], [192, 0, 0], [255, 255, 255]];

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const shown = (page) => page.waitForFunction(() => {
  const all = [...globalThis.batten.painter.pictures.values()];
  return all.length >= 5 && all.every(Boolean);
});

/** What is seen soon, for a picture is painted when it has been made. */
async function expect(page, points) {
  for (const begun = Date.now(); ;) {
    await quiet(page);
    const found = await stillColours(page, points);
    const wrong = points.flatMap(([x, y, colour], i) =>
      (colour.every((value, k) => Math.abs(value - found[i][k]) < 12) ? [] : [`at ${x},${y}: ${found[i]}`]));
    if (!wrong.length || Date.now() - begun > 5000) {
      assert.deepEqual(wrong, []);
      return;
    }
  }
}

test('it is seen in its order, chosen, moved, deleted, and saved as the element that it was', async (t) => {
  const server = await serve({ name: 'mixed.svg', bytes: Buffer.from(FILE) });
  t.after(() => server.close());
  const { page } = await open(browser, server.address, { colorScheme: 'light' });
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  page.on('dialog', (dialog) => asked.push(dialog.message()));
  await shown(page);
  await expect(page, [[30, 50, GREEN], [70, 50, YELLOW], [110, 50, GREEN], [200, 60, BLUE], [200, 98, BLUE], [172, 28, PAPER],
    [30, 230, BLACK], [110, 230, PAPER], [170, 240, RED], [330, 50, BLACK]]);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'foreign.png') });
  assert.deepEqual(asked.filter((address) => !address.startsWith('blob:') && !/\/(stage|module|page|engine|sheets|styles|icons)\//.test(address)), []);
  // On dim paper its colours are turned over, too: what was black is seen.
  await page.emulateMedia({ colorScheme: 'dark' });
  await quiet(page);
  await shown(page);
  await expect(page, [[30, 230, PAPER]]);
  await page.emulateMedia({ colorScheme: 'light' });
  await quiet(page);
  await shown(page);
  await expect(page, [[30, 230, BLACK]]);

  await page.keyboard.press('v');
  await page.mouse.click(...await place(page, 200, 60));
  assert.equal((await state(page)).selected ?? 1, 1);
  await page.keyboard.press('Delete');
  await expect(page, [[200, 60, PAPER], [30, 50, GREEN]]);
  await page.keyboard.press('Control+z');
  await expect(page, [[200, 60, BLUE]]);
  const [from, to] = [await place(page, 200, 60), await place(page, 200, 160)];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 5 });
  await page.mouse.up();
  await expect(page, [[200, 60, PAPER], [200, 160, BLUE]]);
  await page.keyboard.press('Control+s');
  while (server.saves < 1) await new Promise((done) => { setTimeout(done, 20); });
  const text = server.bytes.toString();
  const circle = /<circle id="dots"[^>]*>/.exec(text)?.[0] ?? '';
  assert.match(circle, /filter="url\(#n\)"/);
  const [, right, down] = /matrix\(1[ ,]0[ ,]0[ ,]1[ ,]([-\d.e]+)[ ,]([-\d.e]+)\)/.exec(circle) ?? [];
  assert.ok(Math.abs(right) < 2 && Math.abs(down - 100) < 2, circle);
  assert.match(text, /<text id="words" class="words" x="150" y="260">████<\/text>/);
});
