#!/usr/bin/env python3
"""The files that CONTRIBUTING.md lists for adding a tool, a kind of object and a format are those of its examples: the
files of the engine and the page that name Line, the plane and OBJ are exactly those listed.

Usage: check_additions.py ROOT. Exit status 1 when a list lacks a file or has one too many.
"""
import pathlib
import re
import sys

from sources import sources

# "X was added so:", and how a file names X. Other meanings of the words (a ruler's line, the plane of the page) do not
# count, nor does a command that makes an object of the kind.
EXAMPLES = {
    "Line": r"\bbat_tool_line\b|\bTOOL_LINE\b|\btool-line\b|\bTOOL\(LINE\b|HINT_LINE\b",
    "The plane": r"\bbat_kind_of_plane\b|\bBAT_KIND_PLANE\b|\bKIND_PLANE\b|\bKIND\(plane\b|\bbat_object_plane\b",
    "OBJ": r"\bbat_format_of_obj\b|\bFORMAT\(obj\b",
}
MOST = 4


def main():
    root = pathlib.Path(sys.argv[1])
    guide = re.sub(r"\s+", " ", (root / "CONTRIBUTING.md").read_text("utf-8"))
    files = [path for path in sources(root, ["src", "include", "apps", "web"], (".c", ".h", ".def", ".js", ".svg", ".html", ".css"))
             if "node_modules" not in path.parts]
    text = {str(path.relative_to(root)): path.read_text("utf-8") for path in files}
    faults = []
    for name, pattern in EXAMPLES.items():
        found = {path for path, code in text.items() if re.search(pattern, code)}
        list_ = re.search(re.escape(name) + r" was added so: ((?:`[^`]+`(?:, )?)+)\.", guide)
        said = set(re.findall(r"`([^`]+)`", list_[1])) if list_ else set()
        faults += [f"CONTRIBUTING.md: {name}: {path} names it and is not listed" for path in sorted(found - said)]
        faults += [f"CONTRIBUTING.md: {name}: {path} is listed and does not name it" for path in sorted(said - found)]
        if len(found) > MOST:
            faults.append(f"{name} is named by {len(found)} files, at most {MOST}")
    print(*faults, sep="\n")
    print(f"{len(files)} files read, {len(faults)} faults")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
