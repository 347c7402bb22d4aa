#!/usr/bin/env python3
"""The Python package, built by pip and installed into an empty folder: beside scipy, with views, types and errors; and the page
docs/python.md, whose code is run. Usage: BATTEN_LIBRARY=libbatten.so test_python.py ROOT
"""
import ast
import copy
import dataclasses
import doctest
import gc
import inspect
import multiprocessing
import os
import pathlib
import pickle
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np
from scipy import integrate, interpolate, optimize

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
PLACE = tempfile.TemporaryDirectory()
subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-index", "--no-deps", "--no-cache-dir", "--target", PLACE.name, ROOT],
               check=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
sys.path.insert(0, PLACE.name)
import batten  # noqa: E402

X = np.linspace(0, 200, 201)
WAVE = np.column_stack([X, 40 * np.sin(X / 20)])
OVER = np.column_stack([X[50:110], 40 * np.sin(X[50:110] / 20) + 8 * np.sin(np.pi * np.arange(60) / 59)])
PICTURE = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -48 210 102" width="420" height="204" fill="none">'
           '<rect x="-5" y="-48" width="210" height="102" fill="#fff"/>{}</svg>\n')


def random_curve(random, degree, dimension):
    count = int(random.integers(degree + 1, 14))
    knots = np.r_[np.zeros(degree), np.linspace(0, 1, count - degree + 1), np.ones(degree)]
    knots[degree + 1:count] = np.sort(random.uniform(0.05, 0.95, count - degree - 1))
    points = random.normal(size=(count, dimension))
    return batten.curve(points, knots, degree=degree), knots, points


class BesideScipy(unittest.TestCase):
    def test_values_and_derivatives(self):
        random = np.random.default_rng(1)
        for _ in range(30):
            degree = int(random.integers(1, 6))
            curve, knots, points = random_curve(random, degree, int(random.integers(2, 4)))
            u = np.sort(random.uniform(0, 1, 40))
            got = curve.at_many(u, order=2)
            for order in range(min(degree, 2) + 1):
                theirs = np.column_stack(interpolate.splev(u, (knots, list(points.T), degree), der=order))
                np.testing.assert_allclose(got[:, order], theirs, atol=1e-9 * (1 + abs(theirs).max()))

    def test_knots_in_and_degree_up_keep_the_curve(self):
        random = np.random.default_rng(2)
        curve, knots, points = random_curve(random, 3, 2)
        finer = curve.insert_knot(0.5, times=2)
        theirs = interpolate.insert(0.5, (knots, list(points.T), 3), m=2)
        np.testing.assert_allclose(finer.points, np.column_stack(theirs[1])[:finer.count], atol=1e-12)
        self.assertLess(curve.elevate(5).hausdorff(curve, 1e-9).distance, 1e-9)

    def test_length_and_closest_point(self):
        curve = batten.fit(WAVE, tolerance=0.01)
        speed = lambda u: np.hypot(*curve.at(u, order=1)[1])  # noqa: E731
        theirs = sum(integrate.quad(speed, a, b)[0] for a, b in zip(np.unique(curve.knots), np.unique(curve.knots)[1:]))
        self.assertAlmostEqual(curve.length(), theirs, delta=1e-6)
        for place in np.random.default_rng(3).uniform([0, -60], [200, 60], (10, 2)):
            near = curve.nearest(place)
            away = lambda u: np.hypot(*(curve.at(float(u)) - place))  # noqa: E731
            step = (curve.domain[1] - curve.domain[0]) / 300
            start = min(curve.spread(301), key=away)
            theirs = optimize.minimize_scalar(away, bounds=(start - step, start + step), method="bounded", options={"xatol": 1e-10})
            self.assertLessEqual(near.distance, theirs.fun + 1e-9)
            self.assertAlmostEqual(near.distance, theirs.fun, delta=1e-6)

    def test_fit_has_no_more_knots_than_splprep_for_the_same_error(self):
        noisy = WAVE + np.random.default_rng(4).normal(scale=0.1, size=WAVE.shape)
        for points in (WAVE, noisy):
            ours = batten.fit(points, tolerance=0.5)
            error = max(ours.nearest(point).distance for point in points)
            self.assertLessEqual(error, 0.5)
            spline, _ = interpolate.splprep(points.T, s=len(points) * (error / 2) ** 2)
            self.assertLessEqual(ours.count, len(spline[1][0]) + 2)


