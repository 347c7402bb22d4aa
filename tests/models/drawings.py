"""Twenty drawings with shapes in space, made with the program from few numbers, and how large each is, by numpy alone."""
import json
import math
import pathlib
import subprocess

import numpy

UNITS = {"px": 25.4 / 96, "mm": 1, "in": 25.4}  # millimetres
# Where a place of the page (x right, y down, z away from the eye) is in a file, by whether the page is a floor and y is up there.
AXES = {(False, False): [[1, 0, 0], [0, 0, 1], [0, -1, 0]], (False, True): [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
        (True, False): [[1, 0, 0], [0, -1, 0], [0, 0, -1]], (True, True): [[1, 0, 0], [0, 0, -1], [0, 1, 0]]}


def clamped(count, degree):
    return [min(max(i - degree, 0), count - degree) for i in range(count + degree + 1)]


def curve(points, degree=3, closed=False):
    points = [list(p) for p in points]
    return {"degree": degree, "closed": closed, "points": points,
            "knots": list(range(len(points) + 1)) if closed else clamped(len(points), degree)}


def ring(radius, count=16, middle=(0, 0)):
    angles = [2 * math.pi * i / count for i in range(count)]
    return curve([[middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)] for a in angles], closed=True)


def half_ball(clockwise):
    points = [[100 + 40 * math.sin(math.pi * i / 48), 100 - 40 * math.cos(math.pi * i / 48)] for i in range(49)]
    points[0][0] = points[-1][0] = 100
    return curve(points[::-1] if clockwise else points, 1)


VASE = [[130, 190], [150, 170], [160, 120], [115, 80], [112, 50], [128, 30]]  # upright on the page, beside the axis x = 100
BODY = {"vertices": [[x, y, z] for z in (0, 30) for y in (10, 70) for x in range(10, 131, 10)]}
BODY["faces"] = ([[i, i + 13, i + 14, i + 1] for i in range(12)] + [[26 + i, 27 + i, 40 + i, 39 + i] for i in range(12)]
                 + [[i, i + 1, 27 + i, 26 + i] for i in range(12)] + [[13 + i, 39 + i, 40 + i, 14 + i] for i in range(12)]
                 + [[0, 26, 39, 13], [12, 25, 51, 38]])


WITHOUT_FACES, MESHES = ("curves",), ("mesh", "wired_mesh")


class Maker:
    """Makes drawings into a folder."""

    def __init__(self, program, folder, examples):
        self.program, self.folder, self.examples = program, pathlib.Path(folder), pathlib.Path(examples)

    def batten(self, command, *arguments, **files):
        names = []
        for name, content in files.items():
            names.append(str(self.folder / f"{name}.json"))
            pathlib.Path(names[-1]).write_text(json.dumps(content))
        return json.loads(subprocess.run([self.program, command, *names, *arguments], check=True, capture_output=True).stdout)

    def turned(self, profile, axis="100,0,0,0,1,0"):
        return self.batten("revolve", "--axis", axis, "--tolerance", "1e-5", profile=profile)

    def swept(self, path, profile):
        return self.batten("sweep", "--tolerance", "1e-3", sweep={"path": path, "profile": profile})

    def drawing(self, name, *shapes, unit="mm", plane=False):
        def thing(shape):
            if "vertices" in shape:
                return {"kind": "mesh", "mesh": {"vertices": shape["vertices"], "faces": shape["faces"]}}
            if isinstance(shape["degree"], int):
                return {"kind": "path", "curves": [shape]}
            return {"kind": "surface", "surface": {k: shape[k] for k in ("degree", "closed", "knots", "points")}}
        objects = [{"id": i + 1, "name": "", **thing(shape)} for i, shape in enumerate(shapes)]
        if plane:
            objects.append({"id": len(objects) + 1, "name": "", "kind": "plane", "origin": [0, 0, 0], "axes": [1, 0, 0, 0, 0, 1]})
        path = self.folder / f"{name}.batten"
        path.write_text(json.dumps({"batten": 5, "page": [0, 0, 200, 200], "scale": UNITS[unit], "unit": unit,
                                    "next": len(objects) + 1, "objects": objects}))
        return path

    def all(self):
        """name: (drawing, whether its parts are closed: None: some are)."""
        helix = curve([[100 + 50 * math.cos(i / 2), 190 - 6 * i, 50 * math.sin(i / 2)] for i in range(26)])
        knot = curve([[100 + (40 + 16 * math.cos(1.5 * a)) * math.cos(a), 100 + (40 + 16 * math.cos(1.5 * a)) * math.sin(a), 16 * math.sin(1.5 * a)]
                      for a in (4 * math.pi * i / 48 for i in range(48))], closed=True)
        sides = [curve([[0, 0, 0], [60, -20, 20], [120, 0, 0]]), curve([[0, 90, 0], [60, 120, 60], [120, 90, 0]]),
                 curve([[0, 0, 0], [-20, 45, 30], [0, 90, 0]]), curve([[120, 0, 0], [120, 45, -40], [120, 90, 0]])]
        for side in sides:
            side["degree"], side["knots"] = 2, clamped(3, 2)
        ribs = [curve([[x, 60 + s * math.cos(a), s * math.sin(a)] for a in (2 * math.pi * i / 12 for i in range(12))], closed=True)
                for x, s in ((20, 10), (60, 40), (110, 35), (160, 15))]
        wires = {"wires": [{"reference": curve([[0, 40, 0], [140, 40, 0]], 1), "radius": 90,
                            "curve": curve([[0, 40, 0], [50, 10, 0], [90, 70, 40], [140, 40, 0]])}]}
        cone = curve([[100, 40], [140, 120], [100, 120]], 1)
        can = curve([[130, 40], [130, 140]], 1)
        made = {
            "vase": ([self.turned(curve(VASE))], False), "vase_other_way": ([self.turned(curve(VASE[::-1]))], False),
            "ball": ([self.turned(half_ball(False))], True), "ball_other_way": ([self.turned(half_ball(True))], True),
            "tube": ([self.swept(helix, ring(8))], False), "knot": ([self.swept(knot, ring(6))], True),
            "coons": ([self.batten("coons", c0=sides[0], c1=sides[1], d0=sides[2], d1=sides[3])], False),
            "loft": ([self.batten("loft", *self.files(ribs))], False),
            "wired_mesh": ([self.batten("wire", target=BODY, wires=wires)], True), "mesh": ([BODY], True),
            "cone": ([self.turned(cone)], True), "can": ([self.turned(can)], False),
            "torus": ([self.turned(ring(20, middle=(160, 100)))], True),
            "curves": ([helix, knot], None), "sheet_and_ball": ([self.turned(half_ball(False)), self.turned(can)], None),
        }
        out = {name: (self.drawing(name, *shapes), closed) for name, (shapes, closed) in made.items()}
        out["ball_in_inches"] = self.drawing("ball_in_inches", *made["ball"][0], unit="in"), True
        out["ball_in_pixels"] = self.drawing("ball_in_pixels", *made["ball_other_way"][0], unit="px"), True
        standing = curve([[100, 0, 0], [130, 0, 0], [110, 0, -60], [100, 0, -70]], 1)
        out["on_a_floor"] = self.drawing("on_a_floor", self.turned(standing, "100,0,0,0,0,1"), plane=True), True
        for name in ("jug", "space/relief", "space/turned", "space/character"):
            out[name.split("/")[-1]] = self.examples / f"{name}.batten", None if name == "space/character" else False
        return out

    def files(self, curves):
        for i, content in enumerate(curves):
            path = self.folder / f"rib{i}.json"
            path.write_text(json.dumps(content))
            yield str(path)


