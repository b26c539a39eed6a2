"""Many designs of a case: arrays of inputs, studies, optimizations."""

from __future__ import annotations

import operator
import os
import reprlib
import warnings
from collections.abc import Mapping, Sequence
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, as_completed
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from rollerscrew import _engine
from rollerscrew.progress import Progress, progress_callback
from rollerscrew.records import Command
from rollerscrew.values import (
    checked_text,
    is_quantity,
    number_text,
    override_text,
    plain,
    unit_and_magnitude,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Whole numbers up to so many different ones are counts; arrays with more are quantities.
_MOST_COUNTS = 10_000

#: An executor gets about so many pieces of a study, so that none of its workers waits long.
_PIECES = 256


@dataclass(frozen=True, eq=False)
class Designs:
    """Answers of many designs, a row each, in the order in which they were asked for."""

    inputs: pd.DataFrame  #: What the designs differ in; units stand in the names of the columns.
    responses: tuple[str, ...]
    values: npt.NDArray[np.float64]  #: designs x responses, read-only; NaN where there is none.
    status: npt.NDArray[np.object_]  #: `converged`, or how the design ended.
    reason: npt.NDArray[np.object_]  #: Empty where converged.

    def __post_init__(self) -> None:
        for array in (self.values, self.status, self.reason):
            array.flags.writeable = False

    def __reduce__(self) -> tuple[Any, ...]:
        return Designs, (self.inputs, self.responses, self.values, self.status, self.reason)

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        converged = int(self.converged.sum())
        return f"<Designs: {len(self)}, {converged} converged; {', '.join(self.responses)}>"

    def __getitem__(self, response: str) -> npt.NDArray[np.float64]:
        """The values of one response, read-only."""
        try:
            return self.values[:, self.responses.index(response)]
        except ValueError:
            raise KeyError(f"{response!r}; there is {', '.join(self.responses)}") from None

    @property
    def converged(self) -> npt.NDArray[np.bool_]:
        return np.asarray(self.status == "converged", dtype=np.bool_)

    def plot(self, x: str, y: str, colour: str | None = None, ax: Axes | None = None) -> Axes:
        """Converged designs as points: an input or response over another, coloured by a third."""
        from rollerscrew import plots

        return plots.draw(_cloud(self, x, y, colour), ax)

    def to_frame(self) -> pd.DataFrame:
        """Inputs, status, reason and responses, one row per design: the columns of `study.csv`."""
        outcome = pd.DataFrame({"status": self.status, "reason": self.reason})
        answers = pd.DataFrame(self.values, columns=list(self.responses))
        return pd.concat([self.inputs, outcome, answers], axis=1)


def _cloud(answers: Designs, x: str, y: str, colour: str | None) -> dict[str, Any]:
    """The description of converged designs as points."""
    names = [name for name in (x, y, colour) if name is not None]
    values = np.column_stack([_numbers(answers, name) for name in names])
    values = values[answers.converged & np.isfinite(values).all(axis=1)]
    if not len(values):
        raise ValueError("no design converged with numbers in all of these columns")
    series: dict[str, Any] = {"style": 0, "parts": [values[:, :2]]}
    described: dict[str, Any] = {
        "name": "designs",
        "styles": [{"colour": "blue", "dash": "none", "mark": "circle", "weight": "thin"}],
        "x": _axis(x),
        "y": _axis(y),
        "panels": [{"series": [series]}],
    }
    if colour is not None:
        series |= {"parts": values[:, None, :2], "values": values[:, 2]}
        ends = {"from": values[:, 2].min(), "to": values[:, 2].max()}
        described["colours"] = _axis(colour) | ends
    return described


def _axis(name: str) -> dict[str, Any]:
    label, unit = _engine.response_title(name)
    return {"label": label[:1].upper() + label[1:], "unit": unit}


def _numbers(answers: Designs, name: str) -> npt.NDArray[np.float64]:
    if name in answers.responses:
        return answers[name]
    if name not in answers.inputs:
        known = ", ".join([*answers.inputs.columns, *answers.responses])
        raise KeyError(f"no column {name!r}; there is {known}")
    column = answers.inputs[name]
    if column.dtype.kind not in "fiu":
        raise ValueError(f"{name} holds words; expected a column of numbers")
    return column.to_numpy(dtype=np.float64)


def designs_of(inputs: pd.DataFrame, answers: _engine.Designs) -> Designs:
    status = np.full(answers.count, "converged", dtype=object)
    reason = np.full(answers.count, "", dtype=object)
    for row, name, why in answers.failures:
        status[row], reason[row] = name, why
    return Designs(inputs, tuple(answers.responses), answers.values, status, reason)


def study_inputs(study: _engine.Study) -> pd.DataFrame:
    """What the designs of a study set, a row each."""
    columns = {}
    values = study.factor_values()
    for column, (name, words) in enumerate(
        zip(study.factor_names(), study.factor_words(), strict=True)
    ):
        numbers = values[:, column]
        columns[name] = [words[int(k)] for k in numbers] if words else numbers
    return pd.DataFrame(columns)


def evaluate(
    source: _engine.Source,
    inputs: Mapping[str, Any],
    responses: Sequence[str] | None,
    command: Command,
    threads: int | None,
    progress: Progress,
) -> Designs:
    """See `Case.evaluate`."""
    if not isinstance(inputs, Mapping) or not inputs:
        raise TypeError(
            "expected a dictionary of arrays, such as {'mechanism.lead': (leads, 'mm')}"
        )
    if isinstance(responses, str):
        raise TypeError(f"got the text {responses!r}; expected a list of responses")
    constants = [
        f"{checked_text('path', path)}={override_text(value)}"
        for path, value in inputs.items()
        if _is_scalar(value)
    ]
    columns = {
        path: _Column.of(checked_text("path", path), values)
        for path, values in inputs.items()
        if not _is_scalar(values)
    }
    if not columns:
        raise ValueError("expected an array for one of the inputs; `with_` takes single values")
    lengths = {path: len(column.numbers) for path, column in columns.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(
            "expected arrays of one length; got "
            + ", ".join(f"{count} of {path}" for path, count in lengths.items())
        )
    plan: dict[str, Any] = {
        "command": command,
        "plan": "monte_carlo",
        "samples": 1,
        "factors": [column.factor for column in columns.values()],
    }
    if responses is not None:
        plan["responses"] = list(responses)
    study = _engine.Study(
        _engine.Source.of_text(
            source.name,
            source.text,
            [*source.overrides, *constants, f"study={override_text(plan)}"],
            source.folder,
        )
    )
    for text in study.warnings:
        warnings.warn(text, stacklevel=3)
    numbers = np.column_stack([column.numbers for column in columns.values()])
    answers = study.evaluate(numbers, thread_count(threads), progress_callback(progress))
    frame = pd.DataFrame(
        {
            name if isinstance(column.shown, np.ndarray) else path: column.shown
            for name, (path, column) in zip(study.factor_names(), columns.items(), strict=True)
        }
    )
    return designs_of(frame, answers)


@dataclass(frozen=True)
class _Column:
    """One input of many designs: numbers within a range, or the indices of values."""

    factor: dict[str, Any]  #: As a study of the case has it.
    numbers: npt.NDArray[np.float64]
    shown: Any  #: The values, for people.

    @classmethod
    def of(cls, path: str, values: Any) -> _Column:
        unit = ""
        if is_quantity(values):
            unit, values = unit_and_magnitude(values)
        elif _is_with_unit(values):
            values, unit = values
        if isinstance(values, list | tuple) and not all(map(_is_number, values)):
            return cls._of_values(path, list(values), unit)
        if np.ma.is_masked(values):
            raise ValueError(f"{path}: got masked numbers; expected finite numbers")
        array = np.asarray(values)
        if array.ndim != 1 or array.size == 0:
            raise ValueError(
                f"{path}: got {reprlib.repr(values)} of shape {array.shape}; expected an array of "
                "one dimension, or a list, with at least one value"
            )
        if array.dtype.kind in "fiu":
            with np.errstate(over="ignore"):  # A long double may become infinite.
                return cls._of_numbers(path, array.astype(np.float64), unit)
        return cls._of_values(path, list(array), unit)

    @classmethod
    def _of_numbers(cls, path: str, numbers: npt.NDArray[np.float64], unit: str) -> _Column:
        wrong = np.flatnonzero(~np.isfinite(numbers))
        if wrong.size > 0:
            raise ValueError(
                f"{path}[{wrong[0]}]: got {numbers[wrong[0]]}; expected finite numbers"
            )
        low, high = float(numbers.min()), float(numbers.max())
        if not unit and np.all(numbers == np.round(numbers)) and np.abs(numbers).max() < 2**53:
            counts, indices = np.unique(numbers, return_inverse=True)
            if counts.size <= _MOST_COUNTS:
                levels = [int(count) for count in counts]
                return cls({"path": path, "values": levels}, indices.astype(np.float64), numbers)
        if low == high:
            factor = {"path": path, "values": [_with_unit(low, unit)]}
            return cls(factor, np.zeros_like(numbers), numbers)
        ends = {"from": _with_unit(low, unit), "to": _with_unit(high, unit)}
        return cls({"path": path, "uniform": ends}, numbers, numbers)

    @classmethod
    def _of_values(cls, path: str, values: list[Any], unit: str) -> _Column:
        if unit:
            raise TypeError(f"{path}: expected numbers next to the unit {unit!r}")
        values = [plain(value) for value in values]
        texts = [override_text(value) for value in values]
        place = {text: k for k, text in enumerate(dict.fromkeys(texts))}
        levels = list(dict(zip(texts, values, strict=True)).values())
        indices = np.array([place[text] for text in texts], dtype=np.float64)
        return cls({"path": path, "values": levels}, indices, texts)


def _is_scalar(value: Any) -> bool:
    """Which all designs have."""
    if is_quantity(value):
        return np.ndim(value.magnitude) == 0
    return isinstance(value, str | bool | int | float | np.generic)


def _is_with_unit(values: Any) -> bool:
    """`(numbers, "mm")`."""
    if not (isinstance(values, tuple) and len(values) == 2):
        return False
    return isinstance(values[1], str) and not isinstance(values[0], str)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)


def _with_unit(number: float, unit: str) -> Any:
    return f"{number_text(number)} {unit}" if unit else number


def thread_count(threads: int | None) -> int:
    """The threads asked for, or one per processor."""
    if threads is None:
        return _engine.available_processors()
    if not hasattr(threads, "__index__"):
        raise TypeError(f"threads: got {threads!r}; expected a whole number from 1 to 4096")
    count = operator.index(threads)
    if not 1 <= count <= 4096:
        raise ValueError(f"threads: got {count}; expected 1 to 4096")
    return count


SourceParts = tuple[str, str, tuple[str, ...], str]


@lru_cache(maxsize=4)
def _prepared(parts: SourceParts, process: int) -> _engine.Study:
    name, text, overrides, folder = parts
    return _engine.Study(_engine.Source.of_text(name, text, list(overrides), folder))


def _answer(parts: SourceParts, first: int, count: int) -> bytes:
    """In a worker: the record of designs [first, first + count)."""
    return _prepared(parts, os.getpid()).record(first, count)


def study_rows(
    source: _engine.Source,
    executor: Executor | None,
    threads: int | None,
    progress: Progress,
) -> tuple[_engine.Study, _engine.StudyRows | None]:
    """A study and the rows of all its designs; without rows where the plan has none."""
    study = _engine.Study(source)
    if not study.has_designs:
        return study, None
    show = progress_callback(progress)
    if executor is None:
        return study, study.run(thread_count(threads), show)
    if not hasattr(executor, "submit"):
        raise TypeError(f"got {executor!r}; expected an executor of concurrent.futures")
    parts = (source.name, source.text, tuple(source.overrides), source.folder)
    size = max(study.chunk, -(-study.count // _PIECES))
    pieces: dict[Future[bytes], tuple[int, int]] = {}
    try:
        for first in range(0, study.count, size):
            count = min(size, study.count - first)
            pieces[executor.submit(_answer, parts, first, count)] = (first, count)
        records = []
        done = 0
        for future in as_completed(pieces):
            first, count = pieces[future]
            records.append(_record(study, future, first, count))
            done += count
            if show:
                show(done, study.count)
    except BaseException:
        for future in pieces:
            future.cancel()
        raise
    return study, study.collect(records)


def _record(study: _engine.Study, future: Future[bytes], first: int, count: int) -> bytes:
    """What a worker answered; designs that it could not answer are rows with the reason."""
    try:
        return future.result()
    except (BrokenExecutor, CancelledError):
        raise
    except Exception as error:
        reason = f"{type(error).__name__}: {error}".encode(errors="replace").decode()
        return study.failed_record(first, count, reason)
