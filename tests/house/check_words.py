#!/usr/bin/env python3
"""The browser shell contains no texts itself: all come from src/editor/tables/strings.def. index.html has no text
except the name and the messages for a failed load and for a browser without scripts; the scripts have no sentence and set no literal text on an element.
Every key that the shell uses is in the table. The front page of a static host and the race have tables of their own, web/site/*.json, in
both languages, too.

Usage: check_words.py ROOT
"""
import html.parser
import json
import pathlib
import re
import sys

from sources import sources

root = pathlib.Path(sys.argv[1])
faults = []
keys = set(re.findall(r'^(?:TEXT|HELP|LATE)\(\w+, "([^"]+)"', (root / "src/editor/tables/strings.def").read_text("utf-8"), re.M))
asked = set()


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.skipped = 0  # depth inside elements that may contain text

    def handle_starttag(self, tag, attributes):
        if tag in ("meta", "link", "img", "input"):
            self.check(tag, attributes)
            return
        self.skipped += bool(self.skipped or dict(attributes).get("id") == "failed" or tag in ("script", "noscript"))
        self.check(tag, attributes)

    def check(self, tag, attributes):
        for name, value in attributes:
            if name in ("aria-label", "title", "placeholder", "alt") and value != "Batten":
                faults.append(f"web/index.html: {tag} {name}={value!r}")
            if value and name in ("data-text", "data-label", "data-help"):
                asked.add(value)

    def handle_endtag(self, tag):
        self.skipped -= bool(self.skipped)

    def handle_data(self, data):
        if not self.skipped and re.search(r"\w", data) and data.strip() != "Batten":
            faults.append(f"web/index.html: {data.strip()!r}")


Page().feed((root / "web/index.html").read_text("utf-8"))

LITERAL = re.compile(r"'((?:[^'\\\n]|\\.)*)'|`((?:[^`\\]|\\.)*)`")
TOLD = re.compile(r"(textContent|innerText|\.title|\.placeholder|'aria-label'|'title')\s*(=|,)\s*$")
sprite = (root / "web/icons/sprite.svg").read_text("utf-8")
files = sources(root, ["web"], (".js",))
for path in files:
    text = path.read_text("utf-8")
    text = re.sub(r"/\*.*?\*/", lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.S)
    text = re.sub(r"(^|\s)//[^\n]*", r"\1", text)
    for found in LITERAL.finditer(text):
        words = found[1] if found[1] is not None else found[2]
        spoken = re.sub(r"\$\{[^}]*\}", "%", words)
        sentence = re.match(r"[^\w]*[A-Z][a-z]+[ ,]", spoken) or re.search(r"[a-z] [a-z]+\.$", spoken)
        given = TOLD.search(text[max(0, found.start() - 30):found.start()]) and re.search(r"[A-Za-z]{2}", spoken.replace("Batten", ""))
        if sentence or given:
            faults.append(f"{path.relative_to(root)}: {words!r}")
    asked |= set(re.findall(r"'(shell\.[a-z0-9-]+)'", text))
    asked |= {f"shell.{key}" for key in re.findall(r"#?text\('([a-z-]+)'\)", text)}
    if "`shell.${" in text:  # keys made from the names of sheets and of the bar's groups
        names = re.findall(r"'([a-z]+)'", text) + re.findall(r'data-group="(\w+)"', sprite.lower())
        asked |= {f"shell.{name}" for name in names} & keys

site = {path: json.loads(path.read_text("utf-8")) for path in sorted((root / "web/site").glob("*.json"))}
faults += [f"{path.relative_to(root)}: {key}" for path, all_words in site.items() for key, both in all_words.items()
           if len(both) != 2 or not all(both)]
for path in files:
    own = site.get(path.with_suffix(".json"), {})
    told = re.findall(r"\bsay\('([a-z.-]+)'\)", path.read_text("utf-8"))
    faults += [f"{path.relative_to(root)}: {key} is not in its words" for key in told if own and key not in own]
# What is searched is found by the words of others: each command and each setting has some, and none is left over.
defs = (root / "src/editor/tables/commands.def").read_text("utf-8")
commands = set(re.findall(r'^(?:COMMAND|HELD)\(\w+, "([^"]+)"', defs, re.M))
rows = re.findall(r'^PROPERTY\(\w+, "([^"]+)".*?([A-Z]+)\)$', re.sub(r",\n\s+", ", ", defs), re.M)
settings = {name for name, group in rows if group != "LEVELS"} - commands
searched = set(re.findall(r'^WORDS\("([^"]+)\.words", "[^"]', (root / "src/editor/tables/strings.def").read_text("utf-8"), re.M))
named = {f"command.{name}" for name in commands} | {f"property.{name}" for name in settings}
faults += [f"strings.def: {key} has no WORDS" for key in sorted(named - searched)]
faults += [f"strings.def: WORDS of {key}, which there is not" for key in sorted(searched - named)
           if not key.startswith("format.") and key not in keys]
faults += [f"{key}: not in strings.def" for key in sorted(asked - keys)]
print("\n".join(faults))
print(f"{len(files)} scripts and the page read, {len(faults)} faults")
sys.exit(1 if faults or not files else 0)
