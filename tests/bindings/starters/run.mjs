// Begins projects as a developer begins them, from packed packages: run.mjs [--here] [NAME...]. Each is installed from the registry into
// a fresh folder; with --here, its tools are those of tests/web, and the registry is not asked. The dev server runs before the packages are used; the first edit uses them, the second changes a word of the page;
// then the page is reloaded, built, and the build served. The last line is "N passed, N failed".
import { execFile, execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { STARTERS } from './table.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');
const PACKED = path.join(process.env.BATTEN_NPM ?? path.join(root, 'build/wasm/npm'));
const HERE = path.join(root, 'tests/web/node_modules');
const WAIT = 40000; // milliseconds that a server and a page have
const TYPES = { html: 'text/html', js: 'text/javascript', css: 'text/css', wasm: 'application/wasm', svg: 'image/svg+xml', json: 'application/json' };
const playwright = await import(path.join(root, 'tests/web/node_modules/playwright-core/index.mjs'));
const { BROWSER } = await import(path.join(root, 'tests/web/chromium.mjs'));
const run = promisify(execFile);
const later = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

/** A port that nobody listens to. */
const free = () => new Promise((done) => {
  const server = net.createServer().listen(0, '127.0.0.1', () => {
    const { port } = server.address();
    server.close(() => done(String(port)));
  });
});

