"""camera: against splines, quadrature and frames computed in numpy and scipy; what the contract says of bad data."""
import csv
import io
import json
import struct
import subprocess
import unittest

import numpy
from scipy.integrate import quad
from scipy.interpolate import BSpline
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

from program import ProgramTest

RANDOM = numpy.random.default_rng(29)
CLAMPED = [0, 0, 0, 0, .3, .6, 1, 1, 1, 1]


def clamped(points, knots=None, degree=3):
    return {"degree": degree, "closed": False, "knots": knots or CLAMPED, "points": points}


def spline(curve, values=None):
    """A function of the share of the domain."""
    t, p = numpy.array(curve["knots"], float), curve["degree"]
    c = numpy.array(curve[values] if values else curve["points"], float)
    if curve.get("closed"):
        n, period = len(c), t[-1] - t[0]
        t = numpy.concatenate([t[n - p:n] - period, t, t[1:p + 1] + period])
        c = numpy.concatenate([c[n - p:], c])
        first, last = t[p], t[p + n]
    else:
        first, last = t[p], t[-p - 1]
    b = BSpline(t, c, p)
    return lambda x, nu=0: b(first + (last - first) * numpy.asarray(x), nu=nu)


def keys(points):
    """Unit, with aligned signs."""
    q = numpy.array(points, float)
    q /= numpy.linalg.norm(q, axis=1)[:, None]
    for i in range(1, len(q)):
        if q[i] @ q[i - 1] < 0:
            q[i] = -q[i]
    return q


def angles(a, b):
    """Between rotations, in radians."""
    return (Rotation.from_quat(a).inv() * Rotation.from_quat(b)).magnitude()


class Camera(ProgramTest):
    def camera(self, move, *words):
        return {k: numpy.array(v) for k, v in self.json("camera", self.file("move.json", move), *words).items()}

    def bad(self, move, words, *arguments):
        self.assertIn(words, self.refused(1, "camera", self.file("bad.json", move), *(arguments or ("--fps", "2"))))


