"""A case as a function of numbers, for optimizers and samplers."""

from __future__ import annotations

import json
import threading
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew import _engine
from rollerscrew.designs import (
    _ENTRY,
    Designs,
    Origin,
    SourceParts,
    _with_entries,
    designs_of,
    parts_of,
    require_once,
    source_of,
    told_of_arguments,
    warn_of,
)
from rollerscrew.errors import InputError
from rollerscrew.reasons import commands_of
from rollerscrew.record import some_of
from rollerscrew.records import Command
from rollerscrew.values import _MOST_EXACT, checked, number_text, override_text

if TYPE_CHECKING:
    from rollerscrew.case import Case

#: Units of the documents, one for each quantity of the input that has one.
_UNITS = ("mm", "N", "deg", "MPa", "rpm", "degC", "kg/m^3", "N/mm", "N m", "s", "")

#: So many designs are answered by the thread that asks; others by all processors.
_FEW = 256

#: Steps of differences, as parts of the number; of what is 0, of 1.
_STEP = 1e-3

_FORWARD = np.arange(5.0), np.array([-25.0, 48.0, -36.0, 16.0, -3.0]) / 12.0

#: Places in steps and weights of differences of fourth order: central ones and, where a design
#: beyond a bound fails, those of one side.
_DIFFERENCES = (
    (np.array([-2.0, -1.0, 1.0, 2.0]), np.array([1.0, -8.0, 8.0, -1.0]) / 12.0),
    _FORWARD,
    (-_FORWARD[0], -_FORWARD[1]),
)