/** Files of a folder, served plainly. */
async function serve(folder) {
  const server = http.createServer((request, response) => {
    const file = path.join(folder, new URL(request.url, 'http://x/').pathname.replace(/\/$/, '/index.html'));
    const there = file.startsWith(folder) && fs.existsSync(file) && fs.statSync(file).isFile();
    response.writeHead(there ? 200 : 404, { 'content-type': TYPES[file.split('.').pop()] ?? 'application/octet-stream' });
    response.end(there ? fs.readFileSync(file) : '');
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => (server.closeAllConnections(), server.close()) };
}

/** A command of the project's own packages that goes on until it is closed. */
async function begin(project, words) {
  const port = await free();
  const child = spawn(path.join(project, 'node_modules/.bin', words[0]), words.slice(1).map((word) => word.replace('PORT', port)),
    { cwd: project, detached: true, stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1' } });
  let said = '';
  child.stdout.on('data', (text) => { said += text; });
  child.stderr.on('data', (text) => { said += text; });
  return {
    address: `http://127.0.0.1:${port}/`,
    said: () => said,
    async there() {
      for (const end = Date.now() + WAIT; Date.now() < end; await later(100)) {
        if (await fetch(this.address).then(({ ok }) => ok, () => false)) {
          return this;
        }
      }
      throw new Error(`no server: ${said}`);
    },
    async close() {
      const ended = child.exitCode !== null || new Promise((done) => child.once('exit', done));
      try {
        process.kill(-child.pid);
      } catch {
        // it has ended by itself
      }
      await ended;
    },
  };
}

/** Waits until the page tells all that it should, with a word. A page that does not follow edits is reloaded, as its developer does. */
async function told(page, word, names, reloads) {
  let found = {};
  const begun = Date.now();
  let patience = 1500; // a busy machine needs longer from a reload to the editor
  for (let next = begun + (reloads ? 0 : WAIT / 2); Date.now() < begun + WAIT; await later(250)) {
    if (Date.now() >= next) {
      await page.reload();
      next = reloads ? Date.now() + patience : Infinity;
      patience *= 2;
    }
    found = await page.evaluate(() => globalThis.told ?? {}).catch(() => ({}));
    if (Object.values(found).some((text) => text.startsWith('failed'))) {
      break;
    }
    if (names.every((name) => found[name]) && found.core.startsWith(word)) {
      return found;
    }
  }
  throw new Error(`the page told ${JSON.stringify(found).slice(0, 300)}, not ${names} with ${word}`);
}

/** What a component shows follows a stroke that is drawn in its editor. */
async function draw(page) {
  await page.waitForFunction(() => document.querySelector('output')?.textContent === '1' && document.querySelector('svg path')?.getAttribute('d')?.startsWith('M') &&
    document.querySelector('batten-editor').svg.includes('<path'), null, { timeout: WAIT });
  const box = await page.locator('batten-editor').boundingBox();
  const at = (share) => [box.x + box.width * (0.3 + 0.4 * share), box.y + box.height * (0.5 + 0.1 * Math.sin(6 * share))];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let i = 1; i <= 30; i++) {
    await page.mouse.move(...at(i / 30));
  }
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector('output').textContent === '2', null, { timeout: WAIT });
}

/** No page shows itself in an editor, and what was opened is in it. */
async function look(starter, page, found) {
  if (starter.component) {
    await draw(page);
    found = { editor: await page.locator('batten-editor').evaluate(({ svg }) => svg) };
  }
  const frames = page.frames().slice(1).map((frame) => frame.url());
  if (found.editor !== undefined && (!frames.length || frames.some((url) => !url.startsWith('blob:')) || !found.editor.includes('<path'))) {
    throw new Error(`frames ${frames}, the editor has ${found.editor.slice(0, 200)}`);
  }
}

/** The name of a package without its version. */
const bare = (name) => name.replace(/(?<=.)@.*/, '');

/** A package of tests/web, and its command, as if it had been installed. */
function borrow(name, project) {
  fs.symlinkSync(path.join(HERE, name), path.join(project, 'node_modules', name));
  const { bin = {} } = JSON.parse(fs.readFileSync(path.join(HERE, name, 'package.json'), 'utf8'));
  fs.mkdirSync(path.join(project, 'node_modules/.bin'), { recursive: true });
  Object.entries(bin).forEach(([command, file]) => fs.symlinkSync(path.join(HERE, name, file), path.join(project, 'node_modules/.bin', command)));
}

/** What it was tried with: "vite 7.3.8, react 19.2.0". */
function versions(starter, project) {
  const of = (name) => JSON.parse(fs.readFileSync(path.join(project, 'node_modules', name, 'package.json'), 'utf8')).version;
  return starter.packages.map(bare).map((name) => `${name} ${of(name)}`).join(', ') || `node ${process.versions.node}`;
}

async function install(starter, project) {
  fs.writeFileSync(path.join(project, 'package.json'), '{ "name": "begun", "private": true, "type": "module" }\n');
  const packed = ['batten-core', 'batten-editor'].map((name) =>
    path.join(project, execFileSync('npm', ['pack', '--silent', path.join(PACKED, name)], { cwd: project, encoding: 'utf8' }).trim()));
  await run('npm', ['install', '--no-audit', '--no-fund', ...packed, ...(here ? ['--offline'] : starter.packages)], { cwd: project });
  starter.packages.forEach((name) => here && borrow(bare(name), project));
  for (const [name, text] of Object.entries(starter.files)) {
    fs.mkdirSync(path.dirname(path.join(project, name)), { recursive: true });
    fs.writeFileSync(path.join(project, name), text);
  }
}

/** Dev server, first edit, second edit, reload. */
async function develop(starter, project, browser, names) {
  const main = path.join(project, starter.main);
  const write = (text) => (fs.mkdirSync(path.dirname(main), { recursive: true }), fs.writeFileSync(main, text));
  write(starter.begun ?? "globalThis.told = { core: 'begun' };\n");
  const command = starter.dev ?? starter.watch;
  const tool = command && await begin(project, command);
  const files = starter.dev ? null : await serve(path.join(project, starter.out));
  const page = await browser.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  try {
    if (starter.dev) {
      await tool.there();
    } else {
      const made = path.join(project, starter.out, path.basename(starter.main));
      for (const end = Date.now() + WAIT; !fs.existsSync(made) && Date.now() < end; await later(100));
    }
    await page.goto((files ?? tool).address);
    if (!starter.begun) {
      await told(page, 'begun', ['core'], starter.reloads);
    }
    write(starter.text('first'));
    await look(starter, page, await told(page, 'first', names, starter.reloads));
    write(starter.text('second'));
    await look(starter, page, await told(page, 'second', names, starter.reloads));
    await page.reload();
    await look(starter, page, await told(page, 'second', names));
    if (faults.length > 0) {
      throw new Error(faults.join('\n'));
    }
  } catch (error) {
    throw new Error(`dev: ${error.message}\n${faults.slice(0, 5).join('\n')}\n${tool?.said().slice(-1500)}`);
  } finally {
    await page.close();
    await tool?.close();
    files?.close();
  }
}

/** The build, served. */
async function build(starter, project, browser, names) {
  fs.writeFileSync(path.join(project, starter.main), starter.text('built'));
  const { stdout, stderr } = await run(path.join(project, 'node_modules/.bin', starter.build[0]), starter.build.slice(1), { cwd: project })
    .catch((error) => { throw new Error(`build: ${error.stdout}${error.stderr}`); });
  if (starter.page) {
    fs.copyFileSync(path.join(project, starter.page), path.join(project, starter.out, 'index.html'));
  }
  const server = starter.start ? await (await begin(project, starter.start)).there() : await serve(path.join(project, starter.out));
  const page = await browser.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  try {
    await page.goto(server.address);
    await look(starter, page, await told(page, 'built', names));
  } catch (error) {
    throw new Error(`build: ${error.message}\n${faults.join('\n')}`);
  } finally {
    await page.close();
    await server.close();
  }
  return (stdout + stderr).split('\n').filter((line) => /warn/i.test(line)).slice(0, 4);
}

async function one(name, browser) {
  const starter = STARTERS[name];
  const project = fs.mkdtempSync(path.join(os.tmpdir(), `batten-${name}-`));
  try {
    await install(starter, project);
    const tried = versions(starter, project);
    if (starter.script) {
      fs.writeFileSync(path.join(project, starter.main), starter.text('run'));
      const [command, ...words] = starter.script;
      const own = path.join(project, 'node_modules/.bin', command);
      const { stdout } = await run(fs.existsSync(own) ? own : command, words, { cwd: project });
      const found = JSON.parse(stdout);
      if (!/^run M/.test(found.core) || !/^M/.test(found.worker)) {
        throw new Error(stdout);
      }
      return [tried];
    }
    const names = starter.component ? ['core'] : ['core', 'worker', 'editor'];
    if (starter.dev || starter.reloads) {
      await develop(starter, project, browser, names);
    }
    return [tried, ...(starter.build ? await build(starter, project, browser, names) : [])];
  } finally {
    if (!process.env.KEEP) {
      fs.rmSync(project, { recursive: true, force: true, maxRetries: 20, retryDelay: 200 });
    }
  }
}

const here = process.argv.includes('--here');
const asked = process.argv.slice(2).filter((word) => word !== '--here');
const names = asked.length > 0 ? asked : Object.keys(STARTERS);
const browser = await playwright.chromium.launch(BROWSER);
let failed = 0;
for (const name of names) {
  const start = Date.now();
  try {
    const [tried, ...warned] = await one(name, browser);
    console.log([`ok    ${name} (${Math.round((Date.now() - start) / 1000)} s): ${tried}`, ...warned].join('\n      '));
  } catch (error) {
    failed++;
    console.log(`FAIL  ${name} (${Math.round((Date.now() - start) / 1000)} s)\n${error.message.replace(/^/gm, '      ')}`);
  }
}
await browser.close();
console.log(`${names.length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
