"""batten motion: walks made by a formula, with 31 joints and noise as of markers; read, fitted, scaled, bent. Places of joints
come from a forward kinematics of this file's own, in numpy."""
import json
import subprocess
import unittest

import numpy
from scipy.interpolate import BSpline

from program import ProgramTest

RANDOM = numpy.random.default_rng(7)
AXES = "XYZ"


def chain(name, parent, *offsets):
    """Bones one after the other."""
    made = []
    for i, offset in enumerate(offsets):
        made.append([f"{name}{i}", parent if i == 0 else f"{name}{i - 1}", offset])
    return made


# 31 joints: hips, a spine with neck and head, two arms with fingers, two legs.
BONES = [["Hips", None, [0, 0, 0]]] + chain("Spine", "Hips", [0, 9, 0], [0, 11, .5], [0, 12, 0], [0, 10, 0]) + chain(
    "Head", "Spine3", [0, 9, 1], [0, 8, 1])
for side, x in (("Left", 1), ("Right", -1)):
    BONES += chain(side + "Arm", "Spine3", [5 * x, 6, 0], [12 * x, 0, 0], [27 * x, 0, 0], [25 * x, 0, 0])
    BONES += chain(side + "Thumb", side + "Arm3", [3 * x, -2, 3], [3 * x, 0, 1])
    BONES += chain(side + "Finger", side + "Arm3", [9 * x, 0, 0], [4 * x, 0, 0])
    BONES += chain(side + "Leg", "Hips", [9 * x, -4, 0], [0, -42, 0], [0, -40, 0], [0, -3, 13])
assert len(BONES) == 31


def walk(frames=120, order="ZXY", noise=.1, swing=30.0, positions="XYZ", seed=1, first="position", bob=1.0):
    """A walk along z at 1.2 steps a second: joints swing by two harmonics; noise in degrees. A BVH as text, and its values."""
    random = numpy.random.default_rng(seed)
    step = 2 * numpy.pi * 1.2 * numpy.arange(frames) / 120
    lines, depth, columns = ["HIERARCHY"], 0, []
    children = {}
    for name, parent, _ in BONES:
        children.setdefault(parent, []).append(name)
    offsets = {name: offset for name, _, offset in BONES}

    def put(name, depth):
        root = name == "Hips"
        lines.append("\t" * depth + ("ROOT " if root else "JOINT ") + name)
        lines.append("\t" * depth + "{")
        lines.append("\t" * (depth + 1) + "OFFSET %r %r %r" % tuple(map(float, offsets[name])))
        turns = [axis + "rotation" for axis in order]
        places = [axis + "position" for axis in positions] if root else []
        channels = places + turns if first == "position" else turns + places
        lines.append("\t" * (depth + 1) + f"CHANNELS {len(channels)} " + " ".join(channels))
        if root:
            way = {"Z": 110 * step / (2 * numpy.pi), "Y": 92 + 2.5 * bob * numpy.cos(2 * step), "X": 3 * bob * numpy.sin(step)}
            place = [way[axis] + random.normal(0, noise / 5, frames) for axis in positions]
        else:
            place = []
        still = "Finger" in name or "Thumb" in name
        phase, size = random.uniform(0, 2 * numpy.pi), swing * random.uniform(.2, 1) * (.1 if still else 1)
        turn = []
        for axis in order:
            own = size * (1 if axis == "X" else .3)
            angle = own * numpy.sin(step + phase) + .25 * own * numpy.sin(2 * step + 2 * phase) + random.uniform(-15, 15)
            turn.append(angle + random.normal(0, noise, frames))
        columns.extend(place + turn if first == "position" else turn + place)
        for child in children.get(name, []):
            put(child, depth + 1)
        if name not in children:
            lines.extend("\t" * (depth + 1) + line for line in ("End Site", "{", "\tOFFSET 0.0 2.0 0.0", "}"))
        lines.append("\t" * depth + "}")

    put("Hips", 0)
    values = numpy.round(numpy.array(columns).T, 6)
    lines += ["MOTION", f"Frames: {frames}", "Frame Time: 0.0083333"]
    lines += [" ".join(map(repr, row.tolist())) for row in values]
    return "\n".join(lines) + "\n"


