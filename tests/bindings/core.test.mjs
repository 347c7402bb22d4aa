// batten-core under Node, as built in build/wasm/npm: what calls give, what they refuse, whom memory belongs to.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { inspect } from 'node:util';
import v8 from 'node:v8';
import vm from 'node:vm';
import { Worker } from 'node:worker_threads';
import zlib from 'node:zlib';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const home = path.join(root, 'build/wasm/npm/batten-core');
const { load, BattenError, Curve } = await import(path.join(home, 'index.js'));
const { load: loadSketch } = await import(path.join(home, 'sketch.js'));
const { load: loadLevels } = await import(path.join(home, 'levels.js'));
const { load: loadBare } = await import(path.join(home, 'bare.js'));
const b = await load();
const sine = (count, f = (x) => 40 * Math.sin(x / 20)) => Array.from({ length: count }, (_, x) => [x, f(x)]);
const near = (a, c, by = 1e-9) => assert.ok(Math.abs(a - c) <= by, `${a} is not ${c}`);
const refuses = (status, what) => assert.throws(what, (error) => error instanceof BattenError && error.status === status, status);

test('the modules have the sizes that the README tells', () => {
  const size = (name) => zlib.gzipSync(fs.readFileSync(path.join(home, name)), { level: 9 }).length;
  const names = ['batten.wasm', 'batten-sketch.wasm', 'batten-levels.wasm'];
  console.log(`${names.map((name) => `${name} ${size(name)}`).join(', ')} bytes gzip`);
  assert.ok(size('batten-sketch.wasm') <= 60000);
  assert.ok(size('batten-levels.wasm') <= 65000);
  assert.ok(size('batten.wasm') <= 500000);
  names.forEach((name) => assert.ok(size(`${name}.js`) <= 1.015 * size(name), 'as text they are hardly more'));
  assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(fs.readFileSync(path.join(home, 'batten.wasm')))), []);
});

test('points in all forms give the same curve, within tolerance of each', () => {
  const points = sine(200);
  const curve = b.fit(points, { tolerance: 0.5 });
  assert.ok(curve.report.maxError <= 0.5);
  for (const point of points) {
    assert.ok(curve.nearest(point).distance <= 0.5);
  }
  const forms = [points.flat(), Float64Array.from(points.flat()), Float32Array.from(points.flat()), points.map(([x, y]) => ({ x, y }))];
  forms.filter((_, i) => i !== 2).forEach((form) => assert.ok(b.fit(form, { tolerance: 0.5 }).isEqual(curve)));
  near(b.fit(forms[2], { tolerance: 0.5 }).hausdorff(curve, 1e-3).distance, 0, 0.1);
});

test('a curve with known shape: values, length, area, path', () => {
  const quarter = b.curve([[0, 0], [1, 0], [1, 1]], [0, 0, 0, 1, 1, 1], { degree: 2 });
  assert.deepEqual([...quarter.at(0.5, { order: 1 })], [0.75, 0.25, 1, 1]);
  near(quarter.length(), (Math.SQRT2 + Math.asinh(1)) / Math.SQRT2, 1e-9); // of a parabola
  const square = b.clamped([[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]], { degree: 1 }).close();
  assert.equal(square.closed, true);
  near(square.area, 100);
  const other = square.transform([1, 0, 5, 0, 1, 5]);
  near(b.combine('intersection', [square, [other]], 0.01)[0].area, 25, 1e-6);
  near(b.combine('union', [square, { curves: [other] }], 0.01)[0].area, 175, 1e-6);
  assert.equal(square.intersect(other, 0.01).crossings.length, 2);
  assert.equal(quarter.toSVG(), 'M0 0C0.667 0 1 0.333 1 1');
  assert.match(square.toSVG(), /^M0 0C.*Z$/);
});

