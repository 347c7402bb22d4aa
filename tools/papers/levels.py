"""The figures of Hwang, Park and Yoon, Multilevel Editing of B-Spline Curves with Robust Orientation of Details (2016)."""
import json
import math

from scene import PALE, THIN, ASKED, Figure, Picture, Session, cubic, document, path, straight

RMF, FRENET, FIXED = 0, 1, 2  # of the property frame-rule


def curves_of(program, made):
    """The curves of all levels of the first shape of a document, base first."""
    shape = next(o for o in made["objects"] if o["kind"] == "shape")["curves"][0]
    return program.json("levels", "-", data=shape)["curves"]


class Levels(Session):
    """A session with the levels tool on one curve, to which levels are added; the finest is then active."""

    def __init__(self, program, name, curve, count):
        super().__init__(name, document(path(1, "curve", curve)))
        self.program, self.active = program, count
        self.command("tool-levels").tap(on(program, curve, 0.3)).command(*["level-add"] * count)

    def to(self, level):
        while self.active != level:
            down = self.active > level
            self.command("level-down" if down else "level-up")
            self.active += -1 if down else 1
        return self

    def document(self):
        return self.program.replay(self.lines)

    def curves(self):
        return curves_of(self.program, self.document())

    def drag(self, moves):
        """Control points of the active level are dragged by so much each: {index: (x, y)}."""
        points = self.curves()[self.active]["points"]
        for i, by in moves.items():
            start = points[i]
            self.stroke(straight(start, (start[0] + by[0], start[1] + by[1])))
        return self

    def repose(self, places):
        """Control points of the base are dragged to these places."""
        points = self.curves()[0]["points"]
        return self.to(0).drag({i: (to[0] - at[0], to[1] - at[1]) for i, (at, to) in enumerate(zip(points, places))
                                if math.dist(at, to) > 1e-9})


def on(program, curve, u):
    return program.json("eval", "-", "--at", u, data=curve)["points"][0]


def nodes(curve):
    p, knots = curve["degree"], curve["knots"]
    if curve["closed"]:
        knots = knots + [knots[-1] + knot - knots[0] for knot in knots[1:p + 1]]
    return [sum(knots[i + 1:i + p + 1]) / p for i in range(len(curve["points"]))]


def details(program, coarse, fine):
    """Of each control point of a level: how far it is along and to the left of the level below, by that level's tangent."""
    new = list(fine["knots"])
    for knot in coarse["knots"]:
        new.remove(knot)
    refined = program.json("curve", "insert", "-", "--at", ",".join(map(repr, new)), data=coarse)["points"]
    at = nodes(fine)
    slope = program.json("eval", "-", "--at", ",".join(map(repr, at)), "--derivatives", 2, data=coarse)["derivatives"]
    made = []
    for i, u in enumerate(at):
        t, d = slope[0][i], [fine["points"][i][k] - refined[i][k] for k in (0, 1)]
        size = math.hypot(*t)
        bend = t[0] * slope[1][i][1] - t[1] * slope[1][i][0]
        made.append(((d[0] * t[0] + d[1] * t[1]) / size, (t[0] * d[1] - t[1] * d[0]) / size, bend))
    return made


def polygon(picture, curve):
    return picture.line(curve["points"], stroke=PALE).dots(curve["points"], 6)


ARCH = [(170, 330), (231, 165), (370, 78), (544, 78), (683, 165), (744, 330)]
WAVE = [(170, 330), (231, 165), (370, 95), (509, 364), (657, 382), (744, 191)]


def normals(program, curve, at, high):
    slope = program.json("eval", "-", "--at", ",".join(map(repr, at)), "--derivatives", 1, data=curve)["derivatives"][0]
    return [(high * t[1] / math.hypot(*t), -high * t[0] / math.hypot(*t)) for t in slope]


