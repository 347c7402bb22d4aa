"""render: PNG against librsvg's picture of the SVG, sizes, backgrounds, PDF."""
import base64
import io
import json
import os
import pathlib
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree
import zlib

import numpy
from PIL import Image, ImageChops

from program import CURVE, PROGRAM, ROOT, ProgramTest

CAR = ROOT / "examples" / "car.svg"


def pixels(data):
    """An RGB or RGBA PNG of 8 bits as an array (height, width, 4)."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height, depth, kind, _, _, interlace = struct.unpack(">IIBBBBB", data[16:29])
    assert depth == 8 and kind in (2, 6) and interlace == 0
    at, packed = 8, b""
    while at < len(data):
        size = struct.unpack(">I", data[at:at + 4])[0]
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    channels = 4 if kind == 6 else 3
    raw = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + width * channels)
    image = numpy.zeros((height, width, channels), int)
    for y in range(height):
        row, above = raw[y, 1:].reshape(width, channels).astype(int), image[y - 1] if y else numpy.zeros((width, channels), int)
        if raw[y, 0] == 0:
            image[y] = row
        elif raw[y, 0] == 1:
            image[y] = numpy.cumsum(row, 0) % 256
        elif raw[y, 0] == 2:
            image[y] = (row + above) % 256
        else:
            for x in range(width):
                left, corner = (image[y, x - 1], above[x - 1]) if x else (numpy.zeros(channels, int),) * 2
                if raw[y, 0] == 3:
                    guess = (left + above[x]) // 2
                else:
                    sums = numpy.abs([above[x] - corner, left - corner, left + above[x] - 2 * corner])
                    guess = numpy.where((sums[0] <= sums[1]) & (sums[0] <= sums[2]), left,
                                        numpy.where(sums[1] <= sums[2], above[x], corner))
                image[y, x] = (row[x] + guess) % 256
    if channels == 3:
        image = numpy.dstack([image, numpy.full((height, width), 255)])
    return image


class Render(ProgramTest):
    def png(self, name, *words):
        self.done("render", name, self.folder / "out.png", *words)
        return pixels((self.folder / "out.png").read_bytes())

    def rsvg(self, name, width, height):
        data = subprocess.run(["rsvg-convert", "-w", str(width), "-h", str(height), "-b", "white", str(name)],
                              check=True, capture_output=True).stdout
        return pixels(data)

    def compare(self, ours, theirs):
        """Two rasterisers may differ by a shade along edges, not in where things are."""
        self.assertEqual(ours.shape, theirs.shape)
        difference = numpy.abs(ours[:, :, :3] - theirs[:, :, :3]).max(2)
        self.assertLess((difference > 64).mean(), 0.002)
        self.assertLess(difference.mean(), 1.0)
        self.assertGreater((theirs[:, :, :3].min(2) < 128).mean(), 0.005)  # there is something to see

    @unittest.skipUnless(shutil.which("rsvg-convert"), "librsvg2-bin is not here")
    def test_car_as_librsvg_paints_it(self):
        self.compare(self.png(CAR, "--size", "300x126"), self.rsvg(CAR, 300, 126))

    @unittest.skipUnless(shutil.which("rsvg-convert"), "librsvg2-bin is not here")
    def test_styles_as_librsvg_paints_them(self):
        svg = self.file("s.svg", """<svg xmlns="http://www.w3.org/2000/svg" viewBox="10 20 200 100" width="200" height="100">
