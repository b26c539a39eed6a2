"""Cases from files, texts and dictionaries; values of every kind; sharing between threads."""

from __future__ import annotations

import copy
import enum
import json
import pickle
import re
import threading
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, commands, lesson, lessons
from rollerscrew.values import number_text

FORCE = "load_cases[0].axial_force"


@pytest.fixture(scope="module")
def ureg() -> Any:
    return pytest.importorskip("pint").UnitRegistry()


def blocks_of(file: Path) -> dict[str, Any]:
    """A lesson as dictionaries."""
    yaml = pytest.importorskip("yaml")

    class Loader(yaml.SafeLoader):  # type: ignore[misc, name-defined]
        """Takes `150e3` for a number, as YAML 1.2 does."""

    exponent = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)[eE][-+]?\d+$")
    Loader.add_implicit_resolver("tag:yaml.org,2002:float", exponent, list("-+.0123456789"))
    blocks = yaml.load(file.read_text(encoding="utf-8"), Loader)
    assert isinstance(blocks, dict)
    return blocks


def body(result: rs.Result) -> str:
    """A document without the hash of its input."""
    return "\n".join(line for line in result.to_json().splitlines() if "input_sha256" not in line)


def results(result: rs.Result) -> dict[str, Any]:
    """A document without its input, which keeps the units that were given."""
    document: dict[str, Any] = json.loads(result.to_json())
    return {k: v for k, v in document.items() if k not in ("input_sha256", "resolved_input")}


def resolved(case: rs.Case, path: str) -> tuple[float, str]:
    """Number and unit of a value as `check` shows it."""
    (value,) = [each.value for each in case.check().input if each.path == path]
    number, _, unit = value.partition(" ")
    return float(number), unit


@pytest.mark.parametrize("file", lessons(), ids=lambda file: file.stem)
def test_dictionaries_are_files(file: Path) -> None:
    from_file = lesson(file.stem)
    from_blocks = rs.Case(blocks_of(file), name=str(file))
    assert from_blocks.name == from_file.name
    # `check` shows values as they are written: 1.10 in the file, 1.1 in the dictionary.
    for command in set(commands(file)) - {"check", "study", "optimize"}:
        assert body(getattr(from_blocks, command)()) == body(getattr(from_file, command)())


@pytest.mark.parametrize("file", lessons(), ids=lambda file: file.stem)
def test_resolved_inputs_are_cases(file: Path) -> None:
    for command in set(commands(file)) - {"check", "study", "optimize"}:
        result = getattr(lesson(file.stem), command)()
        again = rs.Case(json.loads(result.to_json())["resolved_input"], name=str(file))
        assert body(getattr(again, command)()) == body(result)


@pytest.mark.parametrize("number", [10, 11, 16, 17, 19, 21])
def test_studies_from_dictionaries_are_those_of_files(number: int) -> None:
    from_file = lesson(number)
    from_blocks = rs.Case(blocks_of(Path(from_file.name)), name=from_file.name)
    result = from_file.study()
    assert body(from_blocks.study()) == body(result)
    resolved = rs.Case(json.loads(result.to_json())["resolved_input"], name=from_file.name)
    assert results(resolved.study()) == results(result)


@pytest.mark.parametrize("file", lessons(), ids=lambda file: file.stem)
def test_texts_are_files(file: Path) -> None:
    case = rs.Case.from_text(file.read_text(encoding="utf-8"), name=str(file))
    assert case == lesson(file.stem)
    assert case.contact().to_json() == lesson(file.stem).contact().to_json()


def test_text_of_dictionaries_reads_as_a_file() -> None:
    case = rs.Case(blocks_of(CONFIGS / "01_config_1_to_3.yaml"))
    assert case.name == "<case>"
    assert "mechanism:\n  type: inverted\n  lead: 5 mm\n" in case.text
    assert rs.Case.from_text(case.text) == case