test('calls that say how much they need, lists of structs, several results', () => {
  const curve = b.fit(sine(200), { tolerance: 0.05 });
  assert.equal(curve.inflections().filter((u) => curve.at(u)[0] > 5 && curve.at(u)[0] < 195).length, 3);
  assert.ok(curve.nearestAll([50, 0]).length > 1);
  assert.equal(curve.nearestAll(curve.at(30), { within: 1e-3 }).length, 1);
  assert.deepEqual(curve.nearestAll([50, 0], { within: 1e-3 }), []);
  assert.equal(b.clamped([[0, 0], [1, 1]], { degree: 1 }).inflections().length, 0);
  const [left, right] = curve.split(curve.domain[1] / 3);
  near(left.length() + right.length(), curve.length(), 1e-6);
  near(left.join(right).hausdorff(curve, 1e-6).distance, 0, 1e-6);
  const { points, u } = curve.flatten(0.1);
  assert.equal(points.length, 2 * u.length);
  const { curves } = curve.offset(2, 0.01);
  near(Math.abs(curves[0].nearest(curve.at(u[1])).distance), 2, 0.02);
  assert.equal(curve.basis(curve.domain[0]).values[0], 1);
  assert.deepEqual([...curve.bounds.low].length, 2);
});

test('sketch: redrawn, new, and live, whose commit is the same as at once', () => {
  const curve = b.fit(sine(200), { tolerance: 0.5 });
  const stroke = Array.from({ length: 60 }, (_, i) => [50 + i, 40 * Math.sin((50 + i) / 20) + 8 * Math.sin((i * Math.PI) / 59)]);
  const drawn = curve.sketch(stroke);
  assert.ok(drawn.nearest(stroke[30]).distance <= 1);
  assert.ok(curve.nearest(stroke[30]).distance > 2);
  assert.ok(drawn.at(0).every((one, i) => one === curve.at(0)[i]));
  const live = curve.live();
  stroke.forEach((place) => live.add(...place));
  assert.ok(live.preview().report.target.length > 60);
  assert.ok(live.commit().isEqual(drawn));
  refuses('state', () => live.add(1, 2));
  const fresh = b.live();
  refuses('dot', () => fresh.preview());
  stroke.forEach(([x, y]) => fresh.addMany({ points: [[x, y]], pressure: [0.5], time: [x] }));
  assert.ok(fresh.commit().isEqual(b.sketch({ points: stroke, pressure: stroke.map(() => 0.5), time: stroke.map(([x]) => x) })));
  refuses('far', () => curve.sketch(stroke.map(([x, y]) => [x, y + 1e4])));
});

test('splines, frames, levels', () => {
  const spline = b.spline([[0, 0], [10, 20], [30, 5]], { tangents: [null, [1, 0], null] });
  const middle = spline.nearest([10, 20]);
  near(middle.distance, 0);
  near(spline.at(middle.u, { order: 1 })[3], 0);
  const helix = b.fit(Array.from({ length: 100 }, (_, i) => [Math.cos(i / 10), Math.sin(i / 10), i / 20]), { tolerance: 0.001 });
  const { t, s, r } = helix.frames(20);
  for (let i = 0; i < 60; i += 3) {
    near(t[i] * s[i] + t[i + 1] * s[i + 1] + t[i + 2] * s[i + 2], 0, 1e-12);
    near(r[i], t[i + 1] * s[i + 2] - t[i + 2] * s[i + 1], 1e-12);
  }
  const shape = b.fit(sine(200), { tolerance: 0.05 }).levels(2);
  const whole = shape.flatten();
  const u = shape.curve(0).domain[1] / 2;
  const before = whole.at(u);
  assert.equal(shape.drag(0, u, [0, 5]), shape);
  assert.ok(Math.abs(shape.flatten().at(u)[1] - before[1]) > 1);
  assert.equal(shape.options.frame, 'rmf');
  const live = shape.live(1);
  live.drag(u, [0, 2]);
  const shown = live.shape().flatten();
  assert.ok(live.commit().flatten().hausdorff(shown, 1e-6).distance < 1e-6);
});

