"""The figures of Kim and Kim, Sketch-based Modification of the Cubic B-Splines for the Pen-input Displays (2005)."""
import json
import math

from scene import ASKED, PALE, PEN, THIN, Figure, Picture, Session, cubic, document, path

TOLERANCE = 1
BASE = cubic([(80, 300), (230, 110), (430, 330), (620, 90), (780, 300), (920, 200)])


def at(program, curve, parameters, order=0):
    made = program.json("eval", "-", "--at", ",".join(map(repr, parameters)), "--derivatives", order, data=curve)
    return made["points"] if order == 0 else (made["points"], made["derivatives"])


def spread(curve, first, last, count=120):
    """Parameters at shares of the curve's domain."""
    low, high = curve["knots"][curve["degree"]], curve["knots"][-curve["degree"] - 1]
    return [low + (high - low) * (first + (last - first) * i / count) for i in range(count + 1)]


def over(program, curve, first, last, height):
    """A stroke over a part of a curve, which it leaves by height(share) across."""
    parameters = spread(curve, first, last)
    points, slopes = at(program, curve, parameters, 1)
    way = []
    for i, (p, t) in enumerate(zip(points, slopes[0])):
        size, high = math.hypot(*t), height(i / 120)
        way.append((p[0] + high * t[1] / size, p[1] - high * t[0] / size))
    return way


def hump(high, count=1):
    return lambda share: high * math.sin(math.pi * count * share) * math.sin(math.pi * share)


class Sketch(Session):
    def __init__(self, program, name, curve):
        super().__init__(name, document(path(1, "curve", curve)))
        self.program = program
        self.set("tolerance", TOLERANCE).command("tool-sketch")

    def document(self):
        made = self.program.replay(self.lines)
        if len(made["objects"]) != 1:
            raise SystemExit(f"{self.lines[0]['name']}: a stroke became a curve of its own")
        return made

    def curve(self):
        return self.document()["objects"][0]["curves"][0]

    def over(self, first, last, height):
        return self.along(over(self.program, self.curve(), first, last, height))

    def along(self, way):
        self.stroke(way)
        self.way = way
        return self


def inner(curve):
    p = curve["degree"]
    return curve["knots"][p + 1:-p - 1]


def plate(program):
    return Picture(program, 1000, 330).panel(0, -70)


def polygons(picture, before, after, way):
    picture.line(before["points"], stroke=PALE).curve(before, 1.2, THIN).line(way, 6, PEN[:7] + "55")
    return picture.line(after["points"], 1.2, "#74a3f0ff").dots(after["points"], 5).curve(after, 2.5)


def away(program, way, curve):
    """How far the stroke is from the curve at most."""
    samples = program.json("eval", "-", "--samples", 4001, data=curve)["points"]
    return max(min(math.dist(p, q) for q in samples) for p in way)


def kept(before, after):
    """Control points at the start and at the end that are the same, bit for bit."""
    one, other = before["points"], after["points"]
    ends = []
    for a, b in ((one, other), (one[::-1], other[::-1])):
        ends.append(next((i for i, (p, q) in enumerate(zip(a, b)) if p != q), min(len(a), len(b))))
    return ends


def redrawn(program, number, curve, first, last, height):
    session = Sketch(program, f"2005, Fig. {number}", curve).over(first, last, height)
    after = session.curve()
    rows = [("inner knots before, after", "", f"{len(inner(curve))}, {len(inner(after))}"),
            ("knots that are double", "0", str(sum(a == b for a, b in zip(inner(after), inner(after)[1:])))),
            ("stroke to curve, greatest distance, px", "", f"{away(program, session.way, after):.2f}"),
            ("control points that stay, bit for bit, at the start, at the end", "", "{}, {}".format(*kept(curve, after)))]
    picture = polygons(plate(program), curve, after, session.way)
    return session, after, picture, rows


