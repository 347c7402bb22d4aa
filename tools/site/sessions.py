"""A session for each tool, as a journal."""
import json
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from pen import WINDOW, document, path, straight, strokes, style  # noqa: E402

STYLE = style(3)
# The eyes of the sessions in space: some 50 and 60 degrees off the upright.
SHEET = {"eye": [250, 900, -750], "target": [500, 360, 0], "up": [0, -1, -1], "size": [900, 480], "height": 560}
LIFTED = {"eye": [500, 1129, -450], "target": [500, 330, -60], "up": [0, -0.5, -0.87], "size": [900, 480], "height": 480}


def fitted(program, points, tolerance=0.5):
    table = "".join(f"{x:.3f},{y:.3f}\n" for x, y in points).encode()
    made = subprocess.run([program, "fit", "-", "--tolerance", str(tolerance)], input=table, check=True, capture_output=True)
    curve = json.loads(made.stdout)
    return {name: curve[name] for name in ("degree", "knots", "points")} | {"closed": False}


def wave(noise=0.0):
    return [(120 + 4 * i, 220 - 70 * math.sin(i / 30) + noise * math.sin(i * 0.9) + noise * math.sin(i * 0.37)) for i in range(191)]


def drawing(program, curves):
    return document(*(path(1 + i, "line", curve, STYLE) for i, curve in enumerate(curves)))


def tap(*place):
    return [place] * 2


def session(document, tool, ways, *after):
    head = [{"journal": "batten", "version": 1, "name": f"{tool}.svg", "document": document}, {"resize": [*WINDOW, 1]},
            {"set": "tolerance", "value": 1}, {"command": f"tool-{tool}"}]
    return head + strokes(ways) + list(after)


def lines_of(path):
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def sessions(program, root):
    """The tools that change a drawing: what is done with each, and how it is seen (films.make)."""
    plain, empty = fitted(program, wave()), drawing(program, [])
    top = min(wave(), key=lambda place: place[1])
    bold = document(path(1, "line", plain, STYLE), path(2, "bold", fitted(program, [(x, y + 110) for x, y in wave()]), style(9)))
    kept = {"sketch": ("docs/pictures/car.journal", None), "levels": ("examples/demos/crocodile.journal", None),
            "surface": ("examples/space/sheet.journal", SHEET), "lift": ("examples/space/lifted.journal", LIFTED)}
    made = {
        "points": session(drawing(program, [plain]), "points", [tap(*top), straight(top, (top[0] - 30, top[1] - 70))]),
        "smooth": session(drawing(program, [fitted(program, wave(4), 0.3)]), "smooth", [wave()[10:180:2], wave()[10:180:2][::-1]]),
        "eraser": session(drawing(program, [plain]), "eraser", [wave()[60:110]]),
        "tangents": session(empty, "tangents",
                            [straight((150, 300), (210, 240)), straight((380, 120), (460, 120)), straight((640, 280), (720, 300)),
                             straight((860, 130), (880, 90))], {"key": "Enter", "down": True, "time": 20000}),
        "line": session(empty, "line", [straight((150, 320), (420, 90)), straight((420, 90), (820, 300))]),
        "rectangle": session(empty, "rectangle", [straight((200, 100), (560, 310)), straight((640, 160), (820, 300))]),
        "ellipse": session(empty, "ellipse", [straight((200, 100), (560, 310)), straight((640, 160), (820, 300))]),
        "polygon": session(empty, "polygon", [straight((330, 210), (330, 60)), straight((690, 230), (780, 230))]),
        "circle": session(empty, "circle", [tap(330, 260), tap(470, 90), tap(640, 230)]),
        "width": session(drawing(program, [plain]), "width", [tap(*top), straight(top, (top[0], top[1] - 26))]),
        "eyedropper": session(bold, "select", [tap(*top)], {"command": "tool-eyedropper"}, *strokes([tap(top[0], top[1] + 110)], 30000)),
        "select": session(drawing(program, [plain]), "select", [tap(*top), straight(top, (top[0] + 60, top[1] + 110))]),
    }
    return {name: (lines_of(root / file), view) for name, (file, view) in kept.items()} | {name: (lines, None) for name, lines in made.items()}
