"""Whatever is passed, the interpreter lives and the exception says what was expected."""

from __future__ import annotations

import gc
import multiprocessing
import random
import string
import subprocess
import sys
import threading
from collections import UserDict, UserString
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, lesson
from rollerscrew import _engine

HELPFUL = (TypeError, ValueError, KeyError, AttributeError)


def nested(kind: str, levels: int) -> Any:
    value: Any = 1
    for _ in range(levels):
        value = {"a": value} if kind == "dict" else [value]
    return value


def endless(kind: str) -> Any:
    if kind == "dict":
        one: dict[str, Any] = {}
        one["a"] = one
        return one
    if kind == "list":
        many: list[Any] = []
        many.append(many)
        return many
    array = np.empty(1, dtype=object)
    array[0] = array
    return array


class Rude:
    """Raises wherever it is looked at."""

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name)

    def __repr__(self) -> str:
        raise RuntimeError("no")

    __str__ = __repr__


class RudeMapping(dict[str, Any]):
    def items(self) -> Any:
        raise LookupError("no items")


VALUES: dict[str, Any] = {
    "None": None,
    "object": object(),
    "type": int,
    "function": len,
    "module": string,
    "rude": Rude(),
    "mock": MagicMock(),
    "huge int": 10**5000,
    "negative huge int": -(10**5000),
    "large int": 2**64,
    "NaN": float("nan"),
    "infinity": float("inf"),
    "complex": 1j,
    "decimal": Decimal("9"),
    "fraction": Fraction(9, 1),
    "bytes": b"9",
    "bytearray": bytearray(b"9"),
    "memoryview": memoryview(b"9"),
    "long bytes": b"9" * 10**6,
    "set": {9},
    "generator": (x for x in (9,)),
    "iterator": iter([9]),
    "path": Path("9"),
    "user string": UserString("9"),
    "user dict": UserDict({"a": UserDict()}),
    "half a character": "\ud800",
    "two halves": "\ud83d\ude00",
    "NUL": "9\0",
    "control": "\x01\x7f\x1b[31m",
    "long text": "nine" * 250_000,
    "long words": "nine " * 10**5,
    "lines": "9\n" * 1000,
    "quotes": "\"'`",
    "YAML": "{a: [b, &c d, *c, !!python/object:os.system x]}",
    "open brackets": "[{" * 5000,
    "anchor": "&a [*a]",
    "comment": "9 # nine",
    "document end": "9\n...\n---\nmechanism: {}",
    "directive": "%YAML 9.9",
    "override": "9=10",
    "recursive dict": endless("dict"),
    "recursive list": endless("list"),
    "recursive array": endless("array"),
    "deep dict": nested("dict", 500),
    "very deep dict": nested("dict", 50_000),
    "deep list": nested("list", 50_000),
    "wide list": list(range(30_000)),
    "wide dict": {f"k{k}": k for k in range(5_000)},
    "keys of numbers": {1: 2},
    "keys of None": {None: 2},
    "keys of bytes": {b"a": 2},
    "keys of halves": {"\ud800": 2},
    "keys of NUL": {"\0": 2},
    "empty key": {"": 2},
    "long key": {"k" * 10**6: 2},
    "rude mapping": RudeMapping(a=1),
    "long double": np.longdouble("1e4000"),
    "long complex": np.clongdouble(1j),
    "date": np.datetime64("2020-01-01"),
    "structured": np.zeros(2, dtype=[("a", "f8")]),
    "void": np.void(b"abc"),
    "NaT": np.timedelta64("NaT", "s"),
    "array of objects": np.array([object(), None], dtype=object),
    "no elements": np.zeros((0, 3)),
}


