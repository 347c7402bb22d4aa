#!/usr/bin/env python3
"""The numbers that the engine and the page share are defined in one place: input.h, frame.h and panels.h of
include/batten (and the caps and joins of relate.h). web/engine/codes.js is generated from them, and no other script
of the page may define them.

Usage: check_codes.py ROOT [--write]. Exit status 1 when codes.js differs from the headers. --write: regenerates it.
"""
import pathlib
import re
import sys

# The page's name for each family, and the prefix of the header's names.
FAMILIES = [("Phase", "BAT_POINTER_", "of events of a pointer"), ("Device", "BAT_DEVICE_", ""), ("Modifier", "", "keys that are held"),
            ("Role", "BAT_ROLE_", "what an item of a picture is"), ("Flag", "BAT_ITEM_", "how an item is painted"),
            ("Path", "BAT_PATH_", "commands of a path"), ("Cap", "BAT_CAP_", ""), ("Join", "BAT_JOIN_", ""),
            ("Cursor", "BAT_CURSOR_", ""), ("Act", "BAT_LEVEL_", "what is done to a level"), ("Ask", "BAT_ASK_", "flags: what the host is asked to do")]
MODIFIERS = ("BAT_SHIFT", "BAT_CTRL", "BAT_ALT", "BAT_META")
WIDTH = 118


def enums(root):
    """Every name of an enum of these headers, with its number."""
    found = {}
    for name in ("input", "frame", "panels", "relate"):
        text = (root / "include" / "batten" / f"{name}.h").read_text("utf-8")
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
        for body in re.findall(r"enum(?:\s+\w+)?\s*\{(.*?)\}", text, re.S):
            value = -1
            for row in filter(None, (row.strip() for row in body.split(","))):
                member, _, given = (part.strip() for part in row.partition("="))
                value = int(given, 0) if re.fullmatch(r"-?\d+|0x[0-9a-fA-F]+", given) else value + 1 if not given else None
                if value is not None:
                    found[member] = value
    return found


def script(found):
    lines = ["// Numbers that the engine and its host have in common: made of the headers by tests/house/check_codes.py.", ""]
    for family, prefix, says in FAMILIES:
        names = [n for n in found if n.startswith(prefix)] if prefix else list(MODIFIERS)
        cut = len(prefix or "BAT_")
        row = f"export const {family} = Object.freeze({{"
        if says:
            lines.append(f"/** {says[0].upper()}{says[1:]}. */")
        for i, name in enumerate(names):
            word = f"{name[cut:]}: {found[name]}" + ("," if i + 1 < len(names) else " });")
            if len(row) + 1 + len(word) > WIDTH:
                lines.append(row)
                row = " "
            row += " " + word
        lines.append(row)
    lines += ["", "/**", " * Its names in small letters, each at its number.", " * @param {Record<string, number>} family", " */",
              "export const names = (family) => {", "  /** @type {string[]} */", "  const list = [];",
              "  for (const [name, number] of Object.entries(family)) list[number] = name.toLowerCase();", "  return list;", "};"]
    return "\n".join(lines) + "\n"


def main():
    root = pathlib.Path(sys.argv[1])
    codes = root / "web" / "engine" / "codes.js"
    wanted = script(enums(root))
    if "--write" in sys.argv:
        codes.write_text(wanted, "utf-8")
    faults = [] if codes.read_text("utf-8") == wanted else [
        "web/engine/codes.js is not what the headers in include/batten say: python3 tests/house/check_codes.py . --write"]
    count = 0
    for path in sorted((root / "web").rglob("*.js")):
        if path == codes or "node_modules" in path.parts:
            continue
        count += 1
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
            if re.search(r"\b(ROLE|CURSOR|ASK|PHASE)_?\w*\s*=\s*(\d|\[')", line):
                faults.append(f"{path.relative_to(root)}:{number}: numbers of the engine stand in engine/codes.js")
    print(*faults, sep="\n")
    print(f"{count} scripts read, {len(faults)} faults")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
