"""Every command against what surrounds it: a reader that has gone, a full disk, a limit on the size of files, names and
data that are no UTF-8, standard streams that are closed."""
import json
import os
import resource
import signal
import subprocess
import unittest

from program import CURVE, HANG, PROGRAM, ROOT, ProgramTest

SPACE = {"degree": 2, "closed": False, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0, 0], [5, 9, 4], [10, 0, 2]]}
LARGE = dict(CURVE, points=[[100 * x, 100 * y] for x, y in CURVE["points"]])
OVER = "x,y\n" + "".join(f"{x},{x * (600 - x) / 400 + 20}\n" for x in range(100, 501, 10))
BAD = b"no\xff\xfe\x80utf8\xc3"  # the last byte is half a character


class Streams(ProgramTest):
    def setUp(self):
        super().setUp()
        curve = self.file("c.json", LARGE)
        stroke = self.file("s.csv", OVER)
        spline = self.file("t.json", {"points": [[0, 0], [3, 2], [6, 0]]})
        journal = ROOT / "tests" / "journals" / "redraw.journal"
        car = ROOT / "examples" / "car.svg"
        # What each prints on standard output.
        self.printing = {
            "eval": ["eval", curve, "--samples", 20000], "nearest": ["nearest", curve, "--point", "1,1"],
            "frames": ["frames", self.file("d.json", SPACE), "--samples", 5000], "fit": ["fit", stroke],
            "sketch": ["sketch", curve, stroke], "tangents": ["tangents", spline],
            "levels": ["levels", self.file("l.json", {"base": CURVE})], "info": ["info", car], "simplify": ["simplify", car],
            "info --json": ["info", car, "--json"], "replay": ["replay", journal],
            "convert": ["convert", car, "-", "--to", "batten"], "render svg": ["render", car, "-", "--to", "svg"],
            "render png": ["render", car, "-", "--to", "png"], "render pdf": ["render", car, "-", "--to", "pdf"],
            "--help": ["--help"], "--version": ["--version"], "eval --help": ["eval", "--help"],
            "edit": ["edit", self.folder / "new.svg", "--no-open"],
        }
        # What each writes into a file, the last word.
        self.writing = {
            "convert": ["convert", car, "out.batten"], "convert svg": ["convert", car, "out.svg"],
            "render svg": ["render", car, "out.svg"], "render png": ["render", car, "out.png"],
            "render pdf": ["render", car, "out.pdf"], "replay": ["replay", journal, "--output", "out.svg"],
        }

    def run_with(self, words, **more):
        return subprocess.run([PROGRAM, *map(str, words)], stderr=subprocess.PIPE, timeout=HANG, cwd=self.folder,
                              stdin=subprocess.DEVNULL, **more)

    def test_reader_that_has_gone_ends_it_quietly(self):
        for name, words in self.printing.items():
            with self.subTest(name=name):
                read, write = os.pipe()
                os.close(read)
                result = self.run_with(words, stdout=write)
                os.close(write)
                line = result.stderr.replace(f"{self.folder}/new.svg: not there yet; the first save makes it\n".encode(), b"")
                self.assertEqual((result.returncode, line), (-signal.SIGPIPE, b""))

    def test_reader_that_wants_one_line(self):
        script = f"{PROGRAM} eval c.json --samples 60000 2>err | head -1; echo ${{PIPESTATUS[0]}}"
        result = subprocess.run(["bash", "-c", script], capture_output=True, cwd=self.folder, timeout=HANG)
        line, status = result.stdout.decode().splitlines()
        self.assertTrue(line.startswith('{"u":['))
        self.assertEqual((status, (self.folder / "err").read_text()), (str(128 + signal.SIGPIPE), ""))

    def test_signal_that_is_blocked(self):
        read, write = os.pipe()
        os.close(read)
        block = lambda: signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGPIPE])
        result = self.run_with(self.printing["eval"], stdout=write, preexec_fn=block)
        os.close(write)
        self.assertEqual((result.returncode, result.stderr), (128 + signal.SIGPIPE, b""))

    def test_nobody_listens_to_errors(self):
        """A failure, or a remark, that nobody reads: the status is the same, and the file is written."""
        (self.folder / "text.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><text>a</text></svg>')
        for words, status in ((["eval", "nothing.json", "--samples", "3"], 1), (["eval"], 2),
                              (["convert", "text.svg", "out.svg"], 0)):
            read, write = os.pipe()
            os.close(read)
            result = subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=write, cwd=self.folder, timeout=HANG)
            os.close(write)
            self.assertEqual((result.returncode, result.stdout), (status, b""))
        self.assertTrue((self.folder / "out.svg").exists())

    def one_line(self, result, words):
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(result.stderr.count(b"\n"), 1, result.stderr)
        self.assertIn(words, result.stderr.decode())

    def test_output_that_is_full(self):
        for name, words in self.printing.items():
            if name == "edit":
                continue
            with self.subTest(name=name), open("/dev/full", "wb") as full:
                self.one_line(self.run_with(words, stdout=full), "standard output: cannot be written: No space")

    def limited(self, words, size, **more):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        return self.run_with(words, preexec_fn=limit, **more)

    def test_limit_of_file_sizes(self):
        """A message and status 1; the old file stays, or none is made; nothing lies beside it."""
        before = sorted(os.listdir(self.folder))
        for name, words in self.writing.items():
            with self.subTest(name=name):
                out = self.folder / words[-1]
                self.one_line(self.limited(words, 1000), f"{words[-1]}: cannot be written: File too large")
                self.assertEqual(sorted(os.listdir(self.folder)), before)
                out.write_text("old")
                self.one_line(self.limited(words, 1000), "File too large")
                self.assertEqual(out.read_text(), "old")
                out.unlink()

    def test_limit_of_the_size_of_standard_output(self):
        """A file that standard output leads to is left as it was."""
        for name, words in self.printing.items():
            if name in ("edit", "--help", "--version", "eval --help", "nearest", "replay"):
                continue  # too short to reach the limit
            for before in (b"", b"before\n"):
                with self.subTest(name=name, before=before):
                    (self.folder / "out").write_bytes(before)
                    with open(self.folder / "out", "ab") as out:
                        self.one_line(self.limited(words, 200, stdout=out), "standard output: cannot be written: File too")
                    self.assertEqual((self.folder / "out").read_bytes(), before)

    def test_closed_streams(self):
        """Whatever is closed: no file takes its number, and what cannot be read or written is told where it can be."""
        script = f"{PROGRAM} convert c.json out.svg <&- >&- 2>&-; echo $?; {PROGRAM} info c.json >&- 2>err; echo $?; " \
                 f"{PROGRAM} eval - --samples 3 <&- 2>>err; echo $?; {PROGRAM} convert nothing.json out.batten 2>&-; echo $?"
        result = subprocess.run(["bash", "-c", script], capture_output=True, cwd=self.folder, timeout=HANG)
        self.assertEqual(result.stdout, b"0\n1\n1\n1\n")
        self.assertTrue((self.folder / "out.svg").read_bytes().startswith(b"<?xml"))
        self.assertEqual((self.folder / "err").read_text(), "standard output: cannot be written: Bad file descriptor\n"
                         "standard input: cannot be read: Bad file descriptor\n")


