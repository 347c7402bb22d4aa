"""Surfaces, meshes, wires, views of them, cameras and motion."""
import ctypes

import numpy as np

from ._call import LIBRARY
from ._handle import Changing, Handle, Memory, Session, Value, Written
from ._library import RECORDS, STRUCTS, copied, doubles, integers, lib, record, shown, wrong
from ._values import converted, filled, is_row


class Surface(Value):
    """A tensor-product B-spline surface in space. It never changes."""

    _made_by = "batten.surface(points, u_knots, v_knots), batten.loft(sections) and others"

    @property
    def points(self):
        """The control points: an array of rows along u, columns along v and three numbers."""
        rows, columns, row = self.count("u"), self.count("v"), lib.bat_surface_row
        row.restype, memory = ctypes.c_void_p, self._memory()
        return np.array([copied("double", row(ctypes.c_void_p(memory.address), i), (columns, 3)) for i in range(rows)])

    def __repr__(self):
        return f"<Surface of {self.count('u')} by {self.count('v')} points>" if self._own else super().__repr__()


def surface(points, u_knots, v_knots, *, degree=3, closed=False):
    array = points if isinstance(points, np.ndarray) else None
    try:
        array = np.array(points, dtype=object) if array is None else array
    except Exception:  # of what others wrote
        raise wrong("points", "rows of points", shown(points)) from None
    if array.ndim != 3 or array.shape[2] != 3:
        raise wrong("points", "rows of points: an array of shape (rows, columns, 3)", shown(array if array.ndim else points))
    flat = array.reshape(-1, 3)
    u_knots, v_knots = doubles(u_knots, "u_knots").ravel(), doubles(v_knots, "v_knots").ravel()
    pairs = [list(one) if isinstance(one, (list, tuple)) else [one, one] for one in (degree, closed)]
    return LIBRARY["_surface"](pairs[0], pairs[1], array.shape[:2], flat, [u_knots.size, v_knots.size], u_knots, v_knots)


class SurfaceFinder(Handle):
    """Finds closest points of one surface, and where rays meet it, faster than the surface does."""

    _made_by = "Surface.finder()"


class Tessellation(Session):
    """Triangles of a surface, which follow it when a part of it changes."""

    _made_by, _instead = "Surface.tessellate()", "triangles that are updated in place; grid gives them as they are"

    @property
    def grid(self):
        """The triangles: points and normals (rows, columns, 3), u, v, and three vertices for each of triangles."""
        with self._lock:
            item, memory = STRUCTS["bat_mesh"](), self._memory()
            lib.bat_tessellation_mesh(ctypes.c_void_p(memory.address), ctypes.byref(item))
            vertices, triangles = (item.rows, item.columns, 3), copied("int", item.triangles, (item.triangle_count, 3))
            return RECORDS["bat_mesh"](rows=item.rows, columns=item.columns, points=copied("double", item.points, vertices),
                                       normals=copied("double", item.normals, vertices), u=copied("double", item.u, (item.rows,)),
                                       v=copied("double", item.v, (item.columns,)), triangles=triangles)


class Relief(Changing, Written):
    """A surface with levels of detail over a base. Edits change it."""

    _made_by = "Surface.levels(levels), Surface.relief() and others"

    def _level_total(self):
        return self.levels

    def _level_count(self, level):
        surface = self.surface(level)
        return surface.count("u") * surface.count("v")

    def add_level(self, u_knots=None, v_knots=None, details=None, source=None):
        with self._lock:
            below, knots = self.surface(self.levels), {"u": u_knots, "v": v_knots}
            if (details is not None or source is not None) and (u_knots is None or v_knots is None):
                raise wrong("u_knots" if u_knots is None else "v_knots", "knots, where details or sources are given", None)
            knots = {name: None if one is None else doubles(one, name + "_knots").ravel() for name, one in knots.items()}
            if details is not None or source is not None:
                count = np.prod([one.size - (1 if below.is_closed(name) else below.degree(name) + 1) for name, one in knots.items()])
                for name, given, each in (("details", details, 3), ("source", source, 1)):
                    if given is not None and np.size(given) != count * each:
                        raise wrong(name, f"{count * each} numbers for {count} control points", shown(np.asarray(given)), "count")
            return self._add_level([0 if one is None else one.size for one in knots.values()], u_knots=knots["u"], v_knots=knots["v"], details=details, source=source)


class Sweep(Handle):
    """A profile that goes along a path."""

    _made_by = "Curve.sweep(profile)"


