#!/usr/bin/env python3
# label: slow
"""Drawings of others stay light: with one point of one curve moved and saved, they are at most 1.15 times as heavy in the middle,
and 1.6 times where the worst tenth begins; a tiny file may have 400 bytes more, and 60 for each knot of the curve."""
import json
import pathlib
import sys
import unittest

from program import PROGRAM, ROOT, ProgramTest

sys.path.insert(0, str(ROOT / "tests" / "pictures"))
from weight import MIDDLE, TENTH, list_files, measure, sums  # noqa: E402

OURS = [ROOT / "examples", ROOT / "tests" / "pictures" / "programs", ROOT / "docs" / "pictures", ROOT / "tests" / "gestures"]
ICONS = [pathlib.Path("/usr/share/icons"), pathlib.Path("/usr/share/openclipart")]


def wavy(columns, rows):
    """A drawing of many small curves, as a map has, in one path and in as many."""
    one = [f"M{9 * i} {9 * k}c2 -3 4 3 6 0s1 2 2 3" for i in range(columns) for k in range(rows)]
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {9 * columns} {9 * rows}">'
    return (f'{head}<path fill="none" stroke="#000" d="{"".join(one)}"/></svg>',
            f'{head}<g fill="none" stroke="#000">{"".join(f"<path d={chr(34)}{data}{chr(34)}/>" for data in one)}</g></svg>')


class Weight(ProgramTest):
    def weigh(self, paths, seed):
        done = measure(PROGRAM, paths, seed)
        middle, tenth, _ = sums(done)
        heavy = "\n".join(f"{share:.2f} {more:+d} {path}" for share, more, free, path in done if share > TENTH and more > free)
        self.assertLessEqual(middle, MIDDLE, heavy)
        self.assertLessEqual(tenth, TENTH, heavy)
        return done

    def test_drawings_of_others(self):
        self.assertGreater(len(self.weigh(list_files(OURS, 24, 1), 1)), 15)

    def test_icons(self):
        paths = list_files([name for name in ICONS if name.is_dir()], 20, 3)
        if not paths:
            self.skipTest("no icons are installed")
        self.weigh(paths, 3)

    def test_one_of_many(self):
        """However much there is beside the curve that is edited, it alone weighs something."""
        for name, text in zip(("one.svg", "many.svg"), wavy(40, 40)):
            for share, more, free, _ in measure(PROGRAM, [pathlib.Path(self.file(name, text))], 1):
                self.assertLess(more, free, name)
                self.assertLess(share, 1.02, name)

    def test_all_comes_back(self):
        """What was edited is the same after opening it again, and so is what was not."""
        for path in list_files(OURS, 8, 5):
            kept = json.loads(self.done("convert", path, "-", "--to", "batten"))
            drawn = [thing for thing in kept["objects"] if thing["kind"] == "path" and not thing.get("hidden")]
            if "source" not in kept or not drawn:
                continue
            drawn[0]["curves"][0]["points"][1][0] += 1 / 3
            saved = self.file("saved.svg", self.done("convert", "-", "-", "--to", "svg", stdin=json.dumps(kept)))
            again = json.loads(self.done("convert", saved, "-", "--to", "batten"))
            self.assertEqual(again["objects"], kept["objects"], path)
            self.assertEqual(self.done("convert", saved, "-", "--to", "svg"), pathlib.Path(saved).read_bytes())


if __name__ == "__main__":
    unittest.main()
