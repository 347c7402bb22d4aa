// A browser, a page with the editor in it, and simulated pens, mice and fingers, all through the browser's own input
// pipeline, so that events are trusted, coalesced and captured like a user's.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { afterEach, beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { BROWSER, HANG } from './chromium.mjs';

export { HANG };
/** Milliseconds in which the second part of the module comes, or is missing. */
const COMES = 20000;

const HERE = path.dirname(fileURLToPath(import.meta.url));
export const SCREENSHOTS = path.resolve(HERE, '../../build/screenshots');
const AXE = fs.readFileSync(path.join(HERE, 'node_modules/axe-core/axe.min.js'), 'utf8');

/**
 * Console errors of any page, including uncaught ones and policy violations: each fails the test in which it occurs.
 */
let faults = [];
/** Those that the test declared. @type {RegExp[]} */
let expected = [];
/** What a test has opened, closed before the next: a page that lives on could err in it. @type {import('playwright-core').BrowserContext[]} */
let contexts = [];

/** Declares errors that this test is about. @param {...RegExp} patterns */
export function expectFaults(...patterns) {
  expected.push(...patterns);
}

/** What a page says whose server has gone: parts that it had not fetched yet are missing too. */
export const GONE = [/ERR_CONNECTION_(REFUSED|RESET)/, /Failed to fetch/, /^Missing: /];

beforeEach(async () => {
  await Promise.all(contexts.map((context) => context.close()));
  faults = [];
  expected = [];
  contexts = [];
});
afterEach(() => {
  assert.deepEqual(faults.filter((fault) => !expected.some((pattern) => pattern.test(fault))), [], 'errors on the console');
});

/**
 * Runs in every page. Short timers and frames are counted, so that quiet() can wait until none is left and no test
 * needs a fixed delay. Long timers (a notice that disappears by itself, another tab that does not answer) are
 * lengthened, because a busy machine needs the time. `hasty` is for testing such a timer; `holdTimers` for testing what
 * happens before timers fire. A contact that a test leaves down counts as resting only when the test says so (`rests`),
 * however long it takes.
 * @param {number} hang milliseconds after which a page that is never quiet says what it still waits for
 */
function countTimers(hang) {
  const { setTimeout: later, setInterval: ever, clearTimeout: never, requestAnimationFrame: soon } = globalThis;
  globalThis.setInterval = (what, delay) => ever(() => globalThis.rests && what(), delay);
  const [waiting, held] = [new Map(), new Map()];
  globalThis.setTimeout = (what, delay = 0, ...values) => {
    const long = delay >= 2000;
    const run = () => {
      waiting.delete(id);
      held.delete(id);
      what(...values);
    };
    const id = later(() => (globalThis.timersHeld ? held.set(id, run) : run()), long && !globalThis.hasty ? 60 * delay : delay);
    if (!long) {
      waiting.set(id, what);
    }
    return id;
  };
  globalThis.clearTimeout = (id) => {
    waiting.delete(id);
    held.delete(id);
    never(id);
  };
  globalThis.requestAnimationFrame = (what) => {
    const id = soon((time) => {
      waiting.delete(`frame ${id}`);
      what(time);
    });
    waiting.set(`frame ${id}`, what);
    return id;
  };
  globalThis.holdTimers = (on) => {
    globalThis.timersHeld = on;
    [...(on ? [] : held.values())].forEach((run) => run());
  };
  const moving = (animation) => animation.playState === 'running' && animation.effect.getComputedTiming().endTime < Infinity;
  const isQuiet = () => waiting.size === 0 && !document.getAnimations().some(moving);
  // What the engine shows now. engine.frame() tells each change once: what a test takes, the page would never paint.
  globalThis.glance = () => {
    const { engine, painter } = globalThis.batten;
    engine.stillVersion = -1;
    const frame = engine.frame();
    engine.stillVersion = -1;
    painter.retheme();
    return frame;
  };
  const awaited = () => [...waiting].map(([id, what]) => `${id}: ${what}`)
    .concat(document.getAnimations().filter(moving).map(({ effect }) => `animation of ${effect.target?.outerHTML.slice(0, 99)}`));
  globalThis.quiet = () => new Promise((done, fail) => {
    const from = Date.now();
    const look = () => (isQuiet() ? done() : Date.now() - from > hang ? fail(new Error(`never quiet: ${awaited().join('; ')}`)) : later(look, 5));
    look();
  });
}

