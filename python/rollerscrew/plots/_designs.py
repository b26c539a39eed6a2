"""The inputs of a study's designs, by factor."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import sentence, shown
from rollerscrew.plots._names import unit_text

if TYPE_CHECKING:
    import pandas as pd

    from rollerscrew.record import Record
    from rollerscrew.results import StudyResult


@dataclass(frozen=True)
class Input:
    """What a factor, or what it carries along, is in every design."""

    path: str
    label: str
    unit: str
    factor: int  #: Place of the factor that sets it.
    is_factor: bool  #: Not carried along by another one.
    base: float | str | None  #: What the file says.
    values: npt.NDArray[Any]  #: Numbers in `unit`, or words; the base case first.

    @property
    def is_numeric(self) -> bool:
        return self.values.dtype != np.object_

    @property
    def title(self) -> str:
        """`Lead (mm)`."""
        text = shown(self.label, 40)
        text = text if self.label == self.path else sentence(text)
        return f"{text} ({unit_text(self.unit)})" if self.unit and self.is_numeric else text

    def text(self, value: Any) -> str:
        """`lead: 5 mm`."""
        return f"{shown(self.label, 28)}: {self.value_text(value)}"

    def value_text(self, value: Any) -> str:
        if not self.is_numeric:
            return shown(str(value), 20)
        return f"{value:.5g}{f' {unit_text(self.unit)}' if self.unit else ''}"

    def levels(self, rows: npt.NDArray[np.int_]) -> list[Any]:
        """Different values in these designs: numbers ascending, words in their order."""
        values = self.values[rows]
        if self.is_numeric:
            return [float(value) for value in np.unique(values[np.isfinite(values)])]
        return [value for value in dict.fromkeys(values) if value is not None]


def inputs_of(result: StudyResult) -> list[Input]:
    """Factors, each followed by what it carries along."""
    frame = result.all_designs.inputs
    described = list(_described(result.study.factors))
    by_place = len(frame.columns) == len(described) and all(
        str(column).startswith(record["path"])
        for column, (_, _, record) in zip(frame.columns, described, strict=True)
    )
    inputs = []
    for place, (factor, is_factor, record) in enumerate(described):
        column = frame.columns[place] if by_place else record["path"]
        base = record.get("base")
        standard = None if base is None else base.get("number", base["value"])
        inputs.append(
            Input(
                record["path"],
                record["label"],
                record.get("unit", ""),
                factor,
                is_factor,
                standard,
                _values(frame, column, standard),
            )
        )
    return inputs


def _described(factors: Sequence[Record]) -> Iterator[tuple[int, bool, Record]]:
    for place, factor in enumerate(factors):
        yield place, True, factor
        for companion in factor.get("with", []):
            yield place, False, companion


def _values(frame: pd.DataFrame, column: Any, base: float | str | None) -> npt.NDArray[Any]:
    """What designs do not say is what the file says."""
    if column not in frame:
        return np.full(len(frame), base, dtype=np.float64 if isinstance(base, Real) else object)
    given = [base if _is_missing(value) else value for value in frame[column].tolist()]
    if all(isinstance(value, Real) or value is None for value in given):
        return np.array([np.nan if value is None else value for value in given], dtype=np.float64)
    words = np.empty(len(given), dtype=object)
    words[:] = given
    return words


def _is_missing(value: Any) -> bool:
    return value is None or (isinstance(value, float) and value != value)


def owners(result: StudyResult, inputs: Sequence[Input]) -> npt.NDArray[np.int_]:
    """Of a study that varies one factor at a time: the factor of each design; -1 of the file's."""
    found = np.full(len(result.all_designs), -1)
    for each in inputs:
        if each.is_factor and each.base is not None:
            found[(found < 0) & np.array([value != each.base for value in each.values])] = (
                each.factor
            )
    if "designs" in result:
        paths = [each.path for each in inputs if each.is_factor]
        for row, design in enumerate(result["designs"]):
            first = next(iter(design["settings"]), None)
            if first in paths and paths.count(first) == 1:
                found[row] = paths.index(first)
    return found


def is_geometric(numbers: Sequence[float]) -> bool:
    """Whether numbers grow by a factor, so that an axis should be logarithmic."""
    at = np.sort(np.asarray(numbers, dtype=np.float64))
    if len(at) < 3 or at[0] <= 0.0 or at[-1] < 8.0 * at[0]:
        return False
    steps = np.diff(np.log(at))
    return bool(np.ptp(steps) < 0.02 * steps.mean())


def hold(held: list[Input], rows: npt.NDArray[np.int_]) -> tuple[npt.NDArray[np.int_], list[str]]:
    """The designs in which these factors are as in the file, or nearest to it."""
    notes = []
    for each in held:
        levels = each.levels(rows)
        level = each.base if each.base in levels else levels[0]
        if each.is_numeric and isinstance(each.base, float | int):
            level = min(levels, key=lambda value: abs(value - float(each.base)))  # type: ignore
        rows = rows[each.values[rows] == level]
        notes.append(each.text(level))
    return rows, notes
