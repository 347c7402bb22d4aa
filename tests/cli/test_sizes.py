"""Real size: however a file says it, a square of 60 mm is 60 mm long in what Batten writes, read here without Batten."""

import json
import re
import shutil
import struct
import unittest
import zlib

from program import ProgramTest

PX = 25.4 / 96
ROOM = 0.01  # mm
RECT = '<rect x="{0}" y="{1}" width="{2}" height="{2}"/>'


def svg(root, unit):
    """A page of 200 x 100 mm with a square of 60 mm, 10 mm from its left and 20 from its top; unit: mm of one in the file."""
    box = f'viewBox="0 0 {200 / unit!r} {100 / unit!r}"'
    rect = RECT.format(*(repr(mm / unit) for mm in (10, 20, 60)))
    return f'<svg xmlns="http://www.w3.org/2000/svg" {root.format(box=box)}>{rect}</svg>'


# Eight ways: the root, and mm of a unit.
WAYS = {
    "px": ('width="755.90551181" height="377.95275591" {box}', PX),
    "mm": ('width="200mm" height="100mm" {box}', 1),
    "cm": ('width="20cm" height="10cm" {box}', 10),
    "in": ('width="7.874015748in" height="3.937007874in" {box}', 25.4),
    "pt": ('width="566.92913386pt" height="283.46456693pt" {box}', 25.4 / 72),
    "pc": ('width="47.244094488pc" height="23.622047244pc" {box}', 25.4 / 6),
    "%": ('width="100%" height="100%" {box}', PX),
    "none": ("", PX),
    # More of the kind.
    "no viewBox": ('width="200mm" height="100mm"', PX),
    "hundredths": ('width="200mm" height="100mm" {box}', 0.01),
    "width alone": ('width="20cm" {box}', 1 / 3.78),
    "height alone": ('height="100mm" {box}', 25.4),
    "Q": ('width="800Q" height="400Q" {box}', 3),
    "spaces": ('width=" 200MM " height=" 100mm" {box}', 2),
}
PHYSICAL = set(WAYS) - {"px", "%", "none", "Q"}


def gcode(text):
    """The greatest and least of x and y."""
    at = [[float(v) for v in re.findall(axis + r"(-?[\d.]+)", text)] for axis in "XY"]
    return [min(at[0]), min(at[1]), max(at[0]), max(at[1])]


def dxf(text):
    lines = [line.strip() for line in text.splitlines()]
    pairs = list(zip(lines[::2], lines[1::2]))
    units = pairs[pairs.index(("9", "$INSUNITS")) + 1]
    body = pairs[pairs.index(("2", "ENTITIES")):pairs.index(("2", "OBJECTS"))]
    at = [[float(v) for code, v in body if code == want] for want in ("10", "20")]
    return [units[1], min(at[0]), min(at[1]), max(at[0]), max(at[1])]


def page_of_pdf(data):
    """In millimetres."""
    x, y, right, top = (float(v) for v in re.search(rb"/MediaBox \[ ([^\]]*)\]", data).group(1).split())
    return [(right - x) * 25.4 / 72, (top - y) * 25.4 / 72]


def chunks(png):
    at, out = 8, {}
    while at < len(png):
        size, = struct.unpack(">I", png[at:at + 4])
        name, body = png[at + 4:at + 8], png[at + 8:at + 8 + size]
        assert struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0] == zlib.crc32(name + body)
        out[name.decode()] = body
        at += 12 + size
    return out


