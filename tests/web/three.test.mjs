// three.js plays what `batten camera` writes: the camera of the file against the program's own samples at 1,000 times.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { AnimationMixer, Quaternion, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { PROGRAM } from './server.mjs';

globalThis.self ??= globalThis; // the loader looks for a window
const TIMES = 1000;
const CLAMPED = [0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1];
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'batten-three-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true }));

/** Numbers in [-1, 1] that look random, the same in each run. */
function source(seed) {
  let state = seed;
  return () => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return (2 * state) / 2147483648 - 1;
  };
}

/** @param {number} count @param {number} size @param {() => number} next @param {number} scale */
const rows = (count, size, next, scale) => Array.from({ length: count }, () => Array.from({ length: size }, () => scale * next()));
const curve = (points) => ({ degree: 3, closed: false, knots: CLAMPED, points });

function camera(move, ...words) {
  const name = path.join(folder, 'move.json');
  fs.writeFileSync(name, JSON.stringify(move));
  return execFileSync(PROGRAM, ['camera', name, ...words], { encoding: 'utf8', maxBuffer: 1 << 26 });
}

/** The greatest distance and angle (degrees) between player and program. */
async function played(move) {
  const file = path.join(folder, 'move.glb');
  camera(move, '--fps', '2', '--out', file);
  const data = fs.readFileSync(file);
  const scene = await new GLTFLoader().parseAsync(data.buffer.slice(data.byteOffset, data.byteOffset + data.length), '');
  assert.equal(scene.cameras.length, 1);
  assert.equal(scene.animations.length, 1);
  const mixer = new AnimationMixer(scene.scene);
  mixer.clipAction(scene.animations[0]).play();
  const { duration } = move.timing;
  const times = Array.from({ length: TIMES }, (_, i) => (duration * (i + 0.5)) / TIMES);
  const own = JSON.parse(camera(move, '--at', times.join()));
  let [place, angle] = [0, 0];
  times.forEach((time, i) => {
    mixer.setTime(time);
    scene.scene.updateMatrixWorld(true);
    const at = scene.cameras[0].getWorldPosition(new Vector3());
    const turn = scene.cameras[0].getWorldQuaternion(new Quaternion());
    place = Math.max(place, at.distanceTo(new Vector3(...own.positions[i])));
    angle = Math.max(angle, (turn.angleTo(new Quaternion(...own.rotations[i])) * 180) / Math.PI);
  });
  return { place, angle };
}

/** The diagonal of the box of the points. */
function sizeOf(points) {
  return Math.hypot(...[0, 1, 2].map((d) => Math.max(...points.map((p) => p[d])) - Math.min(...points.map((p) => p[d]))));
}

const next = source(7);
const path3 = [[0, 0, 0], [40, 10, 20], [50, 70, 0], [90, 30, 30], [120, 80, 10], [150, 0, 60]];
const levels = [{ knots: CLAMPED, details: rows(6, 3, next, 0.3) }, { knots: CLAMPED, details: rows(6, 3, next, 0.1) }];
const eased = { duration: 5, curve: { degree: 2, knots: [0, 0, 0, 0.4, 1, 1, 1], values: [0, 0.1, 0.3, 1] } };
const moves = {
  'free, with levels and a timing': {
    path: curve(path3), timing: eased, fov: { degree: 1, knots: [0, 0, 1, 1], values: [30, 50] },
    orientation: { mode: 'free', base: curve(rows(6, 4, next, 1).map((q) => [q[0], q[1], q[2], q[3] + 2])), levels },
  },
  'along a path in space': { path: curve(path3), timing: { duration: 4 }, orientation: { mode: 'along', first: { s: [0, 0, -1] }, levels } },
  'past the zenith of its target': {
    path: curve([[-90, 2, 100], [-60, 2, 100], [-20, 0, 100], [20, 0, 100], [60, 0, 100], [90, 0, 100]]),
    timing: { duration: 2 }, orientation: { mode: 'look-at', target: [0, 0, 0] },
  },
};

for (const [name, move] of Object.entries(moves)) {
  test(`three.js shows a move ${name}`, async () => {
    const { place, angle } = await played(move);
    console.log(`      ${(place / sizeOf(move.path.points)).toExponential(1)} of the size, ${angle.toFixed(4)} degrees`);
    assert.ok(place < 1e-4 * sizeOf(move.path.points), `${place}`);
    assert.ok(angle < 0.1, `${angle}`);
  });
}

// Where a move is made of cubics in time, without levels, a player's spans are those of the move: 1e-6, as far as floats go. Its
// parameter is even in time on a straight path whose control points lie evenly, and on a tripod. Of one span, a player's is the move's
// own; of several, whose quaternions are not of length 1 between them, as keys have to be, there are more keys.
const straight = [0, 1, 2, 3].map((i) => [50 * i, 27 * i, -20 * i]);
const SIZE = sizeOf(straight); // of the tripods' world, too
const bezier = (points) => ({ degree: 3, closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], points });
const unit = (q) => q.map((x) => x / Math.hypot(...q));
const turns = bezier([[0.1, 0.2, 0, 1], [0.2, 0.1, 0.3, 0.9], [-0.1, 0.3, 0.2, 0.9], [0.1, -0.2, 0.4, 0.8]].map(unit));
const several = { degree: 3, closed: false, knots: [0, 0, 0, 0, 0.2, 0.5, 0.7, 1, 1, 1, 1], points: rows(7, 4, next, 0.4).map((q) => unit([q[0], q[1], q[2], 1])) };
const ring = { degree: 3, closed: true, knots: [0, 1, 2, 3, 4, 5, 6], points: rows(6, 4, next, 0.4).map((q) => unit([q[0], q[1], q[2], 1])) };
const exact = {
  'of four spans, on a straight path': { path: bezier(straight), timing: { duration: 4 }, orientation: { mode: 'free', base: several } },
  'of four spans, on a tripod': { path: bezier(straight.map(() => [3, 1, 2])), timing: { duration: 7 }, orientation: { mode: 'free', base: several } },
  'of a closed base': { path: bezier(straight), timing: { duration: 4 }, orientation: { mode: 'free', base: ring } },
  'on a straight path': { path: bezier(straight), timing: { duration: 4 }, orientation: { mode: 'free', base: turns } },
  'on a tripod': { path: bezier(straight.map(() => [3, 1, 2])), timing: { duration: 4 }, orientation: { mode: 'free', base: turns } },
};

for (const [name, move] of Object.entries(exact)) {
  test(`three.js shows cubics ${name} as they are`, async () => {
    const { place, angle } = await played(move);
    const [far, turned] = [place / SIZE, (angle * Math.PI) / 180];
    console.log(`      ${far.toExponential(1)} of the size, ${turned.toExponential(1)} radians`);
    assert.ok(far < 1e-6, `${far}`);
    assert.ok(turned < 1e-6, `${turned}`);
  });
}