def test_errors_of_dictionaries_name_the_line_of_the_text() -> None:
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    blocks["mechanism"]["rollers"] = 0
    with pytest.raises(rs.InputError, match=r"^<case>:\d+:\d+: error: mechanism\.rollers: got 0"):
        rs.Case(blocks)


def test_mappings_and_sequences_of_all_kinds() -> None:
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    frozen = MappingProxyType(
        {**OrderedDict(blocks), "load_cases": tuple(map(MappingProxyType, blocks["load_cases"]))}
    )
    assert rs.Case(frozen) == rs.Case(blocks)


# Quantities

#: Lesson, path, number and unit of the file, the same in a unit that the program does not know.
QUANTITIES: list[tuple[int, str, float, str, str]] = [
    (1, "mechanism.lead", 5, "mm", "inch"),
    (1, "structure.nut.length", 0.09, "m", "ft"),
    (1, "mechanism.pitch_diameter.screw", 21e3, "um", "thou"),
    (1, FORCE, 45, "kN", "lbf"),
    (1, FORCE, 45e3, "N", "kgf"),
    (1, "materials.youngs_modulus", 209, "GPa", "psi"),
    (1, "materials.youngs_modulus", 209e3, "N/mm**2", "ksi"),
    (18, "materials.density", 7810, "kg/m**3", "lb/inch**3"),
    (18, "materials.density", 7.81, "g/cm**3", "lb/ft**3"),
    (10, "lubricant.viscosity", 166.5, "mPa*s", "lb/ft/s"),
    (10, "lubricant.viscosity", 166.5, "cP", "psi*s"),
    (9, "lubricant.viscosity_at[0].kinematic_viscosity", 185, "mm**2/s", "inch**2/s"),
    (9, "lubricant.viscosity_at[0].kinematic_viscosity", 185, "cSt", "ft**2/s"),
    (10, "lubricant.pressure_viscosity", 30, "1/GPa", "1/psi"),
    (10, "operation.speed", 400, "rpm", "turn/s"),
    (10, "operation.speed", 41.9, "rad/s", "turn/hour"),
    (1, "contact.hertz_constant.screw", 3.6062e5, "N/mm**1.5", "lbf/inch**1.5"),
    (10, "carrier.nut_torque", 0.1, "N*m", "ft*lbf"),
    (10, "carrier.nut_torque", 100, "N*mm", "inch*lbf"),
    (9, "lubricant.temperature", 333.15, "K", "degR"),
    (9, "lubricant.temperature", 60, "degC", "degF"),
    (11, "materials.thermal_expansion", 11.5e-6, "1/K", "1/delta_degF"),
    (11, "materials.thermal_expansion", 11.5, "um/m/K", "1/delta_degF"),
    (11, "materials.thermal_expansion", 11.5, "um/m/delta_degC", "1/delta_degC"),
    (14, "life.history.interval", 0.5, "s", "day"),
    (14, "life.history.interval", 1, "min", "week"),
    (1, "mechanism.flank_angle", 45, "deg", "arcmin"),
    (1, "mechanism.flank_angle", 0.78, "rad", "turn"),
    (30, "heat.conductance.screw_ambient", 2, "W/K", "Btu/hour/delta_degF"),
    (30, "heat.specific_heat", 460, "J/kg/K", "Btu/lb/delta_degF"),
    (34, "response.load.mass", 120, "kg", "stone"),
    (34, "response.screw.inertia", 3.5e-4, "kg*m**2", "lb*ft**2"),
    (34, "response.material_damping.at_frequency", 250, "Hz", "MHz"),
    (35, "response.motor.damping", 0.002, "N*m*s/rad", "ozf*inch*s/rad"),
    (35, "response.end_stops.upper.damping", 0.4, "s/m", "s/ft"),
]


