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
import films
import headers
import learn
import pages
import sessions
import tour

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The pages of each section, in order; the rest of docs/ follows in "More".
SECTIONS = [
    ("Tools", ["docs/hands.md", "docs/keyboard.md", "docs/precision.md", "docs/levels.md", "docs/tangents.md", "docs/surface-tool.md"]),
    ("Recipes", ["docs/surfaces-from-curves.md", "docs/character-line.md", "docs/relief.md", "docs/surfaces.md", "docs/camera-moves.md",
                 "docs/jobs.md"]),
    ("Files", ["docs/safety.md", "docs/format.md", "docs/journal.md"]),
    ("The papers", ["docs/papers/README.md", "docs/papers/tangents-1994.md", "docs/papers/sketch-2005.md", "docs/papers/levels-2016.md",
                    "docs/papers/errors.md", "docs/why/cubics.md", "docs/why/frames.md"]),
    ("Developers", ["docs/batten.1", "bindings/js/core/README.md", "bindings/js/editor/README.md", "docs/react.md", "docs/vue.md",
                    "docs/svelte.md", "docs/python.md", "docs/packages.md", "docs/interface.md", "docs/benchmarks.md", "docs/why/faster.md"]),
    ("Mathematics", ["docs/math/sketch.md", "docs/math/levels.md", "docs/math/tangents.md", "docs/math/surfaces.md"]),
]
# What the cards of the first page lead to: a title, an address, and what is behind it.
CARDS = [
    ("Learn", "learn/draw.html", "Five short pages: draw, levels, tangents, surfaces, camera. Each opens in the editor."),
    ("Tools", "tools/sketch.html", "What each tool does, its options, its keys, and two tips."),
    ("Files", "safety.html", "Where drawings are kept, and what goes out to other programs, in true size."),
    ("Developers", "npm.html", "The library in C, C++, JavaScript and Python, and the program for the shell."),
]
SAYS = "Draw over a curve, and it follows the pen. An editor for curves and surfaces, a C library, and a program for the shell."
TIPS = "docs/tools.md"
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


def tips():
    """Two tips for each tool, by its name, as HTML."""
    parts = re.split(r"^## (.*)$", (ROOT / TIPS).read_text(encoding="utf-8"), flags=re.M)
    return {name: pages.pandoc(text) for name, text in zip(parts[1::2], parts[2::2])}


def options():
    """Names of the properties of each tool, as the page shows them."""
    text = (ROOT / "web/sheets/options.js").read_text(encoding="utf-8")
    table = text[text.index("const OF = {"):text.index("};", text.index("const OF = {"))]
    return {name: re.findall(r"'([\w-]+)'", row) for name, row in re.findall(r"(\w+): \[(.*?)\]", table)}


def tool_page(name, title, text, key, shown, manual, tip, properties):
    said, _ = commands.strings(ROOT)
    body = [f"<h1>{html.escape(title)}</h1>", f"<p>{html.escape(text)}</p>"]
    if key:
        body.append(f"<p>Its key is <kbd>{html.escape(key)}</kbd>.</p>")
    if shown:
        body.append(f'<figure><img src="{name}.gif" width="640" alt="The pen at work with the {html.escape(title.lower())}."></figure>'
                    '<p>The picture is made from a journal, a session as text: '
                    f'<a href="{name}.journal">{name}.journal</a>. {"" if shown[1] else "Orange is the way of the pen. "}'
                    f'Run it: <code>batten replay {name}.journal --output {name}.svg</code>.</p>')
    body += ["<h2>Two tips</h2>", tip]
    if properties:
        rows = "".join(f'<tr><td><a href="../commands.html#property-{one}">{html.escape(said[f"property.{one}"])}</a></td>'
                       f'<td>{html.escape(said.get(f"property.{one}.help", ""))}</td></tr>' for one in properties)
        body.append(f"<h2>Options</h2><p>They stand in the bar while the tool is in hand.</p><table>{rows}</table>")
    if name in MORE_OF_TOOLS:
        body.append(f'<p>More: <a href="../{manual.sources[MORE_OF_TOOLS[name]]}">{html.escape(title_of(MORE_OF_TOOLS[name]))}</a>.</p>')
    return "\n".join(body)


def home(bare):
    cards = "".join(f'<li><a href="{address}"><strong>{name}</strong> {html.escape(text)}</a></li>' for name, address, text in CARDS)
    film = "" if bare else '<figure><img src="learn/levels.gif" width="640" height="269" alt="The back of a crocodile is bent, and its scales come along."></figure>'
    race = "" if bare else '<p><a href="../race.html">Compare curve fitting</a>: your own stroke, fitted by Batten and by two other libraries.</p>'
    return f'<h1>Batten</h1><p class="promise">{html.escape(SAYS)}</p>{film}<ul class="cards">{cards}</ul>{race}'


def main(program, folder, bare):
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("tools", "learn"):
        (folder / name).mkdir(parents=True)
    manual = pages.Manual(ROOT, folder)
    manual.plan("index.html", "Contents", "Start", body=home(bare))
    if not bare:
        with tempfile.TemporaryDirectory() as aside:
            manual.plan("tour.html", "A tour in ten pictures", "Start", body=tour.make(program, ROOT, folder, pathlib.Path(aside)))
    listed = {source for _, sources in SECTIONS for source in sources}
    rest = sorted(str(path.relative_to(ROOT)) for path in ROOT.glob("docs/**/*.md"))
    rest = [source for source in rest if source != TIPS and not source.startswith("docs/learn/")]
    math = [source for source in rest if source.startswith("docs/math/")]
    more = [source for source in rest if source not in listed and source not in math]
    for source in [*listed, *rest]:
        manual.sources[source] = address_of(source)
    learnt = learn.journals(program, ROOT)
    for name, (lines, _) in learnt.items():
        (folder / "learn" / f"{name}.journal").write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
        source = f"docs/learn/{name}.md"
        manual.plan(f"learn/{name}.html", title_of(source), "Learn", source, head=learn.head(name, not bare))
    shown = {} if bare else sessions.sessions(program, ROOT)
    tip, properties = tips(), options()
    for name, title, text, key in tools():
        manual.plan(f"tools/{name}.html", title, "Tools",
                    body=tool_page(name, title, text, key, shown.get(name), manual, tip[name], properties.get(name, [])))
    body, rows = commands.page(ROOT)
    manual.plan("commands.html", "Commands and keys", "Tools", body=body, rows=rows)
    for name, (lines, _) in shown.items():
        (folder / "tools" / f"{name}.journal").write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        made = [pool.submit(films.make, program, ROOT, *session, folder / kind / f"{name}.gif")
                for kind, of in (("tools", shown), ("learn", {} if bare else learnt)) for name, session in of.items()]
        for film in made:
            film.result()
    for section, sources in [*SECTIONS, ("Mathematics", [source for source in math if source not in listed]), ("More", more)]:
        for source in sources:
            manual.plan(address_of(source), title_of(source), section, source)
    missing = headers.plan(manual, ROOT)
    manual.write()
    for name in ("tools/site/manual.css", "tools/site/search.js", "web/icons/batten.svg"):
        shutil.copy(ROOT / name, folder)
    for face in list(folder.parent.glob("*/fonts/inter.woff2"))[:1]:  # the editor's
        shutil.copy(face, folder)
        shutil.copy(face.with_name("OFL.txt"), folder)
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