class Free(Camera):
    PATH = {"degree": 3, "closed": False, "knots": [2, 2, 2, 2, 3, 5, 8, 8, 8, 8],
            "points": [[0, 0, 0], [4, 1, 2], [5, 7, 0], [9, 3, 3], [12, 8, 1], [15, 0, 6]]}
    TIMING = {"degree": 2, "knots": [0, 0, 0, .4, 1, 1, 1], "values": [0, .1, .3, 1]}

    def move(self):
        return {"path": self.PATH, "fov": {"degree": 1, "knots": [0, 0, 1, 1], "values": [30, 50]},
                "orientation": {"mode": "free", "base": clamped(RANDOM.normal(size=(6, 4)).tolist()),
                                "levels": [{"knots": [0, 0, 0, 0, .5, 1, 1, 1, 1], "details": RANDOM.normal(size=(5, 3)).tolist()},
                                           {"knots": CLAMPED, "details": (.2 * RANDOM.normal(size=(6, 3))).tolist()}]},
                "timing": {"duration": 5, "curve": self.TIMING}}

    def test_formula(self):
        for _ in range(4):
            move = self.move()
            made = self.camera(move, "--fps", "8")
            path, e = spline(self.PATH), spline(self.TIMING, "values")
            speed = lambda x: numpy.linalg.norm(path(x, 1)) * 6  # per share of the domain
            knots = [0, 1 / 6, .5, 1]
            length = sum(quad(speed, a, b, epsabs=1e-13, epsrel=1e-13)[0] for a, b in zip(knots, knots[1:]))
            self.assertAlmostEqual(made["length"] / length, 1, delta=1e-12)
            numpy.testing.assert_allclose(made["time"], numpy.arange(41) / 8, atol=1e-15)
            numpy.testing.assert_allclose(made["distance"], length * e(made["time"] / 5), atol=1e-11 * length)
            share = (made["u"] - 2) / 6
            for s, d in zip(share, made["distance"]):
                edges = [0] + [k for k in knots[1:-1] if k < s] + [s]
                own = sum(quad(speed, a, b, epsabs=1e-13, epsrel=1e-13)[0] for a, b in zip(edges, edges[1:]))
                self.assertAlmostEqual(own, d, delta=1e-10 * length)
            numpy.testing.assert_allclose(made["positions"], path(share), atol=1e-9 * 20)
            base = spline(dict(move["orientation"]["base"], points=keys(move["orientation"]["base"]["points"])))
            turned = Rotation.from_quat(base(share))
            for level in move["orientation"]["levels"]:
                turned = turned * Rotation.from_rotvec(spline(clamped(level["details"], level["knots"]))(share))
            self.assertLess(angles(turned.as_quat(), made["rotations"]).max(), 1e-9)
            numpy.testing.assert_allclose(made["fov"], 30 + 20 * share, atol=1e-9)
            r = made["rotations"]
            self.assertGreater((r[1:] * r[:-1]).sum(axis=1).min(), 0)
            numpy.testing.assert_allclose((r * r).sum(axis=1), 1, atol=1e-14)

    def test_once_round(self):
        """A closed base that turns once round comes back as -q."""
        for n in (4, 7, 12):
            turn = numpy.pi * numpy.arange(n) / n
            base = [[0, 0, numpy.sin(a), numpy.cos(a)] for a in turn]
            base = [(numpy.array(q) * s).tolist() for q, s in zip(base, RANDOM.choice([-2, 3], n))]
            circle = {"degree": 3, "closed": True, "knots": list(range(9)),
                      "points": [[numpy.cos(a), numpy.sin(a), 0] for a in numpy.arange(8) * numpy.pi / 4]}
            move = {"path": circle, "orientation": {"mode": "free", "base": {"degree": 3, "closed": True, "knots": list(range(n + 1)), "points": base}}}
            made = self.camera(move, "--fps", "100")
            angle = Rotation.from_quat(made["rotations"]).as_rotvec()[:, 2]
            steps = numpy.diff(numpy.unwrap(angle))
            self.assertGreater(steps.min(), 0)
            self.assertAlmostEqual(steps.sum(), 2 * numpy.pi, delta=1e-9)
            self.assertLess(steps.max() / steps.mean(), 1.6)

    def test_table(self):
        move = self.move()
        made = self.camera(move, "--at", "5,0,2.5,-1,9")
        numpy.testing.assert_array_equal(made["u"], made["u"][[0, 1, 2, 1, 0]])
        name = self.folder / "table.csv"
        self.done("camera", self.file("move.json", move), "--at", "5,0,2.5,-1,9", "--out", str(name))
        rows = list(csv.reader(io.StringIO(name.read_text())))
        self.assertEqual(rows[0], "time,x,y,z,qx,qy,qz,qw,fov".split(","))
        table = numpy.array(rows[1:], float)
        numpy.testing.assert_array_equal(table[:, 1:4], made["positions"])
        numpy.testing.assert_array_equal(table[:, 4:8], made["rotations"])

    def test_levelled_path(self):
        """The path of a shape is its finest curve."""
        shape = {"base": clamped([[0, 0, 0], [1, 0, 2], [3, 1, 0], [4, 4, 1], [6, 2, 2], [7, 0, 0]]),
                 "levels": [{"knots": CLAMPED, "details": RANDOM.normal(size=(6, 3)).tolist()}]}
        finest = self.json("levels", self.file("shape.json", shape))["curves"][-1]
        move = {"path": shape, "orientation": {"mode": "along"}}
        made, plain = (self.camera(m, "--fps", "3") for m in (move, dict(move, path=finest)))
        for name in made:
            numpy.testing.assert_array_equal(made[name], plain[name])


