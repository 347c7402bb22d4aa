#!/usr/bin/env python3
"""The library calls only those libm functions whose results IEEE 754 determines; the others differ between libcs in the
last bits, and src/base/real.h replaces them. Nor does it call qsort, whose order of ties differs too, unless the line
states that there are none ("no ties").

Usage: check_real.py ROOT
"""
import pathlib
import re
import sys

from sources import sources

INEXACT = ("hypot sin cos tan asin acos atan atan2 sinh cosh tanh exp exp2 expm1 log log2 log10 log1p pow cbrt "
           "erf tgamma lgamma fma sqrtf powf").split()
CALL = re.compile(r"(?<![\w.>])(" + "|".join(INEXACT) + r"|qsort)\s*\(")

root = pathlib.Path(sys.argv[1])
faults, files = [], 0
for path in sources(root, ["src"], (".c", ".h")):
    files += 1
    text = re.sub(r"/\*.*?\*/", lambda found: re.sub(r"[^\n]", " ", found[0]) if "no ties" not in found[0]
                  else found[0], path.read_text(encoding="utf-8"), flags=re.S)
    for number, line in enumerate(text.splitlines(), 1):
        found = CALL.search(line)
        if found and not (found[1] == "qsort" and "no ties" in line):
            faults.append(f"{path.relative_to(root)}:{number}: {line.strip()}")
if faults:
    print("\n".join(faults))
    print("Call bat_hypot, bat_sin, ... of curve/real.h instead; WASM must give the same bits.")
print(f"{files} files read, {len(faults)} faults")
sys.exit(1 if faults or not files else 0)
