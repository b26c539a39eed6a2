"""Attributes of results: annotated as they are, read-only, alive as long as they are needed."""

from __future__ import annotations

import copy
import gc
import keyword
import typing
import weakref
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, answer, lesson, lesson_commands
from rollerscrew import records, results

RESULTS: list[type[rs.Record]] = [getattr(rs, name) for name in results.__all__]

#: Annotated, and in none of the documents here: how a life that was not found failed, the roller
#: whose thread fails first, what `influence`, which takes long, has, and how the loads of
#: `contact`, which are equal shares, were solved.
NEVER_MET = {
    ("Life", "status"),
    ("Verdict", "not_built"),  # Of the light program.
    ("Verdict", "failed"),  # Of an input that a command refuses.
    ("Verdict", "skipped"),  # Of bodies that take long.
    ("WeakestThread", "roller"),
    ("Model", "accuracy"),
    ("ComputedThere", "influence"),  # Of a model that is asked for.
    ("ContactResult", "model"),
    ("SecondNut", "equal_shares"),  # Of load cases without preload.
    ("Response", "stopped_at_s"),  # Of an integration that fails.
    ("InvalidCandidate", "row"),  # All of the catalogue here are sound.
    # Of catalogues that print them, see tests/prs/size.
    *(
        ("SizedCandidate", name)
        for name in ("axial_play_mm", "drag_torque_Nm", "grease_volume_cm3")
    ),
    # Only an export reports these: the screw turns the lever at a known lead there.
    *(("LeverMotion", f"middle_{name}") for name in ("gear_ratio", "reflected_inertia_kg_mm2")),
    # Of curves that cannot tell two unknowns apart, see tests/prs/fit.
    *(("FitDirection", name) for name in ("combination", "direction", "names", "ratio")),
    *(
        ("FitCombination", name)
        for name in (
            "factor",
            "high",
            "kind",
            "low",
            "names",
            "standard_deviation",
            "text",
            "value",
        )
    ),
}

_WAYS_OUT = ("screw_ambient", "nut_ambient", "rollers_ambient")
_HEIGHTS = "{addendum: 0.4 mm, dedendum: 0.5 mm}"
_THREADS = f"{{screw: {_HEIGHTS}, roller: {_HEIGHTS}, nut: {_HEIGHTS}}}"

_PRELOAD = "force: 3 kN, position: 29.1666667 mm, load: {from: -20 kN, to: 20 kN, steps: 5}"
_TWO_NUTS = (
    "{arrangement: double_nut, distance: 68.3333333 mm, "
    f"spacer: {{length: 10 mm, inner_diameter: 36 mm, outer_diameter: 46 mm}}, {_PRELOAD}}}"
)

_BEARING = {"dynamic_capacity": "50 kN", "static_capacity": "90 kN", "preload": "5 kN"}
_LIGHT = "[{axial_force: 3 kN, direction: tension, position: 29.1666667 mm}]"


def _fit(path: str, bounds: str, drag: str) -> dict[str, Any]:
    """Two unknowns from the curve of the torque."""
    return {
        "fit.parameters": f"[{{path: {path}, from: {bounds}}}, "
        f"{{path: {drag}, from: 0 N m, to: 3 N m}}]",
        "fit.curves": "[{name: torque, file: 37_torque.csv, response: slip.torque_screw_Nm, "
        "measured: {column: torque_Nm, unit: N m}, deviation: 0.08 N m, "
        "conditions: [{path: 'load_cases[0].axial_force', column: force_kN, unit: kN}]}]",
        "fit.profile": "[]",
    }