class Arrays(unittest.TestCase):
    def test_forms(self):
        curve = batten.fit(WAVE)
        self.assertEqual(batten.fit(WAVE.tolist()), curve)
        self.assertEqual(batten.fit(WAVE.ravel()), curve)
        self.assertEqual(batten.fit(np.asfortranarray(WAVE)), curve)
        space = np.column_stack([WAVE, X])
        self.assertEqual(batten.fit(space), batten.fit(space.ravel(), dimension=3))

    def test_numbers_are_not_copied(self):
        from batten._library import doubles
        self.assertTrue(np.shares_memory(doubles(WAVE, "x"), WAVE))
        curve = batten.fit(WAVE)
        points, expected = curve.points, curve.points.copy()
        self.assertFalse(points.flags.owndata or points.flags.writeable)
        self.assertEqual(points.ctypes.data, curve.points.ctypes.data)
        del curve
        gc.collect()
        other = [batten.fit(WAVE * k) for k in range(1, 20)]
        np.testing.assert_array_equal(points, expected)
        self.assertEqual(len(other), 19)

    def test_memory_is_given_back(self):
        def rounds(count):
            for _ in range(count):
                one = batten.clamped([[0, 0], [1, 2], [3, 3], [4, 0]] * 50)
                one.flatten(0.01)
                one.split(1.0)
                with self.assertRaises(batten.BattenError):
                    one.elevate(99)
            gc.collect()
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.assertLess(rounds(600) - rounds(200), 3000)  # kB; 600 rounds that kept it would take 15,000


class Hands(unittest.TestCase):
    def test_sketch_live_is_the_same_as_at_once(self):
        curve = batten.fit(WAVE)
        drawn, live = curve.sketch(OVER), curve.live()
        for place in OVER:
            live.add(*place)
        self.assertEqual(live.preview().report.target.shape[1], 2)
        self.assertEqual(live.commit(), drawn)
        self.assertLess(drawn.nearest(OVER[30]).distance, 1.0)
        new, again = batten.sketch(OVER), batten.live()
        again.add_many({"points": OVER, "pressure": np.full(60, 0.5)})
        self.assertEqual(again.commit(), new)

    def test_spline_frames_levels_regions(self):
        spline = batten.spline([[0, 0], [10, 20], [30, 5]], tangents=[None, [1, 0], None])
        near = spline.nearest([10, 20])
        self.assertLess(near.distance, 1e-9)
        self.assertAlmostEqual(spline.at(near.u, order=1)[1, 1], 0)
        u, point, t, s, r = batten.fit(np.column_stack([np.cos(X / 9), np.sin(X / 9), X / 20]), tolerance=1e-3).frames(20)
        np.testing.assert_allclose(np.cross(t, s), r, atol=1e-12)
        self.assertEqual((u.shape, point.shape), ((20,), (20, 3)))
        shape = batten.fit(WAVE, tolerance=0.05).levels(2)
        before, middle = shape.flatten(), shape.curve(0).domain.mean()
        target = shape.curve(0).at(middle) + [0, 5]
        np.testing.assert_allclose(shape.drag(0, middle, [0, 5]).curve(0).at(middle), target, atol=1e-9)
        self.assertGreater(shape.flatten().hausdorff(before, 0.01).distance, 1)
        square = batten.clamped([[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]], degree=1).close()
        other = square.transform([1, 0, 5, 0, 1, 5])
        self.assertAlmostEqual(batten.combine("difference", [square, [other]], 0.01)[0].area, 75, places=6)
        self.assertEqual(len(square.intersect(other, 0.01).crossings), 2)

    def test_counts_of_nothing(self):
        line = batten.clamped([[0, 0], [9, 0]], degree=1)
        self.assertEqual(line.inflections().size, 0)
        self.assertEqual(line.nearest_all([4, 3], within=0.5), [])
        self.assertEqual(len(line.nearest_all([4, 3], within=5)), 1)


