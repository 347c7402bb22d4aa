"""Batten: B-spline curves that follow the pen.

Points are arrays of n rows, or flat with `dimension`. Arrays of float64 go in without a copy; results are numpy arrays that the
library has written. Each function is a C function of include/batten, and help() says what its header says. What cannot be done
raises a BattenError, which names the argument, what was expected and what was found.

A Curve never changes: it compares and hashes by its numbers. A Shape changes; it compares and hashes by identity. Both copy and
pickle. LiveSketch and LiveShape are sessions of one pen; they do neither. All may be used from several threads, and after a fork.
"""
import contextlib
import ctypes
import os
import threading
import weakref

import numpy as np

from ._call import KINDS, RESULTS, Report, converted, method, snake
from ._library import DOCS, RECORDS, STRUCTS, TABLE, BattenError, check, doubles, integers, lib, pointer, record, shown, wrong

__version__ = lib.bat_version().decode()


class _Memory:
    """What the library allocated, until nothing looks at it any more."""

    __slots__ = "address", "free", "__weakref__"

    def __init__(self, address, free):
        self.address, self.free = address, free

    def __del__(self):
        if self.address:
            self.free(self.address)


class _Handle:
    _own, _dim, _ended = None, 2, "freed"
    _lock = contextlib.nullcontext()  # of what never changes

    def __new__(cls, *given, **options):
        raise TypeError(f"a {cls.__name__} is made by {cls._made_by}")

    def __init_subclass__(cls):
        if cls.__name__ in TABLE["frees"]:
            cls._free = staticmethod(getattr(lib, TABLE["frees"][cls.__name__]))
            cls._free.argtypes, cls._free.restype = [ctypes.c_void_p], None

    @classmethod
    def _made(cls, address, dim):
        return cls._sharing(_Memory(address, cls._free), dim)

    @classmethod
    def _sharing(cls, memory, dim):
        self = object.__new__(cls)
        self._own, self._dim = memory, dim
        return self

    @property
    def dim(self):
        """The number of coordinates, 2 or 3."""
        return self._dim

    def _memory(self):
        if not self._own:
            raise BattenError("state", f"this {type(self).__name__} has been {self._ended}")
        return self._own

    def _end(self, how):
        self._own, self._ended = None, how

    def free(self):
        """Gives the memory back at once. Any use after that is an error."""
        with self._lock:
            self._end(self._ended if not self._own else "freed")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.free()

    def __copy__(self):
        return self._sharing(self._memory(), self._dim)

    def __deepcopy__(self, _):
        return self.__copy__()

    def __repr__(self):
        return f"<{type(self).__name__}{'' if self._own else ', ' + self._ended}>"


class _Changing(_Handle):
    """What changes: one thread at a time."""

    @classmethod
    def _sharing(cls, memory, dim):
        self = super()._sharing(memory, dim)
        self._lock = threading.RLock()
        _changing[id(self)] = self
        return self

    def _no(self, *_):
        raise TypeError(f"a {type(self).__name__} is the session of one pen and cannot be copied or pickled; commit() gives its result")

    __copy__ = __deepcopy__ = __reduce__ = __reduce_ex__ = _no


_changing = weakref.WeakValueDictionary()
_held = []


def _hold():
    """Before a fork: no other thread is in the middle of a change."""
    _held[:] = [handle for one in _changing.valuerefs() if (handle := one())]
    for handle in _held:
        handle._lock.acquire()


def _release():
    for handle in _held:
        handle._lock.release()
    _held.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_release, after_in_child=_release)


def _read_only(array):
    """The numbers with gaps between them: read-only, and copied by functions that would write (scipy's splines)."""
    apart = np.empty((*array.shape[:-1], array.shape[-1] + 1) if array.ndim > 1 else (*array.shape, 2))
    view = apart[:, :-1] if array.ndim > 1 else apart[:, 0]
    view[...] = array
    view.flags.writeable = apart.flags.writeable = False
    return view[...]


