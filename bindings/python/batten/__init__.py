"""Batten: B-spline curves that follow the pen.

Points are arrays of n rows, or flat with `dimension`. Arrays of float64 go in without a copy; results are numpy arrays that the
library has written, and `points` and `knots` of a curve are views of it. Each function is a C function of include/batten.
"""
import ctypes

import numpy as np

from ._call import KINDS, method, snake
from ._library import STRUCTS, TABLE, BattenError, check, doubles, lib, pointer

__version__ = lib.bat_version().decode()


class _Handle:
    def __init__(self, address, dim):
        self._at, self.dim = address, dim

    def _address(self):
        if not self._at:
            raise BattenError("state", f"this {type(self).__name__} has been committed")
        return self._at

    def _gone(self):
        self._at = None

    def __del__(self):
        if self._at:
            getattr(lib, TABLE["frees"][type(self).__name__])(ctypes.c_void_p(self._at))


class Curve(_Handle):
    """A non-uniform B-spline of degree 1 to 7, in the plane or in space, open or closed. It never changes."""

    def _view(self, address, shape):
        """Numbers of the curve, where they lie; they keep the curve alive."""
        items = (ctypes.c_double * int(np.prod(shape))).from_address(address)
        items.owner = self
        view = np.frombuffer(items).reshape(shape)
        view.flags.writeable = False
        return view

    def frames(self, n, **options):
        """(u, point, t, s, r): frames at n places or at parameters, rows of three numbers."""
        u = self.spread(n) if np.ndim(n) == 0 else doubles(n, "n")
        return (u, *self.frame_chain(**options).many(u))

    def finder(self):
        """A finder looks at the curve it is made of, so it keeps that."""
        finder = self._finder()
        finder.own = self
        return finder

    def to_svg(self, tolerance=0.01, decimals=3):
        """SVG path data."""
        def text(place):
            return " ".join(f"{round(one, decimals) + 0.0:.12g}" for one in place[:2].tolist())

        cubics = self.to_cubics(tolerance=tolerance)
        words = ["M" + text(cubics[0][0]), *("C" + " ".join(map(text, cubic[1:])) for cubic in cubics)]
        return "".join(words) + ("Z" if self.closed else "")

    def __repr__(self):
        return f"<Curve of degree {self.degree}, {self.count} points{', closed' if self.closed else ''}>"

    def __eq__(self, other):
        return isinstance(other, Curve) and self.is_equal(other)

    __hash__ = None


class Finder(_Handle):
    pass


class Chain(_Handle):
    def many(self, u):
        """(point, t, s, r) at many parameters."""
        u = doubles(u, "u")
        arrays = [np.empty((u.size, 3)) for _ in range(4)]
        out = STRUCTS["bat_frame_arrays"](*[array.ctypes.data for array in arrays])
        check(lib.bat_frame_chain_many(ctypes.c_void_p(self._address()), ctypes.c_size_t(u.size), pointer(u), ctypes.byref(out)))
        return tuple(arrays)


class Shape(_Handle):
    def level_total(self):
        return self.levels


class LiveShape(_Handle):
    def level_total(self):
        return self.shape().levels


class LiveSketch(_Handle):
    def add(self, *place):
        """Adds a sample: its coordinates."""
        return self.add_many([place])


for _kind in (Curve, Finder, Chain, Shape, LiveShape, LiveSketch):
    KINDS[_kind.__name__] = _kind
for _call in TABLE["calls"]:
    for _called in _call["names"]:
        _kind, _name = _called.replace("()", "").split(".")
        _name = snake(_name)
        _run, _is_property = method(_call, _name)
        if _kind == "b":
            globals()[_name] = _run
        else:
            _written = _name in vars(KINDS[_kind])
            setattr(KINDS[_kind], "_" + _name if _written else _name, property(_run) if _is_property and not _called.endswith("()") else _run)
