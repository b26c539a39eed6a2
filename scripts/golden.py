#!/usr/bin/env python3
"""Writes tests/golden/: what every command says of every lesson, in few numbers.

    scripts/golden.py PRS            says which numbers moved, from what to what, and writes the
                                     files of their lessons
    scripts/golden.py PRS --check    says so, writes nothing; ends with status 1 where some moved
    scripts/golden.py PRS 01 14 ..   the same, with or without --check, of some lessons

A file has one line per command. Of a list of numbers stand the first, the greatest and the mean;
records of a long list are taken as one list per quantity. PRS_THOROUGH=1 checks what takes more
than some seconds too.
"""

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests/golden"
SLOW = {("20_map", "study"), ("23_crowning", "optimize")}

#: Who answers and what was asked; the way to a solution and what is left over after it.
LEFT_OUT = {
    "prs_version", "schema_version", "command", "case_file", "input_sha256", "resolved_input",
    "newton_history", "iterations", "relative_residual", "relative_residue", "evaluations",
    "interpolation_error", "axial_error_um", "histogram", "settings", "commands", "input",
    "rounds", "change",
}  # fmt: skip

#: Numbers at the end of an adaptive integration in time or of a search. Processors and their
#: mathematical libraries round differently, which such a way magnifies to its own tolerance.
INTEGRATED = r"^(response\.(?!response\.frequency_response)|fit|optimize|slip\.heat_cycle)"

#: Remainders of a balance of energy, any below the bound as good as another: 1e-6 of the turnover,
#: which the integrator promises (energies close to it at the default tolerance).
RESIDUALS = [
    (r"energy_J\.residual$", r"energy_J\.turnover"),
    (r"energy_J\.residual_relative$", None),
]
RESIDUAL = 1e-6

#: Relative, of a list relative to its greatest number. The engine of live pages agrees with the
#: program to 1e-12, its own mathematical functions included (tests/engine).
TOLERANCES = [
    (INTEGRATED, 1e-6),
    (r"depth", 1e-6),  # Where a curve is flat, its highest point moves by the root of its values.
    (r"", 1e-9),
]

#: Numbers that are small beside others, and those whose greatest is their range: times of events
#: beside the duration, reactions that nearly cancel, friction of contacts that roll (rounding of
#: their loads).
RANGES = [
    (r"^response\..*time_s", r"time_s"),
    (r"reactions\..*force_N", r"reactions\..*force_N"),
    (r"reactions\..*moment_Nm", r"reactions\..*moment_Nm"),
    (r"friction_force_N", r"normal_load_N"),
]

#: Records of a list that is no longer than this stand on their own.
FEW = 2

Leaf = float | bool | str | list[float]


def leaves(x: Any, path: str = "") -> Iterator[tuple[str, float | bool | str]]:
    """Each number, flag and status of a document, lists entry by entry."""
    if isinstance(x, dict):
        for key, value in x.items():
            if key == "warnings":
                yield f"{path}.warnings", len(value)
            elif key not in LEFT_OUT:
                yield from leaves(value, f"{path}.{key}")
    elif isinstance(x, list):
        records = any(isinstance(entry, dict) for entry in x)
        for k, entry in enumerate(x):
            yield from leaves(entry, f"{path}[{k}]" if records and len(x) <= FEW else f"{path}[]")
    elif isinstance(x, bool | int | float) or (path.endswith("status") and x is not None):
        yield path, x


def summary(values: list[Any]) -> Leaf:
    if isinstance(values[0], str):
        return ", ".join(sorted(set(values)))
    if isinstance(values[0], bool):
        return values.count(True)
    return [values[0], max(values, key=abs), sum(values) / len(values)]


def rounded(leaf: Leaf) -> Leaf:
    if isinstance(leaf, list):
        return [rounded(value) for value in leaf]  # type: ignore[misc]
    return float(f"{leaf:.11g}") if isinstance(leaf, float) else leaf


def key_numbers(document: Any) -> dict[str, Leaf]:
    found: dict[str, list[Any]] = {}
    for path, value in leaves(document):
        found.setdefault(path[1:], []).append(value)
    return {
        path: rounded(summary(values) if "[]" in path else values[0])
        for path, values in found.items()
    }


