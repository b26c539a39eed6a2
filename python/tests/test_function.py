"""A case as a function of numbers: its values are those of the commands, its slopes exact."""

from __future__ import annotations

import pickle
import warnings
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
import rollerscrew as rs
from conftest import lesson

FORCE, ANGLE = "load_cases[0].axial_force", "mechanism.flank_angle"
STIFFNESS, PRESSURE = "axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"


def test_values_are_those_of_the_command() -> None:
    f = lesson(4).function([ANGLE, FORCE], [STIFFNESS, PRESSURE])
    assert f.units == ("deg", "N")
    designs = np.array([[44.0, 9e3], [45.0, 10e3], [46.0, 11e3]])
    values = f(designs)
    assert values.shape == (3, 2)
    for x, expected in zip(designs, values, strict=True):
        case = lesson(4).with_({ANGLE: (x[0], "deg"), FORCE: (x[1], "N")})
        solved = case.solve().load_cases[0]
        assert solved.screw is not None and solved.screw.peak_pressure_MPa is not None
        pressure = solved.screw.peak_pressure_MPa.max()
        np.testing.assert_allclose(expected, [solved.axial_stiffness_N_per_um, pressure], rtol=1e-9)
        np.testing.assert_array_equal(f(x), expected)
    many = np.repeat(designs, 200, axis=0)
    np.testing.assert_allclose(f(many), np.repeat(values, 200, axis=0), rtol=1e-11)


def test_units_may_be_chosen() -> None:
    f = lesson(4).function({FORCE: "kN"}, [STIFFNESS])
    g = lesson(4).function([FORCE], [STIFFNESS])
    assert f(f.x0) == g(g.x0) and g.x0[0] == pytest.approx(1e3 * f.x0[0])
    with pytest.raises(ValueError, match="expected a unit that the value can be converted to"):
        lesson(4).function({FORCE: "mm"}, [STIFFNESS])


@pytest.mark.parametrize(
    ("number", "inputs", "responses", "command"),
    [
        (4, {ANGLE: "deg", FORCE: "kN"}, [STIFFNESS, PRESSURE], "solve"),
        (9, {"operation.speed": "rpm"}, ["slip.efficiency", "slip.power_loss_W"], "slip"),
    ],
)
def test_jacobians_are_slopes(
    number: int, inputs: dict[str, str], responses: list[str], command: Any
) -> None:
    f = lesson(number).function(inputs, responses, command)
    jacobian = f.jacobian(f.x0)
    assert jacobian.shape == (len(responses), len(inputs))
    for k, x in enumerate(f.x0):
        step = np.zeros_like(f.x0)
        step[k] = 1e-4 * x
        slope = (f(f.x0 + step) - f(f.x0 - step)) / (2.0 * step[k])
        np.testing.assert_allclose(jacobian[:, k], slope, rtol=1e-5)


def test_counts_are_whole_numbers() -> None:
    f = lesson(1).function(["mechanism.rollers"], [STIFFNESS])
    nine, eleven = f([[9.0], [11.0]])
    assert f([9])[0] == nine[0] < eleven[0]
    with pytest.raises(ValueError, match="expected whole numbers"):
        f([9.5])
    with pytest.raises(ValueError, match="got a count"):
        f.jacobian([9.0])


def test_designs_that_fail_are_nan_with_their_reasons() -> None:
    f = lesson(1).function(["mechanism.rollers"], [STIFFNESS])
    values = f([[9], [50]])
    assert np.isfinite(values[0]).all() and np.isnan(values[1]).all()
    designs = f.designs([[9], [50]])
    assert "more rollers of 7.5" in designs.reason[1]
    assert designs.case(0) == lesson(1).with_({"mechanism.rollers": 9})
    pickle.loads(pickle.dumps(designs)).case(0)


def test_whole_arrays_are_responses() -> None:
    f = lesson(1).function([FORCE], ["screw.load_rate_percent"])
    loads = lesson(1).solve().load_cases[0].screw
    assert loads is not None
    np.testing.assert_allclose(f(f.x0), loads.load_rate_percent, rtol=1e-9)


@pytest.mark.parametrize("x", [[1.0, 2.0], [[1.0, 2.0]], np.ones((1, 1, 1)), 3.0])
def test_other_shapes_are_refused(x: Any) -> None:
    f = lesson(4).function([FORCE], [STIFFNESS])
    with pytest.raises(ValueError, match="x: got the shape"):
        f(x)


