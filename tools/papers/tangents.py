"""The figures of Jou, Park and Lee, Interactive G1 Splines with Tangent Specification Method (1994)."""
import math

from scene import CTRL, PALE, PEN, Figure, Picture, Session, document, straight

FAITHFUL = 0  # of the property spline-mode
CHORD, ARROW = 96.0, 40.0
# At the third and the fourth point: the angle to the incoming and to the outgoing chord, and k, as Table 1 prints them.
TABLE = {4: ((45, 56.3, 0.40689), (56.3, 45, 0.59311)), 5: ((1.2, 100, 0.81263), (100, 1.2, 0.18737)),
         6: ((100, 1.4, 0.09059), (1.4, 100, 0.90941)), 7: ((1.2, 100, 0.81263), (1.4, 99, 0.90953)),
         8: ((99, 1.6, 0.09612), (99, 2.3, 0.24169))}


def rad(degrees):
    return degrees * math.pi / 180


def polygon(figure):
    """The five points on the page, chords 1 : 2.5 : 1, and the headings of the chords."""
    heading, headings, x, y, points = -rad(TABLE[4][0][0]), [], 0.0, 0.0, []
    for i in range(4):
        points.append((x, y))
        if i > 1:
            heading += (1 if i == 2 else -1) * rad(sum(TABLE[figure][i - 2][:2]))
        headings.append(heading - 0.2 if i == 0 else heading)
        length = CHORD * (2.5 if i == 2 else 1)
        x, y = x + length * math.cos(headings[i]), y + length * math.sin(headings[i])
    points.append((x, y))
    middle = [(min(p[k] for p in points) + max(p[k] for p in points)) / 2 for k in (0, 1)]
    return [(500 + p[0] - middle[0], 210 + p[1] - middle[1]) for p in points], headings


def session(number, like, angles):
    """Five points placed; at the third and the fourth an arrow is dragged, so far from the incoming chord."""
    points, headings = polygon(like)
    made = Session(f"1994, Fig. {number}", document()).set("spline-mode", FAITHFUL).command("tool-tangents")
    for i, point in enumerate(points):
        if angles and i in (2, 3):
            turn = headings[i - 1] + (1, -1)[i - 2] * rad(angles[i - 2])
            made.stroke(straight(point, (point[0] + ARROW * math.cos(turn), point[1] + ARROW * math.sin(turn))), modifiers=CTRL)
        else:
            made.tap(point)
    return made.key("Enter").lines


class Result:
    """The spline that a session leads to, and what the program makes of it."""

    def __init__(self, program, lines):
        self.document = program.replay(lines)
        self.spline = next(o for o in self.document["objects"] if o["kind"] == "spline")["spline"]
        self.curve = program.json("tangents", "-", data={k: self.spline[k] for k in ("points", "tangents", "mode") if k in self.spline})
        self.points = self.spline["points"]
        self.chords = [[b[k] - a[k] for k in (0, 1)] for a, b in zip(self.points, self.points[1:])]

    def k(self, i):
        return self.curve["k"][i]

    def angles(self, i):
        """Between the asked direction and the incoming and the outgoing chord, in degrees."""
        return [turn(self.chords[i - 1], self.spline["tangents"][i]), turn(self.spline["tangents"][i], self.chords[i])]

    def built(self, i):
        """The direction that the curve has there: of its segments, which meet in the point."""
        segment = self.curve["bezier"][i]
        return [segment[1][d] - segment[0][d] for d in (0, 1)]


def turn(a, b):
    return abs(math.degrees(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))


def plate(program):
    return Picture(program, 640, 420).panel(-180, 0)


def drawn(picture, made, circles=True):
    """The points, the asked directions, and the curve from the second to the fourth point, as the paper draws it."""
    picture.line(made.points, stroke=PALE)
    for segment in made.curve["bezier"][1:-1]:
        picture.curve({"degree": 3, "closed": False, "knots": [0] * 4 + [1] * 4, "points": segment}, 2.5)
    for i in (2, 3):
        d = made.spline["tangents"][i]
        if circles and d:
            picture.circle(made.points[i], ARROW)
            picture.arrow(made.points[i], [made.points[i][k] + ARROW * d[k] for k in (0, 1)])
    picture.dots(made.points)
    for i, (x, y) in enumerate(made.points):
        away = ARROW + 4 if circles and i in (2, 3) and made.spline["tangents"][i] else 0
        picture.text((x - 8, y + (24 + away if i % 2 else -12 - away)), f"P{i + 1}")
    return picture


