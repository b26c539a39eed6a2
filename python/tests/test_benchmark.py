"""`benchmark/`: this program is within, a spoiled copy is not, READMEs are enough."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from conftest import REPOSITORY, Run

BENCHMARK = REPOSITORY / "benchmark"
sys.path[:0] = [str(BENCHMARK), str(BENCHMARK / "reference")]
check = import_module("check")
results_page = import_module("results_page")

FOLDERS = sorted(BENCHMARK.glob("[0-9][0-9]_*"))


def run_check(path: Path, *options: str) -> subprocess.CompletedProcess[str]:
    argv = [sys.executable, str(BENCHMARK / "check.py"), str(path), *options]
    return subprocess.run(argv, capture_output=True, text=True)


def expected_as_results(path: Path) -> list[list[str]]:
    rows = [["case", "quantity", "value", "unit"]]
    for folder in FOLDERS:
        with open(folder / "expected.csv", newline="") as file:
            rows += [
                [folder.name[:2], r["quantity"], r["value"], r["unit"]]
                for r in csv.DictReader(file)
            ]
    write(path, rows)
    return rows


def write(path: Path, rows: list[list[str]]) -> None:
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows(rows)


@pytest.fixture(scope="module")
def page(program: Run) -> Any:
    path = program("--version").args[0]
    return results_page.page(path)


def test_all_numbers_of_the_program_are_within(page: Any) -> None:
    _, results = page
    assert list(results) == [folder.name[:2] for folder in FOLDERS]
    for case in results.values():
        row, value, ratio = check.worst(case)
        assert ratio <= 1.0, (case["name"], row, value)


def test_page_of_results_is_what_the_program_gives(page: Any) -> None:
    assert page[0] == (BENCHMARK / "RESULTS.md").read_text()


def test_a_spoiled_copy_is_not_within(tmp_path: Path) -> None:
    path = tmp_path / "results.csv"
    rows = expected_as_results(path)
    assert run_check(path).returncode == 0

    for number in (folder.name[:2] for folder in FOLDERS):
        place = next(i for i, row in enumerate(rows) if row[0] == number)
        with open(next(BENCHMARK.glob(f"{number}_*")) / "expected.csv", newline="") as file:
            uncertainty = float(next(csv.DictReader(file))["uncertainty"])
        spoiled = [list(row) for row in rows]
        spoiled[place][2] = repr(float(rows[place][2]) + 1.5 * uncertainty)
        write(path, spoiled)
        compared = check.compare(check.read_results(path))
        assert [n for n, case in compared.items() if check.worst(case)[2] > 1.0] == [number]
        assert not check.all_within(compared)
    spoiled_run = run_check(path, "--rows", "1", "--picture", str(tmp_path / "d.svg"))
    assert spoiled_run.returncode == 1 and "Not all within" in spoiled_run.stdout
    assert (tmp_path / "d.svg").read_text().startswith("<svg")


def test_what_is_missing_or_unknown_does_not_pass(tmp_path: Path) -> None:
    path = tmp_path / "results.csv"
    rows = expected_as_results(path)
    write(path, rows[:5] + rows[6:])
    assert run_check(path).returncode == 1
    for wrong, message in (
        (["01", "displacement_um", "44.0", "mm"], "must be um"),
        (["01", "displacement", "44.0", "um"], "no quantity displacement"),
        (["01", "displacement_um", "fast", "um"], "not a number"),
        (["17", "displacement_um", "1", "um"], "case 17"),
    ):
        write(path, [rows[0], wrong])
        done = run_check(path)
        assert done.returncode == 2 and message in done.stderr


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: str(folder.name))
def test_case_is_complete(folder: Path) -> None:
    readme = (folder / "README.md").read_text()
    sections = re.findall(r"^## (.*)$", readme, re.MULTILINE)
    assert sections == ["Question", "Given", "Equations", "Asked"]
    assert "![" in readme and "(picture.svg)" in readme
    assert (folder / "picture.svg").stat().st_size < 60_000
    assert (folder / "case.yaml").is_file()
    assert "CC-BY 4.0" in (folder / "SOURCE.md").read_text()
    # What only this program would understand.
    assert not re.search(r"\bprs\b|yaml|rollerscrew", readme)

    with open(folder / "expected.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({row["quantity"] for row in rows}) == len(rows) >= 6
    sources = ("closed form", "two codes", "finite elements", "paper")
    asked = readme[readme.index("## Asked") :]
    for row in rows:
        assert float(row["uncertainty"]) > 0.0 and row["reason"] and row["unit"]
        assert row["source"].startswith(sources)
        name = row["quantity"].split(".")[-1]
        stem = re.split(r"_(?:\d+|screw|nut|rollers?|accelerate|travel|brake)(?:_|$)", name)[0]
        stem = re.sub(r"^real_bodies_.*", "real_bodies_", stem)
        assert stem in asked, row["quantity"]


def test_solvers_and_strangers_use_nothing_of_the_program() -> None:
    for script in [*BENCHMARK.glob("reference/*.py"), *BENCHMARK.glob("strangers/*.py")]:
        assert not re.search(r"rollerscrew|subprocess|\bprs\b", script.read_text()), script
    for script in BENCHMARK.glob("strangers/*.py"):
        imported = set(re.findall(r"^(?:from|import) (\w+)", script.read_text(), re.MULTILINE))
        assert imported <= {"csv", "sys", "math", "numpy", "scipy"}


@pytest.mark.parametrize("number", ["01", "03", "09", "12"])
def test_a_stranger_with_the_readme_alone_is_within(number: str, tmp_path: Path) -> None:
    if number in ("01", "12"):
        pytest.importorskip("scipy")
    script = BENCHMARK / "strangers" / f"case_{number}.py"
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=True)
    path = tmp_path / "results.csv"
    path.write_text(done.stdout)
    checked = run_check(path)
    assert checked.returncode == 0, checked.stdout + checked.stderr


@pytest.mark.parametrize("number", ["01", "02", "09", "12", "20"])
def test_expected_numbers_are_those_of_the_reference(number: str) -> None:
    cases = import_module("cases")
    rows = cases.Rows()
    getattr(cases, f"case_{number}")(rows)
    with open(next(BENCHMARK.glob(f"{number}_*")) / "expected.csv", newline="") as file:
        kept = list(csv.DictReader(file))
    assert [row["quantity"] for row in rows] == [row["quantity"] for row in kept]
    for row, old in zip(rows, kept):
        assert abs(row["value"] - float(old["value"])) <= 0.05 * float(old["uncertainty"])
        assert float(old["uncertainty"]) == pytest.approx(row["uncertainty"], rel=0.01)


def test_reference_agrees_with_a_third_implementation() -> None:
    """Solved by another program, with all rollers; under an axial force these are the sector."""
    kept = REPOSITORY / "tests" / "prs" / "mechanism" / "reference_cases.json"
    (found,) = (
        case["result"]
        for case in json.loads(kept.read_text())["cases"]
        if case["name"] == "symmetric-1-tension"
    )
    cases = import_module("cases")
    sector = cases.sector_a("position_1", "tension")
    sector.position = 0.163 / 3
    result = sector.solve()
    assert 1e6 * result["displacement"] == pytest.approx(found["axial_displacement_um"], rel=1e-10)
    for loads, body in zip(result["normal"], ("screw", "nut")):
        assert loads == pytest.approx(found[body]["normal_load_N"][0], rel=1e-9)
