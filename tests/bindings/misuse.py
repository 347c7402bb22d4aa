"""Wrong things given to every function of the Python package: each argument of each call is replaced by each wrong value. What cannot
be right is refused by an error that names the argument; whatever else may happen, nothing else is raised and nothing crashes. The same
for the C function below it, past what Python has looked at: each argument becomes NULL, a number of no range, an array or a struct
with one in it. Usage: misuse.py ROOT LIBRARY.
"""
import copy
import ctypes
import inspect
import os
import pathlib
import pickle
import shutil
import signal
import sys
import tempfile

import numpy as np


VIEW = {"eye": [10, -50, 30], "target": [10, 0, 1.5], "fov": 40}
BONES = [{"name": "hip", "parent": -1, "offset": [0, 0, 0], "channels": ["x_position", "z_rotation", "x_rotation", "y_rotation"]},
         {"name": "leg", "parent": 0, "offset": [0, -1, 0], "channels": ["z_rotation", "x_rotation"]}, {"name": "foot", "parent": 1, "end": True, "offset": [0, -1, 0]}]
TURNS = [[0, 0, 0.1 * i, 1] for i in range(6)]
PNG = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\2\0\0\0\3\x08\2\0\0\0" + bytes(20)
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9" viewBox="0 0 9 9"><path d="M0 0L9 0L9 9Z"/><text>a</text></svg>'
CLASSES = ("Curve", "Finder", "Chain", "Shape", "LiveShape", "LiveSketch", "Surface", "SurfaceFinder", "Tessellation", "Relief", "Sweep", "Mesh", "Reference",
           "Binding", "Tracks", "LineDrawing", "Camera", "Take", "Motion", "Picture", "Object", "Document")
ANEW = {"LiveShape": lambda made: made["Shape"].live(0), "LiveSketch": lambda made: sketched(made["Curve"]), "Tessellation": lambda made: made["Surface"].tessellate(),
        **dict.fromkeys(("Shape", "Relief", "Camera", "Motion", "Document"), None)}  # what a call changes is made, or copied, for each call


def sketched(curve):
    x, live = np.linspace(0, 20, 41)[9:30], curve.live()
    return live.add_many(np.column_stack([x, np.sin(x) + 0.1]))


def things(batten):
    """One of each class, fresh."""
    x = np.linspace(0, 20, 41)
    curve = batten.fit(np.column_stack([x, np.sin(x)]), tolerance=0.01)
    square = batten.clamped([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], degree=1).close()
    shape = curve.levels(2)
    space = curve.to_dimension(3)
    sections = [space.transform([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, height]) for height in range(4)]
    surface, take = batten.loft(sections), batten.take(BONES, np.random.default_rng(1).uniform(-20, 20, (20, 6)), 0.05)
    document, camera = batten.document(), space.camera(base={"degree": 3, "points": TURNS, "knots": [0, 0, 0, 0, 1, 2, 3, 3, 3, 3]})
    document.add(batten.path_object([square]))
    camera.add_shake(7, 0.1, 2.0)
    return {"Curve": curve, "Closed": square, "Space": space, "Sections": sections, "Finder": curve.finder(), "Chain": curve.frame_chain(), "Shape": shape,
            "LiveShape": shape.live(0), "LiveSketch": sketched(curve), "Surface": surface, "SurfaceFinder": surface.finder(), "Tessellation": surface.tessellate(),
            "Relief": surface.levels(1), "Sweep": space.sweep(batten.clamped([[-0.1, 0], [0, 0.1], [0.1, 0]], degree=2)),
            "Mesh": batten.mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1]], [[0, 1, 2], [0, 2, 3]]), "Reference": batten.reference(curves=[space]),
            "Binding": batten.bind([{"reference": space, "radius": 3.0}], surface.points.reshape(-1, 3)), "Tracks": surface.section([0, 0, 1.5], [0, 0, 1]),
            "LineDrawing": batten.line_drawing(VIEW, [surface]), "Camera": camera, "Take": take, "Motion": take.motion(), "Picture": batten.picture(PNG),
            "Object": document.at(0), "Document": document, "b": batten}


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
            "place": 1.0, "many.u": [middle], **more(made, wave, middle)}