def test_numbers_out_of_bounds_are_no_answers() -> None:
    f = lesson(4).function([FORCE], [STIFFNESS])
    assert np.isnan(f([-1.0])).all()


# Designs


def test_designs_are_chosen() -> None:
    forces = np.linspace(5.0, 45.0, 9)
    designs = lesson(1).evaluate({FORCE: (forces, "kN")}, [STIFFNESS, "screw.load_rate_percent"])
    threads = designs["screw.load_rate_percent"]
    assert threads.shape[0] == 9 and threads.shape[1] > 5
    assert repr(designs) == f"<Designs: 9, 9 converged; {STIFFNESS}, screw.load_rate_percent>"
    some = designs[forces > 20.0]
    np.testing.assert_array_equal(some[STIFFNESS], designs[STIFFNESS][forces > 20.0])
    assert len(designs[2:4]) == 2 and len(designs[[0, 8]]) == 2
    best = designs.best(STIFFNESS, largest=True)
    assert designs[STIFFNESS][best] == designs[STIFFNESS].max()
    case = designs[[best]].case(0)
    assert case == designs.case(best)
    assert case.number(FORCE, "kN") == pytest.approx(forces[best])
    assert pickle.loads(pickle.dumps(some)).case(0) == some.case(0)


def test_grids_have_their_inputs_as_dimensions() -> None:
    forces, rollers = np.meshgrid([10.0, 20.0, 30.0], [9, 11])
    designs = lesson(1).evaluate(
        {FORCE: (forces.ravel(), "kN"), "mechanism.rollers": rollers.ravel()},
        [STIFFNESS, "screw.load_rate_percent"],
    )
    maps = designs.to_xarray()
    assert maps[STIFFNESS].shape == (3, 2)
    assert maps["screw.load_rate_percent"].dims[-1] == "thread"
    at = {f"{FORCE}_kN": 20.0, "mechanism.rollers": 11}
    assert float(maps[STIFFNESS].sel(at)) == designs[STIFFNESS][4]
    assert maps[STIFFNESS].attrs["units"] == "N/µm"
    assert designs[:5].to_xarray()[STIFFNESS].dims == ("design",)
    assert maps.attrs["prs_version"] == rs.__version__
    assert (maps.attrs["command"], maps.attrs["loads"]) == ("solve", "at rest")
    assert maps.attrs["input_sha256"] == lesson(1).solve().input_sha256
    assert all("units" in variable.attrs for name, variable in maps.items() if name != "status")
    assert all(coordinate.attrs["units"] for name, coordinate in maps.coords.items() if "_" in name)


def test_frames_are_inputs() -> None:
    forces = np.array([10.0, 20.0])
    designs = lesson(1).evaluate({FORCE: (forces, "kN"), "mechanism.rollers": [9, 11]}, [STIFFNESS])
    again = lesson(1).evaluate(designs.inputs, [STIFFNESS])
    np.testing.assert_array_equal(again.values, designs.values)
    assert list(again.inputs.columns) == list(designs.inputs.columns)


def test_load_cases_by_name() -> None:
    case = lesson(1)
    name = case.solve().load_cases[1].name
    by_name, by_place = f"load_cases[{name}].{STIFFNESS}", f"load_cases[1].{STIFFNESS}"
    named = case.evaluate({"mechanism.rollers": [9]}, [by_name])
    placed = case.evaluate({"mechanism.rollers": [9]}, [by_place])
    np.testing.assert_array_equal(named.values, placed.values)


def test_errors_name_the_argument_and_the_index() -> None:
    with pytest.raises(rs.InputError, match=r"^inputs\['mechanism.lead'\]\[2\]: got -?0"):
        lesson(4).evaluate({"mechanism.lead": ([1.0, 2.5, 0.0], "mm")})
    with pytest.raises(rs.InputError, match=r"^responses\[1\]: got .*materials.density") as raised:
        lesson(1).evaluate(
            {"mechanism.rollers": [9]},
            ["measures.envelope_volume_cm3", "measures.weight_kg"],
            command="measures",
        )
    assert "--set" not in str(raised.value)


def test_what_cannot_stand_in_the_case_may_be_a_row() -> None:
    ratios = np.array([0.3, 0.7, 0.25, -2.0])
    with pytest.raises(rs.InputError, match=r"inputs\['materials.poisson_ratio'\]\["):
        lesson(4).evaluate({"materials.poisson_ratio": ratios}, [STIFFNESS])
    designs = lesson(4).evaluate({"materials.poisson_ratio": ratios}, [STIFFNESS], on_error="row")
    assert list(designs.status) == ["converged", "refused", "converged", "refused"]
    assert "inputs['materials.poisson_ratio'][1]" in designs.reason[1]
    alone = lesson(4).evaluate({"materials.poisson_ratio": ratios[[0, 2]]}, [STIFFNESS])
    np.testing.assert_array_equal(designs.values[[0, 2]], alone.values)


