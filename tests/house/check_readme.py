#!/usr/bin/env python3
"""What the README tells a newcomer to type does what it says: its C program is built and run, the commands of "The
program" run in the order given, on the examples, in a folder of their own.

Usage: check_readme.py ROOT BUILD
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

ROOT, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def block(heading, language):
    section = TEXT.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return re.search(rf"```{language}\n(.*?)```", section, re.S)[1]


def edit(command, folder, environment):
    """`batten edit` runs until it is told to end: its first line is an address."""
    with subprocess.Popen(command + " --no-open", shell=True, cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, start_new_session=True) as server:
        address = server.stdout.readline()
        os.killpg(server.pid, signal.SIGTERM)
    assert re.match(r"http://127\.0\.0\.1:\d+/", address), address


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    (folder / "main.c").write_text(block("The library", "c"))
    subprocess.run(["gcc", "-std=c17", "-Wall", "-Wextra", "-Werror", f"-I{ROOT}/include", "main.c",
                    BUILD / "libbatten.a", "-lm", "-o", "main"], cwd=folder, check=True)
    said = subprocess.run(["./main"], cwd=folder, check=True, capture_output=True, text=True).stdout
    assert said == "5 control points\n", said

    (folder / "examples").symlink_to(ROOT / "examples")
    (folder / "build" / "release").mkdir(parents=True)
    (folder / "build" / "release" / "batten").symlink_to(BUILD / "batten")
    first, *commands = block("The program", "sh").splitlines()
    assert first == "PATH=$PWD/build/release:$PATH", first
    environment = {**os.environ, "PATH": f"{folder}/build/release:{os.environ['PATH']}"}
    for command in commands:
        command = command.split(" #")[0].rstrip()
        print(command)
        if command.startswith("batten edit "):
            edit(command, folder, environment)
        else:
            subprocess.run(command, shell=True, cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
        for made in re.findall(r"build/[\w.]+", command):
            assert (folder / made).stat().st_size > 0, made
    assert len(commands) > 3
