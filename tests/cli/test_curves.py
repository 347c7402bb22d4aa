"""eval, nearest, fit, sketch: against scipy's B-splines, closed forms, and what the contract says of bad data."""
import json
import math
import unittest

import numpy
from scipy.interpolate import BSpline

from program import CURVE, RING, ProgramTest


def spline_of(curve):
    """The same curve by scipy. A closed one is unrolled over three periods."""
    degree, knots, points = curve["degree"], curve["knots"], numpy.array(curve["points"], float)
    if not curve["closed"]:
        return BSpline(knots, points, degree)
    n, period = len(points), knots[-1] - knots[0]
    turns = numpy.concatenate([numpy.array(knots[:-1]) + k * period for k in range(-2, 5)])
    return BSpline(turns, numpy.concatenate([points] * 7)[:len(turns) - degree - 1], degree)


def wave(first, last, bump=0.0):
    return [[x, 30 * math.sin(x / 30) + bump * math.sin((x - first) / (last - first) * math.pi) ** 2]
            for x in range(first, last + 1)]


def distance(points, curve):
    """Greatest distance of the points to the curve, by dense sampling."""
    spline, (low, high) = spline_of(curve), (curve["knots"][0], curve["knots"][-1])
    if not curve["closed"]:
        low, high = curve["knots"][curve["degree"]], curve["knots"][-curve["degree"] - 1]
    samples = spline(numpy.linspace(low, high, 20001))
    return max(numpy.min(numpy.hypot(*(samples - point).T)) for point in numpy.array(points))


class Eval(ProgramTest):
    def check(self, curve, words, u):
        result = self.json("eval", self.file("c.json", curve), *words)
        self.assertEqual(result["u"], list(u))
        spline = spline_of(curve)
        size = numpy.abs(curve["points"]).max()
        self.assertLess(numpy.abs(result["points"] - spline(u)).max(), 1e-13 * size)
        for k, values in enumerate(result["derivatives"], 1):
            expected = spline(u, nu=k)
            self.assertLess(numpy.abs(values - expected).max(), 1e-12 * max(size, numpy.abs(expected).max()))
        return result

    def test_against_scipy(self):
        at = [1.75, 0.25, 1.1, 0, 2]  # in any order
        result = self.check(CURVE, ["--at", ",".join(map(repr, at)), "--derivatives", "2"], at)
        self.assertEqual(numpy.shape(result["derivatives"]), (2, 5, 2))
        self.assertEqual(self.check(CURVE, ["--samples", "5"], [0, 0.5, 1, 1.5, 2])["derivatives"], [])

    def test_closed(self):
        self.check(RING, ["--samples", "5", "--derivatives", "1"], [0, 1, 2, 3, 4])
        self.check(RING, ["--at", "-1.5,7.25,5", "--derivatives", "2"], [-1.5, 7.25, 5])  # any period

    def test_space(self):
        curve = dict(CURVE, points=[[0, 0, 1], [1, 2, 5], [3, 3, -2], [5, 1, 0], [6, 0, 1]])
        self.check(curve, ["--samples", "9", "--derivatives", "3"], numpy.linspace(0, 2, 9).tolist())

    def test_numbers_read_back_bit_for_bit(self):
        at = [0.1, 1 / 3, math.pi / 2, 2.2250738585072014e-308, math.nextafter(2, 0)]
        result = self.json("eval", self.file("c.json", CURVE), "--at", ",".join(map(repr, at)))
        self.assertEqual(result["u"], at)
        point = result["points"][1]
        line = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [point, point]}
        self.assertEqual(self.json("eval", self.file("d.json", line), "--at", "0")["points"], [point])

    def test_outside_the_domain(self):
        line = self.refused(1, "eval", self.file("c.json", CURVE), "--at", "0.5,2.5")
        self.assertIn("2.5", line)
        self.assertIn("[0, 2]", line)

    def test_extra_keys_and_standard_input(self):
        curve = dict(CURVE, report={"max_error": 1, "changed": [0, 1]}, k=[None, 1])
        self.assertEqual(self.done("eval", "-", "--samples", "3", stdin=json.dumps(curve)),
                         self.done("eval", self.file("c.json", CURVE), "--samples", "3"))

    def test_bad_curves(self):
        for curve, word in (
            ("", "line 1"), ("{", "line 1"), ("[]", ""), ("null", ""), ("{}", "degree"),
            (dict(CURVE, degree=9), "degree"), (dict(CURVE, knots=[0, 1]), "knots"),
            (dict(CURVE, knots=[0, 0, 0, 0, 3, 2, 2, 2, 2]), "knots: expected at least 3, found 2"),
            (dict(CURVE, knots=[0, 0, 0, 0, 0, 2, 2, 2, 2]), "knots: expected at most 4 knots at 0"),
            (dict(CURVE, knots=[0, 0, 0, 0, 1, 1, 1, 1, 2]), "knots: expected at most 3 knots at 1"),
            (dict(CURVE, knots=[0, 0, 0, 0, 1, 2, 2, 2]), "knots: expected 9 for 5 points, found 8"),
            (dict(CURVE, knots=[0, 0, 0, 0, 1, 2e99, 2e99, 2e99, 2e99]), "knots: expected"), (dict(CURVE, points=[[0]] * 5), "points"),
            (dict(CURVE, points=[[0, 0], [1, 2], [3, 3, 1], [5, 1], [6, 0]]), "points"),
            (json.dumps(CURVE).replace("[6, 0]", "[6, 1e999]"), ""), (json.dumps(CURVE) + "x", ""),
        ):
            with self.subTest(curve=curve):
                line = self.refused(1, "eval", self.file("bad.json", curve), "--samples", "3")
                self.assertRegex(line, r"bad\.json: .*expected.*found")
                self.assertIn(word, line)
        self.assertIn("No such file", self.refused(1, "eval", "nowhere.json", "--samples", "3"))
        self.assertIn("directory", self.refused(1, "eval", self.folder, "--samples", "3"))


