// Kills a browser that draws, at random moments, and opens its profile again: node kills.mjs [COUNT [SEED]]. A stroke that was said
// to be kept is there; of the others at most the last one is missing. Four of five kills take the renderer alone, as a crash or a
// phone does; the fifth takes all of the browser's processes. Prints what was lost, as JSON, and every 100 kills how far it is; an
// interrupt (SIGINT, SIGTERM) ends it after the kill that it is at, with what was reached.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { chance } from './disk_model.mjs';
import { Hand, launchAt, ready } from './page.mjs';
import { serve } from './server.mjs';

const MOST = 4; // strokes of a session
const RENEW = 25; // kills until another drawing is begun
const WINDOW = { viewport: { width: 820, height: 800 } }; // no wider than the strokes need: each kill opens a page
const line = (k) => [[150, 120 + 37 * (k % 14)], [350, 100 + 37 * (k % 14)], [550, 120 + 37 * (k % 14)]];

/** The processes of a browser with this profile. @param {string} profile */
const processesOf = (profile) => fs.readdirSync('/proc').filter((pid) => {
  try {
    return /^\d+$/.test(pid) && fs.readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes(profile);
  } catch {
    return false; // it has ended
  }
}).map(Number);

/** Waits for what may never end, since who was to answer was killed. @param {Promise<unknown>} work */
const soon = (work) => Promise.race([work.catch(() => {}), new Promise((done) => setTimeout(done, 2000))]);

/** A browser, also on a machine where one start takes too long. @param {string} profile */
async function launch(profile, tries = 3) {
  try {
    return await launchAt(profile, { ...WINDOW, handleSIGINT: false, handleSIGTERM: false }); // a signal ends the run, not the browser
  } catch (error) {
    processesOf(profile).forEach(kill);
    if (tries === 1) {
      throw error;
    }
    return launch(profile, tries - 1);
  }
}

/** @param {number} pid */
function kill(pid) {
  try {
    process.kill(pid, 'SIGKILL');
  } catch {
    // It has ended by itself.
  }
}

/** @param {number} pid */
const isRenderer = (pid) => {
  try {
    return fs.readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes('--type=renderer');
  } catch {
    return false;
  }
};

/** A page, and what it tells: the pens that were lifted, and the strokes that are kept. */
async function visit(context, address) {
  const told = { up: [], kept: -1 };
  const page = await context.newPage();
  await page.exposeFunction('tell', (what, value) => {
    if (what === 'up') {
      told.up.push(value);
    } else {
      told.kept = Math.max(told.kept, value);
    }
  });
  await page.goto(address);
  await ready(page);
  // Counted by the steps of the journal: a stroke near another may redraw it.
  await page.evaluate(() => {
    globalThis.steps = () => new TextDecoder().decode(batten.engine.journal).split('{"do":').length - 1;
  });
  const drawn = await page.evaluate(() => globalThis.steps());
  await page.evaluate(() => {
    document.getElementById('stage').addEventListener('pointerup', () => globalThis.tell('up', Date.now()));
    const { keeper } = batten;
    const note = keeper.note.bind(keeper);
    keeper.note = (...values) => {
      note(...values);
      const count = globalThis.steps();
      void keeper.settled().then(() => keeper.fault || globalThis.tell('kept', count));
    };
  });
  return { page, told, drawn, hand: new Hand(page, await context.newCDPSession(page)) };
}

/**
 * @param {number} count of kills @param {number} seed
 * @param {(all: object) => boolean} goOn is told what was reached after each kill, and says whether there is to be another
 */
export async function kills(count, seed, goOn = () => true) {
  const random = chance(seed);
  const server = await serve();
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-kills-'));
  const all = { seed, kills: 0, strokes: 0, renderers: 0, lost: 0, lostAfter20ms: 0 };
  let context = await launch(profile);
  try {
    let seen = await visit(context, server.address);
    for (let k = 0; k < count; k++) {
      const { page, told, hand } = seen;
      if (k % RENEW === RENEW - 1) {
        await page.evaluate(() => batten.drawings.openNew().then(() => batten.keeper.settled()));
        told.kept = -1; // what was told was told of the drawing before
      }
      const begun = await page.evaluate(() => globalThis.steps());
      const whole = random() < 0.2;
      let over = false;
      const drawing = (async () => {
        for (let n = 0; n < MOST; n++) {
          await hand.stroke(line(begun + n), { step: 40 });
          while (told.kept < begun + n + 1 && !over) { // a machine under load may keep it later than a hand draws on
            await new Promise((done) => setTimeout(done, 1));
          }
        }
      })().catch(() => {}); // the browser is gone
      const stop = Math.floor(MOST * random());
      for (const from = Date.now(); told.up.length <= stop && Date.now() - from < 60000;) {
        await new Promise((done) => setTimeout(done, 1));
      }
      await new Promise((done) => setTimeout(done, random() < 0.5 ? 0 : 40 * random()));
      const [now, ups, kept] = [Date.now(), told.up.slice(), told.kept];
      processesOf(profile).filter((pid) => whole || isRenderer(pid)).forEach(kill);
      over = true;
      await soon(drawing);
      if (whole) {
        await soon(context.close());
        context = await launch(profile);
      } else {
        await soon(page.close());
      }
      seen = await visit(context, server.address).catch(async () => { // the browser itself did not survive it
        await soon(context.close());
        context = await launch(profile);
        return visit(context, server.address);
      });
      const missing = begun + ups.length - seen.drawn;
      assert.ok(seen.drawn >= kept, `kill ${k} of seed ${seed}: ${seen.drawn} strokes, ${kept} were said to be kept`);
      assert.ok(missing <= 1, `kill ${k} of seed ${seed}: ${missing} strokes are missing`);
      all.kills++;
      all.renderers += Number(!whole);
      all.strokes += ups.length;
      all.lost += Math.max(0, missing);
      all.lostAfter20ms += Number(missing > 0 && now - ups.at(-1) > 20);
      if (!goOn(all)) {
        break;
      }
    }
  } catch (error) {
    console.error(JSON.stringify(all)); // what was reached
    throw error;
  } finally {
    await soon(context.close());
    processesOf(profile).forEach(kill);
    server.close();
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  return all;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  let interrupted = false;
  ['SIGINT', 'SIGTERM'].forEach((signal) => process.on(signal, () => {
    interrupted = true;
  }));
  const all = await kills(Number(process.argv[2] ?? 1000), Number(process.argv[3] ?? Date.now() % 100000), (now) => {
    if (now.kills % 100 === 0) {
      console.error(JSON.stringify(now));
    }
    return !interrupted;
  });
  console.log(JSON.stringify(all));
  process.exit(0);
}