def test_preload_of_designs() -> None:
    case = lesson(12)
    rollers = [int(case["mechanism.rollers"]), int(case["mechanism.rollers"]) - 1]
    response = "preload.lost_motion_um" if "lost_motion_um" in case.preload().preload else None
    paths = [response or "preload.loads[0].axial_displacement_um"]
    designs = case.evaluate({"mechanism.rollers": rollers}, paths, command="preload")
    assert designs.converged.all() and designs.values[0, 0] != designs.values[1, 0]


def test_batches_go_into_one_file(tmp_path: Any) -> None:
    import pandas as pd

    inputs = {FORCE: (np.linspace(5.0, 45.0, 10), "kN"), "model.roller": "flexible"}
    file = tmp_path / "designs.parquet"
    assert lesson(1).evaluate_to_parquet(file, inputs, [STIFFNESS], batch=3) == 10
    expected = lesson(1).evaluate(inputs, [STIFFNESS]).to_frame()
    pd.testing.assert_frame_equal(pd.read_parquet(file), expected)


def test_functions_are_sent_elsewhere() -> None:
    for inputs in ([FORCE], ["mechanism.rollers", FORCE]):
        f = lesson(1).function(inputs, [STIFFNESS, "screw.load_rate_percent"])
        again = pickle.loads(pickle.dumps(f))
        assert repr(again) == repr(f)
        np.testing.assert_array_equal(again(f.x0), f(f.x0))


def test_threads_share_counts() -> None:
    f = lesson(1).function(["mechanism.rollers"], [STIFFNESS])
    with ThreadPoolExecutor(4) as executor:
        shared = list(executor.map(f, [[k] for k in [*range(3, 13)] * 3]))
    alone = [f([k]) for k in [*range(3, 13)] * 3]
    np.testing.assert_allclose(shared, alone, rtol=1e-11)


def test_functions_warn_of_inputs_that_move_nothing() -> None:
    with pytest.warns(UserWarning, match="mechanism.flank_angle: moves no load or stiffness"):
        f = lesson(1).function([ANGLE], [STIFFNESS])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert pickle.loads(pickle.dumps(f)).jacobian(f.x0) == 0.0


def test_errors_of_functions_name_the_argument() -> None:
    with pytest.raises(rs.InputError, match=r"^responses\[0\]: got stiffness; .*did you mean") as r:
        lesson(1).function([FORCE], ["stiffness"])
    assert "study" not in str(r.value) and "measures." not in str(r.value)
    with pytest.raises(rs.InputError, match=r"^responses\[0\]: .*weight_kg; needs `materials.dens"):
        lesson(1).function([FORCE], ["measures.weight_kg"], command="measures")
    with pytest.raises(rs.InputError, match="^command: got preload; expected contact"):
        lesson(1).function([FORCE], [STIFFNESS], command="preload")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="inputs: got none"):
        lesson(1).function([], [STIFFNESS])
    five: Any = 5
    with pytest.raises(TypeError, match="inputs: got 5; expected a list of paths"):
        lesson(1).function(five, [STIFFNESS])
    with pytest.raises(TypeError, match="responses: got 5; expected a list of paths"):
        lesson(1).function([FORCE], five)
    with pytest.raises(ValueError, match="responses: got none"):
        lesson(1).function([FORCE], [])


def test_slopes_at_a_bound_are_those_of_one_side() -> None:
    bore = "structure.screw.bore"
    case = lesson(4).with_({bore: "0 mm"})
    f = case.function([bore], [STIFFNESS])
    assert np.isnan(f([-0.001])).all()
    # A bore takes its square away from the section: at none the slope is none.
    assert abs(f.jacobian([0.0])[0, 0]) < 1e-4 * abs(f.jacobian([1.0])[0, 0])


def test_values_with_the_units_of_a_function_are_a_case() -> None:
    f = lesson(4).function(["mechanism.rollers", FORCE], [STIFFNESS])
    same = lesson(4).with_(dict(zip(f.inputs, zip(f.x0, f.units, strict=True), strict=True)))
    solved = same.solve().load_cases[0]
    assert solved.axial_stiffness_N_per_um == lesson(4).solve().load_cases[0][STIFFNESS]


