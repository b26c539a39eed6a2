"""Why a response is not there: what is said helps when it is followed."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, lesson
from rollerscrew.reasons import COMMANDS

QUICK = (9, 15, 37)
LESSONS = sorted(file for file in CONFIGS.glob("*.yaml") if "\nmechanism:" in file.read_text())


def stands(case: rs.Case, needed: str) -> bool:
    """Whether the case has an input that a reason calls missing."""
    path, _, value = needed.partition(": ")
    found = path in case or re.sub(r"(materials)\.\w+\.", r"\1.", path) in case
    return found and value in ("", case[path])


@pytest.mark.parametrize(
    "file",
    [
        pytest.param(
            file,
            id=file.stem,
            marks=[] if int(file.stem[:2]) in QUICK else [pytest.mark.thorough],
        )
        for file in LESSONS
    ],
)
def test_each_reason_names_a_command_that_answers_or_an_input_that_is_missing(file: Path) -> None:
    case = rs.Case.from_yaml(file)
    ready = case.check().commands
    frames = {
        command: case.responses(command)  # type: ignore[arg-type]
        for command in COMMANDS
        if command != "preload" and ready[command]["ready"]
    }
    defined = {command: set(f["path"][f["defined"]]) for command, f in frames.items()}
    missing: dict[str, bool] = {}
    for command, frame in frames.items():
        for path, reason in zip(frame["path"], frame["needs"], strict=True):
            said = f"{command} {path}: {reason}"
            if path in defined[command]:
                assert reason == "", said
                continue
            other = re.search(r'write command="(\w+)"$', reason)
            inputs = re.findall(r"`([^`]+)`", reason) if reason.startswith("needs ") else []
            for needed in inputs:
                if needed not in missing:
                    missing[needed] = needed in ready[command].get("wrong", []) or not stands(
                        case, needed
                    )
                assert missing[needed], said
            if other and not inputs and not reason.startswith("absent, "):
                assert path in defined[other[1]], said
            else:
                assert inputs or reason.startswith("absent, "), said


N = {"mechanism.rollers": [8, 9]}


def test_a_reason_names_the_command() -> None:
    own = rs.new("standard", screw_diameter="25 mm", lead="5 mm")
    for path, command in (
        ("life.system.l10_hours", "life"),
        ("load_cases[0].slip.viscosity_mPas", "slip"),
        ("axial_stiffness_N_per_um", "solve"),
    ):
        asked = "life" if command != "life" else "solve"
        with pytest.raises(
            rs.InputError, match=f'got {re.escape(path)}; write command="{command}"$'
        ):
            own.evaluate(N, [path], command=asked)  # type: ignore[arg-type]
        answers = own.evaluate(N, [path], command=command)  # type: ignore[arg-type]
        assert np.isfinite(answers.values).all()
    with pytest.raises(rs.InputError, match='weight_kg; write command="measures"$'):
        own.function(["load_cases[0].axial_force"], ["measures.weight_kg"], command="life")
    with pytest.raises(rs.InputError, match='write command="solve"$'):
        lesson(12).evaluate(N, ["axial_stiffness_N_per_um"], command="preload")
    with pytest.raises(rs.InputError, match='write command="preload"$'):
        lesson(12).evaluate(N, ["preload.lost_motion_um"])


def test_a_reason_names_the_input() -> None:
    with pytest.raises(
        rs.InputError, match=r"needs `structure` and `load_cases\[0\].share: solved`"
    ):
        lesson(15).evaluate(N, ["measures.largest_load_rate_percent"], command="measures")
    with pytest.raises(rs.InputError, match=r"per_um; needs `structure` and "):
        lesson(15).evaluate(N, ["axial_stiffness_N_per_um"])
    needs = lesson(37).responses("measures").set_index("path")["needs"]
    assert needs["measures.critical_speed_rpm"] == "needs `measures.shaft`"
    assert needs["life.system.l10_hours"] == 'needs `life`; write command="life"'


def test_places_that_are_none_say_how_many_there_are() -> None:
    for place in ("9", "foo"):
        with pytest.raises(rs.InputError, match="expected one of the 6 load cases, from 0: conf"):
            lesson(1).evaluate(N, [f"load_cases[{place}].axial_stiffness_N_per_um"])
    with pytest.raises(rs.InputError, match=r"load_rate_percent\[99\]; expected an entry .* 20;"):
        lesson(1).evaluate(N, ["screw.load_rate_percent[99]"])
    with pytest.raises(rs.InputError, match="a row for each roller; expected a number or one row"):
        lesson(33).evaluate(N, ["screw.load_rate_percent"])