def figure_1(program):
    session, after, _, rows = redrawn(program, 1, BASE, 0.36, 0.66, hump(60))
    stroke = {"points": session.way}
    near = [program.json("nearest", "-", "--point", f"{p[0]!r},{p[1]!r}", data=BASE) for p in (session.way[0], session.way[-1])]
    changed = program.sketch(BASE, stroke, TOLERANCE)["report"]["changed"]
    picture = Picture(program, 1000, 610)
    places = at(program, BASE, [changed[0], near[0]["u"], near[1]["u"], changed[1]])
    picture.panel(0, -60).curve(BASE, 2).line(session.way, 5, PEN).dots(places, 8)
    for p, words, down in zip(places, ("t_k", "u_s", "u_e", "t_l"), (26, 44, 44, 26)):
        picture.text((p[0], p[1] + down), words)
    picture.text((500, 360), "the curve, the pen marking, and where the change begins and ends")
    picture.panel(0, 230).curve(BASE, 1.2, PALE).curve(after, 2.5).text((500, 360), "the curve modified")
    picture.dots(at(program, after, inner(after)), 5, ASKED)
    rows.insert(0, ("interval that changes, u_s to u_e inside it", "[t_k, t_l]", f"[{changed[0]:.3f}, {changed[1]:.3f}], {near[0]['u']:.3f} to {near[1]['u']:.3f}"))
    return Figure("2005-1", session.lines, session.document(), picture, rows)


def figure_2(program):
    """The stroke leaves the curve and goes beyond its end."""
    first = over(program, BASE, 0.78, 0.97, lambda share: 0.0)
    d = [(first[-1][k] - first[-8][k]) / math.dist(first[-1], first[-8]) for k in (0, 1)]
    way = first + [(first[-1][0] + 2.5 * i * d[0] * 0.9, first[-1][1] + 2.5 * i * d[1] * 0.9 - 0.006 * i * i) for i in range(1, 50)]
    start = {**BASE, "points": [[0.8 * x, y] for x, y in BASE["points"]]}
    way = [(0.8 * x, y) for x, y in way]
    session = Sketch(program, "2005, Fig. 2", start).along(way)
    after = session.curve()
    picture = polygons(plate(program), start, after, way)
    rows = [("from the curve's end to the stroke's, px", "0", f"{math.dist(after['points'][-1], way[-1]):.2f}"),
            ("stroke to curve, greatest distance, px", "", f"{away(program, way, after):.2f}")]
    return Figure("2005-2", session.lines, session.document(), picture, rows)


def figure_3(program):
    """The knots of the curve, and those of what replaces a part of it."""
    dense = {**BASE}
    knots = [0.15, 0.3, 0.42, 0.5, 0.58, 0.7, 0.85]
    dense = program.json("curve", "insert", "-", "--at", ",".join(map(str, knots)), data=dense)
    dense = {k: dense[k] for k in ("degree", "closed", "knots", "points")}
    session, after, _, rows = redrawn(program, 3, dense, 0.42, 0.6, hump(40))
    picture = Picture(program, 1000, 460).panel(0, -50)
    low, high = program.sketch(dense, {"points": session.way}, TOLERANCE)["report"]["changed"]
    polygons(picture, dense, after, session.way)
    for y, curve, words in ((440, dense, "T"), (485, after, "T_loc in T")):
        end = curve["knots"][-1]
        scale = 820 / dense["knots"][-1]
        picture.line([(120, y), (120 + scale * end, y)]).text((96, y + 5), words, anchor="end")
        for knot in sorted(set(curve["knots"])):
            picture.line([(120 + scale * knot, y - 9), (120 + scale * knot, y + 9)], 1.5, ASKED if low < knot < high else "#22262bff")
    left = [a == b for a, b in zip(dense["knots"], after["knots"])].index(False)
    rows.append(("knots of T before t_k that stay", "all", str(left)))
    return Figure("2005-3", session.lines, session.document(), picture, rows)


