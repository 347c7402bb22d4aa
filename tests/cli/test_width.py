"""Widths along strokes: `curve outline --widths`, and `width` for drawings, as they are written, painted and read again."""
import json
import pathlib
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