def more(made, wave, middle):
    """The same for what there is beside curves."""
    surface, space, b = made["Surface"], made["Space"], made["b"]
    return {"v": 0.5, "at_grid.u": [middle], "at_grid.v": [0.5], "normal_grid.u": [middle], "normal_grid.v": [0.5], "direction": "u", "tangents_k.direction": [1, 1],
            "hits.origin": [5, 0, 1.5], "hits.direction": [0, 1, 0], "origin": [0, 0, 1.5], "revolve.direction": [1, 0, 0], "revolve.origin": [0, -5, 0], "normal": [0, 0, 1],
            "Surface.nearest.point": [1, 2, 3], "SurfaceFinder.nearest.point": [1, 2, 3], "Reference.nearest.point": [1, 2, 3], "view_project.point": [1, 2, 3],
            "Surface.isocurve.at": 0.5, "Surface.refine.knots": np.sort(np.r_[surface.knots("u"), middle]), "Surface.transform.matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
            "Relief.transform.matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], "Surface.redraw.direction": "v", "Surface.redraw.at": 0.5, "Surface.redraw.line": surface.isocurve("v", 0.5),
            "Surface.sketch.direction": "v", "Surface.sketch.at": 1 / 3, "view": VIEW, "Surface.sketch.stroke": strokes(b, surface.isocurve("v", 1 / 3)),
            "Surface.pick_line.marking": strokes(b, surface.isocurve("v", 1 / 3)), "Surface.intersect.b": surface, "Surface.is_equal.b": surface, "Mesh.is_equal.b": made["Mesh"],
            "Surface.levels.levels": 1, "Surface.levels_to.levels": 1, "Surface.levels_to.coarsest": [12, 4], "surface": surface, "moved": [1, 2], "reference": made["Reference"],
            "Relief.move.index": [0], "Relief.move.deltas": [[0, 0, 1]], "Relief.drag.delta": [0, 0, 0.1], "Relief.drag_finest.delta": [0, 0, 0.1], "Relief.redraw.level": 0,
            "Relief.redraw.direction": "v", "Relief.redraw.at": 0.5, "Relief.redraw.line": made["Relief"].surface(0).isocurve("v", 0.5), "Relief.copy_levels.onto": surface,
            "profile": b.clamped([[-0.1, 0], [0, 0.1], [0.1, 0]], degree=2), "sides": [b.clamped(one) for one in QUAD], "sections": made["Sections"], "recipe": {"kind": "loft"},
            "recipe_surface.curves": made["Sections"], "check_recipe.count": 3, "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1]], "curves": [made["Closed"]],
            "Binding.apply.curves": [space], "surfaces": [surface], "meshes": [made["Mesh"]], "edges": [[0, 1]], "wires": [{"reference": space, "radius": 3.0}],
            "bind.points": np.zeros((4, 3)), "i": 0, "scene": [surface], "pixel": [100, 200], "cast.view": {**VIEW, "eye": [0, 0, 50], "up": [0, 1, 0]}, "cast.stroke": wave + 300,
            "canvas": {"normal": [0, 0, 1]}, "path": space, "Camera.add_level.knots": [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], "details": np.zeros((6, 3)), "seed": 7, "amount": 0.1, "rate": 2.0,
            "Camera.take_levels.other": made["Camera"], "duration": 3.0, "retime.points": [[0, 0], [0.5, 0.2], [1, 1]], "rotation": [0, 0, 0, 1], "Camera.turn.level": 1, "key": 1,
            "degrees": 50.0, "target": [1, 2, 3], "up": [0, 0, 1], "time": 0.3, "times": [0.0, 1.0], "insert_knot.times": 1, "remove_knot.times": 1, "pose": made["Camera"].at(middle),
            "size": [800, 600], "keys.place": 0.1, "keys.angle": 0.01, "values": [3.0, 1.0, 2.0], "frame": 3, "joint": 1, "angle": 0, "revolve.angle": 1.0, "Motion.set_gain.level": 1,
            "Motion.redraw.level": 0, "Motion.redraw.points": [[0.1, 5], [0.2, 6], [0.3, 5]], "Motion.bend.path": space, "Motion.take_style.other": made["Motion"],
            "picture": made["Picture"], "matrix": [1, 0, 1, 0, 1, 1], "Curve.transform.matrix": [1, 0, 1, 0, 1, 1], "axis": 0, "at": 3.0, "axes": [1, 0, 0, 0, 1, 0],
            "plane_object.origin": [0, 0, 0], "Object.bind.wires": [{"reference": space, "radius": 1.0}], "sources": [b.path_object([one], id=i + 50) for i, one in enumerate(made["Sections"])], "mesh": made["Mesh"], "relief": made["Relief"],
            "camera": made["Camera"], "motion": made["Motion"], "seconds": 0.3, "parent": 0, "name": "a", "id": 1, "curve": made["Closed"], "shape": made["Closed"].shape(), "style": {},
            "paint": {"dashes": [1, 2]}, "index": 2, "Object.bind.curves": [b.path_object([space], id=7)], "Object.with_matrix.matrix": [1, 0, 0, 1, 0, 0],
            "image_object.matrix": [1, 0, 0, 1, 0, 0], "foreign_object.matrix": [1, 0, 0, 1, 0, 0], "foreign_object.picture": b.picture(SVG.encode()), "Object.curve.index": 0, "Object.shape.index": 0, "Object.with_curve.index": 0, "Object.with_shape.index": 0, "cover.curve": 0,
            "Document.at.index": 0, "Document.insert.index": 1, "Document.insert.object": b.guide_object(0, 1.0, id=9), "Document.replace.index": 0,
            "Document.replace.object": b.path_object([made["Closed"]], id=1), "Document.remove.index": 0, "Document.end.index": 0, "page": [0, 0, 10, 10], "millimetres": 2.0, "unit": "mm",
            "object": made["Object"], "glyph": made["Document"].to_glif(), "text": "{}", "read_svg.text": SVG, "model": [surface, made["Mesh"]], "write_model.model": [surface],
            "losses": {"count": [1] * 32}, "lossKind": "text", "loss_key.kind": "text", "report": made["Motion"].report, "Camera.to_gltf_scene.scene": [surface], "line_drawing.scene": [surface],
            "region": made["Closed"], "offset_region.distance": 0.1, "offset_region.tolerance": 0.01, "nib": {"width": 0.3}, "outline_width.profile": [(0, 1), (1, 0.2)], "cover_width.profile": [(0, 1), (1, 0.2)],
            "check_widths.profile": [(0, 1)], "width_at.profile": [(0, 1)], "width_is_even.profile": [(0, 1)], "width_at.at": 0.5, "function": 3.0, "x": 0.5, "bytes": PNG,
            "read_document.text": made["Document"].write(), "read_curve.text": made["Curve"].write(), "read_surface.text": surface.write(), "read_mesh.text": made["Mesh"].write(),
            "read_model.text": surface.write(), "read_obj.text": b.write_obj(surface), "read_iges.text": b.write_iges(surface), "read_step.text": b.write_step(surface),
            "read_bvh.text": made["Take"].to_bvh(), "read_view.text": b.write_view(VIEW), "read_canvas.text": '{"plane":{"origin":[0,0,0],"normal":[0,0,1]}}',
            "read_camera.text": made["Camera"].write(), "read_points.text": "1 2\n3 4\n", "read_stroke.text": "x,y\n1,2\n3,4\n",
            "read_spline.text": '{"points":[[0,0],[1,1]]}', "read_shape.text": made["Shape"].write(), "edit.text": "[]", "read_relief.text": made["Relief"].write(),
            "read_sweep.text": f'{{"path":{space.write()},"profile":{b.clamped([[0, 0], [0, 1]], degree=1).write()}}}',
            "read_wires.text": f'{{"wires":[{{"reference":{space.write()},"radius":3,"curve":{space.write()}}}]}}',
            "surface.points": surface.points, "u_knots": None, "v_knots": None, "surface.u_knots": surface.knots("u"), "surface.v_knots": surface.knots("v"),
            "surface.degree": (surface.degree("u"), surface.degree("v")), "faces": [[0, 1, 2]], "joints": BONES, "take.values": np.zeros((3, 6)), "frame_time": 0.1,
            "side": "u1", "Surface.blend.other": surface, "Surface.match.other": surface, "Surface.blend_to_curve.curve": space, "other_side": "u0", "Sweep.surface.tolerance": 0.05, "Relief.drag.level": 1, "Object.with_guide.at": 1.0}


