// A stand-in for the server of `batten edit`: the shell's files with its headers, and one document.
// With it a test can inspect, and corrupt, what the real server would hold.
import { spawn } from 'node:child_process';
import crypto from 'node:crypto';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const WEB = path.join(ROOT, 'web');
export const MODULE = process.env.BATTEN_MODULE ?? path.join(ROOT, 'build/wasm/batten.wasm');
export const PROGRAM = process.env.BATTEN_PROGRAM ?? path.join(ROOT, 'build/release/batten');
export const EXAMPLE = path.join(ROOT, 'examples/car.svg');
const SHOWN = 'examples/car.svg'; // the shell's, too: an empty page offers it

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.png': 'image/png',
  '.webmanifest': 'application/manifest+json',
};
const digestOf = (bytes, how = 'hex') => crypto.createHash('sha256').update(bytes).digest(how);
/** The script that is a part of the page: it is there whatever else is missing. */
const STARTING = fs.readFileSync(path.join(WEB, 'page/starting.js'), 'utf8').trim();
const POLICY = `default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'sha256-${digestOf(STARTING, 'base64')}'; ` + "style-src 'self'; img-src 'self' blob: data:; font-src 'self'; " +
  "connect-src 'self'; worker-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/** Files with a fixed address; all others are in the folder of their build. */
const STAYING = ['index.html', 'manifest.webmanifest', 'sw.js'];
const BUILT = ['words.en.json', 'words.ko.json', 'batten.wasm', 'batten-later.wasm'];

/** The files as the program would embed them. @param {string} build */
function shellFiles(build) {
  const files = fs.readdirSync(WEB, { recursive: true }).filter((file) => /\.(html|js|css|svg|png|webmanifest)$/.test(file));
  return [...files.filter((file) => !['engine/types.js', 'page/starting.js'].includes(file) && !STAYING.includes(file)), ...BUILT, SHOWN]
    .map((file) => `${build}/${file}`).concat(STAYING.slice(0, 2));
}

/** What was built already: each opening of a page asks for all. @type {Map<string, ReturnType<typeof make>>} */
const made = new Map();

/** A file as it is built: the bytes at its address, which needs no server. @param {string} build @param {string} address */
function built(build, address) {
  const key = `${build} ${address}`;
  if (!made.has(key)) {
    made.set(key, make(build, address));
  }
  return made.get(key);
}

/** @param {string} build @param {string} address */
function make(build, address) {
  const [folder, ...rest] = address.split('/');
  const name = STAYING.includes(folder) ? folder : rest.join('/');
  const file = BUILT.includes(name) ? path.join(path.dirname(MODULE), name) : path.join(name === SHOWN ? ROOT : WEB, name);
  if (name === '' || (name !== folder && folder !== build) || !/^(web|build|examples)/.test(path.relative(ROOT, file)) || !fs.existsSync(file)) {
    return null;
  }
  let body = fs.readFileSync(file);
  if (name === folder) {
    body = Buffer.from(body.toString().replaceAll('%BUILD%', build).replace('%FACE%', '').replace('%STARTING%', () => STARTING)
      .replace('%FILES%', () => shellFiles(build).map((one) => `${one}:${digestOf(built(build, one).body)}`).join(' ')));
  }
  return { name, body, type: TYPES[path.extname(file)] };
}

const tagOf = (bytes) => `"${digestOf(bytes).slice(0, 16)}"`;

/**
 * `version` names the build, `without` the files that it lacks, `stale` files that are still of another build, `spoil` the bytes that
 * a file is answered with; `beside` a new file beside the document ('': none can
 * be made); `refused` the status that saves are refused with; `heard` counts the requests for the version alone.
 * @param {{ name?: string, bytes?: Buffer }} [document] omitted: the page is served without a token
 * @param {boolean} [lasting] the address stays, so that the browser may keep the shell
 * @param {string} host
 */
