#!/usr/bin/env python3
"""Nothing goes out untested: the workflow for pull requests runs every part of ./test all, and the site waits for it.

Usage: check_workflows.py ROOT
"""
import importlib.util
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
given = importlib.util.spec_from_file_location("run", ROOT / "tests/run.py")
run = importlib.util.module_from_spec(given)
given.loader.exec_module(run)

test = (ROOT / ".github/workflows/test.yml").read_text()
pages = (ROOT / ".github/workflows/pages.yml").read_text()
faults = []
parts = re.search(r"part: \[([^\]]*)\]", test)
if not parts or parts[1].split(", ") != list(run.PARTS):
    faults.append(f"test.yml: the parts are not {', '.join(run.PARTS)}")
if "./test all ${{ matrix.part }}" not in test or not re.search(r"^  pull_request:$", test, re.M):
    faults.append("test.yml: does not run ./test all for pull requests")
# Jobs stand at two blanks; each that publishes needs the tests.
jobs = re.split(r"^  (?=\w+:$)", pages.split("\njobs:\n")[1], flags=re.M)[1:]
if not any("uses: ./.github/workflows/test.yml" in job and job.startswith("test:") for job in jobs):
    faults.append("pages.yml: does not run the tests")
for job in jobs:
    if "deploy" in job and not re.search(r"^    needs: test$", job, re.M):
        faults.append(f"pages.yml: {job.split(':')[0]} does not wait for the tests")
if not any("deploy" in job for job in jobs):
    faults.append("pages.yml: nothing is published")
print(*faults, sep="\n")
sys.exit(1 if faults else 0)