class Along(Camera):
    def test_in_space(self):
        path = clamped([[0, 0, 0], [8, 1, 0], [9, 7, 5], [2, 9, 4], [0, 3, 9], [4, 0, 12]])
        first = numpy.array([0, 1, 5.])
        made = self.camera({"path": path, "orientation": {"mode": "along", "first": {"s": first.tolist()}}}, "--fps", "5")
        c = spline(path)
        x = numpy.linspace(0, 1, 40001)
        t = c(x, 1)
        t /= numpy.linalg.norm(t, axis=1)[:, None]
        s = numpy.empty_like(t)
        for i in range(len(t)):
            if i > 0:  # by the rotation that takes t[i - 1] to t[i]
                axis = numpy.cross(t[i - 1], t[i])
                first = first + numpy.cross(axis, first) + numpy.cross(axis, numpy.cross(axis, first)) / (1 + t[i - 1] @ t[i])
            first = first - t[i] * (first @ t[i])
            first /= numpy.linalg.norm(first)
            s[i] = first
        for u, q in zip(made["u"], made["rotations"]):
            at = int(round(u * 40000))
            own = numpy.array([numpy.cross(t[at], s[at]), s[at], -t[at]]).T
            self.assertLess((Rotation.from_matrix(own).inv() * Rotation.from_quat(q)).magnitude(), 3e-4)  # of the grid
        z = Rotation.from_quat(made["rotations"]).apply([0, 0, 1])
        tangent = c(made["u"], 1)
        numpy.testing.assert_allclose(z, -tangent / numpy.linalg.norm(tangent, axis=1)[:, None], atol=1e-12)

    def test_relative(self):
        """A constant base turns the camera in its own frame; a tripod runs evenly and stands still."""
        path = clamped([[0, 0], [3, 4], [6, 1], [9, 2], [11, 5], [12, 0]])
        plain = self.camera({"path": path, "orientation": {"mode": "along"}}, "--fps", "7")
        q = [0.1, -0.3, 0.2, 0.9]
        base = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [q, q]}
        turned = self.camera({"path": path, "orientation": {"mode": "along", "base": base}}, "--fps", "7")
        own = Rotation.from_quat(plain["rotations"]) * Rotation.from_quat(q)
        self.assertLess(angles(own.as_quat(), turned["rotations"]).max(), 1e-12)
        still = self.camera({"path": clamped([[3, 4, 5]] * 6), "orientation": {"mode": "free", "base": base},
                             "timing": {"duration": 8}}, "--fps", "2")
        self.assertEqual(still["length"], 0)
        numpy.testing.assert_allclose(still["u"], numpy.arange(17) / 16, atol=1e-15)


