"""surface eval, isocurve: against FITPACK (scipy's bisplev), tensor products of scipy's splines, closed forms, and what
the contract says of bad data."""
import json
import unittest

import numpy
from scipy.interpolate import BSpline, bisplev, insert

from program import ProgramTest

RANDOM = numpy.random.default_rng(11)


def axis(degree, closed, count):
    """Knots of one direction."""
    if closed:
        return numpy.cumsum(RANDOM.uniform(0.2, 1, count + 1)).tolist()
    inner = numpy.sort(RANDOM.uniform(1, 3, count - degree - 1))
    return [1.0] * (degree + 1) + inner.tolist() + [3.0] * (degree + 1)


def surface(degree=(3, 3), closed=(False, False), count=(6, 7)):
    knots = [axis(degree[d], closed[d], count[d]) for d in range(2)]
    return {"degree": list(degree), "closed": list(closed), "knots": knots,
            "points": RANDOM.uniform(-10, 10, (*count, 3)).tolist()}


def whole(sheet, d):
    """Knots of one direction, and the indices of the points that belong to them: a closed one over several periods."""
    t, n, p = sheet["knots"][d], numpy.shape(sheet["points"])[d], sheet["degree"][d]
    if not sheet["closed"][d]:
        return numpy.array(t), numpy.arange(n)
    turns = numpy.concatenate([numpy.array(t[:-1]) + k * (t[-1] - t[0]) for k in range(-9, 10)])
    return turns, numpy.arange(len(turns) - p - 1) % n


def value(sheet, u, v, nu=0, nv=0):
    """By scipy's splines, along u and then along v."""
    (s, i), (t, j) = whole(sheet, 0), whole(sheet, 1)
    along_u = BSpline(s, numpy.array(sheet["points"])[i], sheet["degree"][0])(u, nu=nu)  # points along v
    return BSpline(t, along_u[j], sheet["degree"][1])(v, nu=nv)


NAMES = [("points", 0, 0), ("du", 1, 0), ("dv", 0, 1), ("duu", 2, 0), ("duv", 1, 1), ("dvv", 0, 2)]


