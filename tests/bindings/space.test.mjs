// Surfaces, wires, views, cameras, motion, documents and formats in batten-core under Node: what calls give and what they refuse. The programs
// of the package test show what they are for.
import assert from 'node:assert/strict';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const batten = await import(path.join(root, 'build/wasm/npm/batten-core/index.js'));
const { BattenError } = batten;
const b = await batten.load();
const near = (a, c, by = 1e-9) => assert.ok(Math.abs(a - c) <= by, `${a} is not ${c}`);
const says = (pattern, what) => assert.throws(what, (error) => error instanceof BattenError && pattern.test(error.message), String(pattern));
const ring = (z, r) => b.fit(Array.from({ length: 41 }, (_, i) => [r * Math.cos(i * Math.PI / 20), r * Math.sin(i * Math.PI / 20), z]), { tolerance: 1e-3, closed: true });
const line = b.clamped([[0, 0, 0], [0, 0, 5], [0, 0, 15], [0, 0, 20]]);
const move = (curve, x) => curve.transform([1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0]);
const vase = b.loft([ring(0, 10), ring(10, 5), ring(20, 12)]);

test('surfaces: places, curvature, closest points, rays, sections, levels', () => {
  const [u, v] = [vase.domain('u'), vase.domain('v')];
  near(Math.hypot(...vase.at(u[0], v[0]).slice(0, 2)), 10, 0.01);
  assert.equal(vase.points.length, 3 * vase.count('u') * vase.count('v'));
  assert.equal(vase.atGrid([u[0], 1], [0, 0.5, 1]).length, 18);
  assert.ok(Number.isFinite(vase.curvature(1, 0.5).gauss));
  const finder = vase.finder();
  const sphere = b.surface([[[0, 0, 0], [0, 2, 0]], [[2, 0, 0], [2, 2, 0]]], [0, 0, 1, 1], [0, 0, 1, 1], { degree: 1 });
  near(sphere.nearest([1, 1, 3]).distance, 3);
  near(finder.hits([0, 0, 10], [1, 0, 0])[0].distance, 5, 0.01);
  for (const { point } of vase.section([0, 0, 5], [0, 0, 1]).points(0)) {
    near(point[2], 5, 1e-4);
  }
  const relief = vase.levels(1);
  assert.equal(relief.details(1).length, 3 * relief.source(1).length);
  relief.addLevel();
  assert.equal(relief.levels, 2);
  const { grid, report } = vase.tessellate({ tolerance: 0.1 });
  assert.ok(report.maxError <= 0.1);
  assert.ok(grid.triangles.every((one) => one >= 0 && one < grid.rows * grid.columns));
  const copy = b.reference({ surfaces: [vase.copy()] });
  near(vase.deviation(copy).greatest, 0, 1e-6);
});

test('sweeps, wires, meshes', () => {
  const tube = line.sweep(ring(0, 1).toDimension(2), { twist: 0.5 }).surface(1e-3);
  assert.ok(tube.report.maxError <= 1e-3);
  const mesh = b.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], { faces: [[0, 1, 2], [0, 1, 3]] });
  assert.deepEqual(mesh.faces.map((face) => [...face]), [[0, 1, 2], [0, 1, 3]]);
  const binding = b.bind([{ reference: line, radius: 100 }], mesh.vertices);
  near(binding.apply([move(line, 7)]).report.largest, 7, 1e-9);
  assert.deepEqual([...binding.apply([line]).points], [...mesh.vertices]);
  assert.ok(mesh.withVertices([...mesh.vertices].map((one) => 2 * one)).size > mesh.size);
});

test('views, cameras, motion', () => {
  const view = { eye: [50, 0, 10], target: [0, 0, 10], fov: 40 };
  const drawing = b.lineDrawing(view, vase);
  assert.ok(drawing.count > 0 && drawing.at(0).points.length >= 8);
  const { origin, direction } = b.viewRay(view, [500, 500]);
  near(Math.hypot(origin[0] + 50 * direction[0], origin[1], 0), 0, 1e-9);
  const camera = line.camera({ mode: 'along' }).addShake(7, 0.1, 2);
  assert.equal(b.readCamera(camera.write()).write(), camera.write());
  const rows = Array.from({ length: 9 }, (_, i) => [i, i * i]);
  const take = b.take([{ name: 'hip', parent: -1, offset: [0, 0, 0], channels: ['x_position', 'z_rotation'] }, { name: 'end', parent: 0, offset: [0, 1, 0], end: true }], rows, 0.1);
  assert.deepEqual([...take.values], rows.flat());
  const motion = take.motion();
  assert.equal(motion.take().joints[0].name, 'hip');
  assert.equal(motion.positions(0.25).length, 6);
  assert.equal(b.readBvh(take.toBvh()).jointCount, 2);
});

