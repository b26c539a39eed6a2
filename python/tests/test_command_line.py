"""The package answers as the command line program does, byte for byte."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import rollerscrew as rs
from conftest import CONFIGS, REPOSITORY, Run, answer, lesson, lesson_commands


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_documents_are_those_of_the_program(stem: str, command: str, program: Run) -> None:
    run = program(command, CONFIGS / f"{stem}.yaml", "--json", "--quiet")
    assert run.returncode in (0, 3), run.stderr
    assert answer(stem, command).to_json() == run.stdout


OVERRIDES: list[tuple[int, str, dict[str, Any]]] = [
    (1, "solve", {"mechanism.rollers": 9}),
    (1, "solve", {"mechanism.rollers": "9", "load_cases[0].axial_force": "30 kN"}),
    (1, "solve", {"model.bodies": "refined"}),
    (1, "solve", {"load_cases[2]": {"name": "x", "axial_force": "1 kN", "share": "equal"}}),
    (1, "contact", {"mechanism.profile.roller": {"convex": "5 mm"}}),
    (1, "check", {"mechanism.flank_angle": "50 deg"}),
    (3, "solve", {"load_cases[0].axial_force": {"from": "1 kN", "to": "9 kN", "steps": 3}}),
    (9, "slip", {"operation.speed": "100 rpm", "friction": {"coulomb": 0.11}}),
    (9, "slip", {"lubricant.temperature": "80 degC"}),
    (12, "preload", {"mechanism.rollers": 8}),
    (14, "life", {"mechanism.rollers": 8}),
    (18, "measures", {"materials.density": "7.7 g/cm^3"}),
    (17, "study", {"mechanism.rollers": 10}),
    (10, "study", {"study.factors[0].values": ["21 mm", "22 mm"]}),
    (22, "optimize", {"optimize.seed": 2, "optimize.generations": 3}),
]


@pytest.mark.parametrize(("number", "command", "values"), OVERRIDES)
def test_with_is_set(number: int, command: str, values: dict[str, Any], program: Run) -> None:
    case = lesson(number).with_(**values)
    sets = [argument for text in case.overrides for argument in ("--set", text)]
    run = program(command, case.name, "--json", "--quiet", *sets)
    assert run.returncode in (0, 3), run.stderr
    assert getattr(case, command)().to_json() == run.stdout

    at_once = rs.Case.from_yaml(case.name, set=values)
    assert at_once == case
    assert getattr(at_once, command)().to_json() == run.stdout


def test_with_adds_up(program: Run) -> None:
    case = lesson(1).with_(**{"mechanism.rollers": 9}).with_(**{"mechanism.rollers": 10})
    run = program(
        "solve",
        case.name,
        "--json",
        "--set",
        "mechanism.rollers=9",
        "--set",
        "mechanism.rollers=10",
    )
    assert case.solve().to_json() == run.stdout


def test_schema_and_version_are_those_of_the_program(program: Run) -> None:
    from rollerscrew import _engine

    assert _engine.schema().strip() == program("schema").stdout.strip()
    assert rs.__version__ in program("--version").stdout


#: Wrong overrides of lesson 1 and the command that notices.
WRONG_OVERRIDES: list[tuple[str, str, str]] = [
    ("check", "mechanism.rollers", "0"),
    ("check", "mechanism.rollers", "13"),
    ("check", "mechanism.rollers", "nine"),
    ("check", "mechanism.rolers", "9"),
    ("check", "mechanism.lead", "5"),
    ("check", "mechanism.lead", "5 kN"),
    ("check", "mechanism.lead", "5 bananas"),
    ("check", "mechanism.lead", "1e99 mm"),
    ("check", "mechanism.lead", ""),
    ("check", "mechanism..lead", "5 mm"),
    ("check", "load_cases[9].axial_force", "5 kN"),
    ("check", "load_cases[0].axial_force", "-5 kN"),
    ("check", "load_cases[0].name", "config2-tension"),
    ("check", "materials", "[1, 2"),
    ("check", "materials", "{poisson_ratio: 0.7}"),
    ("check", "mechanism.profile.roller", "{convex: -1 mm}"),
    ("solve", "structure", "null"),
    ("contact", "mechanism.centre_distance", "20 mm"),
    ("study", "study", "{command: solve, factors: []}"),
    ("study", "study", "{command: fly, factors: [{path: mechanism.rollers, values: [9]}]}"),
    (
        "study",
        "study",
        "{command: solve, factors: [{path: mechanism.rollers, values: [9]}], responses: [nope]}",
    ),
    ("study", "study", "{command: solve, factors: [{path: mechanism.nope, values: [9]}]}"),
    ("optimize", "optimize", "{command: contact}"),
]


@pytest.mark.parametrize(("command", "path", "value"), WRONG_OVERRIDES)
def test_wrong_overrides_read_as_the_program_says(
    command: str, path: str, value: str, program: Run
) -> None:
    name = lesson(1).name
    run = program(command, name, "--json", "--set", f"{path}={value}")
    assert (run.returncode, run.stdout) == (2, "")
    with pytest.raises(rs.InputError) as raised:
        getattr(lesson(1).with_(**{path: value}), command)()
    assert str(raised.value) == run.stderr.removesuffix("\n")
    assert isinstance(raised.value, ValueError)


@pytest.mark.parametrize("command", ["slip", "preload", "life", "study", "optimize"])
def test_missing_blocks_read_as_the_program_says(command: str, program: Run) -> None:
    run = program(command, lesson(1).name, "--json")
    assert run.returncode == 2
    with pytest.raises(rs.InputError) as raised:
        getattr(lesson(1), command)()
    assert str(raised.value) == run.stderr.removesuffix("\n")


WRONG_FILES: dict[str, str | bytes] = {
    "empty": "",
    "only a comment": "# nothing\n",
    "a text": "nothing here",
    "a list": "- 1\n- 2\n",
    "broken": "mechanism: {type: inverted\n",
    "tabs": "mechanism:\n\ttype: inverted\n",
    "anchors": "a: *nowhere\n",
    "duplicate keys": "mechanism:\n  lead: 5 mm\n  lead: 6 mm\n",
    "duplicate blocks": "mechanism: {}\nmechanism: {}\n",
    "unknown block": "mechanisms: {}\n",
    "deep": "a: " + "[" * 20_000,
    "control characters": "mechanism: {type: \x01}\n",
    "many mistakes": "mechanism: {type: odd, lead: 5, rollers: -1}\nload_cases: 3\n",
    "no UTF-8": b"mechanism: {type: \xff\xfe}\n",
    "UTF-16": "mechanism: {}\n".encode("utf-16"),
}


@pytest.mark.parametrize("name", WRONG_FILES)
def test_wrong_files_read_as_the_program_says(name: str, program: Run, tmp_path: Path) -> None:
    file = tmp_path / "case.yaml"
    content = WRONG_FILES[name]
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    run = program("check", file, "--json")
    assert (run.returncode, run.stdout) == (2, "")
    with pytest.raises(rs.InputError) as raised:
        rs.Case.from_yaml(file)
    assert str(raised.value) == run.stderr.removesuffix("\n")


def test_line_ends_of_old_macs_are_line_ends(program: Run, tmp_path: Path) -> None:
    file = tmp_path / "case.yaml"
    file.write_bytes(lesson(1).text.replace("\n", "\r").encode())
    assert program("check", file, "--quiet").returncode == 0
    assert rs.Case.from_yaml(file).text == lesson(1).text


@pytest.mark.parametrize("name", ["nothing.yaml", ".", "folder/nothing.yaml", "huge.yaml"])
def test_unreadable_files_read_as_the_program_says(name: str, program: Run, tmp_path: Path) -> None:
    (tmp_path / "huge.yaml").write_text("# " + "x" * (2 << 20))
    run = program("check", tmp_path / name, "--json")
    assert run.returncode == 2
    with pytest.raises(rs.InputError) as raised:
        rs.Case.from_yaml(tmp_path / name)
    assert str(raised.value) == run.stderr.removesuffix("\n")


def test_names_of_files_stand_as_they_were_given(
    program: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(REPOSITORY)
    name = "configs/../configs/01_config_1_to_3.yaml"
    case = rs.Case.from_yaml(name)
    assert case.name == name
    with pytest.raises(rs.InputError) as raised:
        case.slip()
    assert str(raised.value) == program("slip", name).stderr.removesuffix("\n")
