#!/usr/bin/env python3
"""Do strokes do what was meant? Runs the gestures of starter/ and those written by families.py through the engine.

Exit status 0 when 98 % of all gestures pass, and 80 % in each category of five or more; and when, in 97 %, what is shown while
the pen is down never goes back to what was shown before.
"""
import argparse
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import score as s

BAR, EACH, STEADY = 0.99, 0.8, 0.97
MARKS = ("<!-- confusion: begin -->", "<!-- confusion: end -->")


def written():
    """A folder with the gestures that families.py writes."""
    folder = tempfile.TemporaryDirectory(prefix="gestures-")
    os.mkdir(os.path.join(folder.name, "drawings"))
    subprocess.run([sys.executable, "-B", os.path.join(HERE, "draw.py"), os.path.join(folder.name, "drawings")], check=True)
    with open(os.path.join(folder.name, "gestures.json"), "w") as f:
        subprocess.run([sys.executable, "-B", os.path.join(HERE, "families.py"), folder.name], stdout=f, check=True)
    return folder


def confusion(rows):
    """The confusion matrix as Markdown: meant in rows, done in columns."""
    cells = {}
    for g, ok, why, got, raw, done, cut, *_ in rows:
        meant = s.kind_meant(g)
        if ok and done != meant:  # one of several acceptable outcomes
            done = meant
        cells[meant, done] = cells.get((meant, done), 0) + 1
    kinds = [k for k in s.MEANINGS if any(k in pair for pair in cells)]
    lines = ["| meant | " + " | ".join(kinds) + " | cut off by mistake | as meant |", "|---" * (len(kinds) + 3) + "|"]
    for a in kinds:
        own = [r for r in rows if s.kind_meant(r[0]) == a]
        if own:
            lines.append(f"| {a} | " + " | ".join(str(cells.get((a, b), ".")) for b in kinds) +
                         f" | {sum(r[6] for r in own) or '.'} | {sum(r[1] for r in own)} of {len(own)} |")
    return "\n".join(lines)


def put_table(path, text):
    with open(path) as f:
        old = f.read()
    first, last = (old.index(m) for m in MARKS)
    with open(path, "w") as f:
        f.write(old[:first] + MARKS[0] + "\n" + text + "\n" + old[last:])


def asked():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("host", help="the program made of host.c, for example build/dev/tests/gesture_host")
    parser.add_argument("word", nargs="?", help="an id or a part of a category: these alone")
    parser.add_argument("-v", action="count", default=0, help="those that do not hold, and why; -vv: all")
    parser.add_argument("--table", metavar="FILE", help="write the confusion table between the marks of this file")
    arguments = parser.parse_args()
    if not os.access(arguments.host, os.X_OK):
        parser.error(f"{arguments.host}: no such program; cmake --build --preset dev makes build/dev/tests/gesture_host")
    return arguments


def main():
    arguments = asked()
    rows = []
    with written() as own:
        for title, folder in (("starter set", os.path.join(HERE, "starter")), ("families", own)):
            part = s.score(arguments.host, folder, arguments.word)
            print(title)
            good, total = s.table(part, arguments.v)
            print(f"  {good} of {total}")
            rows += part
    good, low = sum(r[1] for r in rows), []
    for category in sorted({r[0]["category"] for r in rows}):
        own = [r[1] for r in rows if r[0]["category"] == category]
        if len(own) >= 5 and sum(own) < EACH * len(own):
            low.append(category)
    text = confusion(rows)
    print(text)
    if arguments.table:
        put_table(arguments.table, text)
    print(f"{good} of {len(rows)} gestures do what is meant, {100 * good / max(1, len(rows)):.1f} %")
    steady = sum(not r[7] for r in rows)
    print(f"{steady} of {len(rows)} are never shown as what they had ceased to be shown as")
    if low:
        print("too few of: " + ", ".join(low))
    return 0 if rows and good >= BAR * len(rows) and steady >= STEADY * len(rows) and not low else 1


if __name__ == "__main__":
    sys.exit(main())
