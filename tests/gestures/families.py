#!/usr/bin/env python3
"""Writes gestures.json: strokes over the drawings of draw.py, each labelled with the designer's intention. The label
comes from the family and the geometry of the drawing, never from what the program does. Seeded and reproducible.

Usage: families.py FOLDER > FOLDER/gestures.json
"""
import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import draw
from stroke import Along, Random

VIEW = [1280, 752]


class Curve:
    """A curve of a drawing: points by arc length, directions, distances to other curves."""

    def __init__(self, name, closed, points):
        self.name, self.closed = name, closed
        places = []
        for b in draw.beziers(points, closed):
            for i in range(24):
                t = i / 24
                places.append([sum(w * q[k] for w, q in zip(((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3), b)) for k in (0, 1)])
        places.append(list(points[0] if closed else points[-1]))
        self.line = Along(places)
        self.length = self.line.length

    def at(self, s):
        return self.line.at(s % self.length if self.closed else s)

    def way(self, s):
        a, b = self.at(s - 1), self.at(s + 1)
        if not self.closed:
            a, b = self.at(max(0, s - 1)), self.at(min(self.length, s + 1))
        d = math.dist(a, b)
        return [(b[k] - a[k]) / d for k in (0, 1)]

    def beside(self, s, off):
        p, w = self.at(s), self.way(s)
        return [p[0] - off * w[1], p[1] + off * w[0]]

    def distance(self, p):
        return min(math.dist(p, q) for q in self.line.places)

    def end(self, last):
        """The end point and the outward direction."""
        s = self.length if last else 0
        w = self.way(s)
        return self.at(s), (w if last else [-w[0], -w[1]])

    def turn(self, a, b):
        """The total bending in between, radians."""
        n = 12
        angles = [math.atan2(*reversed(self.way(a + (b - a) * i / n))) for i in range(n + 1)]
        return sum(abs(math.remainder(q - p, 2 * math.pi)) for p, q in zip(angles, angles[1:]))


DRAWINGS = {name: {n: Curve(n, *c) for n, c in curves.items()} for name, curves in [*draw.DRAWINGS.items(), *draw.OTHERS.items()]}


def others(drawing, curve):
    return [c for c in DRAWINGS[drawing].values() if c is not curve]


def nearest_other(drawing, curve, places):
    return min((c.distance(p) for p in places for c in others(drawing, curve)), default=math.inf)


def nearest_any(drawing, places):
    return min(c.distance(p) for p in places for c in DRAWINGS[drawing].values())


def touching(drawing, limit=1.0):
    """Pairs of ends of open curves that touch: (curve, its end, curve, its end)."""
    found = []
    open_ones = [c for c in DRAWINGS[drawing].values() if not c.closed]
    for i, a in enumerate(open_ones):
        for b in open_ones[i + 1:]:
            for ea in (0, 1):
                for eb in (0, 1):
                    if math.dist(a.end(ea)[0], b.end(eb)[0]) <= limit:
                        found.append((a, ea, b, eb))
    return found


def inside(p):
    return 20 < p[0] < 980 and 20 < p[1] < 680


def rounded(path):
    return [[round(x, 2) for x in p] for p in path]


class Maker:
    def __init__(self, seed, names=sorted(draw.DRAWINGS), letter="g"):
        self.r, self.out, self.count, self.names, self.letter = Random(seed), [], 0, names, letter
        self.other = None

    def hand(self, small=False):
        r = self.r
        if self.other:
            return self.other.hand(r)
        if small:
            return {"speed": round(r.between(90, 220)), "tremor": round(r.between(0.05, 0.2), 2), "drift": round(r.between(0.05, 0.25), 2),
                    "noise": round(r.between(0.02, 0.12), 2), "hook": round(r.between(0, 1.2), 1)}
        return {"speed": round(r.between(200, 800)), "tremor": round(r.between(0.1, 0.6), 2), "drift": round(r.between(0.2, 0.9), 2),
                "noise": round(r.between(0, 0.25), 2), "hook": round(r.between(0, 4.5), 1)}

    def add(self, category, drawing, zoom, centre, strokes, expect, small=False, prepare=None, kind=None):
        self.count += 1
        g = {"id": self.letter + "%03d" % self.count, "category": category, "drawing": drawing + ".svg",
             "view": {"size": VIEW, "zoom": zoom, "centre": [round(x, 1) for x in centre]}}
        if self.other:
            g["category"] = self.other.name
            g["view"].update(self.other.view)
            if self.other.turned and not kind and not expect[0].get("new"):  # what begins on a curve still does
                strokes = [path[::-1] for path in strokes]
        if prepare:
            g["prepare"] = prepare
        made = []
        for path in strokes:
            s = {"path": rounded(path), "seed": 71000 + 10 * self.count + len(made), "hand": self.hand(small)}
            if kind:
                s["kind"] = kind
            made.append(s)
        if len(made) == 1:
            g["stroke"] = made[0]
        else:
            g["strokes"] = made
        g["expect"] = expect
        self.out.append(g)

    def pick(self, drawing, accept=lambda c: True):
        return self.r.pick([c for c in DRAWINGS[drawing].values() if accept(c)])

    def any_drawing(self):
        return self.r.pick(self.names)

    def zoom(self, low=0.6, high=2.0):
        if self.other:
            low, high = self.other.zooms
        return round(math.exp(self.r.between(math.log(low), math.log(high))), 3)

    def until(self, wanted, attempt, most=4000):
        got = 0
        for _ in range(most):
            if got == wanted:
                return
            got += bool(attempt())
        raise SystemExit(f"{self.out[-1]['category'] if self.out else '?'}: {got} of {wanted} found")


def middle(path):
    return [sum(p[k] for p in path) / len(path) for k in (0, 1)]


def bump(curve, a, b, height, count=14, lean=0.0):
    """A path along the curve that leaves it in a smooth bump."""
    return [curve.beside(a + (b - a) * i / (count - 1), height * math.sin(math.pi * i / (count - 1)) ** 2 + lean * (i / (count - 1) - 0.5))
            for i in range(count)]


def stretch(m, curve, low, high):
    """A stretch of the curve, low to high units long, and its length; None if the curve is too short."""
    most = curve.length * (0.8 if not curve.closed else 0.6)
    if most < low:
        return None
    length = m.r.between(low, min(high, most))
    a = m.r.between(0, curve.length - length) if not curve.closed else m.r.between(0, curve.length)
    if not curve.closed:
        a = min(max(a, 0.06 * curve.length), curve.length - length - 0.06 * curve.length)
        if a < 0:
            return None
    return a, a + length


def bare_ends(drawing, curve, a, b, limit):
    """Whether no end of the curve that touches another curve is near the stretch."""
    return curve.closed or (a > limit and b < curve.length - limit)


def overdraw(m, category, low, high, share, zooms=(0.6, 2.0), against=False, small=False):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom(*zooms)
        curve = m.pick(drawing)
        got = stretch(m, curve, low / zoom, high / zoom)
        if not got:
            return False
        a, b = got
        length = (b - a) * zoom
        height = m.r.between(0.3, 1) * min(share * length, 24) * m.r.pick([-1, 1]) / zoom
        path = bump(curve, a, b, height)
        if not bare_ends(drawing, curve, a, b, 40 / zoom) or curve.turn(a, b) > 4 or not all(map(inside, path)):
            return False
        if nearest_other(drawing, curve, path) * zoom < max(14, 2.5 * abs(height) * zoom):
            return False
        m.add(category, drawing, zoom, middle(path), [path[::-1] if against else path], [{"redraws": [curve.name]}], small)
        return True
    return attempt


def begun_away(m, both):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing)
        got = stretch(m, curve, 170 / zoom, 380 / zoom)
        if not got:
            return False
        a, b = got
        off = [m.r.between(14, 26) * m.r.pick([-1, 1]) / zoom for _ in (0, 1)]
        near = m.r.between(0, 4) / zoom
        path = []
        for i in range(14):
            t = i / 13
            o = near + (off[0] - near) * max(0, 1 - t / 0.3) ** 2
            if both:
                o += (off[1] - near) * max(0, 1 - (1 - t) / 0.3) ** 2
            path.append(curve.beside(a + (b - a) * t, o))
        if not bare_ends(drawing, curve, a, b, 60 / zoom) or curve.turn(a, b) > 2.5 or nearest_other(drawing, curve, path) * zoom < 50:
            return False
        m.add("both ends away" if both else "begun away", drawing, zoom, middle(path), [path], [{"redraws": [curve.name]}])
        return True
    return attempt


