// A drop-in for the npm package fit-curve: points to cubic Béziers that follow each other. One smooth curve is fitted to all of
// them, and covered with as few cubics as can be, so there are fewer of them.
import { load } from '../index.js';

const b = await load();

/** The point between two, at a share of the way. @param {number[]} p @param {number[]} q @param {number} t @returns {number[]} */
const lerp = (p, q, t) => p.map((one, i) => one + (q[i] - one) * t);
/** @param {unknown} point @returns {boolean} whether it is a row of numbers */
const isPoint = (point) => Array.isArray(point) && point.every((one) => typeof one === 'number');

/**
 * @param {number[][]} points of 2 or 3 coordinates
 * @param {number} maxError the greatest squared distance between points and curve, as in fit-curve
 * @returns {number[][][]} cubics, of four points each
 */
export default function fitCurve(points, maxError) {
  if (!Array.isArray(points)) {
    throw new TypeError('First argument should be an array');
  }
  if (points.some((point) => !isPoint(point) || point.length !== points[0].length)) {
    throw new Error('Each point should be an array of numbers. Each point should have the same amount of numbers.');
  }
  const kept = points.filter((point, i) => i === 0 || point.some((one, k) => one !== points[i - 1][k]));
  if (kept.length < 2) {
    return [];
  }
  const [first, last] = [kept[0], kept[kept.length - 1]];
  if (kept.length === 2) {
    return [[first, lerp(first, last, 1 / 3), lerp(first, last, 2 / 3), last]];
  }
  const half = Math.max(Math.sqrt(maxError), 1e-9) / 2;
  const fitted = b.fitWithin(kept, { tolerance: half, holdEnds: true });
  let curve = fitted;
  try {
    curve = fitted.refitG1(half);
    const numbers = Array.from(curve.toCubics());
    const size = first.length;
    const places = Array.from({ length: numbers.length / size }, (_, i) => numbers.slice(i * size, (i + 1) * size));
    return Array.from({ length: places.length / 4 }, (_, i) => places.slice(4 * i, 4 * i + 4));
  } finally {
    curve.free();
    fitted.free();
  }
}

export { fitCurve };