@pytest.mark.parametrize(("number", "path", "magnitude", "unit", "foreign"), QUANTITIES)
def test_quantities_of_pint(
    ureg: Any, number: int, path: str, magnitude: float, unit: str, foreign: str
) -> None:
    case = lesson(number)
    written = unit.replace("**", "^").replace("*", " ").replace("delta_degC", "K")
    expected, expected_unit = resolved(case.with_(**{path: f"{magnitude} {written}"}), path)
    assert expected != 0

    quantity = ureg.Quantity(magnitude, unit)
    for given in (quantity, quantity.to(foreign)):
        got, got_unit = resolved(case.with_(**{path: given}), path)
        assert got_unit == expected_unit
        assert got == pytest.approx(expected, rel=1e-12)


def test_percent_of_pint(ureg: Any) -> None:
    given = lesson(1).with_({"materials.poisson_ratio": ureg.Quantity(28, "percent")})
    assert body(given.check()) == body(lesson(1).with_({"materials.poisson_ratio": 0.28}).check())


def test_stiffness_of_pint(ureg: Any) -> None:
    def stiffness(guidance: Any) -> float:
        case = lesson(1).with_(**{"structure.roller.guidance": guidance})
        return float(case.solve().load_cases[0].axial_stiffness_N_per_um)

    ring = ureg.Quantity(2e4, "N/mm")
    expected = stiffness("{ring: 2e4 N/mm}")
    assert stiffness({"ring": ring}) == expected
    assert stiffness({"ring": ring.to("lbf/inch")}) == pytest.approx(expected, rel=1e-12)


def test_known_units_keep_their_digits(ureg: Any) -> None:
    case = lesson(1).with_(**{FORCE: ureg.Quantity(30.1, "kN")})
    assert case.overrides == [f"{FORCE}=30.1 kN"]


def test_quantities_inside_dictionaries(ureg: Any) -> None:
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    expected = rs.Case(blocks).solve()
    blocks["mechanism"]["lead"] = 5 * ureg.mm
    blocks["structure"]["nut"]["flanges"][0]["outer_diameter"] = ureg.Quantity(6.2, "cm")
    blocks["materials"]["poisson_ratio"] = ureg.Quantity(np.float64(0.3))
    assert results(rs.Case(blocks).solve()) == results(expected)


def test_ratios_become_numbers(ureg: Any) -> None:
    for ratio in (ureg.Quantity(30, "percent"), ureg.Quantity(300, "mm/m"), ureg.Quantity(0.3)):
        case = lesson(1).with_(**{"materials.poisson_ratio": ratio})
        number, unit = resolved(case, "materials.poisson_ratio")
        assert number == pytest.approx(0.3, rel=1e-15) and unit == ""


@pytest.mark.parametrize("unit", ["Hz", "1/s"])
def test_frequencies_are_no_angular_speeds(ureg: Any, unit: str) -> None:
    """For pint 1 Hz is 1 rad/s; for people it is one revolution a second."""
    with pytest.raises(rs.InputError, match=r"is the unit of a .*; use one of the units rpm"):
        lesson(10).with_(**{"operation.speed": ureg.Quantity(10, unit)})


@pytest.mark.parametrize(
    ("path", "magnitude", "unit"),
    [("mechanism.lead", 5, "N"), (FORCE, 1, "kW"), (FORCE, 45, ""), ("mechanism.rollers", 9, "mm")],
)
def test_quantities_of_another_dimension(ureg: Any, path: str, magnitude: int, unit: str) -> None:
    with pytest.raises(rs.InputError, match="expected"):
        lesson(1).with_(**{path: ureg.Quantity(magnitude, unit)})


@pytest.mark.parametrize("magnitude", [float("nan"), float("inf"), float("-inf")])
def test_quantities_that_are_no_numbers(ureg: Any, magnitude: float) -> None:
    with pytest.raises(rs.InputError):
        lesson(1).with_(**{FORCE: ureg.Quantity(magnitude, "kN")})