# Rows that are refused


def test_numbers_that_are_not_finite_may_be_rows() -> None:
    lead = (np.array([5.0, np.nan, 5.1, np.inf]), "mm")
    rollers = np.array([9.0, 9.0, 9.4, 8.0])
    designs = lesson(4).evaluate(
        {"mechanism.lead": lead, "mechanism.rollers": rollers}, [STIFFNESS], on_error="row"
    )
    assert list(designs.status) == ["converged", "refused", "refused", "refused"]
    assert designs.reason[1] == "inputs['mechanism.lead'][1]: got nan; expected finite numbers"
    assert "got 9.4; expected a whole number" in designs.reason[2]
    assert designs.case(0) == lesson(4).with_({"mechanism.lead": "5 mm", "mechanism.rollers": 9})
    with pytest.raises(rs.InputError, match="got 9.4"):
        designs.case(2)
    none = lesson(4).evaluate({"mechanism.rollers": [9.4, 9.2]}, [STIFFNESS], on_error="row")
    assert list(none.status) == ["refused", "refused"] and np.isnan(none.values).all()


@pytest.mark.parametrize(
    ("inputs", "responses"),
    [({"mechanism.rolers": [9, 8]}, [STIFFNESS]), ({"mechanism.rollers": [9, 8]}, ["nope"])],
)
def test_what_is_no_value_is_no_row(inputs: dict[str, Any], responses: list[str]) -> None:
    with pytest.raises(rs.InputError):
        lesson(4).evaluate(inputs, responses, on_error="row")


def test_refused_rows_warn_and_show_progress() -> None:
    said: list[tuple[int, int]] = []
    with pytest.warns(UserWarning, match="moves no load"):
        lesson(1).evaluate(
            {ANGLE: (np.array([44.0, 45.0, -1.0]), "deg")},
            [STIFFNESS],
            on_error="row",
            progress=lambda done, total: said.append((done, total)),
        )
    assert said[-1] == (3, 3)


def test_preloads_are_designs() -> None:
    lead = (np.array([0.2, np.nan]), "in")
    designs = lesson(12).evaluate(
        {"structure.nut.outer_diameter": (np.array([50.0, 52.0]), "mm")},
        ["preload.lost_motion_um"],
        command="preload",
    )
    assert list(designs.inputs) == ["structure.nut.outer_diameter_mm"]
    motion = designs.case(1).preload().preload.lost_motion_um
    assert motion == designs["preload.lost_motion_um"][1]
    refused = lesson(12).evaluate(
        {"mechanism.lead": lead}, ["preload.lost_motion_um"], command="preload", on_error="row"
    )
    assert refused.status[1] == "refused" and "got nan" in refused.reason[1]


def test_columns_of_designs() -> None:
    forces = np.array([10.0, 20.0])
    loads = "screw.load_rate_percent"
    designs = lesson(1).evaluate({FORCE: (forces, "kN"), "model.roller": ["flexible"] * 2}, [loads])
    np.testing.assert_array_equal(designs[f"{FORCE}_kN"], forces)
    assert len(designs[[]]) == 0
    with pytest.raises(ValueError, match="got an array; expected a number such as"):
        designs.best(loads)
    with pytest.raises(ValueError, match="holds words"):
        designs["model.roller"]
    with pytest.raises(TypeError, match=r"got 0; expected .*`designs.case\(place\)`"):
        designs[0]  # type: ignore[call-overload]


def test_batches_without_designs_are_refused(tmp_path: Any) -> None:
    file = tmp_path / "designs.parquet"
    for inputs in ({"mechanism.rollers": []}, iter(())):
        with pytest.raises(ValueError, match="expected .*at least one"):
            lesson(1).evaluate_to_parquet(file, inputs, [STIFFNESS])
    with pytest.raises(ValueError, match="batch: got 0"):
        lesson(1).evaluate_to_parquet(file, {"mechanism.rollers": [9]}, [STIFFNESS], batch=0)