#: Documents with names that no lesson has.
VARIANTS: list[tuple[int, str, dict[str, Any]]] = [
    (1, "contact", {"mechanism.thread": _THREADS}),
    (1, "measures", {"model.tooth_compliance": {"yamamoto": "5 mm"}}),
    (1, "solve", {"model.bodies": "refined"}),
    (9, "measures", {}),
    (10, "slip", {"friction": {"coulomb": 0.1}, "mechanism.thread": _THREADS}),
    (12, "preload", {"mechanism.thread": _THREADS}),
    (
        12,
        "preload",
        {
            "preload": {
                "arrangement": "single_nut",
                "backlash": "5 um",
                "position": "29 mm",
                "load": {"from": "-20 kN", "to": "20 kN", "steps": 5},
            }
        },
    ),
    (14, "life", {"mechanism.thread": _THREADS}),
    (14, "life", {"life.static_capacity": "200 kN"}),
    (14, "life", {"model.mechanism": "full"}),
    (
        24,
        "slip",
        {"friction": {"coulomb": 0.1}, "operation": {"speed": "100 rpm"}},
    ),
    (14, "life", {"bearings.fixed": _BEARING}),
    (
        34,
        "response",
        {
            "response.load": {
                "inertia": "20 kg m^2",
                "linkage": {"base": "500 mm", "arm": "300 mm"},
            },
            "response.start.angle": "90 deg",
        },
    ),
    (
        30,
        "slip",
        {"heat.cycles": 2, "heat.start": "25 degC", "limits": {"temperature": "28 degC"}},
    ),
    (30, "slip", {"heat.conductance": dict.fromkeys(_WAYS_OUT, "1e-6 W/K")}),
    (9, "slip", {"preload": _TWO_NUTS, "load_cases": _LIGHT}),
    (9, "slip", {"preload": _TWO_NUTS, "load_cases": _LIGHT, "operation.speed": "-400 rpm"}),
    (
        9,
        "slip",
        {
            "preload": f"{{arrangement: single_nut, {_PRELOAD}}}",
            "materials.conductivity": "45 W/(m K)",
            "materials.specific_heat": "460 J/(kg K)",
            "materials.density": "7800 kg/m^3",
        },
    ),
    (30, "preload", {"preload": f"{{arrangement: single_nut, {_PRELOAD}}}"}),
    (9, "slip", {"friction": {"coulomb": 0.12}, "operation.speed": "0 rpm", "load_cases": _LIGHT}),
    (
        9,
        "life",
        {
            "load_cases": _LIGHT,
            "life": "{position: 29.1666667 mm, contamination: 0.5, "
            "spectrum: [{force: 9 kN, direction: tension, share: 1}]}",
        },
    ),
    (
        1,
        "solve",
        {"structure.roller.guidance": "{ring: 2e4 N/mm, clearance: 1 um}"},
    ),
    (
        33,
        "solve",
        {
            "load_cases[0].travel": "{turns: 31, steps: 4}",
            "load_cases[1].modes.prestress": "true",
        },
    ),
    (
        33,
        "solve",
        {
            "structure.screw.bearings": "[]",
            "deviations.missing_rollers": "[3]",
            "load_cases[0].side_force": "{y: 2.1 kN, at: 20 mm}",
        },
    ),
    (
        36,
        "response",
        {"response.frequency_response": "{from: 10 Hz, to: 200 Hz, points: 5, force: 1 kN}"},
    ),
    (37, "fit", _fit("friction.coulomb", "0.1, to: 0.4", "carrier.screw_torque")),
    (
        30,
        "life",
        {
            "operation": "{speed: 400 rpm}",
            "life": "{position: 29.1666667 mm, spectrum: "
            "[{force: 9 kN, direction: tension, share: 1}]}",
        },
    ),
    (
        18,
        "measures",
        {
            "measures.system": "{shaft: {length: 300 mm}, support_bearing: 600 N/um, "
            "housing: 1500 N/um}"
        },
    ),
    (
        22,
        "optimize",
        {
            "optimize.generations": 2,
            "optimize.constraints": [{"response": "screw.peak_pressure_MPa.max", "at_most": 1}],
        },
    ),
]


_SEGMENTS = [
    {"duration": "0.2 s", "end_speed": "300 mm/s", "force": "8 kN"},
    {"duration": "1.8 s", "end_speed": "300 mm/s", "force": "8 kN"},
    {"duration": "0.2 s", "end_speed": "0 mm/s", "force": "8 kN"},
]
_DESIGNS = {"screw_diameter": "24 mm", "lead": ["10 mm", "40 mm"], "starts": 5}
_LUBRICATED = {"relubrication": "10 h", "back_driving": "allowed"}
#: A lever with its motor; from the program's catalogue; what nothing passes; a preloaded mission.
REQUIREMENTS: list[dict[str, Any] | Path] = [
    CONFIGS / "40_lever.yaml",
    {
        "motion": {"segments": _SEGMENTS},
        "load": {"moved_mass": "50 kg", "inclination": "90 deg"},
        "limits": {"temperature": "200 degC", **_LUBRICATED},
        "heat": {"conductance": {"screw_ambient": "3 W/K", "nut_ambient": "8 W/K"}},
        "life": {"distance": "10 km"},
        "motor": {"inertia": "5 kg cm^2"},
    },
    {
        "motion": {"segments": _SEGMENTS},
        "limits": {"nut_diameter": "40 mm"},
        "candidates": {"designs": _DESIGNS},
    },
    {
        "motion": {"segments": _SEGMENTS},
        "heat": {"conductance": {"screw_ambient": "3 W/K", "nut_ambient": "8 W/K"}, "cycles": 2},
        "bearings": {"fixed": _BEARING},
        "preload": {"force": "2 kN"},
        "life": {"distance": "10 km"},
        "model": {"loads": "static"},
        "candidates": {"designs": {**_DESIGNS, "lead": "10 mm"}},
    },
]


