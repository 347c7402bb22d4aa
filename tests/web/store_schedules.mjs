// Schedules for the store of kept drawings on a disk that fails, tears, reorders and fills up, by seed: node store_schedules.mjs [COUNT].
// What was said to be kept is there afterwards, whatever happened, and nothing that was never drawn.
import assert from 'node:assert/strict';
import { Store } from '../../web/keep/store.js';
import { chance, Crash, Disk } from './disk_model.mjs';

const SCHEDULES = Number(process.argv[2] ?? 10000);
const encode = (text) => new TextEncoder().encode(text);
const linesOf = (journal) => new TextDecoder().decode(journal).split('\n').slice(0, -1);
const bytesOf = (lines) => encode(lines.map((line) => `${line}\n`).join(''));
const ID = (k) => `${k}`.padStart(24, 'abcdef');

/** A page that keeps one drawing as keep.js does, and what it was told is kept. */
class Page {
  constructor(store, random, serial) {
    Object.assign(this, { store, random, serial });
    this.journals = new Map(); // by id: what the page has done
    this.sure = new Map(); // by id: what was said to be kept
    this.names = new Map();
    this.ever = new Set(); // every line that was drawn
    this.lines = 0;
    this.open = false;
    this.id = '';
  }

  begin(id, journal = [`{"journal":"batten","name":"${id}"}`]) {
    [this.id, this.open] = [id, false];
    this.journals.set(id, journal);
    this.names.set(id, `drawing ${id}\u0007"\n`);
  }

  /** A stroke: its line is kept, or not. */
  async step() {
    const own = this.journals.get(this.id);
    const line = `{"do":"${this.serial}-${this.lines++}","n":"${'x'.repeat(Math.floor(this.random() * 60))}"}`;
    own.push(line);
    this.ever.add(line);
    await this.keep(own, [line]);
  }

  async keep(own, fresh) {
    try {
      if (this.open) {
        await this.store.append(this.id, bytesOf(fresh));
      } else {
        await this.store.begin({ id: this.id, name: this.names.get(this.id), place: '' }, bytesOf(own));
        this.open = true;
      }
      this.sure.set(this.id, own.length);
    } catch (error) {
      this.open = false;
      if (error instanceof Crash) {
        throw error;
      }
    }
  }

  /** The engine writes its journal anew. */
  async compact() {
    const own = [...this.journals.get(this.id)];
    this.open = false;
    await this.keep(own, []);
  }
}

/** What is on the disk is what was said to be kept, and no line that was not drawn; each of it whole, or said not to be. */
async function compare(disk, page, seed) {
  const store = new Store(disk);
  const listed = new Map((await store.list()).map((one) => [one.id, one]));
  for (const [id, sure] of page.sure) {
    assert.ok(listed.has(id), `${seed}: ${id} is listed`);
    const kept = await store.take(id);
    const lines = linesOf(kept.journal);
    const drawn = page.journals.get(id);
    assert.ok(lines.length >= sure, `${seed}: ${lines.length} of ${sure} lines`);
    const known = lines.findIndex((line, i) => line !== drawn[i]);
    assert.ok(known < 0 || (known >= sure && (!kept.whole || page.ever.has(lines[known]))), `${seed}: line ${known} of ${lines.length}, sure of ${sure}: ${lines[known]}`);
    assert.equal(kept.name, page.names.get(id), `${seed}`);
  }
}

const seen = { crashes: 0, faults: 0, full: 0, lines: 0 };
for (let seed = 1; seed <= SCHEDULES; seed++) {
  const random = chance(seed);
  const disk = new Disk(random);
  let page = new Page(new Store(disk, () => 0), random, seed);
  page.begin(ID(0));
  for (let phase = 0; phase < 3; phase++) {
    disk.faults = random() < 0.3 ? 0.1 * random() : 0;
    disk.capacity = random() < 0.2 ? [...disk.seen.values()].reduce((sum, { length }) => sum + length, 0) + 800 * random() : Infinity;
    disk.crashAt = random() < 0.7 ? Math.floor(60 * random()) : Infinity;
    seen.full += Number(disk.capacity < Infinity);
    seen.faults += Number(disk.faults > 0);
    try {
      for (let k = 0; k < 8; k++) {
        const what = random();
        if (what < 0.7) {
          await page.step();
        } else if (what < 0.85) {
          await page.compact();
        } else {
          page.begin(ID(page.journals.size));
        }
      }
      if (random() < 0.3) {
        await page.store.mark(page.id, 'aside', true).catch((error) => {
          if (error instanceof Crash) {
            throw error;
          }
        });
      }
    } catch (error) {
      if (!(error instanceof Crash)) {
        throw error;
      }
      seen.crashes++;
    }
    [disk.faults, disk.capacity, disk.crashAt] = [0, Infinity, Infinity];
    await compare(disk, page, `${seed}.${phase} before`); // another tab looks
    if (random() < 0.7) {
      disk.crash();
      await compare(disk, page, `${seed}.${phase} after`);
    }
    // Another page, which goes on with what is there.
    const next = new Page(new Store(disk, () => 0), random, `${seed}-${phase}`);
    [next.sure, next.journals, next.names, next.ever] = [page.sure, page.journals, page.names, page.ever];
    page = next;
    const kept = page.sure.has(ID(0)) ? await page.store.take(ID(0)) : null;
    if (kept?.whole) {
      page.begin(ID(0), linesOf(kept.journal));
    } else {
      page.begin(ID(page.journals.size));
    }
    seen.lines += [...page.sure.values()].reduce((sum, count) => sum + count, 0);
  }
}
assert.ok(seen.crashes > 0.5 * SCHEDULES && seen.faults > 0.5 * SCHEDULES && seen.full > 0.3 * SCHEDULES && seen.lines > 10 * SCHEDULES, JSON.stringify(seen));
console.log(JSON.stringify({ schedules: SCHEDULES, ...seen }));