def test_functions_over_several_commands() -> None:
    case = rs.new("standard", "25 mm", "5 mm")
    bore = "structure.screw.bore"
    paths = ["life.system.l10_hours", STIFFNESS, "measures.screw_weight_kg_per_m"]
    f = case.function([FORCE, bore], paths)
    assert f.responses == tuple(paths) and f.command == ("life", "solve", "measures")
    x = np.vstack([f.x0, f.x0 * [0.9, 1.0], f.x0 + [0.0, 2.0]])
    commands: list[Any] = ["life", "solve", "measures"]
    alone = [case.function([FORCE, bore], [p], c) for p, c in zip(paths, commands, strict=True)]
    assert np.array_equal(f(x), np.hstack([one(x) for one in alone]))
    assert np.array_equal(f(f.x0), f(x)[0])
    slopes = f.jacobian(x[2])
    assert np.array_equal(slopes, np.vstack([one.jacobian(x[2]) for one in alone]))
    assert slopes[2, 0] == 0.0 and slopes[2, 1] < 0.0
    sent = pickle.loads(pickle.dumps(f))
    assert np.array_equal(sent(x), f(x)) and repr(sent) == repr(f)
    told = case.function({FORCE: "kN", bore: "mm"}, {"measures": [paths[2]], "solve": paths[1:2]})
    assert told.responses == (paths[2], paths[1]) and told.units == ("kN", "mm")
    designs = f.designs([[f.x0[0], 0.0], [f.x0[0], 30.0]])
    assert designs.converged.tolist() == [True, False] and designs.reason[1]
    assert np.isnan(designs.values[1]).all() and designs.case(0).number(bore, "mm") == 0.0
    whole = lesson(9).function([FORCE], ["slip.efficiency", "screw.load_rate_percent", STIFFNESS])
    assert whole.responses[0] == "slip.efficiency" and whole.responses[-1] == STIFFNESS
    assert len(whole.responses) == 2 + len(lesson(9).solve().load_cases[0].screw.load_rate_percent)
    with pytest.raises(ValueError, match="responses: got none"):
        case.function([FORCE], {"solve": []})
    with pytest.raises(TypeError, match="command: got 'solve' beside"):
        case.function([FORCE], {"solve": [STIFFNESS]}, "solve")


def test_warnings_are_of_the_line_that_calls() -> None:
    with pytest.warns(UserWarning, match="moves no load") as warned:
        lesson(1).function([ANGLE], [STIFFNESS])
        rs.Function(lesson(1), [ANGLE], [STIFFNESS])
        lesson(1).evaluate({ANGLE: ([44.0], "deg")}, [STIFFNESS], on_error="row")
    assert [warning.filename for warning in warned] == [__file__] * 3


def test_responses_that_are_wrong_have_their_place_among_those_asked_for() -> None:
    case, loads = lesson(9), "screw.load_rate_percent"
    with pytest.raises(rs.InputError, match=r"^responses\[2\]: got foo; expected a number"):
        case.function([FORCE], ["slip.efficiency", STIFFNESS, "foo"])
    with pytest.raises(rs.InputError, match=r"^responses\[1\]: got foo; expected a number"):
        case.evaluate({"mechanism.rollers": [9]}, [loads, "foo"])
    with pytest.raises(rs.InputError, match=r"^responses\[2\]: got slip.efficiency a second time"):
        case.function([FORCE], [STIFFNESS, "slip.efficiency", "slip.efficiency"])
    for again in ([STIFFNESS, STIFFNESS], [loads, f"{loads}[3]"], [f"{loads}[3]", loads]):
        with pytest.raises(rs.InputError, match=r"^responses\[1\]: got .* a second time; expected"):
            case.evaluate({"mechanism.rollers": [9]}, again)
    assert len(case.evaluate({"mechanism.rollers": [9]}, [f"{loads}[3]", f"{loads}[4]"])) == 1


def test_inputs_and_responses_may_be_given_one_at_a_time() -> None:
    for responses in ([STIFFNESS], [STIFFNESS, "slip.efficiency"]):
        at_once = lesson(9).function([FORCE], responses)
        singly = lesson(9).function((path for path in [FORCE]), (path for path in responses))
        assert singly.inputs == at_once.inputs
        np.testing.assert_array_equal(singly(singly.x0), at_once(at_once.x0))


def test_inputs_that_are_none_are_errors_of_input() -> None:
    for path in ("mechanism.leed", "load_cases[9].axial_force", ""):
        with pytest.raises(rs.InputError, match=r"^inputs\['.*'\]: ") as raised:
            lesson(1).function([path], [STIFFNESS])
        assert raised.value.path == path or not path
    for number in (np.inf, np.nan, 1e300):
        with pytest.raises(ValueError, match=r"mechanism.rollers: got .*; expected whole numbers"):
            lesson(1).function(["mechanism.rollers"], [STIFFNESS])([number])
