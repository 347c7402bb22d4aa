#!/usr/bin/env python3
"""The C interface is consistent, as docs/interface.md describes: the rules that can be checked in the public headers.

Usage: check_interface.py ROOT. Exit status 1 when a header breaks a rule.
"""
import pathlib
import re
import sys

# Counts of things indexed by an int: objects, curves of an object, losses of a file, joints of a skeleton and their channels.
INT_COUNTS = {"bat_object_create_path", "bat_object_with_curves", "bat_object_curve_count", "bat_document_count",
              "bat_editor_outline", "bat_loss_words", "bat_losses", "bat_curve_knot_count", "bat_curve_segment_count",
              "bat_surface_knot_count", "bat_bone", "bat_take_create", "bat_take_check", "bat_take_joints"}
# Not a query but an event: returns whether it was used.
NO_PREDICATES = {"bat_editor_key"}
# The order of a call's arguments, from the first on.
PLACES = ["dimension", "degree", "closed", "count"]
COUNT = re.compile(r"(?:\w*_)?(?:count|room|samples)$")


def split(parameters):
    """[(type, name)] of a parameter list; arrays become pointers."""
    found = []
    for one in parameters.split(","):
        type_, name, array = re.fullmatch(r"(.*?)(\w+)((?:\[\w*\])*)", one.strip()).groups()
        found.append((type_.strip() + (" *" if array else ""), name))
    return [] if found == [("", "void")] else found


def is_options(type_):
    return re.fullmatch(r"const bat_\w+_options \*", type_) is not None


def is_result(type_):
    return "*" in type_ and not type_.startswith("const ") and "*const" not in type_


def check_order(name, parameters):
    names = [n for _, n in parameters]
    places = [names.index(n) for n in PLACES if n in names]
    if places != sorted(places):
        yield f"{name}: {', '.join(PLACES)} stand in another order"
    for i, (type_, given) in enumerate(parameters):
        if is_options(type_) and any(not is_options(t) and not is_result(t) for t, _ in parameters[i + 1:]):
            yield f"{name}: something but results stands behind {given}"
        if given == "count" and not is_result(type_) and i + 1 < len(parameters) and "*" not in parameters[i + 1][0]:
            yield f"{name}: what count counts does not follow it"


def check_call(name, returns, parameters):
    yield from check_order(name, parameters)
    if returns == "bool" and not re.fullmatch(r"bat_\w+?_is_\w+", name) and name not in NO_PREDICATES:
        yield f"{name}: a predicate is named bat_x_is_y"
    if name not in INT_COUNTS:
        for type_, given in parameters:
            if COUNT.fullmatch(given) and type_.rstrip(" *") == "int" and given not in ("knot_count", "segment_count"):
                yield f"{name}: {given} is an int"
        if returns == "int" and name.endswith("_count"):
            yield f"{name}: gives an int"
    live = re.fullmatch(r"(?:const )?(bat_\w+_live) \*", parameters[0][0]) if parameters else None
    if live and not name.startswith(live[1] + "_"):
        yield f"{name}: a call of {live[1]} is named after it"


def check_struct(name, body, names):
    members = [m.strip() for m in body.split(";") if m.strip()]
    if name.endswith("_options"):
        if members[0] != "size_t size":
            yield f"{name}: does not begin with its size"
        if name + "_init" not in names:
            yield f"{name}: has no {name}_init"
    if name not in INT_COUNTS:
        for member in members:
            for given in re.findall(r"\w+(?=\s*(?:,|$))", member):
                if COUNT.fullmatch(given) and member.startswith("int "):
                    yield f"{name}: {given} is an int"


def main():
    root = pathlib.Path(sys.argv[1])
    texts = {path.name: path.read_text("utf-8") for path in sorted((root / "include/batten").glob("*.h"))}
    faults, calls, structs = [], {}, {}
    for header, text in texts.items():
        bare = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
        for returns, name, parameters in re.findall(r"BAT_API\s+([^;()]*?)\b(bat_\w+)\(([^;]*?)\);", bare):
            calls[name] = (" ".join(returns.split()), split(" ".join(parameters.split())))
            if any(is_options(t) for t, _ in calls[name][1]) and not re.search(r"options(\s|\*)+may(\s|\*)+be(\s|\*)+NULL|"
                                                                              r"options NULL", text):
                faults.append(f"{header}: does not say that options may be NULL")
        structs |= {name: body for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", bare, re.S)}
    for name, (returns, parameters) in calls.items():
        faults += check_call(name, returns, parameters)
    for name, body in structs.items():
        faults += check_struct(name, " ".join(body.split()), calls)
    lives = {m[1] for name in calls if (m := re.match(r"(bat_\w+_live)_", name))}
    faults += [f"{live}_{end}: is missing" for live in sorted(lives) for end in ("begin", "commit", "cancel")
               if f"{live}_{end}" not in calls]
    faults += [f"check_interface.py: {name} is no exception any more" for name in sorted(INT_COUNTS | NO_PREDICATES)
               if name not in calls and name not in structs]
    print(*sorted(set(faults)), sep="\n")
    print(f"{len(calls)} calls and {len(structs)} structs read, {len(faults)} faults")
    return 1 if faults or len(calls) < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
