#!/usr/bin/env python3
"""Hairy sketches: each line is drawn by several careless strokes, and each goes into its own line.

A page is a drawing of lines that start on one another, as a designer finds a shape; a line is drawn by four to seven strokes
that cover a part of it, lie beside it, tilt and bow, forwards or backwards. A stroke goes into its own line when it changes that
line alone. Exit status 0 when as many do as in OWN: the count only grows.
"""
import argparse
import concurrent.futures
import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "gestures"))
import stroke as hands

PAGES, OWN = 20, 439
ROOM = (1280, 752)


def line(r, lines):
    """A sweep with a wave or two; every other one starts on an older one."""
    for _ in range(1000):
        length, way = r.between(60, 520), r.between(0, 2 * math.pi)
        at = [r.between(120, ROOM[0] - 120), r.between(120, ROOM[1] - 120)]
        if lines and r.u() < 0.5:
            old = hands.Along(r.pick(lines))
            at = old.at(r.u() * old.length)
        bow, wave = r.between(-0.25, 0.25), r.between(-0.06, 0.06)
        places = []
        for i in range(9):
            f = i / 8
            off = length * (bow * 4 * f * (1 - f) + wave * math.sin(2 * math.pi * f))
            places.append([at[0] + length * f * math.cos(way) - off * math.sin(way), at[1] + length * f * math.sin(way) + off * math.cos(way)])
        path = hands.smooth(places, 1)
        inside = all(40 < p[0] < ROOM[0] - 40 and 40 < p[1] < ROOM[1] - 40 for p in path)
        near = sum(min(math.dist(p, q) for old in lines for q in old[::4]) < 40 for p in path[::8]) if lines else 0
        if inside and near * 8 < 0.4 * len(path):
            return path
    return None


def careless(r, path):
    """A stroke over a part of the path, some hundredths of its length off it."""
    along = hands.Along(path)
    size = along.length
    share = r.between(0.45, 1)
    low = r.between(0, 1 - share)
    off, tilt, bow = (max(1.0, 0.012 * size) * r.n() for _ in range(3))
    out = []
    for i in range(25):
        f = i / 24
        p, q = (along.at(size * (low + share * g)) for g in (f, min(1, f + 0.01) if f < 1 else f - 0.01))
        x, y = (q[0] - p[0], q[1] - p[1]) if f < 1 else (p[0] - q[0], p[1] - q[1])
        d = off + tilt * (f - 0.5) + bow * 2 * f * (1 - f)
        m = math.hypot(x, y) or 1
        out.append([p[0] - d * y / m, p[1] + d * x / m])
    return out[::-1] if r.u() < 0.3 else out


def page(seed):
    """Lines for the host, and which line each stroke belongs to."""
    r = hands.Random(4000 + seed)
    lines, script, owner, now = [], ["size %d %d 1" % ROOM, "view 1 %g %g" % (ROOM[0] / 2, ROOM[1] / 2), "frame", "before"], [], 3000.0
    for number in range(5):
        path = line(r, lines)
        if not path:
            continue
        lines.append(path)
        for k in range(r.pick([4, 5, 6, 7])):
            shown = path if k == 0 else hands.smooth(careless(r, path), 1)
            samples = hands.hand(shown, 100 * seed + len(owner), speed=r.between(300, 900))
            for i, (x, y, t, force) in enumerate(samples):
                script.append(f"p {2 if i else 1} 1 7 1 0 {x:.2f} {y:.2f} {force:.3f} {now + 1000 * t:.2f}")
                if i % 8 == 7:
                    script.append("frame")
            now += 1000 * samples[-1][2] + 8
            script += [f"p 3 1 7 0 0 {samples[-1][0]:.2f} {samples[-1][1]:.2f} 0 {now:.2f}", "frame", "stroke"]
            now += r.between(150, 700)
            owner.append(number)
    return "\n".join(script) + "\n", owner


def judge(job):
    host, seed = job
    script, owner = page(seed)
    done = subprocess.run([host], input=script, capture_output=True, text=True, timeout=300)
    rows = [json.loads(text) for text in done.stdout.splitlines()]
    if done.returncode or len(rows) != len(owner):
        sys.exit(f"page {seed}: the host ended with {done.returncode} after {len(rows)} strokes of {len(owner)}")
    mine, found = {}, []
    for number, row in zip(owner, rows):
        changed, added, removed = row["changed"], row["added"], row["removed"]
        if number not in mine:
            mine[number] = set(added)
            continue
        if not changed and not added and not removed:
            found.append("vanished")
        elif len(changed) == 1 and changed[0] in mine[number] and not added and not removed:
            found.append("own")
        elif added and not changed and not removed:
            found.append("new")
            mine[number] |= set(added)  # a later stroke over this one goes to its line, too
        else:
            found.append("other")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="the program made of tests/gestures/host.c, build/dev/tests/gesture_host")
    a = parser.parse_args()
    with concurrent.futures.ProcessPoolExecutor() as pool:
        found = [kind for part in pool.map(judge, [(a.host, seed) for seed in range(PAGES)]) for kind in part]
    own = found.count("own")
    print(", ".join(f"{kind} {found.count(kind)}" for kind in ("own", "new", "other", "vanished")))
    print(f"{own} of {len(found)} go into their own line, {100 * own / len(found):.1f} %")
    return 0 if own >= OWN and "vanished" not in found else 1


if __name__ == "__main__":
    sys.exit(main())
