"""Shapes in space leave a drawing in true size, upright and outward: STL, 3MF, PLY, glTF, USD, STEP, IGES and OBJ, read here without Batten."""

import base64
import collections
import io
import json
import math
import re
import struct
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile

from program import ProgramTest

UNITS = {"px": 25.4 / 96, "mm": 1, "in": 25.4}


# Where a place of the page (x right, y down, z away from the eye) is in the file.
WALL = {"stl": lambda x, y, z: (x, z, -y), "glb": lambda x, y, z: (x, -y, -z)}
FLOOR = {"stl": lambda x, y, z: (x, -y, -z), "glb": lambda x, y, z: (x, -z, y)}
for ways in (WALL, FLOOR):
    ways["step"] = ways["igs"] = ways["stl"]


def triangles_of_stl(data):
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count
    return [tuple(struct.unpack_from("<3f", data, 84 + 50 * i + 12 + 12 * k) for k in range(3)) for i in range(count)]


def triangles_of_glb(data):
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size = struct.unpack_from("<I", data, 12)[0]
    scene, body = json.loads(data[20:20 + size]), data[28 + size:]
    out = []
    for mesh in scene["meshes"]:
        for part in mesh["primitives"]:
            if part.get("mode", 4) != 4:
                continue

            def numbers(index, form, width):
                accessor = scene["accessors"][index]
                view = scene["bufferViews"][accessor["bufferView"]]
                start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
                return list(struct.iter_unpack(form, body[start:start + accessor["count"] * width]))

            places = numbers(part["attributes"]["POSITION"], "<3f", 12)
            wide = scene["accessors"][part["indices"]]["componentType"]
            corners = [i for (i,) in numbers(part["indices"], *{5125: ("<I", 4), 5123: ("<H", 2)}[wide])]
            out += [tuple(places[corners[i + k]] for k in range(3)) for i in range(0, len(corners), 3)]
    return out


def triangles_of_obj(data):
    places, out = [], []
    for line in data.decode().splitlines():
        words = line.split()
        if words[0] == "v":
            places.append(tuple(map(float, words[1:])))
        elif words[0] == "f":
            out.append(tuple(places[int(word.split("/")[0]) - 1] for word in words[1:]))
    return out


CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def triangles_of_3mf(data):
    """Of a package as the core specification wants it: its parts, types and relation; every edge of an object twice, by number."""
    with zipfile.ZipFile(io.BytesIO(data)) as package:
        assert package.testzip() is None
        assert package.namelist() == ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]
        types = {e.get("Extension"): e.get("ContentType") for e in ElementTree.fromstring(package.read("[Content_Types].xml"))}
        assert types == {"rels": "application/vnd.openxmlformats-package.relationships+xml",
                         "model": "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"}
        relation = ElementTree.fromstring(package.read("_rels/.rels"))[0]
        assert relation.get("Target") == "/3D/3dmodel.model"
        assert relation.get("Type") == "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
        model = ElementTree.fromstring(package.read("3D/3dmodel.model"))
    assert model.tag == CORE + "model" and model.get("unit") == "millimeter"
    objects = {e.get("id"): e for e in model.find(CORE + "resources")}
    out = []
    for item in model.find(CORE + "build"):
        mesh = objects[item.get("objectid")].find(CORE + "mesh")
        places = [tuple(float(v.get(c)) for c in "xyz") for v in mesh.find(CORE + "vertices")]
        assert len(set(places)) == len(places)
        for triangle in mesh.find(CORE + "triangles"):
            corners = [int(triangle.get(name)) for name in ("v1", "v2", "v3")]
            assert len(set(corners)) == 3
            out.append(tuple(places[i] for i in corners))
    return out


