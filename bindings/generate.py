#!/usr/bin/env python3
"""Reads calls.txt and the public headers, and writes what the packages are made from.

Usage: generate.py ROOT OUT. In OUT: calls.json (the calls, structs and enums; offsets for wasm32) and its two parts, core.json
(what the small npm modules have) and more.json; exports.txt (the C functions), layout.c (asserts that a compiler for wasm32 lays
structs out as calls.json says), docs.json (what the headers say of each function, struct and member).
"""
import json
import pathlib
import re
import sys

CORE = {"bat_curve": "Curve", "bat_finder": "Finder", "bat_frame_chain": "Chain", "bat_shape": "Shape",
        "bat_shape_live": "LiveShape", "bat_sketch_live": "LiveSketch"}  # the classes of the small npm modules
CLASSES = CORE | {
    "bat_surface": "Surface", "bat_surface_finder": "SurfaceFinder", "bat_tessellation": "Tessellation", "bat_relief": "Relief",
    "bat_sweep": "Sweep", "bat_polymesh": "Mesh", "bat_reference": "Reference", "bat_binding": "Binding", "bat_tracks": "Tracks",
    "bat_line_drawing": "LineDrawing", "bat_camera": "Camera", "bat_take": "Take", "bat_motion": "Motion",
    "bat_picture": "Picture", "bat_object": "Object", "bat_document": "Document"}
SHARED = ("bat_object", "bat_picture")  # whose users are counted
SCALARS = {"double": 8, "int": 4, "size_t": 4, "bool": 1, "char": 1, "float": 4, "uint32_t": 4, "uint64_t": 8, "bat_id": 8}  # sizes on wasm32, which are the alignments too
FREES = {name: f"{c}_{'cancel' if c.endswith('_live') else 'release' if c in SHARED else 'free'}" for c, name in CLASSES.items()}
# Called by hand-written parts of the packages.
ALSO_CORE = ["bat_free", "bat_version", "bat_status_message", "bat_meeting_free", "bat_frame_chain_many"]
ALSO = [*FREES.values(), *ALSO_CORE, *(c + "_retain" for c in SHARED), "bat_surface_row", "bat_tessellation_mesh", "bat_tracks_points",
        "bat_line_drawing_at", "bat_motion_take", "bat_picture_bytes", "bat_object_corners", "bat_object_guide", "bat_object_sources",
        "bat_object_spline", "bat_stroke_read", "bat_spline_read", "bat_style_defaults", "bat_svg_reader_create", "bat_svg_reader_start",
        "bat_svg_reader_text", "bat_svg_reader_end", "bat_svg_reader_source", "bat_svg_reader_finish", "bat_svg_reader_free"]
