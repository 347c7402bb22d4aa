"""Batten: B-spline curves that follow the pen.

Points are arrays of n rows, or flat with `dimension`. Arrays of float64 go in without a copy; results are numpy arrays that the
library has written. Each function is a C function of include/batten, and help() says what its header says. What cannot be done
raises a BattenError, which names the argument, what was expected and what was found.

A Curve, a Surface and a Mesh never change: they compare and hash by their numbers. A Shape, a Relief, a Camera, a Motion and a
Document change; they compare and hash by identity. All copy, and all but a Motion pickle. LiveSketch, LiveShape and Tessellation
are sessions; they do neither. All may be used from several threads, and after a fork.
"""
from . import _curves, _documents, _space
from ._call import LIBRARY, RESULTS, Report, method, snake  # noqa: F401: of the package
from ._documents import read_spline, read_stroke, read_svg
from ._library import DOCS, KINDS, RECORDS, TABLE, BattenError, lib  # noqa: F401: of the package
from ._space import mesh, surface, take

__version__ = lib.bat_version().decode()


def _attach(call, called):
    """Gives a call of the table its place: a function, a method or a property. What is written by hand stays, and finds it behind a _."""
    kind, name = called.replace("()", "").split(".")
    name = snake(name)
    run, is_property = method(call, (kind, name))
    if kind == "b":
        LIBRARY[name] = run
        return
    own = vars(KINDS[kind])
    setattr(KINDS[kind], "_" * (name in own) + name, property(run) if is_property and not called.endswith("()") else run)
    if name in own and not own[name].__doc__:
        own[name].__doc__ = DOCS[call["c"]]


KINDS.update({_name: next(vars(_part)[_name] for _part in (_curves, _space, _documents) if _name in vars(_part)) for _name in TABLE["classes"].values()})
for _row in TABLE["calls"]:
    for _called in _row["names"]:
        _attach(_row, _called)
for _one, _c in ((surface, "bat_surface_create"), (mesh, "bat_polymesh_create"), (take, "bat_take_create"), (KINDS["Relief"].add_level, "bat_relief_add_level"),
                 (KINDS["Binding"].apply, "bat_binding_apply")):
    _one.__doc__ = _one.__doc__ or DOCS[_c]
for _one in (*KINDS.values(), read_spline, read_stroke, read_svg, mesh, surface, take):
    _one.__module__ = "batten"
globals().update(KINDS | {_name: _one for _name, _one in LIBRARY.items() if _name[0] != "_"} | {_one.__name__: _one for _one in RECORDS.values()} | RESULTS)
__all__ = [_name for _name in globals() if _name[0] != "_" and getattr(globals()[_name], "__module__", "") == "batten"]


def __dir__():
    return [*__all__, "__version__"]