/** Runs in every page: a button that comes has its name with it, not a frame later. */
function watchNames() {
  const isNameless = (button) => !button.ariaLabel && !button.getAttribute('aria-labelledby') && !button.title &&
    !button.textContent.trim() && button.checkVisibility();
  new MutationObserver((changes) => {
    for (const button of changes.flatMap(({ addedNodes }) => [...addedNodes]).filter((node) => node instanceof Element)
      .flatMap((node) => [node, ...node.querySelectorAll('*')]).filter((node) => node.matches('button') && isNameless(node))) {
      console.error(`a button without a name: ${button.outerHTML}`);
    }
  }).observe(document, { childList: true, subtree: true });
}

/**
 * Runs in pages whose pictures are not compared: edges in space are not smoothed, which without a graphics card is half of the
 * processor's time of a session in space.
 */
function drawPlainly() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, kind === 'webgl2' ? { ...options, antialias: false } : options);
  };
}

/** Runs in every page: changes kept files as soon as the page that was closed before has let go of them. */
function waitForFiles() {
  globalThis.freed = (change) => change().catch(async (error) => {
    if (error.name !== 'NoModificationAllowedError') {
      throw error;
    }
    await new Promise((done) => setTimeout(done, 50));
    return globalThis.freed(change);
  });
}

/** @param {import('playwright-core').BrowserContext} context @param {boolean} smooth */
async function watch(context, smooth = false) {
  contexts.push(context);
  context.setDefaultTimeout(HANG);
  await context.addInitScript(countTimers, HANG);
  await context.addInitScript(waitForFiles);
  // Pages are those of one who has been here; start.test.mjs and lost.test.mjs look at the first.
  await context.addInitScript((names) => {
    try {
      names.forEach((name) => (localStorage[name] ??= 'seen'));
    } catch {
      // It is not a page that the browser keeps anything of.
    }
  }, ['batten-hands', 'batten-told-lasting']);
  context.on('weberror', (error) => faults.push(`uncaught: ${error.error().stack}`));
  context.on('console', (message) => {
    if (message.type() === 'error') {
      faults.push(`${message.text()} ${message.location().url}`);
    }
  });
  if (!smooth) {
    await context.addInitScript(drawPlainly);
  }
  await context.addInitScript(watchNames);
  await context.addInitScript(() => document.addEventListener('securitypolicyviolation', (event) =>
    console.error(`refused by ${event.violatedDirective}: ${event.blockedURI} ${event.sample}`)));
  return context;
}

/** The browser that other test files use, too, where one is running (browser.mjs). */
async function shared() {
  try {
    return await chromium.connect(fs.readFileSync(process.env.BATTEN_BROWSER ?? '', 'utf8'));
  } catch {
    return null;
  }
}

/** @param {{ smooth?: boolean }} [options] smooth: edges in space as users see them */
export async function launch({ smooth = false } = {}) {
  fs.mkdirSync(SCREENSHOTS, { recursive: true });
  const browser = await shared() ?? await chromium.launch(BROWSER);
  const make = browser.newContext.bind(browser);
  browser.newContext = async (options) => watch(await make(options), smooth);
  return browser;
}

/** A browser with persistent storage in a folder. @param {string} profile @param {object} more how it is started */
export async function launchAt(profile, more = {}) {
  return watch(await chromium.launchPersistentContext(profile, { ...BROWSER, viewport: { width: 1280, height: 800 }, ...more }));
}

/**
 * A page with the editor, ready.
 * @param {import('playwright-core').Browser | import('playwright-core').BrowserContext} browser
 * @param {string} address
 * @param {import('playwright-core').BrowserContextOptions} [options]
 */
export async function open(browser, address, options = {}) {
  // Wide enough for the inspector and a drawing of 1,239 x 720.
  const context = await browser.newContext?.({ viewport: { width: 1544, height: 800 }, acceptDownloads: true, ...options }) ?? browser;
  const page = await context.newPage();
  await page.goto(address);
  await ready(page);
  await faceOn(page);
  const client = await context.newCDPSession(page);
  return { context, page, client, hand: new Hand(page, client) };
}

/** Opens a section of the inspector, or a sheet, and waits until it is filled. @param {string} name */
export async function reveal(page, name) {
  if (!['numbers', 'style', 'objects', 'layers'].includes(name)) {
    if (await page.isVisible(`[data-name=${name}]`)) {
      await page.click(`[data-name=${name}]`);
    } else { // on a phone they are in the menu of the logo
      await page.click('#logo');
      await page.click(`#main-menu :is([data-act=${name}], [data-command=${name === 'menu' ? 'shortcuts' : name}])`);
    }
    return;
  }
  if (await page.locator('#inspector').isHidden()) {
    await page.click('[data-name=inspector]');
  }
  await page.waitForSelector(`#${name} .part-head`);
  if (await page.locator(`#${name}-body`).isHidden()) {
    await page.click(`[data-name=${name}]`);
  }
  await settle(page);
}

