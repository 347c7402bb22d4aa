"""Calls of C as calls.txt describes them: arguments are made, the function is called, results are read."""
import collections
import copy
import ctypes
import functools
import inspect
import math
import re

import numpy as np

from ._library import (CLASSES, DOCS, KINDS, NUMBERS_MOST, NUMPY, SCALARS, STRUCTS, TABLE, Record, bare, check, copied, doubles,
                       handle, lib, pointer, record, shown, text_at, value_type, word_of, wrong)
from ._values import FLAT, address, array_of, converted, encoded, filled, set_field

LIBRARY = {}  # the functions of the library, by name
RESULTS = {}  # the tuples that calls with several results give, by name
CURVED = ("Curve", "Finder", "Chain", "Shape", "LiveShape", "LiveSketch")  # classes that have a dimension
REMADE = ("Finder", "Chain", "SurfaceFinder", "Sweep", "Reference", "Binding", "Tracks", "LineDrawing")  # pickled as the call that made them
FAST = {float, int, np.float64}
Word = collections.namedtuple("Word", "kind name type bare formula whole optional missing least handed ends kept", defaults=[None] * 10)
LITERALS = {"false": False, "true": True, "inf": float("inf")}


def snake(name):
    return re.sub(r"([A-Z]+)", lambda found: "_" + found[1].lower(), name)


def parse(word, type_):
    """A word of calls.txt, taken apart."""
    make = functools.partial(Word, type=type_, bare=bare(type_))
    if word.startswith("@"):
        return make("self", "self", ends=word == "@!")
    if word in ("dim", "null"):
        return make(word, word)
    if word.startswith("="):
        return make("follows", "", formula=word[1:])
    if word[0] in "#%":
        return make("count" if word[0] == "#" else "room", word[1:])
    if word[0] == "!":
        return make("told", word[1:])
    if word[0] == "&":
        return parse(word[1:], type_)._replace(handed=True)
    if found := re.fullmatch(r'"(\w+)"(\??)', word):
        return make("text", found[1], optional=bool(found[2]))
    if found := re.fullmatch(r"\((\w+)\)(\??)", word):
        return make("struct", found[1], optional=bool(found[2]))
    if found := re.fullmatch(r"\{(>?)(\w+)\}", word):
        return make("options", found[2], handed=bool(found[1]))
    if found := re.fullmatch(r">(\w+)(\*?)(?:\[(.*)\])?", word):
        return make("result", found[1], handed=bool(found[2]), formula=found[3])
    if found := re.fullmatch(r"(\w+)(!?)\[(=?)(.*)\](\??)", word):
        return make("array", found[1], kept=bool(found[2]), whole=bool(found[3]), formula=found[4], optional=bool(found[5]))
    name, kept, missing, least = re.fullmatch(r"(\w+)(!?)(?:=(.+)|:(\d))?", word).groups()
    return make("scalar", name, kept=bool(kept), missing=missing, least=least)


