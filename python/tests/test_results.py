"""Results as text, pickles and data frames."""

from __future__ import annotations

import csv
import json
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
from conftest import Run, answer, lesson, lesson_commands

Written = Callable[[int, str], Path]

#: A document of each kind.
KINDS: list[tuple[int, str, type[rs.Result]]] = [
    (1, "check", rs.CheckResult),
    (7, "contact", rs.ContactResult),
    (1, "solve", rs.SolveResult),
    (1, "compare", rs.CompareResult),
    (9, "slip", rs.SlipResult),
    (12, "preload", rs.PreloadResult),
    (14, "life", rs.LifeResult),
    (18, "measures", rs.MeasuresResult),
    (16, "study", rs.StudyResult),
    (17, "study", rs.DerivativesResult),
    (22, "optimize", rs.OptimizationResult),
]
ALL_KINDS = pytest.mark.parametrize(("number", "command", "kind"), KINDS)


def assert_same(a: Any, b: Any) -> None:
    """Values, and what is in them, bit for bit."""
    assert type(a) is type(b)
    if isinstance(a, dict):
        assert list(a) == list(b)
        for name in a:
            assert_same(a[name], b[name])
    elif isinstance(a, list):
        assert len(a) == len(b)
        for x, y in zip(a, b, strict=True):
            assert_same(x, y)
    elif isinstance(a, np.ndarray):
        np.testing.assert_array_equal(a, b, strict=True)
    else:
        assert a == b


def as_json(value: Any) -> Any:
    """Records, arrays and lists as `json` reads them; NaN is null."""
    if isinstance(value, np.ndarray):
        return as_json(value.tolist())
    if isinstance(value, dict):
        return {name: as_json(item) for name, item in value.items()}
    if isinstance(value, list):
        return [as_json(item) for item in value]
    return None if isinstance(value, float) and value != value else value


def test_every_command_has_a_method_and_a_class(program: Run) -> None:
    described = json.loads(program("schema", "results").stdout)["analyses"]
    names = [analysis["name"] for analysis in described]
    assert names == [*lesson(1).check().commands, "size"]
    for analysis in described:
        kind = getattr(rs, analysis["class"])
        assert issubclass(kind, rs.Result) and kind.__name__ in rs.__all__
        method = getattr(rs if analysis["name"] == "size" else rs.Case, analysis["name"])
        assert method.__doc__
        if analysis["name"] != "study":  # Derivatives are a class of their own.
            assert method.__annotations__["return"] == kind.__name__


# Text


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_text_reads_back(stem: str, command: str) -> None:
    result = answer(stem, command)
    again = type(result).from_json(result.to_json())
    assert type(again) is type(result)
    assert again.to_json() == result.to_json()


@ALL_KINDS
def test_values_read_back(number: int, command: str, kind: type[rs.Result]) -> None:
    result = answer(number, command)
    assert type(result) is kind
    assert_same(kind.from_json(result.to_json()).to_dict(), result.to_dict())


@ALL_KINDS
def test_values_are_those_of_the_text(number: int, command: str, kind: type[rs.Result]) -> None:
    result = answer(number, command)
    assert as_json(result.to_dict()) == json.loads(result.to_json())


@pytest.mark.parametrize("protocol", [0, 2, pickle.HIGHEST_PROTOCOL])
@ALL_KINDS
def test_pickle(number: int, command: str, kind: type[rs.Result], protocol: int) -> None:
    result = answer(number, command)
    again = pickle.loads(pickle.dumps(result, protocol))
    assert type(again) is kind
    assert again.to_json() == result.to_json()
    assert_same(again.to_dict(), result.to_dict())


def test_pickled_studies_keep_all_designs() -> None:
    result = answer(20, "study", rs.StudyResult)
    again = pickle.loads(pickle.dumps(result))
    assert len(again.all_designs) == 40_000
    pd.testing.assert_frame_equal(again.to_frame(), result.to_frame())
    assert not again.all_designs.values.flags.writeable


