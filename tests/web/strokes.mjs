// Outlines of strokes beside Chromium's own strokes: node strokes.mjs ARM [FROM [TO [SCALE [FAR]]]] (see tests/relate/strokes.c). Both are
// painted, and samples of which one is covered by more than half and the other by less differ, where by more than a quarter.
// Ends with a failure where an outline was refused, or more than .1 % of all samples differ.
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

import { BROWSER } from './chromium.mjs';

const BATCH = 250;
/** Of all samples: as many may differ. */
export const MOST = 1e-3;

/** How many samples differ, of each stroke. Runs in the page. */
function compare(strokes) {
  const SIDE = 160;
  const canvas = new OffscreenCanvas(SIDE, SIDE);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  const alpha = (paint) => {
    context.resetTransform();
    context.clearRect(0, 0, SIDE, SIDE);
    paint();
    return context.getImageData(0, 0, SIDE, SIDE).data;
  };
  return strokes.map(({ index, status, width, cap, join, stroke, outline }) => {
    const path = new Path2D(stroke);
    const scale = SIDE / (100 + 2 * width + 4);
    const place = () => context.setTransform(scale, 0, 0, scale, (width + 2) * scale, (width + 2) * scale);
    const theirs = alpha(() => {
      place();
      Object.assign(context, { lineWidth: width, lineCap: cap, lineJoin: join, miterLimit: 4 });
      context.stroke(path);
    });
    const ours = alpha(() => { place(); context.fill(new Path2D(outline)); });
    let differ = 0;
    let more = 0;
    for (let i = 3; i < theirs.length; i += 4) {
      if ((theirs[i] > 127) === (ours[i] > 127) || Math.abs(theirs[i] - ours[i]) < 64) continue;
      differ++;
      if (ours[i] > theirs[i]) more++;
    }
    return { index, status, differ, more, samples: SIDE * SIDE, what: `width ${width.toFixed(2)} ${cap} ${join}` };
  });
}

/** The strokes from one number to another, and of how many samples of each the outline's picture differs. `rest`: SCALE, FAR. */
export async function compareStrokes(page, arm, from, to, ...rest) {
  const all = [];
  for (let at = from; at < to; at += BATCH) {
    const asked = [at, Math.min(at + BATCH, to), ...rest].map(String);
    const lines = execFileSync(arm, asked, { maxBuffer: 1 << 30 }).toString().split('\n').filter(Boolean);
    all.push(...await page.evaluate(compare, lines.map((line) => JSON.parse(line))));
  }
  const sum = (name) => all.reduce((total, one) => total + one[name], 0);
  return { all, refused: all.filter((one) => one.status !== 0), share: sum('differ') / sum('samples') };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [arm, from = '0', to = '10000', ...rest] = process.argv.slice(2);
  const browser = await chromium.launch(BROWSER);
  const { all, refused, share } = await compareStrokes(await browser.newPage(), arm, Number(from), Number(to), ...rest);
  await browser.close();
  const off = all.filter((one) => one.differ > MOST * one.samples);
  for (const one of [...refused, ...off.sort((a, b) => b.differ - a.differ)].slice(0, 20))
    console.log(`${one.index}: status ${one.status}, ${one.differ} samples differ, ${one.more} are ours (${one.what})`);
  console.log(`${all.length} strokes: ${refused.length} refused, ${off.length} with more than .1 % of samples, `
    + `${(100 * share).toFixed(4)} % of all samples differ`);
  process.exitCode = refused.length > 0 || share > MOST ? 1 : 0;
}