def test_arrays_of_quantities(ureg: Any) -> None:
    values = ureg.Quantity(np.array([20.0, 25.0]), "mm")
    case = lesson(10).with_(**{"study.factors[0].values": values})
    assert case.overrides == ["study.factors[0].values=[20.0 mm, 25.0 mm]"]
    assert len(case.study().all_designs) < len(lesson(10).study().all_designs)
    temperatures = ureg.Quantity(np.array([50.0, 60.0]), "degC")
    case = lesson(9).with_(study=study_of("lubricant.temperature", temperatures))
    assert list(case.study().all_designs.inputs.iloc[:, 0]) == [50.0, 60.0]


def study_of(path: str, values: Any) -> dict[str, Any]:
    return {"command": "slip", "factors": [{"path": path, "values": values}]}


# Plain values


class Count(enum.IntEnum):
    nine = 9


class Word(str, enum.Enum):  # noqa: UP042
    nine = "9"


class Named(float):
    def __repr__(self) -> str:
        return "a float"

    __str__ = __repr__


@pytest.mark.parametrize(
    "nine",
    [
        9,
        "9",
        " 9 ",
        Count.nine,
        Word.nine,
        np.int8(9),
        np.uint64(9),
        np.str_("9"),
        np.array(9),
        np.array(9, dtype=object),
    ],
    ids=lambda value: f"{type(value).__name__}-{value!r}",
)
def test_whole_numbers(nine: Any) -> None:
    assert resolved(lesson(1).with_(**{"mechanism.rollers": nine}), "mechanism.rollers")[0] == 9


@pytest.mark.parametrize(
    "number",
    [0.25, "0.25", np.float16(0.25), np.float32(0.25), np.float64(0.25), np.longdouble(0.25)]
    + [np.array(0.25), Named(0.25)],
    ids=lambda value: type(value).__name__,
)
def test_fractions(number: Any) -> None:
    path = "materials.poisson_ratio"
    assert resolved(lesson(1).with_(**{path: number}), path)[0] == 0.25
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    blocks["materials"]["poisson_ratio"] = number if not isinstance(number, str) else 0.25
    assert resolved(rs.Case(blocks), path)[0] == 0.25


@pytest.mark.parametrize("number", [1e-5, 1e22, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0])
def test_numbers_are_written_so_that_they_read_back(number: float) -> None:
    assert float(number_text(number)) == number


def test_lists_and_dictionaries() -> None:
    cases = [
        {"name": "a", "axial_force": "1 kN", "direction": "tension", "position": "4 mm"},
        {"name": "b", "axial_force": "2 kN", "direction": "tension", "position": "4 mm"},
    ]
    result = lesson(1).with_(load_cases=cases).solve()
    assert [each.name for each in result.load_cases] == ["a", "b"]
    assert [each.axial_force_N for each in result.load_cases] == [1000.0, 2000.0]


@pytest.mark.parametrize(
    "name",
    ["a: b", "# x", "- x", "a, b", "{a}", "[a]", '"', "'", "\\", "a\\nb", "null", "true", "no", "~"]
    + ["1", "1.5", "1 kN", "0x1", "2020-01-01", "&a", "*a", "!a", "%a", "@a", "`a`", "|", ">", "?"]
    + ["Schräge Last", "荷重", "\U0001f600", "a\x85b", "a\u2028b", " a", "a "],
)
def test_names_with_characters_that_mean_something_to_yaml(name: str) -> None:
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    blocks["load_cases"] = [{**blocks["load_cases"][0], "name": name}]
    assert rs.Case(blocks).solve().load_cases[0].name == name
    case = lesson(1).with_(load_cases=blocks["load_cases"])
    assert case.solve().load_cases[0].name == name


# Identity


def test_cases_do_not_change() -> None:
    case = lesson(1)
    before = (case.name, case.text, case.overrides)
    case.overrides.append("mechanism.rollers=9")
    other = case.with_(**{"mechanism.rollers": 9})
    assert (case.name, case.text, case.overrides) == before
    assert other.overrides == ["mechanism.rollers=9"]
    for name in ("name", "text", "overrides", "anything"):
        with pytest.raises(AttributeError):
            setattr(case, name, "x")


