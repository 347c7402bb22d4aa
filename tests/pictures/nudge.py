"""Files of others, and a small edit of one."""
import math
import re

MOVED = 1e-4  # of the curve's larger side


def shown_paths(drawing):
    hidden, paths = set(), []
    for thing in drawing["objects"]:
        if thing.get("hidden") or thing.get("parent") in hidden:
            hidden.add(thing["id"])
        elif thing["kind"] == "path" and thing.get("curves"):
            paths.append(thing)
    return paths


def nudge(drawing, chance, by=MOVED):
    """Moves a point of a path by a share of its curve's larger side; False: there is none. Of points that coincide none is moved:
    between those a curve has no direction, and would get any."""
    paths = shown_paths(drawing)
    if not paths:
        return False
    points = chance.choice(chance.choice(paths)["curves"])["points"]
    step = by * (max(max(column) - min(column) for column in zip(*points)) or 1)
    alone = [i for i in range(1, len(points) - 1)
             if min(math.dist(points[i][:2], points[k][:2]) for k in (i - 1, i + 1)) > 30 * step]
    points[chance.choice(alone or range(len(points)))][0] += step
    return True


def is_drawing(path):
    """No list of symbols for other files, and nothing that is compressed or a link to nowhere."""
    return path.is_file() and 0 < path.stat().st_size < 2_000_000 and b"<svg" in path.read_bytes()[:20000] + b"<svg" * (
        b"<svg:svg" in path.read_bytes()[:20000])
