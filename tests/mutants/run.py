#!/usr/bin/env python3
"""Plants faults, one at a time, and shows that the tests find them.

Each NAME.patch in this folder changes one line of the sources. Its head says what it breaks:

    Fault: what is wrong now, in words
    Test: the one test that must fail (its name in ctest)
    Tree: the build tree of that test; dev if left out

Usage: run.py [NAME...]       plants all, or those named, in a copy in build/mutants; builds, runs the one test; ends
                              with a table
       run.py --table FILE    the same, and writes the table to FILE
       run.py --check         builds nothing: each patch applies here and names a test of a suite; ./test has most of them
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COPY = ROOT / "build/mutants/tree"
LEAST, LEAST_QUICK = 60, 50  # how many there are, and how many of them ./test finds
HANG = 1200  # seconds: a fault that makes its test hang is found, too


class Mutant:
    """A planted fault: its patch and what the head of the patch says."""

    def __init__(self, path):
        self.path = path
        self.name = path.stem
        text = path.read_text(encoding="utf-8")
        head = dict(re.findall(r"^(Fault|Test|Tree): (.*)$", text.split("\n--- ")[0], re.M))
        self.fault = head.get("Fault", "")
        self.test = head.get("Test", "")
        self.tree = head.get("Tree", "dev")
        self.files = re.findall(r"^\+\+\+ b/(\S+)", text, re.M)
        self.added, self.removed = (len(re.findall(rf"^\{sign}(?!\{sign}\{sign} )", text, re.M)) for sign in "+-")

    def wrong(self):
        """What the patch lacks, or nothing."""
        if not self.fault or not self.test:
            return "no Fault or no Test in its head"
        if len(self.files) != 1 or self.added != 1 or self.removed != 1:
            return "does not replace one line by another"
        return ""


def run(words, **more):
    return subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False, **more)


def tests_of(build):
    """The tests of a build tree: name -> labels."""
    told = run(["ctest", "--test-dir", build, "--show-only=json-v1"])
    if told.returncode:
        return {}
    labels = {}
    for test in json.loads(told.stdout)["tests"]:
        values = [one["value"] for one in test.get("properties", []) if one["name"] == "LABELS"]
        labels[test["name"]] = values[0] if values else []
    return labels


def suite_of(mutant, trees):
    """The smallest suite that holds the mutant's test: "./test", "./test all", or nothing."""
    if mutant.tree not in trees:
        trees[mutant.tree] = tests_of(ROOT / "build" / mutant.tree)
    labels = trees[mutant.tree].get(mutant.test)
    if labels is None:
        return ""
    return "./test all" if mutant.tree != "dev" or "all" in labels else "./test"


def check(mutants):
    """Whether all patches apply to these sources and name tests that exist; counts them by suite."""
    trees, counts, bad = {}, {"./test": 0, "./test all": 0, "": 0}, []
    for mutant in mutants:
        applies = run(["git", "apply", "--check", "--whitespace=nowarn", mutant.path], cwd=ROOT)
        suite = suite_of(mutant, trees) if mutant.tree == "dev" or (ROOT / "build" / mutant.tree).is_dir() else "./test all"
        wrong = mutant.wrong() or (applies.stdout.strip() if applies.returncode else "") or (
            "" if suite else f"no test {mutant.test} in build/{mutant.tree}")
        if wrong:
            bad.append(f"{mutant.name}: {wrong}")
        counts[suite] += 1
    print(*bad, sep="\n")
    print(f"{len(mutants)} planted faults: ./test finds {counts['./test']}, ./test all the other {counts['./test all']}")
    return not bad and len(mutants) >= LEAST and counts["./test"] >= LEAST_QUICK


