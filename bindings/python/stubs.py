"""The types of the Python package, from calls.json."""
import json
import keyword
import re

HEAD = '''import builtins
from types import TracebackType
from typing import Literal, NamedTuple, Optional, Sequence, TypedDict, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
Floats = NDArray[np.float64]
Text = Union[str, bytes]
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


Tangents = Union[ArrayLike, Sequence[Optional[ArrayLike]]]
Stroke = Union[ArrayLike, StrokePoints]
Spline = Union[ArrayLike, SplinePoints]
Face = Union[Sequence[int], NDArray[np.intc]]


class StrokeArrays(TypedDict, total=False):
    points: Floats
    pressure: Floats
    time: Floats


class SplineArrays(TypedDict, total=False):
    points: Floats
    tangents: Floats
    tension: Floats
    closed: bool


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
    report: Report
    """What the call told that made it."""
    def __enter__(self: Self) -> Self: ...
    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType], /) -> None: ...


'''
FLOATS3 = "tuple[Floats, Floats, Floats, Floats, Floats]"
def said(text, line):
    """A member with its docstring."""
    return f'{line}:\n    """{text}"""'


OWN = {"Curve": ["def __call__(self, u: ArrayLike, *, order: int = ...) -> Floats:\n    \"\"\"The place at u, or the places at an array of any shape; with order=n, n derivatives behind each.\"\"\"",
                 "def __hash__(self) -> int: ...",
                 f"def frames(self, n: ArrayLike, *, rule: Literal['rmf', 'frenet', 'fixed'] = ..., substeps: int = ..., first: ArrayLike = ...) -> {FLOATS3}:\n    \"\"\"(u, point, t, s, r): frames at n places or at parameters, rows of three numbers.\"\"\"",
                 "def to_svg(self, tolerance: float = ..., decimals: int = ...) -> str:\n    \"\"\"SVG path data.\"\"\""],
       "Chain": ["def many(self, u: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]:\n    \"\"\"(point, t, s, r) at many parameters.\"\"\""],
       "Surface": ["def __hash__(self) -> int: ...", said("The control points: rows along u, columns along v, three numbers.", "@property\ndef points(self) -> Floats")],
       "Tessellation": [said("The triangles: points and normals (rows, columns, 3), u, v, and three vertices for each of triangles.", "@property\ndef grid(self) -> TriangleGrid")],
       "Relief": ["def add_level(self, u_knots: Optional[ArrayLike] = ..., v_knots: Optional[ArrayLike] = ..., details: Optional[ArrayLike] = ..., source: Optional[ArrayLike] = ...) -> Relief:\n    {bat_relief_add_level}"],
       "Mesh": ["def __hash__(self) -> int: ...", said("The vertices of each face.", "@property\ndef faces(self) -> list[NDArray[np.intc]]")],
       "Binding": ["def apply(self, curves: Sequence[Curve], points: Optional[ArrayLike] = ...) -> BindingApply:\n    {bat_binding_apply}"],
       "Tracks": [said("The points of a track.", "def points(self, i: int) -> list[TrackPoint]")],
       "LineDrawing": [said("A line: cubics in pixels, their ends shared.", "def at(self, i: int) -> SeenLine")],
       "Take": [said("How many joints there are, ends too.", "@property\ndef joint_count(self) -> int")],
       "Motion": [said("What it was made of.", "def take(self) -> Take"), said("How many joints there are, ends too.", "@property\ndef joint_count(self) -> int")],
       "Picture": [said("The bytes of the file.", "@property\ndef bytes(self) -> builtins.bytes")],
       "Object": [said("Its curves.", "@property\ndef curves(self) -> list[Curve]"), said("The corners of a picture.", "@property\ndef corners(self) -> Optional[Floats]"),
                  said("The axis of a guide, and where it is.", "@property\ndef guide(self) -> Optional[tuple[int, float]]"),
                  said("The ids of what it is made from.", "@property\ndef sources(self) -> list[int]"), said("The points of a spline.", "@property\ndef spline(self) -> Optional[SplineArrays]")],
       "Document": [said("All objects, back to front.", "@property\ndef objects(self) -> list[Object]"),
                    said("Puts an object in front of all others, under a new id, which is returned.", "def add(self, object: Object) -> int")],
       "b": ["def surface(points: Union[ArrayLike, Sequence[ArrayLike]], u_knots: ArrayLike, v_knots: ArrayLike, *, degree: Union[int, tuple[int, int]] = ..., closed: Union[bool, tuple[bool, bool]] = ...) -> Surface:\n    {bat_surface_create}",
             "def mesh(vertices: ArrayLike, faces: Union[Sequence[Face], NDArray[np.intc]] = ...) -> Mesh:\n    {bat_polymesh_create}",
             "def take(joints: Sequence[Union[Bone, BoneGiven]], values: ArrayLike, frame_time: float) -> Take:\n    {bat_take_create}",
             said("A stroke of JSON or CSV, as a dict of points, pressure and time that the calls take.", "def read_stroke(text: Text) -> StrokePoints"),
             said("A spline of JSON, as a dict of points, tangents, tension and closed that the calls take.", "def read_spline(text: Text) -> SplinePoints"),
             said("An SVG file as a document, whose report says what was left out. Nothing is fetched.", "def read_svg(text: Text, *, tolerance: float = ..., corner: float = ..., share: float = ...) -> Document")],
       "LiveSketch": ["def add(self, *place: float) -> LiveSketch:\n    \"\"\"Adds a sample: its coordinates.\"\"\""]}