def test_pickled_optimizations_keep_their_case() -> None:
    result = answer(22, "optimize", rs.OptimizationResult)
    assert pickle.loads(pickle.dumps(result)).best_case == result.best_case
    with pytest.raises(ValueError, match="run `optimize`"):
        _ = rs.OptimizationResult.from_json(result.to_json()).best_case


@pytest.mark.parametrize("number", [10, 11, 15, 16, 19, 21])
def test_designs_of_a_text_are_those_of_the_study(number: int) -> None:
    result = answer(number, "study", rs.StudyResult)
    again = rs.StudyResult.from_json(result.to_json())
    assert again.all_designs.responses == result.all_designs.responses
    np.testing.assert_array_equal(again.all_designs.values, result.all_designs.values)
    assert not again.all_designs.values.flags.writeable
    pd.testing.assert_frame_equal(again.to_frame(), result.to_frame(), check_dtype=False)


def test_long_studies_show_the_first_designs() -> None:
    result = answer(20, "study", rs.StudyResult)
    again = rs.StudyResult.from_json(result.to_json())
    shown = len(again.all_designs)
    assert shown == len(result.designs) - 1 <= len(result.all_designs)
    np.testing.assert_array_equal(again.all_designs.values, result.all_designs.values[:shown])


BAD_TEXTS: dict[str, str] = {
    "empty": "",
    "space": " \n",
    "no JSON": "mechanism: {}",
    "a list": "[]",
    "a number": "1",
    "null": "null",
    "a text": '"prs_version"',
    "another object": "{}",
    "truncated": '{"prs_version": "1.0.0", "load_cases": [{"name": "a"',
    "trailing": '{"prs_version": "0"} {}',
    "trailing comma": '{"prs_version": "0",}',
    "comment": '{"prs_version": "0" /* */}',
    "single quotes": "{'prs_version': '0'}",
    "NaN": '{"prs_version": NaN}',
    "Infinity": '{"prs_version": -Infinity}',
    "NUL": "\0",
    "NUL inside": '{"prs_version": "\0"}',
    "control character": '{"prs_version": "\x01"}',
    "half a character": '{"prs_version": "\ud800"}',
    "half an escape": r'{"prs_version": "\ud800"}',
    "arrays without end": "[" * 100_000,
    "objects without end": '{"a":' * 100_000,
    "deep arrays": '{"prs_version": ' + "[" * 100_000 + "]" * 100_000 + "}",
    "deep objects": '{"prs_version": ' + '{"a":' * 100_000 + "1" + "}" * 100_000 + "}",
    "huge": " " * 10_000_000,
    "long text": '"' + "x" * 10_000_000,
}


@pytest.mark.parametrize("name", BAD_TEXTS)
@pytest.mark.parametrize("kind", [rs.Result, rs.SolveResult, rs.StudyResult])
def test_bad_texts(name: str, kind: type[rs.Result]) -> None:
    with pytest.raises(ValueError, match="document: "):
        kind.from_json(BAD_TEXTS[name])


def test_numbers_beyond_a_double() -> None:
    with pytest.raises(ValueError, match="no result document"):
        rs.Result.from_json('{"prs_version": "0", "x": 1e999}')


@pytest.mark.parametrize("text", [None, b"{}", bytearray(b"{}"), 1, [], {}, object(), Path("x")])
def test_no_texts(text: Any) -> None:
    with pytest.raises(TypeError, match="expected a text"):
        rs.SolveResult.from_json(text)


@pytest.mark.parametrize("cut", [0.1, 0.5, 0.9, 0.999])
def test_truncated_documents(cut: float) -> None:
    text = answer(1, "solve").to_json()
    with pytest.raises(ValueError, match="no result document"):
        rs.SolveResult.from_json(text[: int(cut * len(text))])


def test_subclasses_read_back_as_themselves() -> None:
    class Mine(rs.SolveResult):
        __slots__ = ()

    assert type(Mine.from_json(answer(1, "solve").to_json())) is Mine


# Frames


