"""A session for each tool, as a journal, and the moving picture of it: each frame is the drawing as `batten replay` makes it of
the journal up to there; orange is the way of the pen."""
import importlib.machinery
import importlib.util
import json
import math
import pathlib
import subprocess
import sys

from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from pen import CORNER, WINDOW, ZOOM, document, path, straight, strokes, style  # noqa: E402

FRAMES, SIZE, COLOURS = 22, (640, 269), 32
STYLE = style(3)


def animate(root):
    loader = importlib.machinery.SourceFileLoader("animate", str(root / "docs/pictures/animate"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("animate", loader))
    loader.exec_module(module)
    module.SIZE = SIZE
    return module


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


def sessions(program, root):
    """The tools that change a drawing, and what is done with each."""
    plain = fitted(program, wave())
    top = min(wave(), key=lambda place: place[1])
    journals = {name: [json.loads(line) for line in (root / path).read_text().splitlines()]
                for name, path in (("sketch", "docs/pictures/car.journal"), ("levels", "examples/demos/crocodile.journal"))}
    return journals | {
        "points": session(drawing(program, [plain]), "points", [tap(*top), straight(top, (top[0] - 30, top[1] - 70))]),
        "smooth": session(drawing(program, [fitted(program, wave(4), 0.3)]), "smooth", [wave()[10:180:2], wave()[10:180:2][::-1]]),
        "eraser": session(drawing(program, [plain]), "eraser", [wave()[60:110]]),
        "tangents": session(drawing(program, []), "tangents",
                            [straight((150, 300), (210, 240)), straight((380, 120), (460, 120)), straight((640, 280), (720, 300)),
                             straight((860, 130), (880, 90))], {"key": "Enter", "down": True, "time": 20000}),
        "line": session(drawing(program, []), "line", [straight((150, 320), (420, 90)), straight((420, 90), (820, 300))]),
        "rectangle": session(drawing(program, []), "rectangle", [straight((200, 100), (560, 310)), straight((640, 160), (820, 300))]),
        "ellipse": session(drawing(program, []), "ellipse", [straight((200, 100), (560, 310)), straight((640, 160), (820, 300))]),
        "polygon": session(drawing(program, []), "polygon", [straight((330, 210), (330, 60)), straight((690, 230), (780, 230))]),
        "select": session(drawing(program, [plain]), "select", [tap(*top), straight(top, (top[0] + 60, top[1] + 110))]),
    }


def moving(program, root, lines, file):
    """The moving picture of a journal."""
    maker = animate(root)
    lines = [line for line in lines if line.get("pointer") not in ("hover", "leave")]
    events = [i for i, line in enumerate(lines) if "pointer" in line]
    ups = {i for i in events if lines[i]["pointer"] == "up"}
    step = max(1, len(events) // FRAMES)
    ends = sorted(ups | set(events[step::step]))
    first = events[0]
    frames, rests = [maker.frame(program, lines[:first], ZOOM, CORNER)], [700]
    for end in ends:
        frames.append(maker.frame(program, lines[:end + 1], ZOOM, CORNER))
        rests.append(500 if end in ups else 70)
    frames.append(maker.frame(program, lines, ZOOM, CORNER))
    rests.append(2000)
    colours = Image.new("RGB", (SIZE[0], 3 * SIZE[1]))
    for i, k in enumerate((0, len(frames) // 2, -1)):
        colours.paste(frames[k], (0, i * SIZE[1]))
    palette = colours.quantize(COLOURS, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    frames[0].save(file, save_all=True, append_images=frames[1:], duration=rests, loop=0, optimize=True)
