"""The drive in MuJoCo with the friction and the play of the screw, against `prs response`."""

from __future__ import annotations

import importlib.util
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import rollerscrew as rs
from conftest import Run, lesson
from numpy.typing import NDArray

mujoco: Any = pytest.importorskip("mujoco")

REACH = 5e-3 / (2.0 * math.pi)  #: Lead of the lessons over a turn [m/rad].

#: Torque of the motor [N m] at a time, by its position and speed along the axis; external force.
Control = Callable[[float, float, float], float]
Force = Callable[[float], float]


@dataclass(frozen=True)
class Axis:
    """A drive as MuJoCo has it, and the module of Python beside it."""

    model: Any
    screw: ModuleType
    file: Path


@pytest.fixture
def exported(tmp_path: Path) -> Iterator[Callable[..., Axis]]:
    """Writes and loads a case; the callback is taken away behind the test."""

    def write(case: rs.Case, name: str = "axis", **options: Any) -> Axis:
        file = tmp_path / f"{name}.xml"
        case.export_mjcf(file, **options)
        return Axis(mujoco.MjModel.from_xml_path(str(file)), module(tmp_path / name), file)

    yield write
    mujoco.set_mjcb_passive(None)


def module(stem: Path) -> ModuleType:
    file = stem.with_name(f"{stem.name}_friction.py")
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec is not None and spec.loader is not None
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


@dataclass(frozen=True)
class Motion:
    """Series, and what was lost on the way [J]."""

    time: NDArray[np.float64]
    motor: NDArray[np.float64]  # Along the axis [m]
    load: NDArray[np.float64]
    force: NDArray[np.float64]
    torque: NDArray[np.float64]
    lost: float

    def mean(self, series: NDArray[np.float64], start: float, end: float) -> float:
        return float(series[(self.time > start) & (self.time < end)].mean())


def moved(axis: Axis, duration: float, control: Control, external: Force) -> Motion:
    """A run from the keyframe; work by the mean speed of a step, as kinetic energy has it."""
    model, screw = axis.model, axis.screw
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.set_mjcb_passive(screw.passive)
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, "load")
    step, gear, work, rows = model.opt.timestep, model.actuator_gear[0, 0], 0.0, []
    chain = slice(1 if model.nv == 3 else 0, None)  # A rotor stands beside it.
    spring = model.nv > 1
    for k in range(round(duration / step)):
        data.ctrl[0] = control(k * step, data.qpos[0], data.qvel[0])
        data.xfrc_applied[body, 0] = -external(k * step)
        before = data.qvel.copy()
        mujoco.mj_step(model, data)
        mean = 0.5 * (before + data.qvel)
        work += step * (data.ctrl[0] * gear * mean[0] - external(k * step) * mean[chain].sum())
        force = screw.flank_force(-data.qpos[-1], -data.qvel[-1]) if spring else math.nan
        rows.append((data.time, data.qpos[0], data.qpos[chain].sum(), force, data.ctrl[0]))
    kinetic = (
        data.qvel[chain].sum() ** 2 * model.body_mass[body] + data.qvel**2 @ model.dof_armature
    )
    stored = 0.5 * float(kinetic)
    if spring:
        way = np.linspace(0.0, -data.qpos[-1], 1000)
        stored += float(np.trapezoid(np.interp(way, screw.DEFLECTION, screw.FLANKS), way))
    if model.nv == 3:
        stored += 0.5 * model.tendon_stiffness[0] * (data.qpos[0] - data.qpos[1]) ** 2
    return Motion(*np.array(rows).T, work - stored)


def lost(result: Any) -> float:
    return float(sum(lost for _, lost in result["energy_J"]["lost"].items()))


def steady(result: Any, key: str, start: float, end: float) -> float:
    time = np.array(result.time_s)
    return float(np.array(result[key])[(time > start) & (time < end)].mean())


def test_reversal_through_play(exported: Callable[..., Axis]) -> None:
    """Lesson 34: lost work, steady force and lost motion of the same torque."""
    case = lesson(34)
    motion = moved(
        exported(case, play="joint"),
        0.06,
        lambda t, x, v: float(np.interp(t, [0.0, 5e-3, 20e-3, 28e-3], [0.0, 4.0, 4.0, -5.0])),
        lambda t: 50.0,
    )
    result = case.response().response
    assert motion.lost == pytest.approx(lost(result), rel=0.03)
    force = steady(result, "force_N", 12e-3, 20e-3)
    assert motion.mean(motion.force, 12e-3, 20e-3) == pytest.approx(force, rel=0.03)
    way = 1e6 * np.ptp(motion.motor - motion.load)
    assert way == pytest.approx(result.lost_motion_um, rel=0.03)
    assert motion.force.min() == pytest.approx(min(result.force_N), rel=0.03)  # The impact
    assert motion.load[-1] == pytest.approx(1e-3 * result.position_mm[-1], abs=5e-6)


