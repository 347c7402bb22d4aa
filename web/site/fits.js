// The fits of the race, each as cubic Bézier segments: [x0, y0, x1, y1, x2, y2, x3, y3].

import { Device, Phase } from '../engine/codes.js';
import { addressOf } from '../page/build.js';

/** @typedef {number[]} Segment */
/** @typedef {[number, number]} Place */
/** @typedef {{ segments: Segment[], points: number, joints: string }} Fit */

/** @typedef {{ degree: number, closed?: boolean, knots: number[], points: number[][] }} Curve as docs/format.md says */

/** One period of a closed curve, as an open one. @param {Curve} curve @returns {Curve} */
function unrolled({ degree, closed, knots, points }) {
  if (!closed) {
    return { degree, knots, points };
  }
  const count = points.length;
  const period = knots[count] - knots[0];
  const around = (/** @type {number} */ i) => ((i % count) + count) % count;
  return {
    degree,
    knots: Array.from({ length: count + 2 * degree + 1 }, (_, i) => knots[around(i - degree)] + Math.floor((i - degree) / count) * period),
    points: Array.from({ length: count + degree }, (_, i) => points[around(i - degree)]),
  };
}

/** A curve with one more knot (Boehm 1980). @param {Curve} curve @param {number} u @returns {Curve} */
function withKnot({ degree, knots, points }, u) {
  const k = knots.lastIndexOf(u);
  const place = (/** @type {number} */ j) => {
    const width = knots[j + degree] - knots[j];
    const share = width > 0 ? (u - knots[j]) / width : 0;
    return share === 0 ? points[j - 1] : points[j].map((value, axis) => share * value + (1 - share) * points[j - 1][axis]);
  };
  return {
    degree,
    knots: [...knots.slice(0, k + 1), u, ...knots.slice(k + 1)],
    points: Array.from({ length: points.length + 1 }, (_, j) => (j <= k - degree ? points[j] : j > k ? points[j - 1] : place(j))),
  };
}

/** The pieces of a curve of degree 3. @param {Curve} given @returns {Segment[]} */
function segmentsOf(given) {
  let curve = unrolled(given);
  const { degree } = curve;
  const joints = [...new Set(curve.knots.slice(degree, curve.knots.length - degree))];
  for (const u of joints) {
    while (curve.knots.filter((knot) => knot === u).length < degree) {
      curve = withKnot(curve, u);
    }
  }
  const first = curve.knots.lastIndexOf(joints[0]) - degree;
  return joints.slice(1).map((_, i) => curve.points.slice(first + degree * i, first + degree * (i + 1) + 1).flat());
}

/**
 * Batten as the editor draws it: the samples are a pen's.
 * @param {import('../engine/engine.js').Engine} engine of its own @param {Place[]} stroke @param {number} tolerance
 * @returns {Fit | null}
 */
export function ours(engine, stroke, tolerance) {
  engine.replay(new TextEncoder().encode('{"journal":"batten","version":1,"name":"race"}\n{"command":"tool-sketch"}'));
  engine.set('tolerance', tolerance);
  const pointer = (/** @type {Place} */ [x, y], /** @type {number} */ phase, /** @type {number} */ i) => ({ phase, device: Device.PEN, contact: 1,
    buttons: phase === Phase.UP ? 0 : 1, modifiers: 0, x, y, pressure: 0.5, tiltX: 0, tiltY: 0, twist: 0, width: 0,
    height: 0, time: 8 * i, predicted: false });
  engine.pointer(stroke.map((place, i) => pointer(place, i ? Phase.MOVE : Phase.DOWN, i)));
  const view = engine.frame();
  engine.pointer([pointer(stroke[stroke.length - 1], Phase.UP, stroke.length)]);
  const curve = JSON.parse(new TextDecoder().decode(engine.save(true))).objects[0]?.curves?.[0];
  if (!curve || !view || curve.degree !== 3) {
    return null;
  }
  const seen = curve.points.map((/** @type {number[]} */ [x, y]) => [(x - view.x) * view.zoom, (y - view.y) * view.zoom]);
  return { segments: segmentsOf({ ...curve, points: seen }), points: seen.length, joints: 'C2' };
}

/** @param {Segment[]} segments */
const chain = (segments) => ({ segments, points: 3 * segments.length + (segments.length ? 1 : 0), joints: 'G1' });

/** @param {any} fitCurve @param {Place[]} stroke @param {number} tolerance @returns {Fit} */
export const fitCurveOf = (fitCurve, stroke, tolerance) =>
  chain(fitCurve(stroke, tolerance * tolerance).map((/** @type {Place[]} */ piece) => piece.flat()));

/** @param {any} paper @param {Place[]} stroke @param {number} tolerance @returns {Fit} */
export function paperOf(paper, stroke, tolerance) {
  const path = new paper.Path({ segments: stroke, insert: false });
  path.simplify(tolerance * tolerance);
  return chain(path.curves.map((/** @type {any} */ { values }) => values));
}

/** @param {Segment} s @param {number} t */
function at(s, t) {
  const u = 1 - t;
  const [a, b, c, d] = [u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t];
  return [a * s[0] + b * s[2] + c * s[4] + d * s[6], a * s[1] + b * s[3] + c * s[5] + d * s[7]];
}

/** The greatest distance from a sample to the segments. @param {Segment[]} segments @param {Place[]} stroke */
export function errorOf(segments, stroke) {
  const STEPS = 48; // chords a segment
  const ways = segments.map((segment) => Array.from({ length: STEPS + 1 }, (_, i) => at(segment, i / STEPS)));
  let worst = 0;
  for (const [x, y] of stroke) {
    let least = Infinity;
    for (const way of ways) {
      for (let i = 0; i < STEPS; i++) {
        const [[ax, ay], [bx, by]] = [way[i], way[i + 1]];
        const [dx, dy] = [bx - ax, by - ay];
        const square = dx * dx + dy * dy;
        const f = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
        least = Math.min(least, (x - ax - f * dx) ** 2 + (y - ay - f * dy) ** 2);
      }
    }
    worst = Math.max(worst, least);
  }
  return segments.length ? Math.sqrt(worst) : NaN;
}

/** A script that is no module. @param {string} name @returns {Promise<void>} */
function script(name) {
  return new Promise((resolve, reject) => {
    const element = document.createElement('script');
    element.src = addressOf(`peers/${name}`);
    element.addEventListener('load', () => resolve());
    element.addEventListener('error', () => reject(new Error(name)));
    document.head.append(element);
  });
}

/** The two other libraries. @returns {Promise<{ fitCurve: any, paper: any }>} */
export async function peers() {
  await Promise.all([script('fit-curve.js'), script('paper-core.min.js')]);
  const { fitCurve, paper } = /** @type {any} */ (globalThis);
  paper.setup([1, 1]);
  return { fitCurve, paper };
}