def csv_table(file: Path) -> pd.DataFrame:
    """A file of the program, its numbers to the last digit; nothing is NaN or None."""
    with file.open(encoding="utf-8", newline="") as lines:
        header, *rows = csv.reader(lines)
    columns = dict(zip(header, zip(*rows, strict=True), strict=True))
    return pd.DataFrame({name: _column(texts) for name, texts in columns.items()})


def _column(texts: tuple[str, ...]) -> list[Any]:
    try:
        return [float(text) if text else np.nan for text in texts]
    except ValueError:
        return [{"true": True, "false": False, "": None}.get(text, text) for text in texts]


def assert_columns(frame: pd.DataFrame, table: pd.DataFrame, names: dict[str, str]) -> None:
    """Columns of a frame are those of a table of the program: {name in the frame: in the table}."""
    assert len(frame) == len(table)
    for in_frame, in_table in names.items():
        assert _present(frame[in_frame]) == _present(table[in_table]), in_frame


def _present(column: pd.Series[Any]) -> list[Any]:
    """Values; None where there is none."""
    return [None if x is None or x == "" or x != x else x for x in column.tolist()]


def common(frame: pd.DataFrame, table: pd.DataFrame) -> dict[str, str]:
    return {str(name): str(name) for name in frame.columns if name in table.columns}


#: Frames with the file that has the same: names that differ there, and what the file has more.
FRAMES: list[tuple[int, str, str, str, dict[str, str], set[str] | None]] = [
    (3, "solve", "load_cases_frame", "load_cases.csv", {}, None),
    (9, "slip", "load_cases_frame", "load_cases.csv", {}, None),
    (18, "measures", "load_cases_frame", "load_cases.csv", {}, None),
    (9, "slip", "slip_threads_frame", "slip_threads.csv", {}, None),
    (10, "slip", "slip_threads_frame", "slip_threads.csv", {}, None),
    (12, "preload", "to_frame", "preload.csv", {
        "sides_tension_axial_load_N": "tension_side_load_N",
        "sides_tension_max_normal_load_N": "tension_side_max_normal_load_N",
        "sides_compression_axial_load_N": "compression_side_load_N",
        "without_preload_axial_displacement_um": "without_preload_displacement_um",
    }, {"compression_side_max_normal_load_N", "without_preload_status"}),
    (14, "life", "threads_frame", "life_threads.csv", {}, set()),
    (15, "study", "to_frame", "study.csv", {}, None),
    (16, "study", "to_frame", "study.csv", {}, None),
    (21, "study", "to_frame", "study.csv", {}, None),
    (17, "study", "to_frame", "derivatives.csv", {"path": "factor"}, None),
    (22, "optimize", "front_frame", "front.csv", {}, {"compromise"}),
]  # fmt: skip


@pytest.mark.parametrize(("number", "command", "method", "file", "other", "more"), FRAMES)
def test_frames_are_the_files(
    number: int, command: str, method: str, file: str, other: dict[str, str], more: set[str] | None,
    written: Written,
) -> None:  # fmt: skip
    result = answer(number, command)
    frame = getattr(result, method)()
    if isinstance(result, rs.StudyResult):  # The file begins with the base case.
        frame = pd.concat([result.base.to_frame(), frame], ignore_index=True)
    table = csv_table(written(number, "solve" if command == "measures" else command) / file)
    names = common(frame, table) | other
    assert command == "preload" or set(names) == set(frame.columns) - {"loads"} | (
        {"loads"} & {*table}
    )
    assert more is None or set(table.columns) - set(names.values()) == more
    assert_columns(frame, table, names)


@pytest.mark.parametrize(("number", "command"), [(3, "solve"), (9, "slip"), (1, "solve")])
def test_threads_frame(number: int, command: str, written: Written) -> None:
    result = answer(number, command, rs.SolveResult)
    frame = result.threads_frame()
    table = csv_table(written(number, command) / "load_distribution.csv")
    assert set(frame["loads"]) <= {"static", "running"}
    assert list(frame.columns[:7]) == [
        "case",
        "axial_force_N",
        "direction",
        "position_mm",
        "loads",
        "interface",
        "thread",
    ]
    assert len(frame) == 2 * len(table)
    for interface in ("screw", "nut"):
        part = frame[frame.interface == interface].reset_index(drop=True)
        names = {str(name): str(name) for name in frame.columns[[0, 1, 2, 3, 6]]}
        names |= {str(name): f"{interface}_{name}" for name in frame.columns[7:]}
        assert_columns(part, table, names)


