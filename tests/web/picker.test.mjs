// The colour picker: its models beside the browser's own, a pen, keys, the eyedropper in light and dark, palettes of GIMP.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { downloaded, drop, inThemes, launch, open, place, quiet, rulesIn, SCREENSHOTS, settle, state, violations } from './page.mjs';
import { serve } from './server.mjs';

const ART = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">
  <path d="M50 50H150V150H50Z" fill="#2040c0"/><path d="M200 100H300V200H200Z" fill="#e07b39" fill-opacity="0.5"/></svg>`;
const GPL = 'GIMP Palette\r\nName: Sea and sand\r\nColumns: 2\r\n# by hand\r\n  0  64 128\tDeep\r\n240 220 130\tSand, dry\r\n255 0 0\r\n';

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await browser.close();
  server.close();
});

const fill = (page) => page.evaluate(() => batten.engine.get('fill-colour') >>> 0);

/** The drawing with its first square selected, and the picker open for its fill. */
async function begin(options) {
  const opened = await open(browser, server.address, options);
  await drop(opened.page, 'art.svg', ART);
  await opened.page.focus('#stage');
  await opened.page.keyboard.press('v');
  await opened.page.mouse.click(...await place(opened.page, 100, 100));
  await opened.page.click('#actions .dot.filled button');
  await opened.page.waitForSelector('#picker-sheet:popover-open');
  await quiet(opened.page);
  return opened;
}

test('numbers: HSV, OKLCH and RGB are the browser\'s', async () => {
  const { page, context } = await open(browser, server.address);
  const worst = await page.evaluate(async () => {
    const base = [...document.querySelectorAll('script')].map(({ src }) => src).find((src) => src.endsWith('/main.js'));
    const { MODELS, rgbOf, colourWith } = await import(new URL('sheets/colour_models.js', base).href);
    const probe = document.body.appendChild(document.createElement('i'));
    const computed = (text) => {
      probe.style.color = text;
      return getComputedStyle(probe).color.match(/-?[\d.]+(e-?\d+)?/g).map(Number);
    };
    const most = { oklch: 0, back: 0, hsv: 0 };
    for (let i = 0; i < 500; i++) {
      const colour = (Math.imul(i, 2654435761) >>> 0) | 255;
      const rgb = rgbOf(colour);
      const hex = `#${(colour >>> 8 & 0xffffff).toString(16).padStart(6, '0')}`;
      const [l, c, h] = MODELS.oklch.from(rgb);
      const theirs = computed(`oklch(from ${hex} l c h)`);
      const turn = Math.abs(((h - theirs[2]) % 360 + 540) % 360 - 180) * Math.PI / 180 * c;
      most.oklch = Math.max(most.oklch, Math.abs(l / 100 - theirs[0]), Math.abs(c - theirs[1]), turn);
      for (const name of Object.keys(MODELS)) {
        const again = MODELS[name].to(MODELS[name].from(rgb));
        most.back = Math.max(most.back, (colourWith(again, 255) >>> 0) === (colour >>> 0) ? 0 : 1);
      }
      const [hue, s, v] = MODELS.hsv.from(rgb); // hwb: white and black of the same hue
      const hwb = computed(`hwb(${hue} ${s === undefined ? 0 : v * (100 - s) / 100}% ${100 - v}%)`);
      most.hsv = Math.max(most.hsv, ...rgb.map((value, k) => Math.abs(value * 255 - hwb[k])));
    }
    // What no screen shows keeps its lightness and hue, and is a colour all the same.
    const far = MODELS.oklch.from(MODELS.oklch.to([60, 0.4, 150]));
    probe.remove();
    return { ...most, far };
  });
  assert.ok(worst.oklch < 1e-4 && worst.hsv <= 0.51, JSON.stringify(worst));
  assert.equal(worst.back, 0);
  assert.ok(Math.abs(worst.far[0] - 60) < 0.1 && Math.abs(worst.far[2] - 150) < 0.5 && worst.far[1] > 0.15, String(worst.far));
  await context.close();
});

