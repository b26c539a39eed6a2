"""Writes expected.csv of every case, or of those named: write_expected.py [NN ..]."""
import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cases

BENCHMARK = Path(__file__).resolve().parents[1]
FIELDS = ("quantity", "unit", "value", "uncertainty", "reason", "source", "counts")


def digits(value):
    return f"{value:.12g}"


def main(numbers):
    for folder in sorted(BENCHMARK.glob("[0-9][0-9]_*")):
        if numbers and folder.name[:2] not in numbers:
            continue
        rows = cases.Rows()
        getattr(cases, "case_" + folder.name[:2])(rows)
        with open(folder / "expected.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            writer.writeheader()
            for row in rows:
                writer.writerow(row | {"value": digits(row["value"]), "uncertainty": f"{row['uncertainty']:.3g}"})
        print(f"{folder.name}: {len(rows)} rows")


if __name__ == "__main__":
    main(sys.argv[1:])
