"""The page of all commands and settings, from the editor's tables: name, keys, what it does; and the other words by which the list of
commands, and the manual's search, find each."""
import html
import re

TABLES = "src/editor/tables"


def strings(root):
    """English texts by key: those of TEXT and HELP, and those of WORDS, without what is not in Latin letters."""
    table = (root / TABLES / "strings.def").read_text(encoding="utf-8")
    said = dict(re.findall(r'^(?:TEXT|HELP|LATE)\(\w+, "([^"]+)", "((?:[^"\\]|\\.)*)"', table, re.M))
    words = dict(re.findall(r'^WORDS\("([^"]+)\.words", "((?:[^"\\]|\\.)*)"', table, re.M))
    return said, {key: " ".join(word for word in text.split() if word.isascii()) for key, text in words.items()}


def rows(root):
    """Groups in the table's order: heading, then name, keys, help and other words of each that a person can choose."""
    said, words = strings(root)
    groups = []
    for kind, rest in re.findall(r"^(SECTION|SUBJECT|COMMAND|PROPERTY)\((.*)\)$", (root / TABLES / "commands.def").read_text(encoding="utf-8"), re.M):
        if kind in ("SECTION", "SUBJECT"):
            heading = said.get(f"shell.{rest.lower().replace('_', '-')}", rest.capitalize())
            groups.append((f"Settings: {heading.lower()}" if kind == "SUBJECT" else heading, []))
            continue
        name = re.search(r'"([^"]*)"', rest)
        if not name or not groups:
            continue  # how the table's macros are written
        key = f"{kind.lower()}.{name[1]}"
        if key in said:
            keys = re.findall(r'"([^"]*)"', rest)[1] if kind == "COMMAND" else ""
            groups[-1][1].append((key.replace(".", "-"), said[key], keys, said.get(f"{key}.help", ""), words.get(key, "")))
    elsewhere = [(key.replace(".", "-"), said[key], "", said.get(f"{key}.help", ""), words[key])
                 for key in words if key.startswith("shell.") and key in said]
    return [(heading, found) for heading, found in [*groups, ("Bars and menus", elsewhere)] if found]


def page(root):
    """The page's body, and what the search knows of it: title, mark and text of each row."""
    body, index = ["<h1>Commands and keys</h1>", "<p>All of what the list of commands (<kbd>Ctrl+K</kbd>) and the settings hold. "
                   "Keys can be changed in the settings.</p>"], []
    for heading, found in rows(root):
        body += [f"<h2>{html.escape(heading)}</h2>", '<div class="wide"><table><thead><tr><th></th><th>keys</th><th></th></tr></thead><tbody>']
        for mark, title, keys, text, words in found:
            shown = " ".join(f"<kbd>{html.escape(key)}</kbd>" for key in keys.split())
            body.append(f'<tr id="{mark}"><td>{html.escape(title)}</td><td>{shown}</td><td>{html.escape(text)}</td></tr>')
            index.append((title, f"#{mark}", f"{text} {keys} {words}"))
        body.append("</tbody></table></div>")
    return "\n".join(body), index
