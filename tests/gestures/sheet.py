#!/usr/bin/env python3
"""Contact sheets of gestures: sheet.py HOST FOLDER OUT_PREFIX [filter]. HOST: gesture_host of a build; FOLDER: with gestures.json.
Grey: before; amber: changed or removed, before; red: the stroke's samples; blue: changed, after; green: new.
Needs rsvg-convert for PNG; else the sheets stay SVG."""
import html, os, shutil, subprocess, sys
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import score as s

W, H, COLUMNS, ROWS = 400, 300, 4, 4


def tile(g, ok, why, got, raw):
    paths = [s.clean(g, k) for k in s.strokes_of(g)]
    samples = [s.samples(g, k) for k in s.strokes_of(g)]
    v = g["view"]
    back = lambda p: [(p[0] - v["size"][0] / 2) / v["zoom"] + v["centre"][0], (p[1] - v["size"][1] / 2) / v["zoom"] + v["centre"][1]]
    xs, ys = [p[0] for q in paths for p in q], [p[1] for q in paths for p in q]
    pad = max(max(xs) - min(xs), max(ys) - min(ys), 40 / v["zoom"]) * 0.35
    x0, x1, y0, y1 = min(xs) - pad, max(xs) + pad, min(ys) - pad, max(ys) + pad
    k = min(W / (x1 - x0), (H - 44) / (y1 - y0))
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    at = lambda p: f"{(p[0] - cx) * k + W / 2:.1f},{(p[1] - cy) * k + H / 2 + 8:.1f}"
    line = lambda pts, colour, width, more="": f'<polyline points="{" ".join(at(p) for p in pts)}" fill="none" stroke="{colour}" stroke-width="{width}" {more}/>'
    out = []
    if "fault" not in raw:
        r = s.Result(g, raw)
        for name, c in r.before.items():
            hit = name in r.changed or name in r.removed
            out.append(line(c.points, "#f2b705" if hit else "#bbb", 3 if hit else 1))
    for q in samples:
        pts = [back(p) for p in q]
        x, y = at(pts[0]).split(",")
        out.append(line(pts, "#e22", 0.9) + f'<circle cx="{x}" cy="{y}" r="3" fill="#e22"/>')
    if "fault" not in raw:
        for name in sorted(r.changed):
            if name in r.after:
                out.append(line(r.after[name].points, "#0645d8", 1.5))
        for name in r.added:
            out.append(line(r.after[name].points, "#0a8f3c", 1.5))
    text = lambda y, t, more="": f'<text x="4" y="{y}" font-size="11" {more}>{html.escape(t)}</text>'
    return (f'<rect width="{W}" height="{H}" fill="#fff" stroke="#888"/>{"".join(out)}<rect width="{W}" height="28" fill="#fffe"/>'
            + text(12, f"{g['id']} {g['category']} {g['drawing']} {100 * v['zoom']:.0f}%", 'font-weight="bold"')
            + text(25, f"{s.meant(g)}"[:66]) + text(H - 18, f"{'ok' if ok else 'NO'}: {got}"[:68], f'fill="{"#080" if ok else "#a00"}"')
            + text(H - 5, why[:68], 'fill="#a00"'))


def main():
    host, folder, prefix = sys.argv[1:4]
    rows = s.score(host, folder, sys.argv[4] if len(sys.argv) > 4 else None, keep=True)
    each = COLUMNS * ROWS
    for n in range(0, len(rows), each):
        part = rows[n:n + each]
        height = -(-len(part) // COLUMNS) * H
        body = "".join(f'<svg x="{i % COLUMNS * W}" y="{i // COLUMNS * H}" width="{W}" height="{H}">{tile(*row[:5])}</svg>' for i, row in enumerate(part))
        name = f"{prefix}-{n // each + 1:02}"
        with open(name + ".svg", "w") as f:
            f.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{W * COLUMNS}" height="{height}" font-family="DejaVu Sans, sans-serif">{body}</svg>')
        if shutil.which("rsvg-convert"):
            subprocess.run(["rsvg-convert", name + ".svg", "-o", name + ".png"], check=True)
            os.unlink(name + ".svg")
        print(name)


if __name__ == "__main__":
    main()
