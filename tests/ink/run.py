#!/usr/bin/env python3
"""Real ink through the engine, stroke by stroke, automatic reading on: nearly every stroke of these pages is a new line.

Counts strokes that leave nothing ("vanished"), strokes that change an older line or become a figure ("misread"), and new lines
that begin over 1.5 px from where the pen did ("start moved"). Exit status 0 when no stroke vanished, none waits for a yes, and as
many as in READ and MET are read right and begin where the pen did: these counts only grow.
"""
import argparse
import concurrent.futures
import gzip
import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
DEVICE = {"mouse": 0, "pen": 1, "touch": 2}
WRITING = ("omniglot",)
KINDS = ("new", "redraw", "all strokes", "extend", "join", "close", "figure", "vanished")
READ = {"writing": 49, "drawings": 828}  # of 50 and 853: read as the new lines that they are
MET = {"writing": 49, "drawings": 791}   # of these: begin where the pen did
EVERY = 8                                # --sample: one page in so many
MARKS = ("<!-- ink: begin -->", "<!-- ink: end -->")


def pages(sample):
    with gzip.open(os.path.join(HERE, "pages.jsonl.gz"), "rt") as f:
        return [json.loads(line) for line in f][::EVERY if sample else 1]


def script(page, zoom=1, margin=80, fps=60):
    """Pointer events as the browser's shell sends them, a frame every 60th of a second; where its places are in the document."""
    strokes = page["strokes"]
    xs, ys = [p[0] for s in strokes for p in s], [p[1] for s in strokes for p in s]
    dx, dy = margin - min(xs), margin - min(ys)
    w = max(1280, math.ceil(max(xs) - min(xs) + 2 * margin))
    h = max(752, math.ceil(max(ys) - min(ys) + 2 * margin))
    lines = [f"size {w} {h} 1", f"view {zoom} {w / 2} {h / 2}", "frame", "before"]
    device, base, last, first = DEVICE[page.get("device", "pen")], 5000.0, None, strokes[0][0][2]
    for s in strokes:
        if last is not None and base + s[0][2] - first < last + 30:
            base = last + 30 - s[0][2] + first
        times = [base + p[2] - first for p in s]
        x, y = s[0][0] + dx, s[0][1] + dy
        if device != DEVICE["touch"]:
            lines += [f"p 0 {device} 7 0 0 {x:.2f} {y:.2f} 0 {times[0] - 24 + 8 * k:.3f}" for k in range(3)] + ["frame"]
        lines.append(f"p 1 {device} 7 1 0 {x:.3f} {y:.3f} {s[0][3]:.3f} {times[0]:.3f}")
        due = times[0] + 1000 / fps
        for p, t in zip(s[1:], times[1:]):
            while t > due:
                lines.append("frame")
                due = max(due + 1000 / fps, t - 1000 / fps)
            lines.append(f"p 2 {device} 7 1 0 {p[0] + dx:.3f} {p[1] + dy:.3f} {p[3]:.3f} {t:.3f}")
        last = times[-1] + 4
        lines += ["frame", f"p 3 {device} 7 0 0 {s[-1][0] + dx:.3f} {s[-1][1] + dy:.3f} 0 {last:.3f}", "frame", "stroke"]
    return "\n".join(lines) + "\n", lambda p: [c + (q + d - c) / zoom for q, d, c in zip(p, (dx, dy), (w / 2, h / 2))]


def outcome(r):
    words, chosen = (r["readings"] or {}).get("words") or [], (r["readings"] or {}).get("chosen", 0)
    word = words[chosen] if 0 <= chosen < len(words) else ""
    if r["pending"]:
        return "pending"
    if not r["changed"] and not r["added"] and not r["removed"]:
        return "vanished"
    if r["added"] and not r["changed"] and not r["removed"]:
        return "figure" if word and "New" not in word else "new"
    known = [k for k in KINDS if word.lower().startswith(k)]
    return known[0] if known else "redraw"


