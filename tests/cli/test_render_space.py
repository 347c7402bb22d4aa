"""render of drawings in space: what is seen, what is hidden, the looks, the view of all, what is refused."""
import base64
import json
import re
import unittest

from test_render import pixels

from program import CURVE, ROOT, ProgramTest

KNOTS = [0, 0, 0, 0, 1, 1, 1, 1]
VIEW = {"eye": [50, 50, -500], "target": [50, 50, 0], "up": [0, -1, 0], "size": [200, 160], "height": 160}


def sheet(z=0, number=1):
    """A square of 100 at a depth."""
    points = [[[100 * i / 3, 100 * j / 3, z] for j in range(4)] for i in range(4)]
    return {"id": number, "kind": "surface", "surface": {"degree": [3, 3], "closed": [False, False],
                                                        "knots": [KNOTS, KNOTS], "points": points}}


def line(points, number=2, width=4):
    return {"id": number, "kind": "path", "style": {"stroked": True, "stroke": "#ff0000ff", "width": width},
            "curves": [{"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": points}]}


def document(*objects, page=None):
    known = {"batten": 2, "next": len(objects) + 1, "objects": list(objects)}
    return {**known, "page": page} if page else known


class RenderSpace(ProgramTest):
    def png(self, drawing, *words):
        self.done("render", self.file("in.batten", drawing), "out.png", *words)
        return pixels((self.folder / "out.png").read_bytes())

    def view(self, **changes):
        return self.file("view.json", {**VIEW, **changes})

    def test_the_saved_view(self):
        """Without --view the last saved view is shown, as it would be with it; SVG files made by convert show its lines, and
        hold the drawing."""
        parts = sheet(), line([[0, 50, -20], [100, 50, -20]])
        views = [{"id": 3 + k, "kind": "view", "name": f"v{k}", "view": view} for k, view in enumerate([
            {**VIEW, "eye": [90, -300, -200]}, {**VIEW, "eye": [-60, 80, -300], "size": [220, 140]}])]
        asked = self.png(document(*parts), "--view", self.file("view.json", views[1]["view"]))
        saved = self.png(document(*parts, *views))
        self.assertEqual((asked == saved) if isinstance(asked, tuple) else (asked == saved).all(), True)
        first = self.png(document(*parts, views[0], {**views[1], "hidden": True}))
        self.assertFalse((first[:2] == saved[:2]) if isinstance(first, tuple) else first.shape == saved.shape)
        self.done("convert", self.file("in.batten", document(*parts, *views)), "out.svg")
        self.done("render", "in.batten", "lines.svg", "--look", "lines")
        paths = [re.findall("<path[^>]*>", (self.folder / name).read_text()) for name in ("out.svg", "lines.svg")]
        self.assertEqual(*paths)
        self.assertGreater(len(paths[0]), 4)
        self.assertIn('viewBox="0 0 220 140"', (self.folder / "out.svg").read_text())
        self.done("convert", "in.batten", "straight.batten")
        self.done("convert", "out.svg", "back.batten")
        self.assertEqual((self.folder / "back.batten").read_text(), (self.folder / "straight.batten").read_text())
        self.done("convert", self.file("flat.batten", document(line([[0, 50], [100, 50]]), views[0])), "flat.svg")
        self.assertNotIn('viewBox="0 0 200 160"', (self.folder / "flat.svg").read_text())

    def test_a_camera_of_the_drawing(self):
        """NAME@SECONDS is the view that batten camera says, and the camera itself is in no picture."""
        move = {"path": {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[20, 90, -200], [150, 10, -100]]},
                "orientation": {"mode": "look-at", "target": [50, 50, 0], "up": [0, -1, 0]}, "fov": 50, "timing": {"duration": 2}}
        fly = {"id": 3, "kind": "camera", "name": "Fly@dawn", "move": move}
        parts = sheet(), line([[0, 50, -20], [100, 50, -20]])
        for time in "0", "0.75", "2":
            pose = self.json("camera", self.file("move.json", move), "--at", time)
            x, y, z, w = pose["rotations"][0]
            eye = pose["positions"][0]
            far = (130 ** 2 + 80 ** 2 + 100 ** 2) ** .5  # the size of the path: lines are as wide as they are there
            back = 2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)
            view = {"eye": eye, "target": [e - far * b for e, b in zip(eye, back)], "size": [320, 180], "fov": 50,
                    "up": [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)]}
            wanted = self.png(document(*parts), "--view", self.file("view.json", view))
            shot = self.png(document(*parts, fly), "--view", "Fly@dawn@" + time, "--size", "320x180")
            self.assertEqual((wanted == shot) if isinstance(wanted, tuple) else (wanted == shot).all(), True)
        self.png(document(*parts, fly), "--view", "Fly@dawn@1")
        for name in "Fly@dawn", "Fly@dawn@", "Fly@dawn@x", "Fly@1":
            self.refused(1, "render", self.file("in.batten", document(*parts, fly)), "out.png", "--view", name)
        wide = {**fly, "move": {**move, "fov": 200}}
        self.refused(1, "render", self.file("in.batten", document(*parts, wide)), "out.png", "--view", "Fly@dawn@1")

    def test_a_skeleton_stands_as_it_does_then(self):
        """At the time of a camera's picture a skeleton is where its motion is then: as one that always stands so."""
        def bvh(*angles):
            bones = ("ROOT a { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation "
                     "JOINT b { OFFSET 0 30 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 60 0 } } }")
            frames = "\n".join(f"0 0 0 0 0 0 {angle} 0 0" for angle in angles)
            return f"HIERARCHY\n{bones}\nMOTION\nFrames: {len(angles)}\nFrame Time: 0.5\n{frames}\n"

        move = {"path": {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[-20, -30, -300], [20, -30, -300]]},
                "orientation": {"mode": "look-at", "target": [0, -40, 0], "up": [0, -1, 0]}, "fov": 40, "timing": {"duration": 4}}

        def shot(time, *angles):
            self.file("walk.bvh", bvh(*angles))
            self.done("convert", "walk.bvh", "walk.batten")
            drawing = json.loads((self.folder / "walk.batten").read_text())
            drawing["objects"].append({"id": 99, "kind": "camera", "name": "Eye", "move": move})
            drawing["next"] = 100
            return self.png(drawing, "--view", f"Eye@{time}", "--size", "320x180")

        for time, angle in ((0, 0), (1, 80), (2, -70), (3.5, -70)):
            moving, still, other = shot(time, 0, 40, 80, 5, -70), shot(time, angle), shot(time, 120)
            self.assertLess((abs(moving.astype(int) - still) > 40).mean(), 2e-3)
            self.assertGreater((abs(moving.astype(int) - other) > 40).mean(), 5e-3)

    def test_a_square_is_where_the_view_says(self):
        image = self.png(document(sheet()), "--view", self.view(), "--background", "none")
        self.assertEqual(image.shape, (160, 200, 4))
        self.assertTrue((image[32:128, 52:148, 3] == 255).all())
        self.assertTrue((image[:28, :, 3] == 0).all() and (image[:, :48, 3] == 0).all())
        middle = image[80, 100]
        self.assertTrue(middle[:3].min() > 190 and middle[:3].max() - middle[:3].min() < 25)  # clay

    def test_size_replaces_that_of_the_view(self):
        image = self.png(document(sheet()), "--view", self.view(size=[10.4, 20]), "--size", "100x80")
        self.assertEqual(image.shape[:2], (80, 100))
        image = self.png(document(sheet()), "--view", self.view(size=[10.4, 20]))
        self.assertEqual(image.shape[:2], (20, 10))

    def test_a_line_before_is_drawn_over_and_one_behind_is_faint(self):
        def red(image):
            inside = image[60:100, 60:140].astype(int)
            return int((inside[:, :, 0] - inside[:, :, 1] > 120).sum()), int((inside[:, :, 0] - inside[:, :, 1] > 20).sum())
        before = red(self.png(document(sheet(), line([[0, 50, -20], [100, 50, -20]])), "--view", self.view()))
        behind = red(self.png(document(sheet(), line([[0, 50, 20], [100, 50, 20]])), "--view", self.view()))
        on = red(self.png(document(sheet(), line([[0, 50, 0], [100, 50, 0]])), "--view", self.view()))
        self.assertTrue(before[0] > 3.5 * 80, before)
        self.assertTrue(on[0] > 3.5 * 80, on)
        self.assertTrue(behind[0] == 0 and 40 < behind[1] < 0.75 * before[1], behind)

    def test_looks_differ_and_each_is_the_same_again(self):
        pictures = {}
        for look in ("shaded", "zebra", "curvature", "mean", "lines"):
            bent = document(sheet())
            bent["objects"][0]["surface"]["points"][1][1][2] = -60
            first = self.png(bent, "--look", look, "--size", "150x150")
            self.assertTrue((first == self.png(bent, "--look", look, "--size", "150x150")).all())
            pictures[look] = first.tobytes()
        self.assertEqual(len(set(pictures.values())), 5)

    def test_the_view_of_all_holds_all(self):
        for size in ("300x100", "100x300", "200x200"):
            image = self.png(document(sheet(), line([[300, 0, -200], [0, 300, 40]])), "--size", size)
            seen = (image[:, :, :3] < 250).any(axis=2)
            self.assertTrue(seen.any() and not (seen[0].any() or seen[-1].any() or seen[:, 0].any() or seen[:, -1].any()))

    def test_a_drawing_in_its_page_is_drawn_as_ever(self):
        flat = document(line([[10, 10], [90, 50]]), page=[0, 0, 100, 60])
        flat["objects"][0]["id"] = 1
        flat["batten"] = 1
        image = self.png(flat)
        self.assertEqual(image.shape[:2], (60, 100))
        self.assertTrue((image == self.png(flat, "--look", "zebra")).all())

    def test_the_example(self):
        """The jug closes around its axis: nothing of the paper shows through, inside or outside."""
        self.done("render", ROOT / "examples" / "jug.batten", "out.png", "--size", "240x200", "--background", "none")
        image = pixels((self.folder / "out.png").read_bytes())
        body = image[70:150, 90:150]
        self.assertTrue((body[:, :, 3] == 255).all())

    def test_what_is_refused(self):
        drawing, view = self.file("in.batten", document(sheet())), self.view()
        self.refused(2, "render", drawing, "out.png", "--look", "shiny")
        self.refused(2, "render", drawing, "out.svg", "--look", "shiny")
        self.refused(2, "render", "-", "out.png", "--view", "-")
        self.refused(1, "render", drawing, "out.png", "--view", self.file("bad.json", {**VIEW, "up": [0, 0, 1]}))
        self.refused(1, "render", drawing, "out.png", "--view", self.file("none.json", CURVE))
        self.refused(1, "render", drawing, "out.png", "--size", "30000x30000")


