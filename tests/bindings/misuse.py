"""Wrong things given to every function of the Python package: each argument of each call is replaced by each wrong value. What cannot
be right is refused by an error that names the argument; whatever else may happen, nothing else is raised and nothing crashes.
Usage: misuse.py ROOT LIBRARY.
"""
import copy
import inspect
import pathlib
import pickle
import shutil
import sys
import tempfile

import numpy as np


def things(batten):
    """One of each class, fresh."""
    x = np.linspace(0, 20, 41)
    curve = batten.fit(np.column_stack([x, np.sin(x)]), tolerance=0.01)
    square = batten.clamped([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], degree=1).close()
    shape = curve.levels(2)
    live = curve.live()
    live.add_many(np.column_stack([x[9:30], np.sin(x[9:30]) + 0.1]))
    return {"Curve": curve, "Closed": square, "Finder": curve.finder(), "Chain": curve.frame_chain(), "Shape": shape,
            "LiveShape": shape.live(0), "LiveSketch": live, "b": batten}


def samples(made):
    """A right value for each argument, by its name; with the function before it where a name has several meanings."""
    curve, x = made["Curve"], np.linspace(0, 20, 41)
    wave = np.column_stack([x, np.sin(x)])
    middle = float(curve.domain.mean())
    return {"u": middle, "order": 1, "at_many.u": [middle], "points": wave, "knots": [middle], "curve.knots": np.r_[0, 0, 0, np.arange(39.0), 38, 38, 38],
            "refine.knots": np.sort(np.r_[curve.knots, middle]), "add_level.knots": None, "degree": 4, "curve.degree": 3, "clamped.degree": 3,
            "fit.degree": 3, "from_bezier.points": wave[:40], "closed": False, "spline": wave[::8], "dimension": 2, "b": curve, "count": 5,
            "arguments": [middle] * curve.degree, "matrix": [1, 0, 1, 0, 1, 1], "times": 1, "tolerance": 0.5, "start": 1.0, "end": 2.0, "delta": [0.1, 0.1], "drag.u": middle,
            "Curve.drag.u": [middle], "index": 2, "s": 1.0, "point": [1, 2], "per_span": 4, "steps": 3, "precision": 0.01, "distance": 0.1, "operation": "union",
            "regions": [made["Closed"], [made["Closed"]]], "ends": [[1, 0], [1, 0]], "framesAt.u": [middle], "frames_at.u": [middle], "stroke": wave[9:30],
            "samples": wave[:3], "range": [middle - 1, middle + 1], "limit": 0.1, "kind": "smooth", "live.kind": "new", "c0": [1, 0], "c1": [0, 1], "direction": [1, 1],
            "level": 1, "level0.level": 0, "left": True, "deltas": [[0.1, 0]], "first": 0, "muted": True, "gain": 1.5, "targets": [wave[20]], "Shape.sketch.u": [middle],
            "levels": 2, "coarsest": 8, "onto": made["Curve"], "rule": "rmf", "n": 5, "decimals": 2, "continuity": 0, "gap": 100.0,
            "place": 1.0, "many.u": [middle]}


class Odd:
    def __array__(self, *_, **__):
        raise RuntimeError("odd")

    def __float__(self):
        raise RuntimeError("odd")


def wrong_values(batten):
    freed = batten.clamped([[0, 0], [1, 1]], degree=1)
    freed.free()
    never = [object(), Odd(), "zzz", b"zzz", 1j, {"a": 1}, np.ma.array([[1.0, 2]], mask=[[True, False]]), np.array("x"), np.array([1j, 2]), lambda: 0,
             np.datetime64("2020-01-01"), np.zeros((2, 2, 2)), {1, 2}, np.nan, float("-inf"), [[1, 2], [3]], [np.nan, 1.0], [[np.inf, 0.0]], 10**400, freed, [freed]]
    perhaps = [None, [], [[]], [None], 0, -1, 0.5, 1e300, -1e300, 2**31, 2**63, 1e8, True, "", [1.0], [1, 2, 3], np.zeros((0, 2)), np.zeros((3, 5)), np.float32(1), np.int8(-3),
               [[1e300, 1e300], [-1e300, 0]], [0] * 50, [[0, 0]] * 50, np.arange(40)[::-1], [10**400], float("inf"), 5e-324]
    return never, perhaps


def tried(call, allowed, faults, what):
    """The error of a call, or None."""
    try:
        call()
    except allowed as error:
        return error
    except Exception as error:  # noqa: BLE001: this is what must not be
        faults.append(f"{what}: {type(error).__name__}: {error}")
    return None


