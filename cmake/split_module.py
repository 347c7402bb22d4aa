#!/usr/bin/env python3
"""Splits a linked module in two, of which the second, NAME-later.wasm, is fetched when the page is there.

Usage: split_module.py MODULE.wasm LINKED.map FIRST.txt wasm-opt wasm-split FLAG...
Functions that FIRST does not list go to the second part; it is recorded (tests/web/first_part.mjs). So does the constant data that
only those can reach: that of an object file all of whose functions go, unless others know it by name, and what is marked as late
(strings.def). Until the second part is there it is zero. The linker's map says what lies where; it must not have merged strings
(-O0). Both parts are then optimised for size: x.wasm.named is a part that still has its functions' names. Imports between the parts
are named by the digest of the whole, so parts of different builds do not fit. FLAGS: for binaryen's tools.
"""
import hashlib
import pathlib
import re
import subprocess
import sys

LATE = "late_texts"  # a constant whose object stays, and which goes
DATA, DATA_COUNT = 11, 12  # sections
CONSTANT, END = 0x41, 0x0B  # in a segment's address
SYMBOLS = 8  # a part of the section "linking" of an object file
VARIABLE, SECTION = 1, 3  # kinds of symbols
LOCAL, UNDEFINED, NAMED = 2, 16, 64  # flags of symbols


def room(name):
    """A file of src/ or web/, or of a library, as FIRST names it."""
    name = re.sub(r"^.*/(?:src|web)/(.*)\.c\.obj$", r"\1", name)
    return re.sub(r"^.*/(lib[a-z_0-9.-]+)\.a\((.*)\)$", r"\1/\2", name)


def linked(lines):
    """(kind, address, size, object, name) of all functions and data in a linker's map."""
    kind = ""
    for line in lines:
        if (head := re.search(r" (CODE|DATA)$| \.bss$", line)):
            kind = head[1] or ""
        elif kind and (row := re.match(r" *([0-9a-f-]+) +[0-9a-f]+ +([0-9a-f]+) +([^ ]+):\(([A-Za-z_0-9.$]+)\)$", line)):
            yield kind, row[1], int(row[2], 16), row[3], row[4]


def whole_number(data, at):
    """An unsigned LEB128 and where it ends."""
    value = shift = 0
    while True:
        value |= (data[at] & 127) << shift
        shift += 7
        at += 1
        if data[at - 1] < 128:
            return value, at


def number(value, signed=False):
    """LEB128; a signed one has its sign in the seventh bit of its last byte."""
    out = bytearray()
    while True:
        out.append(value & 127 | 128)
        value >>= 7
        if value == 0 and not (signed and out[-1] & 64):
            out[-1] &= 127
            return bytes(out)


def sections(module):
    """[id, bytes] of each section."""
    at, found = 8, []
    while at < len(module):
        size, begin = whole_number(module, at + 1)
        found.append([module[at], module[begin:begin + size]])
        at = begin + size
    return found


def named(data, at):
    """A name and where it ends."""
    size, at = whole_number(data, at)
    return data[at:at + size], at + size


def is_known(path):
    """Whether other object files know some data of an object file by name."""
    for kind, data in sections(path.read_bytes()):
        if kind != 0:
            continue
        name, at = named(data, 0)
        at = whole_number(data, at)[1]  # past the version
        while name == b"linking" and at < len(data):
            part, (symbols, at) = data[at], named(data, at + 1)
            if part == SYMBOLS and any(kind == VARIABLE and not flags & (LOCAL | UNDEFINED) for kind, flags in symbols_of(symbols)):
                return True
    return False


def symbols_of(data):
    """(kind, flags) of each symbol."""
    count, at = whole_number(data, 0)
    for _ in range(count):
        kind, (flags, at) = data[at], whole_number(data, at + 1)
        yield kind, flags
        if kind != VARIABLE:
            at = whole_number(data, at)[1]
        if kind == VARIABLE or (kind != SECTION and (flags & NAMED or not flags & UNDEFINED)):
            at = named(data, at)[1]
        if kind == VARIABLE and not flags & UNDEFINED:
            for _ in range(3):  # segment, offset, size
                at = whole_number(data, at)[1]


