// label: all (fifteen states at six sizes). What floats over the drawing (chips, the row of a selection, notices, hints, strips, the
// dial) lies in the stage, not one over another, and not over what is edited where there is room beside it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { bezier, launch, open, place, quiet, SCREENSHOTS, settle } from './page.mjs';
import { EXAMPLE, serve } from './server.mjs';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
});
after(() => {
  server.close();
  return browser.close();
});

const SIZES = { mouse: [[1920, 1080], [1280, 800], [1024, 768]], finger: [[820, 1180], [390, 844], [360, 640]] };
const ROOF = bezier([440, 135], [490, 88], [580, 80], [690, 115]);

/** Pairs that overlap, and what is beyond the stage. */
const faults = (page) => page.evaluate(() => {
  const boxOf = (element) => element.getBoundingClientRect();
  const nameOf = (element) => (element.id ? `#${element.id}` : `.${element.classList[0]}`);
  const over = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
  const stage = boxOf(document.getElementById('stage'));
  const main = boxOf(document.querySelector('main'));
  const floating = [...document.querySelectorAll('.chips, .actions, .notice, .first, .dial, .levels, .time, .lens')]
    .filter((one) => one.checkVisibility() && boxOf(one).width > 0).map((one) => [nameOf(one), boxOf(one)]);
  const found = floating.flatMap(([name, a], i) => floating.slice(i + 1).filter(([, b]) => over(a, b)).map(([other]) => `${name} over ${other}`));
  for (const [name, { left, top, right, bottom }] of floating) {
    if (left < main.left - 1 || right > main.right + 1 || top < main.top - 1 || bottom > main.bottom + 1) {
      found.push(`${name} beyond the drawing: ${[left, top, right, bottom].map(Math.round)}`);
    }
  }
  // What is edited: what is selected, or what chips are about.
  const { engine } = batten;
  const { around, at } = engine.readings();
  const about = around ?? (at && [at[0] - 8, at[1] - 8, at[0] + 8, at[1] + 8]);
  const edited = about && { left: stage.left + about[0], top: stage.top + about[1], right: stage.left + about[2], bottom: stage.top + about[3] };
  if (edited && edited.bottom - edited.top < stage.height / 3) {
    found.push(...floating.filter(([name, box]) => ['.chips', '.actions'].includes(name) && over(box, edited)).map(([name]) => `${name} over what is edited`));
  }
  return found;
});

const run = (...names) => (page) => page.evaluate((all) => {
  all.forEach((name) => batten.engine.command(name));
  batten.wake();
}, names);
const curve = async (page, hand) => hand.stroke([await place(page, 592, 103.5)]);

/** How each state is reached from the one before. @type {[string, (page: any, hand: any) => Promise<unknown>][]} */
const STATES = [
  ['rest', async () => {}],
  ['stroke', async (page, hand) => hand.stroke(await Promise.all(ROOF.map(([x, y]) => place(page, x, y))))],
  ['undone', run('undo')],
  ['selected', async (page, hand) => {
    await run('tool-select')(page);
    await curve(page, hand);
  }],
  ['said', (page) => page.evaluate(() => batten.notices.say('The curve was redrawn.'))],
  ['offset', run('curve-offset')],
  ['simplified', run('cancel', 'curve-simplify')],
  ['array', run('cancel', 'array')],
  ['points', run('cancel', 'tool-points')],
  ['width', run('tool-width')],
  ['levels', async (page, hand) => {
    await run('tool-levels')(page);
    await curve(page, hand);
    await run('take-apart')(page);
  }],
  ['asked', (page) => page.evaluate(() => {
    batten.notices.ask('kept', 'Unsaved work on car.svg was brought back.', [{ label: 'Open it as saved', run() {} }]);
    batten.notices.say('Undo: Sketch a curve');
  })],
  ['all', async (page) => {
    await run('cancel', 'tool-select', 'select-all')(page);
    await page.evaluate(() => document.querySelector('[data-about=kept]')?.remove());
  }],
  ['tilted', run('deselect', 'orbit-up', 'orbit-up')],
  ['camera', run('camera-new')],
];

/** What is seen in a state, or it would be another. @type {Record<string, string>} */
const SHOWS = { stroke: '.chips', selected: '.actions', said: '#notice', offset: '.chips', simplified: '.chips', array: '.chips',
  levels: '.levels', asked: '.asked .notice', all: '.actions', camera: '.time' };

for (const [by, sizes] of Object.entries(SIZES)) {
  test(`nothing lies over another, ${by}`, async () => {
    const { page, hand, context } = await open(browser, server.address, { viewport: { width: sizes[0][0], height: sizes[0][1] },
      hasTouch: by === 'finger', isMobile: by === 'finger' });
    await page.keyboard.press('Shift'); // a sign of a user
    await page.waitForSelector('.dial');
    const wrong = [];
    for (const [state, reach] of STATES) {
      await page.setViewportSize({ width: sizes[0][0], height: sizes[0][1] });
      await settle(page);
      hand.rest(2);
      await reach(page, hand);
      await quiet(page);
      await page.waitForSelector(`${SHOWS[state] ?? '.dial'}:not([hidden])`);
      for (const [width, height] of sizes) {
        await page.setViewportSize({ width, height });
        await settle(page);
        await settle(page);
        const found = await faults(page);
        wrong.push(...found.map((fault) => `${state} at ${width} x ${height}: ${fault}`));
        if (found.length > 0 || process.env.PICTURES) {
          await page.screenshot({ path: path.join(SCREENSHOTS, `sweep-${state}-${width}.png`) });
        }
      }
    }
    assert.deepEqual(wrong, []);
    await context.close();
  });
}
