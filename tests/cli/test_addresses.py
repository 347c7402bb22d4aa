"""Curves inside drawings (FILE#NAME/N, -o), many inputs in one run (--lines), and completions of the shells."""
import json
import pathlib
import re
import shutil
import subprocess
import unittest

from program import CURVE, PROGRAM, ROOT, ProgramTest
from test_usage import COMMANDS

OUTLINE = re.compile(r'd="([^"]*)"')
DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:x="urn:x" viewBox="0 0 100 100">
  <!-- kept -->
  <path id="roof" class="a" x:y="1" d="M0 0C10 20 20 20 30 0" stroke="red" fill="none"/>
  <path id="twin" d="M0 50H10"/><path id="twin" d="M0 60H10"/>
  <path id="two" d="M0 80H10M20 80H40" stroke="#00f" fill="none"/>
  <text x="3" y="4">words</text>
</svg>
"""


class Addresses(ProgramTest):
    def setUp(self):
        super().setUp()
        self.drawing = self.file("d#1.svg", DRAWING)  # a name that has a hash itself

    def test_names_ids_and_numbers(self):
        self.assertEqual(self.json("curve", "length", f"{self.drawing}#two/1")["length"], 20)
        self.assertEqual(self.json("curve", "length", f"{self.drawing}#two")["length"], 10)
        objects = json.loads(self.done("info", self.drawing, "--json"))["objects"]
        ids = {o["id"]: o["name"] for o in objects}
        two = next(i for i, name in ids.items() if name == "two")
        self.assertEqual(self.json("curve", "length", f"{self.drawing}#{two}/1")["length"], 20)
        twins = [str(i) for i, name in ids.items() if name == "twin"]
        line = self.refused(1, "curve", "length", f"{self.drawing}#twin")
        self.assertTrue(all(i in line for i in twins), line)
        self.assertIn("found none", self.refused(1, "curve", "length", f"{self.drawing}#nothing"))
        self.assertIn("2 curves", self.refused(1, "curve", "length", f"{self.drawing}#two/2"))
        self.refused(1, "curve", "length", "missing.svg#roof")

    def test_a_join_takes_the_place_of_the_first(self):
        second = '<path id="b" d="M10 0h5L20 5" stroke="red" fill="none"/>'
        drawing = self.file("two.svg", '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 30">'
                                       f'<path id="a" d="M1 1L10 0" stroke="red" fill="none"/>{second}</svg>')
        self.done("curve", "join", f"{drawing}#a", f"{drawing}#b", "-o", "joined.svg")
        text = pathlib.Path(f"{self.folder}/joined.svg").read_text()
        self.assertIn(second, text)  # everything else stays
        self.assertEqual(text.count("<path"), 2)
        ends = self.json("curve", "bounds", f"{self.folder}/joined.svg#a")
        self.assertEqual((ends["low"], ends["high"]), ([1, 0], [20, 5]))

    def test_a_result_goes_back_to_its_place(self):
        before = self.json("eval", f"{self.drawing}#roof", "--samples", "9")["points"]
        self.assertEqual(self.done("curve", "reverse", f"{self.drawing}#roof", "-o", "out.svg"), b"")
        self.assertEqual(pathlib.Path(self.drawing).read_text(encoding="utf-8"), DRAWING)
        made = pathlib.Path(f"{self.folder}/out.svg").read_text(encoding="utf-8")
        for kept in ("<!-- kept -->", 'id="roof"', 'class="a"', 'x:y="1"', "words", 'd="M0 80H10M20 80H40"'):
            self.assertIn(kept, made)
        after = self.json("eval", f"{self.folder}/out.svg#roof", "--samples", "9")["points"]
        for x, y in zip(before, reversed(after)):
            self.assertLess(abs(x[0] - y[0]) + abs(x[1] - y[1]), 1e-9)
        self.done("curve", "insert", f"{self.drawing}#roof", "--at", "0.5", "-o", self.drawing)  # over the input
        self.assertIn("words", pathlib.Path(self.drawing).read_text(encoding="utf-8"))
        stroke = self.file("s.csv", "x,y\n" + "".join(f"{x},{15 - abs(x - 15) * .2}\n" for x in range(6, 25)))
        result = self.run_program("sketch", f"{self.drawing}#roof", stroke, "-o", "n.batten")
        self.assertEqual((result.returncode, result.stdout), (0, b""))
        self.assertIn(b'{"report":{', result.stderr)
        curve = self.json("eval", f"{self.folder}/n.batten#roof", "--samples", "101")["points"]
        self.assertLess(min(abs(x - 15) + abs(y - 15) for x, y in curve), 0.6)
        plain = self.file("c.json", CURVE)
        self.assertIn("FILE#NAME", self.refused(1, "curve", "reverse", plain, "-o", "x.svg"))

    def test_over_the_input_nothing_is_lost_unasked(self):
        """A file that is not kept as it is: what cannot be written back stays, and the message says what it is."""
        latin = DRAWING.replace("words", "caf\u00e9").encode("latin-1")
        dxf = "\n".join("0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 11 5 21 5 0 TEXT 8 0 10 1 20 1 40 2 1 hello 0 ENDSEC 0 EOF".split())
        for name, data, curve in (("l.svg", b'<?xml version="1.0" encoding="ISO-8859-1"?>' + latin, "roof"), ("t.dxf", dxf.encode(), "1")):
            path = pathlib.Path(self.file(name, data))
            for words in (["curve", "reverse", f"{path}#{curve}"], ["simplify", f"{path}#{curve}"], ["simplify", path]):
                result = self.run_program(*words, "-o", path)
                if words[1] == "reverse" or result.returncode:  # nothing to simplify: nothing is written
                    self.assertEqual((result.returncode, result.stdout), (1, b""))
                    self.assertIn(b"1 text", result.stderr)
                self.assertEqual(path.read_bytes(), data)
            self.done("curve", "reverse", f"{path}#{curve}", "-o", self.folder / f"other-{name}")
            self.done("curve", "reverse", f"{path}#{curve}", "-o", path, "--lossy")
            self.assertNotEqual(path.read_bytes(), data)

    def test_a_kept_file_is_not_written_anew_unasked(self):
        """An edit that the file cannot say: what lies flat by a transform is to leave its line."""
        data = DRAWING.replace("<path", '<g transform="matrix(1 0 0 0 0 60)"><path id="flat" d="M60 0C140 20 220 100 320 60"/></g><path', 1).encode()
        path = pathlib.Path(self.file("flat.svg", data))
        stroke = self.file("bow.csv", "x,y\n100,62\n150,70\n200,80\n250,70\n300,61\n")
        for words in ((f"{path}#flat", stroke), (f"{path}#flat", stroke, "-o", path)):
            result = self.run_program("sketch", *words)
            self.assertEqual(result.returncode, int("-o" in words), result.stderr)
        self.assertIn(b"--lossy", result.stderr)
        self.assertEqual(path.read_bytes(), data)
        result = self.run_program("sketch", f"{path}#flat", stroke, "-o", self.folder / "other.svg")
        self.assertEqual((result.returncode, result.stderr.count(b"written anew")), (0, 1))
        self.assertEqual(self.run_program("sketch", f"{path}#flat", stroke, "-o", path, "--lossy").returncode, 0)
        self.assertNotEqual(path.read_bytes(), data)

    def test_simplify_writes_a_drawing_to_a_file(self):
        self.done("curve", "insert", f"{self.drawing}#roof", "--at", "0.2,0.4,0.6,0.8", "-o", "many.svg")
        result = self.run_program("simplify", "many.svg", "-o", "few.svg", "--tolerance", "1e-6")
        self.assertEqual((result.returncode, result.stdout), (0, b""))
        self.assertIn(b'"points_after"', result.stderr)
        for name, count in (("many.svg", 8), ("few.svg", 4)):
            objects = json.loads(self.done("info", name, "--json"))["objects"]
            self.assertEqual(objects[0]["curves"][0]["points"], count)
        self.assertIn("words", (self.folder / "few.svg").read_text(encoding="utf-8"))
        self.done("simplify", "few.svg", "-o", "few.dxf")
        self.assertTrue((self.folder / "few.dxf").read_text(encoding="utf-8").lstrip().startswith("0\nSECTION"))

    def test_simplify_takes_one_curve_of_a_drawing(self):
        many = self.json("curve", "insert", f"{self.drawing}#roof", "--at", "0.2,0.4,0.6,0.8")
        self.done("curve", "insert", f"{self.drawing}#roof", "--at", "0.2,0.4,0.6,0.8", "-o", "many.batten")
        few = self.json("simplify", f"{self.folder}/many.batten#roof", "--tolerance", "1e-6")
        self.assertEqual(len(many["points"]), 8)
        self.assertEqual(few["report"], {"max_error": few["report"]["max_error"], "points_before": 8, "points_after": 4})


class Lines(ProgramTest):
    def test_a_line_in_a_line_out(self):
        curves = [dict(CURVE, points=[[x * s, y * s] for x, y in CURVE["points"]]) for s in (1, 2, 3)]
        text = "\n".join(map(json.dumps, curves[:2])) + "\n{]\n\n" + json.dumps(curves[2])
        result = self.run_program("curve", "length", "--lines", stdin=text)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        lines = [json.loads(line) for line in result.stdout.decode().splitlines()]
        one = self.json("curve", "length", "-", stdin=json.dumps(CURVE))["length"]
        self.assertEqual(len(lines), 5)
        for i, scale in ((0, 1), (1, 2), (4, 3)):
            self.assertAlmostEqual(lines[i]["length"], one * scale, 9)
        self.assertEqual([list(lines[2]), list(lines[3])], [["error"], ["error"]])

    def test_results_of_several_lines_are_joined(self):
        made = self.done("curve", "offset", "--lines", "--distance", "0.25", stdin=(json.dumps(CURVE) + "\n") * 2)
        one, two = map(json.loads, made.decode().splitlines())
        self.assertEqual(one, two)
        self.assertEqual(one, self.json("curve", "offset", "-", "--distance", "0.25", stdin=json.dumps(CURVE)))

    def test_every_command_of_one_curve_stroke_or_points(self):
        """As the first operand alone: the same results, line by line, as one by one; and a bad line is told in its place."""
        stroke = {"points": [[0, 0], [10, 1], [20, 4], [30, 9]]}
        commands = {"eval": "--samples 2", "nearest": "--point 1,1", "frames": "--samples 2", "fit": "", "fit --pen": "", "simplify": "",
                    "levels": "--decompose 1", "curve length": "", "curve bounds": "", "curve curvature": "--samples 2",
                    "curve split": "--at .5", "curve reverse": "", "curve elevate": "--degree 4", "curve insert": "--at .5",
                    "curve flatten": "--tolerance .1", "curve offset": "--distance .1", "curve arcs": "--tolerance .1", "curve intersect": ""}
        for name, words in commands.items():
            text = json.dumps(stroke if name.startswith("fit") else CURVE)
            expected = self.json(*name.split(), "-", *words.split(), stdin=text)
            result = self.run_program(*name.split(), *words.split(), "--lines", stdin=f"{text}\nbad\n{text}\n")
            self.assertEqual((result.returncode, result.stderr), (1, b""), name)
            first, bad, last = map(json.loads, result.stdout.decode().splitlines())
            self.assertEqual((first, last), (expected, expected), name)
            self.assertEqual(list(bad), ["error"], name)

    def test_nothing_and_wrong_usage(self):
        self.assertEqual(self.done("eval", "--lines", "--samples", "3", stdin=""), b"")
        self.refused(2, "curve", "elevate", "--lines", "--degree", "99", stdin=json.dumps(CURVE))
        self.assertEqual(self.done("curve", "length", "--lines", "-", stdin="").decode(), "")


class Completions(ProgramTest):
    def complete(self, *words):
        script = self.file("c.bash", self.done("completion", "bash").decode())
        run = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _batten; printf "%s\\n" "${COMPREPLY[@]}"'
        result = subprocess.run(["bash", "-c", run, script, "batten", *words], capture_output=True, check=True, timeout=60)
        self.assertEqual(result.stderr, b"")
        return set(result.stdout.decode().split())

    def test_bash_proposes_what_the_program_takes(self):
        self.assertEqual(self.complete(""), {name.split()[0] for name in COMMANDS} | {"camera", "--help", "--version"})
        seconds = {name.split()[1] for name in COMMANDS if name.startswith("curve ")}
        self.assertEqual(self.complete("curve", ""), seconds)
        for name in COMMANDS:
            text = self.done(*name.split(), "--help").decode()
            options = set(re.findall(r"(?m)^  (--?[a-z-]+)", text.split("Example:")[0]))
            self.assertEqual(self.complete(*name.split(), "-"), options | {"--help"}, name)
        self.assertEqual(self.complete("curve", "join", "a", "b", "--continuity", ""), {"C0", "C1", "C2"})
        self.assertEqual(self.complete("sketch", "car.svg"), set())
        self.assertEqual(self.complete("completion", ""), {"bash", "zsh", "fish"})
        self.assertEqual(self.complete("motion", "--out", ""), set())  # a file

    def words_of_help(self):
        """Options whose words the help names: each is proposed, and is one that the command takes."""
        return {("frames", "--kind"): "rmf frenet fixed", ("tangents", "--mode"): "round faithful paper even",
                ("tangents", "--default"): "centripetal uniform chordal", ("render", "--to"): "svg png pdf eps",
                ("render", "--look"): "shaded zebra curvature mean lines", ("sketch", "--pins"): "2 3",
                ("curve", "region", "--operation"): "union difference intersection exclusion"}

    def test_words_that_are_proposed_are_taken(self):
        for words, expected in self.words_of_help().items():
            self.assertEqual(self.complete(*words, ""), set(expected.split()))
            for word in expected.split():
                operands = ["missing.json"] * (1 if words[0] in ("frames", "tangents") else 2)
                if words[0] == "render":
                    operands[1] = "out.png"
                more = ["--samples", "2"] if words[0] == "frames" else []
                self.refused(1, *words[:-1], *operands, *more, words[-1], word)  # bad data, not wrong usage

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish_proposes_the_same(self):
        script = self.file("b.fish", self.done("completion", "fish").decode())
        def propose(line):
            result = subprocess.run(["fish", "--no-config", "-c", f"source {script}; complete -C '{line}'"], capture_output=True, check=True,
                                    timeout=60, cwd=self.folder)
            self.assertEqual(result.stderr, b"", line)
            return {row.split("\t")[0] for row in result.stdout.decode().splitlines()}
        self.assertLess({"curve", "surface", "fit", "completion"}, propose("batten "))
        self.assertEqual(propose("batten completion "), {"bash", "zsh", "fish"})
        self.assertEqual(propose("batten motion --out "), {"b.fish"} | {p.name for p in self.folder.iterdir()})
        self.assertEqual(propose("batten curve "), {name.split()[1] for name in COMMANDS if name.startswith("curve ")})
        for words, expected in self.words_of_help().items():
            self.assertEqual(propose(" ".join(("batten", *words, ""))), set(expected.split()), words)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_proposes_the_same(self):
        """Without its line editor: what compadd and _arguments would be given."""
        script = self.file("_batten", self.done("completion", "zsh").decode())
        run = ("compdef() :; compadd() print -rl -- $@; _arguments() print -rl -- $@; source $1; shift; words=($@ ''); CURRENT=$#words; _batten")
        for line, expected in (("batten", "curve surface fit"), ("batten curve", "flatten offset arcs"), ("batten completion", "*:word:(bash|zsh|fish)"),
                               ("batten curve region", "union|difference|intersection|exclusion)"), ("batten frames", "rmf|frenet|fixed)"),
                               ("batten motion", "*:file:_files"), ("batten sketch", "-o[ --lossy[ :value:(2|3)")):
            result = subprocess.run(["zsh", "-f", "-c", run, "zsh", script, *line.split()], capture_output=True, timeout=60, cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, b""), line)
            for word in expected.split():
                self.assertIn(word.replace("|", " "), result.stdout.decode(), line)

    def test_zsh_and_fish_have_every_command(self):
        for shell in ("zsh", "fish"):
            text = self.done("completion", shell).decode()
            for name in COMMANDS:
                self.assertIn(name.split()[-1], text)
            if shutil.which(shell):
                script = self.file(shell, text)
                subprocess.run([shell, "-n", script], check=True, timeout=60)


if __name__ == "__main__":
    unittest.main()