def test_dictionaries_that_change_later_change_no_case() -> None:
    blocks = blocks_of(CONFIGS / "01_config_1_to_3.yaml")
    case = rs.Case(blocks)
    text = case.solve().to_json()
    blocks["mechanism"]["rollers"] = 3
    assert case.solve().to_json() == text


def test_equality_and_hash() -> None:
    case = lesson(1)
    same = rs.Case.from_yaml(case.name)
    nine = case.with_(**{"mechanism.rollers": 9})
    assert same == case and hash(same) == hash(case)
    assert nine != case
    assert nine == rs.Case.from_yaml(case.name, set={"mechanism.rollers": 9})
    assert nine != rs.Case.from_text(case.text, name="other")
    assert case != case.name
    assert len({case, same, nine}) == 2


def test_repr_names_the_file_and_what_changed() -> None:
    assert repr(lesson(1).with_(**{"mechanism.rollers": 9})) == (
        f"<Case {lesson(1).name}, mechanism.rollers=9>"
    )
    many = lesson(1).with_({f"load_cases[{k}].axial_force": "30 kN" for k in range(6)})
    assert len(repr(many.with_({"mechanism.rollers": 9}))) < 400


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_pickle(protocol: int) -> None:
    case = lesson(1).with_(**{"mechanism.rollers": 9})
    again = pickle.loads(pickle.dumps(case, protocol))
    assert again == case
    assert again.solve().to_json() == case.solve().to_json()


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_copies(duplicate: Callable[[rs.Case], rs.Case]) -> None:
    case = lesson(1).with_(**{"mechanism.rollers": 9})
    assert duplicate(case) == case


def test_pickled_cases_do_not_need_their_file(tmp_path: Path) -> None:
    file = tmp_path / "case.yaml"
    file.write_text(lesson(1).text, encoding="utf-8")
    data = pickle.dumps(rs.Case.from_yaml(file))
    file.unlink()
    assert pickle.loads(data).solve().converged


def test_files_may_be_paths_or_texts() -> None:
    assert rs.Case.from_yaml(Path(lesson(1).name)) == rs.Case.from_yaml(lesson(1).name)


class Screw(rs.Case):
    __slots__ = ()


def test_subclasses_stay_subclasses() -> None:
    case = Screw.from_yaml(lesson(1).name)
    assert type(case) is Screw
    assert type(case.with_(**{"mechanism.rollers": 9})) is Screw
    assert type(Screw.from_text(case.text)) is Screw
    assert type(pickle.loads(pickle.dumps(case))) is Screw


# Threads


def test_threads_share_a_case() -> None:
    case = rs.Case.from_yaml(lesson(9).name)
    commands_in_turn = ["slip", "solve", "contact", "check", "measures"] * 8
    expected = {name: lesson(9).__class__.from_yaml(case.name) for name in set(commands_in_turn)}
    texts = {name: getattr(other, name)().to_json() for name, other in expected.items()}
    with ThreadPoolExecutor(8) as pool:
        answers = pool.map(lambda name: getattr(case, name)().to_json(), commands_in_turn)
        assert list(answers) == [texts[name] for name in commands_in_turn]


def test_other_threads_run_while_one_solves() -> None:
    case = lesson(3).with_(**{FORCE: {"from": "1 kN", "to": "45 kN", "steps": 10_000}})
    other_case = lesson(7)
    finished = 0
    running, done = threading.Event(), threading.Event()

    def work() -> None:
        nonlocal finished
        while not done.is_set():
            other_case.contact().to_json()
            finished += 1
            running.set()

    other = threading.Thread(target=work)
    other.start()
    try:
        running.wait()
        before = finished
        result = case.solve()
        during = finished - before
    finally:
        done.set()
        other.join()
    assert result.converged
    assert during > 5  # Of an interpreter that waits, one at most.


