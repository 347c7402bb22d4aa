"""Plots of matplotlib. Usage: plots.py FOLDER COUNT"""
import math
import random
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plot  # noqa: E402

STYLES = ["default", "ggplot", "bmh", "dark_background"]
TIMES = [k / 9 for k in range(60)]


def lines(axes, r, _):
    for k in range(3):
        values = [math.sin(t * (k + 1)) * r.random() + 1 for t in TIMES]
        axes.plot(TIMES, values, ["-", "--", ":"][k], marker=["o", "", "^"][k])


def bars(axes, r, i):
    axes.bar(range(6), [r.random() for _ in range(6)], hatch="/" if i > 20 else None, edgecolor="k")


def points(axes, r, _):
    axes.scatter([r.random() for _ in range(40)], [r.random() for _ in range(40)], s=80, alpha=0.4, c=TIMES[:40], marker="D")


def areas(axes, _r, _i):
    axes.fill_between(TIMES, [math.sin(t) for t in TIMES], [math.cos(t) for t in TIMES], alpha=0.3)


def pie(axes, _, i):
    axes.pie([1, 2, 3, 4], labels=list("abcd"), explode=[0, 0.1, 0, 0], shadow=i > 20)


def contours(axes, _, i):
    axes.contour([[math.sin(a / 4) * math.cos(b / 5 + i) for a in range(30)] for b in range(30)])


def boxes(axes, r, _):
    axes.boxplot([[r.gauss(0, 1) for _ in range(30)] for _ in range(4)])


KINDS = [lines, bars, points, areas, pie, contours, boxes, lines]  # the last: in polar coordinates


def main():
    folder, count = sys.argv[1], int(sys.argv[2])
    for i in range(count):
        matplotlib.rcParams["svg.fonttype"] = "none" if i % 4 == 0 else "path"
        matplotlib.rcParams["svg.hashsalt"] = str(i)
        plot.style.use(STYLES[i % 4])
        figure = plot.figure(figsize=(4, 3))
        kind = i % len(KINDS)
        axes = figure.add_subplot(projection="polar" if kind == len(KINDS) - 1 else None)
        KINDS[kind](axes, random.Random(i), i)
        axes.set_title(f"$x^2 + y_{i}$")
        axes.grid(i % 3 == 0)
        figure.savefig(f"{folder}/{i}.svg", transparent=i % 5 == 0)
        plot.close(figure)


main()
