"""frames and levels: against chains of frames and syntheses written here anew, with scipy's B-splines."""
import json
import math
import unittest

import numpy
from scipy.interpolate import BSpline

from program import CURVE, ProgramTest
from test_curves import spline_of

PATH = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, 1, 2, 3.5, 4, 4, 4, 4],
        "points": [[0, 0, 0], [10, 30, 5], [40, 20, 40], [60, -20, 20], [90, 10, -30], [120, 40, 0], [140, 0, 20]]}
LOOP = {"degree": 3, "closed": True, "knots": [0, 1, 2, 3.5, 4, 5, 6],
        "points": [[0, 0, 0], [60, -20, 30], [90, 40, -20], [60, 90, 40], [0, 100, 0], [-40, 50, 50]]}


def unit(v):
    return v / numpy.linalg.norm(v, axis=-1, keepdims=True)


def transported(curve, u, s):
    """s carried from the start of the domain to u by very many double reflections."""
    spline = spline_of(curve)
    low = curve["knots"][0] if curve["closed"] else curve["knots"][curve["degree"]]
    grid = numpy.linspace(low, u, 4001)
    x, t = spline(grid), unit(spline(grid, 1))
    for i in range(len(grid) - 1):
        v = x[i + 1] - x[i]
        c = v @ v
        if c == 0:
            continue
        left, tangent = s - 2 / c * (v @ s) * v, t[i] - 2 / c * (v @ t[i]) * v
        w = t[i + 1] - tangent
        s = left - 2 / (w @ w) * (w @ left) * w if w @ w > 0 else left
    return s


def turned(s, t0, t1):
    """The least rotation from t0 to t1, applied to s."""
    return s - (s @ t1) / (1 + t0 @ t1) * (t0 + t1)


def inserted(spline, knots, degree):
    """Control points on a superset of the knots: interpolation at the Greville abscissae is exact."""
    knots = numpy.array(knots, float)
    n = len(knots) - degree - 1
    nodes = numpy.array([knots[i + 1:i + degree + 1].mean() for i in range(n)])
    matrix = BSpline.design_matrix(numpy.clip(nodes, knots[degree], knots[n]), knots, degree).toarray()
    return numpy.linalg.solve(matrix, spline(numpy.clip(nodes, knots[degree], knots[n]))), nodes


class Frames(ProgramTest):
    def frames(self, curve, *words):
        result = self.json("frames", self.file("c.json", curve), *words)
        return {key: numpy.array(value) for key, value in result.items()}

    def check_frames(self, curve, f):
        spline = spline_of(curve)
        self.assertLess(numpy.abs(f["points"] - spline(f["u"])).max(), 1e-11)
        tangents = unit(spline(f["u"], 1))
        size = tangents.shape[1]
        self.assertLess(numpy.abs(f["t"][:, :size] - tangents).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.cross(f["t"], f["s"]) - f["r"]).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.sum(f["t"] * f["s"], axis=1)).max(), 1e-12)

    def test_rmf(self):
        f = self.frames(PATH, "--at", "0,0.4,1,2.7,4", "--first", "0,0,1", "--substeps", "200")
        self.check_frames(PATH, f)
        t0 = f["t"][0]
        first = unit(numpy.array([0, 0, 1]) - t0[2] * t0)
        self.assertLess(numpy.abs(f["s"][0] - first).max(), 1e-12)
        for u, s in zip(f["u"], f["s"]):
            self.assertLess(numpy.abs(s - transported(PATH, u, first)).max(), 1e-6)
        coarse = self.frames(PATH, "--at", "0,0.4,1,2.7,4", "--first", "0,0,1")
        self.assertLess(numpy.abs(coarse["s"] - f["s"]).max(), 2e-3)
        self.assertNotIn("holonomy", f)

    def test_frenet(self):
        f = self.frames(PATH, "--samples", "23", "--kind", "frenet")
        self.check_frames(PATH, f)
        spline = spline_of(PATH)
        binormals = unit(numpy.cross(spline(f["u"], 1), spline(f["u"], 2)))
        self.assertLess(numpy.abs(f["r"] - binormals).max(), 1e-9)

    def test_planar_and_fixed(self):
        f = self.frames(CURVE, "--samples", "9")
        self.check_frames(CURVE, f)
        self.assertEqual(f["points"].shape, (9, 2))
        self.assertLess(numpy.abs(f["s"] - numpy.c_[-f["t"][:, 1], f["t"][:, 0], 0 * f["u"]]).max(), 1e-15)
        self.assertTrue((f["r"] == [0, 0, 1]).all())
        f = self.frames(PATH, "--samples", "4", "--kind", "fixed")
        self.assertTrue((f["t"] == [1, 0, 0]).all() and (f["s"] == [0, 1, 0]).all())

    def test_closed(self):
        f = self.frames(LOOP, "--at", "0,3,5.9999999999", "--substeps", "400")
        s0, t0 = f["s"][0], f["t"][0]
        back = transported(LOOP, 6, s0)
        phi = math.atan2(numpy.cross(s0, back) @ t0, s0 @ back)
        self.assertAlmostEqual(float(f["holonomy"]), phi, places=5)
        self.assertLess(numpy.abs(f["s"][2] - s0).max(), 1e-8)  # spread, it comes round

    def test_refusals(self):
        path = self.file("c.json", PATH)
        self.assertIn("domain", self.refused(1, "frames", path, "--at", "9"))
        for words in (["--kind", "darboux"], ["--first", "1,2"], ["--substeps", "0"], []):
            self.refused(2, "frames", path, *(words and ["--samples", "3"]), *words)