class Errors(unittest.TestCase):
    def test_each_says_what_is_wrong(self):
        curve = batten.fit(WAVE)
        for status, call in {
            "count": [lambda: batten.fit([]), lambda: batten.fit([[1, 2]]), lambda: batten.fit(np.zeros(7)), lambda: curve.transform([1]),
                      lambda: curve.blossom(0.0, [1.0]), lambda: batten.sketch({"points": OVER, "pressure": [1]})],
            "number": [lambda: batten.fit([[np.nan, 2], [3, 4]]), lambda: curve.insert_knot(np.inf)],
            "argument": [lambda: batten.fit(None), lambda: batten.fit("x"), lambda: batten.fit([[1, 2], [3]]), lambda: curve.at("a"),
                         lambda: curve.is_equal(3), lambda: curve.levels(1).gain(7), lambda: batten.combine("both", [], 0.1)],
            "degree": [lambda: curve.elevate(99)], "far": [lambda: curve.sketch(OVER + 1e4)],
            "dimension": [lambda: curve.join(curve.to_dimension(3))], "parameter": [lambda: curve.split(1e9)],
        }.items():
            for one in call:
                with self.assertRaises(batten.BattenError) as caught:
                    one()
                self.assertIn(caught.exception.status, (status, "parameter") if status == "number" else (status,))
        with self.assertRaises(TypeError):
            batten.fit(WAVE, tolerence=1)
        with self.assertRaises(TypeError):
            batten.fit()
        live = curve.live()
        live.add_many(OVER)
        live.commit()
        with self.assertRaisesRegex(batten.BattenError, "committed"):
            live.preview()

    def test_what_is_refused_has_a_name(self):
        line = batten.clamped([[0, 0], [1, 1]], degree=1)
        for call, said in ((lambda: batten.combine("union", [[line]], 0.1), r"^regions\[0\]\[0\]: expected a closed curve in the plane, found an open one"),
                           (lambda: batten.combine("union", [line.to_dimension(3)], 0.1), r"^regions\[0\]: .*found one in space"),
                           (lambda: batten.loft([line]), "^sections: "),
                           (lambda: line.open_at(0.5), "out of range: an open one \\(<Curve of degree 1"),
                           (lambda: batten.fit(WAVE, tolerance=0.1).elevate(2), "^degree: expected 3 to 7, found 2"),
                           (lambda: line.levels(2), r"\(<Curve of degree 1, 2 points>\.levels\(levels=2\)\)$")):
            with self.assertRaisesRegex(batten.BattenError, said):
                call()
        with self.assertRaisesRegex(TypeError, "by name tolerance, .*found 2 without a name"):
            batten.fit([[0, 0], [1, 1]], 0.5)
        with self.assertRaisesRegex(TypeError, "knots is missing"):
            batten.curve([[0, 0], [1, 1]])

    def test_a_place_in_the_plane_has_two_numbers(self):
        line, across = batten.clamped([[0, 0], [2, 2]], degree=1), batten.clamped([[0, 2], [2, 0]], degree=1)
        self.assertEqual(line.nearest([1, 1]).point.tolist(), [1, 1])
        self.assertEqual(line.finder().nearest([1, 1]).point.shape, (2,))
        self.assertEqual(line.intersect(across, 1e-6).crossings[0].point.shape, (2,))
        self.assertEqual(line.to_dimension(3).nearest([1, 1, 0]).point.shape, (3,))


@dataclasses.dataclass
class Holder:
    curve: object
    shape: object


def halfway(curve):
    return curve.at(float(curve.domain.mean()))


def elevated(curve):
    return curve.elevate(7).elevate(8)


