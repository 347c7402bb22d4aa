"""Runs labelled gestures through the engine and tells which outcomes match the designer's intention."""
import concurrent.futures
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import stroke as hands

HOVER, DOWN, MOVE, UP, CANCEL = 0, 1, 2, 3, 4
PEN, TOUCH = 1, 2
BATCH = 8  # samples per frame


# ---- gestures to events ----

def zoom_of(g):
    return g["view"]["zoom"]


def to_view(g, p):
    v = g["view"]
    return [(p[0] - v["centre"][0]) * v["zoom"] + v["size"][0] / 2, (p[1] - v["centre"][1]) * v["zoom"] + v["size"][1] / 2]


def strokes_of(g):
    return g["strokes"] if "strokes" in g else [g["stroke"]]


def clean(g, s):
    """The intended path, document units, points about half a pixel apart."""
    return hands.path(s["path"], s.get("kind", "smooth"), 0.5 / zoom_of(g))


def samples(g, s):
    return hands.hand([to_view(g, p) for p in clean(g, s)], s["seed"], **s.get("hand", {}))


def events(g):
    """Lines for the host. Palms: contacts {"from", "to": ms after the (first) pen-down, "at": [x, y] view pixels, "drift"}."""
    lines, now = [], 2000.0
    palms = sorted(g.get("palms", []), key=lambda q: q["from"])
    first_down = now + 400
    touch = []  # (time, line)
    for i, palm in enumerate(palms):
        r = hands.Random(900 + i)
        t, end = first_down + palm["from"], first_down + palm["to"]
        x, y = palm["at"]
        touch.append((t, f"p {DOWN} {TOUCH} {20 + i} 1 0 {x:.2f} {y:.2f} 0.5 {t:.3f}"))
        while t + 16 < end:
            t += 16
            x += r.n() * palm.get("drift", 0.3)
            y += r.n() * palm.get("drift", 0.3)
            touch.append((t, f"p {MOVE} {TOUCH} {20 + i} 1 0 {x:.2f} {y:.2f} 0.5 {t:.3f}"))
        last = CANCEL if palm.get("ends") == "cancel" else UP
        touch.append((end, f"p {last} {TOUCH} {20 + i} 0 0 {x:.2f} {y:.2f} 0 {end:.3f}"))
    touch.sort()

    def palm_until(time):
        while touch and touch[0][0] <= time:
            lines.append(touch.pop(0)[1])

    modifiers = g.get("modifiers", 0)
    at = first_down
    for s in strokes_of(g):
        got = samples(g, s)
        device = {"pen": 1, "mouse": 0, "touch": 2}[s.get("device", "pen")]
        x, y = got[0][:2]
        if device != 2:
            for k in range(6):  # the pen approaches, hovering
                t = at - 120 + 16 * k
                palm_until(t)
                lines.append(f"p {HOVER} {device} 7 0 {modifiers} {x + 3 * (6 - k):.2f} {y - 4 * (6 - k):.2f} 0 {t:.3f}")
                lines.append("frame")
        palm_until(at)
        lines += ["frame", "mark", f"p {DOWN} {device} 7 1 {modifiers} {x:.2f} {y:.2f} {got[0][3]:.3f} {at:.3f}", "frame"]
        for i, (x, y, t, force) in enumerate(got[1:]):
            palm_until(at + 1000 * t)
            lines.append(f"p {MOVE} {device} 7 1 {modifiers} {x:.2f} {y:.2f} {force:.3f} {at + 1000 * t:.3f}")
            if i % BATCH == BATCH - 1:
                lines.append("frame")
        end = at + 1000 * got[-1][2] + 4
        lines += ["frame", f"p {UP} {device} 7 0 {modifiers} {got[-1][0]:.2f} {got[-1][1]:.2f} 0 {end:.3f}", "frame"]
        at = end + s.get("rest", 350)
    palm_until(1e18)
    lines.append("frame")
    return lines


def script(g, folder):
    v = g["view"]
    lines = ["open " + os.path.join(folder, "drawings", g["drawing"]), "size %g %g %g" % (*v["size"], v.get("ratio", 1))]
    lines += list(g.get("prepare", []))
    lines += ["view %.9g %.9g %.9g" % (v["zoom"], *v["centre"]), "frame", "before"]
    lines += events(g) + list(g.get("then", [])) + ["report"]
    return "\n".join(lines) + "\n"


