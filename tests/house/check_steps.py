#!/usr/bin/env python3
"""A small change is built in few steps: what a contributor waits for. Counts, in a build tree that is up to date, what ninja
would do after a touch; nothing is compiled.

Usage: check_steps.py ROOT BUILD             counts
       check_steps.py ROOT BUILD --measure   makes each change in earnest (and takes it back), builds, and measures: fails
                                             also when a test program that shows it takes over 8 s of the processor
"""
import os
import pathlib
import re
import resource
import subprocess
import sys

ROOT, BUILD = map(pathlib.Path, sys.argv[1:3])
MEASURE = "--measure" in sys.argv
PROCESSOR = 8  # seconds
PROGRAMS = 40  # that are linked, at most
# (what changes, in which file, how, the most steps to the unit tests, the most steps to everything)
CHANGES = [
    ("a comment in a source", "src/curve/close.c", lambda text: text + "\n/* . */\n", 8, 60),
    ("a word of the interface", "src/editor/tables/strings.def", lambda text: text.replace("Undo", "Undo it", 1), 12, 60),
    ("a type's own header", "include/batten/camera.h", lambda text: text + "\n/* . */\n", 200, 260),
]


def ninja(*words):
    return subprocess.run(["ninja", "-C", str(BUILD), *words], capture_output=True, text=True, check=False)


def plan():
    """The build as a file by which ninja does not look for new sources first, which it can't without doing it."""
    text = re.sub(r"^build [^\n]*: (RERUN_CMAKE|VERIFY_GLOBS)\b.*?\n\n", "", (BUILD / "build.ninja").read_text(encoding="utf-8"),
                  flags=re.S | re.M)
    (BUILD / "steps.ninja").write_text(text, encoding="utf-8")


def steps(*targets):
    """What ninja would do for the targets."""
    said = ninja("-f", "steps.ninja", "-n", *targets)
    if said.returncode:
        sys.exit(said.stdout[-2000:] + said.stderr[-2000:])
    return [line for line in said.stdout.splitlines() if re.match(r"\[\d+/\d+\]", line)]


def count(path):
    """Steps after a touch: to the unit tests, to everything, and how many of all are links of programs."""
    times = os.stat(path)
    try:
        os.utime(path)
        ninja("batten_ids") # which ends there, as long as no id changes
        few, all_ = steps("unit_tests"), steps()
    finally:
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
    return len(few), len(all_), sum("Linking C executable" in line for line in all_)


def processor():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(path, change):
    """Seconds of the processor to the unit tests when the file has changed in earnest."""
    before = path.read_text(encoding="utf-8")
    try:
        path.write_text(change(before), encoding="utf-8")
        begun = processor()
        built = ninja("unit_tests")
        if built.returncode:
            sys.exit(built.stdout[-2000:])
        return processor() - begun
    finally:
        path.write_text(before, encoding="utf-8")
        ninja("unit_tests")


plan()
if steps():
    ninja("all")  # another test has built what this tree is made of
    plan()
if steps():
    sys.exit(f"{BUILD} is not up to date: " + "; ".join(steps()[:5]))
bad = 0
for what, name, change, most_few, most_all in CHANGES:
    few, whole, programs = count(ROOT / name)
    wrong = few > most_few or whole > most_all or programs > PROGRAMS or few == 0
    line = f"{what} ({name}): {few} steps to the unit tests (at most {most_few}), {whole} to everything (at most {most_all}), " \
           f"{programs} programs linked (at most {PROGRAMS})"
    if MEASURE:
        seconds = measure(ROOT / name, change)
        wrong |= seconds > PROCESSOR and most_few < 100
        line += f", {seconds:.1f} s of the processor"
    bad += wrong
    print(("FAIL  " if wrong else "ok    ") + line)
sys.exit(1 if bad else 0)
