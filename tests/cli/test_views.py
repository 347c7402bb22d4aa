"""cast: against rays and canvases computed here; the reasons for dropped samples; what the contract says of bad data."""
import math
import unittest

import numpy
from scipy.interpolate import BSpline

from program import CURVE, RING, ProgramTest

RANDOM = numpy.random.default_rng(5)
EDGE_ON = math.sin(math.radians(5))


def unit(a):
    return numpy.array(a, float) / numpy.linalg.norm(a)


def axes(view):
    ahead = unit(numpy.subtract(view["target"], view["eye"]))
    right = unit(numpy.cross(ahead, view["up"]))
    return ahead, right, numpy.cross(right, ahead)


def ray(view, pixel):
    ahead, right, above = axes(view)
    w, h = view["size"]
    x, y = pixel[0] - w / 2, h / 2 - pixel[1]
    if "height" in view:
        scale = view["height"] / h
        return numpy.array(view["eye"]) + scale * (x * right + y * above), ahead
    focus = h / 2 / math.tan(math.radians(view["fov"]) / 2)
    return numpy.array(view["eye"], float), unit(focus * ahead + x * right + y * above)


def pixel(view, point):
    ahead, right, above = axes(view)
    w, h = view["size"]
    way = numpy.subtract(point, view["eye"])
    scale = h / view["height"] if "height" in view else h / 2 / math.tan(math.radians(view["fov"]) / 2) / (way @ ahead)
    return [w / 2 + scale * (way @ right), h / 2 - scale * (way @ above)]


def some_view(distance, parallel):
    eye = distance * unit(RANDOM.normal(size=3))
    view = {"eye": eye.tolist(), "target": RANDOM.uniform(-1, 1, 3).tolist(), "up": RANDOM.normal(size=3).tolist(),
            "size": [900, 700]}
    return view | ({"height": distance} if parallel else {"fov": 55})


def spline(curve):
    """Value and derivative at s, by scipy."""
    t, p, points = numpy.array(curve["knots"], float), curve["degree"], numpy.array(curve["points"], float)
    if points.shape[1] == 2:
        points = numpy.column_stack([points, numpy.zeros(len(points))])
    if curve["closed"]:
        t = numpy.concatenate([t[:-1] + k * (t[-1] - t[0]) for k in range(-3, 4)])
        points = points[numpy.arange(len(t) - p - 1) % len(points)]
    return BSpline(t, points, p)


