"""The flight through seven tori (examples/space/tori): what level 2 changed, and that level 0 did not. label: slow"""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

from program import ProgramTest

TORI = pathlib.Path(os.environ["BATTEN_ROOT"]) / "examples" / "space" / "tori"


class Tori(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.made = pathlib.Path(made.name)
        subprocess.run(["/usr/bin/python3", "-B", str(TORI), os.environ["BATTEN"], made.name, "no"], check=True)

    def camera(self, name):
        return {k: numpy.array(v) for k, v in self.json("camera", str(self.made / name), "--fps", "1000").items()}

    def test_levels_apart(self):
        before, after = (json.loads((self.made / f"{name}.json").read_text()) for name in ("before", "after"))
        self.assertEqual(before["path"]["base"], after["path"]["base"])
        for part in ("path", "orientation"):
            (_, first), (low, second) = (move[part]["levels"] for move in (before, after))
            self.assertFalse(numpy.any(low["details"]))
            self.assertFalse(numpy.any(first["details"]))
            self.assertTrue(numpy.any(second["details"]))
        silent = json.loads(json.dumps(after))
        for part in ("path", "orientation"):
            silent[part]["levels"][1]["gain"] = 0
        name = self.file("silent.json", silent)
        self.assertEqual(self.json("camera", name, "--fps", "10"), self.json("camera", str(self.made / "before.json"), "--fps", "10"))

    def test_goes_through(self):
        """Before, the path goes through few of the tori; after, it meets the middle of each and looks at that of the next."""
        drawing = json.loads((self.made / "after.batten").read_text())
        rings = [numpy.array(o["surface"]["points"]).reshape(-1, 3).mean(axis=0) for o in drawing["objects"] if o["kind"] == "surface"]
        self.assertEqual(len(rings), 7)
        before, after = self.camera("before.json"), self.camera("after.json")
        missed = lambda made: [numpy.linalg.norm(made["positions"] - c, axis=1).min() for c in rings]
        self.assertGreater(min(missed(before)), 15)
        self.assertLess(max(missed(after)), .4)  # of the samples' distance
        for here, there in zip(rings, rings[1:]):
            i = numpy.linalg.norm(after["positions"] - here, axis=1).argmin()
            x, y, z, w = after["rotations"][i]
            gaze = -numpy.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
            way = there - after["positions"][i]
            self.assertGreater(gaze @ way / numpy.linalg.norm(way), numpy.cos(numpy.radians(1)))

    def test_journal(self):
        """The session leads from the one drawing to the other, digest by digest; undone, it is the first again."""
        journal = self.made / "tori.journal"
        made = self.json("replay", str(journal), "--check")
        lines = journal.read_text().splitlines()
        opened = lambda name: self.json("replay", self.file("opened.journal", {
            "journal": "batten", "version": 1, "document": json.loads((self.made / name).read_text())}))["digest"]
        self.assertEqual(made["digest"], opened("after.batten"))
        self.assertNotEqual(made["digest"], opened("before.batten"))
        back = self.made / "back.journal"
        back.write_text("\n".join(lines[:-1] + 2 * ['{"do":"undo"}']) + "\n")
        self.assertEqual(self.json("replay", str(back), "--check")["digest"], opened("before.batten"))
        kept = TORI.parent / "tori.journal"
        self.assertEqual(self.json("replay", str(kept), "--check")["digest"], json.loads(kept.read_text().splitlines()[-1])["digest"])

    def test_pictures(self):
        for name in "abcd":
            self.assertEqual((self.made / f"camera-{name}.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
