"""convert, info and pipes: formats, what is left out, output that appears whole or not at all."""
import json
import math
import os
import pathlib
import random
import re
import resource
import stat
import subprocess
import unittest
import xml.etree.ElementTree

from program import CURVE, HANG, PROGRAM, RING, ROOT, SANITIZED, ProgramTest

CAR = ROOT / "examples" / "car.svg"
MIXED = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50" width="100" height="50">
<path d="M0 0C10 10 20 10 30 0" stroke="red" fill="none"/><text x="1" y="2">hello</text><text>again</text>
<image href="x.png" width="3" height="3"/><circle cx="50" cy="25" r="10"/></svg>"""

# In an encoding in which Batten does not keep a file as it is.
OLD = ('<?xml version="1.0" encoding="ISO-8859-1"?>' + MIXED.replace("hello", "h\xe9llo")).encode("latin-1")


class Convert(ProgramTest):
    def test_curve_to_everything_and_back_bit_for_bit(self):
        space = {"degree": 2, "closed": False, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0, 0], [5, 9, 4], [10, 0, 2]]}
        seventh = {"degree": 7, "closed": True, "knots": [0, 1, 2, 3, 4, 5, 6, 7, 8],
                   "points": [[0, 0], [5, 0], [9, 3], [9, 9], [5, 12], [0, 12], [-4, 9], [-4, 3]]}
        for curve in (CURVE, RING, space, seventh, dict(CURVE, points=[[0.1, 1 / 3], [1e-300, 2], [3e9, 3], [5, -0.0], [6, 2 / 7]])):
            first = self.file("a.json", curve)
            for steps in (["b.batten"], ["b.svg"], ["b.batten", "c.svg", "d.batten"]):
                last = first
                for step in (*steps, "e.json"):
                    self.done("convert", last, self.folder / step)
                    last = self.folder / step
                back = json.loads((self.folder / "e.json").read_text(), parse_int=float)  # -0 has its sign
                self.assertEqual({key: back[key] for key in curve}, curve)
                for now, then in zip(back["points"], curve["points"]):  # the sign of zero, too
                    self.assertEqual([math.copysign(1, v) for v in now], [math.copysign(1, v) for v in then])

    def test_svg_out_is_svg(self):
        self.done("convert", self.file("a.json", CURVE), self.folder / "a.svg")
        root = xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.assertEqual(len(root.findall(".//{http://www.w3.org/2000/svg}path")), 1)

    def test_car_survives(self):
        self.done("convert", CAR, self.folder / "car.batten")
        self.done("convert", self.folder / "car.batten", self.folder / "car.svg")
        self.done("convert", self.folder / "car.svg", self.folder / "again.batten")
        first, again = ((self.folder / name).read_bytes() for name in ("car.batten", "again.batten"))
        self.assertEqual(first, again)
        self.assertGreater(len(json.loads(first)["objects"]), 20)

    def test_many_curves_are_a_list(self):
        native = self.json("convert", CAR, "-", "--to", "batten")
        curves = [curve for thing in native["objects"] for curve in thing.get("curves", [])]
        self.done("convert", CAR, "car.json")
        self.assertEqual(json.loads((self.folder / "car.json").read_text()), curves)
        self.done("convert", "car.json", "car.jsonl")
        rows = (self.folder / "car.jsonl").read_text().splitlines()
        self.assertEqual([json.loads(row) for row in rows], curves)
        for words in (("car.jsonl",), ("car.json",), ("-",)):
            back = self.json("convert", *words, "-", "--to", "batten", stdin="\n\n".join(rows))
            self.assertEqual([curve for thing in back["objects"] for curve in thing["curves"]], curves)
        self.done("render", "car.jsonl", "car.png")
        self.assertEqual((self.folder / "car.png").read_bytes()[:4], b"\x89PNG")

    def test_lists_that_are_none(self):
        for name, text, said in (("a.json", "[]", "expected a curve, found none"),
                                 ("a.jsonl", "\n \n", "expected a curve, found none"),
                                 ("a.jsonl", json.dumps(CURVE) + "\n\n{]", "line 3, column 2"),
                                 ("a.json", "[3]", "line 1, column 2")):
            self.assertIn(said, self.refused(1, "convert", self.file(name, text), "b.svg"))
        self.file("none.batten", '{"batten":1,"page":[0,0,1,1],"next":1,"objects":[]}')
        for name in ("out.json", "out.jsonl"):
            self.assertIn("expected 1 at least, found none", self.refused(1, "convert", "none.batten", name))
            self.assertFalse((self.folder / name).exists())

    def test_what_is_left_out_is_counted(self):
        name = self.file("m.svg", MIXED)
        result = self.run_program("render", name, self.folder / "m.png")
        self.assertEqual(result.returncode, 0)
        self.done("convert", name, self.folder / "m.batten")
        self.assertEqual(result.stderr.count(b"\n"), 1)
        self.assertRegex(result.stderr.decode(), r"m\.svg: Left out: .*1 image")
        self.assertEqual(self.run_program("convert", self.folder / "m.batten", self.folder / "n.svg").stderr, b"")

    def test_texts_are_kept_or_said_to_be_left_out(self):
        text = {"id": 1, "kind": "text", "text": "a\nb", "box": [0, -24, 30, 40], "matrix": [1, 0, 0, 1, 5, 30]}
        line = {"id": 2, "kind": "path", "curves": [CURVE]}
        name = self.file("t.batten", {"batten": 12, "page": [0, 0, 90, 90], "objects": [text, line]})
        self.assertEqual(self.run_program("convert", name, self.folder / "t.svg").stderr, b"")
        self.assertEqual(self.run_program("convert", self.folder / "t.svg", self.folder / "u.batten").stderr, b"")
        again = json.loads((self.folder / "u.batten").read_text())["objects"][0]
        self.assertEqual({key: again[key] for key in text}, text)
        for ending in ("dxf", "json", "glif"):
            said = self.run_program("convert", name, self.folder / f"t.{ending}").stderr.decode()
            self.assertIn("t.batten: 1 text left out", said)

    def test_pipes_tell_the_format_from_the_text(self):
        native = self.done("convert", "-", "-", "--to", "batten", stdin=json.dumps(CURVE))
        svg = self.done("convert", "-", "-", "--to", "svg", stdin=native)
        back = json.loads(self.done("convert", "-", "-", "--to", "json", stdin=svg))
        self.assertEqual({key: back[key] for key in CURVE}, CURVE)
        self.assertEqual(self.done("convert", "-", "-", "--to", "batten", stdin=CAR.read_bytes()),
                         self.done("convert", CAR, "-", "--to", "batten"))

    def test_bad_files(self):
        for name, content, words in (
            ("a.svg", "", "line 1"), ("a.svg", "<svg", "line 1"), ("a.svg", "<svg>\n<g></svg>", "line 2"),
            ("a.svg", "{}", "line 1"), ("a.svg", "<html/>", ""), ("a.batten", "<svg/>", "line 1"),
            ("a.batten", "{}", ""), ("a.batten", '{"batten":99}', ""), ("a.json", '{"degree":3}', ""), ("a", "hello", "SVG"),
            ("a.svg", '<?xml version="1.0" encoding="martian"?><svg/>', "line 1"),
        ):
            with self.subTest(name=name, content=content):
                path = self.file(name, content)
                line = self.refused(1, "convert", path, self.folder / "out.batten")
                self.assertTrue(line.startswith(f"{path}: "), line)
                self.assertIn(words, line)
                self.assertFalse((self.folder / "out.batten").exists())

    def test_entities_do_not_explode(self):
        text = '<!DOCTYPE svg [<!ENTITY a "xxxxxxxxxxxxxxxx">' + "".join(
            f'<!ENTITY {b} "{"&" + a + ";"}{("&" + a + ";") * 15}">' for a, b in zip("abcdefgh", "bcdefghi"))
        self.refused(1, "convert", self.file("a.svg", text + "]><svg><title>&i;</title></svg>"), self.folder / "o.batten")

    def test_windows_encoding(self):
        text = '<?xml version="1.0" encoding="Windows-1252"?><svg xmlns="http://www.w3.org/2000/svg">' \
               '<path id="Stra\xdfe\x80" d="M0 0L1 1"/></svg>'
        info = self.json("info", self.file("a.svg", text.encode("latin1")), "--json")
        self.assertEqual(info["objects"][0]["name"], "Straße€")


class Output(ProgramTest):
    def test_old_file_stays_when_the_data_are_bad(self):
        old = self.file("out.svg", "old")
        self.refused(1, "convert", self.file("bad.json", "{"), old)
        self.assertEqual(open_text(old), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad.json", "out.svg"])

    def test_mode_link_and_nothing_left_beside(self):
        source, old = self.file("c.json", CURVE), self.folder / "out.batten"
        old.write_text("old")
        old.chmod(0o604)
        (self.folder / "link.batten").symlink_to("out.batten")
        self.done("convert", source, self.folder / "link.batten")
        self.assertTrue((self.folder / "link.batten").is_symlink())
        self.assertEqual(stat.S_IMODE(old.stat().st_mode), 0o604)
        self.assertEqual(sorted(os.listdir(self.folder)), ["c.json", "link.batten", "out.batten"])

    def test_new_file_has_the_usual_mode(self):
        source = self.file("c.json", CURVE)
        mask = os.umask(0o027)
        try:
            self.done("convert", source, self.folder / "out.batten")
        finally:
            os.umask(mask)
        self.assertEqual(stat.S_IMODE((self.folder / "out.batten").stat().st_mode), 0o640)

    def test_places_that_cannot_be_written(self):
        source = self.file("c.json", CURVE)
        old = self.folder / "old.batten"
        old.write_text("old")
        old.chmod(0o444)
        self.assertIn("read-only", self.refused(1, "convert", source, old))
        self.assertEqual(old.read_text(), "old")
        self.refused(1, "convert", source, self.folder / "nowhere" / "out.batten")
        (self.folder / "folder.svg").mkdir()
        self.refused(1, "convert", source, self.folder / "folder.svg")
        os.symlink("loop.svg", self.folder / "loop.svg")
        self.refused(1, "convert", source, self.folder / "loop.svg")

    def test_same_file_in_and_out(self):
        name = self.file("c.json", CURVE)
        self.done("convert", name, self.folder / "a.batten")
        before = (self.folder / "a.batten").read_bytes()
        self.done("convert", self.folder / "a.batten", self.folder / "a.batten")
        self.assertEqual((self.folder / "a.batten").read_bytes(), before)

    @unittest.skipIf(SANITIZED, "the sanitizer needs more memory than there is")
    def test_out_of_memory(self):
        source = self.file("c.json", CURVE)
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20))
        for words in (["eval", source, "--samples", "16000000"], ["render", source, "o.png", "--size", "30000x30000"]):
            result = subprocess.run([PROGRAM, *words], capture_output=True, preexec_fn=limit, cwd=self.folder,
                                    timeout=HANG)
            self.assertEqual((result.returncode, result.stdout), (1, b""))
            self.assertIn(b"out of memory", result.stderr)
            self.assertEqual(os.listdir(self.folder), ["c.json"])


class Lossy(ProgramTest):
    """What would be lost by writing over the input is not written without a word."""

    def test_writing_over_the_input(self):
        name = self.file("m.svg", OLD)
        (self.folder / "link.svg").symlink_to("m.svg")
        os.link(name, self.folder / "twin.svg")
        for out in (name, self.folder / "link.svg", self.folder / "twin.svg"):
            line = self.refused(1, "convert", name, out)
            self.assertRegex(line, r"^.*\.svg: writing over it would lose \d+ things; --lossy allows it\. Left out: .*1 image")
            self.assertEqual(pathlib.Path(name).read_bytes(), OLD)
        self.done("convert", "-", name, stdin=MIXED)  # what comes by a pipe is not that file

    def test_standard_input_from_the_file(self):
        name = self.file("m.svg", OLD)
        with open(name, "rb") as source:
            result = subprocess.run([PROGRAM, "convert", "-", name], stdin=source, capture_output=True, check=False)
        self.assertEqual((result.returncode, result.stderr.count(b"\n")), (1, 1))
        self.assertEqual(pathlib.Path(name).read_bytes(), OLD)

    def test_lossy(self):
        name = self.file("m.svg", OLD)
        self.done("convert", name, self.folder / "other.svg")
        self.assertEqual(self.run_program("convert", name, name, "--lossy").returncode, 0)
        self.assertIs(self.json("info", name, "--json")["keeps_all"], True)
        self.done("convert", name, name)  # nothing is left to lose

    def test_a_file_that_is_kept(self):
        name = self.file("m.svg", MIXED)
        self.assertEqual(self.run_program("convert", name, name).stderr, b"")
        self.assertEqual(open_text(name), MIXED)
        for step in ("a.batten", "b.svg", "c.batten", "d.svg"):
            self.done("convert", name, self.folder / step)
            name = self.folder / step
        self.assertEqual(open_text(name), MIXED)
        self.assertIs(self.json("info", name, "--json")["keeps_all"], True)
        self.assertRegex(self.done("info", name).decode(), r"shows +all but (1 thing|\d+ things); saving keeps them all\n +1 image\n")

    def test_a_kept_file_that_is_not_xml(self):
        self.done("convert", self.file("m.svg", MIXED), self.folder / "m.batten")
        native, chance = json.loads(open_text(self.folder / "m.batten")), random.Random(5)
        whole = native["source"]["text"]
        texts = [whole.replace("</svg>", end) for end in ("", "</g>", "</svg></svg>", "</svg>x", "&x;</svg>", "]]></svg>")]
        for _ in range(60):
            at = chance.randrange(len(whole))
            texts.append(whole[:at] + chance.choice(["", "<", ">", "&", '"', "/", "<!--", "\x01", " x", "</g>"]) +
                         whole[at + chance.randrange(3):])
        for text in texts:
            native["source"]["text"] = text
            result = self.run_program("convert", "-", "o.svg", stdin=json.dumps(native))
            self.assertEqual(result.returncode, 0, result.stderr.decode())
            xml.etree.ElementTree.parse(self.folder / "o.svg")
            try:
                xml.etree.ElementTree.fromstring(text)
                self.assertEqual(result.stderr, b"", text)
            except xml.etree.ElementTree.ParseError:
                self.assertEqual(result.stderr, b"standard input: Left out: 1 broken part.\n", text)

    def test_a_tolerance_changes_the_path_data_alone(self):
        name = self.file("m.svg", MIXED.replace('d="M0 0C10 10 20 10 30 0"', 'd="M0 0C1 0 2 0 3 0C4 0 5 0 6 0"'))
        self.done("convert", name, self.folder / "o.svg", "--tolerance", "0.1")
        text = open_text(self.folder / "o.svg")
        self.assertNotIn("3 0C4 0", text)
        for part in ('<text x="1" y="2">hello</text><text>again</text>', '<image href="x.png"', 'stroke="red" fill="none"/>'):
            self.assertIn(part, text)

    def test_never_when_nothing_is_lost(self):
        self.done("convert", self.file("c.json", CURVE), self.folder / "a.batten")
        self.file("a.svg", '<svg viewBox="0 0 9 9"><path id="p" d="M0 0L5 5" stroke="red"/></svg>')
        for name in ("a.batten", "a.svg", "a.svg"):
            self.assertEqual(self.run_program("convert", name, name).stderr, b"")
        self.done("convert", CAR, self.folder / "car.svg")
        self.done("convert", self.folder / "car.svg", self.folder / "car.svg")

    def test_a_picture_in_the_drawings_place(self):
        path = self.folder / "car.svg"
        self.done("convert", CAR, path)
        before = path.read_bytes()
        self.assertIn("--lossy", self.refused(1, "render", path, path))
        self.assertEqual(path.read_bytes(), before)
        self.done("render", path, path, "--lossy")
        self.assertNotIn(b"metadata", path.read_bytes())

    def test_precision(self):
        def numbers(*options):
            text = self.done("convert", "a.batten", "-", "--to", "svg", "--plain", *options).decode()
            return [number for path in re.findall(r' d="([^"]*)"', text) for number in re.findall(r"-?[0-9][-+.e0-9]*", path)]

        points = [[100 * math.sin(i), 7 * i + math.cos(i)] for i in range(40)]
        self.done("convert", self.file("a.json", {"degree": 3, "closed": False, "points": points, "knots":
                                                  [0] * 3 + list(range(38)) + [37] * 3}), "a.batten")
        exact = [float(number) for number in numbers("--precision", "0")]
        self.assertGreater(max(len(str(number)) for number in exact), 12)
        for options, apart, decimals in (([], 1e-3, 6), (["--precision", "0.5"], 0.5, 1), (["--precision", "2"], 2, 0)):
            rounded = numbers(*options)
            self.assertEqual(len(rounded), len(exact))
            for x, y in zip(rounded, exact):
                self.assertLessEqual(abs(float(x) - y), apart)
                self.assertLessEqual(len(x.partition(".")[2]), decimals)
        self.assertIn("--precision is for .svg, not for .dxf", self.refused(2, "convert", CAR, "b.dxf", "--precision", "1"))
        for bad in ("-1", "nan", "inf", "x"):
            self.refused(2, "convert", CAR, "b.svg", "--precision", bad)

    def test_an_edited_drawing_is_not_much_longer(self):
        self.done("sketch", f"{CAR}#roof", ROOT / "examples" / "roof.csv", "-o", "car.svg")
        self.done("convert", "car.svg", "plain.svg", "--plain")
        self.assertLess((self.folder / "plain.svg").stat().st_size, 1.3 * CAR.stat().st_size)


class Info(ProgramTest):
    def test_car(self):
        info = self.json("info", CAR, "--json")
        self.assertEqual(info["format"], "svg")
        self.assertEqual(info["page"], [0, 0, 1000, 420])
        self.assertIs(info["keeps_all"], True)
        roof = next(item for item in info["objects"] if item["name"] == "roof")
        self.assertEqual([c["degree"] for c in roof["curves"]], [3])
        self.assertEqual(info["curves"], sum(len(item["curves"]) for item in info["objects"]))
        self.assertIn("roof", self.done("info", CAR).decode())
        titled = open(CAR, encoding="utf-8").read().replace(">", "><title>A car</title>", 1)
        text = self.done("info", "-", stdin=titled.encode()).decode()
        self.assertRegex(text, r"saving +keeps everything\nobjects")
        text = self.done("info", "-", "--kept", stdin=titled.encode()).decode()
        self.assertRegex(text, r"saving +keeps everything\nkeeps +1 title or description\nobjects")

    def test_svg_saved_by_batten_keeps_everything(self):
        self.done("convert", CAR, self.folder / "car.svg")
        info = self.json("info", self.folder / "car.svg", "--json")
        self.assertIs(info["keeps_all"], True)
        self.assertIn("keeps everything", self.done("info", self.folder / "car.svg").decode())

    def test_what_is_left_out(self):
        info = self.json("info", self.file("m.svg", OLD), "--json")
        self.assertEqual((info["left_out"]["texts"], info["left_out"]["images"]), (2, 1))
        self.assertIs(info["keeps_all"], False)
        self.assertEqual(len(info["objects"]), 2)
        text = self.done("info", self.folder / "m.svg").decode()
        total = sum(info["left_out"].values())
        self.assertRegex(text, rf"saving +loses {total} things\n +2 texts\n +1 image\n")

    def test_a_plain_drawing_loses_nothing(self):
        plain = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><g fill="red"><rect id="r" width="3" height="3"/></g></svg>'
        info = self.json("info", self.file("p.svg", plain), "--json")
        self.assertIs(info["keeps_all"], True)
        self.assertEqual(sum(info["left_out"].values()), 0)

    def test_svg_that_another_program_changed(self):
        self.done("convert", self.file("c.json", CURVE), self.folder / "car.svg")
        text = open_text(self.folder / "car.svg")
        at = text.index(" d=\"M") + 5
        changed = self.file("changed.svg", text[:at] + "1" + text[at:])
        info = self.json("info", changed, "--json")
        self.assertEqual((info["edited"], info["keeps_all"]), (True, False))
        self.assertEqual(self.run_program("convert", changed, self.folder / "o.batten").stderr.count(b"\n"), 1)

    def test_names_reach_the_terminal_without_controls(self):
        name = self.file("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path id="a&#x9;b&#x7f;" d="M0 0L1 1"/></svg>')
        self.assertNotRegex(self.done("info", name).decode(), r"[\t\x7f\x1b]")

    def test_curve(self):
        info = self.json("info", self.file("c.json", dict(RING, degree=1)), "--json")
        curve = info["objects"][0]["curves"][0]
        points = RING["points"]
        length = sum(((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 for a, b in zip(points, points[1:] + points[:1]))
        self.assertAlmostEqual(curve.pop("length"), length, 9)
        self.assertEqual(curve, {"degree": 1, "dimension": 2, "closed": True, "points": 5, "knots": 6})
        self.assertIsNone(info["page"])


class Chain(ProgramTest):
    def test_fit_sketch_convert_render(self):
        stroke = self.file("s.csv", "x,y\n" + "".join(f"{x},{x * (100 - x) / 50}\n" for x in range(101)))
        other = self.file("t.csv", "x,y\n" + "".join(f"{x},{x * (100 - x) / 50 + 4}\n" for x in range(30, 71)))
        script = (f"set -e; {PROGRAM} fit {stroke} | {PROGRAM} sketch - {other} | {PROGRAM} convert - - --to svg"
                  f" | {PROGRAM} render - {self.folder}/out.png --size 200x100")
        self.assertEqual(os.system(script), 0)
        self.assertEqual((self.folder / "out.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


def open_text(name):
    with open(name) as file:
        return file.read()


if __name__ == "__main__":
    unittest.main()
