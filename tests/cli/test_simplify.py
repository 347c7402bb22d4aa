"""simplify: few points, within the tolerance by scipy, corners and ends kept, for a curve and for a whole drawing."""
import json
import math
import re
import unittest

import numpy
from scipy.spatial import cKDTree

from program import CURVE, RING, ProgramTest
from test_curves import spline_of


def sampled(curve, count=100001):
    low, high = curve["knots"][0], curve["knots"][-1]
    if not curve["closed"]:
        low, high = curve["knots"][curve["degree"]], curve["knots"][-curve["degree"] - 1]
    return spline_of(curve)(numpy.linspace(low, high, count))


def apart(a, b):
    """Greatest distance between two curves, both ways, from samples."""
    p, q = sampled(a), sampled(b)
    return max(cKDTree(q).query(p)[0].max(), cKDTree(p).query(q)[0].max())


def dense(degree, closed, dimension=2, count=120):
    """A smooth shape with far more points than it needs."""
    turns = numpy.arange(count) * 2 * math.pi / count * (1 if closed else 0.8)
    points = numpy.stack([300 * numpy.cos(turns), 200 * numpy.sin(turns), 50 * numpy.cos(2 * turns)], 1)[:, :dimension]
    knots = list(range(count + 1)) if closed else \
        [0] * degree + list(range(count - degree + 1)) + [count - degree] * degree
    return {"degree": degree, "closed": closed, "knots": knots, "points": points.tolist()}


