#!/usr/bin/env python3
"""Opens SVG files and saves them again: with nothing edited they must be the same bytes, from SVG and by way of the native
format; with one point of one curve moved a little, only the text of its element may differ, and rsvg-convert must show the same
picture; `batten render` must show it, too. Prints each file with what is wrong with it. About a second a file.

Usage: again.py BATTEN FILE_OR_FOLDER ...
"""
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

from compare import SECONDS, SHARE, compare, files
from nudge import MOVED


def convert(batten, *words):
    done = subprocess.run([batten, "convert", *map(str, words)], capture_output=True, timeout=SECONDS, check=False)
    return done.returncode == 0


def nudge(drawing):
    """Moves a point of the middle path that is shown; False: there is none."""
    hidden, paths = set(), []
    for thing in drawing["objects"]:
        if thing.get("hidden") or thing.get("parent") in hidden:
            hidden.add(thing["id"])
        elif thing["kind"] == "path":
            paths.append(thing)
    if not paths:
        return False
    curves = paths[len(paths) // 2]["curves"]
    points = curves[len(curves) // 2]["points"]
    points[len(points) // 2][0] += MOVED * max(max(column) - min(column) for column in zip(*points))
    return True


def tags_between(old, new):
    """How many tags begin in the part of the old text that is not in the new one."""
    least, head, tail = min(len(old), len(new)), 0, 0
    while head < least and old[head] == new[head]:
        head += 1
    while tail < least - head and old[-1 - tail] == new[-1 - tail]:
        tail += 1
    return old[head:len(old) - tail].count(b"<")


def again(batten, path):
    """What is wrong: of "open", "native", "edit", "look", "picture"."""
    text, wrong = path.read_bytes(), []
    with tempfile.TemporaryDirectory() as folder:
        same, kept, moved, edited = (pathlib.Path(folder) / name for name in ("same.svg", "kept.batten", "moved.batten", "edited.svg"))
        if not convert(batten, path, same) or same.read_bytes() != text:
            wrong.append("open")
        if not convert(batten, path, kept) or not convert(batten, kept, same, "--plain") or same.read_bytes() != text:
            return [*wrong, "native"]
        drawing = json.loads(kept.read_bytes())
        if nudge(drawing):
            moved.write_text(json.dumps(drawing))
            if not convert(batten, moved, edited, "--plain") or tags_between(text, edited.read_bytes()) > 2:
                return [*wrong, "edit"]
            if (compare(batten, path, edited) or 0) > SHARE:
                wrong.append("look")
        if (compare(batten, path) or 0) > SHARE:
            wrong.append("picture")
    return wrong


def all_again(batten, paths):
    """Pairs of a path and what is wrong with it."""
    paths = list(paths)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(zip(paths, pool.map(lambda path: again(batten, path), paths)))


def main():
    done = all_again(sys.argv[1], files(sys.argv[2:]))
    for path, wrong in done:
        if wrong:
            print(f"{', '.join(wrong):20} {path}")
    print(f"{sum(not wrong for _, wrong in done)} of {len(done)} files are the same again")


if __name__ == "__main__":
    main()
