// The shell's module asks the host for nothing but its panic, starts, and is of this version. Usage: node module.mjs MODULE
import assert from 'node:assert/strict';
import fs from 'node:fs';

const bytes = fs.readFileSync(process.argv[2]);
const module = await WebAssembly.compile(bytes);
const panic = () => { throw new Error('panic'); };
const placeholders = {}; // for functions of the other part: web/module.js
const builds = new Set(); // what they are imported from: the name of the build
for (const need of WebAssembly.Module.imports(module))
  if (need.module === 'host') assert.deepEqual(need, { module: 'host', name: 'panic', kind: 'function' });
  else {
    placeholders[need.name] = panic;
    builds.add(need.module);
  }
const [build] = builds;
assert.equal(builds.size, 1);
assert.match(build, /^[0-9a-f]{12}$/);
const { exports } = await WebAssembly.instantiate(module, { host: { panic }, [build]: placeholders });

const second = await WebAssembly.compile(fs.readFileSync(process.argv[2].replace('.wasm', '-later.wasm')));
assert.ok(WebAssembly.Module.imports(second).every((need) => need.module === build && need.name in exports));
await WebAssembly.instantiate(second, { [build]: exports });
// Constants lie where the linker put them, in whichever part they come.
const whole = await WebAssembly.instantiate(fs.readFileSync(`${process.argv[2]}.whole`), { host: { panic } });
const memoryOf = (instance) => Buffer.from(instance.memory.buffer);
assert.ok(memoryOf(exports).equals(memoryOf(whole.instance.exports)));
exports._initialize();

const memory = new Uint8Array(exports.memory.buffer, exports.module_version());
const version = new TextDecoder().decode(memory.subarray(0, memory.indexOf(0)));
const header = fs.readFileSync(new URL('../../include/batten/base.h', import.meta.url), 'utf8');
assert.equal(version, /BAT_VERSION "(.*)"/.exec(header)[1]);

console.log(`${bytes.length} bytes`); // the bar is on the first load as a whole: tests/web/size.test.mjs
