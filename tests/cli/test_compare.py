"""label: slow. batten compare against closed forms and numpy, in units and pages of both sides, and on files of models."""
import json
import math
import unittest

import numpy

from program import ROOT, ProgramTest


def circle(radius, n=64, z=None):
    out = 3 / (2 + math.cos(2 * math.pi / n)) * radius
    points = [[out * math.cos(2 * math.pi * i / n), out * math.sin(2 * math.pi * i / n)] + ([] if z is None else [z]) for i in range(n)]
    return {"degree": 3, "closed": True, "knots": list(range(n + 1)), "points": points}


def plane(z, half=1, lean=0):
    return {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2,
            "points": [[[x * half, y * half, z + lean * x] for y in (-1, 1)] for x in (-1, 1)]}


def drawing(objects, **more):
    return {"batten": 2, "next": 100, "objects": objects, **more}


def surface(number, name, content, **more):
    return {"id": number, "kind": "surface", "name": name, "surface": content, **more}


class Compare(ProgramTest):
    def compare(self, a, b, *words):
        return self.json("compare", a if isinstance(a, str) else self.file("a.json", a), b if isinstance(b, str) else self.file("b.json", b),
                         "--json", *words)

    def assertNear(self, found, greatest, mean, rms, within=1e-9):
        for name, want in (("greatest", greatest), ("mean", mean), ("rms", rms)):
            self.assertLessEqual(abs(found[name] - want), within, name)
        self.assertAlmostEqual(math.dist(found["at"], found["to"]), found["greatest"], delta=1e-12 * (1 + greatest))

    def test_closed_forms(self):
        self.assertNear(self.compare(circle(3), circle(1)), 2, 2, 2, 1e-5)
        self.assertNear(self.compare(circle(3, z=4), circle(3)), 4, 4, 4, 1e-5)
        self.assertNear(self.compare(plane(0.25), plane(0, 9)), .25, .25, .25, 1e-14)
        self.assertNear(self.compare(plane(1, lean=1), plane(0, 9)), 2, 1, math.sqrt(4 / 3), 1e-13)
        points = {"vertices": [[0.5, 0, 0]], "faces": []}
        found = self.compare(circle(2), points)
        self.assertNear(found, 2.5, found["mean"], math.sqrt(4.25), 1e-5)

    def test_clouds_as_numpy(self):
        random = numpy.random.default_rng(4)
        a, b = random.uniform(-1, 1, (200, 3)), random.uniform(-1, 1, (500, 3))
        least = numpy.sqrt(((a[:, None] - b[None]) ** 2).sum(2)).min(1)
        found = self.compare({"vertices": a.tolist(), "faces": []}, {"vertices": b.tolist(), "faces": []})
        self.assertNear(found, least.max(), least.mean(), math.sqrt((least ** 2).mean()), 1e-14)
        self.assertEqual(found["at"], a[least.argmax()].tolist())
        self.assertEqual([one["kind"] for one in found["objects"]], ["points"])

    def test_units(self):
        """Ten millimetres above the sheet, said in centimetres; bare numbers stay."""
        high = self.file("high.batten", drawing([surface(1, "up", plane(1))], unit="cm"))
        low = self.file("low.batten", drawing([surface(1, "sheet", plane(0, 90))], unit="mm"))
        found = self.compare(high, low)
        self.assertNear(found, 1, 1, 1, 1e-12)
        self.assertEqual((found["unit"], found["scale"]), ("cm", 10))
        below = self.compare(low, high)
        self.assertNear(below, math.dist((90, 90, 0), (10, 10, 10)), below["mean"],
                        below["rms"], 1e-9)
        self.assertIn("all: greatest 1 cm, mean 1, rms 1, at (", self.done("compare", high, low).decode())
        self.assertNear(self.compare(high, plane(3, 9)), 2, 2, 2, 1e-12)

    def test_objects(self):
        both = self.file("both.batten", drawing([surface(1, "up", plane(1)), surface(2, "far", plane(5)), surface(3, "gone", plane(70), hidden=True)],
                                                unit="mm"))
        found = self.compare(both, plane(0, 9))
        self.assertNear(found, 5, 3, math.sqrt(13), 1e-12)
        self.assertEqual([(one["id"], one["name"], one["kind"], round(one["greatest"], 12)) for one in found["objects"]],
                         [(1, "up", "surface", 1), (2, "far", "surface", 5)])
        self.assertNear(self.compare(both + "#up", plane(0, 9)), 1, 1, 1, 1e-12)
        self.assertNear(self.compare(both + "#3", plane(0, 9)), 70, 70, 70, 1e-11)
        self.assertNear(self.compare(both + "#far", both + "#up"), 4, 4, 4, 1e-12)
        self.assertLess(self.compare(both, both)["greatest"], 1e-12)
        self.assertEqual([line.split(":")[0] for line in self.done("compare", both, both).decode().splitlines()],
                         ["up, surface", "far, surface", "all"])

    def test_models_of_a_drawing(self):
        """What convert writes is as far from the drawing as it was told, whichever way the page stands."""
        ground = {"id": 9, "kind": "plane", "name": "", "origin": [0, 0, 0], "axes": [1, 0, 0, 0, 0, -1]}
        bowl = {"degree": [2, 2], "knots": [[0, 0, 0, 1, 1, 1]] * 2,
                "points": [[[20 * i, 20 * j + 5 * i, -9 * (i == 1) * (j < 2)] for j in range(3)] for i in range(3)]}
        for more in ([], [ground]):
            source = self.file("bowl.batten", drawing([surface(1, "", bowl)] + more, unit="mm"))
            for ending, within in (("stl", 0.011), ("3mf", 0.011), ("glb", 0.011), ("ply", 0.011), ("step", 1e-9), ("iges", 1e-9), ("obj", 0.011)):
                if more and ending in ("3mf", "ply", "iges"):
                    continue  # as stl and step
                with self.subTest(ending=ending, floor=bool(more)):
                    out = str(self.folder / f"bowl.{ending}")
                    self.done("convert", source, out, *(["--triangles"] if ending == "obj" else []), *([] if within < 1e-3 else ["--tolerance", "0.01"]))
                    for a, b in ((source, out), (out, source)):
                        self.assertLessEqual(self.compare(a, b)["greatest"], within)

    def test_spacing(self):
        coarse, fine = (self.compare(circle(3), plane(1, 9), "--spacing", s) for s in ("5", "0.01"))
        self.assertLess(fine["spacing"], coarse["spacing"])
        self.assertNear(fine, 1, 1, 1, 1e-12)
        self.assertIn("--spacing", self.refused(1, "compare", self.file("a.json", plane(0)), self.file("b.json", plane(1)), "--spacing", "1e-5"))

    def test_refused(self):
        one, empty = self.file("one.json", plane(0)), self.file("empty.batten", drawing([]))
        self.assertIn("expected a curve, a surface or a mesh, found none", self.refused(1, "compare", one, empty))
        self.assertIn("expected a curve, a surface or a mesh, found none", self.refused(1, "compare", empty, one))
        self.assertIn("of that name", self.refused(1, "compare", one, empty + "#roof"))
        self.refused(1, "compare", one, self.file("bad.json", "{"))
        self.refused(1, "compare", one, "missing.batten")
        for words in ([one], [one, one, one], [one, one, "--spacing", "-1"], [one, one, "--spacing", "nan"], ["-", "-"]):
            self.refused(2, "compare", *words)


if __name__ == "__main__":
    unittest.main()
