"""label: slow. Meshes of other programs open as what they are: STL, PLY, glTF and 3MF, made here by hand, by Batten's own writers and by assimp."""

import base64
import io
import json
import math
import random
import shutil
import struct
import subprocess
import unittest
import zipfile

from program import ProgramTest

# A wedge whose three sides differ, so that no turned or mirrored one is like it; its corners are numbers of 32 bits.
PLACES = [(1, 2, 3), (11, 2, 3), (1, 22.5, 3), (1, 2, 33.25)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
VOLUME = 10 * 20.5 * 30.25 / 6


def of_z_up(p):
    """Where a place of a file whose up is z lies on a page that is a wall."""
    return (p[0], -p[2], p[1])


def of_y_up(p):
    return (p[0], -p[1], -p[2])


def volume(mesh):
    """Of a mesh of faces without holes, as fans."""
    total = 0
    for face in mesh["faces"]:
        a = mesh["vertices"][face[0]]
        for i, j in zip(face[1:], face[2:]):
            b, c = mesh["vertices"][i], mesh["vertices"][j]
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


def open_edges(mesh):
    """Edges that no other face has the other way round, by the numbers of their vertices."""
    edges = {}
    for face in mesh["faces"]:
        for a, b in zip(face, face[1:] + face[:1]):
            edges[a, b] = edges.get((a, b), 0) + 1
    return sum(1 for (a, b), n in edges.items() if edges.get((b, a), 0) != n)


def binary_stl(places, faces, head=b""):
    return head.ljust(80, b"\0") + struct.pack("<I", len(faces)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(n for i in face for n in places[i]), 0) for face in faces)


def text_stl(places, faces, name="wedge", newline="\n"):
    lines = [f"solid {name}"]
    for face in faces:
        lines += ["facet normal nan 0 1e0", "outer loop", *("vertex " + " ".join(map(repr, map(float, places[i]))) for i in face),
                  "endloop", "endfacet"]
    return newline.join([*lines, f"endsolid {name}", ""])


def ply(places, faces, form="ascii", scalar="float", count="uchar", index="int", extra=()):
    kinds = {"float": "f", "double": "d", "uchar": "B", "char": "b", "short": "h", "ushort": "H", "int": "i", "uint": "I"}
    head = [f"ply", f"format {form} 1.0", "comment by hand", f"element vertex {len(places)}",
            *(f"property {scalar} {c}" for c in "xyz"), "property uchar red", *extra, f"element face {len(faces)}",
            f"property list {count} {index} vertex_indices", "property float quality", "end_header", ""]
    head = "\n".join(head).encode()
    if form == "ascii":
        return head + "".join(" ".join(map(repr, [*map(float, p), 7])) + "\n" for p in places).encode() + \
            "".join(" ".join(map(str, [len(f), *f, 0.5])) + "\n" for f in faces).encode()
    order = ">" if "big" in form else "<"
    return head + b"".join(struct.pack(f"{order}3{kinds[scalar]}B", *p, 7) for p in places) + \
        b"".join(struct.pack(f"{order}{kinds[count]}{len(f)}{kinds[index]}f", len(f), *f, 0.5) for f in faces)


class Meshes(ProgramTest):
    def meshes(self, name, content=None):
        """What Batten opens: the meshes of a drawing of which one unit is a millimetre."""
        path = self.file(name, content) if content is not None else str(name)
        out = self.folder / "opened.batten"
        self.done("convert", path, str(out))
        drawing = json.loads(out.read_text(encoding="utf-8"))
        self.assertEqual((drawing["unit"], drawing.get("scale", 1)), ("mm", 1))
        self.assertTrue(all(o["kind"] == "mesh" for o in drawing["objects"]))
        return [{"name": o["name"], **o["mesh"]} for o in drawing["objects"]]

    def is_wedge(self, mesh, turned=of_z_up, places=PLACES, within=0):
        """The wedge in its true size, upright, not mirrored, and closed."""
        self.assertEqual(len(mesh["vertices"]), 4)
        self.assertEqual(len(mesh["faces"]), 4)
        self.assertEqual(open_edges(mesh), 0)
        for p in places:
            self.assertLessEqual(min(math.dist(turned(p), v) for v in mesh["vertices"]), within)
        a, b, c, d = places
        want = abs(sum((b[k] - a[k]) * ((c[(k + 1) % 3] - a[(k + 1) % 3]) * (d[(k + 2) % 3] - a[(k + 2) % 3]) -
                                        (c[(k + 2) % 3] - a[(k + 2) % 3]) * (d[(k + 1) % 3] - a[(k + 1) % 3])) for k in range(3))) / 6
        self.assertLess(abs(volume(mesh) / want - 1), 1e-6)

    def says(self, name, content, *words):
        """The one line by which a file is refused."""
        line = self.refused(1, "convert", self.file(name, content), "no.batten")
        for word in words:
            self.assertIn(word, line)
        return line


