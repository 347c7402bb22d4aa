#!/usr/bin/env python3
"""The instructions of the README work: the first C program is built and run, and the commands of "The program" are run in
order, on the examples, in a separate folder. The struct that docs/interface.md declares in Python matches the header.

Usage: check_readme.py ROOT BUILD
"""
import ctypes
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

ROOT, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])


def block(heading, language, page="README.md"):
    text = (ROOT / page).read_text(encoding="utf-8")
    section = text.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return re.search(rf"```{language}\n(.*?)```", section, re.S)[1]


def edit(command, folder, environment):
    """`batten edit` runs until it is terminated; its first line is an address."""
    with subprocess.Popen(command + " --no-open", shell=True, cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, start_new_session=True) as server:
        address = server.stdout.readline()
        os.killpg(server.pid, signal.SIGTERM)
    assert re.match(r"http://127\.0\.0\.1:\d+/", address), address


def options_of_python():
    """The size and offsets of bat_fit_options as declared in Python, its members in the header's order, and a struct
    with the library's defaults."""
    given = {"ctypes": ctypes, "batten": ctypes.CDLL(str(BUILD / "libbatten.so"))}
    exec(block("Options", "python", "docs/interface.md"), given)  # pylint: disable=exec-used
    struct, options = given["FitOptions"], given["options"]
    header = re.sub(r"/\*.*?\*/", " ", (ROOT / "include/batten/fit.h").read_text(encoding="utf-8"), flags=re.S)
    body = re.search(r"typedef struct bat_fit_options \{(.*?)\}", header, re.S)[1]
    members = [re.search(r"\w+$", member.strip())[0] for member in body.split(";") if member.strip()]
    assert [name for name, _ in struct._fields_] == members, (struct._fields_, members)
    return [ctypes.sizeof(struct)] + [getattr(struct, name).offset for name in members], members, options


def check_interface(folder):
    places, members, options = options_of_python()
    printed = ", ".join(["sizeof(bat_fit_options)"] + [f"offsetof(bat_fit_options, {name})" for name in members])
    (folder / "places.c").write_text("#include <batten/fit.h>\n#include <stddef.h>\n#include <stdio.h>\n"
                                     f"int main(void) {{ const size_t places[] = {{{printed}}};\n"
                                     'for (size_t i = 0; i < sizeof places / sizeof *places; i++) printf("%zu ", places[i]);\n'
                                     "return 0; }\n")
    subprocess.run(["gcc", "-std=c17", f"-I{ROOT}/include", "places.c", "-o", "places"], cwd=folder, check=True)
    said = subprocess.run(["./places"], cwd=folder, check=True, capture_output=True, text=True).stdout
    assert places == [int(word) for word in said.split()], (places, said)
    assert options.size == places[0] and options.degree == 3 and options.tolerance == 0.5 and not options.hold_ends


with tempfile.TemporaryDirectory() as folder:
    check_interface(pathlib.Path(folder))
    folder = pathlib.Path(folder)
    (folder / "main.c").write_text(block("The first program", "c", "docs/packages.md"))
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
