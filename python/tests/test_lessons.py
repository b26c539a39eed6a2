"""Each lesson with every command for which its file has all that it needs, files and report too."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LESSONS = sorted((ROOT / "configs").glob("*.yaml"))


def run(*arguments: str | Path) -> str:
    command = [os.environ.get("PRS_EXECUTABLE", "prs"), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stderr}"
    return done.stdout


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda path: path.stem)
def test_every_command_of_a_lesson_writes_its_files(lesson: Path, tmp_path: Path) -> None:
    commands = run("list", "commands", lesson).split()
    assert commands
    for command in commands:
        run(command, lesson, "--quiet", "--output", tmp_path)
    run("report", lesson, "--quiet", "--output", tmp_path / "report.html")
    assert len(list(tmp_path.iterdir())) > len(commands)
