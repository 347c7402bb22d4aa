"""libbatten, and the structs that go in and out of it, as calls.json describes them."""
import ctypes
import json
import keyword
import pathlib
import re
from types import SimpleNamespace

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
TABLE = json.loads((HERE / "calls.json").read_text("utf-8"))
DOCS = json.loads((HERE / "docs.json").read_text("utf-8"))
CLASSES = TABLE["classes"]
KINDS = {}  # their Python classes, by name
SCALARS = {"double": ctypes.c_double, "int": ctypes.c_int, "size_t": ctypes.c_size_t, "bool": ctypes.c_bool, "char": ctypes.c_char,
           "uint32_t": ctypes.c_uint32, "uint64_t": ctypes.c_uint64, "bat_id": ctypes.c_uint64}
NUMPY = {"double": np.float64, "int": np.intc, "size_t": np.uintp, "bool": np.bool_}
WHEN_NEEDED = None if int(np.__version__.split(".")[0]) > 1 else False  # for np.array(copy=...)
SHARED = ("bat_object", "bat_picture")  # whose users are counted
NUMBERS_MOST = 1 << 26  # of one result: half a GB


class BattenError(ValueError):
    """What the library could not do. status: a word; code: its number; best: with "tolerance", the best result found."""

    def __init__(self, status, message, best=None):
        super().__init__(message)
        self.status, self.code, self.best = status, TABLE["enums"]["bat_status"][status], best

    def __reduce__(self):
        return BattenError, (self.status, str(self), self.best)


BattenError.__module__ = "batten"


def shown(value):
    """A value that was not expected, in words."""
    if isinstance(value, np.ma.MaskedArray):
        return f"a masked array with {np.ma.count_masked(value)} masked numbers"
    if isinstance(value, np.ndarray) and value.ndim:
        return f"an array of shape {value.shape} of {value.dtype}"
    if value is None or isinstance(value, (bool, int, float, complex, str, bytes, np.generic)):
        text = str(value) if isinstance(value, np.generic) else repr(value) if not isinstance(value, int) or abs(value) < 10**30 else "a huge number"
        return text if len(text) <= 40 else text[:40] + "..."
    return f"a {type(value).__name__}" + (f" of {len(value)}" if isinstance(value, (list, tuple, dict)) else "")


def a(kind):
    return f"an {kind}" if kind[0] in "AEIOU" else f"a {kind}"


def wrong(name, expected, found, status="argument"):
    """The error of an argument."""
    return BattenError(status, f"{name}: expected {expected}, found {found}")


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


def value_type(type_):
    """The ctypes type of one value."""
    return STRUCTS.get(type_) or SCALARS.get(type_, ctypes.c_void_p if type_ in CLASSES else ctypes.c_int)


def field_type(field):
    one = ctypes.c_void_p if field["type"].endswith("*") else value_type(field["type"])
    return one * field["room"] if field["room"] else one


