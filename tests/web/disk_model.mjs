// A disk as the store of kept drawings must be able to bear it: calls fail, writes fall short when it is full, and a crash keeps
// of what was not flushed any part, in any order. By a seed, so that each run can be repeated.

/** Numbers by chance, the same for the same seed. @param {number} seed @returns {() => number} 0..1 */
export function chance(seed) {
  let state = (seed * 2654435761) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state >>>= 0;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 4294967296;
  };
}

export class Crash extends Error {}

export class Disk {
  /** @param {() => number} random */
  constructor(random) {
    this.random = random;
    /** What is on the disk for good. @type {Map<string, Uint8Array>} */
    this.files = new Map();
    /** What has been done since it was flushed. file: made now; bytes: null: removed. @type {{ name: string, bytes: Uint8Array | null, at: number }[]} */
    this.pending = [];
    /** What is seen, as of so many pending. */
    this.sight = new Map();
    this.looked = -1;
    this.capacity = Infinity;
    this.faults = 0; // share of calls that fail
    this.crashAt = Infinity; // calls until the machine stops
    this.clock = 0;
    /** @type {Map<string, number>} */
    this.times = new Map();
  }

  /** A call begins: it may fail, or be the last one. */
  #call() {
    this.clock++;
    if (--this.crashAt < 0) {
      throw new Crash('the machine stopped');
    }
    if (this.random() < this.faults) {
      throw new Error('the disk refused');
    }
  }

  /** What a program sees now: all that was done, flushed or not. @returns {Map<string, Uint8Array>} */
  get seen() {
    if (this.pending.length !== this.looked) {
      this.sight = new Map(this.files);
      this.pending.forEach((one) => apply(this.sight, one));
      this.looked = this.pending.length;
    }
    return this.sight;
  }

  /** Notes what is done. @param {{ name: string, bytes: Uint8Array | null, at: number }} one */
  #do(one) {
    const { seen } = this;
    apply(seen, one);
    this.looked = this.pending.push(one);
  }

  /** The machine stops and starts again: of what was not flushed, any part has reached the disk. */
  crash() {
    const left = this.pending.filter(() => this.random() < 0.5);
    if (this.random() < 0.5) {
      left.sort(() => this.random() - 0.5);
    }
    for (const one of left) {
      const torn = one.bytes && this.random() < 0.4;
      const size = one.bytes?.length ?? 0;
      const [from, to] = torn ? [0, size].map((end) => (this.random() < 0.5 ? end : Math.floor(this.random() * size))).sort((a, b) => a - b) : [0, size];
      apply(this.files, one.bytes ? { ...one, bytes: one.bytes.slice(from, to), at: one.at + from } : one);
    }
    this.pending = [];
    this.looked = -1;
    this.crashAt = Infinity;
  }

  // ---- the calls of a room ----

  async names() {
    this.#call();
    return [...this.seen.keys()];
  }

  async has(name) {
    this.#call();
    return this.seen.has(name);
  }

  async time(name) {
    this.#call();
    return this.times.get(name) ?? 0;
  }

  async read(name, size) {
    this.#call();
    const bytes = this.seen.get(name);
    if (!bytes) {
      throw new Error(`${name} is not there`);
    }
    return bytes.slice(0, size);
  }

  async open(name) {
    this.#call();
    if (!this.seen.has(name)) {
      this.#do({ name, bytes: new Uint8Array(0), at: 0 });
    }
    return {
      write: async (bytes, at) => {
        this.#call();
        const used = [...this.seen.values()].reduce((sum, { length }) => sum + length, 0);
        const room = Math.max(0, this.capacity - used);
        const part = bytes.slice(0, room);
        this.#do({ name, bytes: part, at });
        this.times.set(name, this.clock);
        return part.length;
      },
      read: async () => {
        this.#call();
        return this.seen.get(name)?.slice() ?? new Uint8Array(0);
      },
      flush: async () => {
        this.#call();
        const own = this.pending.filter((one) => one.name === name);
        own.forEach((one) => apply(this.files, one));
        this.pending = this.pending.filter((one) => one.name !== name);
        this.looked = this.pending.length;
      },
      close: async () => this.#call(),
    };
  }

  async remove(name) {
    this.#call();
    if (!this.seen.has(name)) {
      throw new Error(`${name} is not there`);
    }
    this.#do({ name, bytes: null, at: 0 });
  }
}

/** @param {Map<string, Uint8Array>} files @param {{ name: string, bytes: Uint8Array | null, at: number }} done */
function apply(files, { name, bytes, at }) {
  if (!bytes) {
    files.delete(name);
    return;
  }
  const before = files.get(name) ?? new Uint8Array(0);
  const after = new Uint8Array(Math.max(before.length, at + bytes.length));
  after.set(before);
  after.set(bytes, at);
  files.set(name, after);
}
