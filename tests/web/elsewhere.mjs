// The session that browsers other than Chromium run, whoever drives them: drawn, drawn over, saved, kept after a reload, tilted,
// exported, text, both languages.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { EXAMPLE, serve } from './server.mjs';

/** Milliseconds: what takes longer hangs, however busy the machine. */
export const HANG = 90000;
const SHOTS = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../build/screenshots');

/**
 * What drives a browser. run: the value of an expression in the page; drag: presses the mouse at the first place, moves and lifts;
 * type: types in whatever has the focus; escape: presses that key.
 * @typedef {{ name: string, version: () => Promise<string>, go: (address: string) => Promise<unknown>, run: (code: string) => Promise<any>,
 *   drag: (points: number[][]) => Promise<unknown>, type: (text: string) => Promise<unknown>, escape: () => Promise<unknown>, picture?: () => Promise<Buffer> }} Driver
 */

/** @param {Driver} driver */
export async function session(driver) {
  const server = await serve({ name: 'car.svg', bytes: fs.readFileSync(EXAMPLE) });
  const pause = (time) => new Promise((done) => { setTimeout(done, time); });
  const until = async (code, what = code) => {
    for (const begun = Date.now(); !await driver.run(code);) {
      assert.ok(Date.now() - begun < HANG, what);
      await pause(50);
    }
  };
  const ready = () => until("document.documentElement.dataset.ready === 'yes' && batten.painter.list.length > 0", 'the page starts');
  const digest = () => driver.run('String(batten.engine.digest())');
  const objects = () => driver.run('batten.painter.list.length');
  const command = (name) => driver.run(`(batten.engine.command('${name}'), batten.engine.glide(1), batten.wake(), true)`);
  /** To be looked at, where that takes no minutes. */
  const picture = async (name) => driver.picture && fs.writeFileSync(path.join(SHOTS, `${driver.name}-${name}.png`), await driver.picture());
  /** Places of the window for places of the drawing. */
  const on = (points) => driver.run(`(() => {
    const { x, y, zoom } = batten.painter.painted;
    const box = document.getElementById('stage').getBoundingClientRect();
    return ${JSON.stringify(points)}.map(([px, py]) => [box.left + (px - x) * zoom, box.top + (py - y) * zoom]);
  })()`);
  /** Waits until what is kept of the drawing is on the disk, or nothing is. */
  const settled = async () => {
    await driver.run(`(globalThis.kept = 0, batten.keeper.settled().then(() => batten.keeper.find('car.svg'))
      .then((one) => { globalThis.kept = one?.journal.length || -1; }, () => { globalThis.kept = -1; }), true)`);
    await until('kept !== 0', 'it is known whether it is kept');
  };
  const bow = (x0, x1, y, high, count = 25) => Array.from({ length: count }, (_, i) => {
    const t = i / (count - 1);
    return [x0 + (x1 - x0) * t, y - high * 4 * t * (1 - t)];
  });
  try {
    fs.mkdirSync(SHOTS, { recursive: true });
    await driver.go(server.address);
    await ready();
    console.log(`# ${await driver.version()}`);
    const first = await objects();
    const begun = await digest();

    // A new curve; drawn over, it is redrawn; undone, it is as it was.
    await driver.drag(await on(bow(100, 500, 60, 20)));
    await until(`batten.painter.list.length === ${first + 1}`, 'a stroke is a new curve');
    const drawn = await digest();
    assert.notEqual(drawn, begun);
    await driver.drag(await on(bow(160, 440, 56, 35)));
    await until(`String(batten.engine.digest()) !== '${drawn}'`, 'a stroke over it redraws it');
    assert.equal(await objects(), first + 1);
    await command('undo');
    await until(`String(batten.engine.digest()) === '${drawn}'`, 'undone, it is as it was');

    // Saved to where it came from, and read again from there.
    await command('save');
    for (const since = Date.now(); server.saves < 1;) {
      assert.ok(Date.now() - since < HANG, 'it is saved');
      await pause(50);
    }
    assert.ok(server.bytes.length > fs.statSync(EXAMPLE).size);
    await settled();
    await driver.go('about:blank');
    await driver.go(server.address);
    await ready();
    assert.equal(await objects(), first + 1, 'what was saved is opened');

    // Kept without being saved, or said not to be.
    await driver.drag(await on(bow(40, 260, 120, 15)));
    await until(`batten.painter.list.length === ${first + 2}`, 'another curve');
    await settled();
    const keeps = await driver.run('kept > 0');
    if (!keeps) {
      await until("/does not keep unsaved work|no room to keep/.test(document.body.textContent)", 'it says that it keeps nothing');
    }
    await driver.go('about:blank');
    await driver.go(server.address);
    await ready();
    if (keeps) {
      await until(`batten.painter.list.length === ${first + 2}`, 'what was not saved is kept after a reload');
    }
    console.log(`# ${driver.name}: unsaved work is ${keeps ? 'kept' : 'not kept, and the page says so'}`);

    // Tilted.
    await command('orbit-up');
    await command('orbit-up');
    await command('orbit-left');
    await until("Boolean(document.querySelector('.dial.tilted, .tilted'))", 'the view is tilted');
    await picture('tilted');
    await command('view-upright');
    await pause(500);

    // Exported: what a download is given.
    await driver.run(`(() => {
      globalThis.exported = [];
      const make = URL.createObjectURL;
      URL.createObjectURL = (blob) => { exported.push([blob.type, blob.size]); return make.call(URL, blob); };
      HTMLAnchorElement.prototype.click = () => {};
      return true;
    })()`);
    await command('download-svg');
    await until("exported.some(([type, size]) => /svg/.test(type) && size > 1000)", 'SVG is exported');
    await command('export');
    await until("Boolean(document.querySelector('#export[open]'))", 'the sheet of exports opens');
    await driver.run(`(() => {
      const format = document.querySelector('#export-format');
      format.value = 'png';
      format.dispatchEvent(new Event('input', { bubbles: true }));
      format.dispatchEvent(new Event('change', { bubbles: true }));
      document.querySelector('#export .strong').click();
      return true;
    })()`);
    await until("exported.some(([type, size]) => type === 'image/png' && size > 1000)", 'PNG is exported');
    await driver.run("(document.querySelector('#export[open]')?.close(), true)");

    // Text, typed in place.
    await command('tool-text');
    const [at] = await on([[40, 160]]);
    await driver.drag([at, at]);
    await until("Boolean(document.activeElement?.matches('.writing textarea'))", 'text can be typed');
    await driver.type('Hello');
    await driver.escape();
    await until("new TextDecoder().decode(batten.engine.save(true)).includes('Hello')", 'the text is in the drawing');

    // The other language, at once.
    await driver.run("(document.querySelector('[data-name=settings]').click(), true)");
    await until("Boolean(document.querySelector('#settings [data-property=language]'))", 'the settings open');
    await driver.run(`(() => {
      const field = document.querySelector('#settings [data-property=language]');
      field.value = [...field.options].find((one) => one.textContent === '한국어').value;
      field.dispatchEvent(new Event('input', { bubbles: true }));
      field.dispatchEvent(new Event('change', { bubbles: true }));
      return true;
    })()`);
    await until("document.documentElement.lang === 'ko'", 'Korean is chosen');
    await until("/[가-힣]/.test(document.querySelector('#hint')?.textContent ?? '')", 'it speaks Korean');
    await picture('korean');
  } finally {
    server.close();
  }
}
