#!/usr/bin/env python3
"""The modules ("rooms") of the library and their allowed dependencies: reads every #include line of src/ and include/
and every call from one source of src/ to another, and reports those that go upwards, in a circle, or past a header.

Usage: check_layers.py ROOT. Exit status 1 when a line breaks a rule.
"""
import pathlib
import re
import sys

from sources import sources

# The rooms of src/, from the bottom up: each may use those listed before it.
ROOMS = [
    "base", "text", "curve", "curve/frames", "relate", "relate/region", "points", "hands/figures", "hands/sketch", "hands/tangents", "hands/levels", "form/surface", "form/relief", "form/mesh", "form/compare", "form/wire", "form/view", "form/sweep", "form/recipe", "form/camera", "form/motion", "form/trace", "form/sight", "form/shade", "document", "format/json",
    "kinds", "format/native", "format/seen", "format/glyph", "format/svg", "format/svg/write", "format/glif", "format/model", "format/curve", "format/points", "format/obj", "format/dxf", "format/gcode", "format/bvh", "format/stl", "format/threemf", "format/ply", "format/usd", "format/gltf", "format/iges", "format/step", "format", "editor/tables", "editor/session", "editor/view", "editor/input",
    "editor/choice", "editor/edit", "editor/edit/shapes", "editor/scene", "editor/pick", "editor/show", "editor/tools",
    "editor/tools/modes", "editor/tools/keyed", "editor/tools/brushes", "editor/tools/sketch", "editor/tools/tangents", "editor/tools/levels", "editor/tools/surface", "editor/tools/gazes", "editor/tools/points", "editor/tools/width",
    "editor/commands", "editor/panels", "editor",
]
# Rooms on the same level, which may not use each other.
APART = [{"hands/figures", "hands/sketch", "hands/tangents"},
         {"editor/tools", "editor/tools/modes", "editor/tools/keyed", "editor/tools/brushes", "editor/tools/sketch",
          "editor/tools/tangents", "editor/tools/levels", "editor/tools/surface", "editor/tools/gazes", "editor/tools/points",
          "editor/tools/width"}]
# Rooms whose files may not use each other either, except for the headers listed here, which all of them may use.
TOOLBOX = {"editor/tools/tool.h", "editor/tools/toolbox.h", "editor/tools/toolbox.c"}  # for every tool
SINGLE = {"kinds": {"kinds/kinds.h"}, "editor/tools": TOOLBOX, "editor/tools/modes": set()}

# Headers that the build makes.
MADE = {"editor/tables/ids.h"}

# The room of each public header. A new header needs an entry here.
ROOM_OF_HEADER = {
    "base": "base", "types": "base", "curve": "curve", "refine": "curve", "bezier": "curve", "drag": "curve", "measure": "curve",
    "nearest": "curve", "fit": "curve", "frames": "curve/frames", "function": "curve",
    "relate": "relate", "blend": "relate", "region": "relate/region", "width": "relate", "interpolate": "points",
    "sketch": "hands/sketch", "tangents": "hands/tangents", "levels": "hands/levels",
    "surface": "form/surface", "check": "form/surface", "relief": "form/relief", "mesh": "form/mesh", "compare": "form/compare", "wires": "form/wire", "view": "form/view", "sweep": "form/sweep", "recipe": "form/recipe", "camera": "form/camera", "motion": "form/motion", "trace": "form/trace", "sight": "form/sight",
    "document": "document", "paint": "document",
    "format": "document", "format_space": "document",
    "input": "editor/tables", "frame": "editor/tables", "panels": "editor/tables", "editor": "editor/tables",
    "svg_read": None,  # belongs to another library (expat/)
    "batten": None,  # the umbrella header: for users, not for the library itself
    "before_0_2": None,  # included by the umbrella header, for older programs
}

# The headers of libc and libm that the WASM build has; anything else would be a dependency.
LIBC = {"assert", "ctype", "errno", "float", "inttypes", "limits", "math", "stdalign", "stdarg", "stdatomic", "stdbool",
        "stddef", "stdint", "stdio", "stdlib", "string"}