def documents() -> Iterator[rs.Result]:
    """Of all lessons and variants."""
    for parameter in lesson_commands():
        if not parameter.marks:
            yield answer(*parameter.values)
    for number, command, values in VARIANTS:
        yield getattr(lesson(number).with_(**values), command)()
    for requirement in REQUIREMENTS:
        yield rs.size(requirement)


def annotated_records() -> list[type[rs.Record]]:
    return [
        value
        for value in vars(records).values()
        if isinstance(value, type)
        and issubclass(value, rs.Record)
        and value not in (rs.Record, rs.Values, records.Size)  # That is the whole document.
    ]


def hints_of(owner: type[rs.Record]) -> dict[str, Any]:
    """What there is of each key, where it is there."""
    hints = typing.get_type_hints(owner)
    if issubclass(owner, rs.Result):  # A property, which has more than the key.
        hints["warnings"] = list[str]
    return {name: without_none(hint) for name, hint in hints.items() if not name.startswith("_")}


def without_none(hint: Any) -> Any:
    options = [each for each in typing.get_args(hint) if each is not type(None)]
    return options[0] if type(None) in typing.get_args(hint) else hint


def fits(value: Any, hint: Any) -> bool:
    """Whether a value is what the annotation says; floats are floats, flags are no numbers."""
    if typing.get_origin(hint) is list:
        (item,) = typing.get_args(hint)
        return isinstance(value, list) and all(fits(each, item) for each in value)
    if hint == records.Array:
        if isinstance(value, list):
            return not value
        return isinstance(value, np.ndarray) and value.dtype == np.float64
    return type(value) is hint


def walk(record: rs.Record, path: str = "") -> Iterator[tuple[str, rs.Record]]:
    """A record and all that are in it."""
    yield path, record
    for name, value in record.items():
        inside = value if isinstance(value, list) else [value]
        for place, each in enumerate(inside[:50]):
            if isinstance(each, rs.Record):
                yield from walk(each, f"{path}.{name}[{place}]")


def check_annotations(result: rs.Result) -> None:
    for path, record in walk(result):
        if type(record) is rs.Values:
            continue
        hints = hints_of(type(record))
        for name in record:
            if keyword.iskeyword(name):  # No attribute can have it: `record["from"]`.
                continue
            assert name in hints, f"{path}: {type(record).__name__}.{name} is not annotated"
            assert fits(record[name], hints[name]), f"{path}.{name}: {record[name]!r}"
        for name, hint in typing.get_type_hints(type(record)).items():
            if name in record or name.startswith("_"):
                continue
            assert type(None) in typing.get_args(hint), f"{path}.{name} is not there"
            assert getattr(record, name) is None


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_every_key_is_annotated_as_it_is(stem: str, command: str) -> None:
    check_annotations(answer(stem, command))


@pytest.mark.parametrize(("number", "command", "values"), VARIANTS)
def test_every_key_of_variants_is_annotated(
    number: int, command: str, values: dict[str, Any]
) -> None:
    check_annotations(getattr(lesson(number).with_(**values), command)())


