// label: all (a minute of files of others). Files of other programs with one point of one curve moved a little: Chromium shows them
// as before. FILES=5000 node tests/web/run.mjs tests/web/others.test.mjs tries so many of them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch } from './page.mjs';
import { PROGRAM } from './server.mjs';

const ROOT = path.join(path.dirname(fileURLToPath(import.meta.url)), '../..');
const FOLDERS = [...['examples', 'docs/pictures', 'tests/pictures/programs'].map((name) => path.join(ROOT, name)), '/usr/share/icons', '/usr/share/openclipart'];
const MOST = Number(process.env.FILES ?? 200);
const SEEDS = 5;
const LARGEST = 200000; // bytes
const SIDE = 300; // pixels
const SEEN = 96; // of 255: Chromium draws an arc, and the curve that it is, up to a quarter of a pixel apart
const FEW = 20; // pixels, along what was moved by a ten-thousandth of its size

let browser;
let folder;
before(async () => {
  browser = await launch();
  folder = fs.mkdtempSync(path.join(os.tmpdir(), 'others-'));
});
after(async () => {
  await browser.close();
  fs.rmSync(folder, { recursive: true });
});

/** As many of each folder, evenly spread. */
function chosen() {
  const lists = FOLDERS.filter((one) => fs.existsSync(one)).map((one) => fs.readdirSync(one, { recursive: true }).map((name) => path.join(one, String(name)))
    .filter((name) => name.endsWith('.svg') && fs.statSync(name).isFile() && fs.statSync(name).size < LARGEST).sort());
  return lists.flatMap((list) => {
    const step = Math.max(1, Math.floor((list.length * lists.length) / MOST));
    return list.filter((_, i) => i % step === 0);
  }).slice(0, MOST);
}

/** Moves a point of a path that is shown by a ten-thousandth of its curve's size: none that coincides with another, since there a
 * curve has no direction and would get any. @returns {boolean} whether there is one */
function nudge(drawing, seed) {
  const hidden = new Set();
  const paths = drawing.objects.filter((one) => {
    if (one.hidden || hidden.has(one.parent)) {
      hidden.add(one.id);
      return false;
    }
    return one.kind === 'path' && one.curves?.length;
  });
  const curve = paths[(7 * seed) % paths.length]?.curves[0];
  const points = curve?.points ?? [];
  const xs = points.map(([x]) => x);
  const step = 1e-4 * (Math.max(...xs) - Math.min(...xs) || 1);
  const apart = (one, other) => Math.hypot(one[0] - other[0], one[1] - other[1]) > 30 * step;
  const alone = points.filter((point, i) => i > 0 && i < points.length - 1 && apart(point, points[i - 1]) && apart(point, points[i + 1]));
  if (alone.length) {
    alone[(5 * seed) % alone.length][0] += step;
  }
  return alone.length > 0;
}

/** How many pixels of two pictures differ; -1: Chromium shows none. */
const differing = (page, files) => page.evaluate(async ({ sources, side, seen }) => {
  try {
    const [a, b] = await Promise.all(sources.map(async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const context = new OffscreenCanvas(side, side).getContext('2d');
      context.drawImage(image, 0, 0, side, side);
      return context.getImageData(0, 0, side, side).data;
    }));
    return a.reduce((count, value, i) => count + Number(Math.abs(value - b[i]) > seen), 0);
  } catch {
    return -1;
  }
}, { sources: files.map((file) => `data:image/svg+xml;base64,${fs.readFileSync(file).toString('base64')}`), side: SIDE, seen: SEEN });

test('with a point moved Chromium shows files of others as before', async () => {
  const page = await browser.newPage();
  const [kept, moved, saved] = ['kept.batten', 'moved.batten', 'saved.svg'].map((name) => path.join(folder, name));
  let tried = 0;
  for (const [i, file] of chosen().entries()) {
    execFileSync(PROGRAM, ['convert', file, kept], { stdio: 'pipe' });
    const drawing = JSON.parse(fs.readFileSync(kept, 'utf8'));
    if (nudge(drawing, i % SEEDS) && await differing(page, [file, file]) === 0) {
      fs.writeFileSync(moved, JSON.stringify(drawing));
      execFileSync(PROGRAM, ['convert', moved, saved], { stdio: 'pipe' });
      const count = await differing(page, [file, saved]);
      assert.ok(count >= 0 && count <= FEW, `${file}: ${count} values differ`);
      tried++;
    }
  }
  assert.ok(tried > 20, `${tried} files`);
});
