#!/usr/bin/env python3
"""Files packed by gzip: read as what is in them, written by name; damaged ones are refused. SVG without our data."""
import gzip
import re
import unittest

from editor import Editor
from program import ROOT, ProgramTest

CAR = ROOT / "examples" / "car.svg"


class Svgz(ProgramTest):
    def info(self, *arguments, **more):
        told = self.json("info", "--json", *arguments, **more)
        told.pop("file", None)
        return told

    def packed(self, data, name="drawing.svgz"):
        path = self.folder / name
        path.write_bytes(gzip.compress(data))
        return path

    def test_it_is_read_as_what_is_in_it(self):
        path = self.packed(CAR.read_bytes())
        expected = self.info(str(CAR))
        self.assertEqual(self.info(str(path)), expected)
        self.assertEqual(self.info("-", stdin=path.read_bytes()), expected)
        picture, other = self.folder / "a.png", self.folder / "b.png"
        self.done("render", str(path), str(picture))
        self.done("render", str(CAR), str(other))
        self.assertEqual(picture.read_bytes(), other.read_bytes())

    def test_it_is_edited_and_stays_packed(self):
        path = self.packed(CAR.read_bytes())
        editor = Editor(path)
        self.addCleanup(editor.end)
        self.assertEqual(editor.get("/document")[2], CAR.read_bytes())
        changed = CAR.read_bytes().replace(b"#9aa3ad", b"#00ff00")
        status, headers, _ = editor.request("PUT", "/document", {"Content-Type": "image/svg+xml", "If-Match": editor.tag()}, changed)
        self.assertEqual(status, 204)
        self.assertEqual(gzip.decompress(path.read_bytes()), changed)
        self.assertEqual((editor.tag(), editor.get("/document")[2]), (headers["ETag"], changed))
        status, name, _ = editor.post(changed, kind="image/svg+xml")
        self.assertEqual((status, name), (201, "drawing (copy).svgz"))
        self.assertEqual(gzip.decompress((self.folder / name).read_bytes()), changed)
        path.write_bytes(gzip.compress(changed)[:-20])
        self.assertEqual(editor.get("/document")[0], 500)
        self.refused(1, "edit", str(path), "--no-open")

    def test_it_is_written_by_name(self):
        path = self.folder / "out.svgz"
        self.done("convert", str(CAR), str(path))
        self.assertEqual(gzip.decompress(path.read_bytes()), CAR.read_bytes())
        self.assertEqual(path.read_bytes()[4:8], bytes(4))  # no time: the same file each time
        big = CAR.read_bytes().replace(b"</svg>", b"<!--" + b"abc " * 3000000 + b"--></svg>")
        self.done("convert", str(self.packed(big)), str(path))
        self.assertEqual(gzip.decompress(path.read_bytes()), big)

    def test_damaged_files_are_refused(self):
        whole = gzip.compress(CAR.read_bytes())
        for data in (whole[:-9], whole[:40], whole[:11], whole[:60] + b"abc" + whole[63:], gzip.compress(bytes((1 << 28) + 1))):
            path = self.folder / "bad.svgz"
            path.write_bytes(data)
            self.assertRegex(self.refused(1, "info", str(path)), r"bad\.svgz: expected a .* found ")

    def test_plain(self):
        path, packed = self.folder / "plain.svg", self.folder / "plain.svgz"
        native = self.folder / "car.batten"
        self.done("convert", str(CAR), str(native))
        self.done("convert", str(native), str(path), "--plain")
        self.done("convert", str(native), str(packed), "--plain")
        text = path.read_bytes()
        self.assertNotIn(b"batten:document", text)
        self.assertEqual(gzip.decompress(packed.read_bytes()), text)
        self.assertEqual(len(re.findall(b"<path", text)), len(re.findall(b"<path", CAR.read_bytes())))


if __name__ == "__main__":
    unittest.main()