def test_every_annotated_name_is_met() -> None:
    met = {
        (owner.__name__, name)
        for result in documents()
        for _, record in walk(result)
        for owner in type(record).__mro__
        for name in record
    }
    names = {
        (owner.__name__, name)
        for owner in [*annotated_records(), *RESULTS]
        for name in owner.__annotations__
        if not name.startswith("_")
    }
    assert sorted(names - met) == sorted(NEVER_MET), "\n".join(map(str, sorted(names - met)))


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_attributes_are_items(stem: str, command: str) -> None:
    """No key is hidden behind a method or property."""
    for path, record in walk(answer(stem, command)):
        for name in record:
            if not name.isidentifier():
                continue
            attribute, item = getattr(record, name), record[name]
            assert type(attribute) is type(item), f"{path}.{name}"
            if isinstance(item, (int, float, str)):
                assert attribute == item


# Access


@pytest.fixture
def case_record() -> records.LoadCase:
    result = answer(1, "solve", rs.SolveResult)
    return result.load_cases[0]


def test_records_are_mappings(case_record: records.LoadCase) -> None:
    keys = case_record.keys()
    assert list(case_record) == keys == [name for name, _ in case_record.items()]
    assert len(case_record) == len(keys)
    assert "screw" in case_record and "slip" not in case_record
    assert 5 not in case_record and None not in case_record
    assert set(keys) <= set(dir(case_record))
    assert dict(case_record.items())["name"] == case_record.name == case_record["name"]
    assert repr(case_record) == (
        "<LoadCase config1-tension, at rest, converged: "
        f"{', '.join(keys[:6])}, .. {len(keys) - 6} others>"
    )


def test_what_is_absent_says_what_there_is(case_record: records.LoadCase) -> None:
    with pytest.raises(AttributeError, match="'slap' is not defined by this case; there is name, "):
        _ = case_record.slap  # type: ignore[attr-defined]
    with pytest.raises(
        KeyError, match="'slip' .* by this case; it needs the command `slip`; there"
    ):
        _ = case_record["slip"]
    with pytest.raises(
        KeyError, match=r"it needs `model.mechanism: full` and `load_cases\[config1-t"
    ):
        _ = case_record["travel"]
    with pytest.raises(KeyError, match="it needs `heat`; there is name, "):
        _ = answer(9, "slip", rs.SlipResult).load_cases[0]["heat"]
    assert case_record.slip is None
    assert case_record.get("slip") is None
    assert case_record.get("slip", 5) == 5
    assert not hasattr(case_record, "slap")
    assert not hasattr(case_record, "_private")


@pytest.mark.parametrize(
    "key",
    [None, 0, 1.5, b"name", ("name",), "", "\ud800", "a\0b", "x" * 10**6],
    ids=lambda key: ascii(key)[:20],
)
def test_keys_of_other_kinds(case_record: records.LoadCase, key: Any) -> None:
    with pytest.raises(KeyError, match="is not defined by this case; there is name"):
        _ = case_record[key]
    assert case_record.get(key) is None
    assert key not in case_record


def test_records_are_read_only(case_record: records.LoadCase) -> None:
    for record in (case_record, case_record.screw, answer(1, "solve")):
        for name in ("name", "new", "_node", "_document"):
            with pytest.raises(AttributeError, match="read-only"):
                setattr(record, name, 1)
        with pytest.raises((AttributeError, TypeError)):
            del record.name
        with pytest.raises(TypeError):
            record["name"] = 1


def test_records_cannot_be_made_of_anything() -> None:
    with pytest.raises(AttributeError):
        _ = rs.Record.__new__(rs.Record).name
    with pytest.raises(AttributeError):
        _ = rs.SolveResult.__new__(rs.SolveResult).load_cases


def test_plain_dictionaries(case_record: records.LoadCase) -> None:
    plain = case_record.to_dict()
    assert plain["screw"]["axial_load_N"] is not None
    assert type(plain["screw"]) is dict
    assert type(plain["newton_history"][0]) is dict
    assert list(plain) == case_record.keys()


# Memory


def array_of(result: Any) -> np.ndarray[Any, Any]:
    array = result.load_cases[0].screw.axial_load_N
    assert isinstance(array, np.ndarray)
    return array


