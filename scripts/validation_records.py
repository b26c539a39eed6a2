#!/usr/bin/env python3
"""Writes docs/validation/, a validation record of each model: validation_records.py PRS [--check]

A record is made from its form (docs/validation/forms/MODEL.yaml), from `prs validate --json`, from
the benchmark and from the names of the tests, so that it cannot drift. With --check nothing is
written; the status is 1 where a record is not what PRS gives. The line with date and commit changes
only when the rest does.
"""

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
import textwrap
from datetime import date
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parent.parent
RECORDS = ROOT / "docs" / "validation"
sys.path.insert(0, str(ROOT / "benchmark"))

import check
import run_prs

MOST_DIGITS = 8  # Beyond, rounding differs between machines.
MARK = "Computed on "

# Pages that say how many statements of a source are compared and how many hold: page, phrase, source, section.
COUNTED = (
    ("docs/slip.md", r"(\d+) statements in words; (\d+)\s+hold", "sandu_2018", "[23].*"),
    ("docs/jung.md", r"checks (\d+) statements [\s\S]*? (\d+) hold", "jung_2017", None),
    (
        "validation/sandu_2018/SOURCE.md",
        r"(\d+) statements, each [\s\S]* other (\d+) hold",
        "sandu_2018",
        None,
    ),
)


def fill(text: str, indent: str = "") -> str:
    return textwrap.fill(
        text, 119, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )


def items(texts: list[str]) -> str:
    return "\n".join(fill(f"- {text}", "  ") for text in texts) + "\n"


def numbered(texts: list[str]) -> str:
    return "".join(fill(f"{n}. {text}", "   ") + "\n" for n, text in enumerate(texts, 1))


def cell(text: object) -> str:
    return str(text).replace("|", "\\|").replace("\n", " ")


def number(value: float) -> str:
    return f"{value:.6g}"


def matches(pattern: str | None, text: str) -> bool:
    return pattern is None or re.fullmatch(pattern, text) is not None


def sources(validation: dict, name: str) -> dict:
    return next(s for s in validation["sources"] if s["name"] == name)


def printed_values(form: dict, validation: dict) -> tuple[str, list[dict]]:
    """The table of printed numbers, and those that differ."""
    lines, differing = "", []
    for wanted in form["examples"].get("values", []):
        source = sources(validation, wanted["source"])
        groups: dict[str, list[dict]] = {}
        for value in source["values"]:
            if matches(wanted.get("case"), value["case"]) and matches(
                wanted.get("quantity"), value["quantity"]
            ):
                groups.setdefault(value["case"], []).append(value)
        if not groups:
            raise SystemExit(f"{form['title']}: {wanted} matches nothing in `prs validate`")
        for case, values in groups.items():
            good = [v for v in values if v["verdict"] == "reproduces"]
            digits = [v["printed_digits"] for v in values]
            span = (
                f"{min(digits)}"
                if min(digits) == max(digits)
                else f"{min(digits)} to {max(digits)}"
            )
            lines += (
                f"| [{wanted['source']}](../../validation/{wanted['source']}/SOURCE.md), {cell(case)} "
                f"| {len(values)} | {span} | {len(good)} |\n"
            )
            differing += [{"source": wanted["source"], **v} for v in values if v not in good]
    if lines:
        lines = (
            "| printed numbers | compared | digits printed | all digits agree |\n"
            "| --- | --- | --- | --- |\n" + lines + "\n"
        )
    return lines, differing


def statements(form: dict, validation: dict) -> tuple[str, list[str]]:
    lines, failing = "", []
    for wanted in form["examples"].get("statements", []):
        found = [
            s
            for s in sources(validation, wanted["source"])["statements"]
            if matches(wanted.get("section"), s["section"])
        ]
        if not found:
            raise SystemExit(f"{form['title']}: {wanted} matches nothing in `prs validate`")
        count = {
            verdict: sum(s["verdict"] == verdict for s in found)
            for verdict in ("holds", "holds only with", "does not hold")
        }
        of = f", {wanted['section']}" if "section" in wanted else ""
        lines += (
            f"| {wanted['source']}{of} | {len(found)} | {count['holds']} "
            f"| {count['holds only with']} | {count['does not hold']} |\n"
        )
        for s in found:
            if s["verdict"] == "does not hold":
                why = s["why"] or s["evidence"]
                failing.append(
                    f'{wanted["source"]}, {s["section"]}, does not hold: "{s["text"]}". {why}'
                )
    if lines:
        lines = (
            "| statements in words | compared | hold | only with | do not |\n"
            "| --- | --- | --- | --- | --- |\n" + lines + "\n"
        )
    return lines, failing