QUAD = ([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 3, 0], [1, 3, 1], [2, 3, 0], [3, 3, 0]], [[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0]], [[3, 0, 0], [3, 1, 0], [3, 2, 1], [3, 3, 0]])


def strokes(b, line):
    """A line of a surface as it is seen."""
    return [b.view_project(VIEW, place).pixel for place in line.at_many(np.linspace(*line.domain, 40))]


MANY = ("flatten.tolerance", "section.tolerance", "cover_width.tolerance", *(f"{name}.{what}" for name in ("keys", "to_gltf", "to_gltf_scene") for what in ("place", "angle")))  # refused after a million pieces
TEXTS = ("text", "name", "up", "down", "glyph", "bytes")
UNNAMED = ("Curve.calm(limit", "Curve.calm(pixel", "Curve.reparametrise(end", "Surface.sketch(at")  # refused for what they do to the rest
NEEDED = {"Curve.camera": {"mode": "along"}}  # options without which there is nothing to do
SPACE = ("sweep", "revolve", "camera", "stands")


def object_for(batten, made, name):
    """An object that the call can do something with."""
    kinds = {"with_matrix": lambda: batten.image_object(made["Picture"], [1, 0, 0, 1, 0, 0]), "with_guide": lambda: batten.guide_object(0, 1.0),
             "with_spline": lambda: batten.spline_object([[0, 0], [1, 1], [2, 0]]), "to_path": lambda: batten.spline_object([[0, 0], [1, 1], [2, 0]]),
             "with_motion": lambda: batten.skeleton_object(made["Motion"]), "at_time": lambda: batten.skeleton_object(made["Motion"]),
             "with_camera": lambda: batten.camera_object(made["Camera"]), "cover": lambda: batten.path_object([made["Curve"]]).with_paint({"widths": [(0, 1), (1, 0.2)]}),
             "unbind": lambda: batten.path_object([made["Space"]], id=2).bind([{"reference": made["Space"], "radius": 1.0}], [batten.path_object([made["Space"]])]),
             **dict.fromkeys(("with_surface", "with_relief", "with_recipe"), lambda: batten.surface_object(made["Surface"]))}
    return kinds.get(name, lambda: made["Object"])()


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