def test_load_case_by_place_and_name() -> None:
    result = answer(1, "solve", rs.SolveResult)
    assert result.load_case("config2-tension").name == result.load_case(1).name
    assert result.load_case().name == "config1-tension"
    assert result.load_case(-1).name == "config3-compression"
    with pytest.raises(KeyError, match="no load case 'nope'; there is config1-tension, "):
        result.load_case("nope")
    with pytest.raises(IndexError):
        result.load_case(99)


def test_slip_frame(written: Written) -> None:
    frame = answer(9, "slip", rs.SlipResult).slip_frame()
    table = csv_table(written(9, "slip") / "slip.csv")
    names = common(frame, table)
    assert {"case", "axial_force_N", "slip_ratio", "efficiency", "power_loss_W"} <= set(names)
    assert_columns(frame, table, names | {"slip_ratio_estimates_simple": "slip_ratio_simple"})


def test_heat_frames(written: Written) -> None:
    result = answer(30, "slip", rs.SlipResult)
    frame, table = result.heat_frame(), csv_table(written(30, "slip") / "heat.csv")
    assert list(frame["case"]) == ["pull", "return"]
    assert list(frame["temperature_degC_rollers"]) == list(table["temperature_rollers_degC"])
    cycle = result.heat_cycle_frame()
    assert list(cycle.columns) == ["time_s", "screw_degC", "rollers_degC", "nut_degC"]
    assert len(cycle) == len(csv_table(written(30, "slip") / "heat_cycle.csv"))
    assert cycle["rollers_degC"].max() == result.heat_cycle.peak_degC.rollers


def test_measures_frame(written: Written) -> None:
    result = answer(18, "measures", rs.MeasuresResult)
    frame = result.measures_frame()
    table = csv_table(written(18, "measures") / "measures.csv")
    rows = {(row[0], row[1]): row[2] for row in frame.itertuples(index=False)}
    shared = 0
    for row in table.to_dict("records"):
        key = (row["load_case"] or "", row["measure"])
        if key in rows:
            shared += 1
            assert rows[key] == row["value"]
    assert shared > 0.5 * len(table)


@pytest.mark.parametrize("number", [10, 11, 19])
def test_study_frame_of_one_factor_at_a_time(number: int, written: Written) -> None:
    result = answer(number, "study", rs.StudyResult)
    frame = pd.concat([result.base.to_frame(), result.to_frame()], ignore_index=True)
    table = csv_table(written(number, "study") / "study.csv")
    responses = {name: name for name in result.all_designs.responses}
    assert_columns(frame, table, {**responses, "status": "status", "reason": "reason"})
    for row, (factor, number_there) in enumerate(zip(table.factor, table.number, strict=True)):
        if pd.isna(factor) or pd.isna(number_there):
            continue
        columns = [
            name for name in frame.columns if re.fullmatch(rf"{re.escape(factor)}(_.*)?", name)
        ]
        assert number_there in [frame[name][row] for name in columns]


def test_statistics_frame() -> None:
    result = answer(15, "study", rs.StudyResult)
    frame = result.statistics_frame()
    designs = result.all_designs
    for response in designs.responses:
        values = designs[response][designs.converged]
        row: dict[Any, Any] = frame.loc[response].to_dict()
        assert row["count"] == values.size
        assert row["mean"] == pytest.approx(values.mean(), rel=1e-12)
        assert row["standard_deviation"] == pytest.approx(values.std(ddof=1), rel=1e-9)
        assert (row["min"], row["max"]) == (values.min(), values.max())
        assert designs[response][int(row["max_design"]) - 1] == values.max()  # The base case is 0.


