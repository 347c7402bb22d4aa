"""SVG files as programs write them: matplotlib, Graphviz, gnuplot, R, d3 and LibreOffice are asked for a number of drawings each,
the same each time. Those of matplotlib, R and d3 are made by the programs in drawn/."""
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

COUNT = 40
DRAWN = pathlib.Path(__file__).resolve().parent / "drawn"


def call(*words, text=None, folder=None):
    try:
        subprocess.run([str(word) for word in words], input=text, cwd=folder, text=True, capture_output=True, timeout=300,
                       check=True)
    except (OSError, subprocess.SubprocessError) as error:
        print(f"not to be had: {words[0]}: {error}")


# ---- Graphviz ----

SHAPES = ["ellipse", "box", "diamond", "record", "star", "cylinder", "note", "Mrecord", "doublecircle", "plaintext"]
STYLES = ["filled", "dashed", "bold", "rounded,filled", "radial", "solid"]
FILLS = ["gold", "lightblue:white", "#ff880080"]
ARROWS = ["normal", "vee", "dot", "odiamond", "crow"]
LINES = ["solid", "dashed", "dotted", "bold"]


def graph(i):
    """A graph in the language of Graphviz."""
    r = random.Random(i)
    lines = [f"digraph g{i} {{ rankdir={r.choice(['TB', 'LR'])}; splines={r.choice(['spline', 'ortho', 'polyline'])};"]
    for k in range(8):
        looks = f'shape={r.choice(SHAPES)} style="{r.choice(STYLES)}" fillcolor="{r.choice(FILLS)}"'
        lines.append(f'n{k} [{looks} label="node {k}"];')
    for k in range(1, 8):
        lines.append(f'n{r.randrange(k)} -> n{k} [label="{k}" arrowhead={r.choice(ARROWS)} style={r.choice(LINES)}];')
    if i % 3 == 0:
        lines.append('subgraph cluster_a { label="part"; bgcolor="#eeeeff"; n1; n2; }')
    return "\n".join([*lines, "}"])


def with_graphviz(folder):
    for i in range(COUNT):
        call(["dot", "neato", "dot", "fdp"][i % 4], "-Tsvg", "-o", folder / f"{i}.svg", text=graph(i))


# ---- gnuplot ----

TERMINALS = ["", "mouse standalone", "rounded dashed", "enhanced background '#eeeeee'"]
PLOTS = ["plot sin({a}*x) with lines lw 2, cos(x) with points pt 7", "plot '+' using 1:(sin($1)) with boxes fs pattern 2",
         "splot x**2-y**2*{a} with lines", "plot sin(x) with filledcurves above y1=0 fs transparent solid 0.4, x/10 dt 2",
         "set polar; plot sin({a}*t)", "set pm3d map; splot sin(x)*cos(y*{a})", "plot '+' using 1:(cos($1)):(0.2) with errorbars"]


def with_gnuplot(folder):
    for i in range(COUNT):
        text = (f"set term svg size 320,240 {TERMINALS[i % len(TERMINALS)]}; set output '{i}.svg'; set samples 40; "
                f"set isosamples 12; set title 'plot {i}'; {PLOTS[i % len(PLOTS)].format(a=1 + i / 7)}; unset output\n")
        call("gnuplot", text=text, folder=folder)


# ---- LibreOffice, which converts its own flat format ----

SPACES = " ".join(f'xmlns:{name}="urn:oasis:names:tc:opendocument:xmlns:{path}:1.0"' for name, path in
                  [("office", "office"), ("style", "style"), ("text", "text"), ("draw", "drawing"), ("svg", "svg-compatible")])


def lengths(**given):
    return " ".join(f'svg:{name}="{value:.2f}cm"' for name, value in given.items())


def shape(k, r):
    style = f'draw:style-name="s{r.randrange(4)}"'
    at = lengths(x=r.uniform(1, 14), y=r.uniform(1, 9), width=r.uniform(1, 5), height=r.uniform(1, 4))
    name = r.choice(["rect", "ellipse", "path", "line", "text"])
    if name == "line":
        return f"<draw:line {style} {lengths(x1=k, y1=1, x2=r.uniform(5, 15), y2=r.uniform(2, 9))}/>"
    if name == "path":
        return f'<draw:path {style} {at} svg:viewBox="0 0 100 100" svg:d="M0 50C0 0 100 0 100 50S{r.randrange(90)} 100 0 50Z"/>'
    if name == "text":
        return f"<draw:frame {style} {at}><draw:text-box><text:p>text {k}</text:p></draw:text-box></draw:frame>"
    return f"<draw:{name} {style} {at}/>"


def style_of(k, r):
    stroke, fill = ["solid", "dash", "none", "solid"][k], ["solid", "none", "gradient", "solid"][k]
    colours = [f"#{r.randrange(1 << 24):06x}" for _ in range(2)]
    return (f'<style:style style:name="s{k}" style:family="graphic"><style:graphic-properties draw:stroke="{stroke}" '
            f'svg:stroke-width="0.{k + 1}cm" svg:stroke-color="{colours[0]}" draw:fill="{fill}" draw:fill-gradient-name="g" '
            f'draw:fill-color="{colours[1]}" draw:opacity="{50 if k == 3 else 100}%"/></style:style>')


def drawing(i):
    r = random.Random(i)
    shapes = "".join(shape(k, r) for k in range(9))
    styles = "".join(style_of(k, r) for k in range(4))
    return (f'<?xml version="1.0" encoding="UTF-8"?><office:document {SPACES} office:version="1.2" '
            f'office:mimetype="application/vnd.oasis.opendocument.graphics"><office:styles><draw:gradient draw:name="g" '
            f'draw:style="{["linear", "radial", "axial"][i % 3]}" draw:start-color="#ffff00" draw:end-color="#0000ff" '
            f'draw:angle="{30 * i}"/></office:styles><office:automatic-styles>{styles}</office:automatic-styles><office:body>'
            f'<office:drawing><draw:page draw:name="p">{shapes}</draw:page></office:drawing></office:body></office:document>')


def with_libreoffice(folder):
    with tempfile.TemporaryDirectory() as name:
        paths = [pathlib.Path(name) / f"{i}.fodg" for i in range(COUNT)]
        for i, path in enumerate(paths):
            path.write_text(drawing(i))
        profile = f"-env:UserInstallation=file://{name}/profile"
        call("soffice", profile, "--headless", "--convert-to", "svg", "--outdir", folder, *paths)


def draw_all(files, npm):
    """Into a folder for each program, where there is none yet. npm: where d3 and jsdom are installed."""
    makers = {
        "matplotlib": (sys.executable, lambda at: call(sys.executable, DRAWN / "plots.py", at, COUNT)),
        "graphviz": ("dot", with_graphviz),
        "gnuplot": ("gnuplot", with_gnuplot),
        "r": ("Rscript", lambda at: call("Rscript", DRAWN / "plots.R", at, COUNT)),
        "d3": ("node", lambda at: call("node", DRAWN / "charts.mjs", npm.resolve(), at, COUNT)),
        "libreoffice": ("soffice", with_libreoffice),
    }
    for name, (program, make) in makers.items():
        folder = (files / name).resolve()
        if folder.exists() and any(folder.iterdir()):
            continue
        if not shutil.which(program):
            print(f"not to be had: {program}")
            continue
        folder.mkdir(exist_ok=True)
        make(folder)
