// One program of units.wasm: its tests pass, and it computes what it computes natively, bit for bit.
// Usage: node units.mjs MODULE NATIVE ROOT NAME
import { execFileSync } from 'node:child_process';
import { Units } from './host.mjs';

const [modulePath, native, root, name] = process.argv.slice(2);
const units = new Units(modulePath, root);

let faults = 0;
for (let first = 0, run; (run = units.run(name, first)).failed; first = run.at + 1) {
  faults++;
  console.log(`test ${run.at}: ${run.failed}`);
  if (run.at < first) break;
}
if (faults === 0) {
  const [theirText, theirs] = execFileSync(native, ['run', name], { cwd: root, encoding: 'latin1', maxBuffer: 1 << 28 }).split('\nwitness\n');
  const text = Buffer.concat(units.printed).toString('latin1');
  const mine = units.witness();
  if (mine !== theirs || (text !== theirText && name !== 'test_real')) { // which prints how far libm is away
    faults++;
    console.log(`natively\n${theirText}\n${theirs}as WebAssembly\n${text}\n${mine}`);
  }
}
process.exit(faults ? 1 : 0);
