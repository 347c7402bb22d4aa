"""Calls of C as calls.txt describes them: arguments are made, the function is called, results are read."""
import collections
import ctypes
import functools
import inspect
import re

import numpy as np

from ._library import (CLASSES, NUMPY, SCALARS, STRUCTS, TABLE, BattenError, bare, check, copied, doubles, lib, pointer, record,
                       value_type)

KINDS = {}  # the classes, by name
Word = collections.namedtuple("Word", "kind name type bare formula whole optional missing least handed ends", defaults=[None] * 9)
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
    if found := re.fullmatch(r"\((\w+)\)", word):
        return make("struct", found[1])
    if found := re.fullmatch(r"\{(>?)(\w+)\}", word):
        return make("options", found[2], handed=bool(found[1]))
    if found := re.fullmatch(r">(\w+)(\*?)(?:\[(.*)\])?", word):
        return make("result", found[1], handed=bool(found[2]), formula=found[3])
    if found := re.fullmatch(r"(\w+)\[(=?)(.*)\](\??)", word):
        return make("array", found[1], whole=bool(found[2]), formula=found[3], optional=bool(found[4]))
    name, missing, least = re.fullmatch(r"(\w+)(?:=(.+)|:(\d))?", word).groups()
    return make("scalar", name, missing=missing, least=least)


class Plan:
    """A call, prepared."""

    def __init__(self, call):
        self.c, self.returns, self.returned = call["c"], call["returns"], call["returned"]
        self.words = [parse(*one) for one in call["args"]]
        own = [w for w in self.words if w.kind in ("scalar", "array", "struct")]
        self.required = [w.name for w in own if not w.optional and w.missing is None]
        self.defaults = {w.name: w.missing for w in own if w.optional or w.missing is not None}
        self.fields = [f["name"] for w in self.words if w.kind in ("options", "struct") and w.name != "regions"
                       for f in TABLE["structs"][w.bare]["fields"] if f["name"] not in ("size", "count", "points", "dimension")]
        self.options = {name: None for name in [*self.defaults, *self.fields, "dimension"] if name not in self.required}
        self.function = getattr(lib, self.c)
        self.function.argtypes = [self.c_type(w) for w in self.words]
        kind = bare(self.returns)
        self.function.restype = None if self.returns == "void" else ctypes.c_void_p if "*" in self.returns else SCALARS.get(kind, ctypes.c_int)

    @staticmethod
    def c_type(word):
        if word.kind in ("self", "null", "array", "struct", "options", "result") or "*" in word.type:
            return ctypes.c_void_p
        return SCALARS.get(word.bare, ctypes.c_int)