class Plan:
    """A call, prepared."""

    def __init__(self, call, name):
        self.name, self.kind = name, call["names"][0].split(".")[0]
        self.c, self.returns, self.returned = call["c"], call["returns"], call["returned"]
        self.words = [parse(*one) for one in call["args"]]
        own = [w for w in self.words if w.kind in ("scalar", "array", "struct", "text")]
        self.counted = {w.name for w in self.words if w.kind == "count"}
        flats = [w for w in self.words if w.kind == "struct" and w.bare in FLAT]
        self.required = [w.name for w in own if not w.optional and w.missing is None]
        self.defaults = {w.name: w.missing for w in own if w.optional or w.missing is not None}
        self.fields = [f["name"] for w in self.words if w.kind == "options" or w in flats
                       for f in TABLE["structs"][w.bare]["fields"] if not f["counts"] and f["name"] not in ("size", "count", "points", "dimension")]
        self.presets = {name: value for w in self.words if w.kind == "options" for name, value in preset(w.bare).items()}
        flat = ["dimension"] if flats or any(w.kind == "dim" for w in self.words) else []
        self.options = {name: None for name in [*self.defaults, *self.fields, *flat] if name not in self.required}
        self.arrays = [w for w in self.words if w.kind == "array" and "dim" in w.formula or w in flats]
        results = [w for w in self.words if w.kind == "result" or w.kind == "array" and w.handed]
        used = {part for formula in [self.returned, *(w.formula for w in results if w.kind == "result")] for part in re.findall(r"\w+", formula or "")}
        if any(w.kind == "room" for w in self.words):
            used.add("count")
        self.shown = [w for w in results if w.name not in used]
        made = any(w.bare in CLASSES and not w.handed for w in self.shown)
        if len(self.shown) > 1 and not made:
            title = "".join(part.title() for part in [call["names"][0].split(".")[0].replace("b", ""), *name.split("_")])
            RESULTS[title] = collections.namedtuple(title, [w.name for w in self.shown], module="batten")
            self.results = RESULTS[title]
        self.function = getattr(lib, self.c)
        self.function.argtypes = [self.c_type(w) for w in self.words]
        kind = bare(self.returns)
        self.function.restype = None if self.returns == "void" else ctypes.c_void_p if "*" in self.returns else SCALARS.get(kind, ctypes.c_int)

    @staticmethod
    def c_type(word):
        if word.kind in ("self", "null", "array", "struct", "options", "result", "text", "told") or "*" in word.type:
            return ctypes.c_void_p
        return SCALARS.get(word.bare, ctypes.c_int)


@functools.lru_cache(maxsize=None)
def compiled(formula):
    """(names, code) of a formula of calls.txt."""
    return re.findall(r"#?[a-z_]\w*", formula), compile(formula.replace("#", "n_"), formula, "eval")


@functools.lru_cache(maxsize=None)
def factors(formula):
    return re.findall(r"\([^)]*\)|[^*]+", formula)


def curves_of(value, place):
    """(place, curve) of all curves that regions are made of."""
    if isinstance(value, KINDS["Curve"]):
        yield place, value
    elif isinstance(value, dict):
        yield from curves_of(value.get("curves"), f"{place}.curves")
    elif isinstance(value, (list, tuple)):
        for i, one in enumerate(value):
            yield from curves_of(one, f"{place}[{i}]")


def preset(struct):
    """The numbers, truths and words that options have when they are left out."""
    item = STRUCTS[struct]()
    getattr(lib, TABLE["inits"][struct])(ctypes.byref(item), ctypes.c_size_t(ctypes.sizeof(item)))
    return {name: value for name, value in vars(record(struct, item)).items() if isinstance(value, (bool, int, float, str))}


def said(told, message):
    """What a call told of its failure: in a problem, or by the index of what is wrong."""
    for item in told:
        if isinstance(item, ctypes.c_size_t):
            return f"{message} (number {item.value})" if item.value < 2**63 else ""
        return ": ".join(one.decode("utf-8", "replace") for one in (item.place, item.message) if one)
    return ""


