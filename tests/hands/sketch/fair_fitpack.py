"""The sketch hand's curves change their curvature less than FITPACK's cubics with the same residual.

usage: fair_fitpack.py PROGRAM (fair_strokes). FITPACK is told the sum of squared distances that the hand's curve leaves.
"Change" is the integral of the squared derivative of curvature by arc length; "sum" that of its absolute value.
"""
import subprocess
import sys

import numpy as np
from scipy.interpolate import CubicSpline, splev, splprep
from scipy.spatial import cKDTree

PLACES = 1500
STROKES = 20


def changes(curve):
    """Of curvature along a curve given by many points: squared, and absolute."""
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T))]
    spline, even = CubicSpline(way, curve), np.linspace(0, way[-1], PLACES)
    (x, y), (xx, yy) = spline(even, 1).T, spline(even, 2).T
    step = np.diff((x * yy - y * xx) / np.hypot(x, y) ** 3)
    return np.array([(step**2).sum() / even[1], np.abs(step).sum()])


def look(degree, seed):
    """A row a stroke: both ratios, false extrema, points."""
    arguments = [sys.argv[1], str(STROKES), str(degree), str(seed)]
    rows = []
    for line in subprocess.run(arguments, capture_output=True, text=True, check=True).stdout.splitlines():
        extrema, found, points, *numbers = map(float, line.split())
        curve, samples = np.split(np.reshape(numbers, (-1, 2)), [PLACES])
        residual = (cKDTree(curve).query(samples)[0] ** 2).sum()
        cubic = np.transpose(splev(np.linspace(0, 1, PLACES), splprep(samples.T, s=residual)[0]))
        rows.append([*changes(curve) / changes(cubic), max(found - extrema, 0), points])
    return np.array(rows)


failed = False
for degree, most, most_points in ((3, 0.8, 8), (5, 0.8, 9)):
    for seed in (4711, 1):
        change, total, false, points = look(degree, seed).T
        print(
            f"degree {degree}: change {np.median(change):.2f} of FITPACK's in the median, sum {np.median(total):.2f}, "
            f"{false.sum():.0f} false extrema in {STROKES} strokes, {np.median(points):g} points"
        )
        failed |= np.median(change) > most or false.sum() > 0.1 * STROKES or np.median(points) > most_points
sys.exit(int(failed))