class Call:
    def __init__(self, plan, self_, given, options):
        self.plan, self.self, self.options, self.kept, self.results = plan, self_, options, [], []
        self.values = dict(zip(plan.required, given))
        self.values |= {name: options.get(name) for name in plan.defaults}
        self.dim = self.dimension()
        self.counting = False

    def dimension(self):
        if self.self is not None:
            return self.self.dim
        if self.options.get("dimension") is not None:
            return self.options["dimension"]
        for word in self.plan.words:
            if word.kind == "array" and "dim" in word.formula or word.kind == "struct" and word.name != "regions":
                value = self.values[word.name]
                array = doubles(value.get("points") if isinstance(value, dict) else value, word.name)
                return array.shape[1] if array.ndim == 2 else array.size if word.whole and word.formula == "dim" else 2
        return 2

    def evaluate(self, formula):
        """The value of a formula of calls.txt, such as (order+1)*dim."""
        names = {name: self.look(name) for name in re.findall(r"#?[a-z_]\w*", formula)}
        text = re.sub(r"#?[a-z_]\w*", lambda found: repr(names[found[0]]), formula)
        if not re.fullmatch(r"[\d.()+*/ -]+", text):
            raise BattenError("argument", f"{formula} is not a number")
        found = eval(text, {"__builtins__": {}})  # digits and operators of our own table
        if found != int(found):
            raise BattenError("count", "the numbers do not make whole points")
        return int(found)

    def shape(self, formula):
        """The factors of a formula as the shape of an array; what has no derivatives has no axis for them."""
        factors = re.findall(r"\([^)]*\)|[^*]+", formula)
        return tuple(self.evaluate(f) for f in factors if not (f == "(order+1)" and self.values["order"] in (0, None)))

    def look(self, name):
        if name == "dim":
            return self.dim
        if name.startswith("#"):
            return self.records(name[1:])
        if name == "level_count":
            return self.self.curve(self.values["level"]).count
        value = self.values.get(name)
        return value if value is not None else getattr(self.self, name)

    def records(self, name):
        word = next(w for w in self.plan.words if w.name == name and w.kind in ("array", "struct"))
        value = self.values[name]
        if value is None and word.optional:
            return 0
        if name == "regions":
            return len(value)
        size = doubles(value["points"] if isinstance(value, dict) else value, name).size
        each = self.dim if word.kind == "struct" else 1 if word.whole else self.evaluate(word.formula)
        if size % each:
            raise BattenError("count", f"{name} has {size} numbers, in points of {each}")
        return size // each

    def scalar(self, word):
        value = self.values[word.name]
        if value is None and word.missing is not None:
            ends = {"start": 0, "end": 1}
            value = (self.self.domain[ends[word.missing]] if word.missing in ends else LITERALS[word.missing] if word.missing in LITERALS
                     else float(word.missing) if re.match(r"[\d.-]", word.missing) and word.bare == "double"
                     else int(word.missing) if re.fullmatch(r"\d+", word.missing) else word.missing)
            self.values[word.name] = value
        if word.bare in CLASSES:
            return address_of(value, CLASSES[word.bare], word.name)
        if word.least is not None and not (isinstance(value, int) and int(word.least) <= value <= self.self.level_total()):
            raise BattenError("argument", f"there is no level {value}")
        return converted(word.bare, value, word.name)

    def array(self, word):
        value = self.values[word.name]
        if value is None and word.optional:
            return None
        array = doubles(value, word.name, self.dim)
        if array.ndim == 2 and "dim" in word.formula and not word.whole and array.shape[1] != self.dim:
            raise BattenError("dimension", f"{word.name} have {array.shape[1]} coordinates, not {self.dim}")
        size = self.evaluate(word.formula)
        if array.size != size if word.whole else array.size % size:
            raise BattenError("count", f"{word.name} has {array.size} numbers{', not ' if word.whole else ', in points of '}{size}")
        self.kept.append(array)
        return pointer(array)

    def set_field(self, item, struct, field, value, size):
        fields = TABLE["structs"][struct]["fields"]
        name, type_ = field["name"], field["type"]
        if type_.endswith("*"):
            array = doubles(value, name, size) if bare(type_) == "double" else np.ascontiguousarray(value, dtype=np.intc)
            self.kept.append(array)
            setattr(item, name, array.ctypes.data)
            before = fields[fields.index(field) - 1]["name"]
            if before.endswith("_count"):
                setattr(item, before, array.size)
        elif field["room"]:
            numbers = doubles(value, name).ravel()
            if numbers.size > field["room"]:
                raise BattenError("count", f"{name} has {numbers.size} numbers, not {field['room']}")
            getattr(item, name)[:numbers.size] = numbers.tolist()
            if hasattr(item, "has_" + name):
                setattr(item, "has_" + name, True)
        else:
            setattr(item, name, converted(type_, value, name))

    def struct(self, word, options=False):
        item = STRUCTS[word.bare]()
        self.kept.append(item)
        if options:
            getattr(lib, TABLE["inits"][word.bare])(ctypes.byref(item), ctypes.c_size_t(ctypes.sizeof(item)))
            given, count = self.options, None
        elif word.name == "regions":
            return self.regions(self.values["regions"])
        else:
            value = self.values[word.name]
            given = {**self.options, **(value if isinstance(value, dict) else {"points": value})}
            count = self.records(word.name)
            given |= {"dimension": self.dim, "count": count}
        each = {"points": self.dim, "tangents": self.dim, "tension": 2, "pressure": 1, "time": 1}
        for field in TABLE["structs"][word.bare]["fields"]:
            value = given.get(field["name"])
            if value is None or field["name"] == "size":
                continue
            size = each.get(field["name"])
            if count is not None and field["type"].endswith("*") and doubles(value, field["name"], size).size != count * size:
                raise BattenError("count", f"there are not as many {field['name']} as points")
            self.set_field(item, word.bare, field, value, size)
        if options and word.handed:
            self.results.append((word, item, None))
        return ctypes.byref(item)

    def regions(self, value):
        """Regions: each a curve, a list of curves, or a dict of curves and even_odd."""
        items = (STRUCTS["bat_region"] * len(value))()
        self.kept.append(items)
        for item, region in zip(items, value):
            own = region["curves"] if isinstance(region, dict) else region if isinstance(region, (list, tuple)) else [region]
            curves = (ctypes.c_void_p * len(own))(*[address_of(curve, "Curve", "regions") for curve in own])
            self.kept.append(curves)
            item.count, item.curves = len(own), ctypes.addressof(curves)
            item.even_odd = isinstance(region, dict) and bool(region.get("even_odd"))
        return ctypes.byref(items)

    def result(self, word):
        if word.handed or word.bare in CLASSES:
            item = ctypes.c_void_p()
        elif word.formula is None:
            item = value_type(word.bare)()
        elif self.counting and word.formula == "room":
            return None
        elif word.bare in NUMPY:
            item = np.empty(self.shape(word.formula), dtype=NUMPY[word.bare])
            self.results.append((word, item, None))
            return pointer(item)
        else:
            item = (value_type(word.bare) * self.evaluate(word.formula))()
        self.results.append((word, item, None))
        return ctypes.byref(item)

    def argument(self, word):
        if word.kind == "self":
            return address_of(self.self, type(self.self).__name__, "self")
        if word.kind == "dim":
            return converted("int", self.dim, "dimension")
        if word.kind == "follows":
            return self.evaluate(word.formula)
        if word.kind == "room":
            return self.values["room"]
        if word.kind == "count":
            return self.records(word.name)
        return {"null": lambda _: None, "scalar": self.scalar, "array": self.array, "struct": self.struct,
                "options": lambda w: self.struct(w, True), "result": self.result}[word.kind](word)

    def run(self):
        if any(w.kind == "room" for w in self.plan.words):
            self.counting, self.values["room"] = True, 0
            returned = self.once()
            counted = next((item.value for word, item, _ in self.results if word.name == "count"), returned)
            self.counting, self.values["room"], self.results = False, counted, []
        return self.once()

    def once(self):
        plan = self.plan
        arguments = {id(w): self.argument(w) for w in plan.words if w.kind != "result"}
        arguments |= {id(w): self.argument(w) for w in plan.words if w.kind == "result"}
        returned = plan.function(*[arguments[id(w)] for w in plan.words])
        if plan.words and plan.words[0].ends:
            self.self._gone()
        if self.counting:
            return returned
        if plan.returns != "bat_status":
            return self.assemble() if plan.returns == "void" or "room" in self.values else self.returned(returned)
        best = None
        if returned == TABLE["enums"]["bat_status"]["tolerance"] and any(
                word.bare in CLASSES and not word.handed and item for word, item, _ in self.results):
            best = self.assemble()
        check(returned, best)
        return self.assemble()

    def returned(self, value):
        kind = bare(self.plan.returns)
        if self.plan.returned:
            shape = self.shape(self.plan.returned)
            return self.self._view(value, shape) if hasattr(self.self, "_view") else copied(kind, value, shape)
        if kind in CLASSES:
            out = ctypes.c_void_p()
            check(getattr(lib, kind + "_copy")(ctypes.c_void_p(value), ctypes.byref(out)))
            return KINDS[CLASSES[kind]](out.value, self.dim)
        return record(kind, STRUCTS[kind].from_address(value)) if "*" in self.plan.returns else value

    def read(self, word, item):
        make = KINDS.get(CLASSES.get(word.bare))
        if make and not word.handed:
            return make(item.value, self.values.get("dimension") or self.dim) if item.value else None
        if word.handed and word.kind == "result":
            shape = self.shape(word.formula)
            found = ([make(address, self.dim) for address in (ctypes.c_void_p * shape[0]).from_address(item.value)] if make and item.value
                     else copied(word.bare, item.value, shape))
            lib.bat_free(item)
            return found
        if isinstance(item, np.ndarray):
            return item
        if word.formula is not None:
            return [record(word.bare, one) for one in item]
        if word.bare not in STRUCTS:
            return item.value
        found = record(word.bare, item)
        if word.bare == "bat_meeting":
            lib.bat_meeting_free(ctypes.byref(item))
        if word.bare == "bat_sketch_live_info":
            found.target = copied("double", item.target, (item.target_count, self.dim))
        return found

    def assemble(self):
        """The results as one value."""
        for word, item, _ in self.results:
            if word.formula is None and word.bare in ("int", "size_t"):
                self.values[word.name] = item.value
        used = {name for word, _, _ in self.results for name in re.findall(r"\w+", word.formula or "")}
        found = [(word, self.read(word, item)) for word, item, _ in self.results
                 if word.name not in used and not (word.name == "count" and "room" in self.values)]
        made = [value for word, value in found if word.bare in CLASSES and not word.handed]
        rest = {word.name: value for word, value in found if not (word.bare in CLASSES and not word.handed)}
        if len(made) == 1:
            if made[0] is not None and rest:
                info = rest.pop("info", None)
                report = {**vars(info), **vars(info.report)} if info else vars(rest.pop("report")) if "report" in rest else {}
                report.pop("report", None)
                made[0].report = type("Report", (), {**report, **rest, "__repr__": lambda one: repr({**report, **rest})})()
            return made[0]
        if made:
            return tuple(made)
        if not rest:
            return self.self
        values = tuple(rest.values())
        return values[0] if len(values) == 1 else collections.namedtuple("Results", rest)(*values)


