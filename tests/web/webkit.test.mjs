// WebKitGTK as Debian has it, its MiniBrowser driven by WebDriver: the session of elsewhere.mjs. label: all (another browser)
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { HANG, session } from './elsewhere.mjs';

const BROWSER = ['4.1', '4.0'].map((version) => `/usr/lib/${process.arch === 'arm64' ? 'aarch64' : 'x86_64'}-linux-gnu/webkit2gtk-${version}/MiniBrowser`)
  .find((file) => fs.existsSync(file));
const PORT = 20000 + (process.pid % 20000);
const END = 3000; // milliseconds for the driver to end its browser

/** A request of WebDriver. @param {string} way @param {unknown} [body] omitted: it is asked for */
async function ask(way, body, method = body === undefined ? 'GET' : 'POST') {
  const answer = await fetch(`http://127.0.0.1:${PORT}${way}`, { method, body: body === undefined ? undefined : JSON.stringify(body),
    signal: AbortSignal.timeout(HANG) })
    .catch((error) => { throw new Error(`${way} ${JSON.stringify(body)?.slice(0, 200)}: ${error.message}`); });
  const { value } = await answer.json();
  assert.ok(answer.ok, `${way}: ${JSON.stringify(value)}`);
  return value;
}

test('WebKit: drawn, drawn over, saved, kept, tilted, exported, text, both languages', async (t) => {
  const home = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-webkit-'));
  // What it keeps stands in its own folders, and its windows on a screen of their own.
  const driver = spawn('xvfb-run', ['-a', '-s', '-screen 0 1280x900x24', 'WebKitWebDriver', `--port=${PORT}`], { stdio: 'ignore', detached: true,
    env: { ...process.env, HOME: home, XDG_DATA_HOME: `${home}/data`, XDG_CACHE_HOME: `${home}/cache`, XDG_CONFIG_HOME: `${home}/config`,
      LIBGL_ALWAYS_SOFTWARE: '1', WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1', WEBKIT_DISABLE_DMABUF_RENDERER: '1' } });
  let at = '';
  t.after(async () => {
    if (at) {
      await ask(at, undefined, 'DELETE').catch(() => {});
    }
    process.kill(-driver.pid, 'SIGTERM');
    await new Promise((done) => { driver.once('exit', done); setTimeout(done, END); });
    fs.rmSync(home, { recursive: true, force: true });
  });
  for (const begun = Date.now(); !(await ask('/status').catch(() => null))?.ready;) {
    assert.ok(Date.now() - begun < HANG, 'the driver starts');
    await new Promise((done) => { setTimeout(done, 100); });
  }
  const { sessionId, capabilities } = await ask('/session', { capabilities: { alwaysMatch: {
    'webkitgtk:browserOptions': { binary: BROWSER, args: ['--automation'] } } } });
  at = `/session/${sessionId}`;
  await ask(`${at}/window/rect`, { width: 1280, height: 860 });
  const pointer = (actions) => ask(`${at}/actions`, { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }] });
  const keys = (text) => ask(`${at}/actions`, { actions: [{ type: 'key', id: 'keys', actions: [...text].flatMap((value) =>
    [{ type: 'keyDown', value }, { type: 'keyUp', value }]) }] });
  await session({
    name: 'webkit',
    version: async () => `${capabilities.browserName} ${capabilities.browserVersion}`,
    go: (url) => ask(`${at}/url`, { url }),
    run: (code) => ask(`${at}/execute/sync`, { script: `return ${code}`, args: [] }),
    drag: ([[x, y], ...rest]) => pointer([{ type: 'pointerMove', x: Math.round(x), y: Math.round(y), duration: 0 }, { type: 'pointerDown', button: 0 },
      ...rest.map(([left, top]) => ({ type: 'pointerMove', x: Math.round(left), y: Math.round(top), duration: 10 })), { type: 'pointerUp', button: 0 }]),
    type: keys,
    escape: () => keys('\uE00C'),
  });
});