test('a colour by the pen, by keys and by numbers, each one step', async () => {
  const { page, hand, context } = await begin();
  const { digest } = await state(page);
  assert.equal(await fill(page), 0x2040c0ff);
  await inThemes(page, async (colorScheme) => {
    assert.deepEqual(await violations(page, rulesIn(colorScheme)), []);
    await page.screenshot({ path: path.join(SCREENSHOTS, `picker-${colorScheme}.png`) });
  });
  const [sheet, rail] = await Promise.all(['#picker-sheet', '#rail'].map((one) => page.locator(one).boundingBox()));
  assert.ok(sheet.x >= rail.x + rail.width, 'it lies over no tool');
  const box = await page.locator('#picker-sheet .plane').boundingBox();
  const across = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  // What is dragged is seen at once, and nothing changes until the pen is lifted.
  const seen = async () => page.evaluate(([x, y]) => {
    const { still, ratio } = batten.painter;
    const box = still.getBoundingClientRect();
    return [...still.getContext('2d').getImageData((x - box.left) * ratio, (y - box.top) * ratio, 1, 1).data].join();
  }, await place(page, 140, 140));
  await page.mouse.move(...across(0.5, 0.5));
  await page.mouse.down();
  await page.mouse.move(...across(1, 0), { steps: 3 });
  await settle(page);
  assert.equal(await seen(), '0,51,255,255');
  assert.equal((await state(page)).digest, digest);
  await page.mouse.move(...across(0, 0));
  await settle(page);
  assert.equal(await seen(), '255,255,255,255');
  await page.mouse.up();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, digest);
  assert.equal(await seen(), '32,64,192,255');
  await page.click('#actions .dot.filled button');
  await page.waitForSelector('#picker-sheet:popover-open');
  await hand.stroke([across(0.5, 0.5), across(0.8, 0.3), across(1, 0)], { pointerType: 'pen' });
  await settle(page);
  assert.equal(await fill(page) >>> 8, 0x0033ff); // the purest of the hue
  await page.locator('#picker-sheet .plane').focus();
  await page.keyboard.press('Shift+ArrowDown');
  assert.equal(await fill(page) >>> 8, 0x002ee6);
  await page.selectOption('#picker-model', 'oklch');
  for (const [i, value] of ['70', '0.1', '200'].entries()) {
    await page.fill(`#picker-number-${i}`, value);
    await page.locator(`#picker-number-${i}`).blur();
  }
  const [light, chroma, hue] = await page.locator('#picker-sheet input[type=number]').evaluateAll((all) => all.map((one) => Number(one.value)));
  assert.ok(Math.abs(light - 70) < 0.5 && Math.abs(chroma - 0.1) < 0.005 && Math.abs(hue - 200) < 2, `${light} ${chroma} ${hue}`);
  await page.fill('#picker-hex', '#c1121f80');
  await page.keyboard.press('Enter');
  assert.equal(await fill(page), 0xc1121f80);
  await page.waitForFunction(() => document.activeElement.id === 'stage');
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press('Control+z');
  }
  await settle(page);
  assert.equal((await state(page)).digest, digest);
  await context.close();
});

test('a colour of the drawing, as the file has it, in light and dark', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, context } = await begin({ colorScheme });
    await page.click('#picker-page');
    await page.waitForSelector('#probe');
    const [x, y] = await place(page, 250, 150);
    await page.mouse.move(x, y);
    await page.screenshot({ path: path.join(SCREENSHOTS, `picker-probe-${colorScheme}.png`) });
    await page.mouse.click(x, y);
    await page.waitForSelector('#picker-sheet:popover-open');
    const taken = await fill(page);
    const over = [0xe0, 0x7b, 0x39].map((value) => (value + 255) / 2); // half of it, on white
    assert.ok(over.every((value, i) => Math.abs(((taken >>> (24 - 8 * i)) & 255) - value) <= 1.5) && (taken & 255) === 255, taken.toString(16));
    // Cancelled, it is as it was.
    await page.click('#picker-page');
    await page.waitForSelector('#probe');
    await page.keyboard.press('Escape');
    await page.waitForSelector('#picker-sheet:popover-open');
    assert.equal(await fill(page), taken);
    await context.close();
  }
});

test('palettes: of the drawing, opened, kept, saved, taken away and back', async () => {
  const { page, context } = await begin();
  const swatches = () => page.locator('#picker-sheet .swatches button').evaluateAll((all) => all.map((one) => one.title));
  assert.deepEqual([...await swatches()].sort(), ['#2040c0', '#e07b3980']);
  // One that is dropped on the page is there, too, beside the drawing that is open.
  await page.keyboard.press('Escape');
  const { digest } = await state(page);
  await page.evaluate((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'dropped.gpl'));
    document.getElementById('stage').dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer }));
  }, 'GIMP Palette\n#\n1 2 3 Ink\n');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('Palette added: dropped'));
  assert.equal((await state(page)).digest, digest);
  await page.click('#actions .dot.filled button');
  await page.waitForSelector('#picker-sheet:popover-open');
  await page.selectOption('#picker-palette', { label: 'dropped' });
  assert.deepEqual(await swatches(), ['Ink']);
  await page.click('#picker-sheet [data-text="shell.palette-remove"]');
  const give = (text, name = 'sea.gpl') => page.setInputFiles('#picker-file', { name, mimeType: '', buffer: Buffer.from(text) });
  await give(GPL);
  await page.waitForFunction(() => document.querySelectorAll('#picker-sheet .swatches button').length === 3);
  assert.deepEqual(await swatches(), ['Deep', 'Sand, dry', '#ff0000']);
  await page.click('#picker-sheet .swatches [title="Sand, dry"]');
  assert.equal(await fill(page), 0xf0dc82ff);
  await page.screenshot({ path: path.join(SCREENSHOTS, 'picker-palette.png') });
  const saved = page.waitForEvent('download');
  await page.click('#picker-sheet [data-text="shell.palette-save"]');
  const file = await saved;
  assert.equal(file.suggestedFilename(), 'Sea and sand.gpl');
  assert.equal((await downloaded(file)).toString(), 'GIMP Palette\nName: Sea and sand\nColumns: 0\n#\n  0  64 128\tDeep\n240 220 130\tSand, dry\n255   0   0\tUntitled\n');
  await give('JASC-PAL\n0100\n1\n0 0 0\n', 'other.gpl');
  await page.waitForFunction(() => document.querySelector('.notices')?.textContent.includes('other is not a GIMP palette'));
  assert.equal((await swatches()).length, 3);
  await page.click('#picker-sheet [data-text="shell.palette-remove"]');
  assert.equal(await page.evaluate(() => localStorage.getItem('batten-palettes')), '[]');
  await page.locator('.notices button', { hasText: 'Undo' }).click();
  assert.match(await page.evaluate(() => localStorage.getItem('batten-palettes')), /Sand, dry/);
  await context.close();
});