def beside(m, low, high, either):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing)
        got = stretch(m, curve, 190 / zoom, 420 / zoom)
        if not got:
            return False
        a, b = got
        off = m.r.between(low, high) * m.r.pick([-1, 1]) / zoom
        path = [curve.beside(a + (b - a) * i / 11, off) for i in range(12)]
        if (not curve.closed and (b - a) > 0.72 * curve.length) or curve.turn(a, b) > 1.6 or not all(map(inside, path)):
            return False
        if not bare_ends(drawing, curve, a, b, 50 / zoom) or nearest_other(drawing, curve, path) * zoom < 95:
            return False
        m.add("beside a curve, far" if either else "beside a curve", drawing, zoom, middle(path), [path],
              [{"redraws": [curve.name]}] + ([{"new": True}] if either else []))
        return True
    return attempt


def crossing(m, low, high, category):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing)
        s = m.r.between(0.15, 0.85) * curve.length
        p, w = curve.at(s), curve.way(s)
        angle = math.radians(m.r.between(50, 130))
        u = [w[0] * math.cos(angle) - w[1] * math.sin(angle), w[0] * math.sin(angle) + w[1] * math.cos(angle)]
        length, share = m.r.between(low, high) / zoom, m.r.between(0.3, 0.7)
        bow = m.r.between(-0.06, 0.06) * length
        path = [[p[k] + u[k] * length * (t - share) + (-u[1], u[0])[k] * bow * math.sin(math.pi * t) for k in (0, 1)] for t in (0, 0.25, 0.5, 0.75, 1)]
        ends = [c.end(e)[0] for c in DRAWINGS[drawing].values() if not c.closed for e in (0, 1)]
        if not all(map(inside, path)) or min(math.dist(q, e) for q in (path[0], path[-1]) for e in ends) * zoom < 22:
            return False
        fine = [[path[0][k] + (path[-1][k] - path[0][k]) * i / 40 for k in (0, 1)] for i in range(41)]
        for c in DRAWINGS[drawing].values():  # it may cross other curves, but not run along them
            near = [i for i, q in enumerate(fine) if c.distance(q) * zoom < 14]
            if len(near) * length * zoom / 40 > max(40, 0.3 * length * zoom) and c is not curve:
                return False
        m.add(category, drawing, zoom, middle(path), [path], [{"new": True}], small=high < 60)
        return True
    return attempt