class Case:
    """A function, what it is called on, and right arguments."""

    def __init__(self, batten, kind, name, function):
        self.kind, self.name, self.made = kind, name, things(batten)
        made, right = self.made, samples(self.made)
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
        if name in SPACE:
            made["Curve"] = made["Space"]
        if kind == "Object":
            made["Object"] = object_for(batten, made, name)
        if name == "to_svg_kept":
            made["Document"] = batten.read_svg(SVG)
        parameters = inspect.signature(function).parameters.values()
        self.required = [p.name for p in parameters if p.kind == p.POSITIONAL_OR_KEYWORD and p.name != "self" and p.default is p.empty]
        self.others = [p.name for p in parameters if p.kind == p.KEYWORD_ONLY or p.kind == p.POSITIONAL_OR_KEYWORD and p.default is not p.empty]
        self.given = {one: next((right[key] for key in (f"{kind}.{name}.{one}", f"{name}.{one}", one) if key in right), None) for one in self.required}
        self.given |= NEEDED.get(f"{kind}.{name}", {}) | ({"curves": [made["Space"]]} if name == "reference" else {})

    def run(self, options):
        made, kind = self.made, self.kind
        target = made[kind] if kind not in ANEW else ANEW[kind](made) if ANEW[kind] else made[kind].copy()
        return getattr(target, self.name)(**self.given | options)


