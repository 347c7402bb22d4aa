#!/usr/bin/env python3
"""Writes the drawings of this folder: curves through points, as cubic Béziers (Catmull-Rom). Usage: draw.py FOLDER"""
import math
import pathlib
import sys

SIZE = (1000, 700)


def arc(x, y, rx, ry, start, end, count=9):
    return [(x + rx * math.cos(math.radians(start + (end - start) * i / (count - 1))),
             y + ry * math.sin(math.radians(start + (end - start) * i / (count - 1)))) for i in range(count)]


def ring(x, y, rx, ry, count=10):
    return [(x + rx * math.cos(2 * math.pi * i / count), y + ry * math.sin(2 * math.pi * i / count)) for i in range(count)]


def wave(x0, x1, y, height, count, phase=0.0):
    return [(x0 + (x1 - x0) * i / (count - 1), y + height * math.sin(phase + 1.1 * i)) for i in range(count)]


# name: (closed, points)
DRAWINGS = {
    "guitar": {
        "body": (True, [(180, 350), (210, 230), (310, 190), (400, 230), (470, 245), (550, 205), (620, 230), (650, 350), (620, 470), (550, 495), (470, 455), (400, 470), (310, 510), (210, 470)]),
        "hole": (True, ring(500, 350, 52, 52)),
        "neck-top": (False, [(652, 322), (740, 324), (830, 326), (930, 328)]),
        "neck-bottom": (False, [(652, 378), (740, 376), (830, 374), (930, 372)]),
        "bridge": (False, [(300, 290), (296, 330), (296, 370), (300, 410)]),
        "guard": (False, [(390, 300), (400, 380), (440, 428), (510, 436)]),
        "strap": (False, [(150, 90), (260, 120), (380, 70), (520, 60), (660, 110), (800, 90)]),
    },
    "fish": {
        "back": (False, [(130, 360), (220, 280), (350, 220), (500, 205), (640, 250), (760, 330)]),
        "belly": (False, [(130, 360), (220, 425), (350, 470), (500, 470), (640, 420), (760, 330)]),
        "tail-top": (False, [(760, 330), (810, 270), (870, 225), (930, 200)]),
        "tail-bottom": (False, [(760, 330), (815, 385), (870, 430), (925, 470)]),
        "fin": (False, [(430, 120), (480, 90), (550, 85), (610, 125)]),
        "eye": (True, ring(225, 335, 17, 17)),
        "gill": (False, [(310, 300), (330, 335), (330, 370), (308, 405)]),
        "water": (False, wave(90, 920, 600, 14, 15)),
    },
    "vase": {
        "left": (False, [(395, 90), (380, 160), (330, 240), (290, 340), (300, 450), (350, 550), (385, 620)]),
        "right": (False, [(605, 90), (620, 160), (670, 240), (710, 340), (700, 450), (650, 550), (615, 620)]),
        "rim": (True, ring(500, 88, 90, 20)),
        "foot": (False, [(360, 640), (430, 652), (500, 656), (570, 652), (640, 640)]),
        "band-1": (False, [(345, 330), (420, 345), (500, 350), (580, 345), (655, 330)]),
        "band-2": (False, [(342, 354), (420, 369), (500, 374), (580, 369), (658, 354)]),
        "band-3": (False, [(342, 378), (420, 393), (500, 398), (580, 393), (658, 378)]),
        "stem": (False, [(800, 620), (810, 500), (790, 380), (830, 250), (880, 150)]),
        "branch": (False, [(130, 620), (170, 480), (140, 350), (160, 220), (120, 110)]),
    },
    "coast": {
        "shore": (False, [(60, 520), (150, 470), (230, 500), (310, 440), (400, 455), (480, 390), (570, 420), (660, 350), (760, 370), (860, 300), (950, 310)]),
        "river": (False, [(400, 455), (420, 540), (390, 610), (430, 680)]),
        "ring-1": (True, ring(280, 200, 150, 110, 12)),
        "ring-2": (True, ring(280, 200, 112, 78, 12)),
        "ring-3": (True, ring(280, 200, 74, 46, 10)),
        "road": (False, [(520, 90), (600, 140), (690, 120), (780, 170), (890, 150)]),
        "pier": (False, [(640, 560), (720, 590), (800, 580), (880, 610)]),
    },
    "broken": {
        "part-a": (False, [(80, 120), (180, 90), (280, 95), (370, 125)]),
        "part-b": (False, [(450, 160), (550, 190), (650, 180), (740, 140)]),
        "part-c": (False, [(90, 300), (200, 320), (320, 290)]),
        "part-d": (False, [(375, 270), (480, 240), (600, 260), (700, 310)]),
        "part-e": (False, [(740, 330), (800, 355), (900, 350)]),
        "bay": (False, arc(200, 520, 105, 95, 35, 325, 11)),
        "cup": (False, [(420, 430), (410, 530), (470, 600), (560, 600), (620, 530), (610, 430)]),
        "link-1": (False, [(690, 600), (740, 560), (790, 560)]),
        "link-2": (False, [(790, 560), (830, 562), (870, 580)]),
        "link-3": (False, [(870, 580), (905, 600), (950, 600)]),
        "bow": (False, arc(850, 180, 90, 75, 200, 400, 9)),
    },
    "letters": {
        "rule-1": (False, [(60, 180), (360, 180), (660, 180), (940, 180)]),
        "rule-2": (False, [(60, 300), (360, 300), (660, 300), (940, 300)]),
        "rule-3": (False, [(60, 420), (360, 420), (660, 420), (940, 420)]),
        "bowl": (True, ring(820, 560, 75, 85, 12)),
        "ess": (False, [(330, 500), (280, 480), (235, 510), (260, 560), (315, 580), (335, 625), (290, 660), (230, 640)]),
        "hook": (False, [(500, 490), (500, 560), (505, 620), (545, 655), (600, 640)]),
    },
}


