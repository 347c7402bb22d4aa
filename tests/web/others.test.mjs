// label: all (a minute of files of others). Files of other programs with one point of one curve moved a little: Chromium shows them
// as before. So does it where style sheets say where things are, with any of them moved or turned. What is said to look otherwise does. FILES=5000 node tests/web/run.mjs tests/web/others.test.mjs tries so many of them, with FOLDER=... those of a folder.
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
const FOLDERS = process.env.FOLDER ? [process.env.FOLDER] : [...['examples', 'docs/pictures', 'tests/pictures/programs'].map((name) => path.join(ROOT, name)), '/usr/share/icons', '/usr/share/openclipart'];
const MOST = Number(process.env.FILES ?? 200);
const SEEDS = 5;
const LARGEST = 200000; // bytes
const SIDE = 300; // pixels
const SEEN = 96; // of 255: Chromium draws an arc, and the curve that it is, up to a quarter of a pixel apart
const FEW = 20; // pixels, along what was moved by a ten-thousandth of its size

/** Places and transforms by style: of a class, an id, a type, with !important, in a style attribute, by the box. */
const STYLED = `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300" viewBox="0 0 400 300"><style>
.r{x:20px;y:30px;width:60px;height:40px;rx:10px} #c{cx:150px;cy:50px;r:25px} .p{d:path("M200 20 L260 20 L230 80 Z")}
.i{x:350px!important;transform:skewX(9deg)!important} @media print{.r{x:1px}} ellipse{transform:translateX(5%)} g{transform:translate(10%,270px)}</style>
<clipPath id="k" style="transform:translate(5px,0)"><rect style="x:290px;y:210px;width:50px;height:30px"/></clipPath><defs><rect id="u" width="20" height="20"/></defs>
<rect class="r" fill="red"/><circle id="c" fill="green"/><path class="p" fill="blue"/><path d="M9 9H19V19z" style="d:none"/>
<rect width="10" height="10" style="x:300px;y:20px;width:40px;height:50px" fill="purple"/><rect class="i" y="20" width="40" height="20" style="x:10px" fill="#333"/>
<rect x="20" y="150" width="60" height="40" style="transform:rotate(45deg);transform-origin:50px 170px" fill="orange"/>
<rect x="120" y="150" width="60" height="40" style="transform:rotate(45deg);transform-box:fill-box;transform-origin:center" fill="teal"/>
<rect x="220" y="150" width="60" height="40" style="transform:scale(.5);transform-box:fill-box;transform-origin:100% 100%" fill="navy"/>
<rect x="320" y="150" width="60" height="40" style="transform:translate(10px,20px) skewX(10deg);transform-box:fill-box" fill="brown"/>
<ellipse style="cx:50px;cy:260px;rx:30px;ry:10%" fill="pink"/><rect x="120" y="240" width="60" height="40" style="rotate:20deg;transform-box:fill-box;transform-origin:center"/>
<use href="#u" style="x:220px;y:220px"/><use href="#u" transform="rotate(45)" transform-origin="260 240" x="250" y="230" fill="lime"/>
<rect x="280" y="200" width="80" height="60" clip-path="url(#k)" fill="red"/><g><rect width="10" height="10"/></g>
<rect style="--w:30px;x:200px;y:260px;width:var(--w);height:var(--w);translate:10px;scale:50% 80%;transform-origin:200px 260px" fill="#0aa"/>
<rect x="350" y="250" width="30" height="30" style="rx:50%;-webkit-transform:translate(-5px)" fill="#a0a"/></svg>`;

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

/** As many of each folder as there are, evenly spread: what a small one has not, larger ones have. */
function chosen() {
  const lists = FOLDERS.filter((one) => fs.existsSync(one)).map((one) => fs.readdirSync(one, { recursive: true }).map((name) => path.join(one, String(name)))
    .filter((name) => name.endsWith('.svg') && fs.statSync(name).isFile() && fs.statSync(name).size < LARGEST).sort());
  lists.sort((one, other) => one.length - other.length);
  let left = MOST;
  return lists.flatMap((list, k) => {
    const count = Math.min(list.length, Math.floor(left / (lists.length - k)));
    left -= count;
    return Array.from({ length: count }, (_, i) => list[Math.floor((i * list.length) / count)]);
  });
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
const differing = (page, files, seen = SEEN) => page.evaluate(async ({ sources, side, seen }) => {
  try {
    const [a, b] = await Promise.all(sources.map(async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const context = new OffscreenCanvas(side, side).getContext('2d');
      context.drawImage(image, 0, 0, side, side);
      return context.getImageData(0, 0, side, side).data;
    }));
    const at = (data, i) => (i % 4 === 3 ? data[i] : (data[i] * data[i | 3]) / 255); // what is clear has no colour
    return a.reduce((count, _, i) => count + Number(Math.abs(at(a, i) - at(b, i)) > seen), 0);
  } catch {
    return -1;
  }
}, { sources: files.map((file) => `data:image/svg+xml;base64,${fs.readFileSync(file).toString('base64')}`), side: SIDE, seen });

/** Moves an object by (8, 3), or turns it about the origin by a twentieth. */
function move(one, turn) {
  const map = ([x, y]) => (turn ? [x - 0.05 * y, y + 0.05 * x] : [x + 8, y + 3]);
  if (one.primitive) {
    const [a, b, c, d, e, f] = one.primitive.place;
    const [at, along, up] = [map([e, f]), map([e + a, f + b]), map([e + c, f + d])];
    one.primitive.place = [along[0] - at[0], along[1] - at[1], up[0] - at[0], up[1] - at[1], ...at];
  }
  for (const curve of one.curves ?? []) {
    curve.points = curve.points.map(map);
  }
}