def test_servo_axis(exported: Callable[..., Axis]) -> None:
    """Lesson 36: the same, and the torque of the ramp, by its controller."""
    case = lesson(36)
    axis = exported(case, play="joint")
    step = axis.model.opt.timestep
    integral, torque = 0.0, math.nan

    def control(t: float, x: float, v: float) -> float:
        nonlocal integral, torque
        reference, slope = 0.04 * min(t, 0.04), 0.04 if t < 0.04 else 0.0
        largest = 900.0 * math.pi / 30.0
        wanted = min(max((70.0 * (reference - x) + slope) / REACH, -largest), largest)
        error = wanted - v / REACH
        asked = 0.5 * (error + integral / 0.02)
        integral += error * step
        torque = asked + (0.0 if math.isnan(torque) else (torque - asked)) * math.exp(-step / 3e-4)
        return torque

    motion = moved(axis, 0.15, control, lambda t: 1500.0 if t >= 0.09 else 0.0)
    result = case.response().response
    assert motion.lost == pytest.approx(lost(result), rel=0.03)
    for series, key in ((motion.force, "force_N"), (motion.torque, "motor_torque_Nm")):
        expected = steady(result, key, 25e-3, 38e-3)
        assert motion.mean(series, 25e-3, 38e-3) == pytest.approx(expected, rel=0.03)
    # At rest the guides keep up to their friction of the load.
    assert motion.mean(motion.force, 0.13, 0.15) == pytest.approx(1500.0, abs=31.0)
    way = 1e6 * np.ptp(motion.motor - motion.load)
    assert way == pytest.approx(result.lost_motion_um, rel=0.03)


@pytest.fixture(scope="module")
def lift() -> rs.Case:
    """The drive of lesson 35 that lifts a load by an even torque, without stops and coupling."""
    block = {
        "duration": "0.2 s",
        "motor": {"inertia": "6 kg cm^2", "damping": "0.002 N m s/rad", "torque": "6.2 N m"},
        "screw": {"inertia": "3.5 kg cm^2", "drag_torque": "0.1 N m"},
        "load": {"mass": "30 kg", "force": "6 kN", "friction_force": "60 N"},
        "curves": {"force": "12 kN", "speed": "2000 rpm"},
    }
    return lesson(35).with_(response=block)


@pytest.mark.parametrize("play", [None, "joint"])
def test_lifted_load_loses_the_same_over_its_way(
    exported: Callable[..., Axis], lift: rs.Case, play: str | None
) -> None:
    """With one slide, too, where the transmitted force is that of the motor less inertia."""
    axis = exported(lift, play=play)
    axis.model.opt.timestep = min(axis.model.opt.timestep, 2e-4)
    motion = moved(axis, 0.2, lambda t, x, v: 6.2, lambda t: 6000.0)
    result = lift.response().response
    travel = 1e-3 * result.position_mm[-1]
    assert travel > 5e-3
    assert motion.lost / motion.load[-1] == pytest.approx(lost(result) / travel, rel=0.03)


def test_coefficients_are_the_efficiencies_of_slip(exported: Callable[..., Axis]) -> None:
    """c_drive = 1/eta - 1 and c_back = 1 - eta, at forces and speeds between the nodes."""
    case = lesson(35)
    screw = exported(case).screw
    for force, turning in ((9000.0, 700.0), (2500.0, 1100.0), (14000.0, 130.0)):
        for sense in (1, -1):
            both = [
                case.with_(
                    {
                        "load_cases[0].axial_force": f"{force} N",
                        "load_cases[0].direction": direction,
                        "operation.speed": f"{sense * turning} rpm",
                        "model.loads": "static",
                    }
                )
                .slip()
                .load_cases[0]["slip"]
                .efficiency
                for direction in ("tension", "compression")
            ]
            drives = [1.0 / eta - 1.0 for eta in both]
            back = [1.0 - eta for eta in both]
            speed = sense * turning * math.pi / 30.0 * REACH
            # With the sense of rotation, one direction of the force is driven, the other drives.
            driven, driving = (0, 1) if sense > 0 else (1, 0)
            assert screw.coefficient(force, speed, True) == pytest.approx(drives[driven], rel=0.03)
            assert screw.coefficient(force, speed, False) == pytest.approx(back[driving], rel=0.03)