def branch(m, near):
    """A path that starts on a curve, or beside it, and leads steeply away."""
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing)
        s = m.r.between(0.12, 0.88) * curve.length
        side = m.r.pick([-1, 1])
        start = curve.beside(s, side * (m.r.between(5, 11) / zoom if near else 0))
        w = curve.way(s)
        angle = math.radians(m.r.between(55, 125)) * side
        u = [w[0] * math.cos(angle) - w[1] * math.sin(angle), w[0] * math.sin(angle) + w[1] * math.cos(angle)]
        length = m.r.between(60, 220) / zoom
        bow = m.r.between(-0.12, 0.12) * length
        path = [[start[k] + u[k] * length * t + (-u[1], u[0])[k] * bow * math.sin(math.pi * t) for k in (0, 1)] for t in (0, 0.2, 0.4, 0.6, 0.8, 1)]
        if not all(map(inside, path)) or nearest_other(drawing, curve, path) * zoom < 22 or curve.distance(path[-1]) * zoom < 40:
            return False
        if not curve.closed and min(s, curve.length - s) * zoom < 25:
            return False
        expect = {"new": True}
        if not near:
            expect["touch"] = [["start", curve.name, 3.5]]
        m.add("begun near a curve" if near else "T-junction", drawing, zoom, middle(path), [path], [expect])
        return True
    return attempt