# ---- how large they are ----

def basis(degree, closed, knots, count):
    """Values of all basis functions at places of every span, some hundreds in all, both ends among them: places x control points."""
    knots = numpy.array(knots, float)
    if closed:
        period, n = knots[-1] - knots[0], count
        full = numpy.array([knots[(i % n)] + period * (i // n) for i in range(-degree, n + degree + 1)])
    else:
        full = knots
    low, high = degree, len(full) - degree - 1
    spans = [i for i in range(low, high) if full[i + 1] > full[i]]
    rows = []
    for i in spans:
        for t in numpy.linspace(full[i], full[i + 1], 3 + 600 // len(spans)):
            values = [1.0]
            for p in range(1, degree + 1):  # Piegl & Tiller A2.2
                left, right = [t - full[i - k] for k in range(p)], [full[i + 1 + k] - t for k in range(p)]
                fresh, saved = [], 0.0
                for r in range(p):
                    share = values[r] / (right[r] + left[p - 1 - r])
                    fresh.append(saved + right[r] * share)
                    saved = left[p - 1 - r] * share
                values = [*fresh, saved]
            row = numpy.zeros(count)
            for k, value in enumerate(values):
                row[(i - degree + k - (degree if closed else 0)) % count] += value
            rows.append(row)
    return numpy.array(rows)


def places(thing):
    points = numpy.array(thing["points"], float)
    if isinstance(thing["degree"], int):
        return basis(thing["degree"], thing["closed"], thing["knots"], len(points)) @ points
    degree, closed, knots = thing["degree"], thing.get("closed", [False, False]), thing["knots"]
    u, v = (basis(degree[d], closed[d], knots[d], points.shape[d]) for d in range(2))
    along = (u @ points.reshape(len(points), -1)).reshape(len(u), -1, 3)
    return (v @ along).reshape(-1, 3)


def finest(program, relief):
    made = subprocess.run([program, "surface", "levels", "-", "--level", str(len(relief["levels"]))], input=json.dumps(relief).encode(),
                          check=True, capture_output=True)
    return json.loads(made.stdout)


def box(program, drawing, up_is_y, curves):
    """low and high of what a file of it holds, in millimetres, in the file's axes."""
    document = json.loads(pathlib.Path(drawing).read_text())
    upright = any(o["kind"] == "plane" and abs(o["axes"][0] * o["axes"][4] - o["axes"][1] * o["axes"][3]) < 1e-6 for o in document["objects"])
    floor = document.get("stand", "floor" if upright else "wall") == "floor"
    found = []
    for item in document["objects"]:
        if item.get("hidden"):
            continue
        if item["kind"] == "surface":
            found.append(places(item["surface"] if "surface" in item else finest(program, item["relief"])))
        elif item["kind"] == "mesh":
            found.append(numpy.array(item["mesh"]["vertices"], float))
        elif curves and item["kind"] == "path":
            found += [p for p in map(places, item["curves"]) if p.shape[1] == 3]
    all_places = numpy.concatenate(found) * document.get("scale", UNITS["px"]) @ numpy.array(AXES[floor, up_is_y], float).T
    return all_places.min(0), all_places.max(0)