def sources_of_error(value: Any) -> list[Any]:
    """Everything that takes a value of a case."""
    case = lesson(1)
    file = case.name
    return [
        lambda: case.with_(**{"mechanism.rollers": value}),
        lambda: case.with_(mechanism=value),
        lambda: rs.Case.from_yaml(file, set={"mechanism.rollers": value}),
        lambda: rs.Case({"mechanism": {"rollers": value}}),
        lambda: rs.Case({"mechanism": value}),
        lambda: rs.Case(value),
        lambda: rs.Case.from_text(value),
        lambda: rs.Case.from_yaml(value),
        lambda: case.evaluate({"mechanism.rollers": [value, value]}, ["axial_stiffness_N_per_um"]),
        lambda: case.evaluate({"mechanism.rollers": value}, ["nope"]),
        lambda: case.evaluate({"mechanism.rollers": [9]}, [value]),
        lambda: case.evaluate({"mechanism.rollers": [9]}, ["nope"], command=value),
        lambda: case.with_(study=value).study(),
        lambda: rs.SolveResult.from_json(value),
    ]


#: Python's own exceptions go through: of a mapping that cannot be read, of missing memory.
OWN_ERRORS = {"rude mapping": (LookupError,)}


@pytest.mark.parametrize("name", VALUES)
def test_values_of_all_kinds(name: str) -> None:
    for place, call in enumerate(sources_of_error(VALUES[name])):
        try:
            call()
        except (*HELPFUL, *OWN_ERRORS.get(name, ())) as error:
            message = str(error)
            assert message, f"{place}: {type(error).__name__} without a sentence"
            assert "incompatible function arguments" not in message, place
            assert len(message) < 20_000 or str(VALUES[name]) in message, place


@pytest.mark.parametrize("kind", ["dict", "list", "array"])
def test_values_that_contain_themselves(kind: str) -> None:
    with pytest.raises(ValueError, match="levels deep, or contain themselves"):
        lesson(1).with_(mechanism=endless(kind))
    with pytest.raises(ValueError, match="levels deep, or contain themselves"):
        rs.Case({"mechanism": endless(kind)})


@pytest.mark.parametrize("levels", [64, 65, 100, 1000, 100_000])
def test_deep_values(levels: int) -> None:
    value = nested("dict", levels)
    with pytest.raises(ValueError, match="levels|unknown key"):
        rs.Case({"mechanism": value})
    while isinstance(value, dict):  # Long chains of dictionaries are taken apart step by step.
        value = value.pop("a")


@pytest.mark.parametrize(
    "key",
    [
        "",
        ".",
        "..",
        "[",
        "]",
        "[]",
        "[0]",
        "mechanism.",
        ".mechanism",
        "mechanism[0]",
        "load_cases[-1]",
    ]
    + [
        "load_cases[99999999999999999999]",
        "load_cases[0",
        "load_cases[a]",
        "load_cases[0]]",
        "=",
        "a=b",
    ]
    + ["a" * 10**6, "a." * 10_000, "[0]" * 10_000, "\0", "\n", "mechanism\0.rollers", "ü", "\ud800"]
    + ["mechanism.rollers=", "study", "__class__", "{a: b}", "*", "mechanism rollers"],
    ids=lambda key: ascii(key)[:30],
)
def test_paths_of_all_kinds(key: str) -> None:
    with pytest.raises(ValueError):
        lesson(1).with_(**{key: 9})
    with pytest.raises(ValueError):
        rs.Case({key: {"a": 9}})
    with pytest.raises((ValueError, TypeError)):
        lesson(1).evaluate({key: [9, 10]}, ["axial_stiffness_N_per_um"])


@pytest.mark.parametrize(
    "file",
    [None, 5, 5.5, b"configs", object(), [], "", "\0", "a\0b", "\ud800", "x" * 10**6, "/dev/null"]
    + ["/dev/zero", "/proc/self/mem", "/", "~", "nothing/here.yaml"],
    ids=lambda file: ascii(file)[:20],
)
def test_files_of_all_kinds(file: Any) -> None:
    with pytest.raises(HELPFUL) as raised:
        rs.Case.from_yaml(file)
    assert "incompatible function arguments" not in str(raised.value)


@pytest.mark.parametrize("name", [None, 5, b"x", Path("x"), "\ud800"], ids=ascii)
def test_names_of_all_kinds(name: Any) -> None:
    for call in (rs.Case.from_text, lambda text, name: rs.Case({"mechanism": {}}, name=name)):
        with pytest.raises((TypeError, ValueError), match="name: got"):
            call(lesson(1).text, name=name)


