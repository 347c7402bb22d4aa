"""G-code, read by a machine of our own: it keeps to what controllers accept, the tool is up when it travels, and what it cuts is the
drawing within the tolerance, in both directions."""
import json
import math
import re
import unittest

import numpy

from program import CURVE, RING, ROOT, ProgramTest

DRAWINGS = ("examples/car.svg", "docs/pictures/levels-fig2.svg")
UP, DOWN = "G0 Z5", "G1 Z-1 F300"


def away(points, line):
    """The greatest distance from any of the points to the polylines."""
    start = numpy.concatenate([one[:-1] for one in line])
    along = numpy.concatenate([numpy.diff(one, axis=0) for one in line])
    squares = numpy.maximum(numpy.einsum("ij,ij->i", along, along), 1e-300)
    def to(p):
        t = numpy.clip(numpy.einsum("ij,ij->i", p - start, along) / squares, 0, 1)
        return numpy.min(numpy.linalg.norm(start + t[:, None] * along - p, axis=1))
    return max(map(to, points))


class Machine:
    """Follows absolute moves in millimetres. Keeps what is cut as polylines."""

    def __init__(self, text, up, down):
        self.at, self.feed, self.is_down, self.cuts = None, None, None, []
        lines = text.splitlines()
        assert lines[:3] == ["G21", "G90", "G17"] and lines[-1] == "M2", "units, absolute, plane; the end"
        i = 3
        while i < len(lines) - 1:
            if lines[i:i + len(up)] == up:
                self.is_down, i = False, i + len(up)
            elif lines[i:i + len(down)] == down:
                assert self.is_down is False, "lowered twice, or never raised"
                self.is_down, self.feed, i = True, None, i + len(down)
                self.cuts.append([self.at])
            else:
                self.move(lines[i])
                i += 1
        assert self.is_down is False, "raised at the end"

    def move(self, line):
        assert re.fullmatch(r"G[0123]( [XYIJF]-?\d+(\.\d*[1-9])?)+", line), line
        words = {w[0]: float(w[1:]) for w in line.split()}
        to = (words["X"], words["Y"])
        assert to != self.at, "a move to where it is: " + line
        if words["G"] == 0:
            assert not self.is_down, "travels while down: " + line
        else:
            assert self.is_down, "cuts while up: " + line
            self.feed = words.get("F", self.feed)
            assert self.feed, "no feed: " + line
            self.cuts[-1].extend([to] if words["G"] == 1 else self.arc(to, words))
        self.at = to

    def arc(self, to, words):
        centre = numpy.array(self.at) + (words["I"], words["J"])
        a, b = numpy.subtract(self.at, centre), numpy.subtract(to, centre)
        assert abs(numpy.hypot(*a) - numpy.hypot(*b)) < 5e-4, "controllers refuse radii that differ"
        turn = math.atan2(b[1], b[0]) - math.atan2(a[1], a[0])
        turn = turn % (2 * math.pi) if words["G"] == 3 else -(-turn % (2 * math.pi))
        assert abs(turn) < 2.1, "pieces of a third of a circle"
        count = 2 + int(abs(turn) / min(0.05, math.sqrt(0.004 / numpy.hypot(*a))))  # within 0.0005 of the arc
        angles = math.atan2(a[1], a[0]) + turn * numpy.arange(1, count + 1) / count
        points = [tuple(p) for p in (centre + numpy.hypot(*a) * numpy.column_stack([numpy.cos(angles), numpy.sin(angles)]))]
        return points[:-1] + [to]


