// Five jobs of an illustrator, done by hand: every pen stroke, drag, click and key is counted, and docs/jobs.md says as many, beside what the
// documented steps of other programs take.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import { bezier, launch, open, place, quiet, reveal, SCREENSHOTS, state, stillColours } from './page.mjs';
import { serve } from './server.mjs';

const PAGE = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../docs/jobs.md');

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const near = (found, wanted) => Math.max(...wanted.map((value, k) => Math.abs(value - found[k]))) <= 16;

/** One that works and is counted. */
class Worker {
  constructor(page, hand) {
    Object.assign(this, { page, hand, strokes: 0, drags: 0, clicks: 0, keys: 0 });
  }

  async at(points) {
    return Promise.all(points.map(([x, y]) => place(this.page, x, y)));
  }

  /** Through places of the drawing. */
  async draw(points) {
    this.strokes++;
    await this.hand.stroke(await this.at(points));
    await quiet(this.page);
  }

  async drag(from, to) {
    this.drags++;
    await this.hand.stroke(await this.at([from, to]), { pointerType: 'mouse' });
    await quiet(this.page);
  }

  async click(what) {
    this.clicks++;
    await (typeof what === 'string' ? this.page.locator(what).first().click() : this.page.mouse.click(...(await this.at([what]))[0]));
    await quiet(this.page);
  }

  /** Keys one after the other; a chord is one. */
  async press(...keys) {
    for (const key of keys) {
      this.keys++;
      await this.page.keyboard.press(key);
      await quiet(this.page);
    }
  }
}

/** The row that the page has for this job. @param {string} job */
function told(job) {
  const row = fs.readFileSync(PAGE, 'utf8').split('\n').find((line) => line.startsWith(`| ${job} |`));
  assert.ok(row, `docs/jobs.md has no row for ${job}`);
  const [strokes, drags, clicks, keys, sum, theirs] = row.split('|').slice(2).map((cell) => parseInt(cell, 10));
  return { strokes, drags, clicks, keys, sum, theirs };
}

/** Opens a drawing, has the job done, and compares what it took. */
function job(name, bytes, work) {
  test(name, async (t) => {
    const server = await serve({ name: 'job.svg', bytes: Buffer.from(bytes) });
    t.after(() => server.close());
    const { page, hand } = await open(browser, server.address, { colorScheme: 'light' });
    await reveal(page, 'style');
    await reveal(page, 'numbers');
    await page.locator('#stage').focus();
    const worker = new Worker(page, hand);
    await work(page, worker);
    await quiet(page);
    await page.screenshot({ path: path.join(SCREENSHOTS, `job-${name.replace(/[^a-z]+/gi, '-').toLowerCase()}.png`) });
    assert.equal((await state(page)).check, '');
    const { strokes, drags, clicks, keys } = worker;
    const done = { strokes, drags, clicks, keys, sum: strokes + drags + clicks + keys };
    const { theirs, ...row } = told(name);
    assert.deepEqual(row, done, `docs/jobs.md says otherwise: | ${name} | ${Object.values(done).join(' | ')} |`);
    assert.ok(done.sum <= theirs, 'it takes no more than elsewhere');
  });
}

const objectsOf = (page) => page.evaluate(() => JSON.parse(new TextDecoder().decode(batten.engine.save(true))).objects);

const EMPTY = '<svg xmlns="http://www.w3.org/2000/svg" width="800" height="600"/>';

job('wine glass', EMPTY, async (page, worker) => {
  await worker.press('n', 'y');
  // The right half of the outline, from the axis to the axis: rim, bowl, stem, foot.
  await worker.draw([[400, 120], [480, 120], ...bezier([480, 120], [520, 260], [470, 330], [412, 350]), [410, 480],
    ...bezier([410, 480], [420, 505], [470, 505], [480, 520]), [400, 520]]);
  const [glass, ...others] = await objectsOf(page);
  assert.equal(others.length, 0, 'one curve');
  assert.equal(glass.curves[0].closed, true);
});

job('letter S', EMPTY, async (page, worker) => {
  await worker.press('n');
  await worker.draw([...bezier([480, 190], [420, 90], [300, 130], [330, 230]), ...bezier([330, 230], [360, 330], [500, 290], [490, 400]),
    ...bezier([490, 400], [480, 500], [340, 510], [310, 420])]);
  await worker.press('Shift+W');
  await worker.drag([425, 311], [437, 288]);
  const [letter, ...others] = await objectsOf(page);
  assert.equal(others.length, 0, 'one curve');
  const at = letter.paint.widths.findIndex(([, share]) => share > 5); // a bulge over most of it, no spike between two of many stops
  const [before, after] = [letter.paint.widths[at - 1], letter.paint.widths[at + 1]];
  assert.ok(before[0] < 0.3 && after[0] > 0.7, JSON.stringify(letter.paint));
});

