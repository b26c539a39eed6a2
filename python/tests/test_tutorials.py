"""The tutorials in `docs/`: their commands run as printed, and print what the pages show."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(sh|python|text)\n(.*?)^```$", re.M | re.S)


@pytest.mark.parametrize(
    "page", sorted((ROOT / "docs").glob("tutorial_*.md")), ids=lambda page: page.stem
)
def test_commands_of_a_tutorial_print_what_it_shows(page: Path, tmp_path: Path) -> None:
    program = Path(os.environ.get("PRS_EXECUTABLE", ROOT / "build/release/prs/cli/prs"))
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
