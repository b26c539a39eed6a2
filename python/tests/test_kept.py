"""What a case and its results are stays so: elsewhere, after a file has changed, in JSON."""

from __future__ import annotations

import hashlib
import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rollerscrew as rs
from conftest import CONFIGS, REPOSITORY, Run, answer, lesson, lesson_commands

SPECTRUM = "14_flight_spectrum.yaml"


@pytest.fixture
def spectrum(tmp_path: Path) -> Path:
    """A copy of lesson 14 beside a copy of its history."""
    text = (CONFIGS / SPECTRUM).read_text(encoding="utf-8")
    history = lesson(14)["life.history.file"]
    (tmp_path / "history.csv").write_bytes(Path(history).read_bytes())
    file = tmp_path / "case.yaml"
    name = Path(history).relative_to(CONFIGS).as_posix()
    assert name in text
    file.write_text(text.replace(name, "history.csv"), encoding="utf-8")
    return file


def revolutions(result: rs.LifeResult) -> float:
    return float(result.life.system.l10_hours)


# Whether it converged

FAILURES = [
    (9, "slip", {"friction.model": {"coulomb": 50}}),
    (9, "measures", {"friction.model": {"coulomb": 50}}),
    (30, "slip", {"heat.conductance": dict.fromkeys(["screw_ambient", "nut_ambient",
                                                     "rollers_ambient"], "1e-6 W/K")}),
]  # fmt: skip


@pytest.mark.parametrize(("number", "command", "values"), FAILURES)
def test_converged_is_the_exit_status(
    number: int, command: str, values: dict[str, object], program: Run
) -> None:
    result = getattr(lesson(number).with_(values), command)()
    overrides = [word for each in result.overrides for word in ("--set", each)]
    status = program(command, lesson(number).name, "--json", *overrides).returncode
    assert status in (0, 3)
    assert result.converged is (status == 0)
    assert type(result).from_json(result.to_json()).converged is result.converged


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_converged_is_read_off_documents(stem: str, command: str) -> None:
    result = answer(stem, command)
    assert type(result).from_json(result.to_json()).converged is result.converged


def test_what_failed_says_why() -> None:
    jams = {"friction.model": {"coulomb": 50}, "model.loads": "static"}
    slip = lesson(9).with_(jams).slip().load_cases[0].slip
    assert slip is not None and not slip.converged
    assert slip.efficiency is None
    with pytest.raises(KeyError, match="'efficiency' is absent: slip ended with 'jammed': .*jams"):
        slip["efficiency"]
    restored = pickle.loads(pickle.dumps(slip))
    with pytest.raises(KeyError, match="slip ended with 'jammed'"):
        restored["efficiency"]


def test_what_is_not_defined_says_what_it_needs() -> None:
    measures = answer(1, "measures", rs.MeasuresResult).measures
    assert measures.weight_kg is None
    with pytest.raises(KeyError, match="it needs `materials.density`"):
        measures["weight_kg"]


# Files


def test_a_case_is_what_it_was_when_it_was_made(spectrum: Path, tmp_path: Path) -> None:
    case = rs.Case.from_yaml(spectrum)
    before = case.life()
    history = tmp_path / "history.csv"
    text = history.read_text(encoding="utf-8")
    samples = text[text.index("\n", text.index("force_kN")) + 1 :]
    history.write_text(text + samples, encoding="utf-8")
    assert case.life().to_json() == before.to_json()
    changed = rs.Case.from_yaml(spectrum)
    assert changed != case and hash(changed) != hash(case)
    assert changed.life().input_sha256 != before.input_sha256
    sent = pickle.dumps(case)
    history.unlink()
    assert pickle.loads(sent).life().to_json() == before.to_json()
    assert case.with_({"mechanism.rollers": 9}).life().converged
    with pytest.raises(FileNotFoundError, match="does not exist"):
        rs.Case.from_yaml(spectrum)