def in_the_open(m):
    drawing, zoom = m.any_drawing(), m.zoom()
    p = [m.r.between(60, 940), m.r.between(60, 640)]
    angle, path = m.r.between(0, 6.28), [p]
    for _ in range(m.r.pick([4, 5, 6])):
        angle += m.r.between(-0.5, 0.5)
        p = [p[0] + 40 / zoom * math.cos(angle), p[1] + 40 / zoom * math.sin(angle)]
        path.append(p)
    if not all(map(inside, path)) or nearest_any(drawing, path) * zoom < 70:
        return False
    m.add("new line in the open", drawing, zoom, middle(path), [path], [{"new": True}])
    return True


def small_circle(m):
    drawing, zoom = m.any_drawing(), m.zoom(0.8, 2.5)
    curve = m.pick(drawing)
    r = m.r.between(9, 22) / zoom
    s = m.r.between(0.1, 0.9) * curve.length
    c = curve.beside(s, m.r.pick([-1, 1]) * (r + m.r.between(3, 12) / zoom))
    start, way, squash = m.r.between(0, 6.28), m.r.pick([-1, 1]), m.r.between(0.75, 1)
    path = [[c[0] + r * math.cos(start + way * 2 * math.pi * i / 12), c[1] + squash * r * math.sin(start + way * 2 * math.pi * i / 12)] for i in range(13)]
    if not all(map(inside, path)) or nearest_other(drawing, curve, path) * zoom < 8 or (curve.closed and curve.length * zoom < 300):
        return False
    m.add("small circle beside a line", drawing, zoom, c, [path], [{"new": True, "closed": True}], small=True)
    return True


LETTERS = [  # x to the right, y up, in x-heights; strokes of plain handwriting
    [(0, 0.9), (0.1, 0.2), (0.35, 0), (0.6, 0.3), (0.65, 0.95), (0.68, 0.3), (0.85, 0)],           # u
    [(0, 0), (0.15, 0.9), (0.2, 0.1), (0.45, 0.95), (0.6, 0.8), (0.62, 0), (0.8, 0.1)],            # n
    [(0, 0.1), (0.3, 1.9), (0.4, 1.7), (0.25, 0.3), (0.4, 0), (0.6, 0.2)],                         # l
    [(0, 0.45), (0.5, 0.5), (0.45, 0.9), (0.2, 0.95), (0.05, 0.5), (0.2, 0.05), (0.6, 0.15)],      # e
    [(0.5, 0.8), (0.25, 0.95), (0.2, 0.7), (0.45, 0.4), (0.4, 0.05), (0.1, 0.05)],                 # s
    [(0, 0.95), (0.25, 0), (0.5, 0.95), (0.7, 0.05), (0.95, 0.95)],                                # w
]


def word(m):
    drawing, zoom = "letters", m.zoom(0.8, 1.6)
    rule = DRAWINGS[drawing][m.r.pick(["rule-1", "rule-2", "rule-3"])]
    x_height = m.r.between(11, 20) / zoom
    x, y = m.r.between(90, 760), rule.at(0)[1] - m.r.between(1, 5) / zoom
    strokes = []
    for _ in range(m.r.pick([2, 3, 4])):
        letter = m.r.pick(LETTERS)
        strokes.append([[x + p[0] * x_height, y - p[1] * x_height] for p in letter])
        x += x_height * (max(p[0] for p in letter) + 0.45)
    m.add("small handwriting", drawing, zoom, middle(strokes[0]), strokes, [{"new": True, "count": len(strokes), "rms": 2, "most": 7.5}], small=True)
    return True


