"""replay: a journal written by hand runs, its digest is that of the document, --check finds what differs."""
import json
import math
import unittest

from program import ROOT, ProgramTest

CAR = ROOT / "examples" / "car.svg"


class Replay(ProgramTest):
    def setUp(self):
        super().setUp()
        self.document = json.loads(self.done("convert", CAR, "-", "--to", "batten"))
        roof = next(item for item in self.document["objects"] if item["name"] == "roof")
        stroke = [[x, 103 - 10 * math.sin(math.pi * (x - 540) / 120) ** 2 + (x - 590) ** 2 / 4000]
                  for x in range(540, 661, 2)]
        self.redraw = {"do": "sketch-redraw", "object": roof["id"], "curve": 0, "tolerance": 1, "pixel": 1, "pins": 3,
                       "width": 3, "keep_corners": False, "smooth_limit": 5, "view": [0, 0, 1],
                       "stroke": {"points": stroke, "pressure": [0.5]}}

    def journal(self, *lines, document=None):
        first = {"journal": "batten", "version": 1, "name": "car.svg", "document": document or self.document}
        return self.file("s.journal", "".join(json.dumps(line) + "\n" for line in (first, *lines)))

    def test_redraws_the_roof_and_nothing_else(self):
        result = self.json("replay", self.journal(self.redraw), "--check", "--output", self.folder / "out.batten")
        self.assertRegex(result["digest"], "^[0-9a-f]{16}$")
        self.assertEqual(result["objects"], len(self.document["objects"]))
        after = json.loads((self.folder / "out.batten").read_text())
        changed = [a["name"] for a, b in zip(self.document["objects"], after["objects"]) if a != b]
        self.assertEqual(changed, ["roof"])

    def test_digest_is_that_of_the_document(self):
        plain = self.json("replay", self.journal())["digest"]
        redrawn = self.json("replay", self.journal(self.redraw), "--output", self.folder / "out.batten")["digest"]
        self.assertNotEqual(redrawn, plain)
        after = json.loads((self.folder / "out.batten").read_text())
        self.assertEqual(self.json("replay", self.journal(document=after))["digest"], redrawn)
        self.assertEqual(self.json("replay", self.journal(self.redraw, {"do": "undo"}))["digest"], plain)
        self.assertEqual(self.json("replay", self.journal(self.redraw, {"do": "undo"}, {"do": "redo"}))["digest"], redrawn)
        self.assertEqual(self.done("replay", "-", stdin=open_bytes(self.journal(self.redraw))),
                         self.done("replay", self.folder / "s.journal"))

    def test_check_finds_the_first_difference(self):
        digest = self.json("replay", self.journal(self.redraw))["digest"]
        good = dict(self.redraw, digest=digest)
        self.done("replay", self.journal(good, {"do": "undo"}), "--check")
        bad = dict(self.redraw, digest=("0" if digest[0] != "0" else "1") + digest[1:])
        line = self.refused(1, "replay", self.journal(bad, {"do": "undo"}), "--check")
        self.assertRegex(line, r"s\.journal: line 2: ")
        self.done("replay", self.journal(bad))  # without --check nobody asked

    def test_bad_journals(self):
        for lines, place in (([{"do": "frobnicate"}], "line 2"), ([self.redraw, {"do": "redo"}], "line 3"),
                             ([dict(self.redraw, object=4711)], "line 2")):
            line = self.refused(1, "replay", self.journal(*lines), "--output", self.folder / "out.svg")
            self.assertIn(f"s.journal: {place}", line)
        for text in ("{", "[]", '{"journal":"batten","version":99}'):
            self.assertIn("s.journal: ", self.refused(1, "replay", self.file("s.journal", text)))
        self.assertFalse((self.folder / "out.svg").exists())


def open_bytes(name):
    with open(name, "rb") as file:
        return file.read()


if __name__ == "__main__":
    unittest.main()
