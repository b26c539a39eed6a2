#!/usr/bin/env python3
"""Writes RESULTS.md and results.svg, this program against the benchmark: results_page.py PRS [--check]

With --check it writes nothing and says whether RESULTS.md is what PRS gives today (status 1 if not).
"""
import argparse
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import check
import run_prs

BENCHMARK = Path(__file__).resolve().parent
HEAD = """# This program against the benchmark

Written by `results_page.py`; `prs` {version}. Ratios are deviation over the uncertainty of the expected number: a number
with a ratio up to 1 is within. A ratio below 0.01 means agreement to far more digits than the benchmark claims.

![Deviation over uncertainty of all numbers](results.svg)

| case | within | worst ratio | of | expected | here |
| --- | --- | --- | --- | --- | --- |
"""
INFORMATION = """
## For information: bars against real bodies

These numbers do not count. Cases 04 and 08 to 11 are bars and beams by definition; the column "finite elements" is the
answer for elastic bodies, by CalculiX. The program's models `refined` and `influence` are nearer to it
([full_mechanism.md](../docs/full_mechanism.md), [influence.md](../docs/influence.md)).

| case | quantity | finite elements | bars here | bars less elements |
| --- | --- | --- | --- | --- |
"""
REFINED = """
## Case 06 by the one-dimensional model

Case 06 above is computed with `bodies: influence`, which is within the error bars. The one-dimensional model `refined`,
which is fast enough for studies, is not:

| quantity | finite elements | `refined` | ratio |
| --- | --- | --- | --- |
"""


def ratio(value):
    return "below 0.01" if value < 0.01 else f"{value:.2g}"


def number(value, unit):
    return f"{value:.6g} {unit}".replace(" -", "")


def compared(rows):
    found = {}
    for case, quantity, value, unit in rows:
        found.setdefault(case, {})[quantity] = (value, unit)
    return check.compare(found)


def page(prs):
    version = subprocess.run([prs, "--version"], capture_output=True, text=True, check=True).stdout.split()[-1]
    results = compared(run_prs.results(prs))
    lines = HEAD.format(version=version)
    for case, of_case in results.items():
        rows = check.counted(of_case)
        row, value, worst = check.worst(of_case)
        if worst < 0.01:  # Which of the digits of rounding is the worst says nothing.
            row, value, _ = rows[0]
        within = sum(r[2] <= 1.0 for r in rows)
        folder = next(BENCHMARK.glob(case + "_*")).name
        lines += (f"| [{case} {of_case['name']}]({folder}/README.md) | {within} of {len(rows)} | {ratio(worst)} | "
                  f"`{row['quantity']}` | {number(float(row['value']), row['unit'])} | {number(value, row['unit'])} |\n")
    lines += INFORMATION
    for case, of_case in results.items():
        for row, value, _ in of_case["rows"]:
            if row["counts"] == "no":
                real = float(row["value"])
                lines += (f"| {case} | `{row['quantity']}` | {number(real, row['unit'])} | {number(value, row['unit'])} | "
                          f"{round(100 * (value / real - 1), 1) + 0.0:+.1f} % |\n")
    lines += REFINED
    refined = compared(run_prs.results(prs, ["06"], "refined"))["06"]
    chosen = ("displacement_um", "thread_share_screw_1_percent", "thread_share_screw_20_percent",
              "thread_share_nut_1_percent", "thread_share_nut_20_percent")
    for row, value, of_row in refined["rows"]:
        if row["quantity"] in chosen:
            lines += (f"| `{row['quantity']}` | {number(float(row['value']), row['unit'])} | "
                      f"{number(value, row['unit'])} | {ratio(of_row)} |\n")
    return lines, results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("prs")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    text, results = page(given.prs)
    path = BENCHMARK / "RESULTS.md"
    if given.check:
        if path.read_text() == text:
            return 0
        print("benchmark/RESULTS.md is not what the program gives; benchmark/results_page.py writes it", file=sys.stderr)
        return 1
    path.write_text(text)
    check.picture(results, BENCHMARK / "results.svg")
    return 0 if check.all_within(results) else 1


if __name__ == "__main__":
    sys.exit(main())