class Call:
    def __init__(self, plan, self_, given, options):
        self.plan, self.self, self.options, self.kept, self.results, self.given, self.told = plan, self_, options, [], [], [], []
        self.values = dict(zip(plan.required, given))
        self.values |= {name: options.get(name) for name in plan.defaults}
        self.arrays = {}
        self.dim = self.dimension()
        self.counting = False

    def dimension(self):
        if self.self is not None and self.plan.kind in CURVED:
            if (given := self.options.get("dimension")) is not None and converted("int", given, "dimension") != self.self.dim:
                raise wrong("dimension", self.self.dim, shown(given), "dimension")
            return self.self.dim
        if self.options.get("dimension") is not None:
            return converted("int", self.options["dimension"], "dimension")
        for word in self.plan.arrays:
            if self.values[word.name] is not None:
                array = self.points(word)
                found = array.shape[1] if array.ndim == 2 else array.size if word.whole and word.formula == "dim" else 2
                if found not in (2, 3):
                    raise wrong(word.name, "points of 2 or 3 coordinates", shown(array), "dimension" if found else "count")
                return found
        return 2

    def points(self, word):
        """The numbers of an argument that is an array, or has one."""
        if word.name not in self.arrays:
            value = self.values[word.name]
            if isinstance(value, dict) and word.kind == "struct":
                fields = [f["name"] for f in TABLE["structs"][word.bare]["fields"] if f["name"] != "count"]
                if "points" not in value or not value.keys() <= set(fields):
                    raise wrong(word.name, f"a dict of points and perhaps {', '.join(f for f in fields if f != 'points')}",
                                f"one of {', '.join(map(str, value)) or 'nothing'}")
                value = value["points"]
            self.arrays[word.name] = array_of(word.bare if word.kind == "array" else "double", value, word.name, word.formula != "1")
        return self.arrays[word.name]

    def evaluate(self, formula):
        """The value of a formula of calls.txt, such as (order+1)*dim."""
        names, code = compiled(formula)
        names = {name: self.look(name) for name in names}
        found = eval(code, {"__builtins__": {}}, {name.replace("#", "n_"): value for name, value in names.items()})
        if found != int(found):
            counted = [name for name in names if name[0] == "#"]
            raise wrong(counted[0][1:] if counted else formula, f"a number of points of which {formula} is whole", names[counted[0]] if counted else found, "count")
        return int(found)

    def shape(self, formula):
        """The factors of a formula as the shape of an array; what has no derivatives has no axis for them."""
        shape = tuple(self.evaluate(f) for f in factors(formula) if not (f.startswith("(order") and self.values["order"] in (0, None)))
        most = math.prod(shape)
        if min(shape) < 0 or most > NUMBERS_MOST:
            names = [name for name in re.findall(r"[a-z]\w*", formula) if name in self.values]
            raise wrong(names[0] if names else formula, f"results of 0 to {NUMBERS_MOST} numbers", most, "count")
        return shape

    def look(self, name):
        if name == "dim":
            return self.dim
        if name.startswith("#"):
            return self.records(name[1:])
        if name == "level_count":
            return self.self._level_count(self.values["level"])
        value = self.values.get(name)
        if value is None:
            value = getattr(self.self, name)
        return value(*[self.values[one] for one in ("direction",) if one in self.values]) if callable(value) else value

    def records(self, name):
        word = next(w for w in self.plan.words if w.name == name and w.kind in ("array", "struct", "text"))
        value = self.values[name]
        if value is None and word.optional:
            return 0
        if word.kind == "text":
            return len(encoded(value, name))
        if word.kind == "struct" and word.bare not in FLAT or word.bare in CLASSES:
            if not isinstance(value, (list, tuple)):
                raise wrong(name, "a list", shown(value))
            return len(value)
        size = self.points(word).size
        each = self.dim if word.kind == "struct" else 1 if word.whole else self.evaluate(word.formula)
        if size % each:
            raise wrong(name, f"points of {each} numbers", f"{size} numbers", "count")
        return size // each

    def address(self, value, word, name):
        """The address of an object, which lives as long as the call; of one that the call keeps, that of a copy."""
        kind = CLASSES[word.bare]
        found = address(value, kind, name, self.kept)
        if kind == "Curve" and name in ("b", "onto") and self.plan.name != "is_equal" and value.dim != self.dim:
            raise wrong(name, f"a Curve of dimension {self.dim}", f"one of dimension {value.dim}", "dimension")
        if word.kept:
            out = ctypes.c_void_p()
            check(getattr(lib, word.bare + "_copy")(ctypes.c_void_p(found), ctypes.byref(out)))
            self.given.append((value._free, out.value))
            return out.value
        return found

    def scalar(self, word):
        value = self.values[word.name]
        if value is None and word.missing is not None:
            ends = {"start": 0, "end": 1}
            value = (self.self.domain[ends[word.missing]] if word.missing in ends else LITERALS[word.missing] if word.missing in LITERALS
                     else float(word.missing) if re.match(r"[\d.-]", word.missing) and word.bare == "double"
                     else int(word.missing) if re.fullmatch(r"\d+", word.missing) else word.missing)
            self.values[word.name] = value
        if word.bare in CLASSES:
            return self.address(value, word, word.name)
        if word.bare == "double" and word.missing == "inf" and isinstance(value, (float, np.floating)) and value == np.inf:
            return value
        key = f"{self.plan.kind}.{word.name}"
        value = converted(word.bare, value, word.name, key)
        if word.least is not None and not int(word.least) <= value <= self.self._level_total():
            raise wrong(word.name, f"a level from {word.least} to {self.self._level_total()}", value)
        if word.bare in ("int", "size_t"):
            self.values[word.name] = value
        return value

    def text(self, word):
        value = self.values[word.name]
        if value is None and word.optional:
            return None
        self.kept.append(encoded(value, word.name, whole=word.name in self.plan.counted))
        return self.kept[-1]

    def tell(self, word):
        self.told.append(STRUCTS["bat_problem"]() if word.bare == "bat_problem" else ctypes.c_size_t(2**64 - 1))
        return ctypes.byref(self.told[-1])

    def array(self, word):
        value = self.values[word.name]
        if value is None and word.optional:
            return None
        if word.bare in CLASSES:
            count = self.records(word.name)
            if word.whole and count != self.evaluate(word.formula):
                raise wrong(word.name, f"{self.evaluate(word.formula)} of them", count, "count")
            self.kept.append((ctypes.c_void_p * count)(*[self.address(one, word, word.name) for one in value]))
            return ctypes.byref(self.kept[-1])
        array = self.points(word)
        if array.ndim == 2 and "dim" in word.formula and not word.whole and array.shape[1] != self.dim:
            raise wrong(word.name, f"points of {self.dim} coordinates", shown(array), "dimension")
        size = self.evaluate(word.formula)
        if array.size != size if word.whole else array.size % size:
            raise wrong(word.name, f"{size} numbers" if word.whole else f"points of {size} numbers", shown(array), "count")
        if word.handed:
            array = array.copy()
            self.results.append((word, array, None))
        self.kept.append(array)
        return pointer(array)

    def struct(self, word, options=False):
        if options:
            item = STRUCTS[word.bare]()
            self.kept.append(item)
            getattr(lib, TABLE["inits"][word.bare])(ctypes.byref(item), ctypes.c_size_t(ctypes.sizeof(item)))
            for field in TABLE["structs"][word.bare]["fields"]:
                if (value := self.options.get(field["name"])) is not None and field["name"] != "size":
                    set_field(item, word.bare, field, value, field["name"], self.kept, self.dim)
            if word.handed:
                self.results.append((word, item, None))
            return ctypes.byref(item)
        value = self.values[word.name]
        if word.bare in FLAT:
            return ctypes.byref(self.flat(word, value))
        if value is None and word.optional and word.bare != "bat_style":
            return None
        many = word.name in self.plan.counted
        items = filled(word.bare, value if many else [{} if value is None else value], word.name, self.kept, many)
        return ctypes.byref(items)

    def flat(self, word, value):
        """A stroke or a spline: points, and the rest by name."""
        item = STRUCTS[word.bare]()
        self.kept.append(item)
        given = {**self.options, **(value if isinstance(value, dict) else {"points": value})}
        count, points = self.records(word.name), self.points(word)
        if points.ndim == 2 and points.shape[1] != self.dim:
            raise wrong(word.name, f"points of {self.dim} coordinates", shown(points), "dimension")
        given |= {"dimension": self.dim, "count": count, "points": points}
        each = {"points": self.dim, "tangents": self.dim, "tension": 2, "pressure": 1, "time": 1}
        for field in TABLE["structs"][word.bare]["fields"]:
            name, value = field["name"], given.get(field["name"])
            if value is None:
                continue
            if name == "count":
                item.count = count
                continue
            size = each.get(name)
            if field["type"].endswith("*") and doubles(value, name, size).size != count * size:
                raise wrong(name, f"{count * size} numbers for {count} points", shown(np.asarray(value)), "count")
            set_field(item, word.bare, field, value, name, self.kept, self.dim, size)
        return item

    def result(self, word):
        if word.handed or word.bare in CLASSES:
            item = ctypes.c_void_p()
        elif word.formula is None:
            item = value_type(word.bare)()
        elif self.counting and "room" in word.formula:
            return None
        elif word.bare in NUMPY:
            item = np.empty(self.shape(word.formula), dtype=NUMPY[word.bare])
            self.results.append((word, item, None))
            return pointer(item)
        else:
            item = (value_type(word.bare) * self.shape(word.formula)[0])()
        self.results.append((word, item, None))
        return ctypes.byref(item)

    def argument(self, word):
        if word.kind == "self":
            return self.own()
        if word.kind == "dim":
            return converted("int", self.dim, "dimension")
        if word.kind == "follows":
            return self.evaluate(word.formula)
        if word.kind == "room":
            return self.values["room"]
        if word.kind == "count":
            return self.records(word.name)
        return {"null": lambda _: None, "scalar": self.scalar, "array": self.array, "struct": self.struct, "text": self.text, "told": self.tell,
                "options": lambda w: self.struct(w, True), "result": self.result}[word.kind](word)

    def own(self):
        memory = self.self._memory()
        self.kept.append(memory)
        return memory.address

    def run(self):
        if any(w.kind == "room" for w in self.plan.words):
            self.counting, self.values["room"] = True, 0
            returned = self.once()
            counted = next((item.value for word, item, _ in self.results if word.name == "count"), returned)
            self.counting, self.values["room"], self.results, self.told = False, counted, [], []
        return self.once()

    def once(self):
        plan = self.plan
        # The object comes last: what converts the others is code of others, which may end the object.
        order = sorted(plan.words, key=lambda w: (w.kind == "result") + 2 * (w.kind == "self"))
        called = False
        try:
            arguments = {id(w): self.argument(w) for w in order}
            if guard := TABLE["rules"]["checked"].get(plan.c):
                problem = STRUCTS["bat_problem"]()
                check(getattr(lib, guard)(arguments[id(plan.words[0])], ctypes.byref(problem)), None, f" ({plan.name})", f"{plan.words[0].name}.{said([problem], '')}")
            called, returned = True, plan.function(*[arguments[id(w)] for w in plan.words])
        finally:
            for free, copied_ in [] if called else self.given:  # a call that fails frees them, too
                free(copied_)
        if plan.words and plan.words[0].ends:
            self.self._own.address = None
            self.self._end("committed")
        if self.counting:
            return returned
        for word, item, _ in self.results:
            if word.formula is None and word.bare in ("int", "size_t"):
                self.values[word.name] = item.value
        if plan.returns != "bat_status":
            return self.assemble() if plan.returns == "void" or "room" in self.values else self.returned(returned)
        best = None
        if returned == TABLE["enums"]["bat_status"]["tolerance"] and any(
                word.bare in CLASSES and not word.handed and item for word, item, _ in self.results):
            best = self.assemble()
        if returned:
            results = {"room", *(w.name for w in plan.words if w.kind == "result")}
            given = ", ".join(f"{name}={shown(value)}" for name, value in {**self.values, **self.options}.items() if value is not None and name not in results)
            told = self.explained(arguments) or said(self.told, lib.bat_status_message(returned).decode()) or self.outside(returned)
            about = word_of("bat_status", returned) in TABLE["rules"]["of_object"] and self.self is not None and self.self._own and not told
            of = f"{self.self!r}." if about else ""
            told = told or ": ".join(one for one in (lib.bat_status_message(returned).decode(), self.why(returned)) if one)
            if plan.c in TABLE["rules"]["explained_struct"].values():
                told = f"{plan.words[0].name}.{told}"
            check(returned, best, f" ({of}{plan.name.lstrip('_')}({given}))", told)
        return self.assemble()

    def explained(self, arguments):
        """What another call says of the arguments that were refused: of all, or of a struct among them."""
        rules, words = TABLE["rules"], self.plan.words
        asked = [("", rules["explained"].get(self.plan.c), [w for w in words if w.kind not in ("result", "told")])]
        asked += [(w.name, rules["explained_struct"].get(w.bare), [w]) for w in words if w.kind == "struct" and w.name not in self.plan.counted and not self.told]
        for name, explains, given in asked:
            if explains and all(arguments[id(w)] is not None or not name for w in given):
                function, problem = getattr(lib, explains), STRUCTS["bat_problem"]()
                function.argtypes = [*(self.plan.c_type(w) for w in given), ctypes.c_void_p]
                if function(*[arguments[id(w)] for w in given], ctypes.byref(problem)):
                    return (name + "." if name else "") + said([problem], "")
        return ""

    def why(self, status):
        """What the header says of a status that nothing else explains."""
        return TABLE["why"].get(self.plan.c, {}).get(word_of("bat_status", status), "")

    def bound(self, of):
        """A bound of the ranges of the table: a number, or what the object has."""
        if isinstance(of, (int, float)):
            return of
        if of in ("start", "end"):
            return float(self.self.domain[int(of == "end")])
        if of == "level_total":
            return self.self._level_total()
        name = of.rstrip("-")
        return (getattr(self.self, name) if name == "degree" else self.look(name)) - of.endswith("-")

    def outside(self, status):
        """Which number is not in its range, when that is what the status can mean."""
        if word_of("bat_status", status) not in ("argument", "number", "parameter", "count", "degree", "knots", "dimension", "singular"):
            return ""
        ranges = TABLE["rules"]["ranges"]
        for name, value in {**self.values, **self.options}.items():
            low, high, *above = ranges.get(f"{self.plan.c}.{name}", ranges.get(name, (-1e75, 1e75)))
            if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)) or name == "room":
                continue
            try:
                low, high = self.bound(low), self.bound(high)
            except Exception:  # noqa: BLE001: the object has no such thing
                continue
            if not (low < value if above else low <= value) or value > high:
                least, most = (f"{one:.10g}" for one in (low, high))
                expected = "none" if high < low else f"more than {least}" if above and value <= low else f"{least} to {most}"
                return f"{name}: expected {expected}, found {shown(value)}"
        return self.array_outside(status)

    def array_outside(self, status):
        """The same of an array: a number of it, or the array that the status is about."""
        status, given = word_of("bat_status", status), [name for name in self.plan.required if name in self.values]
        for name, array in self.arrays.items():
            if status in ("number", "argument") and (far := np.argwhere(np.abs(array) > 1e75)).size:
                place = "".join(f"[{one}]" for one in far[0])
                return f"{name}{place}: expected -1e75 to 1e75, found {array[tuple(far[0])]}"
        if status in ("argument", "dimension"):
            for name in TABLE["rules"]["regions"]:
                for place, curve in curves_of(self.values.get(name), name):
                    if curve.dim != 2 or not curve.closed:
                        return f"{place}: expected a closed curve in the plane, found {'one in space' if curve.dim != 2 else 'an open one'}"
        meant = [name for name in given if status in name] or [name for name in given if status in ("count", "parameter", "singular") and (name in self.arrays or isinstance(self.values[name], (list, tuple)))]
        return f"{meant[0]}: {lib.bat_status_message(TABLE['enums']['bat_status'][status]).decode()}, found {shown(self.values[meant[0]])}" if meant else ""

    def returned(self, value):
        kind = bare(self.plan.returns)
        if self.plan.returned:
            return copied(kind, value, self.shape(self.plan.returned))
        if kind == "char":
            return text_at(value)
        if kind in CLASSES:
            return handle(kind, value)
        if "*" in self.plan.returns:
            return record(kind, STRUCTS[kind].from_address(value)) if value else None
        return word_of(kind, value) if kind in TABLE["enums"] else value

    def read(self, word, item):
        make = KINDS.get(CLASSES.get(word.bare))
        if make and not word.handed:
            return make._made(item.value, self.values.get("dimension") or self.dim) if item.value else None
        if word.bare == "char":
            data = ctypes.string_at(item.value, self.values["size"])
            lib.bat_free(item)
            return data.decode() if word.name == "text" else data
        if word.handed and word.kind == "result":
            shape = self.shape(word.formula)
            found = ([make._made(address, self.dim) for address in (ctypes.c_void_p * shape[0]).from_address(item.value)] if make and item.value
                     else copied(word.bare, item.value, shape, self.dim))
            lib.bat_free(item)
            return found
        if isinstance(item, np.ndarray):
            return item
        if word.formula is not None:
            return [record(word.bare, one, self.dim) for one in item]
        if word.bare not in STRUCTS:
            return item.value
        found = record(word.bare, item, self.dim)
        for end in ("_free", "_clear"):  # of what the library has put into it
            if word.kind == "result" and hasattr(lib, word.bare + end):
                getattr(lib, word.bare + end)(ctypes.byref(item))
        if word.bare == "bat_sketch_live_info":
            found.target = copied("double", item.target, (item.target_count, self.dim))
        return found

    def remembered(self):
        """The call as it was, for what is made by it again in another process, and for what looks at its arguments."""
        given = [self.values[name] for name in self.plan.required]
        options = {**{name: self.values[name] for name in self.plan.defaults if self.values[name] is not None}, **self.options}
        return None if self.self is None else self.self.__copy__(), self.plan.name, *copy.deepcopy((given, options))

    def assemble(self):
        """The results as one value."""
        found = [(word, self.read(word, item)) for word, item, _ in self.results if word in self.plan.shown or word.kind != "result"]
        made = [value for word, value in found if word.bare in CLASSES and not word.handed]
        rest = {word.name: value for word, value in found if not (word.bare in CLASSES and not word.handed)}
        if len(made) == 1:
            if type(made[0]).__name__ in REMADE:
                made[0]._own.made_of = self.remembered()
            if made[0] is not None and rest:
                info = rest.pop("info", None)
                report = {**vars(info), **vars(info.report)} if info else vars(rest.pop("report")) if "report" in rest else {}
                report.pop("report", None)
                made[0].report = Report(**{**report, **rest})
            return made[0]
        if made:
            return tuple(made)
        if not rest:
            return self.self
        return next(iter(rest.values())) if len(rest) == 1 else self.plan.results(**rest)