MOST_SOURCES = 40  # per folder

MOST_LINES = 60  # per function

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]', re.M)
DEFINED = re.compile(r"^(?!static|typedef|#)[A-Za-z_][\w \*]*?\b(bat_\w+)\([^;{]*\)\s*\{", re.M)
TABLE = re.compile(r"^(?!static|extern|typedef|#)(?:const )?[A-Za-z_][\w \*]*?\b(bat_\w+)(?:\[[^\]]*\])?\s*=", re.M)
USED = re.compile(r"\bbat_\w+")
KIND = re.compile(r"\bBAT_KIND_\w+")
TOOL = re.compile(r"\bBAT_TOOL_(?!COUNT\b)\w+")
VIEW = re.compile(r"\bbat_view(?!point)\w*|->view\b|\.view\b")  # tools ask the stage


def bare(text):
    """The text without comments and string literals, line for line."""
    return re.sub(r'/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.S)


class House:
    def __init__(self, root):
        self.root = root
        self.faults, self.arrows = [], {}
        self.paths = {str(path.relative_to(root / "src")): path for path in sources(root, ["src"], (".c", ".h", ".def"))}
        self.text = {name: path.read_text("utf-8") for name, path in self.paths.items()}
        self.code = {name: bare(text) for name, text in self.text.items()}
        self.lines = 0

    def room(self, name):
        room = name.rsplit("/", 1)[0]
        if room not in ROOMS:
            self.faults.append(f"src/{name}: a folder that is no room of tests/house/check_layers.py")
            return None
        return room

    def header(self, name, place):
        """What an included file belongs to: a room, a file of a room, or None for libc."""
        if name.startswith("batten/"):
            stem = name[len("batten/"):].removesuffix(".h")
            if ROOM_OF_HEADER.get(stem) is None:
                self.faults.append(f"{place}: {name}: " + ("the umbrella header is for users" if stem in ROOM_OF_HEADER
                                   else "a public header without a room in tests/house/check_layers.py"))
                return None
            return ROOM_OF_HEADER[stem] + "/"
        return name

    def may(self, source, target):
        """Whether one file of src/ may use another."""
        here, there = self.room(source), target.rsplit("/", 1)[0]
        if there not in ROOMS or here is None:
            return False
        if target == "editor/editor.h":
            return here == "editor"
        if here == there:
            return here not in SINGLE or target in SINGLE[here] or stem(source) == stem(target)
        if target in TOOLBOX:
            return here.startswith("editor/tools") or ROOMS.index(here) > ROOMS.index(there)
        return ROOMS.index(there) < ROOMS.index(here) and not any({here, there} <= rooms for rooms in APART)

    def includes(self):
        for name, text in self.text.items():
            for found in INCLUDE.finditer(text):
                self.lines += 1
                place = f"src/{name}:{text.count(chr(10), 0, found.start()) + 1}"
                if found[1] == "<" and not found[2].startswith("batten/"):
                    if found[2].removesuffix(".h") not in LIBC:
                        self.faults.append(f"{place}: {found[2]}: not a libc header the core may use")
                    continue
                target = self.header(found[2], place)
                if target and not target.endswith("/") and target not in self.paths and target not in MADE:
                    self.faults.append(f"{place}: {found[2]}: no file of src/")
                elif target and not self.may(name, target):
                    self.arrows.setdefault((name, target.rstrip("/")), place)
        for path in sources(self.root, ["include"], (".h",)):
            if path.stem not in ROOM_OF_HEADER:
                self.faults.append(f"{path.relative_to(self.root)}: give it a room in tests/house/check_layers.py")
                continue
            for found in INCLUDE.finditer(path.read_text("utf-8")):
                self.lines += 1
                target = found[2].startswith("batten/") and ROOM_OF_HEADER.get(path.stem) and \
                    ROOM_OF_HEADER.get(found[2][len("batten/"):-2])
                if target and ROOMS.index(target) > ROOMS.index(ROOM_OF_HEADER[path.stem]):
                    name = str(path.relative_to(self.root))
                    self.arrows.setdefault((name, found[2]), name)

    def calls(self):
        owner = {}
        for name, code in self.code.items():
            if name.endswith(".c"):
                for pattern in (DEFINED, TABLE):
                    for found in pattern.finditer(code):
                        owner[found[1]] = name
        graph = {}
        for name, code in self.code.items():
            if name.endswith(".def"):
                continue
            for word in set(USED.findall(code)):
                target = owner.get(word)
                if not target or target == name or (name.endswith(".h") and stem(name) == stem(target)):
                    continue
                if name.endswith(".c"):
                    graph.setdefault(name, set()).add(target)
                    if not self.may(name, target):
                        self.arrows.setdefault((name, target), f"src/{name}: {word}")
        return graph

    def circles(self, graph):
        """Tarjan's strongly connected components, those of more than one file."""
        index, low, stack, found = {}, {}, [], []

        def visit(node):
            index[node] = low[node] = len(index)
            stack.append(node)
            for other in graph.get(node, ()):
                if other not in index:
                    visit(other)
                if other in stack:
                    low[node] = min(low[node], low[other])
            if low[node] == index[node]:
                ring = set()
                while node not in ring:
                    ring.add(stack.pop())
                if len(ring) > 1:
                    found.append(ring)
        sys.setrecursionlimit(10000)
        for node in sorted(graph):
            if node not in index:
                visit(node)
        return found

    def doors(self):
        """Names that only one room may use."""
        for name, code in self.code.items():
            room = name.rsplit("/", 1)[0]
            if KIND.search(code) and not name.startswith("kinds/"):
                self.arrows.setdefault((name, "BAT_KIND_"), f"src/{name}")
            if "bat_object_kind(" in code and room not in ("kinds", "document"):
                self.arrows.setdefault((name, "bat_object_kind"), f"src/{name}")
            if TOOL.search(code) and room not in ("editor/tables", "editor/tools/modes"):
                self.arrows.setdefault((name, "BAT_TOOL_"), f"src/{name}")
            if room.startswith("editor/tools") and VIEW.search(code):
                self.arrows.setdefault((name, "the view"), f"src/{name}")
            if re.search(r'bat_editor_command\([^;]*"', self.text[name]) and name.endswith(".c"):
                self.arrows.setdefault((name, "a command by its text"), f"src/{name}")
        count = {}
        for name in self.paths:
            if name.endswith(".c"):
                count[name.rsplit("/", 1)[0]] = count.get(name.rsplit("/", 1)[0], 0) + 1
        self.faults += [f"src/{room}: {n} sources, at most {MOST_SOURCES}" for room, n in count.items() if n > MOST_SOURCES]


    def lengths(self):
        """Functions that are too long."""
        for name, text in self.text.items():
            start = 0
            for number, line in enumerate(text.splitlines(), 1):
                if re.match(r"^[A-Za-z].*\) \{$|^ .*\) \{$", line) and (line[0] != " " or not start):
                    start = start if start and line[0] == " " else number
                elif line.startswith("}"):
                    if start and number - start + 1 > MOST_LINES:
                        self.faults.append(f"src/{name}:{start}: a function of {number - start + 1} lines, at most {MOST_LINES}")
                    start = 0


def stem(name):
    return name.rsplit(".", 1)[0]


def main():
    house = House(pathlib.Path(sys.argv[1]))
    house.includes()
    graph = house.calls()
    house.doors()
    house.lengths()
    found = {f"{source} {target}": place for (source, target), place in house.arrows.items()}
    found.update({" ".join(["circle", *sorted(ring)]): "a circle of files" for ring in house.circles(graph)})
    house.faults += [f"{place}: may not be: {arrow}" for arrow, place in sorted(found.items())]
    print("\n".join(house.faults))
    print(f"{len(house.paths)} files and {house.lines} include lines read, {len(house.faults)} faults")
    return 1 if house.faults or house.lines == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