/** As a new page of this size. */
const MILLIMETRES = `<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 ${100 * 96 / 25.4} ${80 * 96 / 25.4}"/>`;

job('logo in millimetres', MILLIMETRES, async (page, worker) => {
  await page.evaluate(() => { batten.engine.set('unit', 1); batten.engine.set('filled', 1); batten.wake?.(); });
  for (const [key, width, height] of [['o', '40', '40'], ['r', '60', '10']]) {
    await worker.press(key);
    await worker.click([60, 60]);
    await page.waitForSelector('#number-width:focus');
    await worker.press(...width, 'Tab', ...height, 'Enter');
    await page.waitForSelector('#stage:focus');
  }
  await worker.press('Control+a');
  await worker.click('#numbers [data-name=align-centre]');
  await worker.click('#numbers [data-name=align-middle]');
  await worker.click('#actions [data-name=region-subtract]');
  const [logo, ...others] = await objectsOf(page);
  assert.equal(others.length, 0, 'one object');
  assert.equal(logo.curves.length, 2, 'two halves');
});

/** A grey PNG with a dark drop in it, base 64: what a photo of a pebble would be. */
function photo(size) {
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name), data]);
    const length = Buffer.alloc(4);
    const sum = Buffer.alloc(4);
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(zlib.crc32(body));
    return Buffer.concat([length, body, sum]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(size);
  head.writeUInt32BE(size, 4);
  head.set([8, 0], 8);
  const rows = Array.from({ length: size }, (_, y) => Buffer.from([0, ...Array.from({ length: size }, (__, x) =>
    (((x - size / 2) / (0.36 * size)) ** 2 + ((y - size / 2) / (0.27 * size)) ** 2 < 1 ? 40 + ((x * 7 + y * 13) % 31) : 200))]));
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head),
    chunk('IDAT', zlib.deflateSync(Buffer.concat(rows))), chunk('IEND', Buffer.alloc(0))]).toString('base64');
}

job('photo traced by hand', EMPTY, async (page, worker) => {
  worker.drags++; // the file, out of its folder
  await page.evaluate((data) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], 'pebble.png', { type: 'image/png' }));
    document.getElementById('stage').dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer }));
  }, photo(400));
  await page.waitForFunction(() => [...batten.painter.pictures.values()].filter(Boolean).length === 1);
  await quiet(page);
  const { matrix } = (await objectsOf(page)).find((object) => object.matrix);
  await worker.press('n');
  const around = Array.from({ length: 73 }, (_, i) => {
    const angle = (i * Math.PI) / 36;
    const [x, y] = [200 + 144 * Math.cos(angle), 200 + 108 * Math.sin(angle)];
    return [matrix[0] * x + matrix[2] * y + matrix[4], matrix[1] * x + matrix[3] * y + matrix[5]];
  });
  await worker.draw(around);
  const curves = (await objectsOf(page)).filter((object) => object.curves);
  assert.equal(curves.length, 1);
  assert.equal(curves[0].curves[0].closed, true);
});

const TWELVE = `<svg xmlns="http://www.w3.org/2000/svg" width="800" height="600">${Array.from({ length: 12 }, (_, i) =>
  `<circle cx="${60 + 61 * i}" cy="${150 + ((i * 97) % 280)}" r="${18 + ((i * 5) % 9)}" fill="${['#c0392b', '#2980b9', '#f1c40f'][i % 3]}"/>`)
  .join('')}</svg>`;

job('twelve recoloured and aligned', TWELVE, async (page, worker) => {
  await worker.press('Control+a');
  await worker.click('.swatches >> nth=1 >> button.swatch >> nth=1');
  await worker.click('#numbers [data-name=align-middle]');
  await worker.click('#numbers [data-name=distribute-across]');
  const objects = (await objectsOf(page)).filter((object) => object.primitive);
  assert.equal(new Set(objects.map(({ style }) => style.fill)).size, 1, 'one colour');
  assert.equal(objects.length, 12);
  const [colour] = await stillColours(page, [[60, 264]]);
  assert.ok(!near(colour, [255, 255, 255]), `the first stands in the row: ${colour}`);
});
