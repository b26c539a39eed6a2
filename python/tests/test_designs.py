"""Many designs: arrays of inputs, studies on executors, optimizations."""

from __future__ import annotations

import math
import multiprocessing
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import (
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from concurrent.futures.process import BrokenProcessPool
from typing import Any

import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
from conftest import CONFIGS, answer, lesson
from rollerscrew.designs import Designs

FORCE = "load_cases[0].axial_force"
STIFFNESS = "axial_stiffness_N_per_um"
PRESSURE = "screw.peak_pressure_MPa.max"


@pytest.fixture(scope="module")
def ureg() -> Any:
    return pytest.importorskip("pint").UnitRegistry()


def one_by_one(case: rs.Case, designs: list[dict[str, Any]]) -> np.ndarray[Any, Any]:
    """Stiffness and pressure of each design, by a case of its own."""
    rows = []
    for values in designs:
        load_case = case.with_(**values).solve().load_cases[0]
        rows.append([load_case.axial_stiffness_N_per_um, load_case.screw.peak_pressure_MPa.max()])
    return np.array(rows)


# Arrays of inputs


def test_evaluate_warns_of_inputs_that_overrides_make_void() -> None:
    angles = {"mechanism.flank_angle": ([40.0, 50.0], "deg")}
    said = "flank_angle: moves no load or stiffness .axial_stiffness_N_per_um.: overridden by"
    with pytest.warns(UserWarning, match=said) as warned:
        designs = lesson(1).evaluate(angles, [STIFFNESS, PRESSURE])
    assert [warning.filename for warning in warned] == [__file__]
    assert designs[STIFFNESS][0] == designs[STIFFNESS][1]
    assert designs[PRESSURE][0] != designs[PRESSURE][1]
    designs = lesson(4).evaluate(angles, [STIFFNESS, PRESSURE])  # Warnings are errors.
    assert designs[STIFFNESS][0] != designs[STIFFNESS][1]


def test_studies_say_which_factor_moved_nothing() -> None:
    factors = [{"path": "mechanism.flank_angle", "values": ["40 deg", "50 deg"]}]
    for plan in ({"plan": "grid"}, {"plan": "monte_carlo", "samples": 10}):
        study = {"command": "solve", **plan, "factors": factors, "responses": [STIFFNESS]}
        void, idle = lesson(1).with_(study=study).study().warnings
        assert "moves no load or stiffness" in void
        assert "mechanism.flank_angle: moved no response" in idle
        assert lesson(4).with_(study=study).study().warnings == []


def test_evaluate_is_solving_one_by_one() -> None:
    generator = np.random.default_rng(1)
    forces = generator.uniform(1, 45, 25)
    rollers = generator.integers(5, 12, 25)
    diameters = generator.uniform(44, 55, 25)
    words = generator.choice(["flexible", "rigid_bending"], 25)
    designs = lesson(1).evaluate(
        {
            FORCE: (forces, "kN"),
            "mechanism.rollers": rollers,
            "structure.nut.outer_diameter": (diameters, "mm"),
            "model.roller": words,
        },
        [STIFFNESS, PRESSURE],
    )
    expected = one_by_one(
        lesson(1),
        [
            {
                FORCE: f"{force!r} kN",
                "mechanism.rollers": int(count),
                "structure.nut.outer_diameter": f"{diameter!r} mm",
                "model.roller": str(word),
            }
            for force, count, diameter, word in zip(
                forces.tolist(), rollers, diameters.tolist(), words, strict=True
            )
        ],
    )
    assert designs.converged.all()
    np.testing.assert_allclose(designs.values, expected, rtol=1e-9)


def test_answers_are_a_frame() -> None:
    forces = np.array([10.0, 20.0, 30.0])
    designs = lesson(1).evaluate(
        {FORCE: (forces, "kN"), "mechanism.rollers": [9, 10, 11]}, [STIFFNESS, PRESSURE]
    )
    assert isinstance(designs, Designs) and len(designs) == 3
    assert designs.responses == (STIFFNESS, PRESSURE)
    frame = designs.to_frame()
    assert list(frame.columns) == [
        f"{FORCE}_kN",
        "mechanism.rollers",
        "status",
        "reason",
        STIFFNESS,
        PRESSURE,
    ]
    np.testing.assert_array_equal(frame[f"{FORCE}_kN"], forces)
    np.testing.assert_array_equal(frame[STIFFNESS], designs[STIFFNESS])
    with pytest.raises(
        KeyError, match="'nope'; there is load_cases.*, axial_stiffness_N_per_um, screw"
    ):
        designs["nope"]


def test_answers_are_read_only() -> None:
    designs = lesson(1).evaluate({FORCE: ([10.0, 20.0], "kN")}, [STIFFNESS])
    for each in (designs, pickle.loads(pickle.dumps(designs))):
        for array in (each.values, each[STIFFNESS], each.status, each.reason):
            assert not array.flags.writeable
        with pytest.raises(AttributeError):
            each.values = None  # type: ignore[misc]
    assert designs == designs and designs != pickle.loads(pickle.dumps(designs))
    assert isinstance(hash(designs), int)


def test_without_responses_those_of_a_study() -> None:
    designs = lesson(1).evaluate({FORCE: ([45.0], "kN")})
    assert STIFFNESS in designs.responses and PRESSURE in designs.responses
    slip = lesson(9).evaluate({"operation.speed": ([100.0], "rpm")}, command="slip")
    assert "slip.efficiency" in slip.responses


def test_other_commands() -> None:
    speeds = [100.0, 250.0]
    designs = lesson(9).evaluate(
        {"operation.speed": (speeds, "rpm")}, ["slip.efficiency"], command="slip"
    )
    expected = [
        lesson(9).with_(**{"operation.speed": f"{speed} rpm"}).slip().load_cases[0].slip.efficiency
        for speed in speeds
    ]
    np.testing.assert_allclose(designs["slip.efficiency"], expected, rtol=1e-9)


@pytest.mark.parametrize(
    "values",
    [
        [9, 11],
        (9, 11),
        range(9, 12, 2),
        np.array([9, 11]),
        np.array([9, 11], dtype=np.int8),
        np.array([9.0, 11.0]),
        np.array([9, 10, 11])[::2],
        pd.Series([9, 11], index=["a", "b"]),
        [9.0, 11],
    ],
    ids=lambda values: f"{type(values).__name__}",
)
def test_counts(values: Any) -> None:
    expected = one_by_one(lesson(1), [{"mechanism.rollers": 9}, {"mechanism.rollers": 11}])
    designs = lesson(1).evaluate({"mechanism.rollers": values}, [STIFFNESS, PRESSURE])
    np.testing.assert_allclose(designs.values, expected, rtol=1e-12)


@pytest.mark.parametrize(
    "of",
    [
        lambda u: ([10.0, 20.5], "kN"),
        lambda u: (np.array([10e3, 20.5e3]), "N"),
        lambda u: (np.array([10, 20.5], dtype=np.longdouble), "kN"),
        lambda u: u.Quantity([10.0, 20.5], "kN"),
        lambda u: u.Quantity([10.0, 20.5], "kN").to("lbf"),
        lambda u: [u.Quantity(10.0, "kN"), u.Quantity(20.5e3, "N")],
        lambda u: [u.Quantity(10.0, "kN"), "20.5 kN"],
        lambda u: ["10 kN", "20500 N"],
        lambda u: ("10 kN", "20500 N"),
        lambda u: np.array(["10 kN", "20.5 kN"]),
        lambda u: pd.Series(["10 kN", "20.5 kN"]),
    ],
)
def test_units(of: Callable[[Any], Any], ureg: Any) -> None:
    expected = one_by_one(lesson(1), [{FORCE: "10 kN"}, {FORCE: "20.5 kN"}])
    designs = lesson(1).evaluate({FORCE: of(ureg)}, [STIFFNESS, PRESSURE])
    np.testing.assert_allclose(designs.values, expected, rtol=1e-9)


def test_columns_hold_numbers_where_their_name_has_a_unit() -> None:
    case = lesson(1)
    numbers = case.evaluate({FORCE: ([10.0, 20.0], "kN")}, [STIFFNESS]).inputs
    assert list(numbers.columns) == [f"{FORCE}_kN"]
    assert numbers.dtypes.iloc[0] == np.float64
    texts = case.evaluate({FORCE: ["10 kN", "20000 N"]}, [STIFFNESS]).inputs
    assert texts.to_dict("list") == {FORCE: ["10 kN", "20000 N"]}


def test_words_and_blocks() -> None:
    profiles = [{"convex": "4.9 mm"}, {"convex": "5.5 mm"}, {"convex": "4.9 mm"}]
    case = lesson(4)
    designs = case.evaluate({"mechanism.profile.roller": profiles}, [STIFFNESS, PRESSURE])
    expected = one_by_one(case, [{"mechanism.profile.roller": profile} for profile in profiles])
    np.testing.assert_allclose(designs.values, expected, rtol=1e-9)
    np.testing.assert_array_equal(designs.values[0], designs.values[2])


def test_one_design_and_equal_designs() -> None:
    one = lesson(1).evaluate({FORCE: ([45.0], "kN")}, [STIFFNESS])
    many = lesson(1).evaluate({FORCE: (np.full(50, 45.0), "kN")}, [STIFFNESS])
    assert len(one) == 1 and len(many) == 50
    np.testing.assert_array_equal(many[STIFFNESS], one[STIFFNESS][0])


def test_order_is_kept() -> None:
    forces = np.random.default_rng(2).uniform(1, 45, 500)
    designs = lesson(1).evaluate({FORCE: (forces, "kN")}, [STIFFNESS])
    order = np.argsort(forces)
    assert (np.diff(designs[STIFFNESS][order]) > 0).all()


@pytest.mark.parametrize("threads", [1, 2, 7, np.int64(3)])
def test_threads_do_not_matter(threads: int) -> None:
    forces = np.linspace(1, 45, 301)
    expected = lesson(1).evaluate({FORCE: (forces, "kN")}, [STIFFNESS]).values
    designs = lesson(1).evaluate({FORCE: (forces, "kN")}, [STIFFNESS], threads=threads)
    np.testing.assert_array_equal(designs.values, expected)


def test_impossible_designs_are_rows_with_their_reason() -> None:
    designs = lesson(1).evaluate({"mechanism.rollers": [9, 50, 11]}, [STIFFNESS, PRESSURE])
    assert list(designs.status) == ["converged", "refused", "converged"]
    assert list(designs.converged) == [True, False, True]
    assert list(designs.reason[[0, 2]]) == ["", ""]
    assert "expected at most 11: more rollers of 7.5" in designs.reason[1]
    assert np.isnan(designs.values[1]).all() and np.isfinite(designs.values[[0, 2]]).all()
    assert list(designs.to_frame()["status"]) == list(designs.status)


def test_numbers_that_cannot_be_solved_are_rows() -> None:
    designs = lesson(1).evaluate({FORCE: ([-5.0, 10.0], "kN")}, [STIFFNESS])
    assert list(designs.status) == ["refused", "converged"]
    assert "expected a force > 0" in designs.reason[0]


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("container", [list, np.array])
def test_numbers_that_are_not_finite(number: float, container: Any) -> None:
    with pytest.raises(ValueError, match=r"axial_force\[1\]: got .*; expected finite numbers"):
        lesson(1).evaluate({FORCE: (container([1.0, number]), "kN")}, [STIFFNESS])
    with pytest.raises(ValueError, match="expected finite numbers"):
        lesson(1).evaluate({"mechanism.rollers": container([9, number])}, [STIFFNESS])


WRONG_INPUTS: dict[str, tuple[Any, type[Exception], str]] = {
    "nothing": (None, TypeError, "expected a dictionary of arrays"),
    "no inputs": ({}, TypeError, "expected a dictionary of arrays"),
    "a list": ([1, 2], TypeError, "expected a dictionary of arrays"),
    "lengths": ({FORCE: ([1, 2], "kN"), "mechanism.rollers": [9]}, ValueError, "2 of load_cases"),
    "empty list": ({FORCE: ([], "kN")}, ValueError, "with at least one value"),
    "empty array": ({"mechanism.rollers": np.array([])}, ValueError, "with at least one value"),
    "empty texts": ({FORCE: []}, ValueError, "with at least one value"),
    "two dimensions": ({FORCE: (np.ones((2, 2)), "kN")}, ValueError, "of one dimension"),
    "lists of lists": ({FORCE: [[1], [2]]}, rs.InputError, "got a list of 1"),
    "ragged": ({FORCE: [[1], [1, 2]]}, rs.InputError, "got a list of 1"),
    "a number": ({"mechanism.rollers": 9}, ValueError, "expected an array"),
    "a text": ({FORCE: "10 kN"}, ValueError, "expected an array"),
    "bytes": ({FORCE: b"10 kN"}, ValueError, "of one dimension"),
    "a generator": ({FORCE: (x for x in "ab")}, ValueError, "of one dimension"),
    "None inside": ({FORCE: None}, ValueError, "of one dimension"),
    "objects": ({FORCE: np.array([object()])}, TypeError, "expected a number"),
    "complex": ({FORCE: [1j]}, TypeError, "expected a number"),
    "dates": ({FORCE: np.array(["2020"], dtype="M8[D]")}, TypeError, "expected a number"),
    "flags": ({"mechanism.rollers": [True]}, rs.InputError, "got true"),
    "masked": (
        {FORCE: (np.ma.array([1.0, 2.0], mask=[False, True]), "kN")},
        ValueError,
        "masked",
    ),
    "no unit": ({FORCE: [10.5, 20.5]}, rs.InputError, r'\(numbers, "kN"\)'),
    "another dimension": ({FORCE: ([10.5, 20.5], "mm")}, rs.InputError, "unit of a length"),
    "no such unit": ({FORCE: ([10.5, 20.5], "bananas")}, rs.InputError, "not a known unit"),
    "texts with unit": ({FORCE: (["10", "20"], "kN")}, TypeError, "numbers next to the unit 'kN'"),
    "path": ({"mechanism.rolers": [9]}, rs.InputError, "did you mean `rollers`"),
    "empty path": ({"": [9]}, rs.InputError, "path"),
    "path that is no text": ({5: [9]}, TypeError, "path: got 5; expected a text"),
    "path within another": (
        {"mechanism.rollers": [9], "mechanism": [{}]},
        rs.InputError,
        "none is a part of another",
    ),
    "fractions of rollers": (
        {"mechanism.rollers": [9.0, 9.6]},
        rs.InputError,
        r"\[1\]: got 9\.6; expected a whole number",
    ),
    "huge": ({"mechanism.rollers": [10**400]}, ValueError, "400 digits"),
    "unsigned": ({"mechanism.rollers": np.array([2**64 - 1], np.uint64)}, rs.InputError, "expect"),
    "half a character": ({FORCE: ["\ud800"]}, ValueError, "UTF-8"),
}


@pytest.mark.parametrize("name", WRONG_INPUTS)
def test_wrong_inputs(name: str) -> None:
    inputs, error, message = WRONG_INPUTS[name]
    with pytest.raises(error, match=message) as raised:
        lesson(1).evaluate(inputs, [STIFFNESS])
    assert isinstance(raised.value, (ValueError, TypeError))


@pytest.mark.parametrize(
    ("responses", "error"),
    [
        (["nope"], rs.InputError),
        ([], rs.InputError),
        ([1], rs.InputError),
        ([None], rs.InputError),
        ([STIFFNESS, STIFFNESS], rs.InputError),
        ([object()], TypeError),
        ("axial_stiffness_N_per_um", TypeError),
        (5, TypeError),
        (["\ud800"], ValueError),
        (["x" * 10**6], rs.InputError),
    ],
    ids=lambda value: ascii(value)[:20],
)
def test_wrong_responses(responses: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        lesson(1).evaluate({"mechanism.rollers": [9]}, responses)


@pytest.mark.parametrize(
    ("keywords", "error"),
    [
        ({"command": "fly"}, rs.InputError),
        ({"command": 5}, rs.InputError),
        ({"command": "slip"}, rs.InputError),
        ({"threads": 0}, ValueError),
        ({"threads": -1}, ValueError),
        ({"threads": 10**30}, ValueError),
        ({"threads": 1.5}, TypeError),
        ({"threads": "2"}, TypeError),
    ],
)
def test_wrong_options(keywords: dict[str, Any], error: type[Exception]) -> None:
    with pytest.raises(error):
        lesson(1).evaluate({"mechanism.rollers": [9]}, [STIFFNESS], **keywords)


@pytest.mark.thorough
def test_a_million_designs() -> None:
    forces = np.linspace(1.0, 45.0, 1_000_000)
    designs = lesson(5).evaluate({FORCE: (forces, "kN")}, [STIFFNESS])
    assert designs.converged.all()


# Studies


class Here(Executor):
    """Does everything at once, in this thread."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(self.answer(fn, *args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future

    def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
        return fn(*args, **kwargs)


class Failing(Here):
    """Each second task raises."""

    def __init__(self, error: Exception) -> None:
        self.error = error
        self.tasks: list[tuple[int, int]] = []

    def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
        first, count = args[-2:]
        self.tasks.append((first, count))
        if len(self.tasks) % 2 == 0:
            raise self.error
        return fn(*args, **kwargs)


def test_arrays_have_a_dimension_of_threads() -> None:
    threads = {"path": "mechanism.contacts_per_roller", "values": [18, 22]}
    study = {"command": "solve", "plan": "grid", "factors": [threads]}
    case = lesson(1).with_(study={**study, "responses": [STIFFNESS, "screw.load_rate_percent"]})
    designs = case.study().all_designs
    shares = designs["screw.load_rate_percent"]
    assert shares.shape == (2, 22)
    np.testing.assert_allclose(np.nansum(shares, axis=1), 100.0, rtol=1e-9)
    np.testing.assert_array_equal(np.isfinite(shares).sum(axis=1), [18, 22])
    assert "screw.load_rate_percent[21]" in designs.to_frame()
    array = designs.to_xarray()["screw.load_rate_percent"]
    assert array.dims == ("mechanism.contacts_per_roller", "thread")
    assert array.thread[0] == 1
    again = rs.StudyResult.from_json(case.study().to_json()).all_designs
    np.testing.assert_allclose(again["screw.load_rate_percent"], shares, rtol=1e-8)
    assert case.study().plot_threads("screw.load_rate_percent").get_ylabel() == "Thread"


def small_study() -> rs.StudyResult:
    result = answer(16, "study", rs.StudyResult)
    return result


@pytest.mark.parametrize("threads", [1, 2, 16])
def test_threads_do_not_matter_to_studies(threads: int) -> None:
    assert lesson(16).study(threads=threads).to_json() == small_study().to_json()


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_processes_do_not_matter_to_studies(start: str) -> None:
    if start not in multiprocessing.get_all_start_methods():
        pytest.skip(f"no {start} here")
    context = multiprocessing.get_context(start)
    with ProcessPoolExecutor(2, mp_context=context) as pool:
        result = lesson(16).study(executor=pool)
    assert isinstance(result, rs.StudyResult)
    assert result.to_json() == small_study().to_json()
    np.testing.assert_array_equal(result.all_designs.values, small_study().all_designs.values)


@pytest.mark.parametrize("executor", [lambda: ThreadPoolExecutor(3), Here], ids=["pool", "here"])
@pytest.mark.parametrize("number", [10, 16, 21])
def test_executors_do_not_matter_to_studies(number: int, executor: Any) -> None:
    with executor() as pool:
        result = lesson(number).study(executor=pool)
    expected = answer(number, "study", rs.StudyResult)
    assert result.to_json() == expected.to_json()
    pd.testing.assert_frame_equal(result.to_frame(), expected.to_frame())


def test_derivatives_need_no_executor() -> None:
    result = lesson(17).study(executor=Failing(RuntimeError("nobody calls")))
    assert isinstance(result, rs.DerivativesResult)
    assert result.to_json() == answer(17, "study").to_json()


@pytest.mark.parametrize("number", [10, 15])
def test_what_workers_cannot_answer_are_failed_rows(number: int) -> None:
    pool = Failing(ZeroDivisionError("of the worker"))
    result = lesson(number).study(executor=pool)
    assert isinstance(result, rs.StudyResult)
    failed = np.zeros(1 + len(result.all_designs), dtype=bool)
    for first, count in pool.tasks[1::2]:
        failed[first : first + count] = True
    failed = failed[1:]  # The base case is the first.
    assert failed.any() and not failed.all()

    designs = result.all_designs
    assert set(designs.status[failed]) == {"failed"}
    assert set(designs.reason[failed]) == {"ZeroDivisionError: of the worker"}
    assert np.isnan(designs.values[failed]).all()
    expected = answer(number, "study", rs.StudyResult)
    np.testing.assert_array_equal(designs.values[~failed], expected.all_designs.values[~failed])
    pd.testing.assert_frame_equal(designs.inputs, expected.all_designs.inputs)
    assert rs.StudyResult.from_json(result.to_json()).to_json() == result.to_json()


def test_nobody_can_answer() -> None:
    class Dead(Here):
        def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
            raise MemoryError

    result = lesson(16).study(executor=Dead())
    assert isinstance(result, rs.StudyResult)
    assert set(result.all_designs.status) == {"failed"}
    assert result.to_frame().shape == small_study().to_frame().shape


@pytest.mark.parametrize("message", ["", "two\nlines", "Ünï \U0001f600", "x" * 100_000, "\0"])
def test_reasons_of_all_kinds(message: str) -> None:
    result = lesson(10).study(executor=Failing(OSError(message)))
    assert isinstance(result, rs.StudyResult)
    failed = result.all_designs.status == "failed"
    assert set(result.all_designs.reason[failed]) == {f"OSError: {message}"}


def test_reasons_that_are_no_text() -> None:
    result = lesson(10).study(executor=Failing(OSError("\ud800")))
    assert isinstance(result, rs.StudyResult)
    assert "OSError: ?" in result.all_designs.reason


@pytest.mark.parametrize("kind", [BrokenProcessPool, CancelledError])
def test_broken_pools_raise(kind: type[Exception]) -> None:
    with pytest.raises(kind):
        lesson(10).study(executor=Failing(kind("broken")))


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_processes_that_die_raise() -> None:
    class Deadly(ProcessPoolExecutor):
        def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
            return super().submit(os._exit, 3)

    with Deadly(1) as pool, pytest.raises(BrokenProcessPool):
        lesson(16).study(executor=pool)


def test_cancelled_futures_raise() -> None:
    class Cancelling(Executor):
        def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
            future: Future[Any] = Future()
            future.cancel()
            future.set_running_or_notify_cancel()
            return future

    with pytest.raises(CancelledError):
        lesson(16).study(executor=Cancelling())


def test_executors_that_take_no_tasks_raise() -> None:
    pool = ThreadPoolExecutor(1)
    pool.shutdown()
    with pytest.raises(RuntimeError, match="shutdown"):
        lesson(16).study(executor=pool)


@pytest.mark.parametrize(
    "record", [b"", b"junk", b"\0" * 1000, b"\xff" * 1000, None, 5, "text", bytearray(b"x")]
)
def test_executors_that_answer_something_else_raise(record: Any) -> None:
    class Other(Here):
        def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
            return record

    with pytest.raises((ValueError, TypeError, IndexError)):
        lesson(16).study(executor=Other())


def test_executors_that_answer_for_others_raise() -> None:
    class Repeating(Here):
        def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
            return fn(*args[:-2], 0, 10)

    with pytest.raises(ValueError, match="missing"):
        lesson(10).study(executor=Repeating())


@pytest.mark.parametrize("length", [1, 10, 50, -1])
def test_executors_that_lose_bytes_raise(length: int) -> None:
    class Losing(Here):
        def answer(self, fn: Any, *args: Any, **kwargs: Any) -> Any:
            return fn(*args, **kwargs)[:length]

    with pytest.raises((ValueError, IndexError, RuntimeError)):
        lesson(16).study(executor=Losing())


# Progress


RUNS = [
    pytest.param(lambda show: lesson(16).study(progress=show), 145, id="threads"),
    pytest.param(lambda show: lesson(16).study(threads=1, progress=show), 145, id="thread"),
    pytest.param(lambda show: lesson(16).study(executor=Here(), progress=show), 145, id="here"),
    pytest.param(lambda show: lesson(15).study(progress=show), 2001, id="many"),
]


@pytest.mark.parametrize(("run", "total"), RUNS)
def test_progress_grows_to_all(run: Any, total: int) -> None:
    told: list[tuple[int, int]] = []
    run(lambda done, of: told.append((done, of)))
    done = [each for each, _ in told]
    assert {of for _, of in told} == {total}
    assert done == sorted(done) and done[-1] == total and done[0] >= 0


def test_progress_of_optimizations() -> None:
    told: list[tuple[int, int]] = []
    lesson(22).optimize(progress=lambda done, of: told.append((done, of)))
    assert told and told == sorted(told) and told[-1][0] == told[-1][1]


def test_progress_is_quiet_without_terminal(capfd: pytest.CaptureFixture[str]) -> None:
    for progress in (True, False, None):
        lesson(11).study(progress=progress)
    assert capfd.readouterr() == ("", "")


def long_study() -> rs.Case:
    """Takes minutes."""
    return lesson(5).with_(
        study={
            "command": "solve",
            "plan": "monte_carlo",
            "samples": 500_000,
            "factors": [{"path": FORCE, "within": "3 %"}],
        }
    )


class Stop(Exception):
    pass


class StopAtOnce:
    """A progress function that has enough at its first call."""

    def __init__(self) -> None:
        self.told: list[tuple[int, int]] = []

    def __call__(self, done: int, total: int) -> None:
        self.told.append((done, total))
        raise Stop(f"{done} of {total}")


@pytest.mark.parametrize(
    "work",
    [lambda progress: long_study().study(progress=progress)]
    + [lambda progress: lesson(23).optimize(progress=progress)],
    ids=["study", "optimize"],
)
def test_exceptions_of_progress_stop_the_work(work: Callable[[Any], Any]) -> None:
    progress = StopAtOnce()
    with pytest.raises(Stop, match="of"):
        work(progress)
    ((done, total),) = progress.told
    assert done < total


class CountingPool(ThreadPoolExecutor):
    """Knows what it was given."""

    def __init__(self) -> None:
        super().__init__(1)
        self.given: list[Future[Any]] = []

    def submit(self, *arguments: Any, **keywords: Any) -> Future[Any]:
        self.given.append(super().submit(*arguments, **keywords))
        return self.given[-1]


def test_exceptions_of_progress_cancel_what_waits() -> None:
    with CountingPool() as pool:
        with pytest.raises(Stop):
            long_study().study(executor=pool, progress=StopAtOnce())
    # One piece was done; the worker may have begun the next ones before the exception came.
    cancelled = [future.cancelled() for future in pool.given]
    assert len(cancelled) > 100
    assert sum(cancelled) > 0.5 * len(cancelled)


def long_optimization() -> rs.Case:
    text = lesson(23).text
    assert "generations: 300" in text
    return rs.Case.from_text(text.replace("generations: 300", "generations: 10000"))


#: Interrupts itself after a second of work, on all processors together, and says how much more work
#: it did until it stopped, over what it had done before.
INTERRUPT = """
import os, signal, sys, threading, time
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGPROF])
import rollerscrew as rs
case = rs.Case.from_text(sys.stdin.read())
signal.signal(signal.SIGINT, signal.default_int_handler)
sent = []
def send():
    signal.sigwait([signal.SIGPROF])
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=send, daemon=True).start()
signal.setitimer(signal.ITIMER_PROF, 1.0)
try:
    {call}