def triangles_of_ply(data):
    head, body = data.split(b"end_header\n", 1)
    vertices, faces = (int(re.search(rf"element {name} (\d+)", head.decode())[1]) for name in ("vertex", "face"))
    assert head.startswith(b"ply\nformat binary_little_endian 1.0\n") and len(body) == 24 * vertices + 13 * faces
    places = [struct.unpack_from("<3f", body, 24 * i) for i in range(vertices)]
    lists = [struct.unpack_from("<B3i", body, 24 * vertices + 13 * i) for i in range(faces)]
    assert all(row[0] == 3 for row in lists)
    return [tuple(places[i] for i in row[1:]) for row in lists]


def triangles_of_usda(data):
    text, out = data.decode(), []
    assert text.startswith("#usda 1.0\n") and 'upAxis = "Z"' in text and "metersPerUnit = 0.001" in text
    assert text.count("{") == text.count("}")
    for mesh in re.findall(r'def Mesh "\w+"\n\{(.*?)\n\}', text, re.S):
        places = [tuple(map(float, p.split(","))) for p in re.findall(r"\(([^()]*)\)", re.search(r"points = \[(.*?)\]", mesh, re.S)[1])]
        corners = [int(n) for n in re.search(r"faceVertexIndices = \[(.*?)\]", mesh, re.S)[1].split(",")]
        counts = re.search(r"faceVertexCounts = \[(.*?)\]", mesh, re.S)[1].split(",")
        assert len(corners) == 3 * len(counts) and {n.strip() for n in counts} == {"3"}
        out += [tuple(places[corners[i + k]] for k in range(3)) for i in range(0, len(corners), 3)]
    return out


def triangles_of_gltf(data):
    """As binary glTF: the same JSON, whose numbers lie in it."""
    scene = json.loads(data)
    head, numbers = scene["buffers"][0].pop("uri").split(",")
    assert head == "data:application/octet-stream;base64"
    body, text = base64.b64decode(numbers, validate=True), json.dumps(scene).encode()
    assert len(body) == scene["buffers"][0]["byteLength"]
    text += b" " * (-len(text) % 4)
    return triangles_of_glb(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(body), len(text), 0x4E4F534A) + text
                            + struct.pack("<II", len(body), 0x004E4942) + body)


READERS = {"stl": triangles_of_stl, "glb": triangles_of_glb, "gltf": triangles_of_gltf, "3mf": triangles_of_3mf, "ply": triangles_of_ply,
           "usda": triangles_of_usda}


def volume(triangles):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
               for a, b, c in triangles) / 6


def open_edges(triangles):
    """Edges that no other triangle has the other way round."""
    edges = collections.Counter()
    for triangle in triangles:
        for k in range(3):
            a, b = triangle[k], triangle[(k + 1) % 3]
            if a != b:
                edges[a, b] += 1
    return sum(1 for (a, b), n in edges.items() if edges[b, a] != n)


def box(points):
    points = list(points)
    return [min(p[k] for p in points) for k in range(3)] + [max(p[k] for p in points) for k in range(3)]


def control_points_of_step(text):
    return [tuple(float(n) for n in found.split(",")) for found in
            re.findall(r"CARTESIAN_POINT\('[^']*',\(([^()]*)\)\)", text.replace("\n", ""))]


class Models(ProgramTest):
    def surface(self, profile, axis):
        return self.json("revolve", self.file("profile.json", profile), "--axis", axis, "--tolerance", "1e-7")

    def drawing(self, surfaces, unit="mm", name="drawing.batten", hidden=(), planes=()):
        objects = [{"id": i + 1, "kind": "surface", "name": "", **({"hidden": True} if i in hidden else {}),
                    "surface": {key: surface[key] for key in ("degree", "closed", "knots", "points")}}
                   for i, surface in enumerate(surfaces)]
        objects += [{"id": len(objects) + 1 + i, "kind": "plane", "name": "", "origin": [0, 0, 0], "axes": axes}
                    for i, axes in enumerate(planes)]
        return self.file(name, {"batten": 5, "page": [0, 0, 200, 200], "scale": UNITS[unit], "unit": unit,
                                "next": len(objects) + 1, "objects": objects})

    def written(self, drawing, ending, *options):
        out = self.folder / f"out.{ending}"
        self.done("convert", drawing, str(out), *options)
        return out.read_bytes()