<rect x="20" y="30" width="60" height="40" fill="#3366cc" opacity=".5" stroke="#cc3300" stroke-width="8"/>
<path d="M100 30L160 30L110 60L150 100" fill="none" stroke="black" stroke-width="6" stroke-linejoin="bevel" stroke-linecap="square"/>
<path d="M60 60h60v60h-60z M75 75h30v30h-30z" fill="#0a0" fill-rule="evenodd" fill-opacity=".7"/>
<circle cx="180" cy="80" r="20" fill="gold" stroke="navy" stroke-width="3" stroke-opacity=".5"/></svg>""")
        self.compare(self.png(svg), self.rsvg(svg, 200, 100))
        self.done("render", svg, self.folder / "o.svg")  # our SVG by librsvg is our PNG
        self.compare(self.png(svg), self.rsvg(self.folder / "o.svg", 200, 100))

    def test_sizes(self):
        for name, words, size in ((CAR, [], (1000, 420)), (CAR, ["--size", "100x90"], (100, 90)),
                                  (self.file("c.json", dict(CURVE, points=[[0, 0]] * 4 + [[3, 0]])), [], (1000, 400))):
            data = self.done("render", name, "-", "--to", "png", *words)
            self.assertEqual(struct.unpack(">II", data[16:24]), size)

    def test_a_line_is_where_it_should_be(self):
        line = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [100, 0]]}
        image = self.png(self.file("c.json", line), "--size", "102x10")  # 2 wide, with its caps 102 x 2
        self.assertTrue((image[4:6, 2:100, :3] == 0).all())
        self.assertTrue((image[[0, 1, 2, 7, 8, 9]] == 255).all())

    def test_backgrounds(self):
        curve = self.file("c.json", CURVE)
        for words, corner in (([], [255] * 4), (["--background", "none"], [0] * 4),
                              (["--background", "#102030"], [16, 32, 48, 255])):
            self.assertEqual(self.png(curve, "--size", "40x20", *words)[0, 0].tolist(), corner)

    def test_svg(self):
        self.done("render", CAR, self.folder / "o.svg", "--size", "500x300", "--background", "#ffeedd")
        root = xml.etree.ElementTree.parse(self.folder / "o.svg").getroot()
        self.assertEqual((root.get("width"), root.get("height"), root.get("viewBox")), ("500", "300", "0 0 1000 420"))
        self.assertIsNone(root.find("{http://www.w3.org/2000/svg}metadata"))
        self.assertNotIn(b"<title", (self.folder / "o.svg").read_bytes())  # a picture, not the file

    def test_pdf(self):
        self.done("render", CAR, self.folder / "o.pdf")
        data = (self.folder / "o.pdf").read_bytes()
        self.assertTrue(data.startswith(b"%PDF-1.") and data.rstrip().endswith(b"%%EOF"))
        self.assertIn(b"/MediaBox [ 0 0 750 315 ]", data)

    def test_degenerate_drawings(self):
        empty = self.file("e.batten", '{"batten":1,"page":[0,0,0,0],"next":1,"objects":[]}')
        self.assertEqual(self.png(empty, "--size", "8x8").shape, (8, 8, 4))
        dot = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[5, 5], [5, 5]]}
        self.png(self.file("d.json", dot), "--size", "8x8")
        for size in (1e-70, 1e70):
            wide = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [size, size]]}
            self.run_program("render", self.file("w.json", wide), self.folder / "w.png", "--size", "8x8")

    def test_pictures_of_the_documents_can_be_made(self):
        shutil.copy(ROOT / "docs/pictures/car.journal", self.folder)
        subprocess.run([ROOT / "docs/pictures/animate", PROGRAM, self.folder], check=True)
        made, kept = (Image.open(folder / "film.gif") for folder in (self.folder, ROOT / "docs/pictures"))
        self.assertEqual((made.n_frames, made.size), (kept.n_frames, kept.size))
        for k in range(0, kept.n_frames, 5):  # shades may differ between versions of cairo
            made.seek(k), kept.seek(k)
            difference = ImageChops.difference(made.convert("L"), kept.convert("L"))
            self.assertLess(sum(difference.histogram()[64:]), 200, f"frame {k}")

    def test_standard_output(self):
        data = self.done("render", "-", "-", "--to", "png", "--size", "20x10", stdin=json.dumps(CURVE))
        self.assertEqual(pixels(data).shape, (10, 20, 4))

    def test_pictures_to_trace(self):
        """Converted there and back they keep their bytes and their place, and every picture shows them, unless they are hidden."""
        red = io.BytesIO()
        Image.new("RGB", (4, 2), (255, 0, 0)).save(red, "PNG")
        data = base64.b64encode(red.getvalue()).decode()
        line = '<path d="M10 25H90" stroke="#000" stroke-width="4" fill="none"/>'
        head = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50" width="100" height="50">'
        plain = self.file("plain.svg", f"{head}{line}</svg>")
        traced = self.file("traced.svg", f'{head}<image width="100" height="50" '
                           f'href="data:image/png;base64,{data}"/>{line}</svg>')
        native, back = self.folder / "traced.batten", self.folder / "back.svg"
        self.done("convert", traced, native)
        self.done("convert", native, back)
        drawing = json.loads(native.read_text())
        self.assertEqual([one["data"] for one in drawing["pictures"]], [data])
        self.assertEqual(drawing["objects"][0]["matrix"], [25, 0, 0, 25, 0, 0])
        self.assertIn(data, back.read_text())
        hidden = self.file("hidden.svg", pathlib.Path(traced).read_text().replace("<image", '<image display="none"'))
        for source in traced, native, back:
            seen = self.png(source)
            self.assertTrue((seen[5:20, :, :3] == [255, 0, 0]).all(), source)
            self.assertTrue((seen[23:27, 10:90, :3] == 0).all(), source)  # behind the line
            self.done("render", source, self.folder / "out.pdf")
            self.assertIn(b"/Subtype /Image", (self.folder / "out.pdf").read_bytes())
            self.done("render", source, self.folder / "out.svg")
            self.assertIn(data, (self.folder / "out.svg").read_text())
        self.assertTrue((self.png(hidden) == self.png(plain)).all())
        # Without a page it counts for the size: the line alone is flat.
        bare = self.file("bare.svg", pathlib.Path(traced).read_text().replace(' viewBox="0 0 100 50" width="100" height="50"', ""))
        self.assertEqual(self.png(bare).shape[:2], (500, 1000))


def faults(*words):
    """Pages of memory that the program touched."""
    child = subprocess.Popen([PROGRAM, *words])
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    assert child.returncode == 0
    return usage.ru_minflt


class Large(ProgramTest):
    def test_what_is_translucent_takes_no_picture_of_its_own(self):
        def drawing(opacity):
            shapes = "".join(f'<circle cx="{50 * i + 25}" cy="25" r="9" fill="red" stroke="blue" opacity="{opacity}"/>'
                             for i in range(8))
            path = self.folder / f"translucent{opacity}.svg"
            path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4000 4000">{shapes}</svg>')
            return faults("render", path, self.folder / "large.png", "--size", "4000x4000")
        self.assertLess(drawing(0.5), 2 * drawing(1))


if __name__ == "__main__":
    unittest.main()