class Sizes(ProgramTest):
    def close(self, found, expected, way):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertLessEqual(abs(a - b), ROOM, f"{way}: {found}, expected {expected}")

    def check(self, name, way):
        paged = not way.startswith("none")
        corner = (10, 20 if paged else -80)  # from the lower left corner of the page, else from the origin
        square = [corner[0], corner[1], corner[0] + 60, corner[1] + 60]
        self.close(gcode(self.done("convert", name, "-", "--to", "gcode").decode()), square, way)
        units, *found = dxf(self.done("convert", name, "-", "--to", "dxf").decode())
        self.assertEqual(units, "4")
        self.close(found, square, way)
        page = page_of_pdf(self.done("convert", name, "-", "--to", "pdf"))
        self.close(page, [200, 100] if paged else [60, 60], way)
        geo = json.loads(self.done("convert", name, "-", "--to", "geojson"))
        xs = [x for x, *_ in geo["features"][0]["geometry"]["coordinates"]]
        self.close([max(xs) - min(xs)], [60], way)

    def test_ways_of_saying_a_size(self):
        for way, (root, unit) in WAYS.items():
            name = self.file("a.svg", svg(root, unit))
            self.check(name, way)
            for between in ("b.batten", "b.svg"):
                self.done("convert", name, between)
                self.check(self.folder / between, way + " by way of " + between)
            plain = self.done("convert", "b.batten", "-", "--to", "svg", "--plain").decode()
            self.assertEqual(plain, svg(root, unit), way)  # the file's own text

    def test_what_says_no_size(self):
        line = "96 px are an inch"
        for way, (root, unit) in WAYS.items():
            name = self.file("a.svg", svg(root, unit))
            for to in ("gcode", "dxf", "pdf", "eps", "geojson"):
                said = self.run_program("convert", name, "o." + to).stderr.decode()
                self.assertEqual(said.count(line), way not in PHYSICAL, (way, to, said))
                self.assertEqual(said.count("\n"), way not in PHYSICAL, (way, to, said))
            self.assertEqual(self.run_program("convert", name, "o.svg").stderr, b"")

    def test_numbers_without_a_size(self):
        """Degrees stay degrees in what Batten keeps, and are millimetres where a format has a size."""
        line = [[10, 50], [10.1, 50.2], [10.3, 50.1]]
        name = self.file("a.geojson", json.dumps({"type": "LineString", "coordinates": line}))
        for between in ("b.batten", "b.svg"):
            self.done("convert", name, between)
            geo = json.loads(self.done("convert", between, "-", "--to", "geojson"))
            self.assertEqual(geo["features"][0]["geometry"]["coordinates"], line, between)
            self.assertEqual(self.run_program("convert", between, "o.dxf").stderr, b"", between)
            units, *found = dxf(self.done("convert", between, "-", "--to", "dxf").decode())
            self.close(found, [10, 50, 10.3, 50.2], between)
        # Who then gives the picture a size means it.
        text = (self.folder / "b.svg").read_text(encoding="utf-8")
        width = text.split(' width="')[1].split('"')[0]
        self.file("c.svg", text.replace(f' width="{width}" ', f' width="{2 * float(width)}mm" ', 1))
        geo = json.loads(self.done("convert", "c.svg", "-", "--to", "geojson"))
        xs = [x for x, *_ in geo["features"][0]["geometry"]["coordinates"]]
        self.assertNotAlmostEqual(max(xs) - min(xs), 0.3, 2)

    def test_drawn_in_batten(self):
        """A square of 60 mm in drawings of other scales: in SVG made anew, reopened."""
        for scale in (1, 1 / 3.78, 25.4, PX):
            side = 60 / scale
            corners = [[0, 0], [side, 0], [side, side], [0, side]]
            curve = {"degree": 1, "closed": True, "points": corners, "knots": [0, 1, 2, 3, 4]}
            document = {"batten": 1, "page": [0, 0, 210 / scale, 297 / scale], "unit": "mm", "scale": scale, "next": 2,
                        "objects": [{"id": 1, "kind": "path", "name": "", "curves": [curve]}]}
            name = self.file("a.batten", json.dumps(document))
            self.done("convert", name, "b.svg")
            text = (self.folder / "b.svg").read_text(encoding="utf-8")
            self.assertIn(' width="210mm" height="297mm"', text)
            for back in ("b.svg", name):
                found = gcode(self.done("convert", back, "-", "--to", "gcode").decode())
                self.close(found, [0, 237, 60, 297], scale)
            self.done("convert", name, "p.svg", "--plain")
            self.close(gcode(self.done("convert", "p.svg", "-", "--to", "gcode").decode()), [0, 237, 60, 297], scale)

    def test_files_of_before(self):
        document = {"batten": 1, "page": [0, 0, 100, 50], "next": 1, "objects": []}
        name = self.file("a.batten", json.dumps(document))
        self.assertNotIn(b"unit", self.done("convert", name, "-", "--to", "batten"))
        self.assertIn(b' width="100" height="50" viewBox="0 0 100 50"', self.done("convert", name, "-", "--to", "svg"))
        for wrong in ({"unit": "ell"}, {"unit": 3}, {"unit": "mm", "scale": 0}, {"unit": "mm", "scale": "x"}):
            refused = self.refused(1, "info", self.file("w.batten", json.dumps({**document, **wrong})))
            self.assertIn("expected", refused)

    def test_other_proportions(self):
        """The page is what the viewport shows; a drawing that is made to fit it is stretched."""
        root = '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 10 10"{}>' + \
            RECT.format(2, 2, 5) + "</svg>"
        for ratio, expected in (("", [70, 30, 120, 80]), ("xMinYMin", [20, 30, 70, 80]), ("xMaxYMax", [120, 30, 170, 80]),
                                ("xMidYMid slice", [40, 10, 140, 110]), ("none", [40, 30, 140, 80])):
            name = self.file("a.svg", root.format(ratio and f' preserveAspectRatio="{ratio}"'))
            found = gcode(self.done("convert", name, "-", "--to", "gcode").decode())
            self.close(found, expected, ratio)
            self.close(page_of_pdf(self.done("convert", name, "-", "--to", "pdf")), [200, 100], ratio)

    def test_style_attributes_say_it_before_attributes(self):
        """As in browsers, where the unit is the same everywhere; what is changed of the page is said there, too."""
        box = 'viewBox="0 0 200 100"'
        for root, mm in ((f'style="width:200mm;height:100mm" {box}', 1), (f'width="100" height="50" style="width: 200mm ; height: 100MM !important" {box}', 1),
                         (f'width="200mm" height="100mm" style="width:100%;height:auto" {box}', 1), (f'width="200mm" height="100mm" style="width:10em" {box}', 1),
                         (f'style="width:40cm!important;width:10cm;height:20cm" {box}', 2), (f'width="400mm" height="200mm" style="max-width:10px;color:red" {box}', 2),
                         ('style="width:400mm;height:200mm" width="10" viewBox="0 0 200 100" preserveAspectRatio="none"', 2)):
            rect = RECT.format(10 / mm, 20 / mm, 60 / mm)
            text = f'<svg xmlns="http://www.w3.org/2000/svg" {root}>{rect}</svg>'
            name = self.file("a.svg", text)
            found = gcode(self.done("convert", name, "-", "--to", "gcode").decode())
            self.close([found[2] - found[0], found[3] - found[1]], [60, 60], root)
            self.done("convert", name, "b.batten")
            self.assertEqual(self.done("convert", "b.batten", "-", "--to", "svg", "--plain").decode(), text, "nothing was edited")
            drawing = json.loads((self.folder / "b.batten").read_text(encoding="utf8"))
            drawing["page"][2] *= 2
            self.done("convert", self.file("c.batten", json.dumps(drawing)), "d.svg")
            page = page_of_pdf(self.done("convert", "d.svg", "-", "--to", "pdf"))
            self.close(page, [400 * mm, 100 * mm], root)
            found = gcode(self.done("convert", "d.svg", "-", "--to", "gcode").decode())
            self.close([found[2] - found[0], found[3] - found[1]], [60, 60], root)

    def test_dxf_units(self):
        for number, mm in ((1, 25.4), (2, 304.8), (4, 1), (5, 10), (6, 1000), (None, 1), (0, 1), (18, 1.495978707e14), (21, 1.2e6 / 3937), (22, 1e5 / 3937),
                           (23, 3.6e6 / 3937), (24, 6.336e9 / 3937), (99, 1)):
            side = 60 / mm
            head = f"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{number}\n0\nENDSEC\n" if number is not None else ""
            name = self.file("a.dxf", head + f"0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n{side!r}\n21\n{side!r}\n"
                             "0\nENDSEC\n0\nEOF\n")
            for step in ("a.dxf", "b.batten", "b.svg"):
                found = gcode(self.done("convert", name if step == "a.dxf" else step, "-", "--to", "gcode").decode())
                if step == "b.svg":  # a page without one's own origin
                    found = [0, 0, found[2] - found[0], found[3] - found[1]]
                self.close(found, [0, 0, 60, 60], (number, step))
                self.done("convert", name, "b.batten")
                self.done("convert", "b.batten", "b.svg")

    @unittest.skipIf(not shutil.which("pdftocairo"), "poppler-utils is not installed")
    def test_pdf_is_read_in_true_size(self):
        for way in ("mm", "in", "px", "hundredths"):
            self.done("convert", self.file("a.svg", svg(*WAYS[way])), "a.pdf")
            self.done("convert", "a.pdf", "b.batten")
            self.done("convert", "b.batten", "c.svg")
            for step in ("a.pdf", "b.batten", "c.svg"):
                self.assertRegex(self.done("info", step).decode(), r"(?m)^size +566\.9\d+ x 283\.4\d+ pt$")
                found = gcode(self.done("convert", step, "-", "--to", "gcode").decode())
                self.close(found, [10, 20, 70, 80], (way, step))

    def rail(self, scale, flat=False):
        """A curve from the origin to 60 mm to the right, 30 down and 20 away; flat: on the page."""
        points = [[0, 0, 0], [30 / scale, 0, 0], [60 / scale, 30 / scale, 20 / scale]]
        curve = {"degree": 2, "points": [p[:2] for p in points] if flat else points, "knots": [0, 0, 0, 1, 1, 1]}
        return json.dumps({"batten": 1, "unit": "mm", "scale": scale, "next": 2,
                           "objects": [{"id": 1, "kind": "path", "name": "", "curves": [curve]}]})

    def ends(self, name):
        """Of the drawing's first curve, in millimetres."""
        curve = json.loads(self.done("convert", name, "-", "--to", "json"))
        curve = curve[0] if isinstance(curve, list) else curve
        return [b - a for a, b in zip(curve["points"][0], curve["points"][-1])]

    def test_step_and_iges_open_in_true_size(self):
        """Upright, and the same in a file whose unit is another, as other programs write them."""
        inch = "#10=(CONVERSION_BASED_UNIT('INCH',#9001)LENGTH_UNIT()NAMED_UNIT(#9003));\n" \
            "#9001=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9002);\n#9002=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n" \
            "#9003=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
        others = {"step": [("#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n", inch, 25.4),
                           ("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)", 1000)],
                  "iges": [("1.,2,2HMM,", "1.,1,2HIN,", 25.4), ("1.,2,2HMM,", "1.,6,1HM, ", 1000)]}
        for scale in (1, 25.4, PX):
            name = self.file("a.batten", self.rail(scale))
            for kind in others:
                self.done("convert", name, "a." + kind)
                text = (self.folder / ("a." + kind)).read_text(encoding="ascii")
                for before, after, unit in [("", "", 1), *others[kind]]:
                    self.assertIn(before, text)
                    # Whatever its name ends in.
                    other = self.file("b.stp" if kind == "step" else "b.igs", text.replace(before, after, 1) if before else text)
                    self.assertIn("size     a unit is 1 mm\n", self.done("info", other).decode())
                    self.done("convert", other, "c.batten")
                    self.done("convert", "c.batten", "d.svg")
                    for step in (other, "c.batten", "d.svg"):
                        self.close([v / unit for v in self.ends(step)], [60, 30, 20], (scale, kind, unit, step))
                    self.done("convert", "c.batten", "e." + kind)  # and out again
                    self.close([v / unit for v in self.ends("e." + kind)], [60, 30, 20], (scale, kind, unit))

    def test_what_lies_flat_in_step_is_seen_from_above(self):
        points = [[0, 0, 0], [30, 0, 0], [60, 30, 0]]
        name = self.file("a.json", json.dumps({"degree": 2, "points": points, "knots": [0, 0, 0, 1, 1, 1]}))
        for kind in ("step", "iges"):
            self.done("surface", "convert", name, "a." + kind)
            found = gcode(self.done("convert", "a." + kind, "-", "--to", "gcode").decode())
            self.close(found, [0, 0, 60, 30], kind)  # y up, as in the file
            self.assertEqual(self.ends("a." + kind), [60, -30])

    def test_pictures(self):
        name = self.file("a.svg", svg(*WAYS["in"]))
        for words, dpi in (((), 96), (("--dpi", "300"), 300), (("--dpi", "25.4"), 25.4)):
            found = chunks(self.done("render", name, "-", "--to", "png", *words))
            wide, high = struct.unpack(">II", found["IHDR"][:8])
            self.assertLessEqual(abs(wide - 200 / 25.4 * dpi), 1)
            self.assertLessEqual(abs(high - 100 / 25.4 * dpi), 1)
            per = struct.unpack(">IIB", found["pHYs"])
            self.assertLessEqual(abs(per[0] - dpi / 0.0254), 0.01 * per[0])
            self.assertEqual(per[2], 1)
        px = self.file("b.svg", svg(*WAYS["px"]))
        self.assertNotIn("pHYs", chunks(self.done("render", px, "-", "--to", "png")))
        found = chunks(self.done("render", px, "-", "--to", "png", "--dpi", "192"))
        self.assertEqual(struct.unpack(">II", found["IHDR"][:8]), (1512, 756))
        self.assertIn(b'width="7.874015748in" height="3.937007874in"', self.done("render", name, "-", "--to", "svg"))
        self.assertIn("--dpi is for", self.refused(2, "render", name, "o.pdf", "--dpi", "96"))
        self.assertIn("either --size or --dpi", self.refused(2, "render", name, "o.png", "--dpi", "96", "--size", "9x9"))


if __name__ == "__main__":
    unittest.main()
