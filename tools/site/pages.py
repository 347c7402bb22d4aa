"""Pages of Markdown and of the program's manual, by pandoc; links between them, and their pictures."""
import html
import pathlib
import re
import shutil
import subprocess

READER = "gfm+tex_math_dollars"
POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'")


def pandoc(text, reader=READER):
    made = subprocess.run(["pandoc", "--from", reader, "--to", "html5", "--mathml", "--no-highlight", "--wrap=none"],
                          input=text, text=True, capture_output=True, check=True)
    if "[WARNING]" in made.stderr:
        raise SystemExit(f"pandoc: {made.stderr}")
    body = re.sub(r"<colgroup>.*?</colgroup>", "", made.stdout, flags=re.S)
    body = re.sub(r' style="text-align: (\w+);"', r' class="\1"', body)  # the policy permits no inline style
    return re.sub(r'<table( style="[^"]*")?>', '<div class="wide"><table>', body).replace("</table>", "</table></div>")


class Manual:
    """The pages, by the files that they are made from."""

    def __init__(self, root, folder):
        self.root, self.folder = root, folder
        self.pages, self.sources, self.index = {}, {}, []

    def plan(self, address, title, section, source=None, body=None, rows=None, head=""):
        """
        A page of a Markdown file below the root, or of HTML; rows: what the search knows of it, if not its headings; head: HTML under
        its title.
        """
        self.pages[address] = {"title": title, "section": section, "source": source, "body": body, "rows": rows, "head": head}
        if source:
            self.sources[source] = address

    def text_of(self, page):
        text = (self.root / page["source"]).read_text(encoding="utf-8")
        return pandoc(text, "man" if page["source"].endswith(".1") else READER)

    def _target(self, page, address, target):
        """Where a link of a page leads in the manual; None: to a file of the repository that is no part of it."""
        if re.match(r"[a-z]+:|#", target) or not page["source"]:
            return target
        path, _, mark = target.partition("#")
        file = (self.root / page["source"]).parent.joinpath(path).resolve()
        try:
            name = str(file.relative_to(self.root))
        except ValueError:
            return None
        depth = "../" * address.count("/")
        if name in self.sources:
            return depth + self.sources[name] + (f"#{mark}" if mark else "")
        if file.suffix in (".png", ".svg", ".gif", ".json", ".batten", ".journal") and file.is_file():
            place = self.folder / "files" / name.replace("/", "-")
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, place)
            return f"{depth}files/{place.name}"
        return None

    def _editor(self, address, target, title):
        """The editor's address for a drawing or a journal of the manual: where a link leads whose title is "editor", or "study"."""
        depth = "../" * address.count("/")
        kind = "study" if title == "study" else "play" if target.endswith(".journal") else "open"
        return f"{depth}../#{kind}={self.folder.name}/{target.removeprefix(depth)}"

    def _relink(self, page, address, body):
        def anchor(match):
            target = self._target(page, address, html.unescape(match[1]))
            title = re.search(r'title="(editor|study)"', match[0])
            if target is not None and title:
                target = self._editor(address, target, title[1])
            if target is None:
                return f"<span class=\"file\">{match[2]}</span>"
            return f'<a href="{html.escape(target)}">{match[2]}</a>'

        body = re.sub(r'<a href="([^"]*)"[^>]*>(.*?)</a>', anchor, body, flags=re.S)
        return re.sub(r'(<img src=")([^"]*)"', lambda m: f'{m[1]}{self._target(page, address, m[2])}"', body)

    def _nav(self, address):
        depth = "../" * address.count("/")
        parts, section = [], None
        for other, page in self.pages.items():
            if page["section"] != section:
                parts.append(("</ul></details>" if section is not None else "")
                             + f'<details{" open" if page["section"] == self.pages[address]["section"] else ""}>'
                             f'<summary>{html.escape(page["section"])}</summary><ul>')
                section = page["section"]
            here = ' aria-current="page"' if other == address else ""
            parts.append(f'<li><a href="{depth}{other}"{here}>{html.escape(page["title"])}</a></li>')
        return "".join(parts) + "</ul></details>"

    def _note(self, address, page, body):
        """What the search knows of a page: a row for each heading, and how soon it is shown."""
        if page["rows"] is not None:
            self.index += [[page["title"], title, address + mark, text, rank(address)] for title, mark, text in page["rows"]]
            return
        pieces = re.split(r"<h([1-4])([^>]*)>(.*?)</h\1>", body, flags=re.S)
        rows = [(page["title"], "", pieces[0])]
        for i in range(1, len(pieces), 4):
            mark = re.search(r'id="([^"]+)"', pieces[i + 1])
            rows.append((plain(pieces[i + 2]), f"#{mark[1]}" if mark else "", pieces[i + 3]))
        for title, mark, text in rows:
            words = plain(text)[:1200]
            if title or words:
                self.index.append([page["title"], title, address + mark, words, rank(address)])

    def write(self):
        for address, page in self.pages.items():
            body = page["body"] if page["body"] is not None else self._relink(page, address, self.text_of(page))
            body = body.replace("</h1>", f"</h1>{page['head']}", 1)
            self._note(address, page, body)
            depth = "../" * address.count("/")
            where = self.folder / address
            where.parent.mkdir(parents=True, exist_ok=True)
            where.write_text(
                '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
                f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n'
                f'<title>{html.escape(page["title"])}: Batten</title>\n'
                f'<meta property="og:title" content="{html.escape(page["title"])}: Batten">\n'
                f'<meta property="og:description" content="{html.escape(first_words(body))}">\n'
                '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
                '<meta name="color-scheme" content="light dark">\n'
                f'<link rel="icon" href="{depth}batten.svg">\n<link rel="stylesheet" href="{depth}manual.css">\n<script src="{depth}search.js" defer></script>\n</head>\n'
                f'<body data-depth="{depth}">\n<header><a class="brand" href="{depth}index.html"><img src="{depth}batten.svg" alt="" width="24" height="24"> Batten</a> '
                f'<a href="{depth}index.html">Manual</a> <a href="{depth}../">Editor</a> '
                '<input type="search" id="search" placeholder="Search" aria-label="Search the manual"></header>\n'
                f'<nav aria-label="Pages">{self._nav(address)}</nav>\n'
                f'<main><ol id="found" hidden></ol><article>{body}</article></main>\n</body>\n</html>\n', encoding="utf-8")


