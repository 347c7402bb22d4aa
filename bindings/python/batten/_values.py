"""Arguments as C takes them: numbers, words, text, arrays, objects, and structs of all of these."""
import ctypes
import numbers

import numpy as np

from ._library import CLASSES, KINDS, STRUCTS, TABLE, Record, a, bare, doubles, integers, lib, shown, wrong

FLAT = ("bat_stroke", "bat_spline")  # structs whose points may be given alone, and the rest by name
RULES = TABLE["rules"]
WITHIN = RULES["within"]  # whole numbers that have no use beyond, by name


def address(value, kind, name, kept):
    """The address of an object, which lives as long as `kept`."""
    if not isinstance(value, KINDS[kind]):
        raise wrong(name, a(kind), shown(value))
    memory = value._own
    if not memory:
        raise wrong(name, a(kind), f"one that has been {value._ended}", "state")
    kept.append(memory)
    return memory.address


def encoded(value, name, whole=True):
    """Text as UTF-8; bytes as they are. What has no length beside it ends at a NUL, and so has none."""
    if not isinstance(value, (str, bytes)):
        raise wrong(name, "text", shown(value))
    try:
        data = value.encode() if isinstance(value, str) else value
    except UnicodeError:
        raise wrong(name, "text", shown(value)) from None
    if not whole and b"\0" in data:
        raise wrong(name, "text without NUL", shown(value))
    return data


def is_row(value):
    return isinstance(value, (list, tuple)) or isinstance(value, np.ndarray) and value.ndim > 0


def array_of(type_, value, name, rows=False, size=None):
    """An array of numbers or truths as C has them; rows: of one number or of several."""
    if type_ == "double":
        return doubles(value, name, size)
    if type_ == "bool":
        if not is_row(value):
            raise wrong(name, "a row of truths", shown(value))
        return np.array([converted("bool", one, name) for one in value], dtype=np.bool_)
    return integers(value, name, type_, (1, 2) if rows else (1,))


def converted(type_, value, name, key=None):
    if isinstance(value, np.ndarray) and value.ndim == 0 and not np.ma.is_masked(value):
        value = value[()]
    if type_ in TABLE["enums"]:
        words = TABLE["enums"][type_]
        if not isinstance(value, str) or value not in words:
            raise wrong(name, f"one of {', '.join(words)}", shown(value))
        return words[value]
    if type_ == "bool":
        if not isinstance(value, (bool, np.bool_)):
            raise wrong(name, "True or False", shown(value))
        return bool(value)
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise wrong(name, "a number", shown(value))
    try:
        number = float(value)
    except (OverflowError, ValueError):
        number = np.inf
    if not np.isfinite(number):
        raise wrong(name, "a finite number", shown(value), "number")
    if type_ == "double":
        return number
    name_of = name.rpartition(".")[2]
    low, high = next((WITHIN[one] for one in (key, name_of, type_) if one in WITHIN), (0 if type_ == "size_t" else -0x7fffffff, 0x7fffffff))
    if number != int(number) or not low <= number <= high:
        raise wrong(name, f"a whole number from {low} to {high}", shown(value),
                    name_of if name_of in ("degree", "dimension") else "count" if type_ == "size_t" else "argument")
    return int(number)


def members(struct, value, name):
    """The fields of a struct, by name, as a dict, a record, or what stands for it gives them."""
    own = [field["name"] for field in TABLE["structs"][struct]["fields"] if field["name"] != "size" and not field["counts"]]
    if isinstance(value, Record):
        value = {one.rstrip("_"): given for one, given in vars(value).items()}
    elif not isinstance(value, dict):
        value = alone(struct, value, own)
    if value is None or not value.keys() <= set(own):
        raise wrong(name, f"a dict of {', '.join(own)}", "None" if value is None else f"one of {', '.join(map(str, value)) or 'nothing'}")
    return value