class Stl(Meshes):
    def test_binary(self):
        for head in (b"", b"solid that is binary", b" " * 80):
            [mesh] = self.meshes("a.stl", binary_stl(PLACES, FACES, head))
            self.is_wedge(mesh)
        self.is_wedge(self.meshes("tail.stl", binary_stl(PLACES, FACES) + b"bytes behind it")[0])
        self.is_wedge(self.meshes("unnamed", binary_stl(PLACES, FACES))[0])  # by what stands in it

    def test_text(self):
        whole = text_stl(PLACES, FACES)
        for text in (whole, text_stl(PLACES, FACES, "", "\r\n"), whole.upper(), "\n\n  " + whole.replace(" ", " \t  "),
                     whole.replace("\n", "\r"), whole.replace("outer loop\n", "outer\nloop\n"),
                     text_stl(PLACES, FACES[:2], "facet one") + text_stl(PLACES, FACES[2:], "two")):
            self.is_wedge(self.meshes("a.stl", text)[0])
        self.is_wedge(self.meshes("unnamed", whole)[0])

    def test_only_what_coincides_is_welded(self):
        """A corner one step of its last bit away stays one of its own; triangles without an area go."""
        near = struct.unpack("<f", struct.pack("<I", struct.unpack("<I", struct.pack("<f", PLACES[0][0]))[0] + 1))[0]
        places = [*PLACES, (near, *PLACES[0][1:])]
        [mesh] = self.meshes("a.stl", binary_stl(places, [*FACES[:3], (4, 3, 2), (0, 0, 1), (2, 2, 2)]))
        self.assertEqual((len(mesh["vertices"]), len(mesh["faces"])), (5, 4))
        self.assertGreater(open_edges(mesh), 0)
        [mesh] = self.meshes("b.stl", binary_stl([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (-0.0, 0, -0.0), (0, 0, 1)],
                                                 [(0, 1, 2), (3, 2, 4)]))
        self.assertEqual(len(mesh["vertices"]), 4)

    def test_refused(self):
        whole = binary_stl(PLACES, FACES)
        self.says("a.stl", whole[:-1], "expected 4 triangles, as the header says, found 3")
        self.says("a.stl", whole[:80] + b"\xff\xff\xff\xff" + whole[84:], "4294967295", "found 4")
        self.says("a.stl", b"", "expected STL, found nothing")
        self.says("a.stl", b"\0" * 84, "expected triangles with an area, found none")
        self.says("a.stl", binary_stl([(math.nan, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]), "triangle 1", "finite")
        self.says("a.stl", binary_stl([(0, 0, 0), (math.inf, 0, 0), (0, 1, 0)], [(0, 0, 2), (0, 1, 2)]), "triangle 2", "finite")
        text = text_stl(PLACES, FACES)
        self.says("a.stl", text.replace("11.0", "1e999", 1), "line 6", "finite")
        self.says("a.stl", text.replace("11.0", "eleven", 1), "line 6", "three numbers")
        self.says("a.stl", text.replace("endloop\nendfacet", "vertex 0 0 0\nendloop\nendfacet", 1), "line 7", "found more")
        self.says("a.stl", text.replace("vertex 11.0 2.0 3.0\n", "", 1), "fewer")
        self.says("a.stl", text[:150], "found the end")
        self.says("a.stl", "solid a\nendsolid a\n", "found none")
        self.says("a.stl", "hello\n", "line 1")


class Ply(Meshes):
    def test_every_form(self):
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            for scalar in ("float", "double"):
                for count, index in (("uchar", "int"), ("int", "uint"), ("ushort", "short"), ("char", "uchar")):
                    self.is_wedge(self.meshes("a.ply", ply(PLACES, FACES, form, scalar, count, index))[0])
            whole = ply(PLACES, FACES, form)
            head, body = whole.split(b"end_header\n")
            self.is_wedge(self.meshes("b.ply", head.replace(b"\n", b"\r\n") + b"end_header\r\n" + body)[0])
            self.is_wedge(self.meshes("unnamed", head.replace(b"vertex_indices", b"vertex_index").replace(b"float", b"float32") + b"end_header\n"
                                      + body)[0])

    def test_polygons_clouds_and_more(self):
        """Faces keep their corners; what is listed is kept; other elements are counted as left out."""
        cube = [(x, y, z) for z in (0, 3) for y in (0, 2) for x in (0, 1)]
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        for form in ("ascii", "binary_big_endian"):
            [mesh] = self.meshes("cube.ply", ply(cube, sides, form))
            self.assertEqual({tuple(f) for f in mesh["faces"]}, set(sides))
            self.assertLess(abs(volume(mesh) - 6), 1e-12)
            self.assertEqual(open_edges(mesh), 0)
        [mesh] = self.meshes("cloud.ply", ply([*PLACES, PLACES[0]], []))
        self.assertEqual((len(mesh["vertices"]), mesh["faces"]), (5, []))
        lines = ply(PLACES, FACES).replace(b"end_header\n", b"element edge 2\nproperty int vertex1\nproperty list uchar float weights\nend_header\n")
        result = self.run_program("convert", self.file("edges.ply", lines + b"0 0\n1 2 0.5 0.25\n"), "edges.batten")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"2 ", result.stderr)
        hat = ply(PLACES, [*FACES, (0, 1)])
        self.is_wedge(self.meshes("hat.ply", hat)[0])

    def test_refused(self):
        whole = {form: ply(PLACES, FACES, form) for form in ("ascii", "binary_little_endian", "binary_big_endian")}
        for form, data in whole.items():
            start = data.index(b"end_header\n") + 11
            self.says("a.ply", data[:-1] if form != "ascii" else data[:-5], "face 4", "found the end")
            self.says("a.ply", data[:start + 2], "vertex 1", "found the end")
            self.says("a.ply", data.replace(b"vertex 4", b"vertex 3"))
            self.says("a.ply", data.replace(b"vertex 4", b"vertex 4000000000"), "expected")
            self.says("a.ply", data.replace(b"face 4", b"face 9007199254740991"), "face 5", "found the end")
            self.says("a.ply", data[:start - 20], "expected end_header, found the end")
            self.says("a.ply", data.replace(b"property float z\n", b""), "vertex", "x, y and z")
            self.says("a.ply", data.replace(b"element vertex", b"element point"), "expected vertex, found none")
            self.says("a.ply", data.replace(b"uchar int", b"float int"), "line 10", "property")
            self.says("a.ply", data.replace(b"format " + form.encode(), b"format binary_middle_endian"), "line 2")
            self.says("a.ply", data.replace(b"comment", b"component"), "line 3")
            self.says("a.ply", data.replace(b"vertex 4", b"vertex -4"), "line 4", "how many")
        for form in whole:
            self.says("a.ply", ply(PLACES, [(0, 1, 4)], form), "face 1", "number of a vertex")
            self.says("a.ply", ply(PLACES, [(0, 1, -1)], form), "face 1", "number of a vertex")
            self.says("a.ply", ply([(math.nan, 0, 0)], [], form) if form != "ascii" else ply([(0, 0, 0)], []).replace(b"0.0 0.0", b"nan 0.0"),
                      "vertex 1")
            self.says("a.ply", ply([], [], form), "expected a vertex, found none")
        data = ply(PLACES, FACES, "binary_little_endian", count="uint")
        at = data.index(b"end_header\n") + 11 + 13 * 4
        self.says("a.ply", data[:at] + b"\xff\xff\xff\xff" + data[at + 4:], "face 1", "as the list says")
        self.says("a.ply", b"plya\n", "line 1")
        # Rows of nothing take no time.
        rows = ply(PLACES, FACES).replace(b"element face", b"element nothing 9007199254740991\nelement face")
        self.is_wedge(self.meshes("rows.ply", rows)[0])