def test_check_frame() -> None:
    result = answer(1, "check", rs.CheckResult)
    frame = result.to_frame()
    assert list(frame.columns) == ["path", "value", "default", "written", "basis"]
    assert frame.default.dtype == bool
    assert (frame.basis == "default").equals(frame.default)
    values = dict(zip(frame.path, frame.value, strict=True))
    assert values["mechanism.lead"] == "5 mm"


def test_contact_frame() -> None:
    result = answer(7, "contact", rs.ContactResult)
    frame = result.to_frame()
    assert list(frame.columns) == ["screw", "nut"]
    assert frame.loc["curvature_sum_per_mm", "nut"] == result.contact.nut.curvature_sum_per_mm


def test_frames_of_results_that_were_read() -> None:
    for number, command, kind in KINDS:
        result, again = answer(number, command), kind.from_json(answer(number, command).to_json())
        for name in dir(kind):
            if not (name.endswith("_frame")):
                continue
            frame, other = getattr(result, name)(), getattr(again, name)()
            pd.testing.assert_frame_equal(frame, other, check_dtype=False)


def test_frames_without_anything() -> None:
    empty = rs.SlipResult.from_json('{"prs_version": "0", "load_cases": []}')
    assert empty.load_cases_frame().empty
    assert empty.threads_frame().empty
    assert empty.converged
    assert lesson(7).contact().threads_frame().shape[1] > 0 or not lesson(7).contact().load_cases


def test_points_of_an_envelope() -> None:
    result = lesson(21).study(threads=2)
    assert isinstance(result, rs.StudyResult)
    frame = result.envelope_frame()
    assert list(frame["name"]) == [point["name"] for point in result.envelope["points"]]
    by_design = result.to_frame()
    for _, point in frame.iterrows():
        for response in result.study.responses:
            assert point[response] == by_design.loc[point["design"] - 1, response]


def test_constraints_of_an_optimization() -> None:
    result = lesson(22).optimize(threads=2)
    frame = result.constraints_frame()
    assert set(frame["of"]) == {"initial", "compromise"}
    assert len(frame) == 2 * len(result.compromise["constraints"])
    assert frame["satisfied"].all()


def test_statistics_are_those_of_the_designs() -> None:
    result = lesson(16).study(threads=2)
    assert isinstance(result, rs.StudyResult)
    frame = result.statistics_frame()
    assert list(frame.index) == result.study.responses
    values = result.all_designs["axial_stiffness_N_per_um"]
    np.testing.assert_allclose(frame.loc["axial_stiffness_N_per_um", "mean"], values.mean())
    np.testing.assert_allclose(
        frame.loc["axial_stiffness_N_per_um", "quantile_0.05"], np.quantile(values, 0.05)
    )


def test_documents_of_other_commands_are_refused() -> None:
    solved = answer(5, "solve").to_json()
    for kind in (rs.LifeResult, rs.PreloadResult, rs.StudyResult, rs.OptimizationResult):
        with pytest.raises(ValueError, match=f"no document of a {kind.__name__}: got"):
            kind.from_json(solved)


def test_load_cases_one_or_several() -> None:
    result = answer(1, "solve", rs.SolveResult)
    for which in ("config1-tension", 0, ["config1-tension"], [0]):
        ax = result.plot_load_distribution(which)
        shares = {tuple(line.get_ydata()) for line in ax.get_lines()}
        assert tuple(result.load_cases[0].screw.load_rate_percent) in shares
        plt.close("all")


def test_a_mission_has_one_efficiency_and_one_peak() -> None:
    mission = lesson(30).with_({"heat.cycles": 2, "heat.start": "25 degC"})
    cycle = mission.slip().heat_cycle
    verdict = {c.name: c for c in mission.check().verdict.criteria}
    assert verdict["efficiency"].value == pytest.approx(cycle.efficiency, rel=1e-12)
    peak = max(cycle.peak_degC.screw, cycle.peak_degC.rollers, cycle.peak_degC.nut)
    assert verdict["temperature"].value == pytest.approx(peak, rel=1e-12)