# How soon the search shows a page: what one does in the editor first, then what users read, what developers read, the C interface.
FIRST, LAST = r"learn/|commands\.html|tools/|tour\.html", r"api/"
DEVELOPERS = (r"(math|why|papers)/|(architecture|benchmarks|coverage|design|hand|interface|journal|jobs|npm|npm-editor|packages|python|references|"
              r"reliability|site|testing|user-test|batten|format)\.html")


def rank(address):
    return 3 if re.match(FIRST, address) else 0 if re.match(LAST, address) else 1 if re.match(DEVELOPERS, address) else 2


def plain(text):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", " ", text))).strip()


def first_words(body):
    """The first paragraph, or as much of it as a preview shows."""
    text = plain((re.search(r"<p[^>]*>(.*?)</p>", re.sub(r"<figure>.*?</figure>|<p><a class=\"button.*?</p>", "", body, flags=re.S), re.S) or [0, ""])[1])
    return text if len(text) < 200 else text[:text.rindex(" ", 0, 200)] + " ..."


def faults(folder):
    """Links and pictures of the pages that lead nowhere, and what else must not be in them."""
    folder = pathlib.Path(folder)
    marks, found, count = {}, [], 0
    for file in folder.rglob("*.html"):
        marks[file] = set(re.findall(r'\bid="([^"]+)"', file.read_text(encoding="utf-8")))
    for file in marks:
        text = file.read_text(encoding="utf-8")
        if "$$" in text or re.search(r'<(script|style)>|<[a-z][^>]*\sstyle="', text):
            found.append(f"{file.relative_to(folder)}: a formula that was not understood, or what the policy forbids")
        for target in re.findall(r'(?:href|src)="([^"]*)"', text):
            if re.match(r"[a-z]+:", target):
                continue
            count += 1
            path, _, mark = html.unescape(target).partition("#")
            there = (file.parent / path).resolve() if path else file
            if there == folder.parent:
                continue  # the editor
            if not there.exists() or (mark and there in marks and mark not in marks[there]):
                found.append(f"{file.relative_to(folder)}: {target}")
    return found, count