class Values(unittest.TestCase):
    def setUp(self):
        self.open = batten.fit(WAVE)
        self.closed = batten.curve([[0, 0], [1, 0], [1, 1], [0, 1]], np.arange(5.0), degree=2, closed=True)
        self.shape = self.open.levels(2)
        self.shape.drag(0, 0.5, [0, 5]).set_gain(1, 2.0).set_muted(2, True).commit()

    def test_copy_compare_hash_and_pickle(self):
        for curve in (self.open, self.closed, self.open.to_dimension(3)):
            for other in (copy.copy(curve), copy.deepcopy(curve), pickle.loads(pickle.dumps(curve))):
                self.assertEqual((other, hash(other), other.report), (curve, hash(curve), curve.report))
                self.assertEqual({curve: "found"}[other], "found")
        self.assertNotEqual(self.open, self.closed)
        self.assertNotEqual(self.open, 3)
        for other in (copy.deepcopy(self.shape), pickle.loads(pickle.dumps(self.shape))):
            self.assertEqual([other.curve(level) for level in range(3)], [self.shape.curve(level) for level in range(3)])
            self.assertEqual((other.gain(1), other.is_muted(2), other.options), (2.0, True, self.shape.options))
            before = self.shape.curve(0)
            other.drag(0, 0.5, [0, 1])
            self.assertEqual(self.shape.curve(0), before)
        finder, chain = self.open.finder(), self.open.frame_chain(rule="fixed")
        for make in (copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))):
            self.assertEqual(make(finder).nearest([1, 2]), finder.nearest([1, 2]))
            self.assertEqual(make(chain).at(0.3), chain.at(0.3))
        kept = dataclasses.asdict(Holder(self.open, self.shape))
        self.assertEqual(kept["curve"], self.open)
        self.assertEqual(pickle.loads(pickle.dumps(self.open.bounds)).low.tolist(), self.open.bounds.low.tolist())
        for live in (self.open.live(), self.shape.live(0)):
            for make in (copy.copy, copy.deepcopy, pickle.dumps):
                with self.assertRaisesRegex(TypeError, "cannot be copied or pickled"):
                    make(live)

    def test_what_ends_gives_back_what_others_need(self):
        points, finder, other = self.open.points, self.open.finder(), copy.copy(self.open)
        with self.open:
            pass
        self.assertEqual(points.shape, (other.count, 2))
        self.assertEqual(finder.nearest(points[0]).distance, 0)
        with self.assertRaisesRegex(batten.BattenError, "freed"):
            self.open.at(0.5)

    def test_processes(self):
        with multiprocessing.get_context("fork").Pool(2) as pool:
            for found in pool.map(halfway, [self.open] * 4):
                np.testing.assert_array_equal(found, halfway(self.open))
            with self.assertRaisesRegex(batten.BattenError, "degree: expected a whole number from 1 to 7, found 8"):
                pool.map(elevated, [self.open])
        fresh = "import pickle, sys; curve = pickle.load(sys.stdin.buffer); print(curve.count)"
        told = subprocess.run([sys.executable, "-c", fresh], input=pickle.dumps(self.open), capture_output=True, env={**os.environ, "PYTHONPATH": PLACE.name})
        self.assertEqual(told.stdout.decode().strip(), str(self.open.count), told.stderr.decode())

    def test_threads_and_forks_amid_them(self):
        live, middle, faults = self.open.live(), float(self.shape.curve(0).domain.mean()), []
        before = self.shape.curve(0).at(middle)

        def draw():
            try:
                for k in range(200):
                    live.add(0.1 * k, 2.0 + k % 3)
                    self.shape.drag(0, middle, [0, 0.01])
            except Exception as error:  # noqa: BLE001: whatever it is
                faults.append(error)

        threads = [threading.Thread(target=draw) for _ in range(8)]
        for thread in threads:
            thread.start()
        for _ in range(5):
            child = os.fork()
            if not child:
                self.shape.drag(0, middle, [0, 1])
                os._exit(0)
            self.assertEqual(os.waitpid(child, 0)[1], 0)
        for thread in threads:
            thread.join()
        self.assertEqual(faults, [])
        np.testing.assert_allclose(self.shape.curve(0).at(middle), before + [0, 16], atol=1e-6)

    def test_places(self):
        middle, end = float(self.open.domain.mean()), self.open.domain[1]
        np.testing.assert_array_equal(self.open(middle), self.open.at_many([middle])[0])
        u = np.array([[0.0, middle], [middle, end]])
        self.assertEqual((self.open(u).shape, self.open(u, order=1).shape), ((2, 2, 2), (2, 2, 2, 2)))
        np.testing.assert_allclose(self.open(u)[1, 1], self.open.at(end), rtol=1e-14)
        back = np.random.default_rng(5).permutation(self.open.spread(30))
        np.testing.assert_allclose(self.open(back), [self.open.at(one) for one in back], rtol=1e-12, atol=1e-12)
        np.testing.assert_array_equal(self.open(np.float32(0.5)), self.open(0.5))

    def test_numbers_of_any_kind(self):
        for points in (WAVE[::-1][::-1], np.asfortranarray(WAVE), WAVE.astype(">f8"), np.broadcast_to(WAVE, WAVE.shape)):
            self.assertEqual(batten.fit(points), self.open)
        self.assertEqual(batten.fit(WAVE.astype(np.float32)), batten.fit(WAVE.astype(np.float32).astype(float)))
        self.assertEqual(batten.clamped(np.array([[0, 0], [3, 4]], dtype=np.int8), degree=1).length(), 5)
        bytes_ = np.frombuffer(b"x" + WAVE.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(WAVE.shape)
        self.assertEqual(batten.fit(bytes_), self.open)
        spline = interpolate.BSpline(self.open.knots, self.open.points, self.open.degree)
        np.testing.assert_allclose(spline(0.5), self.open(0.5), atol=1e-12)


class Whole(unittest.TestCase):
    """All of the library but the editor."""

    def setUp(self):
        curve = batten.fit(WAVE, tolerance=0.5).to_dimension(3)
        self.sections = [curve.transform([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 10 * height]) for height in range(4)]
        self.surface = batten.loft(self.sections)

    def test_path_to_path(self):
        document = batten.read_svg('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1L5 1L5 5L1 5Z"/><path d="M4 4L8 4L8 8L4 8Z"/><text>a</text></svg>')
        self.assertEqual(sum(document.report.lost.count), batten.losses_total(document.report.lost))
        curves = [curve.simplify(0.01) for one in document.objects for curve in one.curves]
        grown = batten.offset_region(batten.combine("union", curves, tolerance=0.001), 1, tolerance=0.001, join="miter")
        self.assertAlmostEqual(sum(curve.area for curve in grown), 6 * 6 * 2 - 3 * 3, delta=0.01)
        out = batten.document()
        out.set_page([0, 0, 10, 10]).add(batten.path_object(grown, name="grown", style={"filled": True, "stroked": False}))
        again = batten.read_svg(out.to_svg())
        self.assertTrue(again.report.native)
        self.assertEqual((again.objects[0].curves, again.digest), (grown, out.digest))
        for text in (out.to_dxf(), out.to_gcode(feed=500.0), out.to_glif()):
            self.assertGreater(len(text), 50)

    def test_loft_wire_and_stl(self):
        surface, line = self.surface, self.sections[0]
        np.testing.assert_allclose(surface.at(line.domain[0], 0), line.at(line.domain[0]), atol=1e-9)
        points = surface.points.reshape(-1, 3)
        moved = batten.bind([{"reference": line, "radius": 100.0}], points).apply([line.transform([1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1, 0])])
        self.assertAlmostEqual(moved.report.largest, 7, delta=1e-9)
        bent = batten.surface(moved.points.reshape(surface.points.shape), surface.knots("u"), surface.knots("v"), degree=(surface.degree("u"), surface.degree("v")))
        np.testing.assert_allclose(bent.at(line.domain[0], 0), line.at(line.domain[0]) + [0, 7, 0], atol=1e-9)
        data = batten.write_stl(bent, tolerance=0.1)
        self.assertEqual(len(data), 84 + 50 * int.from_bytes(data[80:84], "little"))
        self.assertEqual(batten.read_step(batten.write_step(bent)).surfaces, [bent])

    def test_values(self):
        camera, relief = self.sections[0].camera(mode="along"), self.surface.levels(1)
        camera.add_shake(7, 0.1, 2.0)
        document, mesh = batten.document(), batten.mesh(np.eye(3), [[0, 1, 2]])
        document.add(batten.surface_object(self.surface, name="ж"))
        sweep = self.sections[0].sweep(batten.clamped([[-1, 0], [0, 1], [1, 0]], degree=2), twist=1.0)
        take = batten.take([{"name": "hip", "parent": -1, "offset": [0, 0, 0], "channels": ["x_rotation"]}], [[1.0], [5.0], [2.0]], 0.1)
        says = {self.surface: lambda one: one, mesh: lambda one: one, camera: lambda one: one.write(), relief: lambda one: one.write(),
                document: lambda one: one.digest, sweep: lambda one: one.at(1, 0.5), self.surface.finder(): lambda one: one.nearest([1, 2, 3]),
                batten.reference(surfaces=[self.surface]): lambda one: one.nearest([1, 2, 3]).distance, take: lambda one: one.to_bvh(),
                self.surface.section([0, 0, 5], [0, 0, 1]): lambda one: one.points(0), document.at(0): lambda one: (one.name, one.surface())}
        for one, what in says.items():
            for make in (copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))):
                self.assertEqual(what(make(one)), what(one), one)
        self.assertEqual({self.surface: 1}[copy.copy(self.surface)], 1)
        motion = take.motion()
        self.assertEqual(copy.copy(motion).positions(0.1).tolist(), motion.positions(0.1).tolist())
        for one in (motion, self.surface.tessellate()):
            with self.assertRaisesRegex(TypeError, "cannot be"):
                pickle.dumps(one)
        kept = motion.take()
        motion.free()
        self.assertEqual(kept.joints[0].name, "hip")

    def test_readers_say_the_place(self):
        for read, text, place in ((batten.read_obj, "v 1 2 3\nf 1 2 9\n", "line 2"), (batten.read_curve, '{"degree":x}', "line 1, column 11: expected a value"),
                                  (batten.read_svg, "<svg>\n<g></svg>", "line 2"), (batten.read_bvh, "HIERARCHY\nROOT\n", "line")):
            with self.assertRaisesRegex(batten.BattenError, place):
                read(text)
        with self.assertRaisesRegex(batten.BattenError, r"wires\[0\].radius.constant: expected a finite number, found nan"):
            batten.bind([{"reference": self.sections[0], "radius": np.nan}], [[0, 0, 0]])
        with self.assertRaisesRegex(batten.BattenError, r"^knots\[1\]: expected at least 1, found 0"):
            batten.curve([[0, 0], [1, 1]], [1, 0, 0, 1], degree=1)
        view, square = {"eye": [0, 0, 9], "fov": 200}, batten.clamped([[0, 0], [1, 0], [1, 1]], degree=1)
        for message, call in ((r"faces\[0\]: expected numbers of vertices, found 7", lambda: batten.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 7]])),
                              (r"style.opacity: expected 0 to 1, found 2", lambda: batten.path_object([square], style={"opacity": 2})),
                              (r"view.fov: expected 0 to less than 180, found 200", lambda: batten.view_ray(view, [0, 0])),
                              (r"tolerance: expected more than 0, found 0", lambda: square.offset(1, tolerance=0)),
                              (r"u: expected 0 to 2, found 7", lambda: square.split(7)), (r"index: expected none, found 5", lambda: batten.document().remove(5)),
                              (r"count: expected 4 to 16777216, found 2", lambda: batten.clamped([[0, 0], [1, 1]]))):
            with self.assertRaisesRegex(batten.BattenError, "^" + message):
                call()
        with self.assertRaisesRegex(batten.BattenError, "sources: expected an Object, found a Curve"):
            batten.made_object({"kind": "loft"}, self.sections)

    def test_two_that_change_in_two_threads(self):
        cameras = [self.sections[0].camera(mode="along").add_shake(seed, 0.1, 2.0) for seed in (1, 2)]
        threads = [threading.Thread(target=lambda a=a, b=b: [a.take_levels(b) for _ in range(300)]) for a, b in (cameras, cameras[::-1])]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
            self.assertFalse(thread.is_alive())

    def test_types_have_all_names(self):
        tree, classes = ast.parse((pathlib.Path(PLACE.name) / "batten/__init__.pyi").read_text("utf-8")), {}
        for one in tree.body:
            if isinstance(one, ast.ClassDef):
                classes[one.name] = {part.name: any(getattr(d, "id", "") == "property" for d in part.decorator_list) for part in one.body if isinstance(part, ast.FunctionDef)}
        found = 0
        for name in set(classes) & set(vars(batten)):
            own = {key: isinstance(value, property) for key, value in vars(getattr(batten, name)).items() if not key.startswith("_") and (callable(value) or isinstance(value, property))}
            if hasattr(getattr(batten, name), "_made_by"):
                self.assertEqual(own, {key: value for key, value in classes[name].items() if key[0] != "_"}, name)
                found += len(own)
        functions = {one.name for one in tree.body if isinstance(one, ast.FunctionDef)}
        self.assertEqual(functions, {key for key, value in vars(batten).items() if getattr(value, "__module__", "") == "batten" and not isinstance(value, type) and key[0] != "_"})
        self.assertGreater(found + len(functions), 300)