class Bvh:
    """Reads BVH on its own: joints as (name, parent, offset, channels), values of all frames."""

    def __init__(self, text):
        head, motion = text.split("MOTION")
        words, self.joints, open_ = head.split(), [], []
        at = 1
        while at < len(words):
            if words[at] in ("ROOT", "JOINT", "End"):
                end = words[at] == "End"
                assert words[at + 2:at + 4] == ["{", "OFFSET"]
                offset = numpy.array(words[at + 4:at + 7], float)
                channels = [] if end else words[at + 9:at + 9 + int(words[at + 8])]
                self.joints.append((words[at + 1], open_[-1] if open_ else -1, offset, channels, end))
                open_.append(len(self.joints) - 1)
                at += 7 if end else 9 + len(channels)
            else:
                assert words[at] == "}"
                open_.pop()
                at += 1
        lines = motion.split("\n")
        self.frames, self.time = int(lines[1].split()[1]), float(lines[2].split()[2])
        self.text = lines[3:]
        self.values = numpy.array(" ".join(lines[3:]).split(), float).reshape(self.frames, -1)

    def local(self):
        """For each joint the places in its parent (frames, 3) and the rotations (frames, 3, 3)."""
        at = 0
        for _, _, offset, channels, _ in self.joints:
            place, turn = numpy.tile(offset, (self.frames, 1)), numpy.tile(numpy.eye(3), (self.frames, 1, 1))
            for channel in channels:
                axis, value = AXES.index(channel[0]), self.values[:, at]
                if channel[1:] == "position":
                    place[:, axis] = value
                else:
                    c, s = numpy.cos(numpy.radians(value)), numpy.sin(numpy.radians(value))
                    one = numpy.tile(numpy.eye(3), (self.frames, 1, 1))
                    i, j = (axis + 1) % 3, (axis + 2) % 3
                    one[:, i, i] = one[:, j, j] = c
                    one[:, j, i], one[:, i, j] = s, -s
                    turn = turn @ one
                at += 1
            yield place, turn

    def positions(self):
        """(frames, joints, 3)."""
        turns, places = [], []
        for (_, parent, _, _, _), (place, turn) in zip(self.joints, self.local()):
            if parent >= 0:
                place = places[parent] + numpy.einsum("fij,fj->fi", turns[parent], place)
                turn = turns[parent] @ turn
            turns.append(turn)
            places.append(place)
        return numpy.stack(places, 1)

    def lengths(self):
        places = self.positions()
        return numpy.stack([numpy.linalg.norm(places[:, i] - places[:, joint[1]], axis=1)
                            for i, joint in enumerate(self.joints) if joint[1] >= 0])


def apart(a, b):
    """Degrees between the rotations of all joints in all frames."""
    worst = 0
    for (_, p), (_, q) in zip(a.local(), b.local()):
        sine = numpy.linalg.norm(p - q, axis=(1, 2)) / numpy.sqrt(8)
        worst = max(worst, numpy.degrees(2 * numpy.arcsin(numpy.minimum(sine, 1))).max())
    return worst


def line(*points):
    n = len(points)
    return {"degree": 3, "closed": False, "knots": [0] * 4 + list(range(1, n - 3)) + [n - 3] * 4, "points": [list(p) for p in points]}