def figure_2(program):
    plain = cubic(ARCH)

    def edited(rule, pose):
        made = Levels(program, "2016, Fig. 2", plain, 3).set("frame-rule", rule)
        below, fine = made.curves()[2:]
        aside = normals(program, below, nodes(fine), 62)
        made.drag({i: aside[i] for i in range(3, 25, 3)})
        return made.repose(WAVE) if pose else made

    picture = Picture(program, 1000, 560)
    before = edited(RMF, False).curves()
    after = {rule: edited(rule, True) for rule in (RMF, FRENET, FIXED)}
    results = {rule: made.curves() for rule, made in after.items()}
    polygon(picture.panel(-60, 0, 0.5), plain).curve(plain)
    picture.text((457, 400), "(a) the curve at level 0")
    picture.panel(265, 0, 0.5).curve(before[0], 1.2, THIN).curve(before[3]).text((457, 400), "(b) edited at level 3")
    polygon(picture.panel(590, 0, 0.5), results[RMF][0]).curve(results[RMF][0]).text((457, 450), "(c) level 0 edited again")
    for x, rule, words in ((-60, RMF, "(d) in rotation-minimising frames"), (265, FIXED, "(e) in a fixed system"), (590, FRENET, "(f) in Frenet frames")):
        picture.panel(x, 280, 0.5).curve(results[rule][0], 1.2, THIN).curve(results[rule][3]).text((457, 480), words)
    was = details(program, before[2], before[3])
    rows = []
    for rule, words in ((RMF, "rotation-minimising"), (FRENET, "Frenet"), (FIXED, "fixed")):
        now = details(program, results[rule][2], results[rule][3])
        bumps = [i for i in range(len(was)) if abs(was[i][1]) > 5]
        kept = sum(abs(now[i][1] - was[i][1]) < 1e-6 for i in bumps)
        flipped = sum(abs(now[i][1] + was[i][1]) < 1e-6 for i in bumps)
        rows.append((f"{words}: bumps of {len(bumps)} that stand as they stood; on the other side",
                     {RMF: "all; none", FRENET: "flips", FIXED: "leans"}[rule], f"{kept}; {flipped}"))
    lines = after[RMF]
    return Figure("2016-2", lines.lines, lines.document(), picture, rows)


def figure_1(program):
    """Knots are put in by double taps, which changes nothing; then control points are dragged."""
    plain = cubic([(200, 330), (330, 60), (640, 40), (800, 300)])
    session = Session("2016, Fig. 1", document(path(1, "curve", plain))).command("tool-points").tap(on(program, plain, 0.4))
    for u in (0.25, 0.5, 0.75):
        session.double_tap(on(program, plain, u))
    finer = program.replay(session.lines)["objects"][0]["curves"][0]
    for i, by in ((2, (-10, -70)), (3, (30, 110)), (4, (20, -60))):
        at = finer["points"][i]
        session.stroke(straight(at, (at[0] + by[0], at[1] + by[1])))
    made = program.replay(session.lines)
    edited = made["objects"][0]["curves"][0]
    picture = Picture(program, 1000, 250)
    for x, curve, words in ((-40, plain, "(a) knots 0, 0, 0, 0, 1, 1, 1, 1"), (280, finer, "(b) three more knots"), (600, edited, "(c) control points moved")):
        polygon(picture.panel(x, 0, 0.46), curve).curve(curve).text((500, 430), words)
        picture.dots([on(program, curve, u) for u in sorted(set(curve["knots"]))[1:-1]], 5, ASKED)
    apart = distance(program, plain, finer)
    rows = [("control points: (a), (b)", "4, 7", f"{len(plain['points'])}, {len(finer['points'])}"),
            ("knots put in", "0.25, 0.5, 0.75", ", ".join(f"{knot:.3f}" for knot in finer["knots"][4:-4])),
            ("greatest distance from (a) to (b), of the length", "0", f"{apart:.0e}")]
    return Figure("2016-1", session.lines, made, picture, rows)


def distance(program, one, other):
    """How far two curves with the same parameters are apart, of the first's width; below 1e-12 it is 0."""
    samples = [program.json("eval", "-", "--samples", 501, data=curve)["points"] for curve in (one, other)]
    return round(max(map(math.dist, *samples)) / math.dist(samples[0][0], samples[0][-1]), 12)


BOW = [(100, 330), (230, 60), (480, 60), (620, 300)]
SNAKE = cubic([(120, 120), (320, 420), (660, -30), (860, 300)])


def figure_3(program):
    """Frames along a curve with an inflection in its middle."""
    session = Levels(program, "2016, Fig. 3", SNAKE, 1).set("show-frames", 1)
    picture = Picture(program, 1000, 200)
    at = [i / 24 for i in range(25)]
    points = program.json("eval", "-", "--at", ",".join(map(str, at)), data=SNAKE)["points"]
    rows = []
    for x, kind, words in ((-20, None, "(a) points on the curve"), (310, "frenet", "(b) Frenet frames"), (640, "rmf", "(c) rotation-minimising")):
        picture.panel(x, 10, 0.36).text((500, 470), words)
        if kind:
            side = program.json("frames", "-", "--at", ",".join(map(str, at)), "--kind", kind, data=SNAKE)["s"]
            for p, s in zip(points, side):
                picture.line([p, (p[0] + 90 * s[0], p[1] + 90 * s[1])], 1.5, ASKED)
            turned = sum(a[0] * b[0] + a[1] * b[1] < 0 for a, b in zip(side, side[1:]))
            rows.append((f"{words[4:]}: places where the second axis changes sides", {"frenet": "1", "rmf": "0"}[kind], str(turned)))
        picture.curve(SNAKE).dots(points, 5)
    session.set("frame-rule", FRENET).set("frame-rule", RMF)
    return Figure("2016-3", session.lines, session.document(), picture, rows)