@pytest.mark.thorough
def test_models_agree_between_threads() -> None:
    small = {"model.bodies": "influence", "mechanism.contacts_per_roller": 4}
    case = lesson(5).with_(**small)
    with ThreadPoolExecutor(2) as pool:
        first, second = pool.map(lambda _: case.solve().to_json(), range(2))
    assert first == second


def test_files_are_found_from_anywhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CONFIGS.parent)
    case = rs.Case.from_yaml("configs/14_flight_spectrum.yaml")
    there = case.life().to_json()
    sent = pickle.dumps(case)
    monkeypatch.chdir(tmp_path)
    assert case.life().to_json() == there
    assert case.with_({"mechanism.rollers": 9}).life().life.system.l10_hours > 0
    assert pickle.loads(sent).life().to_json() == there
    assert case.name == "configs/14_flight_spectrum.yaml"


def test_differences_are_no_temperatures(ureg: Any) -> None:
    case = rs.Case.from_yaml(CONFIGS / "09_slip_and_dissipation.yaml")
    warm = ureg.Quantity(60, "degC")
    assert case.with_({"lubricant.temperature": warm}).overrides == [
        "lubricant.temperature=60.0 degC"
    ]
    with pytest.raises(rs.InputError, match="temperature"):
        case.with_({"lubricant.temperature": ureg.Quantity(60, "delta_degC")})


def test_blocks_by_name() -> None:
    case = rs.Case.from_yaml(CONFIGS / "09_slip_and_dissipation.yaml")
    changed = case.with_({"mechanism.rollers": 9}, operation={"speed": "100 rpm"})
    assert changed.overrides == ["mechanism.rollers=9", "operation={speed: 100 rpm}"]


def _blocks(low: Any, high: Any, limit: Any) -> dict[str, Any]:
    ends = {"path": "mechanism.flank_angle", "from": low, "to": high}
    peak = "screw.peak_pressure_MPa.max"
    uniform = {"path": ends["path"], "uniform": {"from": low, "to": high}}
    values = {"path": "mechanism.lead", "values": [(4, "mm"), "5 mm"]}
    return {
        "study": {
            "command": "solve",
            "plan": "monte_carlo",
            "samples": 2,
            "factors": [uniform, values],
        },
        "optimize": {
            "command": "solve",
            "variables": [ends],
            "objectives": [{"minimize": peak}],
            "constraints": [{"response": peak, "at_most": limit}],
        },
        "fit": {
            "parameters": [ends],
            "curves": [
                {
                    "name": "x",
                    "file": "x.csv",
                    "response": peak,
                    "measured": {"column": "x", "unit": "MPa"},
                }
            ],
        },
    }


def test_values_with_units_are_alike_in_all_blocks(tmp_path: Path) -> None:
    pint = pytest.importorskip("pint").UnitRegistry()
    (tmp_path / "x.csv").write_text("x\n2900\n3000\n")
    text = rs.new("standard", "25 mm", "5 mm").text
    base = rs.Case.from_text(text, name=str(tmp_path / "case.yaml"))
    expected = base.with_(**_blocks("40 deg", "50 deg", 4000))
    for blocks in (
        _blocks((40, "deg"), (50, "deg"), (4, "GPa")),
        _blocks(40 * pint.deg, 50 * pint.deg, 4 * pint.GPa),
        _blocks("40 deg", "50 deg", "4e9 Pa"),
    ):
        for name in blocks:
            changed = base.with_({name: blocks[name]})
            assert changed.number("mechanism.lead", "mm") == 5.0
            if name == "optimize":
                assert changed["optimize.constraints[0].at_most"] == 4000
            assert repr(changed[name]).replace(".0 deg", " deg") == repr(expected[name])
    with pytest.raises(rs.InputError, match="at_most: got 4 mm"):
        base.with_({"optimize": _blocks("40 deg", "50 deg", "4 mm")["optimize"]}).check()