def segments(data):
    """(address, bytes) of each active segment at a constant address: there are no others."""
    count, at = whole_number(data, 0)
    for _ in range(count):
        if data[at] != 0 or data[at + 1] != CONSTANT:
            raise SystemExit("split_module.py: a segment of another kind")
        address, at = whole_number(data, at + 2)
        size, at = whole_number(data, at + 1)
        yield address, data[at:at + size]
        at += size


def section_of(parts):
    """The data section of segments."""
    return number(len(parts)) + b"".join(
        bytes([0, CONSTANT]) + number(address, True) + bytes([END]) + number(len(data)) + data for address, data in parts)


def divided(parts, moved):
    """Segments cut at the ends of address ranges: those outside, and those inside, without the zeros that memory has anyway."""
    stay, go = [], []
    for address, data in parts:
        ends = sorted({0, len(data), *(end - address for one in moved for end in one if 0 < end - address < len(data))})
        for begin, end in zip(ends, ends[1:]):
            inside = any(low <= address + begin < high for low, high in moved)
            piece = data[begin:end].rstrip(b"\0")
            ahead = len(piece) - len(piece.lstrip(b"\0"))
            if piece:
                (go if inside else stay).append((address + begin + ahead, piece[ahead:]))
    return stay, go


def move_data(first_path, later_path, moved):
    """Moves the data of address ranges from one module to the other."""
    first, later = (sections(path.read_bytes()) for path in (first_path, later_path))
    [own] = [section for section in first if section[0] == DATA]
    stay, go = divided(segments(own[1]), moved)
    if any(section[0] == DATA for section in later):
        raise SystemExit("split_module.py: the second part has data already")
    own[1] = section_of(stay)
    for section in first:
        if section[0] == DATA_COUNT:
            section[1] = number(len(stay))
    at = next((i for i, section in enumerate(later) if section[0] == 0 and i > 1), len(later)) # before the names
    later.insert(at, [DATA, section_of(go)])
    for path, parts in ((first_path, first), (later_path, later)):
        path.write_bytes(path.read_bytes()[:8] + b"".join(bytes([kind]) + number(len(data)) + data for kind, data in parts))
    print(f"{sum(len(data) for _, data in go)} bytes of data in the second part, {sum(len(data) for _, data in stay)} in the first")


def main():
    module, map_path, first_path = map(pathlib.Path, sys.argv[1:4])
    opt, split, *flags = sys.argv[4:]
    later = module.with_name(module.stem + "-later.wasm")
    listed = {(file, name) for line in first_path.read_text("utf-8").splitlines() if re.match("[a-z]", line)
              for file, *names in [line.split()] for name in names}
    rows = list(linked(map_path.read_text("utf-8").splitlines()))

    # Of several functions `up` the tools call the second up.1, the third up.2 and so on. What the shell calls, and what the linker
    # makes, stays.
    times, moved, staying = {}, [], set()
    for kind, _, _, file, name in rows:
        if kind != "CODE":
            continue
        called = name + (f".{times[name]}" if name in times else "")
        times[name] = times.get(name, 0) + 1
        if (room(file), name) in listed or re.match("module/|<internal>", room(file)) or "crt1" in file:
            staying.add(file)
        else:
            moved.append(called)
    list_path = pathlib.Path(f"{module}.later")
    list_path.write_text("\n".join(moved) + "\n", "utf-8")

    going = {file for kind, *_, file, _ in rows if kind == "DATA" and file.endswith(".obj")} - staying
    going = {file for file in going if not is_known(pathlib.Path(file))}
    ranges = [(int(address, 16), int(address, 16) + size) for kind, address, size, file, name in rows
              if kind == "DATA" and (file in going or name.endswith(f".{LATE}"))]

    # Split before optimising: a function that has been inlined can no longer be moved.
    whole = pathlib.Path(f"{module}.whole")
    build = hashlib.sha256(module.read_bytes()).hexdigest()[:12]
    module.rename(whole)
    run = lambda *words: subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)
    run(split, "-g", "--split", whole, "--placeholdermap", f"--import-namespace={build}", f"--placeholder-namespace={build}",
        f"--split-funcs=@{list_path}", "-o1", module, "-o2", later, *flags)
    for part in (module, later):
        run(opt, "-Os", "--low-memory-unused", "-g", "--strip-producers", *flags, part, "-o", f"{part}.named")
        run(opt, "--strip-debug", *flags, f"{part}.named", "-o", part)
    move_data(module, later, ranges)


main()