def figure_4(program):
    """A knot put in near the end of an interval, and the control point that moves along the first edge."""
    curve, knot = cubic([(80, 330), (180, 90), (380, 50), (560, 300), (760, 320), (920, 120)]), 0.42
    session = Session("2005, Fig. 4", document(path(1, "curve", curve))).command("tool-points").tap(at(program, curve, [0.2])[0])
    session.double_tap(at(program, curve, [knot])[0])
    made = program.replay(session.lines)
    finer = made["objects"][0]["curves"][0]
    new = next(k for k in finer["knots"] if k not in curve["knots"])
    span = max(i for i, k in enumerate(curve["knots"]) if k <= new)
    rows = []
    for i in range(span - 2, span + 1):
        share = (new - curve["knots"][i]) / (curve["knots"][i + 3] - curve["knots"][i])
        edge = [curve["points"][i - 1], curve["points"][i]]
        found = math.dist(finer["points"][i], edge[0]) / math.dist(*edge)
        rows.append((f"share of the edge from P{i - 1} to P{i}", f"{share:.6f} (Eq. 1)", f"{found:.6f}"))
    picture = Picture(program, 1000, 400).line(curve["points"], stroke=THIN).dots(curve["points"], 8, THIN)
    picture.line(finer["points"], 1.5, "#74a3f0ff").dots(finer["points"], 6).curve(finer).dots(at(program, finer, [new]), 8, ASKED)
    return Figure("2005-4", session.lines, made, picture, rows)


ROOF = cubic([(60, 330), (300, 150), (640, 140), (940, 330)])


def figures_5_to_7(program):
    """One curve, made more complex twice and then plain again by one stroke; each figure begins where the one before ended."""
    session, five, picture, rows = redrawn(program, 5, ROOF, 0.15, 0.5, hump(46, 2))
    yield Figure("2005-5", session.lines, session.document(), picture, rows)
    session, six, picture, rows = redrawn(program, 6, five, 0.55, 0.9, hump(-44, 2))
    yield Figure("2005-6", session.lines, session.document(), picture, rows)
    plain = over(program, ROOF, 0.0, 1.0, lambda share: 6 * math.sin(math.pi * share))
    simple = Sketch(program, "2005, Fig. 7", six).along(plain)
    after = simple.curve()
    rows = [("inner knots of Fig. 6, after the stroke", "fewer", f"{len(inner(six))}, {len(inner(after))}"),
            ("control points", "fewer", f"{len(six['points'])}, {len(after['points'])}"),
            ("stroke to curve, greatest distance, px", "", f"{away(program, plain, after):.2f}")]
    yield Figure("2005-7", simple.lines, simple.document(), polygons(plate(program), six, after, plain), rows)


def figure_8(program):
    """An almost straight line, sketched towards a shape."""
    line = cubic([(60, 300), (350, 296), (660, 298), (940, 302)])
    session, steps = Sketch(program, "2005, Fig. 8", line), []
    for first, last, height in ((0.05, 0.42, hump(60)), (0.36, 0.72, hump(95)), (0.7, 0.97, hump(-50)), (0.3, 0.5, hump(24))):
        before = session.curve()
        session.over(first, last, height)
        steps.append((before, session.way, session.curve()))
    picture = Picture(program, 1000, 760)
    for row, (before, way, after) in enumerate(steps):
        picture.panel(10, 190 * row - 40, 0.48).curve(before).line(way, 6, PEN)
        picture.panel(510, 190 * row - 40, 0.48).curve(before, 1.2, THIN).curve(after)
    last = steps[-1][2]
    rows = [("strokes", "4", str(len(steps))), ("inner knots in the end", "", str(len(inner(last)))),
            ("continuity", "C2", "C2" if len(set(inner(last))) == len(inner(last)) else "less")]
    return Figure("2005-8", session.lines, session.document(), picture, rows)


def surface_of(made, name):
    return next(o for o in made["objects"] if o["kind"] == "surface" and o["name"] == name)["surface"]


