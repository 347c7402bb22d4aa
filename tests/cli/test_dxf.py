"""DXF against ezdxf: it finds no fault in what Batten writes and evaluates the splines to the same points; and Batten reads
what it writes, in every release, to the same shapes."""
import json
import math
import unittest

import numpy

from editor import STYLE
from program import ROOT, ProgramTest

try:
    import ezdxf
    from ezdxf.path import make_path
except ImportError:
    ezdxf = None

DRAWINGS = ("examples/car.svg", "docs/pictures/levels-fig2.svg")
RELEASES = ("R12", "R2000", "R2010", "R2018")


def away(points, line):
    """The greatest distance from any of the points to the polyline."""
    line = numpy.asarray(line, dtype=float)
    start, along = line[:-1], numpy.diff(line, axis=0)
    squares = numpy.maximum(numpy.einsum("ij,ij->i", along, along), 1e-300)
    def to(p):
        t = numpy.clip(numpy.einsum("ij,ij->i", p - start, along) / squares, 0, 1)
        return numpy.min(numpy.linalg.norm(start + t[:, None] * along - p, axis=1))
    return max(map(to, numpy.asarray(points, dtype=float)))


@unittest.skipUnless(ezdxf, "python3-ezdxf is not installed")
class Dxf(ProgramTest):
    def samples(self, name, count=400):
        """Points of every curve of a drawing, y upwards, in millimetres from the page's lower left corner."""
        native = self.json("convert", name, "-", "--to", "batten")
        k, (left, top, _, high) = native.get("scale", 25.4 / 96), native["page"]
        listed = self.json("convert", name, "-", "--to", "json")
        for curve in listed if isinstance(listed, list) else [listed]:
            found = self.json("eval", "-", "--samples", count, stdin=json.dumps(curve))
            yield [[k * (x[0] - left), k * (top + high - x[1]), -k * x[2] if len(x) > 2 else 0] for x in found["points"]]

    def test_what_is_written(self):
        for name in DRAWINGS:
            self.done("convert", ROOT / name, "out.dxf")
            drawing = ezdxf.readfile(self.folder / "out.dxf")
            audit = drawing.audit()
            self.assertFalse(audit.errors or audit.fixes, [e.message for e in audit.errors + audit.fixes])
            entities = list(drawing.modelspace())
            ours = list(self.samples(ROOT / name))
            self.assertEqual(len(entities), len(ours))
            for entity, points in zip(entities, ours):
                size = numpy.ptp(numpy.asarray(points), axis=0).max()
                theirs = [list(v) for v in make_path(entity).flattening(1e-5 * size, segments=64)]
                self.assertLess(away(theirs[::7], points), 1e-3 * size)
                self.assertLess(away(points[::7], theirs), 1e-3 * size)

    def test_splines_are_the_same(self):
        knots = [0, 0, 0, 0, 0.3, 0.9, 2, 2, 2, 2]
        points = [[0, 0], [1, 5], [3, -2], [4, 1 / 3], [9, 0.1], [10, 7]]
        self.file("c.json", {"degree": 3, "closed": False, "knots": knots, "points": points})
        self.done("convert", "c.json", "c.dxf")
        spline = list(ezdxf.readfile(self.folder / "c.dxf").modelspace())[0]
        self.assertEqual(list(spline.knots), knots)
        self.assertEqual([[p[0], -p[1]] for p in spline.control_points], points)
        tool = spline.construction_tool()
        at = [0, 0.2, 0.3, 0.5, 1.7, 2]
        ours = self.json("eval", "c.json", "--at", ",".join(map(str, at)))["points"]
        for u, p in zip(at, ours):
            theirs = tool.point(u)
            self.assertLess(math.hypot(theirs.x - p[0], theirs.y + p[1]), 1e-12)

    def test_what_ezdxf_writes(self):
        for release in RELEASES:
            drawing = ezdxf.new(release)
            drawing.header["$INSUNITS"] = 4
            space = drawing.modelspace()
            space.add_line((0, 0), (10, 5))
            space.add_circle((20, 20), 7)
            space.add_arc((40, 20), 7, 30, 200)
            space.add_arc((40, 20), 3, 300, 20, dxfattribs={"extrusion": (0, 0, -1)})
            space.add_polyline2d([(0, 30, 0.5), (10, 30, 0), (10, 40, -1), (0, 40, 0.2)], format="xyb", close=True)
            space.add_polyline3d([(0, 90, 1), (5, 95, 2), (10, 90, 3)])
            if release != "R12":
                space.add_ellipse((60, 20), (9, 3), 0.4, 0.3, 4)
                space.add_lwpolyline([(0, 30, 0.5), (10, 30, 0), (10, 40, -1)], format="xyb", close=True)
                space.add_open_spline([(0, 50), (5, 60), (10, 40), (20, 50), (22, 60)])
                space.add_rational_spline([(30, 50), (30, 60), (40, 60)], [1, math.sqrt(0.5), 1], degree=2)
            block = drawing.blocks.new("b")
            block.add_circle((1, 0), 1)
            block.add_line((0, 0), (2, 0))
            space.add_blockref("b", (50, 50), dxfattribs={"rotation": 30, "xscale": 2, "yscale": -2})
            drawing.saveas(self.folder / "in.dxf")
            theirs = []
            for entity in space:
                parts = list(entity.virtual_entities()) if entity.dxftype() == "INSERT" else [entity]
                theirs += [[list(v) for v in make_path(e).flattening(1e-4, segments=64)] for e in parts]
            ours = list(self.samples("in.dxf"))
            self.assertEqual(len(ours), len(theirs), release)
            for mine, other in zip(ours, theirs):
                self.assertLess(away(mine[::5], other), 5e-3, release)
                self.assertLess(away(other[::3], mine), 0.1, release)  # corners lie between samples
                if numpy.linalg.norm(numpy.subtract(mine[0], mine[-1])) > 1:  # where a closed one begins is left open
                    self.assertLess(numpy.linalg.norm(numpy.subtract(mine[0], other[0])), 1e-6, release)

    def test_points_that_all_coincide(self):
        """Nothing is written of them, and a drawing of such alone is refused, so that what is written can be read."""
        dot = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 2], "points": [[3, 4]] * 3}
        ring = {"degree": 1, "closed": True, "knots": [0, 1, 2, 3], "points": [[3, 4, 5]] * 3}
        line = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [9, 2]]}
        for curve in (dot, ring):
            path = {"kind": "path", "name": "", "style": STYLE}
            objects = [{"id": 1, **path, "curves": [curve]}, {"id": 2, **path, "curves": [line]}]
            name = self.file("both.batten", {"batten": 1, "page": [0, 0, 9, 9], "next": 3, "objects": objects})
            self.done("convert", name, "both.dxf")
            self.assertEqual([e.dxftype() for e in ezdxf.readfile(self.folder / "both.dxf").modelspace()], ["LINE"])
            self.done("convert", "both.dxf", "back.batten")
            alone = self.file("dot.batten", {"batten": 1, "page": [0, 0, 9, 9], "next": 2, "objects": objects[:1]})
            self.refused(1, "convert", alone, "dot.dxf")
            self.assertFalse((self.folder / "dot.dxf").exists())

    def test_arcs(self):
        self.done("convert", ROOT / DRAWINGS[0], "arcs.dxf", "--arcs", "0.05")
        drawing = ezdxf.readfile(self.folder / "arcs.dxf")
        self.assertFalse(drawing.audit().errors)
        self.assertEqual({e.dxftype() for e in drawing.modelspace()} - {"LWPOLYLINE", "LINE"}, set())
        line = self.refused(2, "convert", ROOT / DRAWINGS[0], "x.svg", "--arcs", "1")
        self.assertIn("--arcs is for .dxf, not for .svg", line)


if __name__ == "__main__":
    unittest.main()
