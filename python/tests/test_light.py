"""The light program (PRS_FULL=OFF): what it computes is what the whole one does; of all else it
says by name that it is not built, and its verdicts are never green over it."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LIGHT = ROOT / "build/light/prs/cli/prs"
NOT_BUILT = "not built; scripts/install.sh builds all"

pytestmark = pytest.mark.skipif(not LIGHT.exists(), reason="needs build/light")


def run(*arguments: str, program: Path = LIGHT) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(program), *arguments], capture_output=True, text=True, cwd=ROOT, check=False
    )


@pytest.mark.parametrize("command", ["contact", "solve", "slip"])
def test_numbers_are_those_of_the_whole_program(command: str) -> None:
    whole = Path(os.environ["PRS_EXECUTABLE"])
    for lesson in ("05_standard_screw", "10_sandu_reference", "01_config_1_to_3"):
        case = next((ROOT / "configs").glob(f"{lesson[:2]}_*.yaml"))
        light = run(command, str(case), "--json")
        other = run(command, str(case), "--json", program=whole)
        assert (light.stdout, light.returncode) == (other.stdout, other.returncode)


@pytest.mark.parametrize(
    "command", ["preload", "life", "measures", "response", "study", "optimize", "fit"]
)
def test_commands_that_are_left_out_say_so(command: str) -> None:
    done = run(command, "configs/14_flight_spectrum.yaml")
    assert done.returncode in (1, 2) and done.stdout == ""
    if done.returncode == 1:
        assert f"prs {command}: {NOT_BUILT}" in done.stderr


def test_commands_without_a_case_say_so() -> None:
    lesson = "configs/05_standard_screw.yaml"
    for arguments in (
        ("size", "configs/32_press.yaml"),
        ("check", "configs/32_press.yaml"),
        ("export", lesson, "--fmu"),
        ("schema", "life"),
        ("report", lesson, "--output", "/tmp/x.html"),
        ("solve", lesson, "--png", "--output", "/tmp/x"),
    ):
        done = run(*arguments)
        assert (done.returncode, done.stdout) == (1, ""), arguments
        assert NOT_BUILT in done.stderr, arguments


@pytest.mark.parametrize(
    "change, what",
    [
        ("model.bodies=influence", "model.bodies: influence"),
        ("model.mechanism=full", "model.mechanism: full"),
    ],
)
def test_bodies_that_are_left_out_are_told_and_not_judged(change: str, what: str) -> None:
    solved = run("solve", "configs/01_config_1_to_3.yaml", "--set", change)
    assert solved.returncode == 1 and f"{what}: {NOT_BUILT}" in solved.stderr
    checked = json.loads(
        run("check", "configs/05_standard_screw.yaml", "--set", change, "--json").stdout
    )
    assert checked["verdict"]["not_built"] == [what]
    assert checked["verdict"]["state"] != "green"
    assert not checked["commands"]["solve"]["ready"]


def test_verdicts_are_amber_at_best() -> None:
    for lesson in sorted((ROOT / "configs").glob("*.yaml")):
        checked = run("check", str(lesson), "--json")
        if checked.returncode == 0 and "verdict" in (document := json.loads(checked.stdout)):
            assert document["verdict"]["not_built"]
            assert document["verdict"]["state"] != "green"


def test_validation_counts_what_it_leaves_out() -> None:
    done = run("validate", "--json")
    assert done.returncode == 0
    sources = {source["name"]: source for source in json.loads(done.stdout)["sources"]}
    assert not sources["abevi_2015"].get("not_computed")
    assert sources["reference_fe"]["not_computed"] == ["bodies: influence"]
    assert sources["jung_2017"]["values"][-1]["verdict"] == "not_computed"
