#!/usr/bin/python3
"""analyse.py against what can be counted by hand. The numbers are made up for this test; they are nobody's."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import analyse  # noqa: E402

HEAD = "date,first,sketch_seconds,sketch_error_px,points_seconds,points_error_px,device\n"


def lines(*rows):
    return [HEAD, *(f"2026-01-01,sketch,{a},{b},{c},{d},pen+pen\n" for a, b, c, d in rows)]


class Analyse(unittest.TestCase):
    def test_chance(self):
        for count in range(1, 12):  # all on one side: only the two ends of 2^n are as far
            self.assertAlmostEqual(analyse.chance([3.0] * count), 2 / 2 ** count)
        self.assertEqual(analyse.chance([1, -1]), 1)
        self.assertAlmostEqual(analyse.chance([1, 2, 3]), 2 / 8)
        self.assertAlmostEqual(analyse.chance([-1, 2, 3]), 4 / 8)  # 4 and 6, and their opposites
        self.assertLess(analyse.chance([5.0] * 40), 1e-4)  # drawn by chance, not counted out
        self.assertGreater(analyse.chance([(-1) ** i * i for i in range(1, 41)]), 0.5)

    def test_table(self):
        told = analyse.table(analyse.read(lines((10, 1, 30, 3), (20, 2, 25, 1), (40, 3, 30, 2))))
        self.assertIn("people: 3, 3 of them", told[0])
        self.assertIn("sketching 20.0 s, control points 30.0 s; difference within a person +5.0 s", told[1])
        self.assertIn("sketching 2.00 px, control points 2.00 px; difference within a person -1.00 px", told[2])
        self.assertIn("2 of 3", told[3])

    def test_what_is_refused(self):
        for bad in ([HEAD], lines(("x", 1, 2, 3)), lines((-1, 1, 2, 3)), lines(("nan", 1, 2, 3)), ["a,b\n", "1,2\n"]):
            with self.assertRaises(SystemExit, msg=bad):
                analyse.read(bad)

    def test_picture(self):
        with tempfile.TemporaryDirectory() as aside:
            results, out = pathlib.Path(aside) / "r.csv", pathlib.Path(aside) / "r.svg"
            results.write_text("".join(lines((10, 1, 30, 3), (20, 2, 25, 1))))
            with contextlib.redirect_stdout(io.StringIO()):
                analyse.main(results, out)
            self.assertEqual(out.read_text().count("<rect"), 4)


if __name__ == "__main__":
    unittest.main()