class LookAt(Camera):
    def look(self, path, target, up=(0, 0, 1), rate=2000, duration=2, **more):
        move = {"path": path, "orientation": {"mode": "look-at", "target": target, "up": list(up), **more},
                "timing": {"duration": duration}}
        return self.camera(move, "--fps", str(rate))

    def check_aim(self, made, target):
        turn = Rotation.from_quat(made["rotations"])
        away = made["positions"] - target
        away /= numpy.linalg.norm(away, axis=1)[:, None]
        self.assertLess(numpy.linalg.norm(numpy.cross(turn.apply([0, 0, 1]), away), axis=1).max(), 1e-12)
        self.assertGreater((turn.apply([0, 0, 1]) * away).sum(axis=1).min(), 0)
        return turn, away

    def test_level(self):
        up = numpy.array([.2, -.1, 1])
        up /= numpy.linalg.norm(up)
        path = clamped([[9, 0, 2], [5, 8, 3], [-4, 9, 1], [-9, 0, 4], [-4, -8, 2], [5, -6, 1]])
        made = self.look(path, [.5, .3, 1], up, rate=50)
        turn, away = self.check_aim(made, numpy.array([.5, .3, 1]))
        self.assertLess(abs(turn.apply([1, 0, 0]) @ up).max(), 1e-12)
        self.assertGreater((turn.apply([0, 1, 0]) @ up).min(), 0)

    def passes(self, miss):
        """Over the target, past the zenith at so small a distance."""
        return clamped([[-9, miss, 10], [-6, miss, 10], [-2, miss, 10], [2, miss, 10], [6, miss, 10], [9, miss, 10]])

    def test_zenith(self):
        for miss in (.3, .01, 1e-5, 0):
            for sign in (1, -1):
                made = self.look(self.passes(miss), [0, 0, 0], (0, 0, sign))
                turn, away = self.check_aim(made, numpy.zeros(3))
                step = (turn[1:] * turn[:-1].inv()).magnitude()
                self.assertLess(numpy.degrees(step.max()), 3)
                outside = abs(away[:, 2]) < numpy.cos(numpy.radians(5))
                self.assertLess(abs(turn.apply([1, 0, 0])[outside][:, 2]).max(), 1e-12)
                self.assertGreater(sign * turn.apply([0, 1, 0])[outside][:, 2].min() if sign > 0 else -turn.apply([0, 1, 0])[outside][:, 2].max(), 0)

    def test_roll_in_the_cone(self):
        """Against y carried along by very many least rotations, and a smoothstep."""
        path, target = clamped([[-9, 1, 10], [-6, -1, 12], [-2, .6, 9], [2, .4, 11], [6, 1, 10], [9, -2, 10]]), numpy.array([.1, .2, 0])
        c = spline(path)
        gaze = lambda x: (c(x) - target) / numpy.linalg.norm(c(x) - target)
        f = lambda x: gaze(x)[2] - numpy.cos(numpy.radians(5))
        x = numpy.linspace(0, 1, 2001)
        inside = numpy.array([f(v) > 0 for v in x])
        first, last = numpy.flatnonzero(inside)[[0, -1]]
        self.assertTrue(inside[first:last].all())
        a, b = brentq(f, x[first - 1], x[first], xtol=1e-15), brentq(f, x[last], x[last + 1], xtol=1e-15)
        upright = lambda z: (numpy.array([0, 0, 1]) - z * z[2]) / numpy.linalg.norm(numpy.array([0, 0, 1]) - z * z[2])
        grid = numpy.linspace(a, b, 20001)
        z = numpy.array([gaze(v) for v in grid])
        y = numpy.empty_like(z)
        y[0] = upright(z[0])
        for i in range(1, len(z)):  # by the rotation that takes one gaze to the next
            axis, v = numpy.cross(z[i - 1], z[i]), y[i - 1]
            v = v + numpy.cross(axis, v) + numpy.cross(axis, numpy.cross(axis, v)) / (1 + z[i - 1] @ z[i])
            v -= z[i] * (v @ z[i])
            y[i] = v / numpy.linalg.norm(v)
        end = upright(z[-1])
        roll = numpy.arctan2(end @ numpy.cross(z[-1], y[-1]), end @ y[-1])
        made = self.look(path, target.tolist(), rate=200)
        checked = 0
        for u, q in zip(made["u"], made["rotations"]):
            if not a < u < b:
                continue
            at = (u - a) / (b - a)
            i = int(round(at * 20000))
            angle = roll * at * at * (3 - 2 * at)
            own = numpy.cos(angle) * y[i] + numpy.sin(angle) * numpy.cross(z[i], y[i])
            self.assertLess(numpy.linalg.norm(Rotation.from_quat(q).apply([0, 1, 0]) - own), 3e-4)  # of the grid
            checked += 1
        self.assertGreater(checked, 10)

    def test_moving_target(self):
        target = {"degree": 2, "closed": False, "knots": [5, 5, 5, 7, 9, 9, 9], "points": [[0, 0, 0], [3, 1, 0], [1, 4, 2], [0, 0, 5]]}
        path = clamped([[9, 0, 2], [5, 8, 3], [-4, 9, 1], [-9, 0, 4], [-4, -8, 2], [5, -6, 1]])
        made = self.look(path, target, rate=50)
        self.check_aim(made, spline(target)(made["u"]))

    def test_closed(self):
        """Round the zenith and over the seam: no jump there either."""
        points = [[2 * numpy.cos(a) + 1.9, 2 * numpy.sin(a), 10] for a in numpy.pi + numpy.arange(8) * numpy.pi / 4]
        made = self.look({"degree": 3, "closed": True, "knots": list(range(9)), "points": points}, [0, 0, 0], rate=1000)
        turn, _ = self.check_aim(made, numpy.zeros(3))
        step = (turn[1:] * turn[:-1].inv()).magnitude()
        self.assertLess(numpy.degrees(step.max()), 3)
        self.assertLess(angles(made["rotations"][:1], made["rotations"][-1:]).max(), 1e-9)

    def test_through_the_target(self):
        path = clamped([[-9, 0, 0], [-6, 0, 0], [-2, 0, 0], [2, 0, 0], [6, 0, 0], [9, 0, 0]])
        move = {"path": path, "orientation": {"mode": "look-at", "target": [0, 0, 0], "up": [0, 0, 1]}, "timing": {"duration": 2}}
        result = self.run_program("camera", self.file("move.json", move), "--at", "0,0.5,1,1.5,2")
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"passes its target", result.stderr)
        far = self.file("far.json", {"path": {"degree": 1, "knots": [0, 0, 1, 1], "points": [[-5, 0, 0], [5, 1e75, 0]]},
                                     "orientation": {"mode": "look-at", "target": [-5, 0, 0]}})
        for words in (("--out", "x.glb"), ("--out", "no/folder/x.csv"), ("--out", "x.glb", "--scene", "none.batten")):
            self.refused(1, "camera", far, "--fps", "5", *words)  # one line: the remark waits for a result
        self.assertNotIn("fov", self.refused(1, "camera", far, "--fps", "5", "--out", "x.glb"))
        self.assertIn("path: expected numbers up to 3e38, found 5e+73", self.refused(1, "camera", far, "--fps", "5", "--out", "x.glb"))
        made = self.camera(move, "--at", "0,0.5,1,1.5,2")
        numpy.testing.assert_allclose(angles(made["rotations"][[0, 0, 4]], made["rotations"][[1, 2, 3]]), 0, atol=1e-12)
        self.assertAlmostEqual(angles(made["rotations"][:1], made["rotations"][4:])[0], numpy.pi, delta=1e-9)