def ask(host, text):
    try:
        p = subprocess.run([host], input=text, capture_output=True, text=True, timeout=30)
    except subprocess.TimeoutExpired:
        return {"fault": "took over 30 s"}
    try:
        return json.loads(p.stdout)
    except ValueError:
        return {"fault": f"the host ended with {p.returncode}: {p.stderr[-200:]}"}


def play(host, g, folder):
    return ask(host, script(g, folder))


# ---- geometry ----

class Places:
    """A polyline (closed: back to its start) that gives its distance from a point; boxes make this fast."""
    CHUNK = 16

    def __init__(self, points, closed=False):
        self.points = [tuple(p) for p in points] + ([tuple(points[0])] if closed else [])
        self.closed = closed
        self.boxes = []
        for i in range(0, max(1, len(self.points) - 1), self.CHUNK):
            part = self.points[i:i + self.CHUNK + 1]
            xs, ys = [p[0] for p in part], [p[1] for p in part]
            self.boxes.append((min(xs), min(ys), max(xs), max(ys), part))

    def distance(self, p):
        x, y = p
        order = []
        for b in self.boxes:
            dx, dy = max(b[0] - x, 0, x - b[2]), max(b[1] - y, 0, y - b[3])
            order.append((dx * dx + dy * dy, b[4]))
        order.sort(key=lambda o: o[0])
        best = math.inf
        for near, part in order:
            if near >= best:
                break
            if len(part) == 1:
                best = min(best, (part[0][0] - x) ** 2 + (part[0][1] - y) ** 2)
            for (ax, ay), (bx, by) in zip(part, part[1:]):
                vx, vy = bx - ax, by - ay
                l = vx * vx + vy * vy
                t = 0 if l == 0 else max(0, min(1, ((x - ax) * vx + (y - ay) * vy) / l))
                d = (ax + t * vx - x) ** 2 + (ay + t * vy - y) ** 2
                if d < best:
                    best = d
        return math.sqrt(best)

    def length(self):
        return sum(math.dist(p, q) for p, q in zip(self.points, self.points[1:]))

    def ends(self):
        return self.points[0], self.points[-1]


def nearest(many, p):
    return min((m.distance(p) for m in many), default=math.inf)


