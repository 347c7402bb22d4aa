#!/usr/bin/python3
"""Makes every figure of the papers: make.py PROGRAM [FOLDER]

For each figure: the journal that redoes it and the document it leads to (examples/papers), the picture, and its block in the page
(docs/papers), with the numbers beside the paper's. With a folder all is written there instead and compared with what stands in
the project, number by number; what differs is said, and the exit status is 1.
"""
import json
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import levels  # noqa: E402
import sketch  # noqa: E402
import tangents  # noqa: E402
from scene import Picture, Program  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = {"docs/papers/tangents-1994.md": tangents, "docs/papers/sketch-2005.md": sketch, "docs/papers/levels-2016.md": levels}
NUMBER = re.compile(r"-?\d+\.?\d*(?:[eE][-+]?\d+)?")


def text_of(lines):
    return "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)


def block(figure):
    """What a page shows of a figure, between its marks."""
    number = figure.name.split("-")[1]
    journal = figure.journal if isinstance(figure.journal, str) else f"examples/papers/{figure.name}.journal"
    own = [f"docs/papers/pictures/{figure.name}.svg"] if isinstance(figure.picture, Picture) else figure.picture
    pictures = [own] if isinstance(own, str) else own
    parts = [" ".join(f"![Figure {number}]({os.path.relpath(picture, 'docs/papers')})" for picture in pictures)]
    there = figure.document if isinstance(figure.document, str) else f"examples/papers/{figure.name}.batten"
    parts.append(f'[Open it in the editor](../../{there} "editor") · [See it redone by hand](../../{journal} "editor")')
    commands = figure.commands or (f"batten replay {journal} --output figure.batten",)
    parts.append("```sh\n" + "\n".join(commands) + "\n```")
    if figure.rows:
        parts.append("\n".join(["| | the paper | here |", "|---|--:|--:|", *(f"| {what} | {paper} | {here} |" for what, paper, here in figure.rows)]))
    return "\n\n".join(parts)


def make(program, folder):
    """All files, below a folder that mirrors the project. Their names."""
    made = []

    def write(name, text):
        where = folder / name
        where.parent.mkdir(parents=True, exist_ok=True)
        where.write_text(text, encoding="utf-8")
        made.append(name)

    for page, paper in PAGES.items():
        text = (ROOT / page).read_text(encoding="utf-8")
        for figure in paper.figures(program, ROOT):
            if not isinstance(figure.journal, str):
                write(f"examples/papers/{figure.name}.journal", text_of(figure.journal))
            if isinstance(figure.document, dict):
                write(f"examples/papers/{figure.name}.batten", json.dumps(figure.document, separators=(",", ":")) + "\n")
            if isinstance(figure.picture, Picture):
                write(f"docs/papers/pictures/{figure.name}.svg", figure.picture.svg())
            mark = f"<!-- figure {figure.name} -->"
            if mark not in text:
                raise SystemExit(f"{page}: expected {mark}, found none")
            first, _, rest = text.partition(mark)
            text = first + mark + "\n\n" + block(figure) + "\n\n<!-- end -->" + rest.partition("<!-- end -->")[2]
        write(page, text)
    return made


def differ(one, other):
    """Where two texts differ in more than the last digits of their numbers; None: nowhere."""
    words, others = NUMBER.split(one), NUMBER.split(other)
    if words != others:
        return "words"
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        if abs(float(a) - float(b)) > 1e-6 * max(1, abs(float(a)), abs(float(b))):
            return f"{a} and {b}"
    return None


def main(program, folder):
    made = make(Program(program), folder or ROOT)
    if not folder:
        return 0
    wrong = 0
    for name in made:
        if not (ROOT / name).is_file():
            why = "is not in the project"
        else:
            why = differ((folder / name).read_text(encoding="utf-8"), (ROOT / name).read_text(encoding="utf-8"))
        if why:
            print(f"{name}: {why}")
            wrong += 1
    print(f"{len(made)} files made, {wrong} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else None))