@pytest.mark.parametrize("overrides", [None, {}])
def test_no_overrides(overrides: Any) -> None:
    assert rs.Case.from_yaml(lesson(1).name, set=overrides) == lesson(1)


@pytest.mark.parametrize("overrides", [[1], "a=b", 5, {5: 9}, {None: 1}, ["a=b"]], ids=ascii)
def test_overrides_of_other_kinds(overrides: Any) -> None:
    with pytest.raises(TypeError, match="expected a (dictionary|text)"):
        rs.Case.from_yaml(lesson(1).name, set=overrides)


@pytest.mark.parametrize(
    "text",
    [
        "[" * 1_000_000,
        "a: b\n" * 1_000_000,
        "x" * 5_000_000,
        "\ufeff",
        "---\n" * 10_000,
        "\r" * 10**5,
    ]
    + [
        "? " * 10_000,
        "- " * 10_000,
        "a:\n" + " " * 10**6,
        "{a: " * 20_000,
        "'" * 10**6,
        "&a " * 10**5,
    ],
    ids=lambda text: f"{ascii(text)[:12]}-{len(text)}",
)
def test_junk_ends_soon(text: str) -> None:
    with pytest.raises(rs.InputError) as raised:
        rs.Case.from_text(text)
    assert len(str(raised.value)) < 10_000


def test_aliases_are_bounded() -> None:
    lines = ["a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"]
    lines += [f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 10)}]" for k in range(1, 12)]
    with pytest.raises(rs.InputError, match="aliases expanded"):
        rs.Case.from_text("\n".join(lines))


def test_random_changes_of_a_case() -> None:
    generator = random.Random(1)
    text = (CONFIGS / "09_slip_and_dissipation.yaml").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    solved = 0
    for _ in range(300):
        changed = list(lines)
        for _ in range(generator.choice([1, 1, 2, 5])):
            at = generator.randrange(len(changed))
            line = changed[at]
            place = generator.randrange(len(line) + 1)
            changed[at] = generator.choice(
                [
                    line[:place] + generator.choice(string.printable) + line[place:],
                    line[:place] + line[place + 1 :],
                    line[:place],
                    "",
                    line + "\n" + line,
                ]
            )
        try:
            rs.Case.from_text("\n".join(changed)).slip().to_json()
            solved += 1
        except rs.InputError:
            pass
    assert 0 < solved < 300


# Objects of the engine


@pytest.mark.parametrize(
    "kind", [_engine.Node, _engine.Document, _engine.StudyRows, _engine.Designs]
)
def test_objects_of_the_engine_are_not_made_by_hand(kind: Any) -> None:
    with pytest.raises(TypeError):
        kind()


@pytest.mark.parametrize("kind", [rs.Case, rs.SolveResult, rs.StudyResult, rs.Record])
def test_objects_without_content(kind: Any) -> None:
    bare = kind.__new__(kind)
    for name in ("solve", "text", "load_cases", "to_json", "all_designs", "keys", "_node"):
        with pytest.raises((AttributeError, TypeError)):
            value = getattr(bare, name)
            value()


def study() -> _engine.Study:
    return _engine.Study(_engine.Source.load(lesson(10).name, []))


@pytest.mark.parametrize("first", [0, 1, 94, 95, 96, 2**31, 2**63, 2**64 - 1, 2**64, -1, 1.5, None])
@pytest.mark.parametrize("count", [0, 1, 96, 2**63, 2**64 - 1, -1, "1"])
def test_ranges_of_designs(first: Any, count: Any) -> None:
    inside = all(isinstance(x, int) and x >= 0 for x in (first, count)) and first + count <= 95
    for call in (study().record, lambda a, b: study().failed_record(a, b, "why")):
        if inside:
            assert isinstance(call(first, count), bytes)
        else:
            with pytest.raises((IndexError, TypeError)):
                call(first, count)


