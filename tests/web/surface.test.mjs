// The surface tool with a pen: a jug's rim is lit, redrawn with the surface following, locked and undone; in the tilted view
// as face-on.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, pictures, quiet, SCREENSHOTS, settle, state } from './page.mjs';
import { serve } from './server.mjs';

const SPACE = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../examples/space');
/** The document that a journal begins with. */
const first = (name) => {
  const line = fs.readFileSync(path.join(SPACE, `${name}.journal`), 'utf8').split('\n')[0];
  return Buffer.from(JSON.stringify(JSON.parse(line).document));
};

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const pen = { pointerType: 'pen' };

test('a line of a sheet is lit and redrawn', async (t) => {
  const server = await serve({ name: 'sheet.batten', bytes: first('sheet') });
  t.after(() => server.close());
  const { page, hand } = await open(browser, server.address);
  const shot = (name) => pictures(page, `surface-${name}`);
  const told = () => page.evaluate(() => {
    const frame = glance();
    return { notice: frame.notice, hint: frame.hint, labels: frame.labels?.length };
  });
  const begun = await state(page);
  await page.keyboard.press('b');
  const box = await page.evaluate(() => {
    const canvas = document.getElementById('still').getBoundingClientRect();
    return [canvas.left, canvas.top, canvas.width, canvas.height];
  });
  const at = (x, y) => [box[0] + box[2] * x, box[1] + box[3] * y];
  await hand.stroke([at(0.5, 0.45), at(0.5, 0.6)], pen);
  await settle(page);
  await shot('lit');
  const along = Array.from({ length: 40 }, (_, i) => {
    const share = i / 39;
    return at(0.5 + 0.06 * Math.sin(Math.PI * share) ** 3, 0.3 + 0.4 * share);
  });
  hand.rest(2);
  await hand.stroke(along, { ...pen, during: () => shot('drawing') });
  await quiet(page);
  await shot('redrawn');
  const now = await state(page);
  assert.notEqual(now.digest, begun.digest, JSON.stringify(await told()));
  assert.equal(now.check, '');
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal((await state(page)).digest, begun.digest);
  await page.keyboard.press('Shift+Alt+ArrowUp');
  await page.keyboard.press('Shift+Alt+ArrowLeft');
  await settle(page);
  await shot('tilted');
  await page.keyboard.press('Escape');
  await settle(page);
  assert.equal((await state(page)).check, '');
});

/** A sheet over x from 60 to 360 as a surface object, and its image in x = 0. */
const sheetAt = (id, side) => {
  const even = (n) => Array.from({ length: n + 4 }, (_, i) => Math.min(Math.max(i - 3, 0), n - 3));
  const points = Array.from({ length: 7 }, (_, i) => Array.from({ length: 6 }, (_, j) => [
    side * (60 + 50 * i), 200 + 80 * j, 10 * ((3 * i + 5 * j) % 9 - 4),
  ]));
  return {
    id, kind: 'surface', name: `sheet ${id}`,
    surface: { degree: [3, 3], closed: [false, false], knots: [even(7), even(6)], points },
  };
};

for (const pointerType of ['pen', 'touch']) {
  test(`with symmetry a line is redrawn on the twin, too, ${pointerType}`, async (t) => {
    const document = JSON.parse(first('sheet').toString());
    document.page = [-500, 0, 1000, 800];
    const like = document.objects.find((object) => object.kind === 'surface');
    document.objects = [1, -1].map((side, i) => ({ ...like, ...sheetAt(i + 1, side) }));
    document.next = 3;
    const server = await serve({ name: 'twins.batten', bytes: Buffer.from(JSON.stringify(document)) });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { colorScheme: 'light' });
    const shot = (name) => page.screenshot({ path: path.join(SCREENSHOTS, `surface-${name}-${pointerType}.png`) });
    const begun = await state(page);
    await page.keyboard.press('b');
    await page.keyboard.press('y');
    for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+Alt+ArrowUp');
    await page.keyboard.press('Shift+Alt+ArrowLeft');
    await settle(page);
    const box = await page.evaluate(() => {
      const canvas = globalThis.document.getElementById('still').getBoundingClientRect();
      return [canvas.left, canvas.top, canvas.width, canvas.height];
    });
    const at = (x, y) => [box[0] + box[2] * x, box[1] + box[3] * y];
    await hand.stroke([at(0.652, 0.44), at(0.632, 0.52)], { pointerType });
    await quiet(page);
    await shot('twins-lit');
    const line = await page.evaluate(() => {
      const view = glance();
      const label = view.labels?.[0];
      const canvas = globalThis.document.getElementById('still').getBoundingClientRect();
      if (!label) return null;
      const at = new DOMMatrix().scale(view.zoom).rotate(view.angle).translate(view.originX - view.x, view.originY - view.y)
        .transformPoint(label);
      return [canvas.left + at.x, canvas.top + at.y];
    });
    assert.ok(line, 'a line is lit');
    const along = Array.from({ length: 40 }, (_, i) => { // beneath the grip, along the line, bulging
      const share = i / 39;
      return [line[0] - 18 - 30 * share - 20 * Math.sin(Math.PI * share) ** 3, line[1] + 50 + 85 * share];
    });
    hand.rest(2);
    await hand.stroke(along, { pointerType, during: () => shot('twins-drawing') });
    await quiet(page);
    await shot('twins-redrawn');
    const now = await state(page);
    assert.notEqual(now.digest, begun.digest, JSON.stringify(await page.evaluate(() => glance().notice)));
    assert.equal(now.check, '');
    await page.keyboard.press('Control+z');
    await quiet(page);
    assert.equal((await state(page)).digest, begun.digest);
  });
}
