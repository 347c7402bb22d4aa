"""Runs the program for the tests of the command line. BATTEN and BATTEN_ROOT say where it and the sources are."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

HANG = int(os.environ.get("BATTEN_HANG", 1800))  # seconds: one step of a test that takes longer hangs, however busy the machine
PROGRAM = os.environ["BATTEN"]
ONE_IN = int(os.environ.get("BATTEN_ONE_IN", 1))  # of each class one test in so many runs, where others judge the results
with open(PROGRAM, "rb") as program:
    SANITIZED = b"__asan_init" in program.read()
ROOT = pathlib.Path(os.environ["BATTEN_ROOT"])

CURVE = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2],
         "points": [[0, 0], [1, 2], [3, 3], [5, 1], [6, 0]]}
RING = {"degree": 3, "closed": True, "knots": [0, 1, 2.5, 3, 4, 5], "points": [[0, 0], [4, -1], [5, 3], [2, 5], [-1, 3]]}


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        if unittest.defaultTestLoader.getTestCaseNames(type(self)).index(self._testMethodName) % ONE_IN:
            self.skipTest("runs in other trees")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        """Writes a file: bytes, text, or anything else as JSON. Returns its path as text."""
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return str(path)

    def run_program(self, *words, stdin=b"", cwd=None):
        if isinstance(stdin, str):
            stdin = stdin.encode()
        words = [word if isinstance(word, bytes) else str(word) for word in words]
        return subprocess.run([PROGRAM, *words], input=stdin, capture_output=True, timeout=HANG, cwd=cwd or self.folder)

    def done(self, *words, stdin=b""):
        """Standard output of a run that must end with 0."""
        result = self.run_program(*words, stdin=stdin)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        return result.stdout

    def json(self, *words, stdin=b""):
        return json.loads(self.done(*words, stdin=stdin))

    def refused(self, status, *words, stdin=b""):
        """The one line of a run that must end with the status and print nothing."""
        result = self.run_program(*words, stdin=stdin)
        line = result.stderr.decode()
        self.assertEqual((result.returncode, result.stdout), (status, b""), line)
        self.assertEqual(line.count("\n"), 1, line)
        self.assertTrue(line.endswith("\n"))
        return line.strip()