@pytest.mark.parametrize(
    "numbers",
    [
        np.zeros((1, 3)),
        np.zeros((3, 0)),
        np.zeros(12),
        np.zeros((1, 1, 12)),
        np.zeros((2, 12), "f4"),
    ]
    + [
        np.full((2, 12), np.nan),
        np.full((2, 12), -1.0),
        np.full((2, 12), 1e300),
        [[0.0] * 12],
        None,
    ]
    + [np.zeros((2, 24))[:, ::2], np.asfortranarray(np.zeros((2, 12)))],
    ids=lambda numbers: f"{type(numbers).__name__}{getattr(numbers, 'shape', '')}",
)
def test_arrays_of_designs(numbers: Any) -> None:
    try:
        answers = study().evaluate(numbers, 1)
    except (ValueError, TypeError, IndexError):
        return
    assert answers.values.shape == (len(numbers), len(answers.responses))


def test_records_with_errors_in_them() -> None:
    source = study()
    good = [source.record(0, 32), source.record(32, 32), source.record(64, 31)]
    generator = random.Random(1)
    for _ in range(100):
        records = [bytearray(record) for record in good]
        record = generator.choice(records)
        for _ in range(generator.choice([1, 2, 8])):
            record[generator.randrange(generator.choice([8, 32, len(record)]))] = generator.choice(
                [0, 1, 127, 255]
            )
        try:
            rows = source.collect([bytes(record) for record in records])
            rows.document().text()
            assert rows.designs().values.shape[0] == 95
        except (ValueError, IndexError, RuntimeError):
            pass


# Threads and processes


def test_results_vanish_while_they_are_read() -> None:
    shared: list[Any] = [lesson(1).solve()]
    stop = threading.Event()

    def replace() -> None:
        while not stop.is_set():
            shared[0] = lesson(1).solve()
            gc.collect()

    def read(_: int) -> float:
        array = shared[0].load_cases[0].screw.axial_load_N
        return float(array.sum())

    other = threading.Thread(target=replace)
    other.start()
    try:
        with ThreadPoolExecutor(8) as pool:
            sums = set(pool.map(read, range(400)))
    finally:
        stop.set()
        other.join()
    assert len(sums) == 1


def solved(case: rs.Case) -> rs.SolveResult:
    return case.solve()


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
@pytest.mark.parametrize("start", ["fork", "spawn", "forkserver"])
def test_processes_answer_alike(start: str) -> None:
    if start not in multiprocessing.get_all_start_methods():
        pytest.skip(f"no {start} here")
    cases = [lesson(1).with_(**{"mechanism.rollers": count}) for count in (8, 9, 10, 11)]
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(start)) as pool:
        answers = list(pool.map(solved, cases))
    assert [each.to_json() for each in answers] == [case.solve().to_json() for case in cases]


