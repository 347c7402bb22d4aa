"""libbatten, and the structs that go in and out of it, as calls.json describes them."""
import ctypes
import json
import pathlib
import re
from types import SimpleNamespace

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
TABLE = json.loads((HERE / "calls.json").read_text("utf-8"))
CLASSES = TABLE["classes"]
SCALARS = {"double": ctypes.c_double, "int": ctypes.c_int, "size_t": ctypes.c_size_t, "bool": ctypes.c_bool}
NUMPY = {"double": np.float64, "int": np.intc}


class BattenError(ValueError):
    """What the library could not do. status: a word; code: its number; best: with "tolerance", the best result found."""

    def __init__(self, status, message, best=None):
        super().__init__(message)
        self.status, self.code, self.best = status, TABLE["enums"]["bat_status"][status], best


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


def value_type(type_):
    """The ctypes type of one value."""
    return STRUCTS.get(type_) or SCALARS.get(type_, ctypes.c_void_p if type_ in CLASSES else ctypes.c_int)


def field_type(field):
    one = ctypes.c_void_p if field["type"].endswith("*") else value_type(field["type"])
    return one * field["room"] if field["room"] else one


STRUCTS = {}


def define(name):
    """Makes a struct, after those that it holds."""
    if name not in STRUCTS and name in TABLE["structs"]:
        fields = TABLE["structs"][name]["fields"]
        for field in fields:
            define(bare(field["type"]))
        STRUCTS[name] = type(name, (ctypes.Structure,), {"_fields_": [(f["name"], field_type(f)) for f in fields]})


for struct in TABLE["structs"]:
    define(struct)

lib = ctypes.CDLL(str(next(HERE.glob("*batten*.so*"), None) or next(HERE.glob("*batten*.d*"))))
lib.bat_status_message.restype = lib.bat_version.restype = ctypes.c_char_p
lib.bat_free.argtypes = [ctypes.c_void_p]


def check(code, best=None):
    """Raises what a status says, but for OK."""
    if code:
        word = next(word for word, number in TABLE["enums"]["bat_status"].items() if number == code)
        raise BattenError(word, lib.bat_status_message(code).decode(), best)


def word_of(enum, number):
    return next((word for word, value in TABLE["enums"][enum].items() if value == number), number)


def doubles(value, name, size=None):
    """An array of numbers in a row, without a copy where it is one already; None among points is a point of zeros."""
    if isinstance(value, (list, tuple)) and any(one is None for one in value):
        size = size or next((len(one) for one in value if one is not None), 2)
        value = [(0.0,) * size if one is None else one for one in value]
    try:
        array = np.ascontiguousarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise BattenError("argument", f"{name} is not an array of numbers") from None
    if value is None or array.ndim not in (1, 2):
        raise BattenError("argument", f"{name} is not an array of points or numbers")
    return array


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


def copied(type_, address, shape):
    """A copy of what lies at an address: numbers as an array, structs as a list."""
    count = int(np.prod(shape))
    if not address or not count:
        return np.empty(shape) if type_ in NUMPY else []
    items = (value_type(type_) * count).from_address(address)
    if type_ in NUMPY:
        return np.frombuffer(items, dtype=NUMPY[type_]).reshape(shape).copy()
    return [record(type_, item) for item in items]


def record(type_, item):
    """A struct as a namespace. Pointers are left out, but for those with a count before them."""
    found, count = {}, 0
    for field in TABLE["structs"][type_]["fields"]:
        name, kind = field["name"], field["type"]
        value = getattr(item, name)
        if kind.endswith("*"):
            if bare(kind) in STRUCTS:
                found[name] = copied(bare(kind), value, (count,))
        elif kind == "size_t" and re.search(r"(^|_)count$", name):
            count = value
        elif field["room"]:
            found[name] = np.array(value[:]) if kind == "double" else list(value)
        elif name != "size":
            found[name] = record(kind, value) if kind in STRUCTS else word_of(kind, value) if kind in TABLE["enums"] else value
    return SimpleNamespace(**found)