def thin(points, most):
    step = max(1, len(points) // most)
    return points[::step]


def within(points, low, high):
    return points[int(len(points) * low):max(int(len(points) * low) + 1, math.ceil(len(points) * high))]


class Result:
    """The resulting document. Curves are named "object" or "object:index"."""

    def __init__(self, g, raw):
        self.g, self.raw = g, raw
        self.before, self.after, self.closed_before, self.closed_after, self.owner = {}, {}, {}, {}, {}
        names = {o["id"]: o["name"] or f"#{o['id']}" for o in raw["before"]}
        changed = set(raw["changed"]) | set(raw["removed"])
        for o in raw["before"]:
            self.take(o, names[o["id"]], self.before, self.closed_before)
        for o in raw["before"]:
            if o["id"] not in changed:
                self.take(o, names[o["id"]], self.after, self.closed_after)
        for o in raw["after"]:
            self.take(o, names.get(o["id"], f"+{o['id']}"), self.after, self.closed_after)
        self.added = sorted(k for k in self.after if k.startswith("+"))
        self.changed, self.removed = set(), set()
        for i in changed:
            name = names[i]
            old = [k for k in self.before if k.split(":")[0] == name]
            for k in old:
                if k not in self.after:
                    self.removed.add(k)
                elif self.after[k].points != self.before[k].points and not self.alike(k):
                    self.changed.add(k)
            self.added += [k for k in self.after if k.split(":")[0] == name and k not in self.before]
        # The same shapes in another order are not a change.
        self.changed, self.removed = self.changed, self.removed

    def alike(self, k):
        a, b = self.before[k], self.after[k]
        if self.closed_before[k] != self.closed_after[k]:
            return False
        limit = 0.02 / zoom_of(self.g)
        return (all(a.distance(p) <= limit for p in thin(b.points, 80)) and
                all(b.distance(p) <= limit for p in thin(a.points, 80)))

    @staticmethod
    def take(o, name, places, closed):
        for i, c in enumerate(o["curves"]):
            key = name if i == 0 else f"{name}:{i}"
            places[key] = Places(c["places"], c["closed"])
            closed[key] = c["closed"]

    def curve_count(self):
        return len(self.after) - len(self.before)

    def words(self):
        w = []
        if self.changed:
            w.append("changed " + ",".join(sorted(self.changed)))
        if self.added:
            w.append(f"{len(self.added)} new")
        if self.removed:
            w.append("gone " + ",".join(sorted(self.removed)))
        if self.raw["pending"]:
            w.append("asks")
        return "; ".join(w) or "nothing"


# ---- expectations ----

def passes(r, curves, s, limit, core):
    """The distance, in pixels, of the intended path from the curves; its first and last parts may blend."""
    path = clean(r.g, s)
    worst = max(nearest(curves, p) for p in thin(within(path, *core), 160)) * zoom_of(r.g)
    return None if worst <= limit else f"{worst:.1f} px from the path, {limit:.1f} allowed"


def still(r, old, new, limit, away, what):
    """Whether old parts farther than `away` px from the strokes moved by at most limit px, and nothing new is there."""
    z = zoom_of(r.g)
    paths = [Places(thin(clean(r.g, s), 400)) for s in strokes_of(r.g)]
    for a, b, word in ((old, new, "moved"), (new, old, "strays")):
        worst = 0.0
        for line in a:
            for p in thin(line.points, 240):
                if nearest(paths, p) * z > away:
                    worst = max(worst, nearest(b, p) * z)
        if worst > limit:
            return f"{what} {word} {worst:.1f} px beyond {away:.0f} px from the stroke"
    return None


def touching(r, pairs):
    for a, b, limit in pairs:
        if a not in r.after or b not in r.after:
            return f"{a} or {b} is gone"
        d = min(min(r.after[b].distance(p) for p in r.after[a].ends()), min(r.after[a].distance(p) for p in r.after[b].ends())) * zoom_of(r.g)
        if d > limit:
            return f"{a} no longer meets {b} ({d:.1f} px)"
    return None


def span(r, names):
    """The path's distance from the old curves: transitions are a few times as long."""
    old = [r.before[n] for n in names]
    return max(nearest(old, p) for s in strokes_of(r.g) for p in thin(within(clean(r.g, s), 0.05, 0.95), 40)) * zoom_of(r.g)


def away_of(r, e, names):
    return e["away"] if "away" in e else 60 + 3 * min(80, span(r, names))


def alone(r, names, added, removed=()):
    if r.raw["pending"]:
        return "waits for a yes"
    other = (r.changed | r.removed) - set(names)
    if other:
        return "changes " + ",".join(sorted(other))
    if len(r.added) != added:
        return f"{len(r.added)} new curves, not {added}"
    gone = r.removed - set(removed)
    if gone:
        return "loses " + ",".join(sorted(gone))
    return None


def near_enough(r, s):
    """The tolerance in pixels; smaller for short strokes, which otherwise could not fail."""
    return min(6, max(1.6, 0.05 * hands.lengths(clean(r.g, s))[-1] * zoom_of(r.g)))


def redraws(r, e):
    names = e["redraws"]
    why = alone(r, names, 0)
    if why:
        return why
    missing = set(names) - r.changed
    if missing:
        return "does not change " + ",".join(sorted(missing))
    for n in names:
        if r.closed_before[n] != r.closed_after[n]:
            return f"{n} is {'closed' if r.closed_after[n] else 'opened'}"
    new, old = [r.after[n] for n in names], [r.before[n] for n in names]
    for s in strokes_of(r.g)[-1:] if e.get("last") else strokes_of(r.g):
        why = passes(r, new, s, e.get("passes", near_enough(r, s)), e.get("core", [0.08, 0.92]))
        if why:
            return why
    if e.get("still", 1.5) is not None:
        why = still(r, old, new, e.get("still", 1.5), away_of(r, e, names), ",".join(names))
        if why:
            return why
    return touching(r, e.get("touch", []))


def new(r, e):
    count = e.get("count", len(strokes_of(r.g)))
    why = alone(r, [], count)
    if why:
        return why
    z = zoom_of(r.g)
    lines = [r.after[k] for k in r.added]
    for s in strokes_of(r.g):
        path = clean(r.g, s)
        core = thin(within(path, *e.get("core", [0.03, 0.97])), 120)
        best, said = math.inf, ""
        for line in lines:
            there = [line.distance(p) * z for p in core]
            own = Places(thin(path, 400))
            back = [own.distance(p) * z for p in thin(line.points, 120)]
            rms = max(math.sqrt(sum(d * d for d in x) / len(x)) for x in (there, back))
            most = max(max(there), max(back))
            over = max(rms / e.get("rms", 2.5), most / e.get("most", 8))
            if over < best:
                best, said = over, f"new curve {rms:.1f} px rms, {most:.1f} px at most from the path"
        if best > 1:
            return said
    if "closed" in e:
        for k in r.added:
            if r.closed_after[k] != e["closed"]:
                return "new curve is " + ("closed" if r.closed_after[k] else "open")
    for end, name, limit in e.get("touch", []):
        path = clean(r.g, strokes_of(r.g)[0])
        p = path[0] if end == "start" else path[-1]
        ends = [q for line in lines for q in line.ends()]
        q = min(ends, key=lambda q: math.dist(p, q))
        d = r.after[name].distance(q) * z
        if d > limit:
            return f"new curve's {end} is {d:.1f} px off {name}"
    return None


def joins(r, e):
    names = e["joins"]
    if r.raw["pending"]:
        return "waits for a yes"
    other = (r.changed | r.removed) - set(names)
    if other:
        return "changes " + ",".join(sorted(other))
    if not set(names) <= r.changed | r.removed or r.curve_count() != -1:
        return "does not join " + ",".join(names)
    lines = [r.after[k] for k in list(r.changed) + r.added if k in r.after]
    if len(lines) != 1:
        return f"{len(lines)} curves, not one"
    why = passes(r, lines, strokes_of(r.g)[0], e.get("passes", 6), e.get("core", [0.08, 0.92]))
    old = [r.before[n] for n in names]
    return why or still(r, old, lines, e.get("still", 1.5), e.get("away", 120), ",".join(names))


def closes(r, e):
    name = e["closes"]
    why = alone(r, [name], 0)
    if why:
        return why
    if name not in r.changed:
        return f"does not change {name}"
    line = r.after[name]
    if not r.closed_after[name] and math.dist(*line.ends()) * zoom_of(r.g) > 0.5:
        return f"{name} is not closed"
    why = passes(r, [line], strokes_of(r.g)[0], e.get("passes", 6), e.get("core", [0.08, 0.92]))
    return why or still(r, [r.before[name]], [line], e.get("still", 1.5), e.get("away", 120), name)


def extends(r, e):
    name = e["extends"]
    why = alone(r, [name], 0)
    if why:
        return why
    if name not in r.changed:
        return f"does not change {name}"
    line = r.after[name]
    if r.closed_after[name]:
        return f"{name} is closed"
    s = strokes_of(r.g)[0]
    path = clean(r.g, s)
    tip = min((path[0], path[-1]), key=lambda p: -r.before[name].distance(p))
    off = min(math.dist(tip, q) for q in line.ends()) * zoom_of(r.g)
    if off > e.get("end", 9):
        return f"{name} ends {off:.1f} px from the stroke's end"
    why = passes(r, [line], s, e.get("passes", 6), e.get("core", [0.08, 0.97]))
    return why or still(r, [r.before[name]], [line], e.get("still", 1.5), e.get("away", 120), name) or touching(r, e.get("touch", []))


def nothing(r, e):
    return None if r.words() == "nothing" else r.words()


KINDS = {"redraws": redraws, "new": new, "joins": joins, "closes": closes, "extends": extends, "nothing": nothing}


def judge(g, raw):
    """(passes, why not, what happened)"""
    if "fault" in raw:
        return False, raw["fault"], "fault"
    if raw["refused"]:
        return False, "refused: " + raw["refused"][0], "fault"
    if raw["check"]:
        return False, "invariant: " + raw["check"], "fault"
    r = Result(g, raw)
    reasons = []
    for e in g["expect"]:
        kind = next(k for k in KINDS if k in e)
        why = KINDS[kind](r, e)
        if why is None:
            return True, "", r.words()
        reasons.append((kind, why))
    # The most relevant reason: that of the outcome of the expected kind, else of the first.
    got = "new" if r.added and not r.changed else "redraws"
    for kind, why in reasons:
        if kind == got:
            return False, f"{kind}: {why}", r.words()
    return False, "%s: %s" % reasons[0], r.words()


def read(folder):
    with open(os.path.join(folder, "gestures.json")) as f:
        return json.load(f)["gestures"]


def score(host, folder, only=None, keep=False):
    """Rows of (gesture, whether it passes, why not, what happened, the host's output). folder: contains gestures.json
    and the drawings."""
    gestures = [g for g in read(folder) if not only or only in g["id"] or only in g["category"]]
    rows = []
    with concurrent.futures.ProcessPoolExecutor(max_workers=max(2, os.cpu_count() or 2)) as pool:
        for g, row in zip(gestures, pool.map(one, [(host, g, folder, keep) for g in gestures], chunksize=2)):
            rows.append((g, *row))
    return rows


def one(work):
    host, g, folder, keep = work
    raw = play(host, g, folder)
    ok, why, got = judge(g, raw)
    return ok, why, got, raw if keep else None, kind_done(g, raw), cut_off(g, raw), raw.get("returns", 0)


def table(rows, verbose):
    kinds = {}
    for g, ok, *_ in rows:
        a, b = kinds.get(g["category"], (0, 0))
        kinds[g["category"]] = (a + ok, b + 1)
    for name, (a, b) in kinds.items():
        print(f"  {name:34} {a:3} of {b}")
    if verbose:
        for g, ok, why, got, *_ in rows:
            if not ok or verbose > 1:
                print(f"  {'ok ' if ok else '-- '} {g['id']:6} {g['category']:28} {g['drawing']:14} {meant(g)} | {got} | {why}")
    return sum(a for a, _ in kinds.values()), sum(b for _, b in kinds.values())


MEANINGS = ["redraw", "several", "extend", "join", "close", "new", "nothing"]


def kind_meant(g):
    """The kind of the first expected outcome."""
    e = g["expect"][0]
    if "redraws" in e:
        return "several" if len(e["redraws"]) > 1 else "redraw"
    return next(word for key, word in (("new", "new"), ("joins", "join"), ("closes", "close"), ("extends", "extend"), ("nothing", "nothing")) if key in e)


def kind_done(g, raw):
    """The kind of what happened to the curves, whatever was meant."""
    if "fault" in raw:
        return "nothing"
    r = Result(g, raw)
    if r.removed:
        return "join"
    if r.added:
        return "new"
    if not r.changed:
        return "nothing"
    if len(r.changed) > 1:
        return "several"
    name = next(iter(r.changed))
    if r.closed_after[name] != r.closed_before[name]:
        return "close"
    return "extend" if grown(r, name) else "redraw"


def grown(r, name):
    """Whether an end was continued along the stroke, away from where the curve was."""
    if r.closed_after[name]:
        return False
    paths = [Places(thin(clean(r.g, s), 400)) for s in strokes_of(r.g)]
    limit = 12 / zoom_of(r.g)
    return any(r.before[name].distance(p) > limit and nearest(paths, p) < limit for p in r.after[name].ends())


def cut_off(g, raw):
    """Whether a curve has lost an end that no stroke came near."""
    if "fault" in raw:
        return False
    r = Result(g, raw)
    paths = [Places(thin(clean(g, s), 400)) for s in strokes_of(g)]
    lines, z = list(r.after.values()), zoom_of(g)
    for name in r.changed | r.removed:
        if not r.closed_before[name]:
            for p in r.before[name].ends():
                if nearest(lines, p) * z > 12 and nearest(paths, p) * z > 30:
                    return True
    return False


def meant(g):
    out = []
    for e in g["expect"]:
        kind = next(k for k in KINDS if k in e)
        v = e[kind]
        out.append(kind + ("" if v is True else " " + (",".join(v) if isinstance(v, list) else str(v))))
    return " or ".join(out)
