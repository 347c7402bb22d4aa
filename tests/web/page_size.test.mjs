// The page's size and unit where nothing is selected: typed, asked about once, scaled or kept, undone, found again; by mouse,
// pen and keyboard, in English and Korean.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { inThemes, launch, open, quiet, ready, reveal, rulesIn, SCREENSHOTS, settle, state, violations } from './page.mjs';
import { serve } from './server.mjs';

const ROOT = '<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297" id="mine">';
const REST = '<!-- mine -->\n<rect x="20" y="30" width="60" height="40" fill="#d33"/><text x="30" y="120">Hello</text></svg>\n';
const EMPTY = `${ROOT}</svg>\n`;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const saved = (page) => page.evaluate(() => new TextDecoder().decode(batten.engine.save(false)));
const value = (page, side) => page.$eval(`#page-${side}`, ({ value, nextSibling }) => `${value} ${nextSibling.textContent}`);
/** How wide the rectangle is for a reader of the file: in millimetres. */
const wide = (svg) => {
  const [, width] = /<svg[^>]* width="([\d.]+)mm"/.exec(svg) ?? [];
  const [, box] = /viewBox="[\d.-]+ [\d.-]+ ([\d.]+)/.exec(svg) ?? [];
  return 60 * width / box;
};

async function drawing(t, text, options) {
  const server = await serve({ name: 'page.svg', bytes: Buffer.from(text) });
  const opened = await open(browser, server.address, options);
  t.after(() => Promise.all([opened.context.close(), server.close()]));
  await reveal(opened.page, 'numbers');
  await opened.page.waitForSelector('#page-width');
  await quiet(opened.page);
  return opened;
}

for (const [locale, said, scale, keep] of [
  ['en', 'The page becomes 105 mm × 148.5 mm. Scale the drawing with it?', 'Scale the drawing', 'Keep its size'],
  ['ko-KR', '페이지가 105 mm × 148.5 mm(으)로 바뀝니다. 그림도 함께 늘이거나 줄일까요?', '그림도 함께 조절', '그림 크기 유지']]) {
  test(`a page is scaled by keyboard, kept by pen, left by Escape, ${locale}`, async (t) => {
    const { page, hand } = await drawing(t, ROOT + REST, { locale });
    const first = await state(page);
    assert.equal(await value(page, 'width'), '210 mm');
    assert.equal(await page.$eval('#page-sizes', (select) => select.value), 'A4');
    const type = async () => { // as one does: a number, a tab, a number, Enter
      await page.click('#page-width');
      await page.keyboard.press('Control+a');
      await page.keyboard.type('105mm');
      await page.keyboard.press('Tab');
      await page.keyboard.type('148.5');
      await page.keyboard.press('Enter');
      await settle(page);
    };
    await type();
    assert.equal(await page.textContent('#page-asks'), said);
    assert.equal((await state(page)).digest, first.digest, 'nothing has happened yet');
    await inThemes(page, async (colorScheme) => {
      await page.screenshot({ path: path.join(SCREENSHOTS, `page-size-${locale}-${colorScheme}.png`) });
      assert.deepEqual(await violations(page, rulesIn(colorScheme)), []);
    });
    // Escape: all is as it was.
    await page.keyboard.press('Escape');
    await settle(page);
    assert.ok(await page.locator('.page-asks').isHidden());
    assert.equal(await value(page, 'width'), '210 mm');
    assert.equal((await state(page)).digest, first.digest);
    // Enter once more: the first answer has the focus.
    await type();
    assert.equal(await page.evaluate(() => document.activeElement.textContent), scale);
    await page.keyboard.press('Enter');
    await settle(page);
    assert.equal(await value(page, 'height'), '148.5 mm');
    let file = await saved(page);
    assert.ok(file.endsWith(REST), file);
    assert.equal(wide(file), 30);
    assert.match(file, /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" width="105mm" height="148.5mm" viewBox="0 0 210 297" id="mine">/);
    const scaled = await state(page);
    await page.keyboard.press('Escape');
    await page.focus('#stage');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal((await state(page)).digest, first.digest);
    assert.equal(await value(page, 'width'), '210 mm');
    assert.equal(await saved(page), ROOT + REST);
    await page.keyboard.press('Control+Shift+z');
    await settle(page);
    assert.equal((await state(page)).digest, scaled.digest);
    await page.keyboard.press('Control+z');
    // The other answer, with a pen.
    await type();
    const { x, y, width, height } = await page.getByRole('button', { name: keep }).boundingBox();
    await hand.stroke([[x + width / 2, y + height / 2], [x + width / 2, y + height / 2]]);
    await settle(page);
    file = await saved(page);
    assert.ok(file.endsWith(REST), file);
    assert.equal(wide(file), 60);
    assert.equal(await value(page, 'width'), '105 mm');
    assert.equal((await state(page)).check, '');
    await page.screenshot({ path: path.join(SCREENSHOTS, `page-size-${locale}-kept.png`) });
    // The page is found as it was left.
    const kept = await state(page);
    await quiet(page);
    await page.reload();
    await ready(page);
    await reveal(page, 'numbers');
    assert.equal((await state(page)).digest, kept.digest);
    assert.equal(await value(page, 'height'), '148.5 mm');
  });
}

/** How large the page is in the window, of its width and height, and where its middle lies. */
const seen = (page) => page.evaluate(() => {
  const [width, height] = ['width', 'height'].map((side) => Number.parseFloat(batten.engine.number(`page-${side}`)));
  const { x, y, zoom } = batten.painter.painted;
  const { clientWidth, clientHeight } = document.getElementById('stage');
  return { fills: Math.max(width * zoom / clientWidth, height * zoom / clientHeight),
    at: [(width / 2 - x) * zoom / clientWidth, (height / 2 - y) * zoom / clientHeight] };
});

test('width and height change places, another page is seen whole, and there may be none', async (t) => {
  const { page } = await drawing(t, ROOT + REST);
  const first = await state(page);
  await page.click('[data-name=page-turn]');
  await settle(page);
  assert.equal(await value(page, 'width'), '297 mm');
  assert.equal(await page.$eval('#page-sizes', (select) => select.value), 'A4');
  assert.ok(await page.locator('.page-asks').isHidden());
  assert.match(await saved(page), /width="297mm" height="210mm" viewBox="0 0 297 210"/);
  await inThemes(page, async (colorScheme) => {
    await page.screenshot({ path: path.join(SCREENSHOTS, `page-turned-${colorScheme}.png`) });
    assert.deepEqual(await violations(page, rulesIn(colorScheme)), []);
  });
  for (const [name, answer] of [['A3', 'Keep its size'], ['Legal', 'Keep its size'], ['A5', 'Scale the drawing']]) {
    await page.selectOption('#page-sizes', name);
    await page.getByRole('button', { name: answer }).click();
    await settle(page);
    const { fills, at } = await seen(page);
    assert.ok(name === 'A5' || (fills > 0.5 && fills < 1), `${name}: ${fills}`);
    assert.ok(name === 'A5' || at.every((place) => Math.abs(place - 0.5) < 0.01), `${name}: ${at}`);
  }
  await page.selectOption('#page-sizes', { label: 'Infinite canvas' });
  await settle(page);
  assert.ok(await page.$eval('[data-name=page-turn]', (button) => button.disabled));
  assert.equal(await page.$eval('#page-sizes', (select) => select.value), 'none');
  await inThemes(page, async (colorScheme) => page.screenshot({ path: path.join(SCREENSHOTS, `page-none-${colorScheme}.png`) }));
  // A page again, which asks nothing where there was none.
  await page.selectOption('#page-sizes', 'A4');
  await settle(page);
  assert.equal(await value(page, 'height'), '297 mm');
  await page.focus('#stage');
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press('Control+z');
  }
  await settle(page);
  assert.equal((await state(page)).digest, first.digest);
});

