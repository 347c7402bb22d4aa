#!/usr/bin/env python3
"""In the sources of the module, formats of snprintf contain only conversions that web/module/print.c supports.

Usage: check_print.py ROOT
"""
import pathlib
import re
import sys

from sources import sources

CALL = re.compile(r"v?snprintf\s*\((.*?)\);", re.S)
TEXT = re.compile(r'"((?:[^"\\]|\\.)*)"')
KNOWN = re.compile(r"%(?:%|0?\d*(?:\.(?:\*|\d+))?(?:s|c|[lz]?[dux]|[efg]))")

root = pathlib.Path(sys.argv[1])
faults, formats = [], 0
for path in sources(root, ["src", "web/module"], (".c",)):
    for call in CALL.finditer(path.read_text(encoding="utf-8")):
        text = "".join(TEXT.findall(call[1]))
        formats += 1
        if "%" in KNOWN.sub("", text):
            faults.append(f"{path.relative_to(root)}: \"{text}\"")
if faults:
    print("\n".join(faults))
    print("The module's snprintf (web/module/print.c) does not know this.")
print(f"{formats} formats read, {len(faults)} faults")
sys.exit(1 if faults or not formats else 0)
