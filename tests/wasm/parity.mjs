// The vectors natively and as WASM agree bit for bit. Usage: node parity.mjs MODULE NATIVE...
import fs from 'node:fs';
import { execFileSync } from 'node:child_process';

const [modulePath, ...natives] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(fs.readFileSync(modulePath), {});
const { memory, _initialize, sections, name, run, values } = instance.exports;
_initialize();

function cString(address) {
  const bytes = new Uint8Array(memory.buffer, address);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

const ours = [];
for (let i = 0; i < sections(); i++) {
  const count = run(i);
  if (count < 0) throw new Error(`${cString(name(i))}: no room`);
  ours.push({ name: cString(name(i)), bits: new BigUint64Array(memory.buffer.slice(values(), values() + 8 * count)) });
}

const view = new DataView(new ArrayBuffer(8));
const real = (bits) => (view.setBigUint64(0, bits), view.getFloat64(0));
let faults = natives.length === 0 ? 1 : 0;
for (const native of natives) {
  const lines = execFileSync(native, { encoding: 'utf8', maxBuffer: 1 << 28 }).trim().split('\n');
  if (lines.length !== ours.length) (faults++, console.log(`${native}: ${lines.length} sections, not ${ours.length}`));
  lines.forEach((line, i) => {
    const [title, rest] = line.split(':');
    const theirs = rest.trim().split(' ').map((word) => BigInt(`0x${word}`));
    const mine = ours[i];
    let different = 0;
    let first = -1;
    // A NaN's payload and sign carry nothing.
    for (let k = 0; k < Math.max(theirs.length, mine.bits.length); k++)
      if (theirs[k] !== mine.bits[k] &&
        !(k < theirs.length && k < mine.bits.length && isNaN(real(theirs[k])) && isNaN(real(mine.bits[k])))) {
        if (first < 0) first = k;
        different++;
      }
    console.log(`${title}: ${theirs.length} numbers, ${different} differ`);
    if (theirs.length < 50) (faults++, console.log('  too few: the section gave up'));
    if (different) {
      faults++;
      console.log(`  first at ${first}: ${native} ${real(theirs[first] ?? 0n)}, WASM ${real(mine.bits[first] ?? 0n)}`);
    }
  });
}
process.exit(faults ? 1 : 0);
