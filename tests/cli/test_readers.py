"""Two drawings as programs read them that are not Batten, where these are installed: as large as numpy says, upright, solid. All
of tests/models/drawings.py are tried by tests/models/whole.py."""
import pathlib
import sys
import unittest

from program import PROGRAM, ROOT, ProgramTest

sys.path.insert(0, str(ROOT / "tests" / "models"))
import drawings  # noqa: E402
import whole  # noqa: E402


class Readers(ProgramTest):
    def found(self, drawing, closed, *kinds):
        for kind in kinds:
            for reader, fault in whole.check(PROGRAM, drawing, closed, kind, self.folder).items():
                with self.subTest(drawing=pathlib.Path(drawing).stem, kind=kind, reader=reader):
                    self.assertIsNone(fault)

    def test_a_box_and_a_cone(self):
        made = drawings.Maker(PROGRAM, self.folder, ROOT / "examples")
        self.found(made.drawing("box", drawings.BODY), True, "stl", "glb")
        cone = made.turned(drawings.curve([[100, 40], [140, 120], [100, 120]], 1))
        self.found(made.drawing("cone", cone, unit="in"), True, "stl", "obj", "gltf", "step")

    def test_a_fault_is_found(self):
        """The same box in a drawing whose unit is another has another size."""
        made = drawings.Maker(PROGRAM, self.folder, ROOT / "examples")
        low, high = drawings.box(PROGRAM, made.drawing("box", drawings.BODY, unit="in"), False, True)
        self.assertIsNotNone(whole.compare({"low": low / 25.4, "high": high / 25.4}, low, high, "stl", whole.USUAL))
        self.assertIsNone(whole.compare({"low": low, "high": high}, low, high, "stl", whole.USUAL))


if __name__ == "__main__":
    unittest.main()