class Eval(ProgramTest):
    def eval(self, sheet, *words):
        return self.json("surface", "eval", self.file("s.json", sheet), *words)

    def test_against_fitpack(self):
        for degree in ((1, 1), (3, 3), (2, 5), (5, 4)):
            sheet = surface(degree)
            result = self.eval(sheet, "--samples", "5x4", "--derivatives", "2")
            u, v = numpy.linspace(1, 3, 5), numpy.linspace(1, 3, 4)
            self.assertEqual(result["uv"], [[a, b] for a in u for b in v])  # u slowest, ends included
            for name, nu, nv in NAMES:
                if nu > degree[0] - 1 or nv > degree[1] - 1:  # FITPACK gives no derivative that may jump
                    continue
                for c in range(3):
                    tck = (*map(numpy.array, sheet["knots"]), numpy.array(sheet["points"])[..., c].ravel(), *degree)
                    want = bisplev(u, v, tck, nu, nv).ravel()
                    got = numpy.array(result[name])[:, c]
                    self.assertLess(numpy.abs(got - want).max(), 1e-11 * max(10, numpy.abs(want).max()), (degree, name))

    def test_every_kind_against_scipy(self):
        for closed in ((False, True), (True, False), (True, True)):
            for degree in ((3, 3), (1, 7), (6, 2)):
                sheet = surface(degree, closed, (8, 9))
                places = [(a, b) for a in (1.25, 1.5, 2.9) for b in (1.3, 2.2)]
                result = self.eval(sheet, "--at", ";".join(f"{a!r},{b!r}" for a, b in places), "--derivatives", "2")
                for name, nu, nv in NAMES:
                    want = numpy.array([value(sheet, a, b, nu, nv) for a, b in places])
                    self.assertLess(numpy.abs(result[name] - want).max(), 1e-10 * max(10, numpy.abs(want).max()))

    def test_closed_directions_leave_out_the_end_and_take_any_period(self):
        sheet = surface((3, 2), (True, False), (5, 4))
        low, high = sheet["knots"][0][0], sheet["knots"][0][-1]
        u = [place[0] for place in self.eval(sheet, "--samples", "4x2")["uv"]]
        self.assertLess(numpy.abs(numpy.array(u[::2]) - (low + (high - low) * numpy.arange(4) / 4)).max(), 1e-14)
        a = self.eval(sheet, "--at", f"{low + 0.5!r},2")["points"][0]
        b = self.eval(sheet, "--at", f"{low + 0.5 - 3 * (high - low)!r},2")["points"][0]
        self.assertLess(numpy.abs(numpy.subtract(a, b)).max(), 1e-13)

    def test_only_what_is_asked_for(self):
        sheet = surface()
        self.assertEqual(sorted(self.eval(sheet, "--samples", "1x1")), ["points", "uv"])
        self.assertEqual(sorted(self.eval(sheet, "--samples", "2x1", "--derivatives", "1")), ["du", "dv", "points", "uv"])
        self.assertEqual(sorted(self.eval(sheet, "--samples", "2x2", "--normals", "--curvature")),
                         ["gauss", "mean", "normals", "points", "uv"])

    def test_normals_and_curvature(self):
        bowl = {"degree": [2, 2], "knots": [[0, 0, 0, 1, 1, 1]] * 2,  # z = x^2 + y^2, bends towards its normal
                "points": [[[x, y, a + b] for y, b in ((-1, 1), (0, -1), (1, 1))] for x, a in ((-1, 1), (0, -1), (1, 1))]}
        result = self.eval(bowl, "--at", "0.5,0.5;0.75,0.5", "--normals", "--curvature")
        self.assertEqual((result["normals"][0], result["gauss"][0], result["mean"][0]), ([0, 0, 1], 4, 2))
        self.assertAlmostEqual(result["gauss"][1], 4 / (1 + 4 * 0.25) ** 2, 14)
        cone = {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0, 1]] * 2, [[1, 0, 0], [0, 1, 0]]]}
        result = self.eval(cone, "--at", "0,0.5;1,0.5", "--normals", "--curvature")
        self.assertIsNone(result["normals"][0])
        self.assertEqual(result["gauss"][0], result["mean"][0])
        self.assertIsNone(result["gauss"][0])
        self.assertIsNotNone(result["normals"][1])

    def test_points_of_two_numbers_lie_in_the_plane(self):
        sheet = {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "points": [[[0, 0], [0, 1]], [[1, 0], [1, 1]]]}
        self.assertEqual(self.eval(sheet, "--at", "0.5,0.25")["points"], [[0.5, 0.25, 0]])

    def test_bad_data(self):
        good = surface()
        for change, found in (
            ({"degree": 3}, "degree: expected two degrees"), ({"degree": [3, 8]}, "degree: expected 1 to 7"),
            ({"degree": [3, "x"]}, "degree: expected a number"), ({"closed": [True]}, "closed: expected two flags"),
            ({"closed": [1, 0]}, "closed: expected true or false"), ({"knots": [good["knots"][0]]}, "knots: expected two lists"),
            ({"knots": [good["knots"][0], [0, 1]]}, "knots: expected 11 for 7 points, found 2"),
            ({"knots": [good["knots"][0], good["knots"][1][::-1]]}, "knots: expected"),
            ({"points": []}, "points: expected"), ({"points": 7}, "points: expected a list of rows"),
            ({"points": good["points"][:5] + [good["points"][5][:4]]}, "points: expected 7 in each row"),
            ({"points": [[[1, 2, 3]] * 7] * 6}, "points: expected a surface, found all points equal"),
            ({"points": [[[1e80, 2, 3]] * 7] * 6}, "points: expected numbers up to 1e75"),
            ({"points": good["points"][:5] + [[[1]] * 7]}, "points: expected a point of 2 or 3 numbers"),
        ):
            with self.subTest(change=change):
                name = self.file("bad.json", dict(good, **change))
                line = self.refused(1, "surface", "eval", name, "--samples", "2x2")
                self.assertIn(found, line)
                self.assertTrue(line.startswith(name), line)
        name = self.file("s.json", good)
        self.assertIn("--at: expected u in the domain [1, 3], found 0",
                      self.refused(1, "surface", "eval", name, "--at", "0,2"))
        self.assertIn("--at: expected v in the domain", self.refused(1, "surface", "eval", name, "--at", "2,7"))
        self.assertIn("--v: expected v in the domain", self.refused(1, "surface", "isocurve", name, "--v", "7"))
        missing = {key: good[key] for key in ("degree", "knots")}
        self.assertIn("points: expected", self.refused(1, "surface", "eval", self.file("m.json", missing), "--samples", "2x2"))


