// Libraries of npm: evaluation, closest point, fits and frames. Usage: peer_npm.mjs BENCH_STROKES, the program that prints the
// strokes. A library gives the curve that it has through or by the benchmark's points; what it gets wrong is told beside the time.
import { execFileSync } from 'node:child_process';
import { Bezier } from 'bezier-js';
import { CurveInterpolator } from 'curve-interpolator';
import fitCurve from 'fit-curve';
import paper from 'paper/dist/paper-core.js';
import rhino3dm from 'rhino3dm';
import { CatmullRomCurve3, Vector3 } from 'three';

// verb-nurbs looks for a window, and says its version.
const { log } = console;
Object.assign(globalThis, { window: globalThis });
console.log = () => {};
const { default: verb } = await import('verb-nurbs');
console.log = log;

const [WAVE, QUERIES, EVALS, FRAMES, TOLERANCE] = [100, 100, 20000, 10000, 0.5];

function* random(seed) {
  for (let state = BigInt(seed); ;) {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    yield Number(state >> 11n) / 9007199254740992;
  }
}

/** The common input, as bench/timing.h makes it. @param {number} n @param {number} dimension @returns {number[][]} */
function wave(n, dimension) {
  const noise = random(99);
  return Array.from({ length: n }, (_, i) => Array.from({ length: dimension }, (__, c) => {
    const value = noise.next().value;
    return c === 0 ? 10 * i + 4 * value : 60 * value;
  }));
}
const knotsOf = (/** @type {number} */ n) => Array.from({ length: n + 4 }, (_, i) => (i < 4 ? 0 : i >= n ? 1 : (i - 3) / (n - 3)));

/** A point of a clamped cubic over 0..1. @param {number[][]} points @param {number} u */
function pointOf(points, u) {
  const [n, t] = [points.length, knotsOf(points.length)];
  let k = 3;
  while (k < n - 1 && u >= t[k + 1]) {
    k++;
  }
  return points[0].map((_, c) => {
    const d = [0, 1, 2, 3].map((i) => points[k - 3 + i][c]);
    for (let r = 1; r < 4; r++) {
      for (let i = 3; i >= r; i--) {
        const w = (u - t[k - 3 + i]) / (t[k + 1 + i - r] - t[k - 3 + i]);
        d[i] = (1 - w) * d[i - 1] + w * d[i];
      }
    }
    return d[3];
  });
}

/** The same curve without its ends, as cubics: uniform spans by the classical matrix. @param {number[][]} points */
function cubicsOf(points) {
  const mix = (/** @type {number[][]} */ p, /** @type {number[]} */ w) => [0, 1].map((c) => p.reduce((sum, at, i) => sum + w[i] * at[c], 0));
  return points.slice(3).map((_, i) => {
    const p = points.slice(i, i + 4);
    return [[1 / 6, 4 / 6, 1 / 6, 0], [0, 2 / 3, 1 / 3, 0], [0, 1 / 3, 2 / 3, 0], [0, 1 / 6, 4 / 6, 1 / 6]].map((w) => mix(p, w));
  });
}
const cubicAt = (/** @type {number[][]} */ [a, b, c, d], /** @type {number} */ t) => [0, 1].map((k) =>
  (1 - t) ** 3 * a[k] + 3 * t * (1 - t) ** 2 * b[k] + 3 * t * t * (1 - t) * c[k] + t ** 3 * d[k]);

/** How far x is from what `at` draws: the best of many samples, then ever closer. @param {(u: number) => number[]} at @param {number[]} x */
function distance(at, x, steps = 20000) {
  const off = (/** @type {number} */ u) => Math.hypot(at(u)[0] - x[0], at(u)[1] - x[1]);
  let [best, least] = [0, Infinity];
  for (let i = 0; i <= steps; i++) {
    const d = off(i / steps);
    [best, least] = d < least ? [i / steps, d] : [best, least];
  }
  for (let reach = 1 / steps; reach > 1e-13; reach *= 0.7) {
    for (const u of [best - reach / 2, best + reach / 2].map((v) => Math.min(Math.max(v, 0), 1))) {
      const d = off(u);
      [best, least] = d < least ? [u, d] : [best, least];
    }
  }
  return least;
}
const along = (/** @type {number[][][]} */ cubics) => (/** @type {number} */ u) => {
  const i = Math.min(Math.floor(u * cubics.length), cubics.length - 1);
  return cubicAt(cubics[i], u * cubics.length - i);
};

