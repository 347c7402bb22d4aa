#!/usr/bin/env python3
"""How much heavier SVG files of others become when one point of one curve is moved and they are saved. Of every file: its size
then as a share of its size now, and whether it is within the bound for tiny files (400 bytes, and 60 for each knot of the curve).
Of all: the share in the middle, the least of the worst tenth, and how many are beyond both the share and that bound.

Usage: weight.py BATTEN [--seed N] [--count N] [--least SHARE] FILE|FOLDER ...
"""
import argparse
import json
import pathlib
import random
import statistics
import subprocess
import tempfile

from nudge import is_drawing, nudge

MIDDLE, TENTH = 1.15, 1.6  # the most that shares may be
BY = 0.03                  # how far the point is moved: of the curve's larger side
FREE, KNOT = 400, 60       # bytes that weigh nothing: of a file, and of each knot


def changed_knots(before, after):
    """Of all curves that differ."""
    return sum(len(new["knots"]) for one, other in zip(before["objects"], after["objects"])
               for old, new in zip(one.get("curves", ()), other.get("curves", ())) if old != new)


def weigh(batten, path, seed):
    """(share, bytes, bytes that are free), or None where there is no curve to edit, or no file is read."""
    def run(*words):
        return subprocess.run([batten, "convert", *map(str, words)], capture_output=True, check=False, timeout=120).returncode == 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        file, kept, moved, saved = (folder / one for one in ("file.svg", "kept.batten", "moved.batten", "saved.svg"))
        file.write_bytes(path.read_bytes())
        if not run(file, kept):
            return None
        text = kept.read_bytes()
        drawing, before = (json.loads(text, parse_int=lambda word: -0.0 if word == "-0" else int(word)) for _ in range(2))
        if "source" not in drawing or not nudge(drawing, random.Random(f"{seed} {path.name}"), BY):
            return None
        moved.write_text(json.dumps(drawing))
        if not run(moved, saved):
            raise RuntimeError(f"{path}: not saved")
        size, more = file.stat().st_size, saved.stat().st_size - file.stat().st_size
        return (size + more) / size, more, FREE + KNOT * changed_knots(before, drawing)


def measure(batten, paths, seed=1):
    """[(share, more, free, path)], the heaviest last."""
    done = [(weigh(batten, path, seed), path) for path in paths]
    return sorted((*one, path) for one, path in done if one)


def sums(done):
    """The share in the middle, that at which the worst tenth begins, and the files that are too heavy, and not tiny. What a tiny file
    may weigh counts as nothing."""
    shares = sorted(1.0 if more <= free else share for share, more, free, _ in done)
    return statistics.median(shares), shares[min(len(shares) - 1, (9 * len(shares)) // 10)], shares


def list_files(names, count, seed):
    paths = []
    for name in map(pathlib.Path, names):
        paths += sorted(name.rglob("*.svg")) if name.is_dir() else [name]
    paths = [path for path in dict.fromkeys(path.resolve() for path in paths) if is_drawing(path)]
    random.Random(seed).shuffle(paths)
    return paths[:count]


def main():
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reader.add_argument("batten")
    reader.add_argument("files", nargs="+")
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--count", type=int, default=200)
    reader.add_argument("--least", type=float, default=TENTH, help="files that become so much heavier are listed")
    given = reader.parse_args()
    done = measure(given.batten, list_files(given.files, given.count, given.seed), given.seed)
    for share, more, free, path in done:
        if share >= given.least:
            print(f"{share:8.2f} {more:+9d} bytes, {free:7d} free  {path}")
    plain = [share for share, *_ in done]
    middle, tenth, _ = sums(done)
    print(f"{len(done)} files: {statistics.median(plain):.3f} times in the middle, {plain[(9 * len(plain)) // 10]:.2f} in the worst "
          f"tenth; without what tiny files may weigh {middle:.3f} and {tenth:.2f}")


if __name__ == "__main__":
    main()
