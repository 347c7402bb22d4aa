#!/usr/bin/env python3
"""Glyphs of fonts (GLIF 2): read with their points and handles, written so that FontForge sees the same outline."""
import re
import subprocess
import unittest
import xml.etree.ElementTree as tree

from program import ProgramTest

HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<glyph name="{}" format="2">\n  <advance width="520"/>\n  <unicode hex="0061"/>\n  <outline>\n'
TAIL = "  </outline>\n</glyph>\n"


def contour(*points):
    """Points as (x, y, type, smooth)."""
    lines = ["    <contour>\n"]
    for x, y, *more in points:
        kind = f' type="{more[0]}"' if more and more[0] else ""
        smooth = ' smooth="yes"' if more[1:] else ""
        lines.append(f'      <point x="{x}" y="{y}"{kind}{smooth}/>\n')
    return "".join(lines) + "    </contour>\n"


def glyph(*contours, name="a"):
    return HEAD.format(name) + "".join(contours) + TAIL


RING = contour((100, 0, "curve", True), (155, 0), (200, 45), (200, 100, "curve", True), (200, 155), (155, 200), (100, 200, "curve", True),
               (45, 200), (0, 155), (0, 100, "curve", True), (0, 45), (45, 0))
STEM = contour((300, 0, "line"), (380, 0, "line"), (380, 700, "line"), (300, 700, "line"))
STROKE = contour((10, 20, "move"), (60, 120), (160, -40), (260, 80, "curve"))


def points(text):
    """Contours of (x, y, type, smooth)."""
    return [[(float(p.get("x")), float(p.get("y")), p.get("type"), p.get("smooth")) for p in c.findall("point")]
            for c in tree.fromstring(text).find("outline").findall("contour")]


