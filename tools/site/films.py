"""Films of sessions, as GIF: each frame is the drawing as `batten replay` makes it of the journal up to there. On the page, orange is the
way of the pen; in space a film has one view, or is what a camera sees."""
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from pen import CORNER, ZOOM  # noqa: E402

FRAMES, SIZE, FLIGHT = 22, (640, 269), (640, 360)
COLOURS, SHADES = 32, 96  # of a film on the page, and in space
SAMPLED = 8  # frames of which the colours are taken


def animate(root):
    loader = importlib.machinery.SourceFileLoader("animate", str(root / "docs/pictures/animate"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("animate", loader))
    loader.exec_module(module)
    module.SIZE = SIZE
    return module


def film(frames, rests, file, colours=COLOURS):
    """Pictures of one size, each shown for so many ms, as a GIF of one palette."""
    size = frames[0].size
    some = frames[::max(1, len(frames) // SAMPLED)]
    sample = Image.new("RGB", (size[0], len(some) * size[1]))
    for i, frame in enumerate(some):
        sample.paste(frame, (0, i * size[1]))
    palette = sample.quantize(colours, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    frames[0].save(file, save_all=True, append_images=frames[1:], duration=rests, loop=0, optimize=True)


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
    film(frames, rests, file)


def run(program, *words, data=None):
    return subprocess.run([program, *map(str, words)], input=data, check=True, capture_output=True).stdout


def drawing(program, lines, file):
    """What a session leads to, as a native file."""
    run(program, "replay", "-", "--output", file, data="".join(json.dumps(line) + "\n" for line in lines).encode())


def picture(program, file, size, *words):
    png = run(program, "render", file, "-", "--to", "png", *words)
    return Image.open(io.BytesIO(png)).convert("RGB").resize(size, Image.Resampling.LANCZOS)


def seen(program, lines, view, aside, file):
    """The film of a session in space, from one view."""
    wide, tall = view["size"]
    (aside / "view.json").write_text(json.dumps(view), encoding="utf-8")
    steps = [i for i, line in enumerate(lines) if "command" in line or line.get("pointer") in ("move", "up")]
    frames = []
    for end in [*steps[::max(1, len(steps) // FRAMES)], len(lines) - 1]:
        drawing(program, [line for line in lines[:end + 1] if "digest" not in line], aside / "frame.batten")
        frames.append(picture(program, aside / "frame.batten", (SIZE[0], round(SIZE[0] * tall / wide)), "--view", aside / "view.json"))
    film(frames, [700] + [90] * (len(frames) - 2) + [2000], file, SHADES)


def flown(program, lines, aside, file):
    """The film of what the camera of a session's drawing sees."""
    drawing(program, lines, aside / "flight.batten")
    objects = json.loads((aside / "flight.batten").read_text(encoding="utf-8"))["objects"]
    camera = next(one for one in objects if one["kind"] == "camera")
    duration = camera["move"]["timing"]["duration"]
    frames = [picture(program, aside / "flight.batten", FLIGHT, "--view", f"{camera['name']}@{duration * i / (FRAMES - 1):.3f}",
                      "--size", "x".join(map(str, FLIGHT))) for i in range(FRAMES)]
    film(frames, [round(1000 * duration / FRAMES)] * (FRAMES - 1) + [1500], file, SHADES)


def make(program, root, lines, view, file):
    """The film of a session. view: None, on the page; an eye as JSON; or "camera", the drawing's first."""
    with tempfile.TemporaryDirectory() as aside:
        if view == "camera":
            flown(program, lines, pathlib.Path(aside), file)
        elif view:
            seen(program, lines, view, pathlib.Path(aside), file)
        else:
            moving(program, root, lines, file)
