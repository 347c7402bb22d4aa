#!/usr/bin/env python3
"""Two programs, in C, C++, Python and JavaScript, in fresh projects from packed packages: outline (an SVG path, simplified, offset, united,
written) and vase (a loft, bent by a wire, as STL). All four write the same bytes. Usage: proof.py ROOT BUILD LIBRARY
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

root, build, library = map(pathlib.Path, sys.argv[1:])
proof = root / "tests/bindings/proof"
work = pathlib.Path(tempfile.mkdtemp(prefix="batten-proof-"))


def run(*command, **more):
    """The output of a command, which must succeed."""
    told = subprocess.run([str(part) for part in command], cwd=work, text=True, capture_output=True, **more)
    if told.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{told.stdout}{told.stderr}")
    return told.stdout.strip()


def compiled():
    """The commands of C and C++, by the installed libraries."""
    run("cmake", "--install", build, "--prefix", work / "installed")
    package = next((work / "installed").rglob("batten.pc")).parent
    found = os.environ | {"PKG_CONFIG_PATH": str(package)}
    flags = run("pkg-config", "--cflags", "--libs", "batten-svg", "batten", env=found).split()
    library_path = f"-Wl,-rpath,{run('pkg-config', '--variable=libdir', 'batten', env=found)}"
    commands = {}
    for language, compiler in (("c", "cc -std=c17"), ("cpp", "c++ -std=c++17")):
        for name in ("outline", "vase"):
            run(*compiler.split(), "-Wall", "-Wextra", "-Wpedantic", "-Werror", proof / f"{name}.{language}", *flags, library_path, "-lm", "-o", f"{name}.{language}.out")
            commands[name, language] = [work / f"{name}.{language}.out"]
    return commands


def python():
    """In a fresh environment, from the wheel."""
    environment = os.environ | {"BATTEN_LIBRARY": str(library), "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    run("/usr/bin/python3", "-c", "import sys, os; sys.path.insert(0, sys.argv[1]); import backend; backend.build_wheel(os.getcwd())", root / "bindings/python", env=environment)
    run("/usr/bin/python3", "-m", "venv", "--system-site-packages", "--without-pip", "venv")
    place = run("venv/bin/python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))")
    shutil.unpack_archive(next(work.glob("*.whl")), place, "zip")
    return {(name, "py"): [work / "venv/bin/python", proof / f"{name}.py"] for name in ("outline", "vase")}


def javascript():
    """In a fresh project, from the npm package."""
    environment = os.environ | {"npm_config_cache": str(work / "cache"), "npm_config_update_notifier": "false"}
    (work / "package.json").write_text('{"name": "proof", "private": true, "type": "module"}\n')
    packed = run("npm", "pack", "--silent", root / "build/wasm/npm/batten-core", env=environment)
    run("npm", "install", "--offline", "--no-audit", "--no-fund", work / packed, env=environment)
    for name in ("outline", "vase"):
        shutil.copy(proof / f"{name}.mjs", work)
    return {(name, "mjs"): ["node", f"{name}.mjs"] for name in ("outline", "vase")}


try:
    written, told = {}, {}
    for (program, language), command in (compiled() | python() | javascript()).items():
        out = work / f"{program}.{language}.made"
        told[program, language] = run(*command, *([proof / "drawing.svg"] if program == "outline" else []), out)
        written[program, language] = out.read_bytes()
    faults = [f"{program}.{language}: not as in C" for program, language in written
              if (written[program, language], told[program, language]) != (written[program, "c"], told[program, "c"])]
    print(*faults, *sorted({f"{program}: {text}" for (program, _), text in told.items()}), sep="\n")
    sys.exit(bool(faults) or len(written) != 8)
finally:
    shutil.rmtree(work)
