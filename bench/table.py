"""Reads rows as JSON lines, writes the machine and the table of docs/benchmarks.md. usage: table.py MACHINE < rows"""
import json
import sys

rows = {}
programs = []
units = {}
for line in sys.stdin:
    r = json.loads(line)
    rows[r["name"], r["program"]] = r
    units[r["name"]] = r["unit"]
    if r["program"] not in programs:
        programs.append(r["program"])
peers = [p for p in programs if p != "batten"]
print(f"""Machine: {sys.argv[1]}

| task | unit | Batten | {" | ".join(peers)} |
|---|---|---|{"---|" * len(peers)}""")
for name, unit in units.items():
    own = rows.get((name, "batten"))
    if not own:
        continue
    cells = []
    for p in ["batten"] + peers:
        r = rows.get((name, p))
        if not r:
            cells.append("")
            continue
        text = f"{r['best']:.3g} ({r['median']:.3g})"
        if p != "batten":
            text += f", {r['best'] / own['best']:.3g} x"
        if r["note"]:
            text += f"; {r['note']}"
        cells.append(text)
    print(f"| {name} | {unit} | {' | '.join(cells)} |")
