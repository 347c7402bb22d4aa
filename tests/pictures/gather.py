#!/usr/bin/env python3
"""Gathers many SVG files of others into FOLDER, for whole.py: a folder for each source. Icon themes and clip art come from
Debian's packages, which are unpacked and not installed, icons from npm, and drawings from the programs of the machine that can be
asked for some (draw.py); those that are missing are named and left out. What is there is not fetched again. About 600 MB.

Usage: gather.py FOLDER
"""
import pathlib
import subprocess
import sys

from draw import draw_all

DEBIAN = ["breeze-icon-theme", "elementary-xfce-icon-theme", "gnome-colors-common", "inkscape", "kalzium-data", "mate-icon-theme",
          "numix-icon-theme", "openclipart-svg", "papirus-icon-theme", "suru-icon-theme"]
# Of these packages only a part is a picture: the rest are icons as other packages have them.
PARTS = {"inkscape": "usr/share/inkscape/[!iu]*/**/*.svg"}
NPM = ["lucide-static", "@tabler/icons", "bootstrap-icons", "simple-icons", "@mdi/svg", "feather-icons", "ionicons",
       "@primer/octicons", "remixicon", "@fortawesome/fontawesome-free", "flag-icons"]
TOOLS = ["d3", "jsdom"]
INSTALLED = ["Tango", "Adwaita", "HighContrast"]  # of /usr/share/icons
# Programs of which there is no package of files: their names in the files of others.
PROGRAMS = {"illustrator": b"Adobe Illustrator", "figma": b'clip-path="url(#clip0_', "sketch": b"Sketch", "corel": b"CorelDRAW"}
MOST = 400  # files of such a program


def run(folder, *words):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"not to be had: {' '.join(words)}: {done.stderr.strip().splitlines()[-1:]}")
    return done.returncode == 0


def link(to, at):
    """A link at `at`."""
    if to.exists() and not at.is_symlink():
        at.symlink_to(to.resolve())


def fetch_debian(files, kept):
    for name in DEBIAN:
        room = kept / "debian" / name
        if not room.exists():
            room.mkdir(parents=True)
            if not run(room, "apt-get", "download", name) or not run(room, "dpkg", "-x", next(room.glob("*.deb")).name, "."):
                continue
        if name not in PARTS:
            link(room, files / name)
            continue
        (files / name).mkdir(exist_ok=True)
        for i, path in enumerate(sorted(room.glob(PARTS[name]))):
            link(path, files / name / f"{i}-{path.name}")


def fetch_npm(files, kept):
    room = kept / "npm"
    if not room.exists():
        room.mkdir(parents=True)
        run(room, "npm", "install", "--silent", "--no-fund", "--no-audit", "--ignore-scripts", "--prefix", ".", *NPM, *TOOLS)
    for name in NPM:
        link(room / "node_modules" / name, files / ("npm-" + name.lstrip("@").replace("/", "-")))


def link_programs(files):
    """Files that say which program wrote them, wherever they are."""
    for name in PROGRAMS:
        (files / name).mkdir(exist_ok=True)
    found = dict.fromkeys(PROGRAMS, 0)
    for source in sorted(files.iterdir()):
        for path in sorted(source.rglob("*.svg")) if source.name not in PROGRAMS else []:
            if not path.is_file() or min(found.values()) >= MOST:
                continue
            text = path.read_bytes()
            for name, mark in PROGRAMS.items():
                if found[name] < MOST and mark in text:
                    link(path, files / name / f"{found[name]}-{path.name}")
                    found[name] += 1


def main():
    folder = pathlib.Path(sys.argv[1])
    files, kept = folder / "files", folder / "fetched"
    files.mkdir(parents=True, exist_ok=True)
    fetch_debian(files, kept)
    fetch_npm(files, kept)
    for name in INSTALLED:
        link(pathlib.Path("/usr/share/icons") / name, files / name.lower())
    draw_all(files, kept / "npm")
    link_programs(files)
    for source in sorted(files.iterdir()):
        print(f"{sum(1 for _ in source.rglob('*.svg')):7} {source.name}")


if __name__ == "__main__":
    main()
