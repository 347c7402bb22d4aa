"""A drawing in true size over sheets of paper, read back by poppler: their number and size, the square to check the printer by, and
the same point of the drawing where it belongs on neighbouring sheets."""

import re
import shutil
import subprocess
import unittest

import numpy

from program import ProgramTest

DPI = 127  # 5 pixels a millimetre
ROOM = 1.01  # pixels


def svg(wide, high, inner="", unit="mm"):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide}{unit}" height="{high}{unit}" '
            f'viewBox="0 0 {wide} {high}">{inner}</svg>')


@unittest.skipUnless(shutil.which("pdfinfo"), "poppler-utils is not installed")
class Tiles(ProgramTest):
    def tile(self, text, *words):
        """The PDF's number of pages and their size in points."""
        self.done("render", self.file("a.svg", text), "o.pdf", "--tile", *words)
        told = subprocess.run(["pdfinfo", self.folder / "o.pdf"], check=True, capture_output=True, text=True).stdout
        size = re.search(r"Page size: +([\d.]+) x ([\d.]+) pts", told)
        return int(re.search(r"Pages: +(\d+)", told)[1]), [float(v) for v in size.groups()]

    def page(self, number):
        """Its pixels: red, green, blue."""
        data = subprocess.run(["pdftoppm", "-r", str(DPI), "-f", str(number), "-l", str(number), self.folder / "o.pdf"],
                              check=True, capture_output=True).stdout
        kind, size, _, rest = data.split(b"\n", 3)
        self.assertEqual(kind, b"P6")
        wide, high = map(int, size.split())
        return numpy.frombuffer(rest, numpy.uint8).reshape(high, wide, 3).astype(int)

    def red(self, number):
        """Where the red is, in millimetres from the sheet's upper left corner: its middle. None: there is none."""
        page = self.page(number)
        rows, columns = numpy.nonzero((page[:, :, 0] > 200) & (page[:, :, 1] < 80))
        return None if not len(rows) else numpy.array([columns.mean() + .5, rows.mean() + .5]) * 25.4 / DPI

    def test_pages_and_sizes(self):
        # What a sheet shows, in mm, is 10 mm less on each side; each further one adds that less the overlap.
        for sheet, points, drawing, words, pages in (
                ("A4", (595.28, 841.89), (500, 400), (), 3 * 2),
                ("a4", (595.28, 841.89), (550, 544), (), 3 * 2),
                ("A4", (595.28, 841.89), (551, 545), (), 4 * 3),
                ("A4", (595.28, 841.89), (550, 100), ("--overlap", "0"), 3),
                ("letter", (612, 792), (500, 400), (), 3 * 2),
                ("100x150mm", (283.46, 425.2), (150, 200), (), 2 * 2),
                ("4x6in", (288, 432), (100, 150), (), 1),
                ("A4", (595.28, 841.89), (210, 297), (), 1),
                ("A4", (595.28, 841.89), (20, 30), (), 1)):
            found, size = self.tile(svg(*drawing), sheet, *words)
            self.assertEqual(found, pages, (sheet, drawing))
            for a, b in zip(size, points):
                self.assertAlmostEqual(a, b, delta=.02, msg=sheet)
        self.assertEqual(self.tile(svg(1890, 100, unit="px"), "A4")[0], 3)  # 500 mm
        self.assertEqual(self.tile(svg(20, 4, unit="in"), "A4")[0], 3)

    def test_rows_and_columns(self):
        self.tile(svg(500, 400), "A4")
        text = subprocess.run(["pdftotext", self.folder / "o.pdf", "-"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(re.findall(r"row (\d), column (\d) of 2 x 3", text),
                         [(r, c) for r in "12" for c in "123"])
        self.assertEqual(text.count("50 mm"), 1)

    def test_the_square(self):
        self.tile(svg(500, 400), "A4")
        page = self.page(1)
        dark = page.sum(2) < 384
        box = dark[75:75 + 270, 60:60 + 270]  # away from the marks around
        rows, columns = (numpy.nonzero(box.sum(axis) > 200)[0] for axis in (1, 0))
        for lines in (rows, columns):
            self.assertAlmostEqual(lines[-1] - lines[0], 50 * 5, delta=ROOM)
        dark = self.page(2).sum(2) < 384
        self.assertEqual(dark[60:-60, 60:-60].sum(), 0, "on the first only")

    def test_one_point_on_neighbours(self):
        # On the first sheet it is 10 mm further in than in the drawing; on the next one 180 (or 267) less.
        for at, sheets in (((185, 100), {1: (195, 110), 2: (15, 110)}), ((300, 272), {2: (130, 282), 5: (130, 15)})):
            self.tile(svg(500, 400, f'<rect x="{at[0] - 1}" y="{at[1] - 1}" width="2" height="2" fill="#f00"/>'), "A4")
            for number in range(1, 7):
                found = self.red(number)
                self.assertEqual(found is not None, number in sheets, number)
                if found is not None:
                    self.assertLess(numpy.abs(found - sheets[number]).max(), ROOM * 25.4 / DPI, (at, number))

    def test_smaller_than_a_sheet(self):
        self.tile(svg(100, 60, '<rect x="49" y="29" width="2" height="2" fill="#f00"/>'), "A4")
        self.assertLess(numpy.abs(self.red(1) - (105, 148.5)).max(), ROOM * 25.4 / DPI)

    def test_the_square_makes_way(self):
        self.tile(svg(500, 400, '<rect x="5" y="5" width="80" height="80" fill="#f00"/>'), "A4")
        page = self.page(1)[80:460, 80:460]
        self.assertTrue((page == (255, 0, 0)).all())

    def test_an_empty_drawing(self):
        self.assertEqual(self.tile('<svg xmlns="http://www.w3.org/2000/svg"/>', "A4")[0], 1)

    def test_refused(self):
        name = self.file("a.svg", svg(20000, 20000))
        line = self.refused(1, "render", name, "o.pdf", "--tile", "A4")
        self.assertRegex(line, r"found 8\d{3} \(75 rows, 112 columns\).*--tile A0")
        for words in (("A4", "--overlap", "190"), ("A4", "--overlap", "297"), ("A4", "--overlap", "nan"),
                      ("A4", "--overlap", "-1"), ("A9",), ("nanxnanmm",), ("infx5mm",), ("100x150",), ("0x5mm",), ("",)):
            self.refused(2, "render", name, "o.pdf", "--tile", *words)
        self.refused(2, "render", name, "o.png", "--tile", "A4")
        self.refused(2, "render", name, "o.pdf", "--tile", "A4", "--size", "9x9")
        self.refused(2, "render", name, "o.pdf", "--overlap", "5")
        self.assertFalse((self.folder / "o.pdf").exists())


if __name__ == "__main__":
    unittest.main()