def figure_4(program):
    """One control point of a detail over a straight base raised: the curve draws its basis function."""
    knots = [0] * 4 + [0.12, 0.2, 0.45, 0.7, 0.8] + [1] * 4
    count, number, high = len(knots) - 4, 5, 240
    base = {"degree": 3, "closed": False, "knots": knots,
            "points": [[100 + 800 * sum(knots[i + 1:i + 4]) / 3, 340] for i in range(count)]}
    session = Levels(program, "2016, Fig. 4", base, 1)
    session.drag({number: (0, -high)})
    fine = session.curves()[1]
    at = [i / 400 for i in range(401)]
    found = program.json("eval", "-", "--at", ",".join(map(str, at)), "--derivatives", 1, data=fine)
    slope = [-d[1] / high for d in found["derivatives"][0]]
    inside = [i for i in range(400) if slope[i] > 1e-9 >= slope[i + 1]]
    low, up = at[inside[0]], at[inside[0] + 1]
    for _ in range(50):
        middle = (low + up) / 2
        here = -program.json("eval", "-", "--at", middle, "--derivatives", 1, data=fine)["derivatives"][0][0][1]
        low, up = (middle, up) if here > 0 else (low, middle)
    greville = nodes(fine)[number]
    picture = Picture(program, 1000, 300)
    graph = [(p[0], p[1]) for p in found["points"]]
    steep = max(map(abs, slope))
    lines = [(graph, 340), ([(p[0], 220 - 140 * s / steep) for p, s in zip(graph, slope)], 220)]
    for x, (line, zero), words in zip((-30, 470), lines, ("(a) a basis function", "(b) its derivative")):
        picture.panel(x, 0, 0.55).line([(100, zero), (900, zero)]).line(line, 2.5, "#22262bff").text((500, 470), words)
        picture.line([(100 + 800 * low, zero + 20), (100 + 800 * low, 80)], 1.2, ASKED).text((100 + 800 * low, 66), "node")
        picture.dots([(100 + 800 * knot, zero) for knot in sorted(set(fine["knots"]))], 5)
    rows = [("the node, where the basis function is greatest", "root of Eq. 7", f"{low:.6f}"),
            ("the mean of its three knots (Greville), the default here", "", f"{greville:.6f}")]
    return Figure("2016-4", session.lines, session.document(), picture, rows)


def figure_5(program):
    """A detail (0, h) over a curve whose only inflection is in the middle, in three systems."""
    base = cubic([(150, 290), (350, -90), (600, 510), (800, 130)])
    level, results, session = 4, {}, None
    for rule in (FIXED, FRENET, RMF):
        session = Levels(program, "2016, Fig. 5", base, level).set("frame-rule", rule)
        below, fine = session.curves()[level - 1:]
        at = nodes(fine)
        high = [46 * (i % 3 != 0) * (2 <= i < len(at) - 2) for i in range(len(at))]
        left = normals(program, below, at, 1)
        bends = [d[2] for d in details(program, below, fine)]
        sides = {FIXED: [(0, -1)] * len(at), RMF: left, FRENET: [(s[0] * (1 if b < 0 else -1), s[1] * (1 if b < 0 else -1)) for s, b in zip(left, bends)]}[rule]
        session.drag({i: (h * s[0], h * s[1]) for i, (h, s) in enumerate(zip(high, sides)) if h})
        results[rule] = session.curves()
    graph = {**fine, "points": [[100 + 800 * u, 300 - 3 * h] for u, h in zip(at, high)]}
    picture = Picture(program, 1000, 560)
    picture.panel(20, 0, 0.5).line([(100, 300), (900, 300)]).curve(graph).text((500, 430), "(a) h")
    for x, y, rule, words in ((490, 0, FIXED, "(b) in a fixed system"), (20, 270, FRENET, "(c) in Frenet frames"), (490, 270, RMF, "(d) in rotation-minimising frames")):
        picture.panel(x, y, 0.5).curve(base, 1.2, THIN).curve(results[rule][level]).text((500, 490), words)
    rows = []
    for rule, words, said in ((FIXED, "fixed", "leans"), (FRENET, "Frenet", "flips"), (RMF, "rotation-minimising", "one side")):
        found = [d[1] for d in details(program, results[rule][level - 1], results[rule][level])]
        rows.append((f"{words}: details to the left, to the right", said, f"{sum(d < -1 for d in found)}, {sum(d > 1 for d in found)}"))
    return Figure("2016-5", session.lines, session.document(), picture, rows)