/** Opens the settings where a control of them is. @param {string} name of the control */
export async function setting(page, name) {
  if (!await page.isVisible('#settings')) {
    await reveal(page, 'settings');
  }
  const field = page.locator(`#setting-${name}`);
  await field.waitFor({ state: 'attached' });
  if (await field.isHidden()) {
    await page.click(`[aria-controls=${await field.evaluate((one) => one.closest('[role=tabpanel]').id)}]`);
  }
  await settle(page);
}

/** The bytes of a file that the page hands to the browser. @param {import('playwright-core').Download} download */
export async function downloaded(download) {
  const parts = [];
  for await (const part of await download.createReadStream()) {
    parts.push(part);
  }
  return Buffer.concat(parts);
}

export async function ready(page) {
  await page.waitForSelector('html[data-ready=yes]');
  await settle(page);
}

/** The table of texts, once those are there that come with the module's second part. */
export async function texts(page) {
  await page.waitForFunction(() => Object.values(batten.panel.tables.strings).every(Boolean));
  return page.evaluate(() => batten.panel.tables.strings);
}

/** A drawing in space opens from three quarters: back to the page, as tests begin; space.test.mjs looks at how it opens. */
export async function faceOn(page) {
  // Asking for the view calls the second part of the module, which without it ends the engine.
  await page.waitForFunction(() => !globalThis.batten?.engine || batten.engine.partial || batten.engine.module.second, null, { timeout: COMES }).catch(() => {});
  if (await page.evaluate(() => globalThis.batten?.engine.module.second && batten.engine.number('view') !== '')) {
    await page.waitForFunction(() => batten.dial?.opening.drawing === batten.engine.drawing);
    await page.evaluate(() => {
      batten.engine.command('view-upright');
      batten.engine.glide(1);
      batten.wake();
    });
    await settle(page);
  }
}

/** Waits until a promise made in the page gives true: waitForFunction takes the promise itself for true. */
export async function until(page, holds, value) {
  for (const from = Date.now(); !await page.evaluate(holds, value); await new Promise((done) => setTimeout(done, 20))) {
    assert.ok(Date.now() - from < HANG, `never: ${holds}`);
  }
}