def functions(batten):
    """(class or b, name, function) of all that the package has."""
    names = [(kind, name, hand) for kind, hand in [(kind, getattr(batten, kind)) for kind in CLASSES] for name in dir(hand)]
    calls = [(kind, name, getattr(hand, name)) for kind, name, hand in names if not name.startswith("_") and inspect.isfunction(getattr(hand, name)) and name not in ("free", "add")]
    return calls + [("b", name, one) for name, one in vars(batten).items() if inspect.isfunction(one) and one.__module__ == "batten" and not name.startswith("_")
                    and name != "read_svg"]


def table(batten):
    """(how many calls, faults)."""
    faults, count, worked = [], 0, 0
    allowed = (batten.BattenError, TypeError)
    never, perhaps = wrong_values(batten)
    for kind, name, function in functions(batten):
        case = Case(batten, kind, name, function)
        try:
            case.run({})
            worked += 1
        except Exception as error:  # noqa: BLE001: named below
            faults.append(f"{kind}.{name} does not work at all: {error}")
        for argument in [*case.required, *case.others]:
            values = [*never, *perhaps]
            for wrong in values if kind in CLASSES[:6] else values[len(name + argument) % 3::3]:
                if f"{name}.{argument}" in MANY and isinstance(wrong, float) and 0 < wrong < 1e-9:
                    continue
                count += 1
                what = f"{kind}.{name}({argument}={type(wrong).__name__} {str(wrong)[:40]!r})"
                error = tried(lambda: case.run({argument: wrong}), allowed, faults, what)  # noqa: B023: called at once
                beyond = isinstance(wrong, (int, float, np.int8)) and not isinstance(wrong, bool) and (wrong < 0 or wrong == 1e300)
                if beyond and isinstance(error, batten.BattenError) and argument not in str(error).split(" (")[0] and f"{kind}.{name}({argument}" not in UNNAMED:
                    faults.append(f"{what}: does not name it: {error}")
                if any(wrong is one for one in never) and not (argument in TEXTS and isinstance(wrong, (str, bytes))) and (error is None or argument not in str(error)):
                    faults.append(f"{what}: {'taken in silence' if error is None else error}")
    for name, thing in things(batten).items():
        if name in CLASSES:
            count += ended(batten, name, faults)
            tried(lambda: type(thing)(1, 2), TypeError, faults, f"{name}(1, 2)")  # noqa: B023
            tried(lambda: setattr(thing, "dim", 7), AttributeError, faults, f"{name}.dim = 7")  # noqa: B023
    if worked < 300:
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


REALS = (np.nan, np.inf, -1e300, -1.0, 0.0, 5e-324, 1e300)
SECONDS = 60  # that one call may take
WHOLES = (-2**31, -1, 0, 8, 2**31 - 1)