class Levels(ProgramTest):
    def levels(self, shape, edits=None):
        words = [self.file("s.json", shape)]
        if edits is not None:
            words.append(self.file("e.json", edits))
        return self.json("levels", *words)

    def shape(self, base, **more):
        """A base and one level, a knot in the middle of every span, details as a wave."""
        knots = sorted(base["knots"] + [(a + b) / 2 for a, b in zip(base["knots"], base["knots"][1:]) if a < b])
        count = len(knots) - (1 if base["closed"] else base["degree"] + 1)
        details = [[0, 3 * math.sin(i), 2 * math.cos(2 * i)] for i in range(count)]
        return {"base": base, "levels": [{"knots": knots, "details": details}], **more}

    def test_planar_synthesis(self):
        shape = self.shape(CURVE)
        result = self.levels(shape)
        spline = spline_of(CURVE)
        points, nodes = inserted(spline, shape["levels"][0]["knots"], 3)
        t = unit(spline(nodes, 1))
        s = numpy.c_[-t[:, 1], t[:, 0]]
        d = numpy.array(shape["levels"][0]["details"])
        expected = points + d[:, :1] * t + d[:, 1:2] * s
        self.assertLess(numpy.abs(result["curves"][1]["points"] - expected).max(), 1e-12)
        self.assertEqual(result["curves"][0]["points"], CURVE["points"])
        again = self.levels(result["shape"])
        self.assertEqual(again["curves"], result["curves"])  # nothing done: the same bits

    def test_space_synthesis(self):
        shape = self.shape(PATH, first={"t": [1, 0, 0], "s": [0, 0, 1]})
        result = self.levels(shape)
        spline = spline_of(PATH)
        points, nodes = inserted(spline, shape["levels"][0]["knots"], 3)
        t0 = unit(spline(0, 1))
        start = turned(numpy.array([0, 0, 1.0]), numpy.array([1.0, 0, 0]), t0)
        for node, point, d, got in zip(nodes, points, shape["levels"][0]["details"], result["curves"][1]["points"]):
            t, s = unit(spline(node, 1)), transported(PATH, node, start)
            frame = numpy.array([t, s, numpy.cross(t, s)])
            self.assertLess(numpy.abs(got - (point + numpy.array(d) @ frame)).max(), 0.02)  # the default chain's own

    def test_edits(self):
        shape = self.shape(PATH)
        before = self.levels(shape)
        for level in (0, 1):
            delta = [3, -5, 7]
            after = self.levels(shape, [{"type": "drag", "level": level, "u": 1.3, "delta": delta}])
            moved = spline_of(after["curves"][level])(1.3) - spline_of(before["curves"][level])(1.3)
            self.assertLess(numpy.abs(moved - delta).max(), 1e-11)
            back = self.levels(after["shape"], [{"type": "drag", "level": level, "u": 1.3, "delta": [-3, 5, -7]}])
            for a, b in zip(back["curves"], before["curves"]):
                self.assertLess(numpy.abs(numpy.array(a["points"]) - b["points"]).max(), 1e-10)
        moved = self.levels(shape, [{"type": "move", "level": 0, "index": 2, "delta": [1, 2, 3]}])
        change = numpy.array(moved["curves"][0]["points"]) - before["curves"][0]["points"]
        self.assertLess(numpy.abs(change - numpy.outer(numpy.arange(7) == 2, [1, 2, 3])).max(), 1e-13)

    def test_symmetry_is_held(self):
        points = [[-9, 0], [-8, 4.5], [-5, 6], [-2, 8], [2, 8], [5, 6], [8, 4.5], [9, 0]]
        outline = {"dimension": 2, "degree": 3, "closed": False, "points": points, "knots": [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5]}
        shape = self.json("levels", "--decompose", "1", self.file("even.json", outline))
        for level in range(2):
            edit = {"type": "drag", "level": level, "u": 1.3, "delta": [-0.7, 0.4], "hold": {"symmetry": True}}
            after = self.levels(shape, [edit])["curves"][-1]["points"]
            self.assertNotEqual(after, points)
            for (x, y), (p, q) in zip(after, reversed(after)):
                self.assertLess(max(abs(x + p), abs(y - q)), 1e-9 * 18)

    def test_edits_hold(self):
        """Length by quadrature, places and directions by scipy, area by the shoelace formula, to 1e-9 of the size."""
        def measures(curve):
            spline, low, high = spline_of(curve), *((0, 6) if curve["closed"] else (curve["knots"][3], curve["knots"][-4]))
            knots = sorted({low, high, *(k for k in curve["knots"] if low < k < high)})
            x, w = numpy.polynomial.legendre.leggauss(60)
            length = sum((b - a) / 2 * w @ numpy.linalg.norm(spline((a + b) / 2 + (b - a) / 2 * x, 1), axis=1) for a, b in zip(knots, knots[1:]))
            area = 0
            if curve["closed"]:
                for a, b in zip(knots, knots[1:]):
                    p, d = spline((a + b) / 2 + (b - a) / 2 * x), spline((a + b) / 2 + (b - a) / 2 * x, 1)
                    area += (b - a) / 4 * w @ (p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0])
            return length, area
        for curve, flat in ((PATH, False), (dict(LOOP, points=[p[:2] for p in LOOP["points"]]), True)):
            shape = self.shape(curve)
            before = self.levels(shape)["curves"]
            hold = {"length": True, "area": flat, "points": [0.7, 2.9], "directions": [0.7]}
            for level in (0, 1):
                delta = [4, -6] if flat else [4, -6, 3]
                after = self.levels(shape, [{"type": "drag", "level": level, "u": 1.8, "delta": delta, "hold": hold}])["curves"]
                a, b = spline_of(before[-1]), spline_of(after[-1])
                self.assertLess(numpy.abs(b(1.8) - a(1.8) - delta).max(), 1e-7)
                self.assertLess(numpy.abs(b([0.7, 2.9]) - a([0.7, 2.9])).max(), 1e-7)
                self.assertLess(numpy.abs(unit(b(0.7, 1)) - unit(a(0.7, 1))).max(), 1e-9)
                for was, now, size in zip(measures(before[-1]), measures(after[-1]), (150, 150 ** 2)):
                    self.assertLess(abs(was - now), 1e-9 * size)
        name = self.file("s.json", self.shape(PATH))
        for wrong in ({"area": True}, {"points": [1.8]}, {"points": "all"}, {"directions": [0] * 9}, 3):
            self.refused(1, "levels", name, self.file("e.json", [
                {"type": "drag", "level": 0, "u": 1.8, "delta": [4, -6, 3], "hold": wrong}]))

    def test_edits_stay_local_in_space(self):
        base = {"degree": 3, "closed": False, "knots": [0, 0, 0, *range(18), 17, 17, 17],
                "points": [[20 * i, 30 * math.sin(1.3 * i), 25 * math.cos(0.9 * i)] for i in range(20)]}
        before = self.levels(self.shape(base))
        after = self.levels(self.shape(base), [{"type": "move", "level": 0, "index": 6, "delta": [5, 40, -30]}])
        u = numpy.linspace(12, 17, 200)
        self.assertLess(numpy.abs(spline_of(after["curves"][1])(u) - spline_of(before["curves"][1])(u)).max(), 1e-10)
        plain = self.levels(self.shape(base, propagation="plain"),
                            [{"type": "move", "level": 0, "index": 6, "delta": [5, 40, -30]}])
        self.assertGreater(numpy.abs(spline_of(plain["curves"][1])(u) - spline_of(before["curves"][1])(u)).max(), 1e-3)

    def test_gain_transform_and_sketch(self):
        shape = self.shape(CURVE)
        mute = self.levels(shape, [{"type": "gain", "level": 1, "value": 0}])
        u = numpy.linspace(0, 2, 50)
        self.assertLess(numpy.abs(spline_of(mute["curves"][1])(u) - spline_of(CURVE)(u)).max(), 1e-12)
        before = self.levels(shape)
        turn = [[0, -2, 0, 5], [2, 0, 0, 1], [0, 0, 2, 0]]
        after = self.levels(shape, [{"type": "transform", "matrix": turn}])
        expected = numpy.array(before["curves"][1]["points"]) @ numpy.array([[0, 2], [-2, 0]]) + [5, 1]
        self.assertLess(numpy.abs(after["curves"][1]["points"] - expected).max(), 1e-11)
        base = {"degree": 3, "closed": False, "knots": [0, 0, 0, *range(12), 11, 11, 11],
                "points": [[40 * i, 0] for i in range(14)]}
        x = numpy.linspace(150, 350, 120)
        stroke = {"points": numpy.c_[x, 12 * numpy.sin((x - 150) / 200 * math.pi) ** 2].tolist()}
        drawn = self.levels(self.shape(base), [{"type": "sketch", "level": 1, "stroke": stroke}])
        plain = self.levels(self.shape(base))
        change = numpy.array(drawn["curves"][1]["points"]) - plain["curves"][1]["points"]
        self.assertEqual(numpy.abs(change[:3]).max(), 0)  # what the stroke misses stays
        self.assertEqual(drawn["curves"][0], plain["curves"][0])
        self.assertGreater(numpy.abs(change).max(), 2)

    def test_short_sketch_is_said(self):
        base = {"degree": 3, "closed": False, "knots": [0, 0, 0, *range(12), 11, 11, 11],
                "points": [[40 * i, 0] for i in range(14)]}
        shape = self.file("s.json", {"base": base, "levels": []})
        for width, short in ((60, True), (250, False)):
            x = numpy.linspace(100, 100 + width, 120)
            stroke = {"points": numpy.c_[x, 20 * numpy.sin((x - 100) / width * math.pi) ** 2].tolist()}
            edits = self.file("e.json", [{"type": "sketch", "level": 0, "stroke": stroke}])
            result = self.run_program("levels", shape, edits)
            said = result.stderr.decode()
            self.assertEqual(result.returncode, 0, said)
            points = numpy.array(json.loads(result.stdout)["curves"][0]["points"])
            if short:
                self.assertRegex(said, r"e\.json: line 1, column 2: the stroke is short for level 0 \(1\.\d of its spans\): "
                                       r"it is missed by \d+(\.\d)?\n$")
                self.assertLess(float(said.split()[-1]), 20)
            else:
                self.assertEqual(said, "")
            self.assertLess(numpy.abs(points[-3:, 1]).max(), 1e-9)

    def test_decompose(self):
        knots = [0, 0, 0, *range(38), 37, 37, 37]
        curve = {"degree": 3, "closed": False, "knots": knots,
                 "points": [[10 * i, 20 * math.sin(i / 3) + 3 * math.cos(2 * i)] for i in range(40)]}
        path = self.file("c.json", curve)
        result = self.json("levels", "--decompose", "3", path)
        self.assertEqual(len(result["curves"]), 4)
        self.assertLess(numpy.abs(result["curves"][3]["points"] - numpy.array(curve["points"])).max(), 1e-10)
        again = self.levels(result)  # what was printed reads as a shape
        self.assertEqual(again["curves"], result["curves"])
        self.assertIn("interior knots", self.refused(1, "levels", "--decompose", "12", path))

    def test_refusals(self):
        shape = self.file("s.json", self.shape(CURVE))
        for edits in ([{"type": "bend"}], [{"type": "move", "level": 4, "index": 0, "delta": [0, 0]}],
                      [{"type": "move", "level": 0, "index": 99, "delta": [0, 0]}], {"type": "move"},
                      [{"type": "drag", "level": 0, "u": 1, "delta": [1]}], [{"type": "gain", "level": 0, "value": 1}]):
            self.refused(1, "levels", shape, self.file("e.json", edits))
        wrong = self.shape(CURVE)
        wrong["levels"][0]["details"].pop()
        self.assertIn("details", self.refused(1, "levels", self.file("w.json", wrong)))
        wrong = self.shape(CURVE)
        wrong["levels"][0]["knots"][5] = 0.123  # the base's knot 1 is gone
        wrong["levels"][0]["knots"].sort()
        self.assertIn("knots", self.refused(1, "levels", self.file("w.json", wrong)))
        self.assertIn("base", self.refused(1, "levels", self.file("w.json", {"levels": []})))
        self.refused(2, "levels", "--decompose", "1", shape, shape)


if __name__ == "__main__":
    unittest.main()
