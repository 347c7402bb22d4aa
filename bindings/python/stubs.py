"""The types of the Python package, from calls.json."""
import json
import keyword
import re

HEAD = '''from types import TracebackType
from typing import Literal, NamedTuple, Optional, Sequence, TypedDict, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
Floats = NDArray[np.float64]
Self = TypeVar("Self", bound="_Handle")


class _Points(TypedDict):
    points: ArrayLike


class StrokePoints(_Points, total=False):
    pressure: ArrayLike
    time: ArrayLike
    dimension: int


class SplinePoints(_Points, total=False):
    tangents: Tangents
    tension: ArrayLike
    closed: bool
    dimension: int


class _Curves(TypedDict):
    curves: Sequence[Curve]


class RegionCurves(_Curves, total=False):
    even_odd: bool


Tangents = Union[ArrayLike, Sequence[Optional[ArrayLike]]]
Stroke = Union[ArrayLike, StrokePoints]
Spline = Union[ArrayLike, SplinePoints]
Region = Union[Curve, Sequence[Curve], RegionCurves]


class BattenError(ValueError):
    """What the library could not do. status: a word; code: its number; best: with "tolerance", the best result found."""
    status: str
    code: int
    best: Optional[Curve]


class _Handle:
    @property
    def dim(self) -> int:
        """The number of coordinates, 2 or 3."""
    def free(self) -> None:
        """Gives the memory back at once. Any use after that is an error."""
    def __enter__(self: Self) -> Self: ...
    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType], /) -> None: ...


'''
FLOATS3 = "tuple[Floats, Floats, Floats, Floats, Floats]"
OWN = {"Curve": ["report: Report",
                 "def __call__(self, u: ArrayLike, *, order: int = ...) -> Floats:\n    \"\"\"The place at u, or the places at an array of any shape; with order=n, n derivatives behind each.\"\"\"",
                 "def __hash__(self) -> int: ...",
                 f"def frames(self, n: ArrayLike, *, rule: Literal['rmf', 'frenet', 'fixed'] = ..., substeps: int = ..., first: ArrayLike = ...) -> {FLOATS3}:\n    \"\"\"(u, point, t, s, r): frames at n places or at parameters, rows of three numbers.\"\"\"",
                 "def to_svg(self, tolerance: float = ..., decimals: int = ...) -> str:\n    \"\"\"SVG path data.\"\"\""],
       "Chain": ["def many(self, u: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]:\n    \"\"\"(point, t, s, r) at many parameters.\"\"\""],
       "LiveSketch": ["def add(self, *place: float) -> LiveSketch:\n    \"\"\"Adds a sample: its coordinates.\"\"\""]}
NUMBERS = {"double": "float", "int": "int", "size_t": "int", "bool": "bool"}


def snake(name):
    return re.sub(r"([A-Z]+)", lambda found: "_" + found[1].lower(), name)


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


class Stubs:
    def __init__(self, table, docs):
        self.table, self.docs, self.tuples, self.reports, self.structs = table, docs, [], {}, {}

    def one(self, type_):
        type_ = bare(type_)
        if type_ in self.table["enums"]:
            return f"Literal[{', '.join(map(repr, self.table['enums'][type_]))}]"
        return NUMBERS.get(type_) or self.table["classes"].get(type_) or self.struct(type_)

    def fields(self, struct):
        """(name, type) of what a struct has as a result."""
        for field in self.table["structs"][struct]["fields"]:
            name, type_ = field["name"], field["type"]
            if type_.endswith("*") and bare(type_) not in self.table["structs"] and name != "target" or name == "size" or re.search(r"(^|_)count$", name):
                continue
            yield name + "_" * keyword.iskeyword(name), self.many(type_) if type_.endswith("*") or field["room"] else self.one(type_)

    def struct(self, type_):
        title = self.table["structs"][type_]["title"]
        if title not in self.structs:
            self.structs[title] = ""
            self.structs[title] = "\n".join([f"class {title}:", *(f"    {name}: {type_}" for name, type_ in self.fields(type_))])
        return title

    def told(self, name, type_, many):
        """What the report of a new object has."""
        for field, found in self.fields(bare(type_)) if name in ("report", "info") else [(name, self.many(type_) if many else self.one(type_))]:
            if field != "report":
                self.reports.setdefault(field, set()).add(found)
            else:
                self.told(field, "bat_sketch_report", False)

    def many(self, type_):
        return "Floats" if bare(type_) == "double" else "NDArray[np.intc]" if bare(type_) == "int" else f"list[{self.one(type_)}]"

    def arguments(self, call):
        """(required, optional) as words of a signature."""
        required, optional = [], {}
        for word, type_ in call["args"]:
            if found := re.match(r"\((\w+)\)|\{>?(\w+)\}", word):
                if found[1]:
                    given = {"regions": "Sequence[Region]", "spline": "Spline"}.get(found[1], "Stroke")
                    required.append(f"{found[1]}: {given}")
                for field in self.table["structs"][bare(type_)]["fields"]:
                    if found[1] != "regions" and field["name"] not in ("size", "count", "points", "dimension"):
                        array = field["room"] or field["type"].endswith("*")
                        optional[field["name"]] = "Tangents" if field["name"] == "tangents" else "ArrayLike" if array else self.one(field["type"])
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
        if len(made) == 1:
            for word, handed, formula, type_ in found:
                if bare(type_) not in self.table["classes"]:
                    self.told(word, type_, formula)
        if made:
            return made[0] if len(made) == 1 else f"tuple[{', '.join(made)}]"
        shown = [(word, self.many(type_) if formula else self.one(type_)) for word, _, formula, type_ in found]
        if not shown:
            handed = [type_ for word, type_ in call["args"] if word.startswith("{>")]
            return self.one(handed[0]) if handed else kind
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
                said = self.docs[call["c"]].replace("\n", "\n\n    ")
                lines[kind].append(f'def {name}({given}) -> {result}:\n    """{said}"""')
        classes = [f"class {kind}(_Handle):\n" + "\n".join(f"    {line}" for one in lines[kind] for line in one.split("\n")) for kind in self.table["classes"].values()]
        report = "class Report:\n    \"\"\"What a call told about the object that it made: some of these.\"\"\"\n" + "\n".join(
            f"    {name}: {next(iter(types)) if len(types) == 1 else 'Union[' + ', '.join(sorted(types)) + ']'}" for name, types in self.reports.items())
        return HEAD + "\n\n\n".join([*self.structs.values(), report, *self.tuples, *classes]) + "\n\n\n" + "\n".join(lines["b"]) + "\n"


def text(path):
    return Stubs(json.loads(path.read_text("utf-8")), json.loads(path.with_name("docs.json").read_text("utf-8"))).text()
