// Records what a page calls until a drawing is open and has been looked at: those functions are the first part of the module
// (web/module/first.txt). node tests/web/first_part.mjs: plays the scenes below with a module that notes its calls (binaryen's
// wasm-split), in pages to which the second part never comes, and writes the list anew. build/wasm must be built before.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { Hand, launch, place, ready, settle, state } from './page.mjs';
import { EXAMPLE, MODULE, serve } from './server.mjs';

const BUILD = path.dirname(MODULE);
const LIST = path.resolve(BUILD, '../../web/module/first.txt');
const WATCHED = path.join(BUILD, 'batten.watched.wasm');
const HEAD = `# Made by tests/web/first_part.mjs: the functions that a page calls until a drawing is open and has been looked at. They are the
# first part of the module; the others go to batten-later.wasm. A file of src/, or of the C library, and its functions.
`;
/** What small drawings of other programs have; others wait for the second part (engine/reading.js). */
const OTHERS = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 600" width="9in"><title>Kinds</title>
<g id="e" opacity=".8"><path fill="#fed" stroke="rgb(9, 20, 90)" stroke-width="2" d="M10 10h90v40q-20 30-60 10t-30-9zM20 20a30 20 9 1 0 40 9c3 3 9 2 9-8s-3-9-9-9z"/>
<circle cx="200" cy="80" r="40" stroke-dasharray="4 2" stroke="red"/><rect x="300" width="90" height="60" rx="9"/></g><ellipse cx="90" cy="400" rx="60" ry="30"/>
<polygon points="300,300 380,420 220,420" fill-rule="evenodd"/><polyline points="500,300 520,340 560,310" fill="none" stroke="#456" stroke-linejoin="round"/>
<line x1="600" y1="300" x2="800" y2="390" stroke="currentColor" color="green"/></svg>`;

/** All functions of the module in order, as [file, function], from the linker's map. */
function functions() {
  const lines = fs.readFileSync(path.join(BUILD, 'batten.map'), 'utf8').split('\n');
  const code = lines.slice(lines.findIndex((line) => / CODE$/.test(line)), lines.findIndex((line) => / DATA$/.test(line)));
  return code.map((line) => line.match(/([^ ]+):\(([A-Za-z_0-9.]+)\)$/)).filter(Boolean).map(([, file, name]) =>
    [file.replace(/^.*\/(src|web)\/(.*)\.c\.obj$/, '$2').replace(/^.*\/(lib[a-z_0-9.-]+)\.a\((.*)\)$/, '$1/$2'), name]);
}

/** Which functions a page has called, by their number. */
const called = (page) => page.evaluate(() => {
  const { wasm } = globalThis.batten.engine;
  const size = wasm.profile(0, 0);
  const address = wasm.memory_alloc(size);
  wasm.profile(address, size);
  const view = new DataView(wasm.memory.buffer, address, size); // after eight bytes when each was called first
  return Array.from({ length: (size - 8) / 4 }, (_, i) => i).filter((i) => view.getUint32(8 + 4 * i, true) !== 0);
});

/** Zoomed and moved by wheel and mouse, hovered over, resized. */
async function look(page, hand) {
  const near = (dx, dy) => [600 + dx, 350 + dy];
  await page.mouse.move(...near(0, 0));
  await page.mouse.wheel(30, 60);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -60);
  await page.keyboard.up('Control');
  await page.mouse.down({ button: 'middle' });
  await page.mouse.move(...near(40, 20), { steps: 5 });
  await page.mouse.up({ button: 'middle' });
  for (let i = 0; i < 30; i++) {
    await hand.hover(near(9 * i - 200, 6 * i - 100), i < 15 ? 'pen' : 'mouse');
  }
  await page.setViewportSize({ width: 1000, height: 700 });
  await settle(page);
}

/** Without the second part a pen moves the view, and keys do nothing. */
async function onlyLook(page, hand) {
  await page.waitForSelector('[data-about=missing]');
  await look(page, hand);
  await hand.stroke(await Promise.all([[60, 60], [200, 90], [320, 60]].map(([x, y]) => place(page, x, y))));
  await page.keyboard.press('v');
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Control+S');
  await state(page);
  await page.evaluate(() => batten.pack());
}

const car = { name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) };
/** @type {{ name: string, document?: { name: string, bytes: Buffer }, options?: object, missing?: boolean }[]} */
const SCENES = [
  { name: 'the example', document: car },
  { name: 'an empty page' },
  { name: 'a drawing of other programs', document: { name: 'others.svg', bytes: Buffer.from(OTHERS) } },
  { name: 'in Korean', document: car, options: { locale: 'ko-KR', colorScheme: 'dark', deviceScaleFactor: 2 } },
  { name: 'without the second part', document: car, missing: true },
];

execFileSync('wasm-split', ['--instrument', `${MODULE}.whole`, '--profile-export=profile', '--enable-simd', '--enable-bulk-memory',
  '-o', WATCHED]);
const all = functions();
const first = new Set();
const browser = await launch();
try {
  for (const { name, document, options, missing } of SCENES) {
    const server = await serve(document);
    server.spoil = (file, body) => (file === 'batten.wasm' ? fs.readFileSync(WATCHED) : body);
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    await context.route('**/batten-later.wasm', (route) => (missing ? route.fulfill({ status: 404 }) : null)); // else never answered
    const page = await context.newPage();
    await page.goto(server.address);
    await ready(page);
    const hand = new Hand(page, await context.newCDPSession(page));
    await (missing ? onlyLook : look)(page, hand);
    const before = first.size;
    (await called(page)).forEach((i) => first.add(i));
    console.log(`${name}: ${first.size - before} functions more`);
    await context.close();
    server.close();
  }
} finally {
  await browser.close();
  fs.rmSync(WATCHED);
}

/** @type {Map<string, string[]>} */
const rows = new Map();
for (const [file, name] of [...first].map((i) => all[i]).filter(([file]) => !/^(module\/|<)|crt1/.test(file))) { // those stay anyway
  rows.set(file, [...rows.get(file) ?? [], name]);
}
const lines = [...rows].sort(([a], [b]) => (a < b ? -1 : 1)).map(([file, names]) => `${file} ${names.sort().join(' ')}\n`);
fs.writeFileSync(LIST, HEAD + lines.join(''));
console.log(`${first.size} of ${all.length} functions: ${path.relative(process.cwd(), LIST)}`);
