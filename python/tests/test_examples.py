"""The examples run, find what they say, and pass strict type checks."""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import REPOSITORY

EXAMPLES = REPOSITORY / "python" / "examples"
THOROUGH = os.environ.get("PRS_THOROUGH") == "1"


def run(name: str, *arguments: Any) -> Any:
    sys.path.insert(0, str(EXAMPLES))
    try:
        return importlib.import_module(name).main(*arguments)
    finally:
        sys.path.remove(str(EXAMPLES))


def test_every_example_is_run() -> None:
    names = {file.stem for file in EXAMPLES.glob("*.py")}
    text = Path(__file__).read_text(encoding="utf-8")
    assert names and all(f'run("{name}"' in text for name in names)


@pytest.mark.filterwarnings("ignore")  # Those of SALib itself.
def test_indices_by_salib() -> None:
    indices = run("salib_sensitivity", 256 if THOROUGH else 64)
    for by in indices.values():
        assert sum(by.values()) == pytest.approx(1.0, abs=0.1)  # No interactions to speak of.
    pressure = indices["screw.peak_pressure_MPa.max"]
    assert max(pressure, key=pressure.__getitem__) == "load_cases[0].axial_force"


@pytest.mark.filterwarnings("ignore")  # Those of pymoo itself.
def test_a_front_by_pymoo() -> None:
    front = run("pymoo_front", *((20, 40) if THOROUGH else (4, 16)))
    assert len(front) > 2
    assert (np.diff(front[:, 0]) > 0.0).all() and (np.diff(front[:, 1]) > 0.0).all()


def test_an_optimum_by_scipy() -> None:
    best = run("scipy_optimum")
    assert best.success
    force = best.x[1]
    pressure = run("scipy_optimum", 2000.0 * 0.9)
    assert pressure.x[1] < force


def test_many_designs_by_dask() -> None:
    found = run("dask_designs", *(() if THOROUGH else (2000, 500)))
    assert found.loc["count"].item() == (100_000 if THOROUGH else 2000)
    assert 0.0 < found.loc["min"].item() < found.loc["max"].item()


def test_a_fit_finds_the_coefficient() -> None:
    found, deviation = run("friction_fit", 0.08)
    assert abs(found - 0.08) < 3.0 * deviation < 0.02


def test_maps_by_xarray(tmp_path: Path) -> None:
    import xarray

    maps = run("xarray_maps", tmp_path / "maps.nc", 5)
    xarray.testing.assert_identical(xarray.load_dataset(tmp_path / "maps.nc"), maps)


def test_types(tmp_path: Path) -> None:
    """Of the examples; of a careless program those lines that would fail for some cases."""
    careless = tmp_path / "careless.py"
    careless.write_text(
        "import rollerscrew as rs\n"
        "measures = rs.lesson(1).measures().measures\n"
        "print(measures.weight_kg + 1.0)\n"
        "slip = rs.lesson(9).slip()\n"
        "print(slip.load_cases[0].slip.efficiency)\n"
        "print(slip.heat_cycle.time_s)\n",
        encoding="utf-8",
    )
    files = [str(file) for file in sorted(EXAMPLES.glob("*.py"))]
    options = ["--strict", "--config-file=", "--ignore-missing-imports"]
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", *options, *files, str(careless)],
        capture_output=True,
        encoding="utf-8",
        check=False,
        cwd=REPOSITORY,
    )
    lines = [line for line in checked.stdout.splitlines() if ": error: " in line]
    places = [tuple(line.split(":")[:2]) for line in lines]
    assert [(Path(file).name, number) for file, number in places] == [
        ("careless.py", "3"),
        ("careless.py", "5"),
        ("careless.py", "6"),
    ], checked.stdout