class Below:
    """Calls of C, one argument of which is another than what the package has made of the right ones."""

    def __init__(self):
        module = sys.modules["batten._call"]
        self.call, self.argument, self.ranges = module.Call, module.Call.argument, module.TABLE["rules"]["ranges"]
        self.seen, self.aim = [], None

    def __enter__(self):
        def argument(call, word):
            before = len(call.kept)
            value = self.argument(call, word)
            if self.aim is None:
                self.seen += [(call.plan, word, change) for change in self.changes(call, word, call.kept[before:])]
            elif self.aim[:2] == (call.plan, word):
                return self.changed(call, value, call.kept[before:])
            return value
        self.call.argument = argument
        return self

    def __exit__(self, *_):
        self.call.argument = self.argument

    def changes(self, call, word, kept):
        """What is to be tried: ("is", value), ("at", place, value) of an array, or ("of", member, value) of a struct. Never a count
        that is more than there is."""
        status, sized = call.plan.returns == "bat_status", {n for w in call.plan.words if w.kind == "result" for n in compiled_names(w.formula)}
        double, pointer = word.bare == "double", call.plan.c_type(word) is ctypes.c_void_p
        found = [("is", None)] if pointer and status else []
        if word.kind in ("count", "room", "dim", "follows"):
            found += [("is", value) for value in WHOLES[:3] if value == 0 or word.bare == "int"]
        elif word.kind == "scalar" and not pointer:
            bounded = word.name not in sized or status and f"{call.plan.c}.{word.name}" in self.ranges
            found += [("is", value) for value in (REALS if double else (False, True) if word.bare == "bool" else (0,) if word.bare == "size_t" else
                                                  [w for w in WHOLES if w <= 0 or bounded and w > 8])
                      if not (double and f"{call.plan.name}.{word.name}" in MANY and 0 <= value < 1e-9)]
        for one in kept:
            if isinstance(one, np.ndarray) and one.size and one.dtype == float and word.kind == "array":
                found += [("at", place, value) for place in (0, -1) for value in (np.nan, -np.inf, 1e300, -1.0)]
            if isinstance(one, ctypes.Structure):
                found += [("of", name, value) for name, kind in one._fields_ if name != "size" for value in
                          (REALS if kind is ctypes.c_double else (None,) if kind is ctypes.c_void_p and status else
                           (-2**31, -1, 0, 2**31 - 1) if kind is ctypes.c_int and "count" not in name and "room" not in name else ())]
        return found

    def changed(self, call, value, kept):
        how, *what = self.aim[2]
        if how == "is":
            return what[0]
        for one in kept:
            if how == "at" and isinstance(one, np.ndarray):
                call.kept.append(one.copy())
                call.kept[-1].reshape(-1)[what[0]] = what[1]
                return call.kept[-1].ctypes.data_as(ctypes.c_void_p)
            if how == "of" and isinstance(one, ctypes.Structure) and what[0] in dict(one._fields_):
                setattr(one, *what)
        return value


def compiled_names(formula):
    return [] if formula is None else [part for part in formula.replace("(", " ").replace(")", " ").replace("*", " ").replace("+", " ").split()]


def below(batten):
    """(how many calls of C, of how many functions, faults). Each function has a process, which another goes on for when it ends."""
    faults, count, done = [], 0, set()
    for kind, name, function in functions(batten):
        case = Case(batten, kind, name, function)
        with Below() as hook:
            options = {"order": 1} if "order" in case.others else {}
            try:
                case.run(options)
            except Exception:  # noqa: BLE001: the table above says so
                continue
            aims = list({described(aim): aim for aim in hook.seen if aim[0].c not in done}.values())
            done |= {aim[0].c for aim in aims}
            first = 0
            while first < len(aims):
                reader, writer = os.pipe()
                child = os.fork()
                if not child:
                    judged(batten, case, hook, aims, first, options, writer)
                os.close(writer)
                with os.fdopen(reader, "rb") as told:
                    lines = told.read().decode().splitlines()
                ended_ = os.waitpid(child, 0)[1]
                last = int(lines[-1].split(" ", 1)[0]) if lines else first
                faults += [line.split(" ", 1)[1] for line in lines if " " in line]
                if ended_:
                    faults.append(f"{described(aims[last])}: ended by {ended_}")
                count += last + 1 - first
                first = last + 1
    return count, len(done), faults


def described(aim):
    return f"{aim[0].c}({aim[1].kind} {aim[1].name or aim[1].formula}: {aim[2]})"


def judged(batten, case, hook, aims, first, options, writer):
    """In a process of its own: says each time what it begins with."""
    for i, aim in enumerate(aims[first:], first):
        os.write(writer, f"{i}\n".encode())
        hook.aim, error = aim, None
        signal.alarm(SECONDS)
        try:
            case.run(options)
        except Exception as raised:  # noqa: BLE001: what the package makes of a result that it did not ask for
            error = raised
        if aim[1].kind == "self" and not isinstance(error, batten.BattenError):
            os.write(writer, f"{i} {described(aim)}: {error or 'taken in silence'}\n".encode())
    os._exit(0)


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
    deep, functions_of_c, faults_of_c = below(package)
    print(*found, *faults_of_c, sep="\n")
    print(f"{tries} wrong things in Python, {len(found)} faults; {deep} in {functions_of_c} functions of C, {len(faults_of_c)} faults")
    sys.exit(bool(found or faults_of_c) or tries < 20000 or deep < 3500)
