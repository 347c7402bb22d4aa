"""Reads rows as JSON lines, writes the machine and the tables of docs/benchmarks.md. usage: table.py MACHINE < rows"""
import json
import sys

tasks = {}
for line in sys.stdin:
    if line.startswith("{"):
        row = json.loads(line)
        tasks.setdefault(row["name"], {})[row["program"]] = row


def cells(row, own):
    ratio = f"{row['best'] / own['best']:.3g}" if row is not own else ""
    return f"{row['best']:.3g} ({row['median']:.3g}) | {ratio} | {row['note']} |"


print(f"Machine: {sys.argv[1]}")
print("\nA ratio above 1 says that Batten is faster.")
print("\n| task | program | best (median) | ratio | result |\n|---|---|---:|---:|---|")
alone = []
for name, rows in tasks.items():
    own = rows.get("batten")
    if not own:
        continue
    if len(rows) == 1:
        alone.append(own)
        continue
    others = sorted((row for row in rows.values() if row is not own), key=lambda row: row["best"])
    print(f"| **{name}**, {own['unit']} | Batten | {cells(own, own)}")
    for row in others:
        print(f"| | {row['program']} | {cells(row, own)}")
print("\nTasks for which no peer was at hand:")
print("\n| task | best (median) | result |\n|---|---:|---|")
for own in alone:
    print(f"| {own['name']}, {own['unit']} | {own['best']:.3g} ({own['median']:.3g}) | {own['note']} |")
