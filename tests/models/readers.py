"""Files of shapes in space as programs read them that are not Batten: admesh, assimp, Blender (Debian), OCCT's Draw (occt-draw) and
the glTF validator of Khronos (npm gltf-validator, of tests/web unless NODE_PATH says where). Each gives what it finds: low and high
of a box, triangles' volume and open edges."""
import json
import os
import pathlib
import re
import shutil
import subprocess

import numpy

SECONDS = 300
os.environ.setdefault("NODE_PATH", str(pathlib.Path(__file__).resolve().parents[1] / "web/node_modules"))
DRAW = next(filter(None, map(shutil.which, ("DRAWEXE", "occt-draw", "occt-draw-7.6"))), None)
NUMBER = r"-?[\d.]+(?:e[-+]?\d+)?|-?inf|nan"
VALIDATE = """const validator = require('gltf-validator'); const file = process.argv[1];
validator.validateBytes(new Uint8Array(require('fs').readFileSync(file))).then((r) => console.log(JSON.stringify(r.issues)));"""


def said(*words, **options):
    return subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS, check=False,
                          **options).stdout.decode(errors="replace")


def draw(folder, *lines):
    """What Draw prints. Debian has its libraries only under names with a version, which its plug-ins are not asked for by."""
    folder = pathlib.Path(folder)
    libraries = folder / "libraries"
    libraries.mkdir(exist_ok=True)
    for library in pathlib.Path("/usr/lib").glob("*/libTK*.so.7"):
        link = libraries / library.stem
        if not link.exists():
            link.symlink_to(library)
    script = folder / "script.tcl"
    script.write_text("\n".join(["pload MODELING XSDRAW", *lines, "exit"]))
    path = ":".join(filter(None, [os.environ.get("LD_LIBRARY_PATH"), str(libraries)]))
    return said(DRAW, "-b", "-f", script, cwd=folder, env={**os.environ, "LD_LIBRARY_PATH": path})


def admesh(file):
    text = said("admesh", "--no-check", "--exact", file)
    low, high = zip(*(map(float, re.search(rf"Min {c} =\s*({NUMBER}), Max {c} =\s*({NUMBER})", text).groups()) for c in "XYZ"))
    return {"low": low, "high": high, "open": int(re.search(r"Total disconnected facets\s*:\s*(\d+)", text)[1]),
            "volume": float(re.search(rf"Volume\s*:\s*({NUMBER})", text)[1])}


def assimp(file):
    text = said("assimp", "info", file)
    if "ERROR" in text or "Minimum point" not in text:
        return {"wrong": text.strip().splitlines()[-1]}
    low, high = ([float(n) for n in re.search(rf"{name} point\s*\(({NUMBER}) ({NUMBER}) ({NUMBER})\)", text).groups()]
                 for name in ("Minimum", "Maximum"))
    return {"low": low, "high": high}


def gltf(file):
    text = said("node", "-e", VALIDATE, file)
    try:
        issues = json.loads(text)
    except ValueError:
        return {"wrong": text.strip()}
    bad = [m for m in issues["messages"] if m["severity"] < 2]
    return {"wrong": json.dumps(bad[:2])} if bad else {}


# Blender's z is up: what imports a file whose y is up turns it, so it is turned back. Vertices are merged, as seams may be apart.
BLENDER = """
import bpy, bmesh, json, numpy, sys
numpy.bool = bool  # which the glTF importer of Blender 3.4 asks newer numpy for
file, turned = sys.argv[-2], sys.argv[-1] == 'y'
bpy.ops.wm.read_factory_settings(use_empty=True)
kind = file.rsplit('.', 1)[1]
{'stl': bpy.ops.import_mesh.stl, 'ply': bpy.ops.import_mesh.ply, 'obj': bpy.ops.wm.obj_import}.get(kind, bpy.ops.import_scene.gltf)(filepath=file)
places, volume, loose = [], 0.0, 0
for item in [one for one in bpy.data.objects if one.type == 'MESH']:
    mesh = bmesh.new()
    mesh.from_mesh(item.data)
    mesh.transform(item.matrix_world)
    places += [tuple(v.co) for v in mesh.verts]
    size = max((max(v.co[k] for v in mesh.verts) - min(v.co[k] for v in mesh.verts)) for k in range(3))
    bmesh.ops.remove_doubles(mesh, verts=mesh.verts, dist=1e-6 * size)
    loose += sum(not edge.is_manifold for edge in mesh.edges if edge.link_faces)
    volume += mesh.calc_volume(signed=True) if mesh.faces else 0.0
places = [(x, z, -y) for x, y, z in places] if turned else places
print('FOUND', json.dumps({'low': [min(p[k] for p in places) for k in range(3)], 'high': [max(p[k] for p in places) for k in range(3)],
                           'open': loose, 'volume': volume}))
"""


def edges(file):
    """A copy of an OBJ file whose polylines are single edges: of each Blender 3.4 reads the first only (later ones read all)."""
    lines = []
    for line in pathlib.Path(file).read_text().splitlines():
        corners = line.split()[1:] if line.startswith("l ") else []
        lines += [f"l {a} {b}" for a, b in zip(corners, corners[1:])] if corners else [line]
    copy = pathlib.Path(file).with_name(f"{pathlib.Path(file).stem}-edges.obj")
    copy.write_text("\n".join([*lines, ""]))
    return copy


def blender(file):
    file = edges(file) if pathlib.Path(file).suffix == ".obj" else file
    text = said("blender", "-b", "--factory-startup", "--python-expr", BLENDER, "--", file, "y" if pathlib.Path(file).suffix in (".glb", ".gltf", ".obj") else "z")
    found = re.search(r"(?m)^FOUND (.*)$", text)
    return json.loads(found[1]) if found else {"wrong": text.strip()[-300:]}


def has_validator():
    return shutil.which("node") is not None and said("node", "-e", "require('gltf-validator')") == ""


def occt(file, folder, kind):
    text = draw(folder, f"{'stepread' if kind == 'step' else 'igesread'} {file} s *", "catch {renamevar s_1 s}", "puts [nbshapes s]",
                "puts [checkshape s]", "puts [bounding s -optimal -noTriangulation]", "puts [vprops s 1e-6]")
    corners = re.search(rf"(?m)^({NUMBER}) ({NUMBER}) ({NUMBER}) ({NUMBER}) ({NUMBER}) ({NUMBER})\s*$", text)
    if not corners or "seems to be valid" not in text:
        return {"wrong": text.strip()[-300:]}
    numbers = list(map(float, corners.groups()))
    return {"low": numbers[:3], "high": numbers[3:], "solids": int(re.search(r"SOLID\s*: (\d+)", text)[1]),
            "volume": float(re.search(rf"Mass :\s*({NUMBER})", text)[1])}


READERS = {"admesh": (shutil.which("admesh"), ("stl",)), "assimp": (shutil.which("assimp"), ("stl", "glb", "gltf", "obj", "ply", "3mf")),
           "blender": (shutil.which("blender"), ("stl", "glb", "gltf", "obj", "ply")),
           "gltf-validator": (has_validator(), ("glb", "gltf")), "occt": (DRAW, ("step", "iges"))}