test('a unit asks nothing; nor does an empty page, nor what is no size', async (t) => {
  const { page } = await drawing(t, ROOT + REST);
  const first = await state(page);
  await page.selectOption('#page-unit', 'in');
  await settle(page);
  assert.ok(await page.locator('.page-asks').isHidden());
  assert.equal(await value(page, 'width'), '8.268 in');
  assert.match(await saved(page), /width="8\.267716535in" height="11\.69291339in" viewBox="0 0 210 297"/);
  await page.focus('#stage');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await state(page)).digest, first.digest);
  assert.equal(await value(page, 'width'), '210 mm');
  // What is no size is refused in words.
  for (const text of ['0', '-3', 'wide', '1e30']) {
    await page.fill('#page-width', text);
    await page.press('#page-width', 'Enter');
    await settle(page);
    assert.equal(await page.getAttribute('#page-width', 'aria-invalid'), 'true', text);
    assert.match((await state(page)).notice, /That is not a valid page size/);
    assert.equal((await state(page)).digest, first.digest);
    await page.focus('#stage');
    await settle(page);
    assert.equal(await value(page, 'width'), '210 mm');
  }
  // A size by its name, lying as the page does.
  await page.selectOption('#page-sizes', 'A3');
  await settle(page);
  assert.ok(await page.locator('.page-asks').isVisible());
  await page.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await value(page, 'height'), '297 mm');
  assert.equal(await page.$eval('#page-sizes', (select) => select.value), 'A4');
  // With a selection the section is about it.
  await page.focus('#stage');
  await page.keyboard.press('Control+a');
  await settle(page);
  assert.ok(await page.locator('#page-width').isHidden());
  assert.ok(await page.locator('#number-width').isVisible());

  const empty = await drawing(t, EMPTY);
  await empty.page.fill('#page-width', '8.5in');
  await empty.page.press('#page-width', 'Enter');
  await settle(empty.page);
  assert.equal(await value(empty.page, 'width'), '215.9 mm');
  assert.ok(await empty.page.locator('.page-asks').isHidden());
});