class Report(Record):
    """What a call told about the object that it made."""

    def __getattr__(self, name):
        raise AttributeError(f"{name}: this report has {', '.join(vars(self)) or 'nothing'}")


Report.__module__ = "batten"


def bound(plan, given, options):
    """The arguments that must be there, in their order; those that have a name are taken out of the options."""
    missing = plan.required[len(given):]
    if len(given) > len(plan.required):
        raise TypeError(f"{plan.name}() takes {', '.join(plan.required) or 'nothing'}" + (f", and by name {', '.join(plan.options)}" if plan.options else "")
                        + f"; found {len(given)} without a name")
    if lacking := [name for name in missing if name not in options]:
        raise TypeError(f"{plan.name}() takes {', '.join(plan.required)}; {' and '.join(lacking)} {'is' if len(lacking) == 1 else 'are'} missing")
    given = [*given, *(options.pop(name) for name in missing)]
    if twice := set(options) & set(plan.required):
        raise TypeError(f"{plan.name}() has {min(twice)} twice")
    if unknown := set(options) - set(plan.options):
        raise TypeError(f"{plan.name}() has no option {min(unknown)}, but {', '.join(plan.options)}")
    return given


def settled(value):
    """A copy of what changes, made in its turn: a call that holds two of them could wait for one that holds the same."""
    if getattr(value, "_changes", False) and value._own:
        return value.copy()
    return [settled(one) for one in value] if isinstance(value, (list, tuple)) and any(getattr(one, "_changes", False) for one in value) else value


