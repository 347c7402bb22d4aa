#!/usr/bin/python3
"""Writes twenty drawings with shapes in space as every kind of file, and reads these with programs that are not Batten: each is as
large as numpy says within 1e-4 of its size and stands upright; of what is closed triangles leave no edge open and hold a volume
above 0, as STEP it is a solid; and nobody finds fault. Prints a line a file that is wrong, and how many were read by whom.
Usage: whole.py BATTEN [--only NAME,...] [--kinds stl,glb,...]"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

import drawings
import readers

KINDS = ("stl", "glb", "gltf", "obj", "ply", "3mf", "step", "iges")
UP_IS_Y, METRES, FACES_ONLY = ("glb", "gltf", "obj"), ("glb", "gltf"), ("stl", "3mf", "ply")
SURFACES_ONLY = ("step", "iges")
WITHIN = {"occt": 1e-3}  # of the size: Draw searches for a box no better; points it finds to 1e-12 (tests/cli/test_occt.py)
USUAL = 1e-4


def compare(found, low, high, kind, within):
    """What is wrong with what a reader found."""
    if "wrong" in found:
        return found["wrong"]
    size = numpy.linalg.norm(high - low)
    scale = 1000 if kind in METRES else 1
    if "low" in found:
        far = max(numpy.abs(numpy.array(found["low"]) * scale - low).max(), numpy.abs(numpy.array(found["high"]) * scale - high).max()) / size
        if not far <= within:
            return f"its box is {far:.2g} of its size off: {found['low']} {found['high']}, not {low / scale} {high / scale}"
    return None


def read(reader, file, kind, closed, folder):
    """What the reader finds, and what is wrong besides the size."""
    if reader == "occt":
        found = readers.occt(file, folder, kind)
        if closed and kind == "step" and not found.get("solids") and "wrong" not in found:
            found["wrong"] = "no solid"
    else:
        found = {"admesh": readers.admesh, "assimp": readers.assimp, "blender": readers.blender, "gltf-validator": readers.gltf}[reader](file)
    if closed and found.get("open"):
        found["wrong"] = f"{found['open']} open edges"
    if closed and not found.get("volume", 1) > 0:
        found["wrong"] = f"volume {found['volume']}"
    return found


def check(program, drawing, closed, kind, folder):
    """reader: what is wrong (None: nothing), of those that are installed."""
    file = pathlib.Path(folder) / f"{pathlib.Path(drawing).stem}.{kind}"
    low, high = drawings.box(program, drawing, kind in UP_IS_Y, kind not in FACES_ONLY)
    unit = json.loads(pathlib.Path(drawing).read_text()).get("scale", drawings.UNITS["px"])
    words = ["--tolerance", repr(0.5 * USUAL * numpy.linalg.norm(high - low) / unit)] if kind not in ("step", "iges") else []
    if kind == "obj":
        words.append("--triangles")
    done = subprocess.run([program, "convert", drawing, file, *words], capture_output=True, check=False)
    if done.returncode:
        return {"batten": done.stderr.decode().strip()}
    out = {}
    for reader, (there, kinds) in readers.READERS.items():
        if there and kind in kinds:
            out[reader] = compare(read(reader, file, kind, closed, folder), low, high, kind, WITHIN.get(reader, USUAL))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    parser.add_argument("--kinds", default=",".join(KINDS))
    wanted = parser.parse_args()
    examples = pathlib.Path(__file__).resolve().parents[2] / "examples"
    tried, wrong = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for name, (drawing, closed) in drawings.Maker(wanted.program, folder, examples).all().items():
            if wanted.only and name not in wanted.only.split(","):
                continue
            for kind in wanted.kinds.split(","):
                if (name in drawings.WITHOUT_FACES and kind in FACES_ONLY) or (name in drawings.MESHES and kind in SURFACES_ONLY):
                    continue
                for reader, fault in check(wanted.program, drawing, closed, kind, folder).items():
                    tried[reader] += 1
                    if fault:
                        wrong += 1
                        print(f"{name}.{kind}: {reader}: {fault}", flush=True)
    print(", ".join(f"{reader}: {count}" for reader, count in tried.items()), f"files; {wrong} faults")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
