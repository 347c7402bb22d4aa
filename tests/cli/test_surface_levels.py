"""surface levels: taken apart and put together; a relief compared with its formula, evaluated by scipy; gains, detail
carried over; wherever a SURFACE is wanted a RELIEF is its finest level."""
import unittest

import numpy
from scipy.interpolate import BSpline

from program import ProgramTest


def clamped(spans):
    return [0.0] * 3 + [float(k) for k in range(spans + 1)] + [float(spans)] * 3


def sheet(spans, seed):
    """A bent sheet, bicubic, clamped, over [0, spans] in both directions."""
    random, count = numpy.random.default_rng(seed), spans + 3
    points = [[[i, j + .2 * i, .15 * (i - 3) ** 2 + .4 * random.random()] for j in range(count)] for i in range(count)]
    return {"degree": [3, 3], "closed": [False, False], "knots": [clamped(spans)] * 2, "points": points}


def at(surface, u, v, du=0, dv=0):
    """The surface or a derivative on a grid."""
    knots, points = surface["knots"], numpy.array(surface["points"], float)
    along_u = BSpline(knots[0], points, 3)
    along_u = along_u.derivative(du)(u) if du else along_u(u)
    along_v = BSpline(knots[1], numpy.moveaxis(along_u, 1, 0), 3)
    along_v = along_v.derivative(dv)(v) if dv else along_v(v)
    return numpy.moveaxis(along_v, 0, 1)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def moved(base, level):
    """What a level over a base adds, as a surface: the formula of docs/math/surfaces.md."""
    nodes = [numpy.array([sum(k[i + 1:i + 4]) / 3 for i in range(len(k) - 4)]) for k in level["knots"]]
    a, b = unit(at(base, *nodes, du=1)), unit(at(base, *nodes, dv=1))
    n = unit(numpy.cross(a, b))
    leg = unit(a - numpy.cross(n, b))
    d = numpy.array(level["details"])
    world = leg * d[..., :1] + numpy.cross(n, leg) * d[..., 1:2] + n * d[..., 2:]
    return {"knots": level["knots"], "points": world * level.get("gain", 1)}


class Levels(ProgramTest):
    def finest(self, relief, grid):
        got = self.json("surface", "eval", self.file("r.json", relief), "--at", ";".join(f"{u},{v}" for u in grid for v in grid))
        return numpy.array(got["points"]).reshape(len(grid), len(grid), 3)

    def test_apart_and_together(self):
        surface = self.file("s.json", sheet(8, 1))
        relief = self.json("surface", "levels", surface, "--decompose", 3)
        counts = [len(relief["base"]["points"])] + [len(level["details"]) for level in relief["levels"]]
        self.assertEqual(counts, [4, 5, 7, 11])
        back = self.json("surface", "levels", self.file("r.json", relief), "--level", 3)
        numpy.testing.assert_allclose(back["points"], sheet(8, 1)["points"], atol=1e-12)
        self.assertEqual(self.json("surface", "levels", self.file("r.json", relief), "--level", 0), relief["base"])
        small = self.json("surface", "levels", surface, "--decompose", 1, "--coarsest", "6x11")
        self.assertEqual((len(small["base"]["points"]), len(small["base"]["points"][0])), (6, 11))

    def test_formula(self):
        relief = self.json("surface", "levels", self.file("s.json", sheet(8, 2)), "--decompose", 1, "--gain", "1=1.5")
        grid = numpy.linspace(0, 8, 13)
        level = relief["levels"][0]
        self.assertEqual(level["gain"], 1.5)
        expected = at(relief["base"], grid, grid) + at(moved(relief["base"], level), grid, grid)
        numpy.testing.assert_allclose(self.finest(relief, grid), expected, atol=1e-12)

    def test_carried(self):
        relief = self.json("surface", "levels", self.file("s.json", sheet(8, 3)), "--decompose", 1)
        other = sheet(5, 4)
        onto = self.json("surface", "levels", self.file("r.json", relief), "--onto", self.file("o.json", other))
        self.assertEqual(onto["base"], self.json("surface", "levels", self.file("o.json", other), "--level", 0))
        # The details are the same spline of three coordinates, over the other domain.
        one = {"knots": relief["levels"][0]["knots"], "points": relief["levels"][0]["details"]}
        two = {"knots": onto["levels"][0]["knots"], "points": onto["levels"][0]["details"]}
        grid = numpy.linspace(0, 1, 11)
        numpy.testing.assert_allclose(at(two, 5 * grid, 5 * grid), at(one, 8 * grid, 8 * grid), atol=1e-12)
        expected = at(other, 5 * grid, 5 * grid) + at(moved(other, onto["levels"][0]), 5 * grid, 5 * grid)
        numpy.testing.assert_allclose(self.finest(onto, 5 * grid), expected, atol=1e-12)

    def test_as_surface(self):
        relief = self.json("surface", "levels", self.file("s.json", sheet(4, 5)), "--decompose", 1, "--gain", "1=0")
        top = self.json("surface", "levels", self.file("r.json", relief), "--level", 1)
        line = self.json("surface", "isocurve", self.file("r.json", relief), "--u", 1.3)
        self.assertEqual(line, self.json("surface", "isocurve", self.file("t.json", top), "--u", 1.3))

    def test_refused(self):
        surface = self.file("s.json", sheet(4, 6))
        relief = self.file("r.json", self.json("surface", "levels", surface, "--decompose", 1))
        self.assertIn("inner knots for 4 levels", self.refused(1, "surface", "levels", surface, "--decompose", 4))
        self.assertIn("inner knots", self.refused(1, "surface", "levels", surface, "--decompose", 1, "--coarsest", "3x7"))
        self.assertIn("expected level 2, found 1", self.refused(1, "surface", "levels", relief, "--gain", "2=1"))
        self.assertIn("expected level 3, found 1", self.refused(1, "surface", "levels", relief, "--level", 3))
        self.assertIn("relief: expected", self.refused(1, "surface", "levels", self.file("b.json", {"base": 3})).replace("surface:", "relief:"))
        for wrong in ("1", "1=", "1=x", "0=1", "13=1", "1=1e7", "1=1,", ""):
            self.assertIn("--gain", self.refused(2, "surface", "levels", relief, "--gain", wrong))
        self.assertIn("--coarsest", self.refused(2, "surface", "levels", surface, "--coarsest", "4x4"))
        self.assertIn("standard input", self.refused(2, "surface", "levels", "-", "--onto", "-"))


if __name__ == "__main__":
    unittest.main()