test('every call refuses what is not meant', () => {
  const curve = b.fit(sine(50));
  refuses('count', () => b.fit([]));
  refuses('count', () => b.fit([[1, 2]]));
  refuses('number', () => b.fit([[NaN, 2], [3, 4]]));
  refuses('argument', () => b.fit(3));
  refuses('argument', () => b.fit());
  refuses('argument', () => b.fit([['a', 2], [3, 4]]));
  refuses('dimension', () => b.fit([[1, 2], [3, 4, 5]]));
  refuses('argument', () => b.fit([[1, 2], [3, 4]], { tolerence: 3 }));
  refuses('count', () => b.fit(new Float64Array(7)));
  refuses('degree', () => curve.elevate(99));
  refuses('degree', () => curve.elevate(4.5));
  refuses('count', () => curve.transform([1]));
  refuses('argument', () => curve.at('a'));
  refuses('argument', () => curve.isEqual(null));
  refuses('argument', () => curve.levels(1).gain(7));
  refuses('argument', () => curve.levels(1).curve(-1));
  refuses('argument', () => b.combine('both', [], 0.1));
  refuses('count', () => curve.blossom(0, [1]));
  refuses('count', () => b.sketch({ points: sine(20), pressure: [1] }));
  refuses('knots', () => b.curve([[0, 0], [1, 1]], [1, 0, 0, 1], { degree: 1 }));
  assert.throws(() => b.curve([[0, 0], [1, 1]], [1, 0, 0, 1], { degree: 1 }), /^BattenError: knots\[1\]: expected at least 1, found 0 \(curve\(/);
});

test('what is freed is gone; objects of another instance are refused', async () => {
  const curve = b.fit(sine(50));
  const finder = curve.finder();
  curve.free();
  curve.free();
  refuses('state', () => curve.count);
  assert.ok(finder.nearest([10, 10]).distance < 40); // it has a curve of its own
  const second = await load();
  refuses('argument', () => second.fit(sine(50)).isEqual(b.fit(sine(50))));
  assert.equal(typeof finder[Symbol.dispose ?? Symbol.for('Symbol.dispose')], 'function');
});

test('arrays in the memory of the module are not copied, and memory does not leak', () => {
  const points = sine(200).flat();
  const array = b.array(points.length);
  array.values.set(points);
  assert.ok(b.fit(array).isEqual(b.fit(points)));
  const into = b.array(400);
  const curve = b.fit(points);
  const u = curve.spread(200);
  const written = curve.atMany(u, { into });
  assert.equal(written.buffer, b.memory.buffer);
  assert.deepEqual([...into.values], [...curve.atMany(u)]);
  refuses('count', () => curve.atMany(curve.spread(201), { into }));
  const few = b.array(8);
  few.values.set([0, 0, 1, 2, 3, 3, 4, 0]);
  const round = () => {
    const one = b.clamped(few);
    one.flatten(0.1);
    one.split(1e-3).forEach((part) => part.free());
    one.elevate(5).free();
    assert.throws(() => one.elevate(99));
    assert.throws(() => one.transform([1]));
    one.free();
  };
  round();
  const before = b.memory.buffer.byteLength;
  for (let i = 0; i < 1500; i++) {
    round();
  }
  assert.equal(b.memory.buffer.byteLength, before);
});

test('numbers and curves that nobody holds any more are freed by the collector', async () => {
  v8.setFlagsFromString('--expose-gc');
  const collect = vm.runInNewContext('gc');
  const other = await load();
  const size = () => other.memory.buffer.byteLength;
  for (let i = 0; i < 40; i++) {
    other.clamped(other.array(1 << 16));
    collect();
    await new Promise((done) => setTimeout(done));
  }
  assert.ok(size() < 20 << 20, `${size()}`); // 40 MB if they stayed
});

test('the small module draws, and says what it has not', async () => {
  const small = await loadSketch();
  const curve = small.fit(sine(100));
  assert.match(curve.toSVG(), /^M/);
  const live = curve.live();
  sine(60, (x) => 30 * Math.sin(x / 20)).forEach((place) => live.add(...place));
  assert.ok(live.commit() instanceof Curve);
  refuses('unsupported', () => curve.levels(2));
});

test('the small module of levels gives what the whole one gives, and says what it has not', async () => {
  const small = await loadLevels();
  const of = (library) => {
    const curve = library.spline([[0, 0], [40, 30], [90, 5], [140, 40], [200, 0]], { tangents: [null, [1, 0], null, null, null] });
    const shape = library.fit(sine(200), { tolerance: 0.05 }).levels(2);
    const u = shape.curve(0).domain[1] / 2;
    shape.drag(0, u, [0, 5]).setGain(1, 0.5);
    const live = shape.live(1);
    live.drag(u, [0, 2]);
    return [curve, live.commit().flatten(), library.shapeFromSpline([[0, 0], [10, 20], [30, 5]]).flatten()].flatMap((one) => [...one.points]);
  };
  assert.deepEqual(of(small), of(b));
  const shape = small.fit(sine(200)).levels(2);
  refuses('unsupported', () => shape.redraw(sine(60)));
  refuses('unsupported', () => small.live());
  await assert.rejects(load({ small: 'levels' }), { status: 'argument', message: /no option small/ });
});

test('without a module inside, it comes from an address, bytes or a compiled module', async () => {
  const file = path.join(home, 'batten-sketch.wasm');
  const bytes = fs.readFileSync(file);
  for (const wasm of [new URL(`file://${file}`), `file://${file}`, path.relative('.', file), bytes, new WebAssembly.Module(bytes)]) {
    assert.equal((await loadBare({ wasm })).fit([0, 0, 1, 1, 2, 0]).count, b.fit([0, 0, 1, 1, 2, 0]).count);
  }
  await assert.rejects(loadBare(), { status: 'argument', message: /no module inside/ });
  await assert.rejects(loadBare({ wasm: 'nowhere.wasm' }), { status: 'state', message: /nowhere\.wasm cannot be read.*load\(\{ wasm \}\) takes/ });
});

test('in a worker', async () => {
  const worker = new Worker(`import(${JSON.stringify(path.join(home, 'index.js'))}).then(async ({ load }) =>
    (await import('node:worker_threads')).parentPort.postMessage((await load()).fit([0, 0, 1, 1, 2, 0]).count))`, { eval: true });
  after(() => worker.terminate());
  const told = await new Promise((done, fail) => worker.once('message', done).once('error', fail));
  assert.equal(told, b.fit([0, 0, 1, 1, 2, 0]).count);
});

test('consoles and JSON show what an object is; a place in the plane has two numbers', () => {
  const curve = b.clamped([[0, 0], [2, 2]], { degree: 1 });
  assert.equal(String(curve), '<Curve of degree 1, 2 points>');
  assert.equal(inspect(curve), String(curve));
  assert.match(inspect(b), /^<Batten [\d.]+>$/);
  assert.ok(b.readCurve(JSON.stringify(curve)).isEqual(curve));
  assert.ok(b.readShape(JSON.stringify(b.fit(sine(200), { tolerance: 0.05 }).levels(1))));
  assert.throws(() => JSON.stringify(curve.finder()), { status: 'unsupported', message: 'a Finder has no JSON' });
  assert.deepEqual([...curve.nearest({ x: 1, y: 1 }).point], [1, 1]);
  const across = b.clamped([[0, 2], [2, 0]], { degree: 1 });
  assert.equal(curve.intersect(across, 1e-6).crossings[0].point.length, 2);
  assert.equal(curve.toDimension(3).nearest([1, 1, 0]).point.length, 3);
  assert.throws(() => new curve.constructor(), /a Curve is made by/);
  curve.free();
  assert.equal(String(curve), '<Curve, freed>');
});

test('what is refused has a name, and options that are none are refused', () => {
  const line = b.clamped([[0, 0], [1, 1]], { degree: 1 });
  assert.throws(() => b.combine('union', [[line]], 0.1), /^BattenError: regions\[0\]\[0\]: expected a closed curve in the plane, found an open one/);
  assert.throws(() => b.offsetRegion({ curves: [line] }, 1, 0.1), /region\.curves\[0\]/);
  assert.throws(() => line.openAt(0.5), /out of range: an open one \(<Curve of degree 1, 2 points>\.openAt\(u: 0\.5\)\)$/);
  assert.throws(() => b.fit(sine(200), { tolerance: 0.05 }).elevate(2), /^BattenError: degree: expected 3 to 7, found 2/);
  assert.throws(() => b.loft([line]), /^BattenError: sections: /);
  assert.throws(() => line.levels(2), /\(<Curve of degree 1, 2 points>\.levels\(levels: 2\)\)$/);
  assert.throws(() => line.toSVG(1), /toSVG: expected \(options\), found 1 as options/);
  assert.throws(() => line.toSVG({ decimals: 1.5 }), /decimals: expected a whole number from 0 to 20/);
  assert.throws(() => b.fit([[0, 0], [1, 1]], [1]), /expected \(points, options\)/);
  assert.throws(() => b.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), /mesh: expected \(vertices, options\)/);
});
