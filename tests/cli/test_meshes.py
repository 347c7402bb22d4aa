"""Meshes of other programs open as what they are: STL, PLY, glTF and 3MF, made here by hand, by Batten's own writers and by assimp."""

import json
import math
import pathlib
import shutil
import struct
import subprocess
import unittest

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


class Others(Meshes):
    ENDINGS = ("stl", "ply")
    Y_UP = ("glb", "gltf")

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
        """--to STL is what a name that ends in .stl is; and render, info and edit open what is read."""
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
        for form, ending in (("stl", "stl"), ("stlb", "stl"), ("ply", "ply"), ("plyb", "ply")):
            out = self.folder / f"assimp_{form}.{ending}"
            subprocess.run(["assimp", "export", source, str(out), f"-f{form}"], stdout=subprocess.DEVNULL, check=True)
            self.is_wedge(self.meshes(out)[0], within=1e-4)


if __name__ == "__main__":
    unittest.main()
