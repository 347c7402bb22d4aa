// The two adapters beside the packages that they stand in for.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const home = path.join(root, 'build/wasm/npm/batten-core');
const theirs = createRequire(path.join(root, 'tests/web/package.json'));
const { default: fitCurve } = await import(path.join(home, 'adapters/fit-curve.js'));
const { getStroke, getSvgPath } = await import(path.join(home, 'adapters/freehand.js'));
const their = { fitCurve: theirs('fit-curve'), getStroke: theirs('perfect-freehand').getStroke };
their.fitCurve = their.fitCurve.default ?? their.fitCurve;

const at = ([p, q, r, s], t) => p.map((_, k) => (1 - t) ** 3 * p[k] + 3 * (1 - t) ** 2 * t * q[k] + 3 * (1 - t) * t * t * r[k] + t ** 3 * s[k]);
/** The greatest distance from a point to the cubics, at 200 places each. */
const error = (cubics, points) => {
  const places = cubics.flatMap((cubic) => Array.from({ length: 201 }, (_, i) => at(cubic, i / 200)));
  return Math.max(...points.map((point) => Math.min(...places.map((place) => Math.hypot(...place.map((one, k) => one - point[k]))))));
};
const STROKES = {
  wave: Array.from({ length: 150 }, (_, i) => [2 * i, 60 * Math.sin(i / 18)]),
  spiral: Array.from({ length: 200 }, (_, i) => [i * Math.cos(i / 20), i * Math.sin(i / 20)]),
  noisy: Array.from({ length: 150 }, (_, i) => [2 * i, 60 * Math.sin(i / 25) + Math.sin(i * 12.9898) * 0.7]),
};

test('fit-curve: the same call, within the error, in two thirds of the pieces', () => {
  let [all, others] = [0, 0];
  for (const [name, points] of Object.entries(STROKES)) {
    for (const maxError of [1, 4, 25]) {
      const [ours, other] = [fitCurve(points, maxError), their.fitCurve(points, maxError)];
      console.log(`${name} ${maxError}: ${ours.length} pieces, error ${error(ours, points).toFixed(2)}; fit-curve ${other.length}, ${error(other, points).toFixed(2)}`);
      assert.ok(error(ours, points) <= Math.sqrt(maxError) * 1.02);
      assert.ok(ours.length <= other.length + 1);
      all += ours.length;
      others += other.length;
      assert.ok(ours.every((cubic, i) => cubic.length === 4 && (i === 0 || cubic[0].every((one, k) => Math.abs(one - ours[i - 1][3][k]) < 1e-9))));
      assert.ok([[ours[0][0], points[0]], [ours.at(-1)[3], points.at(-1)]].every(([a, c]) => Math.hypot(a[0] - c[0], a[1] - c[1]) < 1e-9));
    }
  }
  assert.ok(3 * all <= 2 * others, `${all} of ${others}`);
});

test('fit-curve: what it returns and refuses at the edges', () => {
  for (const few of [[], [[1, 1]], [[1, 1], [1, 1]]]) {
    assert.deepEqual(fitCurve(few, 1), their.fitCurve(few, 1));
  }
  const line = [[0, 0], [30, 60]];
  their.fitCurve(line, 1)[0].forEach((point, i) => point.forEach((one, k) => assert.ok(Math.abs(one - fitCurve(line, 1)[0][i][k]) < 1e-9)));
  assert.throws(() => fitCurve('x', 1), TypeError);
  assert.throws(() => fitCurve([[0, 0], [1]], 1), /same amount/);
  assert.throws(() => fitCurve([[0, 0], [NaN, 1], [3, 4]], 1));
  assert.ok(error(fitCurve([[0, 0, 0], [1, 2, 3], [4, 4, 9], [5, 5, 5]], 1e-4), [[1, 2, 3]]) < 0.02);
});

const area = (outline) => Math.abs(outline.reduce((sum, [x, y], i) => {
  const [x1, y1] = outline[(i + 1) % outline.length];
  return sum + x * y1 - x1 * y;
}, 0)) / 2;

test('freehand: constant width without thinning, a tenth of the area beside perfect-freehand', () => {
  const points = STROKES.wave;
  const plain = getStroke(points, { size: 12, thinning: 0, simulatePressure: false });
  for (const [x, y] of plain) {
    const away = Math.min(...points.map((place) => Math.hypot(place[0] - x, place[1] - y)));
    assert.ok(away > 4 && away < 6 + 2, `${away}`); // 6 from the line, whose samples lie 2 to 7 apart
  }
  for (const options of [{ size: 12, thinning: 0 }, { size: 16 }, { size: 10, thinning: 0.8, simulatePressure: false }]) {
    const pressed = points.map(([x, y], i) => [x, y, 0.5 + 0.4 * Math.sin(i / 30)]);
    const [ours, other] = [getStroke(pressed, options), their.getStroke(pressed, { ...options, streamline: 0, last: true })];
    console.log(`freehand ${JSON.stringify(options)}: area ${area(ours).toFixed(0)}, ${ours.length} points; theirs ${area(other).toFixed(0)}, ${other.length}`);
    assert.ok(Math.abs(area(ours) / area(other) - 1) < 0.1);
  }
});

test('freehand: nothing, a dot, a jump, junk', () => {
  assert.deepEqual(getStroke([]), []);
  assert.equal(getSvgPath(getStroke([])), '');
  const dot = getStroke([[5, 5], [5, 5]], { size: 10, thinning: 0 });
  assert.ok(dot.every(([x, y]) => Math.abs(Math.hypot(x - 5, y - 5) - 5) < 1e-9));
  assert.match(getSvgPath(getStroke([{ x: 0, y: 0, pressure: 1 }, { x: 9, y: 9 }])), /^M[-\d. L]+Z$/);
  assert.ok(getStroke([[0, 0], [NaN, 3], [Infinity, 1], [10, 0], [20, 0]]).flat().every(Number.isFinite));
});
