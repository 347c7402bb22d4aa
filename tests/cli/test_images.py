#!/usr/bin/env python3
"""Pictures in a drawing are painted, whatever their kind and place; what could not be is said in one line; and nothing is read or
painted twice in one picture. References: Pillow, which knows how a photo is turned, and rsvg-convert."""
import base64
import io
import os
import pathlib
import shutil
import unittest

import numpy
from PIL import Image, ImageOps
from program import PROGRAM, ProgramTest
from test_foreign import SHARE, compare

HEAD = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 100 100" width="100" '
        'height="100">')


def quarters():
    """Four colours, no two of which change places unseen."""
    image = Image.new("RGB", (40, 20), (255, 0, 0))
    image.paste((0, 0, 255), (0, 0, 20, 20))
    image.paste((0, 160, 0), (0, 0, 20, 10))
    image.paste((255, 255, 0), (20, 10, 40, 20))
    return image


def encoded(kind, turn=1):
    exif, out = Image.Exif(), io.BytesIO()
    exif[0x112] = turn
    quarters().save(out, kind, **({"exif": exif.tobytes(), "quality": 100, "subsampling": 0} if kind == "JPEG" else {}))
    return out.getvalue()


def uri(kind, turn=1):
    return f"data:image/{kind.lower()};base64,{base64.b64encode(encoded(kind, turn)).decode()}"


def placed(href):
    """As an image, turned and translucent, as one in a pattern, as a pattern of nothing else, in a mask and in a marker's place."""
    return {
        "image": f'<image x="5" y="5" width="90" height="90" xlink:href="{href}"/>',
        "turned": f'<g transform="rotate(30 50 50)" opacity=".5"><image x="20" y="20" width="60" height="60" xlink:href="{href}"/></g>',
        "pattern": f'<pattern id="p" width="20" height="10" patternUnits="userSpaceOnUse"><image width="20" height="10" xlink:href='
                   f'"{href}"/></pattern><path d="M5 5H95V95H5Z" fill="url(#p)"/>',
        "in a pattern": f'<pattern id="p" width="30" height="30" patternUnits="userSpaceOnUse"><circle r="20"/><image x="5" y="5" width='
                        f'"20" height="10" xlink:href="{href}"/></pattern><path d="M5 5H95V95H5Z" fill="url(#p)"/>',
        "mask": f'<mask id="m"><image width="100" height="100" xlink:href="{href}"/></mask><rect width="100" height="100" fill="#024" '
                'mask="url(#m)"/>',
        "used": f'<defs><image id="i" width="50" height="50" xlink:href="{href}"/></defs><use xlink:href="#i" x="30" y="20"/>',
    }


class Images(ProgramTest):
    def seen(self, path):
        self.done("render", path, self.folder / "seen.png", "--background", "white")
        return numpy.asarray(Image.open(self.folder / "seen.png").convert("RGB")).astype(int)

    @unittest.skipUnless(shutil.which("rsvg-convert"), "rsvg-convert is not installed")
    def test_as_librsvg_shows_them(self):
        for kind in "PNG", "JPEG", "GIF":
            for name, content in placed(uri(kind)).items():
                path = self.file("drawn.svg", f"{HEAD}{content}</svg>")
                if (kind, name) == ("GIF", "used"):  # a picture of another kind in what is used is not drawn, and that is said
                    self.assertIn("1 image", self.run_program("render", path, self.folder / "o.png").stderr.decode())
                    continue
                share = compare(PROGRAM, path)
                self.assertIsNotNone(share, (kind, name))
                self.assertLessEqual(share, SHARE, (kind, name))

    @unittest.skipUnless(shutil.which("rsvg-convert"), "librsvg is not installed")
    def test_a_photo_is_turned_as_its_camera_was(self):
        for turn in range(1, 9):
            meant = ImageOps.exif_transpose(Image.open(io.BytesIO(encoded("JPEG", turn))))
            content = f'<image width="100" height="100" preserveAspectRatio="none" xlink:href="{uri("JPEG", turn)}"/>'
            seen = self.seen(self.file("turned.svg", f"{HEAD}{content}</svg>"))
            for x in 0.25, 0.75:
                for y in 0.25, 0.75:
                    colour = meant.getpixel((int(meant.width * x), int(meant.height * y)))
                    self.assertLess(abs(seen[int(100 * y), int(100 * x)] - colour).max(), 8, (turn, x, y))


class Counted(ProgramTest):
    """With what stands for librsvg, which counts."""

    def setUp(self):
        super().setUp()
        library = self.folder / "library"
        library.mkdir()
        for name in ("librsvg-2.so.2", "libgobject-2.0.so.0", "librsvg-2.2.dylib", "libgobject-2.0.0.dylib"):
            (library / name).symlink_to(os.environ["BATTEN_COUNTING_RSVG"])
        self.counts = self.folder / "counts"
        given = {"LD_LIBRARY_PATH": str(library), "DYLD_LIBRARY_PATH": str(library), "RSVG_COUNTS": str(self.counts)}
        for name, value in given.items():
            self.set(name, value)

    def set(self, name, value):
        before = os.environ.get(name)
        os.environ[name] = value
        self.addCleanup(lambda: os.environ.__setitem__(name, before) if before is not None else os.environ.pop(name, None))

    def drawing(self, count):
        """Many curves with one pattern, one mask and one picture."""
        parts = [f'<path d="M{i} 5h40v40h-40z" fill="url(#p)" stroke="url(#p)" mask="url(#m)"/>' for i in range(count)]
        images = [f'<image x="{i}" y="60" width="20" height="10" xlink:href="{uri("JPEG")}"/>' for i in range(count)]
        return (f'{HEAD}<pattern id="p" width="9" height="9" patternUnits="userSpaceOnUse"><circle r="5"/></pattern><mask id="m" maskUnits='
                f'"userSpaceOnUse" width="90" height="90"><circle r="80" fill="#fff"/></mask>{"".join(parts + images)}</svg>')

    def rendered(self, count, ending):
        path = self.file("many.svg", self.drawing(count))
        result = self.run_program("render", path, self.folder / f"many.{ending}")
        self.assertEqual(result.returncode, 0, result.stderr)
        if not self.counts.exists():
            self.skipTest("the program does not find the library that counts")
        return [int(word) for word in self.counts.read_text().split()], result.stderr.decode()

    def test_nothing_is_read_twice(self):
        for ending in "png", "pdf":
            (read, painted, released), said = self.rendered(30, ending)
            self.assertEqual((read, released), (3, 3), ending)  # the pattern, the mask, the picture: once each, and let go
            # Thirty masks and thirty pictures, the pattern once for fill and stroke, and whether the picture shows anything.
            self.assertEqual(painted, 62, ending)
            self.assertNotIn("left out", said)

    def test_what_is_left_out_is_said_in_one_line(self):
        self.set("RSVG_REFUSES", "1")
        _, said = self.rendered(3, "png")
        lines = [line for line in said.splitlines() if "left out" in line]
        self.assertEqual(len(lines), 1, said)
        self.assertTrue(lines[0].endswith("left out, as librsvg did not paint them: 3 images, 6 patterns, 3 masks"), said)
        path = self.file("plain.svg", f'{HEAD}<image width="9" height="9" xlink:href="{uri("PNG")}"/></svg>')
        self.assertNotIn("left out", self.run_program("render", path, self.folder / "plain.png").stderr.decode())


if __name__ == "__main__":
    unittest.main()