def gltf(places, faces=None, index="H", mode=4, nodes=None, more=None, part=None, form="f", normalized=False, gap=0):
    """The JSON of a mesh and its numbers: interleaved with `gap` bytes, with indices of a type or (faces None) without."""
    body = b"".join(struct.pack(f"<3{form}", *p) + b"\xff" * gap for p in places)
    wide, kinds = struct.calcsize(f"<3{form}") + gap, {"b": 5120, "B": 5121, "h": 5122, "H": 5123, "I": 5125, "f": 5126}
    primitive = {"attributes": {"POSITION": 0}, "mode": mode, **(part or {})}
    scene = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes or [{"mesh": 0}],
             "meshes": [{"name": "wedge", "primitives": [primitive]}],
             "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": kinds[form], "count": len(places), "type": "VEC3",
                            "normalized": normalized}],
             "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(body), "byteStride": wide}], "buffers": [{}]}
    if faces is not None:
        corners = [i for face in faces for i in face]
        body += b"\0" * (-len(body) % 4)
        scene["bufferViews"].append({"buffer": 0, "byteOffset": len(body), "byteLength": len(corners) * struct.calcsize(index)})
        scene["accessors"].append({"bufferView": 1, "componentType": kinds[index], "count": len(corners), "type": "SCALAR"})
        primitive["indices"] = 1
        body += struct.pack(f"<{len(corners)}{index}", *corners)
    scene["buffers"][0]["byteLength"] = len(body)
    return {**scene, **(more or {})}, body


