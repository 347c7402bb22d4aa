"""surface convert: glTF and STL taken apart by their specifications and compared with closed forms, OBJ there and back,
OBJ files where commands want curves and surfaces."""
import json
import pathlib
import shutil
import struct
import subprocess
import unittest

import numpy

from program import CURVE, ProgramTest

# z = x y over [-1, 2] x [0, 3]
SADDLE = {"degree": [1, 1], "closed": [False, False], "knots": [[-1, -1, 2, 2], [0, 0, 3, 3]],
          "points": [[[-1, 0, 0], [-1, 3, -3]], [[2, 0, 0], [2, 3, 6]]]}
CUBE = {"vertices": [[k & 1, k >> 1 & 1, k >> 2] for k in range(8)],
        "faces": [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]}
# An L with six corners on each end: two faces that are not convex. Its volume is 3.
CORNERS = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
ELL = {"vertices": [[x, y, z] for z in (0, 1) for x, y in CORNERS],
       "faces": [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11]] + [[k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k] for k in range(6)]}


def ring(count, radius):
    angles = 2 * numpy.pi * numpy.arange(count) / count
    return numpy.stack([radius * numpy.cos(angles), radius * numpy.sin(angles)], 1)


def torus(count=12):
    points = [[[(3 + x) * c, (3 + x) * s, y] for x, y in ring(count, 1)] for c, s in ring(count, 1)]
    knots = list(range(count + 1))
    return {"degree": [3, 3], "closed": [True, True], "knots": [knots, knots], "points": points}


def volume(triangles):
    return numpy.einsum("ij,ij->i", triangles[:, 0], numpy.cross(triangles[:, 1], triangles[:, 2])).sum() / 6