class Curve(_Handle):
    """A non-uniform B-spline of degree 1 to 7, in the plane or in space, open or closed. It never changes."""

    _made_by = "batten.curve(points, knots), batten.fit(points) and others"
    report = Report()

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
        if is_one(u):
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

    def frame_chain(self, **options):
        chain = self._frame_chain(**options)
        chain._made_of = copied(self), options
        return chain

    def finder(self):
        finder = self._finder()
        finder._made_of = copied(self), {}  # a finder looks at the curve
        return finder

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

    def __eq__(self, other):
        return self.is_equal(other) if isinstance(other, Curve) else NotImplemented

    def __hash__(self):
        if "_hash" not in self.__dict__:
            self._hash = hash((self.degree, self.closed, self.dim, tuple(self.points.ravel().tolist()), tuple(self.knots.tolist())))
        return self._hash

    def __copy__(self):
        other = super().__copy__()
        other.__dict__ |= {name: value for name, value in vars(self).items() if not name.startswith("_")}
        return other

    def __reduce__(self):
        own = {name: value for name, value in vars(self).items() if not name.startswith("_")}
        return _curve, (self.degree, self.closed, self.dim, np.array(self.points), np.array(self.knots)), own or None


def is_one(value):
    """Whether a value is no array."""
    return value.ndim == 0 if isinstance(value, np.ndarray) else not hasattr(value, "__len__")


def copied(curve):
    return curve.__copy__()


def _curve(degree, closed, dim, points, knots):
    return curve(points, knots, degree=degree, closed=closed, dimension=dim)  # noqa: F821: made below


class Finder(_Handle):
    """Finds closest points of one curve, faster than the curve does."""

    _made_by = "Curve.finder()"

    def __copy__(self):
        other = _Handle.__copy__(self)
        other._made_of = self._made_of
        return other

    def __reduce__(self):
        self._memory()
        return _finder, (self._made_of[0],)


def _finder(curve):
    return curve.finder()


class Chain(_Handle):
    """Frames along a curve."""

    _made_by = "Curve.frame_chain()"
    __copy__ = Finder.__copy__

    def many(self, u):
        """(point, t, s, r) at many parameters."""
        u, memory = doubles(u, "u"), self._memory()
        arrays = [np.empty((u.size, 3)) for _ in range(4)]
        out = STRUCTS["bat_frame_arrays"](*[array.ctypes.data for array in arrays])
        check(lib.bat_frame_chain_many(ctypes.c_void_p(memory.address), ctypes.c_size_t(u.size), pointer(u), ctypes.byref(out)))
        return tuple(arrays)

    def __reduce__(self):
        self._memory()
        return _chain, self._made_of


def _chain(curve, options):
    return curve.frame_chain(**options)


class Shape(_Changing):
    """A curve with levels of detail over a base. Edits change it."""

    _made_by = "Curve.levels(levels), Curve.shape() and others"

    def _level_total(self):
        return self.levels

    def __copy__(self):
        return self.copy()

    def __deepcopy__(self, _):
        return self.copy()

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


class LiveShape(_Changing):
    """An edit of a shape while the pen is down."""

    _made_by = "Shape.live(level)"

    def _level_total(self):
        return self.shape().levels


class LiveSketch(_Changing):
    """A stroke over a curve while the pen is down."""

    _made_by = "Curve.live() and batten.live()"

    def add(self, *place):
        """Adds a sample: its coordinates."""
        if len(place) != self.dim:
            raise wrong("place", f"{self.dim} coordinates", len(place), "dimension")
        return self.add_many([[converted("double", one, "place") for one in place]])


for _kind in (Curve, Finder, Chain, Shape, LiveShape, LiveSketch):
    KINDS[_kind.__name__] = _kind
for _call in TABLE["calls"]:
    for _called in _call["names"]:
        _kind, _name = _called.replace("()", "").split(".")
        _name = snake(_name)
        _run, _is_property = method(_call, (_kind, _name))
        _made = property(_run) if _is_property and not _called.endswith("()") else _run
        if _kind == "b":
            globals()[_name] = _run
        elif _name in vars(KINDS[_kind]):
            setattr(KINDS[_kind], "_" + _name, _made)
            if not vars(KINDS[_kind])[_name].__doc__:
                vars(KINDS[_kind])[_name].__doc__ = DOCS[_call["c"]]
        else:
            setattr(KINDS[_kind], _name, _made)
globals().update({_one.__name__: _one for _one in RECORDS.values()} | RESULTS)