test('documents: SVG in and out, objects, formats', () => {
  const text = '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY c "#f00">]>\n<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><g id="a&#x436;"><path fill="&c;" d="M1 1L5 1L5 5L1 5Z"/></g><!-- - --><text><![CDATA[<]]></text></svg>';
  const document = b.readSvg(text);
  assert.equal(b.lossesTotal(document.report.lost), [...document.report.lost.count].reduce((a, c) => a + c));
  assert.equal(document.toSvg({ native: false }), text, 'what was not edited stays as it was');
  assert.equal(b.readSvg(new TextEncoder().encode(text)).digest, document.digest);
  const drawn = document.objects.find((one) => one.curveCount);
  assert.equal(drawn.style.fill, 0xff0000ff);
  near(Math.abs(drawn.curves[0].area), 16, 1e-9);
  const out = b.document();
  const id = out.add(b.surfaceObject(vase, { name: 'ж' }));
  assert.ok(out.at(out.find(id)).surface().isEqual(vase));
  assert.equal(b.readDocument(out.write()).digest, out.digest);
  assert.equal(typeof out.digest, 'bigint');
  const again = b.readStep(b.writeStep(vase));
  assert.ok(again.surfaces[0].isEqual(vase));
  const stl = b.writeStl(vase, { tolerance: 0.1 });
  assert.equal(stl.length, 84 + 50 * new DataView(stl.buffer).getUint32(80, true));
  assert.ok(b.splineObject([[0, 0], [10, 5], [20, 0]]).spline.points.length === 6);
  assert.deepEqual(b.readStroke('{"points":[[0,0],[1,1]]}').points.map((one) => [...one]), [[0, 0], [1, 1]]);
});

test('refusals name the argument, what was expected and what was found', () => {
  says(/^wires\[0\]\.radius: expected an object of .*, found "thick"$/, () => b.bind([{ reference: line, radius: 'thick' }], [[0, 0, 0]]));
  says(/^curves\[1\]: expected a Curve, found a Surface$/, () => b.pathObject([line, vase]));
  says(/^style: expected an object of .*, found one with colour$/, () => b.pathObject([line.toDimension(2)], { style: { colour: 3 } }));
  says(/^mode: expected one of free, along, look_at, found "tangent"$/, () => line.camera({ mode: 'tangent' }));
  says(/^points\[0\]\[1\]: expected a finite number, found NaN$/, () => b.bind([{ reference: line, radius: 1 }], [[0, NaN, 0]]));
  says(/^details: expected \d+ numbers for \d+ control points, found 1$/, () => vase.relief().addLevel({ uKnots: vase.knots('u'), vKnots: vase.knots('v'), details: [1] }));
  says(/^faces\[0\]: expected 3 vertices or more, found an Array of 2$/, () => b.mesh([[0, 0, 0]], { faces: [[0, 0]] }));
  says(/^faces\[0\]: expected numbers of vertices, found 7 /, () => b.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], { faces: [[0, 1, 7]] }));
  says(/^style\.opacity: expected 0 to 1, found 2 /, () => b.pathObject([line.toDimension(2)], { style: { opacity: 2 } }));
  says(/^view\.fov: expected 0 to less than 180, found 200 /, () => b.viewRay({ eye: [0, 0, 9], fov: 200 }, [0, 0]));
  says(/^profile\.stops\[1\]\.at: expected more than at the stop before, found 0 /, () => b.widthAt([{ at: 0, share: 1 }, { at: 0, share: 1 }], 0.5));
  says(/^tolerance: expected more than 0, found 0 /, () => line.toDimension(2).offset(1, 0));
  says(/^u: expected 0 to 1, found 7 /, () => line.split(7));
  says(/^index: expected none, found 5 /, () => b.document().remove(5));
  says(/line 2, column 9: expected <\/g>, found <\/svg>/, () => b.readSvg('<svg>\n<g> &lt;</svg>'));
  says(/in another file/, () => b.readSvg('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg>&x;</svg>'));
  says(/out of proportion/, () => b.readSvg(`<!DOCTYPE svg [<!ENTITY a0 "aaaaaaaaaaaaaaaa">${Array.from({ length: 9 }, (_, i) => `<!ENTITY a${i + 1} "${`&a${i};`.repeat(16)}">`).join('')}]><svg>&a9;</svg>`));
  says(/line 2/, () => b.readObj('v 1 2 3\nf 1 2 9\n'));
  says(/this Surface has been freed/, () => {
    const gone = vase.copy();
    gone.free();
    gone.at(0, 0);
  });
});

test('every name of the table is there, and every type of index.d.ts has its class', () => {
  const classes = Object.entries(b.tables.kinds);
  assert.equal(classes.length, 22);
  classes.forEach(([name, kind]) => assert.equal(batten[name], kind));
  const own = (kind) => Object.getOwnPropertyNames(kind.prototype).filter((name) => !name.endsWith('_') && name !== 'constructor');
  assert.ok([...classes.map(([, kind]) => kind), b.constructor].flatMap(own).length > 400);
});