NUMBERS = {"double": "float", "int": "int", "size_t": "int", "bool": "bool", "uint32_t": "int", "uint64_t": "int", "bat_id": "int", "char": "str"}
ARRAYS = {"double": "Floats", "int": "NDArray[np.intc]", "size_t": "NDArray[np.uintp]", "bool": "NDArray[np.bool_]"}
ALONE = {"bat_function": "float, Curve", "bat_region": "Curve, Sequence[Curve]", "bat_width_profile": "ArrayLike, Sequence[WidthStopGiven]",
         "bat_model": "Mesh, Surface, Curve, Sequence[Union[Mesh, Surface, Curve]]", "bat_line_scene": "Surface, Curve, Sequence[Union[Surface, Curve]]",
         "bat_width_stop": "tuple[float, float]", "bat_stop": "tuple[float, int]"}  # what stands for a struct


def snake(name):
    return re.sub(r"([A-Z]+)", lambda found: "_" + found[1].lower(), name)


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


class Stubs:
    def __init__(self, table, docs):
        self.table, self.docs, self.tuples, self.reports, self.structs, self.given = table, docs, [], {}, {}, {}

    def one(self, type_):
        type_ = bare(type_)
        if type_ in self.table["enums"]:
            return f"Literal[{', '.join(map(repr, self.table['enums'][type_]))}]"
        return NUMBERS.get(type_) or self.table["classes"].get(type_) or self.struct(type_)

    def fields(self, struct):
        """(name, type) of what a struct has as a result."""
        for field in self.table["structs"][struct]["fields"]:
            name, type_ = field["name"], field["type"]
            if field["counts"] or name == "size":
                continue
            one, was = bare(type_), "counted" in field
            if not type_.endswith("*"):
                found = self.many(type_) if field["room"] else self.one(type_)
            elif (one in ARRAYS or type_.endswith("**")) and not was and struct not in ("bat_mesh", "bat_seen_line"):
                continue
            else:
                single = one == "char" or (not was and one not in ARRAYS) or one in self.table["classes"] and type_.count("*") < 2
                found = f"Optional[{self.one(type_)}]" if single else self.many(type_)
            yield name + "_" * keyword.iskeyword(name), found

    def giving(self, type_):
        """The type of a struct that is given: what results have, a dict, or what stands for it."""
        type_ = bare(type_)
        title = self.table["structs"][type_]["title"]
        if type_ not in self.given:
            self.given[type_] = ""
            own = [(f["name"], self.argument(f)) for f in self.table["structs"][type_]["fields"] if f["name"] != "size" and not f["counts"]]
            if any(keyword.iskeyword(name) for name, _ in own):
                self.given[type_] = f"{title}Given = TypedDict('{title}Given', {{" + ", ".join(f"'{name}': {found!r}" for name, found in own) + "}, total=False)"
            else:
                self.given[type_] = "\n".join([f"class {title}Given(TypedDict, total=False):", *(f"    {name}: {found}" for name, found in own)])
        return f"Union[{', '.join([self.struct(type_), title + 'Given', *ALONE.get(type_, '').split('; ')]).rstrip(', ')}]"

    def argument(self, field):
        """The type of a field that is given."""
        type_, one = field["type"], bare(field["type"])
        if one in self.table["classes"]:
            return f"Sequence[{self.one(one)}]" if type_.count("*") > 1 else self.one(one)
        if one in self.table["structs"]:
            return f"Sequence[{self.giving(one)}]" if "counted" in field else self.giving(one)
        if field["room"] and one in self.table["enums"]:
            return f"Sequence[{self.one(one)}]"
        if one == "char":
            return "str"
        return "Tangents" if field["name"] == "tangents" else "ArrayLike" if field["room"] or "*" in type_ else self.one(type_)

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
        return ARRAYS.get(bare(type_)) or f"list[{self.one(type_)}]"

    def arguments(self, call):
        """(required, optional) as words of a signature."""
        required, optional = [], {}
        counted = {word[1:] for word, _ in call["args"] if word[0] == "#"}
        for word, type_ in call["args"]:
            word = word.removeprefix("&")
            if found := re.match(r"\((\w+)\)(\??)|\{>?(\w+)\}", word):
                flat = bare(type_) in ("bat_stroke", "bat_spline")
                if found[1] and not flat:
                    given = f"Sequence[{self.giving(type_)}]" if found[1] in counted else self.giving(type_)
                    if found[2]:
                        optional[found[1]] = given
                    else:
                        required.append(f"{found[1]}: {given}")
                    continue
                if found[1]:
                    required.append(f"{found[1]}: {'Spline' if bare(type_) == 'bat_spline' else 'Stroke'}")
                for field in self.table["structs"][bare(type_)]["fields"]:
                    if field["name"] not in ("size", "count", "points", "dimension") and (flat or not field["counts"]):
                        optional[field["name"]] = self.argument(field)
                if flat:
                    optional.setdefault("dimension", "int")
            elif word[0] in "!#%=>@":
                continue
            elif found := re.match(r'"(\w+)"(\??)', word):
                if found[2]:
                    optional[found[1]] = "Text"
                else:
                    required.append(f"{found[1]}: Text")
            elif found := re.match(r"(\w+)!?\[=?.*\](\??)$", word):
                given = f"Sequence[{self.one(type_)}]" if bare(type_) in self.table["classes"] else "ArrayLike"
                if found[2]:
                    optional[found[1]] = given
                else:
                    required.append(f"{found[1]}: {given}")
            elif word == "dim":
                optional["dimension"] = "int"
            elif found := re.match(r"(\w+)!?(=?)", word):
                if found[1] == "null":
                    continue
                if found[2]:
                    optional[found[1]] = self.one(type_)
                else:
                    required.append(f"{found[1]}: {self.one(type_)}")
        return required, [f"{name}: {type_} = ..." for name, type_ in optional.items()]

    def result(self, call, kind, name):
        rooms = any(word.startswith("%") for word, _ in call["args"])
        nothing = "*" in call["returns"] and "NULL" in self.docs[call["c"]] and not any(":" in word for word, _ in call["args"])
        if call["returned"]:
            return f"Optional[{self.many(call['returns'])}]" if nothing else self.many(call["returns"])
        if call["returns"] not in ("bat_status", "void") and not rooms:
            return f"Optional[{self.one(call['returns'])}]" if nothing else self.one(call["returns"])
        found = [(*re.match(r">(\w+)(\*?)(?:\[(.*)\])?$", word).groups(), type_) for word, type_ in call["args"] if word[0] == ">"]
        shown_too = [(word[1:].split("[")[0], "", "1", type_) for word, type_ in call["args"] if word[0] == "&"]
        used = {part for _, _, formula, _ in found for part in re.findall(r"\w+", formula or "")}
        found = shown_too + [one for one in found if one[0] not in used and not (rooms and one[0] == "count")]
        if len(found) == 1 and bare(found[0][3]) == "char":
            return "str" if found[0][0] == "text" else "bytes"
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
            return self.one(handed[0]) if handed else kind or "None"
        if len(shown) == 1:
            return shown[0][1]
        title = "".join(part.title() for part in [kind, *name.split("_")])
        self.tuples.append("\n".join([f"class {title}(NamedTuple):", *(f"    {word}: {type_}" for word, type_ in shown)]))
        return title

    def text(self):
        quoted = {"{" + name + "}": '"""' + text.replace("\n", "\n\n    ") + '"""' for name, text in self.docs.items()}
        lines = {kind: [re.sub(r"\{\w+\}", lambda found: quoted.get(found[0], found[0]), line) for line in OWN.get(kind, [])]
                 for kind in [*self.table["classes"].values(), "b"]}
        self.struct("bat_mesh"), self.struct("bat_seen_line"), self.told("report", "bat_svg_report", False)
        for call in self.table["calls"]:
            for called in call["names"]:
                kind, name = called.split(".")
                method = name.endswith("()")
                name = snake(name.replace("()", ""))
                if any(re.match(rf"(@property\n)?def {name}\(", line) for line in lines[kind]):
                    continue
                required, optional = self.arguments(call)
                result = self.result(call, "" if kind == "b" else kind, name)
                if name[0] == "_":
                    continue
                plain = kind != "b" and all(word[0] in "@>" for word, _ in call["args"])
                makes = bare(call["returns"]) in self.table["classes"] or any(word[0] == ">" and bare(type_) in self.table["classes"] for word, type_ in call["args"])
                first = [] if kind == "b" else ["self"]
                given = ", ".join([*first, *required, *(["*", *optional] if optional else [])])
                if plain and not method and not makes and call["c"] != "bat_shape_commit":
                    lines[kind].append("@property")
                about, _, place = self.docs[call["c"]].rpartition("\n")
                said = "\n".join(one for one in (about, self.docs[call["c"] + "()"], place) if one).replace("\n", "\n\n    ")
                lines[kind].append(f'def {name}({given}) -> {result}:\n    """{said}"""')
        classes = [f"class {kind}(_Handle):\n" + "\n".join(f"    {line}" for one in lines[kind] for line in one.split("\n")) for kind in self.table["classes"].values()]
        classes = [one.replace("    @property\n    def bytes(self) -> bytes", "    @property\n    def bytes(self) -> builtins.bytes") for one in classes]
        report = "class Report:\n    \"\"\"What a call told about the object that it made: some of these.\"\"\"\n" + "\n".join(
            f"    {name}: {next(iter(types)) if len(types) == 1 else 'Union[' + ', '.join(sorted(types)) + ']'}" for name, types in self.reports.items())
        return HEAD + "\n\n\n".join([*self.structs.values(), *self.given.values(), report, *self.tuples, *classes]) + "\n\n\n" + "\n".join(lines["b"]) + "\n"


def text(path):
    return Stubs(json.loads(path.read_text("utf-8")), json.loads(path.with_name("docs.json").read_text("utf-8"))).text()
