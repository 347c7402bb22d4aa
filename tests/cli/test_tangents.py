"""batten tangents: through the points, in the directions, the same curve as B-spline and as Béziers (scipy)."""
import json
import math
import random
import re
import unittest

import numpy
from scipy.interpolate import BSpline
from program import ProgramTest


def cubic(b, t):
    s = 1 - t
    return s**3 * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t**3 * b[3]


def angle(a, b):
    a, b = a / numpy.linalg.norm(a), b / numpy.linalg.norm(b)
    return 2 * math.atan2(numpy.linalg.norm(a - b), numpy.linalg.norm(a + b))


def k_of(c0, c1, t):
    """Math 1.2, by angles: the sine of the angle to the outgoing chord over that to the incoming one."""
    a, b = angle(t, c1), angle(t, c0)
    return 1 / (1 + math.sqrt(math.sin(a) / math.sin(b) * numpy.linalg.norm(c1) / numpy.linalg.norm(c0)))


class Tangents(ProgramTest):
    def spline(self, spline, *words):
        return self.json("tangents", self.file("spline.json", spline), *words)

    def as_segments(self, result):
        """The B-spline's pieces agree with the Béziers, in order; returns them."""
        bezier = numpy.array(result["bezier"])
        knots, points, closed = numpy.array(result["knots"]), numpy.array(result["points"]), result["closed"]
        if closed:  # one period, unrolled by the degree
            period = knots[-1] - knots[0]
            knots = numpy.concatenate([knots[-4:-1] - period, knots, knots[1:4] + period])
            points = numpy.concatenate([points[-3:], points])
            breaks = numpy.unique(result["knots"])
        else:
            breaks = numpy.unique(knots)
        self.assertEqual(len(breaks) - 1, len(bezier))
        curve = BSpline(knots, points, 3)
        for low, high, b in zip(breaks, breaks[1:], bezier):
            for t in (0.1, 0.5, 0.9):
                self.assertLess(numpy.abs(curve(low + t * (high - low)) - cubic(b, t)).max(), 1e-11 * 1000)
        return bezier

    def test_even_curvature(self):
        """Through every point; the curvature of each quadratic is greatest at its point, and equal where two meet."""
        rng = random.Random(16)
        for closed in (False, True):
            angles = numpy.linspace(0, 2 * math.pi, 12, endpoint=False)
            points = [[rng.uniform(50, 100) * math.cos(a), rng.uniform(50, 100) * math.sin(a)] for a in angles]
            result = self.spline({"points": points, "closed": closed}, "--mode", "even")
            self.assertEqual(result["degree"], 2)
            self.assertEqual(result["k"], [None] * 12)
            bezier = numpy.array(result["bezier"])
            self.assertEqual(len(bezier), 12 if closed else 10)
            ends = []
            for b, point in zip(bezier, points if closed else points[1:-1]):
                middle = (3 * b[1] - b[0]) / 2
                a, c = b[0] - middle, b[0] - 2 * middle + b[3]
                t = min(max(a @ c / (c @ c), 0), 1)  # where the speed is least
                self.assertLess(numpy.linalg.norm(cubic(b, t) - point), 1e-2)
                sharp = []
                for u in (0, t, 1):
                    d, dd = 2 * ((1 - u) * (middle - b[0]) + u * (b[3] - middle)), 2 * c
                    sharp.append(abs(d[0] * dd[1] - d[1] * dd[0]) / numpy.linalg.norm(d) ** 3)
                self.assertGreaterEqual(sharp[1], max(sharp) * (1 - 1e-12))
                ends.append(sharp)
            for i in range(len(ends) if closed else len(ends) - 1):
                after = ends[(i + 1) % len(ends)][0]
                self.assertAlmostEqual(ends[i][2] / after, 1, delta=1e-6)

    def test_random_splines(self):
        source = random.Random(4)
        for turn in range(40):
            n, size, closed = source.randint(3, 9), 2 + turn % 2, turn % 4 > 1
            points = numpy.array([[source.uniform(-300, 300) for _ in range(size)] for _ in range(n)])
            tangents = [[source.uniform(-1, 1) for _ in range(size)] if source.random() < 0.6 else None for _ in range(n)]
            result = self.spline({"points": points.tolist(), "tangents": tangents, "closed": closed})
            bezier = self.as_segments(result)
            self.assertEqual(len(result["k"]), n)
            self.assertEqual(len(bezier), n if closed else n - 1)
            for i, b in enumerate(bezier):
                follower = (i + 1) % n
                self.assertTrue((b[0] == points[i]).all() and (b[3] == points[follower]).all())
                if tangents[i]:
                    self.assertLess(angle(b[1] - b[0], numpy.array(tangents[i])), 1e-9)
                if tangents[follower]:
                    self.assertLess(angle(b[3] - b[2], numpy.array(tangents[follower])), 1e-9)
                if closed or follower:
                    after = bezier[(i + 1) % len(bezier)] if closed or i + 1 < len(bezier) else None
                    if after is not None:
                        self.assertLess(angle(b[3] - b[2], after[1] - after[0]), 1e-9)

    def test_no_hooks(self):
        """A sine at seven points with its own directions: no segment turns a radian more than the sine there."""
        u = 0.3 + math.pi / 3 * numpy.arange(7)
        given = numpy.column_stack([numpy.full(7, 2 / 3), numpy.cos(u)])
        points = numpy.column_stack([20 + 100 * (u - 0.3), 100 * numpy.sin(u)])
        bezier = self.as_segments(self.spline({"points": points.tolist(), "tangents": given.tolist()}))
        for i, b in enumerate(bezier):
            t = numpy.linspace(0, 1, 200)
            built = numpy.array([cubic(b, s) for s in t])
            x = numpy.interp(t, [0, 1], [u[i], u[i + 1]])
            sine = numpy.column_stack([x, numpy.sin(x)])
            def turn(p):
                ways = numpy.unwrap(numpy.arctan2(*numpy.diff(p, axis=0).T[::-1]))
                return numpy.abs(numpy.diff(ways)).sum()
            self.assertLess(turn(built), turn(sine) + 1)

    def test_directions_found_together(self):
        """At points without a direction scipy's B-spline turns as much before as after; a given one stops every influence."""
        rng = random.Random(42)
        angles = numpy.linspace(0, 2 * math.pi, 9, endpoint=False)
        points = [[rng.uniform(80, 100) * math.cos(a), rng.uniform(80, 100) * math.sin(a)] for a in angles]

        def bend(p, q, r):
            a, b = q - p, r - q
            return 2 / 3 * (a[0] * b[1] - a[1] * b[0]) / numpy.linalg.norm(a) ** 3
        bezier = self.as_segments(self.spline({"points": points, "closed": True}))
        for b, after in zip(bezier, numpy.roll(bezier, -1, axis=0)):
            self.assertAlmostEqual(-bend(*b[:0:-1]) / bend(*after[:3]), 1, delta=1e-9)
        given = [None if i % 4 else [-math.sin(a), math.cos(a)] for i, a in enumerate(angles)]
        first = self.spline({"points": points, "tangents": given})["bezier"]
        turned = given[:-1] + [[-1, 3]]
        self.assertEqual(first[:4], self.spline({"points": points, "tangents": turned})["bezier"][:4])

    def test_k_and_where_there_is_none(self):
        points = numpy.array([[0, 0], [100, 0], [150, 80], [300, 60]], float)
        given = [[1, 0], [1, 0.5], [0, -1], None]
        result = self.spline({"points": points.tolist(), "tangents": given}, "--mode", "faithful")
        self.assertIsNone(result["k"][0])
        self.assertIsNone(result["k"][3])
        self.assertIsNone(result["k"][2])  # outside the wedge
        expected = k_of(points[1] - points[0], points[2] - points[1], numpy.array(given[1]))
        self.assertAlmostEqual(result["k"][1], expected, delta=1e-12)

    def test_modes_and_defaults(self):
        corner = {"points": [[0, 0], [4, 0], [4, 9]], "mode": "faithful"}
        for rule, k in (("centripetal", 0.4), ("uniform", 0.5), ("chordal", 4 / 13)):
            self.assertAlmostEqual(self.spline(corner, "--default", rule)["k"][1], k, delta=1e-12)
        self.assertEqual(self.spline(corner), self.spline(corner, "--mode", "faithful", "--default", "centripetal"))
        self.assertEqual(self.spline(corner), self.spline({"points": corner["points"]}, "--default", "centripetal"))
        plain = {"points": corner["points"]}
        self.assertEqual(self.spline(plain), self.spline(corner, "--mode", "round"))
        self.assertNotEqual(self.spline(plain), self.spline(corner))
        outside = dict(corner, tangents=[None, [0.5, -1], None])
        self.assertIsNone(self.spline(outside)["k"][1])
        self.assertAlmostEqual(self.spline(outside, "--mode", "paper")["k"][1], 0.02, delta=1e-12)

    def test_tension_stretches_the_handles(self):
        plain = {"points": [[0, 0], [4, 1], [9, 0]]}
        one = numpy.array(self.spline(plain)["bezier"])
        two = numpy.array(self.spline(dict(plain, tension=[None, [0.5, 2], 1]))["bezier"])
        self.assertLess(numpy.abs((two[0][3] - two[0][2]) - 0.5 * (one[0][3] - one[0][2])).max(), 1e-14)
        self.assertLess(numpy.abs((two[1][1] - two[1][0]) - 2 * (one[1][1] - one[1][0])).max(), 1e-14)
        self.as_segments(self.spline(dict(plain, tension=[1, 0, 1])))  # a corner

    def test_its_output_is_a_curve(self):
        text = self.done("tangents", "-", stdin=json.dumps({"points": [[0, 0], [4, 1], [9, 0]], "closed": True}))
        self.assertEqual(len(self.json("eval", "-", "--samples", "5", stdin=text)["points"]), 5)

    def test_a_session_of_the_tool_replayed(self):
        """A journal by hand: three taps, the last with a dragged direction, then a point put on the curve."""
        lines = [{"journal": "batten", "version": 1, "name": "by hand"}, {"resize": [800, 600, 1]},
                 {"command": "tool-tangents"}]
        time = 0
        for x, y, dx, dy in ((100, 300, 0, 0), (300, 200, 0, 0), (500, 300, 30, 40)):
            time += 1000
            pen = {"device": "pen", "id": 1}
            lines.append({"pointer": "down", **pen, "buttons": 1, "x": x, "y": y, "time": time})
            lines.append({"pointer": "move", **pen, "buttons": 1, "x": x + dx, "y": y + dy, "time": time + 20})
            lines.append({"pointer": "up", **pen, "x": x + dx, "y": y + dy, "time": time + 40})
        lines += [{"command": "accept"}, {"command": "point-add"}]
        journal = self.file("s.journal", "".join(json.dumps(line) + "\n" for line in lines))
        self.json("replay", journal, "--check", "--output", self.folder / "out.batten")
        objects = json.loads((self.folder / "out.batten").read_text())["objects"]
        self.assertEqual([item["kind"] for item in objects], ["spline"])
        spline = objects[0]["spline"]
        self.assertEqual(len(spline["points"]), 4)
        self.assertLess(angle(numpy.array(spline["tangents"][-1]), numpy.array([3.0, 4.0])), 1e-9)
        self.assertEqual(objects[0], json.loads(self.done(
            "convert", self.folder / "out.batten", "-", "--to", "batten"))["objects"][0])
        # As SVG and back it is still a spline; the program draws what it gives.
        self.done("convert", self.folder / "out.batten", self.folder / "out.svg")
        back = json.loads(self.done("convert", self.folder / "out.svg", "-", "--to", "batten"))
        self.assertEqual(back["objects"], objects)
        drawn = numpy.array(self.spline(spline)["bezier"])
        self.done("convert", self.folder / "out.batten", self.folder / "out.svg", "--precision", "0")
        path = next(line for line in (self.folder / "out.svg").read_text().split("<") if line.startswith("path"))
        numbers = [float(n) for n in re.findall(r"-?[0-9.]+(?:e-?[0-9]+)?", path.split(' d="')[1].split('"')[0])]
        self.assertLess(numpy.abs(numpy.array(numbers[-6:]) - drawn[-1][1:].ravel()).max(), 1e-9)

    def test_refusals(self):
        cases = {
            '{"points":[[0,0]]}': "points",
            '{"points":[[1,1],[1,1]]}': "points",
            '{"tangents":[]}': "points",
            '{"points":[[0,0],[1,1,1]]}': "points",
            '{"points":[[0,0],[1,1]],"tangents":[null]}': "tangents",
            '{"points":[[0,0],[1,1]],"tangents":[null,[1]]}': "tangents",
            '{"points":[[0,0],[1,1]],"tension":[1,-1]}': "tension",
            '{"points":[[0,0],[1,1]],"closed":1}': "closed",
            '{"points":[[0,0],[1,1e80]]}': "",
            "[]": "spline",
            "{": "",
        }
        for text, word in cases.items():
            self.assertIn(word, self.refused(1, "tangents", self.file("bad.json", text)), text)
        good = self.file("good.json", {"points": [[0, 0], [1, 1]]})
        self.refused(2, "tangents", good, "--mode", "wild")
        self.refused(2, "tangents", good, "--default", "none")
        self.refused(1, "tangents", self.folder / "missing.json")


if __name__ == "__main__":
    unittest.main()
