// Times the rows on surfaces as WebAssembly, and prints them as the other programs do. Usage: node module.mjs MODULE [FILTER]
import fs from 'node:fs';

const [modulePath, filter = ''] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(fs.readFileSync(modulePath), {});
const { memory, _initialize, name, unit, factor, begin, run, end } = instance.exports;
_initialize();

function cString(address) {
  const bytes = new Uint8Array(memory.buffer, address);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

const now = () => performance.now() / 1000;

/** As bench_measure of timing.h, after the compiler has had time to optimise. */
function measure(call) {
  for (const start = now(); now() - start < 0.3;) call();
  let repeat = 1;
  for (;; repeat *= 2) {
    const start = now();
    for (let i = 0; i < repeat; i++) call();
    if (now() - start > 2e-4) break;
  }
  const runs = [];
  for (const start = now(); runs.length < 400 && (runs.length < 5 || now() - start < 0.4);) {
    const from = now();
    for (let i = 0; i < repeat; i++) call();
    runs.push((now() - from) / repeat);
  }
  runs.sort((a, b) => a - b);
  return [runs[0], runs[Math.floor(runs.length / 2)]];
}

for (let row = 0; name(row); row++) {
  if (!cString(name(row)).includes(filter)) continue;
  const context = begin(row);
  if (!context) throw new Error(`${cString(name(row))}: cannot be set up`);
  const [best, median] = measure(() => run(row, context)).map((time) => Number((time * factor(row)).toPrecision(4)));
  end(row, context);
  console.log(JSON.stringify({ program: 'wasm', name: cString(name(row)), unit: cString(unit(row)), best, median, note: '' }));
}