def quick(plan, run):
    """The same call without a plan, where it takes nothing but a curve and at most a parameter; what is unusual goes to run."""
    words = [w for w in plan.words if w.kind != "self"]
    function = plan.function
    if plan.returns not in ("double", "int", "size_t", "bool", "void") or any(w.kind not in ("scalar", "result") for w in words):
        return run
    if not words:
        def call(self):
            own = self._own
            return function(own.address) if own else run(self)
    elif [w.name for w in words] == ["u"] and plan.returns == "double":
        def call(self, *given, **options):
            if len(given) == 1 and not options and given[0].__class__ in FAST and self.__class__ is kind:
                u, own = given[0], self._own
                if own and -1e300 < u < 1e300:
                    return function(own.address, u)
            return run(self, *given, **options)
    elif [w.name for w in words] == ["u", "order", "out"]:
        rooms, filled, none = {dim: ctypes.c_double * dim for dim in (2, 3)}, np.frombuffer, object()

        def call(self, u=none, **options):
            if not options and u.__class__ in FAST and self.__class__ is kind:
                own = self._own
                if own and -1e300 < u < 1e300:
                    out = rooms[self._dim]()
                    function(own.address, u, 0, out)
                    return filled(out)
            return run(self, *(() if u is none else (u,)), **options)
    else:
        return run
    kind = KINDS["Curve"]
    return call


