// A brush for users of perfect-freehand: the outline of a stroke whose width follows the pressure, with its options. The middle
// line is a fitted curve, so the outline is smooth without being smoothed, and lies where the pen was.
import { BattenError, load } from '../sketch.js';

const b = await load();

/** What options are when they are left out. */
const DEFAULTS = { size: 16, thinning: 0.5, smoothing: 0.5, simulatePressure: true, easing: (t) => t };
const RATE = 0.275; // how fast a simulated pressure follows the speed, as in perfect-freehand

/** The distance of two points. @param {number[]} p @param {number[]} q */
const hypot = (p, q) => Math.hypot(q[0] - p[0], q[1] - p[1]);

/** [x, y, pressure] of each point that differs from the one before. */
function samples(points) {
  const rows = points.map((point) => (Array.isArray(point) ? point : [point.x, point.y, point.pressure]));
  return rows.filter(([x, y], i) => Number.isFinite(x) && Number.isFinite(y) && (i === 0 || x !== rows[i - 1][0] || y !== rows[i - 1][1]))
    .map(([x, y, pressure]) => [x, y, pressure ?? 0.5]);
}

/** Fast strokes press less. */
function simulated(places, size) {
  let pressure = 0.5;
  return places.map((place, i) => {
    const speed = i === 0 ? 0 : Math.min(1, hypot(places[i - 1], place) / size);
    pressure = Math.min(1, pressure + (Math.min(1, 1 - speed) - pressure) * speed * RATE);
    return pressure;
  });
}

/** Points of the middle line and its unit normals. */
function middle(places, tolerance) {
  let curve;
  try {
    curve = b.fit(places.map(([x, y]) => [x, y]), { tolerance, holdEnds: true });
  } catch (error) {
    if (!(error instanceof BattenError && error.best)) {
      throw error;
    }
    curve = error.best;
  }
  const count = Math.min(2000, Math.max(8, 8 * (curve.count - curve.degree)));
  const rows = curve.atMany(curve.spread(count), { order: 1 });
  curve.free();
  return Array.from({ length: count }, (_, i) => {
    const [x, y, dx, dy] = rows.subarray(4 * i, 4 * i + 4);
    const speed = Math.hypot(dx, dy) || 1;
    return { x, y, nx: -dy / speed, ny: dx / speed };
  });
}

/** A half turn about a point, from a normal to its opposite, clockwise where y points down. */
function cap({ x, y, nx, ny }, radius, steps = 8) {
  return Array.from({ length: steps - 1 }, (_, i) => {
    const turn = (Math.PI * (i + 1)) / steps;
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    return [x + radius * (nx * c + ny * s), y + radius * (ny * c - nx * s)];
  });
}

/** A circle, as a closed polygon. @param {number[]} centre @param {number} radius @returns {number[][]} */
const disc = ([x, y], radius) => Array.from({ length: 24 }, (_, i) =>
  [x + radius * Math.cos((i * Math.PI) / 12), y + radius * Math.sin((i * Math.PI) / 12)]);

/**
 * The outline of a stroke, as a closed polygon.
 * @param {(number[] | { x: number, y: number, pressure?: number })[]} points
 * @param {{ size?: number, thinning?: number, smoothing?: number, simulatePressure?: boolean, easing?: (pressure: number) => number,
 *   streamline?: number, start?: object, end?: object, last?: boolean }} [options] as those of perfect-freehand; streamline, start, end
 *   and last are taken and have no effect
 * @returns {number[][]}
 */
export function getStroke(points, options = {}) {
  const { size, thinning, smoothing, simulatePressure, easing } = { ...DEFAULTS, ...options };
  const radius = (pressure) => Math.max(0.01, size * easing(0.5 - thinning * (0.5 - pressure)));
  const places = samples(points);
  if (places.length < 2) {
    return places.flatMap((place) => disc(place, radius(thinning === 0 ? 0.5 : place[2])));
  }
  const pressures = simulatePressure ? simulated(places, size) : places.map(([, , pressure]) => pressure);
  const line = middle(places, Math.max(0.02, smoothing * size * 0.125));
  // The pressure at the same share of the way.
  const ways = places.map(((way) => (place, i) => (way += i === 0 ? 0 : hypot(places[i - 1], place)))(0));
  const gone = line.map(((way) => ({ x, y }, i) => (way += i === 0 ? 0 : Math.hypot(x - line[i - 1].x, y - line[i - 1].y)))(0));
  let k = 1;
  const radii = gone.map((way) => {
    const at = (way / (gone[gone.length - 1] || 1)) * ways[ways.length - 1];
    while (k < ways.length - 1 && ways[k] < at) {
      k++;
    }
    const share = Math.min(1, Math.max(0, (at - ways[k - 1]) / (ways[k] - ways[k - 1])));
    return radius(pressures[k - 1] + share * (pressures[k] - pressures[k - 1]));
  });
  const side = (sign) => line.map(({ x, y, nx, ny }, i) => [x + sign * radii[i] * nx, y + sign * radii[i] * ny]);
  const opposite = ({ x, y, nx, ny }) => ({ x, y, nx: -nx, ny: -ny });
  return [...side(1), ...cap(line[line.length - 1], radii[radii.length - 1]), ...side(-1).reverse(), ...cap(opposite(line[0]), radii[0])];
}

/** SVG path data of an outline. @param {number[][]} outline */
export function getSvgPath(outline, decimals = 2) {
  const numbers = outline.map((place) => place.map((one) => Number(one.toFixed(decimals)) + 0).join(' '));
  return numbers.length > 0 ? `M${numbers.join('L')}Z` : '';
}

export default getStroke;