class Utf8(ProgramTest):
    """What is told is valid UTF-8, whatever names and data hold."""

    COMMANDS = {"eval": ["--samples", "3"], "nearest": ["--point", "1,2"], "frames": ["--samples", "3"], "fit": [],
                "tangents": [], "levels": [], "info": [], "replay": [], "simplify": []}

    def test_names_of_files(self):
        escaped = r"no\xFF\xFE\x80utf8\xC3"
        for name, more in self.COMMANDS.items():
            self.assertIn(escaped, self.refused(1, name, BAD, *more))
        curve, shape = self.file("c.json", CURVE), self.file("l.json", {"base": CURVE})
        for words in (["sketch", BAD, curve], ["sketch", curve, BAD], ["convert", BAD, "out.svg"], ["render", BAD, "out.png"],
                      ["levels", shape, BAD], ["convert", curve, BAD + b"/out.svg"], ["render", curve, BAD + b"/o.png"],
                      ["edit", BAD + b"/out.svg", "--no-open"]):
            with self.subTest(words=words):
                self.assertIn(escaped, self.refused(1, *words))

    def test_words(self):
        curve = self.file("c.json", CURVE)
        for words in ([BAD], ["help", BAD], ["eval", curve, "--at", BAD], ["eval", curve, b"--" + BAD],
                      ["eval", curve, curve, BAD], ["convert", curve, BAD], ["convert", curve, "-", "--to", b"\xff"],
                      ["render", curve, BAD], ["render", curve, "o.png", "--size", BAD],
                      ["render", curve, "o.png", "--background", BAD], ["edit", BAD], ["edit", "a.svg", "--port", BAD],
                      ["tangents", curve, "--mode", BAD], ["frames", curve, "--samples", "3", "--kind", BAD],
                      ["eval", curve, "--at", "ü" * 5000], ["replay", curve, "--output", BAD]):
            with self.subTest(words=[word[:40] for word in words]):
                self.refused(2, *words)

    def test_data(self):
        contents = (BAD, b'{"degree":"' + BAD + b'"}', b'{"' + BAD + b'":1}', b"x,y\n" + BAD, b"<svg>" + BAD + b"</svg>",
                    b"<" + BAD + b"/>", b'<?xml version="1.0" encoding="' + BAD + b'"?><svg/>', b"\xff\xfe<\0")
        for content in contents:
            for name, more in self.COMMANDS.items():
                for ending in (".json", ".svg", ".batten"):
                    with self.subTest(content=content, name=name, ending=ending):
                        self.refused(1, name, self.file("a" + ending, content), *more)

    def test_lines_stay_lines(self):
        name = "a\nb\rc\u0085d\u2028e\u2029f\x1b[31mg\u009b31mh\x7f"
        line = self.refused(1, "info", name)
        self.assertIn("a b c d e f [31mg 31mh : cannot be read", line)

    def test_info_of_a_file_with_such_a_name(self):
        name = os.fsencode(self.folder) + b"/" + BAD + b".json"
        with open(name, "w") as file:
            json.dump(CURVE, file)
        self.assertIn(r"no\xFF\xFE\x80utf8\xC3.json", self.done("info", name).decode())
        self.assertIn("utf8", json.loads(self.done("info", name, "--json").decode())["file"])


if __name__ == "__main__":
    unittest.main()
