#!/usr/bin/env python3
"""Runs clang-tidy over the library, the program and the module, or some of their files. A file is skipped if it,
and all that it includes, was clean before with the same configuration. The analyzer follows fewer states here than it
would by itself, because its time goes into a few long functions; tools/analyse looks as deep as it can.

Usage: check_tidy.py ROOT MADE [--share N OF] [--changed] [--deep]
MADE: the folder of the headers that the build makes. --share: the N-th (from 1) of so many parts. --changed: what differs
from main, committed or not, and sources whose own header does.
"""
import argparse
import functools
import hashlib
import pathlib
import re
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
RULES = (ROOT / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes()
WASM = ["--target=wasm32-wasi", "-nostdlibinc", "-isystem", "/usr/include/wasm32-wasi"]


INCLUDED = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*"?<?([^">]+)', re.M)


@functools.cache
def text_of(path):
    """(the bytes of a file, those of the project's files that it includes)"""
    text = path.read_bytes()
    folders = [path.parent, ROOT / "include", ROOT / "src", ROOT / "apps/batten", pathlib.Path(given.made)]
    names = [name.decode() for name in INCLUDED.findall(text)]
    return text, [next((folder / name for folder in folders if (folder / name).is_file()), None) for name in names]


def key_of(path, flags):
    """What the findings hang on: all that is included, the rules, the flags."""
    found, left, digest = {path}, [path], hashlib.sha256(repr(flags + LIMITS).encode() + RULES)
    while left:
        new = [one for one in text_of(left.pop())[1] if one and one not in found]
        found.update(new), left.extend(new)
    for one in sorted(found):
        digest.update(text_of(one)[0])
    return digest.hexdigest()


def run(paths, flags):
    """(whether nothing was found, the text of the findings) of files that are read with these flags, in one run: to begin one takes
    as long as to read most of the files."""
    done = subprocess.run(["clang-tidy", "--quiet", *map(str, paths), "--", *flags, *LIMITS], capture_output=True, text=True, check=False)
    return done.returncode == 0, done.stdout + done.stderr


def check(paths, flags):
    """(how many were read, {path: findings}) of those that were not clean before."""
    marks = {path: CLEAN / key_of(path, flags) for path in paths}
    left = [path for path in paths if not marks[path].exists()]
    clean = not left or run(left, flags)[0]
    faulty = {} if clean else {path: text for path in left for good, text in [run([path], flags)] if not good}
    for path in left:
        if path not in faulty:
            marks[path].touch()
    return len(left), faulty


def flags_of(path):
    return tuple(FLAGS + (WASM if "module" in path.parts else LIBRARIES if "apps" in path.parts or "expat" in path.parts else []))


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
groups = {}
for path in files:
    groups.setdefault(flags_of(path), []).append(path)
results = [check(paths, list(flags)) for flags, paths in groups.items()]
faulty = {path: text for _, found in results for path, text in found.items()}
for path, text in faulty.items():
    print(f"{path.relative_to(ROOT)}:\n{text}")
print(f"{len(files)} files, {sum(read for read, _ in results)} read anew, {len(faulty)} with findings")
sys.exit(1 if faulty or not (files or given.changed) else 0)