def test_file_document_and_module_have_the_same_table(
    exported: Callable[..., Axis], program: Run, configs: Path, tmp_path: Path
) -> None:
    import json

    case = configs / "34_reversal.yaml"
    run = program("export", case, "--mjcf", "--urdf", "--play", "joint", "--json", "-o", tmp_path)
    assert run.returncode == 0, run.stderr
    export = json.loads(run.stdout)["export"]
    names = [Path(file["path"]).name for file in export["files"]]
    stem = "screw_34_reversal"
    assert names == [f"{stem}.mjcf.xml", f"{stem}_friction.py", f"{stem}.urdf"]
    losses = export["robot"]["losses"]
    screw = module(tmp_path / stem)
    for key, values in {
        "force_N": screw.FORCE,
        "speed_m_per_s": screw.SPEED,
        "c_drive": screw.C_DRIVE,
        "c_back": screw.C_BACK,
        "v_0_m_per_s": screw.V_0,
    }.items():
        np.testing.assert_allclose(losses[key], values, rtol=1e-5, err_msg=key)
    # Without a coupling a motor's friction would be on the screw; here it has a slide of its own.
    assert export["robot"]["drag_N"] == pytest.approx(0.18 / REACH)
    assert screw.DRAG == pytest.approx(0.1 / REACH)
    for file in (f"{stem}.mjcf.xml", f"{stem}.urdf"):
        text = (tmp_path / file).read_text()
        assert "never a coefficient" in text and "root mean square" in text
        for title, rows in (("c_drive", losses["c_drive"]), ("c_back", losses["c_back"])):
            table = re.search(rf"{title} = .*\n.*m/s.*\n((?:\s+[\d.e+-]+)+)", text)
            assert table is not None
            numbers = np.array(table[1].split(), dtype=float).reshape(len(rows), -1)
            np.testing.assert_allclose(numbers[:, 1:], rows, atol=6e-5)
    again = exported(lesson(34), stem, play="joint")
    assert again.screw.C_BACK == screw.C_BACK


def test_friction_without_callback_is_that_of_the_run(tmp_path: Path) -> None:
    """p_0 + p_1 F + dry friction under the root mean square force of the run."""
    case = lesson(34)
    case.export_urdf(tmp_path / "axis.urdf")
    text = (tmp_path / "axis.urdf").read_text()
    force = float(np.sqrt(np.mean(np.square(case.response().response.force_N))))
    stated = re.search(r"under a load of (\S+) N", text)
    fit = re.search(r"alone it is (\S+) N \+ (\S+) of the load", text)
    assert stated is not None and fit is not None
    assert float(stated[1]) == pytest.approx(force, rel=1e-5)
    dynamics = ElementTree.parse(tmp_path / "axis.urdf").find(".//dynamics")
    assert dynamics is not None
    expected = float(fit[1]) + float(fit[2]) * force + 0.18 / REACH + 80.0
    assert float(dynamics.attrib["friction"]) == pytest.approx(expected, rel=1e-5)


def test_play_is_a_joint_with_limits(exported: Callable[..., Axis]) -> None:
    """Without the callback: its range is the play, its limit a spring and a damper."""
    axis = exported(lesson(34), play="joint")
    model = axis.model
    gap = model.joint("gap")
    assert np.ptp(gap.range) == pytest.approx(30e-6, rel=1e-6)
    masses = model.dof_armature[:2]
    np.testing.assert_allclose(masses, [4e-4 / REACH**2, 3.5e-4 / REACH**2], rtol=1e-9)
    together = 1.0 / (1.0 / masses[1] + 1.0 / 120.0)
    stiffness, damping = -model.jnt_solref[gap.id] * together
    force = float(re.findall(r"under a load of (\S+) N", axis.file.read_text())[0])
    nodes = [np.interp(f, axis.screw.FLANKS, axis.screw.DEFLECTION) for f in (-force, force)]
    way = 0.5 * (nodes[1] - nodes[0] - 30e-6)
    assert stiffness == pytest.approx(force / way, rel=0.02)
    assert damping == pytest.approx(stiffness * 0.05 / (2.0 * math.pi * 250.0), rel=1e-4)
    # The screw is held by its friction, and the load, without that of its guides, is pulled.
    model.tendon_frictionloss[:] = 0.0
    data = mujoco.MjData(model)
    data.xfrc_applied[model.body("load").id, 0] = -100.0
    mujoco.mj_step(model, data, nstep=20000)
    assert data.qpos[2] == pytest.approx(-15e-6 - 100.0 / stiffness, abs=0.02 * 100.0 / stiffness)


def test_preloaded_screw_is_a_spring(exported: Callable[..., Axis]) -> None:
    case = lesson(36)
    axis = exported(case, play="joint")
    gap = axis.model.joint("gap")
    assert not axis.model.jnt_limited[gap.id]
    # The curve of `prs preload`, without a coupling and a shaft between.
    for row in case.preload().preload["loads"]:
        force = axis.screw.flank_force(1e-6 * row["axial_displacement_um"], 0.0)
        assert force == pytest.approx(row["axial_force_N"], rel=0.01, abs=1e-6)