class Mesh(Value):
    """Polygons in space, or a cloud of points. It never changes."""

    _made_by = "batten.mesh(vertices, faces), batten.read_obj(text) and others"

    @property
    def faces(self):
        """The vertices of each face: a list of arrays."""
        return [self.face(i) for i in range(self.face_count)]

    def __repr__(self):
        return f"<Mesh of {self.vertex_count} vertices, {self.face_count} faces>" if self._own else super().__repr__()


def mesh(vertices, faces=()):
    if not is_row(faces):
        raise wrong("faces", "a list of faces", shown(faces))
    corners = [integers(face, f"faces[{i}]") for i, face in enumerate(faces)]
    for i, face in enumerate(corners):
        if face.size < 3:
            raise wrong(f"faces[{i}]", "3 vertices or more", face.size, "count")
    return LIBRARY["_mesh"](vertices, [one.size for one in corners] or np.empty(0), np.concatenate(corners) if corners else np.empty(0))


class Reference(Handle):
    """What distances are measured to."""

    _made_by = "batten.reference(curves=..., surfaces=..., meshes=...)"


class Binding(Handle):
    """Points that follow wires."""

    _made_by = "batten.bind(wires, points)"

    def apply(self, curves, points=None):
        wires, bound = self._memory().made_of[2]
        if not isinstance(curves, (list, tuple)) or len(curves) != len(wires):
            raise wrong("curves", f"a list of {len(wires)} curves", shown(curves), "count")
        array, bound = doubles(bound if points is None else points, "points"), doubles(bound, "points")
        if array.size != bound.size:
            raise wrong("points", f"{bound.size // 3} points, as were bound", shown(array), "count")
        return self._apply(curves, array.reshape(-1, 3))


class Tracks(Handle):
    """Curves that surfaces have in a view or with each other, as polylines."""

    _made_by = "Surface.silhouettes(view), Surface.section(origin, normal), Surface.intersect(b)"

    def points(self, i):
        out, memory = ctypes.c_void_p(), self._memory()
        lib.bat_tracks_points.restype = ctypes.c_size_t
        count = lib.bat_tracks_points(ctypes.c_void_p(memory.address), ctypes.c_size_t(converted("size_t", i, "i")), ctypes.byref(out))
        return copied("bat_track_point", out.value, (count,))


class LineDrawing(Handle):
    """What is seen of a scene, as lines."""

    _made_by = "batten.line_drawing(view, scene)"

    def at(self, i):
        item, memory = STRUCTS["bat_seen_line"](), self._memory()
        lib.bat_line_drawing_at(ctypes.c_void_p(memory.address), ctypes.c_size_t(converted("size_t", i, "i")), ctypes.byref(item))
        line = record("bat_seen_line", item)
        line.points = copied("double", item.points, (item.segments * 3 + 1, 2)) if item.points else np.empty((0, 2))
        return line


class Camera(Changing, Written):
    """A camera move. Edits change it."""

    _made_by = "Curve.camera(mode=...) and batten.read_camera(text)"

    def _level_total(self):
        return self.levels


class Take(Handle):
    """Motion as it was recorded: a skeleton and its frames."""

    _made_by = "batten.read_bvh(text) and batten.take(joints, values, frame_time)"

    @property
    def joint_count(self):
        """How many joints there are, ends too."""
        return len(self.joints)

    def __reduce__(self):
        return take, (self.joints, self.values, self.frame_time)


def take(joints, values, frame_time):
    """A take of joints (dicts of name, parent, offset, channels, end) and, for each frame, a row with all their channels."""
    item = filled("bat_bone", joints, "joints", kept := [])
    channels, values = sum(one.channel_count for one in item), doubles(values, "values")
    if values.ndim != 2 or values.shape[1] != channels:
        raise wrong("values", f"a row of {channels} numbers for each frame", shown(values), "count")
    del kept
    return LIBRARY["_take"](list(joints), values.shape[0], frame_time, values.ravel())


class Motion(Changing):
    """A take with few knots, in levels. Edits change it."""

    _made_by = "Take.motion()"

    def take(self):
        memory = self._memory()
        lib.bat_motion_take.restype = ctypes.c_void_p
        return Take._sharing(Memory(lib.bat_motion_take(ctypes.c_void_p(memory.address)), None, memory), 3)

    @property
    def joint_count(self):
        """How many joints there are, ends too."""
        return self.take().joint_count
