// label: smoke. The store of kept drawings on a disk that fails, tears, reorders and fills up, without a browser: ten thousand
// schedules by seed. What was said to be kept is there afterwards, whatever happened; what is damaged is said to be.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { endOf, headOf, joined, read, recordsOf } from '../../web/keep/records.js';
import { copy, rename } from '../../web/keep/manage.js';
import { Store } from '../../web/keep/store.js';
import { chance, Disk } from './disk_model.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const encode = (text) => new TextEncoder().encode(text);
const decode = (bytes) => new TextDecoder().decode(bytes);
const linesOf = (journal) => decode(journal).split('\n').slice(0, -1);
const bytesOf = (lines) => encode(lines.map((line) => `${line}\n`).join(''));
const ID = (k) => `${k}`.padStart(24, 'abcdef');

test('ten thousand schedules: what was said to be kept is kept', () => {
  // In a process of its own: a runner of tests follows each promise, which takes most of the time.
  const { stdout, stderr, status } = spawnSync(process.execPath, [path.join(HERE, 'store_schedules.mjs')], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  assert.equal(JSON.parse(stdout).schedules, 10000);
});

const SAMPLE = ['{"journal":"batten","version":1,"name":"a"}', ...Array.from({ length: 40 }, (_, k) => (k % 7 === 6 ? '{"do":"undo","digest":"0123456789abcdef"}' :
  `{"do":"sketch-new","object":${k},"stroke":[${'1.5,'.repeat(k % 11)}2]}`))];
const HEAD = { id: ID(1), name: 'a', place: '' };
const file = () => {
  const { bytes, number } = recordsOf(bytesOf(SAMPLE), 1);
  return joined([headOf(HEAD), bytes, endOf(number)]);
};

test('a file reads back as it was written; a byte that changes costs one line, and is noticed', () => {
  const whole = file();
  const back = read(whole);
  assert.deepEqual([linesOf(back.journal), back.whole, back.head], [SAMPLE, true, HEAD]);
  for (let at = 0; at < whole.length; at++) {
    for (const change of [1, 0x20, 0x80]) {
      const bytes = whole.slice();
      bytes[at] ^= change;
      const { journal, whole: said } = read(bytes);
      const lines = linesOf(journal);
      const there = SAMPLE.filter((line) => lines.includes(line)).length;
      assert.equal(said, false, `byte ${at}`);
      assert.ok(there >= SAMPLE.length - 1, `byte ${at}: ${there} lines`);
      assert.ok(lines.length >= SAMPLE.length - 1 && lines.length <= SAMPLE.length, `byte ${at}: ${lines.length} lines`);
      // An undo is taken for what it was, and what is missing has its place.
      lines.forEach((line, i) => assert.ok(i === 0 || line === SAMPLE[i] || line === '{"spoilt":true}' || line === '{"do":"undo"}', `byte ${at}: ${line}`));
    }
  }
});

test('a file that is cut anywhere gives the lines before, and says so; one with a hole those around it', () => {
  const whole = file();
  for (let size = 0; size < whole.length; size++) {
    const { journal, whole: said } = read(whole.slice(0, size));
    assert.equal(said, false, `${size} bytes`);
    const lines = linesOf(journal);
    assert.deepEqual(lines, SAMPLE.slice(0, lines.length), `${size} bytes`);
  }
  const random = chance(7);
  for (let k = 0; k < 500; k++) {
    const from = Math.floor(random() * whole.length);
    const bytes = whole.slice();
    bytes.fill(0, from, from + 300);
    const { journal, whole: said } = read(bytes);
    assert.equal(said, false);
    const missing = SAMPLE.filter((line) => !linesOf(journal).includes(line)).length;
    assert.ok(missing <= 14, `${missing} lines in a hole of 300 bytes`);
  }
});

test('nothing that is not of the store is a drawing; whatever a file holds, it is read in time', async () => {
  const disk = new Disk(chance(3));
  for (const name of ['readme.txt', 'abcdefab.x', '.1', 'abcdefabcdef.aside', `${ID(2)}.3`, `${ID(3)}.1`]) {
    disk.files.set(name, encode('#J 1 9007199254740991 00000000\n'.repeat(2000)));
  }
  const list = await new Store(disk).list();
  assert.deepEqual(list.map(({ id, broken }) => [id, broken]).sort(), [[ID(2), true], [ID(3), true]]);
  const kept = await new Store(disk).take(ID(2));
  assert.deepEqual([kept.whole, kept.broken, kept.journal.length, kept.raw.length > 1000], [false, true, 0, true]);
});

test('what the user deleted can be brought back, makes room, and is gone a month later', async () => {
  const disk = new Disk(chance(4));
  let now = 0;
  const store = new Store(disk, () => now);
  const journal = bytesOf(SAMPLE);
  await store.begin({ ...HEAD, id: ID(1) }, journal);
  await store.begin({ ...HEAD, id: ID(2) }, journal);
  await store.mark(ID(1), 'gone', true);
  assert.deepEqual((await store.list()).map(({ gone }) => gone).sort(), [false, true]);
  await store.mark(ID(1), 'gone', false);
  assert.ok((await store.list()).every(({ gone }) => !gone));
  await store.mark(ID(1), 'gone', true);
  assert.equal(await store.purge(), 0);
  disk.capacity = [...disk.seen.values()].reduce((sum, { length }) => sum + length, 0) + 20;
  await store.begin({ ...HEAD, id: ID(3) }, journal);
  assert.deepEqual((await store.list()).map(({ id }) => id).sort(), [ID(2), ID(3)], 'it made room');
  await store.mark(ID(2), 'gone', true);
  now = 31 * 24 * 3600 * 1000;
  assert.equal(await store.purge(), 1);
  assert.deepEqual((await store.list()).map(({ id }) => id), [ID(3)]);
});

test('a name and a copy change no byte of what is kept; torn at any place they are there or not', async () => {
  const disk = new Disk(chance(11));
  const store = new Store(disk);
  await store.begin(HEAD, bytesOf(SAMPLE));
  const { raw } = await store.take(HEAD.id);
  await rename(store, HEAD.id, 'a longer name');
  await rename(store, HEAD.id, 'b');
  assert.deepEqual(await store.take(HEAD.id).then((kept) => [kept.name, linesOf(kept.journal), kept.whole, kept.raw]), ['b', SAMPLE, true, raw]);
  await store.append(HEAD.id, bytesOf(['{"do":"undo"}'])); // its file is open as before
  await copy(store, { ...HEAD, id: ID(2), name: 'b copy' }, HEAD.id);
  await copy(store, { ...HEAD, id: ID(3), name: 'c' }, bytesOf(SAMPLE));
  await store.append(HEAD.id, bytesOf(['{"do":"redo"}']));
  assert.deepEqual((await store.list()).map(({ name }) => name).sort(), ['b', 'b copy', 'c']);
  assert.deepEqual(linesOf((await store.take(ID(2))).journal), [...SAMPLE, '{"do":"undo"}']);
  assert.deepEqual(linesOf((await store.take(HEAD.id)).journal), [...SAMPLE, '{"do":"undo"}', '{"do":"redo"}']);
  // Begun anew it is called as its head says.
  await store.begin({ ...HEAD, name: 'd' }, bytesOf(SAMPLE));
  assert.equal((await store.take(HEAD.id)).name, 'd');
  await rename(store, HEAD.id, 'e');
  const put = (name, bytes) => {
    disk.files = new Map([...disk.seen, [name, bytes]]);
    disk.pending = [];
    disk.looked = -1;
  };
  const whole = disk.seen.get(`${HEAD.id}.name`).slice();
  const seen = new Set();
  for (let size = 0; size <= whole.length; size++) {
    put(`${HEAD.id}.name`, whole.slice(0, size));
    const { name, journal } = await new Store(disk).take(HEAD.id);
    seen.add(name);
    assert.deepEqual(linesOf(journal), SAMPLE);
  }
  assert.deepEqual([...seen], ['d', 'e']);
  // What is damaged is not copied, and what is deleted leaves no name.
  put(`${ID(2)}.1`, disk.seen.get(`${ID(2)}.1`).map((byte, at) => byte ^ Number(at === 200)));
  await assert.rejects(copy(new Store(disk), { ...HEAD, id: ID(4) }, ID(2)));
  await assert.rejects(rename(store, ID(9), 'x'));
  await store.remove(HEAD.id);
  assert.deepEqual((await disk.names()).filter((name) => name.startsWith(HEAD.id) || name.startsWith(ID(4))), []);
});
