#!/usr/bin/env python3
"""Compares the kernel with FITPACK (scipy): positions and derivatives (splev), insertion (insert), periodic curves,
degree elevation by values. Usage: fitpack.py DRIVER

The driver reads one curve and one task a line and writes numbers; see driver_curve.c.
"""
import subprocess
import sys

import numpy
from scipy.interpolate import BSpline, insert, splev

random = numpy.random.default_rng(7)


def words(values):
    return " ".join(repr(float(v)) for v in numpy.ravel(values))


def knots_of(degree, inner):
    t = numpy.sort(random.uniform(0, 1, inner))
    if inner > 3 and degree > 2:
        t[1] = t[2]
    return numpy.concatenate([numpy.zeros(degree + 1), t, numpy.ones(degree + 1)])


cases, lines = [], []
for degree in range(1, 6):  # FITPACK goes up to five
    for size in (2, 3):
        for inner in (0, 1, 5, 40):
            t = knots_of(degree, inner)
            n = len(t) - degree - 1
            c = random.uniform(-10, 10, (n, size))
            u = numpy.sort(random.uniform(0, 1, 50))
            curve = f"{degree} {size} 0 {n} {words(t)} {words(c)}"
            orders = min(degree, 3)
            tck = (t, [c[:, k] for k in range(size)], degree)
            values = numpy.array([splev(u, tck, der=k) for k in range(orders + 1)])  # order, size, point
            lines.append(f"{curve} eval {orders} {len(u)} {words(u)}")
            cases.append(("eval", numpy.transpose(values, (2, 0, 1)), degree))
            x = float(random.uniform(0.05, 0.95))
            fresh = insert(x, tck)
            points = numpy.array([row[: n + 1] for row in fresh[1]]).T
            lines.append(f"{curve} insert {repr(x)}")
            cases.append(("insert", numpy.concatenate([fresh[0], points.ravel()]), degree))
            lines.append(f"{curve} elevated {degree + 2} {len(u)} {words(u)}")
            cases.append(("elevated", values[0].T, degree))
for degree in range(1, 8):  # scipy's BSpline has no limit on the degree: the periodic extension by hand
    for n in (2, 3, 9):
        steps = random.uniform(0.2, 1, n)
        t = numpy.concatenate([[0], numpy.cumsum(steps)])
        c = random.uniform(-10, 10, (n, 2))
        period = t[-1]
        index = numpy.arange(-degree, n + degree + 1)
        full = t[index % n] + (index // n) * period
        points = c[numpy.arange(-degree, n) % n]
        u = numpy.sort(random.uniform(0, period, 40))
        lines.append(f"{degree} 2 1 {n} {words(t)} {words(c)} eval 0 {len(u)} {words(u)}")
        cases.append(("eval", BSpline(full, points, degree)(u), degree))

answer = subprocess.run([sys.argv[1]], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
rows = answer.stdout.splitlines()
assert len(rows) == len(cases), (len(rows), len(cases))
worst = {}
for row, (what, want, degree) in zip(rows, cases):
    got = numpy.array([float(word) for word in row.split()])
    want = numpy.ravel(want)
    assert got.shape == want.shape, (what, degree, got.shape, want.shape)
    error = float(numpy.max(numpy.abs(got - want) / (10 + numpy.abs(want))))
    worst[what] = max(worst.get(what, 0), error)
    assert error < 1e-9, (what, degree, error)
print(f"{len(cases)} comparisons with FITPACK; worst relative errors", worst)
