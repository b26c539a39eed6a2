"""The notebooks run, quietly, and the numbers that they print are those that are stored."""

from __future__ import annotations

import difflib
import os
from pathlib import Path
from typing import Any

import pytest

nbclient = pytest.importorskip("nbclient", reason="nbclient is not installed")
nbformat = pytest.importorskip("nbformat", reason="nbformat is not installed")
pytest.importorskip("ipykernel", reason="ipykernel is not installed")
pytest.importorskip("pint", reason="pint is not installed")

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
LARGEST_FILE = 500_000  #: Bytes, pictures included.

#: Of the tools that run notebooks, not of this package: the kernel is another process.
pytestmark = pytest.mark.filterwarnings("ignore")


def read(path: Path) -> Any:
    return nbformat.read(path, as_version=4)


def stream(cell: Any, name: str) -> str:
    outputs = cell.get("outputs", [])
    return "".join(o["text"] for o in outputs if o.output_type == "stream" and o["name"] == name)


def printed(cell: Any) -> str:
    """What a cell shows as text: its stream and its value, without pictures."""
    values = [
        o["data"]["text/plain"]
        for o in cell.get("outputs", [])
        if o.output_type == "execute_result" and "image/png" not in o["data"]
    ]
    return "\n".join([stream(cell, "stdout").rstrip("\n"), *values]).strip()


def is_result(cell: Any) -> bool:
    return "result" in cell.metadata.get("tags", [])


def leave_pictures_out(ipython: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Figures are made and not rendered, which takes half of a notebook's time."""
    profile = ipython / "profile_default"
    profile.mkdir(parents=True)
    (profile / "ipython_kernel_config.py").write_text("c.InlineBackend.figure_formats = set()\n")
    monkeypatch.setenv("IPYTHONDIR", str(ipython))


def executed(path: Path) -> Any:
    """The notebook after a fresh run in its own folder; raises CellExecutionError."""
    notebook = read(path)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = []
    client = nbclient.NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": str(path.parent)}}
    )
    return client.execute()


def test_there_are_notebooks() -> None:
    assert len(NOTEBOOKS) >= 6


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_stored_notebook_is_complete_and_small(path: Path) -> None:
    notebook = read(path)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert [cell.execution_count for cell in code] == list(range(1, len(code) + 1))
    assert not any(cell.metadata.get("execution") for cell in code), "time stamps"
    assert not any(stream(cell, "stderr") for cell in code)
    assert any(is_result(cell) for cell in code)
    assert all(printed(cell) for cell in code if is_result(cell))
    assert path.stat().st_size < LARGEST_FILE


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_fresh_run_is_quiet_and_prints_the_stored_numbers(
    path: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PRS_CACHE_DIR", "")
    if os.environ.get("PRS_THOROUGH") != "1":
        leave_pictures_out(tmp_path, monkeypatch)
    stored = read(path)
    fresh = executed(path)
    for number, (before, after) in enumerate(zip(stored.cells, fresh.cells, strict=True), 1):
        assert not stream(after, "stderr"), f"cell {number}: {stream(after, 'stderr')}"
        if is_result(before):
            assert printed(after) == printed(before), f"cell {number}:\n" + "\n".join(
                difflib.unified_diff(
                    printed(before).splitlines(), printed(after).splitlines(), "stored", "now"
                )
            )