class Motion(ProgramTest):
    def made(self, text, *words, out="out.bvh"):
        self.done("motion", self.file("in.bvh", text), *words, "--out", out)
        data = (self.folder / out).read_text()
        return json.loads(data) if out.endswith("json") else Bvh(data)

    def test_frames_are_kept(self):
        for order, places, first in (("ZXY", "XYZ", "position"), ("XYZ", "ZXY", "rotation"), ("YXZ", "Y", "position"), ("ZYX", "", "rotation"),
                                     ("XZY", "XYZ", "position"), ("YZX", "ZY", "rotation")):
            text = walk(20, order, positions=places, first=first)
            before = Bvh(text)
            for words in ((), ("--gain", "1=1,2=1,3=1")):
                after = self.made(text, *words)
                self.assertEqual(after.text, before.text)  # bit for bit
                self.assertEqual([j[0::3] for j in before.joints], [j[0::3] for j in after.joints])
                self.assertEqual((before.frames, before.time), (after.frames, after.time))

    def test_few_knots_keep_the_tolerance(self):
        text = walk()
        before = Bvh(text)
        for tolerance in (.5, 2):
            after = self.made(text, "--tolerance", str(tolerance))
            self.assertLessEqual(apart(before, after), tolerance)
            after = self.made(text, "--tolerance", str(tolerance), "--levels", "0")
            self.assertLessEqual(apart(before, after), tolerance)
            report = self.made(text, "--tolerance", str(tolerance), "--levels", "0", out="out.json")["report"]
            self.assertEqual(report["numbers_before"], 120 * 96)
            self.assertEqual(report["keys_before"], 120 * 32)
            self.assertLessEqual(abs(report["max_error"] - apart(before, after)), 1e-9)
            self.assertLessEqual(10 * report["numbers_after"], report["numbers_before"])
            self.assertLessEqual(10 * report["keys_after"], report["keys_before"])

    def test_other_orders_keep_the_tolerance(self):
        for order in ("XYZ", "YXZ", "ZYX", "XZY", "YZX", "X", "Y", "Z"):
            text = walk(60, order, noise=.05)
            self.assertLessEqual(apart(Bvh(text), self.made(text, "--tolerance", "0.5")), .5)

    def test_bones_keep_their_lengths(self):
        text = walk(40)
        path = self.file("path.json", line([0, 92, 0], [0, 92, 40], [40, 92, 60], [90, 92, 60], [90, 100, 120]))
        wanted = numpy.array([numpy.linalg.norm(j[2]) for j in Bvh(text).joints[1:]])
        for words in ((), ("--gain", "3=0"), ("--gain", "1=2,2=-3,3=5"), ("--path", path), ("--tolerance", "1", "--path", path, "--gain", "3=0")):
            lengths = self.made(text, *words).lengths()
            self.assertLess(abs(lengths / wanted[:, None] - 1).max(), 1e-12)

    def test_joints_are_where_numpy_puts_them(self):
        """All joints and ends, in single frames of a walk, of the drawing that a BVH file is: the vertices of its lines."""
        for order in "ZXY", "XYZ", "YZX":
            text = walk(order=order)
            head, lines = text.split("MOTION")[0], text.strip().splitlines()[-120:]
            for frame in 0, 41, 97:
                one = f"{head}MOTION\nFrames: 1\nFrame Time: 0.0083333\n{lines[frame]}\n"
                self.file("one.bvh", one)
                self.done("convert", "one.bvh", "one.obj")
                seen = numpy.array([line.split()[1:] for line in (self.folder / "one.obj").read_text().splitlines()
                                    if line.startswith("v ")], float)  # up is y in both
                wanted = Bvh(one).positions()[0]
                apart = numpy.linalg.norm(seen[:, None] - wanted[None], axis=2)
                self.assertLess(apart.min(axis=0).max(), 1e-6, "each joint is on a line")
                self.assertLess(apart.min(axis=1).max(), 1e-6, "and each point of a line is a joint")

    def test_blender_opens_it(self):
        """A walk that was fitted, scaled and written: Blender reads it, and its bones are where numpy puts them."""
        self.file("in.bvh", walk(frames=12))
        self.done("motion", "in.bvh", "--tolerance", ".5", "--gain", "3=0", "--out", "out.bvh")
        script = self.file("look.py", """
import bpy, builtins, json
plain = builtins.open  # Debian's add-on asks for a mode that its Python no longer has
builtins.open = lambda name, mode='r', *rest, **more: plain(name, mode.replace('U', ''), *rest, **more)
bpy.ops.import_anim.bvh(filepath='out.bvh', axis_forward='Y', axis_up='Z', rotate_mode='NATIVE', update_scene_fps=False)
body, found = bpy.context.object, []
for frame in 1, 6, 12:
    bpy.context.scene.frame_set(frame)
    found.append({bone.name: list(body.matrix_world @ bone.head) for bone in body.pose.bones})
json.dump(found, plain('found.json', 'w'))
""")
        run = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", script],
                             capture_output=True, text=True, timeout=600, cwd=self.folder, check=False)
        self.assertEqual(run.returncode, 0, run.stdout[-2000:] + run.stderr[-2000:])
        bvh = Bvh((self.folder / "out.bvh").read_text())
        places, names = bvh.positions(), [joint[0] for joint in bvh.joints]
        for frame, bones in zip((0, 5, 11), json.loads((self.folder / "found.json").read_text())):
            self.assertEqual(len(bones), len(BONES))
            for name, place in bones.items():
                self.assertLess(numpy.abs(places[frame][names.index(name)] - place).max(), 1e-3, (frame, name))  # floats

    def test_a_level_is_the_jitter(self):
        """Without the finest level the noise goes and the swing stays."""
        quiet, loud = Bvh(walk(120, noise=0)), walk(120, noise=1.5)
        calm = self.made(loud, "--levels", "4", "--gain", "4=0")

        def shake(bvh):
            return numpy.abs(numpy.diff(bvh.values[:, 3:], n=2, axis=0)).mean()

        self.assertLess(shake(calm), .4 * shake(Bvh(loud)))
        self.assertLess(apart(quiet, calm), 8)
        swing = quiet.values.max(0) - quiet.values.min(0)
        kept = calm.values.max(0) - calm.values.min(0)
        big = swing > 20
        self.assertTrue((kept[big] > .85 * swing[big]).all())
        plain = self.made(walk(240, noise=0), "--tolerance", "0.5")
        wide = [self.made(walk(240, noise=0), "--tolerance", "0.5", "--gain", f"1={gain},2={gain}") for gain in (1.5, 2)]
        feet = [index for index, joint in enumerate(plain.joints) if joint[0] in ("LeftLeg2", "RightLeg2")]

        def step(bvh):
            places = bvh.positions()
            return numpy.ptp(places[:, feet[0]] - places[:, feet[1]], axis=0)[2]

        self.assertGreater(step(wide[0]), 1.1 * step(plain), "it struts: its steps are longer")
        self.assertGreater(step(wide[1]), 1.1 * step(wide[0]))

    def test_the_path_is_the_way_alone(self):
        """Of two seconds the path's base is one span: bob and sway are its details. Laid out straight the walk still bobs, and hardly tilts."""
        text = walk(240, noise=0)
        before = Bvh(text)
        base = self.made(text, out="plain.json")["path"]["base"]
        self.assertEqual(len(base["points"]), 4)
        slope = BSpline(base["knots"], numpy.array(base["points"]), 3).derivative()(numpy.linspace(base["knots"][3], base["knots"][-4], 200))
        own = numpy.diff(before.positions()[:, 0], axis=0)

        def steepest(ways):
            return numpy.degrees(numpy.arctan2(abs(ways[:, 1]), ways[:, 2])).max()

        self.assertGreater(steepest(own), 15)
        self.assertLess(steepest(slope), 6)
        ends = [before.positions()[frame, 0] for frame in (0, -1)]
        straight = self.file("straight.json", line(*((ends[0] * (3 - i) + ends[1] * i) / 3 for i in range(4))))
        after = self.made(text, "--path", straight)
        self.assertGreater(numpy.ptp(after.positions()[:, 0, 1]), .8 * numpy.ptp(before.positions()[:, 0, 1]))
        self.assertLess(apart(before, after), 8)

    def test_the_walk_follows_the_path(self):
        """A turned path turns the walk; a level curve keeps every joint's height."""
        text = walk(120, noise=0)
        before = Bvh(text)
        plain = self.made(text, out="plain.json")
        base = plain["path"]["base"] if "base" in plain["path"] else plain["path"]["shape"]["base"]
        same = self.made(text, "--path", self.file("same.json", base))
        self.assertLess(numpy.abs(same.positions() - before.positions()).max(), 1e-6)
        points = numpy.array(base["points"])
        turn = numpy.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # about y
        turned = self.made(text, "--path", self.file("turned.json", {**base, "points": (points @ turn.T + [5, 0, 7]).tolist()}))
        self.assertLess(numpy.abs(turned.positions() - (before.positions() @ turn.T + [5, 0, 7])).max(), 1e-3)
        text = walk(120, noise=0, bob=0)  # the root goes straight: on a level curve every joint keeps its height
        before = Bvh(text)
        bent = self.made(text, "--path", self.file("bent.json", line([0, 92, 0], [0, 92, 60], [30, 92, 90], [90, 92, 110], [120, 92, 110])))
        heights = bent.positions()[:, :, 1] - before.positions()[:, :, 1]
        self.assertLess(numpy.abs(heights).max(), 1e-3)
        self.assertLess(numpy.linalg.norm(bent.positions()[-1, 0] - [120, 92, 110]), 1e-6)

    def test_json_says_how_it_turns(self):
        """Joints from the JSON, by scipy, are those of the BVH."""
        from scipy.interpolate import BSpline
        from scipy.spatial.transform import Rotation
        text = walk(40, noise=.05)
        made, frames = self.made(text, "--tolerance", "0.5", out="out.json"), self.made(text, "--tolerance", "0.5")
        u = numpy.arange(40.0)
        local = list(frames.local())
        for joint, (_, wanted), (name, parent, offset, channels, end) in zip(made["joints"], local, frames.joints):
            self.assertEqual((joint["name"], -1 if joint["parent"] is None else joint["parent"]), (name, parent))
            self.assertEqual(joint["offset"], offset.tolist())
            if not channels:
                self.assertTrue(joint["end"])
                continue
            base = joint["orientation"]["base"]
            q = BSpline(numpy.array(base["knots"], float), numpy.array(base["points"]), base["degree"])(u)
            turn = Rotation.from_quat(q)
            for level in joint["orientation"].get("levels", []):
                turn = turn * Rotation.from_rotvec(BSpline(numpy.array(level["knots"], float), numpy.array(level["details"]), base["degree"])(u))
            self.assertLess(numpy.abs(turn.as_matrix() - wanted).max(), 1e-8)

    def test_short_takes(self):
        for frames in range(1, 8):
            text = walk(frames)
            self.assertEqual(self.made(text).text, Bvh(text).text)
            self.assertLessEqual(apart(Bvh(text), self.made(text, "--tolerance", "0.5")), .5)
            for levels in "0", "12":
                self.made(text, "--levels", levels, out="out.json")

    def test_bad_files(self):
        good = walk(3)
        lines = good.split("\n")

        def refused(text, place, message):
            told = self.refused(1, "motion", self.file("bad.bvh", text), "--out", "x.bvh")
            self.assertRegex(told, place + ".*" + message)

        refused("", "line 1", "expected HIERARCHY, found the end")
        refused("BVH", "line 1", "expected HIERARCHY, found 'BVH'")
        refused(good.replace("ROOT", "JOINT", 1), "line 2", "expected ROOT, found 'JOINT'")
        refused(good.replace("OFFSET 0.0 0.0 0.0", "OFFSET 0.0 x 0.0", 1), "line 4", "expected an offset of 3 numbers, found 'x'")
        refused(good.replace("Zrotation", "Wrotation", 1), "line 5", "found 'Wrotation'")
        refused(good.replace("Zrotation", "Xrotation", 1), "line 5", "each once")
        refused(good.replace("CHANNELS 6", "CHANNELS 7", 1), "line 5", "from 0 to 6, found '7'")
        refused(good.replace("Frames: 3", "Frames: 0"), f"line {lines.index('Frames: 3') + 1}", "above 0")
        refused(good.replace("Frames: 3", "Frames: 4"), "line", "expected a number for each channel, found the end")
        refused(good.replace("Frames: 3", "Frames: 2"), "line", "expected the end after the last frame")
        refused(good.replace("Frames: 3", "Frames: 100000000"), "line", "expected")
        refused(good.replace("Frame Time: 0.0083333", "Frame Time: 0"), "line", "the time of a frame")
        refused(good.replace("MOTION", "NOTION"), "line", "JOINT, End Site or }|MOTION")
        refused("\n".join(lines[:-2] + [lines[-2].replace(" ", " nan ", 1)]), f"line {len(lines) - 1}", "found 'nan'")
        path = self.file("closed.json", {"degree": 2, "closed": True, "knots": [0, 1, 2, 3], "points": [[0, 0], [1, 0], [0, 1]]})
        self.refused(1, "motion", self.file("in.bvh", good), "--path", path, "--out", "x.bvh")
        self.refused(1, "motion", self.file("in.bvh", walk(3, positions="")), "--path", self.file("l.json", line([0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0])), "--out", "x.bvh")
        for words in (("--out", "x.txt"), (), ("--gain", "4=1", "--out", "x.bvh"), ("--gain", "1", "--out", "x.bvh"), ("--gain", "1=1,", "--out", "x.bvh"),
                      ("--gain", "1=1e7", "--out", "x.bvh"), ("--levels", "1.5", "--out", "x.bvh"), ("--levels", "13", "--out", "x.bvh"),
                      ("--tolerance", "0", "--out", "x.bvh"), ("--tolerance", "181", "--out", "x.bvh")):
            self.refused(2, "motion", "in.bvh", *words)


if __name__ == "__main__":
    unittest.main()
