"""Columns of numbers and GeoJSON as drawings: what is written, other readers read, within the tolerance; what is read comes back."""
import csv
import io
import json
import unittest

import numpy

from program import CURVE, RING, ROOT, ProgramTest

CAR = ROOT / "examples" / "car.svg"


def away(points, lines):
    """The greatest distance from any of the points to the polylines."""
    start = numpy.concatenate([one[:-1] for one in lines])
    along = numpy.concatenate([numpy.diff(one, axis=0) for one in lines])
    squares = numpy.maximum(numpy.einsum("ij,ij->i", along, along), 1e-300)
    def to(p):
        t = numpy.clip(numpy.einsum("ij,ij->i", p - start, along) / squares, 0, 1)
        return numpy.min(numpy.linalg.norm(start + t[:, None] * along - p, axis=1))
    return max(map(to, points))


def columns(text):
    """The lines of a CSV of ours, by Python's reader."""
    lines = {}
    for row in csv.DictReader(io.StringIO(text)):
        lines.setdefault(row.get("curve", "1"), []).append([float(row[c]) for c in "xyz" if c in row])
    return [numpy.array(line) for line in lines.values()]


def places(text):
    found = json.loads(text)
    assert found["type"] == "FeatureCollection"
    return [numpy.array(one["geometry"]["coordinates"]) for one in found["features"]]


READERS = {"csv": columns, "geojson": places}


