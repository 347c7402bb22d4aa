// Contrast measured over the colour tokens, focus, forced colours, reduced motion, and axe-core over the states reached
// by keyboard.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, quiet, SCREENSHOTS, settle, violations } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(async () => {
  await browser.close();
  server.close();
});

/** All colour tokens as computed by the browser: red, green, blue 0..255, alpha 0..1. */
function tokens(page) {
  return page.evaluate(() => {
    const names = [];
    for (const sheet of document.styleSheets) {
      for (const rule of sheet.cssRules) {
        if (rule.selectorText === ':root') {
          names.push(...[...rule.style].filter((name) => /light-dark/.test(rule.style.getPropertyValue(name))));
        }
      }
    }
    const probe = document.body.appendChild(document.createElement('i'));
    const canvas = document.createElement('canvas').getContext('2d');
    const found = {};
    for (const name of names) {
      probe.style.color = '';
      probe.style.color = `var(${name})`;
      canvas.clearRect(0, 0, 1, 1);
      const [r, g, b, a = 1] = getComputedStyle(probe).color.match(/[\d.]+/g).map(Number);
      found[name.slice(2)] = [r, g, b, a];
    }
    probe.remove();
    return found;
  });
}

const linear = (value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
/** The WCAG 2.2 contrast of a colour over a ground. */
function contrast(colour, ground) {
  const over = colour.slice(0, 3).map((value, i) => value * colour[3] + ground[i] * (1 - colour[3]));
  const [low, high] = [luminance(over), luminance(ground)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}

/** Text on its background: 4.5 : 1. */
const WORDS = [
  ['words', ['surface', 'ground', 'hover', 'accent-soft']],
  ['words-soft', ['surface', 'ground', 'hover']],
  ['accent', ['surface', 'accent-soft', 'hover']],
  ['on-accent', ['accent']],
  ['role-value', ['role-page-fill', 'ground']],
  ['role-ruler', ['role-ruler-fill']],
];
/** Parts that must be visible to be usable: 3 : 1 (WCAG 1.4.11). */
const SHAPES = [
  ['field', ['surface']],
  ...['object', 'highlight', 'ink', 'fit', 'knot', 'knot-fill', 'pending', 'selection', 'handle', 'marquee', 'point',
    'chosen-fill', 'prompt', 'arrow', 'arrow-fill', 'guide', 'polygon', 'comb', 'comb-fill', 'reach', 'erased', 'guideline', 'pivot',
    'axis-x', 'axis-y', 'axis-z']
    .map((role) => [`role-${role}`, ['role-page-fill', 'ground']]),
];
/** Secondary parts: the line being replaced, areas, the prediction ahead of the pen. */
const BESIDE = /^role-(stretch|transition|predicted|ghost|wedge|beyond|page|grid|grid-strong|chosen$|.*-fill$)|^(shadow|edge|ground|pasteboard|surface|hover|accent-soft)$/;

test('contrast of every token, in both themes', async () => {
  const { page, context } = await open(browser, server.address);
  await inThemes(page, async (colorScheme) => {
    const all = await tokens(page);
    assert.ok(Object.keys(all).length > 30);
    const faint = [];
    const measured = new Set();
    for (const [pairs, least] of [[WORDS, 4.5], [SHAPES, 3]]) {
      for (const [name, grounds] of pairs) {
        measured.add(name);
        for (const ground of grounds) {
          const value = contrast(all[name], all[ground]);
          if (!(value >= least)) {
            faint.push(`${name} on ${ground}: ${value.toFixed(2)}`);
          }
        }
      }
    }
    assert.deepEqual(faint, [], colorScheme);
    const unknown = Object.keys(all).filter((name) => !measured.has(name) && !BESIDE.test(name));
    assert.deepEqual(unknown, [], 'a token that nobody has measured');
  });
  await context.close();
});

test('contrast is computed as WCAG says', () => {
  assert.ok(Math.abs(contrast([0, 0, 0, 1], [255, 255, 255, 1]) - 21) < 1e-9);
  assert.ok(Math.abs(contrast([118, 118, 118, 1], [255, 255, 255, 1]) - 4.54) < 0.01);
  assert.ok(Math.abs(contrast([0, 0, 0, 0], [255, 255, 255, 1]) - 1) < 1e-9);
});

const STATES = [
  ['the list', ['F6', 'F6', 'F6', 'F6', 'End', 'ArrowRight']],
  ['a range', ['F6', 'F6', 'F6', 'Shift+T']],
  ['waypoints', ['F6', 'F6', 'F6', 'Shift+T', 'Enter']],
  ['points', ['F6', 'F6', 'F6', 'a', 'Tab']],
  ['the selection', ['F6', 'F6', 'F6', 'v', 'Tab']],
];
/** How a state is looked at, by language: by all rules first, then by those that hang on colours. @type {Record<string, Record<string, object>>} */
const LOOKS = {
  en: { light: { colorScheme: 'light', forcedColors: 'none' }, dark: { colorScheme: 'dark', forcedColors: 'none' },
    'light-forced': { colorScheme: 'light', forcedColors: 'active' } },
  'ko-KR': { 'dark-ko-KR': { colorScheme: 'dark' } },
};
for (const [locale, looks] of Object.entries(LOOKS)) {
  test(`axe-core finds nothing, state by state: ${Object.keys(looks).join(', ')}`, async () => {
    const { page, context } = await open(browser, server.address, { locale, ...Object.values(looks)[0] });
    const look = async (state, pictures = false) => {
      for (const [i, [name, media]] of Object.entries(looks).entries()) {
        await page.emulateMedia(media);
        await quiet(page);
        assert.deepEqual(await violations(page, i ? 'colours' : 'all'), [], `${state}, ${name}`);
        if (pictures) {
          await page.screenshot({ path: path.join(SCREENSHOTS, `access-${name}-${state.replace(/\W/g, '')}.png`) });
        }
      }
    };
    await page.keyboard.press('Shift'); // a sign of a user
    await page.waitForSelector('#mirror', { state: 'attached' });
    for (const [state, keys] of STATES) {
      for (const key of keys) {
        await page.keyboard.press(key);
        await settle(page);
      }
      await look(state, true);
      for (let i = 0; i < 4; i++) {
        await page.keyboard.press('Escape');
      }
      await page.evaluate(() => document.activeElement.blur());
    }
    assert.ok(await page.locator('#style-body input').first().isVisible(), 'the inspector is among what was looked at');
    for (const sheet of ['settings', 'menu']) {
      await page.focus(`[data-name=${sheet}]`);
      await page.keyboard.press('Enter');
      await page.waitForSelector(`#${sheet}`);
      await look(sheet);
      await page.keyboard.press('Escape');
    }
    await page.evaluate(async () => {
      const file = (name) => new File(['x,y\n10,10\n60,110\n120,40\n'], name);
      batten.engine.pasteFile(new Uint8Array(await file('a.csv').arrayBuffer()), 'a.csv');
      batten.wake();
      await new Promise((done) => { setTimeout(done, 100); });
      void batten.files.arrive([{ file: file('b.csv'), place: null }]);
    });
    await page.waitForSelector('#holds[open]');
    await look('question');
    await context.close();
  });
}

test('forced colours: what is drawn wears the system\'s, and the focus shows', async () => {
  const { page, context } = await open(browser, server.address, { forcedColors: 'active', colorScheme: 'dark' });
  const roles = await page.evaluate(() => batten.theme.roles.map(({ stroke }) => stroke));
  const system = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement('i'));
    return ['Canvas', 'CanvasText', 'Highlight', 'GrayText', 'LinkText', 'ActiveText'].map((name) => {
      probe.style.color = name;
      return getComputedStyle(probe).color;
    });
  });
  const own = roles.filter((colour, i) => i > 0 && !system.includes(colour) && !/, 0\)$/.test(colour));
  assert.deepEqual(own, []);
  await page.waitForFunction(() => [...document.querySelectorAll('#style .swatch')].filter((one) => one.checkVisibility()).length > 2);
  const swatches = await page.locator('#style .swatch:visible').all();
  const pictures = await Promise.all(swatches.map(async (one) => (await one.screenshot()).toString('base64')));
  assert.ok(pictures.length > 2 && new Set(pictures).size === pictures.length, 'colours of the drawing differ');
  await page.keyboard.press('Tab'); // the keyboard is in use
  for (const target of ['#stage', '[data-name=menu]', '#mirror [tabindex="0"]']) {
    await page.focus(target);
    const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
    assert.notEqual(outline, 'none', target);
  }
  await context.close();
});

test('reduced motion: nothing moves by itself', async () => {
  const { page, context } = await open(browser, server.address, { reducedMotion: 'reduce' });
  const moving = () => page.evaluate(() => [...document.querySelectorAll('*')].filter((element) => {
    const { transitionDuration, animationName, scrollBehavior } = getComputedStyle(element);
    return animationName !== 'none' || scrollBehavior === 'smooth' || parseFloat(transitionDuration) > 0;
  }).map((element) => element.outerHTML).concat(document.getAnimations().map(String)));
  assert.deepEqual(await moving(), []);
  await page.click('[data-name=menu]');
  assert.deepEqual(await moving(), []);
  // The view jumps: after one frame it is in its final place.
  await page.keyboard.press('Escape');
  await page.focus('#stage');
  await page.keyboard.press('+');
  await settle(page);
  const zoom = await page.evaluate(() => batten.painter.painted.zoom);
  await quiet(page);
  assert.equal(await page.evaluate(() => batten.painter.painted.zoom), zoom);
  await context.close();
});
