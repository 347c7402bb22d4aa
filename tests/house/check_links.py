#!/usr/bin/env python3
"""Every relative link and every path in backticks in the documents exists.

Usage: check_links.py ROOT
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
# Names of files that the reader or a build makes.
NOT_YET = re.compile(r"build/|bug\.journal|trim|scissors|<|\*|drawing\.|corpus")
FOLDERS = "apps|bench|cmake|docs|examples|fuzz|include|src|tests|tools|web"

faults, count = [], 0
for document in [*sorted(ROOT.glob("*.md")), *sorted(ROOT.glob("docs/**/*.md"))]:
    for number, line in enumerate(document.read_text(encoding="utf-8").splitlines(), 1):
        for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", line):
            if re.match(r"[a-z]+:", target):
                continue
            count += 1
            if not (document.parent / target).exists():
                faults.append(f"{document.relative_to(ROOT)}:{number}: {target}")
        for target in re.findall(rf"`((?:{FOLDERS})/[^`\s]+)`", line):
            if NOT_YET.search(target):
                continue
            count += 1
            if not (ROOT / target).exists():
                faults.append(f"{document.relative_to(ROOT)}:{number}: {target}")
print("\n".join(faults))
print(f"{count} links, {len(faults)} lead nowhere")
sys.exit(1 if faults or not count else 0)
