"""Cases to begin with, values of cases, cases that are handed over, what can be asked."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
from conftest import Run, answer, lesson, lessons


def test_new_cases_are_those_of_the_program(program: Run) -> None:
    case = rs.new("standard", screw_diameter="25 mm", lead=(5, "mm"), rollers=9)
    options = ["--screw-diameter", "25 mm", "--lead", "5 mm", "--rollers", "9"]
    assert case.text == program("new", "standard", "-", *options).stdout
    assert case["mechanism.rollers"] == 9
    assert case.slip().converged
    assert rs.new().solve().converged
    with pytest.raises(rs.InputError, match="^screw_diameter: got 25 N") as raised:
        rs.new(screw_diameter="25 N", lead="5 mm")
    assert (raised.value.path, raised.value.got) == ("screw_diameter", "25 N")
    with pytest.raises(rs.InputError, match="screw_diameter: got 25.5; .*write the unit"):
        rs.new(screw_diameter=25.5, lead="5 mm")
    with pytest.raises(TypeError, match="screw_diameter: got .*expected a number with its unit"):
        rs.new(screw_diameter=["25 mm"], lead="5 mm")
    with pytest.raises(rs.InputError, match='lead: missing.*add `lead="10 mm"`'):
        rs.new("standard", "25 mm")
    nine = rs.new("standard", "25 mm", "5 mm", rollers=np.int64(9))
    assert nine.name == "<standard 25 mm x 5 mm>" and nine["mechanism.rollers"] == 9


def test_lessons_by_number_and_name() -> None:
    names = rs.lessons()
    assert list(names) == [file.stem for file in lessons()]
    assert all(names.values())
    assert rs.lesson(14) == rs.lesson("14_flight_spectrum") == rs.lesson("flight_spectrum")
    assert rs.lesson(1).solve().load_cases == answer(1, "solve", rs.SolveResult).load_cases
    with pytest.raises(rs.InputError, match="expected the number or the name"):
        rs.lesson("nope")


def test_lists_to_choose_from() -> None:
    assert any(units.startswith("mm, ") for units in rs.units()["units"])
    assert "iso-vg-100" in set(rs.lubricants()["name"])
    found = rs.configurations("24 mm", (6, "mm"))
    assert len(found) > 1 and {"type", "starts_screw", "pitch_mm"} <= set(found.columns)


def test_values_of_cases() -> None:
    case = lesson(1)
    assert case["mechanism.lead"] == "5 mm"
    assert case["mechanism"]["rollers"] == case["mechanism.rollers"] == 11
    assert case["load_cases[0].axial_force"] == case["load_cases[config1-tension].axial_force"]
    assert case.number("mechanism.lead", "um") == 5000.0
    assert case.number("mechanism.rollers") == 11.0
    assert "model.bodies" in case and "mechanism.leed" not in case and 5 not in case
    for path in ("mechanism.leed", "load_cases[99].name", "load_cases[nope].name", "..", ""):
        with pytest.raises(KeyError):
            case[path]
    with pytest.raises(ValueError, match="expected a unit that the value can be converted to"):
        case.number("mechanism.lead", "N")


def test_numbers_with_units_are_values() -> None:
    pint = pytest.importorskip("pint").UnitRegistry()
    for five in ("5.5 mm", (5.5, "mm"), pint.Quantity(5.5, "mm")):
        assert lesson(4).with_({"mechanism.lead": five})["mechanism.lead"] == "5.5 mm"
    study = {"factors": [{"path": "mechanism.lead", "values": (np.array([5.0, 6.0]), "mm")}]}
    values = lesson(4).with_(study={"command": "solve", **study})["study.factors[0].values"]
    assert values == ["5.0 mm", "6.0 mm"]


def test_cases_are_handed_over(tmp_path: Path) -> None:
    nine = lesson(1).with_({"mechanism.rollers": 9})
    file = tmp_path / "nine.yaml"
    assert nine.to_yaml(file) is None
    text = file.read_text(encoding="utf-8")
    assert text == nine.to_yaml()
    assert "# Lesson 1" in text and "rollers: 9" in text
    again = rs.Case.from_yaml(file)
    assert again.overrides == [] and again.solve().load_cases == nine.solve().load_cases
    flight = lesson(14).with_({"mechanism.rollers": 9})
    flight.to_yaml(tmp_path / "flight.yaml")
    assert rs.Case.from_yaml(tmp_path / "flight.yaml").life().life == flight.life().life


def test_responses_say_what_they_need() -> None:
    frame = lesson(1).responses("measures").set_index("path")
    assert frame.loc["measures.material_volume_cm3", "defined"]
    weight = frame.loc["measures.weight_kg"]
    assert not weight["defined"] and "materials.density" in weight["needs"]
    assert weight["unit"] == "kg" and weight["title"]
    solved = lesson(1).responses()
    defined = solved[solved["defined"]]["path"].tolist()
    assert lesson(1).evaluate({"mechanism.rollers": [11]}, defined).converged.all()


@pytest.mark.parametrize("path", ["slip.efficiency", "weight_kg", "peak_pressure_MPa.max"])
def test_explanations_are_those_of_the_program(path: str, program: Run) -> None:
    assert answer(9, "slip").explain(path) == program("measures", "--explain", path).stdout


def test_help_has_unit_equation_and_source() -> None:
    said = rs.records.Slip.__doc__ or ""
    assert "power_loss_W [W]: lost to all sources of friction; Sandu 2018, (3.51)" in said
    with pytest.raises(ValueError, match="expected the path of a quantity"):
        answer(9, "slip").explain("nope")
    assert "load_cases[].slip.efficiency\n" in answer(9, "slip").explain()


def test_notebooks_show_headlines(monkeypatch: pytest.MonkeyPatch) -> None:
    jammed = lesson(9).with_({"friction.model": {"coulomb": 50}}).slip()
    assert "did not converge" in jammed._repr_html_()
    shown = answer(1, "solve")._repr_html_()
    assert "config1-tension" in shown and "stiffness, N/µm" in shown and "data:image/png" in shown
    designs = lesson(1).evaluate({"mechanism.rollers": [9, 11]})
    assert "2 designs" in designs._repr_html_() and "mechanism.rollers" in designs._repr_html_()


def test_progress_shows_in_notebooks(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Kernel:
        IPKernelApp = type("IPKernelApp", (), {"initialized": staticmethod(lambda: True)})

    monkeypatch.setitem(sys.modules, "ipykernel.kernelapp", Kernel)  # type: ignore[arg-type]
    lesson(16).study(progress=True)
    assert "145 of 145 designs" in capsys.readouterr().err


def test_libraries_load_when_they_are_needed() -> None:
    code = "import sys, rollerscrew; print({'pandas', 'matplotlib', 'xarray'} & set(sys.modules))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"


def test_histories_of_arrays() -> None:
    x = np.linspace(0.0, 60.0, 601)
    force = 10.0 + 5.0 * np.sin(x)
    history: dict[str, Any] = {"force": (force, "kN"), "position": (x, "mm")}
    case = lesson(14)
    result = case.life(history=history)
    assert result.converged
    frame = pd.DataFrame({"force_kN": force, "position_mm": x})
    assert case.life(history=frame).life == result.life
    time = frame.assign(time_s=0.5 * np.arange(601.0))
    expected = case.life(history=time).life
    assert expected.system.l10_hours != result.life.system.l10_hours
    assert case.life(history=time.set_index("time_s")).life == expected
    frame.index = pd.Timestamp("2026-11-29") + pd.to_timedelta(time.time_s, unit="s")
    assert case.life(history=frame).life == expected
    frame.index = pd.to_timedelta(time.time_s, unit="s")
    assert case.life(history=frame).life == expected
    for index, message in {
        "t": "got the column 't'; expected one as",
        None: "got an index of float64 without a name",
    }.items():
        frame.index = pd.Index(0.5 * np.arange(601.0), name=index)
        with pytest.raises(ValueError, match=message):
            case.life(history=frame)
    with pytest.raises(ValueError, match="got 'time' as index and as column"):
        case.life(history=time.set_index(time.time_s.rename("time_s")))
    assert case.life(history={**history, "force": (2.0 * force, "kN")}).life != result.life
    with pytest.raises(TypeError, match="got no unit"):
        case.life(history={"force": force})
    runs = case.with_({"operation": {"speed": "600 rpm"}})
    with pytest.warns(UserWarning, match="hours are those of motion at operation.speed, 600 rpm"):
        assert runs.life(history=history).life.system.l10_hours
    timed = runs.life(history=history, interval="0.5 s").life.system.l10_hours
    assert timed == pytest.approx(expected.system.l10_hours, rel=0.01)


def test_assumed_values_in_the_way_of_a_change_say_how_the_case_is_made_anew() -> None:
    given: dict[str, Any] = {
        "starts": 5,
        "nut_length": "85 mm",
        "load": "30 kN",
        "speed": "1500 rpm",
    }
    case = rs.new("standard", "30 mm", "10 mm", **given)
    changes = {"mechanism.lead": (8, "mm"), "roughness": "0.3 um", "operation.speed": "900 rpm"}
    with pytest.raises(
        rs.InputError, match="dedendum: got .*assumed for the values of bef"
    ) as raised:
        case.with_(changes)
    assert raised.value.path == "mechanism.thread.screw.dedendum"
    call = str(raised.value).rpartition("make the case anew, `")[2].removesuffix("`")
    anew = eval(call, {"rollerscrew": rs})
    made = rs.new("standard", "30 mm", "8 mm", **given | {"speed": "900 rpm"})
    assert anew == made.with_({"roughness": "0.3 um"}) and anew.check()
    with pytest.raises(rs.InputError, match="dedendum") as raised:
        case.with_({"mechanism.thread.screw.dedendum": "3 mm"})
    assert "anew" not in str(raised.value)


# What is not there says where it is


def test_paths_that_are_none_say_what_is_meant() -> None:
    case = lesson(1)
    with pytest.raises(KeyError, match="no 'lead' there; .*did you mean 'mechanism.lead'"):
        case["lead"]
    with pytest.raises(KeyError, match="there are 6 entries, config1-tension, "):
        case["load_cases[9].axial_force"]
    assert set(case.inputs()["path"]) >= {"mechanism.lead", "model.bodies"}
    with pytest.raises(rs.InputError) as raised:
        case.with_(mechanism={"rollers": 9})
    assert "`with_({'mechanism.rollers': ..})` changes one value" in raised.value.__notes__[0]


def test_attributes_that_are_none_say_what_is_meant() -> None:
    result: Any = answer(1, "solve")
    with pytest.raises(AttributeError, match=r"mean load_cases\[0\].axial_stiffness_N_per_um\?"):
        _ = result.axial_stiffness_N_per_um
    with pytest.raises(AttributeError, match="did you mean .*plot_load_distribution"):
        _ = result.plot_loads
    with pytest.raises(AttributeError, match="mean axial_stiffness_N_per_um, tangent_stiffness"):
        _ = result.load_cases[0].stiffness
    with pytest.raises(ValueError, match="did you mean efficiency"):
        result.explain("eficiency")
    assert "designs" not in dir(rs) and {"Case", "new", "plots"} <= set(dir(rs))


def test_lists_have_no_place_in_the_text() -> None:
    loads = lesson(1).with_(load_cases=[{"axial_force": "3 kN", "share": "equal"}])
    with pytest.raises(ValueError, match=r"load_cases=.* cannot .* `Case\(case.check"):
        loads.to_yaml()
    resolved = rs.Case(loads.check().resolved_input)
    assert rs.Case.from_text(resolved.to_yaml()).contact().load_cases == loads.contact().load_cases


@pytest.mark.parametrize(("number", "command"), [(18, "measures"), (9, "slip"), (14, "life")])
def test_responses_are_what_evaluate_answers(number: int, command: Any) -> None:
    case = lesson(number)
    frame = case.responses(command)
    rollers = {"mechanism.rollers": [case["mechanism.rollers"]]}
    defined = frame[frame["defined"]]["path"].tolist()
    assert case.evaluate(rollers, defined, command=command).converged.all()
    for path in frame[~frame["defined"]]["path"].tolist():
        with pytest.raises(rs.InputError, match=r"^responses\[0\]: got "):
            case.evaluate(rollers, [path], command=command)


def test_arrays_of_missing_numbers_are_arrays() -> None:
    case = lesson(12).with_(
        {
            "life": {
                "position": "20 mm",
                "spectrum": [{"force": "40 kN", "direction": "tension", "share": 1}],
            }
        }
    )
    flank = case.life().life.compression.screw
    assert not np.isfinite(flank.l10_revolutions).any()
    assert not case.responses("life").empty


def test_responses_of_commands() -> None:
    paths = lesson(12).responses("preload")["path"].tolist()
    numbers = lesson(12).evaluate({"mechanism.rollers": [9]}, paths[:5], command="preload")
    assert np.isfinite(numbers.values).all()
    with pytest.raises(ValueError, match="command: got 'check'; expected contact | solve"):
        lesson(1).responses("check")  # type: ignore[arg-type]


def test_cases_load_cases_and_searches_are_shown() -> None:
    case = rs.new("standard", "25 mm", "5 mm").with_({"mechanism.rollers": 9})
    shown = case._repr_html_()
    assert "mechanism.rollers=9" in shown and "<td>5 mm</td>" in shown
    assert "ready for check, contact, solve" in shown and "preload (lacks preload)" in shown
    assert "Static safety" in case.check()._repr_html_()
    assert "L10 in time, h" in case.life()._repr_html_()
    assert "dynamic capacity" in case.measures()._repr_html_()
    load_case = case.solve().load_cases[0]
    shown = load_case._repr_html_()
    assert "axial stiffness" in shown and "data:image/png;base64," in shown
    assert load_case.screw is not None and "50 numbers from" in load_case.screw._repr_html_()
    assert "<th>design</th>" in answer(23, "optimize")._repr_html_()
    assert "standard_deviation" in answer(16, "study")._repr_html_()


@pytest.mark.parametrize("number", [7, 8, 41])
def test_what_a_case_must_change_is_shown(number: int) -> None:
    case = lesson(number)
    wrong = [name for name, state in case.check().commands.items() if "wrong" in state]
    for shown in (case._repr_html_(), case.check()._repr_html_()):
        assert wrong and all(f"{name} (" in shown for name in wrong) and "to change: " in shown


@pytest.mark.parametrize("kind", [None, 5, "--help", "-x", "nope"])
def test_types_that_are_none_are_refused(kind: Any) -> None:
    with pytest.raises(rs.InputError, match="type: got .*; expected one of standard, inverted"):
        rs.new(kind)


def test_errors_of_the_program_are_of_arguments() -> None:
    with pytest.raises(rs.InputError, match="^lead is missing; expected it as an argument$"):
        rs.configurations("24 mm")
    with pytest.raises(rs.InputError, match="screw_diameter: got --help; expected a length"):
        rs.new("standard", "--help", "5 mm")


FIVE: Any = 5
WRONG: dict[str, tuple[Callable[[], Any], type[Exception], str]] = {
    "explore": (lambda: rs.explore(FIVE), TypeError, "case: got 5; expected a Case"),
    "size": (lambda: rs.size(FIVE), TypeError, "requirement: got 5; expected a path"),
    "draw": (lambda: rs.plots.draw({}), TypeError, "description: got {}; expected one of"),
    "number": (lambda: lesson(1).number("mechanism.lead", FIVE), TypeError, "unit: got 5; expect"),
    "explain": (lambda: answer(1, "solve").explain(FIVE), TypeError, "path: got 5; expected"),
    "report": (lambda: lesson(1).report("x", results=FIVE), TypeError, "results: got 5; expected"),
    "place": (lambda: solved().load_case(99), IndexError, "load_case: got 99; there are 6"),
    "half": (lambda: solved().load_case(FIVE / 2), TypeError, "load_case: got 2.5; expected a pl"),
    "ellipses": (lambda: solved().plot_ellipses(99), IndexError, "load_case: got 99; there are 6"),
    "pressures": (lambda: solved().plot_pressures(FIVE / 2), TypeError, "load_case: got 2.5"),
    "interface": (lambda: solved().plot_butterfly("foo"), ValueError, "interface: got 'foo'; exp"),
    "models": (lambda: compared().plot_loads(99), IndexError, "load_case: got 99; there are 6"),
    "design": (lambda: designs().case(5), IndexError, "design: got 5; there are 1"),
    "best": (lambda: designs().best(FIVE), TypeError, "response: got 5; expected a text"),
    "history": (lambda: lesson(4).life(history=no_rows()), ValueError, "history: got a frame with"),
}


def solved() -> rs.SolveResult:
    return answer(1, "solve", rs.SolveResult)


def compared() -> rs.CompareResult:
    return answer(1, "compare", rs.CompareResult)


def designs() -> rs.Designs:
    return lesson(1).evaluate({"mechanism.rollers": [9]}, ["axial_stiffness_N_per_um"])


def no_rows() -> pd.DataFrame:
    return pd.DataFrame({"force_kN": []}, index=pd.DatetimeIndex([]))


@pytest.mark.filterwarnings("ignore:the page is static")
@pytest.mark.parametrize("name", WRONG)
def test_wrong_calls_name_the_argument(name: str) -> None:
    call, error, message = WRONG[name]
    with pytest.raises(error, match=message):
        call()