def alone(struct, value, own):
    """What a value that is no dict stands for; None: nothing."""
    handles = value if isinstance(value, (list, tuple)) else [value]
    if struct == "bat_function":
        return {"curve": value} if isinstance(value, KINDS["Curve"]) else {"constant": value} if isinstance(value, numbers.Real) else None
    if struct == "bat_region" and all(isinstance(one, KINDS["Curve"]) for one in handles):
        return {"curves": handles}
    if struct in ("bat_model", "bat_line_scene"):
        found = {field: [one for one in handles if isinstance(one, KINDS[kind])] for field, kind in (("mesh", "Mesh"), ("surfaces", "Surface"), ("curves", "Curve"))}
        if sum(map(len, found.values())) == len(handles) and len(found["mesh"]) < 2:
            return {field: one[0] if field == "mesh" else one for field, one in found.items() if one}
    if struct == "bat_width_profile":
        return {"stops": value}
    if is_row(value) and len(value) == len(own) and struct in ("bat_width_stop", "bat_stop"):
        return dict(zip(own, value))
    return None


def filled(struct, values, name, kept, many=True):
    """An array of structs."""
    if not is_row(values):
        raise wrong(name, "a list", shown(values))
    items = (STRUCTS[struct] * len(values))()
    kept.append(items)
    for index, (item, value) in enumerate(zip(items, values)):
        fill(item, struct, value, f"{name}[{index}]" if many else name, kept)
    return items


def fill(item, struct, value, name, kept):
    if struct == "bat_style":
        lib.bat_style_defaults.restype = STRUCTS[struct]
        ctypes.memmove(ctypes.byref(item), ctypes.byref(lib.bat_style_defaults()), ctypes.sizeof(item))
    elif struct in TABLE["inits"]:
        getattr(lib, TABLE["inits"][struct])(ctypes.byref(item), ctypes.c_size_t(ctypes.sizeof(item)))
    given = {**RULES["defaults"].get(struct, {}), **members(struct, value, name)}
    for field in TABLE["structs"][struct]["fields"]:
        if given.get(field["name"]) is not None:
            set_field(item, struct, field, given[field["name"]], f"{name}.{field['name']}", kept)


def set_field(item, struct, field, value, name, kept, dim=3, size=None):
    """Sets one field of a struct, and the count that stands before it."""
    type_, at = field["type"], field["name"]
    kind, stars = bare(type_), type_.count("*")
    count = field.get("counted")
    if stars and kind in CLASSES and stars == 1:
        setattr(item, at, address(value, CLASSES[kind], name, kept))
    elif stars and kind in CLASSES:
        if not isinstance(value, (list, tuple)):
            raise wrong(name, "a list", shown(value))
        found = (ctypes.c_void_p * len(value))(*[address(one, CLASSES[kind], name, kept) for one in value])
        kept.append(found)
        setattr(item, at, ctypes.addressof(found))
        setattr(item, count, len(value))
    elif stars and kind == "char":
        kept.append(ctypes.create_string_buffer(encoded(value, name, whole=False)))
        setattr(item, at, ctypes.addressof(kept[-1]))
    elif stars and kind in STRUCTS:
        setattr(item, at, ctypes.addressof(filled(kind, value if count else [value], name, kept, bool(count))))
        if count:
            setattr(item, count, len(value))
    elif stars:
        array, each = array_of(kind, value, name, size=size), size or RULES["each"].get(f"{struct}.{at}", 1)
        if array.size % each:
            raise wrong(name, f"records of {each} numbers", shown(array), "count")
        kept.append(array)
        setattr(item, at, array.ctypes.data)
        if count:
            setattr(item, count, array.size // each)
    elif field["room"] and kind in TABLE["enums"]:
        if not isinstance(value, (list, tuple)) or len(value) > field["room"]:
            raise wrong(name, f"a list of {field['room']} words at most", shown(value), "count")
        getattr(item, at)[:len(value)] = [converted(kind, one, name) for one in value]
        setattr(item, count, len(value))
    elif field["room"]:
        array = (doubles(value, name) if kind == "double" else integers(value, name)).ravel()
        if array.size not in (field["room"], dim):
            raise wrong(name, f"{field['room']} numbers", shown(array), "count")
        getattr(item, at)[:array.size] = array.tolist()
        if hasattr(item, "has_" + at):
            setattr(item, "has_" + at, True)
    elif kind in STRUCTS:
        fill(getattr(item, at), kind, value, name, kept)
    else:
        setattr(item, at, converted(type_, value, name))
