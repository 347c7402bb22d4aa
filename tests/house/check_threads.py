#!/usr/bin/env python3
"""tests/threads makes every public call that takes an object as const on many threads at once: base.h promises it.

Usage: check_threads.py ROOT
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
headers = "\n".join(path.read_text() for path in sorted((root / "include/batten").glob("*.h")))
opaque = set(re.findall(r"typedef struct (bat_\w+) \1;", headers)) - set(re.findall(r"typedef struct (bat_\w+) \{", headers))
kinds = "|".join(sorted(opaque))
calls = re.findall(r"BAT_API([^;]*?)\b(bat_\w+)\(([^;]*)\);", headers)
wanted = {name for _, name, takes in calls if re.search(rf"const ({kinds}) \*", takes)}
tests = "\n".join(path.read_text() for path in (root / "tests/threads").glob("*.c"))
missing = sorted(name for name in wanted if not re.search(rf"\b{name}\(", tests))
for name in missing:
    print(f"tests/threads: does not call {name}, which takes its object as const")
print(f"{len(wanted)} calls")
sys.exit(len(wanted) < 100 or bool(missing))
