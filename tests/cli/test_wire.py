"""wire: meshes, surfaces and curves against the formulas by numpy; what stays keeps its digits; what is told and what is
refused."""
import json
import unittest

import numpy

from program import ProgramTest

LINE = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0, 0], [10, 0, 0]]}
RAISED = dict(LINE, points=[[0, 0, 2], [10, 0, 2]])
TURNED = dict(LINE, points=[[0, 0, 0], [0, 0, 10]])
RANDOM = numpy.random.default_rng(21)


def line(*points):
    return dict(LINE, points=list(points))


def strength(distance, radius):
    x = numpy.minimum(distance / radius, 1)
    return (x * x - 1) ** 2


def grid(count=9, step=0.7):
    points = [[1 + step * i, step * (j - count // 2) + 0.1, 0.3] for i in range(count) for j in range(count)]
    faces = [[i * count + j, i * count + j + 1, (i + 1) * count + j + 1, (i + 1) * count + j] for i in range(count - 1) for j in range(count - 1)]
    return {"vertices": points, "faces": faces}


class Wire(ProgramTest):
    def wire(self, target, *wires, blend=None):
        content = {"wires": list(wires)}
        if blend:
            content["blend"] = blend
        return self.json("wire", self.file("target.json", target), self.file("wires.json", content))

    def test_a_mesh_is_lifted(self):
        mesh = grid()
        result = self.wire(mesh, {"reference": LINE, "curve": RAISED, "radius": 1.5})
        before, after = numpy.array(mesh["vertices"]), numpy.array(result["vertices"])
        f = strength(numpy.hypot(before[:, 1], before[:, 2]), 1.5)
        self.assertLess(numpy.abs(after - before - f[:, None] * [0, 0, 2]).max(), 1e-12)
        self.assertEqual(result["faces"], mesh["faces"])
        for a, b, felt in zip(mesh["vertices"], result["vertices"], f):
            if felt == 0:
                self.assertEqual(a, b)
        self.assertEqual(result["report"]["points"], 81)
        self.assertEqual(result["report"]["moved"], int((f > 0).sum()))
        self.assertAlmostEqual(result["report"]["largest"], 2 * f.max(), 12)
        self.assertEqual(result["report"]["torn"], 0)

    def test_a_turn_and_a_scale(self):
        cloud = {"vertices": RANDOM.uniform([0, -2, -2], [10, 2, 2], (50, 3)).tolist(), "faces": []}
        result = self.wire(cloud, {"reference": LINE, "curve": TURNED, "radius": 2, "scale": 1.5})
        p = numpy.array(cloud["vertices"])
        f = strength(numpy.hypot(p[:, 1], p[:, 2]), 2)
        q = p * [0, 1, 1] * (1 + 0.5 * f)[:, None]
        angle = f * numpy.pi / 2  # about -y: x goes to z
        foot = p * [1, 0, 0]
        turned = numpy.stack([-q[:, 2] * numpy.sin(angle), q[:, 1], q[:, 2] * numpy.cos(angle)], 1)
        moved = foot + turned + f[:, None] * (foot[:, [1, 2, 0]] - foot)
        self.assertLess(numpy.abs(moved - result["vertices"]).max(), 1e-12)

    def test_turns_by_frames_carry_rigidly(self):
        bow = {"degree": 3, "closed": False, "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2], "points": RANDOM.uniform(-5, 5, (5, 3)).tolist()}
        axis, angle, shift = numpy.array([2, -1, 2]) / 3, 1.2, numpy.array([1, 2, 3])
        cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
        turn = numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross
        moved = dict(bow, points=(numpy.array(bow["points"]) @ turn.T + shift).tolist())
        cloud = {"vertices": RANDOM.uniform(-5, 5, (60, 3)).tolist(), "faces": []}
        want = numpy.array(cloud["vertices"]) @ turn.T + shift
        wire = {"reference": bow, "curve": moved, "radius": 1e8}  # so wide that everything counts as on the wire
        result = self.wire(cloud, dict(wire, turn="frames"))
        self.assertLess(numpy.abs(want - result["vertices"]).max(), 1e-9)
        plain = self.wire(cloud, wire)
        self.assertEqual(plain, self.wire(cloud, dict(wire, turn="tangent")))
        self.assertGreater(numpy.abs(want - plain["vertices"]).max(), 0.1)

    def test_blends(self):
        other = line([0, 1, 0], [10, 1, 0])
        up, aside = line([0, 0, 1], [10, 0, 1]), line([0, 2, 0], [10, 2, 0])
        cloud = {"vertices": [[5, y, 0] for y in (0, 0.2, 0.5, 0.8, 1, 2.9, 3.5)], "faces": []}
        y = numpy.array(cloud["vertices"])[:, 1]
        a, b = strength(abs(y), 3), strength(abs(y - 1), 3)
        moves = numpy.stack([0 * y, 0 * y, a], 1), numpy.stack([0 * y, b, 0 * y], 1)
        for blend, weight in ((None, lambda f, d: f / (1 - f)), ({"kind": "cross", "exponent": 2}, lambda f, d: (f / (1 - f)) ** 2),
                              ({"kind": "local", "exponent": 1}, lambda f, d: f), ({"kind": "magnitude"}, lambda f, d: d)):
            result = self.wire(cloud, {"reference": LINE, "curve": up, "radius": 3}, {"reference": other, "curve": aside, "radius": 3}, blend=blend)
            with numpy.errstate(divide="ignore", invalid="ignore"):
                u, v = weight(a, a), weight(b, b)
                mean = numpy.where((u + v > 0)[:, None], (u[:, None] * moves[0] + v[:, None] * moves[1]) / (u + v)[:, None], 0)
            for k in range(len(y)):
                want = mean[k]
                if a[k] == 1 and blend is None or a[k] == 1 and blend.get("kind") == "cross":
                    want = moves[0][k]
                if b[k] == 1 and blend is None or b[k] == 1 and blend.get("kind") == "cross":
                    want = moves[1][k]
                got = numpy.array(result["vertices"][k]) - cloud["vertices"][k]
                self.assertLess(numpy.abs(got - want).max(), 1e-12, (blend, k))

    def test_surfaces_and_curves(self):
        surface = {"degree": [2, 2], "closed": [False, True], "knots": [[0, 0, 0, 1, 1, 1], [0, 1, 2, 3, 4]],
                   "points": [[[5 + i, y, z] for y, z in ((1, 0), (0, 1), (-1, 0), (0, -1))] for i in range(3)]}
        result = self.wire(surface, {"reference": LINE, "curve": RAISED, "radius": 2})
        before, after = numpy.array(surface["points"]), numpy.array(result["points"])
        self.assertLess(numpy.abs(after - before - [0, 0, 2 * 0.5625]).max(), 1e-12)
        self.assertEqual([result[k] for k in ("degree", "closed", "knots")], [surface[k] for k in ("degree", "closed", "knots")])
        flat = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 2], "points": [[1, 0.5], [2, 9], [3, 8]]}
        aside = line([0, 1, 0], [10, 1, 0])
        self.assertEqual(self.wire(flat, {"reference": LINE, "curve": aside, "radius": 1})["points"], [[1, 1.0625], [2, 9], [3, 8]])
        self.assertEqual(self.wire(flat, {"reference": LINE, "curve": RAISED, "radius": 1})["points"], [[1, 0.5, 1.125], [2, 9, 0], [3, 8, 0]])

    def test_the_same_curve_changes_nothing(self):
        mesh = {"vertices": RANDOM.normal(0, 3, (200, 3)).tolist(), "faces": [[0, 1, 2]]}
        curve = {"degree": 3, "closed": True, "knots": [0, 1, 2, 3, 4, 5], "points": RANDOM.normal(0, 3, (5, 3)).tolist()}
        result = self.wire(mesh, {"reference": curve, "curve": curve, "radius": 5, "domain": LINE})
        self.assertEqual(result["vertices"], mesh["vertices"])
        self.assertEqual(result["report"]["moved"], 0)

    def test_torn_edges_are_counted(self):
        hairpin = {"degree": 1, "closed": False, "knots": [0, 0, 1, 2, 3, 3], "points": [[0, 1, 0], [20, 1, 0], [20, -1, 0], [0, -1, 0]]}
        mesh = grid(8, 0.5)  # 8 edges cross y = 0
        self.assertEqual(self.wire(mesh, {"reference": hairpin, "curve": hairpin, "radius": 3})["report"]["torn"], 8)

    def test_bad_data(self):
        mesh = self.file("m.json", grid())
        good = {"reference": LINE, "curve": RAISED, "radius": 1}
        for change, says in (({"radius": 0}, "above 0"), ({"radius": {"degree": 1, "knots": [0, 0, 1, 1], "values": [1, -1]}}, "above 0"),
                             ({"curve": dict(RAISED, knots=[0, 0, 2, 2])}, "domain of the reference"), ({"reference": None}, "object")):
            wires = self.file("w.json", {"wires": [dict(good, **change)]})
            self.assertIn(says, self.refused(1, "wire", mesh, wires))
        wires = self.file("w.json", {"wires": [good], "blend": {"kind": "cross", "exponent": 0}})
        self.assertIn("above 0", self.refused(1, "wire", mesh, wires))
        two = self.file("two.json", [LINE, LINE])
        self.assertIn("one mesh, surface or curve", self.refused(1, "wire", two, self.file("w.json", {"wires": [good]})))
        self.refused(2, "wire", "-", "-")

    def test_obj(self):
        obj = self.file("m.obj", "v 1 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n")
        result = self.json("wire", obj, self.file("w.json", {"wires": [{"reference": LINE, "curve": RAISED, "radius": 1}]}))
        self.assertEqual(result["vertices"], [[1, 0, 2], [2, 0, 2], [2, 1, 0]])


if __name__ == "__main__":
    unittest.main()