def ball(radius, clockwise):
    """Half a circle from pole to pole about an upright axis, as a curve of many points, in either direction."""
    count = 60
    points = [[100 + radius * math.sin(math.pi * i / count), 100 - radius * math.cos(math.pi * i / count)]
              for i in range(count + 1)]
    points[0][0] = points[-1][0] = 100
    if clockwise:
        points.reverse()
    knots = [0] + list(range(count + 1)) + [count]
    return {"degree": 1, "closed": False, "knots": knots, "points": points}


class OfDrawings(Models):
    def test_a_ball_drawn_in_both_directions(self):
        """A polygon of 60 sides turned: closed, outward, as large as it is, in every unit, whichever way it was drawn."""
        radius, sides = 30, 60
        # Exact: frusta of the polygon's sides.
        exact = 0
        for i in range(sides):
            y = [radius * math.cos(math.pi * (i + k) / sides) for k in range(2)]
            r = [radius * math.sin(math.pi * (i + k) / sides) for k in range(2)]
            exact += math.pi / 3 * (y[0] - y[1]) * (r[0] ** 2 + r[0] * r[1] + r[1] ** 2)
        for clockwise, unit in ((False, "mm"), (True, "mm"), (True, "px"), (False, "in")):
            drawing = self.drawing([self.surface(ball(radius, clockwise), "100,100,0,0,1,0")], unit)
            for ending, read in (("stl", triangles_of_stl), ("glb", triangles_of_glb)):
                scale = UNITS[unit] / (1000 if ending == "glb" else 1)
                triangles = read(self.written(drawing, ending, "--tolerance", repr(3e-4 * radius)))
                self.assertEqual(open_edges(triangles), 0)
                self.assertLess(abs(volume(triangles) / (exact * scale ** 3) - 1), 2e-3)
                low_high = box(p for t in triangles for p in t)
                middle = WALL[ending](100 * scale, 100 * scale, 0)
                for k in range(3):
                    for side, sign in ((k, -1), (3 + k, 1)):
                        self.assertLess(abs(low_high[side] - middle[k] - sign * radius * scale), 2e-3 * radius * scale)

    def test_a_surface_alone_faces_outward(self):
        """Whichever way the half circle was drawn; as STEP a surface comes back bit for bit."""
        for clockwise in (False, True):
            surface = self.file("ball.json", self.surface(ball(30, clockwise), "100,100,0,0,1,0"))
            for ending, read in (("stl", triangles_of_stl), ("glb", triangles_of_glb)):
                out = self.folder / f"ball.{ending}"
                self.done("surface", "convert", surface, str(out), "--tolerance", "0.05")
                self.assertLess(abs(volume(read(out.read_bytes())) / (4 / 3 * math.pi * 30 ** 3) - 1), 0.01)
            self.done("surface", "convert", surface, str(self.folder / "ball.step"))
            self.done("surface", "convert", str(self.folder / "ball.step"), str(self.folder / "again.json"))
            again = json.loads((self.folder / "again.json").read_text(encoding="utf-8"))
            again = again[0] if isinstance(again, list) else again
            self.assertEqual(again["points"], json.loads((self.folder / "ball.json").read_text(encoding="utf-8"))["points"])

    def test_upright(self):
        """A cone with its tip up on the page has it up in each file; on a floor it lies."""
        profile = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 2], "points": [[100, 40], [120, 90], [100, 90]]}
        surface = self.surface(profile, "100,0,0,0,1,0")
        drawing = self.drawing([surface])
        for ways, options in ((WALL, ()), (FLOOR, ("--floor",))):
            for ending, read in (("stl", triangles_of_stl), ("glb", triangles_of_glb)):
                scale = 1e-3 if ending == "glb" else 1
                triangles = read(self.written(drawing, ending, *options))
                self.assertGreater(volume(triangles), 0)
                tip = ways[ending](100 * scale, 40 * scale, 0)
                base = ways[ending](100 * scale, 90 * scale, 0)
                points = {p for t in triangles for p in t}
                up = max(range(3), key=lambda k: abs(tip[k] - base[k]))
                extreme = (max if tip[up] > base[up] else min)(points, key=lambda p: p[up])
                self.assertLess(math.dist(extreme, tip), 1e-3 * scale)
            text = self.written(drawing, "step", *options).decode()
            tip = ways["step"](100, 40, 0)
            self.assertLess(min(math.dist(p, tip) for p in control_points_of_step(text)), 1e-9)
            self.done("surface", "convert", str(self.folder / "out.step"), str(self.folder / "back.json"))
            again = json.loads((self.folder / "back.json").read_text(encoding="utf-8"))
            again = again[0] if isinstance(again, list) else again
            low_high = box(p for row in again["points"] for p in row)
            corners = [ways["step"](*p) for row in surface["points"] for p in row]
            for a, b in zip(low_high, box(corners)):
                self.assertLess(abs(a - b), 1e-9)

    def test_a_plane_that_stands_on_the_page_makes_it_a_floor(self):
        """A cone whose tip is nearest to the eye stands on the page; a plane that lies or leans changes nothing."""
        profile = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 2], "points": [[100, 0, -50], [120, 0, 0], [100, 0, 0]]}
        surface = self.surface(profile, "100,0,0,0,0,1")
        half = math.sqrt(0.5)
        for axes, floor in (([1, 0, 0, 0, 0, 1], True), ([half, half, 0, 0, 0, -1], True), ([1, 0, 0, 0, 1, 0], False),
                            ([1, 0, 0, 0, half, half], False)):
            drawing = self.drawing([surface], planes=[axes])
            for options in ((), ("--wall",), ("--floor",)):
                ways = FLOOR if "--floor" in options or (floor and not options) else WALL
                low_high = box(p for t in triangles_of_stl(self.written(drawing, "stl", *options)) for p in t)
                tip, base = ways["stl"](100, 0, -50), ways["stl"](100, 0, 0)
                k = next(k for k in range(3) if tip[k] != base[k])
                self.assertEqual(k, 2 if ways is FLOOR else 1)
                self.assertLess(abs(low_high[3 + k] - low_high[k] - 50), 1e-2)
                self.assertLess(abs(low_high[3 + k if tip[k] > base[k] else k] - tip[k]), 1e-2)
        self.refused(2, "convert", drawing, "both.stl", "--floor", "--wall")

    def test_capped(self):
        """A vase and a tube whose rims lie in a plane: as solid as the frusta of their polygon, whichever way they were drawn."""
        profile = [(30, 0), (40, 25), (22, 60), (35, 90)]
        exact = sum(math.pi / 3 * (b[1] - a[1]) * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2) for a, b in zip(profile, profile[1:]))
        for clockwise in (False, True):
            points = [[100 + x, 150 - y] for x, y in profile]
            if clockwise:
                points.reverse()
            knots = [0, *range(len(points)), len(points) - 1]
            surface = self.surface({"degree": 1, "closed": False, "knots": knots, "points": points}, "100,100,0,0,1,0")
            drawing = self.drawing([surface])
            for ending, read, options in (*((ending, read, ()) for ending, read in READERS.items()), ("stl", triangles_of_stl, ("--floor",)),
                                          ("obj", triangles_of_obj, ("--triangles",))):
                scale = 1e-3 if ending in ("glb", "gltf") else 1
                loose = read(self.written(drawing, ending, "--tolerance", "0.01", *options))
                solid = read(self.written(drawing, ending, "--tolerance", "0.01", "--cap", *options))
                self.assertGreater(open_edges(loose), 50)
                self.assertEqual(open_edges(solid), 0)
                self.assertLess(abs(volume(solid) / (exact * scale ** 3) - 1), 2e-3)
            (self.folder / "vase.json").write_text(json.dumps(surface), encoding="utf-8")
            self.done("surface", "convert", str(self.folder / "vase.json"), str(self.folder / "vase.stl"), "--cap")
            self.assertEqual(open_edges(triangles_of_stl((self.folder / "vase.stl").read_bytes())), 0)
        for ending in ("step", "iges", "svg", "obj"):
            self.assertIn("--cap", self.refused(2, "convert", drawing, f"no.{ending}", "--cap"))

    def test_triangles_as_obj(self):
        """As OBJ of triangles a ball is what it is as STL, with y up; without the option OBJ holds B-splines as before."""
        drawing = self.drawing([self.surface(ball(30, True), "100,100,0,0,1,0")])
        text = self.written(drawing, "obj", "--triangles", "--tolerance", "0.01")
        self.assertNotIn(b"cstype", text)
        stl = triangles_of_stl(self.written(drawing, "stl", "--tolerance", "0.01"))
        obj = triangles_of_obj(text)
        self.assertEqual(len(obj), len(stl))
        self.assertEqual(open_edges(obj), 0)
        self.assertLess(abs(volume(obj) / volume(stl) - 1), 1e-6)
        normals = [tuple(map(float, line.split()[1:])) for line in text.decode().splitlines() if line.startswith("vn ")]
        places = [tuple(map(float, line.split()[1:])) for line in text.decode().splitlines() if line.startswith("v ")]
        for p, n in zip(places, normals):
            self.assertGreater(sum((a - m) * b for a, m, b in zip(p, WALL["glb"](100, 100, 0), n)), 0)
        self.assertIn(b"cstype bspline", self.written(drawing, "obj"))

    def test_every_file_of_triangles(self):
        """A cone with its tip up has it up in each file, as large as it is, on a wall and on a floor; two surfaces are two objects."""
        profile = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 2], "points": [[100, 40], [120, 90], [100, 90]]}
        surface = self.surface(profile, "100,0,0,0,1,0")
        drawing = self.drawing([surface, surface], "in")
        count = 0
        for options, ways in (((), WALL), (("--floor",), FLOOR)):
            for ending, read in READERS.items():
                scale = 25.4 / (1000 if ending in ("glb", "gltf") else 1)
                triangles = read(self.written(drawing, ending, "--tolerance", "0.02", *options))
                self.assertEqual(len(triangles) % 2, 0)
                self.assertEqual(len(triangles), count := count or len(triangles))  # the tolerance is a length of the drawing
                self.assertLess(abs(volume(triangles) / (2 * math.pi / 3 * 20 ** 2 * 50 * scale ** 3) - 1), 5e-3)
                points = {p for t in triangles for p in t}
                tip = ways["glb" if ending in ("glb", "gltf") else "stl"](100 * scale, 40 * scale, 0)
                self.assertLess(min(math.dist(p, tip) for p in points), 1e-4 * scale)

    def test_what_is_refused_and_left_out(self):
        flat = self.file("flat.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 C 10 0 20 10 30 30"/></svg>')
        for ending in ("stl", "glb", "step", "iges"):
            self.assertIn("curves that lie flat", self.refused(1, "convert", flat, f"no.{ending}"))
        surface = self.surface(ball(30, False), "100,100,0,0,1,0")
        drawing = self.drawing([surface, surface], hidden=(1,))
        self.assertEqual(len(triangles_of_stl(self.written(drawing, "stl"))),
                         len(triangles_of_stl(self.written(self.drawing([surface], name="one.batten"), "stl"))))
        self.assertIn("found none", self.refused(1, "convert", self.drawing([surface], hidden=(0,)), "no.stl"))
        self.assertIn("--floor", self.refused(2, "convert", drawing, "a.svg", "--floor"))


if __name__ == "__main__":
    unittest.main()
