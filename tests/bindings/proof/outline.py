"""Reads the curves of an SVG file, simplifies them, moves their outlines apart, unites what overlaps, and writes an SVG file.
Usage: outline.py drawing.svg outline.svg
"""
import pathlib
import sys

import batten

source, target = map(pathlib.Path, sys.argv[1:])
try:
    drawing = batten.read_svg(source.read_text())
except batten.BattenError as error:
    sys.exit(f"{source}: {error}")
apart = []
for thing in drawing.objects:
    for curve in thing.curves:
        simple = curve.simplify(0.05)
        outward = -3 if simple.area > 0 else 3
        apart += simple.offset(outward, 0.01).curves

united = batten.combine("union", apart, 0.01)
out = batten.document()
out.set_page([0, 0, 120, 80])
out.add(batten.path_object(united, name="outline", style={"filled": True, "stroked": False}))
target.write_text(out.to_svg(native=False))
print(f"{drawing.count} objects, {len(apart)} outlines, {len(united)} united")
