// One Chromium for many test files: `node browser.mjs start FILE` leaves one running whose address stands in FILE, which
// launch() of page.mjs finds by BATTEN_BROWSER; `stop FILE` ends it. It also ends when whoever started it has ended.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import { chromium } from 'playwright-core';
import { BROWSER } from './chromium.mjs';

const WATCH = 1000; // milliseconds between looks at whether it is still wanted
const START = 60000;

const [order, file, owner] = process.argv.slice(2);

/** @param {number} pid */
function lives(pid) {
  try {
    return process.kill(pid, 0);
  } catch {
    return false;
  }
}

const sleep = (time) => new Promise((done) => setTimeout(done, time));

if (order === 'start') {
  fs.rmSync(file, { force: true });
  spawn(process.execPath, [process.argv[1], 'serve', file, String(process.ppid)], { detached: true, stdio: 'ignore' }).unref();
  for (let waited = 0; !fs.existsSync(file) && waited < START; waited += 50) {
    await sleep(50);
  }
  process.exitCode = fs.existsSync(file) ? 0 : 1;
} else if (order === 'serve') {
  const server = await chromium.launchServer(BROWSER);
  fs.writeFileSync(`${file}.new`, server.wsEndpoint());
  fs.renameSync(`${file}.new`, file);
  while (fs.existsSync(file) && lives(Number(owner)) && server.process().exitCode === null) {
    await sleep(WATCH);
  }
  await server.close();
  fs.rmSync(file, { force: true });
} else {
  fs.rmSync(file, { force: true });
}