def copy_tree():
    """Brings the copy up to date with the files of this tree, as a repository of its own; untouched files keep their times."""
    listed = run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT).stdout.split("\0")
    listed = {name for name in listed if name and (ROOT / name).is_file()}
    COPY.mkdir(parents=True, exist_ok=True)
    if not (COPY / ".git").exists():
        run(["git", "init", "-q"], cwd=COPY)
    for name in run(["git", "ls-files", "-z"], cwd=COPY).stdout.split("\0"):
        if name and name not in listed:
            (COPY / name).unlink(missing_ok=True)
    for name in listed:
        source, target = ROOT / name, COPY / name
        data = source.read_bytes()
        if not target.exists() or target.read_bytes() != data:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
            target.chmod(source.stat().st_mode & 0o777)
    packages, link = ROOT / "tests/web/node_modules", COPY / "tests/web/node_modules"
    if packages.exists() and not link.exists():
        link.symlink_to(packages)
    run(["git", "add", "-A"], cwd=COPY)
    run(["git", "-c", "user.name=tests", "-c", "user.email=tests@localhost", "commit", "-q", "-m", "copy"], cwd=COPY)


def build(tree):
    """Configures where needed, builds; the log of a failure, or nothing."""
    if not (COPY / "build" / tree / "build.ninja").exists():
        made = run(["cmake", "--preset", tree, "--log-level=WARNING"], cwd=COPY)
        if made.returncode:
            return made.stdout
    built = run(["cmake", "--build", "--preset", tree], cwd=COPY)
    return built.stdout if built.returncode else ""


def holds(mutant):
    """Whether the mutant's test passes in the copy, and the end of what it printed."""
    tested = run(["ctest", "--test-dir", COPY / "build" / mutant.tree, "-R", f"^{re.escape(mutant.test)}$", "--no-tests=error",
                  "--output-on-failure", "--timeout", HANG], cwd=COPY)
    return tested.returncode == 0, "\n".join(tested.stdout.strip().splitlines()[-25:])


def plant(mutant, verbose):
    """One fault from planting to pulling out: the verdict."""
    applied = run(["git", "apply", "--whitespace=nowarn", mutant.path], cwd=COPY)
    if applied.returncode:
        return "does not apply"
    try:
        log = build(mutant.tree)
        if log:
            print(log[-3000:] if verbose else "", end="")
            return "does not build"
        passes, said = holds(mutant)
        if verbose:
            print(said)
        return "not found" if passes else "found"
    finally:
        run(["git", "apply", "-R", "--whitespace=nowarn", mutant.path], cwd=COPY)


def table(rows):
    """The outcome in Markdown."""
    lines = ["| fault | where | the test that finds it | in | outcome |", "|---|---|---|---|---|"]
    for mutant, suite, verdict in rows:
        lines.append(f"| {mutant.fault} | `{mutant.files[0]}` | `{mutant.test}`"
                     f"{'' if mutant.tree == 'dev' else f' ({mutant.tree})'} | {suite or 'no suite'} | {verdict} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ", maxsplit=1)[1])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--table")
    parser.add_argument("--verbose", "-v", action="store_true")
    given = parser.parse_args()
    mutants = [Mutant(path) for path in sorted(HERE.glob("*.patch")) if not given.names or path.stem in given.names]
    if not mutants:
        sys.exit("no such mutant")
    if given.check:
        sys.exit(0 if check(mutants) else 1)
    os.environ["GIT_CEILING_DIRECTORIES"] = str(COPY.parent)
    copy_tree()
    bad = 0
    for tree in sorted({mutant.tree for mutant in mutants}):
        print(f"build/{tree} of the copy ...", flush=True)
        log = build(tree)
        if log:
            sys.exit(log[-3000:])
    rows, trees, sound = [], {}, {}
    for number, mutant in enumerate(mutants, 1):
        begun = time.monotonic()
        key = (mutant.tree, mutant.test)
        if key not in sound:
            sound[key] = holds(mutant)
        verdict = plant(mutant, given.verbose) if sound[key][0] else "its test fails without it"
        if verdict == "its test fails without it" and given.verbose:
            print(sound[key][1])
        rows.append((mutant, suite_of(mutant, trees), verdict))
        bad += verdict != "found"
        print(f"{number}/{len(mutants)} {mutant.name}: {verdict} by {mutant.test} ({time.monotonic() - begun:.0f} s)", flush=True)
    if given.table:
        pathlib.Path(given.table).write_text(table(rows), encoding="utf-8")
    print(f"{len(rows) - bad} passed, {bad} failed")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
