"""Objects of the library as Python holds them: memory that is given back, copies, pickles, threads and forks."""
import contextlib
import ctypes
import os
import threading
import weakref

from ._call import LIBRARY, Report
from ._library import TABLE, BattenError, lib


class Memory:
    """What the library allocated, until nothing looks at it any more."""

    __slots__ = "address", "free", "made_of", "__weakref__"

    def __init__(self, address, free, made_of=None):
        self.address, self.free, self.made_of = address, free, made_of  # made_of: what must live as long

    def __del__(self):
        if self.address and self.free:
            self.free(self.address)


class Handle:
    _own, _dim, _ended, _changes = None, 3, "freed", False
    report = Report()
    _lock = contextlib.nullcontext()  # of what never changes

    def __new__(cls, *given, **options):
        raise TypeError(f"a {cls.__name__} is made by {cls._made_by}")

    def __init_subclass__(cls):
        if cls.__name__ in TABLE["frees"]:
            cls._free = staticmethod(getattr(lib, TABLE["frees"][cls.__name__]))
            cls._free.argtypes, cls._free.restype = [ctypes.c_void_p], None

    @classmethod
    def _made(cls, address, dim=3):
        return cls._sharing(Memory(address, cls._free), cls._dimension(address, dim))

    @staticmethod
    def _dimension(address, dim):
        return dim

    @classmethod
    def _sharing(cls, memory, dim):
        self = object.__new__(cls)
        self._own, self._dim = memory, dim
        return self

    @property
    def dim(self):
        """The number of coordinates, 2 or 3."""
        return self._dim

    def _memory(self):
        if not self._own:
            raise BattenError("state", f"this {type(self).__name__} has been {self._ended}")
        return self._own

    def _end(self, how):
        self._own, self._ended = None, how

    def free(self):
        """Gives the memory back at once. Any use after that is an error."""
        with self._lock:
            self._end(self._ended if not self._own else "freed")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.free()

    def __copy__(self):
        other = self._sharing(self._memory(), self._dim)
        other.__dict__ |= self._told()
        return other

    def __deepcopy__(self, _):
        return self.__copy__()

    def __reduce__(self):
        made_of = self._memory().made_of
        if made_of is None:
            raise TypeError(f"a {type(self).__name__} cannot be pickled")
        return _again, made_of

    def _told(self):
        """What others have put on it: its report, and names of their own."""
        return {name: value for name, value in vars(self).items() if not name.startswith("_")}

    def __repr__(self):
        return f"<{type(self).__name__}{'' if self._own else ', ' + self._ended}>"


def _again(one, name, given, options):
    """Makes what a call has made, once more."""
    return (LIBRARY[name] if one is None else getattr(one, name))(*given, **options)


class Written(Handle):
    """What is pickled as the text that it writes."""

    def __reduce__(self):
        return _read, (type(self).__name__, self.write(), self._told())


def _read(kind, text, told):
    one = LIBRARY["read_" + kind.lower()](text)
    one.__dict__ |= told
    return one


class Value(Written):
    """What never changes, and is what its numbers are."""

    def __eq__(self, other):
        return self.is_equal(other) if isinstance(other, type(self)) else NotImplemented

    def __hash__(self):
        if "_hash" not in self.__dict__:
            self._hash = hash(self.write())
        return self._hash


class Changing(Handle):
    """What changes: one thread at a time."""

    _changes = True

    @classmethod
    def _sharing(cls, memory, dim):
        self = super()._sharing(memory, dim)
        self._lock = threading.RLock()
        _changing[id(self)] = self
        return self

    def __copy__(self):
        other = self.copy()
        other.__dict__ |= self._told()
        return other


class Session(Changing):
    _changes = False  # no call takes it
    _instead = "a session of one pen; commit() gives its result"

    def _no(self, *_):
        raise TypeError(f"a {type(self).__name__} cannot be copied or pickled: it is {self._instead}")

    __copy__ = __deepcopy__ = __reduce__ = __reduce_ex__ = _no


_changing = weakref.WeakValueDictionary()
_held = []


def _hold():
    """Before a fork: no other thread is in the middle of a change."""
    _held[:] = [handle for one in _changing.valuerefs() if (handle := one())]
    for handle in _held:
        handle._lock.acquire()


def _release():
    for handle in _held:
        handle._lock.release()
    _held.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_release, after_in_child=_release)
