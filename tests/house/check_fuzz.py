#!/usr/bin/env python3
"""Every public name is called by a fuzz target, or by a header of tests/support that one includes.

Usage: check_fuzz.py ROOT
"""
import pathlib
import re
import sys

# Not called, with the reason.
EXCEPT = {
    "bat_version": "gives a constant",
    "bat_svg_read": "expat, which has fuzzers of its own, and the reader that fuzz_svg feeds",
}

root = pathlib.Path(sys.argv[1])
headers = "\n".join(path.read_text() for path in sorted((root / "include/batten").glob("*.h")))
names = set(re.findall(r"BAT_API[^;]*?\b(bat_\w+)\(", headers))
texts, waiting = {}, sorted((root / "fuzz").glob("fuzz_*.c"))
while waiting:
    path = waiting.pop()
    if path in texts:
        continue
    texts[path] = path.read_text()
    waiting += [root / "tests" / name for name in re.findall(r'#include "(support/[^"]+)"', texts[path])]
called = "\n".join(texts.values())
missing = sorted(name for name in names if name not in EXCEPT and not re.search(rf"\b{name}\(", called))
for name in missing:
    print(f"fuzz: no target calls {name}")
stale = sorted(name for name in EXCEPT if name not in names or re.search(rf"\b{name}\(", called))
for name in stale:
    print(f"check_fuzz.py: {name} is no exception any more")
print(f"{len(names)} public names, {len(missing)} called by no target")
sys.exit(len(names) < 200 or bool(missing) or bool(stale))