def said(prs: str, *arguments: str) -> str:
    environment = {**os.environ, "PRS_CACHE_DIR": os.environ.get("PRS_CACHE_DIR", "")}
    run = subprocess.run(
        [prs, *arguments], cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    if run.returncode != 0:
        raise SystemExit(f"prs {' '.join(arguments)}: status {run.returncode}: {run.stderr}")
    return run.stdout


def of_lesson(prs: str, lesson: str, slow: bool) -> dict[str, dict[str, Leaf]]:
    """Key numbers by command. What an earlier command said already is not said again."""
    file = f"configs/{lesson}.yaml"
    commands: dict[str, dict[str, Leaf]] = {}
    known: dict[str, Leaf] = {}
    for command in said(prs, "list", "commands", file).split():
        if (lesson, command) in SLOW and not slow:
            continue
        numbers = key_numbers(json.loads(said(prs, command, file, "--json", "--quiet")))
        commands[command] = {k: v for k, v in numbers.items() if k not in known or known[k] != v}
        known |= numbers
    return commands


def text(commands: dict[str, dict[str, Leaf]]) -> str:
    """JSON, one line per command, numbers under what their path begins with."""
    lines = []
    for command, numbers in commands.items():
        groups: dict[str, dict[str, Leaf]] = {}
        for path, leaf in numbers.items():
            place, _, name = path.rpartition(".")
            groups.setdefault(place, {})[name] = leaf
        lines.append(f"{json.dumps(command)}: {json.dumps(groups)}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def read(file: Path) -> dict[str, dict[str, Leaf]]:
    if not file.exists():
        return {}
    return {
        command: {
            f"{place}.{name}".lstrip("."): leaf
            for place, group in groups.items()
            for name, leaf in group.items()
        }
        for command, groups in json.loads(file.read_text()).items()
    }


def greatest(numbers: dict[str, Leaf], pattern: str) -> float:
    """Of the numbers whose path has the pattern."""
    found = [
        x for path, x in numbers.items() if re.search(pattern, path) and not isinstance(x, str)
    ]
    return max(abs(x) for leaf in found for x in (leaf if isinstance(leaf, list) else [leaf]))


def agree(command: str, path: str, old: dict[str, Leaf], new: dict[str, Leaf]) -> bool:
    a, b = old[path], new[path]
    if isinstance(a, str | bool) or isinstance(b, str | bool):
        return a == b
    one, other = (x if isinstance(x, list) else [x] for x in (a, b))
    full = f"{command}.{path}"
    for pattern, whole in RESIDUALS:
        if re.search(pattern, full):
            return abs(other[0]) <= RESIDUAL * (greatest(new, whole) if whole else 1.0)
    tolerance = next(value for pattern, value in TOLERANCES if re.search(pattern, full))
    ranges = [greatest(old, whole) for pattern, whole in RANGES if re.search(pattern, full)]
    bound = tolerance * max(map(abs, [*one, *other, *ranges]))
    return len(one) == len(other) and all(
        abs(x - y) <= bound for x, y in zip(one, other, strict=True)
    )


def moved(golden: dict[str, dict[str, Leaf]], now: dict[str, dict[str, Leaf]]) -> Iterator[str]:
    for command in dict.fromkeys([*golden, *now]):
        old, new = golden.get(command, {}), now.get(command, {})
        for path in dict.fromkeys([*old, *new]):
            if path not in new:
                yield f"{command}: {path}: {old[path]} is gone"
            elif path not in old:
                yield f"{command}: {path}: {new[path]} is new"
            elif not agree(command, path, old, new):
                yield f"{command}: {path}: {old[path]} -> {new[path]}"


def main() -> int:
    prs, *words = sys.argv[1:]
    prs = str(Path(prs).resolve())
    check = "--check" in words
    slow = not check or "PRS_THOROUGH" in os.environ
    chosen = tuple(word for word in words if word != "--check")
    lessons = sorted(file.stem for file in ROOT.glob("configs/*.yaml"))
    lessons = [lesson for lesson in lessons if not chosen or lesson.startswith(chosen)]

    def work(lesson: str) -> tuple[str, dict[str, dict[str, Leaf]]]:
        return lesson, of_lesson(prs, lesson, slow)

    differences = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for lesson, commands in pool.map(work, lessons):
            file = GOLDEN / f"{lesson}.json"
            golden = read(file).items()
            kept = {c: n for c, n in golden if slow or (lesson, c) not in SLOW}
            here = [f"{lesson}: {line}" for line in moved(kept, commands)]
            differences += here if check or kept else []  # Of a new lesson all numbers are new.
            if here and not check:
                GOLDEN.mkdir(exist_ok=True)
                file.write_text(text(commands))
    if not chosen:
        known = {f"{lesson}.json" for lesson in lessons}
        gone = [file for file in sorted(GOLDEN.glob("*.json")) if file.name not in known]
        if check:
            differences += [f"{file.stem}: no such lesson" for file in gone]
        else:
            for file in gone:
                file.unlink()
    for line in differences:
        print(line)
    if differences:
        write = f"`scripts/golden.py {prs}`, and " if check else ""
        print(f"{len(differences)} numbers moved. Where they should: {write}a line in CHANGELOG.md")
    return 1 if check and differences else 0


if __name__ == "__main__":
    sys.exit(main())