class Simplify(ProgramTest):
    def simplified(self, curve, *words):
        result = self.json("simplify", self.file("c.json", curve), *words)
        report = result["report"]
        self.assertEqual(report["points_before"], len(curve["points"]))
        self.assertEqual(report["points_after"], len(result["points"]))
        self.assertLessEqual(report["points_after"], report["points_before"])
        self.assertEqual((result["degree"], result["closed"]), (curve["degree"], curve["closed"]))
        return result

    def test_every_degree_dimension_and_closing(self):
        for degree in (1, 2, 3, 4, 5):
            for closed in (False, True):
                for dimension in (2, 3):
                    for tolerance in (0.05, 1.0):
                        with self.subTest(degree=degree, closed=closed, dimension=dimension, tolerance=tolerance):
                            curve = dense(degree, closed, dimension)
                            result = self.simplified(curve, "--tolerance", tolerance)
                            self.assertLessEqual(result["report"]["max_error"], tolerance)
                            self.assertLess(apart(curve, result), tolerance + 0.04)  # the samples are at most 0.07 apart
                            if degree >= 3:
                                self.assertLess(len(result["points"]), 60)
                            if not closed:
                                ends = sampled(curve, 2), sampled(result, 2)
                                self.assertLess(numpy.abs(ends[0] - ends[1]).max(), 1e-9)

    def test_cubics_that_share_a_tangent(self):
        """G1: cubics, about half as many as C2 takes, smooth where they meet, within the tolerance."""
        for degree in (2, 3, 5):
            for closed in (False, True):
                with self.subTest(degree=degree, closed=closed):
                    curve = dense(degree, closed)
                    name = self.file("c.json", curve)
                    words = "simplify", name, "--tolerance", "0.1"
                    smooth, cubics = self.json(*words, "--continuity", "C2"), self.json(*words, "--continuity", "G1")
                    self.assertEqual(smooth, self.json(*words))
                    self.assertEqual((cubics["degree"], cubics["closed"]), (3, closed))
                    spans = [len(set(c["knots"])) - 1 for c in (smooth, cubics)]
                    self.assertLess(spans[1], spans[0] if degree > 2 else len(curve["points"]) / 4)
                    self.assertEqual(cubics["report"]["points_after"], len(cubics["points"]))
                    self.assertLessEqual(cubics["report"]["max_error"], 0.1)
                    self.assertLess(apart(curve, cubics), 0.1 + 0.04)

    def test_cubics_that_meet_at_extremes(self):
        """An oval is four cubics with level and upright handles, in whole numbers with a grid; joints are its extremes."""
        for turn in (0, 0.4):
            curve = dense(5, True)
            curve["points"] = (numpy.array(curve["points"]) @ [[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]).tolist()
            for grid in (0, 1, 10):
                with self.subTest(turn=turn, grid=grid):
                    result = self.json("simplify", self.file("c.json", curve), "--tolerance", "1", "--continuity", "extremes", "--grid", grid)
                    points = numpy.array(result["points"])
                    self.assertLess(apart(curve, result), 1.1 + 1.5 * grid)
                    self.assertLessEqual(len(points), 12 if turn == 0 else 24)
                    ends = points[2::3]
                    handles = numpy.stack([points[1::3], numpy.roll(points, -3, 0)[::3]])
                    level = (handles == ends).all(0).any(1)
                    self.assertEqual(level.sum(), 4)
                    seen = sampled(curve)
                    for low, high in ((ends.min(0), seen.min(0)), (seen.max(0), ends.max(0))):
                        self.assertLess(numpy.abs(low - high).max(), 1e-6 + 0.51 * grid)
                    if grid:
                        self.assertTrue((points % grid == 0).all())
        self.refused(2, "simplify", "-", "--grid", "1")
        self.refused(2, "simplify", "-", "--continuity", "extremes", "--tolerance", "0")

    def test_the_default_is_a_thousandth_of_the_longer_side(self):
        for scale in (1e-6, 1, 1e6):
            curve = dense(3, False)
            curve["points"] = (numpy.array(curve["points"]) * scale).tolist()
            result = self.simplified(curve)
            side = max(numpy.ptp(sampled(curve), axis=0))
            self.assertLessEqual(result["report"]["max_error"], 1e-3 * side)
            self.assertEqual(len(result["points"]), len(self.simplified(dense(3, False))["points"]))

    def test_corners_of_polylines_stay(self):
        """Points on straight lines go, the corners are the same points as before, whatever the tolerance."""
        corners = [[0, 0], [100, 0], [130, 40], [0, 90]]
        points = [[a[0] + (b[0] - a[0]) * i / 10, a[1] + (b[1] - a[1]) * i / 10]
                  for a, b in zip(corners, corners[1:]) for i in range(10)] + [corners[-1]]
        for tolerance in ("1e-6", "1", "1e9"):
            curve = {"degree": 1, "closed": False, "knots": [0, *range(31), 30], "points": points}
            result = self.simplified(curve, "--tolerance", tolerance)
            self.assertEqual(len(result["points"]), 4)
            self.assertLess(numpy.abs(numpy.array(result["points"]) - corners).max(), 1e-9)

    def test_zero_changes_nothing(self):
        """Only a knot where the curve is one polynomial anyway may go."""
        bent = dict(CURVE, points=[[0, 0], [1, 2], [3, 7], [5, 1], [6, 0]])
        for curve in (bent, RING):
            self.assertEqual(len(self.simplified(curve, "--tolerance", "0")["points"]), 5)
        one = self.simplified(CURVE, "--tolerance", "0")  # both spans are the same cubic
        self.assertEqual((len(one["points"]), one["report"]["max_error"]), (4, 0))
        self.assertLess(numpy.abs(sampled(one) - sampled(CURVE)).max(), 1e-12)

    def test_what_is_small_already(self):
        line = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, 1, 1, 1, 1], "points": [[0, 0], [1, 0], [2, 0], [3, 0]]}
        dot = dict(line, points=[[5, 5]] * 4)
        for curve in (line, dot, dict(dot, degree=1, knots=[0, 0, 1, 1], points=[[2, 2]] * 2)):
            for words in ((), ("--tolerance", "0"), ("--tolerance", "1e30")):
                self.assertEqual(self.simplified(curve, *words)["points"], curve["points"])
        self.assertGreaterEqual(len(self.simplified(RING, "--tolerance", "1e30")["points"]), 3)

    def test_again_is_the_same(self):
        """What is simple already loses next to nothing more."""
        once = self.simplified(dense(3, True), "--tolerance", "0.5")
        again = self.simplified(once, "--tolerance", "0.5")
        self.assertGreaterEqual(len(again["points"]), len(once["points"]) - 2)

    def test_a_drawing(self):
        """Every curve of an SVG; names, styles and groups stay; the report is a line on standard error."""
        path = "M" + " ".join(f"{x},{80 * math.sin(x / 40):.9f}" for x in range(0, 400, 2))
        svg = '<svg xmlns="http://www.w3.org/2000/svg"><g id="layer"><path id="wave" stroke="#123456" fill="none" ' \
              f'd="{path}"/></g><circle cx="50" cy="50" r="40"/></svg>'
        result = self.run_program("simplify", self.file("a.svg", svg), "--tolerance", "0.5")
        self.assertEqual(result.returncode, 0)
        report = json.loads(result.stderr)["report"]
        self.assertLessEqual(report["max_error"], 0.5)
        text = result.stdout.decode()
        for word in ("layer", "wave", "#123456"):
            self.assertIn(word, text)
        name = self.file("b.svg", text)
        before, after = (json.loads(self.done("info", f, "--json")) for f in (self.folder / "a.svg", name))
        self.assertEqual(len(before["objects"]), len(after["objects"]))
        native = self.run_program("simplify", "-", "--tolerance", "0.5", stdin=self.done("convert", name, "-", "--to", "batten"))
        self.assertEqual((native.returncode, json.loads(native.stdout)["batten"] is None), (0, False))

    def test_a_surface_stays(self):
        """Its lines only show it: here they are straight, and one span would do."""
        knots = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
        places = [sum(knots[i + 1:i + 4]) / 3 for i in range(7)]
        surface = {"degree": [3, 3], "knots": [knots, knots], "points": [[[x, y, 0] for y in places] for x in places]}
        drawing = {"batten": 2, "objects": [{"id": 1, "kind": "surface", "name": "sheet", "surface": surface}]}
        name = self.file("s.batten", json.dumps(drawing))
        result = self.run_program("simplify", name, "--tolerance", "0.5")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, self.done("convert", name, "-", "--to", "batten"))
        self.assertEqual(json.loads(result.stderr)["report"]["points_after"], 0)

    def test_an_empty_drawing(self):
        result = self.run_program("simplify", self.file("e.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>'))
        self.assertEqual((result.returncode, json.loads(result.stderr)),
                         (0, {"report": {"max_error": 0, "points_before": 0, "points_after": 0}}))
        self.assertTrue(re.match(rb"<\?xml|<svg", result.stdout))

    def test_bad_data(self):
        self.refused(1, "simplify", "nowhere.json")
        line = self.refused(1, "simplify", self.file("a.json", json.dumps(CURVE).replace("[6, 0]", "[6, NaN]")))
        self.assertIn("a.json", line)


if __name__ == "__main__":
    unittest.main()
