import { launch, open, settle, quiet, place } from './page.mjs';
import { serve, EXAMPLE } from './server.mjs';
import fs from 'node:fs';
const out = process.argv[2] ?? '/tmp/shots/a';
const only = process.argv[3] ? new RegExp(process.argv[3]) : /./;
const browser = await launch();
const sizes = { d: [1280, 800], p: [390, 844], t: [820, 1180] };
for (const [n, [width, height]] of Object.entries(sizes)) for (const theme of ['light', 'dark']) {
  if (!only.test(`${n}-${theme}`)) continue;
  const touch = n !== 'd';
  const server = await serve();
  const { page, context, hand } = await open(browser, server.address, { viewport: { width, height }, colorScheme: theme, hasTouch: touch, isMobile: touch });
  const shot = (s) => page.screenshot({ path: `${out}-${n}-${theme}-${s}.png` });
  await page.waitForTimeout(500);
  await shot('1empty');
  await page.evaluate(async (t) => { batten.engine.load ? 0 : 0; }, '');
  await page.evaluate((text) => { const tr = new DataTransfer(); tr.items.add(new File([text], 'car.svg')); for (const type of ['dragover','drop']) document.getElementById('stage').dispatchEvent(new DragEvent(type, {bubbles:true,cancelable:true,dataTransfer:tr})); }, fs.readFileSync(EXAMPLE, 'utf8'));
  await page.waitForTimeout(800);
  await shot('2car');
  await page.keyboard.press('v');
  await page.keyboard.press('Control+a');
  await page.waitForTimeout(900);
  await shot('3selected');
  await page.evaluate(() => { const e = document.getElementById('inspector'); e && e.hidden && document.querySelector('[data-name=inspector]')?.click(); });
  await page.waitForTimeout(500);
  await shot('4inspector');
  for (const id of ['style', 'layers', 'numbers', 'menu', 'settings']) {
    const has = await page.evaluate((i) => { const e = document.getElementById(i); if (e?.popover) { e.showPopover(); return true; } return false; }, id);
    if (!has) continue;
    await page.waitForTimeout(400);
    await shot(`5${id}`);
    await page.evaluate((i) => document.getElementById(i).hidePopover(), id);
  }
  await page.keyboard.press('Escape'); 
  await page.evaluate(() => { batten.engine.command('view-fit'); batten.wake(); });
  const ids = await page.evaluate(() => JSON.parse(batten.engine.ask('editor_outline', 0, 200)).rows.map(r => r.id));
  await page.evaluate((id) => { batten.engine.act('editor_select', id, 0); batten.wake(); }, ids[ids.length - 1]);
  await page.waitForTimeout(500);
  await shot('6one');
  await page.evaluate(() => { batten.engine.command('tool-levels'); batten.wake(); });
  await page.waitForTimeout(900);
  await shot('7levels');
  await context.close(); server.close();
}
await browser.close();