/** Waits for two frames: input so far has been painted. */
export function settle(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

/**
 * Does something in the light theme, the page's own, and in the dark one: what is seen of a state, which itself is reached once.
 * @param {(colorScheme: 'light' | 'dark') => Promise<unknown>} work
 */
export async function inThemes(page, work) {
  for (const colorScheme of /** @type {const} */ (['dark', 'light'])) {
    await page.emulateMedia({ colorScheme });
    await settle(page);
    await work(colorScheme);
  }
}

/** Pictures of the page in both themes: NAME-light.png and NAME-dark.png. @param {string} name */
export const pictures = (page, name) => inThemes(page, (colorScheme) =>
  page.screenshot({ path: path.join(SCREENSHOTS, `${name}-${colorScheme}.png`) }));

/** Rules of axe-core whose answers hang on colours. */
const COLOURS = ['color-contrast', 'link-in-text-block'];

/** Of a state that is looked at in both themes: by all rules in one of them. @param {'light' | 'dark'} colorScheme */
export const rulesIn = (colorScheme) => (colorScheme === 'light' ? 'all' : 'colours');

/**
 * What axe-core finds wrong with the page, in words.
 * @param {'all' | 'colours'} rules `colours`: a state that all rules have looked at, in another theme
 * @returns {Promise<string[]>}
 */
export async function violations(page, rules = 'all') {
  if (!await page.evaluate(() => 'axe' in globalThis)) {
    await page.evaluate(AXE); // the page's policy blocks foreign scripts, but not the debugger's
  }
  return page.evaluate(async (only) => {
    // Style sheets are preloaded for rules that are off; what names the places is not shown.
    const options = { resultTypes: ['violations'], preload: { assets: ['media'] }, selectors: false, ...only && { runOnly: only } };
    const { violations: found } = await globalThis.axe.run(document, options);
    return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`);
  }, rules === 'all' ? null : COLOURS);
}

/** Waits until the page has nothing left to do: no frame, short timer or transition. */
export function quiet(page) {
  return page.evaluate(() => globalThis.quiet());
}

/** The engine's current state, without requesting another frame from it. */
export function state(page) {
  return page.evaluate(() => ({
    digest: batten.engine.digest(),
    check: batten.engine.partial ? '' : batten.engine.check(), // the check is in the second part
    hint: document.getElementById('hint').textContent,
    notice: [...document.querySelectorAll('#notice-text, #asked span')].map((said) => said.textContent).filter(Boolean).join('\n'),
    unsaved: !document.getElementById('unsaved').hidden,
    zoom: batten.painter.painted.zoom,
    angle: batten.painter.painted.angle,
    counts: { ...batten.painter.counts },
  }));
}

/** A hint as it is said to a pen, or to a mouse. @param {string} text of the table of strings */
export const hintFor = (text, device = 'pen') => text.replace(/\{([^|}]*)\|([^}]*)\}/g, device === 'mouse' ? '$2' : '$1');

/** The window position of a point of the document. */
export function place(page, x, y) {
  return page.evaluate(([px, py]) => {
    const { x: left, y: top, zoom, angle } = batten.painter.painted;
    const box = document.getElementById('stage').getBoundingClientRect();
    const cosine = Math.cos((angle * Math.PI) / 180) * zoom;
    const sine = Math.sin((angle * Math.PI) / 180) * zoom;
    return [box.left + (px - left) * cosine - (py - top) * sine, box.top + (px - left) * sine + (py - top) * cosine];
  }, [x, y]);
}

/** Notes in `late` how long each frame comes after the oldest move of a contact that is not seen yet, ms. */
export function timePaint(page) {
  return page.evaluate(() => {
    globalThis.late = [];
    globalThis.since = 0;
    addEventListener('pointermove', ({ timeStamp, buttons }) => {
      if (globalThis.since || !buttons) {
        return;
      }
      globalThis.since = timeStamp;
      requestAnimationFrame(() => { // what it posts comes when the frame has been painted
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => {
          globalThis.late.push(performance.now() - globalThis.since);
          globalThis.since = 0;
        };
        port2.postMessage(0);
      });
    }, true);
  });
}

/** The number of pixels of a canvas that are not transparent. */
export function inked(page, id) {
  return page.evaluate((name) => {
    const canvas = document.getElementById(name);
    const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 3; i < data.length; i += 4) {
      count += data[i] > 0 ? 1 : 0;
    }
    return count;
  }, id);
}

export class Hand {
  constructor(page, client) {
    this.page = page;
    this.client = client;
    this.time = Date.now() / 1000;
  }

  #mouse(type, [x, y], more) {
    this.time += 0.004;
    return this.client.send('Input.dispatchMouseEvent', { type, x, y, timestamp: this.time, ...more });
  }

  /** Brings the pen near, not touching. */
  async hover(point, pointerType = 'pen') {
    await this.#mouse('mouseMoved', point, { pointerType, button: 'none', buttons: 0 });
    await settle(this.page);
  }

  /**
   * A stroke through window positions, samples `step` pixels apart, 4 ms each. Sent without waiting for each other,
   * as by a tablet. `lift`: false leaves the pen down. `during` runs while it is still down; `end`: its position then.
   */
  async stroke(points, { pointerType = 'pen', lift = true, modifiers = 0, step = 3, during = null, end = points.at(-1),
    button = 'left' } = {}) {
    const dense = densify(points, step);
    const buttons = button === 'left' ? 1 : 2;
    const pen = (force) => ({ pointerType, button, buttons, force, tiltX: 20, tiltY: 10, modifiers });
    const sent = [];
    await this.#mouse('mouseMoved', dense[0], { pointerType, button: 'none', buttons: 0, modifiers });
    sent.push(this.#mouse('mousePressed', dense[0], { ...pen(0.3), clickCount: 1 }));
    dense.slice(1).forEach((point, i) => sent.push(this.#mouse('mouseMoved', point, pen(0.3 + (0.4 * i) / dense.length))));
    const still = [...dense, end].every(([x, y]) => x === dense[0][0] && y === dense[0][1]);
    if (!lift || during || !still) { // a tap ends at once: on a machine under load it would become a long press
      await Promise.all(sent);
      await settle(this.page);
    }
    if (during) {
      await during();
    }
    if (lift) {
      await Promise.all([...sent, this.lift(end, { ...pen(0), buttons: 0 })]);
    }
    return dense;
  }

  /** Lifts the pen that is down. */
  async lift(point, more = { pointerType: 'pen', button: 'left' }) {
    await this.#mouse('mouseReleased', point, { ...more, clickCount: 1 });
    await settle(this.page);
  }

  /** Continues a stroke from where the pen is down. */
  async drag(from, to, pointerType = 'pen') {
    const pen = { pointerType, button: 'left', buttons: 1, force: 0.5 };
    await Promise.all(densify([from, to], 3).map((point) => this.#mouse('mouseMoved', point, pen)));
    await settle(this.page);
  }

  /** Advances the engine's time, which it takes from events. */
  rest(seconds) {
    this.time += seconds;
  }

  /** Fingers: an array of frames 8 ms apart, each an array of positions; they lift at the end, unless `lift` is false.
   * Sent without waiting for each other: a page under load would take them for fingers that rest. `radius` in pixels: of a finger's contact, or a palm's. `down`: how many are down already. */
  async fingers(frames, { lift = true, radius = 6, down = 0 } = {}) {
    let before = down;
    const sent = [];
    for (const frame of frames) {
      const touchPoints = frame.map(([x, y], id) => ({ x, y, id, force: 0.5, radiusX: radius, radiusY: radius }));
      sent.push(this.#touch(before < frame.length ? 'touchStart' : 'touchMove', touchPoints));
      before = frame.length;
    }
    if (lift) {
      sent.push(this.#touch('touchEnd', []));
    }
    await Promise.all(sent);
    await settle(this.page);
  }

  #touch(type, touchPoints) {
    this.time += 0.008;
    return this.client.send('Input.dispatchTouchEvent', { type, touchPoints, timestamp: this.time });
  }

  /** A tap of several fingers side by side, long after any earlier input. */
  async tap(fingers, [x, y] = [400, 400], options = {}) {
    this.time += 2;
    const at = Array.from({ length: fingers }, (_, i) => [x + 70 * i, y + 9 * i]);
    await this.fingers([at.slice(0, 1), at, at.map(([a, b]) => [a + 1, b + 2])], options);
  }
}

/** The polyline with points at most `step` apart. */
export function densify(points, step) {
  const dense = [points[0]];
  for (let i = 1; i < points.length; i++) {
    const [x0, y0] = points[i - 1];
    const [x1, y1] = points[i];
    const count = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / step));
    for (let k = 1; k <= count; k++) {
      dense.push([x0 + ((x1 - x0) * k) / count, y0 + ((y1 - y0) * k) / count]);
    }
  }
  return dense;
}

/** Points of a cubic Bézier. */
export function bezier(p0, p1, p2, p3, count = 40) {
  return Array.from({ length: count + 1 }, (_, i) => {
    const t = i / count;
    const s = 1 - t;
    return [0, 1].map((k) => s * s * s * p0[k] + 3 * s * s * t * p1[k] + 3 * s * t * t * p2[k] + t * t * t * p3[k]);
  });
}

/** The camera move that the time strip shows. */
export const move = (page) => page.evaluate(() => {
  const { engine } = globalThis.batten;
  return JSON.parse(engine.string(engine.wasm.editor_move(engine.editor)));
});

/** Colours of the still canvas at places of the drawing: red, green, blue, opacity. */
export async function stillColours(page, points) {
  const places = await Promise.all(points.map(([x, y]) => place(page, x, y)));
  return page.evaluate((all) => all.map(([x, y]) => {
    const still = document.getElementById('still');
    const box = still.getBoundingClientRect();
    const ratio = still.width / box.width;
    return [...still.getContext('2d').getImageData((x - box.left) * ratio, (y - box.top) * ratio, 1, 1).data];
  }), places);
}

/** Drops a file, and waits until it is opened or refused, or a question appears. */
export async function drop(page, name, text) {
  await page.evaluate(([title, content]) => new Promise((done) => {
    const { files } = batten;
    const read = files.read;
    files.read = async (...words) => {
      delete files.read;
      const found = await read.apply(files, words);
      if (!found) {
        done();
      }
      return found;
    };
    files.take = (...words) => {
      delete files.take;
      const opened = files.take(...words);
      done();
      return opened;
    };
    const asking = new MutationObserver(() => document.querySelector('dialog.question:not(#opening)') && done());
    asking.observe(document.body, { childList: true });
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], title));
    for (const type of ['dragover', 'drop']) {
      const event = new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer });
      document.getElementById('stage').dispatchEvent(event);
    }
  }), [name, text]);
  await settle(page);
}

/** What a field shows and screen readers say: its number, and its unit as they find it. */
export const said = (page, field) => page.$eval(field, (input) =>
  `${input.value} ${document.getElementById(input.getAttribute('aria-describedby')).textContent}`);
