// Files through a reader natively and as WebAssembly: what was computed is the same, bit for bit.
// Usage: node corpus.mjs MODULE NATIVE ROOT fuzz|svg|journal|text|icons
import fs from 'node:fs';
import path from 'node:path';
import { execFileSync } from 'node:child_process';
import { Units } from './host.mjs';

const [modulePath, native, root, kind] = process.argv.slice(2);
const ICONS = { folder: '/usr/share/icons', wanted: 300 }; // tools/packages.sh installs more than these

/** Files below a folder, links left out, in order of their names. @param {RegExp} name */
function below(folder, name) {
  if (!fs.existsSync(folder)) return [];
  return fs.readdirSync(folder, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1)).flatMap((entry) => {
    const whole = path.join(folder, entry.name);
    if (entry.isDirectory()) return /^(\.git|build|node_modules)$/.test(entry.name) ? [] : below(whole, name);
    return entry.isFile() && name.test(entry.name) ? [whole] : [];
  });
}

/** Those with a transform first: they ask most of the reader. */
function icons() {
  const all = below(ICONS.folder, /\.svg$/);
  const moved = all.filter((file) => fs.readFileSync(file, 'utf8').includes('transform='));
  const rest = all.filter((file) => !moved.includes(file));
  const few = [...moved, ...rest].slice(0, ICONS.wanted);
  if (few.length < ICONS.wanted) throw new Error(`only ${few.length} SVG files below ${ICONS.folder}, not ${ICONS.wanted}`);
  console.log(`${Math.min(moved.length, few.length)} of ${few.length} with transforms`);
  return few;
}

/** @type {Record<string, () => [string, string[]][]>} reader, its files */
const sets = {
  fuzz: () => fs.readdirSync(path.join(root, 'fuzz')).filter((file) => file.endsWith('.c'))
    .map((file) => [file.slice(0, -2), below(path.join(root, 'fuzz/corpus', file.slice(5, -2)), /./)]),
  svg: () => [['svg', below(root, /\.svg$/)]],
  journal: () => [['journal', [...below(root, /\.journal$/), ...below(path.join(root, 'fuzz/corpus/journal'), /./)]]],
  text: () => [['text', [...below(root, /\.(csv|json|jsonl|batten)$/), ...below(path.join(root, 'fuzz/corpus'), /./)]]],
  icons: () => [['svg', icons()]],
};

const units = new Units(modulePath, root);
let count = 0;
let faults = 0;
for (const [reader, files] of sets[kind]()) {
  if (files.length === 0) continue;
  const theirs = execFileSync(native, ['read', reader, ...files], { encoding: 'utf8', maxBuffer: 1 << 28 })
    .split('\nwitness\n').slice(1);
  files.forEach((file, i) => {
    const { value: mine, failed } = units.read(reader, fs.readFileSync(file));
    count++;
    if (mine === theirs[i]) return;
    faults++;
    console.log(`${reader} ${path.relative(root, file)}\nnatively\n${theirs[i]}as WebAssembly\n${failed ?? mine}`);
  });
}
console.log(`${count} files, ${faults} differ`);
process.exit(faults || count === 0 ? 1 : 0);
