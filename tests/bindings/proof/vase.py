"""A surface through three rings, bent by a wire, as triangles in an STL file. Usage: vase.py vase.stl"""
import pathlib
import sys

import batten

CORNERS = [[2, 0], [2, 2], [0, 2], [-2, 2], [-2, 0], [-2, -2], [0, -2], [2, -2]]


def ring(size, height):
    return batten.curve([[size * x, size * y, height] for x, y in CORNERS], range(9), degree=3, closed=True)


vase = batten.loft([ring(5, 0), ring(3, 10), ring(6, 20)])

wire = batten.clamped([[0, 0, 0], [0, 0, 7], [0, 0, 13], [0, 0, 20]])
bent = batten.clamped([[0, 0, 0], [0, 0, 7], [4, 0, 13], [8, 0, 20]])
net = vase.points
moved = batten.bind([{"reference": wire, "radius": 50}], net.reshape(-1, 3)).apply([bent])

surface = batten.surface(moved.points.reshape(net.shape), vase.knots("u"), vase.knots("v"),
                         degree=(vase.degree("u"), vase.degree("v")), closed=(vase.is_closed("u"), vase.is_closed("v")))

pathlib.Path(sys.argv[1]).write_bytes(batten.write_stl(surface, tolerance=0.05))
print(f"{net.shape[0]} by {net.shape[1]} points, {moved.report.moved} moved")
