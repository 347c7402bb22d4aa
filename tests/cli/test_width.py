"""Widths along strokes: `curve outline --widths`, and `width` for drawings, as they are written, painted and read again."""
import json
import pathlib
import re
import unittest

from program import ProgramTest

LINE = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [100, 0]]}
SVG = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 120 40">'
       '<path d="M10 20H110" fill="none" stroke="#cc0000" stroke-width="2"/></svg>')


def area(curves):
    """Of polygons: the outlines of straight strokes with straight sides."""
    total = 0
    for curve in curves:
        points = curve["points"]
        total += sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1])) / 2
    return total


class Width(ProgramTest):
    def test_outlines_follow_the_list(self):
        name = self.file("line.json", json.dumps(LINE))
        cone = self.json("curve", "outline", name, "--widths", "0,2;1,6", "--cap", "butt")
        self.assertEqual(len(cone), 1)
        xs, ys = zip(*cone[0]["points"])
        self.assertAlmostEqual(max(xs), 100)
        self.assertAlmostEqual(max(ys), 3)
        even = self.done("curve", "outline", name, "--width", "3")
        self.assertEqual(self.done("curve", "outline", name, "--widths", "0,3;0.5,3"), even)

    def test_refuses_what_is_no_list(self):
        name = self.file("line.json", json.dumps(LINE))
        for words in (["--widths", "0,1;0,2"], ["--widths", "0,1,2"], ["--widths", "0,-1"], ["--widths", "0,0"],
                      ["--widths", "0,1;2,1"], ["--width", "1", "--widths", "0,1"], []):
            self.refused(2, "curve", "outline", name, *words)
        self.refused(2, "width", self.file("a.svg", SVG))

    def test_plotters_get_a_line_or_the_outline(self):
        """EPS has one line of one width, and says so; on request what the stroke covers, as DXF and G-code have, too."""
        wide = self.file("wide.svg", self.done("width", self.file("line.svg", SVG), "--widths", "0,0;0.5,8;1,0").decode())
        line, outline, cut, around = (str(self.folder / name) for name in ("line.eps", "outline.eps", "cut.dxf", "around.dxf"))
        said = self.run_program("convert", wide, line)
        self.assertEqual(said.returncode, 0)
        self.assertIn(b"1 stroke of changing width written as a line of one width", said.stderr)
        self.done("convert", wide, outline, "--outline")
        painted = [re.search(r"%%EndPageSetup(.*)showpage", pathlib.Path(name).read_text(encoding="latin1"), re.S).group(1) for name in (line, outline)]
        self.assertRegex(painted[0], r"7.5 15 m [0-9. \n]*82.5 15 c S")
        self.assertNotRegex(painted[0], r"\bf\b")
        self.assertRegex(painted[1], r" c h\n[^S]* f\n")
        self.assertNotRegex(painted[1], r"\bS\b")
        self.done("convert", wide, cut)
        self.done("convert", wide, around, "--outline")
        closed = [re.search(r"ENTITIES.*?SPLINE.*?\n *70\r?\n *(\d+)", pathlib.Path(name).read_text(encoding="ascii"), re.S) for name in (cut, around)]
        self.assertEqual([int(found.group(1)) & 1 if found else None for found in closed], [0, 1], "open, closed")
        self.refused(2, "convert", wide, str(self.folder / "a.pdf"), "--outline")
        filled = self.file("filled.svg", pathlib.Path(wide).read_text(encoding="utf8").replace('fill="none"', 'fill="#00ff00"'))
        self.done("convert", filled, outline, "--outline")

    def test_drawings_keep_it(self):
        name = self.file("a.svg", SVG)
        wide = self.file("wide.svg", self.done("width", name, "--widths", "0,0;0.5,8;1,0").decode())
        text = pathlib.Path(wide).read_text(encoding="utf8")
        self.assertRegex(text, r'fill(="|:)#cc0000')  # for others: what it covers
        info = self.json("info", wide, "--json")
        native = self.file("wide.batten", self.done("convert", wide, "-", "--to", "batten").decode())
        self.assertEqual(json.loads(pathlib.Path(native).read_text(encoding="utf8"))["batten"], 7)
        self.assertEqual(json.loads(pathlib.Path(native).read_text(encoding="utf8"))["objects"][0]["paint"]["widths"], [[0, 0], [0.5, 1], [1, 0]])
        self.assertEqual(self.json("info", native, "--json")["objects"][0]["widths"], [[0, 0], [0.5, 8], [1, 0]])
        self.assertEqual(info["objects"][0]["widths"], [[0, 0], [0.5, 8], [1, 0]])

    def test_without_it_nothing_changes(self):
        native = self.done("convert", self.file("a.svg", SVG), "-", "--to", "batten")
        self.assertNotIn(b"widths", native)
        self.assertNotIn(b'"batten":7', native)


if __name__ == "__main__":
    unittest.main()
