#!/usr/bin/python3
"""Both journals end within a pixel of the silhouette, and docs/user-test.md has the table: check.py PROGRAM [--write]"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from measure import row, table  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent.parent / "docs" / "user-test.md"
journals = [HERE / "sketch.journal", HERE / "points.journal"]
missed = [j.name for j in journals if not row(sys.argv[1], j)["greatest error, px"] <= 1]
made = re.sub(r"(<!-- table -->\n).*?(<!-- end -->)", lambda m: f"{m[1]}\n{table(sys.argv[1], journals)}\n\n{m[2]}",
              PAGE.read_text(), flags=re.S)
if "--write" in sys.argv:
    PAGE.write_text(made)
stale = made != PAGE.read_text()
for fault in [f"{name}: over a pixel off" for name in missed] + [f"{PAGE.name}: the table differs"] * stale:
    print(fault)
sys.exit(bool(missed or stale))
