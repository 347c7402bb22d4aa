#!/usr/bin/env python3
"""One touch is one crossing: tangencies and near-tangencies beside exact algebra. Curves have whole coordinates; roots are
counted by Sturm's sequences over whole numbers, those of two cubics in Bézout's resultant. Usage: contacts.py MEETINGS [COUNT]"""
import math
import random
import subprocess
import sys
import unittest
from fractions import Fraction

ARM = sys.argv.pop(1)
COUNT = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 1000
SIZE = 1 << 27  # of curves, in steps of 2^16, so that there is room for gaps: coordinates stay below 2^53


# ---- polynomials with whole coefficients, lowest first ----

def trim(p):
    while p and p[-1] == 0:
        p.pop()
    return p


def add(p, q, sign=1):
    n = max(len(p), len(q))
    return trim([(p[i] if i < len(p) else 0) + sign * (q[i] if i < len(q) else 0) for i in range(n)])


def times(p, q):
    out = [0] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return trim(out)


def at(p, x):
    """The value's sign is that of the polynomial at a fraction."""
    n, d, value, power = x.numerator, x.denominator, 0, 1
    for a in reversed(p):
        value = value * n + a * power
        power *= d
    return value


def primitive(p):
    g = math.gcd(*p)
    return [a // g for a in p] if g > 1 else p


def sturm(p):
    chain = [p, primitive(trim([i * a for i, a in enumerate(p)][1:]))]
    while chain[-1]:
        a, b = list(chain[-2]), chain[-1]
        lead, flips = b[-1], 0
        while len(a) >= len(b):
            factor, shift = a[-1], len(a) - len(b)
            a = [lead * x for x in a]
            flips ^= lead < 0
            for i, y in enumerate(b):
                a[i + shift] -= factor * y
            a = trim(a)
        chain.append(primitive([x if flips else -x for x in a]))
    return chain[:-1]


def changes(chain, x):
    last, count = 0, 0
    for p in chain:
        s = at(p, x)
        if s:
            count += last * s < 0
            last = 1 if s > 0 else -1
    return count


def roots(p, low=Fraction(0), high=Fraction(1), width=Fraction(1, 1 << 90)):
    """The distinct roots in [low, high], as intervals no wider than width."""
    if not p or len(p) == 1:
        return []
    chain, out = sturm(p), []
    stack = [(low, high, changes(chain, low), changes(chain, high))]
    if at(p, low) == 0:
        out.append((low, low))
    while stack:
        a, b, ca, cb = stack.pop()
        if ca == cb:
            continue
        if b - a <= width:
            out.append((a, b))
            continue
        m = (a + b) / 2
        cm = changes(chain, m)
        stack += [(a, m, ca, cm), (m, b, cm, cb)]
    return sorted(out)


def power_form(b):
    """A Bézier cubic's coordinate as a polynomial."""
    if len(b) == 2:
        return trim([b[0], b[1] - b[0]])
    return trim([b[0], 3 * (b[1] - b[0]), 3 * (b[0] - 2 * b[1] + b[2]), b[3] - 3 * b[2] + 3 * b[1] - b[0]])


def turned(points):
    """By a right triangle of 3, 4 and 5: nothing is parallel to an axis, and everything stays whole."""
    return [(3 * x - 4 * y, 4 * x + 3 * y) for x, y in points]


# ---- cases ----

class Case:
    def __init__(self, a, b, tolerance, least, most, note, total=None, centres=(), roots=0):
        self.a, self.b, self.tolerance, self.centres, self.roots = a, b, tolerance, centres, roots
        self.least, self.most, self.note, self.total = least, most, note, total

    def look_closer(self):
        """Where what was known of two cubics' stretches was too rough: counts them along b and along a, from places that crowd at
        `centres`: two contacts may be one stretch along the one curve."""
        v, u = zip(*self.centres)
        low, high = sorted(max(stretches(self.a, self.b, float(self.tolerance) * by, v), stretches(self.b, self.a, float(self.tolerance) * by, u))
                           for by in (0.9, 1.1))
        self.least, self.most = min(self.roots, low), max(self.roots, high)

    def line(self):
        numbers = [len(self.a) - 1, len(self.b) - 1, float(self.tolerance)]
        return " ".join(repr(float(x)) if i > 1 else str(x) for i, x in
                        enumerate(numbers + [x for p in self.a + self.b for x in p]))


def random_cubic(r):
    return [(r.randint(-SIZE // 2, SIZE // 2) * (1 << 16), r.randint(-SIZE // 2, SIZE // 2) * (1 << 16)) for _ in range(4)]


EXTENT = SIZE << 16


def random_gap(r):
    """1e-2 to 1e-12 of the size, or none."""
    return 0 if r.random() < 0.1 else int(r.choice((-1, 1)) * EXTENT * 10 ** r.uniform(-12, -2))


def line_and_cubic(r):
    """A level line near the top or the bottom of a cubic."""
    while True:
        a = random_cubic(r)
        y = power_form([p[1] for p in a])
        slope = roots(trim([i * c for i, c in enumerate(y)][1:]), width=Fraction(1, 1 << 40))
        slope = [s for s in slope if 0.02 < s[0] < 0.98]
        if slope:
            break
    u = r.choice(slope)[0]
    top = sum(c * u ** i for i, c in enumerate(y))
    level = int(top) + random_gap(r)
    tolerance = max(2, int(EXTENT * 10 ** r.uniform(-11, -3)))
    b = [(-EXTENT, level), (EXTENT, level)]
    f = add(y, [level], -1)
    n = len(roots(f))
    inside = add([tolerance ** 2], times(f, f), -1)
    cuts = [Fraction(0)] + [(s[0] + s[1]) / 2 for s in roots(inside)] + [Fraction(1)]
    near = [at(inside, (x + z) / 2) > 0 for x, z in zip(cuts, cuts[1:])]
    stretches = sum(now and not before for now, before in zip(near, [False] + near))
    before, after = at(f, Fraction(0)), at(f, Fraction(1))
    free = abs(before) > tolerance and abs(after) > tolerance
    total = ((after > 0) - (before > 0)) if free else None
    return Case(turned(a), turned(b), 5 * tolerance, min(n, stretches), max(n, stretches), f"{n} roots, {stretches} stretches", total)


def resultant(a, b):
    """In b's parameter: where it lies on the cubic that a is a part of; and a's parameter there, as a fraction of two polynomials."""
    xs, ys = power_form([p[0] for p in a]), power_form([p[1] for p in a])
    xs, ys = xs + [0] * (4 - len(xs)), ys + [0] * (4 - len(ys))
    bx, by = power_form([p[0] for p in b]), power_form([p[1] for p in b])
    # Bézout's matrix of x(u) - X and y(u) - Y, whose entries are linear in X and Y
    p, q = [[c] for c in xs], [[c] for c in ys]
    p[0], q[0] = add([xs[0]], bx, -1), add([ys[0]], by, -1)

    def bracket(i, j):
        return add(times(p[i], q[j]), times(p[j], q[i]), -1)
    m = [[bracket(3, 2), bracket(3, 1), bracket(3, 0)],
         [bracket(3, 1), add(bracket(3, 0), bracket(2, 1)), bracket(2, 0)],
         [bracket(3, 0), bracket(2, 0), bracket(1, 0)]]

    def minor(i, j, k, l):
        return add(times(m[i][k], m[j][l]), times(m[i][l], m[j][k]), -1)
    whole = add(add(times(m[0][0], minor(1, 2, 1, 2)), times(m[0][1], minor(1, 2, 0, 2)), -1), times(m[0][2], minor(1, 2, 0, 1)))
    # the kernel (u^2, u, 1): u = -minor(0, 2) / minor(0, 1) of the first two rows
    return primitive(whole), [(minor(i, j, 0, 2), minor(i, j, 0, 1)) for i, j in ((0, 1), (0, 2), (1, 2))]


def value(p, x):
    return sum(c * x ** i for i, c in enumerate(p))


def meetings_of(a, b):
    """The parameters in b of exact crossings, a's parameter beside each; None: one is too near an end of a to tell."""
    whole, kernels = resultant(a, b)
    out = []
    for low, high in roots(whole, width=Fraction(1, 1 << 120)):
        v = (low + high) / 2
        best = max(((abs(value(d, v)), n, d) for n, d in kernels), key=lambda k: k[0])
        if best[0] == 0:
            return None
        u = -value(best[1], v) / value(best[2], v)
        if min(abs(u), abs(1 - u)) < 1e-3 or min(v, 1 - v) < 1e-3:
            return None
        if 0 < u < 1:
            out.append((float(v), float(u)))
    return out


def place_on(c, t):
    s = 1 - t
    w = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
    return sum(k * p[0] for k, p in zip(w, c)), sum(k * p[1] for k, p in zip(w, c))


def stretches(a, b, tolerance, centres):
    """How many stretches of b lie within the tolerance of a."""
    coarse = [place_on(a, i / 256) for i in range(257)]

    def away(v):
        x, y = place_on(b, v)

        def square(u):
            p = place_on(a, u)
            return (p[0] - x) ** 2 + (p[1] - y) ** 2
        far = [(p[0] - x) ** 2 + (p[1] - y) ** 2 for p in coarse]
        least = min(far)
        for i in range(257):
            if far[i] > far[max(i - 1, 0)] or far[i] > far[min(i + 1, 256)]:
                continue
            low, high = max(i - 1, 0) / 256, min(i + 1, 256) / 256
            for _ in range(80): # thirds: the square's foot, then the line's own distance
                one, two = low + (high - low) / 3, high - (high - low) / 3
                low, high = (low, two) if square(one) < square(two) else (one, high)
            u = (low + high) / 2
            p, q = place_on(a, max(u - 1e-5, 0)), place_on(a, min(u + 1e-5, 1))
            least = min(least, square(u))
            if 1e-5 < u < 1 - 1e-5: # the chord's normal: squares lose half of the digits
                m, length = place_on(a, u), math.dist(p, q)
                least = min(least, (((q[0] - p[0]) * (y - m[1]) - (q[1] - p[1]) * (x - m[0])) / length) ** 2) if length else least
        return least ** 0.5
    shares = sorted({min(max(c + side * 1e-9 * 1.25 ** k, 0), 1) for c in centres for side in (-1, 0, 1) for k in range(93)})
    near = [away(v) <= tolerance for v in shares]
    return sum(now and not before for now, before in zip(near, [False] + near))


def two_cubics(r):
    """The second one is moved to where it nearly touches the first, with its tangent there."""
    while True:
        a, b = random_cubic(r), random_cubic(r)
        u, v = Fraction(r.randint(200, 800), 1000), Fraction(r.randint(200, 800), 1000)

        def place(c, t):
            p = [power_form([q[k] for q in c]) for k in (0, 1)]
            return [float(value(k, t)) for k in p], [float(value([i * x for i, x in enumerate(k)][1:], t)) for k in p]
        (ax, ay), (dx, dy) = place(a, u)
        (bx, by), (ex, ey) = place(b, v)
        scale = ((dx * dx + dy * dy) / (ex * ex + ey * ey)) ** 0.5 if ex or ey else 0
        if not 0.2 < scale < 5:
            continue
        # turned and scaled about its place, so that the tangents agree; then away by the gap
        c, s = (dx * ex + dy * ey) / (ex * ex + ey * ey), (dy * ex - dx * ey) / (ex * ex + ey * ey)
        gap, length = random_gap(r), (dx * dx + dy * dy) ** 0.5
        mx, my = ax - gap * dy / length, ay + gap * dx / length
        b = [(int(mx + c * (x - bx) - s * (y - by)), int(my + s * (x - bx) + c * (y - by))) for x, y in b]
        met = meetings_of(a, b)
        if met is None:
            continue
        n, near = len(met), sum(abs(x - float(v)) < 0.3 * max(abs(gap) / EXTENT, 1e-13) ** 0.5 * 30 + 1e-5 for x, _ in met)
        # clearly above or below what the two are apart, so that nobody has to find stretches
        if r.random() < 0.5 and abs(gap) > 4000:
            tolerance, least, most = abs(gap) * 10 ** r.uniform(-3, -1), n, n
        else:
            tolerance = max(abs(gap) * 10 ** r.uniform(1, 3), EXTENT * 1e-12)
            least, most = min(n, n - near + 1), max(n, n - near + 1)
        if tolerance > 1e-4 * EXTENT or near > 2:
            continue
        return Case(a, b, max(tolerance, 16), least, most, f"{n} roots, {near} near, gap {gap / EXTENT:.3g}", None,
                    [(float(v), float(u)), *met], n)


def run(cases):
    told = subprocess.run([ARM], input="\n".join(c.line() for c in cases) + "\n", stdout=subprocess.PIPE, text=True, check=True)
    lines = told.stdout.splitlines()
    assert len(lines) == len(cases)
    for case, line in zip(cases, lines):
        numbers = [int(x) for x in line.split()]
        yield case, [numbers[i:i + 8] for i in range(0, 32, 8)]


class Contacts(unittest.TestCase):
    def check(self, make, seed, count):
        r = random.Random(seed)
        cases, wrong = [make(r) for _ in range(count)], []
        for case, (plain, turned_, small, large) in run(cases):
            status, found, overlaps, total = plain[:4]
            says = f"{case.note}, {float(case.tolerance) / EXTENT:.3g} tolerance, found {plain} {turned_} {small} {large}: {case.line()}"
            if case.centres and not case.least <= found <= case.most:
                case.look_closer()
            if status or overlaps or not case.least <= found <= case.most:
                wrong.append("count: " + says)
            elif turned_ != [*plain[:3], -total, *plain[4:]]:
                wrong.append("order: " + says)
            elif any(not case.least <= size[1] <= case.most or size[0] for size in (small, large)):
                wrong.append("scale: " + says)
            elif case.total is not None and plain[6] == 0 and abs(total) != abs(case.total):
                wrong.append("signs: " + says)
        self.assertFalse(wrong, f"{len(wrong)} of {count}:\n" + "\n".join(wrong[:8]))

    def test_line_and_cubic(self):
        self.check(line_and_cubic, 1, 4 * COUNT)

    def test_two_cubics(self):
        self.check(two_cubics, 2, COUNT)


if __name__ == "__main__":
    unittest.main()