class Glif(ProgramTest):
    def file(self, text, name="a.glif"):
        path = self.folder / name
        path.write_text(text)
        return path

    def converted(self, text, end, *options):
        out = self.folder / f"out.{end}"
        out.unlink(missing_ok=True)
        self.done("convert", self.file(text), out, *options, *(["--plain"] if end == "svg" else []))
        return out.read_text()

    def test_it_comes_back_as_it_was(self):
        text = glyph(RING, STEM, STROKE)
        back = self.converted(text, "glif")
        self.assertEqual(points(back), points(text))
        self.assertIn('<advance width="520"/>', back)
        self.assertIn('<glyph name="a" format="2">', back)

    def test_it_lies_upright(self):
        svg = self.converted(glyph(STEM), "svg")
        self.assertRegex(svg, r'd="M300 0L380 0L380 -700L300 -700L?[^"]*Z"')
        self.assertIn('viewBox="0 -700 520 700"', svg)

    def test_quadratics(self):
        """Points halfway between handles are implied; without any point on the curve one lies halfway, too."""
        text = glyph(contour((0, 0, "qcurve"), (0, 100), (100, 100), (100, 0, "qcurve")), contour((0, 0), (100, 0), (100, 100), (0, 100)))
        first, second = points(self.converted(text, "glif"))
        on = [p[:2] for p in first if p[2]]
        self.assertIn((50, 100), on)
        self.assertEqual({p[:2] for p in second if p[2]}, {(0, 50), (50, 0), (100, 50), (50, 100)})

    def test_what_is_left_out_is_told(self):
        text = glyph(STEM).replace("  </outline>", '    <component base="b"/>\n  </outline>').replace("</glyph>", "  <lib><dict/></lib>\n</glyph>")
        result = self.run_program("convert", self.file(text), self.folder / "out.svg")
        self.assertEqual(result.returncode, 0)
        self.assertIn("2", result.stderr.decode())

    def test_bad_files(self):
        for bad, wrong in ((RING.replace('x="100"', 'x="1o0"', 1), "expected x and y"), (RING.replace('"curve"', '"cubic"', 1), "expected type"),
                           (STEM.replace('type="line"', "", 1).replace('type="line"', "", 0), "before a line"),
                           (STROKE.replace(' type="curve"', ""), "after the handles"),
                           (STEM.replace('"line"/>\n', '"move"/>\n').replace("move", "line", 1), "move at the first")):
            with self.subTest(wrong=wrong):
                line = self.refused(1, "info", self.file(glyph(bad)))
                self.assertIn(wrong, line)
                self.assertRegex(line, r"line \d+, column \d+")

    def test_what_it_writes_it_reads(self):
        drawing = '<svg xmlns="http://www.w3.org/2000/svg"%s><path d="M0 0C%s 9 5 %s 9 70H0Z"/></svg>'
        far = "a glyph holds places and widths up to 1e9, found one further out"
        out = self.folder / "far.glif"
        for box, x, y in (("", "1e9", "-1e9"), (' viewBox="0 0 1e9 9"', "3", "3")):
            self.done("convert", self.file(drawing % (box, x, y), "in.svg"), out)
            self.done("info", out)
        for box, x, y in (("", "1.1e9", "3"), ("", "3", "2e30"), (' viewBox="0 0 2e9 9"', "3", "3")):
            out.unlink(missing_ok=True)
            self.assertIn(far, self.refused(1, "convert", self.file(drawing % (box, x, y), "in.svg"), out))
            self.assertFalse(out.exists())
        self.assertIn(far, self.refused(1, "convert", self.file(drawing % ("", "2e9", "3"), "in.svg"), self.file(glyph(RING), "far.glif")))
        self.assertEqual(out.read_text(), glyph(RING))

    def test_extremes(self):
        """A quarter turned by 45 degrees has its extreme in the middle; the outline stays where it was."""
        text = glyph(contour((0, 0, "move"), (40, 60), (80, 60), (120, 0, "curve"), (150, -40), (190, -90), (200, 50, "curve")))
        plain, cut = points(self.converted(text, "glif"))[0], points(self.converted(text, "glif", "--extremes"))[0]
        self.assertEqual(len(plain), 7)
        tops = [i for i, p in enumerate(cut) if p[2] and p[:2] == (60, 45)]
        self.assertEqual([cut[i + d][1] for i in tops for d in (-1, 1)], [45, 45])
        for segments in (plain, cut):
            for a, b, c, d in zip(segments[0::3], segments[1::3], segments[2::3], segments[3::3]):
                self.assertEqual((b[2], c[2], d[2]), (None, None, "curve"))
        for axis in (0, 1):  # no segment turns back within itself
            for a, b, c, d in zip(cut[0::3], cut[1::3], cut[2::3], cut[3::3]):
                rises = [q[axis] - p[axis] for p, q in ((a, b), (b, c), (c, d))]
                at = [(1 - t) ** 2 * rises[0] + 2 * t * (1 - t) * rises[1] + t * t * rises[2] for t in [i / 50 for i in range(51)]]
                self.assertFalse(min(at) < -1e-6 and max(at) > 1e-6, (axis, a, d))
        self.assertEqual(self.converted(glyph(STEM), "glif", "--extremes"), self.converted(glyph(STEM), "glif"))

    def test_in_its_place(self):
        """In the place of a glyph only the contours are new."""
        old = (glyph(RING, STEM).replace("  </outline>", '    <component base="acute"/>\n  </outline>')
               .replace("</glyph>", '  <anchor name="top" x="1" y="2"/>\n  <!-- <contour> -->\n  <lib><dict><key>k</key></dict></lib>\n</glyph>'))
        out = self.file(old, "A_.glif")
        self.done("convert", self.file(glyph(STROKE, name="other")), out)
        new = out.read_text()
        self.assertEqual(points(new), points(glyph(STROKE)))
        self.assertEqual(re.sub(r"\s*<contour>.*?</contour>", "", new.replace("<!-- <contour> -->", ""), flags=re.S),
                         re.sub(r"\s*<contour>.*?</contour>", "", old.replace("<!-- <contour> -->", ""), flags=re.S))
        self.done("convert", out, out)  # onto itself
        self.assertEqual(out.read_text(), new)
        for empty in ("  <outline/>\n", "  <outline>\n  </outline>\n", ""):
            out.write_text('<?xml version="1.0"?>\n<glyph name="n" format="2">\n  <unicode hex="41"/>\n' + empty + "  <note>n</note>\n</glyph>\n")
            self.done("convert", self.file(glyph(STEM)), out)
            self.assertEqual(points(out.read_text()), points(glyph(STEM)))
            self.assertRegex(out.read_text(), '(?s)<unicode hex="41"/>.*<note>n</note>.*')

    def test_folder(self):
        font = self.folder / "Sans.ufo" / "glyphs"
        font.mkdir(parents=True)
        (font / "contents.plist").write_text("<plist/>")
        for name, drawn in (("A_", RING), ("b", STEM)):
            (font / f"{name}.glif").write_text(glyph(drawn, name=name))
        before = {path.name: path.read_text() for path in font.iterdir()}
        self.refused(2, "convert", font.parent, "out")
        self.done("convert", font.parent, "out", "--to", "svg")
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()), ["A_.svg", "b.svg"])
        self.done("convert", "out", font.parent, "--to", "glif")
        self.assertEqual({path.name: points(path.read_text()) for path in font.glob("*.glif")},
                         {name: points(text) for name, text in before.items() if name.endswith("glif")})
        (font / "c.glif").write_text("<glyph")
        result = self.run_program("convert", font, "again", "--to", "svg")
        self.assertEqual((result.returncode, result.stderr.count(b"\n")), (1, 1))
        self.assertEqual(sorted(path.name for path in (self.folder / "again").iterdir()), ["A_.svg", "b.svg"])
        (font / "b.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
        self.assertIn("one file", self.refused(1, "convert", font, "third", "--to", "svg"))
        self.assertFalse((self.folder / "third").exists())
        (self.folder / "empty").mkdir()
        self.assertIn("found none", self.refused(1, "convert", "empty", "third", "--to", "svg"))
        self.assertIn("expected a folder", self.refused(1, "convert", "out", self.file("", "plain"), "--to", "glif"))

    def test_fontforge_sees_the_same(self):
        out = self.folder / "out.glif"
        self.done("convert", self.file(glyph(RING, STEM)), out)
        script = ("import fontforge,sys\ng=fontforge.font().createChar(97)\ng.importOutlines(sys.argv[1])\n"
                  "print([[(p.x,p.y,p.on_curve) for p in c] for c in g.foreground])")
        said = subprocess.run(["fontforge", "-lang=py", "-c", script, out], capture_output=True, text=True, check=True).stdout
        seen = eval(re.search(r"\[\[.*\]\]", said)[0])  # our own script's list of numbers
        self.assertEqual(sorted(len(c) for c in seen), [4, 12])
        self.assertEqual({p[:2] for c in seen for p in c}, {p[:2] for c in points(glyph(RING, STEM)) for p in c})


if __name__ == "__main__":
    unittest.main()