def extend(m, overlap):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing, lambda c: not c.closed)
        last = m.r.pick([0, 1])
        p, w = curve.end(last)
        length, bow = m.r.between(45, 150) / zoom, m.r.between(-0.5, 0.5)
        path = []
        if overlap:
            back = min(m.r.between(40, 90) / zoom, 0.4 * curve.length)
            path = [curve.at(curve.length - back * (1 - t) if last else back * (1 - t)) for t in (0, 0.3, 0.6, 0.85)]
        angle, q = math.atan2(w[1], w[0]), list(p)
        path.append(q)
        for _ in range(5):
            angle += bow / 5
            q = [q[0] + length / 5 * math.cos(angle), q[1] + length / 5 * math.sin(angle)]
            path.append(q)
        if not all(map(inside, path)) or nearest_other(drawing, curve, path) * zoom < 24:
            return False
        m.add("along the curve and past its end" if overlap else "from the very end onwards", drawing, zoom, middle(path),
              [path if m.r.u() < 0.7 else path[::-1]], [{"extends": curve.name}])
        return True
    return attempt


GAPS = [("part-a", 1, "part-b", 0), ("part-c", 1, "part-d", 0), ("part-d", 1, "part-e", 0)]


def gap(m):
    zoom = m.zoom(0.7, 1.6)
    a, ea, b, eb = m.r.pick(GAPS)
    a, b = DRAWINGS["broken"][a], DRAWINGS["broken"][b]
    back = [m.r.pick([0, 0, 30, 60]) / zoom for _ in (0, 1)]
    path = [a.at(a.length - back[0] * t) for t in (1, 0.5)] * bool(back[0]) + [a.end(1)[0]]
    path += [b.end(0)[0]] + [b.at(back[1] * t) for t in (0.5, 1)] * bool(back[1])
    path = [[p[k] + m.r.between(-1.5, 1.5) / zoom for k in (0, 1)] for p in path]
    if m.r.u() < 0.5:
        path = path[::-1]
    m.add("gap between two curves", "broken", zoom, middle(path), [path], [{"joins": [a.name, b.name]}])
    return True


def close(m):
    zoom = m.zoom(0.7, 1.6)
    name = m.r.pick(["bay", "cup", "bow"])
    c = DRAWINGS["broken"][name]
    p, q = c.end(1)[0], c.end(0)[0]
    u, d = [q[k] - p[k] for k in (0, 1)], math.dist(p, q)
    bow = m.r.between(-0.12, 0.22) * d
    inner = c.at(c.length / 2)
    n = [-u[1] / d, u[0] / d]
    if (inner[0] - p[0]) * n[0] + (inner[1] - p[1]) * n[1] > 0:
        n = [-n[0], -n[1]]
    path = [[p[k] + u[k] * t + n[k] * bow * math.sin(math.pi * t) for k in (0, 1)] for t in (0, 0.25, 0.5, 0.75, 1)]
    m.add("closing own curve", "broken", zoom, middle(path), [path if m.r.u() < 0.5 else path[::-1]], [{"closes": name}])
    return True