class Points(ProgramTest):
    def curves(self, *words, stdin=b""):
        found = self.json("convert", *words, "-", "--to", "json", stdin=stdin)
        return found if isinstance(found, list) else [found]

    def refusal(self, name, text):
        return self.refused(1, "convert", self.file(name, text), "o.svg")

    def test_what_is_written(self):
        rows = "\n".join(map(json.dumps, self.curves(CAR)))
        flat = self.done("curve", "flatten", "-", "--lines", "--tolerance", 0.01, stdin=rows).splitlines()
        drawn = [numpy.array(json.loads(line)["points"]) for line in flat]
        side = max(numpy.ptp(numpy.concatenate(drawn), axis=0))
        for kind, read in READERS.items():
            scale = 25.4 / 96 if kind == "geojson" else 1  # of a drawing in px
            lines = [line / scale for line in read(self.done("convert", CAR, "-", "--to", kind).decode())]
            self.assertEqual(len(lines), len(drawn))
            up = kind == "geojson"
            for ours, theirs in zip(drawn, (line * [1, -1] if up else line for line in lines)):
                self.assertLess(away(ours, [theirs]), 1e-4 * side + 0.01)
                self.assertLess(away(theirs, [ours]), 0.01)

    def test_and_comes_back(self):
        for kind in READERS:
            self.done("convert", CAR, f"a.{kind}")
            self.done("convert", f"a.{kind}", f"b.{kind}")
            a, b = ((self.folder / f"{x}.{kind}").read_text() for x in "ab")
            self.assertEqual(READERS[kind](a)[3].tolist(), READERS[kind](b)[3].tolist())
            if kind == "csv":
                self.assertEqual(a, b)
            closed = [c["closed"] for c in self.curves(self.folder / f"a.{kind}")]
            self.assertEqual(closed.count(True), len([c for c in self.curves(CAR) if c["closed"]]))

    def test_one_curve_and_space(self):
        line = {"degree": 1, "closed": True, "knots": [0, 1, 2, 3], "points": [[0.1, 0], [1, 1e-300], [1, 1e75]]}
        text = self.done("convert", self.file("l.json", line), "-", "--to", "csv").decode()
        self.assertEqual(text, "x,y\n0.1,0\n1,1e-300\n1,1e75\n0.1,0\n")
        self.assertEqual(self.curves("-", stdin=text), [line])
        space = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0, 5], [1, 2, 3]]}
        both = self.file("b.json", [line, space])
        text = self.done("convert", both, "-", "--to", "csv").decode()
        self.assertEqual(text.splitlines()[0], "curve,x,y,z")
        self.assertEqual(text.splitlines()[-1], "2,1,2,3")
        found = json.loads(self.done("convert", both, "-", "--to", "geojson"))
        self.assertEqual([len(one["geometry"]["coordinates"][0]) for one in found["features"]], [2, 3])
        self.assertEqual(self.curves("-", stdin=json.dumps(found)), [line, space])

    def test_columns_of_others(self):
        for text, count, first in (("0 0\n1 2\n3 1\n", 1, [0, 0]),
                                   ("# survey\nid;Y;X\n7;1,5;2\n".replace(",", ".") + "8;2;3\n", 1, [2, 1.5]),
                                   ("curve,x,y\nroof,0,0\nroof,1,1\nsill,5,5\nsill,6,6\nroof,9,9\nroof,8,8\n", 3, [0, 0]),
                                   ("\ufeffCurve\tx\ty\na\t1\t1\na\t2\t2\nb\t1\t1\nb\t0\t1\n", 2, [1, 1]),
                                   ("x,y,z,curve\n1,2,3,p\n4,5,6,p\n", 1, [1, 2, 3])):
            curves = self.curves("-", stdin=text)
            self.assertEqual((len(curves), curves[0]["points"][0]), (count, first))

    def test_geojson_of_others(self):
        ring = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
        cases = {"LineString": ring[:3], "MultiLineString": [ring[:2], ring[1:3]], "Polygon": [ring, ring],
                 "MultiPolygon": [[ring], [ring, ring]]}
        counts = {"LineString": 1, "MultiLineString": 2, "Polygon": 2, "MultiPolygon": 3}
        shapes = []
        for kind, coordinates in cases.items():
            shape = {"type": kind, "coordinates": coordinates}
            shapes.append(shape)
            for whole in (shape, {"type": "Feature", "properties": None, "geometry": shape},
                          {"type": "GeometryCollection", "geometries": [shape]}):
                curves = self.curves("-", stdin=json.dumps(whole))
                self.assertEqual(len(curves), counts[kind])
                self.assertEqual(curves[0]["closed"], "Polygon" in kind)
        features = [{"type": "Feature", "properties": {"name": f"<{s['type']}>"}, "geometry": s} for s in shapes]
        features.append({"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1, 2]}})
        features.append({"type": "Feature", "properties": {}, "geometry": None})
        name = self.file("all.geojson", {"type": "FeatureCollection", "features": features})
        result = self.run_program("convert", name, "all.batten")
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"2", result.stderr)
        native = json.loads((self.folder / "all.batten").read_text())
        self.assertEqual([thing["name"] for thing in native["objects"]][::2][:2], ["<LineString>", "<MultiLineString>"])
        self.assertEqual(len(native["objects"]), 8)

    def test_north_is_up(self):
        """A map: latitudes grow upwards on the page, and lines are thin against it, whatever its units are."""
        coast = {"type": "LineString", "coordinates": [[-180, -60], [0, 80], [180, 10]]}
        for size in (1, 1e-5, 1e5):
            scaled = {**coast, "coordinates": [[x * size, y * size] for x, y in coast["coordinates"]]}
            name = self.file("map.geojson", scaled)
            self.done("convert", name, "map.batten")
            thing = json.loads((self.folder / "map.batten").read_text())["objects"][0]
            self.assertEqual(thing["curves"][0]["points"], [[x, -y] for x, y in scaled["coordinates"]])
            self.assertAlmostEqual(thing["style"]["width"] / (360 * size), 1e-3)
            self.done("convert", name, "again.geojson")
            back = json.loads((self.folder / "again.geojson").read_text())
            self.assertEqual(back["features"][0]["geometry"]["coordinates"], scaled["coordinates"])
        space = {"type": "LineString", "coordinates": [[1, 2, 30], [4, 0, 60]]}  # heights are towards the eye, as in DXF
        self.assertEqual(self.curves("-", stdin=json.dumps(space))[0]["points"], [[1, -2, -30], [4, 0, -60]])
        self.done("convert", self.file("s.geojson", space), "s.dxf")
        self.assertRegex((self.folder / "s.dxf").read_text().replace("\r", ""), r" 10\n1\.0\n 20\n2\.0\n 30\n30\.0\n")

    def test_refusals(self):
        self.assertIn("line 3, field 2", self.refusal("a.csv", "x,y\n0,0\n1,\n"))
        self.assertIn("line 2, field 1", self.refusal("a.csv", "1,2\nx,4\n"))
        self.assertIn("header alone", self.refusal("a.csv", "x,y\n"))
        self.assertIn("found one", self.refusal("a.csv", "1,2\n"))
        self.assertIn("1e75", self.refusal("a.csv", "1,2\n3,1e80\n"))
        self.refusal("a.csv", "")
        line = '{"type":"LineString","coordinates":%s}'
        for bad in ("[]", "[[0,0]]", "[[0,0],[1]]", "[[0,0],[1,null]]", "[[0,0],[1,2,3]]", "3", "[[0,0],[1e80,0]]"):
            self.refusal("a.geojson", line % bad)
        self.assertIn("found none", self.refusal("a.geojson", '{"type":"Point","coordinates":[0,0]}'))
        self.assertIn("found none", self.refusal("a.geojson", '{"type":"LineString"}'))
        empty = self.file("e.batten", {"batten": 1, "page": [0, 0, 1, 1], "next": 1, "objects": []})
        for kind in READERS:
            self.assertIn("found none", self.refused(1, "convert", empty, f"o.{kind}"))

    def test_points_are_as_fit_reads_them(self):
        text = self.done("convert", self.file("r.json", RING), "-", "--to", "geojson").decode()
        line = json.dumps(json.loads(text)["features"][0])
        places = [[x, -y] for x, y in json.loads(line)["geometry"]["coordinates"][:3]]
        self.assertEqual(self.curves("-", stdin=line)[0]["points"][:3], places)
        fitted = self.json("fit", "-", "--tolerance", 0.01, "--closed", stdin=line)
        self.assertLess(fitted["report"]["max_error"], 0.01)
        self.assertEqual(len(self.curves(self.file("c.json", CURVE))), 1)


if __name__ == "__main__":
    unittest.main()