def test_arrays_are_read_only() -> None:
    array = array_of(answer(1, "solve"))
    assert not array.flags.writeable
    assert array.dtype == np.float64 and array.ndim == 1 and array.flags.c_contiguous
    with pytest.raises(ValueError, match="read-only"):
        array[0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        array += 1.0
    with pytest.raises(ValueError, match="read-only"):
        array.sort()
    with pytest.raises(ValueError):
        array.flags.writeable = True


def test_every_array_of_every_document_is_read_only() -> None:
    for result in documents():
        for path, record in walk(result):
            for name in record:
                value = record[name]
                assert not (isinstance(value, np.ndarray) and value.flags.writeable), (path, name)


def test_arrays_share_memory() -> None:
    result = answer(1, "solve")
    first, second = array_of(result), array_of(result)
    assert np.shares_memory(first, second)
    assert first.ctypes.data == second.ctypes.data
    assert not np.shares_memory(first, array_of(lesson(1).solve()))


def test_arrays_outlive_everything() -> None:
    case = rs.Case.from_yaml(lesson(1).name)
    result = case.solve()
    load_case = result.load_cases[0]
    interface = load_case.screw
    array = interface.axial_load_N
    expected = array.copy()
    view = array[3:]
    del case, result
    gc.collect()
    assert load_case.name == "config1-tension"
    del load_case
    gc.collect()
    np.testing.assert_array_equal(interface.axial_load_N, expected)
    del interface
    gc.collect()
    np.testing.assert_array_equal(array, expected)
    del array
    gc.collect()
    junk = [np.full(expected.size, np.nan) for _ in range(1000)]
    np.testing.assert_array_equal(view, expected[3:])
    assert len(junk) == 1000


def test_results_end_when_nobody_uses_them() -> None:
    class Tracked(rs.SolveResult):
        __slots__ = ("__weakref__",)

    result = Tracked(lesson(1).solve()._document)
    alive = weakref.ref(result)
    assert result.converged
    del result
    gc.collect()
    assert alive() is None


def test_many_threads_read_one_result() -> None:
    result = lesson(2).solve()
    expected = answer(2, "solve").to_json()

    def read(k: int) -> float:
        if k % 10 == 0:
            assert result.to_json() == expected
        cases = result.load_cases
        return float(cases[k % len(cases)].screw.axial_load_N.sum())

    with ThreadPoolExecutor(16) as pool:
        sums = list(pool.map(read, range(200)))
    cases = result.load_cases
    assert sums == [float(cases[k % len(cases)].screw.axial_load_N.sum()) for k in range(200)]


def test_null_is_no_number() -> None:
    text = (
        '{"prs_version": "0", "lives": [1.5, null, 2], "matrix": [[1, 2], [null, 4]], "none": []}'
    )
    result = rs.Result.from_json(text)
    np.testing.assert_array_equal(result["lives"], [1.5, np.nan, 2.0])
    np.testing.assert_array_equal(result["matrix"], [[1.0, 2.0], [np.nan, 4.0]])
    assert result["none"] == []


def test_kinds_of_values() -> None:
    text = (
        '{"prs_version": "0", "u": 18446744073709551615, "i": -5, "f": 1.0, "b": true, "n": null, '
        '"t": "\\u0000 \\ud83d\\ude00", "l": ["a", 1, [2, 3]], "o": {}, "keys": 1, "a b": 2}'
    )
    result = rs.Result.from_json(text)
    assert (result["u"], result["i"], result["f"], result["b"]) == (2**64 - 1, -5, 1.0, True)
    assert type(result["f"]) is float and type(result["i"]) is int and result["b"] is True
    assert result["n"] is None
    assert result["t"] == "\0 \U0001f600"
    assert result["l"][:2] == ["a", 1] and list(result["l"][2]) == [2.0, 3.0]
    assert len(result["o"]) == 0 and repr(result["o"]) == "<Values: >"
    assert result["keys"] == 1 and callable(result.keys)
    assert result["a b"] == 2


# Copies


def test_copies_of_records_are_the_records(case_record: records.LoadCase) -> None:
    assert copy.copy(case_record) is case_record
    assert copy.deepcopy({"case": case_record})["case"] is case_record
    result = answer(1, "solve")
    assert copy.deepcopy(result) is result


def test_arrays_without_numbers_are_arrays() -> None:
    case = answer(24, "solve", rs.SolveResult).load_cases[0]
    assert case.idle_rollers is not None and isinstance(case.idle_rollers, np.ndarray)
    assert case.idle_rollers.size == 0 and not case.idle_rollers.flags.writeable


def test_dir_lists_what_is_public() -> None:
    names = dir(answer(1, "solve", rs.SolveResult))
    assert "load_cases" in names and "plot_load_distribution" in names
    assert not [name for name in names if name.startswith("_") and not name.startswith("__")]
