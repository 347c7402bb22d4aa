"""The fit needs at most 1.1 times the control points of FITPACK at equal true error.

usage: fit_economy.py PROGRAM, where PROGRAM prints for one of three strokes the points, then "fit COUNT ERROR".
FITPACK gets the best of 40 smoothing factors; its true error is the distance to a dense sampling.
"""
import subprocess
import sys
import warnings

import numpy as np
from scipy.interpolate import splev, splprep
from scipy.spatial import cKDTree

warnings.simplefilter("ignore")
failed = False
for kind in "012":
    lines = subprocess.run([sys.argv[1], kind], capture_output=True, text=True, check=True).stdout.split("\n")
    points = np.array([[float(v) for v in line.split()] for line in lines if line and not line.startswith("fit")])
    count, tolerance = next((int(l.split()[1]), float(l.split()[2])) for l in lines if l.startswith("fit"))
    best = None
    for s in np.geomspace(0.5, 300, 40):
        (t, c, p), _ = splprep(points.T, s=s)
        curve = np.array(splev(np.linspace(0, 1, 8001), (t, c, p))).T
        if cKDTree(curve).query(points)[0].max() <= tolerance and (best is None or len(t) - 4 < best):
            best = len(t) - 4
    print(f"stroke {kind}: {count} control points, FITPACK {best}, both within {tolerance}")
    failed |= best is None or count > 1.1 * best + 1
sys.exit(failed)