/** @param {string} program @param {string} name @param {string} unit @param {number} each units of a millisecond a call @param {() => void} call */
function row(program, name, unit, each, call, note = '') {
  const times = [];
  const begin = performance.now();
  while (times.length < 5 || (performance.now() - begin < 1000 && times.length < 400)) {
    const start = performance.now();
    call();
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  const [best, median] = [times[0], times[times.length >> 1]].map((ms) => Number((ms * each).toPrecision(4)));
  console.log(JSON.stringify({ program, name, unit, best, median, note }));
}

/** @param {string} program @param {number} n @param {(u: number) => void} at */
const evaluates = (program, n, at, note = '') => row(program, `eval 1e6 sorted, 3D cubic, n=${n}`, 'ns/point', 1e6 / EVALS, () => {
  for (let i = 0; i < EVALS; i++) {
    at(i / EVALS);
  }
}, note);
const apart = (/** @type {number[]} */ a, /** @type {number[]} */ b) => `off by ${Math.max(...a.map((v, c) => Math.abs(v - b[c]))).toExponential(0)}`;

const rhino = await rhino3dm();
for (const n of [16, 1000]) {
  const points = wave(n, 3);
  const right = pointOf(points, 0.37);
  const nurbs = verb.geom.NurbsCurve.byKnotsControlPointsWeights(3, knotsOf(n), points);
  evaluates('verb-nurbs', n, (u) => nurbs.point(u), apart(nurbs.point(0.37), right));
  const curve = rhino.NurbsCurve.create(false, 3, points);
  const [from, to] = curve.domain;
  const at = (/** @type {number} */ u) => curve.pointAt(from + u * (to - from));
  evaluates('rhino3dm', n, at, apart(at(0.37), right));
  const through = new CurveInterpolator(points, { tension: 0.5 });
  through.getPointAt(0.5); // what it prepares
  evaluates('curve-interpolator', n, (u) => through.getPointAt(u), 'Catmull-Rom');
  const frames = new CatmullRomCurve3(points.map((p) => new Vector3(...p)));
  row('three.js', `RMF 10000 in bulk, n=${n}`, 'ns/frame', 1e6 / FRAMES, () => {
    frames.updateArcLengths();
    frames.computeFrenetFrames(FRAMES, false); // for all its name a chain of least rotations
  }, 'Catmull-Rom');
  if (n === 1000) {
    row('verb-nurbs', 'eval 2 derivatives, n=1000', 'ns/point', 1e6 / 2000, () => {
      for (let i = 0; i < 2000; i++) {
        nurbs.derivatives(i / 2000, 2);
      }
    });
  }
}
{
  const data = verb.geom.NurbsCurve.byKnotsControlPointsWeights(3, knotsOf(1000), wave(1000, 2)).asNurbs();
  const knots = Array.from({ length: 1000 }, (_, i) => (i + 0.37) / 1000);
  row('verb-nurbs', 'insert 1000 knots into 1000', 'us', 1e3, () => verb.eval.Modify.curveKnotRefine(data, knots));
}

const plane = wave(WAVE, 2);
const cubics = cubicsOf(plane);
const place = random(5);
const queries = Array.from({ length: QUERIES }, () => [10 * WAVE * place.next().value, 100 * place.next().value - 20]);
/** @param {string} program @param {(x: number[]) => number} find the distance @param {((u: number) => number[]) | null} at */
function nearest(program, find, at, note = '') {
  const error = at ? Math.max(...queries.slice(0, 40).map((x) => Math.abs(find(x) - distance(at, x)))) : 0;
  row(program, 'nearest, planar cubic, n=100', 'us', 1e3 / QUERIES, () => queries.forEach(find),
    at ? `distances off by ${error.toExponential(0)}` : note);
}
const off = (/** @type {number[]} */ x, /** @type {number} */ px, /** @type {number} */ py) => Math.hypot(px - x[0], py - x[1]);
paper.setup(new paper.Size(100, 100));
{
  const nurbs = verb.geom.NurbsCurve.byKnotsControlPointsWeights(3, knotsOf(WAVE), plane.map(([x, y]) => [x, y, 0]));
  nearest('verb-nurbs', (x) => {
    const [px, py] = nurbs.closestPoint([...x, 0]);
    return off(x, px, py);
  }, (u) => pointOf(plane, u));
  const path = new paper.Path({ insert: false });
  path.moveTo(cubics[0][0]);
  cubics.forEach(([, b, c, d]) => path.cubicCurveTo(b, c, d));
  nearest('paper', (x) => path.getNearestLocation(x).distance, along(cubics));
  const pieces = cubics.map((cubic) => new Bezier(cubic.map(([x, y]) => ({ x, y }))));
  nearest('bezier-js', (x) => Math.min(...pieces.map((piece) => piece.project({ x: x[0], y: x[1] }).d)), along(cubics));
  const through = new CurveInterpolator(plane, { tension: 0.5 });
  through.getNearestPosition([0, 0]);
  nearest('curve-interpolator', (x) => through.getNearestPosition(x).distance, null, 'Catmull-Rom');
}

['eight bends', 'spiral', 'car line'].forEach((name, kind) => {
  const samples = execFileSync(process.argv[2], [String(kind)], { encoding: 'utf8' }).trim().split('\n')
    .filter((line) => !line.startsWith('f')).map((line) => line.split(/\s+/).map(Number));
  /** @param {string} program @param {() => number[][][]} fit */
  const fits = (program, fit) => {
    const made = fit();
    const at = along(made);
    const error = Math.max(...samples.filter((_, i) => i % 5 === 0).map((x) => distance(at, x, 2000)));
    row(program, `fit 1000, ${name}`, 'us', 1e3, fit, `${3 * made.length + 1} points, true error ${error.toFixed(3)}`);
  };
  fits('fit-curve', () => fitCurve(samples, TOLERANCE * TOLERANCE)); // it compares squares
  fits('paper', () => {
    const path = new paper.Path({ segments: samples, insert: false });
    path.simplify(TOLERANCE * TOLERANCE);
    return path.curves.map((curve) => curve.getValues()).map((v) => [v.slice(0, 2), v.slice(2, 4), v.slice(4, 6), v.slice(6, 8)]);
  });
});
