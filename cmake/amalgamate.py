#!/usr/bin/env python3
"""The library as two files, batten.c and batten.h. Usage: amalgamate.py ROOT OUT_DIR

batten.h holds the public headers, batten.c the internal headers and then all sources. What belongs to one source alone
(static functions and variables, types, tags, constants) gets the source's path added to its name, wherever the source
uses it: nothing clashes, not even with what the headers of some system declare. Macros of a source end with it.
"""
import re
import subprocess
import sys
from pathlib import Path

TOKEN = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|[A-Za-z_]\w*|\.?\d(?:[eEpP][+-]|[\w.])*"
                   r"|->|\.\.\.|\\\n|\s+|.", re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+([<"])([^>"]+)[>"][^\n]*\n', re.M)
DEFINE = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.M)
WORD = re.compile(r"[A-Za-z_]\w*\Z")
SPECIFIERS = {"static", "inline", "const", "typedef", "struct", "union", "enum", "volatile", "void"}


def tokens(text):
    return TOKEN.findall(text)


def bare(text):
    """The tokens that declarations consist of: no comments, spaces and lines of the preprocessor."""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", "", text, flags=re.M)
    return [t for t in tokens(text) if not t.isspace() and not t.startswith("//")]


def declarations(text):
    """Each declaration at file scope, as its tokens; bodies of functions are left out."""
    out, now, depth = [], [], 0
    for t in bare(text):
        now.append(t)
        depth += (t in "({[") - (t in ")}]") if len(t) == 1 else 0
        if depth == 0 and (t == ";" or t == "}" and is_function(now)):
            out.append(now)
            now = []
    return out


def is_function(declaration):
    """Its last brace closes the body of a function, or a block of extern "C"."""
    depth, before = 0, ""
    for t in declaration:
        if t == "{" and depth == 0:
            return before == ")"
        depth += (t in "([{") - (t in ")]}") if len(t) == 1 else 0
        before = t
    return False


def declared(declaration):
    """The names that a declaration brings to file scope, and whether they belong to this file alone."""
    names = []
    local = any(t in ("static", "typedef", "BAT_INLINE") for t in declaration[:4])
    flat, depth = [], 0
    for i, t in enumerate(declaration):
        if t in ("struct", "union", "enum") and i + 2 < len(declaration) and declaration[i + 2] == "{":
            names.append(declaration[i + 1])
        if t == "enum" and (declaration[i + 1] == "{" or declaration[i + 2:i + 3] == ["{"]):
            names += constants(declaration, declaration.index("{", i))
        if len(t) == 1 and t in "}":
            depth -= 1
        if depth == 0 and t != "}":
            flat.append(t)
        if t == "{":
            depth += 1
    if local:
        names += declarators(flat)
    return names


def constants(declaration, start):
    names, depth = [], 0
    for k in range(start, len(declaration)):
        t = declaration[k]
        if t == "}" and depth == 1:
            break
        depth += (t in "({[") - (t in ")}]") if len(t) == 1 else 0
        if depth == 1 and WORD.match(t) and declaration[k - 1] in "{,":
            names.append(t)
    return names


def declarators(flat):
    """static int a = 1, b[3]; static int (*table[])(int); static int f(int x) ..."""
    names, depth, open_for_name = [], 0, True
    for k, t in enumerate(flat):
        following = flat[k + 1] if k + 1 < len(flat) else ";"
        if open_for_name and WORD.match(t) and t not in SPECIFIERS and t != "__attribute__":
            pointer = depth == 1 and following in ")[(" and "*" in flat[max(0, k - 3):k]
            if (depth == 0 and following in ";,=[({") or pointer:
                names.append(t)
                open_for_name = False
        depth += (t in "([") - (t in ")]") if len(t) == 1 else 0
        if t == "," and depth == 0:
            open_for_name = True
    return names


def members(text):
    """Where in tokens(text) a word is the name of a member that is declared there."""
    found, all_tokens = set(), tokens(text)
    solid = [i for i, t in enumerate(all_tokens) if not t.isspace() and t != "\\\n" and not t.startswith(("/*", "//"))]
    kinds, first, parens = [], 0, 0
    for n, i in enumerate(solid):
        t = all_tokens[i]
        before = all_tokens[solid[n - 1]] if n else ";"
        after = all_tokens[solid[n + 1]] if n + 1 < len(solid) else ";"
        if t == "{":
            back = [all_tokens[solid[k]] for k in range(max(0, n - 2), n)]
            kinds.append(bool({"struct", "union"} & set(back)) and before != ")" and before != "=")
            first, parens = n + 1, 0
        elif t == "}":
            if kinds:
                kinds.pop()
            first, parens = n + 1, 0
        elif t == ";":
            first, parens = n + 1, 0
        elif t in ("(", "["):
            parens += 1
        elif t in (")", "]"):
            parens -= 1
        elif kinds and kinds[-1] and WORD.match(t):
            plain = parens == 0 and after in (",", ";", "[", ":") and (n > first or before == "}")
            if plain and before not in ("struct", "union", "enum") or parens == 1 and before == "*" and after in (")", "["):
                found.add(i)
    return found


