#!/usr/bin/env python3
"""Runs clang-tidy over the library, the program and the module, or some of their files. A file is skipped if the
same preprocessed text was clean before with the same configuration. The analyzer follows fewer states here than it
would by itself, because its time goes into a few long functions; tools/analyse looks as deep as it can.

Usage: check_tidy.py ROOT MADE [--share N OF] [--changed] [--deep]
MADE: the folder of the headers that the build makes. --share: the N-th (from 1) of so many parts. --changed: what differs
from main, committed or not, and sources whose own header does.
"""
import argparse
import hashlib
import pathlib
import subprocess
import sys

from sources import sources

parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ")[1])
parser.add_argument("root", type=pathlib.Path)
parser.add_argument("made")
parser.add_argument("--share", type=int, nargs=2, default=(1, 1))
parser.add_argument("--changed", action="store_true")
parser.add_argument("--deep", action="store_true")
given = parser.parse_args()

ROOT = given.root
CLEAN = pathlib.Path("tidy")
FLAGS = ["-std=c17", f"-I{ROOT}/include", f"-I{ROOT}/src", f"-I{given.made}", f"-I{ROOT}/apps/batten", "-D_POSIX_C_SOURCE=200809L"]
LIBRARIES = subprocess.run(["pkg-config", "--cflags", "cairo", "expat", "libmicrohttpd"], capture_output=True, text=True,
                           check=True).stdout.split()
# A function is left after so many states (the analyzer's own limit is 225,000).
FEWER = [part for text in ("-analyzer-config", "max-nodes=8000") for part in ("-Xclang", text)]
LIMITS = [] if given.deep else FEWER
WASM = ["--target=wasm32-wasi", "-nostdlibinc", "-isystem", "/usr/include/wasm32-wasi"]


def check(path):
    """(path, text of the findings, whether clang-tidy was run)"""
    flags = FLAGS + (WASM if "module" in path.parts else LIBRARIES if "apps" in path.parts or "expat" in path.parts else [])
    text = subprocess.run(["clang", *flags, "-E", str(path)], capture_output=True, check=False).stdout
    rules = repr(LIMITS).encode() + (ROOT / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes()
    key = hashlib.sha256(text + rules)
    mark = CLEAN / key.hexdigest()
    if mark.exists():
        return path, "", False
    run = subprocess.run(["clang-tidy", "--quiet", str(path), "--", *flags, *LIMITS], capture_output=True, text=True,
                         check=False)
    if run.returncode == 0:
        mark.touch()
        return path, "", True
    return path, run.stdout + run.stderr, True


def git(*words):
    return subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False).stdout.split()


def changed():
    """Paths that differ from main: as others have it, where this is a clone, else this clone's own."""
    main = next((name for name in ("origin/main", "main") if git("rev-parse", "--verify", "-q", name)), "HEAD")
    base = git("merge-base", "HEAD", main) or ["HEAD"]
    names = git("diff", "--name-only", base[0]) + git("ls-files", "--others", "--exclude-standard")
    return {ROOT / name for name in names}


files = sources(ROOT, ["src", "expat", "apps/batten", "web/module"], (".c",))
if given.changed:
    new = changed()
    files = [path for path in files if path in new or path.with_suffix(".h") in new]
else:
    share, shares = given.share
    files = files[share - 1::shares]
CLEAN.mkdir(exist_ok=True)
results = [check(path) for path in files]
faulty = [(path, text) for path, text, _ in results if text]
for path, text in faulty:
    print(f"{path.relative_to(ROOT)}:\n{text}")
print(f"{len(files)} files, {sum(read for _, _, read in results)} read anew, {len(faulty)} with findings")
sys.exit(1 if faulty or not (files or given.changed) else 0)
