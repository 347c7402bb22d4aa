#!/usr/bin/python3
"""What visitors' results say: analyse.py RESULTS.csv [PICTURE.svg]

Each line is one person, as the study hands it in (docs/user-test.md). Printed are the medians of time and error of both ways, the
median of the differences within a person, how many were faster by sketching, and how likely so large a mean difference is by chance:
the signs of all differences are turned in every way, or in 100,000 ways of more than 16 people. The picture is that of Fig. 13: a
bar for each person, left by sketching, right by control points.
"""
import csv
import itertools
import random
import statistics
import sys

NUMBERS = "sketch_seconds", "sketch_error_px", "points_seconds", "points_error_px"
EXACT = 16  # people, of whom all 2^n signs are tried


def read(lines):
    rows = []
    for number, row in enumerate(csv.DictReader(lines), 2):
        try:
            values = {name: float(row[name]) for name in NUMBERS}
        except (KeyError, TypeError, ValueError):
            raise SystemExit(f"line {number}: expected {', '.join(NUMBERS)} as numbers")
        if not all(0 <= value < 1e9 for value in values.values()):
            raise SystemExit(f"line {number}: expected times and errors of zero or more")
        rows.append(values | {"first": row.get("first")})
    if not rows:
        raise SystemExit("expected a line for each person, found none")
    return rows


def chance(differences):
    """The share of sign changes whose mean is as far from zero: a paired permutation test, two-sided."""
    asked = abs(sum(differences)) * (1 - 1e-12)
    if len(differences) <= EXACT:
        signs = itertools.product((1, -1), repeat=len(differences))
        count = 2 ** len(differences)
        return sum(abs(sum(s * d for s, d in zip(sign, differences))) >= asked for sign in signs) / count
    draw, count = random.Random(1), 100000
    hits = sum(abs(sum(d if draw.random() < .5 else -d for d in differences)) >= asked for _ in range(count))
    return (hits + 1) / (count + 1)


def table(rows):
    def median(name):
        return statistics.median(row[name] for row in rows)

    seconds = [row["points_seconds"] - row["sketch_seconds"] for row in rows]
    error = [row["points_error_px"] - row["sketch_error_px"] for row in rows]
    first = sum(row["first"] == "sketch" for row in rows)
    return [f"people: {len(rows)}, {first} of them sketched first",
            f"time, median: sketching {median('sketch_seconds'):.1f} s, control points {median('points_seconds'):.1f} s; "
            f"difference within a person {statistics.median(seconds):+.1f} s, by chance {chance(seconds):.3g}",
            f"error, median: sketching {median('sketch_error_px'):.2f} px, control points {median('points_error_px'):.2f} px; "
            f"difference within a person {statistics.median(error):+.2f} px, by chance {chance(error):.3g}",
            f"faster by sketching: {sum(d > 0 for d in seconds)} of {len(rows)}"]


def picture(rows):
    width, high = 760, 320
    most = max(max(row["sketch_seconds"], row["points_seconds"]) for row in rows) or 1
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {high + 60}" font-family="sans-serif" font-size="13" fill="#59616c">',
             f'<path d="M0 0h{width}v{high + 60}H0z" fill="#fff"/>']
    for left, name, words, colour in ((40, "sketch_seconds", "sketching, s", "#1f62d6"), (410, "points_seconds", "control points, s", "#8b95a1")):
        step = 310 / len(rows)
        for i, row in enumerate(rows):
            tall = (high - 50) * row[name] / most
            parts.append(f'<rect x="{left + i * step + step * .15:.1f}" y="{high - tall:.1f}" width="{step * .7:.1f}" height="{tall:.1f}" fill="{colour}"/>')
        parts += [f'<path d="M{left} {high}h310" stroke="#8b95a1"/>', f'<text x="{left + 155}" y="{high + 34}" text-anchor="middle">{words}</text>',
                  f'<text x="{left - 4}" y="46" text-anchor="end">{most:.0f}</text>']
    return "\n".join([*parts, "</svg>"]) + "\n"


def main(results, out=None):
    with open(results, encoding="utf-8") as lines:
        rows = read(lines)
    print("\n".join(table(rows)))
    if out:
        with open(out, "w", encoding="utf-8") as file:
            file.write(picture(rows))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
