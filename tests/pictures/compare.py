#!/usr/bin/env python3
"""Compares the pictures that `batten render` makes of SVG files with those of rsvg-convert.

Two pictures agree when all but SHARE of the pixels of each lie between the least and the greatest value of the other in their
neighbourhood of 3 x 3, within NEAR. The size is one that both programs fill: they centre a picture of other proportions in
different ways. Files that rsvg-convert cannot show, or shows empty, are not counted. It takes minutes for
hundreds of files.

Usage: compare.py BATTEN [--list] FILE_OR_FOLDER ...
"""
import concurrent.futures
import hashlib
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy

SIDE = 160  # pixels of the longer side
NEAR = 24  # of 255
SHARE = 0.002
SECONDS = 30  # for one picture


def unfilter(kind, line, above, size):
    """A row of a PNG; size: bytes of a pixel."""
    if kind == 0:
        return line
    if kind == 1:
        return numpy.cumsum(line.reshape(-1, size), 0, numpy.uint8).ravel()
    if kind == 2:
        return line + above
    out = bytearray(len(line))
    for i, value in enumerate(line.tolist()):
        left = out[i - size] if i >= size else 0
        up = int(above[i])
        corner = int(above[i - size]) if i >= size else 0
        guess = left + up - corner
        near = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
        out[i] = value + ((left + up) // 2 if kind == 3 else near) & 255
    return numpy.frombuffer(bytes(out), numpy.uint8)


def pixels(png):
    """Rows of red, green, blue over white."""
    at, data = 8, b""
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        if name == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if name == b"IDAT":
            data += body
        at += size + 12
    channels = {2: 3, 6: 4}[colour]
    assert depth == 8
    rows = numpy.frombuffer(zlib.decompress(data), numpy.uint8).reshape(height, 1 + width * channels)
    above, lines = numpy.zeros(width * channels, numpy.uint8), []
    for row in rows:
        above = unfilter(row[0], row[1:], above, channels)
        lines.append(above)
    image = numpy.array(lines).reshape(height, width, channels).astype(float)
    if channels == 3:
        return image
    alpha = image[:, :, 3:] / 255
    return image[:, :, :3] * alpha + 255 * (1 - alpha)


def far(one, other):
    """The share of pixels of one that are not near any of the other's neighbourhood."""
    padded = numpy.pad(other, ((1, 1), (1, 1), (0, 0)), "edge")
    around = [padded[y:y + one.shape[0], x:x + one.shape[1]] for y in range(3) for x in range(3)]
    low, high = numpy.min(around, 0) - NEAR, numpy.max(around, 0) + NEAR
    return float(numpy.mean(numpy.any((one < low) | (one > high), 2)))


def run(command):
    try:
        return subprocess.run(command, capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None


def size_of(batten, path):
    """Width and height in pixels, as near as can be to the page's proportions."""
    told = run([batten, "info", "--json", str(path)])
    try:
        wide, high = json.loads(told.stdout)["page"][2:]
    except (AttributeError, KeyError, TypeError, ValueError):
        return SIDE, SIDE
    if not (wide > 0 and high > 0):
        return SIDE, SIDE
    sizes = [(side, side * min(wide, high) / max(wide, high)) for side in range(SIDE, SIDE + 400)]
    near = [pair for pair in sizes if abs(pair[1] - round(pair[1])) < 0.05]
    long, short = near[0] if near else min(sizes[:64], key=lambda pair: abs(pair[1] - round(pair[1])))
    short = max(1, round(short))
    return (long, short) if wide >= high else (short, long)


def compare(batten, path, written=None):
    """None: rsvg-convert shows nothing; else the greater of both shares, 1 when there is no picture. written: what stands for
    the picture of batten, as rsvg-convert shows it."""
    with tempfile.TemporaryDirectory() as folder:
        theirs, ours = pathlib.Path(folder) / "theirs.png", pathlib.Path(folder) / "ours.png"
        wide, high = size_of(batten, path)
        command = ["rsvg-convert", "-w", str(wide), "-h", str(high), "-b", "white", "-o", str(theirs), str(path)]
        run([*command, "--keep-aspect-ratio"])
        if not theirs.exists() or not theirs.stat().st_size:
            return None
        expected = pixels(theirs.read_bytes())
        if max(abs(expected.shape[1] - wide), abs(expected.shape[0] - high)) <= 1:
            run(command)  # a side was rounded: without that the page fills it
            expected = pixels(theirs.read_bytes())
        if numpy.ptp(expected, (0, 1)).max() == 0:
            return None
        width, height = expected.shape[1::-1]
        done = run(["rsvg-convert", "-w", str(width), "-h", str(height), "-b", "white", "-o", str(ours), str(written)] if written
                   else [batten, "render", str(path), str(ours), "--size", f"{width}x{height}", "--background", "white"])
        if not done or done.returncode or not ours.exists():
            return 1.0
        found = pixels(ours.read_bytes())
        return max(far(expected, found), far(found, expected)) if found.shape == expected.shape else 1.0


def files(names):
    seen = set()
    for name in names:
        path = pathlib.Path(name)
        for one in sorted(path.rglob("*.svg")) if path.is_dir() else [path]:
            key = hashlib.sha256(one.read_bytes()).digest() if one.is_file() else None
            if key and key not in seen:
                seen.add(key)
                yield one


def main():
    arguments = [a for a in sys.argv[1:] if a != "--list"]
    batten, paths = arguments[0], list(files(arguments[1:]))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        shares = list(pool.map(lambda path: compare(batten, path), paths))
    counted = [(share, path) for share, path in zip(shares, paths) if share is not None]
    good = sum(share <= SHARE for share, _ in counted)
    if "--list" in sys.argv:
        for share, path in sorted(counted, key=lambda pair: pair[0]):
            if share > SHARE:
                print(f"{100 * share:6.2f} %  {path}")
    print(f"{good} of {len(counted)} pictures agree; {len(paths) - len(counted)} not counted")


if __name__ == "__main__":
    main()