def test_hashes_are_of_what_was_computed(spectrum: Path) -> None:
    case = rs.Case.from_yaml(spectrum)
    others = (case.with_({"mechanism.rollers": 9}), case.with_({"life.share": "equal"}))
    hashes = {each.contact().input_sha256 for each in (case, *others)}
    assert len(hashes) == 3
    plain = lesson(1)
    assert plain.contact().input_sha256 == hashlib.sha256(plain.text.encode()).hexdigest()


def test_resolved_inputs_find_their_files(
    spectrum: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    result = rs.Case.from_yaml(spectrum).life()
    history = result.resolved_input.life.history
    assert history["file"] == str(tmp_path / "history.csv")
    content = (tmp_path / "history.csv").read_bytes()
    assert history["sha256"] == hashlib.sha256(content).hexdigest()
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "history.csv").write_text("t,F\n0,1\n1,2\n", encoding="utf-8")
    monkeypatch.chdir(elsewhere)
    again = rs.Case(result.resolved_input)
    assert again.life().life == result.life
    assert again.life().resolved_input == result.resolved_input
    (tmp_path / "history.csv").write_bytes(content + b"\n")
    with pytest.raises(rs.InputError, match="which is another file or has changed"):
        rs.Case(result.resolved_input)


# Numbers, warnings, documents


def test_whole_numbers_may_be_floats() -> None:
    nine = lesson(1).with_({"mechanism.rollers": np.float64(9.0)})
    assert nine.solve().load_cases == lesson(1).with_({"mechanism.rollers": 9}).solve().load_cases
    designs = lesson(1).evaluate({"mechanism.rollers": [9.0, 11.0]})
    assert lesson(1).with_({"mechanism.rollers": designs.inputs["mechanism.rollers"][0]}) == nine
    said = r"got 9\.4; expected a whole number from 1 to 1000"
    with pytest.raises(rs.InputError, match=said):
        lesson(1).with_({"mechanism.rollers": 9.4})
    with pytest.raises(rs.InputError, match=said):
        lesson(1).evaluate({"mechanism.rollers": [9.4, 9.4]})


def test_warnings_of_load_cases_are_warnings_of_the_result() -> None:
    result = lesson(1).with_({"load_cases[0].axial_force": "2000 kN"}).solve()
    name, own = result.load_cases[0].name, result.load_cases[0].warnings
    assert own and own[0] not in result["warnings"]
    assert f"load case {name}: {own[0]}" in result.warnings


def test_documents_of_other_commands_are_refused() -> None:
    with pytest.raises(ValueError, match="got one of the command 'slip'; expected 'solve'"):
        rs.SolveResult.from_json(answer(9, "slip").to_json())


def test_the_base_case_of_a_study_stands_apart() -> None:
    study = answer(15, "study", rs.StudyResult)
    assert len(study.to_frame()) == len(study.all_designs) == 2000
    assert len(study.base) == 1 and study.base.converged.all()
    assert study.all_designs.case(7).solve().converged


def test_results_are_their_content() -> None:
    result = lesson(1).solve()
    assert result == lesson(1).solve() == pickle.loads(pickle.dumps(result))
    assert result != lesson(2).solve() and result.load_cases[0] != result.load_cases[1]
    assert pickle.loads(pickle.dumps(result.load_cases[1])) == result.load_cases[1]
    assert len({result, lesson(1).solve()}) == 1
    assert json.loads(json.dumps(result.to_dict())) == json.loads(result.to_json())


def test_errors_say_their_parts(tmp_path: Path) -> None:
    with pytest.raises(rs.InputError) as raised:
        lesson(1).with_({"mechanism.leed": "5 mm", "mechanism.rollers": 9.4})
    error = {each.path: each for each in raised.value.errors}["mechanism.leed"]
    assert error.hint == "did you mean `lead`?"
    assert (error.line or 0) > 1 and error.column and error.file == lesson(1).name
    assert {each.got for each in raised.value.errors} == {"", "9.4"}
    again = pickle.loads(pickle.dumps(raised.value))
    assert again.errors == raised.value.errors and again.path == raised.value.path
    for missing in (tmp_path / "nope.yaml",):
        with pytest.raises(FileNotFoundError) as absent:
            rs.Case.from_yaml(missing)
        assert isinstance(absent.value, rs.InputError)


