#!/usr/bin/env python3
"""Every public call that takes an index is tried with one that does not exist, by tests/document/test_no_such.c.

A whole number in a public header is an index or is not, as the two lists below say; a name that stands in neither is an
error, so that a new call does not go unnoticed.

Usage: check_indices.py ROOT
"""
import pathlib
import re
import sys

INDICES = set("angle curve done first frame i index joint key level picture point reading segment".split())
OTHERS = set("axis coarsest continuity degree dimension frames levels modifiers order per_span room segments size steps "
             "times".split())  # and all that end in count or size
TEST = "tests/document/test_no_such.c"

root = pathlib.Path(sys.argv[1])
tried = set(re.findall(r"\b(bat_\w+)\(", (root / TEST).read_text()))
indexed, wrong = set(), 0
for path in sorted((root / "include/batten").glob("*.h")):
    text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
    for call, arguments in re.findall(r"BAT_API\s[^;{]*?\b(bat_\w+)\(([^;]*?)\)\s*;", text):
        for name in re.findall(r"(?:^|,)\s*(?:int|unsigned|long|size_t|u?int(?:8|16|32)_t)\s+(\w+)\s*(?=,|$)", arguments):
            if name in INDICES:
                indexed.add(call)
            elif name not in OTHERS and not re.search(r"(?:^|_)(?:count|size)$", name):
                print(f"{path.name}: {call}: is '{name}' an index? Say so in check_indices.py")
                wrong += 1
for call in sorted(indexed - tried):
    print(f"{call} takes an index: {TEST} does not try one that does not exist")
print(f"{len(indexed)} public calls take an index, {len(indexed - tried)} of them are not tried")
sys.exit(len(indexed) < 50 or wrong > 0 or bool(indexed - tried))
