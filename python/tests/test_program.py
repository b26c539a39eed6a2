"""The program that comes with the package, as the console script and as a module."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
import rollerscrew as rs

SCRIPT = [os.path.join(sysconfig.get_path("scripts"), "prs")]
MODULE = [sys.executable, "-m", "rollerscrew"]


def run(command: list[str], *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*command, *arguments], capture_output=True, text=True, cwd=folder, check=False
    )


@pytest.mark.parametrize("command", [SCRIPT, MODULE])
def test_is_of_the_version_of_the_package(command: list[str], tmp_path: Path) -> None:
    assert rs.__version__ in run(command, "--version", folder=tmp_path).stdout


@pytest.mark.parametrize("command", [SCRIPT, MODULE])
def test_arguments_and_exit_status_are_handed_over(command: list[str], tmp_path: Path) -> None:
    (tmp_path / "a case.yaml").write_text("mechanism: {lead: 5}\n")
    asked = run(command, "check", "a case.yaml", folder=tmp_path)
    assert asked.returncode == 2
    assert "a case.yaml:1:19: error: mechanism.lead: got 5" in asked.stderr


def test_brings_its_modules_and_its_data(tmp_path: Path) -> None:
    package = Path(rs.__file__).parent
    assert (package / "lib/prs/prs_tbb.so").is_file()
    assert (package / "share/prs/lessons/01_config_1_to_3.yaml").is_file()
    source = package / "share/prs/validation/sandu_2018"
    validated = run(SCRIPT, "validate", str(source), "--quiet", folder=tmp_path)
    assert (validated.returncode, validated.stderr) == (0, "")