class Building(unittest.TestCase):
    def test_what_is_missing_is_said_first(self):
        ask = "import sys; sys.path.insert(0, sys.argv[1]); import backend; backend.get_requires_for_build_wheel()"
        bare = {name: value for name, value in os.environ.items() if name not in ("BATTEN_LIBRARY", "CMAKE", "CC")} | {"PATH": PLACE.name}
        told = subprocess.run([sys.executable, "-B", "-c", ask, ROOT / "bindings/python"], capture_output=True, text=True, env=bare)
        self.assertEqual((told.returncode, told.stdout), (1, ""))
        self.assertRegex(told.stderr, r"no CMake \(.*no a C compiler|no CMake \(apt install cmake")

    def test_metadata_without_compiling(self):
        ask = "import sys; sys.path.insert(0, sys.argv[1]); import backend; print(backend.prepare_metadata_for_build_wheel(sys.argv[2]))"
        told = subprocess.run([sys.executable, "-B", "-c", ask, ROOT / "bindings/python", PLACE.name], capture_output=True, text=True)
        self.assertIn("Name: batten-core", pathlib.Path(PLACE.name, told.stdout.strip(), "METADATA").read_text("utf-8"))


class End(unittest.TestCase):
    def test_no_crash_at_the_end_of_a_process(self):
        left = ("import batten, threading\nc = batten.clamped([[0, 0], [1, 1]], degree=1)\ns, v = c.shape(), c.points\n"
                "f, live = c.finder(), c.live()\nclass Last:\n    def __del__(self): print(c.at(0.5), s.levels)\nlast = Last()\n"
                "threading.Thread(target=lambda: [c.at(0.5) for _ in range(10 ** 7)], daemon=True).start()")
        told = subprocess.run([sys.executable, "-c", left], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": PLACE.name})
        self.assertEqual((told.returncode, told.stderr), (0, ""))


class Types(unittest.TestCase):
    def test_names_that_are_shown_are_those_of_the_package(self):
        self.assertLessEqual({"fit", "Curve", "read_svg", "BattenError", "__version__"}, set(dir(batten)))
        self.assertFalse({"lib", "TABLE", "KINDS", "method", "snake"} & set(dir(batten)))

    def test_help_says_what_each_option_is(self):
        self.assertIn("tolerance: greatest true distance", batten.fit.__doc__)
        self.assertEqual(inspect.signature(batten.fit).parameters["tolerance"].default, 1.0)

    def test_help_says_what_the_headers_say(self):
        self.assertIn("Global closest point; of equally close ones, the one with the smaller u.", batten.Curve.nearest.__doc__)
        self.assertIn("<batten/fit.h>", batten.fit.__doc__)
        stubs = pathlib.Path(PLACE.name, "batten/__init__.pyi").read_text("utf-8")
        for kind in (batten.Curve, batten.Finder, batten.Chain, batten.Shape, batten.LiveShape, batten.LiveSketch):
            for name, one in vars(kind).items():
                if not name.startswith("_") and name != "report":
                    self.assertTrue(one.__doc__ and not one.__doc__.startswith("In C:"), f"{kind.__name__}.{name}")
                    self.assertRegex(stubs, rf"\bdef {name}\(.*:\n +\"\"\"")

    def test_no_any(self):
        self.assertNotRegex(pathlib.Path(PLACE.name, "batten/__init__.pyi").read_text("utf-8"), r"\bAny\b(?! use)")
        sample = pathlib.Path(PLACE.name) / "strict.py"
        sample.write_text("import batten\ncurve = batten.fit([[0, 0], [1, 1]], tolerance=0.5)\nfar: float = curve.nearest([1, 2]).distance\n"
                          "worst: float = curve.report.max_error\nplaces = curve([0.1, 0.2], order=1)\nwith curve.live() as live:\n"
                          "    live.add(1, 2).add_many({'points': [[1, 2]], 'pressure': [1]})\n"
                          "batten.spline({'points': [[0, 0], [1, 2]]}, tangents=[None, [1, 0]])\n"
                          "batten.combine('union', [curve, [curve], {'curves': [curve], 'even_odd': True}], 0.1)\n")
        told = subprocess.run(["mypy", "--strict", "--no-incremental", "--cache-dir=/dev/null", "strict.py"], cwd=PLACE.name, capture_output=True, text=True).stdout
        self.assertIn("Success", told)
        if pyright := shutil.which("pyright"):
            run = [pyright, "--pythonpath", sys.executable]
            told = subprocess.run([*run, "strict.py"], cwd=PLACE.name, capture_output=True, text=True).stdout
            self.assertIn("0 errors", told)
            told = subprocess.run([*run, "--verifytypes", "batten", "--ignoreexternal"], cwd=PLACE.name, capture_output=True, text=True,
                                  env={**os.environ, "PYTHONPATH": PLACE.name}).stdout
            self.assertRegex(told, r"With unknown type: 0\b")
            self.assertNotRegex(told, r"With (ambiguous|unknown) type: [1-9]")

    def test_mypy(self):
        sample = pathlib.Path(PLACE.name) / "sample.py"
        sample.write_text("import batten\ncurve = batten.fit([[0, 0], [1, 1]], tolerance=0.5)\ncount: int = curve.count\n"
                          "left, right = curve.split(0.5)\nlength: float = left.join(right).length()\n"
                          "text: str = curve.at(0.5)\ncurve.levels(2, frame='none')\n")
        told = subprocess.run(["mypy", "--no-incremental", "--cache-dir=/dev/null", "sample.py"], cwd=PLACE.name, capture_output=True, text=True).stdout
        self.assertRegex(told, r'sample.py:6: error: Incompatible types')
        self.assertRegex(told, r'sample.py:7: error: Argument "frame"')
        self.assertIn("Found 2 errors", told)


class Page(unittest.TestCase):
    def test_its_code_prints_what_it_says(self):
        names = {}
        text = (ROOT / "docs/python.md").read_text("utf-8")
        test = doctest.DocTestParser().get_doctest(text, names, "docs/python.md", "docs/python.md", 0)
        self.assertGreater(len(test.examples), 20)
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
        runner.run(test, clear_globs=False)
        self.assertEqual(runner.summarize(verbose=False).failed, 0)
        line = '<path d="{}" stroke="{}" stroke-width="{}"/>'
        made = PICTURE.format("".join(line.format(test.globs[name].to_svg(decimals=1), colour, width) for name, colour, width in
                                      (("curve", "#9aa5b1", 1), ("drawn", "#2563eb", 1), ("pulled", "#d9480f", 1.5))))
        picture = ROOT / "docs/pictures/python.svg"
        if os.environ.get("BATTEN_WRITE_PICTURE"):
            picture.write_text(made)
        self.assertEqual(picture.read_text(), made)


if __name__ == "__main__":
    unittest.main()
