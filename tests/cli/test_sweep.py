"""revolve, coons, loft: against numpy's rotation, the formula of Coons and the curves themselves; what the contract says of
bad data."""
import unittest

import numpy
from scipy.interpolate import BSpline

from program import RING, ProgramTest

RANDOM = numpy.random.default_rng(13)


def curve(count=6, degree=3, domain=(0, 1), dimension=3):
    inner = numpy.sort(RANDOM.uniform(*domain, count - degree - 1))
    return {"degree": degree, "closed": False, "knots": [domain[0]] * (degree + 1) + inner.tolist() + [domain[1]] * (degree + 1),
            "points": RANDOM.uniform(-9, 9, (count, dimension)).tolist()}


def at(c, share):
    t, p = numpy.array(c["knots"]), c["degree"]
    points = numpy.array(c["points"])
    return BSpline(t, numpy.pad(points, ((0, 0), (0, 3 - points.shape[1]))), p)(t[0] + numpy.array(share) * (t[-1] - t[0]))


class Made(ProgramTest):
    def points(self, surface, u, v):
        places = ";".join(f"{a!r},{b!r}" for a, b in zip(u, v))
        return numpy.array(self.json("surface", "eval", self.file("made.json", surface), "--at", places)["points"])


def spline(f, x, derivative=0):
    if isinstance(f, (int, float)):
        return numpy.full_like(x, f if derivative == 0 else 0)
    return BSpline(numpy.array(f["knots"]), numpy.array(f["values"]), f["degree"])(x, nu=derivative)


