#!/usr/bin/env python3
"""Many realistic mechanisms through `prs study`: how many converge, and how well forces balance.

    scripts/many_mechanisms.py PRS [--static N] [--running N] [--seed S] [CATALOGUE.csv]

Makes a case with `prs new` for each screw of a maker's catalogue and draws load, direction,
rollers, threads, flank angle, Young's modulus, pitch errors and crowning around it. N mechanisms
in all are solved at rest (`solve`, bars or refined bodies), N as running screws (`slip`, whose
friction changes the loads; friction and speed are drawn, too). Every second running screw has no
friction of the rollers' heads, the others heads that are smoother than the flanks: rough ones
between smooth flanks hold the rollers, and no slip balances them. The balance of a mechanism is
the sum of the axial loads of all threads at an interface over the axial force, less 1. Prints a
line per screw and command, of each kind of reason the first, and the worst balance.

Exit status 1 where a mechanism neither converges nor is refused.
"""

import argparse
import collections
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from catalogue import new_case, rows_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Refused: such a mechanism cannot be built. All else that has no answer did not converge.
ANSWERS = ("converged", "refused")


def value_in(text, key):
    """The first number behind a key of the case."""
    line = next(line for line in text.splitlines() if line.strip().startswith(key + ":"))
    return float(line.split(":")[1].split()[0])


def without_heads(case):
    """The case without friction of the rollers' heads."""
    return re.sub("^carrier:.*\n", "", case, flags=re.MULTILINE)


def with_smooth_heads(case):
    """The case with heads that rub with a coefficient of 0.02 at most."""
    smooth, found = re.subn("^(carrier:.*boundary: )0.1", r"\g<1>0.02", case, flags=re.MULTILINE)
    if found != 1:
        sys.exit("many_mechanisms: `prs new` writes no friction of the heads that this knows")
    return smooth


def study(case, capacity, running, samples, seed):
    """The block `study` of a case; forces up to the static capacity [kN]."""
    least_friction = 0.04 if "\ncarrier:" in case else 0.005
    rollers = int(value_in(case, "rollers"))
    threads = int(value_in(case, "contacts_per_roller"))
    force = f"{{from: {capacity / 1000:.6g} kN, to: {capacity:.6g} kN}}"
    few, many = max(2, rollers - 4), max(2, threads // 3)
    factors = [
        f'path: "load_cases[0].axial_force", log_uniform: {force}',
        'path: "load_cases[0].direction", values: [tension, compression]',
        f"path: mechanism.rollers, values: {list(range(few, rollers + 1))}",
        f"path: mechanism.contacts_per_roller, values: {list(range(many, threads + 1))}",
        "path: mechanism.flank_angle, uniform: {from: 40 deg, to: 45 deg}",
        "path: materials.youngs_modulus, within: 5 %",
        "path: deviations.pitch_error.screw.linear, normal: {deviation: 3 um}",
        "path: deviations.pitch_error.nut.linear, normal: {deviation: 3 um}",
        "path: deviations.crowning, uniform: {from: 0 um, to: 5 um}",
    ]
    if running:
        factors += [
            f"path: friction.model.coulomb, log_uniform: {{from: {least_friction}, to: 0.15}}",
            "path: operation.speed, log_uniform: {from: 1 rpm, to: 3000 rpm}",
        ]
    else:
        factors.append("path: model.bodies, values: [bars, refined]")
    lines = "\n".join(f"    - {{{factor}}}" for factor in factors)
    return f"""
study:
  command: {"slip" if running else "solve"}
  plan: monte_carlo
  samples: {samples}
  seed: {seed}
  responses: [screw.axial_load_N.mean, nut.axial_load_N.mean]
  factors:
{lines}
"""


def balances(row):
    """At screw and nut."""
    shared = int(row["mechanism.rollers"]) * int(row["mechanism.contacts_per_roller"])
    force = 1e3 * float(row["load_cases[0].axial_force_kN"])
    for interface in ("screw", "nut"):
        yield abs(shared * float(row[interface + ".axial_load_N.mean"]) / force - 1.0)


def run(prs, file, folder):
    """Counts of statuses, of each kind of reason the first, and the worst balance."""
    command = [prs, "study", str(file), "--output", str(folder), "--csv-digits", "17"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not (folder / "study.csv").exists():
        sys.exit(done.stderr)
    counts, reasons, worst = collections.Counter(), {}, 0.0
    with open(folder / "study.csv", encoding="utf-8", newline="") as results:
        for row in csv.DictReader(results):
            if row["design"] == "0":
                continue
            counts[row["status"]] += 1
            if row["status"] == "converged":
                worst = max(worst, *balances(row))
            else:
                key = row["reason"].split(": error: ")[-1].split(":")[0]
                kind = row["status"] + ", " + key
                reasons.setdefault(kind, row["reason"])
    return counts, reasons, worst


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("prs")
    parser.add_argument("--static", type=int, default=1_000_000, help="loads at rest, in all")
    parser.add_argument("--running", type=int, default=1_000_000, help="running screws, in all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "catalogue", nargs="?", default=ROOT / "validation/standard_screws/screws.csv"
    )
    asked = parser.parse_args()
    if shutil.which(asked.prs) is None:
        parser.error(f"PRS: got {asked.prs}, which is no program; build prs, or say where it is")
    if min(asked.static, asked.running) < 0:
        parser.error("--static, --running: expected numbers of mechanisms, 0 or more")
    if not pathlib.Path(asked.catalogue).is_file():
        parser.error(f"CATALOGUE: got {asked.catalogue}, which is no file; expected a CSV file")
    rows = rows_of(asked.catalogue)

    failed = False
    for running, wanted in ((False, asked.static), (True, asked.running)):
        total, first, worst = collections.Counter(), {}, 0.0
        for number, row in enumerate(rows if wanted else []):
            samples = wanted // len(rows) + (number < wanted % len(rows))
            if samples == 0:
                continue
            with tempfile.TemporaryDirectory() as temporary:
                folder = pathlib.Path(temporary)
                file = folder / "case.yaml"
                if not new_case(asked.prs, row, file):
                    sys.exit(1)  # `prs new` has said why.
                text = file.read_text(encoding="utf-8")
                if running:
                    text = with_smooth_heads(text) if number % 2 else without_heads(text)
                capacity = float(row["static_capacity_kN"])
                block = study(text, capacity, running, samples, asked.seed + number)
                file.write_text(text + block, encoding="utf-8")
                counts, reasons, balance = run(asked.prs, file, folder / "out")
            print(
                f"{'slip' if running else 'solve'} {row['screw_diameter_mm']}x{row['lead_mm']}: "
                f"{dict(counts)}, worst balance {balance:.1e}",
                flush=True,
            )
            total.update(counts)
            worst = max(worst, balance)
            first = reasons | first
        if wanted:
            print(f"in all: {dict(total)}, worst balance {worst:.1e}")
        for kind, reason in first.items():
            print(f"  {kind}: {reason}")
        failed = failed or any(status not in ANSWERS for status in total)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
