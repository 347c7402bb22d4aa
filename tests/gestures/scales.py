#!/usr/bin/env python3
"""Does the same thing drawn smaller or larger mean the same? Every gesture again with view, zoom and all samples so many times as
large: the same curves change, in the same way.

Exit status 0 when the host answers each time and at each size as many agree with size 1 as in AGREE: the counts only grow. Of a
part of the gestures the counts are not judged.
"""
import argparse
import concurrent.futures
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import run
import score as s

SIZES = (0.5, 2)
AGREE = {0.5: 574, 2: 573}  # of 582


def scaled(line, k):
    """The order to the host with all pixels k times as large; palms too."""
    words = line.split()
    if words[:1] == ["p"]:
        words[6:8] = ["%.4f" % (k * float(x)) for x in words[6:8]]
    elif words[:1] == ["size"]:
        words[1:3] = ["%g" % (k * float(x)) for x in words[1:3]]
    elif words[:1] == ["view"]:
        words[1] = "%.9g" % (k * float(words[1]))
    return " ".join(words)


def meaning(g, host, folder, k):
    """What became of the curves; names and kinds, no lengths."""
    text = "\n".join(scaled(line, k) for line in s.script(g, folder).splitlines()) + "\n"
    raw = s.ask(host, text)
    if "fault" in raw:
        return raw["fault"]
    r = s.Result(g, raw)
    return s.kind_done(g, raw), sorted(r.changed), sorted(r.removed), len(r.added), [r.closed_after[n] for n in sorted(r.changed)]


def meanings(work):
    g, host, folder, sizes = work
    return [meaning(g, host, folder, k) for k in sizes]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="the program made of host.c, for example build/dev/tests/gesture_host")
    parser.add_argument("word", nargs="?", help="an id or a part of a category: these alone")
    parser.add_argument("-v", action="store_true", help="those that mean something else")
    parser.add_argument("--sizes", type=float, nargs="+", default=SIZES)
    parser.add_argument("--every", type=int, default=1, help="one gesture in so many, for a slow host")
    a = parser.parse_args()
    agree, count, silent = dict.fromkeys(a.sizes, 0), 0, 0
    with run.written() as own, concurrent.futures.ProcessPoolExecutor() as pool:
        jobs = [(g, a.host, folder, (1, *a.sizes)) for folder in (os.path.join(HERE, "starter"), own)
                for g in s.read(folder) if not a.word or a.word in g["id"] or a.word in g["category"]][::a.every]
        for (g, *_), found in zip(jobs, pool.map(meanings, jobs, chunksize=2)):
            count += 1
            silent += any(isinstance(what, str) for what in found)
            for k, other in zip(a.sizes, found[1:]):
                agree[k] += other == found[0]
                if a.v and other != found[0]:
                    print(f"  {g['id']:6} {g['category']:28} {g['drawing']:14} at {k:g}: {other}, at 1: {found[0]}")
    for k, n in agree.items():
        print(f"{k:g} times the size: {n} of {count} mean the same, {100 * n / max(1, count):.1f} %")
    part = a.word or a.every > 1
    return 0 if not silent and (part or all(n >= AGREE.get(k, 0) for k, n in agree.items())) else 1


if __name__ == "__main__":
    sys.exit(main())