def miscounted(validation: dict) -> list[str]:
    wrong = []
    for page, phrase, source, section in COUNTED:
        found = [
            s for s in sources(validation, source)["statements"] if matches(section, s["section"])
        ]
        right = (len(found), sum(s["verdict"] == "holds" for s in found))
        written = re.search(phrase, (ROOT / page).read_text())
        if not written or tuple(map(int, written.groups())) != right:
            wrong.append(f"{page}: expected {right[0]} statements, of which {right[1]} hold")
    return wrong


def digits_of(row: dict, value: float) -> int:
    expected = float(row["value"])
    scale = abs(expected) or float(row["uncertainty"])
    part = abs(value - expected) / scale
    return MOST_DIGITS if part == 0.0 else min(MOST_DIGITS, max(0, math.floor(-math.log10(part))))


def benchmark_row(number_: str, case: dict) -> str:
    """One case: how many numbers are within, and how many digits agree of the larger half of them. What symmetry makes
    zero has no digits."""
    rows = check.counted(case)
    within = sum(ratio <= 1.0 for _, _, ratio in rows)
    digits = sorted(
        digits_of(row, value) for row, value, _ in rows if abs(float(row["value"])) > 1e-6
    )
    least = "8 or more" if digits[0] == MOST_DIGITS else str(digits[0])
    middle = digits[len(digits) // 2]
    folder = next(check.BENCHMARK.glob(number_ + "_*")).name
    truth = ", ".join(sorted({row["source"].split(":")[0] for row, _, _ in rows}))
    return (
        f"| [{number_} {case['name']}](../../benchmark/{folder}/README.md) | {truth} "
        f"| {within} of {len(rows)} | {least} | {'8 or more' if middle == MOST_DIGITS else middle} |\n"
    )


def of_benchmark(form: dict, results: dict, refined: dict) -> str:
    named = [(n, results[n]) for n in form["examples"].get("benchmark", [])]
    if (n := form["examples"].get("benchmark_refined")) is not None:
        named.append((n, refined[n]))
    if not named:
        return ""
    return (
        "| benchmark | truth | within | digits, least | digits, median |\n"
        "| --- | --- | --- | --- | --- |\n" + "".join(benchmark_row(*each) for each in named) + "\n"
    )


def in_words(name: str) -> str:
    """A test's name as words: AThinRingIsStiff, a thin ring is stiff."""
    parts = re.findall(
        r"\d+[a-z]*[A-Z](?![a-z])|[A-Z]?[a-z]+|[A-Z](?=[A-Z][a-z]|$)|[A-Z]+|\d+", name
    )
    return " ".join(part if part[0].isdigit() else part.lower() for part in parts)


def last_argument(arguments: str) -> str:
    depth, start = 0, 0
    for i, c in enumerate(arguments):
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth == 0:
            start = i + 1
    return arguments[start:]


def tolerance(body: str) -> str:
    """The loosest tolerance that a test's comparisons state, 1e-3 or less."""
    compared_ = re.findall(r"(?:EXPECT|ASSERT)_(?:NEAR|LT|LE)\(([^;]*)\)[^;)]*;", body)
    stated = [
        text
        for c in compared_
        for text in re.findall(r"(?<![\w.])\d(?:\.\d+)?e-\d+", last_argument(c))
    ]
    small = [text for text in stated if float(text) <= 1e-3]
    return f" [{max(small, key=float)}]" if small else ""


def of_tests(form: dict) -> str:
    text = ""
    for name in form["examples"].get("tests", []):
        path = ROOT / name
        found = list(
            re.finditer(r"^TEST(?:_F|_P)?\(\s*\w+,\s*(\w+)\)", path.read_text(), re.MULTILINE)
        )
        if not found:
            raise SystemExit(f"{name}: no tests found")
        ends = [test.start() for test in found[1:]] + [len(path.read_text())]
        sentences = [
            in_words(test[1]) + tolerance(test.string[test.end() : end])
            for test, end in zip(found, ends)
        ]
        count = "1 test" if len(found) == 1 else f"{len(found)} tests"
        item = f"- [{path.name}](../../{name}), {count}: {'; '.join(sentences)}."
        text += fill(item, "  ") + "\n"
    return text


def beyond(form: dict, results: dict, refined: dict) -> list[str]:
    """What of the benchmark is not within."""
    cases = [(n, results[n]) for n in form["examples"].get("benchmark", [])]
    if (n := form["examples"].get("benchmark_refined")) is not None:
        cases.append((n, refined[n]))
    found = []
    for n, case in cases:
        out = sum(ratio > 1.0 for _, _, ratio in check.counted(case))
        if out:
            row, value, ratio = check.worst(case)
            found.append(
                f"Benchmark {n}: {out} of {len(check.counted(case))} numbers are beyond the error bars; the worst is "
                f"`{row['quantity']}`, {number(value)} in place of {number(float(row['value']))} {row['unit']}, "
                f"{ratio:.2g} error bars away."
            )
    return found


def deviations(form: dict, differing: list[dict], failing: list[str], results: dict) -> str:
    text = ""
    if differing:
        reasons = list(dict.fromkeys(v["reason"] for v in differing if v.get("reason")))
        text += "| where | quantity | printed | computed | right | why |\n| --- | --- | --- | --- | --- | --- |\n"
        for v in differing:
            why = f"({reasons.index(v['reason']) + 1})" if v.get("reason") else ""
            right = number(v["corrected"]) if isinstance(v.get("corrected"), (int, float)) else "-"
            text += (
                f"| {v['source']}, {cell(v['where'])} | `{v['quantity']}` | {cell(v['printed'])} "
                f"| {number(v['computed'])} | {right} | {why} |\n"
            )
        text += "\n" + (f"Why:\n\n{numbered(reasons)}\n" if reasons else "")
    rows = ""
    for n in form["examples"].get("information", []):
        for row, value, _ in results[n]["rows"]:
            if row["counts"] == "no":
                real = float(row["value"])
                rows += (
                    f"| {n} {results[n]['name']} | `{row['quantity']}` | {number(real)} | {number(value)} "
                    f"| {round(100 * (value / real - 1), 1) + 0.0:+.1f} % |\n"
                )
    if rows:
        text += (
            "Beams against elastic bodies (CalculiX):\n\n"
            "| case | quantity | finite elements | here | difference |\n| --- | --- | --- | --- | --- |\n"
            + rows
            + "\n"
        )
    if failing:
        text += items(failing) + "\n"
    return text or "None is known among the examples above.\n\n"


def record(form: dict, validation: dict, results: dict, refined: dict) -> str:
    page = form["page"]
    table, differing = printed_values(form, validation)
    said, failing = statements(form, validation)
    failing += beyond(form, results, refined)
    examples = table + said + of_benchmark(form, results, refined)
    return (
        f"# Validation record: {form['title'][0].lower() + form['title'][1:]}\n\n"
        f"Written by `scripts/validation_records.py`; the form is [forms](forms/{form['name']}.yaml).\n\n"
        f"## Purpose\n{fill(form['purpose'])}\n\n"
        f"## Equations\nIn full in [{page}](../{page}).\n\n{items(form['equations'])}\n"
        f"## Range\n{items(form['range'])}\n"
        f"## Reference examples\n{examples or 'No published numbers and no case of the benchmark.' + chr(10) * 2}"
        "## Tests\nWhat is held by tests, whose names are properties; in brackets the loosest tolerance that a\n"
        f"test states, of the quantity that it compares:\n\n{of_tests(form)}\n"
        f"## Deviations\n{deviations(form, differing, failing, results)}"
        f"## Limits of use\n{items(form['limits'])}\n"
    )


def compared(rows: list) -> dict:
    found: dict = {}
    for case, quantity, value, unit in rows:
        found.setdefault(case, {})[quantity] = (value, unit)
    return check.compare(found)


def summary(validation: dict, results: dict) -> str:
    """What was compared with what, in one table: a row per source, and the benchmark."""
    lines = (
        "## Summary\n"
        "What `prs validate` compares, by source. A number *agrees* if all its printed digits do. Of those that do not,\n"
        "`SOURCE.md` says why: a misprint, another sign, an input that was not printed, a theory that does not give it.\n\n"
        "| source | numbers | agree | differ by up to 1 % | by more | sentences | hold | with a condition | do not |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    )
    for source in validation["sources"]:
        name, values = source["name"], source["values"]
        others = [v for v in values if v["verdict"] != "reproduces"]
        near = sum(abs(v["computed"] / float(v["printed"]) - 1.0) <= 0.01 for v in others)
        verdicts = [s["verdict"] for s in source["statements"]]
        counts = [verdicts.count(v) for v in ("holds", "holds only with", "does not hold")]
        row = [
            len(values),
            len(values) - len(others),
            near,
            len(others) - near,
            len(verdicts),
            *counts,
        ]
        lines += f"| [{name}](../../validation/{name}/SOURCE.md) | {' | '.join(map(str, row))} |\n"
    ratios = [ratio for case in results.values() for _, _, ratio in check.counted(case)]
    return lines + (
        f"\nOf the {len(ratios)} numbers of the [benchmark](../../benchmark/README.md), "
        f"{sum(ratio <= 1.0 for ratio in ratios)} are within the\n"
        f"uncertainty that each of them states; the largest deviation is {max(ratios):.2g} of it. Elastic bodies of case 06 are\n"
        "`influence` there; [refined.md](refined.md) has how far `refined` is from them.\n\n"
        "**Not covered.** No measurement is this project's own: efficiencies, temperatures, play and lives are compared\n"
        "with published tests and with makers' catalogues alone. No publication has loads of single threads with all inputs, so\n"
        "those are compared with finite elements of this repository, for an inverted screw of 20 threads and a standard\n"
        "one of 35. Wear and the strength of cages have no model, so there is nothing to compare.\n\n"
    )


# Inputs that a case gets if nobody states them: key, value in words, another value in words and as text, source.
DECIDE = (
    ("model.bodies", "refined; without a `model` bars", "bars", "bars", "[models](../models.md#bodies)"),
    ("structure.roller.guidance", "both ends, without play", "ends with 20 µm of play",
     "{ring: 1e6 N/mm, clearance: 20 um}", "[running.md](../running.md), nothing published"),
    ("structure.nut.thrust.compression", "far face", "near face", "0 mm",
     "[new_case.md](../new_case.md): a nut between housing faces"),
    ("mechanism.profile.roller", "arc of 5 pitches of 1 mm", "of 10", "{convex: 10 mm}",
     "[new_case.md](../new_case.md): static capacities of a catalogue"),
    ("mechanism.contacts_per_roller", "50", "40", "40", "[new_case.md](../new_case.md): lengths of a catalogue"),
    ("mechanism.rollers", "11", "10", "10", "[new_case.md](../new_case.md): as many as fit"),
    ("deviations.pitch_error.screw.linear", "none", "3.8 µm, grade 5", "3.8 um", "ISO 3408-3 for the other value"),
    ("friction.model.coulomb", "0.1", "0.06", "0.06",
     "[new_case.md](../new_case.md): efficiencies of a catalogue"),
    ("carrier.bearing.friction", "mixed", "dry, 0.1", "{coulomb: 0.1}",
     "[new_case.md](../new_case.md): efficiencies of a catalogue"),
    ("lubricant.temperature", "60 °C", "80 °C", "80 degC", "[new_case.md](../new_case.md): assumed, no chart"),
    ("roughness", "0.2 µm", "0.4 µm", "0.4 um", "[new_case.md](../new_case.md): finely ground flanks"),
    ("lubricant.film.direction", "minor axis", "that of rolling", "rolling", "[slip.md](../slip.md): Sandu 2018"),
    ("life.share", "solved", "equal", "equal", "[life.md](../life.md): makers' capacities suppose it"),
    ("life.reliability", "90 %", "95 %", "95 %", "ISO 281"),
)  # fmt: skip
JUDGED = ("stiffness", "static_safety", "life", "efficiency", "film")


def defaults_that_decide(prs: str) -> str:
    """Effects of values that nobody stated, each alone, on the screw of README."""
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "screw.yaml"
        catalogue = ("--screw-diameter", "25mm", "--lead", "5mm")
        subprocess.run([prs, "new", "standard", case, *catalogue], check=True, capture_output=True)

        def judged(*overrides: str) -> list[float]:
            command = [prs, "check", str(case), "--json", *overrides]
            done = subprocess.run(command, check=True, capture_output=True, text=True)
            criteria = {c["name"]: c for c in json.loads(done.stdout)["verdict"]["criteria"]}
            return [criteria[name]["value"] for name in JUDGED]

        base = judged()
        lines = (
            "## Defaults that decide\n"
            "Values that nobody states decide on the numbers of a case. The screw is the one of the README (`prs new\n"
            "standard screw.yaml --screw-diameter 25mm --lead 5mm`); each row changes one value to another plausible one,\n"
            "and gives the effect in percent on the least stiffness and static safety of its load cases, on life,\n"
            f"efficiency and film ratio. By default they are {base[0]:.0f} N/µm, {base[1]:.2f}, {base[2]:.0f} h, "
            f"{100 * base[3]:.1f} % and {base[4]:.2f}.\n\n"
            "| key | taken | here | stiffness | static safety | life | efficiency | film | source of the default |\n"
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
        )
        for key, taken, other, value, source in DECIDE:
            effects = [
                100 * (new / old - 1)
                for new, old in zip(judged("--set", f"{key}={value}"), base, strict=True)
            ]
            cells = ["0" if abs(effect) < 0.5 else f"{effect:+.0f}" for effect in effects]
            lines += f"| `{key}` | {taken} | {other} | {' | '.join(cells)} | {source} |\n"
    return lines + "\n"


def index(forms: list[dict], table: str) -> str:
    lines = (
        "# Validation records\n\n"
        "One page for each model: purpose, equations, range, reference examples with digits of agreement, tests,\n"
        "deviations, limits of use, date and commit. `scripts/validation_records.py` writes them from forms, from\n"
        "`prs validate`, from the [benchmark](../../benchmark/README.md) and from the tests; `scripts/lint.sh` checks that\n"
        "they are what the program gives. Each names the page that explains its model.\n\n"
    )
    return (
        lines
        + table
        + "## Models\n"
        + items(
            [
                f"[{f['title']}]({f['name']}.md), of [{f['page']}](../{f['page']}): {f['purpose']}"
                for f in forms
            ]
        )
    )


def without_mark(text: str) -> str:
    return "\n".join(line for line in text.splitlines() if not line.startswith(MARK))


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("prs")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    done = subprocess.run(
        [given.prs, "validate", "--json", "--quiet"], capture_output=True, text=True
    )
    validation = json.loads(done.stdout)
    results = compared(run_prs.results(given.prs))
    refined = compared(run_prs.results(given.prs, ["06"], "refined"))
    commit = subprocess.run(
        ["git", "rev-parse", "--short=10", "HEAD"], cwd=ROOT, capture_output=True, text=True
    ).stdout.strip()

    forms = [
        {**yaml.safe_load(path.read_text()), "name": path.stem}
        for path in sorted((RECORDS / "forms").glob("*.yaml"))
    ]
    pages = {form["name"]: record(form, validation, results, refined) for form in forms}
    pages["README"] = index(forms, summary(validation, results) + defaults_that_decide(given.prs))
    stale = [path for path in RECORDS.glob("*.md") if path.stem not in pages]
    for name, text in pages.items():
        path = RECORDS / f"{name}.md"
        kept = path.read_text() if path.is_file() else ""
        if name != "README":
            text += (
                f"\n{MARK}{date.today()} with `prs` {validation['prs_version']}, commit {commit}.\n"
            )
            text = text.replace("\n\n\n", "\n\n")
        if without_mark(kept).rstrip() == without_mark(text).rstrip():
            continue
        if given.check:
            stale.append(path)
        else:
            path.write_text(text)
    for path in stale:
        print(f"{path.relative_to(ROOT)} is not what the program gives", file=sys.stderr)
    if stale:
        print(
            "scripts/validation_records.py PRS writes the records; delete what has no form",
            file=sys.stderr,
        )
    wrong = miscounted(validation)
    print(*wrong, sep="\n", end="\n" if wrong else "", file=sys.stderr)
    return 1 if stale or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
