"""PDF and EPS: what is written looks the same in poppler and in ghostscript; the first page of a PDF is read, whoever wrote it."""
import io
import os
import pathlib
import shutil
import subprocess
import unittest

import numpy
from PIL import Image

from program import ROOT, ProgramTest

CAR = ROOT / "examples" / "car.svg"
DRAWINGS = (CAR, ROOT / "docs/pictures/levels-fig2.svg")


def missing(*programs):
    return next((name for name in programs if not shutil.which(name)), None)


class Pages(ProgramTest):
    def pixels(self, data):
        return numpy.asarray(Image.open(io.BytesIO(data)).convert("L"), dtype=float)

    def ours(self, name, *words):
        return self.pixels(self.done("render", name, "-", "--to", "png", *words))

    def by_poppler(self, name):
        return self.pixels(subprocess.run(["pdftocairo", "-png", "-r", "96", "-singlefile", name, "-"], check=True,
                                          capture_output=True).stdout)

    def by_ghostscript(self, name):
        return self.pixels(subprocess.run(["gs", "-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=png16m", "-r72",
                                           "-dTextAlphaBits=4", "-dGraphicsAlphaBits=4", "-sOutputFile=-", name],
                                          check=True, capture_output=True).stdout)

    def same(self, a, b, most=0.01):
        """But for shades of the same edge: no pixel has nothing like it within a pixel."""
        self.assertEqual(a.shape, b.shape)
        around = [numpy.roll(b, (y, x), (0, 1)) for y in (-1, 0, 1) for x in (-1, 0, 1)]
        low, high = numpy.min(around, axis=0), numpy.max(around, axis=0)
        beyond = numpy.maximum(numpy.maximum(low - a, a - high), 0)
        self.assertLess((beyond > 40).mean(), most)
        self.assertGreater((a < 200).mean(), 0.005, "there is something to see")

    @unittest.skipIf(missing("pdftocairo"), "poppler-utils is not installed")
    def test_pdf_as_poppler_shows_it(self):
        for name in DRAWINGS:
            self.done("convert", name, "out.pdf")
            self.done("render", name, "same.pdf")
            self.same(self.by_poppler(self.folder / "out.pdf"), self.ours(name))
            sizes = [len((self.folder / f).read_bytes()) for f in ("out.pdf", "same.pdf")]
            self.assertLess(abs(sizes[0] - sizes[1]), 100)

    @unittest.skipIf(missing("gs"), "ghostscript is not installed")
    def test_eps_as_ghostscript_shows_it(self):
        for drawing in DRAWINGS:  # in points, so that a pixel is one
            name = self.file("in.batten", dict(self.json("convert", drawing, "-", "--to", "batten"), unit="pt", scale=25.4 / 72))
            self.done("convert", name, "out.eps")
            data = (self.folder / "out.eps").read_bytes()
            self.assertTrue(data.startswith(b"%!PS-Adobe-3.0 EPSF-3.0"))
            box = next(line for line in data.split(b"\n") if line.startswith(b"%%BoundingBox")).split()[1:]
            left, low, right, high = map(int, box)
            whole = self.ours(name, "--dpi", "72")
            image = self.by_ghostscript(self.folder / "out.eps")  # a page larger than the picture, which is at the lower left
            height = min(image.shape[0], whole.shape[0])
            width = min(image.shape[1], whole.shape[1])
            self.assertTrue(0 <= left < right <= whole.shape[1] and 0 <= low < high <= whole.shape[0])
            self.same(image[image.shape[0] - height:, :width], whole[whole.shape[0] - height:, :width])

    @unittest.skipIf(missing("pdftocairo"), "poppler-utils is not installed")
    def test_a_pdf_comes_back(self):
        for name in DRAWINGS:
            self.done("convert", name, "out.pdf")
            (self.folder / "as.ai").write_bytes((self.folder / "out.pdf").read_bytes())
            for made in ("out.pdf", "as.ai"):
                self.done("convert", made, "back.svg")
                self.same(self.ours(self.folder / "back.svg", "--size", "500x500"), self.ours(name, "--size", "500x500"))
            scales = [self.json("info", f, "--json").get("scale", 25.4 / 96) for f in (name, "out.pdf")]
            self.assertLess(abs(scales[1] - 25.4 / 72), 1e-9)
            curves = [self.json("convert", f, "-", "--to", "json") for f in (name, "out.pdf")]
            corners = [[k * m(p[c] for one in many for p in one["points"]) for m in (min, max) for c in (0, 1)]
                       for k, many in zip(scales, curves)]
            self.assertLess(numpy.abs(numpy.subtract(*corners)).max(), 0.1 * scales[0])

    @unittest.skipIf(missing("pdftocairo", "rsvg-convert"), "poppler-utils or librsvg2-bin is not installed")
    def test_the_first_page_of_others(self):
        pages = []
        for k, shape in enumerate(('<circle cx="60" cy="60" r="40"/>', '<rect x="5" y="5" width="20" height="90"/>')):
            text = f'<svg xmlns="http://www.w3.org/2000/svg" width="120" height="120">{shape}</svg>'
            pages.append(self.file(f"page{k}.svg", text))
        subprocess.run(["rsvg-convert", "-f", "pdf", "-o", self.folder / "two.pdf", *pages], check=True)
        curves = self.json("convert", "two.pdf", "-", "--to", "json")
        self.assertIsInstance(curves, dict, "one circle, not the second page's rectangle")
        middle = numpy.mean(curves["points"], axis=0)
        radius = numpy.linalg.norm(numpy.subtract(curves["points"][0], middle))
        self.assertTrue(abs(radius / 40 - 1) < 0.5)
        found = self.done("info", "two.pdf").decode()
        self.assertIn("svg", found)

    def test_what_is_no_pdf(self):
        for text in ("%PDF-1.7\nnothing of the kind\n", "%PDF-"):
            line = self.refused(1, "convert", self.file("bad.pdf", text), "out.svg")
            self.assertIn("pdftocairo", line)
            self.assertFalse((self.folder / "out.svg").exists())
        self.refused(1, "convert", self.file("empty.pdf", ""), "out.svg")

    def test_without_the_program(self):
        path = os.environ["PATH"]
        os.environ["PATH"] = str(self.folder)
        try:
            line = self.refused(1, "convert", self.file("a.pdf", "%PDF-1.4\n"), "out.svg")
        finally:
            os.environ["PATH"] = path
        self.assertIn("pdftocairo is needed (package poppler-utils)", line)

    def test_a_picture_keeps_off_the_drawing(self):
        self.done("convert", CAR, "a.pdf")
        self.assertIn("--lossy", self.refused(1, "convert", "a.pdf", "a.pdf") if not missing("pdftocairo") else "--lossy")
        self.assertIn("--plain is for .svg, not for .pdf", self.refused(2, "convert", CAR, "b.pdf", "--plain"))
        self.assertIn("--arcs is for .dxf, not for .eps", self.refused(2, "convert", CAR, "b.eps", "--arcs", "1"))
        self.assertFalse(pathlib.Path(self.folder / "b.pdf").exists())


if __name__ == "__main__":
    unittest.main()