def figure_6(program):
    """Four control points; edited at level 5, then at level 0."""
    plain, bent = cubic(BOW), [(100, 330), (150, 20), (620, 420), (640, 90)]
    session = Levels(program, "2016, Fig. 6", plain, 5)
    below, fine = session.curves()[4:]
    aside = normals(program, below, nodes(fine), 1)
    session.drag({i: tuple((14 + 26 * math.sin(0.1 * i)) * c for c in aside[i]) for i in range(4, 31, 2)})
    before = session.curves()
    session.repose(bent)
    after = session.curves()
    picture = Picture(program, 1000, 470)
    polygon(picture.panel(20, 0, 0.55), before[0]).curve(before[0]).text((360, 400), "(a) level 0")
    picture.panel(520, 0, 0.55).curve(before[0], 1.2, THIN).curve(before[5]).text((360, 400), "(b) edited at level 5")
    polygon(picture.panel(20, 220, 0.55), after[0]).curve(after[0]).text((360, 440), "(c) level 0 edited")
    picture.panel(520, 220, 0.55).curve(after[0], 1.2, THIN).curve(after[5]).text((360, 440), "(d) level 5 after (c)")
    was, now = details(program, before[4], before[5]), details(program, after[4], after[5])
    off = max(math.dist(a[:2], b[:2]) for a, b in zip(was, now))
    rows = [("control points at levels 1 to 5 (Table 2)", "5, 7, 11, 19, 35", ", ".join(str(len(c["points"])) for c in after[1:])),
            ("details that stand to the curve as they stood", "all", f"{sum(math.dist(a[:2], b[:2]) < 1e-6 for a, b in zip(was, now))} of {len(was)}"),
            ("greatest change of a detail, of the curve's width", "", f"{'below 1e-9' if off / 520 < 1e-9 else off / 520}")]
    return Figure("2016-6", session.lines, session.document(), picture, rows)


def figure_7(program, root):
    """The outline of a crocodile with scales; its base bent in two ways."""
    lines = [json.loads(line) for line in (root / "examples/demos/crocodile.journal").read_text().splitlines()]
    start, bent = lines[0]["document"], program.replay(lines)
    other = Session("2016, Fig. 7", start).command("tool-levels").tap((540, 294))
    for a, b in (((500, 168), (500, 230)), ((960, 262), (900, 350)), ((80, 236), (84, 212))):
        other.stroke(straight(a, b))
    third = program.replay(other.lines)
    all_of = {name: curves_of(program, made) for name, made in (("b", start), ("c", bent), ("d", third))}
    picture = Picture(program, 1000, 520)
    first = all_of["b"][0]
    polygon(picture.panel(10, 0, 0.48), first).curve(first).text((500, 420), "(a) level 0")
    for x, y, name, words in ((510, 0, "b", "(b) with the details of its levels"), (10, 250, "c", "(c) level 0 bent"), (510, 250, "d", "(d) level 0 bent otherwise")):
        picture.panel(x, y, 0.48).curve(all_of[name][0], 1.0, THIN).curve(all_of[name][-1], 1.6).text((500, 440), words)
    was = [details(program, *pair) for pair in zip(all_of["b"], all_of["b"][1:])]
    rides = [level.get("source") for level in next(o for o in start["objects"] if o["kind"] == "shape")["curves"][0]["levels"]]
    below = [source is None or source[i] == j for j, (source, one) in enumerate(zip(rides, was)) for i in range(len(one))]
    rows = [("control points at level 0", "30", str(len(first["points"]))),
            ("control points at the finest level", "", str(len(all_of["b"][-1]["points"])))]
    for name in ("c", "d"):
        now = [details(program, *pair) for pair in zip(all_of[name], all_of[name][1:])]
        same = [math.dist(a[:2], b[:2]) < 1e-6 for one, two in zip(was, now) for a, b in zip(one, two)]
        rows.append((f"({name}): details that stand to the level below as they stood", "all",
                     f"{sum(a and b for a, b in zip(same, below))} of {sum(below)}"))
    rows.append(("details that ride on a coarser level, where the one below has a sharp bend", "", str(len(below) - sum(below))))
    return Figure("2016-7", "examples/demos/crocodile.journal", bent, picture, rows)


