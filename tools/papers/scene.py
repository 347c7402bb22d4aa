"""What the figures of the papers are made with: the program, sessions as journals, and pictures from what they lead to."""
import html
import json
import math
import pathlib
import re
import subprocess
import tempfile
import sys
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import pen  # noqa: E402
from pen import INK, WINDOW, document, path, straight, style  # noqa: E402, F401

PALE, THIN, ASKED, PEN, POINT = "#ced4daff", "#8b95a1ff", "#7a3fd1ff", "#e8590cff", "#1f62d6ff"
CTRL = 2


class Program:
    """The program batten; what it answers, as JSON."""

    def __init__(self, path):
        self.path = path

    def __call__(self, *words, data=None):
        text = data if isinstance(data, (str, type(None))) else json.dumps(data)
        made = subprocess.run([self.path, *map(str, words)], input=text, capture_output=True, text=True)
        if made.returncode:
            raise SystemExit(f"batten {' '.join(map(str, words))}: {made.stderr.strip()}")
        return made.stdout

    def json(self, *words, data=None):
        return json.loads(self(*words, data=data))

    def replay(self, lines):
        """The document that a journal leads to."""
        with tempfile.TemporaryDirectory() as aside:
            made = pathlib.Path(aside) / "made.batten"
            self("replay", "-", "--check", "--output", made, data="".join(json.dumps(line) + "\n" for line in lines))
            return json.loads(made.read_text())

    def sketch(self, curve, stroke, tolerance):
        """What `batten sketch` makes of a curve and a stroke, with its report."""
        with tempfile.TemporaryDirectory() as aside:
            names = [pathlib.Path(aside) / name for name in ("curve.json", "stroke.json")]
            for name, made in zip(names, (curve, stroke)):
                name.write_text(json.dumps(made))
            return self.json("sketch", *names, "--tolerance", tolerance)


def polyline(points, closed=False):
    count = len(points)
    knots = list(range(count + 1)) if closed else [0, *range(count), count - 1]
    return {"degree": 1, "closed": closed, "knots": knots, "points": [list(point) for point in points]}


def cubic(points, knots=None):
    inner = len(points) - 3
    return {"degree": 3, "closed": False, "knots": knots or [0] * 4 + [i / inner for i in range(1, inner)] + [1] * 4,
            "points": [list(point) for point in points]}


class Session:
    """A session of the pen, as a journal: places are those of the page."""

    def __init__(self, name, start, *settings):
        self.lines = [{"journal": "batten", "version": 1, "name": f"{name}.svg", "document": start}, {"resize": [*WINDOW, 1]}]
        self.lines += settings
        self.time = 0

    def command(self, *names):
        self.lines += [{"command": name} for name in names]
        return self

    def set(self, name, value):
        self.lines.append({"set": name, "value": value})
        return self

    def key(self, name):
        self.time += 500
        self.lines.append({"key": name, "down": True, "time": self.time})
        return self

    def stroke(self, way, modifiers=0, gap=2500):
        lines, self.time = pen.stroke(way, self.time + gap, modifiers=modifiers)
        self.lines += lines
        return self

    def tap(self, place, **words):
        return self.stroke([place] * 2, **words)

    def double_tap(self, place):
        return self.tap(place).tap(place, gap=120)


class Picture:
    """Curves, polygons and words side by side; drawn by `batten render`."""

    def __init__(self, program, width, height):
        self.program, self.size, self.objects, self.texts = program, (width, height), [], []
        self.move, self.scale = (0, 0), 1

    def panel(self, x, y, scale=1.0, caption=None):
        """What follows is moved to x, y, and scaled; the caption stands there."""
        self.move, self.scale = (x, y), scale
        if caption:
            self.texts.append((x, y, 15, "start", caption))
        return self

    def place(self, point):
        return [self.move[k] + self.scale * point[k] for k in (0, 1)]

    def curve(self, curve, width=2.0, stroke=INK):
        moved = {**{k: curve[k] for k in ("degree", "closed", "knots")}, "points": [self.place(point) for point in curve["points"]]}
        self.objects.append(path(len(self.objects) + 1, "", moved, style(width, stroke)))
        return self

    def line(self, points, width=1.0, stroke=THIN, closed=False):
        return self.curve(polyline(points, closed), width, stroke)

    def dots(self, points, size=6.0, stroke=POINT):
        for x, y in points:
            self.line([(x, y), (x + 0.01 / self.scale, y)], size, stroke)
        return self

    def circle(self, middle, radius, width=1.0, stroke=THIN):
        return self.line([(middle[0] + radius * math.cos(t * math.pi / 40), middle[1] + radius * math.sin(t * math.pi / 40))
                          for t in range(80)], width, stroke, closed=True)

    def arrow(self, start, end, width=2.0, stroke=ASKED, head=9.0):
        length = math.dist(start, end)
        d = [(end[k] - start[k]) / length * head / self.scale for k in (0, 1)]
        wings = [(end[0] - d[0] + side * d[1] / 2, end[1] - d[1] - side * d[0] / 2) for side in (1, -1)]
        return self.line([start, end], width, stroke).line([wings[0], end, wings[1]], width, stroke)

    def text(self, point, words, size=14, anchor="middle"):
        self.texts.append((*self.place(point), size, anchor, words))
        return self

    def svg(self):
        made = self.program("render", "-", "-", "--to", "svg", "--background", "white", data=document(*self.objects, page=self.size))
        words = "".join(f'<text x="{x:.1f}" y="{y:.1f}" font-family="sans-serif" font-size="{size}" fill="#59616c" '
                        f'text-anchor="{anchor}">{html.escape(text)}</text>\n' for x, y, size, anchor, text in self.texts)
        return re.sub(r"\d+\.\d{3,}", lambda found: f"{float(found[0]):.2f}", made).replace("</svg>", words + "</svg>")


@dataclass
class Figure:
    """What stands in a page in a figure's place: rows are what is measured, the paper's value, and the one here."""
    name: str
    journal: list | str  # lines, or a file of the project that has them
    document: dict | str  # or a file of the project
    picture: Picture | str | tuple  # files of docs/pictures, where another command makes them
    rows: list
    commands: tuple = ()