READ = ["bat_frame_arrays", "bat_mesh", "bat_seen_line", "bat_svg_options", "bat_svg_report", "bat_problem"]  # structs of these
# What both packages know of arguments, beside their types.
RULES = {
    "checked": {"bat_width_eval": "bat_width_check", "bat_width_is_even": "bat_width_check", "bat_function_eval": "bat_function_check"},
    # Which call takes the same arguments, and a problem in place of the result, and says what is wrong; and which says it of a struct.
    "explained": {"bat_curve_create": "bat_curve_check", "bat_curve_create_clamped": "bat_curve_clamped_check", "bat_surface_create": "bat_surface_check",
                  "bat_polymesh_create": "bat_polymesh_check", "bat_take_create": "bat_take_check", "bat_picture_create": "bat_picture_check"},
    "explained_struct": {"bat_style": "bat_style_check", "bat_paint": "bat_paint_check", "bat_viewpoint": "bat_viewpoint_check",
                         "bat_width_profile": "bat_width_check", "bat_function": "bat_function_check"},
    # What a call that was refused may have been refused for, by its name and the argument's, or the argument's alone: from, to, and whether
    # the first is out. Any other number lies within 1e75. start, end: of the domain; a word: what the object has; "-" takes one off.
    "ranges": {
        "tolerance": [0, 1e75], "corner": [0, 1e75], "limit": [0, 1e75, True], "pixel": [0, 1e75, True], "duration": [0, 1e75, True], "spacing": [0, 1e75],
        "precision": [0, 1e75, True], "width": [0, 1e75], "smooth_limit": [0, 1e75], "fairness": [0, 1e75, True], "tension": [0, 1e75, True], "within": [0, 1e75],
        "gap": [0, 1e75], "grid": [0, 1e75], "chord": [0, 1e75], "leaf": [0, 1e75], "reach": [0, 1e75], "distance": [-1e75, 1e75], "miter_limit": [1, 1e75],
        "opacity": [0, 1], "axis": [0, 1], "fov": [0, 180], "id": [1, 0x7fffffff], "parent": [0, 0x7fffffff], "follows": [0, 0x7fffffff], "degree": [1, 7],
        "millimetres": [1e-12, 1e12], "frame_time": [0, 1e9, True], "smoothing": [0, 1e75], "feed": [0, 1e75, True], "arcs": [0, 1e75, True], "rate": [0, 1e75, True],
        "pins": [2, 1 << 20], "u": ["start", "end"], "u0": ["start", "end"], "u1": ["start", "end"], "start": ["start", "end"], "end": ["start", "end"],
        "level": [0, "level_total"], "index": [0, "count-"], "first": [0, "count-"], "i": [0, "count-"], "joint": [0, "joint_count-"], "frame": [0, "frames-"],
        "continuity": [0, 3], "levels": [1, 64], "coarsest": [2, 1e9],
        **{f"bat_{name}.tolerance": [0, 1e75, True] for name in (
            "curve_arcs", "curve_cover_width", "curve_flatten", "curve_intersect", "curve_self_intersect", "curve_offset", "curve_outline",
            "curve_outline_width", "curve_refit_extremes", "surface_revolve", "shape_drag_finest", "shape_live_drag_finest", "relief_drag_finest",
            "regions_combine", "fit_within", "region_offset", "sweep_surface", "gcode_write")},
        **{f"bat_{name}.level": [1, "level_total"] for name in ("shape_set_gain", "shape_set_muted", "relief_set_gain", "camera_set_gain", "camera_shake_of")},
        "bat_shape_move.index": [0, "level_count-"], "bat_shape_move_many.first": [0, "level_count-"], "bat_shape_live_move.first": [0, 1e9],
        "bat_motion_angle.angle": [0, 2], "bat_motion_redraw.angle": [0, 2], "bat_motion_redraw.level": [0, "levels-"], "bat_motion_set_gain.level": [1, "levels-"],
        "bat_surface_revolve.angle": [-6.2832, 6.2832], "bat_curve_elevate.degree": ["degree", 7], "bat_camera_view.distance": [0, 1e75, True],
        "bat_curve_reparametrise.start": [-1e30, 1e30], "bat_curve_reparametrise.end": [-1e30, 1e30], "bat_document_insert.index": [0, "count"],
        "bat_object_with_curve.index": [0, "curve_count-"], "bat_object_with_shape.index": [0, "curve_count-"], "bat_object_cover.curve": [0, "curve_count-"],
        "bat_curve_join.continuity": [0, 2], "bat_recipe_surface.scale": [0, 1e75]},
    "of_object": ["argument", "knots", "count", "degree", "dimension", "singular", "unsupported", "state"],  # why an object may be refused
    "regions": ["regions", "region"],  # arguments whose curves are closed, in the plane
    "each": {"bat_rotation_curve.points": 4},  # numbers of a record of an array with a count
    "defaults": {"bat_nib": {"cap": "round", "join": "round", "miter_limit": 4.0}, "bat_recipe": {"scale": 1.0, "angle": 360.0}, "bat_wire": {"scale": 1.0},
                 "bat_gradient": {"matrix": [1, 0, 0, 1, 0, 0]}, "bat_viewpoint": {"up": [0, 0, 1], "size": [1000, 1000]}},
    # Whole numbers that have no use beyond, by name.
    "within": {"dimension": [2, 3], "degree": [1, 7], "order": [0, 7], "decimals": [0, 20], "per_span": [1, 4096], "substeps": [0, 4096], "steps": [0, 4096], "times": [1, 8],
               "solves_max": [0, 4096], "pins": [0, 1 << 20], "Surface.order": [0, 2], "id": [0, 0x7fffffff], "uint32_t": [0, 0xffffffff],
               "uint64_t": [0, 1 << 53]}}
