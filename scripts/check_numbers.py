#!/usr/bin/env python3
"""Checks numbers that several documents state against the one place that has them: the sources that
the program prints, which tests hold. A document may round to fewer digits, or state a part of a
range."""

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
RANGE = r"\+?(-?[\d.]+) to \+?(-?[\d.]+)"


class Claim(NamedTuple):
    file: str  # where the numbers stand
    source: str  # their lower and upper end there
    texts: tuple[str, ...]  # the same in documents


BODIES = "prs/model/body_model.h"
CLAIMS = {
    "stiffness of bars": Claim(
        BODIES,
        rf'"{RANGE} % stiffer than finite elements on an inverted 21 x 5 mm screw; nearer',
        (
            rf"\bbars\b[^|.;]{{0,60}}?{RANGE} % (?:too stiff|stiffer)",
            rf"bar model\. It is {RANGE} % too stiff",
            rf"stiffness, against finite elements \| {RANGE} % at 45 kN",
            rf"\bbars are [\d.]+ to [\d.]+ % too stiff in tension and {RANGE} %",
        ),
    ),
    "stiffness of refined": Claim(
        BODIES,
        rf'bias = "{RANGE} % stiffer than finite elements',
        (
            rf"\brefined\b[^|.;]{{0,60}}? {RANGE} % stiffer",
            rf"against CalculiX: stiffness {RANGE} %",
            rf"compared with CalculiX the values are {RANGE} %",
            rf"stiffness, against finite elements \|[^|]*\| {RANGE} % at 1 to 45 kN",
        ),
    ),
    "dynamic capacity over a maker's": Claim(
        "prs/life/rating_life.h",
        r"kCapacityOverMakers = \{([\d.]+), ([\d.]+)\}",
        (rf"(?<!Lemor's )C_a is {RANGE} times", rf"the dynamic capacity is {RANGE} times"),
    ),
}


def documents() -> Iterator[tuple[str, str]]:
    """Names and texts, without breaks of lines; of notebooks their words."""
    listed = ["git", "ls-files", "*.md", "*.ipynb", "*.yaml"]
    names = subprocess.run(listed, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in names.splitlines():
        text = (ROOT / name).read_text(encoding="utf-8")
        if name.endswith(".ipynb"):
            text = "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"])
        yield name, re.sub(r"\s+(?:# )?", " ", text.replace("`", ""))


def faults() -> Iterator[str]:
    texts = dict(documents())
    for what, claim in CLAIMS.items():
        found = re.search(claim.source, (ROOT / claim.file).read_text())
        if not found:
            yield f"{claim.file}: no {claim.source}, which states the {what}"
            continue
        low, high = map(float, found.groups())
        for pattern in claim.texts:
            places = [(name, said) for name in texts for said in re.finditer(pattern, texts[name])]
            if not places:
                yield f"scripts/check_numbers.py: no document has {pattern}"
            for name, said in places:
                if not all(low <= float(each) <= high for each in said.groups()):
                    yield f"{name}: `{said[0]}`; {claim.file} has {low:g} to {high:g} ({what})"


def main() -> int:
    found = list(faults())
    print("\n".join(found), end="\n" if found else "", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
