"""The screw in its drive from Python, its unit in a host, and its joint for robot simulators."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, lesson


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


RPM = np.pi / 30.0
#: Outputs of the unit, the series of the run that they are, and the factor to SI.
OUTPUTS = {
    "position": ("position_mm", 1e-3),
    "velocity": ("speed_mm_per_s", 1e-3),
    "force": ("force_N", 1.0),
    "deflection": ("deflection_um", 1e-6),
    "motor_angle": ("motor_angle_deg", np.pi / 180.0),
    "motor_velocity": ("motor_speed_rpm", RPM),
    "screw_angle": ("screw_angle_deg", np.pi / 180.0),
    "screw_velocity": ("screw_speed_rpm", RPM),
    "coupling_torque": ("coupling_torque_Nm", 1.0),
}


@dataclass(frozen=True)
class Duty:
    """A lesson whose inputs hold for `hold` seconds each, and the signals that say the same."""

    lesson: int
    duration: float
    hold: float
    inputs: Callable[[float], dict[str, float]]
    signals: Callable[[Duty], dict[str, Any]]

    def steps(self, value: Callable[[float], str]) -> dict[str, Any]:
        times = [k * self.hold for k in range(round(self.duration / self.hold))]
        return {"steps": [{"at": f"{t:.9g} s", "value": value(t)} for t in times]}


def _reversal(t: float) -> dict[str, float]:
    torque = np.interp(t, [0.0, 5e-3, 20e-3, 28e-3], [0.0, 4.0, 4.0, -5.0])
    return {"motor_torque": float(torque), "external_force": 50.0}


def _servo(t: float) -> dict[str, float]:
    moves = t < 0.04 - 1e-9
    return {
        "reference": 0.04 * t if moves else 1.6e-3,
        "reference_speed": 0.04 if moves else 0.0,
        "external_force": 1500.0 if t > 0.09 - 1e-9 else 0.0,
    }


def _led(t: float) -> str:
    """A speed that is fed forward is a reference that is ahead by speed/gain."""
    inputs = _servo(t)
    return f"{1e3 * (inputs['reference'] + inputs['reference_speed'] / 70.0):.12g} mm"


DUTIES = {
    "reversal": Duty(
        34,
        0.06,
        2e-3,
        _reversal,
        lambda d: {
            "response.motor.torque": d.steps(lambda t: f"{_reversal(t)['motor_torque']:.12g} N m")
        },
    ),
    "emergency_stop": Duty(
        35, 0.1, 5e-3, lambda t: {"reference": 900.0 * RPM, "external_force": 1200.0}, lambda d: {}
    ),
    "servo_axis": Duty(
        36,
        0.15,
        2e-3,
        _servo,
        lambda d: {
            "response.motor.controller.position": d.steps(_led),
            "response.motor.controller.speed_feed_forward": False,
        },
    ),
}


@pytest.fixture(scope="module", params=DUTIES.values(), ids=DUTIES.keys())
def exported(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Duty, str]:
    pytest.importorskip("fmpy")
    from fmpy.validation import validate_fmu

    duty: Duty = request.param
    file = str(tmp_path_factory.mktemp("unit") / "drive.fmu")
    lesson(duty.lesson).export_fmu(file)
    assert validate_fmu(file) == []
    return duty, file


@pytest.mark.parametrize("parts", [1, 4, 20])
def test_unit_is_the_run(exported: tuple[Duty, str], parts: int, tmp_path: Path) -> None:
    """Each output within 1e-4 of its range, at steps of a part of what the inputs hold for."""
    from fmpy import extract, read_model_description
    from fmpy.fmi2 import FMU2Slave

    duty, file = exported
    step = duty.hold / parts
    count = round(duty.duration / step)
    description = read_model_description(file)
    reference = {v.name: v.valueReference for v in description.modelVariables}
    unit: Any = FMU2Slave(
        guid=description.guid,
        unzipDirectory=extract(file, str(tmp_path)),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="drive",
    )

    def set_inputs(k: int) -> None:
        inputs = duty.inputs(k // parts * duty.hold)
        unit.setReal([reference[name] for name in inputs], list(inputs.values()))

    series = dict(OUTPUTS)
    if "motor_torque" not in duty.inputs(0.0):
        series["motor_torque"] = ("motor_torque_Nm", 1.0)
    outputs = [reference[name] for name in series]
    unit.instantiate()
    unit.setupExperiment(startTime=0.0)
    unit.enterInitializationMode()
    set_inputs(0)
    unit.exitInitializationMode()
    rows = [unit.getReal(outputs)]
    state = None
    for k in range(count):
        set_inputs(k)
        unit.doStep(k * step, step)
        rows.append(unit.getReal(outputs))
        if k == count // 2:
            state = unit.getFMUstate()
    unit.setFMUstate(state)
    for k in range(count // 2 + 1, count):
        set_inputs(k)
        unit.doStep(k * step, step)
        assert unit.getReal(outputs) == rows[k + 1]  # To the bit.
    unit.terminate()
    unit.freeInstance()
    changes = {**duty.signals(duty), "response.sample_interval": f"{step:.9g} s"}
    run = lesson(duty.lesson).with_(changes).response().response
    for column, (key, factor) in enumerate(series.values()):
        expected = factor * run[key]
        found = np.array(rows)[:, column]
        # A torque that jumps with an input has its old value at the end of a step.
        ends = slice(0, -1) if key.endswith("torque_Nm") else slice(None)
        atol = 1e-4 * np.ptp(expected)
        np.testing.assert_allclose(found[ends], expected[ends], rtol=0, atol=atol, err_msg=key)


def test_unit_starts_where_initialization_ends(tmp_path: Path) -> None:
    """Inputs that are set behind it do not move the start: speeds go straight, forces step."""
    pytest.importorskip("fmpy")
    from fmpy import extract, read_model_description
    from fmpy.fmi2 import FMU2Slave

    block = {
        "duration": "10 ms",
        "motor": {"speed": "0 rpm"},
        "coupling": {"stiffness": "2000 N m/rad", "damping": "0.1 N m s/rad"},
        "screw": {"inertia": "3 kg cm^2"},
        "load": {"mass": "45 kg"},
        "material_damping": {"time": "50 us"},
    }
    case = lesson(36).with_(response=block)
    case.export_fmu(tmp_path / "drive.fmu")
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
    unit.exitInitializationMode()
    unit.setReal([reference["motor_speed"], reference["external_force"]], [50.0, 1000.0])
    unit.doStep(0.0, 5e-3)
    angle, force = unit.getReal([reference["motor_angle"], reference["force"]])
    unit.terminate()
    unit.freeInstance()
    assert angle == pytest.approx(0.125, rel=1e-9)
    ramp = {"points": [{"at": "0 s", "value": "0 rad/s"}, {"at": "5 ms", "value": "50 rad/s"}]}
    step = {"steps": [{"at": "-1 s", "value": "0 N"}, {"at": "0.001 us", "value": "1 kN"}]}
    changes = {"response.motor.speed": ramp, "response.load.force": step}
    run = case.with_({**changes, "response.sample_interval": "5 ms"}).response().response
    assert force == pytest.approx(run.force_N[1], abs=1e-4 * np.ptp(run.force_N) + 1.0)


def test_lever_follows_its_own_equation() -> None:
    """SciPy integrates J theta'' = g F - M in the angle, under the force that the run has."""
    interpolate = pytest.importorskip("scipy.interpolate")
    integrate = pytest.importorskip("scipy.integrate")
    base, arm, inertia = 0.5, 0.3, 2.0
    speed = {"points": [{"at": "0 s", "value": "0 rpm"}, {"at": "0.1 s", "value": "3000 rpm"}]}
    torque = {"mean": "300 N m", "amplitude": "100 N m", "frequency": "20 Hz"}
    block = {
        "duration": "0.4 s",
        "sample_interval": "20 us",
        "motor": {"speed": speed},
        "load": {
            "linkage": {"base": "500 mm", "arm": "300 mm"},
            "inertia": "2 kg m^2",
            "torque": {"sine": torque},
        },
        "start": {"angle": "60 deg"},
        "material_damping": {"time": "50 us"},
    }
    run = lesson(36).with_(response=block).response().response
    time, angle = np.array(run.time_s), np.radians(run.lever_angle_deg)
    force = interpolate.CubicSpline(time, run.force_N)

    def rates(t: float, state: np.ndarray) -> list[float]:
        length = np.sqrt(base**2 + arm**2 - 2.0 * base * arm * np.cos(state[0]))
        ratio = base * arm * np.sin(state[0]) / length
        against = 300.0 + 100.0 * np.sin(2.0 * np.pi * 20.0 * t)
        return [state[1], (ratio * force(t) - against) / inertia]

    own = integrate.solve_ivp(
        rates,
        (0.0, time[-1]),
        [angle[0], 0.0],
        "DOP853",
        time[::500],
        rtol=1e-10,
        atol=1e-12,
        max_step=1e-4,
    )
    assert np.ptp(angle) > 0.3
    assert own.y[0] == pytest.approx(angle[::500], abs=1e-5 * np.ptp(angle))
    # The angle is that of the length, which the screw has moved.
    length = np.sqrt(base**2 + arm**2 - 2.0 * base * arm * np.cos(angle))
    assert length - length[0] == pytest.approx(1e-3 * np.array(run.position_mm), abs=1e-10)
    assert run.energy_J.residual_relative < 1e-6


@pytest.fixture(scope="module")
def axis() -> rs.Case:
    """The drive of lesson 35 under an even torque, without stops."""
    block = {
        "duration": "0.2 s",
        "motor": {"inertia": "6 kg cm^2", "damping": "0.002 N m s/rad", "torque": "6.2 N m"},
        "screw": {"inertia": "3.5 kg cm^2"},
        "load": {"mass": "30 kg", "force": "6 kN", "friction_force": "60 N"},
        "curves": {"force": "12 kN", "speed": "2000 rpm"},
    }
    return lesson(35).with_(response=block)


def test_mujoco_loses_what_the_fit_states(axis: rs.Case, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    axis.export_mjcf(tmp_path / "axis.xml", friction_load=6000.0)
    axis.export_urdf(tmp_path / "axis.urdf", friction_load=6000.0)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "axis.xml"))
    bare = mujoco.MjModel.from_xml_path(str(tmp_path / "axis.urdf"))
    assert bare.dof_frictionloss[0] == pytest.approx(model.dof_frictionloss[0], rel=1e-12)
    assert bare.dof_damping[0] == pytest.approx(model.dof_damping[0], rel=1e-12)
    assert model.body_mass[1] == bare.body_mass[-1] == 30.0
    model.opt.timestep = 2e-4
    data = mujoco.MjData(model)
    load, torque = 6000.0, 6.2
    data.qfrc_applied[0], data.ctrl[0] = -load, torque
    mujoco.mj_step(model, data, nstep=1000)
    inertia = 30.0 + model.dof_armature[0]
    travel, speed = data.qpos[0], data.qvel[0]
    lost = (torque * model.actuator_gear[0, 0] - load) * travel - 0.5 * inertia * speed**2

    result = axis.response().response
    energy = result.energy_J
    expected = energy.motor + energy.load - (energy.stored_end - energy.stored_start)
    errors = re.search(r"off by (\S+) N at the most", (tmp_path / "axis.xml").read_text())
    assert errors is not None
    assert travel > 5e-3
    assert lost / travel == pytest.approx(
        1e3 * expected / result.position_mm[-1], abs=float(errors[1])
    )


def test_mujoco_holds_what_friction_holds(axis: rs.Case, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    axis.export_mjcf(tmp_path / "axis.xml", friction_load=6000.0)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "axis.xml"))
    data = mujoco.MjData(model)
    data.qfrc_applied[0] = 0.9 * model.dof_frictionloss[0]
    mujoco.mj_step(model, data, nstep=500)
    assert abs(data.qvel[0]) < 1e-4


def test_joints_have_the_constants_of_the_drive(tmp_path: Path) -> None:
    case = lesson(35)
    case.export_mjcf(tmp_path / "axis.xml", friction_load=6000.0)
    case.export_urdf(tmp_path / "axis.urdf", friction_load=6000.0)
    joint = ElementTree.parse(tmp_path / "axis.xml").find(".//joint")
    assert joint is not None
    reach = 0.005 / (2.0 * np.pi)
    assert float(joint.attrib["armature"]) == pytest.approx(9.5e-4 / reach**2)
    assert joint.attrib["range"].split() == ["0", "0.0089999999999999993"]
    key = ElementTree.parse(tmp_path / "axis.xml").find(".//key")
    assert key is not None
    assert float(key.attrib["qpos"]) == pytest.approx(6e-3)
    dynamics = ElementTree.parse(tmp_path / "axis.urdf").find(".//dynamics")
    assert dynamics is not None
    assert dynamics.attrib["friction"] == joint.attrib["frictionloss"]
    odd = tmp_path / "a--b---c.yaml"
    odd.write_text((CONFIGS / "35_emergency_stop.yaml").read_text())
    rs.Case.from_yaml(odd).export_mjcf(tmp_path / "odd.xml")
    rs.Case.from_yaml(odd).export_urdf(tmp_path / "odd.urdf")
    for file in ("odd.xml", "odd.urdf"):
        ElementTree.parse(tmp_path / file)
    with pytest.raises(rs.InputError, match="response"):
        lesson(5).export_mjcf(tmp_path / "none.xml")