def test_screw_creeps_at_rest_as_stated(exported: Callable[..., Axis], lift: rs.Case) -> None:
    """Under half of the friction, against v_0 artanh(1/2) = 0.55 v_0."""
    axis = exported(lift.with_({"response.load.friction_force": "0 N"}), play="joint")
    model, screw = axis.model, axis.screw
    model.opt.timestep = 1e-5  # V_0 as stated, not that of a long step
    data = mujoco.MjData(model)
    mujoco.set_mjcb_passive(screw.passive)
    data.qfrc_applied[0] = 0.5 * (screw.DRAG + screw.coefficient(1.0, 0.0, True) * screw.FORCE[0])
    mujoco.mj_step(model, data, nstep=20000)
    assert data.qvel[0] == pytest.approx(math.atanh(0.5) * screw.V_0, rel=0.03)


def test_curves_between_their_nodes(exported: Callable[..., Axis]) -> None:
    """The table of forces rises, has the play in its middle and pulls nowhere."""
    screw = exported(lesson(34), play="joint").screw
    assert all(a < b for a, b in pairwise(screw.DEFLECTION))
    assert screw.flank_force(0.0, 1.0) == 0.0
    assert screw.flank_force(20e-6, -1e3) == 0.0  # Damping cannot pull.
    assert screw.flank_force(20e-6, 0.0) > 0.0 > screw.flank_force(-20e-6, 0.0)


@pytest.mark.parametrize("play", [None, "joint"])
@pytest.mark.parametrize("side", ["upper", "lower"])
def test_a_stop_alone_is_a_spring(
    exported: Callable[..., Axis], side: str, play: str | None
) -> None:
    """Without friction a mass M at the speed v goes v sqrt(M/k) into a stop."""
    stiffness, speed = 2e6, 0.05
    sign = 1.0 if side == "upper" else -1.0
    stops = {side: {"at": f"{20.0 * sign} mm", "stiffness": f"{stiffness} N/m"}}
    case = lesson(34).with_({"response.end_stops": stops})
    model = exported(case, play=play).model
    model.opt.timestep = min(model.opt.timestep, 5e-5)
    model.dof_frictionloss[:] = model.dof_damping[:] = 0.0
    model.tendon_frictionloss[:] = model.tendon_damping[:] = 0.0
    model.opt.gravity[:] = 0.0
    data = mujoco.MjData(model)

    def position() -> float:
        return sign * (data.qpos[0] if play is None else data.qpos[-2:].sum())  # Screw and gap.

    moving = slice(None) if play is None else slice(-1)  # All but the gap.
    data.qpos[moving] = sign * 0.0199
    data.qvel[moving] = sign * speed
    deepest = 0.0
    for _ in range(round(0.05 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        deepest = max(deepest, position() - 0.02)
    if play is None:
        mass = model.body_mass.sum() + model.dof_armature[0]
        assert deepest == pytest.approx(speed * math.sqrt(mass / stiffness), rel=0.01)
    else:  # The load alone goes less deep, and all that moves, on a rigid screw, deeper.
        load = model.body_mass[-1]
        both = model.body_mass.sum() + model.dof_armature.sum()
        least, most = (speed * math.sqrt(mass / stiffness) for mass in (load, both))
        assert 0.99 * least < deepest < 1.01 * most


def test_friction_of_a_joint_that_is_not_there(exported: Callable[..., Axis]) -> None:
    axis = exported(lesson(34))
    axis.screw.SCREW = "knee"
    with pytest.raises(ValueError, match="no joint 'knee'"):
        axis.screw.prepare(axis.model)


def test_wrong_play(program: Run, configs: Path, tmp_path: Path) -> None:
    case = configs / "34_reversal.yaml"
    for options, words in (
        (("--urdf", "--play", "joint"), "--play: needs --mjcf"),
        (("--mjcf", "--play", "hinge"), "joint"),
        (("--fmu", "--friction-load", "1 kN"), "--friction-load: needs --mjcf or --urdf"),
        (("--mjcf", "--friction-load", "9 MN"), "response.curves.force"),
        (("--mjcf", "--static"), "--static: needs --fmu"),
        (("--mjcf", "--play", "joint", "--set", "response.screw.inertia=0 kg m^2"), "inertia"),
    ):
        run = program("export", case, *options, "--output", tmp_path)
        assert run.returncode == 2
        assert words in run.stderr
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(ValueError, match="play: got 'hinge'; expected 'joint' or None"):
        lesson(34).export_mjcf(tmp_path / "axis.xml", play="hinge")  # type: ignore[arg-type]
