#!/usr/bin/env python3
"""calls.txt has every public function once: with a name that no other has, or with the reason why it has none; every name in it
is there; and the header for C++ is what the table makes of it. Usage: check_calls.py ROOT
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(root / "bindings"))
import cpp  # noqa: E402
from generate import CLASSES, RULES, Headers, rows  # noqa: E402

headers = Headers(root)
faults, seen, names, whole = [], {}, {}, set()
for name, called, words, _ in rows(root / "bindings/calls.txt"):
    if name.endswith(".h"):
        whole.add(name)
        continue
    seen.setdefault(name, []).append(called)
    if called is None and not words:
        faults.append(f"{name}: why has it no counterpart?")
    for one in called.split(",") if called else []:
        names.setdefault(one, []).append(name)
        if one.split(".")[0] not in {"b", *CLASSES.values()}:
            faults.append(f"{one}: of what class?")
faults += [f"{name}: of {' and '.join(of)}" for name, of in names.items() if len(of) > 1]
faults += [f"{name}: twice, without two names" for name, called in seen.items() if len(called) > 1 and None in called]
faults += [f"{name}: is in no header" for name in seen if name not in headers.calls]
faults += [f"{name}: no such header" for name in whole if not (root / "include/batten" / name).exists()]
for name in headers.calls:
    if (name in seen) == (headers.header[name] in whole):
        faults.append(f"{name} ({headers.header[name]}): {'a line too many' if name in seen else 'not in calls.txt'}")
# What makes something of numbers, or reads it, says what is wrong with them: by a problem among its arguments, or by a call beside it.
SILENT = {
    "bat_camera_create": "takes a path; its options have ranges", "bat_reference_create": "takes what is right by itself",
    "bat_object_create_": "bat_object_head_check, bat_style_check and the checks of what is in it", "bat_document_create": "takes nothing",
    "bat_editor_create": "takes nothing", "bat_svg_reader_": "bat_svg_reader_finish says it", "bat_shape_create": "takes a curve; its options have ranges",
    "bat_relief_create": "takes what is right by itself", "bat_finder_create": "takes what is right by itself", "bat_surface_finder_create": "takes what is right by itself",
    "bat_frame_chain_create": "takes a curve; its options have ranges", "bat_sweep_create": "takes curves; bat_function_check", "bat_line_drawing_create": "bat_viewpoint_check",
    "bat_editor_salvage": "leaves out what is wrong, and says how much"}
told = lambda name: any("bat_problem" in type_ for type_, _ in headers.calls[name][1])
makes = [name for name, (returns, _) in headers.calls.items() if returns == "bat_status" and re.search(r"_(create|create_\w+|read|check|salvage|replay|reader_\w+)$", name)]
silent = [name for name in makes if not told(name) and name not in RULES["explained"]]
faults += [f"{name}: what does it say of what it refuses? (a bat_problem, \"explained\" of generate.py, or a reason here)" for name in silent
           if not any(name.startswith(one) for one in SILENT)]
faults += [f"{one}: needs no reason any more" for one in SILENT if not any(name.startswith(one) for name in silent)]
faults += [f"{one}: takes no bat_problem" for one in [*RULES["explained"].values(), *RULES["explained_struct"].values()] if not told(one)]
text = "\n".join(path.read_text("utf-8") for path in sorted((root / "include/batten").glob("*.h")))
public = set(re.findall(r"BAT_API[^;]*?\b(bat_\w+)\(", re.sub(r"/\*.*?\*/", " ", text, flags=re.S)))
faults += [f"{name}: generate.py does not see it" for name in sorted(public - set(headers.calls))]
if cpp.text(root) != (root / "include/batten/batten.hpp").read_text("utf-8"):
    faults.append("include/batten/batten.hpp: bindings/cpp.py makes another; run it")
print(*faults, sep="\n")
print(f"{len(public)} public functions, {len(names)} names, {len(faults)} faults")
sys.exit(bool(faults) or len(public) < 400 or len(names) < 100)
