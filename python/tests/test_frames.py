"""Data frames can be saved: each column has one type, every row and column is there."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
import xarray
from conftest import answer, lesson, lesson_commands
from rollerscrew.frames import frame_of

#: Columns and types of frames that were written to netCDF, which takes long.
WRITTEN: set[Any] = set()


def frames_of(result: rs.Result) -> dict[str, pd.DataFrame]:
    names = [name for name in dir(type(result)) if name.endswith("_frame")]
    return {name: getattr(result, name)() for name in names}


def assert_kept(frame: pd.DataFrame, folder: Path) -> None:
    file = io.BytesIO()
    frame.to_parquet(file)
    pd.testing.assert_frame_equal(pd.read_parquet(file), frame)
    kind = (tuple(frame.columns), tuple(frame.dtypes), frame.empty)
    if kind in WRITTEN and os.environ.get("PRS_THOROUGH") != "1":
        return
    WRITTEN.add(kind)
    name = folder / f"{len(WRITTEN)}.nc"
    frame.rename_axis("row").to_xarray().to_netcdf(name, engine="netcdf4")
    again = xarray.load_dataset(name, engine="netcdf4").to_dataframe()
    has_rows = not frame.empty  # Texts without rows have no type of their own in netCDF.
    pd.testing.assert_frame_equal(
        again[frame.columns], frame.rename_axis("row"), check_index_type=False, check_dtype=has_rows
    )


@pytest.mark.parametrize(("stem", "command"), lesson_commands())
def test_every_frame_is_kept(stem: str, command: str, tmp_path: Path) -> None:
    for name, frame in frames_of(answer(stem, command)).items():
        for column in frame:
            kinds = {type(value) for value in frame[column].tolist()}
            assert len(kinds) <= 1, f"{name}: {column} holds {kinds}"
            assert kinds <= {str, int, float, bool}, f"{name}: {column} holds {kinds}"
        assert len(frame.columns) > 0, f"{name} has no columns"
        assert_kept(frame, tmp_path)


def test_frames_without_rows_have_their_columns(tmp_path: Path) -> None:
    empty = rs.SlipResult.from_json('{"prs_version": "0", "warnings": [], "load_cases": []}')
    full = answer(9, "slip", rs.SlipResult)
    for name, frame in frames_of(empty).items():
        assert frame.empty
        assert set(getattr(full, name)().columns) <= set(frame.columns), name
        assert_kept(frame, tmp_path)


def test_load_cases_that_fail_are_rows_with_their_status() -> None:
    jammed = lesson(9).with_({"friction.model": {"coulomb": 50}}).slip()
    frame = jammed.slip_frame()
    assert list(frame["case"]) == [case.name for case in jammed.load_cases]
    assert set(frame["status"]) == {"jammed"} and not frame["converged"].any()
    assert len(jammed.load_cases_frame()) == len(jammed.load_cases)


def test_measures_have_numbers_and_words_apart() -> None:
    frame = answer(18, "measures", rs.MeasuresResult).measures_frame()
    assert list(frame.columns) == ["load_case", "measure", "value", "text", "unit"]
    assert frame["value"].dtype == np.float64
    weight = frame[frame["measure"] == "weight_kg"].iloc[0]
    assert weight["unit"] == "kg" and weight["value"] > 0.0 and weight["text"] == ""
    words = frame[frame["text"] != ""]
    assert len(words) > 0 and words["value"].isna().all()


def test_flags_and_counts_with_gaps_are_numbers() -> None:
    rows = [{"flag": True, "count": 3}, {"flag": None, "count": None}]
    gaps = frame_of(rows, {"flag": bool, "count": int})
    assert gaps["flag"].tolist()[0] == 1.0 and np.isnan(gaps["flag"][1])
    assert gaps.dtypes.tolist() == [np.float64, np.float64]
    whole = frame_of(rows[:1], {"flag": bool, "count": int})
    assert whole.dtypes.tolist() == [np.bool_, np.int64]


def test_travel_and_modes_have_a_row_per_position_and_mode() -> None:
    result = answer(33, "solve", rs.SolveResult)
    travel, modes = result.travel_frame(), result.modes_frame()
    assert set(travel["case"]) == {"pull", "table"} and set(modes["case"]) == {"table"}
    pull = travel[travel["case"] == "pull"]
    assert len(pull) == 2 * 16 + 1
    assert pull["angle_deg"].is_monotonic_increasing
    assert pull["screw_end_displacement_um_x"].tolist() == pull["deviation_um"].tolist()
    force = result.load_case("pull").axial_force_N
    assert np.allclose(np.abs(pull["nut_force_N_x"]), force, rtol=1e-9)
    assert modes["frequency_Hz"].is_monotonic_increasing and modes["frequency_Hz"].iloc[0] > 0
    assert modes["mode"].tolist() == list(range(1, len(modes) + 1))
    energy = modes.filter(like="kinetic_energy_percent_").sum(axis=1)
    assert np.allclose(energy, 100.0, rtol=1e-6)