def seen(curve, turn, tilt):
    """A curve in space as a parallel view shows it: turned about the upright, then tilted, in degrees."""
    c, s, u, w = (f(math.radians(angle)) for angle in (turn, tilt) for f in (math.cos, math.sin))
    points = []
    for x, y, *z in curve["points"]:
        x, y, z = x - 500, y - 210, -(z[0] if z else 0)
        x, y = x * c - y * s, x * s + y * c
        points.append((500 + x, 210 + y * u - z * w))
    return {**curve, "points": points}


def figure_8(program):
    """Edited at level 4, then at levels 1 and 2, then pulled into space."""
    plain = cubic([(120, 300), (260, 120), (420, 120), (580, 300), (720, 300), (880, 180)])
    session = Levels(program, "2016, Fig. 8", plain, 4)
    below, fine = session.curves()[3:]
    aside = normals(program, below, nodes(fine), 26)
    session.drag({i: aside[i] for i in range(3, len(aside) - 2, 3)})
    steps = [session.curves()]
    session.to(1).drag({2: (-20, 60), 5: (30, -70)})
    steps.append(session.curves())
    session.to(2).drag({3: (0, -60), 6: (10, 50)})
    steps.append(session.curves())
    session.command(*["orbit-up"] * 4, "tool-lift")
    # The stroke is drawn in a view 60 degrees off the zenith, over what it lifts.
    tilt, rows = math.radians(60), [y for _, y in steps[2][4]["points"]]
    pivot = (min(rows) + max(rows)) / 2
    way = program.json("eval", "-", "--samples", 161, data=steps[2][4])["points"]
    seat = [(x, pivot + (y - pivot) * math.cos(tilt)) for x, y in way]
    session.tap(seat[40])
    session.stroke([(x, y - 170 * math.sin(math.pi * i / 160) ** 2 * math.sin(tilt)) for i, (x, y) in enumerate(seat)])
    made = session.document()
    space = curves_of(program, made)
    picture = Picture(program, 1000, 720)
    picture.panel(10, -10, 0.48).curve(plain).text((500, 400), "(a) level 0")
    for x, y, curves, words in ((510, -10, steps[0], "(b) edited at level 4"), (10, 210, steps[1], "(c) edited at level 1"), (510, 210, steps[2], "(d) edited at level 2")):
        picture.panel(x, y, 0.48).curve(curves[0], 1.2, THIN).curve(curves[4]).text((500, 440), words)
    for x, turn, words in ((10, 0, "(e) pulled into space"), (510, 35, "(f) the same, turned")):
        picture.panel(x, 470, 0.48).curve(seen(steps[2][4], turn, 60), 1.0, PALE).curve(seen(space[4], turn, 60)).text((500, 450), words)
    flat = program.json("eval", "-", "--samples", 401, data=steps[2][4])["points"]
    high = program.json("eval", "-", "--samples", 401, data=space[4])["points"]
    off = max(min(math.dist(p[:2], q) for q in flat) for p in high)
    rows = [("levels of the curve in space", "0 to 4", f"0 to {len(space) - 1}"),
            ("how far its shadow is from (d), of its width", "", "below 1e-9" if off < 1e-9 * 760 else f"{off / 760:.1e}"),
            ("greatest height over the page", "", f"{max(-p[2] for p in high):.0f}")]
    return Figure("2016-8", session.lines, made, picture, rows)


def figure_9(program, root):
    journal = "examples/space/tori.journal"
    lines = [json.loads(line) for line in (root / journal).read_text().splitlines()]
    before, after = lines[0]["document"], program.replay(lines)

    def path_of(made):
        return next(o for o in made["objects"] if o["kind"] == "shape")["curves"][0]

    rows = [("control points of the path at level 0", "6", str(len(path_of(after)["base"]["points"]))),
            ("level 0 of the path after the edit", "unchanged", "the same bits" if path_of(before)["base"] == path_of(after)["base"] else "changed")]
    pictures = tuple(f"docs/pictures/camera-{letter}.png" for letter in "abcd")
    return Figure("2016-9", journal, after, pictures, rows, ("examples/space/tori batten tori", "batten render tori/after.batten seen.png --view Fly@1.55 --size 640x360"))


def figures(program, root):
    for figure in (figure_1, figure_2, figure_3, figure_4, figure_5, figure_6):
        yield figure(program)
    yield figure_7(program, root)
    yield figure_8(program)
    yield figure_9(program, root)
