"""Fixtures of all tests: the lessons in `configs/`, and the program that they are compared with."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import pytest

# Matrices of earlier runs, on disk, are left alone; set before the engine is loaded.
os.environ.setdefault("PRS_CACHE_DIR", "")

import rollerscrew as rs

REPOSITORY = Path(__file__).resolve().parents[2]
CONFIGS = REPOSITORY / "configs"

#: What takes more than some seconds.
SLOW = {("23_crowning", "optimize")}

Run = Callable[..., "subprocess.CompletedProcess[str]"]


def lessons() -> list[Path]:
    """Those that are cases."""
    return sorted(file for file in CONFIGS.glob("*.yaml") if "\nmotion:" not in file.read_text())


def commands(file: Path) -> list[str]:
    """The commands that a file has all for."""
    return [command for command, state in lesson(file.stem).check().commands.items() if state.ready]


def lesson_commands() -> list[Any]:
    """Parameters: every lesson with every command that it is for."""
    return [
        pytest.param(
            file.stem,
            command,
            id=f"{file.stem}-{command}",
            marks=[pytest.mark.thorough] if (file.stem, command) in SLOW else [],
        )
        for file in lessons()
        for command in commands(file)
    ]


@cache
def lesson(number_or_stem: int | str) -> rs.Case:
    """The case of a lesson, by its number or the name of its file."""
    if isinstance(number_or_stem, int):
        (file,) = CONFIGS.glob(f"{number_or_stem:02d}_*.yaml")
    else:
        file = CONFIGS / f"{number_or_stem}.yaml"
    return rs.Case.from_yaml(file)


@cache
def _answer(number_or_stem: int | str, command: str) -> rs.Result:
    return getattr(lesson(number_or_stem), command)()  # type: ignore[no-any-return]


R = TypeVar("R", bound=rs.Result)


def answer(number_or_stem: int | str, command: str, kind: type[R] = rs.Result) -> R:  # type: ignore[assignment]
    """What a command answers for a lesson, which is of some kind."""
    result = _answer(number_or_stem, command)
    assert isinstance(result, kind)
    return result


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "thorough: takes long; runs where PRS_THOROUGH=1 is set")
    config.addinivalue_line("markers", "xdist_group(name): run by one process (pytest-xdist)")


#: Files that ask for the answers to every command of every lesson: one process computes them once.
OF_ALL_ANSWERS = {"test_command_line", "test_frames", "test_kept", "test_record", "test_results"}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        file = item.path.stem
        item.add_marker(pytest.mark.xdist_group("answers" if file in OF_ALL_ANSWERS else file))
    if os.environ.get("PRS_THOROUGH") == "1":
        return
    for item in items:
        if item.get_closest_marker("thorough"):
            item.add_marker(pytest.mark.skip(reason="set PRS_THOROUGH=1"))


@pytest.fixture(scope="session")
def configs() -> Path:
    """The folder of the lessons."""
    return CONFIGS


@pytest.fixture(scope="session")
def program() -> Run:
    """Runs the command line program with some arguments."""
    built = REPOSITORY / "build" / "release" / "prs" / "cli" / "prs"
    path = os.environ.get("PRS_EXECUTABLE") or (str(built) if built.is_file() else None)
    path = path or shutil.which("prs")
    if path is None:
        pytest.skip("no program: build it, or set PRS_EXECUTABLE")

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [path, *map(str, arguments)],
            capture_output=True,
            encoding="utf-8",
            timeout=300,
            check=False,
        )

    return run


@pytest.fixture(scope="session")
def written(
    program: Run, configs: Path, tmp_path_factory: pytest.TempPathFactory
) -> Callable[[int, str], Path]:
    """The folder with the files that the program writes of a lesson, all digits in CSV."""

    @cache
    def write(number: int, command: str) -> Path:
        (file,) = configs.glob(f"{number:02d}_*.yaml")
        folder = tmp_path_factory.mktemp(f"{file.stem}_{command}")
        run = program(command, file, "--output", folder, "--quiet", "--csv-digits", 17)
        assert run.returncode in (0, 3), run.stderr
        return folder

    return write
