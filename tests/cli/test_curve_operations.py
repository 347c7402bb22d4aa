"""curve ...: against scipy's B-splines, quadrature, closed forms, and what the contract says of bad data."""
import json
import math
import unittest

import numpy
from scipy.integrate import quad
from scipy.interpolate import BSpline

from program import CURVE, RING, ProgramTest

SPACE = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2],
         "points": [[0, 0, 0], [2, 3, 1], [5, 2, -1], [6, -1, 2], [9, 0, 4]]}
AT = numpy.linspace(0, 2, 4001)


def spline(curve):
    return BSpline(curve["knots"], numpy.array(curve["points"], float), curve["degree"])


def line(*points):
    return {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": list(points)}


class Operations(ProgramTest):
    def setUp(self):
        super().setUp()
        self.curve, self.ring, self.space = (self.file(f"{i}.json", c) for i, c in enumerate((CURVE, RING, SPACE)))

    def test_length_and_bounds(self):
        for name, curve in ((self.curve, CURVE), (self.space, SPACE)):
            slope = spline(curve).derivative()
            length = sum(quad(lambda u: numpy.linalg.norm(slope(u)), a, a + 1, epsabs=1e-13)[0] for a in (0, 1))
            self.assertAlmostEqual(self.json("curve", "length", name)["length"], length, 11)
            box, points = self.json("curve", "bounds", name), spline(curve)(AT)
            self.assertLess(numpy.abs(box["low"] - points.min(0)).max(), 1e-5)
            self.assertLess(numpy.abs(box["high"] - points.max(0)).max(), 1e-5)
            self.assertTrue((points >= numpy.array(box["low"]) - 1e-12).all())

    def test_curvature_and_torsion(self):
        result = self.json("curve", "curvature", self.space, "--at", "0.3,1.7,0")
        self.assertEqual(result["u"], [0.3, 1.7, 0])
        for u, bend, turn in zip(result["u"], result["curvature"], result["torsion"]):
            a, b, c = (spline(SPACE)(u, nu=k) for k in (1, 2, 3))
            n = numpy.cross(a, b)
            self.assertAlmostEqual(bend, numpy.linalg.norm(n) / numpy.linalg.norm(a) ** 3, 12)
            self.assertAlmostEqual(turn, n @ c / (n @ n), 12)
        plane = self.json("curve", "curvature", self.curve, "--samples", "4")
        self.assertEqual(plane["torsion"], [0, 0, 0, 0])
        self.assertLess(plane["curvature"][1], 0)

    def test_the_same_curve_in_other_words(self):
        points = spline(CURVE)(AT)
        for words in (["elevate", "--degree", "5"], ["insert", "--at", "1.5,0.25,1.5"], ["reverse"]):
            made = self.json("curve", words[0], self.curve, *words[1:])
            expected = points[::-1] if words == ["reverse"] else points
            self.assertLess(numpy.abs(spline(made)(AT) - expected).max(), 1e-12)
        self.assertEqual(self.json("curve", "elevate", self.curve, "--degree", "5")["degree"], 5)
        self.assertEqual(self.json("curve", "insert", self.curve, "--at", "1.5,.25,1.5")["knots"],
                         [0, 0, 0, 0, 0.25, 1, 1.5, 1.5, 2, 2, 2, 2])

    def test_split_and_join(self):
        left, right = self.json("curve", "split", self.curve, "--at", "0.7")
        self.assertEqual((left["knots"][-1], right["knots"][0]), (0.7, 0.7))
        for piece, at in ((left, AT[AT <= 0.7]), (right, AT[AT >= 0.7])):
            self.assertLess(numpy.abs(spline(piece)(at) - spline(CURVE)(at)).max(), 1e-12)
        a, b = self.file("a.json", left), self.file("b.json", right)
        whole = self.file("whole.json", self.json("curve", "join", a, b))
        self.assertLess(self.json("curve", "distance", whole, self.curve)["distance"], 1e-8)
        smooth = self.json("curve", "join", a, b, "--continuity", "C2")
        self.assertEqual(smooth["knots"].count(0.7), 1)
        self.assertIn("expected to begin within", self.refused(1, "curve", "join", b, a))
        self.assertIn("closed", self.refused(1, "curve", "split", self.ring, "--at", "1"))
        self.assertIn("closed", self.refused(1, "curve", "join", self.curve, self.ring))
        self.assertIn("inside the domain", self.refused(1, "curve", "split", self.curve, "--at", "2"))

    def test_blend_and_match(self):
        def end(curve, u, way):  # tangent, curvature vector, rate of its length, of scipy's derivatives, as one goes that way
            a, b, c = (spline(curve)(u, nu=k) * way**k for k in (1, 2, 3))
            n, v = numpy.cross(a, b), numpy.linalg.norm(a)
            bend = numpy.linalg.norm(n) / v**3
            rate = n @ numpy.cross(a, c) / numpy.linalg.norm(n) / v**4 - 3 * bend * (a @ b) / v**3
            return numpy.concatenate([a / v, (b - a * (a @ b) / v**2) / v**2, [rate]])

        other = {**SPACE, "points": [[p[0] + 12, p[1] * 0.7, 3 - p[2]] for p in SPACE["points"]]}
        b = self.file("other.json", other)
        made = self.json("blend", self.space, b, "--continuity", "G3", "--continuity-to", "G2", "--tension", "1,1.3")
        self.assertEqual(made["degree"], 6)
        self.assertLess(numpy.abs(end(made, 0, 1) - end(SPACE, 2, 1)).max(), 1e-8)
        self.assertLess(numpy.abs(end(made, 1, 1) - end(other, 0, 1))[:6].max(), 1e-8)
        self.assertLess(max(made["report"]["jump_from"] + made["report"]["jump_to"][:3]), 1e-8)
        met = self.json("match", self.space, b, "--continuity", "G3", "--from", "start", "--to", "end")
        self.assertEqual(met["points"][-1], SPACE["points"][-1])
        self.assertLess(numpy.abs(end(met, 0, 1) - end(other, 2, 1)).max(), 1e-8)
        self.assertIn("closed", self.refused(1, "blend", self.curve, self.ring))
        self.assertIn("apart", self.refused(1, "blend", self.curve, self.curve, "--to", "end"))

    def test_flatten(self):
        for tolerance in (0.1, 1e-3, 1e-6):
            points = numpy.array(self.json("curve", "flatten", self.space, "--tolerance", tolerance)["points"])
            sides = points[1:] - points[:-1]
            worst = 0
            for x in spline(SPACE)(AT):
                along = numpy.clip(((x - points[:-1]) * sides).sum(1) / (sides ** 2).sum(1), 0, 1)
                worst = max(worst, numpy.linalg.norm(points[:-1] + along[:, None] * sides - x, axis=1).min())
            self.assertLessEqual(worst, tolerance)
            self.assertLess(len(points), 12 / math.sqrt(tolerance))

    def test_arcs(self):
        result = self.json("curve", "arcs", self.curve, "--tolerance", "0.001")
        self.assertLessEqual(result["max_error"], 0.001)
        worst, last = 0, None
        for arc in result["arcs"]:
            for end in ("from", "to"):
                if "radius" in arc:
                    radius = math.dist(arc[end], arc["centre"])
                    self.assertAlmostEqual(radius, arc["radius"], delta=1e-9 * radius)
            if last:
                self.assertEqual(arc["from"], last)
            last = arc["to"]
        for x in spline(CURVE)(AT[::20]):
            worst = max(worst, min(abs(math.dist(x, arc["centre"]) - arc["radius"]) for arc in result["arcs"]))
        self.assertLessEqual(worst, 0.001)
        self.assertLess(len(result["arcs"]), 40)
        self.assertIn("in the plane", self.refused(1, "curve", "arcs", self.space, "--tolerance", "1"))

    def test_tolerances_that_rounding_hides(self):
        """Told, not tried until the day is over."""
        for words in (["offset", "--distance", "1e70"], ["offset", "--distance", "3", "--tolerance", "1e-15"], ["arcs", "--tolerance", "1e-30"]):
            said = self.refused(1, "curve", words[0], self.curve, *words[1:])
            self.assertRegex(said, "--tolerance: expected one .*found too small a one")
        far = self.file("far.json", {**CURVE, "points": [[x + 1e12, y] for x, y in CURVE["points"]]})
        self.refused(1, "curve", "arcs", far, "--tolerance", "1e-6")
        self.assertGreater(len(self.json("curve", "arcs", far, "--tolerance", "0.1")["arcs"]), 1)
        straight = self.file("l.json", line([1e12, 0], [1e12 + 3, 4]))
        self.assertEqual(len(self.json("curve", "arcs", straight, "--tolerance", "1e-9")["arcs"]), 1)

    def test_offset(self):
        for name, curve in ((self.curve, CURVE), (self.ring, RING)):
            near = spline(curve)(AT) if curve is CURVE else None
            for distance in (0.5, -0.5):
                made = self.json("curve", "offset", name, "--distance", str(distance), "--tolerance", "0.001")
                self.assertGreater(len(made), 0)
                for one in made:
                    self.assertLessEqual(one["report"]["max_error"], 0.001)
                    if near is None:
                        continue
                    for x in spline(one)(numpy.linspace(one["knots"][0], one["knots"][-1], 200)):
                        far = numpy.linalg.norm(near - x, axis=1).min()
                        self.assertLess(abs(far - 0.5), 0.0011)
        turned = self.file("344.json", {"degree": 3, "closed": False, "knots": [0] * 4 + [1] * 4,
                                        "points": [[51, 0], [-0.0859375, 161.640625], [0, 164], [0, 164]]})
        self.assertEqual(len(self.json("curve", "offset", turned, "--distance", "-8", "--tolerance", "0.01")), 1)
        short = self.file("short.json", line([0, 0], [3, 4]))
        made = self.json("curve", "offset", short, "--distance", "5", "--tolerance", "1e-6")
        self.assertLess(numpy.abs(numpy.array([made[0]["points"][0], made[0]["points"][-1]]) -
                                  [[-4, 3], [-1, 7]]).max(), 1e-12)
        self.assertEqual(self.json("curve", "offset", short, "--distance", "0")[0]["points"], [[0, 0], [3, 4]])
        self.assertIn("--distance", self.refused(2, "curve", "offset", self.curve))
        self.assertIn("in the plane", self.refused(1, "curve", "offset", self.space, "--distance", "1"))

    def test_region(self):
        try:
            import shapely.geometry
        except ImportError:
            self.skipTest("shapely is not installed")
        methods = {"union": "union", "difference": "difference", "intersection": "intersection", "exclusion": "symmetric_difference"}
        random = numpy.random.default_rng(5)

        def ring():
            n = int(random.integers(3, 9))
            turn = 2 * math.pi * numpy.arange(n) / n
            points = random.uniform(2, 6, (n, 1)) * numpy.column_stack((numpy.cos(turn), numpy.sin(turn)))
            return (points + random.uniform(-3, 3, 2)).tolist()

        for i in range(24):
            a, b = ring(), ring()
            files = [self.file(f"r{k}.json", {"degree": 1, "closed": True, "knots": list(range(len(p) + 1)), "points": p})
                     for k, p in enumerate((a, b))]
            name = list(methods)[i % 4]
            made = self.json("curve", "region", *files, "--operation", name)
            expected = getattr(shapely.geometry.Polygon(a), methods[name])(shapely.geometry.Polygon(b))
            whole = shapely.geometry.Polygon()
            for one in made:  # degree 1: its points are its corners
                whole = whole.symmetric_difference(shapely.geometry.Polygon(one["points"]))
            self.assertLess(whole.symmetric_difference(expected).area, 1e-4)
        square = self.file("q.json", {"degree": 1, "closed": True, "knots": [0, 1, 2, 3, 4], "points": [[0, 0], [4, 0], [4, 4], [0, 4]]})
        self.assertEqual(self.json("curve", "region", square, square, "--operation", "exclusion"), [])
        self.assertEqual(self.json("curve", "region", square, square)[0]["points"], [[0, 0], [4, 0], [4, 4], [0, 4]])
        self.assertIn("a closed curve", self.refused(1, "curve", "region", square, self.curve))
        self.assertIn("in the plane", self.refused(1, "curve", "region", self.space, self.space))
        self.refused(2, "curve", "region", square, square, "--operation", "sum")
        self.refused(2, "curve", "region", square, square, "--tolerance", "0")
        self.refused(2, "curve", "region", square)

    def test_outline(self):
        """Strokes along random polylines, which often cross themselves, cover what shapely's buffers do."""
        try:
            import shapely.geometry
        except ImportError:
            self.skipTest("shapely is not installed")
        random = numpy.random.default_rng(6)
        for _ in range(4):
            points = random.uniform(0, 10, (5, 2)).tolist()
            name = self.file("s.json", {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 3, 4, 4], "points": points})
            made = self.json("curve", "outline", name, "--width", "0.8", "--tolerance", "1e-4")
            buffer = shapely.geometry.LineString(points).buffer(0.4, 256)
            area = 0
            for curve in made:
                self.assertTrue(curve["closed"])
                self.assertLess(curve["report"]["max_error"], 1.2e-4)
                del curve["report"]
                flat = numpy.array(self.json("curve", "flatten", self.file("o.json", curve), "--tolerance", "1e-6")["points"])
                area += float(numpy.sum(flat[:-1, 0] * flat[1:, 1] - flat[:-1, 1] * flat[1:, 0])) / 2
            self.assertAlmostEqual(area, buffer.area, 2)
        self.assertIn("in the plane", self.refused(1, "curve", "outline", self.space, "--width", "1"))
        self.refused(2, "curve", "outline", self.curve)
        self.refused(2, "curve", "outline", self.curve, "--width", "0")
        self.refused(2, "curve", "outline", self.curve, "--width", "1", "--cap", "flat")

    def test_intersect(self):
        parabola = {"degree": 2, "closed": False, "knots": [0, 0, 0, 1, 1, 1], "points": [[-1, 1], [0, -1], [1, 1]]}
        a, b = self.file("p.json", parabola), self.file("l.json", line([-2, 0.25], [2, 0.25]))
        result = self.json("curve", "intersect", a, b)
        self.assertEqual(result["overlaps"], [])
        for hit, x in zip(result["hits"], (-0.5, 0.5)):
            self.assertAlmostEqual(hit["point"][0], x, 12)
            self.assertAlmostEqual(hit["u"], (x + 1) / 2, 12)
            self.assertAlmostEqual(hit["v"], (x + 2) / 4, 12)
            self.assertEqual((hit["kind"], hit["sign"]), ("crosses", -1 if x < 0 else 1))
        c, d = self.file("c.json", line([0, 0], [4, 4])), self.file("d.json", line([6, 6], [2, 2]))
        result = self.json("curve", "intersect", c, d)
        self.assertEqual((result["hits"], result["overlaps"]), ([], [[0.5, 1, 1, 0.5]]))
        loop = {"degree": 3, "closed": False, "knots": [0] * 4 + [1] * 4,
                "points": [[4, -6], [-4 / 3, 26 / 3], [-4 / 3, -26 / 3], [4, 6]]}
        hits = self.json("curve", "intersect", self.file("loop.json", loop))["hits"]
        self.assertEqual(len(hits), 1)
        self.assertLess(math.dist(hits[0]["point"], (1, 0)), 1e-12)
        self.assertIn("expected 2 numbers", self.refused(1, "curve", "intersect", self.curve, self.space))

    def test_distance(self):
        a, b = self.file("a.json", line([0, 0], [10, 0])), self.file("b.json", line([2, 3], [4, 3]))
        self.assertEqual(self.json("curve", "distance", a, b), {"distance": math.sqrt(45), "u": 1, "v": 1})
        self.assertEqual(self.json("curve", "distance", self.curve, self.curve)["distance"], 0)
        stdin = json.dumps(CURVE).encode()
        self.assertEqual(json.loads(self.done("curve", "distance", "-", self.curve, stdin=stdin))["distance"], 0)


if __name__ == "__main__":
    unittest.main()