WORST = {
    "deep documents": """
        for text in ('[' * 10**7, '{"a":' * 10**6, '{"prs_version":' * 10**6 + '1' + '}' * 10**6):
            raises(lambda: rs.Result.from_json(text))
        """,
    "deep cases": """
        for text in ('[' * 10**6, '{a: ' * 10**5, '- ' * 10**6, 'a:\\n' + ' ' * 10**6):
            raises(lambda: rs.Case.from_text(text))
        """,
    "deep values": """
        value = last = {}
        for _ in range(10**6):
            last['a'] = last = {}
        raises(lambda: case.with_(mechanism=value))
        raises(lambda: rs.Case(value))
        import os; sys.stdout.flush(); print('done', flush=True); os._exit(0)
        """,
    "low recursion limit": """
        sys.setrecursionlimit(120)
        raises(lambda: case.with_(mechanism=nested(60)))
        """,
    "threads": """
        import threading
        def work():
            for _ in range(20):
                case.solve().load_cases[0].screw.axial_load_N.sum()
        threads = [threading.Thread(target=work) for _ in range(50)]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        """,
    "fork with threads": """
        import os, threading, warnings
        warnings.simplefilter('ignore')
        for _ in range(50):
            fresh = rs.Case.from_text(case.text)
            thread = threading.Thread(target=lambda: fresh.solve().to_json())
            thread.start()
            child = os.fork()
            if child == 0:
                os._exit(0 if fresh.solve().converged else 1)
            assert os.waitpid(child, 0)[1] == 0
            thread.join()
        """,
    "fork with busy threads": """
        import os, threading, warnings
        warnings.simplefilter('ignore')
        stop = False
        def work():
            while not stop:
                case.solve().to_json()
        threads = [threading.Thread(target=work) for _ in range(2)]
        [thread.start() for thread in threads]
        for _ in range(100 if 'PRS_THOROUGH' in os.environ else 20):
            child = os.fork()
            if child == 0:
                os._exit(0 if case.solve().converged else 1)
            assert os.waitpid(child, 0)[1] == 0
        stop = True
        [thread.join() for thread in threads]
        """,
    "threads at exit": """
        import threading
        sweep = {'from': '1 kN', 'to': '45 kN', 'steps': 20_000}
        case = case.with_(**{'load_cases[0].axial_force': sweep})
        threading.Thread(target=case.solve, daemon=True).start()
        work_goes_on()
        """,
    "loops at exit": """
        import threading
        def again(call):
            while True:
                call()
        forces = {'load_cases[0].axial_force': ([1.0, 2.0], 'kN')}
        calls = [case.solve, case.contact, lambda: rs.Case.from_text(case.text),
                 lambda: case.solve().to_json(), lambda: case.evaluate(forces)]
        for call in calls:
            threading.Thread(target=again, args=(call,), daemon=True).start()
        work_goes_on()
        """,
    "results at exit": """
        import builtins
        builtins.kept = [case.solve(), case.solve().load_cases[0].screw.axial_load_N]
        class Late:
            def __del__(self):
                builtins.kept[0].to_json()
        builtins.late = Late()
        """,
    "objects that end in a callback": """
        def show(done, total):
            global case
            case = None
            gc.collect()
        lesson16 = rs.Case.from_yaml(configs + '/16_abevi_parameters.yaml')
        del case
        text = lesson16.study(progress=show).to_json()
        """,
    "studies within callbacks": """
        lesson16 = rs.Case.from_yaml(configs + '/16_abevi_parameters.yaml')
        inner = []
        def show(done, total):
            if not inner:
                inner.append(None)
                inner[0] = lesson16.study().to_json()
        assert lesson16.study(progress=show).to_json() == inner[0]
        """,
}

_HEAD = """
import faulthandler, gc, signal, sys
faulthandler.enable()
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGPROF])  # In all threads; see below.
import rollerscrew as rs
configs = sys.argv[1]
case = rs.Case.from_yaml(configs + '/01_config_1_to_3.yaml')
def nested(levels):
    return {'a': nested(levels - 1)} if levels else 1
def work_goes_on():
    # Waits until the processors have worked for this process, on whatever thread.
    signal.setitimer(signal.ITIMER_PROF, 0.2)
    signal.sigwait([signal.SIGPROF])
def raises(call):
    try:
        call()
    except (ValueError, TypeError, RecursionError):
        return
    raise AssertionError('nothing was raised')
"""


#: Killed by std::terminate: the lock of the interpreter is asked for while that ends.
STUDY_AT_EXIT = """
        import threading
        study = {'command': 'solve', 'plan': 'monte_carlo', 'samples': 500_000,
                 'factors': [{'path': 'load_cases[0].axial_force', 'within': '3 %'}]}
        threading.Thread(target=case.with_(study=study).study, daemon=True).start()
        work_goes_on()
        """


def test_studies_at_exit() -> None:
    assert assert_survives(STUDY_AT_EXIT) == ""  # Writing while streams are closed aborts Python.


@pytest.mark.parametrize("name", WORST)
def test_nothing_ends_the_interpreter(name: str) -> None:
    assert_survives(WORST[name])


def assert_survives(indented: str) -> str:
    """Runs a script in a process of its own, and returns what it writes to stderr."""
    lines = indented.splitlines()
    script = _HEAD + "\n".join(line[8:] for line in lines) + "\nprint('done')\n"
    run = subprocess.run(
        [sys.executable, "-c", script, str(CONFIGS)],
        capture_output=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )
    assert run.returncode == 0, run.stderr[-3000:]
    assert run.stdout.endswith("done\n")
    return run.stderr