class Isocurve(ProgramTest):
    def test_is_the_line_of_the_surface(self):
        for closed in ((False, False), (True, False), (False, True)):
            sheet = surface((3, 2), closed, (6, 8))
            name = self.file("s.json", sheet)
            for option, fixed, along in (("--u", 0, 1), ("--v", 1, 0)):
                line = self.json("surface", "isocurve", name, option, "1.75")
                self.assertEqual(line["knots"], sheet["knots"][along])  # to the bit
                self.assertEqual((line["degree"], line["closed"]), (sheet["degree"][along], closed[along]))
                at = [1.2, 1.9, 2.7]
                places = ";".join(f"1.75,{x!r}" if fixed == 0 else f"{x!r},1.75" for x in at)
                want = self.json("surface", "eval", name, "--at", places)["points"]
                got = self.json("eval", self.file("c.json", line), "--at", ",".join(map(repr, at)))["points"]
                self.assertLess(numpy.abs(numpy.subtract(got, want)).max(), 1e-13)

    def test_from_standard_input(self):
        sheet = surface()
        want = self.done("surface", "isocurve", self.file("s.json", sheet), "--u=2")
        self.assertEqual(self.done("surface", "isocurve", "-", "--u", "2", stdin=json.dumps(sheet)), want)


BOWL = {"degree": [2, 2], "knots": [[0, 0, 0, 1, 1, 1]] * 2,  # z = x^2 + y^2
        "points": [[[x, y, a + b] for y, b in ((-1, 1), (0, -1), (1, 1))] for x, a in ((-1, 1), (0, -1), (1, 1))]}


class Search(ProgramTest):
    def test_closest(self):
        sheet = surface((3, 3), (True, False), (9, 8))
        name = self.file("s.json", sheet)
        points = numpy.array(self.json("surface", "eval", name, "--samples", "60x60")["points"])
        for _ in range(5):
            point = RANDOM.uniform(-12, 12, 3)
            near = self.json("surface", "closest", name, f"--point={','.join(map(repr, point.tolist()))}")
            self.assertEqual(list(near), ["u", "v", "distance", "point"])
            jet = self.json("surface", "eval", name, "--at", f"{near['u']!r},{near['v']!r}", "--derivatives", "1")
            gap = numpy.subtract(near["point"], point)
            self.assertLess(numpy.abs(numpy.subtract(jet["points"][0], near["point"])).max(), 1e-12)
            self.assertAlmostEqual(numpy.linalg.norm(gap), near["distance"], 11)
            self.assertLessEqual(near["distance"], numpy.linalg.norm(points - point, axis=1).min() + 1e-12)
            self.assertLess(abs(gap @ jet["du"][0]) / numpy.linalg.norm(jet["du"][0]), 1e-9)

    def test_hits_from_near_to_far(self):
        name = self.file("s.json", BOWL)
        hits = self.json("surface", "hit", name, "--ray=-3,0,0.25,2,0,0")["hits"]
        self.assertEqual([list(hit) for hit in hits], [["u", "v", "distance", "point"]] * 2)
        for hit, want in zip(hits, (2.5, 3.5)):
            self.assertAlmostEqual(hit["distance"], want, 12)
            self.assertLess(numpy.abs(numpy.subtract(hit["point"], [want - 3, 0, 0.25])).max(), 1e-12)
        self.assertEqual(self.json("surface", "hit", name, "--ray", "0,0,5,0,0,1"), {"hits": []})
        self.assertEqual(len(self.json("surface", "hit", name, "--ray=-3,0,0,1,0,0")["hits"]), 1)  # it touches

    def test_bad_data(self):
        name = self.file("s.json", BOWL)
        self.assertIn("--point", self.refused(1, "surface", "closest", name, "--point", "1e80,0,0"))


