"""Curves and shapes, and the sessions of a pen."""
import ctypes

import numpy as np

from ._call import LIBRARY
from ._handle import Changing, Handle, Session, Value
from ._library import STRUCTS, TABLE, check, doubles, integers, lib, pointer, wrong
from ._values import converted


def _read_only(array):
    """The numbers with gaps between them: read-only, and copied by functions that would write (scipy's splines)."""
    apart = np.empty((*array.shape[:-1], array.shape[-1] + 1) if array.ndim > 1 else (*array.shape, 2))
    view = apart[:, :-1] if array.ndim > 1 else apart[:, 0]
    view[...] = array
    view.flags.writeable = apart.flags.writeable = False
    return view[...]


class Curve(Value):
    """A non-uniform B-spline of degree 1 to 7, in the plane or in space, open or closed. It never changes."""

    _made_by = "batten.curve(points, knots), batten.fit(points) and others"
    @staticmethod
    def _dimension(address, _):
        return lib.bat_curve_dimension(address)

    @property
    def points(self):
        """The control points: count rows, read-only."""
        return self._kept_numbers("points")

    @property
    def knots(self):
        """The knots, read-only: count + degree + 1 of an open curve, count + 1 of a closed one."""
        return self._kept_numbers("knots")

    def _kept_numbers(self, name):
        self._memory()
        kept = self.__dict__.get("_" + name + "_kept")
        if kept is None:
            kept = self.__dict__.setdefault("_" + name + "_kept", _read_only(getattr(self, "_" + name)))
        return kept

    def __call__(self, u, **options):
        """The place at u, or the places at an array of any shape; with order=n, n derivatives behind each."""
        if u.__class__ is float or is_one(u):
            return self.at(u, **options)
        places = doubles(np.ravel(u) if isinstance(u, np.ndarray) and not np.ma.isMaskedArray(u) else u, "u")
        places, order = places.ravel(), slice(None)
        if (places[1:] < places[:-1]).any():  # at_many takes them in their order
            sorting = np.argsort(places, kind="stable")
            places, order = places[sorting], np.argsort(sorting)
        found = self.at_many(places, **options)[order]
        return found.reshape(np.shape(u) + found.shape[1:])

    def frames(self, n, **options):
        """(u, point, t, s, r): frames at n places or at parameters, rows of three numbers."""
        u = self.spread(n) if is_one(n) else doubles(n, "n")
        return (u, *self.frame_chain(**options).many(u))

    def to_svg(self, tolerance=0.01, decimals=3):
        """SVG path data."""
        decimals = converted("int", decimals, "decimals")

        def text(place):
            return " ".join(f"{round(one, decimals) + 0.0:.12g}" for one in place[:2].tolist())

        cubics = self.to_cubics(tolerance=tolerance)
        words = ["M" + text(cubics[0][0]), *("C" + " ".join(map(text, cubic[1:])) for cubic in cubics)]
        return "".join(words) + ("Z" if self.closed else "")

    def __repr__(self):
        if not self._own:
            return super().__repr__()
        return f"<Curve of degree {self.degree}, {self.count} points{', closed' if self.closed else ''}>"

    def __hash__(self):
        if "_hash" not in self.__dict__:
            self._hash = hash((self.degree, self.closed, self.dim, tuple(self.points.ravel().tolist()), tuple(self.knots.tolist())))
        return self._hash

    def __reduce__(self):
        return _curve, (self.degree, self.closed, self.dim, np.array(self.points), np.array(self.knots)), self._told() or None


def is_one(value):
    """Whether a value is no array."""
    return value.ndim == 0 if isinstance(value, np.ndarray) else not hasattr(value, "__len__")


def _curve(degree, closed, dim, points, knots):
    return LIBRARY["curve"](points, knots, degree=degree, closed=closed, dimension=dim)


class Finder(Handle):
    """Finds closest points of one curve, faster than the curve does."""

    _made_by = "Curve.finder()"


class Chain(Handle):
    """Frames along a curve."""

    _made_by = "Curve.frame_chain()"

    def many(self, u):
        """(point, t, s, r) at many parameters."""
        u, memory = doubles(u, "u"), self._memory()
        arrays = [np.empty((u.size, 3)) for _ in range(4)]
        out = STRUCTS["bat_frame_arrays"](*[array.ctypes.data for array in arrays])
        check(lib.bat_frame_chain_many(ctypes.c_void_p(memory.address), ctypes.c_size_t(u.size), pointer(u), ctypes.byref(out)))
        return tuple(arrays)


class Shape(Changing):
    """A curve with levels of detail over a base. Edits change it."""

    _made_by = "Curve.levels(levels), Curve.shape() and others"

    @staticmethod
    def _dimension(address, _):
        return lib.bat_curve_dimension(ctypes.c_void_p(lib.bat_shape_curve(address, 0)))

    def _level_total(self):
        return self.levels

    def _level_count(self, level):
        return self.curve(level).count

    def __reduce_ex__(self, _):
        """The base, and each level as bat_shape_add_level takes it. What an open edit has left in its frames is committed."""
        one = self.copy().commit()
        levels = [(np.array(one.curve(level).knots), one.details(level), one.source(level), one.gain(level), one.is_muted(level))
                  for level in range(1, one.levels + 1)]
        return _shape, (one.curve(0), vars(one.options), levels)

    def __repr__(self):
        return f"<Shape of {self.levels} levels>" if self._own else super().__repr__()


def _shape(base, options, levels):
    words = {name: word for name, word in options.items() if isinstance(word, str)}
    item = STRUCTS["bat_shape_options"]()
    lib.bat_shape_options_init(ctypes.byref(item), ctypes.c_size_t(ctypes.sizeof(item)))
    for field in TABLE["structs"]["bat_shape_options"]["fields"]:
        name = field["name"]
        if name in words:
            setattr(item, name, converted(field["type"], words[name], name))
        elif name in options:
            setattr(item, name, (ctypes.c_double * 3)(*options[name]) if field["room"] else options[name])
    out = ctypes.c_void_p()
    check(lib.bat_shape_create(base._memory().address, ctypes.byref(item), ctypes.byref(out)))
    shape = Shape._made(out.value, base.dim)
    for level, (knots, details, source, gain, muted) in enumerate(levels, 1):
        knots, details, source = doubles(knots, "knots"), doubles(details, "details"), integers(source, "source")
        check(lib.bat_shape_add_level(ctypes.c_void_p(out.value), knots.size, pointer(knots), pointer(details), pointer(source)))
        shape.set_gain(level, gain)
        shape.set_muted(level, muted)
    return shape


class LiveShape(Session):
    """An edit of a shape while the pen is down."""

    _made_by = "Shape.live(level)"

    def _level_total(self):
        return self.shape().levels


class LiveSketch(Session):
    """A stroke over a curve while the pen is down."""

    _made_by = "Curve.live() and batten.live()"

    def add(self, *place):
        """Adds a sample: its coordinates."""
        if len(place) != self.dim:
            raise wrong("place", f"{self.dim} coordinates", len(place), "dimension")
        return self.add_many([[converted("double", one, "place") for one in place]])