class Cast(ProgramTest):
    def cast(self, stroke, view, on):
        return self.json("cast", self.file("stroke.json", {"points": numpy.array(stroke).tolist()}),
                         self.file("view.json", view), self.file("on.json", on))

    def test_on_planes(self):
        kept = 0
        for i in range(30):
            view, normal, origin = some_view(40, i % 2), RANDOM.normal(size=3), RANDOM.uniform(-20, 20, 3)
            stroke = RANDOM.uniform([0, 0], view["size"], (20, 2))
            want, dropped = [], []
            for k, at in enumerate(stroke):
                from_, along = ray(view, at)
                towards = along @ unit(normal)
                far = (origin - from_) @ unit(normal) / towards
                if abs(towards) < EDGE_ON or far < 0:
                    dropped.append({"index": k, "why": "edge-on" if abs(towards) < EDGE_ON else "behind"})
                else:
                    want.append(from_ + far * along)
            on = {"plane": {"origin": origin.tolist(), "normal": normal.tolist()}}
            if not want:
                self.assertEqual(self.run_program("cast", self.file("a", {"points": stroke.tolist()}), self.file("v", view),
                                                  self.file("o", on)).returncode, 1)
                continue
            result = self.cast(stroke, view, on)
            self.assertEqual(list(result), ["points", "dropped"])
            self.assertEqual(result["dropped"], dropped)
            self.assertLess(numpy.abs(numpy.subtract(result["points"], want)).max(), 1e-9 * numpy.abs(want).max())
            kept += len(want)
        self.assertGreater(kept, 300)

    def test_on_ruled_surfaces_places_come_back(self):
        """A stroke drawn along a path of the ruled surface (its places all fit to be kept) lands on the surface and on its rays."""
        kept = exact = 0
        for i in range(200):
            curve = CURVE if i % 2 else RING
            at = spline(curve)
            view, d = some_view(60, i % 3), unit(RANDOM.normal(size=3))
            low, high = (curve["knots"][0], curve["knots"][-1])
            s = numpy.linspace(low, high, 30)[:-1]
            h = 2 * numpy.sin(s) + 0.5
            places = at(s) + h[:, None] * d
            stroke = numpy.array([pixel(view, p) for p in places])
            sine = numpy.array([abs(numpy.cross(unit(at(a, 1)), d) @ ray(view, p)[1]) for a, p in zip(s, stroke)])
            on = {"curve": curve, "along": (3 * d).tolist()}
            if not (sine > 1.001 * EDGE_ON).all():
                continue
            result = self.cast(stroke, view, on)
            self.assertEqual(list(result), ["points", "dropped", "s", "h"])
            self.assertEqual(result["dropped"], [])
            for p, place, a, b in zip(stroke, result["points"], result["s"], result["h"]):
                self.assertLess(numpy.abs(at(a) + b * d - place).max(), 1e-10)
                from_, along = ray(view, p)
                self.assertLess(numpy.linalg.norm(numpy.cross(numpy.subtract(place, from_), along)), 1e-8)
            kept += 1
            exact += numpy.abs(numpy.subtract(result["points"], places)).max() < 1e-7
        self.assertGreater(kept, 8)
        self.assertGreater(exact, 3)

    def test_why_samples_are_dropped_on_a_ruled_surface(self):
        on = {"curve": {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[-1, 0], [1, 0]]}, "along": [0, 0, 5]}
        view = {"eye": [0, -9, 0], "target": [0, 0, 0], "up": [0, 0, 1], "size": [100, 100], "height": 20}
        result = self.cast([[50, 50], [40, 50], [50, 9], [52, 60]], view, on)
        self.assertEqual(result["dropped"], [{"index": 1, "why": "miss"}, {"index": 2, "why": "far"}])
        self.assertLess(numpy.abs(numpy.subtract(result["points"], [[0, 0, 0], [0.4, 0, -2]])).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.subtract(result["s"], [0.5, 0.7])).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.subtract(result["h"], [0, -2])).max(), 1e-12)
        away = dict(view, target=[0, -99, 0])
        line = self.refused(1, "cast", self.file("s", {"points": [[50, 50]]}), self.file("v", away), self.file("o", on))
        self.assertIn("points: expected samples that land, found none of 1", line)

    def test_on_a_surface(self):
        bowl = {"degree": [2, 2], "knots": [[0, 0, 0, 1, 1, 1]] * 2,  # z = x^2 + y^2
                "points": [[[x, y, a + b] for y, b in ((-1, 1), (0, -1), (1, 1))] for x, a in ((-1, 1), (0, -1), (1, 1))]}
        view = {"eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "size": [100, 100], "height": 4}
        result = self.cast([[50, 50], [60, 50], [50, 70], [1, 1]], view, bowl)
        self.assertEqual(list(result), ["points", "dropped", "uv"])
        self.assertEqual(result["dropped"], [{"index": 3, "why": "miss"}])
        self.assertLess(numpy.abs(numpy.subtract(result["points"], [[0, 0, 0], [.4, 0, .16], [0, -.8, .64]])).max(), 1e-12)
        self.assertLess(numpy.abs(numpy.subtract(result["uv"], [[.5, .5], [.7, .5], [.5, .1]])).max(), 1e-12)

    def test_bad_data(self):
        view = {"eye": [0, -9, 0], "target": [0, 0, 0], "up": [0, 0, 1], "size": [100, 100], "height": 20}
        plane = {"plane": {"origin": [0, 0, 0], "normal": [0, 1, 0]}}
        good = {"points": [[1, 2]]}
        for stroke, seen, on, found in (
            (good, dict(view, fov=40), plane, "fov: expected either fov or height"),
            (good, dict(view, up=[0, 3, 0]), plane, "up: expected a direction at an angle to the gaze"),
            (good, dict(view, size=[0, 3]), plane, "size: expected width and height above 0"),
            (good, dict(view, eye=[1]), plane, "eye: expected 2 or 3 numbers"),
            (good, view, {}, "canvas: expected a curve"),
            (good, view, {"plane": {"origin": [0, 0, 0], "normal": [0, 0, 0]}}, "normal: expected a direction other than 0"),
            (good, view, {"curve": CURVE}, "along: expected 2 or 3 numbers, found none"),
            ({"points": [[1, 2, 3]]}, view, plane, "points: expected samples of 2 numbers"),
            ({"points": []}, view, plane, "points: expected"),
        ):
            with self.subTest(found=found):
                self.assertIn(found, self.refused(1, "cast", self.file("s", stroke), self.file("v", seen), self.file("o", on)))

    def test_from_standard_input(self):
        import json
        view = {"eye": [0, 0, 9], "target": [0, 0], "up": [0, 1], "size": [100, 100], "height": 20}
        plane = self.file("p", {"plane": {"origin": [0, 0, 1], "normal": [0, 0, 1]}})
        stroke = self.file("s", "x,y\n50,50\n60,50\n")
        self.assertEqual(self.json("cast", stroke, "-", plane, stdin=json.dumps(view))["points"], [[0, 0, 1], [2, 0, 1]])


class Pick(ProgramTest):
    SHEET = {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0], [0, 2]], [[4, 0], [4, 2]]]}
    ABOVE = {"eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "size": [1000, 1000], "height": 10}

    def pick(self, *marking):
        return self.json("surface", "pick", self.file("s", self.SHEET), self.file("m", {"points": marking}),
                         self.file("v", self.ABOVE))

    def test_the_line_meant(self):
        found = self.pick([600, 450], [620, 400], [640, 350], [499, 400])
        self.assertEqual(list(found), ["direction", "value", "boundary", "used", "dropped", "residuals"])
        self.assertEqual((found["direction"], found["boundary"], found["used"], found["dropped"]), ("u", False, 3, 1))
        self.assertAlmostEqual(found["value"], 0.3, 12)
        self.assertAlmostEqual(found["residuals"]["u"], 0.2 * math.sqrt(2 / 3), 12)
        self.assertAlmostEqual(found["residuals"]["v"], 0.5 * math.sqrt(2 / 3), 12)
        edge = self.pick([540, 499], [800, 499])
        self.assertEqual((edge["direction"], edge["value"], edge["boundary"]), ("v", 0, True))

    def test_beside_the_surface(self):
        line = self.refused(1, "surface", "pick", self.file("s", self.SHEET), self.file("m", {"points": [[1, 1], [2, 2]]}),
                            self.file("v", self.ABOVE))
        self.assertIn("points: expected samples on the surface, found none of 2", line)


class Sketch(ProgramTest):
    SIDE, KNOTS = 9, [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6]
    SHEET = {"degree": [3, 3], "knots": [KNOTS, KNOTS],
             "points": [[[2 * i, 2 * j, math.sin(i) * math.cos(j)] for j in range(9)] for i in range(9)]}
    VIEW = {"eye": [-30, -40, 35], "target": [8, 8, 0], "up": [0, 0, 1], "size": [1000, 800], "fov": 30}

    def hump(self, option, at, d, height=2.0):
        """Places over the line, raised along d, and the stroke that shows them."""
        line = spline(self.json("surface", "isocurve", self.file("s", self.SHEET), option, repr(at)))
        x = numpy.linspace(0, 1, 150)
        places = line(1 + 4 * x) + height * (numpy.sin(math.pi * x) ** 3)[:, None] * unit(d)
        return places, [pixel(self.VIEW, p) for p in places]

    def sketch(self, stroke, *words):
        return self.json("surface", "sketch", self.file("s", self.SHEET), self.file("t", {"points": stroke}),
                         self.file("v", self.VIEW), *words)

    def test_the_line_passes_by_the_stroke(self):
        for option, d, words in (("--u", [0, 0, 1], ["--tolerance", "0.01"]), ("--v", [0.2, 0.3, 1], []), ("--u", [1, 0, 1], [])):
            places, stroke = self.hump(option, 2.6, d)
            made = self.sketch(stroke, option, "2.6", f"--along={','.join(map(str, d))}", *words)
            self.assertEqual(list(made["report"]), ["direction", "value", "reach", "moved", "rows", "gain", "line_error",
                                                    "knots_before", "knots_after"])
            line = spline(self.json("surface", "isocurve", self.file("m", made), option, "2.6"))
            fine = line(numpy.linspace(0, 6, 20001))
            tolerance = 0.01 if words else 1e-4 * 22.7
            off = max(numpy.linalg.norm(fine - p, axis=1).min() for p in places[20:-20])
            self.assertLess(off, 1.3 * tolerance)
            self.assertLess(made["report"]["line_error"], 1e-9)
            k = int(option == "--v")
            self.assertEqual(made["knots"][k], self.KNOTS)
            self.assertEqual(numpy.shape(made["points"])[k], self.SIDE)
            still = [i for i in range(self.SIDE) if i not in made["report"]["rows"]]
            self.assertTrue(still)
            before, after = (numpy.moveaxis(numpy.array(s["points"]), k, 0) for s in (self.SHEET, made))
            for i in still:  # the row, a curve, has the same shape
                rows = [spline({"degree": 3, "closed": False, "knots": s["knots"][1 - k], "points": p[i]})
                        for s, p in ((self.SHEET, before), (made, after))]
                x = numpy.linspace(0, 6, 101)
                self.assertLess(numpy.abs(rows[0](x) - rows[1](x)).max(), 1e-8)

    def test_reach_and_hold(self):
        _, stroke = self.hump("--u", 2.6, [0, 0, 1])
        made = self.sketch(stroke, "--u", "2.6", "--hold", "0,8", "--reach", "9", "--tolerance", "0.02")
        self.assertEqual(made["report"]["rows"], list(range(1, 8)))

    def test_bad_data(self):
        _, stroke = self.hump("--u", 2.6, [0, 0, 1])
        surface, view = self.file("s", self.SHEET), self.file("v", self.VIEW)

        def refused(code, points, *words):
            return self.refused(code, "surface", "sketch", surface, self.file("t", {"points": points}), view, *words)
        self.assertIn("expected at most a third of the samples dropped, found 60 of 150",
                      refused(1, [[9999, 9999]] * 60 + stroke[60:], "--u", "2.6"))
        self.assertIn("expected a line that can move",
                      refused(1, stroke, "--u", "2.6", "--hold", "0,1,2,3,4,5,6,7,8", "--tolerance", ".02"))
        self.assertIn("expected rows 0 to 8, found 9", refused(1, stroke, "--u", "2.6", "--hold", "9", "--tolerance", ".02"))
        self.assertIn("expected u in the domain", refused(1, stroke, "--u", "7"))
        self.assertIn("too short", refused(1, [[500, 400]], "--u", "2.6"))
        self.assertIn("--along", refused(2, stroke, "--u", "2.6", "--along", "0,0,0"))
        self.assertIn("either --u or --v", refused(2, stroke))


if __name__ == "__main__":
    unittest.main()