def glb(scene, body):
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    body += b"\0" * (-len(body) % 4)
    return struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(body), len(text), 0x4E4F534A) + text + \
        struct.pack("<II", len(body), 0x004E4942) + body


def as_text(scene, body, kind="application/octet-stream"):
    uri = f"data:{kind};base64," + base64.b64encode(body).decode()
    return json.dumps({**scene, "buffers": [{**scene["buffers"][0], "uri": uri}]})


METRES = [tuple(n / 1000 for n in p) for p in PLACES]
THOUSAND = {"scale": [0.001, 0.001, 0.001]}


class Gltf(Meshes):
    def is_upright(self, mesh, places=PLACES):
        self.is_wedge(mesh, of_y_up, places, 1e-5)

    def test_every_form(self):
        """Indices of every type and none, numbers apart and interleaved, binary and as text; metres."""
        loose = [METRES[i] for face in FACES for i in face]
        for scene in (*(gltf(METRES, FACES, index, gap=gap) for index in "BHI" for gap in (0, 8)), gltf(loose),
                      gltf(loose, [range(12)])):
            for name, data in (("a.glb", glb(*scene)), ("a.gltf", as_text(*scene)), ("unnamed", glb(*scene)),
                               ("unnamed", as_text(*scene, "application/gltf-buffer"))):
                [mesh] = self.meshes(name, data)
                self.is_upright(mesh)
                self.assertEqual(mesh["name"], "wedge")
        short = [[round(2 * n) for n in p] for p in PLACES if p[2] != 33.25] + [[2, 4, 66]]  # whole numbers, as quantized
        half = [{"mesh": 0, "name": "node", "scale": [0.0005] * 3}]
        [mesh] = self.meshes("b.glb", glb(*gltf(short, FACES, form="h", nodes=half)))
        self.assertEqual(mesh["name"], "node")
        self.is_upright(mesh, [[n / 2 for n in p] for p in short])
        full = [[0, 0, 0], [127, 0, 0], [0, 127, 0], [0, 0, 127]]
        [mesh] = self.meshes("c.glb", glb(*gltf(full, FACES, form="b", normalized=True)))
        self.is_upright(mesh, [[1000 * n / 127 for n in p] for p in full])

    def test_strips_and_fans(self):
        """A strip and a fan have all their triangles on one side."""
        places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0)]
        for mode, order in ((5, (0, 1, 2, 3, 4)), (6, (1, 3, 4, 2, 0))):
            for scene in (gltf([places[i] for i in order], mode=mode), gltf(places, [order], mode=mode)):
                [mesh] = self.meshes("a.glb", glb(*scene))
                self.assertEqual(len(mesh["faces"]), 3)
                for face in mesh["faces"]:
                    a, b, c = (mesh["vertices"][i] for i in face)
                    self.assertLess((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)  # y is turned round

    def test_nodes(self):
        """Placed by a matrix, moved, turned and scaled, in each other, mirrored: as large and as outward as they are."""
        half = math.sqrt(0.5)
        nodes = [{"children": [1, 2], "translation": [5, 0, 0], "scale": [2, 2, 2]},
                 {"name": "turned", "mesh": 0, "rotation": [0, 0, half, half], "translation": [0, 1, 0]},
                 {"name": "mirrored", "mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1]}]
        turned, mirrored = self.meshes("a.glb", glb(*gltf(METRES, FACES, nodes=nodes)))
        self.assertEqual((turned["name"], mirrored["name"]), ("turned", "mirrored"))
        self.is_wedge(turned, of_y_up, [(5000 - 2 * y, 2000 + 2 * x, 2 * z) for x, y, z in PLACES], 1e-4)
        self.is_wedge(mirrored, of_y_up, [(5000 - 2 * x, 2 * y, 6000 + 2 * z) for x, y, z in PLACES], 1e-4)
        scene, body = gltf(METRES, FACES, nodes=nodes)
        del scene["scenes"], scene["scene"]
        self.assertEqual(len(self.meshes("roots.glb", glb(scene, body))), 2)
        # In a row of 3,000 nodes, each in the one before.
        deep = [{"children": [i + 1], "translation": [0.001, 0, 0]} for i in range(3000)] + [{"mesh": 0}]
        [mesh] = self.meshes("deep.glb", glb(*gltf(METRES, FACES, nodes=deep)))
        self.is_wedge(mesh, of_y_up, [(x + 3000, y, z) for x, y, z in PLACES], 1e-3)

    def test_left_out(self):
        scene, body = gltf(METRES, FACES, more={"cameras": [{}], "animations": [{}]})
        scene["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 1})
        scene["nodes"][0]["skin"] = 0
        result = self.run_program("convert", self.file("a.glb", glb(scene, body)), "a.batten")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"4 ", result.stderr)
        [cloud] = self.meshes("cloud.glb", glb(*gltf(METRES, mode=0)))
        self.assertEqual((len(cloud["vertices"]), cloud["faces"]), (4, []))

    def test_refused(self):
        scene, body = gltf(METRES, FACES)
        whole = glb(scene, body)

        def other(path, value, data=body):
            """With something else in its place."""
            changed = json.loads(json.dumps(scene))
            at = changed
            for step in path[:-1]:
                at = at[step]
            at[path[-1]] = value
            return glb(changed, data)

        self.says("a.glb", whole[:-1], "expected", "found")
        self.says("a.glb", whole[:16], "beginning")
        self.says("a.glb", whole[:4] + b"\1" + whole[5:], "another version")
        self.says("a.glb", other(["asset", "version"], "1.0"), "another or none")
        self.says("a.glb", whole[:12] + b"\xff\xff\xff\xff" + whole[16:], "expected")
        self.says("a.gltf", json.dumps(scene), "buffers[0]", ".glb")
        self.says("a.gltf", json.dumps({**scene, "buffers": [{"uri": "a.bin", "byteLength": 72}]}), "buffers[0]", ".glb")
        self.says("a.gltf", as_text(scene, body).replace("base64,", "base64,#"), "buffers[0]", "base 64")
        for accessor in (0, 1):
            for count in (1 << 31, 1e15, 100):
                self.says("a.glb", other(["accessors", accessor, "count"], count), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "count"], -1), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "byteOffset"], 70), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "componentType"], 5124), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "type"], "VEC2"), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "bufferView"], 9), f"accessors[{accessor}]")
            self.says("a.glb", other(["accessors", accessor, "sparse"], {}), f"accessors[{accessor}]", "sparse")
        self.says("a.glb", other(["bufferViews", 1, "byteOffset"], 1000), "buffers[0]")
        self.says("a.glb", other(["bufferViews", 0, "byteStride"], 0), "bufferViews[0]")
        self.says("a.glb", other(["meshes", 0, "primitives", 0, "indices"], 2), "meshes[0]")
        self.says("a.glb", other(["meshes", 0, "primitives", 0, "mode"], 7), "meshes[0]")
        self.says("a.glb", other(["meshes", 0, "primitives"], []), "found none")
        self.says("a.glb", other(["nodes", 0, "mesh"], 1), "nodes[0]")
        self.says("a.glb", other(["nodes", 0, "matrix"], [1] * 15), "nodes[0]", "16")
        self.says("a.glb", other(["nodes", 0, "scale"], [1e300] * 3), "finite")
        self.says("a.glb", other(["nodes", 0, "children"], [0]), "nodes[0]", "in itself")
        self.says("a.glb", other(["nodes"], [{"children": [1]}, {"children": [2]}, {"children": [1]}]), "nodes[1]", "in itself")
        self.says("a.glb", other(["nodes"], [{"children": [7]}]), "nodes")
        self.says("a.glb", other(["scene"], 1), "scene")
        self.says("a.glb", other(["extensionsRequired"], ["KHR_draco_mesh_compression"]), "KHR_draco_mesh_compression")
        self.says("a.glb", glb(*gltf(METRES, [(0, 1, 4)])), "meshes[0]", "number of a vertex")
        self.says("a.glb", glb(*gltf(METRES, [(0, 1, -2)], "h")), "meshes[0]", "number of a vertex")
        self.says("a.glb", glb(*gltf(METRES, [(0, 1, 1.5)], "f")), "meshes[0]", "number of a vertex")
        self.says("a.glb", glb(*gltf([(math.nan, 0, 0), *METRES[1:]], FACES)), "finite")
        # A mesh of 3,000 triangles shown by 100,000 nodes: refused before it takes all memory.
        nodes = [{"children": list(range(1, 100001))}] + [{"mesh": 0}] * 100000
        self.says("a.glb", glb(*gltf(METRES, FACES * 750, nodes=nodes)), "for a file of this size")


CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
MODEL = "3D/3dmodel.model"


def mesh_of(places, faces, prefix=""):
    return f"<{prefix}mesh><{prefix}vertices>" + "".join(f"<{prefix}vertex x='{x!r}' y=\"{y!r}\"\n z = '{z!r}' />" for x, y, z in places) + \
        f"</{prefix}vertices><{prefix}triangles>" + "".join(f'<{prefix}triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces) + \
        f"</{prefix}triangles></{prefix}mesh>"


def model(resources, build, unit=' unit="millimeter"', prefix=""):
    name = f"xmlns:{prefix[:-1]}" if prefix else "xmlns"
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<!-- a > b --><{prefix}model{unit} {name}="{CORE}" xmlns:p="urn:p"><{prefix}metadata name="Title">&lt;{prefix}object&gt;</{prefix}metadata>
<{prefix}resources>{resources}</{prefix}resources><{prefix}build>{build}</{prefix}build></{prefix}model>"""


def package(text, method=zipfile.ZIP_DEFLATED, files=(), level=None, name=MODEL, relation=True):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method, compresslevel=level) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        if relation:
            archive.writestr("_rels/.rels", f"""<Relationships><Relationship Id="r" Target="/{name}"
                Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>""")
        archive.writestr(name, text)
        for other, content in files:
            archive.writestr(other, content)
    return out.getvalue()


WEDGE = f'<object id="1" name="a &amp; b" type="model">{mesh_of(PLACES, FACES)}</object>'
ITEM = '<item objectid="1"/>'


class ThreeMf(Meshes):
    def test_every_form(self):
        """Stored and deflated at every level, in every unit, with and without a relation, prefixed, of other names."""
        for method, level in ((zipfile.ZIP_STORED, None), *((zipfile.ZIP_DEFLATED, n) for n in range(10))):
            [mesh] = self.meshes("a.3mf", package(model(WEDGE, ITEM), method, level=level))
            self.is_wedge(mesh)
            self.assertEqual(mesh["name"], "a & b")
        self.is_wedge(self.meshes("unnamed", package(model(WEDGE, ITEM)))[0])
        self.is_wedge(self.meshes("a.3mf", package(model(WEDGE, ITEM), name="other/Part.Model"))[0])
        self.is_wedge(self.meshes("a.3mf", package(model(WEDGE, ITEM), relation=False, name="3d/3DModel.MODEL"))[0])
        x = model(f'<x:object id="1">{mesh_of(PLACES, FACES, "x:")}</x:object><object id="1"/>', '<x:item objectid="1"/>', prefix="x:")
        self.is_wedge(self.meshes("a.3mf", package(x))[0])
        for unit, scale in (("", 1), ("micron", 1e-3), ("millimeter", 1), ("centimeter", 10), ("inch", 25.4), ("foot", 304.8), ("meter", 1000)):
            [mesh] = self.meshes("a.3mf", package(model(WEDGE, ITEM, f' unit="{unit}"' if unit else "")))
            self.is_wedge(mesh, of_z_up, [[scale * n for n in p] for p in PLACES], 1e-9 * scale)

    def test_items_and_components(self):
        """An object of two components, one of them mirrored, in two items, moved and turned."""
        resources = WEDGE + '<object id="9" name="both"><components><component objectid="1"/>' \
            '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 -5 0 0"/></components></object>'
        build = '<item objectid="9" transform="0 2 0 -2 0 0 0 0 2 100 0 7.5"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 50"/>'
        both, one = self.meshes("a.3mf", package(model(resources, build)))
        self.assertEqual((both["name"], len(both["faces"]), open_edges(both)), ("both", 8, 0))
        self.assertLess(abs(volume(both) / (2 * 8 * VOLUME) - 1), 1e-9)
        for sign in (1, -1):
            for x, y, z in PLACES:
                x = x if sign == 1 else -x - 5
                self.assertLess(min(math.dist(of_z_up((100 - 2 * y, 2 * x, 2 * z + 7.5)), v) for v in both["vertices"]), 1e-9)
        self.is_wedge(one, of_z_up, [(x, y, z + 50) for x, y, z in PLACES], 1e-9)
        # What another file of the archive describes.
        parts = '<object id="2"><components><component p:path="/3D/Objects/one.model" objectid="1"/></components></object>'
        [mesh] = self.meshes("b.3mf", package(model(parts, '<item objectid="2"/>'), files=[("3D/Objects/one.model", model(WEDGE, ""))]))
        self.is_wedge(mesh)

    def test_inflated_as_zlib_deflates(self):
        """Noise, runs and far repeats of text, behind the model as a comment: what comes out is checked by its sum."""
        source = random.Random(5)
        for kind in ("noise", "runs", "far"):
            for level in (1, 6, 9):
                if kind == "noise":
                    text = "".join(chr(source.randrange(32, 127)) for _ in range(70000)).replace("-", "_")
                elif kind == "runs":
                    text = "".join(chr(source.randrange(65, 91)) * source.randrange(1, 300) for _ in range(900))
                else:
                    block = "".join(chr(source.randrange(65, 91)) for _ in range(32000))
                    text = (block + "x") * 5
                self.is_wedge(self.meshes("a.3mf", package(model(WEDGE, ITEM) + f"<!--{text}-->", level=level))[0])

    def test_long_fields(self):
        """Sizes in the fields of 64 bits, as some programs always write them."""
        data = package(model(WEDGE, ITEM))
        end = data.rindex(b"PK\5\6")
        count, size, at = struct.unpack_from("<HII", data, end + 10)
        entries, place, body = b"", at, data[:at]
        for _ in range(count):
            head = list(struct.unpack_from("<4s6H3I5H2I", data, place))
            name = data[place + 46:place + 46 + head[10]]
            extra = struct.pack("<HHQQQ", 1, 24, head[9], head[8], head[16])
            place += 46 + sum(head[10:13])
            head[8] = head[9] = head[16] = 0xFFFFFFFF
            head[11], head[12] = len(extra), 0
            entries += struct.pack("<4s6H3I5H2I", *head) + name + extra
        record = struct.pack("<4sQHHIIQQQQ", b"PK\6\6", 44, 45, 45, 0, 0, count, count, len(entries), at)
        locator = struct.pack("<4sIQI", b"PK\6\7", 0, at + len(entries), 1)
        close = struct.pack("<4sHHHHIIH", b"PK\5\6", 0, 0, 0xFFFF, 0xFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0)
        self.is_wedge(self.meshes("a.3mf", body + entries + record + locator + close)[0])

    def test_left_out(self):
        lattice = WEDGE.replace("</mesh>", '<b:beamlattice xmlns:b="urn:b"><b:vertex x="9"/></b:beamlattice></mesh>')
        result = self.run_program("convert", self.file("a.3mf", package(model(lattice, ITEM))), "a.batten")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"1 ", result.stderr)

    def test_refused(self):
        whole = package(model(WEDGE, ITEM))
        for cut in (0, 10, len(whole) // 2, len(whole) - 30, len(whole) - 1):
            self.says("a.3mf", whole[:cut], "ZIP")
        at = whole.index(MODEL.encode()) + len(MODEL) + 40
        self.says("a.3mf", whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:], MODEL, "damaged")
        self.says("a.3mf", package("no xml"), "XML")
        self.says("a.3mf", package("<svg/>"), "expected a model")
        self.says("a.3mf", package(model(WEDGE, ITEM), name="else.xml", relation=False), MODEL)
        self.says("a.3mf", package(model(WEDGE, "")), "build", "found none")
        self.says("a.3mf", package(model(WEDGE, '<item objectid="2"/>')), "object 2", "none such")
        self.says("a.3mf", package(model(WEDGE, '<item objectid="one"/>')), "build", "objectid")
        self.says("a.3mf", package(model(WEDGE + WEDGE, ITEM)), "object 1", "twice")
        self.says("a.3mf", package(model(WEDGE, '<item objectid="1" transform="1 0 0"/>')), "12 numbers")
        self.says("a.3mf", package(model(WEDGE, '<item objectid="1" transform="1e300 0 0 0 1 0 0 0 1 0 0 0"/>')), "finite")
        self.says("a.3mf", package(model(WEDGE, '<item objectid="1" p:path="/no.model"/>')), "path")
        self.says("a.3mf", package(model(WEDGE, ITEM, ' unit="cubit"')), "unit")
        for was, now in (("11", "nan"), ("11", "1e999"), ("11", ""), ("11", "1 1")):
            self.says("a.3mf", package(model(WEDGE.replace(f"'{was}'", f"'{now}'"), ITEM)), "object 1", "vertex")
        for number in ("4", "-1", "0.5", "4294967296"):
            self.says("a.3mf", package(model(WEDGE.replace('v3="1"', f'v3="{number}"'), ITEM)), "object 1", "triangle")

        def chain(count, last):
            return WEDGE + "".join(f'<object id="{i}"><components><component objectid="{i + 1 if i < count + 1 else last}"/>'
                                   '<component objectid="1"/></components></object>' for i in range(2, count + 2))
        self.says("a.3mf", package(model(chain(5, 2), '<item objectid="2"/>')), "object 2", "circle")
        self.says("a.3mf", package(model(chain(70, 1), '<item objectid="2"/>')), "64 deep")
        doubled = WEDGE + "".join(f'<object id="{i}"><components>' + f'<component objectid="{i - 1}"/>' * 2 + "</components></object>"
                                  for i in range(2, 60))
        self.says("a.3mf", package(model(doubled, '<item objectid="59"/>')), "for a file of this size")
        # A bomb, and one that says that it is none.
        bomb = package(model(WEDGE, ITEM) + " " * 100000000)
        self.assertLess(len(bomb), 200000)
        self.says("a.3mf", bomb, MODEL, "unpacks to too much")
        size = struct.pack("<I", len(model(WEDGE, ITEM)) + 100000000)
        self.assertEqual(bomb.count(size), 2)
        self.says("a.3mf", bomb.replace(size, struct.pack("<I", 60000)), MODEL, "damaged")


class Others(Meshes):
    ENDINGS = ("stl", "ply", "glb", "gltf", "3mf")

    def there_and_back(self, ending):
        """Batten's mesh to a file and back: in its place, in millimetres, whatever the drawing's unit was."""
        for unit, scale in (("mm", 1), ("in", 25.4), ("px", 25.4 / 96)):
            turned = [of_z_up(p) for p in PLACES]
            drawing = {"batten": 6, "page": [0, 0, 99, 99], "unit": unit, "scale": scale, "next": 2,
                       "objects": [{"id": 1, "kind": "mesh", "name": "wedge", "mesh": {"vertices": turned, "faces": FACES}}]}
            out = self.folder / f"out.{ending}"
            self.done("convert", self.file("in.batten", drawing), str(out))
            [mesh] = self.meshes(out)
            self.is_wedge(mesh, lambda p: of_z_up([scale * n for n in p]), [[n for n in p] for p in PLACES], 1e-5 * scale) \
                if scale == 1 else self.is_scaled(mesh, scale)
            again = self.folder / f"again.{ending}"
            self.done("convert", str(out), str(again))
            self.is_scaled(self.meshes(again)[0], scale)

    def is_scaled(self, mesh, scale):
        self.assertEqual(open_edges(mesh), 0)
        self.assertLess(abs(volume(mesh) / (VOLUME * scale ** 3) - 1), 1e-5)
        for p in PLACES:
            self.assertLess(min(math.dist([scale * n for n in of_z_up(p)], v) for v in mesh["vertices"]), 1e-5 * 40 * scale)

    def test_there_and_back(self):
        for ending in self.ENDINGS:
            self.there_and_back(ending)

    def test_by_the_name_of_the_format(self):
        """--to STL is what a name that ends in .stl is; and info and render open what is read."""
        first = self.file("a.stl", binary_stl(PLACES, FACES))
        for ending in self.ENDINGS:
            self.done("convert", first, f"b.{ending}")
            self.done("convert", first, "c", "--to", ending)
            self.assertEqual((self.folder / f"b.{ending}").read_bytes(), (self.folder / "c").read_bytes())
            self.assertEqual(self.json("info", f"b.{ending}", "--json")["format"], ending)
            self.done("render", f"b.{ending}", "b.png")

    @unittest.skipUnless(shutil.which("assimp"), "assimp-utils")
    def test_files_of_assimp(self):
        source = self.file("a.stl", binary_stl(PLACES, FACES))
        for form, ending in (("stl", "stl"), ("stlb", "stl"), ("ply", "ply"), ("plyb", "ply"), ("glb2", "glb"), ("3mf", "3mf")):
            out = self.folder / f"assimp_{form}.{ending}"
            subprocess.run(["assimp", "export", source, str(out), f"-f{form}"], stdout=subprocess.DEVNULL, check=True)
            places = [[1000 * n for n in p] for p in PLACES] if ending == "glb" else PLACES  # it takes no unit for another
            self.is_wedge(self.meshes(out)[0], of_y_up if ending == "glb" else of_z_up, places, 1e-2 if ending == "glb" else 1e-4)

        subprocess.run(["assimp", "export", source, str(self.folder / "a.obj"), "-fobj"], stdout=subprocess.DEVNULL, check=True)
        self.done("convert", "a.obj", "obj.batten")  # its numbers have no unit
        [mesh] = [o["mesh"] for o in json.loads((self.folder / "obj.batten").read_text())["objects"]]
        self.is_wedge(mesh, of_y_up, PLACES, 1e-4)


if __name__ == "__main__":
    unittest.main()