class Sweep(Made):
    """Against a chain of frames computed here, by very many small rotations."""

    SWEEP = {"path": {"degree": 3, "closed": False, "knots": [1, 1, 1, 1, 2, 4, 4, 4, 4],
                      "points": [[0, 0, 0], [8, 1, 0], [9, 7, 5], [2, 9, 4], [0, 3, 9]]},
             "profile": {"degree": 2, "closed": True, "knots": [0, 1, 2, 3, 4], "points": [[.5, 0], [0, .4], [-.6, 0], [0, -.3]]},
             "first": {"s": [0, 1, 5]}, "twist": {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "values": [0, 2, 1]},
             "scale": {"degree": 1, "knots": [0, 0, 1, 1], "values": [1, 0.5]}}

    def frames(self, steps=20000):
        """u, C, t, s along the path: s is carried along by the least rotation of t, in many steps."""
        path = self.SWEEP["path"]
        c = BSpline(numpy.array(path["knots"]), numpy.array(path["points"], float), 3)
        u = numpy.linspace(1, 4, steps + 1)
        t = c(u, nu=1)
        t /= numpy.linalg.norm(t, axis=1)[:, None]
        s = numpy.empty_like(t)
        x = numpy.array(self.SWEEP["first"]["s"], float)
        for i in range(steps + 1):
            if i > 0:  # by the rotation that takes t[i - 1] to t[i]
                axis = numpy.cross(t[i - 1], t[i])
                x = x + numpy.cross(axis, x) + numpy.cross(axis, numpy.cross(axis, x)) / (1 + t[i - 1] @ t[i])
            x = x - t[i] * (x @ t[i])
            x /= numpy.linalg.norm(x)
            s[i] = x
        return u, c(u), t, s, c

    def test_places(self):
        u, c, t, s, path = self.frames()
        pick = numpy.arange(0, 20001, 1000)
        profile = self.SWEEP["profile"]
        knots = numpy.arange(-4, 10)
        closed = BSpline(knots.astype(float), numpy.array(profile["points"], float)[numpy.arange(len(knots) - 3) % 4], 2)
        # Batten's P_i has its support at t_i; here the first knot is -4, one period earlier.
        v = numpy.linspace(0, 3.9, len(pick))
        at = ";".join(f"{a!r},{b!r}" for a, b in zip(u[pick].tolist(), v.tolist()))
        result = self.json("sweep", self.file("s.json", self.SWEEP), "--at", at)
        share = (u[pick] - 1) / 3
        angle, scale = spline(self.SWEEP["twist"], share)[:, None], spline(self.SWEEP["scale"], share)[:, None]
        a, b = s[pick], numpy.cross(t[pick], s[pick])
        a, b = numpy.cos(angle) * a + numpy.sin(angle) * b, numpy.cos(angle) * b - numpy.sin(angle) * a
        x, y = closed(v).T[:, :, None]
        want = c[pick] + scale * (x * a + y * b)
        self.assertLess(numpy.abs(want - result["points"]).max(), 1e-7)
        c1, c2 = path(u[pick], nu=1), path(u[pick], nu=2)
        speed = numpy.linalg.norm(c1, axis=1)[:, None]
        bend = (c2 - t[pick] * (c2 * t[pick]).sum(1)[:, None]) / speed ** 2
        factor = 1 - scale[:, 0] * ((bend * a).sum(1) * x[:, 0] + (bend * b).sum(1) * y[:, 0])
        self.assertLess(numpy.abs(factor - result["factor"]).max(), 1e-6)

    def test_surface(self):
        name = self.file("s.json", self.SWEEP)
        for tolerance in (1e-2, 1e-5):
            made = self.json("sweep", name, "--tolerance", tolerance)
            self.assertEqual(made["closed"], [False, True])
            self.assertLessEqual(made["report"]["max_error"], tolerance)
            self.assertEqual((made["report"]["seam"], made["report"]["holonomy"]), (False, 0))
            u, v = RANDOM.uniform(1, 4, 200), RANDOM.uniform(0, 4, 200)
            at = ";".join(f"{a!r},{b!r}" for a, b in zip(u.tolist(), v.tolist()))
            want = numpy.array(self.json("sweep", name, "--at", at)["points"])
            self.assertLessEqual(numpy.linalg.norm(self.points(made, u.tolist(), v.tolist()) - want, axis=1).max(), tolerance)

    def test_samples_and_folds(self):
        tight = {"path": dict(self.SWEEP["path"], points=[[0, 0], [5, 0], [5, 5], [0, 5], [0, 9]]),
                 "profile": {"degree": 1, "knots": [0, 0, 1, 1], "points": [[-9, 0], [9, 0]]}}
        name = self.file("t.json", tight)
        made = self.json("sweep", name)
        result = self.json("sweep", name, "--samples", "200x3")
        factor = numpy.reshape(result["factor"], (200, 3)).min(1)
        u = numpy.array(result["uv"])[::3, 0]
        inside = numpy.array([any(a <= x <= b for a, b in made["report"]["folds"]) for x in u])
        clear = numpy.abs(factor) > 1e-3
        self.assertTrue((inside == (factor < 0))[clear].all() and inside.any() and not inside.all())
        self.assertEqual(result["uv"][:4], [[1, 0], [1, 0.5], [1, 1], [result["uv"][3][0], 0]])

    def test_bad_data_and_usage(self):
        for change, word in (({"path": None}, "path"), ({"twist": {"degree": 1, "knots": [0, 0, 2, 2], "values": [0, 1]}}, "twist"),
                             ({"frame": "best"}, "frame"), ({"scale": "big"}, "scale"), ({"first": {}}, "s"),
                             ({"profile": self.SWEEP["path"]}, "profile"), ({"scale": {"degree": 1, "knots": [0, 0, 1, 1]}}, "values"),
                             ({"path": {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2], "points": [[0, 0], [1, 2], [3, 0], [4, 3], [5, 3]]}}, "corner")):
            sweep = {k: v for k, v in {**self.SWEEP, **change}.items() if v is not None}
            self.assertIn(word, self.refused(1, "sweep", self.file("s.json", sweep)))
        name = self.file("s.json", self.SWEEP)
        for words in ([], [name, "--at", "1"], [name, "--samples", "3"], [name, "--at", "1,1", "--tolerance", "1"],
                      [name, "--tolerance", "0"]):
            self.refused(2, "sweep", *words)


