// three.js: computeFrenetFrames, which for all its name is a chain of least rotations, on its own cubic through the
// benchmark's points.
import { CatmullRomCurve3, Vector3 } from 'three';

const FRAMES = 10000;

/** The common input, as bench/timing.h makes it. @param {number} n */
function wave(n) {
  const points = [];
  let state = 99n;
  for (let i = 0; i < n; i++) {
    const p = [];
    for (let c = 0; c < 3; c++) {
      state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
      const noise = Number(state >> 11n) / 9007199254740992;
      p.push(c === 0 ? 10 * i + 4 * noise : 60 * noise);
    }
    points.push(new Vector3(p[0], p[1], p[2]));
  }
  return new CatmullRomCurve3(points);
}

for (const n of [16, 1000]) {
  const curve = wave(n), times = [];
  const begin = performance.now();
  while (times.length < 5 || performance.now() - begin < 4000) {
    const start = performance.now();
    curve.updateArcLengths();
    curve.computeFrenetFrames(FRAMES, false);
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  const ns = (/** @type {number} */ ms) => Number((ms * 1e6 / FRAMES).toPrecision(4));
  console.log(JSON.stringify({ program: 'three.js', name: `RMF 10000 in bulk, n=${n}`, unit: 'ns/frame',
    best: ns(times[0]), median: ns(times[times.length >> 1]), note: 'Catmull-Rom' }));
}