class DrawSpace(ProgramTest):
    """SVG and PDF: lines with what is hidden left out or dashed."""
    def lines(self, drawing, *words):
        self.done("render", self.file("in.batten", drawing), "out.svg", "--view", self.file("view.json", VIEW), *words)
        text = (self.folder / "out.svg").read_text()
        return [(float(x), float(y), "dasharray" in path, "ff0000" in path)
                for path in re.findall("<path[^>]*>", text) for x, y in re.findall(r"([\d.]+) ([\d.]+)", path.split(" d=")[1])]

    def test_what_lies_behind_is_cut_or_dashed(self):
        behind = document(sheet(), line([[-20, 50, 20], [120, 50, 20]]))
        red = [x for x, _, _, is_red in self.lines(behind) if is_red]
        self.assertTrue(red and all(x < 50.1 or x > 149.9 for x in red), red)
        drawn = self.lines(behind, "--look", "lines")
        hidden = [x for x, _, dashed, is_red in drawn if is_red and dashed]
        self.assertTrue(min(hidden) > 49.9 and max(hidden) < 150.1, hidden)
        before = self.lines(document(sheet(), line([[-20, 50, -20], [120, 50, -20]])), "--look", "lines")
        self.assertFalse([x for x, _, dashed, is_red in before if is_red and dashed])
        corners = {(round(x), round(y)) for x, y, _, is_red in before if not is_red}
        self.assertTrue({(50, 30), (150, 30), (50, 130), (150, 130)} <= corners)

    def pictures(self, drawing, *words):
        """The pictures in the SVG, and whether each lies below all lines."""
        self.done("render", self.file("in.batten", drawing), "out.svg", "--view", self.file("view.json", VIEW), *words)
        text = (self.folder / "out.svg").read_text()
        found = re.findall('<image width="200" height="160" [^>]*base64,([A-Za-z0-9+/=]*)"/>', text)
        return [pixels(base64.b64decode(data)) for data in found], text.find("<image") < text.find("<path")

    def test_the_shading_lies_below_as_one_picture(self):
        seen = set()
        for words in ((), ("--look", "zebra"), ("--look", "curvature"), ("--look", "mean")):
            bent = document(sheet())
            bent["objects"][0]["surface"]["points"][1][1][2] = -60
            found, below = self.pictures(bent, *words)
            self.assertTrue(len(found) == 1 and below)
            self.assertEqual(found[0].shape, (320, 400, 4))  # two pixels for one of the drawing
            self.assertTrue((found[0][64:256, 104:296, 3] == 255).all() and (found[0][:100, :80, 3] == 0).all())
            seen.add(found[0].tobytes())
        self.assertEqual(len(seen), 4)
        self.assertEqual(self.pictures(document(sheet()), "--look", "lines")[0], [])

    def test_the_view_of_all_stands_or_lies_as_the_page(self):
        """Up is up: the page's up of a wall, towards the eye of a floor; what is nearer to the eye from above is further down."""
        for stand, up, front in (("wall", [0, -40, 0], [0, 0, -40]), ("floor", [0, 0, -40], [0, 40, 0]), (None, [0, -40, 0], [0, 0, -40])):
            parts = [line([[7, 7, 7], [7 + a, 7 + b, 7 + c]], n) for n, (a, b, c) in enumerate((up, front), 1)]
            drawing = {**document(*parts), **({"stand": stand} if stand else {})}
            self.done("render", self.file("in.batten", drawing), "out.svg", "--look", "lines")
            ends = []
            for path in re.findall('<path[^>]* d="([^"]*)"', (self.folder / "out.svg").read_text()):
                numbers = list(map(float, re.findall(r"-?[\d.]+(?:e[-+]?\d+)?", path)))
                ends.append((numbers[0], numbers[1], numbers[-2], numbers[-1]))
            upright, forward = sorted(ends, key=lambda e: abs(e[0] - e[2]))
            self.assertLess(abs(upright[0] - upright[2]), 1e-3)
            self.assertLess(upright[3], upright[1])
            self.assertGreater(forward[3], forward[1])

    def test_the_picture_agrees_with_the_png(self):
        """A pixel of the PNG is the mean of four of the picture, but where lines lie."""
        drawing = document(sheet(z=30))
        below = self.pictures(drawing)[0][0].astype(float)
        self.done("render", self.file("in.batten", drawing), "out.png", "--view", self.file("view.json", VIEW),
                  "--background", "none")
        image = pixels((self.folder / "out.png").read_bytes()).astype(float)
        mean = below.reshape(160, 2, 200, 2, 4).mean(axis=(1, 3))
        self.assertLess(abs(mean - image)[36:124, 56:144].max(), 3)

    def test_pdf(self):
        name, view = self.file("in.batten", document(sheet())), self.file("view.json", VIEW)
        for look, images in (("shaded", 1), ("zebra", 1), ("lines", 0)):
            self.done("render", name, "out.pdf", "--view", view, "--look", look)
            data = (self.folder / "out.pdf").read_bytes()
            self.assertTrue(data.startswith(b"%PDF"))
            self.assertEqual(data.count(b"/Width 400"), 2 * images)  # its colours and its alpha


if __name__ == "__main__":
    unittest.main()
