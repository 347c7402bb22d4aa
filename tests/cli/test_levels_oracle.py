"""Shapes of several levels, in the plane and in space, open and closed: whole curves and edits of them, to the bar of
1e-10 of the size, against everything written here anew with numpy: de Boor bases by scipy, chains of double
reflections a span at a time, nodes by root finding, loops closed by arc length, twist bookkeeping over the whole curve.
label: all (all of levels computed once more in Python)"""
import math
import unittest

import numpy
from scipy.interpolate import BSpline
from scipy.optimize import brentq

from program import ProgramTest

SEED = 20160501


def unit(v):
    return v / numpy.linalg.norm(v, axis=-1, keepdims=True)


class Curve:
    """Degree, knots of one period or all, points of three coordinates."""

    def __init__(self, degree, closed, knots, points):
        self.degree, self.closed, self.knots = degree, closed, numpy.array(knots, float)
        self.points = numpy.array(points, float)
        n, p = len(self.points), degree
        if closed:
            period = self.knots[-1] - self.knots[0]
            self.low, self.high = self.knots[0], self.knots[-1]
            turns = numpy.concatenate([self.knots[:-1] + k * period for k in range(-2, 4)])
            # N_i lives on knots i..i+p+1 of the period that begins at index 2 n.
            self.spline = BSpline(turns, numpy.tile(self.points, (6, 1))[:len(turns) - p - 1], p)
        else:
            self.low, self.high = self.knots[p], self.knots[n]
            self.spline = BSpline(self.knots, self.points, p)

    def at(self, u, k=0):
        return self.spline(self.wrap(u), k)

    def wrap(self, u):
        return self.low + (u - self.low) % (self.high - self.low) if self.closed and not u == self.high else u

    def spans(self):
        inner = self.knots if self.closed else self.knots[self.degree:len(self.points) + 1]
        return [(a, b) for a, b in zip(inner, inner[1:]) if a < b]

    def support(self, i):
        """Of N_i, on the unrolled line."""
        if not self.closed:
            return self.knots[i], self.knots[i + self.degree + 1]
        n, period = len(self.points), self.high - self.low
        return tuple(self.knots[k % n] + k // n * period for k in (i, i + self.degree + 1))

    def with_points(self, points):
        return Curve(self.degree, self.closed, self.knots, points)

    def weights(self, u):
        """N_i(u) of all distinct control points: a row for each u."""
        return self.with_points(numpy.eye(len(self.points))).spline(u)

    def refinement(self, fine):
        """Takes control points to those on more knots: interpolation at as many places as there are points is exact."""
        places = greville(fine)
        return numpy.linalg.solve(fine.weights(places), self.weights(places))


def greville(curve):
    n, p = len(curve.points), curve.degree
    period = curve.high - curve.low
    knot = (lambda k: curve.knots[k % n] + k // n * period) if curve.closed else (lambda k: curve.knots[k])
    nodes = [sum(knot(i + j) for j in range(1, p + 1)) / p for i in range(n)]
    return [curve.wrap(min(max(u, curve.low), curve.high) if not curve.closed else u) for u in nodes]


def argmax(curve):
    """Where each N_i is greatest in the domain: the root of N_i', else an end of the domain."""
    n, p, nodes = len(curve.points), curve.degree, []
    for i in range(n):
        a, b = curve.support(i)
        period = curve.high - curve.low
        if curve.closed:
            knots = [curve.knots[k % n] + k // n * period for k in range(i, i + p + 2)]
        else:
            knots = list(curve.knots[i:i + p + 2])
            a, b = max(a, curve.low), min(b, curve.high)
        bump = BSpline.basis_element(knots)
        slope = lambda u: bump(u, 1)
        tiny = 1e-9 * (b - a)
        if knots[0] == knots[p] or slope(a + tiny) <= 0:
            u = a
        elif knots[1] == knots[p + 1] or slope(b - tiny) >= 0:
            u = b
        else:
            u = brentq(slope, a + tiny, b - tiny, xtol=1e-15, rtol=1e-15)
        nodes.append(curve.wrap(u))
    return nodes


def least(s, t0, t1):
    return s - (s @ t1) / (1 + t0 @ t1) * (t0 + t1)


def reflected(x0, t0, s, x1, t1):
    v = x1 - x0
    if v @ v == 0:
        return least(s, t0, t1)
    left, tangent = s - 2 / (v @ v) * (v @ s) * v, t0 - 2 / (v @ v) * (v @ t0) * v
    w = t1 - tangent
    s = left - 2 / (w @ w) * (w @ left) * w if w @ w > 1e-20 else left
    return unit(s - (s @ t1) * t1)


class Chain:
    """Double reflections through consecutive spans: eight steps each, doubled until none turns by over 30 degrees."""

    def __init__(self, curve, spans, s):
        self.curve, self.samples = curve, []
        for a, b in spans:
            steps = 8
            while True:
                u = [a + (b - a) * i / steps for i in range(steps)] + [b]
                t = unit(self.inside(a, b, u, 1))
                if (numpy.sum(t[1:] * t[:-1], axis=1) >= math.cos(math.pi / 6)).all():
                    break
                steps *= 2
            x = self.inside(a, b, u, 0)
            for i, v in enumerate(u):
                if self.samples and i == 0:
                    s = unit(least(s, self.samples[-1][2], t[0]))
                elif i > 0:
                    s = reflected(x[i - 1], t[i - 1], s, x[i], t[i])
                self.samples.append((v, x[i], t[i], s, (a, b)))

    def inside(self, a, b, u, k):
        """The span's own polynomial, also at its right end."""
        c = self.curve
        turns = 0.0
        if c.closed and not c.low <= a < c.high:
            turns = (a - c.low) // (c.high - c.low) * (c.high - c.low)
        middle = (a + b) / 2 - turns
        piece = [c.spline(middle, j) / math.factorial(j) for j in range(c.degree + 1)]
        h = numpy.array(u)[:, None] - turns - middle
        out = 0
        for j in range(c.degree, k - 1, -1):
            out = out * h + piece[j] * math.factorial(j) / math.factorial(j - k)
        return out

    def at(self, u):
        for v, x, t, s, (a, b) in reversed(self.samples):
            if v <= u and (u < b or v == b):
                if u == v:
                    return t, s
                y, d = self.inside(a, b, [u], 0)[0], unit(self.inside(a, b, [u], 1)[0])
                return d, reflected(x, t, s, y, d)
        raise ValueError(u)


def angle(s, other, t):
    """Of other from s, signed about t."""
    return math.atan2(numpy.cross(s, other) @ t, s @ other)


GAUSS = numpy.polynomial.legendre.leggauss(24)


def length(curve, a, b):
    """Arc length, panel by panel."""
    knots = [a, *[k for k in curve.knots if a < k < b], b]
    total = 0
    for c, d in zip(knots, knots[1:]):
        for i in range(8):
            e, f = c + (d - c) * i / 8, c + (d - c) * (i + 1) / 8
            speeds = numpy.linalg.norm(curve.spline((e + f) / 2 + (f - e) / 2 * GAUSS[0], 1), axis=1)
            total += (f - e) / 2 * (GAUSS[1] @ speeds)
    return total


def frames_of(curve, nodes, rule, first, planar):
    """Frames (rows t, s, r) that the whole curve gives at the nodes."""
    if rule == "fixed":
        return [numpy.eye(3)] * len(nodes)
    out = []
    if planar and rule == "rmf":
        for u in nodes:
            t = unit(curve.at(u, 1))
            out.append(numpy.array([t, [-t[1], t[0], 0], [0, 0, 1]]))
        return out
    if rule == "frenet":
        for u in nodes:
            t = unit(curve.at(u, 1))
            r = unit(numpy.cross(curve.at(u, 1), curve.at(u, 2)))
            out.append(numpy.array([t, numpy.cross(r, t), r]))
        return out
    t0 = unit(curve.at(curve.low, 1))
    if "t" in first:
        s = unit(least(numpy.array(first["s"], float), unit(numpy.array(first["t"], float)), t0))
        s = unit(s - (s @ t0) * t0)
    else:
        s = numpy.array(first["s"], float)
        s = unit(s - (s @ t0) * t0)
    chain = Chain(curve, curve.spans(), s)
    phi, whole = 0, 1
    if curve.closed:
        phi, whole = angle(s, least(chain.samples[-1][3], chain.samples[-1][2], t0), t0), length(curve, curve.low, curve.high)
    for u in nodes:
        t, s = chain.at(u)
        if phi:
            a = -phi * length(curve, curve.low, u) / whole
            s = math.cos(a) * s + math.sin(a) * numpy.cross(t, s)
        out.append(numpy.array([t, s, numpy.cross(t, s)]))
    return out


class Shape:
    """Synthesis, and edits with twist bookkeeping over whole curves, from the JSON."""

    def __init__(self, shape):
        base = shape["base"]
        self.planar = len(base["points"][0]) == 2
        points = [[*x, 0.0] if self.planar else x for x in base["points"]]
        self.curves = [Curve(base["degree"], base["closed"], base["knots"], points)]
        self.rule, self.first = shape["frame"], shape["first"]
        self.plain = shape["propagation"] == "plain"
        self.levels = []
        for level in shape["levels"]:
            n = len(level["knots"]) - 1 if base["closed"] else len(level["knots"]) - base["degree"] - 1
            refined = Curve(base["degree"], base["closed"], level["knots"], numpy.zeros((n, 3)))
            matrix = self.curves[-1].refinement(refined)
            nodes = greville(refined) if shape["nodes"] == "greville" else argmax(refined)
            self.levels.append({"matrix": matrix, "nodes": nodes, "gain": level.get("gain", 1),
                                "details": numpy.array([[*d, 0][:3] for d in level["details"]], float)})
            self.curves.append(refined)
        self.build(1)

    def build(self, start):
        """Levels from `start` on in the frames that the curves alone give."""
        for l in range(start, len(self.curves)):
            level, below = self.levels[l - 1], self.curves[l - 1]
            level["frames"] = frames_of(below, level["nodes"], self.rule, self.first, self.planar)
            self.put(l)

    def put(self, l):
        level = self.levels[l - 1]
        moved = [d @ f for d, f in zip(level["details"], level["frames"])]
        below = level["matrix"] @ self.curves[l - 1].points
        self.curves[l] = self.curves[l].with_points(below + level["gain"] * numpy.array(moved))

    def edit(self, j, deltas):
        """deltas: {index: world vector} at level j, neighbours in the order of the parameter."""
        old = list(self.curves)
        if j == 0:
            points = old[0].points.copy()
            for i, delta in deltas.items():
                points[i] += delta
            self.curves[0] = old[0].with_points(points)
        else:
            level = self.levels[j - 1]
            for i, delta in deltas.items():
                level["details"][i] = level["details"][i] + level["frames"][i] @ delta / level["gain"]
            self.put(j)
        run = list(deltas)
        for l in range(j + 1, len(self.curves)):
            level, before, after = self.levels[l - 1], old[l - 1], self.curves[l - 1]
            stretch = self.stretch(before, run)
            if self.rule == "rmf" and not self.planar and not self.plain and stretch:
                level["frames"], run = self.kept(level, before, after, stretch)
            else:
                level["frames"] = frames_of(after, level["nodes"], self.rule, self.first, self.planar)
                run = list(range(len(level["nodes"])))
            self.put(l)

    def commit(self):
        """Details in the frames that the curves alone give; nothing moves."""
        for l, level in enumerate(self.levels, 1):
            fresh = frames_of(self.curves[l - 1], level["nodes"], self.rule, self.first, self.planar)
            level["details"] = numpy.array([new @ (d @ old) for d, old, new in zip(level["details"], level["frames"], fresh)])
            level["frames"] = fresh

    @staticmethod
    def stretch(curve, run):
        """Parameters between which a curve changes with a run of its points; None: everywhere."""
        a, b = curve.support(run[0])[0], curve.support(run[-1])[1]
        if not curve.closed:
            a, b = max(a, curve.low), min(b, curve.high)
            return None if (a, b) == (curve.low, curve.high) else (a, b)
        period = curve.high - curve.low
        b = a + (b - a) % period if b > a + period or b <= a else b
        return None if len(run) + curve.degree >= len(curve.points) else (a, b)

    def kept(self, level, before, after, stretch):
        """The bookkeeping: frames keep their angle against the chain that is carried through the stretch; what that
        comes out turned by is taken back smoothly (from the start of a curve: throughout)."""
        a, b = stretch
        period = before.high - before.low
        spans = before.spans()
        if before.closed:
            spans = [(c + k * period, d + k * period) for k in (-1, 0, 1, 2) for c, d in spans]
        spans = [(c, d) for c, d in spans if c >= a and d <= b]
        from_start, to_end = not before.closed and a == before.low, not before.closed and b == before.high
        chains, t_in = [], unit(before.at(a, 1))
        for curve in (before, after):
            t = unit(curve.at(a, 1))
            s = unit(numpy.cross(t_in, [0.3, 0.5, 0.8]))
            chains.append(Chain(curve, spans, unit(s - (s @ t) * t)))
        turn = 0
        if not to_end:
            t, s0, s1 = chains[0].samples[-1][2], chains[0].samples[-1][3], chains[1].samples[-1][3]
            turn = angle(s0, s1, t)
        frames, run = list(level["frames"]), []
        for i, node in enumerate(level["nodes"]):
            u = node
            if before.closed:
                while u <= a:
                    u += period
                while u - period > a:
                    u -= period
            if not ((u > a or from_start) and (u < b or to_end)):
                continue
            t0, c0 = chains[0].at(u)
            t1, c1 = chains[1].at(u)
            x = (u - a) / (b - a)
            w = 1 if from_start else 0 if to_end else x * x * (3 - 2 * x)
            theta = angle(c0, frames[i][1], t0) - turn * w
            s = math.cos(theta) * c1 + math.sin(theta) * numpy.cross(t1, c1)
            frames[i] = numpy.array([t1, s, numpy.cross(t1, s)])
            run.append((u, i))
        return frames, [i for _, i in sorted(run)]


def random_shape(random, case):
    degree = 2 + case % 4
    closed, size = bool(case % 2), 2 if case % 5 == 4 else 3
    rule = "frenet" if case % 11 == 5 else "fixed" if case % 11 == 8 else "rmf"
    if rule == "frenet":
        degree = max(degree, 3)
    count = int(random.integers(14, 20))
    turn = 2 * math.pi * numpy.arange(count) / count
    points = numpy.c_[200 * numpy.cos(turn), 200 * numpy.sin(turn), 50 * numpy.sin(3 * turn)] if closed else \
        numpy.c_[60 * numpy.arange(count), 50 * numpy.sin(numpy.arange(count)), 40 * numpy.cos(0.7 * numpy.arange(count))]
    points = (points + random.uniform(-20, 20, points.shape))[:, :size]
    widths = random.uniform(0.5, 2, count if closed else count - degree)
    inner = numpy.concatenate([[0], numpy.cumsum(widths)])
    knots = list(inner) if closed else [inner[0]] * degree + list(inner) + [inner[-1]] * degree
    shape = {"base": {"degree": degree, "closed": closed, "knots": knots, "points": points.tolist()}, "levels": [],
             "frame": rule, "nodes": "argmax" if case % 3 == 1 else "greville",
             "propagation": "plain" if case % 7 == 6 else "local"}
    first = unit(random.uniform(-1, 1, 3))
    t = unit(random.uniform(-1, 1, 3))
    shape["first"] = {"s": first.tolist()} if case % 4 == 2 else \
        {"t": t.tolist(), "s": unit(numpy.cross(t, first)).tolist()}
    for level in range(3):
        more = [a + (b - a) * random.uniform(0.3, 0.7) for a, b in zip(knots, knots[1:]) if a < b and random.random() < 0.8]
        knots = sorted(knots + more)
        n = len(knots) - 1 if closed else len(knots) - degree - 1
        details = random.uniform(-6, 6, (n, 3)) / (level + 1)
        if size == 2:
            details = details[:, :2]
        shape["levels"].append({"knots": list(knots), "details": details.tolist()})
        if case % 6 == 3 and level == 1:
            shape["levels"][-1]["gain"] = 1.7
    return shape


class LevelsOracle(ProgramTest):
    def compare(self, oracle, curves, case):
        self.assertEqual(len(oracle.curves), len(curves))
        for l, (mine, other) in enumerate(zip(oracle.curves, curves)):
            points = numpy.array(other["points"])
            size = numpy.abs(mine.points).max()
            miss = numpy.abs(points - mine.points[:, :points.shape[1]]).max() / size
            self.assertLess(miss, 1e-10, f"case {case}, level {l}")

    def test_frames(self):
        """`frames` itself: kinds, first, substeps of its own choice, in any order; the angle of a loop."""
        random = numpy.random.default_rng(SEED + 1)
        for case in range(16):
            shape = random_shape(random, case)
            curve = Shape(dict(shape, levels=[], frame="fixed")).curves[0]
            u = random.uniform(curve.low, curve.high, 7).tolist()
            first = random.uniform(-1, 1, 3)
            f = self.json("frames", self.file("c.json", shape["base"]), "--at", ",".join(map(repr, u)), "--kind",
                          shape["frame"], "--first", ",".join(map(repr, first.tolist())))
            planar = len(shape["base"]["points"][0]) == 2
            expected = frames_of(curve, u, shape["frame"], {"s": unit(first)}, planar)
            for name, column in zip("tsr", numpy.transpose(expected, (1, 0, 2))):
                self.assertLess(numpy.abs(numpy.array(f[name]) - column).max(), 1e-10, f"case {case}")
            self.assertEqual("holonomy" in f, curve.closed)
            if curve.closed and not planar and shape["frame"] == "rmf":
                t0 = unit(curve.at(curve.low, 1))
                s = unit(first - (first @ t0) * t0)
                end = Chain(curve, curve.spans(), s).samples[-1]
                self.assertLess(abs(f["holonomy"] - angle(s, least(end[3], end[2], t0), t0)), 1e-10)

    def test_edits_in_order(self):
        """Moves, drags, gains and rigid motions, one after the other, each committed."""
        random = numpy.random.default_rng(SEED + 2)
        for case in (0, 3, 5, 9, 14, 21):
            shape, edits = random_shape(random, case), []
            oracle, size = Shape(shape), len(shape["base"]["points"][0])
            for k in range(6):
                j = int(random.integers(0, 4))
                curve = oracle.curves[j]
                full = numpy.array([*random.uniform(-10, 10, size) / (j + 1), 0][:3])
                if k == 2:
                    gain = float(random.uniform(0.5, 2))
                    edits.append({"type": "gain", "level": max(j, 1), "value": gain})
                    oracle.levels[max(j, 1) - 1]["gain"] = gain
                    oracle.build(max(j, 1))
                elif k == 4:
                    a = random.uniform(0, 6)
                    turn = numpy.array([[math.cos(a), -math.sin(a), 0], [math.sin(a), math.cos(a), 0], [0, 0, 1]])
                    if size == 3:
                        turn = turn @ numpy.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
                    edits.append({"type": "transform", "matrix": numpy.c_[turn, [3, -4, 5]].tolist()})
                    oracle.curves[0] = oracle.curves[0].with_points(oracle.curves[0].points @ turn.T + [3, -4, 5 * (size == 3)])
                    oracle.first = {key: (turn @ v).tolist() for key, v in oracle.first.items()}
                    oracle.build(1)
                else:
                    i = int(random.integers(len(curve.points)))
                    edits.append({"type": "move", "level": j, "index": i, "delta": full[:size].tolist()})
                    oracle.edit(j, {i: full})
                    oracle.commit()
            after = self.json("levels", self.file("s.json", shape), self.file("e.json", edits))
            self.compare(oracle, after["curves"], case)
            for level, mine in zip(after["shape"]["levels"], oracle.levels):
                miss = numpy.abs(numpy.array([[*d, 0][:3] for d in level["details"]]) - mine["details"]).max()
                self.assertLess(miss, 1e-10 * numpy.abs(oracle.curves[0].points).max(), f"case {case}")

    def test_only_a_base(self):
        shape = random_shape(numpy.random.default_rng(SEED + 3), 0)
        result = self.json("levels", self.file("s.json", {"base": shape["base"]}))
        self.assertEqual(result["curves"], [shape["base"]])
        self.assertEqual([result["shape"][key] for key in ("levels", "frame", "nodes", "propagation")],
                         [[], "rmf", "greville", "local"])

    def test_shapes_and_edits(self):
        random = numpy.random.default_rng(SEED)
        for case in range(14):
            shape = random_shape(random, case)
            path = self.file("s.json", shape)
            self.compare(Shape(shape), self.json("levels", path)["curves"], case)
            size = len(shape["base"]["points"][0])
            for j in (0, 1, 2):
                oracle = Shape(shape)
                curve = oracle.curves[j]
                delta = random.uniform(-15, 15, size) / (j + 1)
                full = numpy.array([*delta, 0][:3])
                i = [0, len(curve.points) - 1, int(random.integers(len(curve.points)))][(case + j) % 3]
                u = float(random.uniform(curve.low, curve.high))
                if (case + j) % 2:
                    edit = {"type": "move", "level": j, "index": i, "delta": delta.tolist()}
                    deltas = {i: full}
                else:
                    edit = {"type": "drag", "level": j, "u": u, "delta": delta.tolist()}
                    w = curve.weights(u)
                    run = [k for k in range(len(w)) if w[k] > 0]
                    if curve.closed and run[0] == 0 and run[-1] == len(w) - 1:  # around the seam
                        gap = next(k for k in range(len(run)) if run[k + 1] > run[k] + 1)
                        run = run[gap + 1:] + run[:gap + 1]
                    deltas = {k: w[k] / (w @ w) * full for k in run}
                oracle.edit(j, deltas)
                after = self.json("levels", path, self.file("e.json", [edit]))
                self.compare(oracle, after["curves"], (case, edit))
                # What the file says then gives the same curves, by the frames of the curves alone.
                if (case + j) % 4 == 0:
                    self.compare(Shape(after["shape"]), after["curves"], (case, "read back"))


if __name__ == "__main__":
    unittest.main()