def joint(m):
    drawing = "chair" if m.other else m.r.pick(["fish", "broken"])
    zoom = m.zoom(0.8, 1.8)
    a, ea, b, eb = m.r.pick(touching(drawing))
    wa, wb = a.end(ea)[1], b.end(eb)[1]
    if wa[0] * wb[0] + wa[1] * wb[1] > -0.85:  # almost straight through
        return False
    back = [m.r.between(0.35, 0.7) * min(c.length, 260 / zoom) for c in (a, b)]
    height = m.r.between(-7, 7) / zoom
    path = []
    for i in range(7):
        t = i / 6
        path.append(a.beside(a.length - back[0] * (1 - t) if ea else back[0] * (1 - t), height * math.sin(math.pi * t / 2) ** 2 * (1 if ea else -1)))
    for i in range(1, 7):
        t = i / 6
        path.append(b.beside(b.length - back[1] * t if eb else back[1] * t, height * math.cos(math.pi * t / 2) ** 2 * (-1 if eb else 1)))
    m.add("over a joint", drawing, zoom, middle(path), [path if m.r.u() < 0.5 else path[::-1]],
          [{"redraws": [a.name, b.name], "touch": [[a.name, b.name, 3]]}, {"joins": [a.name, b.name]}])
    return True


def up_to_joint(m):
    drawing = m.r.pick(["fish", "broken"])
    zoom = m.zoom(0.8, 1.8)
    a, ea, b, eb = m.r.pick(touching(drawing))
    if m.r.u() < 0.5:
        a, ea, b, eb = b, eb, a, ea
    back = m.r.between(0.4, 0.8) * min(a.length, 320 / zoom)
    if back * zoom < 45:
        return False
    height = m.r.between(3, 9) * m.r.pick([-1, 1]) / zoom
    path = [a.beside(a.length - back * (1 - t) if ea else back * (1 - t), height * math.sin(math.pi * t) ** 2) for t in [i / 9 for i in range(10)]]
    m.add("redrawn up to a joint", drawing, zoom, middle(path), [path if m.r.u() < 0.6 else path[::-1]],
          [{"redraws": [a.name], "touch": [[a.name, b.name, 2]]}])
    return True


def further_line(m):
    drawing, zoom = m.r.pick([("vase", "band-1", "band-2", "band-3"), ("letters", "rule-1", "rule-2", "rule-3"), ("coast", "ring-1", "ring-2", "ring-3")]), m.zoom(0.8, 1.6)
    first, second = DRAWINGS[drawing[0]][drawing[1]], DRAWINGS[drawing[0]][drawing[2]]
    if drawing[0] != "vase":
        return False
    spacing = 24 * m.r.between(0.9, 1.2)
    curve = m.r.pick([DRAWINGS["vase"]["band-1"], DRAWINGS["vase"]["band-3"]])
    off = spacing * (-1 if curve.name == "band-1" else 1)
    path = [curve.beside(curve.length * t, off) for t in (0.05, 0.25, 0.5, 0.75, 0.95)]
    m.add("a further line beside parallel ones", "vase", zoom, middle(path), [path if m.r.u() < 0.6 else path[::-1]], [{"new": True}])
    return True


def chosen(m):
    """Another curve is nearer, but this one is selected."""
    a, b = m.r.pick([("band-1", "band-2"), ("band-3", "band-2"), ("band-2", "band-1"), ("band-2", "band-3")])
    meant, other = DRAWINGS["vase"][a], DRAWINGS["vase"][b]
    zoom = m.zoom(0.8, 1.3)
    side = 1 if other.at(0)[1] > meant.at(0)[1] else -1
    off = side * m.r.between(13, 17)
    path = [meant.beside(meant.length * t, off * math.sin(math.pi * (t - 0.1) / 0.8) ** 0.5 if 0.1 < t < 0.9 else 0) for t in [0.1 + 0.8 * i / 12 for i in range(13)]]
    m.add("selection restricts", "vase", zoom, middle(path), [path], [{"redraws": [a], "passes": 6}],
          prepare=["command tool-select", "select " + a, "command tool-sketch"])
    return True