def figure_1(program, made):
    """D_R is the diagonal of the parallelogram with the edges a and b."""
    i, k = 2, made.k(2)
    a = [(1 - k) ** 2 / k * c for c in made.chords[1]]
    b = [k * c for c in made.chords[2]]
    p = made.points[i]
    to = [p[d] + a[d] + b[d] for d in (0, 1)]
    picture = drawn(plate(program), made, circles=False)
    picture.line([p, [p[d] + a[d] for d in (0, 1)], to, [p[d] + b[d] for d in (0, 1)], p], 1.5, PEN)
    picture.arrow(p, to).text((to[0] + 18, to[1]), "D_R", anchor="start")
    picture.text((p[0] + a[0] / 2 - 16, p[1] + a[1] / 2), "a").text((p[0] + b[0] / 2 - 10, p[1] + b[1] / 2 + 12), "b")
    ratio = math.hypot(*made.chords[2]) / math.hypot(*made.chords[1])
    by_6 = 1 / (1 + math.sqrt(math.hypot(*a) / math.hypot(*b) * ratio))
    rows = [("k by Eq. 6, from the edges a and b", "", f"{by_6:.5f}"), ("k of the curve", "", f"{k:.5f}"),
            ("D_R to the asked direction, degrees", "0", f"{turn([x - y for x, y in zip(to, p)], made.spline['tangents'][i]):.6f}")]
    return picture, rows


def figure_2(program, made):
    ratio = [math.hypot(*chord) for chord in made.chords]
    picture = plate(program).line(made.points, stroke=PALE).dots(made.points, 8)
    for i, (x, y) in enumerate(made.points):
        picture.text((x - 8, y + (24 if i % 2 else -12)), f"P{i + 1}")
    return picture, [("chord P2P3 to chord P3P4", "1 : 2.5", f"1 : {ratio[2] / ratio[1]:.4f}")]


def figure_3(program, made):
    picture, rows = drawn(plate(program), made), []
    for i in (2, 3):
        first, second = made.angles(i)
        rows += [(f"P{i + 1}: angle to the incoming, the outgoing chord", "", f"{first:.2f}°, {second:.2f}°"),
                 (f"P{i + 1}: k", "", f"{made.k(i):.5f}")]
        picture.text((made.points[i][0] + 48, made.points[i][1] + (18 if i == 2 else -8)), f"{first:.0f}°, {second:.0f}°", anchor="start")
    return picture, rows


def equation_7(upper, lower, ratio):
    return 1 / (1 + math.sqrt(math.sin(rad(upper)) / math.sin(rad(lower)) * ratio))


def figure_of_table(number):
    def figure(program, made):
        rows = []
        for i, (first, second, printed) in zip((2, 3), TABLE[number]):
            ratio = math.hypot(*made.chords[i]) / math.hypot(*made.chords[i - 1])
            here = made.angles(i)
            rows += [(f"P{i + 1}: angle to the incoming, the outgoing chord", f"{first}°, {second}°", f"{here[0]:.1f}°, {here[1]:.1f}°"),
                     (f"P{i + 1}: k by Eq. 7 as printed", f"{printed:.5f}", f"{equation_7(*here, ratio):.4f}"),
                     (f"P{i + 1}: k put right, of the curve", "", f"{made.k(i):.4f}"),
                     (f"P{i + 1}: from the asked direction to the curve's, degrees", "0",
                      f"{turn(made.built(i), made.spline['tangents'][i]):.6f}")]
        return drawn(plate(program), made), rows
    return figure


HALVES = {1: (4, (60, 30)), 2: (4, None), 3: (4, (70, 25))}
DRAW = {1: figure_1, 2: figure_2, 3: figure_3}


def figures(program, root):
    """Number, journal, document, picture and numbers of each figure."""
    for number in range(1, 9):
        like, angles = HALVES.get(number, (number, number > 3 and [row[0] for row in TABLE[number]]))
        lines = session(number, like, angles)
        made = Result(program, lines)
        picture, rows = DRAW.get(number, figure_of_table(number))(program, made)
        yield Figure(f"1994-{number}", lines, made.document, picture, rows)
