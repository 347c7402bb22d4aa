"""Documents, what is in them, and files that are read by hand."""
import ctypes
from xml.parsers import expat

import numpy as np

from ._call import LIBRARY, Report, said
from ._handle import Changing, Handle, Written
from ._library import STRUCTS, BattenError, check, copied, lib, record, shown, wrong
from ._values import encoded, filled


class Picture(Handle):
    """The bytes of a PNG, JPEG or WebP file."""

    _made_by = "batten.picture(bytes)"

    @property
    def bytes(self):
        size, memory = ctypes.c_size_t(), self._memory()
        lib.bat_picture_bytes.restype = ctypes.c_void_p
        return ctypes.string_at(lib.bat_picture_bytes(ctypes.c_void_p(memory.address), ctypes.byref(size)), size.value)

    def __reduce__(self):
        return LIBRARY["picture"], (self.bytes,)


class Object(Handle):
    """An object of a document: a path, a spline, a group, a picture, a surface and so on. It never changes."""

    _made_by = "batten.path_object(curves) and others"

    @property
    def curves(self):
        """Its curves: a list."""
        return [self.curve(i) for i in range(self.curve_count)]

    @property
    def corners(self):
        box, memory = (ctypes.c_double * 8)(), self._memory()
        if self.picture() is None:
            return None
        lib.bat_object_corners(ctypes.c_void_p(memory.address), box)
        return np.array(box).reshape(4, 2)

    @property
    def guide(self):
        at, memory = ctypes.c_double(), self._memory()
        axis = lib.bat_object_guide(ctypes.c_void_p(memory.address), ctypes.byref(at))
        return None if axis < 0 else (axis, at.value)

    @property
    def sources(self):
        ids, memory = ctypes.c_void_p(), self._memory()
        count = lib.bat_object_sources(ctypes.c_void_p(memory.address), ctypes.byref(ids))
        return list((ctypes.c_uint64 * count).from_address(ids.value)) if count else []

    @property
    def spline(self):
        memory = self._memory()
        lib.bat_object_spline.restype = ctypes.c_void_p
        found = lib.bat_object_spline(ctypes.c_void_p(memory.address))
        return _arrays(STRUCTS["bat_spline"].from_address(found)) if found else None

    def __reduce__(self):
        alone = LIBRARY["document"]()
        alone.insert(0, self)
        return _object, (alone.write(),)

    def __repr__(self):
        return f"<Object {self.id}: {self.kind}, {self.curve_count} curves>" if self._own else super().__repr__()


def _object(text):
    return LIBRARY["read_document"](text).at(0)


class Document(Changing, Written):
    """An ordered list of objects, back to front. It changes."""

    _made_by = "batten.document(), batten.read_svg(text) and others"

    @property
    def objects(self):
        """All objects, back to front: a list."""
        with self._lock:
            return [self.at(i) for i in range(self.count)]

    def add(self, object):
        """Puts an object in front of all others, under a new id, which is returned."""
        if not isinstance(object, Object):
            raise wrong("object", "an Object", shown(object))
        with self._lock:
            number = self.new_id()
            self.insert(self.count, object.with_id(number))
            return number

    def __repr__(self):
        return f"<Document of {self.count} objects>" if self._own else super().__repr__()


def _arrays(item):
    """A stroke or a spline as a dict that the calls take."""
    each = {"points": item.dimension, "tangents": item.dimension, "tension": 2, "pressure": 1, "time": 1}
    found = {name: copied("double", getattr(item, name), (item.count, size) if size > 1 else (item.count,))
             for name, size in each.items() if getattr(item, name, None)}
    return found | ({"closed": item.closed} if hasattr(item, "closed") else {})


def _read_arrays(function, struct, text):
    data, item, block, problem = encoded(text, "text"), STRUCTS[struct](), ctypes.c_void_p(), STRUCTS["bat_problem"]()
    check(function(data, ctypes.c_size_t(len(data)), ctypes.byref(item), ctypes.byref(block), ctypes.byref(problem)), told=said([problem], ""))
    found = _arrays(item)
    lib.bat_free(block)
    return found


def read_stroke(text):
    """A stroke of JSON or CSV, as a dict of points, pressure and time that the calls take.

    In C: bat_stroke_read, <batten/format.h>"""
    return _read_arrays(lib.bat_stroke_read, "bat_stroke", text)


def read_spline(text):
    """A spline of JSON, as a dict of points, tangents, tension and closed that the calls take.

    In C: bat_spline_read, <batten/format.h>"""
    return _read_arrays(lib.bat_spline_read, "bat_spline", text)


def read_svg(text, **options):
    """An SVG file as a document, whose report says what was left out. Nothing is fetched. tolerance, corner and share as in
    bat_svg_options.

    In C: bat_svg_reader, <batten/format.h>"""
    data, reader, faults = encoded(text, "text"), ctypes.c_void_p(), []
    given = filled("bat_svg_options", [options], "options", [], False)
    check(lib.bat_svg_reader_create(ctypes.byref(given), ctypes.byref(reader)))

    def tell(status):
        if status:
            faults.append(status)

    def start(name, attributes):
        words = [name, *attributes]
        tell(lib.bat_svg_reader_start(reader, words[0].encode(), (ctypes.c_char_p * len(words))(*[one.encode() for one in attributes], None)))

    def characters(some):
        some = some.encode()
        tell(lib.bat_svg_reader_text(reader, some, ctypes.c_size_t(len(some))))

    parser = expat.ParserCreate()
    parser.ordered_attributes = parser.buffer_text = True
    parser.StartElementHandler, parser.CharacterDataHandler = start, characters
    parser.EndElementHandler = lambda _: tell(lib.bat_svg_reader_end(reader))
    try:
        parser.Parse(data, True)
        check(faults[0] if faults else 0)
        if isinstance(text, str) or not data[:2] in (b"\xff\xfe", b"\xfe\xff"):
            check(lib.bat_svg_reader_source(reader, data, ctypes.c_size_t(len(data))))
    except (expat.ExpatError, BattenError) as error:
        lib.bat_svg_reader_free(reader)
        if isinstance(error, BattenError):
            raise
        raise BattenError("syntax", f"text: line {error.lineno}, column {error.offset + 1}: {expat.ErrorString(error.code)}") from None
    out, report, problem = ctypes.c_void_p(), STRUCTS["bat_svg_report"](), STRUCTS["bat_problem"]()
    check(lib.bat_svg_reader_finish(reader, ctypes.byref(out), ctypes.byref(report), ctypes.byref(problem)), told=said([problem], ""))
    found = Document._made(out.value)
    found.report = Report(**vars(record("bat_svg_report", report)))
    return found
