"""What `cmake --install` writes: moved, used, and built upon by other projects; and how its program
is guarded against hostile files."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/release"

pytestmark = pytest.mark.skipif(
    not (BUILD / "CMakeCache.txt").exists(), reason="needs build/release"
)


def run(*command: str | Path) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The prefix after it was moved."""
    folder = tmp_path_factory.mktemp("package")
    for component in ("program", "development"):
        run("cmake", "--install", BUILD, "--prefix", folder / "first", "--component", component)
    return (folder / "first").rename(folder / "an installed prs")


def build(source: Path, prefix: Path, folder: Path) -> None:
    run(
        "cmake",
        "-S",
        source,
        "-B",
        folder,
        "-G",
        "Ninja",
        "-DCMAKE_CXX_FLAGS=-O0",
        f"-DCMAKE_PREFIX_PATH={prefix}",
    )
    run("cmake", "--build", folder)


@pytest.mark.xdist_group("package")
def test_programs_find_their_data_wherever_they_are_moved(installed: Path, tmp_path: Path) -> None:
    prs = installed / "bin/prs"
    validated = json.loads(
        run(prs, "validate", installed / "share/prs/validation/sandu_2018", "--json")
    )
    assert [source["name"] for source in validated["sources"]] == ["sandu_2018"]
    lesson = tmp_path / "lesson.yaml"
    run(prs, "new", "--lesson", "14", lesson)
    assert "life" in run(prs, "list", "commands", lesson)


@pytest.mark.xdist_group("package")
@pytest.mark.parametrize(
    "text",
    [
        "man/man1/prs.1.gz",
        "man/man1/prs-solve.1.gz",
        "bash-completion/completions/prs",
    ],
)
def test_manual_and_completions_are_there(installed: Path, text: str) -> None:
    assert (installed / "share" / text).stat().st_size > 0


@pytest.mark.xdist_group("package")
def test_another_project_solves_what_the_program_solves(installed: Path, tmp_path: Path) -> None:
    headers = sorted((installed / "include/prs").glob("*.h"))
    assert len(headers) > 5
    folder = tmp_path / "build"
    folder.mkdir()
    (folder / "all_headers.h").write_text("".join(f'#include "prs/{h.name}"\n' for h in headers))
    build(ROOT / "tests/package", installed, folder)
    case = ROOT / "configs/01_config_1_to_3.yaml"
    by_library = json.loads(run(folder / "package", case))
    by_program = json.loads(run(installed / "bin/prs", "solve", case, "--json"))
    assert by_library["load_cases"] == by_program["load_cases"]


@pytest.mark.xdist_group("package")
def test_examples_print_what_their_last_lines_say(installed: Path, tmp_path: Path) -> None:
    build(ROOT / "examples", installed, tmp_path)
    lesson = installed / "share/prs/lessons/05_standard_screw.yaml"
    for source in sorted((ROOT / "examples").glob("*.cpp")):
        lines = run(tmp_path / source.stem, lesson).rstrip("\n").split("\n")
        printed = "\n".join(f"//     {line}".rstrip() for line in lines)
        assert f"\n// Prints:\n//\n{printed}" in source.read_text()


@pytest.mark.skipif(not shutil.which("readelf"), reason="needs readelf")
def test_the_program_is_guarded() -> None:
    """Addresses of chance, tables of addresses that are written once, checks of returns, sizes."""
    flags = ("--file-header", "--program-headers", "--dynamic", "--dyn-syms")
    text = run("readelf", "--wide", *flags, BUILD / "prs/cli/prs")
    for guard in (
        "Type: +DYN", "GNU_RELRO", "BIND_NOW|FLAGS_1.*NOW", "__stack_chk_fail", "__[a-z]+_chk@",
    ):  # fmt: skip
        assert re.search(guard, text), guard


def test_bill_of_materials_names_the_libraries() -> None:
    bill = json.loads(run(sys.executable, ROOT / "scripts/sbom.py", BUILD))
    names = {component["name"] for component in bill["components"]}
    for library in ("boost", "cli11", "csv", "eigen3", "fmt", "nettle", "nlohmann-json", "spectra",
                    "suitesparse|cholmod", "xsimd", "yaml-cpp"):  # fmt: skip
        assert any(re.match(f"(lib)?({library})", name) for name in names), library