# Held back from the first families; other hands draw on these.
OTHERS = {
    "chair": {
        "seat": (False, [(300, 400), (400, 388), (520, 388), (640, 402)]),
        "front-leg": (False, [(300, 400), (292, 480), (284, 570), (276, 660)]),
        "back-leg": (False, [(640, 402), (650, 490), (664, 580), (682, 662)]),
        "back": (False, [(640, 402), (662, 310), (690, 200), (700, 90)]),
        "spindle": (False, [(560, 360), (580, 280), (604, 190), (616, 110)]),
        "cushion": (True, ring(430, 340, 110, 22)),
        "rug": (True, ring(480, 672, 330, 20, 12)),
        "lamp": (False, [(110, 640), (120, 480), (108, 320), (150, 190), (240, 130)]),
        "cord": (False, [(780, 560), (830, 520), (860, 570), (910, 540), (950, 580)]),
    },
    "leaf": {
        "upper": (False, [(120, 420), (230, 270), (400, 190), (580, 200), (740, 290), (860, 420)]),
        "lower": (False, [(120, 420), (240, 520), (420, 570), (600, 550), (750, 490), (860, 420)]),
        "rib": (False, [(170, 420), (340, 400), (520, 390), (700, 400), (820, 416)]),
        "vein-1": (False, [(330, 360), (370, 310), (400, 250)]),
        "vein-2": (False, [(520, 350), (560, 300), (590, 240)]),
        "vein-3": (False, [(430, 450), (470, 490), (490, 530)]),
        "drop": (True, ring(660, 470, 24, 24)),
        "stalk": (False, [(60, 640), (70, 560), (50, 480), (66, 400)]),
        "breeze": (False, wave(260, 900, 90, 16, 11)),
    },
}


def beziers(points, closed):
    """Cubics of a spline through the points; its ends bend roughly like the circle through the last three points."""
    n = len(points)
    out = []
    for i in range(n if closed else n - 1):
        p = [points[(i + k) % n] if closed or 0 <= i + k < n else None for k in (-1, 0, 1, 2)]
        if p[0] is None:
            p[0] = tuple(2 * a - b for a, b in zip(p[1], p[2]))
        if p[3] is None:
            p[3] = tuple(2 * a - b for a, b in zip(p[2], p[1]))
        d = [math.dist(p[k], p[k + 1]) ** 0.5 for k in range(3)]
        m1 = [(p[2][k] - p[1][k] + d[1] * ((p[1][k] - p[0][k]) / d[0] - (p[2][k] - p[0][k]) / (d[0] + d[1]))) for k in (0, 1)]
        m2 = [(p[2][k] - p[1][k] + d[1] * ((p[3][k] - p[2][k]) / d[2] - (p[3][k] - p[1][k]) / (d[1] + d[2]))) for k in (0, 1)]
        out.append((p[1], tuple(p[1][k] + m1[k] / 3 for k in (0, 1)), tuple(p[2][k] - m2[k] / 3 for k in (0, 1)), p[2]))
    return [tuple(tuple(round(x, 2) for x in q) for q in b) for b in out]


def svg(curves):
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" fill="none" stroke="#22262b" stroke-width="2">' % (*SIZE, *SIZE)]
    for name, (closed, points) in curves.items():
        parts = beziers(points, closed)
        d = "M%g %g" % parts[0][0] + "".join("C%g %g %g %g %g %g" % (*b[1], *b[2], *b[3]) for b in parts) + ("Z" if closed else "")
        lines.append(f'  <path id="{name}" d="{d}"/>')
    return "\n".join(lines) + "\n</svg>\n"


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    for name, curves in [*DRAWINGS.items(), *OTHERS.items()]:
        (folder / f"{name}.svg").write_text(svg(curves))