class Redraw(ProgramTest):
    def redraw(self, sheet, line, *words):
        return self.json("surface", "redraw", self.file("s.json", sheet), self.file("l.json", line), *words)

    def line(self, sheet, option, at, move=(0, 0, 1)):
        line = self.json("surface", "isocurve", self.file("s.json", sheet), option, repr(at))
        return dict(line, points=(numpy.array(line["points"]) + move).tolist())

    def test_the_line_is_the_new_one(self):
        for closed in ((False, False), (True, False), (False, True)):
            sheet = surface((3, 3), closed, (12, 11))
            for option, d in (("--u", 0), ("--v", 1)):
                line = self.line(sheet, option, 2.1)
                made = self.redraw(sheet, line, option, "2.1")
                report = made["report"]
                self.assertEqual(list(report), ["direction", "value", "reach", "moved", "rows", "gain", "line_error",
                                                "knots_before", "knots_after"])
                self.assertEqual((report["direction"], report["value"]), ("uv"[d], 2.1))
                spans = len(set(sheet["knots"][d])) - 1
                width = sheet["knots"][d][-1] - sheet["knots"][d][0]
                self.assertAlmostEqual(report["reach"], 2.5 * width / spans, 12)
                got = self.json("surface", "isocurve", self.file("m.json", made), option, "2.1")
                self.assertLess(numpy.abs(numpy.subtract(got["points"], line["points"])).max(), 1e-12)
                before = numpy.moveaxis(numpy.array(sheet["points"]), d, 0)
                after = numpy.moveaxis(numpy.array(made["points"]), d, 0)
                moved = [i for i in range(len(before)) if not numpy.array_equal(before[i], after[i])]
                self.assertEqual(moved, report["rows"])
                self.assertLess(report["line_error"], 1e-12)

    def test_a_superset_of_knots_refines(self):
        sheet = surface((3, 2), count=(9, 8))
        line = self.line(sheet, "--u", 2.0, (0, 0, 0))
        knots, points, _ = insert(1.7, (numpy.array(line["knots"]), list(numpy.array(line["points"]).T), 2))
        points = numpy.array(points).T[:9] + [0, 0, 1]
        line = {"degree": 2, "closed": False, "knots": knots.tolist(), "points": points.tolist()}
        made = self.redraw(sheet, line, "--u", "2")
        self.assertEqual(made["knots"][1], line["knots"])
        got = self.json("surface", "isocurve", self.file("m.json", made), "--u", "2")
        self.assertLess(numpy.abs(numpy.subtract(got["points"], line["points"])).max(), 1e-12)
        self.assertEqual(made["report"]["knots_after"][1], made["report"]["knots_before"][1] + 1)

    def test_hold_and_reach(self):
        sheet = surface((3, 3), count=(12, 11))
        made = self.redraw(sheet, self.line(sheet, "--u", 2.0), "--u", "2", "--hold", "0,1", "--reach", "9")
        self.assertEqual(made["report"]["rows"], list(range(2, 12)))
        self.assertEqual(made["points"][:2], sheet["points"][:2])
        self.assertEqual(made["report"]["reach"], 9)

    def test_what_can_not_be(self):
        sheet = surface((3, 3), count=(8, 7))
        name, line = self.file("s.json", sheet), self.line(sheet, "--u", 1.0)
        drawn = self.file("l.json", line)
        for words, found in (
            (["--u", "1", "--hold", "0"], "--u: expected a line that can move, found all rows"),
            (["--u", "1.0001", "--hold", "0"], "gain up to 4, found"), (["--u", "0"], "--u: expected u in the domain"),
            (["--v", "2"], "knots: expected the surface's knots"), (["--u", "2", "--hold", "8"], "expected rows 0 to 7, found 8"),
        ):
            with self.subTest(words=words):
                self.assertIn(found, self.refused(1, "surface", "redraw", name, drawn, *words))
        for change, found in (({"closed": True, "knots": [1, 1.5, 2, 2.2, 2.4, 2.6, 2.8, 3]}, "closed: expected"),
                              ({"degree": 2, "knots": line["knots"][1:-1], "points": line["points"][1:]}, "degree: expected 3")):
            self.assertIn(found, self.refused(1, "surface", "redraw", name, self.file("b.json", dict(line, **change)), "--u", "2"))


class Intersect(ProgramTest):
    def flat(self, corners):
        return {"degree": [1, 1], "closed": [False, False], "knots": [[0, 0, 1, 1]] * 2, "points": corners}

    def test_planes_and_a_cylinder(self):
        level = self.flat([[[-2, -2, 0.5], [-2, 2, 0.5]], [[2, -2, 0.5], [2, 2, 0.5]]])
        upright = self.flat([[[0.25, -2, -1], [0.25, -2, 1]], [[0.25, 2, -1], [0.25, 2, 1]]])
        names = self.file("a.json", level), self.file("b.json", upright)
        result = self.json("surface", "intersect", *names)
        self.assertEqual(len(result["curves"]), 1)
        self.assertEqual(result["tangential"], [])
        points = numpy.array(result["curves"][0]["points"])
        self.assertLess(abs(points[:, [0, 2]] - [0.25, 0.5]).max(), 1e-9)
        self.assertEqual(sorted([points[0][1], points[-1][1]]), [-2, 2])
        ring = [[1.01 * numpy.cos(k * numpy.pi / 8), 1.01 * numpy.sin(k * numpy.pi / 8)] for k in range(16)]
        tube = {"degree": [3, 1], "closed": [True, False], "knots": [list(range(17)), [0, 0, 1, 1]],
                "points": [[[*p, -1], [*p, 1]] for p in ring]}
        name = self.file("c.json", tube)
        result = self.json("surface", "intersect", name, names[0], "--tolerance", "1e-4")
        self.assertEqual([curve["closed"] for curve in result["curves"]], [True])
        self.assertLessEqual(result["report"]["max_error"], 1e-4)
        points = numpy.array(result["curves"][0]["points"])
        self.assertLess(abs(points[:, 2] - 0.5).max(), 2e-4)
        apart = self.file("d.json", self.flat([[[-2, -2, 5], [-2, 2, 5]], [[2, -2, 5], [2, 2, 5]]]))
        result = self.json("surface", "intersect", names[0], apart)
        self.assertEqual(result, {"curves": [], "tangential": [], "report": {"max_error": 0}})
        self.refused(2, "surface", "intersect", "-", "-")
        self.refused(2, "surface", "intersect", *names, "--tolerance", "0")
        self.refused(1, "surface", "intersect", names[0], self.file("e.json", {"degree": 3}))