class Player(Camera):
    """Reads the file as a player does: cubic spans by glTF's formula, rotations made unit, numbers as 32-bit floats."""

    def played(self, move, *words):
        name = self.folder / "scene.glb"
        self.done("camera", self.file("move.json", move), "--fps", "2", "--out", str(name), *words)
        data = name.read_bytes()
        magic, version, total, length = struct.unpack_from("<4sIII", data)
        self.assertEqual((magic, version, total), (b"glTF", 2, len(data)))
        scene, numbers = json.loads(data[20:20 + length]), data[28 + length:]

        def read(index):
            accessor = scene["accessors"][index]
            view = scene["bufferViews"][accessor["bufferView"]]
            size = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
            return numpy.frombuffer(numbers, "<f4", accessor["count"] * size, view["byteOffset"]).astype(float).reshape(-1, size)

        tracks = {}
        (animation,) = scene["animations"]
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            self.assertEqual(sampler["interpolation"], "CUBICSPLINE")
            times, values = read(sampler["input"])[:, 0], read(sampler["output"])
            self.assertTrue((numpy.diff(times) > 0).all())
            tracks[channel["target"]["path"]] = times, values.reshape(len(times), 3, -1)
        return scene, tracks

    def at(self, track, time):
        times, values = track
        i = numpy.clip(numpy.searchsorted(times, time, "right") - 1, 0, len(times) - 2)
        length = (times[i + 1] - times[i])[:, None]
        x = numpy.clip((time - times[i])[:, None] / length, 0, 1)
        y = 1 - x
        return (values[i, 1] * y * y * (1 + 2 * x) + values[i, 2] * length * x * y * y + values[i + 1, 1] * x * x * (3 - 2 * x)
                - values[i + 1, 0] * length * x * x * y)

    def agrees(self, move, duration, place, angle, fov):
        scene, tracks = self.played(move)
        told = scene["animations"][0]["extras"]["within"]  # the file says to what it agrees
        self.assertLessEqual(told["position"], 1.01 * place)
        self.assertAlmostEqual(told["degrees"], angle, delta=1e-12)
        place, angle = told["position"], told["degrees"]
        times = RANDOM.uniform(0, duration, 300)
        own = self.camera(move, "--at", ",".join(map(repr, times.tolist())))
        self.assertLess(numpy.linalg.norm(self.at(tracks["translation"], times) - own["positions"], axis=1).max(), place)
        self.assertLess(numpy.degrees(angles(self.at(tracks["rotation"], times), own["rotations"]).max()), angle)
        lens = scene["cameras"][0]["perspective"]
        if "pointer" in tracks:
            self.assertEqual(scene["extensionsUsed"], ["KHR_animation_pointer"])
            self.assertLess(abs(numpy.degrees(self.at(tracks["pointer"], times)[:, 0]) - own["fov"]).max(), .1)
        else:
            numpy.testing.assert_allclose(own["fov"], fov)
        self.assertAlmostEqual(numpy.degrees(lens["yfov"]), fov, delta=1e-4)
        return scene, tracks

    def test_moves(self):
        for _ in range(3):
            move = Free.move(Free)
            scene, tracks = self.agrees(move, 5, 1e-4 * 18, .1, 30)
            self.assertIn("pointer", tracks)
            self.assertEqual([m["primitives"][0]["mode"] for m in scene["meshes"]], [3])
        look = {"path": clamped([[-9, .2, 10], [-6, .2, 10], [-2, 0, 10], [2, 0, 10], [6, 0, 10], [9, 0, 10]]),
                "orientation": {"mode": "look-at", "target": [0, 0, 0]}, "timing": {"duration": 2}}
        self.agrees(look, 2, 1e-4 * 18, .1, 40)
        told = subprocess.run(["assimp", "info", str(self.folder / "scene.glb")], capture_output=True).stdout.decode()
        self.assertRegex(told, r"Cameras:\s+1\n")
        self.assertRegex(told, r"Animations:\s+1\n")

    def test_scene(self):
        """The surfaces and curves of a drawing lie in the scene, too; hidden ones and cameras do not."""
        sheet = {"degree": [1, 1], "closed": [False, False], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0, 0], [0, 9, 1]], [[9, 0, 2], [9, 9, 0]]]}
        move = Free.move(Free)
        drawing = self.file("scene.batten", {"batten": 2, "objects": [
            {"id": 1, "kind": "surface", "surface": sheet}, {"id": 2, "kind": "surface", "surface": sheet, "hidden": True},
            {"id": 3, "kind": "path", "curves": [clamped([[0, 0], [1, 1], [2, 0], [3, 1]], [0, 0, 0, 0, 1, 1, 1, 1])]}, {"id": 4, "kind": "camera", "move": move}]})
        scene, tracks = self.played(move, "--scene", drawing)
        self.assertEqual([m["primitives"][0]["mode"] for m in scene["meshes"]], [3, 4, 3])
        self.assertEqual(scene["scenes"][0]["nodes"], [0, 1, 2, 3])
        self.assertEqual([c["target"].get("node") for c in scene["animations"][0]["channels"]][:2], [3, 3])
        told = subprocess.run(["assimp", "info", str(self.folder / "scene.glb")], capture_output=True).stdout.decode()
        self.assertRegex(told, r"Meshes:\s+3\n")
        self.assertRegex(told, r"Cameras:\s+1\n")
        pyramid = {"vertices": [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]], "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}
        square = {"vertices": [[10, 0, 0], [14, 0, 0], [14, 4, 1], [10, 4, 1]], "faces": [[0, 1, 2, 3]]}
        solid = self.file("meshes.batten", {"batten": 6, "objects": [
            {"id": 1, "kind": "mesh", "mesh": pyramid}, {"id": 2, "kind": "mesh", "mesh": square},
            {"id": 3, "kind": "mesh", "mesh": square, "hidden": True}, {"id": 4, "kind": "surface", "surface": sheet}]})
        scene, tracks = self.played(move, "--scene", solid)  # meshes come as triangles, not as lines along their edges
        modes = [m["primitives"][0]["mode"] for m in scene["meshes"]]
        self.assertEqual(sorted(modes), [3, 4, 4])
        (faces,) = [m["primitives"][0] for m in scene["meshes"]
                    if m["primitives"][0]["mode"] == 4 and scene["accessors"][m["primitives"][0]["indices"]]["count"] == 18]
        place = scene["accessors"][faces["attributes"]["POSITION"]]
        self.assertEqual((place["count"], place["min"], place["max"]), (8, [0, 0, 0], [14, 6, 6]))
        name = self.file("move.json", move)
        self.refused(2, "camera", name, "--fps", "2", "--scene", drawing)
        self.refused(2, "camera", name, "--fps", "2", "--out", "x.csv", "--scene", drawing)
        self.refused(2, "camera", "-", "--fps", "2", "--out", "x.glb", "--scene", "-")
        self.refused(1, "camera", name, "--fps", "2", "--out", "x.glb", "--scene", "none.batten")

    def test_tripod(self):
        turn = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0, 0, 1], [0, 0, 1, 1]]}
        scene, _ = self.agrees({"path": clamped([[3, 4, 5]] * 6), "orientation": {"mode": "free", "base": turn}}, 4, 1e-4, .1, 40)
        self.assertNotIn("meshes", scene)
        self.bad({"path": clamped([[3, 4, 5]] * 6), "fov": 180, "orientation": {"mode": "free", "base": turn}}, "180", "--fps", "2", "--out", str(self.folder / "x.glb"))
        self.assertFalse((self.folder / "x.glb").exists())


