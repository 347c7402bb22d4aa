// The host of units.wasm: files of the repository, standard output, and an end when a test fails.
import fs from 'node:fs';
import path from 'node:path';

class Stop extends Error {}

export class Units {
  constructor(file, root) {
    this.module = new WebAssembly.Module(fs.readFileSync(file));
    this.root = root;
    this.start();
  }

  start() {
    /** @type {Buffer[]} what was written to standard output */
    this.printed = [];
    const host = {
      stop: (why) => { throw new Stop(this.string(why)); },
      read: (name, to, room) => {
        const file = path.join(this.root, this.string(name));
        if (!fs.existsSync(file)) return -1;
        const bytes = fs.readFileSync(file);
        if (bytes.length <= room) this.bytes(to, bytes.length).set(bytes);
        return bytes.length;
      },
    };
    // Of a system there is standard output; the rest is not there.
    const system = new Proxy({ fd_write: this.write.bind(this) }, {
      get: (known, call) => known[call] ?? ((...values) => {
        if (call === 'proc_exit') throw new Stop(`exit ${values[0]}`);
        return 52; // ENOSYS
      }),
    });
    this.exports = new WebAssembly.Instance(this.module, { host, wasi_snapshot_preview1: system }).exports;
    this.exports._initialize();
  }

  bytes(at, size) { return new Uint8Array(this.exports.memory.buffer, at, size); }

  string(at) {
    const all = new Uint8Array(this.exports.memory.buffer, at);
    return new TextDecoder().decode(all.subarray(0, all.indexOf(0)));
  }

  write(file, parts, count, written) {
    const view = new DataView(this.exports.memory.buffer);
    let sum = 0;
    for (let i = 0; i < count; i++) {
      const size = view.getUint32(parts + 8 * i + 4, true);
      this.printed.push(Buffer.from(this.bytes(view.getUint32(parts + 8 * i, true), size)));
      sum += size;
    }
    view.setUint32(written, sum, true);
    return 0;
  }

  // Calls an export: what it gave, or why it ended.
  attempt(call) {
    try {
      return { value: call(this.exports) };
    } catch (error) {
      if (!(error instanceof Stop) && !(error instanceof WebAssembly.RuntimeError)) throw error;
      return { failed: error instanceof Stop ? error.message : error.stack };
    }
  }

  // A program from one of its tests on, in an instance of its own.
  run(name, first) {
    this.start();
    this.put(this.exports.text(), Buffer.from(`${name}\0`));
    const { value, failed } = this.attempt((module) => module.run(first));
    this.attempt((module) => module.flush());
    return { at: this.exports.at(), failed: failed ?? (value ? `returned ${value}` : '') };
  }

  // What the witness saw of one file in a reader (corpus.h).
  read(reader, bytes) {
    const outcome = this.attempt((module) => {
      this.put(module.text(), Buffer.from(`${reader}\0`));
      const at = module.room(bytes.length + 1);
      if (at === 0) throw new Stop('no memory');
      this.put(at, Buffer.concat([bytes, Buffer.from([0])]));
      if (!module.read(at, bytes.length)) throw new Stop('no such reader');
      return this.witness();
    });
    if (outcome.failed) this.start();
    return outcome;
  }

  put(at, bytes) { this.bytes(at, bytes.length).set(bytes); }

  witness() { return this.string(this.exports.witness()); }
}