class Match(ProgramTest):
    def test_goes_on_with_the_derivatives_of_the_other(self):
        """By scipy: across the edge the first and the second derivative are the other's, times one factor and its square; the far edge stays."""
        a, b = surface(), surface((4, 3))
        made = self.json("surface", "match", self.file("a.json", a), self.file("b.json", b), "--from", "u1", "--to", "u0")
        self.assertGreater(made["report"]["moved"], 0)
        made = made.get("surface", made)
        turned = numpy.abs(value(made, 3, 1) - value(b, 1, 1)).max() > 1e-9
        for w in (0.0, 0.2, 0.55, 1.0):
            v, at = 1 + 2 * w, 1 + 2 * (1 - w if turned else w)
            self.assertLess(numpy.abs(value(made, 3, v) - value(b, 1, at)).max(), 1e-9)
            self.assertLess(numpy.abs(value(made, 1, v) - value(a, 1, v)).max(), 1e-9)
            mine, its = value(made, 3, v, nu=1), value(b, 1, at, nu=1)
            factor = mine @ its / (its @ its)
            self.assertGreater(factor, 0)
            for order in (1, 2):
                mine, its = value(made, 3, v, nu=order), value(b, 1, at, nu=order)
                self.assertLess(numpy.abs(mine - factor ** order * its).max(), 1e-7 * (1 + numpy.abs(its).max() * factor ** order))

    def test_refusals(self):
        sheet, ring = self.file("s.json", surface()), self.file("r.json", surface(closed=(True, False)))
        self.assertIn("open", self.refused(1, "surface", "match", sheet, ring, "--to", "v0"))
        self.refused(1, "surface", "match", sheet, ring, "--to", "u0")
        self.refused(2, "surface", "match", sheet, sheet, "--continuity", "G4")
        self.refused(2, "surface", "match", sheet, sheet, "--to", "curve")
        self.refused(2, "surface", "match", sheet, sheet, "--tension", "0")


class Blend(ProgramTest):
    def test_goes_on_with_the_derivatives_of_both(self):
        """By scipy: across each edge the first and the second derivative are the surface's, times one factor and its square."""
        a, b = surface(), surface((4, 3))
        made = self.json("surface", "blend", self.file("a.json", a), self.file("b.json", b), "--from", "u1", "--to", "u0",
                         "--continuity", "G2", "--continuity-to", "G1")
        made = made.get("surface", made)
        turned = numpy.abs(value(made, 0.25, 1) - value(b, 1, 1.5)).max() > 1e-9
        for w in (0.0, 0.2, 0.55, 1.0):
            for sheet, at, share, v, orders in ((a, 3, w, 0, 2), (b, 1, 1 - w if turned else w, 1, 1)):
                u = 1 + 2 * share
                self.assertLess(numpy.abs(value(made, w, v) - value(sheet, at, u)).max(), 1e-9)
                factor = None
                for order in range(1, orders + 1):
                    mine, its = value(made, w, v, nv=order), value(sheet, at, u, nu=order)
                    factor = factor or mine @ its / (its @ its)
                    self.assertLess(numpy.abs(mine - factor ** order * its).max(), 1e-7 * numpy.abs(its).max() * factor ** order)

    def test_refusals(self):
        sheet, ring = self.file("s.json", surface()), self.file("r.json", surface(closed=(True, False)))
        self.assertIn("open", self.refused(1, "surface", "blend", sheet, ring, "--to", "v0"))
        self.refused(1, "surface", "blend", sheet, sheet, "--from", "u1", "--to", "u1")
        self.refused(2, "surface", "blend", sheet, sheet, "--continuity", "G4")
        self.refused(2, "surface", "blend", sheet, sheet, "--tension", "0,1")


if __name__ == "__main__":
    unittest.main()