test('where style says where things are they are there, and where they were moved to', async () => {
  const page = await browser.newPage();
  const [file, kept, alone, drawn, moved, saved] = ['styled.svg', 'kept.batten', 'alone.batten', 'drawn.svg', 'moved.batten', 'saved.svg']
    .map((name) => path.join(folder, name));
  const convert = (from, to) => execFileSync(PROGRAM, ['convert', from, to], { stdio: 'pipe' });
  /** What the document itself looks like, without the file that it came from. */
  const draw = (document) => {
    fs.writeFileSync(alone, JSON.stringify({ ...document, source: undefined }));
    convert(alone, drawn);
  };
  fs.writeFileSync(file, STYLED);
  convert(file, kept);
  const text = fs.readFileSync(kept, 'utf8');
  draw(JSON.parse(text));
  assert.equal(await differing(page, [file, drawn]), 0, 'as it was read');
  const count = JSON.parse(text).objects.length;
  assert.ok(count > 15);
  for (let i = 0; i < count; i++) {
    for (const turn of [false, true]) {
      const document = JSON.parse(text);
      const one = document.objects[i];
      move(one, turn);
      draw(document);
      fs.writeFileSync(moved, JSON.stringify(document));
      convert(moved, saved);
      const what = `${i}, ${turn ? 'turned' : 'moved'}`;
      const other = await differing(page, [saved, drawn]);
      assert.ok(other >= 0 && other <= FEW, `${what}: ${other} values differ`);
      assert.ok(fs.readFileSync(saved, 'utf8').includes('<style>\n.r{x:20px'), `${what}: the file is kept`);
    }
  }
});

/** What is faulty, or makes no picture: told where Chromium shows something else, and nowhere else. */
const FAULTS = {
  same: ['<path d="M10 10L90 10L90 90 X 10 10"/>', '<path d="M10 10L90 10L90"/>', '<path d="L10 10 90 10 90 90"/><path d="z"/>', '<path d="M10 10A5 5 0 2 0 90 90L50 50"/>',
    '<rect width="30" height="30" transform="translate(20) foo(3)"/>', '<rect x="50" width="30" height="30" transform="rotate(30deg)"/>',
    '<rect x="50" width="30" height="30" transform="translate(10),"/>', '<use href="#no"/><use/><use id="a" href="#a"/>', '<rect width="-9" height="9"/><rect x="foo" width="50" height="50" rx="-5"/><circle r="-5"/>',
    '<circle cx="50" cy="50" r="40" fill="#36c" opacity=".5" color-rendering="optimizeSpeed" color-interpolation="linearRGB"/>',
    '<svg x="10" y="10" width="50" height="50"><rect width="30" height="30"/></svg>', '<svg width="50" height="50" overflow="visible"><rect width="90" height="90"/></svg>',
    '<rect width="50" height="50" fill="red"/><rect x="100" width="50" height="50" fill="blue" style="mix-blend-mode:multiply"/>',
    '<g id="q"><rect width="50" height="50"/><rect x="20" width="50" height="50"/></g><use href="#q" y="60" opacity=".5"/>',
    '<symbol id="q"><rect width="50" height="50"/><rect x="80" width="50" height="50"/></symbol><use href="#q" y="60" opacity=".5"/>',
    '<rect width="50" height="50" fill="url(#no) red" clip-path="url(#no)"/><rect x="60" width="50" height="50" fill="url(#no)"/>',
    '<path d="M0 9H90" stroke="red" stroke-width="4" stroke-dasharray="0 0"/><text x="5" y="5"> </text><image width="9" height="9"/>'],
  other: ['<rect width="calc(10px + 20px)" height="90"/>', '<circle cx="50" cy="50" r="40" shape-rendering="crispEdges"/>', '<svg x="10" y="10" width="50" height="50"><rect width="90" height="90"/></svg>',
    '<linearGradient id="g" color-interpolation="linearRGB"><stop stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient><circle cx="50" cy="50" r="40" fill="url(#g)"/>',
    '<rect width="90" height="90" fill="red"/><rect width="50" height="50" fill="blue" style="mix-blend-mode:screen"/>',
    '<symbol id="q"><rect width="50" height="50"/><rect x="20" y="20" width="50" height="50"/></symbol><use href="#q" opacity=".5"/>'],
};

test('what is told as not shown is what Chromium shows otherwise', async () => {
  const page = await browser.newPage();
  const [file, kept, drawn] = ['fault.svg', 'fault.batten', 'drawn.svg'].map((name) => path.join(folder, name));
  for (const [i, body] of [...FAULTS.same, ...FAULTS.other].entries()) {
    const told = i >= FAULTS.same.length;
    fs.writeFileSync(file, `<svg xmlns="http://www.w3.org/2000/svg" width="200" height="150">${body}</svg>`);
    execFileSync(PROGRAM, ['convert', file, kept], { stdio: 'pipe' });
    fs.writeFileSync(kept, JSON.stringify({ ...JSON.parse(fs.readFileSync(kept, 'utf8')), source: undefined }));
    execFileSync(PROGRAM, ['convert', kept, drawn], { stdio: 'pipe' });
    assert.equal(/^shows /m.test(String(execFileSync(PROGRAM, ['info', file]))), told, body);
    assert.equal(await differing(page, [file, drawn], SEEN / 4) !== 0, told, `${body}: in Chromium`);
  }
});

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
