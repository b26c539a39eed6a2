"""The tutorials in `docs/` and the five first lessons: commands print what the pages show."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import REPOSITORY, Run

BLOCK = re.compile(r"^```(sh|python|text)\n(.*?)^```$", re.M | re.S)


@pytest.mark.parametrize(
    "page", sorted((REPOSITORY / "docs").glob("tutorial_*.md")), ids=lambda page: page.stem
)
def test_commands_of_a_tutorial_print_what_it_shows(page: Path, tmp_path: Path) -> None:
    program = Path(os.environ.get("PRS_EXECUTABLE", REPOSITORY / "build/release/prs/cli/prs"))
    environment = {
        **os.environ,
        "PATH": f"{program.parent}:{os.environ['PATH']}",
        "MPLBACKEND": "Agg",
    }
    shells = {"sh": ["bash", "-euc"], "python": [sys.executable, "-c"]}
    blocks = BLOCK.findall(page.read_text())
    assert {language for language, _ in blocks} >= {"sh", "text"}
    printed = ""
    for language, text in blocks:
        if language == "text":
            assert set(text.splitlines()) <= set(printed.splitlines())
            continue
        done = subprocess.run(
            [*shells[language], text],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        printed += done.stdout


def test_first_lessons_print_the_numbers_of_their_page(program: Run) -> None:
    page = (REPOSITORY / "docs/lessons.md").read_text()
    rows = re.findall(r"^\| \d+, [^|]*\| `prs ([^`]*)` \| ([^|]*) \|", page, re.M)
    assert len(rows) == 5
    for command, seen in rows:
        verb, case = command.split()
        printed = program(verb, REPOSITORY / case).stdout
        for number in re.findall(r"\d+\.\d+|\d+,\d{3}", seen):
            assert number.replace(",", "") in printed, (command, number)


def test_the_own_screw_of_the_readme_has_its_numbers(program: Run, tmp_path: Path) -> None:
    page = (REPOSITORY / "README.md").read_text()
    section = page[page.index("## Your own screw") : page.index("`prs explore")]
    (new,) = re.findall(r"prs (new standard screw.yaml .*)", section)
    case = tmp_path / "screw.yaml"
    program(*new.replace("screw.yaml", str(case)).split())
    printed = {verb: program(verb, case).stdout for verb in ("solve", "slip", "life")}
    (table,) = re.findall(r"`prs solve` prints\n\n((?:    .*\n)+)", section)
    lines = {line.strip() for line in printed["solve"].splitlines()}
    assert {line.strip() for line in table.splitlines()} <= lines

    stated = re.search(
        r"efficiency of ([\d.]+) % in tension and ([\d.]+) kW .*"
        r"life of ([\d.]+) million .* is (\d+) h",
        " ".join(section.split()),
    )
    assert stated
    for text, verb, row, unit in (
        (stated[1], "slip", r"efficiency, % +([\d.]+)", 1.0),
        (stated[2], "slip", r"power lost, W +([\d.]+)", 1000.0),
        (stated[3], "life", r"mechanism, real thread loads +([\d.]+)", 1.0),
        (stated[4], "life", r"mechanism, real thread loads +[\d.]+ +([\d.]+)", 1.0),
    ):
        found = re.search(row, printed[verb])
        assert found
        half = 0.5 * 10.0 ** -len(text.partition(".")[2])
        assert float(found[1]) / unit == pytest.approx(float(text), abs=1.001 * half, rel=0.0)
