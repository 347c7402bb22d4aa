#!/usr/bin/env python3
"""Writes index.d.ts of batten-core from calls.json and docs.json beside it: types.py CALLS.json HEAD.d.ts OUT.d.ts. In HEAD stands what is written by
hand; members of a class there go before those that are made here."""
import json
import pathlib
import re
import sys

NUMBERS = ("double", "int", "size_t", "uint32_t", "bat_id")
ARRAYS = {"double": "Float64Array", "int": "Int32Array", "size_t": "Uint32Array"}
FLAT = {"bat_stroke": "Points | Stroke", "bat_spline": "Points | Spline"}
# What stands for a struct, beside an object of its members.
ALONE = {"bat_function": " | Curve | number", "bat_model": " | Solid | Solid[]", "bat_line_scene": " | Solid | Solid[]", "bat_width_profile": " | WidthStopGiven[]",
         "bat_width_stop": " | number[]", "bat_stop": " | number[]"}


def camel(name):
    return re.sub(r"_(\w)", lambda found: found[1].upper(), name)


def bare(type_):
    return re.sub(r"const|[ *]", "", type_)


class Types:
    def __init__(self, calls, docs):
        self.docs, self.given = docs, {}
        self.structs, self.enums, self.classes = calls["structs"], calls["enums"], calls["classes"]
        self.calls = calls["calls"]

    def title(self, name):
        return self.structs[name]["title"]

    def one(self, type_):
        """The type of one value of a C type."""
        type_ = bare(type_)
        if type_ in NUMBERS:
            return "number"
        if type_ in self.enums:
            return " | ".join(f"'{word}'" for word in self.enums[type_])
        known = {"bool": "boolean", "char": "string", "uint64_t": "bigint"}
        return known.get(type_) or self.classes.get(type_) or self.title(type_)

    def many(self, type_):
        one = self.one(type_)
        return ARRAYS.get(bare(type_)) or (f"({one})[]" if " | " in one else f"{one}[]")

    def giving(self, type_):
        """The type of a struct that is given."""
        type_ = bare(type_)
        if type_ == "bat_region":
            return "Region"
        if type_ not in self.given:
            self.given[type_] = ""
            self.given[type_] = self.struct(type_, True)
        return self.title(type_) + "Given" + ALONE.get(type_, "")

    def listing(self, type_):
        one = self.giving(type_)
        return f"readonly ({one})[]" if " | " in one else f"readonly {one}[]"

    def argued(self, field):
        """The type of a member that is given."""
        type_, one = field["type"], bare(field["type"])
        if one in self.classes:
            return f"readonly {self.one(one)}[]" if type_.count("*") > 1 else self.one(one)
        if one in self.structs:
            return self.listing(one) if "counted" in field else self.giving(one)
        if field["room"] and one in self.enums:
            return f"readonly ({self.one(one)})[]"
        if one == "char":
            return "string"
        return ("NumberList" if one != "bool" else "readonly boolean[]") if field["room"] or "*" in type_ else self.one(type_)

    def resulting(self, field):
        """The type of a member of a result; None: it is not there."""
        type_, one = field["type"], bare(field["type"])
        if type_.endswith("*"):
            if one == "char":
                return "string | null"
            if "counted" in field:
                return self.many(type_)
            return f"{self.one(type_)} | null" if type_.count("*") == 1 and (one in self.classes or one in self.structs) else None
        return "string" if one == "char" else self.many(type_) if field["room"] else self.one(type_)

    def struct(self, name, given=False):
        """An interface; what is given, and options, have their members optional."""
        options = name.endswith("_options")
        lines = []
        for field in self.structs[name]["fields"]:
            type_ = self.argued(field) if given or options else self.resulting(field)
            if field["name"] == "size" or field["counts"] or type_ is None:
                continue
            if said := self.docs[f"{name}.{field['name']}"]:
                lines.append(self.comment(said, "  "))
            lines.append(f"  {camel(field['name'])}{'?' if given or options else ''}: {type_}{' | null' if given and 'null' not in type_ else ''};")
        return "\n".join([self.comment(self.docs[name]), f"export interface {self.title(name)}{'Given' * given} {{", *lines, "}"])

    def argument(self, word, type_, counted):
        """(name, type, optional) of what a caller gives, or None."""
        word = word.removeprefix("&")
        if found := re.match(r"\((\w+)\)(\??)", word):
            type_ = FLAT.get(bare(type_)) or (self.listing(type_) if found[1] in counted else self.giving(type_))
            return found[1], type_, bool(found[2])
        if found := re.match(r'"(\w+)"(\??)', word):
            return found[1], "string | Uint8Array", bool(found[2])
        if found := re.match(r"(\w+)!?\[(=?)(.*?)\](\??)$", word):
            if bare(type_) in self.classes:
                return found[1], f"readonly {self.one(type_)}[]", bool(found[4])
            plain = bare(type_) in ("double", "int", "size_t") and (found[2] or found[3] == "1")
            return found[1], "NumberList" if plain else "readonly boolean[]" if bare(type_) == "bool" else "Points", bool(found[4])
        if re.match(r"[@=#%{>!]|dim$|null$", word):
            return None
        found = re.match(r"(\w+)!?(=?)", word)
        return found[1], "number | bigint" if bare(type_) == "uint64_t" else self.one(type_), bool(found[2])

    def result(self, call):
        rooms = any(word.startswith("%") for word, _ in call["args"])
        nothing = " | null" if "*" in call["returns"] and "NULL" in self.docs[call["c"]] and not any(":" in word for word, _ in call["args"]) else ""
        if call["returned"]:
            return self.many(call["returns"]) + nothing
        if call["returns"] not in ("bat_status", "void") and not rooms:
            return self.one(call["returns"]) + nothing
        if any(word.startswith("{>") for word, _ in call["args"]):
            return next(self.one(type_) for word, type_ in call["args"] if word.startswith("{>"))
        results = [re.match(r">(\w+)(\*?)(?:\[(.*)\])?$", word).groups() + (type_,) for word, type_ in call["args"] if word.startswith(">")]
        back = [(word[1:].split("[")[0], "", "1", type_) for word, type_ in call["args"] if word.startswith("&")]
        used = {name for _, _, formula, _ in results if formula for name in re.findall(r"\w+", formula)}
        results = back + [r for r in results if r[0] not in used and not (rooms and r[0] == "count")]
        shown = [(camel(name), {"text": "string", "bytes": "Uint8Array"}[name] if bare(type_) == "char" else self.many(type_) if formula else self.one(type_), handed)
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
        counted = {word[1:] for word, _ in call["args"] if word[0] == "#"}
        arguments = [found for word, type_ in call["args"] if (found := self.argument(word, type_, counted))]
        given = [f"{camel(name)}{'_' * (name == 'function')}: {type_}" for name, type_, optional in arguments if not optional]
        bags = [self.title(bare(type_)) for word, type_ in call["args"] if word.startswith("{")]
        bag = [f"{camel(name)}?: {type_}" for name, type_, optional in arguments if optional]
        flat = [bare(type_) for word, type_ in call["args"] if word.startswith("(") and bare(type_) in FLAT]
        if any(word == "dim" for word, _ in call["args"]) or flat:
            bag.append("dimension?: number")
        if "bat_spline" in flat:
            bags.append("Partial<Omit<Spline, 'points'>>")
        if "bat_stroke" in flat:
            bags.append("Partial<Omit<Stroke, 'points'>>")
        result = self.result(call)
        made = any(word[0] == ">" and bare(type_) in self.classes for word, type_ in call["args"])
        if not made and sum(bool(re.match(r">\w+\[", word)) and bare(type_) == "double" for word, type_ in call["args"]) == 1:
            bag.append("into?: Numbers")
        parts = bags + ([f"{{ {'; '.join(bag)} }}"] if bag else [])
        plain = all(word[0] in "@>" for word, _ in call["args"])
        makes = made or bare(call["returns"]) in self.classes or result == "this"
        note = self.note(call)
        if kind != "b" and plain and not makes and not name.endswith("()"):
            return f"{note}  readonly {name}: {result};"
        if parts:
            given.append(f"options?: {' & '.join(parts)}")
        return f"{note}  {name.replace('()', '')}({', '.join(given)}): {result};"

    def text(self, head):
        for call in self.calls:
            for called in call["names"]:
                if "._" in called:  # for what is written by hand, in HEAD
                    [self.argument(word, type_, {word[1:] for word, _ in call["args"]}) for word, type_ in call["args"]]
                    continue
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
                   ("bat_stroke", "bat_spline", "bat_region", "bat_sketch_live_info", "bat_frame_arrays", "bat_problem")]
        interfaces = [*map(self.struct, structs)]
        return re.sub(r"  // \w+: the calls of C\n", "", head) + "\n" + "\n\n".join([*interfaces, *self.given.values()]) + "\n"


if __name__ == "__main__":
    source, head, out = map(pathlib.Path, sys.argv[1:])
    docs = json.loads(source.with_name("docs.json").read_text("utf-8"))
    out.write_text(Types(json.loads(source.read_text()), docs).text(head.read_text("utf-8")), "utf-8")
