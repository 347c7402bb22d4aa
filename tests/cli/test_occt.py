"""IGES and STEP against Open CASCADE, where its program is installed (Debian: occt-draw): it reads what Batten writes and
finds the same points, and Batten reads what it writes; and the files of other programs that come with it, where they are."""
import json
import pathlib
import re
import sys
import unittest

import numpy

from program import ROOT, ProgramTest

sys.path.insert(0, str(ROOT / "tests" / "models"))
from readers import DRAW, draw  # noqa: E402


def ring(count, radius):
    angles = 2 * numpy.pi * numpy.arange(count) / count
    return numpy.stack([radius * numpy.cos(angles), radius * numpy.sin(angles)], 1)


KNOTS = list(range(13))
SHEET = {"degree": [3, 1], "closed": [False, False], "knots": [[-1, -1, -1, -1, 0.3, 2, 2, 2, 2], [0, 0, 1, 3, 3]],
         "points": [[[i, j, numpy.sin(i + 2 * j)] for j in range(3)] for i in range(5)]}
TUBE = {"degree": [2, 3], "closed": [False, True], "knots": [[0, 0, 0, .5, 1, 1, 1], KNOTS],
        "points": [[[x, y, z] for x, y in ring(12, 1 + z)] for z in (0, .3, .6, 1.1)]}
TORUS = {"degree": [3, 3], "closed": [True, True], "knots": [KNOTS, KNOTS],
         "points": [[[(3 + x) * c, (3 + x) * s, y] for x, y in ring(12, 1)] for c, s in ring(12, 1)]}
BEND = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, .4, 1, 1, 1, 1],
        "points": [[0, 0, 1], [1, 2, 1 / 3], [3, 1e-7, 0], [4, 1, 1], [5, 5, 5]]}
LOOP = {"degree": 3, "closed": True, "knots": KNOTS, "points": [[x, y, x / 10] for x, y in ring(12, 2)]}
UV = [(0, 0), (0.25, 0.5), (0.5, 0.75), (0.7, 0.31), (0.99, 0.01)]  # parts of the domain


def places(thing):
    """Parameters of a curve or a surface, a tuple each."""
    def domain(degree, closed, knots):
        return (knots[0], knots[-1]) if closed else (knots[degree], knots[-1 - degree])
    if isinstance(thing["degree"], int):
        low, high = domain(thing["degree"], thing["closed"], thing["knots"])
        return [(low + (high - low) * u,) for u, _ in UV]
    (a, b), (c, d) = map(domain, thing["degree"], thing["closed"], thing["knots"])
    return [(a + (b - a) * u, c + (d - c) * v) for u, v in UV]


@unittest.skipUnless(DRAW, "occt-draw")
class OpenCascade(ProgramTest):
    def points(self, thing):
        at = places(thing)
        command, between = (("eval",), ",") if len(at[0]) == 1 else (("surface", "eval"), ";")
        words = between.join(",".join(map(repr, map(float, p))) for p in at)
        return numpy.array(self.json(*command, self.file("one.json", thing), f"--at={words}")["points"])

    def convert(self, source, target):
        self.done("surface", "convert", str(source), str(target))
        return json.loads(target.read_text()) if target.suffix == ".json" else target

    READ = {".igs": ["igesread f.igs s *"], ".step": ["stepread f.step s *", "renamevar s_1 s"]}
    WRITE = {".igs": ["brepiges s back.igs"], ".step": ["stepwrite a s back.step"]}

    def test_there_and_back(self):
        surfaces, curves = [TORUS, SHEET, TUBE], [BEND, LOOP]
        for ending in (".igs", ".step"):
            folder = pathlib.Path(self.file("in.json", surfaces + curves)).parent
            self.convert(folder / "in.json", folder / f"f{ending}")
            lines = [*self.READ[ending], "explode s f"]
            for k, thing in enumerate(surfaces):
                lines.append(f"mksurface g s_{k + 1}")
                lines += [f'svalue g {u} {v} x y z; puts "AT [dval x] [dval y] [dval z]"' for u, v in places(thing)]
            lines.append("explode s")
            rest = len(surfaces)
            if ending == ".step":  # what is closed is a solid, the rest a set
                lines += ['puts "SOLID [whatis s_1]"', "explode s_2", *(f"copy s_2_{k} s_{k}" for k in range(3, 5))]
                rest -= 1
            for k, thing in enumerate(curves):
                lines.append(f"mkcurve g s_{rest + k + 1}")
                lines += [f'cvalue g {t[0]} x y z; puts "AT [dval x] [dval y] [dval z]"' for t in places(thing)]
            told = draw(folder, *lines, *self.WRITE[ending])
            self.assertEqual("shape SOLID" in told, ending == ".step", told)
            found = numpy.array([list(map(float, m.split())) for m in re.findall(r"(?m)^AT (.*)$", told)])
            want = numpy.concatenate([self.points(thing) for thing in surfaces + curves])
            self.assertEqual(found.shape, want.shape, told)
            self.assertLess(numpy.abs(found - want).max(), 1e-12)
            back = self.convert(folder / f"back{ending}", folder / "back.json")
            back = back if isinstance(back, list) else [back]
            there = [thing for thing in back if not isinstance(thing["degree"], int)]
            self.assertGreaterEqual(len(there), len(surfaces))  # closed ones may come back in parts
            for thing in surfaces:
                for p in self.points(thing):
                    at = ",".join(map(repr, map(float, p)))
                    self.assertLess(min(self.json("surface", "closest", self.file("b.json", part), f"--point={at}")["distance"]
                                        for part in there), 1e-9)

    def test_files_of_other_programs(self):
        """Samples that Debian's packages hold: each is read, or refused with the place and what was found."""
        samples = [path for pattern in ("*.igs", "*.iges", "*.stp", "*.step")
                   for path in pathlib.Path(DRAW).resolve().parent.parent.glob(f"share/opencascade/data/**/{pattern}")]
        for path in samples:
            result = self.run_program("surface", "convert", str(path), "out.json")
            if result.returncode:
                self.assertRegex(result.stderr.decode(), r"^\S+: (line \d+: )?.*expected .*\n$")


if __name__ == "__main__":
    unittest.main()
