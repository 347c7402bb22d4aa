"""The types of the Python package, from calls.json."""
import json
import re

HEAD = '''from typing import Any, Literal, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
Floats = NDArray[np.float64]
Stroke = Union[ArrayLike, dict[str, Any]]
Region = Union["Curve", Sequence["Curve"], dict[str, Any]]


class BattenError(ValueError):
    status: str
    code: int
    best: Any


'''
OWN = {"Curve": ["report: Any", "def frames(self, n: ArrayLike, *, rule: str = ..., substeps: int = ..., first: ArrayLike = ...) -> tuple[Floats, Floats, Floats, Floats, Floats]: ...",
                 "def finder(self) -> Finder: ...", "def to_svg(self, tolerance: float = ..., decimals: int = ...) -> str: ..."],
       "Chain": ["def many(self, u: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]: ..."],
       "Shape": ["report: Any"], "LiveSketch": ["def add(self, *place: float) -> LiveSketch: ..."]}
NUMBERS = {"double": "float", "int": "int", "size_t": "int", "bool": "bool"}


def snake(name):
    return re.sub(r"([A-Z]+)", lambda found: "_" + found[1].lower(), name)


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


class Stubs:
    def __init__(self, table):
        self.table, self.tuples = table, []

    def one(self, type_):
        type_ = bare(type_)
        if type_ in self.table["enums"]:
            return f"Literal[{', '.join(map(repr, self.table['enums'][type_]))}]"
        return NUMBERS.get(type_) or self.table["classes"].get(type_) or "Any"

    def many(self, type_):
        return "Floats" if bare(type_) == "double" else "NDArray[np.intc]" if bare(type_) == "int" else f"list[{self.one(type_)}]"

    def arguments(self, call):
        """(required, optional) as words of a signature."""
        required, optional = [], {}
        for word, type_ in call["args"]:
            if found := re.match(r"\((\w+)\)|\{>?(\w+)\}", word):
                if found[1]:
                    required.append(f"{found[1]}: {'Sequence[Region]' if found[1] == 'regions' else 'Stroke'}")
                for field in self.table["structs"][bare(type_)]["fields"]:
                    if found[1] != "regions" and field["name"] not in ("size", "count", "points", "dimension"):
                        array = field["room"] or field["type"].endswith("*")
                        optional[field["name"]] = "ArrayLike" if array else self.one(field["type"])
                optional.setdefault("dimension", "int")
            elif found := re.match(r"(\w+)\[=?.*\](\??)$", word):
                if found[2]:
                    optional[found[1]] = "ArrayLike"
                else:
                    required.append(f"{found[1]}: ArrayLike")
            elif word == "dim":
                optional["dimension"] = "int"
            elif found := re.match(r"(\w+)(=?)", word):
                if found[0] == "null":
                    continue
                if found[2]:
                    optional[found[1]] = self.one(type_)
                else:
                    required.append(f"{found[1]}: {self.one(type_)}")
        return required, [f"{name}: {type_} = ..." for name, type_ in optional.items()]

    def result(self, call, kind, name):
        rooms = any(word.startswith("%") for word, _ in call["args"])
        if call["returned"]:
            return self.many(call["returns"])
        if call["returns"] not in ("bat_status", "void") and not rooms:
            return self.one(call["returns"])
        found = [(*re.match(r">(\w+)(\*?)(?:\[(.*)\])?$", word).groups(), type_) for word, type_ in call["args"] if word[0] == ">"]
        used = {part for _, _, formula, _ in found for part in re.findall(r"\w+", formula or "")}
        found = [one for one in found if one[0] not in used and not (rooms and one[0] == "count")]
        made = [self.one(type_) for _, handed, _, type_ in found if bare(type_) in self.table["classes"] and not handed]
        if made:
            return made[0] if len(made) == 1 else f"tuple[{', '.join(made)}]"
        shown = [(word, self.many(type_) if formula else self.one(type_)) for word, _, formula, type_ in found]
        if not shown:
            return "Any" if any(word.startswith("{>") for word, _ in call["args"]) else kind
        if len(shown) == 1:
            return shown[0][1]
        title = "".join(part.title() for part in [kind, *name.split("_")])
        self.tuples.append("\n".join([f"class {title}(NamedTuple):", *(f"    {word}: {type_}" for word, type_ in shown)]))
        return title

    def text(self):
        lines = {kind: list(OWN.get(kind, [])) for kind in [*self.table["classes"].values(), "b"]}
        for call in self.table["calls"]:
            for called in call["names"]:
                kind, name = called.split(".")
                method = name.endswith("()")
                name = snake(name.replace("()", ""))
                if any(re.match(rf"def {name}\(", line) for line in lines[kind]):
                    continue
                required, optional = self.arguments(call)
                result = self.result(call, "" if kind == "b" else kind, name)
                plain = all(word[0] in "@>" for word, _ in call["args"])
                first = [] if kind == "b" else ["self"]
                given = ", ".join([*first, *required, *(["*", *optional] if optional else [])])
                if plain and not method and result not in self.table["classes"].values() and not result.startswith("tuple"):
                    lines[kind].append("@property")
                lines[kind].append(f"def {name}({given}) -> {result}: ...")
        classes = [f"class {kind}:\n" + "\n".join(f"    {line}" for line in lines[kind]) for kind in self.table["classes"].values()]
        return HEAD + "\n\n\n".join([*self.tuples, *classes]) + "\n\n\n" + "\n".join(lines["b"]) + "\n"


def text(path):
    return Stubs(json.loads(path.read_text("utf-8"))).text()
