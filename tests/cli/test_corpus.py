#!/usr/bin/env python3
# label: all (sixty files of other programs, rendered and edited)
"""Files of other programs, opened and saved again (tests/pictures/again.py): all those in tests/pictures/programs, which are
written as Illustrator, Figma, Inkscape, matplotlib, d3, Graphviz and LibreOffice write them, and of the icons of the machine as
many different ones, spread over all. How many are good may only grow."""
import os
import pathlib
import shutil
import sys

try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit(77)
if not shutil.which("rsvg-convert"):
    sys.exit(77)
from program import ONE_IN  # noqa: E402

PICTURES = pathlib.Path(__file__).resolve().parent.parent / "pictures"
sys.path.insert(0, str(PICTURES))
from again import all_again  # noqa: E402
from compare import files  # noqa: E402

# A folder, how many of its files are tried, and how many of these may differ in their picture; in what is kept none may.
# d3's axes ask for crisp edges, which cairo does not draw.
CORPORA = [(PICTURES / "programs", 7, 1), (pathlib.Path("/usr/share/icons/Tango/scalable"), 30, 0),
           (pathlib.Path("/usr/share/icons/Adwaita/scalable"), 23, 0)]


def spread(paths, count):
    paths = list(paths)
    return [paths[i * len(paths) // count] for i in range(count)] if len(paths) > count else paths


def main():
    failed = False
    for folder, count, differ in CORPORA:
        done = all_again(os.environ["BATTEN"], spread(files([folder]), -(-count // ONE_IN)))
        bad = [(path, wrong) for path, wrong in done if wrong]
        for path, wrong in bad:
            print(f"{', '.join(wrong):20} {path}")
        lost = [path for path, wrong in bad if set(wrong) - {"picture"}]
        print(f"{folder}: {len(done) - len(bad)} of {len(done)}")
        failed = failed or not done or lost or len(bad) > differ
    sys.exit(1 if failed else 0)


main()