class Revolve(Made):
    def test_against_rotation(self):
        for angle, dimension in ((360, 3), (-90, 2), (200.5, 3), (-360, 2)):
            profile = curve(domain=(1, 3), dimension=dimension)
            origin, axis = numpy.array([20., 1, -2]), numpy.array([0, 2., 1])
            k = axis / numpy.linalg.norm(axis)
            name = self.file("p.json", profile)
            words = ["revolve", name, "--axis", "20,1,-2,0,2,1", "--angle", angle]
            for tolerance in (None, 1e-6):
                made = self.json(*words, *([] if tolerance is None else ["--tolerance", tolerance]))
                points = numpy.array(profile["points"])
                bound = tolerance or 1e-4 * numpy.linalg.norm(points.max(0) - points.min(0))
                u, v = RANDOM.uniform(0, 1, 50), RANDOM.uniform(0, 1, 50)
                x = at(profile, v) - origin
                a = numpy.radians(angle * u)[:, None]
                want = origin + x * numpy.cos(a) + numpy.cross(k, x) * numpy.sin(a) + k * (x @ k)[:, None] * (1 - numpy.cos(a))
                error = numpy.linalg.norm(self.points(made, u.tolist(), (1 + 2 * v).tolist()) - want, axis=1).max()
                self.assertLessEqual(error, made["report"]["max_error"] + 1e-12)
                self.assertLessEqual(made["report"]["max_error"], bound)
                self.assertEqual(made["closed"], [abs(angle) == 360, False])
                self.assertEqual((made["knots"][0][0], made["knots"][0][-1]), (0, 1))

    def test_bad_data_and_usage(self):
        name = self.file("p.json", {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [0, 2]]})
        self.refused(1, "revolve", name, "--axis", "0,0,0,0,1,0")
        for words in ([], ["--axis", "0,0,0,0,0,0"], ["--axis", "0,0,0,1"], ["--axis", "0,0,0,1,0,0", "--angle", "0"],
                      ["--axis", "0,0,0,1,0,0", "--angle", "361"], ["--axis", "0,0,0,1,0,0", "--tolerance", "0"]):
            self.refused(2, "revolve", name, *words)


class Coons(Made):
    def test_the_formula(self):
        corners = RANDOM.uniform(-9, 9, (2, 2, 3))  # by u and v
        sides = [curve(6, 3), curve(5, 2, (2, 7)), curve(4, 3), curve(7, 1, (-1, 1))]
        for side, first, last in zip(sides, ((0, 0), (0, 1), (0, 0), (1, 0)), ((1, 0), (1, 1), (0, 1), (1, 1))):
            side["points"][0], side["points"][-1] = corners[first].tolist(), corners[last].tolist()
        names = [self.file(f"{i}.json", side) for i, side in enumerate(sides)]
        made = self.json("coons", *names)
        u, v = RANDOM.uniform(0, 1, 60), RANDOM.uniform(0, 1, 60)
        u[:10], u[10:20], v[20:30], v[30:40] = 0, 1, 0, 1
        c0, c1, d0, d1 = at(sides[0], u), at(sides[1], u), at(sides[2], v), at(sides[3], v)
        x, y = u[:, None], v[:, None]
        plane = ((1 - x) * (1 - y) * corners[0, 0] + x * (1 - y) * corners[1, 0] + (1 - x) * y * corners[0, 1] +
                 x * y * corners[1, 1])
        want = (1 - y) * c0 + y * c1 + (1 - x) * d0 + x * d1 - plane
        self.assertLess(numpy.abs(self.points(made, u.tolist(), v.tolist()) - want).max(), 1e-12)
        sides[3]["points"][-1][2] += 0.5
        names[3] = self.file("3.json", sides[3])
        line = self.refused(1, "coons", *names)
        self.assertIn("corner u = 1, v = 1", line)
        self.json("coons", *names, "--tolerance", "0.6")

    def test_bad_data_and_usage(self):
        name, ring = self.file("c.json", curve()), self.file("r.json", RING)
        self.refused(1, "coons", name, name, name, ring)
        self.refused(2, "coons", name, name, name)
        self.refused(2, "coons", "-", name, "-", name)


class Loft(Made):
    def test_contains_its_sections(self):
        for count in (2, 3, 4, 9):
            knots = curve(7, domain=(0, 1))["knots"]
            sections = [dict(curve(7), knots=[d + s * k for k in knots]) for d, s in
                        ((RANDOM.uniform(-3, 3), RANDOM.uniform(1, 3)) for _ in range(count))]
            names = [self.file(f"{i}.json", section) for i, section in enumerate(sections)]
            made = self.json("loft", *names)
            v, first = made["report"]["v"], sections[0]["knots"]
            self.assertEqual((len(v), v[0], v[-1]), (count, 0, 1))
            share = RANDOM.uniform(0, 1, 20)
            for section, place in zip(sections, v):
                got = self.points(made, (first[0] + share * (first[-1] - first[0])).tolist(), [place] * 20)
                self.assertLess(numpy.abs(got - at(section, share)).max(), 1e-9)

    def test_bad_data_and_usage(self):
        name, ring = self.file("c.json", curve()), self.file("r.json", RING)
        self.assertIn("r.json", self.refused(1, "loft", name, ring))
        self.refused(1, "loft", name, name)
        self.refused(1, "loft", *[self.file(f"{i}.json", curve(9)) for i in range(40)])
        self.refused(2, "loft", name)
        self.refused(2, "loft", "-", "-")


if __name__ == "__main__":
    unittest.main()
