#!/usr/bin/env python3
"""Opens many files of others, saves them, edits a curve of each and paints them, and says of each source how many are as they
should be. FOLDER has a folder for each source (gather.py makes one); of every source as many different files are tried as of any
other, as far as it has them. Another seed chooses other files, so that what was mended with one can be proven with the next.

Tried of each file:
  open     saved with nothing edited it is the same bytes, as SVG and by way of the native format
  edit     with one point of one curve moved a little, one element's text differs; with Batten's data, these besides
  look     rsvg-convert shows the edited file as it shows the file
  picture  `batten render` shows what rsvg-convert shows (compare.py: to a pixel's neighbourhood)
  end      no call fails, crashes or takes longer than the limit
Usage: whole.py BATTEN FOLDER [--seed N] [--count N] [--source NAME] ...
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import statistics
import subprocess
import tempfile
import time

from again import tags_between
from compare import SECONDS, SHARE, compare, files
from nudge import is_drawing, nudge

CHECKS = ("open", "edit", "look", "picture", "end")
# What a file has that pictures may differ for: the class of a failure.
CAUSES = ["text", "foreignObject", "filter", "mask", "pattern", "marker", "image", "switch", "symbol", "style", "textPath",
          "animate", "use"]
PROPERTIES = ["mix-blend-mode", "enable-background", "shape-rendering", "spreadMethod", "context-fill", "currentColor",
              "stroke-dasharray", "non-scaling-stroke", "clip-rule", "paint-order", "<!ENTITY"]
NATIVE = re.compile(rb"\n<metadata><batten:document.*</batten:document></metadata>|<batten:document.*</batten:document>", re.S)


class Failed(Exception):
    """A call that did not end as it should: crashed, refused, slow."""


def call(seconds, *words):
    began = time.monotonic()
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired as error:
        raise Failed(f"slow: {words[1]}") from error
    seconds.append(time.monotonic() - began)
    if done.returncode:
        kind = "crashed" if done.returncode < 0 else "refused"
        said = done.stderr.decode(errors="replace").strip().splitlines()
        raise Failed(f"{kind}: {words[1]}: {said[-1] if said else ''}")


def causes(text):
    found = [name for name in CAUSES if re.search(rb"<(\w+:)?%s\b" % name.encode(), text)]
    return found + [name for name in PROPERTIES if name.encode() in text]


def edited(batten, path, text, folder, one):
    """The file with a curve edited; what of its text is not as it should be is noted."""
    kept, moved, plain, full = (folder / name for name in ("kept.batten", "moved.batten", "plain.svg", "full.svg"))
    call(one["seconds"], batten, "convert", path, kept)
    call(one["seconds"], batten, "convert", kept, plain, "--plain")
    if plain.read_bytes() != text:
        one["wrong"]["open"] = "by way of the native format"
    drawing = json.loads(kept.read_bytes(), parse_int=lambda word: -0.0 if word == "-0" else int(word))
    if not nudge(drawing, random.Random(one["seed"])):
        return None
    moved.write_text(json.dumps(drawing))
    call(one["seconds"], batten, "convert", moved, plain, "--plain")
    call(one["seconds"], batten, "convert", moved, full)
    new = plain.read_bytes()
    if new == text:
        return None  # what moved is not written: it is less than the precision
    one["ratio"] = len(new) / len(text)
    tags = tags_between(text, new)
    if tags > 2:
        one["wrong"]["edit"] = f"{tags} tags are not the same"
    elif NATIVE.sub(b"", full.read_bytes()) != NATIVE.sub(b"", new):
        one["wrong"]["edit"] = "not the same beside Batten's data"
    return plain


def picture(one, name, *words):
    share = compare(*words)
    if share is not None:
        one["seen"].add(name)
    if share is not None and share > SHARE:
        one["wrong"][name] = f"{100 * share:.2f} %"


def try_file(batten, source, path, seed):
    text = path.read_bytes()
    one = {"source": source, "path": path, "wrong": {}, "seen": set(), "seconds": [], "seed": f"{seed} {path.name}"}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = folder / "file.svg"  # without what lies beside it, as the edited one
        path.write_bytes(text)
        try:
            call(one["seconds"], batten, "convert", path, folder / "same.svg")
            if (folder / "same.svg").read_bytes() != text:
                one["wrong"]["open"] = "not the same bytes"
            one["seen"] |= {"open", "end"}
            plain = edited(batten, path, text, folder, one)
            if plain:
                one["seen"].add("edit")
                picture(one, "look", batten, path, plain)
            picture(one, "picture", batten, path)
        except (Failed, ValueError) as error:
            one["seen"].add("end")
            one["wrong"]["end"] = str(error)
    if one["wrong"]:
        one["causes"] = causes(text)
    return one


def sample(folder, names, count, seed):
    """(source, path) of `count` files, of each source as many as of the others while it has any."""
    chance, queues = random.Random(seed), {}
    for source in sorted(one for one in folder.iterdir() if one.is_dir() and (not names or one.name in names)):
        paths = sorted(source.rglob("*.svg"))
        chance.shuffle(paths)
        queues[source.name] = files(path for path in paths if is_drawing(path))
    chosen = []
    while queues and len(chosen) < count:
        for name in list(queues):
            path = next(queues[name], None)
            if path is None:
                del queues[name]
            elif len(chosen) < count:
                chosen.append((name, path))
    return chosen


def table(done):
    """Lines: of each source, and of all, how many of those that could be tried are as they should be."""
    yield f"{'':22}{'files':>6}" + "".join(f"{check:>12}" for check in CHECKS) + f"{'longer':>8}{'seconds':>9}"
    sources = sorted({one["source"] for one in done})
    for source in [*sources, ""]:
        some = [one for one in done if source in ("", one["source"])]
        cells = ""
        for check in CHECKS:
            tried = [one for one in some if check in one["seen"]]
            good = sum(check not in one["wrong"] for one in tried)
            cells += f"{good:>6} of{len(tried):>4}"[-12:].rjust(12)
        ratios = [one["ratio"] for one in some if "ratio" in one]
        longest = max((max(one["seconds"], default=0) for one in some), default=0)
        yield f"{source or 'all':22}{len(some):>6}{cells}{statistics.median(ratios) if ratios else 1:>8.2f}{longest:>9.1f}"


def main():
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reader.add_argument("batten")
    reader.add_argument("folder", type=pathlib.Path)
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--count", type=int, default=729)
    reader.add_argument("--source", action="append")
    given = reader.parse_args()
    chosen = sample(given.folder, given.source, given.count, given.seed)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        done, ranks = [], collections.Counter()
        for one in pool.map(lambda pair: try_file(given.batten, *pair, given.seed), chosen):
            done.append(one)
            for check, how in one["wrong"].items():
                print(f"{check:8} {how:34} [{' '.join(one['causes'])}] {one['path'].relative_to(given.folder)}", flush=True)
                ranks.update((check, cause) for cause in one["causes"] or ["nothing listed"])
    for (check, cause), count in ranks.most_common():
        print(f"{count:5} {check:8} {cause}")
    print("\n".join(table(done)))


if __name__ == "__main__":
    main()
