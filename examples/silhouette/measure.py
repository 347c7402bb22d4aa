#!/usr/bin/python3
"""What a journal cost and what came of it: measure.py PROGRAM JOURNAL... Needs numpy.

Counted from the journal's raw events: gestures (a double tap is one), pen-downs, travel of the pen on and above the screen, views changed. Measured
on what `batten replay` makes of it: inner knots, control points, and the greatest distance between the line and the
silhouette, both ways, each taken as 20,000 points.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy

WINDOW = 1280, 800
MARGIN = 32
PAGE = 1000, 420
ZOOM = min((WINDOW[0] - 2 * MARGIN) / PAGE[0], (WINDOW[1] - 2 * MARGIN) / PAGE[1])
ORIGIN = PAGE[0] / 2 - WINDOW[0] / 2 / ZOOM, PAGE[1] / 2 - WINDOW[1] / 2 / ZOOM
TARGET, LINE = 2, 4  # ids of the objects


def batten(program, *words, data=None):
    return subprocess.run([program, *map(str, words)], input=data, check=True, capture_output=True).stdout


def de_boor(knots, points, degree, u):
    """Points of a B-spline at the parameters u, by the Cox-de Boor recursion."""
    span = numpy.clip(numpy.searchsorted(knots, u, side="right") - 1, degree, len(points) - 1)
    d = [points[span - degree + j] for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[span - degree + j], knots[span + j - r + 1]
            a = ((u - low) / (high - low))[:, None]
            d[j] = (1 - a) * d[j - 1] + a * d[j]
    return d[degree]


def curve_of(document, object_id):
    item = next(o for o in document["objects"] if o["id"] == object_id)
    curve = item["curves"][0]
    return numpy.array(curve["knots"], float), numpy.array(curve["points"], float), curve["degree"]


def samples(curve, count=20000):
    knots, points, degree = curve
    return de_boor(knots, points, degree, numpy.linspace(knots[degree], knots[-degree - 1], count))


def distances(line, target):
    """From each point of the line to the polygon of the target's points."""
    a, b = target[:-1], target[1:]
    along = b - a
    square = numpy.maximum((along ** 2).sum(1), 1e-300)
    result = numpy.empty(len(line))
    for i, p in enumerate(line):
        t = numpy.clip(((p - a) * along).sum(1) / square, 0, 1)
        result[i] = math.sqrt((((a + t[:, None] * along) - p) ** 2).sum(1).min())
    return result


def greatest_error(document, count=4000):
    target, line = samples(curve_of(document, TARGET), count), samples(curve_of(document, LINE), count)
    return max(distances(line, target).max(), distances(target, line).max())


def result(program, journal):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.batten"
        batten(program, "replay", journal, "--check", "--output", out)
        return json.loads(out.read_text())


def cost(journal):
    gestures = downs = on = above = views = 0
    at, down, tapped = None, False, -math.inf
    for text in pathlib.Path(journal).read_text().splitlines():
        line = json.loads(text)
        views += "wheel" in line or str(line.get("command", "")).startswith(("zoom", "pan", "view"))
        if "pointer" not in line:
            continue
        place = line["x"], line["y"]
        if at:
            step = math.dist(at, place)
            on, above = (on + step, above) if down else (on, above + step)
        at = place
        if line["pointer"] == "down":
            downs += 1
            gestures += line["time"] - tapped > 400
            began = line["time"]
        if line["pointer"] == "up":
            tapped = line["time"] if line["time"] - began < 150 else -math.inf
        down = line["pointer"] == "down" or (down and line["pointer"] == "move")
    return {"gestures": gestures, "pen-downs": downs, "travel on the screen, px": round(on), "travel above it, px": round(above),
            "views changed": views}


def row(program, journal):
    document = result(program, journal)
    knots, points, degree = curve_of(document, LINE)
    return {**cost(journal), "inner knots": len(knots) - 2 * degree - 2, "control points": len(points),
            "greatest error, px": round(greatest_error(document), 2)}


def table(program, journals):
    rows = {pathlib.Path(j).stem: row(program, j) for j in journals}
    names = list(rows)
    lines = ["| | " + " | ".join(names) + " |", "|---|" + "---:|" * len(names)]
    for what in rows[names[0]]:
        lines.append(f"| {what} | " + " | ".join(str(rows[name][what]) for name in names) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table(sys.argv[1], sys.argv[2:]))
