"""The screw in its drive from Python, its unit in a host, and its joint for robot simulators."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import rollerscrew as rs
from conftest import lesson


@pytest.fixture(scope="module")
def case() -> rs.Case:
    return lesson(34)


def test_frame_has_a_row_per_sample(case: rs.Case) -> None:
    result = case.response()
    frame = result.to_frame()
    assert len(frame) == 601
    assert list(frame.columns[:3]) == ["time_s", "position_mm", "speed_mm_per_s"]
    assert frame["force_N"].min() == pytest.approx(
        -result.response["largest"]["compression"]["force_N"], rel=2e-3
    )


@pytest.mark.parametrize("times", [1, 5, 20])
def test_unit_is_the_run(case: rs.Case, times: int, tmp_path: Path) -> None:
    """Of a torque that holds over each step, within 1e-4 of each range."""
    pytest.importorskip("fmpy")
    from fmpy import extract, read_model_description
    from fmpy.fmi2 import FMU2Slave
    from fmpy.validation import validate_fmu

    step = times * 1e-4
    count = round(0.04 / step)
    torque = [4.0 if k * step < 0.02 else -5.0 for k in range(count)]
    held = {"steps": [{"at": "0 s", "value": "4 N m"}, {"at": "20 ms", "value": "-5 N m"}]}
    case = case.with_({"response.motor.torque": held, "response.duration": "40 ms"})
    case.export_fmu(tmp_path / "drive.fmu")
    assert validate_fmu(str(tmp_path / "drive.fmu")) == []
    description = read_model_description(str(tmp_path / "drive.fmu"))
    reference = {v.name: v.valueReference for v in description.modelVariables}
    unit: Any = FMU2Slave(
        guid=description.guid,
        unzipDirectory=extract(str(tmp_path / "drive.fmu"), str(tmp_path / "unit")),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="drive",
    )
    unit.instantiate()
    unit.setupExperiment(startTime=0.0)
    unit.enterInitializationMode()
    unit.setReal([reference["motor_torque"], reference["external_force"]], [torque[0], 50.0])
    unit.exitInitializationMode()
    outputs = [reference[name] for name in ("position", "force", "motor_velocity")]
    rows = [unit.getReal(outputs)]
    state = None
    for k in range(count):
        unit.setReal([reference["motor_torque"]], [torque[k]])
        unit.doStep(k * step, step)
        rows.append(unit.getReal(outputs))
        if k == count // 2:
            state = unit.getFMUstate()
    unit.setFMUstate(state)
    for k in range(count // 2 + 1, count):
        unit.setReal([reference["motor_torque"]], [torque[k]])
        unit.doStep(k * step, step)
        assert unit.getReal(outputs) == rows[k + 1]  # To the bit.
    unit.terminate()
    unit.freeInstance()
    run = case.response().response
    factors = (1e-3, 1.0, np.pi / 30.0)
    for column, key in enumerate(("position_mm", "force_N", "motor_speed_rpm")):
        expected = factors[column] * run[key][::times]
        found = np.array(rows)[:, column]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-4 * np.ptp(expected))


def test_joints_have_the_constants_of_the_drive(tmp_path: Path) -> None:
    case = lesson(35)
    case.export_mjcf(tmp_path / "axis.xml", friction_load=6000.0)
    case.export_urdf(tmp_path / "axis.urdf", friction_load=6000.0)
    joint = ElementTree.parse(tmp_path / "axis.xml").find(".//joint")
    assert joint is not None
    reach = 0.005 / (2.0 * np.pi)
    assert float(joint.attrib["armature"]) == pytest.approx(9.5e-4 / reach**2)
    assert joint.attrib["range"].split() == ["0", "0.0089999999999999993"]
    dynamics = ElementTree.parse(tmp_path / "axis.urdf").find(".//dynamics")
    assert dynamics is not None
    assert dynamics.attrib["friction"] == joint.attrib["frictionloss"]
    with pytest.raises(rs.InputError, match="response"):
        lesson(5).export_mjcf(tmp_path / "none.xml")