class Nearest(ProgramTest):
    def test_against_dense_search(self):
        for curve in (CURVE, RING):
            name, spline = self.file("c.json", curve), spline_of(curve)
            end = curve["knots"][-1]
            u = numpy.linspace(0, end, 200001)
            samples = spline(u)
            for point in ([3, 4], [0, 0], [-2, 1], [2.5, 1.5]):
                result = self.json("nearest", name, "--point", f"{point[0]},{point[1]}")
                best = numpy.hypot(*(samples - point).T).min()
                self.assertLessEqual(result["distance"], best + 1e-12)
                self.assertGreater(result["distance"], best - 1e-6)
                self.assertLess(numpy.abs(spline(result["u"]) - result["point"]).max(), 1e-12)
                self.assertAlmostEqual(math.dist(result["point"], point), result["distance"], 12)

    def test_line_in_space(self):
        line = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0, 0], [10, 0, 0]]}
        result = self.json("nearest", self.file("c.json", line), "--point", "4,3,4")
        self.assertEqual(result, {"u": 0.4, "point": [4, 0, 0], "distance": 5})

    def test_wrong_count_of_coordinates(self):
        line = self.refused(1, "nearest", self.file("c.json", CURVE), "--point", "1,2,3")
        self.assertRegex(line, "expected 2 coordinates.*found 3")


class Fit(ProgramTest):
    def test_closed_by_force(self):
        """Ends far apart stay where the pen put them: every sample is within the tolerance."""
        arc = [[200 * math.cos(a / 50), 200 * math.sin(a / 50)] for a in range(30, 280)]
        for stroke in (wave(0, 500), [[x, 0] for x in range(0, 501, 4)], arc):
            result = self.json("fit", self.file("s.json", {"points": stroke}), "--closed")
            self.assertTrue(result["closed"])
            self.assertLess(distance(stroke, result), 1)
            self.assertLess(result["report"]["max_error"], 1)

    def test_within_tolerance(self):
        points = wave(0, 200)
        for tolerance in (2, 0.2, 0.05):
            curve = self.json("fit", self.file("s.json", {"points": points}), "--tolerance", tolerance, "--pixel", "0.1")
            self.assertLessEqual(distance(points, curve), tolerance * 1.01)
            self.assertEqual(curve["report"]["knots_after"], len(curve["knots"]))
            self.assertLess(len(curve["points"]), 60)

    def test_tolerance_that_cannot_be_met_is_bad_data(self):
        points = [[x + 3 * math.sin(9.7 * x * x), y + 3 * math.sin(7.1 * x * x)] for x, y in wave(0, 300)]
        name = self.file("s.json", {"points": points})
        line = self.refused(1, "fit", name, "--tolerance", "0.001")
        self.assertRegex(line, r"s\.json: points: expected a fit within 0\.001, the best found reaches \d")
        self.assertGreater(float(line.split()[-1]), 0.001)

    def test_csv_and_json_are_the_same(self):
        points = wave(0, 100)
        as_json = self.done("fit", self.file("s.json", {"points": points, "pressure": [0.5] * 101}))
        csv = "x,y,pressure\n" + "".join(f"{x!r},{y!r},0.5\n" for x, y in points)
        self.assertEqual(self.done("fit", self.file("s.csv", csv)), as_json)
        self.assertEqual(self.done("fit", "-", stdin=csv), as_json)

    def test_closed(self):
        arc = [[50 * math.cos(a), 50 * math.sin(a)] for a in numpy.linspace(0, 5.6, 150)]
        name = self.file("s.json", {"points": arc})
        self.assertFalse(self.json("fit", name)["closed"])
        self.assertTrue(self.json("fit", name, "--closed")["closed"])

    def test_dots_and_bad_strokes(self):
        self.assertIn("too short", self.refused(1, "fit", self.file("s.json", {"points": [[1, 1]] * 9})))
        self.assertIn("too short", self.refused(1, "fit", self.file("s.json", {"points": [[1, 1], [1.2, 1]]})))
        for bad in ("", "{}", {"points": []}, {"points": [[0, 0], [1]]}, {"points": "no"},
                    {"points": wave(0, 9), "pressure": [1]}, "x,y\n1,2\n3\n", "a,b\n1,2\n"):
            with self.subTest(bad=bad):
                self.assertIn("s.json: ", self.refused(1, "fit", self.file("s.json", bad)))


