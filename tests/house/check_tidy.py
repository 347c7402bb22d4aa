#!/usr/bin/env python3
"""Runs clang-tidy over the library, the program and the module, or a share of their files. A file is skipped if the
same preprocessed text was clean before with the same configuration. The analyzer follows fewer states here than it
would by itself, because its time goes into a few long functions; tools/analyse looks as deep as it can.

Usage: check_tidy.py ROOT [SHARE SHARES] [--deep]    shares are counted from 1
"""
import hashlib
import pathlib
import subprocess
import sys

from sources import sources

ROOT = pathlib.Path(sys.argv[1])
CLEAN = pathlib.Path("tidy")
FLAGS = ["-std=c17", f"-I{ROOT}/include", f"-I{ROOT}/src", f"-I{ROOT}/apps/batten", "-D_POSIX_C_SOURCE=200809L"]
LIBRARIES = subprocess.run(["pkg-config", "--cflags", "cairo", "expat", "libmicrohttpd"], capture_output=True, text=True,
                           check=True).stdout.split()
# A function is left after so many states (the analyzer's own limit is 225,000).
FEWER = [part for text in ("-analyzer-config", "max-nodes=20000") for part in ("-Xclang", text)]
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


numbers = [word for word in sys.argv[2:] if word != "--deep"]
share, shares = map(int, numbers) if numbers else (1, 1)
LIMITS = FEWER if len(numbers) == len(sys.argv[2:]) else []
CLEAN.mkdir(exist_ok=True)
files = sources(ROOT, ["src", "expat", "apps/batten", "web/module"], (".c",))[share - 1::shares]
results = [check(path) for path in files]
faulty = [(path, text) for path, text, _ in results if text]
for path, text in faulty:
    print(f"{path.relative_to(ROOT)}:\n{text}")
print(f"{len(files)} files, {sum(read for _, _, read in results)} read anew, {len(faulty)} with findings")
sys.exit(1 if faulty or not files else 0)
