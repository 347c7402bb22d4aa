"""Exit status 2 and one line for wrong usage; help with an example for every command."""
import json
import os
import re
import subprocess
import time
import unittest

from program import CURVE, PROGRAM, ProgramTest

COMMANDS = ["edit", "eval", "nearest", "frames", "fit", "sketch", "tangents", "levels", "convert", "render", "simplify", "width", "blend", "match", "info", "replay",
            "surface eval", "surface isocurve", "surface closest", "surface hit", "surface pick", "surface redraw", "surface sketch", "surface intersect", "surface blend", "surface match", "surface levels", "surface convert", "cast", "wire", "sweep", "revolve",
            "coons", "loft", "motion", "curve length", "curve bounds", "curve curvature", "curve split", "curve join", "curve reverse", "curve elevate", "curve insert", "curve flatten", "curve offset", "curve arcs", "curve intersect", "curve distance", "curve region", "curve outline", "compare", "completion"]


class Usage(ProgramTest):
    def test_help_of_every_command_has_usage_and_example(self):
        overview = self.done("--help").decode()
        for name in COMMANDS:
            self.assertRegex(overview, rf"(?m)^  {name} +\S")
            text = self.done(*name.split(), "--help").decode()
            self.assertTrue(text.startswith(f"Usage: batten {name} "), text)
            self.assertRegex(text, rf"(?m)^Example:\n  batten {name} ")
            self.assertEqual(text, self.done("help", *name.split()).decode())
            usage = text.splitlines()[0]
            for option in re.findall(r"--[a-z]+", usage):  # what the usage names, the list explains
                self.assertRegex(text, rf"(?m)^  {option}\b")
            self.assertLess(max(map(len, text.splitlines())), 121)

    def test_version(self):
        self.assertRegex(self.done("--version").decode(), r"^batten \d+\.\d+\.\d+\n$")

    def test_wrong_usage_is_2_and_one_line(self):
        curve = self.file("c.json", CURVE)
        for words in (
            [], ["frobnicate"], ["frames", curve], ["tangents"], ["levels"],
            ["eval"], ["eval", curve], ["eval", curve, "--at", "1", "--samples", "3"], ["eval", curve, "--at"],
            ["eval", curve, "--at", ""], ["eval", curve, "--at", "1,,2"], ["eval", curve, "--at", "1,x"],
            ["eval", curve, "--at", "nan"], ["eval", curve, "--at", "inf"], ["eval", curve, "--at", "1e999"],
            ["eval", curve, "--samples", "0"], ["eval", curve, "--samples", "-3"], ["eval", curve, "--samples", "2.5"],
            ["eval", curve, "--samples", "3", "--samples", "4"], ["eval", curve, "--samples", "3", "--derivatives", "-1"],
            ["eval", curve, "--samples", "3", "--frob"], ["eval", curve, curve, "--samples", "3"],
            ["eval", "", "--samples", "3"],
            ["nearest", curve], ["nearest", curve, "--point", "1"], ["nearest", curve, "--point", "1,2,3,4"],
            ["nearest", curve, "--point", "1,b"],
            ["fit"], ["fit", curve, "--tolerance", "0"], ["fit", curve, "--tolerance", "-1"], ["fit", curve, "--closed=1"],
            ["fit", "--pen", curve, "--pixel", "zero"], ["fit", "--pen", curve, "--tolerance", "1e-4"],
            ["sketch", curve, curve, "--tolerance", "1", "--pixel", "1e5"],
            ["sketch", curve], ["sketch", "-", "-"], ["sketch", curve, curve, "--pins", "4"],
            ["sketch", curve, curve, "--pins", "2.5"],
            ["convert", curve], ["convert", curve, "out.doc"], ["convert", curve, "-"], ["convert", curve, "out"],
            ["convert", curve, "x.svg", "--to", "png"],
            ["convert", curve, "x.batten", "--plain"], ["convert", curve, "x.svg", "--to", "json", "--plain"],
            ["render", curve, "out.gif"], ["render", curve, "-"], ["render", curve, "o.png", "--size", "10"],
            ["render", curve, "o.png", "--size", "0x10"], ["render", curve, "o.png", "--size", "10x10x"],
            ["render", curve, "o.png", "--size", "99999x10"], ["render", curve, "o.png", "--background", "redd"],
            ["blend", curve], ["blend", curve, curve, "--continuity", "G4"], ["blend", "-", "-"], ["blend", curve, curve, "--tension", "1"],
            ["match", curve], ["match", curve, curve, "--from", "middle"], ["match", curve, curve, "--tension", "0"],
            ["width"], ["width", curve], ["width", curve, "--widths", "1,1;0,1"],
            ["simplify"], ["simplify", curve, "--tolerance", "-1"], ["simplify", curve, "--tolerance", "nan"],
            ["simplify", curve, "--continuity", "C1"], ["simplify", curve, "--continuity"],
            ["simplify", curve, curve], ["info"], ["info", curve, "--xml"], ["replay"], ["replay", curve, "--output", "x.doc"],
            ["completion"], ["completion", "csh"], ["curve", "length", "--lines", curve], ["eval", "--lines", "-o", curve],
            ["curve", "reverse", "--lines", "-o", curve], ["curve", "reverse", curve, "-o"], ["tangents", "--lines"],
            ["curve"], ["curve", "frobnicate"], ["curve", "length"], ["curve", "curvature", curve], ["curve", "split", curve],
            ["curve", "split", curve, "--at", "1,2"], ["curve", "join", curve], ["curve", "join", curve, curve, "--continuity", "G1"],
            ["curve", "elevate", curve], ["curve", "elevate", curve, "--degree", "8"], ["curve", "insert", curve],
            ["curve", "flatten", curve], ["curve", "flatten", curve, "--tolerance", "0"], ["curve", "arcs", curve],
            ["curve", "intersect"], ["curve", "intersect", curve, curve, "--tolerance", "-1"], ["curve", "distance", curve],
            ["curve", "distance", "-", "-"],
            ["surface"], ["surface", "frobnicate"], ["surface", "eval"], ["surface", "eval", curve],
            ["surface", "eval", curve, "--samples", "3"], ["surface", "eval", curve, "--samples", "3x0"],
            ["surface", "eval", curve, "--samples", "9999x9999"], ["surface", "eval", curve, "--at", "1"],
            ["surface", "eval", curve, "--at", "1,2;"], ["surface", "eval", curve, "--at", "1,2,3"],
            ["surface", "eval", curve, "--at", "1,2;3"], ["surface", "eval", curve, "--at", "1;2"],
            ["surface", "eval", curve, "--at", "1,2", "--samples", "2x2"],
            ["surface", "eval", curve, "--samples", "2x2", "--derivatives", "3"],
            ["surface", "isocurve", curve], ["surface", "isocurve", curve, "--u", "1", "--v", "2"],
            ["surface", "isocurve", curve, "--u", "x"],
            ["surface", "closest", curve], ["surface", "closest", curve, "--point", "1,2"],
            ["surface", "hit", curve], ["surface", "hit", curve, "--ray", "0,0,0,0,0,0"],
            ["surface", "hit", curve, "--ray", "0,0,0,1,1"],
            ["surface", "redraw", curve, "--u", "1"], ["surface", "redraw", curve, curve],
            ["surface", "redraw", "-", "-", "--u", "1"], ["surface", "redraw", curve, curve, "--u", "1", "--hold", "1.5"],
            ["surface", "redraw", curve, curve, "--u", "1", "--hold", "-1"],
            ["surface", "redraw", curve, curve, "--u", "1", "--reach", "0"],
            ["cast", curve, curve], ["cast", "-", curve, "-"], ["cast", curve, curve, curve, curve],
            ["edit"], ["edit", "nothing.bvh"], ["edit", "-"], ["edit", "x.svg", "--port", "70000"], ["edit", "x.svg", "--port", "a"],
        ):
            with self.subTest(words=words):
                self.assertRegex(self.refused(2, *words), r"^batten( [a-z]+){0,2}: .*\(see: batten.* --help\)$")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["c.json"])  # nothing written

    def test_option_forms(self):
        curve = self.file("c.json", CURVE)
        expected = self.done("eval", curve, "--at", "-0,1e0,2")
        self.assertEqual(self.done("eval", "--at=-0,1e0,2", curve), expected)
        self.assertEqual(self.done("eval", "--at=-0,1e0,2", "--", curve), expected)
        odd = self.file("--help", CURVE)  # a file may be called anything
        self.assertEqual(self.run_program("eval", "--at=-0,1e0,2", "--", "--help").stdout, expected, odd)

    def test_long_work_shows_on_a_terminal_and_only_there(self):
        curve = json.dumps(CURVE).encode()
        for terminal in (True, False):
            try:
                keep, give = os.openpty() if terminal else os.pipe()
            except OSError:  # a bare chroot without /dev/pts: there is no terminal to show it on
                self.assertFalse(os.path.exists("/dev/pts/ptmx"))
                continue
            with subprocess.Popen([PROGRAM, "eval", "-", "--samples", "3"], stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, stderr=give) as process:
                shown = ""
                while terminal and not shown.endswith(" s"):  # it waits for its input
                    shown += os.read(keep, 4096).decode()
                time.sleep(0 if terminal else 1.3)  # that nothing comes takes time to see
                output = process.communicate(curve)[0]
            os.write(give, b"|")
            while "|" not in shown:
                shown += os.read(keep, 4096).decode()
            os.close(give)
            os.close(keep)
            self.assertEqual((process.returncode, json.loads(output)["u"]), (0, [0, 1, 2]))
            self.assertRegex(shown, r"^(\rbatten eval: \d+ s)+\r\x1b\[K\|$" if terminal else r"^\|$")


if __name__ == "__main__":
    unittest.main()
