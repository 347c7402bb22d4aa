#!/usr/bin/python3
"""Makes the manual, a folder of pages that needs no server and no framework: manual.py PROGRAM FOLDER [--bare].

Pages are Markdown and the program's manual by pandoc, and the C interface by headers.py. Pictures are made by the program; --bare
leaves them out, for a quick check. Fails when a link leads nowhere, or a function has no example.
"""
import concurrent.futures
import html
import json
import pathlib
import re
import shutil
import sys
import tempfile

import commands
import headers
import pages
import sessions
import tour

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The pages of each section, in order; the rest of docs/ follows in "More".
SECTIONS = [
    ("The papers", ["docs/papers/README.md", "docs/papers/tangents-1994.md", "docs/papers/sketch-2005.md", "docs/papers/levels-2016.md",
                    "docs/papers/errors.md"]),
    ("Why", ["docs/why/faster.md", "docs/why/cubics.md", "docs/why/frames.md"]),
    ("How fast", ["docs/benchmarks.md", "docs/user-test.md", "docs/jobs.md"]),
    ("Packages", ["bindings/js/core/README.md", "bindings/js/editor/README.md", "docs/react.md", "docs/vue.md", "docs/svelte.md", "docs/python.md"]),
    ("The program", ["docs/batten.1"]),
    ("Files", ["docs/format.md", "docs/journal.md"]),
    ("Mathematics", ["docs/math/sketch.md", "docs/math/levels.md", "docs/math/tangents.md", "docs/math/surfaces.md"]),
]
MORE_OF_TOOLS = {"levels": "docs/levels.md", "tangents": "docs/tangents.md", "surface": "docs/surface-tool.md",
                 "sketch": "docs/math/sketch.md"}


def title_of(source):
    if source.endswith(".1"):
        return "Command line: batten(1)"
    return re.search(r"^#+ (.*)$", (ROOT / source).read_text(encoding="utf-8"), re.M)[1]


def address_of(source):
    if source.startswith("bindings/js/"):
        return {"core": "npm.html", "editor": "npm-editor.html"}[source.split("/")[2]]
    return re.sub(r"\.(md|1)$", ".html", source.removeprefix("docs/").replace("README", "index"))


def tools():
    """Names, titles, help and keys of the tools, from the editor's tables."""
    table = (ROOT / "src/editor/tables/commands.def").read_text(encoding="utf-8")
    said, _ = commands.strings(ROOT)
    found = re.findall(r'^COMMAND\(TOOL_\w+, "tool-([\w-]+)", "([^"]*)"', table, re.M)
    return [(name, said[f"command.tool-{name}"], said[f"command.tool-{name}.help"], key) for name, key in found]


def tool_page(name, title, text, key, shown, manual):
    body = [f"<h1>{html.escape(title)}</h1>", f"<p>{html.escape(text)}</p>"]
    if key:
        body.append(f"<p>Its key is <kbd>{html.escape(key)}</kbd>.</p>")
    if shown:
        body.append(f'<figure><img src="{name}.gif" width="640" height="269" alt="The pen at work with the {html.escape(title.lower())}."></figure>'
                    '<p>The picture is made from a journal, a session as text: '
                    f'<a href="{name}.journal">{name}.journal</a>. Orange is the way of the pen. '
                    f'Run it: <code>batten replay {name}.journal --output {name}.svg</code>.</p>')
    if name in MORE_OF_TOOLS:
        body.append(f'<p>More: <a href="../{manual.sources[MORE_OF_TOOLS[name]]}">{html.escape(title_of(MORE_OF_TOOLS[name]))}</a>.</p>')
    return "\n".join(body)


def home(manual, bare):
    rows = []
    for address, page in manual.pages.items():
        if address != "index.html":
            rows.append((page["section"], f'<a href="{address}">{html.escape(page["title"])}</a>'))
    sections = list(dict.fromkeys(section for section, _ in rows))
    return ("<h1>Batten: the manual</h1><p>A pen-first editor for curves and surfaces, a C library, and a program for the shell.</p>"
            + ("" if bare else '<p><a href="../race.html">Compare curve fitting</a>: your own stroke, fitted by Batten and by two other libraries.</p>')
            + "".join(f'<h2>{section}</h2><p>{", ".join(link for other, link in rows if other == section)}</p>' for section in sections))


def main(program, folder, bare):
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "tools").mkdir(parents=True)
    manual = pages.Manual(ROOT, folder)
    manual.plan("index.html", "Contents", "Start", body="")
    if not bare:
        with tempfile.TemporaryDirectory() as aside:
            manual.plan("tour.html", "A tour in ten pictures", "Start", body=tour.make(program, ROOT, folder, pathlib.Path(aside)))
    listed = {source for _, sources in SECTIONS for source in sources}
    rest = sorted(str(path.relative_to(ROOT)) for path in ROOT.glob("docs/**/*.md"))
    math = [source for source in rest if source.startswith("docs/math/")]
    more = [source for source in rest if source not in listed and source not in math]
    for source in [*listed, *rest]:
        manual.sources[source] = address_of(source)
    shown = {} if bare else sessions.sessions(program, ROOT)
    for name, title, text, key in tools():
        manual.plan(f"tools/{name}.html", title, "Tools", body=tool_page(name, title, text, key, name in shown, manual))
    body, rows = commands.page(ROOT)
    manual.plan("commands.html", "Commands and keys", "Tools", body=body, rows=rows)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for name, lines in shown.items():
            (folder / "tools" / f"{name}.journal").write_text("".join(json.dumps(line) + "\n" for line in lines))
        list(pool.map(lambda name: sessions.moving(program, ROOT, shown[name], folder / "tools" / f"{name}.gif"), shown))
    for section, sources in [*SECTIONS, ("Mathematics", [source for source in math if source not in listed]), ("More", more)]:
        for source in sources:
            manual.plan(address_of(source), title_of(source), section, source)
    missing = headers.plan(manual, ROOT)
    manual.pages["index.html"]["body"] = home(manual, bare)
    manual.write()
    for name in ("manual.css", "search.js"):
        shutil.copyfile(ROOT / "tools" / "site" / name, folder / name)
    (folder / "words.js").write_text("globalThis.manualWords = " + json.dumps(manual.index, ensure_ascii=False) + ";\n", encoding="utf-8")
    found, count = pages.faults(folder)
    print("\n".join([*found, *(f"{name} has no example" for name in missing)]))
    print(f"{len(manual.pages)} pages, {count} links, {len(found)} lead nowhere; {len(missing)} functions without an example")
    return 1 if found or missing or count < 500 else 0


if __name__ == "__main__":
    given = [word for word in sys.argv[1:] if word != "--bare"]
    if len(given) != 2:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(given[0]).resolve(), pathlib.Path(given[1]).resolve(), "--bare" in sys.argv))
