"""References: `Case.compare` with data in place of files."""

from typing import Any

import matplotlib as mpl
import numpy as np
import pandas as pd
import pytest
import rollerscrew as rs
from conftest import lesson

mpl.use("agg")


def table(case: rs.Case) -> dict[str, list[float] | list[str]]:
    """The shares that the case itself finds for its first load."""
    load = case.solve().load_cases[0]
    shares = [float(share) for share in load.screw.load_rate_percent]
    return {
        "load_case": [load.name] * len(shares),
        "thread": list(np.arange(1.0, len(shares) + 1)),
        "screw.load_rate_percent": shares,
    }


def test_own_shares_lie_on_the_curve() -> None:
    case = lesson(1)
    result = case.compare(table(case), tolerance="0.01 % of the mean", name="own")
    assert result.references is not None
    (own,) = result.references
    assert own.name == "own"
    assert own.met
    assert own.models[0].bodies == "bars"
    assert own.models[0].rms_deviation == pytest.approx(0.0, abs=1e-9)
    assert own.sum == pytest.approx(100.0)
    frame = result.references_frame()
    assert list(frame["bodies"]) == ["bars", "refined"] + ["influence"] * (len(frame) - 2)


def test_several_references_stand_side_by_side() -> None:
    case = lesson(1)
    own, other = table(case), table(case)
    other["screw.load_rate_percent"] = [5.0] * 20
    result = case.compare([own, other])
    assert [r.name for r in result.references or []] == ["reference 1", "reference 2"]
    assert [r.file for r in result.references or []] == ["<reference 1>", "<reference 2>"]


def test_threads_and_load_cases_may_be_the_index() -> None:
    case = lesson(1)
    frame = pd.DataFrame(table(case))
    named = case.compare(frame).references_frame()
    for index in ("thread", ["load_case", "thread"]):
        pd.testing.assert_frame_equal(
            case.compare(frame.set_index(index)).references_frame(), named
        )


def test_what_is_wrong_is_named_where_it_stands() -> None:
    case = lesson(1)
    wrong = table(case)
    wrong["thread"][3] = 21.0  # type: ignore[call-overload]
    with pytest.raises(rs.InputError, match=r"^<reference>:5:\d+: error: thread: got 21"):
        case.compare(wrong)
    with pytest.raises(ValueError, match="as many of each column"):
        case.compare({"thread": [1.0], "screw.load_rate_percent": [5.0, 6.0]})


def test_a_picture_has_the_points_of_the_reference() -> None:
    case = lesson(1)
    data = table(case)
    ax = case.solve().plot_load_distribution(reference=data)
    lines = [line for axes in ax.figure.axes for line in axes.get_lines()]
    shares = np.array(data["screw.load_rate_percent"])
    assert any(
        len(line.get_ydata()) == len(shares)
        and line.get_linestyle() == "None"
        and np.allclose(np.asarray(line.get_ydata()), shares)
        for line in lines
    )
    case.compare(data).plot_references()


def test_options_without_a_reference_are_refused() -> None:
    with pytest.raises(TypeError, match="tolerance, foo: got options of a reference, and no ref"):
        lesson(1).compare(tolerance="nonsense", foo=3)


@pytest.mark.parametrize("reference", [5, "x", [5]])
def test_what_is_no_reference_is_refused(reference: Any) -> None:
    with pytest.raises(TypeError, match="reference: got .*; expected a frame, or arrays"):
        lesson(1).compare(reference)
    with pytest.raises(TypeError, match=r"reference\['thread'\]: got 5; expected an array"):
        lesson(1).compare({"thread": 5})


def test_without_references_the_frame_has_its_columns() -> None:
    case = lesson(1)
    bare, full = case.compare().references_frame(), case.compare(table(case)).references_frame()
    assert bare.empty and set(full.columns) <= set(bare.columns)
    assert bare[full.columns].dtypes.equals(full.dtypes)