except KeyboardInterrupt:
    print("stopped after", (time.process_time() - sent[0]) / sent[0])
else:
    print("ran to its end")
"""


@pytest.mark.parametrize(
    ("case", "call"),
    [
        (long_study, "case.study()"),
        (long_study, "case.study(threads=1)"),
        (long_study, "case.study(progress=lambda done, total: None)"),
        (long_optimization, "case.optimize()"),
    ],
)
def test_interrupts_stop_long_work(case: Callable[[], rs.Case], call: str) -> None:
    text = case().text
    if case().overrides:
        text += case().overrides[0].replace("study=", "study: ", 1)
    run = subprocess.run(
        [sys.executable, "-X", "faulthandler", "-c", INTERRUPT.format(call=call)],
        input=text,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith("stopped after"), run.stdout
    assert float(run.stdout.split()[-1]) < 5.0  # To its end it takes a hundred times as much.


@pytest.mark.parametrize(
    "keywords", [{"threads": 0}, {"threads": "x"}, {"executor": 5}, {"progress": 5.5}]
)
def test_wrong_options_of_studies(keywords: dict[str, Any]) -> None:
    (option,) = keywords
    with pytest.raises((ValueError, TypeError), match=f"{option}: got|expected an executor"):
        lesson(11).study(**keywords)


# Optimizations


def test_best_case_is_what_the_document_says() -> None:
    result = answer(22, "optimize", rs.OptimizationResult)
    load_case = result.best_case.contact().load_cases[0]
    stated = result.compromise.responses
    for interface in ("screw", "nut"):
        assert load_case[interface].peak_pressure_MPa.max() == pytest.approx(
            stated[f"{interface}.peak_pressure_MPa.max"], rel=1e-12
        )
    set_by = lesson(22).with_(**dict(each.split("=", 1) for each in result.compromise.set))
    assert set_by.contact().load_cases[0].to_dict().keys() == load_case.to_dict().keys()
    np.testing.assert_array_equal(
        set_by.contact().load_cases[0].screw.peak_pressure_MPa, load_case.screw.peak_pressure_MPa
    )


def test_best_case_without_feasible_design() -> None:
    limits = [{"response": PRESSURE, "at_most": 1}]
    case = lesson(22).with_(**{"optimize.generations": 3, "optimize.constraints": limits})
    result = case.optimize()
    assert "compromise" not in result and "nearest" in result
    pressure = result.best_case.contact().load_cases[0].screw.peak_pressure_MPa.max()
    assert pressure == pytest.approx(result.nearest.responses[PRESSURE], rel=1e-12)


def test_best_case_of_a_case_with_overrides() -> None:
    case = lesson(22).with_(**{"mechanism.rollers": 8, "optimize.generations": 3})
    result = case.optimize()
    pressure = result.best_case.contact().load_cases[0].screw.peak_pressure_MPa.max()
    assert pressure == pytest.approx(result.compromise.responses[PRESSURE], rel=1e-12)


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_optimizations_are_deterministic(threads: int) -> None:
    expected = answer(22, "optimize", rs.OptimizationResult)
    result = lesson(22).optimize(threads=threads)
    assert result.to_json() == expected.to_json()
    assert result.best_case == expected.best_case


def test_seeds_matter() -> None:
    other = lesson(22).with_(**{"optimize.seed": 2}).optimize()
    expected = answer(22, "optimize", rs.OptimizationResult)
    assert other.best_case != expected.best_case


def test_single_values_are_those_of_all_designs() -> None:
    case = rs.Case.from_yaml(CONFIGS / "05_standard_screw.yaml")
    forces = np.array([10.0, 20.0])
    answers = case.evaluate(
        {"load_cases[0].axial_force": (forces, "kN"), "materials.youngs_modulus": "200 GPa"},
        ("axial_stiffness_N_per_um",),
    )
    soft = case.with_({"materials.youngs_modulus": "200 GPa"})
    for force, stiffness in zip(forces, answers["axial_stiffness_N_per_um"], strict=True):
        solved = soft.with_({"load_cases[0].axial_force": f"{force} kN"}).solve()
        expected = solved.load_cases[0].axial_stiffness_N_per_um
        np.testing.assert_allclose(stiffness, expected, rtol=1e-9)
    with pytest.raises(ValueError, match="expected an array"):
        case.evaluate({"materials.youngs_modulus": "200 GPa"})


def test_progress_of_arrays() -> None:
    case = rs.Case.from_yaml(CONFIGS / "05_standard_screw.yaml")
    told: list[tuple[int, int]] = []
    forces = (np.linspace(5.0, 20.0, 1000), "kN")
    case.evaluate(
        {"load_cases[0].axial_force": forces}, progress=lambda *counts: told.append(counts)
    )
    assert told[-1] == (1000, 1000)


def test_no_executor() -> None:
    with pytest.raises(TypeError, match="expected an executor"):
        rs.Case.from_yaml(CONFIGS / "16_abevi_parameters.yaml").study(executor=4)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("options", "message"),
    [({"progress": 3}, "progress: got 3"), ({"threads": "2"}, "threads: got '2'")],
)
def test_options_of_wrong_types(options: dict[str, Any], message: str) -> None:
    case = rs.Case.from_yaml(CONFIGS / "05_standard_screw.yaml")
    with pytest.raises(TypeError, match=message):
        case.evaluate({"load_cases[0].axial_force": ([1.0, 2.0], "kN")}, **options)


def test_a_frame_keeps_its_index_and_its_counts() -> None:
    frame = pd.DataFrame(
        {"mechanism.rollers": [7, 9, 8]}, index=pd.Index(["A", "B", "C"], name="screw")
    )
    designs = lesson(1).evaluate(frame, ["axial_stiffness_N_per_um"])
    answer = designs.to_frame()
    assert answer.index.equals(frame.index)
    assert answer["mechanism.rollers"].dtype == frame["mechanism.rollers"].dtype
    assert designs[[2, 0]].to_frame().index.tolist() == ["C", "A"]
    assert (answer.status == "converged").all()


def test_blocks_of_a_case_are_copies() -> None:
    case = lesson(1)
    case["mechanism"]["rollers"] = 3
    assert case["mechanism.rollers"] != 3


FORCE_OF_PUSH = "load_cases[config1-compression].axial_force"


def test_columns_of_a_frame_name_load_cases_and_units() -> None:
    frame = pd.DataFrame({f"{FORCE_OF_PUSH}_kN": [10.0, 20.0]}, index=["low", "high"])
    stiffness = f"load_cases[config1-compression].{STIFFNESS}"
    designs = lesson(1).evaluate(frame, [stiffness])
    force = lesson(1).with_({FORCE_OF_PUSH: "20 kN"}).solve().load_case("config1-compression")
    assert designs[stiffness][1] == pytest.approx(force.axial_stiffness_N_per_um, rel=1e-9)
    assert designs.best(stiffness, largest=True) == 1
    np.testing.assert_array_equal(designs[f"{FORCE_OF_PUSH}_kN"], [10.0, 20.0])
    with pytest.raises(KeyError, match="no column"):
        designs[f"load_cases[none].{STIFFNESS}"]


def test_xarrays_have_the_index_of_a_frame_and_titles_of_whole_arrays() -> None:
    shares, force = "screw.load_rate_percent", "load_cases[0].axial_force_kN"
    frame = pd.DataFrame({"mechanism.rollers": [11, 9, 11], force: [10.0, 20.0, 20.0]})
    named = lesson(1).evaluate(frame.set_axis(["A", "B", "C"]), [STIFFNESS, shares]).to_xarray()
    assert named["design"].values.tolist() == ["A", "B", "C"]
    assert int(named["mechanism.rollers"].sel(design="B")) == 9
    assert named[shares].attrs == {"long_name": "share of the load, screw", "units": "%"}
    assert "design" not in lesson(1).evaluate(frame, [STIFFNESS]).to_xarray().coords
    along = lesson(1).evaluate(frame[[force]][:2].set_axis(["B", "A"])[::-1], [STIFFNESS])
    assert along.to_xarray()["design"].values.tolist() == ["B", "A"]
    levels = pd.MultiIndex.from_tuples([("x", 1), ("x", 2), ("y", 1)], names=["family", None])
    both = lesson(1).evaluate(frame.set_axis(levels), [STIFFNESS]).to_xarray()
    assert both["family"].values.tolist() == ["x", "x", "y"]
    assert both["level_1"].values.tolist() == [1, 2, 1]


def test_threads_of_xarrays_have_the_numbers_of_the_paths() -> None:
    paths = ["screw.load_rate_percent[19]", "screw.load_rate_percent[0]"]
    paths += [f"nut.load_rate_percent[{k}]" for k in (0, 4)]
    designs = lesson(1).evaluate({FORCE: ([10.0, 20.0], "kN")}, paths)
    maps = designs.to_xarray()
    assert maps.thread.values.tolist() == [1, 5, 20]
    np.testing.assert_array_equal(
        maps["screw.load_rate_percent"].sel(thread=[20, 1]), designs.values[:, :2]
    )
    assert np.isnan(maps["nut.load_rate_percent"].sel(thread=20)).all()
    shares = answer(16, "study", rs.StudyResult).all_designs.to_xarray()
    assert np.isfinite(shares["nut.load_rate_percent"].sel(thread=20)).all()


def test_arrays_over_something_else_have_a_dimension_of_their_own() -> None:
    names = ["response.position_mm[0]", "response.position_mm[7]"]
    maps = lesson(34).evaluate({FORCE: ([10.0], "kN")}, names, command="response").to_xarray()
    assert maps["response.position_mm"].dims[-1] == "response.position_mm_index"
    assert maps["response.position_mm_index"].values.tolist() == [0, 7]
    full = lesson(33).evaluate(
        {FORCE: ([4.0], "kN")}, ["screw.roller_share_percent", "screw.load_rate_percent[1]"]
    )
    assert full.to_xarray()["screw.roller_share_percent"].dims[-1].endswith("_index")
    assert full.to_xarray()["screw.load_rate_percent[1]"].thread.values.tolist() == [*range(1, 7)]


def test_many_inputs_that_are_no_grid_take_no_memory() -> None:
    generator = np.random.default_rng(3)
    frame = pd.DataFrame({f"x{k}": generator.random(1000) for k in range(8)})
    values = generator.random((1000, 1))
    text = np.full(1000, "converged", dtype=object)
    maps = Designs(frame, (STIFFNESS,), values, text, text).to_xarray()
    assert maps.sizes == {"design": 1000}
    assert maps["x7"].dims == ("design",)


def test_counts_of_a_document_are_integers() -> None:
    result = answer(10, "study", rs.StudyResult)
    again = rs.StudyResult.from_json(result.to_json())
    assert result.to_frame().dtypes.equals(again.to_frame().dtypes)
    assert again.to_frame()["mechanism.rollers"].dtype == np.int64


def test_progress_of_slow_designs() -> None:
    told: list[tuple[int, int]] = []
    lesson(33).evaluate(
        {FORCE: (np.linspace(3.0, 5.0, 40), "kN")},
        ["axial_displacement_um"],
        threads=1,
        progress=lambda done, of: told.append((done, of)),
    )
    done = [each for each, _ in told]
    assert {of for _, of in told} == {40} and done == sorted(done)
    assert len(set(done)) > 1 and done[-1] == 40
