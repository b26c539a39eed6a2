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