def table(batten):
    """(how many calls, faults)."""
    faults, count, worked = [], 0, 0
    allowed = (batten.BattenError, TypeError)
    names = [(kind, name, hand) for kind, hand in [(kind, getattr(batten, kind)) for kind in ("Curve", "Finder", "Chain", "Shape", "LiveShape", "LiveSketch")] for name in dir(hand)]
    calls = [(kind, name, getattr(hand, name)) for kind, name, hand in names if not name.startswith("_") and inspect.isfunction(getattr(hand, name)) and name not in ("free", "add")]
    calls += [("b", name, one) for name, one in vars(batten).items() if inspect.isfunction(one) and getattr(one, "__signature__", None) and not name.startswith("_")]
    never, perhaps = wrong_values(batten)
    for kind, name, function in calls:
        made = things(batten)
        right = samples(made)
        if name == "close":
            made["Curve"] = batten.clamped([[0, 0], [1, 0], [1, 1], [0, 0]])
        if name == "join":
            ends = made["Curve"].at_many(made["Curve"].domain)
            right["b"] = made["Curve"].transform([1, 0, ends[1, 0] - ends[0, 0], 0, 1, ends[1, 1] - ends[0, 1]])
        if name == "open_at" or name == "move_seam":
            made["Curve"] = made["Closed"]
            right["u"] = 0.5
        if kind == "Shape" and name == "live" or kind == "LiveShape":
            right["level"] = 0

        def value(argument, kind=kind, name=name, right=right):
            return next((right[key] for key in (f"{kind}.{name}.{argument}", f"{name}.{argument}", argument) if key in right), None)

        parameters = inspect.signature(function).parameters.values()
        required = [p.name for p in parameters if p.kind == p.POSITIONAL_OR_KEYWORD and p.name != "self" and p.default is p.empty]
        others = [p.name for p in parameters if p.kind == p.KEYWORD_ONLY or p.kind == p.POSITIONAL_OR_KEYWORD and p.default is not p.empty]

        def run(options, kind=kind, name=name, required=required):
            given = {one: value(one) for one in required} | options
            target = things(batten)[kind] if kind in ("LiveShape", "LiveSketch") else made[kind]
            return getattr(target, name)(**given)

        try:
            run({})
            worked += 1
        except Exception as error:  # noqa: BLE001: named below
            faults.append(f"{kind}.{name} does not work at all: {error}")
        for argument in [*required, *others]:
            for wrong in [*never, *perhaps]:
                count += 1
                what = f"{kind}.{name}({argument}={type(wrong).__name__} {str(wrong)[:40]!r})"
                error = tried(lambda: run({argument: wrong}), allowed, faults, what)  # noqa: B023: called at once
                if any(wrong is one for one in never) and (error is None or argument not in str(error)):
                    faults.append(f"{what}: {'taken in silence' if error is None else error}")
    for name, thing in things(batten).items():
        if name != "b":
            count += ended(batten, name, faults)
            tried(lambda: type(thing)(1, 2), TypeError, faults, f"{name}(1, 2)")  # noqa: B023
            tried(lambda: setattr(thing, "dim", 7), AttributeError, faults, f"{name}.dim = 7")  # noqa: B023
    if worked < 90:
        faults.append(f"only {worked} calls were tried")
    return count, faults


def ended(batten, name, faults):
    """Whatever is asked of what has been freed is an error that says so."""
    thing = things(batten)[name]
    right = samples(things(batten))
    thing.free()
    thing.free()
    repr(thing)
    asked = [lambda: copy.copy(thing), lambda: copy.deepcopy(thing), lambda: pickle.dumps(thing)]
    for one in dir(type(thing)):
        found = inspect.getattr_static(type(thing), one)
        if one.startswith("_") or one in ("free", "dim", "report"):
            continue
        if isinstance(found, property):
            asked.append(lambda one=one: getattr(thing, one))
        elif inspect.isfunction(found):
            required = [p.name for p in inspect.signature(found).parameters.values() if p.kind == p.POSITIONAL_OR_KEYWORD and p.name != "self" and p.default is p.empty]
            asked.append(lambda one=one, required=required: getattr(thing, one)(*[right.get(f"{type(thing).__name__}.{one}.{name_}", right.get(f"{one}.{name_}", right.get(name_))) for name_ in required]))
    for call in asked:
        error = tried(call, (batten.BattenError, TypeError), faults, f"{name}, freed")
        if error is None or not ("freed" in str(error) or "cannot be copied" in str(error) or "place" in str(error)):
            faults.append(f"{name}, freed: {call.__defaults__}: {error or 'taken in silence'}")
    return len(asked)


if __name__ == "__main__":
    root, place = pathlib.Path(sys.argv[1]).resolve(), tempfile.TemporaryDirectory()
    sys.path[:0] = [place.name, str(root / "bindings/python")]
    import backend
    shutil.copytree(root / "bindings/python/batten", f"{place.name}/batten")
    for path, text in backend.made(pathlib.Path(place.name) / "made").items():
        pathlib.Path(place.name, path).write_bytes(text)
    shutil.copy(sys.argv[2], f"{place.name}/batten/libbatten.so")
    import batten as package
    tries, found = table(package)
    print(*found, sep="\n")
    print(f"{tries} wrong things, {len(found)} faults")
    sys.exit(bool(found) or tries < 5000)