def hairy(m):
    def attempt():
        drawing, zoom = m.any_drawing(), m.zoom()
        curve = m.pick(drawing)
        got = stretch(m, curve, 200 / zoom, 360 / zoom)
        if not got:
            return False
        a, b = got
        height = m.r.between(4, 9) * m.r.pick([-1, 1]) / zoom
        strokes = []
        for _ in range(m.r.pick([2, 3])):
            c, d = a + m.r.between(0, 0.12) * (b - a), b - m.r.between(0, 0.12) * (b - a)
            path = bump(curve, c, d, height * m.r.between(0.7, 1.2), lean=m.r.between(-3, 3) / zoom)
            strokes.append(path if m.r.u() < 0.6 else path[::-1])
        if not bare_ends(drawing, curve, a, b, 50 / zoom) or curve.turn(a, b) > 3 or nearest_other(drawing, curve, strokes[0]) * zoom < 30:
            return False
        m.add("hairy overdraws", drawing, zoom, middle(strokes[0]), strokes, [{"redraws": [curve.name], "last": True}])
        return True
    return attempt


def hatching(m):
    drawing, zoom = m.any_drawing(), m.zoom()
    x, y, angle = m.r.between(80, 900), m.r.between(80, 620), m.r.between(0, math.pi)
    apart, length, count = m.r.between(13, 20) / zoom, m.r.between(50, 110) / zoom, m.r.pick([4, 5])
    u, n = [math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]
    strokes = [[[x + u[k] * length * t + n[k] * apart * i for k in (0, 1)] for t in (0, 0.33, 0.67, 1)] for i in range(count)]
    if nearest_any(drawing, [p for s in strokes for p in s]) * zoom < 40 or not all(inside(p) for s in strokes for p in s):
        return False
    m.add("hatching", drawing, zoom, middle(strokes[count // 2]), strokes, [{"new": True, "count": count, "rms": 3, "most": 9}])
    return True


def chain(m):
    zoom = m.zoom(0.9, 2)
    d = DRAWINGS["broken"]
    cut = [m.r.between(0.2, 0.5), m.r.between(0.5, 0.8)]
    height = m.r.between(-5, 5) / zoom
    path = [d["link-1"].beside(d["link-1"].length * (cut[0] + (1 - cut[0]) * t), height) for t in (0, 0.33, 0.67)]
    path += [d["link-2"].beside(d["link-2"].length * t, height) for t in (0, 0.25, 0.5, 0.75)]
    path += [d["link-3"].beside(d["link-3"].length * cut[1] * t, height) for t in (0, 0.33, 0.67, 1)]
    m.add("over two joints", "broken", zoom, middle(path), [path if m.r.u() < 0.5 else path[::-1]],
          [{"redraws": ["link-1", "link-2", "link-3"], "touch": [["link-1", "link-2", 3], ["link-2", "link-3", 3]]}])
    return True


def whole_turn(m):
    drawing, zoom = m.r.pick(["guitar", "coast", "vase", "letters"]), m.zoom(0.7, 1.5)
    curve = m.pick(drawing, lambda c: c.closed and c.length > 200)
    start, off, way = m.r.between(0, curve.length), m.r.between(-9, 9) / zoom, m.r.pick([-1, 1])
    path = [curve.beside(start + way * curve.length * i / 26, off + 0.5 * math.sin(i)) for i in range(27)]
    if nearest_other(drawing, curve, path) * zoom < 22:
        return False
    m.add("closed curve, whole turn", drawing, zoom, middle(path), [path], [{"redraws": [curve.name], "still": None}])
    return True


FAMILIES = [
    (26, lambda m: overdraw(m, "overdraw", 160, 480, 0.07)),
    (14, lambda m: overdraw(m, "overdraw against the sense", 140, 400, 0.07, against=True)),
    (12, lambda m: overdraw(m, "short overdraw", 60, 120, 0.08)),
    (12, lambda m: overdraw(m, "far out", 150, 400, 0.07, zooms=(0.25, 0.45))),
    (12, lambda m: overdraw(m, "far in", 150, 400, 0.07, zooms=(3, 8))),
    (14, lambda m: begun_away(m, False)),
    (12, lambda m: begun_away(m, True)),
    (14, lambda m: beside(m, 12, 22, False)),
    (6, lambda m: beside(m, 29, 36, True)),
    (20, lambda m: crossing(m, 90, 260, "across curves")),
    (14, lambda m: crossing(m, 24, 50, "tick across a curve")),
    (24, lambda m: branch(m, False)),
    (14, lambda m: branch(m, True)),
    (12, lambda m: lambda: in_the_open(m)),
    (16, lambda m: lambda: small_circle(m)),
    (14, lambda m: lambda: word(m)),
    (14, lambda m: extend(m, False)),
    (14, lambda m: extend(m, True)),
    (14, lambda m: lambda: gap(m)),
    (12, lambda m: lambda: close(m)),
    (12, lambda m: lambda: joint(m)),
    (14, lambda m: lambda: up_to_joint(m)),
    (8, lambda m: lambda: further_line(m)),
    (8, lambda m: lambda: chosen(m)),
    (10, lambda m: hairy(m)),
    (6, lambda m: lambda: hatching(m)),
    (6, lambda m: lambda: chain(m)),
    (8, lambda m: lambda: whole_turn(m)),
]



class Other:
    """A hand that is not the usual one, or a view or tablet that is not."""

    def __init__(self, name, zooms=(0.7, 1.6), turned=False, view=None, **hand):
        self.name, self.zooms, self.turned, self.view, self.ranges = name, zooms, turned, view or {}, hand

    def hand(self, r):
        return {k: round(r.between(*v), 2) for k, v in self.ranges.items()}


# Lengths in px: tremor of 1 px and more is felt as shaky; a left hand pushes where a right one pulls, and leaves a longer
# hook; 60 samples a second at 2000 px/s are 33 px apart; a small tablet's unit is a few px of a large view.
HANDS = [
    Other("shaky hand", speed=(120, 320), tremor=(1, 1.8), drift=(0.8, 1.6), noise=(0.1, 0.4), hook=(0, 4)),
    Other("left hand", turned=True, speed=(200, 600), tremor=(0.2, 0.7), drift=(0.4, 1.2), noise=(0, 0.2), hook=(2, 6)),
    Other("fast, few samples", speed=(1400, 2600), tremor=(0.1, 0.5), drift=(0.3, 1), noise=(0, 0.3), hook=(0, 3), rate=(60, 90)),
    Other("tiny tablet", view={"size": [430, 300], "ratio": 3}, zooms=(0.35, 0.8), speed=(200, 500), tremor=(0.2, 0.5),
          drift=(0.3, 0.8), noise=(0.05, 0.2), hook=(0, 2.5), rate=(100, 133), grid=(0.5, 1)),
    Other("zoomed out", zooms=(0.18, 0.3), speed=(120, 350), tremor=(0.1, 0.4), drift=(0.2, 0.6), noise=(0, 0.2), hook=(0, 3)),
    Other("zoomed in", zooms=(5, 12), speed=(200, 700), tremor=(0.1, 0.6), drift=(0.2, 0.9), noise=(0, 0.25), hook=(0, 4)),
]


def by_other_hands(m):
    """Each hand: overdraws, lines across and from curves, extensions, joints."""
    for other in HANDS:
        m.other = other
        far = other.zooms[1] < 0.4
        wanted = [(3, overdraw(m, "", 70 if far else 110, 300, 0.07)), (2, crossing(m, 60, 160, "")), (2, branch(m, False))]
        if not far:
            wanted.append((1, lambda: in_the_open(m)))
        if other.zooms[0] < 2:
            wanted += [(2, extend(m, False)), (2, lambda: joint(m))]
        for count, attempt in wanted:
            m.until(count, attempt)


if __name__ == "__main__":
    maker = Maker(20261)
    for count, family in FAMILIES:
        maker.until(count, family(maker))
    others_maker = Maker(52061, sorted(draw.OTHERS), "h")
    by_other_hands(others_maker)
    maker.out += others_maker.out
    print('{"about": "Written by families.py; paths in document units.", "gestures": [')
    print(",\n".join(json.dumps(g) for g in maker.out))
    print("]}")
