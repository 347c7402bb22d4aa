#!/usr/bin/env python3
"""Writes index.d.ts of batten-core from calls.json and docs.json beside it: types.py CALLS.json HEAD.d.ts OUT.d.ts. In HEAD stands what is written by
hand; members of a class there go before those that are made here."""
import json
import pathlib
import re
import sys

NUMBERS = ("double", "int", "size_t")
NAMES = {"bat_near": "Near", "bat_apart": "Apart", "bat_arc": "Arc", "bat_frame3": "Frame", "bat_joint": "Joint",
         "bat_meeting": "Meeting", "bat_crossing": "Crossing", "bat_overlap": "Overlap"}


def camel(name):
    return re.sub(r"_(\w)", lambda found: found[1].upper(), name)


def pascal(name):
    return NAMES.get(name) or camel("_" + name.removeprefix("bat_"))


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


class Types:
    def __init__(self, calls, docs):
        self.docs = docs
        self.structs, self.enums, self.classes = calls["structs"], calls["enums"], calls["classes"]
        self.calls = calls["calls"]

    def one(self, type_):
        """The type of one value of a C type."""
        type_ = bare(type_)
        if type_ in NUMBERS:
            return "number"
        if type_ in self.enums:
            return " | ".join(f"'{word}'" for word in self.enums[type_])
        return "boolean" if type_ == "bool" else self.classes.get(type_) or pascal(type_)

    def many(self, type_):
        return "Float64Array" if bare(type_) == "double" else f"{self.one(type_)}[]"

    def struct(self, name):
        """An interface; options have their fields optional."""
        given = name.endswith("_options")
        lines = []
        for field in self.structs[name]["fields"]:
            type_, word = field["type"], camel(field["name"])
            if field["name"] == "size" or field["name"].endswith("_count") or word == "count":
                continue
            if type_.endswith("*"):
                type_ = "NumberList" if bare(type_) in NUMBERS and given else self.many(type_)
            elif field["room"]:
                type_ = "NumberList" if given else self.many(type_)
            else:
                type_ = self.one(type_)
            if said := self.docs[f"{name}.{field['name']}"]:
                lines.append(self.comment(said, "  "))
            lines.append(f"  {word}{'?' if given else ''}: {type_};")
        return "\n".join([self.comment(self.docs[name]), f"export interface {pascal(name)} {{", *lines, "}"])

    def argument(self, word, type_):
        """(name, type, optional) of what a caller gives, or None."""
        if found := re.match(r"\((\w+)\)", word):
            return found[1], {"regions": "Region[]", "spline": "Points | Spline"}.get(found[1], "Points | Stroke"), False
        if found := re.match(r"(\w+)\[(=?)(.*?)\](\??)$", word):
            vector = found[2] or "dim" not in found[3]
            return found[1], "NumberList" if vector else "Points", bool(found[4])
        if re.match(r"[@=#%{>]|dim$|null$", word):
            return None
        found = re.match(r"(\w+)(=?)", word)
        return found[1], self.one(type_), bool(found[2])

    def result(self, call):
        if call["returned"]:
            return self.many(call["returns"])
        if call["returns"] not in ("bat_status", "void") and not any(word.startswith("%") for word, _ in call["args"]):
            return self.one(call["returns"])
        results = [re.match(r">(\w+)(\*?)(?:\[(.*)\])?$", word).groups() + (type_,)
                   for word, type_ in call["args"] if word.startswith(">")]
        if any(word.startswith("{>") for word, _ in call["args"]):
            return next(self.one(type_) for word, type_ in call["args"] if word.startswith("{>"))
        used = {name for _, _, formula, _ in results if formula for name in re.findall(r"\w+", formula)}
        rooms = any(word.startswith("%") for word, _ in call["args"])
        results = [r for r in results if r[0] not in used and not (rooms and r[0] == "count")]
        shown = [(camel(name), self.many(type_) if formula else self.one(type_), handed)
                 for name, handed, formula, type_ in results]
        made = [one for one in shown if one[1] in self.classes.values() and not one[2]]
        rest = [one for one in shown if one not in made]
        if len(made) == 1 and not rest:
            return made[0][1]
        if len(made) == 1:
            fields = [f"{{ {name}: {type_} }}" for name, type_, _ in rest if name not in ("report", "info")]
            reports = [type_ for name, type_, _ in rest if name == "report"] + ["SketchReport & LiveInfo" for name, *_ in rest if name == "info"]
            return f"{made[0][1]} & {{ readonly report: Readonly<{' & '.join(reports + fields)}> }}"
        if made:
            return f"[{', '.join(type_ for _, type_, _ in made)}]"
        if not shown:
            return "this"
        if len(shown) == 1:
            return shown[0][1]
        return "{ " + "; ".join(f"{name}: {type_}" for name, type_, _ in shown) + " }"

    @staticmethod
    def comment(said, indent=""):
        """A text, a line a paragraph, as a comment."""
        lines = said.replace("*/", "* /").split("\n")
        if len(lines) == 1:
            return f"{indent}/** {said} */"
        return f"{indent}/**\n" + f"{indent} *\n".join(f"{indent} * {line}\n" for line in lines) + f"{indent} */"

    def note(self, call):
        """What the header says of a call, as a comment."""
        return self.comment(self.docs[call["c"]], "  ") + "\n"

    def member(self, call, called):
        kind, name = called.split(".")
        arguments = [found for word, type_ in call["args"] if (found := self.argument(word, type_))]
        given = [f"{camel(name)}: {type_}" for name, type_, optional in arguments if not optional]
        bags = [pascal(bare(type_)) for word, type_ in call["args"] if word.startswith("{")]
        bag = [f"{camel(name)}?: {type_}" for name, type_, optional in arguments if optional]
        if any(word == "dim" for word, _ in call["args"]) or any(word.startswith("(") for word, _ in call["args"]):
            bag.append("dimension?: number")
        if any(word == "(spline)" for word, _ in call["args"]):
            bags.append("Partial<Omit<Spline, 'points'>>")
        result = self.result(call)
        if sum(bool(re.match(r">\w+\[", word)) and bare(type_) == "double" for word, type_ in call["args"]) == 1:
            bag.append("into?: Numbers")
        parts = bags + ([f"{{ {'; '.join(bag)} }}"] if bag else [])
        plain = all(word[0] in "@>" for word, _ in call["args"])
        makes = any(type_ in result for type_ in self.classes.values()) or result == "this"
        note = self.note(call)
        if kind != "b" and plain and not makes and not name.endswith("()"):
            return f"{note}  readonly {name}: {result};"
        if parts:
            given.append(f"options?: {' & '.join(parts)}")
        return f"{note}  {name.replace('()', '')}({', '.join(given)}): {result};"

    def text(self, head):
        for call in self.calls:
            for called in call["names"]:
                kind = called.split(".")[0].replace("b", "Batten") if called.startswith("b.") else called.split(".")[0]
                mark = f"  // {kind}: the calls of C\n"
                if mark not in head:
                    sys.exit(f"types.py: no mark for {kind}")
                byhand = re.compile(rf"(class {kind} (?:(?!\n}}).)*?\n)(  {called.split('.')[1]}\()", re.S)
                if byhand.search(head):  # with a comment of its own, or this one
                    head = byhand.sub(lambda found: found[1] + ("" if found[1].endswith("*/\n") else self.note(call)) + found[2], head, count=1)
                    continue
                head = head.replace(mark, self.member(call, called) + "\n" + mark)
        structs = [name for name in self.structs if name not in
                   ("bat_stroke", "bat_spline", "bat_region", "bat_sketch_live_info", "bat_frame_arrays")]
        return re.sub(r"  // \w+: the calls of C\n", "", head) + "\n" + "\n\n".join(map(self.struct, structs)) + "\n"


if __name__ == "__main__":
    source, head, out = map(pathlib.Path, sys.argv[1:])
    docs = json.loads(source.with_name("docs.json").read_text("utf-8"))
    out.write_text(Types(json.loads(source.read_text()), docs).text(head.read_text("utf-8")), "utf-8")
