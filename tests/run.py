#!/usr/bin/env python3
"""Builds and tests, once the packages are there: what ./test and ./test all do.

Usage: run.py [all [PART]]
all: everything; PART: a part of it alone (native, builds, browser, sanitizers), as a pipeline runs them side by side. The
last line is "N passed, N failed"; the exit status is 1 when any failed. Nothing is counted that did not run; what should
have run and did not has failed.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
CORES = os.cpu_count() or 2
TERMINAL = sys.stdout.isatty()
EVERY = 1 if TERMINAL else 30  # seconds between words on progress
SLOWEST = 10
JOBS = CORES + 3  # tests at a time: sessions in the browser wait for frames a third of their time
AGAIN = 5  # sessions in the browser at most that are run once more

# What is built, as {preset: targets}: two at a time in this order, those of WITH_PAGE when the page's module is there. Which tests
# then run: the trees, and how ctest chooses among their tests. "again" are units that the sanitizers and the twins run just as long.
MODULE = {"wasm": ["all", "npm", "parity_module"]}
TWINS = {"wasm": [*MODULE["wasm"], "units_module"], "release": ["parity", "units"]}
SANITIZED = {"tsan": ["thread_tests"], "asan": ["all"]}
WITH_PAGE = ["dev", "asan"]
PARTS = {
    "native": (MODULE | {"dev": ["all"]}, ["dev"], ["-LE", "^(web|twins|builds|again)$"]),
    "builds": (TWINS | {"dev": ["all", "growth"]}, ["dev"], ["-L", "^(twins|builds)$"]),
    "browser": (MODULE | {"dev": ["batten_program"]}, ["dev"], ["-L", "^web$"]),
    "sanitizers": (MODULE | SANITIZED, ["asan", "tsan"], []),
}
SUITES = {
    (): (MODULE | {"dev": ["all"]}, ["dev"], ["-LE", "^all$"]),
    ("all",): (TWINS | {"tsan": SANITIZED["tsan"], "dev": ["all", "growth"], "asan": SANITIZED["asan"]},
               ["dev", "asan", "tsan"], ["-LE", "^again$"]),
    **{("all", name): part for name, part in PARTS.items()},
}
INTENT = {
    (): "./test: each test of the library, the program and the page once, in a debug build; in the browser the sessions that are "
        "labelled smoke. It leaves to ./test all: the sanitizers, fuzzing, every unit test as WebAssembly, all sessions in the "
        "browser, growth of work, hardened and reproducible builds, clang-tidy on what has not changed.\n"
        "Usually six minutes on two cores, and four when a compiler cache is warm.",
    ("all",): "./test all: everything. It leaves to commands of their own: other systems, fuzzing for long, a thousand files of "
              "others, Debian's packages, planted faults (CONTRIBUTING.md).\n"
              "Usually forty-five minutes on two cores.",
}


def say(text):
    print(f"\033[1m== {text}\033[0m" if TERMINAL else f"== {text}", flush=True)


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


class Progress:
    """What has been reached: on a terminal a line that changes, on a log one now and then."""

    def __init__(self):
        self.begun = self.told = time.monotonic()

    def tell(self, text):
        now = time.monotonic()
        if now - self.told >= EVERY:
            self.told = now
            self.show(f"[{clock(now - self.begun)}] {text}", "" if TERMINAL else "\n")

    def show(self, line, end="\n"):
        """A line of its own, in place of the one that changes."""
        print(f"\r{line[:150]:150}" if TERMINAL and not end else f"\r{'':150}\r{line}" if TERMINAL else line, end=end, flush=True)

    def passed(self):
        return clock(time.monotonic() - self.begun)


def follow(words, log, each):
    """Runs a command; each line that it prints goes to the log and to a function. Its exit status."""
    with open(log, "a", encoding="utf-8") as kept, subprocess.Popen(
            [str(word) for word in words], cwd=ROOT, text=True, errors="replace", stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT) as process:
        for line in process.stdout:
            kept.write(line)
            each(line.rstrip("\n"))
    return process.returncode


def step(name, commands):
    """Whether commands that prepare the tests succeed. Says how far they are, and the end of what they printed if not."""
    progress, log = Progress(), BUILD / f"{name}.log"
    say(name)
    log.unlink(missing_ok=True)
    if all(follow(words, log, lambda line: line and progress.tell(f"{name}: {line}")) == 0 for words in commands):
        progress.show(f"[{progress.passed()}] {name} done")
        return True
    progress.show(f"[{progress.passed()}] {name} failed")
    print(*log.read_text(encoding="utf-8").splitlines()[-60:], sep="\n", flush=True)
    return False


def packages():
    """The npm packages of the browser tests."""
    wanted, there = ROOT / "tests/web/package-lock.json", ROOT / "tests/web/node_modules/.package-lock.json"
    if there.exists() and there.stat().st_mtime >= wanted.stat().st_mtime:
        return True
    done = step("npm", [["npm", "ci", "--prefix", "tests/web", "--no-audit", "--no-fund"]])
    if done:
        there.touch()
    return done


def build(preset, targets, first):
    """Whether a tree is built, once the build that it waits for has ended."""
    if first:
        first.result()
    return step(preset, [["cmake", "--preset", preset, "--log-level=WARNING", "-DBATTEN_WERROR=ON"],
                         ["cmake", "--build", "--preset", preset, "--target", *targets]])


def build_trees(wanted):
    """Builds two trees at a time: while one links, the other compiles. Those that were not built."""
    builds = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for preset, targets in wanted.items():
            builds[preset] = pool.submit(build, preset, targets, builds["wasm"] if preset in WITH_PAGE else None)
    return [preset for preset, built in builds.items() if not built.result()]


def one_list(trees):
    """A folder in which ctest finds the tests of several trees as one list."""
    folder = BUILD / "tests"
    folder.mkdir(exist_ok=True)
    (folder / "CTestTestfile.cmake").write_text("".join(f'subdirs("{BUILD}/{tree}")\n' for tree in trees), encoding="utf-8")
    return folder


STARTS = re.compile(r"^\s*Start\s+\d+: (\S+)")
ENDS = re.compile(r"^\s*(\d+)/(\d+) Test\s+#\d+: (\S+) [ .]*(\*\*\*)?")


def test(trees, choice, jobs=JOBS):
    """Runs the tests. (name, whether it passed, seconds) of each."""
    folder, running, progress = one_list(trees), [], Progress()
    report = folder / "report.xml"
    report.unlink(missing_ok=True)
    state = {"failing": False, "done": "0 of ?"}

    def look(line):
        if (start := STARTS.match(line)):
            running.append(start[1])
        if (end := ENDS.match(line)):
            state["done"] = f"{end[1]} of {end[2]}"
            if end[3] in running:
                running.remove(end[3])
        if start or end:
            state["failing"] = bool(end and end[4])
        if state["failing"]:
            progress.show(line)
        if start or not end: # at an end the next has not begun yet
            progress.tell(f"{state['done']} done; running: {', '.join(running)}")

    say(f"tests of {', '.join(trees)}")
    follow(["ctest", "--test-dir", folder, f"-j{jobs}", "--output-on-failure", "--no-tests=error", "--output-junit", report,
            *choice], folder / "log.txt", look)
    progress.show(f"[{progress.passed()}] done")
    try:
        cases = xml.parse(report).getroot().findall("testcase")
    except (OSError, xml.ParseError):
        cases = []
    return [(case.get("name"), case.get("status") == "run", float(case.get("time") or 0)) for case in cases]


def once_more(trees, done):
    """
    Sessions in the browser that failed are run again, alone: one that passes then is said to be unsteady, with what it printed the
    first time above. A fault fails twice; of more than a few the machine is not the reason.
    """
    failed = [name for name, passed, _ in done if not passed]
    again = [name for name in failed if name.startswith("web_")]
    if not 0 < len(again) <= AGAIN:
        return done, []
    say(f"once more, alone: {', '.join(again)}")
    second = {name: passed for name, passed, _ in test(trees, ["-R", f"^({'|'.join(again)})$"], 1)}
    unsteady = [name for name in again if second.get(name)]
    return [(name, passed or name in unsteady, seconds) for name, passed, seconds in done], unsteady


def by_kind(done):
    """Seconds of tests by what their names begin with: where the time goes."""
    sums = {}
    for name, _, seconds in done:
        kind = name.partition("_")[0]
        number, total = sums.get(kind, (0, 0))
        sums[kind] = (number + 1, total + seconds)
    return [f"{kind}: {number} tests, {total:.0f} s" for kind, (number, total) in sorted(sums.items(), key=lambda row: -row[1][1])]


def main():
    suite = tuple(sys.argv[1:])
    if suite not in SUITES:
        print(f"usage: ./test [all [{'|'.join(PARTS)}]]", file=sys.stderr)
        return 2
    begun = time.monotonic()
    builds, trees, choice = SUITES[suite]
    say(INTENT.get(suite) or f"./test {' '.join(suite)}: a part of ./test all")
    BUILD.mkdir(exist_ok=True)
    bad = [] if packages() else ["npm"]
    unbuilt = build_trees(builds)
    bad += [f"build/{preset}" for preset in unbuilt]
    trees = [tree for tree in trees if tree not in unbuilt]
    done, unsteady = once_more(trees, test(trees, choice)) if trees else ([], [])
    bad += [name for name, passed, _ in done if not passed] + ([] if done else ["no test ran"])
    good = sum(passed for _, passed, _ in done)
    print("The slowest:", *(f"{name} {seconds:.0f} s" for name, _, seconds in sorted(done, key=lambda row: -row[2])[:SLOWEST]),
          sep="\n    ")
    print("By kind:", *by_kind(done)[:SLOWEST], sep="\n    ")
    if unsteady:
        print("Unsteady, to be mended: these failed, and passed when run again alone:", *unsteady, sep="\n    ")
    if bad:
        print("Failed:", *bad, sep="\n    ")
    print(f"After {clock(time.monotonic() - begun)} minutes:\n{good} passed, {len(bad)} failed")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
