#!/usr/bin/env python3
"""Writes include/batten/batten.hpp from calls.txt and the public headers. Usage: cpp.py ROOT [OUT]"""
import pathlib
import re
import sys
import tempfile
import json

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import generate  # noqa: E402

CURVES = {"Curve": "dimension()", "Shape": "bat_curve_dimension(bat_shape_curve(get(), 0))", "Finder": "dimension_",
          "LiveShape": "bat_curve_dimension(bat_shape_curve(bat_shape_live_shape(get()), 0))"}  # how many coordinates an object has
LEVELS = {"Shape": "size(bat_curve_count(bat_shape_curve(get(), level)))",
          "Relief": "size(bat_surface_count(bat_relief_surface(get(), level), BAT_U)) * size(bat_surface_count(bat_relief_surface(get(), level), BAT_V))"}
TOTALS = {"Shape": "levels()", "Relief": "levels()", "Camera": "levels()", "LiveShape": "bat_shape_levels(bat_shape_live_shape(get()))"}
JOINTS = {"Take": "joints().size()", "Motion": "joints()"}
FINDER = "\n  public:\n    Finder(bat_finder *taken, int dimension) noexcept : Handle(taken), dimension_(dimension) {}\n\n  private:\n    int dimension_ = 2;\n"
MOTION = """
  private:
    [[nodiscard]] std::size_t joints() const {
        int count = 0;
        bat_take_joints(bat_motion_take(get()), &count);
        return static_cast<std::size_t>(count);
    }
"""
SURFACE = """
    // The control points, row by row.
    [[nodiscard]] std::vector<double> points() const {
        std::vector<double> out;
        for (std::size_t i = 0; i < count(BAT_U); i++) {
            const double *row = bat_surface_row(get(), static_cast<int>(i));
            out.insert(out.end(), row, row + 3 * count(BAT_V));
        }
        return out;
    }
"""
EXTRA = {"Finder": FINDER, "Motion": MOTION, "Surface": SURFACE}
TAIL = """inline bool operator==(const Curve &a, const Curve &b) { return a.is_equal(b); }
inline bool operator==(const Surface &a, const Surface &b) { return a.is_equal(b); }
inline bool operator==(const Mesh &a, const Mesh &b) { return a.is_equal(b); }

// What calls of regions take: each of these curves bounds one by itself. It looks at them.
class Regions {
  public:
    explicit Regions(const std::vector<Curve> &of) {
        for (const Curve &one : of) curves_.push_back(one.get());
        for (const bat_curve *&one : curves_) own_.push_back({1, &one, false});
    }
    [[nodiscard]] const bat_region *data() const noexcept { return own_.data(); }
    [[nodiscard]] std::size_t size() const noexcept { return own_.size(); }

  private:
    std::vector<const bat_curve *> curves_;
    std::vector<bat_region> own_;
};

// What calls take that write a model, of one surface or mesh. It looks at it.
class Model {
  public:
    explicit Model(Surface &of) : surface_(of.get()) { own_.surface_count = 1, own_.surfaces = &surface_; }
    explicit Model(Mesh &of) { own_.mesh = of.get(); }
    Model(const Model &) = delete;
    Model &operator=(const Model &) = delete;
    operator const bat_model &() const noexcept { return own_; }

  private:
    bat_surface *surface_ = nullptr;
    bat_model own_{};
};

// The headless editor; its other calls take get().
class Editor : public detail::Handle<bat_editor, bat_editor_free> {
  public:
    Editor() : Handle(make()) {}
    void open(Document drawing, const std::string &name = "") {
        detail::check(bat_editor_open(get(), drawing.release(), name.c_str()));
    }
    void command(const std::string &name) { detail::check(bat_editor_command(get(), name.c_str())); }
    void set(const std::string &property, double value) { detail::check(bat_editor_set(get(), property.c_str(), value)); }
    void pointer(Span<const bat_pointer> events) { bat_editor_pointer(get(), events.size(), events.data()); }
    [[nodiscard]] const bat_frame *frame() { return bat_editor_frame(get()); }

  private:
    static bat_editor *make() {
        bat_editor *out = nullptr;
        detail::check(bat_editor_create(&out));
        return out;
    }
};
"""


def snake(name):
    return re.sub(r"([A-Z]+)", lambda found: "_" + found[1].lower(), name)


def bare(type_):
    return re.sub(r"const\b|[ *]", "", type_)