class Bad(Camera):
    BASE = clamped([[0, 0, 0, 1]] * 6)
    MOVE = {"path": Free.PATH, "orientation": {"mode": "free", "base": BASE}}

    def test_data(self):
        move, base, orientation = self.MOVE, self.BASE, self.MOVE["orientation"]
        with_base = lambda points: dict(move, orientation={"mode": "free", "base": dict(base, points=points)})
        self.bad(with_base([[0, 0, 0, 1]] * 5 + [[0, 0, 0, 0]]), "cancel")
        line = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1]}
        opposed = dict(line, points=[[1, 0, 0, 0], [0, 0, 0, 1]])
        self.done("camera", self.file("m.json", dict(move, orientation={"mode": "free", "base": opposed})), "--at", "1")
        self.bad(with_base([[0, 0, 1]] * 6), "4 numbers")
        self.bad(dict(move, timing={"duration": 0}), "duration")
        self.bad(dict(move, timing={"duration": -3}), "duration")
        self.bad(dict(move, timing={"duration": 1e10}), "duration")
        for values in ([0, .6, .5, 1], [.1, .2, .3, 1], [0, .2, .3, .9]):
            self.bad(dict(move, timing={"duration": 1, "curve": {"degree": 2, "knots": [0, 0, 0, .4, 1, 1, 1], "values": values}}), "never fall")
        self.bad(dict(move, orientation={"mode": "look-at", "target": [0, 0, 0], "up": [0, 0, 0]}), "up")
        self.bad(dict(move, path=clamped([[1, 2, 3]] * 6), orientation={"mode": "look-at", "target": [1, 2, 3]}), "target")
        self.bad(dict(move, orientation={"mode": "free"}), "base")
        self.bad(dict(move, orientation={"mode": "sideways"}), "look-at")
        self.bad(dict(move, orientation=dict(orientation, levels=[{"knots": [0, 1], "details": [[0, 0, 0]] * 6}])), "knots")
        self.bad(move, "10000000", "--fps", "1e8")

    def test_usage(self):
        name = self.file("move.json", self.MOVE)
        for words in ([], ["--fps", "2", "--at", "1"], ["--fps", "0"], ["--fps", "2", "--out", "scene.txt"], ["--at", "nan"]):
            self.refused(2, "camera", name, *words)


if __name__ == "__main__":
    unittest.main()
