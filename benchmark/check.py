#!/usr/bin/env python3
"""Compares any program's numbers with the benchmark: check.py results.csv [--picture FILE] [--rows N]

results.csv has a heading and the columns case (01 to 20), quantity, value and, if you like, unit. Names and units are
those of the cases' expected.csv. Only cases that results.csv has are compared; a quantity of theirs that is missing
counts as not within. Exit status: 0 all within, 1 not all within, 2 results.csv cannot be read.
"""
import argparse
import csv
import math
import sys
from pathlib import Path

BENCHMARK = Path(__file__).resolve().parent


class WrongInput(Exception):
    """results.csv says what the benchmark does not know."""


def cases():
    """{number: (name, rows of expected.csv)}"""
    found = {}
    for folder in sorted(BENCHMARK.glob("[0-9][0-9]_*")):
        with open(folder / "expected.csv", newline="") as file:
            found[folder.name[:2]] = (folder.name[3:].replace("_", " "), list(csv.DictReader(file)))
    return found


def read_results(path):
    """{case: {quantity: (value, unit)}}"""
    found = {}
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        for need in ("case", "quantity", "value"):
            if need not in (reader.fieldnames or ()):
                raise WrongInput(f"{path}: no column {need}; the heading must be case,quantity,value,unit")
        for row in reader:
            try:
                value = float(row["value"])
            except (TypeError, ValueError):
                raise WrongInput(f"{path}:{reader.line_num}: value is {row['value']!r}, not a number") from None
            of_case = found.setdefault((row["case"] or "").zfill(2), {})
            if row["quantity"] in of_case:
                raise WrongInput(f"{path}:{reader.line_num}: {row['quantity']} of case {row['case']} stands twice")
            of_case[row["quantity"]] = (value, row.get("unit") or "")
    return found


def compare(results):
    """Of each case in `results` {name, rows: [(expected row, value or None, ratio)]}: ratio is deviation over
    uncertainty, infinite where the quantity is missing."""
    benchmark, compared = cases(), {}
    for number, values in sorted(results.items()):
        if number not in benchmark:
            raise WrongInput(f"case {number} is not in the benchmark, which has {', '.join(benchmark)}")
        name, expected = benchmark[number]
        known = {row["quantity"] for row in expected}
        for quantity in values:
            if quantity not in known:
                raise WrongInput(f"case {number} has no quantity {quantity}; expected.csv has the names")
        rows = []
        for row in expected:
            value, unit = values.get(row["quantity"], (None, ""))
            if unit and unit != row["unit"]:
                raise WrongInput(f"case {number}, {row['quantity']}: unit {unit}, must be {row['unit']}")
            ratio = math.inf if value is None or not math.isfinite(value) else (
                abs(value - float(row["value"])) / float(row["uncertainty"]))
            rows.append((row, value, ratio))
        compared[number] = {"name": name, "rows": rows}
    return compared


def counted(case):
    return [row for row in case["rows"] if row[0]["counts"] == "yes"]


def worst(case):
    return max(counted(case), key=lambda row: row[2])


def all_within(compared):
    return bool(compared) and all(worst(case)[2] <= 1.0 for case in compared.values())


def short(value):
    return "missing" if value is None else f"{value:.9g}"


def table(compared, each=0):
    lines = [f"{'case':<41} {'within':>9}  {'worst deviation / uncertainty':<30} quantity"]
    for number, case in compared.items():
        rows = counted(case)
        row, _, ratio = worst(case)
        within = f"{sum(r[2] <= 1.0 for r in rows)}/{len(rows)}"
        lines.append(f"{number + ' ' + case['name']:<41} {within:>9}  {ratio:<30.3g} {row['quantity']}")
        for row, value, ratio in sorted(rows, key=lambda r: -r[2])[:each]:
            lines.append(f"    {row['quantity']}: {short(value)} {row['unit']}, expected {short(float(row['value']))} "
                         f"+- {float(row['uncertainty']):.2g}: {ratio:.3g}")
    return "\n".join(lines)


def picture(compared, path):
    """Deviation over uncertainty of every number, a row each case, as SVG."""
    width, left, right, line, top = 760, 230, 20, 22, 30
    height = top + line * len(compared) + 34
    low, high = -3.0, 3.0  # powers of ten; what is below stands at the edge
    x = lambda ratio: left + (min(max(math.log10(max(ratio, 1e-300)), low), high) - low) / (high - low) * (
        width - left - right)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
           f'font-size="12"><rect width="100%" height="100%" fill="white"/>']
    for power in range(int(low), int(high) + 1):
        at, limit = x(10.0**power), power == 0
        out.append(f'<line x1="{at:.1f}" x2="{at:.1f}" y1="{top - 6}" y2="{height - 34}" '
                   f'stroke="{"#c00" if limit else "#ddd"}"/><text x="{at:.1f}" y="{height - 20}" '
                   f'text-anchor="middle">{"1" if limit else f"1e{power}"}</text>')
    out.append(f'<text x="{(left + width) / 2}" y="{height - 4}" text-anchor="middle">deviation over uncertainty '
               f'(bar: all numbers of the case; mark: the largest)</text>')
    for i, (number, case) in enumerate(compared.items()):
        y = top + line * i
        ratios = sorted(row[2] for row in counted(case))
        first, last, middle = x(ratios[0]), x(ratios[-1]), x(ratios[len(ratios) // 2])
        colour = "#2a7" if ratios[-1] <= 1.0 else "#c00"
        out.append(f'<text x="{left - 8}" y="{y + 10}" text-anchor="end">{number} {case["name"]}</text>'
                   f'<rect x="{first:.1f}" y="{y + 1}" width="{max(last - first, 1):.1f}" height="9" fill="{colour}" '
                   f'opacity="0.35"/><line x1="{middle:.1f}" x2="{middle:.1f}" y1="{y + 1}" y2="{y + 10}" '
                   f'stroke="{colour}"/><circle cx="{last:.1f}" cy="{y + 5.5}" r="4" fill="{colour}"/>')
    Path(path).write_text("\n".join(out) + "\n</svg>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("--picture", metavar="FILE", help="draw the differences (SVG)")
    parser.add_argument("--rows", type=int, default=0, metavar="N", help="list the N worst numbers of each case")
    given = parser.parse_args()
    try:
        compared = compare(read_results(given.results))
    except (OSError, WrongInput) as error:
        print(f"check.py: {error}", file=sys.stderr)
        return 2
    print(table(compared, given.rows))
    if given.picture:
        picture(compared, given.picture)
    within = all_within(compared)
    print("All within." if within else "Not all within.")
    return 0 if within else 1


if __name__ == "__main__":
    sys.exit(main())
