// Wrong things given to every function of batten-core, by chance but always the same: whatever may happen, nothing but a
// BattenError is thrown, the module does not trap, and the library goes on working. tests/bindings/misuse.py does it for Python, argument by
// argument, under the address sanitizer too.
import assert from 'node:assert/strict';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const { load, BattenError } = await import(path.join(root, 'build/wasm/npm/batten-core/index.js'));
const b = await load();
const TRIES = 20; // of each function
const SLOW = new Set(['spread', 'array']); // give as much as one asks for

const PNG = Uint8Array.from([137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 2, 0, 0, 0, 3, 8, 2, ...Array(24).fill(0)]);

let state = 12345;
const chance = (below) => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return Math.floor((state / 2 ** 32) * below);
};
const one = (list) => list[chance(list.length)];

/** One of each class, fresh. */
function things() {
  const curve = b.fit(Array.from({ length: 41 }, (_, i) => [i / 2, Math.sin(i / 2)]), { tolerance: 0.01 });
  const space = curve.toDimension(3);
  const surface = b.loft([0, 1, 2].map((height) => space.transform([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, height])));
  const shape = curve.levels(2);
  const take = b.take([{ name: 'hip', parent: -1, offset: [0, 0, 0], channels: ['x_position', 'z_rotation'] }], [[0, 1], [1, 3], [2, 4], [3, 3]], 0.1);
  const document = b.document();
  document.add(b.pathObject([curve]));
  const live = curve.live();
  live.add(1, 1);
  const freed = curve.copy();
  freed.free();
  return [curve, space, surface, shape, take, document, live, freed, curve.finder(), curve.frameChain(), shape.live(0), surface.finder(), surface.tessellate(),
    surface.levels(1), space.sweep(b.clamped([[-1, 0], [0, 1], [1, 0]], { degree: 2 })), b.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], { faces: [[0, 1, 2]] }),
    b.reference({ curves: [space] }), b.bind([{ reference: space, radius: 3 }], [[0, 0, 0]]), surface.section([0, 0, 1], [0, 0, 1]),
    b.lineDrawing({ eye: [10, -50, 30], target: [10, 0, 1], fov: 40 }, surface), space.camera({ mode: 'along' }), take.motion(), document.at(0),
    b.picture(PNG)];
}

const PLAIN = [undefined, null, NaN, Infinity, -Infinity, 0, 1, 2, 3, -1, 0.5, 1e300, 2 ** 31, 2 ** 53, 10n, '', 'zzz', 'u', '{', true, false, Symbol('s'), () => 0, new Date(0), new Map(),
  [], [[]], [null], [1], [1, 2], [1, 2, 3], [0, 0, 1], [[0, 0], [1, 1], [2, 0]], [[0, 0, 0], [1, 1, 1]], [[1, 2], [3]], ['a'], [NaN, 1], [[1e300, 1e300], [-1e300, 0]],
  Array(50).fill(0), new Float64Array(4), new Float32Array(3), new Uint8Array(8), new DataView(new ArrayBuffer(8)), new ArrayBuffer(9), {}, { points: 3 }, { zzz: 1 }, { x: 1, y: 2 },
  { tolerance: 'a' }, { dimension: 7 }, { dimension: 3 }, { degree: 1e9 }, { order: 1e8 }, { into: 3 }, { curves: [1] }, { get points() { throw new BattenError('argument', 'a getter'); } }];

test('whatever is given, a BattenError or a result', () => {
  const faults = new Set();
  let tries = 0;
  const kinds = [...Object.values(b.tables.kinds).map((kind) => kind.prototype), Object.getPrototypeOf(b)];
  for (const prototype of kinds) {
    for (const name of Object.getOwnPropertyNames(prototype).filter((own) => own !== 'constructor' && !own.endsWith('_') && !SLOW.has(own))) {
      const all = things();
      const self = prototype === Object.getPrototypeOf(b) ? b : all.find((own) => Object.getPrototypeOf(own) === prototype);
      for (let i = 0; i < TRIES; i++) {
        const given = Array.from({ length: chance(5) }, () => (chance(3) ? one(PLAIN) : chance(2) ? one(all) : [one(all)]));
        tries++;
        try {
          const found = self[name];
          if (typeof found === 'function') {
            found.apply(self, given);
          }
        } catch (error) {
          if (!(error instanceof BattenError)) {
            faults.add(`${self.kind_ ?? 'b'}.${name}: ${error.stack.split('\n').slice(0, 3).join(' ')}`);
          } else if (/\bundefined$|\[object/.test(error.message) && !/found undefined$/.test(error.message)) {
            faults.add(`${self.kind_ ?? 'b'}.${name}: ${error.message}`);
          }
        }
      }
    }
  }
  console.log(`${tries} wrong things, ${faults.size} faults`);
  assert.deepEqual([...faults], []);
  assert.ok(tries > 8000);
  assert.ok(things().length > 20);
});