ALSO += [*RULES["explained"].values(), *RULES["explained_struct"].values()]
TITLES = {"bat_frame3": "Frame", "bat_mesh": "TriangleGrid"}  # of structs in the packages; the others are called as in C: Near, FitReport


class Headers:
    def __init__(self, root):
        self.calls, self.header, self.structs, self.enums, self.docs, self.members, self.numbers = {}, {}, {}, {}, {}, {}, {}
        for path in sorted((root / "include/batten").glob("*.h")):
            self.docs |= documented(path.read_text("utf-8"))
            for said, body, name in re.findall(r"(?:(/\*(?:(?!\*/).)*\*/)\n)?typedef struct \w+ \{(.*?)\} (\w+);", path.read_text("utf-8"), re.S):
                self.members[name] = said, body
            text = re.sub(r"/\*.*?\*/", " ", path.read_text("utf-8"), flags=re.S)
            for returns, name, parameters in re.findall(r"BAT_API\s+([^;()]*?)\b(bat_\w+)\(([^;]*?)\);", text):
                self.calls[name] = (" ".join(returns.split()), self.split(parameters))
                self.header[name] = path.name
            for body, name in re.findall(r"typedef enum \w+ \{(.*?)\} (\w+);", text, re.S):
                self.enums[name] = self.words(body)
            for body in re.findall(r"\benum(?: \w+)? \{(.*?)\}", text, re.S):
                self.numbers |= dict(self.valued(body))
            for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", text, re.S):
                self.structs[name], self.header[name] = body, path.name

    @staticmethod
    def split(parameters):
        found = []
        for one in " ".join(parameters.split()).split(","):
            match = re.fullmatch(r"(.*?)(\w+)((?:\[\w*\])*)", one.strip())
            if match and match[1]:
                found.append((match[1].strip() + (" *" if match[3] else ""), match[2]))
        return found

    @staticmethod
    def valued(body):
        """(name, value) of each word of an enum; those with a value that is not a plain number are left out."""
        at = 0
        for one in body.split(","):
            name, _, value = (part.strip() for part in one.partition("="))
            at = int(value) if value.isdigit() else at
            if name and (not value or value.isdigit()):
                yield name, at
                at += 1

    @staticmethod
    def words(body):
        found = {}
        names = [pair for pair in Headers.valued(body) if not pair[0].endswith("_COUNT") or pair[0] == "BAT_COUNT"]
        stem = names[0][0]
        while len(names) > 1 and not all(name.startswith(stem) for name, _ in names):
            stem = stem[:-1]
        stem = stem[:stem.rfind("_") + 1]
        for name, value in names:
            found[name[len(stem):].lower()] = value
        return found

    def fields(self, struct):
        """(type, name, how many) of each field."""
        return [field for line in self.structs[struct].split(";") if line.strip() for field in self.declared(line)]

    @staticmethod
    def declared(line):
        first, *others = [part.strip() for part in " ".join(line.split()).split(",")]
        type_, name, room = re.fullmatch(r"(.*?)(\w+)\s*(?:\[(.+)\])?", first).groups()
        yield type_.strip(), name, room
        for other in others:
            star, name, room = re.fullmatch(r"(\**)(\w+)(?:\[(\w+)\])?", other).groups()
            yield type_.strip().rstrip("* ").strip() + (" " + star if star else ""), name, room

    def place(self, type_):
        """Size and alignment on wasm32."""
        if type_.endswith("*"):
            return 4, 4
        if type_ in self.enums:
            return 4, 4
        if type_ in SCALARS:
            return SCALARS[type_], SCALARS[type_]
        layout = self.layout(type_)
        return layout["size"], layout["align"]

    def layout(self, name):
        at, most, fields = 0, 1, []
        for type_, field, room in self.fields(name):
            size, align = self.place(type_)
            many = eval(" ".join(room.split()), {}, self.numbers) if room else 0
            at = -(-at // align) * align
            fields.append({"name": field, "type": type_, "room": many, "at": at, **({"each": "dim"} if room == "BAT_DIMENSION_MAX" else {})})
            at += size * (many or 1)
            most = max(most, align)
        return {"size": -(-at // most) * most, "align": most, "fields": fields}


def counting(fields):
    """Says of each field of a struct by which field it is counted, and which fields count."""
    names = [field["name"] for field in fields if field["type"] in ("size_t", "int") and not field["room"] and re.search(r"(^|_)count$", field["name"])]
    for before, field in zip([{"name": ""}, *fields], fields):
        own = field["name"][:-1] + "_count"
        shared = names[:1] if field["type"].endswith("**") and field["name"] != "owned" else []  # with what stands before it
        if found := [own] * (own in names) or [before["name"]] * (before["name"] in names) or shared:
            if field["type"].endswith("*") or field["room"]:
                field["counted"] = found[0]
    for field in fields:
        field["counts"] = field["name"] in names


def prose(comment):
    """The text of a comment of C, a line a paragraph."""
    text = re.sub(r"\n[ \t]*\*[ \t]*", "\n", comment[2:-2]).strip(" *\n")
    return "\n".join(" ".join(one.split()) for one in re.split(r"\n\n+", text))


def documented(text):
    """The comment of each function: the one before it, which holds for all declarations up to an empty line, and the one behind it
    on its line."""
    found, said, before, last, since = {}, "", "", None, 0
    for part in re.finditer(r"/\*.*?\*/|BAT_API\s[^;()#]*\bbat_\w+\([^;]*;|\n[ \t]*\n", text, re.S):
        word = part[0]
        if word.startswith("/*") and last and "\n" not in text[since:part.start()]:
            found[last] = f"{found[last]}\n{prose(word)}".strip()
        elif word.startswith("/*"):
            said, before, last = prose(word), said or before, None
            said = f"{before}\n{said}".strip() if said.startswith("The same") else said
        elif word.startswith("BAT_API"):
            last, since = re.search(r"\b(bat_\w+)\(", word)[1], part.end()
            found[last] = said
        elif word.isspace():
            said, before, last = "", said or before, None
    return found


def members(name, said, body):
    """The comment of a struct, under its name, and of each member, under struct.member: the one behind it, or else the one before it."""
    found = {name: prose(said)}
    for before, line, behind in re.findall(r"(?:(/\*(?:(?!\*/).)*\*/)\s*)?([^;/]+);(?:[ \t]*(/\*.*?\*/))?", body, re.S):
        for _, member, _ in Headers.declared(line):
            found[f"{name}.{member}"] = prose(behind or before)
    return found


def rows(path):
    """(C name or header, names or None, words or reason, whether the small npm modules may have it) of calls.txt."""
    core = True
    for line in path.read_text("utf-8").splitlines():
        core = core and not line.startswith("# Not in the small npm modules")
        if line.strip() and not line.startswith("#"):
            name, called, *words = line.split()
            yield name, None if called == "-" else called, " ".join(words) if called == "-" else words, core


def used(headers, type_, found):
    """Adds the structs and enums that a type needs."""
    bare = re.sub(r"\bconst\b|\*", "", type_).strip()
    if bare in headers.structs and bare not in found and bare not in CLASSES:
        title = re.sub(r"_(\w)", lambda letter: letter[1].upper(), bare.removeprefix("bat"))
        found[bare] = {**headers.layout(bare), "title": TITLES.get(bare, title)}
        for inner, _, _ in headers.fields(bare):
            used(headers, inner, found)


def write(path, text):
    """Writes a file, unless it says so already: what is made from it then stays as it is."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def table(headers, calls, classes, read):
    """The calls, and the structs, enums and classes that they need."""
    structs = {}
    for name in [type_ for call in calls for type_ in [*(type_ for _, type_ in call["args"]), call["returns"]]] + read:
        used(headers, name, structs)
    for struct in structs.values():
        counting(struct["fields"])
    return {"calls": calls, "structs": structs, "inits": {name: name + "_init" for name in structs if name + "_init" in headers.calls},
            "enums": {name: headers.enums[name] for name in headers.enums
                      if name == "bat_status" or any(name == field["type"] for s in structs.values() for field in s["fields"])
                      or any(name == type_ for call in calls for _, type_ in [*call["args"], (None, call["returns"])])},
            "classes": classes, "frees": {name: FREES[name] for name in classes.values()}}


def reasons(said):
    """What a comment says of each status: {"argument": "an open curve"}."""
    found = {}
    for status, why in re.findall(r"BAT_([A-Z]+):\s*((?:[^;.]|\.(?=\w))+)", said):
        found.setdefault(status.lower(), " ".join(why.split()))
    return {status: why for status, why in found.items() if status not in ("memory", "tolerance", "dot", "far", "syntax")}  # whose words are enough


def optional(call):
    """The structs of options that a call takes."""
    return [re.sub(r"\bconst\b|\*", "", type_).strip() for word, type_ in call["args"] if word.startswith("{")]


def main():
    root, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    headers = Headers(root)
    calls, first = [], set()
    for name, called, words, core in rows(root / "bindings/calls.txt"):
        if called is None:
            continue
        returns, parameters = headers.calls[name]
        given = [word for word in words if not word.startswith("<")]
        if len(given) != len(parameters):
            sys.exit(f"calls.txt: {name} has {len(parameters)} arguments, not {len(given)}")
        calls.append({"c": name, "names": called.split(","), "returns": returns,
                      "returned": next((word[2:-1] for word in words if word.startswith("<")), None),
                      "args": [[word, type_] for word, (type_, _) in zip(given, parameters)]})
        first |= {name} if core else set()
    whole = table(headers, calls, CLASSES, READ) | {"rules": RULES}
    core = table(headers, [call for call in calls if call["c"] in first], CORE, READ[:1]) | {"rules": RULES}
    why = {call["c"]: found for call in calls if (found := reasons(headers.docs[call["c"]]))}  # what is not in the small npm modules
    more = {part: {name: of for name, of in whole[part].items() if name not in core[part]} for part in ("structs", "inits", "enums", "classes", "frees")}
    out.mkdir(parents=True, exist_ok=True)
    for name, one in (("calls", whole | {"why": why}), ("core", core), ("more", more | {"why": why, "calls": [call for call in calls if call["c"] not in first]})):
        write(out / f"{name}.json", json.dumps(one, indent=None, separators=(",", ":")) + "\n")
    structs = whole["structs"]
    docs = {call["c"]: f"{headers.docs[call['c']]}\nIn C: {call['c']}, <batten/{headers.header[call['c']]}>".strip() for call in calls}
    for name in structs:
        docs |= members(name, *headers.members[name])
        docs[name] = f"{docs[name]}\nIn C: {name}, <batten/{headers.header[name]}>".strip()
    for call in calls:  # its options, each with its comment
        said = [(field["name"], docs[f"{struct}.{field['name']}"]) for struct in optional(call) for field in structs[struct]["fields"] if field["name"] != "size" and not field["counts"]]
        docs[call["c"] + "()"] = "\n".join(f"{name}: {' '.join(about.split())}" for name, about in said if about)
    write(out / "docs.json", json.dumps(docs, indent=0, ensure_ascii=False) + "\n")
    ends = {name + end for name in structs for end in ("_free", "_clear")} | {name + "_copy" for name in CLASSES}
    exports = sorted({call["c"] for call in calls} | set(ALSO) | set(whole["inits"].values()) | ends & set(headers.calls))
    write(out / "exports.txt", "\n".join(exports) + "\n")
    lines = ["#include <batten/batten.h>", ""]
    for name, layout in structs.items():
        lines.append(f'_Static_assert(sizeof({name}) == {layout["size"]}, "{name}");')
        lines += [f'_Static_assert(offsetof({name}, {field["name"]}) == {field["at"]}, "{name}.{field["name"]}");'
                  for field in layout["fields"]]
    write(out / "layout.c", "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