def net(surface):
    return len(surface["points"]), len(surface["points"][0])


def moved(before, after):
    """Control points of a net that are not where they were; both nets have the same size."""
    return sum(p != q for one, other in zip(before["points"], after["points"]) for p, q in zip(one, other))


def of_surface(program, root, number, name, picture, rows):
    journal = f"examples/space/{name}.journal"
    lines = [json.loads(line) for line in (root / journal).read_text().splitlines()]
    before, made = lines[0]["document"], program.replay(lines)
    there = f"examples/space/{name}.batten"
    return Figure(f"2005-{number}", journal, there if (root / there).is_file() else made, picture, rows(before, made))


def of_net(name, knots_from):
    def rows(before, made):
        one, other = surface_of(before, name), surface_of(made, name)
        return [("control points before, after", "", "{} by {}, {} by {}".format(*net(one), *net(other))),
                (f"knots that the surface had and has, {knots_from}", "all", "{} of {}".format(
                    sum(k in set(other["knots"][0]) for k in set(one["knots"][0])), len(set(one["knots"][0]))))]
    return rows


def of_wire(before, made):
    one, other = surface_of(before, "body"), surface_of(made, "body")
    return [("control points of the body", "", "{} by {}".format(*net(other))),
            ("control points that follow the wire", "", str(moved(one, other)))]


def bars(program, counts):
    """What the two scripts do, as the paper's bars show times: left sketching, right control points."""
    picture = Picture(program, 760, 300)
    for row, (what, pair) in enumerate(counts):
        most = max(pair)
        for side, value in enumerate(pair):
            y = 40 + 85 * row + 30 * side
            picture.line([(230, y), (230 + 420 * value / most, y)], 18, ("#1f62d6ff", THIN)[side])
            picture.text((230 + 420 * value / most + 22, y + 5), f"{value:g}", anchor="start")
        picture.text((210, 60 + 85 * row), what, anchor="end")
    return picture.text((230, 285), "blue: sketching; grey: control points", anchor="start")


def figures_of_people(program, root):
    """The silhouette, by the two scripted hands that stand in for people."""
    table = (root / "docs/user-test.md").read_text(encoding="utf-8").partition("<!-- table -->")[2].partition("<!-- end -->")[0]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith("|")]
    found = {row[0]: row[1:] for row in cells}

    def made(name):
        return program.replay([json.loads(line) for line in (root / f"examples/silhouette/{name}.journal").read_text().splitlines()])

    yield Figure("2005-12", "examples/silhouette/sketch.journal", made("sketch"), "docs/pictures/silhouette.png",
                 [("greatest error of sketching, of control points, px", "", ", ".join(found["greatest error, px"]))],
                 ("examples/silhouette/picture batten silhouette.png",))
    counted = [(what, [float(cell) for cell in found[what]]) for what in ("gestures", "pen-downs", "travel above it, px")]
    yield Figure("2005-13", "examples/silhouette/points.journal", made("points"), bars(program, counted),
                 [(f"{what}: sketching, control points", {"gestures": "times, ten people"}.get(what, ""), ", ".join(found[what]))
                  for what, _ in counted],
                 ("examples/silhouette/measure.py batten examples/silhouette/sketch.journal",))


def figures(program, root):
    yield figure_1(program)
    yield figure_2(program)
    yield figure_3(program)
    yield figure_4(program)
    yield from figures_5_to_7(program)
    yield figure_8(program)
    yield of_surface(program, root, 9, "sheet", "docs/pictures/sheet.svg", of_net("sheet", "across the line"))
    yield of_surface(program, root, 10, "jug", "docs/pictures/jug.svg", of_net("jug", "across the line"))
    yield of_surface(program, root, 11, "character", ("docs/pictures/car-sheet.png", "docs/pictures/car-line.png"), of_wire)
    yield from figures_of_people(program, root)