class Convert(ProgramTest):
    def convert(self, content, ending, *options, name="in.json"):
        out = str(pathlib.Path(self.file(name, content)).parent / f"out{ending}")
        self.assertEqual(self.done("surface", "convert", self.file(name, content), out, *options), b"")
        return out

    def glb(self, path):
        """The parts of a file, each (mode, points, normals, indices), after checking what glTF 2.0 asks for."""
        data = pathlib.Path(path).read_bytes()
        magic, version, length = struct.unpack("<4sII", data[:12])
        self.assertEqual((magic, version, length), (b"glTF", 2, len(data)))
        size, kind = struct.unpack("<I4s", data[12:20])
        self.assertEqual((kind, size % 4), (b"JSON", 0))
        scene = json.loads(data[20:20 + size])
        rest, kind = struct.unpack("<I4s", data[20 + size:28 + size])
        self.assertEqual((kind, rest % 4, 28 + size + rest), (b"BIN\0", 0, len(data)))
        binary = data[28 + size:]
        self.assertEqual(scene["asset"]["version"], "2.0")
        self.assertEqual(scene["buffers"], [{"byteLength": rest}])
        self.assertEqual(scene["scenes"][scene["scene"]]["nodes"], list(range(len(scene["nodes"]))))

        def array(index):
            accessor = scene["accessors"][index]
            view = scene["bufferViews"][accessor["bufferView"]]
            width = {"VEC3": 3, "SCALAR": 1}[accessor["type"]]
            kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
            self.assertEqual(view["target"], 34962 if width == 3 else 34963)
            self.assertEqual((view["buffer"], view["byteOffset"] % 4), (0, 0))
            self.assertLessEqual(view["byteOffset"] + view["byteLength"], rest)
            self.assertEqual(view["byteLength"], accessor["count"] * width * 4)
            self.assertGreater(accessor["count"], 0)
            numbers = numpy.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)
            if "min" in accessor:
                self.assertEqual(accessor["min"], numbers.min(0).tolist())
                self.assertEqual(accessor["max"], numbers.max(0).tolist())
            return numbers, "min" in accessor

        parts = []
        for node in scene["nodes"]:
            (primitive,) = scene["meshes"][node["mesh"]]["primitives"]
            self.assertLess(primitive["material"], len(scene["materials"]))
            points, has_box = array(primitive["attributes"]["POSITION"])
            self.assertTrue(has_box)
            normals = indices = None
            if primitive["mode"] == 4:
                normals = array(primitive["attributes"]["NORMAL"])[0]
                indices = array(primitive["indices"])[0].reshape(-1, 3)
                self.assertEqual(len(normals), len(points))
                self.assertLess(numpy.abs(numpy.linalg.norm(normals, axis=1) - 1).max(), 1e-6)
                self.assertLess(indices.max(), len(points))
            parts.append((primitive["mode"], points.astype(float), normals, indices))
        return parts

    def stl(self, path):
        data = pathlib.Path(path).read_bytes()
        self.assertFalse(data.startswith(b"solid"))
        facet = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        (count,) = struct.unpack("<I", data[80:84])
        self.assertEqual(len(data), 84 + 50 * count)
        facets = numpy.frombuffer(data, facet, count, 84)
        self.assertFalse(facets["attribute"].any())
        corners = facets["corners"].astype(float)
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = numpy.linalg.norm(normals, axis=1)
        big = lengths > 1e-9 * lengths.max()
        self.assertLess(numpy.abs(normals[big] / lengths[big, None] - facets["normal"][big]).max(), 1e-3)
        return corners

    def test_a_saddle(self):
        for tolerance in (0.1, 0.003):
            ((mode, points, normals, triangles),) = self.glb(self.convert(SADDLE, ".glb", "--tolerance", str(tolerance)))
            self.assertEqual(mode, 4)
            x, y, z = points.T
            self.assertLess(numpy.abs(z - x * y).max(), 1e-6)
            want = numpy.stack([-y, -x, numpy.ones_like(x)], 1)
            self.assertLess(numpy.abs(normals - want / numpy.linalg.norm(want, axis=1)[:, None]).max(), 1e-6)
            middles = points[triangles].mean(1)
            self.assertLess(numpy.abs(middles[:, 2] - middles[:, 0] * middles[:, 1]).max(), tolerance)
            flat = points[triangles][:, :, :2]
            a, b = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
            areas = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
            self.assertTrue((areas > 0).all())
            self.assertAlmostEqual(areas.sum(), 9, 5)

    def test_solids(self):
        for content, size in ((CUBE, 1), (ELL, 3)):
            self.assertAlmostEqual(volume(self.stl(self.convert(content, ".stl"))), size, 6)
            ((_, points, _, triangles),) = self.glb(self.convert(content, ".glb"))
            self.assertAlmostEqual(volume(points[triangles]), size, 6)

    def test_a_torus_has_no_gap(self):
        corners = self.stl(self.convert(torus(), ".stl", "--tolerance", "0.01"))
        edges = {}
        for triangle in map(lambda t: [tuple(p) for p in t], corners.tolist()):
            for k in range(3):
                edge = triangle[k], triangle[(k + 1) % 3]
                edges[edge] = edges.get(edge, 0) + 1
        self.assertEqual(set(edges.values()), {1})
        self.assertTrue(all((b, a) in edges for a, b in edges))  # both ways once: closed, and of one sense

    def test_lists(self):
        cloud = {"vertices": [[1, 2, 3], [4, 5, 6]], "faces": []}
        parts = self.glb(self.convert([CURVE, SADDLE, cloud, CURVE], ".glb"))
        self.assertEqual([part[0] for part in parts], [0, 4, 3, 3])
        self.assertEqual(parts[0][1].tolist(), [[1, 2, 3], [4, 5, 6]])
        curve = numpy.array(CURVE["points"])
        self.assertEqual(parts[2][1][0].tolist(), [*curve[0], 0])
        self.assertEqual(parts[2][1][-1].tolist(), [*curve[-1], 0])

    def test_there_and_back(self):
        for content, ending in ((SADDLE, ".obj"), (torus(), ".obj"), (CUBE, ".obj"), ([ELL, SADDLE, torus()], ".obj"),
                                ([SADDLE, torus(), CURVE], ".igs"), (torus(), ".iges"), ([SADDLE, torus(), CURVE], ".STP"),
                                (SADDLE, ".step")):
            obj = self.convert(content, ending)
            back = pathlib.Path(obj).with_name("back.json")
            self.done("surface", "convert", obj, str(back))
            found = json.loads(back.read_text())
            content, found = (x if isinstance(x, list) else [x] for x in (content, found))
            self.assertEqual(found, content)

    def test_obj_where_an_object_is_wanted(self):
        obj = self.convert(SADDLE, ".obj")
        at = self.json("surface", "eval", obj, "--at", "1.5,2")["points"]
        self.assertLess(numpy.abs(numpy.array(at) - [1.5, 2, 3]).max(), 1e-14)
        curve = self.convert(CURVE, ".obj", name="curve.json")
        self.assertEqual(self.done("eval", curve, "--samples", "5"), self.done("eval", self.file("c.json", CURVE), "--samples", "5"))
        self.assertIn("expected one curve, found 0", self.refused(1, "eval", self.convert(SADDLE, ".obj"), "--samples", "2"))
        self.assertIn("expected one surface, found 2",
                      self.refused(1, "surface", "closest", self.convert([SADDLE, SADDLE], ".obj"), "--point", "0,0,0"))

    def test_bad_data(self):
        for text, says in (("v 0 0 nan\n", "line 1"), ("v 0 0 0\nf 1 1 2\n", "line 2"), ("# none\n", "found none"),
                           ("v 0 0 0\nv 1 0 0 0\ncstype rat bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n", "weights")):
            out = pathlib.Path(self.file("x.obj", text)).with_name("o.json")
            self.assertIn(says, self.refused(1, "surface", "convert", self.file("x.obj", text), str(out)))
            self.assertFalse(out.exists())
        bad = dict(CUBE, vertices=CUBE["vertices"][:-1] + [[0, 1e76, 0]])
        self.assertIn("found greater ones in 7", self.refused(1, "surface", "convert", self.file("b.json", bad), "o.stl"))
        cloud = self.file("cloud.json", {"vertices": [[1, 2, 3]], "faces": []})
        self.assertIn("faces or surfaces", self.refused(1, "surface", "convert", cloud, "o.stl"))
        self.assertIn("16 million", self.refused(1, "surface", "convert", self.file("t.json", SADDLE), "o.stl", "--tolerance", "1e-14"))
        self.assertIn("surfaces or curves", self.refused(1, "surface", "convert", cloud, "o.igs"))
        self.assertIn("line 1", self.refused(1, "surface", "convert", self.file("x.igs", "no"), "o.json"))
        self.assertIn("ISO-10303-21", self.refused(1, "surface", "convert", self.file("x.stp", "no"), "o.json"))
        self.refused(2, "surface", "convert", cloud, "o.off")
        self.refused(2, "surface", "convert", cloud, "-")

    @unittest.skipUnless(shutil.which("assimp"), "assimp-utils")
    def test_another_program_reads_them(self):
        for content, triangles, faces in ((CUBE, 12, 6), (ELL, 20, 8)):
            for ending in (".glb", ".stl", ".obj", ".gltf", ".ply", ".3mf"):
                told = subprocess.run(["assimp", "info", self.convert(content, ending), "--raw"], stdout=subprocess.PIPE, check=True).stdout.decode()
                self.assertRegex(told, rf"(?m)^Faces: +{faces if ending == '.obj' else triangles}\b")
                self.assertRegex(told, r"(?m)^Meshes: +1\b")
        told = subprocess.run(["assimp", "info", self.convert([SADDLE, CUBE, CURVE], ".glb"), "--raw"], stdout=subprocess.PIPE, check=True).stdout.decode()
        self.assertRegex(told, r"(?m)^Meshes: +3\b")


if __name__ == "__main__":
    unittest.main()
