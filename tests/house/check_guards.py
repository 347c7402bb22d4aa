#!/usr/bin/env python3
"""Every header of the project has an include guard, named BATTEN_..._<FILE>_H, that no other header shares.

Usage: check_guards.py ROOT
"""
import pathlib
import re
import sys

from sources import sources

root = pathlib.Path(sys.argv[1])
folders = ("include", "src", "apps", "web/module", "tests", "fuzz", "bench", "examples")
headers = sources(root, folders, (".h",))
faults, owners = [], {}
for path in headers:
    place = path.relative_to(root)
    text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S).strip()
    found = re.match(r"#ifndef (\w+)\n#define (\w+)\n", text)
    if not found or found[1] != found[2] or not text.endswith("#endif"):
        faults.append(f"{place}: no include guard around the whole")
        continue
    stem = re.sub(r"\W", "_", path.stem).upper()
    if not re.fullmatch(rf"BATTEN_(\w+_)?{stem}_H", found[1]):
        faults.append(f"{place}: guard {found[1]}, expected BATTEN_..._{stem}_H")
    if found[1] in owners:
        faults.append(f"{place}: guard {found[1]} is also that of {owners[found[1]]}")
    owners[found[1]] = place
print("\n".join(faults))
print(f"{len(headers)} headers read, {len(faults)} faults")
sys.exit(1 if faults or not headers else 0)