export async function serve(document, lasting = false, host = '127.0.0.1') {
  const token = crypto.randomBytes(16).toString('hex');
  const state = { bytes: document?.bytes, version: '1', stranger: '', without: /^$/, stale: {}, spoil: (name, body) => body, saves: 0, heard: 0,
    beside: '', refused: 0, address: '', close: () => {} };
  const server = http.createServer((request, response) => {
    const where = new URL(request.url, 'http://localhost').pathname;
    if (state.stranger) {
      response.writeHead(200, { 'Content-Type': 'text/html' }).end(state.stranger);
      return;
    }
    if (where === '/document') {
      answerDocument(request, response);
      return;
    }
    const address = where.slice(1) || 'index.html';
    const file = built(state.stale[address] ?? state.version, address);
    if (!file || state.without.test(file.name)) {
      response.writeHead(404).end();
      return;
    }
    let body = state.spoil(file.name, file.body);
    if (where === '/') {
      body = Buffer.from(body.toString().replace('%TOKEN%', document ? token : '%TOKEN%')
        .replace('%ADDRESS%', lasting ? 'lasting' : 'passing'));
    }
    response.writeHead(200, { 'Content-Type': file.type, 'Content-Security-Policy': POLICY,
      'Cache-Control': 'no-store' });
    response.end(body);
  });

  function answerDocument(request, response) {
    if (!document || request.headers['x-batten-token'] !== token) {
      response.writeHead(403).end();
    } else if (request.method === 'GET' || request.method === 'HEAD') {
      state.heard += Number(request.method === 'HEAD');
      response.writeHead(200, { 'X-Batten-Name': encodeURIComponent(document.name), ETag: tagOf(state.bytes) });
      response.end(state.bytes);
    } else if (request.method === 'POST') {
      request.resume();
      if (state.beside) {
        response.writeHead(201, { 'X-Batten-Name': encodeURIComponent(state.beside) }).end();
      } else {
        response.writeHead(409, { 'Content-Type': 'text/plain' }).end('The folder is read-only.\n');
      }
    } else if (state.refused) {
      request.resume();
      response.writeHead(state.refused).end();
    } else if (request.headers['if-match'] !== tagOf(state.bytes)) {
      request.resume();
      response.writeHead(412).end();
    } else {
      const parts = [];
      request.on('data', (part) => parts.push(part));
      request.on('end', () => {
        state.bytes = Buffer.concat(parts);
        state.saves++;
        response.writeHead(200, { ETag: tagOf(state.bytes) }).end();
      });
    }
  }

  await new Promise((done) => server.listen(0, host, done));
  server.unref(); // a test that fails before closing it must not hang
  state.address = `http://${host}:${server.address().port}/`;
  state.close = () => {
    server.closeAllConnections();
    server.close();
  };
  return state;
}

/**
 * The program's own server, on a file in a separate folder. No bytes: the file does not exist yet.
 * @param {Buffer} bytes
 * @param {string} name
 * @param {string[]} words further arguments
 */
export async function edit(bytes, name, ...words) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-web-'));
  const file = path.join(folder, name);
  if (bytes.length > 0) {
    fs.writeFileSync(file, bytes);
  }
  const editor = {
    address: '',
    folder,
    program: /** @type {import('node:child_process').ChildProcess | null} */ (null),
    get bytes() {
      return fs.readFileSync(file);
    },
    set bytes(bytes) {
      fs.writeFileSync(file, bytes);
    },
    /** @param {string} other */
    beside: (other) => fs.readFileSync(path.join(folder, other)),
    /** On the same port, if it is free. */
    async start() {
      const program = spawn(PROGRAM, ['edit', file, '--no-open', ...words], { stdio: ['ignore', 'pipe', 'inherit'] });
      editor.program = program;
      editor.address = await new Promise((resolve, reject) => {
        program.on('error', reject);
        program.on('exit', (status) => reject(new Error(`batten edit ended with ${status}`)));
        program.stdout.on('data', (text) => resolve(String(text).trim()));
      });
    },
    /** Killed, without a chance to shut down. */
    async kill() {
      const gone = new Promise((resolve) => editor.program?.on('exit', resolve));
      editor.program?.kill('SIGKILL');
      await gone;
    },
    close() {
      editor.program?.kill();
      fs.rmSync(folder, { recursive: true, force: true });
    },
  };
  await editor.start();
  return editor;
}
