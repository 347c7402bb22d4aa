"""The C interface as pages, rendered from the headers: every declaration with its comment, and for every function a place in
a program that is compiled and run by the tests."""
import html
import re

CALL = re.compile(r"\b(bat_\w+)\s*\(")


def functions_of(code):
    """The functions that a piece of a header declares for users."""
    found = re.findall(r"BAT_API[^;{]*?\b(bat_\w+)\s*\(", code)
    return found + re.findall(r"static inline[^;{]*?\b(bat_\w+)\s*\(", code)


class Examples:
    """Where functions are called: examples first, then tests, then the programs that the fuzzer runs."""

    def __init__(self, root):
        self.places = {}
        files = [*sorted(root.glob("examples/*.c")), *sorted(root.glob("tests/consumer/**/*.c")),
                 *sorted(root.glob("tests/**/test_*.c")), *sorted(root.glob("fuzz/fuzz_*.c"))]
        for file in files:
            lines = file.read_text(encoding="utf-8").splitlines()
            for number, line in enumerate(lines):
                for name in CALL.findall(line):
                    if not re.match(r"\s*(\*|//)", line):
                        self.places.setdefault(name, (file.relative_to(root), lines, number))

    def of(self, name):
        """HTML, or None."""
        if name not in self.places:
            return None
        file, lines, number = self.places[name]
        first, last = max(number - 3, 0), min(number + 4, len(lines))
        piece = lines[first:last]
        indent = min((len(line) - len(line.lstrip()) for line in piece if line.strip()), default=0)
        code = html.escape("\n".join(line[indent:] for line in piece))
        code = re.sub(rf"\b{name}\b", f"<b>{name}</b>", code)
        return (f'<details class="example"><summary>{name} in <span class="file">{file}</span>, line {number + 1}</summary>'
                f"<pre><code>{code}</code></pre></details>")


def said(comment):
    """The text of a comment, as paragraphs."""
    text = re.sub(r"^/\*+|\*/$", "", comment.strip())
    lines = [re.sub(r"^\s*\* ?", "", line).rstrip() for line in text.splitlines()]
    paragraphs, now = [], []
    for line in [*lines, ""]:
        if line.strip():
            now.append(line)
        elif now:
            paragraphs.append(now)
            now = []
    out = []
    for block in paragraphs:
        aligned = sum(bool(re.search(r"\S {2,}\S", line)) or line.startswith("  ") for line in block)
        body = html.escape("\n".join(block))
        out.append(f"<pre class=\"told\">{body}</pre>" if aligned * 2 > len(block) else f"<p>{body}</p>")
    return "".join(out)


def body_of(path):
    """The header without what only the compiler needs."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"#ifdef __cplusplus\n.*?#endif\n", "", text, flags=re.S)
    text = re.sub(r"#ifndef BATTEN_\w+_H\n#define BATTEN_\w+_H\n", "", text)
    text = re.sub(r"#endif[^\n]*\n?\Z", "", text.rstrip() + "\n")
    return re.sub(r"#include [^\n]*\n", "", text)


def blocks(text):
    """Pieces of comment and of code, in order."""
    at, pieces = 0, []
    for match in re.finditer(r"^/\*.*?\*/[ \t]*\n", text, re.S | re.M):
        pieces += [("code", text[at:match.start()]), ("comment", match[0])]
        at = match.end()
    return [(kind, piece) for kind, piece in [*pieces, ("code", text[at:])] if piece.strip()]


def page_of(path, homes, examples, missing):
    """HTML of a header. homes: the page of each name; missing: functions without an example are added to it."""
    title = path.name
    out = [f"<h1 id=\"top\">{title}</h1>", f"<p class=\"include\"><code>#include &lt;batten/{title}&gt;</code></p>"]
    for kind, piece in blocks(body_of(path)):
        if kind == "comment":
            out.append(said(piece))
            continue
        names = functions_of(piece)
        out += [f'<h4 id="{name}"><code>{name}</code></h4>' for name in names if f'id="{name}"' not in "".join(out)]
        out.append(f"<pre><code>{html.escape(piece.strip(chr(10)))}</code></pre>")
        for name in names:
            example = examples.of(name)
            if example:
                out.append(example)
            elif not re.search(rf"static inline[^;{{]*\b{name}\b", piece):
                missing.append(name)

    def link(match):
        home = homes.get(match[0])
        return f'<a href="{home}#{match[0]}">{match[0]}</a>' if home else match[0]

    parts = re.split(r"(<h4.*?</h4>|<summary>.*?</summary>)", "\n".join(out), flags=re.S)
    return "".join(part if i % 2 else re.sub(r"\bbat_\w+\b", link, part) for i, part in enumerate(parts))


def plan(manual, root):
    """Adds a page for each header; returns the functions that have no example."""
    examples, missing, homes = Examples(root), [], {}
    headers = sorted((root / "include" / "batten").glob("*.h"))
    for path in headers:
        for name in functions_of(body_of(path)):
            homes.setdefault(name, path.name.replace(".h", ".html"))
    for path in headers:
        if path.name in ("batten.h", "before_0_2.h"):
            continue
        manual.plan(f"api/{path.stem}.html", path.name, "C interface", body=page_of(path, homes, examples, missing))
    return missing