class Function:
    """One name of a call: what it takes, what it does, what it gives."""

    def __init__(self, table, call, called):
        self.table, self.call = table, call
        self.kind, name = called.replace("()", "").split(".")
        self.name = snake(name).strip("_")
        self.free = self.kind == "b"
        self.words = call["args"]
        self.counted = {word[1:] for word, _ in self.words if word[0] == "#"}
        self.required, self.optional, self.before, self.after, self.passed = [], [], [], [], []
        self.results, self.told, self.room = [], None, any(word[0] == "%" for word, _ in self.words)
        self.constant = any(word.startswith("@") and type_.startswith("const") for word, type_ in self.words)
        self.ranged = []  # the numbers that have a range
        self.names = {}  # how a name of a formula is written
        for word, type_ in self.words:
            self.know(word, type_)
        if call["c"] == "bat_binding_apply":
            self.before.append('detail::exactly("points", points.size(), 3 * count());')
        for word, type_ in self.words:
            self.passed.append(self.place(word, type_))

    def is_class(self, type_):
        return bare(type_) in self.table["classes"]

    def size(self, expression):
        return f"static_cast<std::size_t>({expression})"

    def know(self, word, type_):
        if found := re.match(r"([a-z]\w*)!?(=|:|$)", word):
            self.names[found[1]] = f"size({found[1]})"
        if found := re.match(r">(\w+)$", word):
            self.names[found[1]] = f"size({found[1]}_)"

    def formula(self, text):
        """A formula of calls.txt in C++."""
        def one(found):
            name = found[0]
            if name.isdigit():
                return name
            if name == "dim":
                own = next((word[1:-1] + "." for word, type_ in self.words if bare(type_) in ("bat_spline", "bat_stroke")), "")
                return f"size({own + 'dimension' if self.free else CURVES[self.kind]})"
            if name[0] == "#":
                return self.count(name[1:])
            if name in self.names:
                return self.names[name]
            if name == "level_count":
                return LEVELS[self.kind]
            if name == "joint_count":
                return JOINTS[self.kind]
            direction = "direction" if "direction" in self.names and name in ("count", "degree", "knot_count") else ""
            return f"size({name}({direction}))"
        return re.sub(r"#?\w+", one, text)

    def count(self, name):
        word, type_ = next((w, t) for w, t in self.words if re.match(rf'[("]?{name}\b', w.removeprefix("&")))
        if word[0] == "(" and name not in self.counted:
            return f"{name}.count"
        if word[0] in '("' or self.is_class(type_):
            return f"{name}.size()"
        found = re.match(r"&?\w+!?\[(=?)(.*?)\]", word)
        each = self.formula(found[2])
        return f"{name}.size()" if found[1] or each == "1" else f"detail::many(\"{name}\", {name}.size(), {each})"

    def give(self, type_, name, default=None):
        (self.required if default is None else self.optional).append((f"{type_} {name}".replace("& ", "&").replace("* ", "*"), default))

    def scalar(self, found, type_):
        name, kept, missing, least = found.groups()
        if self.is_class(type_):
            kind = self.table["classes"][bare(type_)]
            constant = "const " if type_.startswith("const") or kept else ""
            self.give(f"{constant}{kind} &", name)
            return f"detail::copy_of<{kind}>({name}.get(), {bare(type_)}_copy)" if kept else f"{name}.get()"
        if missing in ("start", "end"):
            self.give("std::optional<double>", name, "{}")
            return f"{name}.value_or(domain()[{int(missing == 'end')}])"
        if missing is not None and bare(type_) in self.table["enums"]:
            missing = missing if missing.isdigit() else str(self.table["enums"][bare(type_)][missing])
            missing = f"static_cast<{bare(type_)}>({missing})"
        limits = generate.RULES["within"]
        low, high = limits.get(f"{self.kind}.{name}", limits.get(name, (None, None)))
        if least is not None:
            low, high = least, TOTALS[self.kind]
        if low is not None and type_ == "int":
            self.before.append(f'detail::inside("{name}", {name}, {low}, {high});')
        start, end, *above = generate.RULES["ranges"].get(f"{self.call['c']}.{name}", generate.RULES["ranges"].get(name, (-1e75, 1e75)))
        if bare(type_) in ("double", "int", "bat_id") and missing != "inf" and not isinstance(start, str) and not isinstance(end, str):
            self.ranged.append(f'{{"{name}", static_cast<double>({name}), {start}, {end}{", true" * bool(above)}}}')
        self.give(type_, name, {"inf": "std::numeric_limits<double>::infinity()"}.get(missing, missing))
        return name

    def place(self, word, type_):
        """How an argument of C is passed; what it needs before and after is noted."""
        one = bare(type_)
        if word[0] == "@":
            return "release()" if word == "@!" else "get()" if not self.free else "nullptr"
        if word == "dim":
            if self.free and ("int dimension", "2") not in self.optional:
                self.optional.append(("int dimension", "2"))
            return "dimension" if self.free else CURVES[self.kind]
        if word == "null":
            return "nullptr"
        if word[0] == "=":
            return f"static_cast<{type_}>({self.formula(word[1:])})"
        if word[0] == "#":
            return f"static_cast<{type_}>({self.count(word[1:])})" if type_ != "size_t" else self.count(word[1:])
        if word[0] == "%":
            return "room"
        if word[0] == "!":
            self.told = word[1:] + "_told"
            self.before.append(f"{'bat_problem' if one == 'bat_problem' else 'std::size_t'} {self.told}"
                               + ("{};" if one == "bat_problem" else " = std::numeric_limits<std::size_t>::max();"))
            return f"&{self.told}"
        if found := re.fullmatch(r'"(\w+)"(\??)', word):
            if found[1] in self.counted:
                self.give("std::string_view", found[1])
                return f"{found[1]}.data()"
            self.give("const std::string &", found[1], "{}" if found[2] else None)
            return f"{found[1]}.c_str()"
        if found := re.fullmatch(r"\((\w+)\)(\??)", word):
            if found[1] in self.counted:
                self.give(f"Span<const {one}>", found[1])
                return f"{found[1]}.data()"
            if found[2]:
                self.give(f"const {one} *", found[1], "nullptr")
                return found[1]
            self.give(f"const {one} &", found[1])
            return f"&{found[1]}"
        if found := re.fullmatch(r"\{(>?)(\w+)\}", word):
            if found[1]:
                self.before.append(f"{one} {found[2]}_ = {one.removesuffix('_options')}_defaults();")
                self.results.append((found[2], one, f"{found[2]}_"))
                return f"&{found[2]}_"
            name = "options" if not any(given.endswith("*options") for given, _ in self.optional) else one.removeprefix("bat_")
            self.give(f"const {one} *", name, "nullptr")
            return name
        if found := re.fullmatch(r">(\w+)(\*?)(?:\[(.*)\])?", word):
            return self.result(found[1], bool(found[2]), found[3], type_)
        if found := re.fullmatch(r"(&?)(\w+)(!?)\[(=?)(.*)\](\??)", word):
            return self.array(*found.groups(), type_)
        return self.scalar(re.fullmatch(r"(\w+)(!?)(?:=(.+)|:(\d))?", word), type_)

    def array(self, back, name, kept, whole, formula, optional, type_):
        one = bare(type_)
        if self.is_class(type_):
            kind = self.table["classes"][one]
            self.give(f"const List<{kind}> &", name, "{}" if optional else None)
            if whole:
                self.before.append(f'detail::exactly("{name}", {name}.size(), {self.formula(formula)});')
            if kept:
                self.before.append(f"const auto {name}_kept = {name}.kept({one}_copy);")
            return f"{name}_kept.data()" if kept else f"{name}.data()"
        self.give("Numbers" if one == "double" else f"Span<const {one}>", name, "{}" if optional else None)
        if whole:
            test = f"if (!{name}.empty()) " if optional else ""
            self.before.append(f'{test}detail::exactly("{name}", {name}.size(), {self.formula(formula)});')
        elif name not in self.counted and formula != "1":
            self.before.append(f'detail::many("{name}", {name}.size(), {self.formula(formula)});')
        if back:
            self.before.append(f"std::vector<{one}> {name}_({name}.begin(), {name}.end());")
            self.results.append((name, f"std::vector<{one}>", f"std::move({name}_)"))
            return f"{name}_.data()"
        return f"{name}.empty() ? nullptr : {name}.data()" if optional else f"{name}.data()"

    def result(self, name, handed, formula, type_):
        one, place = bare(type_), name + "_"
        if one == "char":
            self.before.append(f"char *{place} = nullptr;")
            self.results.append((name, "std::string", f"detail::taken_text({place}, size_)"))
            return f"&{place}"
        if handed:
            kind = self.table["classes"].get(one)
            self.before.append(f"{one} *{'*' * bool(kind)}{place} = nullptr;")
            many = self.formula(formula)
            self.results.append((name, f"std::vector<{kind or one}>", f"detail::taken_objects<{kind}>({place}, {many})" if kind else f"detail::taken({place}, {many})"))
            return f"&{place}"
        if kind := self.table["classes"].get(one):
            self.before.append(f"{one} *{place} = nullptr;")
            self.results.append((name, kind, f"Finder({place}, dimension())" if kind == "Finder" else f"{kind}({place})"))
            return f"&{place}"
        if formula is None:
            self.before.append(f"{one} {place}{{}};")
            end = next((one + end for end in ("_free", "_clear") if one + end in self.table["headers"]), None)
            if end:
                self.results.append((name, f"detail::Owned<{one}, {end}>", f"detail::Owned<{one}, {end}>({place})"))
            else:
                self.results.append((name, one, place))
            return f"&{place}"
        if self.room and re.search(r"\broom\b", formula):
            self.after.append((place, one, formula))
            self.results.append((name, f"std::vector<{one}>", f"std::move({place})"))
            return f"{place}.data()"
        if re.fullmatch(r"\d+", formula):
            self.before.append(f"std::array<{one}, {formula}> {place}{{}};")
            self.results.append((name, f"std::array<{one}, {formula}>", place))
        else:
            self.before.append(f"std::vector<{one}> {place}({self.formula(formula)});")
            self.results.append((name, f"std::vector<{one}>", f"std::move({place})"))
        return f"{place}.data()"

    def finish(self):
        """(type, declaration, definition, struct or None)."""
        returns, returned = self.call["returns"], self.call["returned"]
        used = {name for word, _ in self.words if word[0] == ">" for name in re.findall(r"\w+", (re.search(r"\[(.*)\]", word) or [0, ""])[1])}
        used |= set(re.findall(r"\w+", returned or "")) | ({"count"} if self.room else set())
        shown = [one for one in self.results if one[0] not in used]
        call = f"{self.call['c']}({', '.join(self.passed)})"
        if guard := generate.RULES["checked"].get(self.call["c"]):
            self.before += ["bat_problem refused{};", f"detail::check({guard}({self.passed[0]}, &refused), refused);"]
        struct, lines = None, list(self.before)
        status = returns == "bat_status"
        checking = f"detail::check(status{', ' + self.told if self.told else ''});"
        if self.ranged and not self.told:
            checking = f"detail::check(status, {{{', '.join(self.ranged)}}});"
        given = [passed for passed, (word, _) in zip(self.passed, self.words) if word[0] not in ">!"]
        structs = [(explains, passed) for passed, (word, type_) in zip(self.passed, self.words)
                   if word[0] == "(" and word[1:-1] not in self.counted and not self.told and (explains := generate.RULES["explained_struct"].get(bare(type_)))]
        if explained := generate.RULES["explained"].get(self.call["c"]):
            structs.insert(0, (explained, ", ".join(given)))
        if structs and status and not self.room:
            lines.append("bat_problem problem{};")
            there = {passed: f" && {passed} != nullptr" for _, passed in structs if re.fullmatch(r"\w+", passed)}
            checking = "".join(f"if (status != BAT_OK{there.get(passed, '')}) detail::check({explains}({passed}, &problem), problem);\n    " for explains, passed in structs) + checking
        if self.room:
            counted = any(word == ">count" for word, _ in self.words)
            type_of = next(t for w, t in self.words if w[0] == "%")
            lines += [f"std::vector<{one}> {place};" for place, one, _ in self.after] + [f"{type_of} room = 0;"]
            lines += [f"detail::check({call});" if status else f"{'' if counted else 'room = '}{call};"] + (["room = count_;"] if counted else [])
            lines += [f"{place}.resize({formula.replace('room', 'size(room)')});" for place, _, formula in self.after]
            lines += [f"detail::check({call});" if status else f"{call};"]
        elif status:
            lines.append(f"const bat_status status = {call};")
        elif returns != "void":
            return self.plain(call, lines, shown, returns, returned)
        else:
            lines.append(f"{call};")
        makes = [one for one in shown if one[1] in self.table["classes"].values() or one[1].startswith("std::vector<") and one[1][12:-1] in self.table["classes"].values()]
        if not shown:
            return "void", lines + [checking] * (status and not self.room), struct
        if len(shown) == 1:
            name, type_, value = shown[0]
            if status and not self.room:
                if makes or "taken" in value:
                    return type_, [*lines, f"{type_} made = {value};" if "{" not in value else value, checking, "return made;"], struct
                lines.append(checking)
            return type_, [*lines, f"return {value.removeprefix('std::move(').removesuffix(')') if value.startswith('std::move(') else value};"], struct
        title = "".join(part.title() for part in ["" if self.free else self.kind, *self.name.split("_")]) + "Result"
        if status and not self.room:
            there = " || ".join(f"{one[0]}_ != nullptr" for one in makes) or "false"
            best = makes and "BAT_TOLERANCE" in self.table["docs"][self.call["c"]]
            members = [*shown, ("within", "bool", "status == BAT_OK")] if best else shown
            struct = (title, [(type_, name) for name, type_, _ in members])
            lines.append(f"{title} made{{{', '.join(value for _, _, value in members)}}};")
            lines.append(f"if (status != BAT_OK && !(status == BAT_TOLERANCE && ({there}))) {checking}" if best else checking)
            lines.append("return made;")
        else:
            struct = (title, [(type_, name) for name, type_, _ in shown])
            lines.append(f"return {{{', '.join(value for _, _, value in shown)}}};")
        return title, lines, struct

    def plain(self, call, lines, shown, returns, returned):
        one = bare(returns)
        if returned:
            lines += [f"const {one} *found = {call};", f"return Span<const {one}>(found, found == nullptr ? 0 : {self.formula(returned)});"]
            return f"Span<const {one}>", lines, None
        if one in self.table["classes"]:
            kind = self.table["classes"][one]
            made = f"{one}_retain(const_cast<{one} *>(found))" if one in generate.SHARED else f"detail::copy_of<{kind}>(found, {one}_copy)"
            lines += [f"const {one} *found = {call};", "if (found == nullptr) return std::nullopt;"]
            lines += [f"{made};", f"return {kind}(const_cast<{one} *>(found));"] if one in generate.SHARED else [f"return {kind}({made});"]
            return f"std::optional<{kind}>", lines, None
        return returns, [*lines, f"return {call};"], None


