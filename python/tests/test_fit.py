"""`fit`: unknown inputs from measured curves, as the program gives them."""

from __future__ import annotations

import csv
import json
from typing import Any

import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
from conftest import CONFIGS, Run

BENCH = CONFIGS / "37_bench.yaml"
TORQUE = {
    "name": "torque",
    "response": "slip.torque_screw_Nm",
    "measured": {"column": "torque_Nm", "unit": "N m"},
    "conditions": [{"path": "load_cases[0].axial_force", "column": "force_kN", "unit": "kN"}],
}


@pytest.fixture(scope="module")
def bench() -> rs.Case:
    return rs.Case.from_yaml(BENCH)


def test_says_what_the_command_says(bench: rs.Case, program: Run) -> None:
    run = program("fit", BENCH, "--json")
    assert run.returncode == 0, run.stderr
    printed = json.loads(run.stdout)["fit"]
    result = bench.fit()
    frame = result.parameters_frame()
    assert list(frame["name"]) == [one["name"] for one in printed["parameters"]]
    assert list(frame["value"]) == [one["value"] for one in printed["parameters"]]
    assert len(result.residuals_frame()) == sum(curve["rows"] for curve in printed["curves"])
    assert list(result.bands_frame()["value"]) == printed["bands"][0]["value"]
    covariance = result.covariance_frame()
    assert np.allclose(np.sqrt(np.diag(covariance)), frame["standard_deviation"])


def test_the_fitted_case_has_the_values(bench: rs.Case) -> None:
    result = bench.fit()
    fitted = result.fitted_case
    assert fitted.number("preload.backlash", "um") == pytest.approx(
        result.parameters_frame()["value"][2], rel=1e-9
    )
    torque = fitted.with_({"load_cases[0].axial_force": "4 kN"}).slip().load_cases[0].slip
    rows = result.residuals_frame()
    assert torque.torque_screw_Nm == pytest.approx(rows["fitted"][3], rel=1e-8)


def test_data_takes_the_place_of_files(bench: rs.Case) -> None:
    with (CONFIGS / "37_torque.csv").open() as file:
        rows = list(csv.DictReader(file))
    frame = pd.DataFrame({key: [float(row[key]) for row in rows] for key in rows[0]})
    parameters = [{"path": "friction.coulomb", "from": 0.02, "to": 0.4}]
    result = rs.fit(bench, parameters, [TORQUE], data={"torque": frame}, level="95 %", profile=True)
    assert result.fit.level_percent == 95.0
    assert result.parameters_frame()["profile_low"][0] < result.parameters_frame()["value"][0]
    twice = {key: np.repeat(frame[key], 2) for key in frame}
    assert rs.fit(bench, parameters, [TORQUE], data={"torque": twice}).fit.curves[0].rows == 32
    unequal = {"force_kN": [1.0, 2.0], "torque_Nm": [1.0]}
    with pytest.raises(ValueError, match="expected as many of each column"):
        rs.fit(bench, parameters, [TORQUE], data={"torque": unequal})
    hole = frame.assign(torque_Nm=frame["torque_Nm"].where(frame.index != 3))
    with pytest.raises(
        rs.InputError, match=r"^<data\['torque'\]>:5:\d+: error: torque_Nm: got nan"
    ):
        rs.fit(bench, parameters, [TORQUE], data={"torque": hole})
    with pytest.raises(ValueError, match="expected one of torque"):
        rs.fit(bench, parameters, [TORQUE], data={"turque": frame})


def test_pictures(bench: rs.Case) -> None:
    result = bench.fit()
    for plot in (result.plot_fit, result.plot_residuals, result.plot_correlation):
        assert plot().has_data()


def test_says_what_the_data_hardly_tell(bench: rs.Case) -> None:
    frame = bench.fit().to_frame()
    assert not frame["note"].any()
    rows: dict[str, list[float]] = {"force_kN": [8.0, 12.0, 16.0], "torque_Nm": []}
    for force in rows["force_kN"]:
        one = bench.with_({"load_cases[0].axial_force": (force, "kN")}).slip()
        rows["torque_Nm"].append(one.load_cases[0].slip.torque_screw_Nm)
    parameters = [
        {"path": "friction.coulomb", "from": 0.02, "to": 0.2},
        {"path": "carrier.screw_torque", "from": "0 N m", "to": "3 N m"},
    ]
    torque = TORQUE | {"deviation": "2 N m"}
    result = rs.fit(bench, parameters, [torque], data={"torque": rows})
    frame = result.to_frame().set_index("name")
    assert frame.loc["carrier.screw_torque", "low"] <= 0.0
    drag = "hardly identified: its interval contains zero"
    assert frame.loc["carrier.screw_torque", "note"] == drag
    assert f"carrier.screw_torque: {drag}" in repr(result)


def test_what_is_no_data_is_refused(bench: rs.Case) -> None:
    wrong: Any = 5
    with pytest.raises(TypeError, match="data: got 5; expected readings by the names"):
        bench.fit(wrong)
    with pytest.raises(TypeError, match=r"data\['torque'\]: got 5; expected a frame, or arrays"):
        bench.fit({"torque": wrong})
    with pytest.raises(TypeError, match="case: got 5; expected a Case"):
        rs.fit(wrong, [], [])
    with pytest.raises(TypeError, match="parameters: got 5; expected a list of dictionaries"):
        rs.fit(bench, wrong, [])
    with pytest.raises(TypeError, match=r"curves\[0\]: got 'a'; expected a dictionary"):
        rs.fit(bench, [], "abc")  # type: ignore[arg-type]