def helped(c):
    """What the header says of a call, and of each of its options."""
    text, _, place = DOCS[c].rpartition("\n")
    return "\n".join(one for one in (text, DOCS[c + "()"], place) if one)


def value_of(missing):
    """The value of a default of calls.txt; start and end stand for those of the curve."""
    if missing in LITERALS:
        return LITERALS[missing]
    return (int if missing.isdigit() else float)(missing) if re.match(r"[\d.-]", missing or "") else missing


def method(call, called):
    """The Python function of one name of a call. Its signature names what it takes."""
    kind, name = called
    plan = Plan(call, name)
    free = kind == "b"

    if free:
        def run(*given, **options):
            return Call(plan, None, [settled(one) for one in bound(plan, given, options)], options).run()
    else:
        def run(self, /, *given, **options):
            if not isinstance(self, KINDS[kind]):
                raise wrong("self", f"a {kind}", shown(self))
            given = [settled(one) for one in bound(plan, given, options)]
            with self._lock:
                return Call(plan, self, given, options).run()

    plain = all(w.kind in ("self", "result") for w in plan.words)
    makes = any(w.bare in CLASSES and w.kind == "result" for w in plan.words) or bare(plan.returns) in CLASSES
    is_property = not free and plain and not makes and call["c"] != "bat_shape_commit"
    found = quick(plan, run) if kind == "Curve" else run
    parameter = inspect.Parameter
    found.__signature__ = inspect.Signature(
        ([] if free else [parameter("self", parameter.POSITIONAL_ONLY)])
        + [parameter(word, parameter.POSITIONAL_OR_KEYWORD) for word in plan.required]
        + [parameter(word, parameter.KEYWORD_ONLY, default=value_of(plan.defaults.get(word)) if word in plan.defaults else plan.presets.get(word)) for word in plan.options])
    found.__name__, found.__qualname__, found.__module__ = name, name if free else f"{kind}.{name}", "batten"
    found.__doc__ = helped(call["c"])
    return found, is_property