def distance(p, a, b):
    vx, vy = b[0] - a[0], b[1] - a[1]
    square = vx * vx + vy * vy
    t = 0 if square == 0 else max(0, min(1, ((p[0] - a[0]) * vx + (p[1] - a[1]) * vy) / square))
    return math.dist(p, (a[0] + t * vx, a[1] + t * vy))


def off(p, curves):
    return min((distance(p, a, b) for c in curves for a, b in zip(c, c[1:] + c[:1])), default=math.inf)


def judge(job):
    host, page, zoom = job
    text, placed = script(page, zoom)
    done = subprocess.run([host], input=text, capture_output=True, text=True, timeout=500)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    if done.returncode or len(rows) != len(page["strokes"]) or any("fault" in r for r in rows):
        sys.exit(f"{page['source']} {page['name']}: the host ended with {done.returncode} after {len(rows)} strokes")
    found = []
    for s, r in zip(page["strokes"], rows):
        kind = outcome(r)
        found.append((kind, kind == "new" and off(placed(s[0]), r["after"]) * zoom > 1.5))
    return found


def row(name, found):
    n, new = len(found), sum(k == "new" for k, _ in found)
    gone, moved = sum(k == "vanished" for k, _ in found), sum(m for _, m in found)
    cells = [str(sum(k == kind for k, _ in found) or ".") for kind in KINDS]
    wrong = n - new - gone
    return (f"| {name} | " + " | ".join(cells) +
            f" | {100 * wrong / max(1, n):.2f} % | {100 * gone / max(1, n):.2f} % | {100 * moved / max(1, new):.1f} % |")


def alike(host, chosen, zoom):
    """Whether each stroke becomes what it becomes at zoom 1."""
    with concurrent.futures.ProcessPoolExecutor() as pool:
        here, there = (list(pool.map(judge, [(host, p, z) for p in chosen])) for z in (1, zoom))
    other = [p["name"] for p, a, b in zip(chosen, here, there) if a != b]
    if other:
        print("read otherwise: " + ", ".join(other))
    return not other


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="the program made of tests/gestures/host.c, build/dev/tests/gesture_host")
    parser.add_argument("--sample", action="store_true", help=f"one page in {EVERY}")
    parser.add_argument("--zoom", type=float, default=1, help="the same ink, in a drawing so many times smaller: it means the same")
    parser.add_argument("-v", action="store_true", help="the strokes that are misread")
    parser.add_argument("--table", metavar="FILE", help="write the table between the marks of this file")
    a = parser.parse_args()
    groups = {"writing": [], "drawings": []}
    chosen = pages(a.sample)
    with concurrent.futures.ProcessPoolExecutor() as pool:
        for page, found in zip(chosen, pool.map(judge, [(a.host, p, a.zoom) for p in chosen])):
            groups["writing" if page["source"] in WRITING else "drawings"] += found
            for i, (kind, _) in enumerate(found):
                if a.v and kind != "new":
                    print(f"  {page['source']} {page['name']} stroke {i}: {kind}")
    lines = ["| new lines | " + " | ".join(KINDS) + " | misread | vanished | start moved |", "|---" * (len(KINDS) + 4) + "|"]
    text = "\n".join(lines + [row(name, found) for name, found in groups.items()])
    print(text)
    good = a.zoom == 1 or alike(a.host, chosen, a.zoom)
    for name, found in groups.items():
        new = sum(k == "new" for k, _ in found)
        met = new - sum(m for _, m in found)
        lost = sum(k in ("vanished", "pending") for k, _ in found)
        print(f"{name}: {new} of {len(found)} are new lines, {met} of them begin where the pen did; {lost} are lost")
        few = not a.sample and (new < READ[name] or met < MET[name])
        good = good and not lost and not few and (not a.sample or new >= 0.9 * len(found))
    if a.table:
        with open(a.table) as f:
            old = f.read()
        first, last = (old.index(m) for m in MARKS)
        with open(a.table, "w") as f:
            f.write(old[:first] + MARKS[0] + "\n" + text + "\n" + old[last:])
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
