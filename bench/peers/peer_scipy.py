"""FITPACK and BSpline through scipy: evaluation, and the fit with the best of 40 smoothing factors.

usage: peer_scipy.py FIT_STROKES; FIT_STROKES prints one of the three strokes (tests/curve/fit_strokes.c).
The time of a fit is that of the one call with the best factor: as if it were known.
"""
import json
import subprocess
import sys
import time
import warnings

import numpy as np
from scipy.interpolate import BSpline, splev, splprep
from scipy.spatial import cKDTree

warnings.simplefilter("ignore")


def measure(call):
    runs = []
    begin = time.perf_counter()
    while len(runs) < 5 or (time.perf_counter() - begin < 0.4 and len(runs) < 400):
        start = time.perf_counter()
        call()
        runs.append(time.perf_counter() - start)
    return min(runs), sorted(runs)[len(runs) // 2]


def row(name, unit, times, scale, note=""):
    print(json.dumps({"program": "scipy", "name": name, "unit": unit, "best": times[0] * scale,
                      "median": times[1] * scale, "note": note}), flush=True)


random = np.random.default_rng(1)
u = np.linspace(0, 1, 1000000)
for n in (16, 1000, 100000):
    knots = np.concatenate([[0] * 4, np.arange(1, n - 3) / (n - 3), [1] * 4])
    poly = BSpline(knots, random.random((n, 3)), 3)
    row(f"eval 1e6 sorted, 3D cubic, n={n}", "ns/point", measure(lambda: poly(u)), 1e3)

for kind, name in enumerate(("eight bends", "spiral", "car line")):
    text = subprocess.run([sys.argv[1], str(kind)], capture_output=True, text=True, check=True).stdout
    x = np.array([[float(v) for v in line.split()] for line in text.split("\n") if line and line[0] != "f"])
    best = None
    for s in np.geomspace(0.5, 300, 40):
        (t, c, p), _ = splprep(x.T, s=s)
        curve = np.array(splev(np.linspace(0, 1, 8001), (t, c, p))).T
        if cKDTree(curve).query(x)[0].max() <= 0.5 and (best is None or len(t) - 4 < best[0]):
            best = (len(t) - 4, s)
    if best:
        row(f"fit 1000, {name}", "us", measure(lambda: splprep(x.T, s=best[1])), 1e6, f"{best[0]} points")
