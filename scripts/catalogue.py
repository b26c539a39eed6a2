#!/usr/bin/env python3
"""Cases of a maker's screws, one `prs new` each, and what they give over what the maker prints.

    scripts/catalogue.py [--prs PRS] [--cases DIR] [CATALOGUE.csv]

Runs check, contact, solve, slip, measures and life on the case of every row and prints a table of
ratios, computed over printed, and the static safety at the assumed load. Columns of the catalogue
as in validation/standard_screws/screws.csv; lines that begin with # are skipped. Exit status 1
where a command fails.
"""

import argparse
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMANDS = ("check", "contact", "solve", "slip", "measures", "life")
# Heading, column of the catalogue, command and key of the result, factor to the column's unit.
RATIOS = (
    ("C_a", "dynamic_capacity_kN", "measures", "dynamic_capacity_N", 1e-3),
    ("C_0", "static_capacity_kN", "measures", "static_capacity_N", 1e-3),
    ("nut and rollers", "nut_and_rollers_kg", "measures", "weight_kg", 1.0),
    ("screw, kg/m", "screw_kg_per_m", "measures", "screw_weight_kg_per_m", 1.0),
    ("screw inertia/m", "screw_inertia_kg_mm2_per_m", "measures", "screw_inertia_kg_mm2", 1.0),
    ("nut inertia", "nut_inertia_kg_mm2", "measures", "nut_inertia_kg_mm2", 1.0),
    (
        "roller inertia",
        "roller_inertia_seen_by_screw_kg_mm2",
        "measures",
        "roller_inertia_kg_mm2",
        1.0,
    ),
    ("efficiency", "efficiency", "slip", "efficiency", 1.0),
)


def rows_of(catalogue):
    """A dictionary for each screw; lines that begin with # are comments."""
    with open(catalogue, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def new_case(prs, row, file):
    options = [
        "--screw-diameter",
        row["screw_diameter_mm"] + "mm",
        "--lead",
        row["lead_mm"] + "mm",
        "--starts",
        row["starts"],
        "--nut-diameter",
        row["nut_diameter_mm"] + "mm",
        "--nut-length",
        row["nut_length_mm"] + "mm",
    ]
    return subprocess.run([prs, "new", "standard", str(file), "--quiet", *options]).returncode == 0


def results(prs, file):
    """The documents of all commands; an error text in place of one that failed."""
    found = {}
    for command in COMMANDS:
        run = subprocess.run(
            [prs, command, str(file), "--json", "--quiet"], capture_output=True, text=True
        )
        found[command] = (
            json.loads(run.stdout) if run.returncode == 0 else run.stderr or str(run.returncode)
        )
    return found


def resolved(found, path):
    """A value of the case, with its unit."""
    return next(entry["value"] for entry in found["check"]["input"] if entry["path"] == path)


def ratio(row, found, column, command, key, factor):
    if command == "measures":
        value = found[command]["measures"].get(key)
    else:
        value = found[command]["load_cases"][0]["slip"].get(key)
    if value is None:
        return None
    if key == "screw_inertia_kg_mm2":  # Of the whole shaft.
        factor = 1e3 / float(resolved(found, "measures.shaft.length").removesuffix(" mm"))
    return value * factor / float(row[column])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument(
        "catalogue", nargs="?", default=ROOT / "validation/standard_screws/screws.csv"
    )
    parser.add_argument("--prs", default=str(ROOT / "build/release/prs/cli/prs"))
    parser.add_argument("--cases", help="folder that keeps the cases; they must be new")
    asked = parser.parse_args()
    if shutil.which(asked.prs) is None:
        parser.error(f"--prs: got {asked.prs}, which is no program; build prs, or say where it is")
    rows = rows_of(asked.catalogue)

    failed = 0
    headings = ["screw", "rollers", *(heading for heading, *_ in RATIOS), "static safety"]
    print("| " + " | ".join(headings) + " |")
    print("| --- " * len(headings) + "|")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(asked.cases or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for row in rows:
            name = f"{row['screw_diameter_mm']}x{row['lead_mm']}"
            if row["starts"] != "5":
                name += f", {row['starts']} starts"
            file = folder / (name.replace(", ", "_").replace(" ", "_") + ".yaml")
            if not new_case(asked.prs, row, file):
                failed += 1
                continue
            found = results(asked.prs, file)
            for command, document in found.items():
                if isinstance(document, str):
                    failed += 1
                    print(f"{name}: prs {command}: {document}", file=sys.stderr)
            if any(isinstance(document, str) for document in found.values()):
                continue
            shown = [ratio(row, found, *of) for _, *of in RATIOS]
            shown.append(found["life"]["life"].get("static_safety"))
            print(
                f"| {name} | {resolved(found, 'mechanism.rollers')} | "
                + " | ".join("-" if value is None else f"{value:.2f}" for value in shown)
                + " |"
            )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