class Sketch(ProgramTest):
    def setUp(self):
        super().setUp()
        self.roof_text = self.done("fit", self.file("s.json", {"points": wave(0, 200)}), "--tolerance", "0.5")
        self.roof = self.file("roof.json", self.roof_text)

    def redraw(self, points, *words):
        return self.json("sketch", self.roof, self.file("t.json", {"points": points}), *words)

    def test_follows_there_and_stays_elsewhere(self):
        stroke, old = wave(60, 120, 8.0), json.loads(self.roof_text)
        for pins in ("2", "3"):
            new = self.redraw(stroke, "--tolerance", "0.5", "--pins", pins)
            report = new["report"]
            self.assertLess(distance(stroke[5:-5], new), 0.51)
            low, high = report["changed"]
            self.assertLess(low, high)
            self.assertEqual((report["knots_before"], report["knots_after"]), (len(old["knots"]), len(new["knots"])))
            self.assertIs(report["reversed"], False)
            if pins == "3":  # before the interval not a bit has changed
                before = numpy.linspace(0, low, 50)
                self.assertLess(numpy.abs(spline_of(old)(before) - spline_of(new)(before)).max(), 1e-10)
            second = spline_of(new).derivative(2)
            for knot in set(new["knots"][4:-4]):
                self.assertLess(numpy.abs(second(knot) - second(math.nextafter(knot, -1))).max(), 1e-9)

    def test_reversed_stroke_gives_the_same_shape(self):
        stroke = wave(60, 120, 8.0)
        forward, backward = self.redraw(stroke), self.redraw(stroke[::-1])
        self.assertIs(backward["report"]["reversed"], True)
        samples = spline_of(forward)(numpy.linspace(forward["knots"][3], forward["knots"][-4], 300))
        self.assertLess(distance(samples, backward), 1)

    def test_dot_and_far_are_bad_data(self):
        dot = self.file("dot.json", {"points": [[60, 27]] * 5})
        self.assertIn("too short", self.refused(1, "sketch", self.roof, dot))
        far = self.file("far.json", {"points": [[x, y + 5000] for x, y in wave(60, 120)]})
        self.assertRegex(self.refused(1, "sketch", self.roof, far), r"far\.json: .*too far")

    def test_dimension(self):
        stroke = self.file("t.json", {"points": [[x, y, 0] for x, y in wave(60, 120)]})
        self.refused(1, "sketch", self.roof, stroke)

    def test_one_of_the_two_from_standard_input(self):
        stroke_text = json.dumps({"points": wave(60, 120, 8.0)})
        stroke = self.file("t.json", stroke_text)
        expected = self.done("sketch", self.roof, stroke)
        self.assertEqual(self.done("sketch", "-", stroke, stdin=self.roof_text), expected)
        self.assertEqual(self.done("sketch", self.roof, "-", stdin=stroke_text), expected)
        again = self.json("sketch", "-", stroke, stdin=expected)  # its output is an input
        self.assertGreater(again["report"]["knots_before"], 0)


if __name__ == "__main__":
    unittest.main()