def same(a, b):
    """Whether two values of fields are equal; nan is equal to nan."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.array_equal(a, b, equal_nan=True)
    return a == b or a != a and b != b


class Record(SimpleNamespace):
    """Values with names, that copy, compare and pickle."""

    def __eq__(self, other):
        if type(self) is not type(other):
            return NotImplemented
        return vars(self).keys() == vars(other).keys() and all(same(value, vars(other)[name]) for name, value in vars(self).items())

    __hash__ = None


STRUCTS, RECORDS = {}, {}


def define(name):
    """Makes a struct, after those that it holds."""
    if name not in STRUCTS and name in TABLE["structs"]:
        fields = TABLE["structs"][name]["fields"]
        for field in fields:
            define(bare(field["type"]))
        STRUCTS[name] = type(name, (ctypes.Structure,), {"_fields_": [(f["name"], field_type(f)) for f in fields]})
        RECORDS[name] = type(TABLE["structs"][name]["title"], (Record,), {"__module__": "batten"})


for struct in TABLE["structs"]:
    define(struct)

lib = ctypes.CDLL(str(next(HERE.glob("*batten*.so*"), None) or next(HERE.glob("*batten*.d*"))))
lib.bat_status_message.restype = lib.bat_version.restype = ctypes.c_char_p
lib.bat_free.argtypes = [ctypes.c_void_p]
lib.bat_free.restype = None


def check(code, best=None, where="", told=""):
    """Raises what a status says, but for OK; what the call told of it comes first."""
    if code:
        raise BattenError(word_of("bat_status", code), (told or lib.bat_status_message(code).decode()) + where, best)


def word_of(enum, number):
    return next((word for word, value in TABLE["enums"][enum].items() if value == number), number)


def numeric(value, name):
    """A value as an array of numbers of any type."""
    if np.ma.is_masked(value):
        raise wrong(name, "numbers without a mask", shown(value))
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O" and value is not None:
            array = array.astype(np.float64)
    except Exception:  # of what others wrote: __array__, __float__
        raise wrong(name, "an array of numbers", shown(value)) from None
    if array.dtype.kind not in "iuf" or array.ndim not in (1, 2):
        raise wrong(name, "an array of points or numbers", shown(array if array.ndim else value))
    return array


def doubles(value, name, size=None):
    """An array of finite numbers in a row, without a copy where it is one already; None among tangents is a point of zeros."""
    if size and name == "tangents" and isinstance(value, (list, tuple)):
        value = [(0.0,) * size if one is None else one for one in value]
    array = np.array(numeric(value, name), dtype=np.float64, order="C", copy=WHEN_NEEDED)
    if not array.flags.aligned:
        array = array.copy()
    if not np.isfinite(array).all():
        place = tuple(int(one) for one in np.argwhere(~np.isfinite(array))[0])
        raise wrong(name + "".join(f"[{one}]" for one in place), "a finite number", array[place], "number")
    return array


def integers(value, name, type_="int", dimensions=(1,)):
    """An array of whole numbers as C has them."""
    array, least = numeric(value, name), 0 if type_ == "size_t" else -0x7fffffff
    if array.ndim not in dimensions or not (np.isfinite(array).all() and (array == np.trunc(array)).all() and (least <= array).all() and (array <= 0x7fffffff).all()):
        raise wrong(name, "a row of whole numbers" if dimensions == (1,) else "whole numbers", shown(value))
    return np.ascontiguousarray(array, dtype=NUMPY[type_])


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


def copied(type_, address, shape, dim=3):
    """A copy of what lies at an address: numbers as an array, structs as a list, of an object of dim; None where nothing lies."""
    count = int(np.prod(shape))
    if not count:
        return np.empty(shape, dtype=NUMPY[type_]) if type_ in NUMPY else []
    if not address:
        return None
    items = (value_type(type_) * count).from_address(address)
    if type_ in NUMPY:
        return np.frombuffer(items, dtype=NUMPY[type_]).reshape(shape).copy()
    return [record(type_, item, dim) for item in items]


def handle(type_, address):
    """An object of its own for one that something else owns."""
    if not address:
        return None
    out = ctypes.c_void_p(address)
    if type_ in SHARED:
        getattr(lib, type_ + "_retain")(out)
    else:
        check(getattr(lib, type_ + "_copy")(out, ctypes.byref(out)))
    return KINDS[CLASSES[type_]]._made(out.value)


def text_at(address):
    return ctypes.string_at(address).decode("utf-8", "replace") if address else None


def pointed(type_, value, count, dim):
    """What a pointer in a struct points to; without a count before it, one."""
    type_, many = bare(type_), type_.count("*") > 1
    if type_ == "char":
        return text_at(value)
    if type_ in CLASSES and not many:
        return handle(type_, value)
    if count is None:
        return record(type_, STRUCTS[type_].from_address(value)) if value and type_ in STRUCTS else None
    if type_ in CLASSES:
        return [handle(type_, one) for one in (ctypes.c_void_p * count).from_address(value)] if value else []
    return copied(type_, value, (count,), dim)


def record(type_, item, dim=3):
    """A struct as a namespace, of an object of dim. Arrays that no field counts are left out."""
    found = {}
    for field in TABLE["structs"][type_]["fields"]:
        name, kind = field["name"], field["type"]
        if field["counts"] or name == "size":
            continue
        value, count = getattr(item, name), getattr(item, field["counted"]) if "counted" in field else None
        name += "_" * keyword.iskeyword(name)  # from_
        if kind.endswith("*"):
            if count is not None or bare(kind) not in NUMPY and not kind.endswith("**"):
                found[name] = pointed(kind, value, count, dim)
        elif field["room"]:
            found[name] = np.array(value[:dim if "each" in field else None]) if kind == "double" else [word_of(kind, one) for one in value[:count]] if kind in TABLE["enums"] else list(value)
        else:
            found[name] = record(kind, value, dim) if kind in STRUCTS else word_of(kind, value) if kind in TABLE["enums"] else value
    return RECORDS[type_](**found)