def test_the_first_lines_of_the_guide_run_anywhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    guide = (REPOSITORY / "python" / "README.md").read_text(encoding="utf-8")
    code = guide.partition("```python\n")[2].partition("```")[0]
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})


# Histories of arrays


HISTORY = {
    "force": (5.0 + 3.0 * np.sin(np.arange(100.0)), "kN"),
    "position": (10.0 + 5.0 * np.sin(np.arange(100.0)), "mm"),
    "time": (0.1 * np.arange(100.0), "s"),
}


def test_histories_of_arrays_stand_in_resolved_inputs() -> None:
    result = lesson(14).life(history=HISTORY)
    again = rs.Case(result.resolved_input)
    assert again.life().life == result.life
    assert pickle.loads(pickle.dumps(again)).life().life == result.life


def test_histories_take_the_place_of_a_spectrum() -> None:
    made = rs.new("standard", "25 mm", "5 mm")
    assert "spectrum" in made["life"]
    life = made.life(history=HISTORY, bins=16)
    assert (
        life.resolved_input.life.history.bins == 16 and "spectrum" not in life.resolved_input.life
    )
    assert lesson(1).life(history=HISTORY, position="29 mm").converged


@pytest.mark.parametrize(
    ("history", "options", "error", "message"),
    [
        ({"force": (np.array([1.0, np.nan]), "kN")}, {}, ValueError, r"\['force'\]\[1\]: got nan"),
        ({"force": (np.ones((2, 2)), "kN")}, {}, ValueError, r"got the shape \(2, 2\)"),
        ({"force": ([], "kN")}, {}, ValueError, "at least 2 numbers"),
        ({"force": np.ones(3)}, {}, TypeError, "got no unit"),
        ([1.0, 2.0], {}, TypeError, "history: got list"),
        (HISTORY | {"time": ([0.0, 1.0], "s")}, {}, ValueError, "got 100 of force, .* 2 of time"),
        (None, {"bins": 3}, TypeError, "options of a history, and no history"),
    ],
)
def test_histories_that_are_none(
    history: Any, options: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        lesson(14).life(history=history, **options)


def test_histories_are_named_as_the_argument() -> None:
    backwards = HISTORY | {"time": (-HISTORY["time"][0], "s")}
    with pytest.raises(rs.InputError, match="^<history>:3:"):
        lesson(14).life(history=backwards)


# Pickles


def test_results_that_were_sent_have_their_pictures() -> None:
    for result in (lesson(1).solve(), lesson(14).life(history=HISTORY)):
        sent = pickle.loads(pickle.dumps(result))
        assert sent.to_json() == result.to_json() and sent == result
        assert sent.figures() == result.figures() != []


# Errors


def test_errors_are_about_what_was_given() -> None:
    text = lesson(1).text
    with pytest.raises(rs.InputError) as raised:
        rs.Case.from_text(text.replace("  lead:", "  leed:"))
    assert raised.value.path == "mechanism.leed" and raised.value.hint == "did you mean `lead`?"
    assert [each.path for each in raised.value.errors] == ["mechanism.lead", "mechanism.leed"]
    with pytest.raises(rs.InputError) as raised:
        rs.Case.from_text("a: [")
    assert (raised.value.path, raised.value.line) == ("", 1)
    with pytest.raises(rs.InputError) as raised:
        lesson(1).evaluate({"mechanism.rollers": [9, 9.5]})
    assert (raised.value.path, raised.value.got) == ("mechanism.rollers", "9.5")
    with pytest.raises(FileNotFoundError) as missing:
        rs.Case.from_yaml("nowhere.yaml")
    assert missing.value.filename == "nowhere.yaml"
    assert str(missing.value).startswith("nowhere.yaml:1:1: error: got no such file")