class Gcode(ProgramTest):
    def machine(self, name, *words, up=UP, down=DOWN):
        text = self.done("convert", name, "-", "--to", "gcode", *words).decode()
        return Machine(text, up.split("\n"), down.split("\n"))

    def drawn(self, name):
        """Every curve as a polyline within 0.005, as the machine has it."""
        native = self.json("convert", name, "-", "--to", "batten")
        scale = native.get("scale", 25.4 / 96)
        page = native.get("page") or [0, 0, 0, 0]
        listed = self.json("convert", name, "-", "--to", "json")
        curves = [json.dumps(curve) for curve in (listed if isinstance(listed, list) else [listed])]
        flat = self.done("curve", "flatten", "-", "--lines", "--tolerance", 0.005, stdin="\n".join(curves)).splitlines()
        for points in (numpy.array(json.loads(line)["points"]) for line in flat):
            yield scale * numpy.column_stack([points[:, 0] - page[0], page[1] + page[3] - points[:, 1]])

    def test_what_is_cut_is_the_drawing(self):
        for name in DRAWINGS:
            drawn = list(self.drawn(ROOT / name))
            for tolerance in (0.5, 0.01):
                cuts = [numpy.array(cut) for cut in self.machine(ROOT / name, "--arcs", tolerance).cuts]
                slack = 1e-4 + 0.01  # the polylines that both become
                self.assertLess(away(numpy.concatenate(drawn)[::17], cuts), tolerance + slack)
                self.assertLess(away(numpy.concatenate(cuts)[::29], drawn), tolerance + slack)

    def test_templates(self):
        machine = self.machine(ROOT / DRAWINGS[0], "--up", r"M5\nG4 P0.2", "--down", "M3 S1000", "--feed", "600", up="M5\nG4 P0.2",
                               down="M3 S1000")
        self.assertEqual(machine.feed, 600)

    def test_circles_close(self):
        for radius in (0.00003, 0.0001, 0.004, 1, 50, 1e6):
            svg = self.file("c.svg", f'<svg xmlns="http://www.w3.org/2000/svg" width="1mm" height="1mm" viewBox="0 -1 1 1"><circle cx="0" cy="0" r="{radius}"/></svg>')
            cuts = self.machine(svg).cuts
            self.assertEqual(len(cuts), 1)
            if radius >= 0.004:
                self.assertEqual(cuts[0][0], cuts[0][-1])
                length = numpy.linalg.norm(numpy.diff(cuts[0], axis=0), axis=1).sum()
                self.assertLess(abs(length / (2 * math.pi * radius) - 1), 0.1)
            else:
                self.assertLessEqual(numpy.abs(cuts[0]).max(), 2e-4)

    def test_hidden_is_not_cut(self):
        shown = {"id": 1, "kind": "path", "curves": [CURVE]}
        hidden = {"id": 2, "kind": "path", "curves": [RING], "hidden": True}
        document = {"batten": 1, "page": [0, 0, 10, 10], "next": 3, "objects": [shown, hidden]}
        name = self.file("d.batten", document)
        self.assertEqual(len(self.machine(name).cuts), 1)
        document["objects"] = [hidden]
        self.assertIn("expected 1 at least, found none", self.refused(1, "convert", self.file("e.batten", document), "o.gcode"))

    def test_refusals(self):
        space = dict(CURVE, points=[p + [1] for p in CURVE["points"]])
        self.assertIn("found one in space", self.refused(1, "convert", self.file("s.json", space), "o.gcode"))
        far = dict(CURVE, points=[[x * 1e9, y] for x, y in CURVE["points"]])
        self.assertIn("1e7", self.refused(1, "convert", self.file("f.json", far), "o.gcode"))
        flat = self.file("c.json", CURVE)
        self.assertIn("ASCII", self.refused(2, "convert", flat, "o.gcode", "--up", "Höhe"))
        self.assertIn("--feed is for .gcode", self.refused(2, "convert", flat, "o.dxf", "--feed", "1"))
        for bad in ("0", "-1", "nan", "x"):
            self.refused(2, "convert", flat, "o.gcode", "--feed", bad)
            self.refused(2, "convert", flat, "o.gcode", "--arcs", bad)
        self.assertIn("written, not read", self.refused(1, "convert", self.file("a.gcode", "G21\n"), "o.svg"))
        self.assertFalse((self.folder / "o.gcode").exists())


if __name__ == "__main__":
    unittest.main()