def text(root):
    with tempfile.TemporaryDirectory() as folder:
        old, sys.argv = sys.argv, ["generate.py", str(root), folder]
        generate.main()
        sys.argv = old
        table = json.loads((pathlib.Path(folder) / "calls.json").read_text())
    headers = generate.Headers(root)
    table["headers"], table["docs"] = headers.calls, headers.docs
    declared, free, defined, structs = {kind: [] for kind in table["classes"].values()}, [], [], []
    for call in table["calls"]:
        for called in call["names"]:
            function = Function(table, call, called)
            type_, lines, struct = function.finish()
            structs += [struct] if struct else []
            given = function.required + sorted(function.optional, key=lambda one: not one[0].endswith("*options"))
            plain = ", ".join(one for one, _ in given)
            defaults = ", ".join(one + (f" = {default}" if default is not None else "") for one, default in given)
            constant = " const" * function.constant
            nodiscard = "[[nodiscard]] " * (type_ != "void")
            gap = "" if type_.endswith("*") else " "
            body = "\n".join(f"    {line}" for line in lines)
            body = re.sub(r"\bsize\((?=[^)])", "static_cast<std::size_t>(", body)
            body = re.sub(r"(?<!\.)\bsize\(\)", "size()", body)
            if function.free:
                free.append(f"{nodiscard}inline {type_}{gap}{function.name}({defaults}) {{\n{body}\n}}")
            else:
                declared[function.kind].append(f"    {nodiscard}{type_}{gap}{function.name}({defaults}){constant};")
                defined.append(f"inline {type_}{gap}{function.kind}::{function.name}({plain}){constant} {{\n{body}\n}}")
    out = [(root / "bindings/cpp_head.txt").read_text().rstrip()]
    out.append("".join(f"class {kind};\n" for kind in table["classes"].values()) + "".join(f"struct {name};\n" for name, _ in structs).rstrip())
    for c, kind in table["classes"].items():
        out.append(f"class {kind} : public detail::Handle<{c}, {table['frees'][kind]}> {{\n  public:\n    using Handle::Handle;\n" + "\n".join(declared[kind]) + f"\n{EXTRA.get(kind, '')}}};")
    out += [f"struct {name} {{\n" + "\n".join(f"    {type_} {member};" for type_, member in members) + "\n};" for name, members in structs]
    out += defined + free + [TAIL.rstrip()]
    return "\n\n".join(out) + "\n\n} // namespace bat\n\n#endif\n"


if __name__ == "__main__":
    made = text(pathlib.Path(sys.argv[1]))
    (pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(sys.argv[1]) / "include/batten/batten.hpp").write_text(made)