def renamed(text, names):
    """The text with other names for what belongs to the file, but for members of structs."""
    if not names:
        return text
    apart, out, last, offset = members(text), [], "", 0
    for i, t in enumerate(tokens(text)):
        if t == "offsetof":
            offset = 1
        elif offset and t == ",":
            offset = 2
        elif offset and t == ")":
            offset = 0
        if t in names and last not in (".", "->") and i not in apart and offset != 2:
            t = names[t]
        out.append(t)
        if not t.isspace() and t != "\\\n" and not t.startswith("/*"):
            last = t
    return "".join(out)


class Library:
    def __init__(self, root, made):
        self.root = root
        self.src = root / "src"
        self.made = made # headers that the build makes
        self.version = re.search(r'BAT_VERSION "([^"]+)"', (root / "include/batten/base.h").read_text()).group(1)
        self.system = set()

    def place(self, kind, name, beside):
        """The file that an include means, None for one of the system."""
        path = self.root / "include" / name if name.startswith("batten/") else self.src / name
        if kind == '"' and not path.exists():
            path = self.made / name
        if kind == '"' and not path.exists():
            path = beside.parent / name
        return path if path.exists() else None

    def expand(self, path, done, public):
        """The text of a header, each header that it needs before it; tables are copied wherever they are included."""
        def put(match):
            other = self.place(match.group(1), match.group(2), path)
            if other is None:
                self.system.add(match.group(2))
                return match.group(0) if public else ""
            inside = other.is_relative_to(self.root / "include")
            if other.suffix == ".def":
                return self.expand(other, done, public)
            if inside != public or other in done:
                return ""
            done.add(other)
            return self.expand(other, done, public)
        text = path.read_text()
        if path.suffix == ".c":
            text = re.sub(r"\A\s*", "", text)
        return INCLUDE.sub(put, text)

    def header(self):
        text = self.expand(self.root / "include/batten/batten.h", set(), True)
        return banner(self.root, f"Batten {self.version}: every public header in one.") + text

    def source(self):
        sources = sorted(self.src.rglob("*.c"))
        headers = sorted(self.src.rglob("*.h")) + sorted(self.made.rglob("*.h"))
        done, shared = set(), []
        for path in headers:
            if path not in done:
                done.add(path)
                shared.append(self.expand(path, done, False))
        texts = {path: self.expand(path, done, False) for path in sources}
        parts = [banner(self.root, f"Batten {self.version}: the whole library in one file. cc -std=c17 -O2 -c batten.c, and link "
                        "with -lm.\n * Made from the sources; change those."), PRELUDE]
        parts += [f"#include <{name}>\n" for name in sorted(self.system)]
        parts += ["\n"] + shared
        for path, text in texts.items():
            stem = "_".join(path.relative_to(self.src).with_suffix("").parts)
            own = {n for d in declarations(text) for n in declared(d) if not n.lower().startswith("bat_")}
            pasted = tuple(re.findall(r"(\w+_)##", text)) # names that macros put together
            names = {n: f"{n}_{stem}" for n in own if not pasted or not n.startswith(pasted)}
            macros = sorted(set(DEFINE.findall(text)))
            parts.append(f"\n/* ---- {path.relative_to(self.root)} ---- */\n{renamed(text, names)}")
            parts += [f"#undef {name}\n" for name in macros]
        return "".join(parts)


PRELUDE = """#define BATTEN_ONLY_0_2
#include "batten.h"

/* The same bits on every machine: products and sums are rounded one by one. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && !defined(__STRICT_ANSI__) && defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

"""


def banner(root, text):
    licence = (root / "LICENSE").read_text().strip().replace("\n", "\n * ").replace(" * \n", " *\n")
    return f"/* {text}\n *\n * {licence} */\n"


def make_ids(root, path):
    """The enums of the tables, as the build makes them."""
    tables = root / "src/editor/tables"
    subprocess.run(["cmake", f"-DSTRINGS={tables}/strings.def", f"-DCOMMANDS={tables}/commands.def", f"-DOUT={path}", "-P",
                    str(root / "cmake/ids.cmake")], check=True)


def main():
    root, out = Path(sys.argv[1]), Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    make_ids(root, out / "made/editor/tables/ids.h")
    library = Library(root, out / "made")
    source = library.source()
    (out / "batten.h").write_text(library.header(), encoding="utf-8")
    (out / "batten.c").write_text(source, encoding="utf-8")


main()