class Function:
    """Responses of a case over inputs, compiled once: `case.function(inputs, responses)`.

    `f(x)` takes the n inputs of one design and gives its m responses, or k x n and gives k x m. A
    design that fails is NaN; `f.designs(x)` has the reasons. Raises ValueError where x is not
    finite. `units` are those of the inputs, `x0` is what the case has. Functions may be shared
    between threads, pickled and sent to other processes.

    Warns of inputs that move no load and no stiffness, as the case overrides what they give.
    """

    def __init__(
        self,
        case: Case,
        inputs: Sequence[str] | Mapping[str, str],
        responses: Sequence[str],
        command: Command = "solve",
        *,
        asked: Sequence[str] | None = None,
    ) -> None:
        for name, given in (("inputs", inputs), ("responses", responses)):
            if isinstance(given, str):
                raise TypeError(f"{name}: got {given!r}; expected a list such as [{given!r}]")
            checked(name, given, Iterable, "a list of paths")
        inputs = inputs if isinstance(inputs, Mapping) else tuple(inputs)
        responses = list(responses)
        for name, paths in (("inputs", inputs), ("responses", responses)):
            if not paths:
                raise ValueError(f"{name}: got none; expected a list of paths")
        #: Responses as they were given, with those of other commands.
        self._given = responses if asked is None else asked
        require_once(self._given)
        for path in inputs:
            try:
                case[path]
            except KeyError as error:
                why = str(error.args[0]).removeprefix(f"{path!r}: ")
                raise InputError(f"inputs[{path!r}]: {why}") from None
        self._case = case
        self._parts: SourceParts = parts_of(case._case.source)
        self.inputs = tuple(inputs)
        self.command: Command | tuple[Any, ...] = command
        named = inputs if isinstance(inputs, Mapping) else {}
        self.units = tuple(named.get(path) or _unit_of(case, path) for path in self.inputs)
        #: What the case itself has.
        self.x0: npt.NDArray[np.float64] = np.array(
            [case.number(path, unit) for path, unit in zip(self.inputs, self.units, strict=True)]
        )
        self._responses = _with_entries(case, list(responses), command)
        self._counts: dict[int, list[int]] = {
            k: [int(number)]
            for k, (path, number) in enumerate(zip(self.inputs, self.x0, strict=True))
            if _is_count(case, path)
        }
        self._lock = threading.Lock()
        self._study = self._compiled()
        warn_of(self._study)
        self.responses: tuple[str, ...] = tuple(self._responses)

    def __reduce__(self) -> tuple[Any, ...]:
        inputs = dict(zip(self.inputs, self.units, strict=True))
        return _restored, (self._case, inputs, self._responses, self.command)

    def __repr__(self) -> str:
        inputs = [
            f"{path} [{unit}]" if unit else path
            for path, unit in zip(self.inputs, self.units, strict=True)
        ]
        return f"<Function of {some_of(inputs)}: {some_of(self.responses)}>"

    def __call__(self, x: npt.ArrayLike) -> npt.NDArray[np.float64]:
        numbers = np.asarray(x, dtype=np.float64)
        values = self._answers(self._rows(numbers)).values
        return values[0] if numbers.ndim == 1 else values

    def designs(self, x: npt.ArrayLike) -> Designs:
        """The designs with their status and reasons.

        Parameters
        ----------
        x : array of n numbers, or of k x n
            Inputs in `units`.

        Returns
        -------
        Designs

        Raises
        ------
        ValueError
            Where the shape is another one.
        """
        import pandas as pd

        rows = self._rows(np.asarray(x, dtype=np.float64))
        study, levels = self._levels(rows)
        answers = self._answered(study, levels)
        names = [
            f"{path}_{_engine.unit_key(unit)}" if unit else path
            for path, unit in zip(self.inputs, self.units, strict=True)
        ]
        parts = self._study_parts(self._plan())
        origin = Origin(self._parts, parts, levels, command=str(self.command))
        return designs_of(pd.DataFrame(rows, columns=names), answers, origin)

    def jacobian(self, x: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Derivatives of the responses by the inputs at one design, m x n.

        Exact by the tangent of the equilibrium where the plan `derivatives` of studies has them;
        else differences of fourth order, at a bound those of one side. Raises ValueError for
        inputs that are counts.

        Parameters
        ----------
        x : array of n numbers
            Inputs in `units`.

        Returns
        -------
        numpy.ndarray
            m x n, units of the responses over `units`.
        """
        numbers = np.asarray(x, dtype=np.float64)
        if numbers.shape != (len(self.inputs),):
            raise ValueError(f"x: got the shape {numbers.shape}; expected ({len(self.inputs)},)")
        if self._counts:
            counts = ", ".join(self.inputs[k] for k in self._counts)
            raise ValueError(f"{counts}: got a count; expected inputs that have derivatives")
        found = self._derivatives(numbers)
        rough: npt.NDArray[np.bool_] = np.asarray(np.isnan(found).any(axis=0))
        if rough.any():
            found = np.where(np.isnan(found), self._differences(numbers, rough), found)
        return found

    def _derivatives(self, x: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """NaN where there are none."""
        found = np.full((len(self.responses), len(self.inputs)), np.nan)
        plan = {
            "command": self.command,
            "plan": "derivatives",
            "factors": [{"path": path} for path in self.inputs],
            "responses": self._responses,
        }
        at = [f"{path}={self._text(k, x[k])}" for k, path in enumerate(self.inputs)]
        try:
            study = _engine.Study(source_of(self._parts, [*at, f"study={override_text(plan)}"]))
            document = study.derivatives().root
        except InputError:
            return found
        for row, response in enumerate(json.loads(document.text())["derivatives"]):
            for column, by in enumerate(response["by"]):
                found[row, column] = by.get("derivative", np.nan)
        return found

    def _differences(
        self, x: npt.NDArray[np.float64], wanted: npt.NDArray[np.bool_]
    ) -> npt.NDArray[np.float64]:
        found = np.full((len(self.responses), x.size), np.nan)
        steps = _STEP * np.where(x == 0.0, 1.0, np.abs(x))
        for places, weights in _DIFFERENCES:
            columns = np.flatnonzero(wanted & np.isnan(found).any(axis=0))
            points = np.repeat(x[None, :], places.size * columns.size, axis=0)
            for k, column in enumerate(columns):
                rows = slice(places.size * k, places.size * (k + 1))
                points[rows, column] += steps[column] * places
            values = self(points).reshape(columns.size, places.size, len(self.responses))
            slopes = np.einsum("kim,i->mk", values, weights) / steps[columns]
            found[:, columns] = np.where(np.isnan(found[:, columns]), slopes, found[:, columns])
        return found

    def _rows(self, x: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        rows = x[None, :] if x.ndim == 1 else x
        if rows.ndim != 2 or rows.shape[1] != len(self.inputs):
            raise ValueError(
                f"x: got the shape {x.shape}; expected ({len(self.inputs)},) for one design or "
                f"(k, {len(self.inputs)}) for many"
            )
        return np.ascontiguousarray(rows)

    def _answers(self, rows: npt.NDArray[np.float64]) -> _engine.Designs:
        return self._answered(*self._levels(rows))

    @staticmethod
    def _answered(study: _engine.Study, numbers: npt.NDArray[np.float64]) -> _engine.Designs:
        if len(numbers) <= _FEW:
            return study.answer(numbers)
        return study.evaluate(numbers, _engine.available_processors(), None)

    def _levels(
        self, rows: npt.NDArray[np.float64]
    ) -> tuple[_engine.Study, npt.NDArray[np.float64]]:
        """Numbers, of counts their places among those that the study was compiled for."""
        if not self._counts:
            return self._study, rows
        with self._lock:
            return self._counted(rows)

    def _counted(
        self, rows: npt.NDArray[np.float64]
    ) -> tuple[_engine.Study, npt.NDArray[np.float64]]:
        numbers = rows.copy()
        for k, known in self._counts.items():
            # NaN, too, is not less.
            wrong = ~(np.abs(rows[:, k]) < _MOST_EXACT) | (rows[:, k] != np.round(rows[:, k]))
            if wrong.any():
                raise ValueError(
                    f"{self.inputs[k]}: got {rows[wrong, k][0]}; expected whole numbers"
                )
            new = sorted(set(rows[:, k].astype(int).tolist()) - set(known))
            if new:
                known += new
                try:
                    self._study = self._compiled()
                except InputError:
                    del known[-len(new) :]
                    raise
            places = {count: place for place, count in enumerate(known)}
            numbers[:, k] = [places[int(count)] for count in rows[:, k]]
        return self._study, numbers

    def _plan(self) -> dict[str, Any]:
        factors: list[dict[str, Any]] = []
        for k, (path, number) in enumerate(zip(self.inputs, self.x0, strict=True)):
            if k in self._counts:
                factors.append({"path": path, "values": list(self._counts[k])})
            else:
                # Designs are given by their values; ends are read, and must stand in the case.
                end = number * (1.0 - 1e-9) if number else 1e-9
                low, high = sorted((number, end))
                ends = {"from": self._text(k, low), "to": self._text(k, high)}
                factors.append({"path": path, "uniform": ends})
        return {
            "command": self.command,
            "plan": "monte_carlo",
            "samples": 1,
            "factors": factors,
            "responses": self._responses,
        }

    def _study_parts(self, plan: Mapping[str, Any]) -> SourceParts:
        name, text, overrides, folder, files = self._parts
        return name, text, (*overrides, f"study={override_text(plan)}"), folder, files

    def _compiled(self) -> _engine.Study:
        try:
            return _engine.Study(source_of(self._study_parts(self._plan())))
        except InputError as error:
            told = (
                told_of_arguments(
                    each,
                    self.inputs,
                    self._given,
                    self._responses,
                    str(self.command),
                    lambda: self._case,
                    lambda *_: None,
                )
                for each in error.errors
            )
            raise InputError("\n".join(told)) from None

    def _text(self, k: int, number: float) -> Any:
        unit = self.units[k]
        return f"{number_text(float(number))} {unit}" if unit else float(number)


class JoinedFunction(Function):
    """Functions of the same inputs, whose responses stand side by side in the order asked for."""

    def __init__(self, functions: Sequence[Function], responses: Sequence[str]) -> None:
        first = functions[0]
        self._functions, self._asked = tuple(functions), tuple(responses)
        self.inputs, self.units, self.x0 = first.inputs, first.units, first.x0
        self.command = tuple(each.command for each in functions)
        found = [each for function in functions for each in function.responses]
        entries = [path if path in responses else _ENTRY.sub("", path) for path in found]
        self._order = sorted(range(len(found)), key=lambda k: self._asked.index(entries[k]))
        self.responses = tuple(found[k] for k in self._order)

    def __reduce__(self) -> tuple[Any, ...]:
        return JoinedFunction, (self._functions, self._asked)

    def __call__(self, x: npt.ArrayLike) -> npt.NDArray[np.float64]:
        return np.concatenate([each(x) for each in self._functions], axis=-1)[..., self._order]

    def jacobian(self, x: npt.ArrayLike) -> npt.NDArray[np.float64]:
        return np.concatenate([each.jacobian(x) for each in self._functions])[self._order]

    def designs(self, x: npt.ArrayLike) -> Designs:
        parts = [each.designs(x) for each in self._functions]
        status, reason = parts[0].status.copy(), parts[0].reason.copy()
        for part in parts[1:]:
            fails = status == "converged"
            status[fails], reason[fails] = part.status[fails], part.reason[fails]
        values = np.hstack([part.values for part in parts])[:, self._order]
        assert parts[0].origin is not None
        origin = replace(parts[0].origin, command=", ".join(self.command))
        return Designs(parts[0].inputs, self.responses, values, status, reason, origin)


def function_of(
    case: Case,
    inputs: Sequence[str] | Mapping[str, str],
    responses: Sequence[str] | Mapping[Command, Sequence[str]],
    command: Command | None,
) -> Function:
    """The function of one command or of several, each with its responses."""
    inputs = (
        inputs
        if isinstance(inputs, (str, Mapping)) or not isinstance(inputs, Iterable)
        else tuple(inputs)
    )
    if isinstance(responses, Iterable) and not isinstance(responses, (str, Mapping)):
        responses = list(responses)
    if isinstance(responses, Mapping):
        if command is not None:
            raise TypeError(f"command: got {command!r} beside those of responses; expected one")
        asked: dict[Any, Sequence[str]] = dict(responses)
    elif command is not None or isinstance(responses, str) or not responses:
        asked = {command or "solve": responses}
    else:
        asked = {}
        for path in checked("responses", responses, Iterable, "a list of paths"):
            homes = commands_of(path) if isinstance(path, str) else ("solve",)
            own = "solve" if "solve" in homes else homes[0]
            asked[own] = [*asked.get(own, ()), path]
    given = None if isinstance(responses, Mapping) else list(responses)
    functions = [Function(case, inputs, paths, of, asked=given) for of, paths in asked.items()]
    if len(functions) == 1:
        return functions[0]
    ordered = [path for paths in asked.values() for path in paths]
    return JoinedFunction(functions, ordered if isinstance(responses, Mapping) else responses)


def _restored(
    case: Case, inputs: Mapping[str, str], responses: Sequence[str], command: Command
) -> Function:
    with warnings.catch_warnings():  # It has warned where it was made.
        warnings.simplefilter("ignore")
        return Function(case, inputs, responses, command)


def _unit_of(case: Case, path: str) -> str:
    """The unit that documents have for what stands at a path."""
    value = case[path]
    text = value if isinstance(value, str) else repr(value)
    for unit in _UNITS:
        if _engine.number_in(text, unit) is not None:
            return unit
    _, _, own = text.partition(" ")
    if _engine.number_in(text, own) is None:
        raise ValueError(f"{path}: got {value!r}; expected an input that is a number")
    return own


def _is_count(case: Case, path: str) -> bool:
    """Whether an input takes whole numbers alone."""
    value = case[path]
    if not isinstance(value, int) or isinstance(value, bool):
        return False
    try:
        case.with_({path: value + 0.5})
    except InputError as error:
        return "whole number" in str(error)
    return False
