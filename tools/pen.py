"""Drawings and strokes of journals that scripts write: a page in the middle of a window, and a pen over it."""
import math

WINDOW, PAGE = (1280, 800), (1000, 420)
ZOOM = min((WINDOW[0] - 64) / PAGE[0], (WINDOW[1] - 64) / PAGE[1])
CORNER = [PAGE[k] / 2 - WINDOW[k] / 2 / ZOOM for k in (0, 1)]
INK = "#22262bff"


def style(width=2.5, stroke=INK, fill=None):
    return {"stroked": True, "stroke": stroke, "width": width, "cap": "round", "join": "round", "miter_limit": 4,
            "filled": fill is not None, "fill": fill or "#00000000", "even_odd": False, "opacity": 1}


def path(number, name, curve, look=None):
    return {"id": number, "kind": "path", "name": name, "style": look or style(), "curves": [curve]}


def document(*objects, page=PAGE):
    return {"batten": 1, "page": [0, 0, *page], "next": len(objects) + 1, "objects": list(objects)}


def straight(*points, step=5.0):
    way = [points[0]]
    for a, b in zip(points, points[1:]):
        count = max(2, round(math.dist(a, b) / step))
        way += [tuple(a[k] + (b[k] - a[k]) * i / count for k in (0, 1)) for i in range(1, count + 1)]
    return way


def stroke(way, time, step=8, modifiers=0):
    """A stroke over places of the page as the lines of a journal, and when it is over."""
    lines = []
    for i, place in enumerate(way):
        x, y = (round((place[k] - CORNER[k]) * ZOOM, 2) for k in (0, 1))
        line = {"pointer": "move" if i else "down", "device": "pen", "id": 1, "buttons": 1, "x": x, "y": y,
                "pressure": 0.5, "time": time}
        lines.append(line | {"modifiers": modifiers} if modifiers else line)
        time += step
    return [*lines, {**lines[-1], "pointer": "up", "buttons": 0, "pressure": 0}], time


def strokes(ways, time=0, gap=2500, step=8):
    lines = []
    for way in ways:
        more, time = stroke(way, time + gap, step)
        lines += more
    return lines
