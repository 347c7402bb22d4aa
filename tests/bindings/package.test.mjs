// npm pack, then a fresh project without a network: Node, a bundle of esbuild, types.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const project = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-npm-'));
after(() => fs.rmSync(project, { recursive: true }));
const run = (command, ...args) => execFileSync(command, args, { cwd: project, encoding: 'utf8', env: { ...process.env, npm_config_cache: path.join(project, 'cache'), npm_config_update_notifier: 'false' } });
const write = (name, text) => fs.writeFileSync(path.join(project, name), text);

const USE = `const b = await load();
const curve = b.fit([[0, 0], [10, 8], [20, 10], [30, 8], [40, 0]], { tolerance: 0.5 });
const live = b.live({ tolerance: 1 });
for (let x = 0; x < 60; x++) live.add(x, 9 * Math.sin(x / 9));
console.log(curve.count, live.preview().count > 3, live.commit().toSVG().startsWith('M0 0C'));`;

test('packed, installed into a fresh project and used', async (t) => {
  run('npm', 'init', '-y');
  const packed = run('npm', 'pack', '--silent', path.join(root, 'build/wasm/npm/batten-core')).trim();
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', path.join(project, packed));
  const folder = path.join(project, 'node_modules/batten-core');
  const files = fs.readdirSync(folder).sort();

  await t.test('everything is in it, nothing else', () => {
    assert.deepEqual(files, ['LICENSE', 'README.md', 'adapters', 'bare.d.ts', 'bare.js', 'batten-levels.wasm', 'batten-levels.wasm.js', 'batten-sketch.wasm',
      'batten-sketch.wasm.js', 'batten.wasm', 'batten.wasm.js', 'call.js', 'core.js', 'documents.js', 'error.js', 'given.js', 'index.d.ts', 'index.js', 'levels.d.ts', 'levels.js', 'library.js', 'memory.js',
      'more.js', 'package.json', 'path.js', 'plan.js', 'sketch.d.ts', 'sketch.js', 'source.js', 'space.js', 'structs.js', 'whole.js', 'xml.js']);
    const told = JSON.parse(fs.readFileSync(path.join(project, 'node_modules/batten-core/package.json'), 'utf8'));
    assert.equal(told.dependencies, undefined);
    assert.ok(fs.readFileSync(path.join(root, 'include/batten/base.h'), 'utf8').includes(`"${told.version}"`));
  });
  await t.test('the sample of its README runs', () => {
    const [sample] = /```js\n([^]*?)```/.exec(fs.readFileSync(path.join(project, 'node_modules/batten-core/README.md'), 'utf8')).slice(1);
    write('readme.mjs', sample);
    assert.match(run('node', 'readme.mjs'), /^\d+ 0\.\d+ M[-\d. ]+C/);
  });
  await t.test('from Node', () => {
    write('use.mjs', `import { load } from 'batten-core';\n${USE}`);
    assert.match(run('node', 'use.mjs'), /^\d true true\n$/);
    write('adapters.mjs', `import fitCurve from 'batten-core/fit-curve';\nimport getStroke from 'batten-core/freehand';
console.log(fitCurve([[0, 0], [5, 5], [10, 0]], 1).length > 0, getStroke([[0, 0], [5, 5], [10, 0]]).length > 9);`);
    assert.equal(run('node', 'adapters.mjs'), 'true true\n');
  });
  await t.test('through a bundle of esbuild for browsers, with no options and nothing beside it', () => {
    for (const [name, word] of [['use', ''], ['small', '/sketch']]) {
      write(`${name}.mjs`, `import { load } from 'batten-core${word}';\n${USE}`);
      run('esbuild', `${name}.mjs`, '--bundle', '--minify', '--format=esm', `--outfile=out/${name}.mjs`);
      assert.match(run('node', `out/${name}.mjs`), /^\d true true\n$/);
    }
    const [whole, small] = ['use', 'small'].map((name) => fs.statSync(path.join(project, `out/${name}.mjs`)).size);
    assert.ok(small < 0.6 * whole, 'only the module that is asked for goes along');
  });
  await t.test('what is served in place of a module is named', async () => {
    const server = http.createServer((_, response) => response.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html>'));
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    const { load } = await import(path.join(project, 'node_modules/batten-core/index.js'));
    await assert.rejects(load({ wasm: `http://127.0.0.1:${server.address().port}/batten.wasm` }), { status: 'state', message: /batten\.wasm is no WebAssembly but text\/html\. load\(\{ wasm \}\) takes/ });
    server.close();
  });
  await t.test('its types have comments, and no any', () => {
    const declared = fs.readdirSync(folder, { recursive: true }).filter((name) => name.endsWith('.d.ts'));
    for (const name of declared) {
      const types = fs.readFileSync(path.join(folder, name), 'utf8');
      assert.doesNotMatch(types.replace(/\/\*[^]*?\*\/|\/\/.*/g, ''), /\bany\b/, name);
      for (const [, before, what] of types.matchAll(/(.*)\n(export (?:declare )?(?:class|function|interface|type) \w+|declare function \w+)/g)) {
        assert.match(before, /\*\/$/, `${name}: ${what}`);
      }
      for (const [, kind, body] of types.matchAll(/export class (\w+) [^{]*\{([^]*?)\n\}/g)) {
        for (const [, before, member] of body.matchAll(/(.*)\n {2}(?:readonly )?(\w+\??|\[Symbol\.dispose\])[(:<]/g)) {
          assert.ok(/\*\/$/.test(before), `${kind}.${member}`);
        }
      }
    }
    assert.ok(declared.length > 5);
  });
  await t.test('each function and class of its scripts has a comment, and no type any', () => {
    const scripts = fs.readdirSync(folder, { recursive: true }).filter((name) => /(?<!\.wasm)\.js$/.test(name) && name !== 'core.js' && name !== 'more.js');
    for (const name of scripts) {
      const text = fs.readFileSync(path.join(folder, name), 'utf8');
      assert.doesNotMatch(text, /\{any\}|\bany>/, name);
      const begins = /(.*)\n(?:export )?(?:default )?(?:async )?(?:function|class) (\w+)|(.*)\n(?:export )?const (\w+) = (?:async )?(?:\([^()]*\)|\w+) =>|(.*)\n {2}(?:static |async |get |set )*([#\w]+)\(.*\) \{\n/g;
      for (const [, ...found] of text.matchAll(begins)) {
        const [before, what] = found.filter((one) => one !== undefined);
        assert.ok(/\*\/$/.test(before) || /^(constructor|if|for|while|switch)$/.test(what), `${name}: ${what}`);
      }
    }
  });
  await t.test('with types', () => {
    write('use.mts', `import { load, BattenError, type Curve } from 'batten-core';
import fitCurve from 'batten-core/fit-curve';
const b = await load();
const curve: Curve = b.fit([[0, 0], [1, 2], [3, 4]], { tolerance: 0.5, holdEnds: true });
const error: number = b.fit(new Float64Array(8)).report.maxError;
const shape = curve.levels(2, { frame: 'rmf' }).drag(0, 0.5, [0, 1]);
const [left, right] = curve.split(0.5);
const path: string = left.join(right, { continuity: 1 }).toSVG();
const pieces: number[][][] = fitCurve([[0, 0], [1, 1]], 1);
try { curve.nearest([0, 0]).distance.toFixed(error); } catch (caught) { if (caught instanceof BattenError && caught.status === 'far') throw caught; }
{ using kept = curve.copy(); kept.free(); }
// @ts-expect-error: no such option
b.fit([0, 0, 1, 1], { tolerence: 1 });
// @ts-expect-error: no such word
curve.levels(2, { frame: 'none' });
export { shape, path, pieces };`);
    write('bare.mts', `import { load } from 'batten-core/bare';
export const count: number = (await load({ wasm: new Uint8Array(8) })).fit([0, 0, 1, 1, 2, 0]).count;
// @ts-expect-error: there is no module inside
export const none = load();`); // where there is no DOM
    write('using.mts', `import { load, BattenError } from 'batten-core';
const b = await load();
const held = [];
{
  using curve = b.fit([[0, 0], [1, 2], [3, 4]]);
  using numbers = b.array(9);
  held.push(() => curve.count, () => numbers.values);
}
console.log(held.map((look) => { try { return look(); } catch (error) { return error instanceof BattenError && error.status; } }).join());`);
    run(path.join(root, 'tests/web/node_modules/.bin/tsc'), '--outDir', 'typed', '--strict', '--target', 'es2022', '--module', 'nodenext', '--lib', 'es2022,dom', 'use.mts', 'using.mts');
    assert.equal(run('node', 'typed/using.mjs'), 'state,state\n', 'using frees');
    run(path.join(root, 'tests/web/node_modules/.bin/tsc'), '--noEmit', '--strict', '--target', 'es2022', '--module', 'nodenext', '--lib', 'es2022', 'bare.mts');
  });
});
