"""The console script `prs`, apart from `rollerscrew`, whose libraries take long to load."""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from pathlib import Path


def program() -> Path:
    """The program that was installed with the package."""
    package = find_spec("rollerscrew")
    folders = (package and package.submodule_search_locations) or []
    for folder in folders:
        path = Path(folder, "bin", "prs")
        if path.is_file():
            return path
    sys.exit(f"prs: error: no bin/prs in {', '.join(folders)}; install rollerscrew again")


def main() -> None:
    """Becomes the program, with the arguments of this process."""
    os.execv(program(), ["prs", *sys.argv[1:]])
