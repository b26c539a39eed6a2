"""`size`: from a requirement to a list of screws, as the program gives it."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
import rollerscrew as rs
import yaml
from conftest import CONFIGS, Run

PRESS = CONFIGS / "32_press.yaml"
#: An axis that moves 50 kg up and down.
LIFT = {
    "motion": {
        "segments": [
            {"duration": "0.2 s", "end_speed": "300 mm/s", "force": "8 kN"},
            {"duration": "1.8 s", "end_speed": "300 mm/s", "force": "8 kN"},
            {"duration": "0.2 s", "end_speed": "0 mm/s", "force": "8 kN"},
        ]
    },
    "load": {"moved_mass": "50 kg", "inclination": "90 deg"},
    "stroke": "650 mm",
    "candidates": {"designs": {"screw_diameter": ["24 mm", "30 mm"], "lead": "10 mm", "starts": 5}},
}


def test_says_what_the_command_says(program: Run) -> None:
    run = program("size", PRESS, "--json")
    assert run.returncode == 0, run.stderr
    printed = json.loads(run.stdout)["candidates"]
    result = rs.size(PRESS)
    assert [row.name for row in result.candidates] == [row["name"] for row in printed]
    frame = result.to_frame()
    assert list(frame["rank"]) == list(range(1, len(printed) + 1))
    assert list(frame["motor_rms_torque_Nm"]) == [row["motor_rms_torque_Nm"] for row in printed]
    criteria = result.criteria_frame()
    assert set(criteria["status"]) <= {"pass", "fail", "not_computed", "not_applicable", "skipped"}
    assert len(criteria) == sum(len(row["criteria"]) for row in printed)


def test_takes_a_dictionary_and_changes_of_it() -> None:
    result = rs.size(LIFT)
    assert len(result.candidates) == 2
    force = result.requirement.segments[1].axial_force_N
    assert force == pytest.approx(8000.0 + 50.0 * 9.80665, rel=1e-12)
    heavier = rs.size(LIFT, set={"load.moved_mass": "100 kg"})
    assert heavier.requirement.segments[1].axial_force_N == pytest.approx(
        8000.0 + 100.0 * 9.80665, rel=1e-12
    )


def test_a_case_is_no_requirement(tmp_path: Path) -> None:
    with pytest.raises(rs.InputError, match="mechanism"):
        rs.size(CONFIGS / "01_config_1_to_3.yaml")
    with pytest.raises(rs.InputError, match="moved_mas"):
        rs.size({**LIFT, "load": {"moved_mas": "50 kg"}})


def test_requirements_hold_to_their_schema(program: Run) -> None:
    schema = jsonschema.Draft202012Validator(json.loads(program("schema", "requirement").stdout))
    requirements = [f for f in sorted(CONFIGS.glob("*.yaml")) if "\nmotion:" in f.read_text()]
    assert len(requirements) >= 3
    for file in requirements:
        schema.validate(yaml.safe_load(file.read_text()))
    along = {"duration": "0.2 s", "end_speed": "300 mm/s", "force": "8 kN"}
    schema.validate({"motion": {"segments": [along]}})  # One kind of speed, not both.
    assert not schema.is_valid({"motion": {"segments": [{**along, "end_speed": "300 mm"}]}})


#: A lever in every form in which a requirement may state it.
LEVER = {"linkage": {"base": "500 mm", "arm": "300 mm"}}
TURNS = {"duration": "1 s", "end_speed": "30 deg/s", "torque": "600 N m"}
BY_SEGMENTS = {**LEVER, "motion": {"start_angle": "40 deg", "segments": [TURNS]}}
BY_HISTORY = {
    **LEVER,
    "motion": {
        "history": {
            "file": "lever.csv",
            "time": {"unit": "s"},
            "angle": {"unit": "deg"},
            "torque": {"unit": "N m", "column": "M"},
        }
    },
}


def turning(**changes: str) -> dict:
    """The lever by segments, one of them changed."""
    return {**BY_SEGMENTS, "motion": {"start_angle": "40 deg", "segments": [{**TURNS, **changes}]}}


@pytest.mark.parametrize(
    ("requirement", "is_right"),
    [
        (BY_SEGMENTS, True),
        (BY_HISTORY, True),
        (turning(end_speed="5 rpm"), True),
        (turning(end_speed="0.5 rad/s"), True),
        ({**BY_SEGMENTS, "load": {"inertia": "20 kg m^2", "resistance": "50 N"}}, True),
        ({**BY_SEGMENTS, "motion": {**BY_SEGMENTS["motion"], "start_speed": "3 deg/s"}}, True),
        (turning(end_speed="30 deg"), False),
        (turning(torque="600 N"), False),
        (turning(torque="nan N m"), False),
        (turning(duration="0 s"), False),
        ({**BY_SEGMENTS, "linkage": {"base": "500 mm"}}, False),
        ({**BY_SEGMENTS, "linkage": {"base": "0 mm", "arm": "300 mm"}}, False),
        ({**BY_SEGMENTS, "linkage": {"base": "500 mm", "arm": "300 mm", "leg": "1 mm"}}, False),
    ],
)
def test_levers_hold_to_the_schema_as_the_program_reads_them(
    program: Run, tmp_path: Path, requirement: dict, is_right: bool
) -> None:
    schema = jsonschema.Draft202012Validator(json.loads(program("schema", "requirement").stdout))
    assert schema.is_valid(requirement) is is_right
    (tmp_path / "lever.csv").write_text("time,angle,M\n0,60,500\n1,70,500\n")
    file = tmp_path / "need.yaml"
    file.write_text(yaml.safe_dump(requirement))
    assert program("check", file).returncode == (0 if is_right else 2)
