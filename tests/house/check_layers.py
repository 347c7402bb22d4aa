#!/usr/bin/env python3
"""Dependencies run downwards only: reads every #include line of src/ and include/ and names those that do not.

Usage: check_layers.py ROOT. Exit status 1 when a line breaks the rule or a header has no layer.
"""
import pathlib
import re
import sys

# What a folder of src/ may include, besides itself.
MAY_USE = {
    "curve": set(),
    "shape": {"curve"},
    "form": {"curve", "shape"},
    "document": {"curve", "shape", "form"},
    "format": {"curve", "shape", "form", "document"},
    "editor": {"curve", "shape", "form", "document", "format"},
}

# The layer of each public header. A new header needs a line here.
LAYER_OF_HEADER = {
    "base": "curve", "curve": "curve", "refine": "curve", "bezier": "curve", "drag": "curve", "measure": "curve",
    "nearest": "curve", "fit": "curve", "frames": "curve",
    "sketch": "shape", "tangents": "shape", "levels": "shape",
    "document": "document",
    "format": "format",
    "editor": "editor",
    "batten": None,  # the umbrella: for users, not for us
}

# libc and libm as far as the WASM build has them; anything else is a dependency.
LIBC = {"assert", "ctype", "errno", "float", "inttypes", "limits", "math", "stdalign", "stdarg", "stdbool",
        "stddef", "stdint", "stdio", "stdlib", "string"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(name, quoted, folder):
    """Layer of an included file, 'libc', or None with the reason."""
    if name.startswith("batten/"):
        stem = name[len("batten/"):].removesuffix(".h")
        if stem not in LAYER_OF_HEADER:
            return None, "a public header without a layer in check_layers.py"
        return LAYER_OF_HEADER[stem], "the umbrella header is for users"
    if quoted:
        parts = name.split("/")
        layer = parts[0] if len(parts) > 1 else folder
        return (layer if layer in MAY_USE else None), "no folder of src/"
    return ("libc" if name.removesuffix(".h") in LIBC else None), "not a libc header the core may use"


def check(root):
    faults, lines = [], 0
    files = [(path, path.parent.name) for path in sorted(root.glob("src/*/*.[ch]"))]
    for path in sorted(root.glob("include/batten/*.h")):
        if path.stem not in LAYER_OF_HEADER:
            faults.append(f"{path.relative_to(root)}: give it a layer in tests/house/check_layers.py")
        elif LAYER_OF_HEADER[path.stem]:
            files.append((path, LAYER_OF_HEADER[path.stem]))
    for path, folder in files:
        if folder not in MAY_USE:
            faults.append(f"{path.relative_to(root)}: folder without a layer in tests/house/check_layers.py")
            continue
        for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(text)
            if not found:
                continue
            lines += 1
            layer, reason = layer_of(found[2], found[1] == '"', folder)
            place = f"{path.relative_to(root)}:{number}: {found[2]}"
            if layer is None:
                faults.append(f"{place}: {reason}")
            elif layer not in MAY_USE[folder] | {folder, "libc"}:
                faults.append(f"{place}: {folder} may not use {layer}")
    return faults, lines


if __name__ == "__main__":
    found_faults, read = check(pathlib.Path(sys.argv[1]))
    print("\n".join(found_faults))
    print(f"{read} include lines read, {len(found_faults)} faults")
    sys.exit(1 if found_faults or read == 0 else 0)
