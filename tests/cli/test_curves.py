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


def distance(points, curve, count=20001):
    """Greatest distance of the points to the curve, by dense sampling."""
    spline, (low, high) = spline_of(curve), (curve["knots"][0], curve["knots"][-1])
    if not curve["closed"]:
        low, high = curve["knots"][curve["degree"]], curve["knots"][-curve["degree"] - 1]
    samples = spline(numpy.linspace(low, high, count))
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


class FitPoints(ProgramTest):
    """Points are fitted as they are: the report is true, and the tolerance kept."""

    def test_the_tolerance_is_kept_to_every_point(self):
        zigzag = [[x, 8 * (x % 2)] for x in range(60)]
        noisy = [[x + 0.3 * math.sin(9.7 * x * x), 40 * math.sin(x / 30) + 0.3 * math.sin(7.1 * x * x)] for x in range(200)]
        for points in (zigzag, noisy, wave(0, 200, 10), [[0, 0], [10, 5]], [[x, 0] for x in range(9)]):
            for words in ([], ["--tolerance", "0.05"], ["--tolerance", "2", "--degree", "5"], ["--free-ends"]):
                curve = self.json("fit", self.file("p.json", {"points": points}), *words)
                size = numpy.linalg.norm(numpy.ptp(numpy.array(points, float), axis=0))
                most = float(words[1]) if words[:1] == ["--tolerance"] else 1e-3 * size
                self.assertLessEqual(curve["report"]["max_error"], most)
                self.assertLessEqual(distance(points, curve, 400001), curve["report"]["max_error"] + 1e-3 * size)
                self.assertEqual(curve["report"]["knots_after"], len(curve["knots"]))
                if "--free-ends" not in words:
                    self.assertEqual((curve["points"][0], curve["points"][-1]), (points[0], points[-1]))

    def test_few_knots(self):
        curve = self.json("fit", self.file("p.json", {"points": wave(0, 400)}), "--tolerance", "0.1")
        self.assertLess(len(curve["points"]), 30)

    def test_closed(self):
        ring = [[50 * math.cos(a), 30 * math.sin(a)] for a in numpy.linspace(0, 2 * math.pi, 90, endpoint=False)]
        curve = self.json("fit", self.file("p.json", {"points": ring}), "--closed", "--tolerance", "0.05")
        self.assertTrue(curve["closed"])
        self.assertLessEqual(distance(ring, curve), 0.051)

    def test_corners(self):
        roof = [[x, x] for x in range(51)] + [[x, 100 - x] for x in range(51, 101)]
        name = self.file("p.json", {"points": roof})
        plain, told, found = (self.json("fit", name, "--tolerance", "0.01", *words)
                              for words in ([], ["--corners", "50"], ["--corners", "auto"]))
        self.assertEqual(told, found)
        self.assertEqual(len(told["points"]), 7)
        self.assertLess(min(math.dist(point, (50, 50)) for point in told["points"]), 1e-6)
        self.assertGreater(len(plain["points"]), 7)
        for bad in ("101", "3,3", "5,2", "1.5", "-1"):
            self.assertIn("expected ascending whole numbers", self.refused(1, "fit", name, f"--corners={bad}"))

    def test_every_kind_of_file(self):
        points, space = wave(0, 60), [[x, x * x / 60, 60 - x] for x in range(61)]
        expected = self.done("fit", self.file("p.json", {"points": points}))
        rows = [f"{x!r}#{y!r}" for x, y in points]
        for text in (["x,y"] + rows, ["X;Y"] + rows, rows, ["east north"] + rows, ["#a track", ""] + rows,
                     ['"X"\t"Y"'] + rows, ["y,name,x"] + [f"{y!r},{i} b,{x!r}" for i, (x, y) in enumerate(points)]):
            between = next((c for c in text[0] if c in ",;\t"), " ")
            csv = "\r\n".join(text[:1] + [row.replace("#", between) for row in text[1:]]) if text is not rows else \
                "\n".join(rows).replace("#", " ")
            with self.subTest(head=text[0]):
                self.assertEqual(self.done("fit", "-", stdin=csv), expected)
        geo = {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": points}}
        for value in (geo, geo["geometry"]):
            self.assertEqual(self.done("fit", "-", stdin=json.dumps(value)), expected)
        as_json = self.done("fit", "-", stdin=json.dumps({"points": space}))
        for text in ("\n".join("\t".join(map(repr, p)) for p in space), "a,b,c\n" + "\n".join(",".join(map(repr, p)) for p in space)):
            self.assertEqual(self.done("fit", "-", stdin=text), as_json)
        self.assertEqual(len(json.loads(as_json)["points"][0]), 3)

    def test_tables_of_other_programs(self):
        """Decimal commas between semicolons, empty columns at the end; a row with a number is never taken for a header."""
        expected = self.done("fit", "-", stdin="1.5,2\n3,4.25\n7,1\n")
        for text in ("1,5;2\n3;4,25\n7;1\n", '"x";"y"\n"1,5";"2"\n"3";"4,25"\n7;1', "1.5,2,\n3,4.25,\n7,1,\n", "X;Y;\n1,5;2;\n3;4,25;\n7;1;\n",
                     "x,,y\n1.5,,2\n3,,4.25\n7,,1\n"):
            self.assertEqual(self.done("fit", "-", stdin=text), expected, text)
        for text, place in (("nan,1\n2,3\n4,5\n", "line 1, field 1"), ("A,1,2\nB,3,4\nC,5,6\n", "line 1, field 1"), ("1,5;2\n3;4,2,5\n", "line 2, field 2")):
            self.assertIn(f"{place}: expected a number, found", self.refused(1, "fit", "-", stdin=text))

    def test_collections_of_one_line(self):
        line = {"type": "LineString", "coordinates": wave(0, 60)}
        feature = {"type": "Feature", "properties": None, "geometry": line}
        expected = self.done("fit", "-", stdin=json.dumps(line))
        self.assertEqual(self.done("fit", "-", stdin=json.dumps({"type": "FeatureCollection", "features": [feature]})), expected)
        for bad, words in (({"type": "FeatureCollection", "features": [feature] * 2}, "features: expected one, a LineString, found 2"),
                           ({"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [2, 0]]]}, "expected a LineString with coordinates, found Polygon"),
                           ({"type": "LineString"}, "found LineString without them"), ({"type": "Feature", "geometry": None}, "found none")):
            self.assertIn(words, self.refused(1, "fit", "-", stdin=json.dumps(bad)))

    def test_any_size_and_ends_to_the_bit(self):
        helix = [[math.cos(t / 20), math.sin(t / 20), t / 30] for t in range(200)]
        for scale in (1e-70, 1, 1e70):
            points = [[c * scale for c in p] for p in helix]
            curve = self.json("fit", "-", stdin=json.dumps({"points": points}))
            self.assertEqual((curve["points"][0], curve["points"][-1]), (points[0], points[-1]))
            self.assertLess(len(curve["points"]), 16)
            self.assertLess(0, curve["report"]["max_error"])
            self.assertLess(curve["report"]["max_error"], 8e-3 * scale)

    def test_what_is_refused(self):
        for bad in ("", "{}", {"points": []}, {"points": [[0, 0], [1]]}, "x,y\n1,2\n3\n", "x,y\n1,2\n3,b\n", "x,y\n1,1e99\n", "5\n6\n",
                    {"type": "LineString", "coordinates": [[1]]}, {"points": [[1, 1]] * 5}, "x,y\n1,2\n"):
            with self.subTest(bad=bad):
                self.assertIn("p.json: ", self.refused(1, "fit", self.file("p.json", bad)))
        self.assertIn("line 3, field 2", self.refused(1, "fit", self.file("p.csv", "x,y\n1,2\n3,b\n")))
        name = self.file("p.json", {"points": wave(0, 9)})
        for words in (["--pixel", "1"], ["--pen", "--smooth", "3"], ["--pen", "--corners", "auto"], ["--pen", "--free-ends"],
                      ["--degree", "8"], ["--tolerance", "0"], ["--corners", "x"]):
            self.refused(2, "fit", name, *words)


class Fit(ProgramTest):
    def test_closed_by_force(self):
        """Ends far apart stay where the pen put them: every sample is within the tolerance."""
        arc = [[200 * math.cos(a / 50), 200 * math.sin(a / 50)] for a in range(30, 280)]
        for stroke in (wave(0, 500), [[x, 0] for x in range(0, 501, 4)], arc):
            result = self.json("fit", "--pen", self.file("s.json", {"points": stroke}), "--closed")
            self.assertTrue(result["closed"])
            self.assertLess(distance(stroke, result), 1)
            self.assertLess(result["report"]["max_error"], 1)

    def test_within_tolerance(self):
        points = wave(0, 200)
        for tolerance in (2, 0.2, 0.05):
            curve = self.json("fit", "--pen", self.file("s.json", {"points": points}), "--tolerance", tolerance, "--pixel", "0.1")
            self.assertLessEqual(distance(points, curve), tolerance * 1.01)
            self.assertEqual(curve["report"]["knots_after"], len(curve["knots"]))
            self.assertLess(len(curve["points"]), 60)

    def test_tolerance_that_cannot_be_met_is_bad_data(self):
        points = [[x + 3 * math.sin(9.7 * x * x), y + 3 * math.sin(7.1 * x * x)] for x, y in wave(0, 300)]
        name = self.file("s.json", {"points": points})
        line = self.refused(1, "fit", "--pen", name, "--tolerance", "0.001")
        self.assertRegex(line, r"s\.json: points: expected a fit within 0\.001, the best found reaches \d")
        self.assertGreater(float(line.split()[-1]), 0.001)

    def test_csv_and_json_are_the_same(self):
        points = wave(0, 100)
        as_json = self.done("fit", "--pen", self.file("s.json", {"points": points, "pressure": [0.5] * 101}))
        csv = "x,y,pressure\n" + "".join(f"{x!r},{y!r},0.5\n" for x, y in points)
        self.assertEqual(self.done("fit", "--pen", self.file("s.csv", csv)), as_json)
        self.assertEqual(self.done("fit", "--pen", "-", stdin=csv), as_json)

    def test_closed(self):
        arc = [[50 * math.cos(a), 50 * math.sin(a)] for a in numpy.linspace(0, 5.6, 150)]
        name = self.file("s.json", {"points": arc})
        self.assertFalse(self.json("fit", "--pen", name)["closed"])
        self.assertTrue(self.json("fit", "--pen", name, "--closed")["closed"])

    def test_dots_and_bad_strokes(self):
        self.assertIn("too short", self.refused(1, "fit", "--pen", self.file("s.json", {"points": [[1, 1]] * 9})))
        self.assertIn("too short", self.refused(1, "fit", "--pen", self.file("s.json", {"points": [[1, 1], [1.2, 1]]})))
        for bad in ("", "{}", {"points": []}, {"points": [[0, 0], [1]]}, {"points": "no"},
                    {"points": wave(0, 9), "pressure": [1]}, "x,y\n1,2\n3\n", "a,b\n1,2\n"):
            with self.subTest(bad=bad):
                self.assertIn("s.json: ", self.refused(1, "fit", "--pen", self.file("s.json", bad)))

    def test_raw_error_counts_what_was_left_out(self):
        hook = [[-3, 3], [-2, 1]] + wave(0, 200)
        report = self.json("fit", "--pen", self.file("s.json", {"points": hook}))["report"]
        self.assertGreaterEqual(report["raw_error"], report["max_error"])
        self.assertGreater(report["raw_error"], 1)


class Sketch(ProgramTest):
    def setUp(self):
        super().setUp()
        self.roof_text = self.done("fit", "--pen", self.file("s.json", {"points": wave(0, 200)}), "--tolerance", "0.5")
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
