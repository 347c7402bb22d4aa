#!/usr/bin/env python3
"""Bold redraws: humps over the roof of examples/car.svg, 60 to 130 px high, end to end, from inside and from near the ends, by a
calm and a shaking hand. What leaves the roof at both ends by at most 35 degrees changes the roof alone; steeper ones, from 60
degrees on, are new lines; and while both ends lie on the roof it can always be redrawn.

Exit status 0 when as many as in BOLD, STEEP and OFFERED do: the counts only grow.
"""
import argparse
import concurrent.futures
import math
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import score as s
from stroke import Along

CAR = os.path.join(HERE, "..", "..", "examples", "car.svg")
CENTRE = [500, 210]
SPANS = {"end to end": (0, 1), "from inside": (0.14, 0.84), "near the ends": (0.03, 0.98)}
HANDS = {"calm": {"speed": 500, "tremor": 0.25, "drift": 0.4, "hook": 2.5},
         "shaking": {"speed": 420, "tremor": 0.9, "drift": 1.2, "noise": 0.3, "hook": 4.5}}
BOLD, STEEP, OFFERED = 156, 16, 208


def roof():
    with open(CAR) as f:
        path = re.search(r'id="roof" d="M([^"]*)"', f.read()).group(1)
    numbers = [float(x) for x in re.findall(r"-?[0-9.]+", path)]
    points = [numbers[i:i + 2] for i in range(0, len(numbers), 2)]
    places = []
    for k in range(0, len(points) - 1, 3):
        b = points[k:k + 4]
        places += [[sum(w * q[c] for w, q in zip(((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3), b)) for c in (0, 1)]
                   for t in (i / 40 for i in range(40))]
    return Along(places + [points[-1]])


def swing(f, flat, top):
    """A sine's hump with its top at this share; flat: it leaves at a smaller angle and is steeper further on."""
    f = f ** (math.log(0.5) / math.log(top))
    return (1 - flat) * math.sin(math.pi * f) + flat * math.sin(math.pi * f) ** 2


def beside(line, s, off):
    """Off the line by so much, to its left as it is seen."""
    p, q = line.at(s - 0.02 * line.length), line.at(s + 0.02 * line.length)
    d, x = math.dist(p, q), line.at(s)
    return [x[0] + off * (q[1] - p[1]) / d, x[1] - off * (q[0] - p[0]) / d]


def hump(line, span, height, flat=0, top=0.5):
    """Points beside the line, and the steeper of the angles in degrees at which they leave it, over a twentieth."""
    low, high = (line.length * x for x in span)
    points = [beside(line, low + (high - low) * i / 40, height * swing(i / 40, flat, top)) for i in range(41)]
    rise = max(swing(f, flat, top) for f in (0.05, 0.95))
    return points, math.degrees(math.atan2(rise * height, 0.05 * (high - low)))


def gestures():
    line, out = roof(), []
    for name, span in SPANS.items():
        for hand, how in HANDS.items():
            for flat, top in ((0, 0.5), (0.8, 0.5), (0.4, 0.42), (0.4, 0.58)):
                for height in range(60, 131, 10):
                    zoom = 1.5 if height % 20 else 1
                    points, angle = hump(line, span, height / zoom, flat, top)
                    out.append(gesture(out, f"{name}, {hand}", points[::-1] if len(out) % 2 else points, how, zoom, angle))
    for hand, how in HANDS.items():
        for height in range(60, 131, 10):
            points, angle = hump(line, (0.4, 0.4 + 0.5 * height / line.length), height)
            out.append(gesture(out, f"an ear, {hand}", points, how, 1, angle))
    return out


def gesture(before, category, points, hand, zoom, angle):
    return {"id": f"h{len(before):03}", "category": category, "drawing": CAR, "angle": angle,
            "view": {"size": [1280, 752], "zoom": zoom, "centre": CENTRE},
            "stroke": {"path": [[round(x, 2) for x in p] for p in points], "seed": 5000 + len(before), "hand": hand},
            "expect": [{"redraws": ["roof"]}]}


def judge(work):
    host, g = work
    raw = s.play(host, g, HERE)
    if "fault" in raw:
        return g, raw["fault"], False
    r = s.Result(g, raw)
    done = s.kind_done(g, raw), sorted(r.changed)
    words = [w.lower() for w in (raw["readings"] or {}).get("words") or []]
    return g, done, done == ("redraw", ["roof"]) or any("redraw" in w for w in words)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="the program made of host.c, for example build/dev/tests/gesture_host")
    parser.add_argument("-v", action="store_true", help="those that mean something else")
    a = parser.parse_args()
    good, total, offered = {"bold": 0, "steep": 0}, {"bold": 0, "steep": 0}, 0
    with concurrent.futures.ProcessPoolExecutor() as pool:
        rows = list(pool.map(judge, [(a.host, g) for g in gestures()], chunksize=4))
    for g, done, offers in rows:
        kind = "bold" if g["angle"] <= 35 else "steep" if g["angle"] >= 60 else None
        right = done == ("redraw", ["roof"]) if kind == "bold" else done == ("new", [])
        offered += offers
        if kind:
            good[kind] += right
            total[kind] += 1
        if a.v and (not offers or (kind and not right)):
            print(f"  {g['id']} {g['category']:24} {g['angle']:4.0f} degrees: {done}{'' if offers else ', no redraw offered'}")
    print(f"{good['bold']} of {total['bold']} humps redraw the roof alone; {good['steep']} of {total['steep']} steep ones are new lines; "
          f"in {offered} of {len(rows)} the roof can be redrawn")
    return 0 if good["bold"] >= BOLD and good["steep"] >= STEEP and offered >= OFFERED else 1


if __name__ == "__main__":
    sys.exit(main())
