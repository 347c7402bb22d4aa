"""Real outlines taken apart and put together: letters of an installed TrueType font, read here from its tables and
imported as SVG, and the drawings in examples/."""
import json
import math
import pathlib
import struct
import unittest

from program import ROOT, ProgramTest

FONT = pathlib.Path("/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf")  # fonts-dejavu-core
LETTERS = "abdegkmqsQRS&@358"


class Font:
    """Outlines of simple glyphs: contours of (x, y, on the curve)."""

    def __init__(self, data):
        self.data, self.tables = data, {}
        for i in range(struct.unpack(">H", data[4:6])[0]):
            tag, _, offset, size = struct.unpack(">4sIII", data[12 + 16 * i:28 + 16 * i])
            self.tables[tag.decode()] = data[offset:offset + size]
        head, loca = self.tables["head"], self.tables["loca"]
        wide = struct.unpack(">h", head[50:52])[0]
        self.offsets = (struct.unpack(f">{len(loca) // 4}I", loca) if wide else
                        [2 * x for x in struct.unpack(f">{len(loca) // 2}H", loca)])
        self.glyphs = self.characters()

    def characters(self):
        """The cmap's segments (format 4)."""
        cmap = self.tables["cmap"]
        for i in range(struct.unpack(">H", cmap[2:4])[0]):
            at = struct.unpack(">I", cmap[8 + 8 * i:12 + 8 * i])[0]
            if struct.unpack(">H", cmap[at:at + 2])[0] == 4:
                break
        n = struct.unpack(">H", cmap[at + 6:at + 8])[0] // 2

        def row(k, kind):
            start = at + 14 + 2 * n * k + (2 if k > 0 else 0)
            return struct.unpack(f">{n}{kind}", cmap[start:start + 2 * n])
        ends, starts, deltas, ranges = row(0, "H"), row(1, "H"), row(2, "h"), row(3, "H")
        found = {}
        for k in range(n):
            for c in range(starts[k], ends[k] + 1):
                if ranges[k] == 0:
                    found[c] = (c + deltas[k]) % 65536
                else:
                    place = at + 16 + 6 * n + 2 * k + ranges[k] + 2 * (c - starts[k])
                    found[c] = struct.unpack(">H", cmap[place:place + 2])[0]
        return found

    def contours(self, letter):
        glyph = self.glyphs[ord(letter)]
        data = self.tables["glyf"][self.offsets[glyph]:self.offsets[glyph + 1]]
        count = struct.unpack(">h", data[:2])[0]
        if count < 0:
            return []
        ends = struct.unpack(f">{count}H", data[10:10 + 2 * count])
        at = 12 + 2 * count + struct.unpack(">H", data[10 + 2 * count:12 + 2 * count])[0]
        flags, total = [], ends[-1] + 1
        while len(flags) < total:
            flag, at = data[at], at + 1
            times = 1
            if flag & 8:
                times, at = data[at] + 1, at + 1
            flags += [flag] * times
        axes = []
        for short, same in ((2, 16), (4, 32)):
            values, value = [], 0
            for flag in flags:
                if flag & short:
                    value += data[at] if flag & same else -data[at]
                    at += 1
                elif not flag & same:
                    value += struct.unpack(">h", data[at:at + 2])[0]
                    at += 2
                values.append(value)
            axes.append(values)
        points = list(zip(*axes, [flag & 1 for flag in flags]))
        return [points[a:b + 1] for a, b in zip((0, *[e + 1 for e in ends]), ends)]


def path(contour):
    """Path data; points on the curve between two that are not are left out in the font."""
    full = []
    for i, (x, y, on) in enumerate(contour):
        px, py, before = contour[i - 1]
        if not on and not before:
            full.append(((x + px) / 2, (y + py) / 2, 1))
        full.append((x, y, on))
    first = next(i for i, p in enumerate(full) if p[2])
    full = full[first:] + full[:first]
    text, i = f"M{full[0][0]} {-full[0][1]}", 1
    while i < len(full):
        x, y, on = full[i]
        if on:
            text, i = text + f"L{x} {-y}", i + 1
        else:
            ex, ey, _ = full[(i + 1) % len(full)]
            text, i = text + f"Q{x} {-y} {ex} {-ey}", i + 2
    return text + "Z"


class Outlines(ProgramTest):
    def check(self, drawing):
        """Every curve of the drawing, at as many levels as its knots allow up to three. Returns how many levels."""
        self.done("convert", drawing, "out.batten")
        document = json.loads((self.folder / "out.batten").read_text())
        total = 0
        for thing in document["objects"]:
            for curve in thing.get("curves", []):
                name = self.file("curve.json", curve)
                for levels in (3, 2, 1):
                    run = self.run_program("levels", "--decompose", levels, name)
                    if run.returncode == 0:
                        break
                else:
                    continue
                got = json.loads(run.stdout)["curves"]
                self.assertEqual(len(got), levels + 1)
                self.assertEqual(got[-1]["knots"], curve["knots"])
                self.assertLess(len(got[0]["points"]), len(curve["points"]))
                xs, ys = zip(*curve["points"])
                size = math.hypot(max(xs) - min(xs), max(ys) - min(ys))
                for p, q in zip(got[-1]["points"], curve["points"]):
                    self.assertLess(math.dist(p, q), 1e-12 * size)
                total += levels
        return total

    @unittest.skipUnless(FONT.exists(), "fonts-dejavu-core is not installed")
    def test_letters(self):
        font = Font(FONT.read_bytes())
        paths = [path(contour) for letter in LETTERS for contour in font.contours(letter)]
        self.assertGreater(len(paths), 20)
        body = "".join(f'<path d="{data}"/>' for data in paths)
        drawing = self.file("letters.svg", f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -2000 2000 2000">{body}</svg>')
        self.assertGreater(self.check(drawing), 2 * len(paths))

    def test_drawings(self):
        self.assertGreater(sum(self.check(drawing) for drawing in sorted(ROOT.glob("examples/*.svg"))), 10)


if __name__ == "__main__":
    unittest.main()