def converted(type_, value, name):
    if type_ in TABLE["enums"]:
        words = TABLE["enums"][type_]
        if value not in words:
            raise BattenError("argument", f"{name} is one of {', '.join(words)}")
        return words[value]
    if type_ == "bool":
        return bool(value)
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise BattenError("argument", f"{name} is not a number")
    if type_ == "double":
        return float(value)
    if value != int(value) or abs(value) > 0x7fffffff or (type_ == "size_t" and value < 0):
        raise BattenError("count" if type_ == "size_t" else "argument", f"{name} is not a whole number")
    return int(value)


def address_of(value, kind, name):
    if not isinstance(value, KINDS[kind]):
        raise BattenError("argument", f"{name} is no {kind}")
    return value._address()


def method(call, name):
    """The Python function of a call. Its signature names what it takes."""
    plan = Plan(call)
    free = call["names"][0].startswith("b.")

    def run(*given, **options):
        self = None if free else given[0]
        given = given if free else given[1:]
        for key in [key for key in options if key in plan.required[len(given):]]:
            given = (*given, options.pop(key)) if plan.required[len(given)] == key else given
        if len(given) != len(plan.required):
            raise TypeError(f"{name}() takes {', '.join(plan.required) or 'nothing'}")
        if unknown := set(options) - set(plan.options):
            raise TypeError(f"{name}() has no option {min(unknown)}")
        return Call(plan, self, given, options).run()

    parameter = inspect.Parameter
    run.__signature__ = inspect.Signature(
        ([] if free else [parameter("self", parameter.POSITIONAL_ONLY)])
        + [parameter(word, parameter.POSITIONAL_OR_KEYWORD) for word in plan.required]
        + [parameter(word, parameter.KEYWORD_ONLY, default=plan.defaults.get(word)) for word in plan.options])
    run.__name__, run.__doc__ = name, f"{call['c']} (include/batten)"
    plain = all(w.kind in ("self", "result") for w in plan.words)
    makes = any(w.bare in CLASSES and w.kind == "result" for w in plan.words) or "bat_shape *" in plan.returns
    return run, not free and plain and not makes and call["c"] != "bat_shape_commit"
