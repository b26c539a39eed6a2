"""Many designs of a case: arrays of inputs, studies, optimizations."""

from __future__ import annotations

import math
import operator
import os
import re
import reprlib
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
import numpy.typing as npt

from rollerscrew import _engine
from rollerscrew.errors import InputError, InputProblem, warn_caller
from rollerscrew.frames import array_kinds
from rollerscrew.progress import Progress, progress_callback
from rollerscrew.reasons import COMMANDS, STUDIED, Reasons, commands_of, numbers_known, response_in
from rollerscrew.record import loads_of, some_of
from rollerscrew.records import (
    Command,
    FlankThreads,
    FrictionForces,
    InterfaceLife,
    InterfaceLoads,
    InterfaceSlip,
)
from rollerscrew.values import (
    checked,
    checked_text,
    is_quantity,
    is_with_unit,
    number_text,
    override_text,
    place_among,
    plain,
    unit_and_magnitude,
)

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

    import pandas as pd
    import xarray
    from matplotlib.axes import Axes

    from rollerscrew.case import Case

#: Whole numbers up to so many different ones are counts; arrays with more are quantities.
_MOST_COUNTS = 10_000

#: An executor gets about so many pieces of a study, so that none of its workers waits long.
_PIECES = 256

#: Name, text, overrides, folder and the files that it names of a source.
SourceParts = tuple[str, str, tuple[str, ...], str, tuple[tuple[str, bytes], ...] | None]

#: What a design whose inputs cannot stand in the case does: it ends the call, or it is a row.
OnError = Literal["raise", "row"]


def parts_of(source: _engine.Source) -> SourceParts:
    files = source.files
    return (
        source.name,
        source.text,
        tuple(source.overrides),
        source.folder,
        None if files is None else tuple(sorted(files.items())),
    )


def source_of(parts: SourceParts, more: Iterable[str] = ()) -> _engine.Source:
    """The source, with further overrides."""
    name, text, overrides, folder, files = parts
    kept = None if files is None else dict(files)
    return _engine.Source.of_text(name, text, [*overrides, *more], folder, kept)


@dataclass(frozen=True, eq=False)
class Origin:
    """Where designs come from: `case` of the whole, `study` of the source that varies it."""

    case: SourceParts
    study: SourceParts | None
    rows: npt.NDArray[Any]  #: Numbers of designs of a study, or one row of settings per design.
    columns: Mapping[str, _Column] | None = None  #: Without a study: what the rows set.
    command: str = ""  #: That answers them; of several commands their names.

    def overrides(self, place: int) -> list[str]:
        if self.columns is not None:
            row = int(self.rows[place])
            return [f"{path}={column.text_of(row)}" for path, column in self.columns.items()]
        assert self.study is not None
        study = _prepared(self.study, os.getpid())
        if self.rows.ndim == 1:
            return study.overrides(int(self.rows[place]))
        return study.overrides_of(np.ascontiguousarray(self.rows[place : place + 1]))


@dataclass(frozen=True, eq=False)
class Designs:
    """Answers of many designs, one row each, in the order in which they were asked for.

    `designs["axial_stiffness_N_per_um"]` is the array of a response or of a column of `inputs`,
    `designs[mask]` the designs that a mask, a slice or places choose, `designs.case(i)` the case of
    one of them.
    """

    inputs: pd.DataFrame  #: What the designs differ in; units stand in the names of the columns.
    responses: tuple[str, ...]
    values: npt.NDArray[np.float64]  #: designs x responses, read-only; NaN where there is none.
    status: npt.NDArray[np.object_]  #: `converged`, or how the design ended.
    reason: npt.NDArray[np.object_]  #: Empty where converged.
    origin: Origin | None = None

    def __post_init__(self) -> None:
        for array in (self.values, self.status, self.reason):
            array.flags.writeable = False

    def __reduce__(self) -> tuple[Any, ...]:
        parts = (self.inputs, self.responses, self.values, self.status, self.reason, self.origin)
        return Designs, parts

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        converged = int(self.converged.sum())
        shown = some_of(list(self._whole_responses()))
        return f"<Designs: {len(self)}, {converged} converged; {shown}>"

    def _repr_html_(self) -> str:
        from rollerscrew.html import designs_html

        return designs_html(self)

    @overload
    def __getitem__(self, chosen: str) -> npt.NDArray[np.float64]: ...
    @overload
    def __getitem__(self, chosen: slice | Sequence[int] | npt.NDArray[Any]) -> Designs: ...
    def __getitem__(self, chosen: Any) -> npt.NDArray[np.float64] | Designs:
        if not isinstance(chosen, str):
            return self._chosen(chosen)
        if chosen in self.responses:
            return self.values[:, self.responses.index(chosen)]
        if chosen in self.inputs:
            return _numbers(self, chosen)
        whole = self._whole_responses().get(chosen)
        if whole is None:
            if (placed := self._with_places(chosen)) == chosen:
                raise KeyError(self._unknown(chosen))
            return self[placed]
        array = self.values[:, whole]
        array.flags.writeable = False
        return array

    def _with_places(self, name: str) -> str:
        """`load_cases[0].slip.efficiency` of `load_cases[pull].slip.efficiency`."""
        from rollerscrew.case import Case

        found = re.match(r"load_cases\[(?!\d+\])([^\]]+)\]", checked_text("column", name))
        if found is None or self.origin is None:
            return name
        entries = Case._from_source(source_of(self.origin.case))["load_cases"]
        names = [entry.get("name") for entry in entries]
        if found[1] not in names:
            return name
        return f"load_cases[{names.index(found[1])}]{name[found.end() :]}"

    def _unknown(self, name: str) -> str:
        return f"no column {name!r}; there is {', '.join([*self.inputs, *self._whole_responses()])}"

    def _whole_responses(self) -> dict[str, list[int]]:
        """The columns of each response: those of an array together, under its path."""
        columns: dict[str, list[int]] = {}
        for place, response in enumerate(self.responses):
            columns.setdefault(_ENTRY.sub("", response), []).append(place)
        whole = {}
        for name, places in columns.items():
            if len(places) > 1:
                whole[name] = places
            else:
                whole[self.responses[places[0]]] = places
        return whole

    def _chosen(self, rows: Any) -> Designs:
        chosen = rows
        if not isinstance(rows, slice):
            chosen = np.asarray(rows, dtype=int if np.size(rows) == 0 else None)
        places = np.arange(len(self))[chosen]
        if places.ndim != 1:
            raise TypeError(
                f"got {rows!r}; expected a response, a slice, a mask or a list of places; "
                "`designs.case(place)` is one of them"
            )
        origin = self.origin and replace(self.origin, rows=self.origin.rows[places])
        inputs = self.inputs.iloc[places]
        return Designs(
            inputs.reset_index(drop=True) if self._counts_rows else inputs,
            self.responses,
            self.values[places],
            self.status[places],
            self.reason[places],
            origin,
        )

    @property
    def _counts_rows(self) -> bool:
        """Whether the index is that of frames without one."""
        import pandas as pd

        return isinstance(self.inputs.index, pd.RangeIndex)

    @property
    def converged(self) -> npt.NDArray[np.bool_]:
        return np.asarray(self.status == "converged", dtype=np.bool_)

    def case(self, design: int) -> Case:
        """The case of one design, as `with_` would give it.

        Parameters
        ----------
        design : int
            Place of the design, from 0.

        Returns
        -------
        Case

        Raises
        ------
        IndexError
            Where there is no such design.
        ValueError
            Of designs that were read from JSON.
        """
        from rollerscrew.case import Case

        if self.origin is None:
            raise ValueError("designs that were read from JSON have no case; run them again")
        place = place_among(len(self), "design", design)
        return Case._from_source(source_of(self.origin.case, self.origin.overrides(place)))

    def best(self, response: str, *, largest: bool = False) -> int:
        """The place of the converged design with the smallest value of a response, or the largest.

        >>> designs.case(designs.best("axial_stiffness_N_per_um", largest=True))

        Parameters
        ----------
        response : str
            A response that is a number.
        largest : bool, optional
            Whether the largest value is the best.

        Returns
        -------
        int
            Place of the design, from 0.

        Raises
        ------
        ValueError
            Where no design converged with a value.
        """
        values = self[checked_text("response", response)]
        if values.ndim > 1:
            raise ValueError(f"{response}: got an array; expected a number such as {response}.max")
        values = np.where(self.converged, values, np.nan)
        if not np.isfinite(values).any():
            raise ValueError(f"no design converged with a value of {response}")
        return int(np.nanargmax(values) if largest else np.nanargmin(values))

    def plot(
        self,
        x: str,
        y: str,
        colour: str | None = None,
        ax: Axes | None = None,
        *,
        label: str | None = None,
        color: Any = None,
        width: float | None = None,
    ) -> Axes:
        """Converged designs as points: an input or response over another, coloured by a third.

        `label`, `color` and `width` as `rollerscrew.plots.draw` has them.

        Parameters
        ----------
        x, y : str
            An input or a response.
        colour : str, optional
            An input or a response.
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; without it in a new figure.
        label : str, optional
            Name in the legend.
        color : optional
            A colour of matplotlib.
        width : float, optional
            Width of a new figure in mm.

        Returns
        -------
        matplotlib.axes.Axes
        """
        from rollerscrew import plots

        x, y = self._with_places(x), self._with_places(y)
        colour = colour and self._with_places(colour)
        return plots.draw(_cloud(self, x, y, colour), ax, label=label, color=color, width=width)

    def to_frame(self) -> pd.DataFrame:
        """Inputs, status, reason and responses, one row per design.

        `study.csv` has these columns behind the number of the design, its first row is the base
        case; that of the plan `one_at_a_time` has the value that is changed in place of the inputs.

        Returns
        -------
        pandas.DataFrame
        """
        import pandas as pd

        index = self.inputs.index
        status, reason = (pd.Series(each, index, "str") for each in (self.status, self.reason))
        outcome = pd.DataFrame({"status": status, "reason": reason})
        answers = pd.DataFrame(self.values, index, columns=list(self.responses))
        return pd.concat([self.inputs, outcome, answers], axis=1)

    def to_xarray(self) -> xarray.Dataset:
        """Responses over the inputs: where these form a grid, each is a dimension.

        Else there is one dimension, `design`, with the inputs as coordinates. The index of a frame
        is a coordinate, too, where there is one dimension. Arrays over threads have the dimension
        `thread`; the number of the first thread is 1, and what an array lacks is NaN. Other arrays
        have a dimension of their own, `response.position_mm_index`, from 0. Variables have the
        attributes `units` and `long_name`, the whole `prs_version`, `case_file`, `input_sha256`,
        `command` and `loads`: `at rest`, or `running` with the friction of a screw that turns.

        Returns
        -------
        xarray.Dataset
        """
        import xarray

        names = [str(name) for name in self.inputs]
        inputs = [self.inputs[name].to_numpy() for name in names]
        levels = [np.unique(values) for values in inputs]
        shape = tuple(map(len, levels))
        dims: tuple[str, ...] = ("design",)
        order: npt.NDArray[Any] = np.arange(len(self))
        coordinates: dict[str, Any] = {name: (dims, each) for name, each in zip(names, inputs)}
        if shape and math.prod(shape) == len(self):
            grid = np.full(shape, -1)
            grid[tuple(map(np.searchsorted, levels, inputs))] = order
            if (grid >= 0).all():
                dims, order, coordinates = tuple(names), grid, dict(zip(names, levels))
        if len(dims) == 1 and not self._counts_rows:
            for label, values in _index_columns(self.inputs.index).items():
                coordinates[label] = (dims, values[order])
        data: dict[str, Any] = {}
        whole = self._whole_responses()
        arrays = {
            name: np.array([int(self.responses[k].rpartition("[")[2][:-1]) for k in columns])
            for name, columns in whole.items()
            if len(columns) > 1
        }
        ends = {name: _ENTRY.sub("", name).rpartition(".")[2] for name in arrays}
        over_threads = {name for name, end in ends.items() if end in _thread_arrays()}
        threads = np.unique([k + 1 for name in over_threads for k in arrays[name]])
        if over_threads:
            coordinates["thread"] = threads
        for name, columns in whole.items():
            values = self.values[order][..., columns]
            title, unit = _engine.response_title(name)
            said = {"long_name": title, "units": unit}
            if name in over_threads:
                placed = np.full((*order.shape, len(threads)), np.nan)
                placed[..., np.searchsorted(threads, arrays[name] + 1)] = values
                data[name] = ((*dims, "thread"), placed, said)
            elif name in arrays:
                coordinates[f"{name}_index"] = arrays[name]
                data[name] = ((*dims, f"{name}_index"), values, said)
            else:
                data[name] = (dims, values[..., 0], said)
        data["status"] = (dims, self.status[order].astype(str))
        dataset = xarray.Dataset(data, coordinates, self._source_attributes())
        for name in names:
            dataset[name].attrs["units"] = _path_and_unit(name)[1]
        return dataset

    def _source_attributes(self) -> dict[str, str]:
        """What the designs were computed by, and from."""
        from rollerscrew.case import Case

        attributes = {"prs_version": _engine.version}
        if self.origin is not None:
            command = self.origin.command
            known = command if command in COMMANDS else "check"
            document = getattr(Case._from_source(source_of(self.origin.case)), known)()
            attributes |= {key: document[key] for key in ("case_file", "input_sha256")}
            attributes["command"] = command
            if loads := loads_of(document):
                attributes["loads"] = loads
        return attributes


def _index_columns(index: pd.Index[Any]) -> dict[str, npt.NDArray[Any]]:
    """The labels of designs by the names of their coordinates: `design`, or those of the levels."""
    if index.nlevels == 1:
        return {"design": index.to_numpy()}
    return {
        str(name if name is not None else f"level_{k}"): index.get_level_values(k).to_numpy()
        for k, name in enumerate(index.names)
    }


@lru_cache(maxsize=1)
def _thread_arrays() -> frozenset[str]:
    """The arrays with a number for each thread, by the ends of their paths."""
    kinds = (FlankThreads, FrictionForces, InterfaceLife, InterfaceLoads, InterfaceSlip)
    names = {name for kind in kinds for name in array_kinds(kind)}
    return frozenset(names - {"roller_share_percent"} | {"yang_load_rate_percent"})


#: The last place in a path: `screw.load_rate_percent[3]`.
_ENTRY = re.compile(r"\[\d+\]$")


_MOST_NORMAL_POINTS = 100


def _cloud(answers: Designs, x: str, y: str, colour: str | None) -> dict[str, Any]:
    """The description of converged designs as points."""
    names = [name for name in (x, y, colour) if name is not None]
    values = np.column_stack([_numbers(answers, name) for name in names])
    values = values[answers.converged & np.isfinite(values).all(axis=1)]
    if not len(values):
        raise ValueError("no design converged with numbers in all of these columns")
    series: dict[str, Any] = {"style": 0, "parts": [values[:, :2]]}
    weight = "thin" if len(values) > _MOST_NORMAL_POINTS else "normal"
    described: dict[str, Any] = {
        "name": "designs",
        "styles": [{"colour": "blue", "dash": "none", "mark": "circle", "weight": weight}],
        "x": _axis(answers, x),
        "y": _axis(answers, y),
        "panels": [{"series": [series]}],
    }
    if colour is not None:
        series |= {"parts": values[:, None, :2], "values": values[:, 2]}
        ends = {"from": values[:, 2].min(), "to": values[:, 2].max()}
        described["colours"] = _axis(answers, colour) | ends
    return described


def _axis(answers: Designs, name: str) -> dict[str, Any]:
    """Title in words and unit; of an input as those of studies: `Axial force`."""
    label, unit = _engine.response_title(name)
    if name in answers.inputs:
        path, unit = _path_and_unit(name)
        label = re.sub(r"[._]", " ", path.partition(".")[2] or path)
    axis = {"label": label[:1].upper() + label[1:], "unit": unit.replace("um", "µm")}
    return axis | ({"whole": True} if _counts(answers, name) else {})


def _counts(answers: Designs, name: str) -> bool:
    return name in answers.inputs and answers.inputs[name].dtype.kind in "iu"


def _numbers(answers: Designs, name: str) -> npt.NDArray[np.float64]:
    if name in answers.responses:
        return answers[name]
    if name not in answers.inputs:
        raise KeyError(answers._unknown(name))
    column = answers.inputs[name]
    if column.dtype.kind not in "fiu":
        raise ValueError(f"{name} holds words, `inputs[{name!r}]`; expected a column of numbers")
    return column.to_numpy(dtype=np.float64)


def designs_of(
    inputs: pd.DataFrame, answers: _engine.Designs, origin: Origin | None = None
) -> Designs:
    status = np.full(answers.count, "converged", dtype=object)
    reason = np.full(answers.count, "", dtype=object)
    for row, name, why in answers.failures:
        status[row], reason[row] = name, why
    return Designs(inputs, tuple(answers.responses), answers.values, status, reason, origin)


def study_designs(
    source: _engine.Source, study: _engine.Study, rows: _engine.StudyRows, command: str
) -> Designs:
    """What the designs of a study set and answer, the base case first."""
    answers = rows.designs()
    parts = parts_of(source)
    origin = Origin(parts, parts, np.arange(answers.count), command=command)
    return designs_of(study_inputs(study), answers, origin)


def study_inputs(study: _engine.Study) -> pd.DataFrame:
    """What the designs of a study set, one row per design."""
    import pandas as pd

    columns: dict[str, Any] = {}
    values = study.factor_values()
    for column, (name, words) in enumerate(
        zip(study.factor_names(), study.factor_words(), strict=True)
    ):
        numbers = values[:, column]
        if words:
            columns[name] = [words[int(k)] for k in numbers]
        else:
            columns[name] = as_counts(name, numbers)
    return pd.DataFrame(columns)


def as_counts(name: str, numbers: npt.NDArray[np.float64]) -> npt.NDArray[Any]:
    """The numbers of a column, as integers where they have no unit and are whole."""
    is_count = not _path_and_unit(name)[1] and np.all(numbers == np.round(numbers))
    return numbers.astype(np.int64) if is_count else numbers


def evaluate(
    case: Case,
    inputs: Any,
    responses: Sequence[str] | None,
    command: Command | Literal["preload"],
    threads: int | None,
    progress: Progress,
    on_error: OnError,
) -> Designs:
    """See `Case.evaluate`."""
    if isinstance(responses, str):
        raise TypeError(f"responses: got the text {responses!r}; expected a list of responses")
    if responses is not None:
        responses = list(checked("responses", responses, Iterable, "a list of responses"))
        require_once(responses)
    if on_error not in ("raise", "row"):
        raise ValueError(f"on_error: got {on_error!r}; expected 'raise' or 'row'")
    constants, columns = _columns(inputs, finite=on_error == "raise")
    count = len(next(iter(columns.values())).numbers)
    if isinstance(command, str) and command == "preload":
        answered = _preload_rows(case, constants, columns, responses, on_error)
    else:
        paths = None if responses is None else _with_entries(case, responses, command)
        source = parts_of(case._case.source)
        prepared = _Evaluation(source, constants, columns, responses or [], paths, command)
        rows = np.arange(count)
        show = progress_callback(progress)
        if on_error == "row":
            answered = prepared.each_row(rows, thread_count(threads), show)
        else:
            study = prepared.study(rows)
            warn_of(study)
            answered = prepared.answered(study, rows, thread_count(threads), show)
    origin = answered.origin
    assert origin is not None
    index = getattr(inputs, "index", None)
    if index is not None and hasattr(inputs, "columns"):
        answered = replace(answered, inputs=answered.inputs.set_axis(index))
    return replace(answered, origin=replace(origin, command=str(command)))


def warn_of(study: _engine.Study) -> None:
    """Warns of inputs that overrides of the case make void."""
    for text in study.warnings:
        warn_caller(text)


def require_once(responses: Sequence[str]) -> None:
    """Raises where a response is asked for a second time, alone or with its array."""
    found: set[str] = set()
    arrays: set[str] = set()
    for k, path in enumerate(responses):
        if not isinstance(path, str):
            continue
        array = _ENTRY.sub("", path)
        if path in arrays or found & {path, array}:
            raise InputError(
                f"responses[{k}]: got {path} a second time; expected each path once; "
                "delete one of them"
            )
        found.add(path)
        arrays.add(array)


def _place_asked(asked: Sequence[str], paths: Sequence[str], place: int) -> int:
    """The place among the responses asked for of a path, where arrays have become entries."""
    k = 0
    for path in map(str, paths[: place + 1]):
        while str(asked[k]) not in (path, _ENTRY.sub("", path)):
            k += 1
    return k


def _columns(inputs: Any, finite: bool) -> tuple[list[str], dict[str, _Column]]:
    """What all designs have, as overrides, and what they differ in; `finite`: numbers must be."""
    if hasattr(inputs, "columns") and hasattr(inputs, "to_dict"):
        inputs = _inputs_of_frame(inputs)
    if not isinstance(inputs, Mapping) or not inputs:
        raise TypeError(
            "expected a dictionary of arrays, such as {'mechanism.lead': (leads, 'mm')}, or a frame"
        )
    constants = [
        f"{checked_text('path', path)}={override_text(value)}"
        for path, value in inputs.items()
        if _is_scalar(value)
    ]
    columns = {
        path: _Column.of(checked_text("path", path), values, finite)
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
    return constants, columns


def _inputs_of_frame(frame: Any) -> dict[str, Any]:
    """The columns of a frame; units stand in their names: `mechanism.lead_mm`."""
    inputs: dict[str, Any] = {}
    for name in frame.columns:
        column = frame[name]
        path, unit = _path_and_unit(checked_text("column", name))
        if hasattr(column, "pint"):
            inputs[path] = column.pint.quantity
        elif unit:
            inputs[path] = (column.to_numpy(), unit)
        elif column.dtype.kind in "fiu":
            inputs[path] = column.to_numpy()
        else:
            inputs[path] = column.tolist()
    return inputs


def _path_and_unit(name: str) -> tuple[str, str]:
    """`mechanism.lead` and `mm` of `mechanism.lead_mm`, whatever entry of a list it is of."""
    keys = _unit_keys()
    plain_path = _plain(name)
    for place, character in enumerate(plain_path):
        unit = plain_path[place + 1 :]
        if character == "_" and unit in keys and plain_path[:place] in _known_paths():
            return name[: -len(unit) - 1], keys[unit]
    return name, ""


def _plain(path: str) -> str:
    """`load_cases[].axial_force` of `load_cases[pull].axial_force`."""
    return re.sub(r"\[[^\]]*\]", "[]", path)


@lru_cache(maxsize=1)
def _unit_keys() -> dict[str, str]:
    """The units of the input by how they stand in names: `N_per_mm`."""
    import json

    units: dict[str, str] = {}
    for quantity in json.loads(_engine.units())["quantities"]:
        for spellings in quantity["units"]:
            for unit in spellings:
                units.setdefault(_engine.unit_key(unit), unit)
    return units


@lru_cache(maxsize=1)
def _known_paths() -> frozenset[str]:
    """The paths of all inputs, `[]` for the places of lists."""
    return frozenset(map(_plain, _engine.input_paths()))


def _with_entries(case: Case, responses: list[str], command: Command) -> list[str]:
    """The responses with each entry of whole arrays: `screw.load_rate_percent`."""
    is_known = isinstance(command, str) and command in STUDIED
    if not is_known or all(not isinstance(r, str) or _is_number_path(r) for r in responses):
        return responses
    result = getattr(case, command)()
    paths = []
    for response in responses:
        value = response_in(result, response) if isinstance(response, str) else None
        if isinstance(value, np.ndarray) and value.ndim == 1:
            paths += [f"{response}[{k}]" for k in range(len(value))]
        else:
            paths.append(response)
    return paths


def _is_number_path(response: str) -> bool:
    """Whether a path cannot be that of a whole array."""
    of_load_case = re.sub(r"^load_cases\[[^\]]*\]\.", "", response)
    return of_load_case.endswith((".max", ".min", ".mean", "]")) or of_load_case in numbers_known()


#: A factor of a study in the key of an error: its number, what it draws from, an end, a level.
_FACTOR = re.compile(r"study\.factors\[(\d+)\]\.?([a-z_]*)\.?(\w*)(?:\[(\d+)\])?")

#: Errors of one value of an input.
_INDEXED = re.compile(r"inputs\['.*?'\]\[\d+\]: ")


def told_of_arguments(
    error: InputProblem,
    inputs: Sequence[str],
    asked: Sequence[str],
    paths: Sequence[str],
    command: str,
    case: Callable[[], Case],
    index_of: Callable[[str, str, str | None], int | None],
) -> str:
    """An error of a study as one of the arguments that it was made of.

    `asked` are the responses as they were given, `paths` those of the study; `case` gives the case,
    where the reason is looked for; `index_of` gives the place of the value of an input that an end
    or a level of its factor is.
    """
    message = _message_of(error).replace(
        "`prs list responses FILE`", f'`case.responses("{command}")`'
    )
    if found := re.fullmatch(r"study\.responses\[(\d+)\]", error.path):
        response = str(paths[int(found[1])])
        at = f"responses[{_place_asked(asked, paths, int(found[1]))}]"
        if "expected a number of " not in message:  # It says already what is wrong.
            return f"{at}: {message}"
        if reason := Reasons(case(), command).of(response):
            return f"{at}: got {response}; {reason}"
        near = [known for known in sorted(numbers_known()) if response in known]
        own = [known for known in near if command in commands_of(known)]
        if near and "did you mean" not in message:
            message = message.partition("; write for example")[0]
            message += f"; did you mean {', '.join(f'`{each}`' for each in (own or near)[:3])}"
            message += "?" if own else f' of command="{commands_of(near[0])[0]}"?'
        return f"{at}: {message}"
    if found := _FACTOR.match(error.path):
        path = inputs[int(found[1])]
        index = None if found[2] == "path" else index_of(path, found[3], found[4])
        at = "" if index is None else f"[{index}]"
        return f"inputs[{path!r}]{at}: {message}"
    if error.path in ("study.command", "study.responses"):
        return f"{error.path.removeprefix('study.')}: {message}"
    return error.text.partition(" (from --set study=")[0]


def _first_of_each(errors: list[str]) -> Iterator[str]:
    """The first error of each input, with how many others it has."""
    count = Counter(_of_input(text) for text in errors)
    for text in errors:
        if more := count.pop(_of_input(text), 0):
            yield text + (f" (and {more - 1} other values)" if more > 1 else "")


def _of_input(text: str) -> str:
    found = _INDEXED.match(text)
    return text if found is None else found[0].rpartition("[")[0]


def _message_of(error: InputProblem) -> str:
    """The error without its place and key."""
    message = error.text.partition(": error: ")[2].partition(" (from --set ")[0]
    return message.removeprefix(f"{error.path}: ")


@dataclass(frozen=True)
class _Evaluation:
    """Designs of a case, as a study that is never run: its factors are the columns."""

    case: SourceParts
    constants: list[str]
    columns: dict[str, _Column]
    asked: Sequence[str]  #: Responses as they were given.
    responses: list[str] | None  #: With the entries of arrays.
    command: Command

    def parts(self, rows: npt.NDArray[np.int64]) -> SourceParts:
        plan: dict[str, Any] = {
            "command": self.command,
            "plan": "monte_carlo",
            "samples": 1,
            "factors": [column.factor_of(rows) for column in self.columns.values()],
        }
        if self.responses is not None:
            plan["responses"] = self.responses
        name, text, overrides, folder, files = self.case
        more = (*overrides, *self.constants, f"study={override_text(plan)}")
        return name, text, more, folder, files

    def study(self, rows: npt.NDArray[np.int64]) -> _engine.Study:
        """Raises InputError, which names the argument and the index that it finds wrong."""
        try:
            return _engine.Study(source_of(self.parts(rows)))
        except InputError as error:
            for each in error.errors:
                self._require_whole(each, rows)
            told = [self._told(each, rows) for each in error.errors]
            raise InputError("\n".join(_first_of_each(told))) from None

    def _require_whole(self, error: InputProblem, rows: npt.NDArray[np.int64]) -> None:
        """Of a count that is not whole a study says that no number between two may be drawn."""
        found = _FACTOR.match(error.path)
        if found is None or rows.size == 1 or "any value between two" not in error.text:
            return
        numbers = list(self.columns.values())[int(found[1])].numbers[rows]
        self.study(rows[np.flatnonzero(numbers != np.round(numbers))[:1]])

    def _told(self, error: InputProblem, rows: npt.NDArray[np.int64]) -> str:
        """The error with the argument in place of the study's key."""

        def index_of(path: str, end: str, level: str | None) -> int | None:
            return self.columns[path].index_of(end, level, rows)

        if error.path in self.columns:
            column, message = self.columns[error.path], _message_of(error)
            is_of_value = message.startswith("got ") and not message.startswith("got the name ")
            place = column.place_of(error.got, rows) if is_of_value else None
            at = "" if place is None else f"[{place}]"
            return f"inputs[{error.path!r}]{at}: {column.hinted(message)}"
        inputs, paths = list(self.columns), self.responses or []
        return told_of_arguments(
            error, inputs, self.asked, paths, self.command, self._base, index_of
        )

    def _base(self) -> Case:
        from rollerscrew.case import Case

        return Case._from_source(source_of(self.case, self.constants))

    def answered(
        self, study: _engine.Study, rows: npt.NDArray[np.int64], threads: int, show: Any
    ) -> Designs:
        import pandas as pd

        numbers = np.column_stack([column.numbers_of(rows) for column in self.columns.values()])
        answers = study.evaluate(numbers, threads, show)
        frame = pd.DataFrame(
            {
                name if isinstance(column.shown, np.ndarray) else path: column.shown_of(rows)
                for name, (path, column) in zip(
                    study.factor_names(), self.columns.items(), strict=True
                )
            }
        )
        name, text, overrides, folder, files = self.case
        case = (name, text, (*overrides, *self.constants), folder, files)
        return designs_of(frame, answers, Origin(case, self.parts(rows), numbers))

    def each_row(self, rows: npt.NDArray[np.int64], threads: int, show: Any) -> Designs:
        """As `answered`; a design whose inputs cannot stand in the case is a row with why."""
        refused: dict[int, str] = {}
        for path, column in self.columns.items():
            for row in np.flatnonzero(~np.isfinite(column.numbers)).tolist():
                got = column.shown[row]
                refused[row] = f"inputs[{path!r}][{row}]: got {got}; expected finite numbers"
        pieces: list[tuple[npt.NDArray[np.int64], Designs]] = []
        finite = np.delete(rows, list(refused))
        for piece in self._pieces(finite, threads, refused) if finite.size else ():
            if not pieces:
                warn_of(self.study(piece[0]))
            pieces.append(piece)
            if show:
                show(sum(len(designs) for _, designs in pieces) + len(refused), len(rows))
        if not pieces and self.responses is None:
            raise InputError(next(iter(refused.values())))
        name, text, overrides, folder, files = self.case
        case = (name, text, (*overrides, *self.constants), folder, files)
        responses = pieces[0][1].responses if pieces else tuple(self.responses or ())
        return _joined(pieces, refused, self.columns, len(rows), responses, case)

    def _pieces(
        self, rows: npt.NDArray[np.int64], threads: int, refused: dict[int, str]
    ) -> Iterator[tuple[npt.NDArray[np.int64], Designs]]:
        try:
            study = self.study(rows)
        except InputError as error:
            if any(not each.text.startswith("inputs[") for each in error.errors):
                raise
            if len(rows) == 1:
                if _INDEXED.match(str(error)) is None:  # The input itself is none.
                    raise
                refused[int(rows[0])] = str(error)
                return
            # Those that are refused lie at the ends of what is refused.
            rows = rows[np.argsort(self.columns[error.errors[0].path].numbers[rows], kind="stable")]
            for half in np.array_split(rows, 2):
                yield from self._pieces(half, threads, refused)
            return
        yield rows, self.answered(study, rows, threads, None)


def _joined(
    pieces: list[tuple[npt.NDArray[np.int64], Designs]],
    refused: dict[int, str],
    columns: dict[str, _Column],
    count: int,
    responses: tuple[str, ...],
    case: SourceParts,
) -> Designs:
    """The designs in their order, with those that were refused."""
    values = np.full((count, len(responses)), np.nan)
    status = np.full(count, "refused", dtype=object)
    reason = np.full(count, "", dtype=object)
    for rows, designs in pieces:
        values[rows], status[rows], reason[rows] = designs.values, designs.status, designs.reason
    for row, why in refused.items():
        reason[row] = why
    origin = Origin(case, None, np.arange(count), columns)
    return Designs(_inputs_frame(columns), responses, values, status, reason, origin)


def _inputs_frame(columns: Mapping[str, _Column]) -> pd.DataFrame:
    """The columns as they were given, with their units in their names."""
    import pandas as pd

    return pd.DataFrame(
        {
            f"{path}_{_engine.unit_key(column.unit)}" if column.unit else path: column.shown
            for path, column in columns.items()
        }
    )


def _preload_rows(
    case: Case,
    constants: list[str],
    columns: dict[str, _Column],
    responses: Sequence[str] | None,
    on_error: OnError,
) -> Designs:
    """Designs by `preload`, which studies do not run: one after the other."""
    if not responses:
        raise ValueError("responses: got none; expected paths such as 'preload.lost_motion_um'")
    count = len(next(iter(columns.values())).numbers)
    values = np.full((count, len(responses)), np.nan)
    status = np.full(count, "converged", dtype=object)
    reason = np.full(count, "", dtype=object)
    for row in range(count):
        wrong = [path for path, column in columns.items() if not np.isfinite(column.numbers[row])]
        if wrong:
            got = columns[wrong[0]].shown[row]
            status[row] = "refused"
            reason[row] = f"inputs[{wrong[0]!r}][{row}]: got {got}; expected finite numbers"
            continue
        overrides = [f"{path}={column.text_of(row)}" for path, column in columns.items()]
        try:
            one = type(case)._from_source(
                source_of(parts_of(case._case.source), [*constants, *overrides])
            )
            result = one.preload()
        except InputError as error:
            if on_error == "raise":
                raise InputError(f"inputs, index {row}: {error}") from None
            status[row], reason[row] = "refused", str(error)
            continue
        if not result.converged:
            status[row], reason[row] = "not_converged", "a load has no equilibrium"
        for k, path in enumerate(responses):
            value = response_in(result, path)
            if isinstance(value, int | float):
                values[row, k] = value
            elif result.converged:
                why = Reasons(case, "preload").of(path) or (
                    "expected a number of the document of `preload`, as "
                    '`case.responses("preload")` shows them'
                )
                raise InputError(f"responses[{k}]: got {path}; {why}")
    name, text, before, folder, files = parts_of(case._case.source)
    origin = Origin(
        (name, text, (*before, *constants), folder, files), None, np.arange(count), columns
    )
    return Designs(_inputs_frame(columns), tuple(responses), values, status, reason, origin)


def batches(inputs: Any, size: int) -> Iterator[Mapping[str, Any]]:
    """The inputs in pieces of at most `size` designs."""
    if size < 1:
        raise ValueError(f"batch: got {size}; expected a whole number > 0")
    if hasattr(inputs, "columns") and hasattr(inputs, "to_dict"):
        inputs = _inputs_of_frame(inputs)
    if not isinstance(inputs, Mapping):
        yield from inputs
        return
    arrays = {path: values for path, values in inputs.items() if not _is_scalar(values)}
    count = max((_length(values) for values in arrays.values()), default=0)
    if count <= size:
        yield inputs
        return
    for first in range(0, count, size):
        piece = slice(first, first + size)
        yield {
            path: (values[0][piece], values[1])
            if path in arrays and _is_with_unit(values)
            else values[piece]
            if path in arrays
            else values
            for path, values in inputs.items()
        }


def _columns_and_index(frame: Any) -> Iterator[tuple[Any, Any]]:
    """The columns of a frame, behind its index where that has a name or holds times."""
    index = getattr(frame, "index", None)
    if len(frame) == 0:
        raise ValueError("history: got a frame without rows; expected at least 2 rows")
    if index is None:
        pass
    elif index.dtype.kind in "mM":
        yield "time_s", (index - index[0]).total_seconds().to_numpy()
    elif index.name is not None:
        yield index.name, index.to_numpy()
    elif index.dtype.kind not in "iu":
        raise ValueError(
            f"history: got an index of {index.dtype} without a name; expected one that is named "
            "like 'time_s', that holds times, or that counts rows"
        )
    for name in frame.columns:
        yield name, frame[name].to_numpy()


def history_columns(history: Any) -> dict[str, tuple[list[float], str]]:
    """Numbers and unit of each column of a history that is given as arrays."""
    if hasattr(history, "columns") and hasattr(history, "to_dict"):
        columns: dict[str, Any] = {}
        for name, values in _columns_and_index(history):
            key, _, unit = checked_text("column", name).partition("_")
            if unit not in _unit_keys():
                raise ValueError(f"history: got the column {name!r}; expected one as 'force_kN'")
            if key in columns:
                raise ValueError(f"history: got {key!r} as index and as column; expected it once")
            columns[key] = (values, _unit_keys()[unit])
        history = columns
    if not isinstance(history, Mapping):
        raise TypeError(
            f"history: got {type(history).__name__}; expected a dictionary of arrays with their "
            'units, such as {"force": (forces, "kN"), "time": (times, "s")}, or a frame'
        )
    found = {}
    for name, values in history.items():
        what = f"history[{name!r}]"
        if is_quantity(values):
            unit, values = unit_and_magnitude(values)
        elif _is_with_unit(values):
            values, unit = values
        else:
            raise TypeError(f'{what}: got no unit; expected ({name}, unit), such as (forces, "kN")')
        numbers = np.asarray(values, dtype=np.float64)
        if numbers.ndim != 1 or len(numbers) < 2:
            raise ValueError(
                f"{what}: got the shape {numbers.shape}; expected an array of at least 2 numbers"
            )
        wrong = np.flatnonzero(~np.isfinite(numbers))
        if wrong.size > 0:
            raise ValueError(
                f"{what}[{wrong[0]}]: got {numbers[wrong[0]]}; expected finite numbers"
            )
        found[name] = (numbers.tolist(), unit)
    if len({len(numbers) for numbers, _ in found.values()}) > 1:
        counts = ", ".join(f"{len(numbers)} of {name}" for name, (numbers, _) in found.items())
        raise ValueError(f"history: expected arrays of one length; got {counts}")
    return found


def _length(values: Any) -> int:
    return len(values[0] if _is_with_unit(values) else values)


@dataclass(frozen=True)
class _Column:
    """One input of many designs: numbers in a unit, or the places of values among levels."""

    path: str
    numbers: npt.NDArray[np.float64]
    levels: list[Any] | None  #: What may stand in the case, where numbers are places.
    unit: str
    shown: Any  #: The values, for people.

    def factor_of(self, rows: npt.NDArray[np.int64]) -> dict[str, Any]:
        """The column as a factor of a study of some of the rows."""
        numbers = self.numbers[rows]
        if self.levels is not None:
            used = np.unique(numbers).astype(int)
            return {"path": self.path, "values": [self.levels[k] for k in used]}
        low, high = float(numbers.min()), float(numbers.max())
        if low == high:
            return {"path": self.path, "values": [_with_unit(low, self.unit)]}
        ends = {"from": _with_unit(low, self.unit), "to": _with_unit(high, self.unit)}
        return {"path": self.path, "uniform": ends}

    def numbers_of(self, rows: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
        """The numbers of some rows, as that factor takes them."""
        numbers = self.numbers[rows]
        if self.levels is not None:
            return np.searchsorted(np.unique(numbers), numbers).astype(np.float64)
        return np.zeros_like(numbers) if numbers.min() == numbers.max() else numbers

    def shown_of(self, rows: npt.NDArray[np.int64]) -> Any:
        if isinstance(self.shown, np.ndarray):
            return self.shown[rows]
        return [self.shown[row] for row in rows]

    def text_of(self, row: int) -> str:
        """One value as `--set` takes it."""
        if self.levels is not None:
            return override_text(self.levels[int(self.numbers[row])])
        number = override_text(float(self.numbers[row]))
        return f"{number} {self.unit}" if self.unit else number

    def place_of(self, text: str, rows: npt.NDArray[np.int64]) -> int | None:
        """The row with a value that an error shows, among the ends or the levels."""
        numbers = self.numbers[rows]
        if self.levels is None:
            places = [int(numbers.argmin()), int(numbers.argmax())]
        else:
            places = np.unique(numbers, return_index=True)[1].tolist()
        shown = [int(rows[k]) for k in places if _shown(self.text_of(int(rows[k]))) == _shown(text)]
        return shown[0] if shown else int(rows[0]) if len(rows) == 1 else None

    def hinted(self, message: str) -> str:
        """An error with what arrays have in place of `5 N`."""
        if not isinstance(self.shown, np.ndarray) or self.unit:
            return message
        in_array = r'give the unit with the numbers, `(numbers, "\1")`'
        return re.sub(r"write the unit, for example `\S+ ([^`]+)`", in_array, message)

    def index_of(self, end: str, level: str | None, rows: npt.NDArray[np.int64]) -> int | None:
        """The row that gave one of the ends, or a level, of that factor."""
        numbers = self.numbers[rows]
        if level is not None:
            used = np.unique(numbers)
            return int(rows[np.flatnonzero(numbers == used[min(int(level), used.size - 1)])[0]])
        if end in ("from", "to"):
            return int(rows[numbers.argmin() if end == "from" else numbers.argmax()])
        return int(rows[0]) if len(rows) == 1 else None

    @classmethod
    def of(cls, path: str, values: Any, finite: bool) -> _Column:
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
                column = cls._of_numbers(path, array.astype(np.float64), unit, finite)
            return column if array.dtype.kind == "f" else replace(column, shown=array)
        return cls._of_values(path, list(array), unit)

    @classmethod
    def _of_numbers(
        cls, path: str, numbers: npt.NDArray[np.float64], unit: str, finite: bool
    ) -> _Column:
        is_finite = np.isfinite(numbers)
        if finite and not is_finite.all():
            wrong = int(np.argmin(is_finite))
            raise ValueError(f"{path}[{wrong}]: got {numbers[wrong]}; expected finite numbers")
        known = numbers[is_finite]
        if not unit and known.size and np.all(known == np.round(known)):
            counts, places = np.unique(known, return_inverse=True)
            if counts.size <= _MOST_COUNTS and np.abs(known).max() < 2**53:
                indices = np.full(numbers.shape, np.nan)
                indices[is_finite] = places
                levels = [int(count) for count in counts]
                return cls(path, indices, levels, "", numbers)
        return cls(path, numbers, None, unit, numbers)

    @classmethod
    def _of_values(cls, path: str, values: list[Any], unit: str) -> _Column:
        if unit:
            raise TypeError(f"{path}: expected numbers next to the unit {unit!r}")
        values = [plain(value) for value in values]
        texts = [override_text(value) for value in values]
        place = {text: k for k, text in enumerate(dict.fromkeys(texts))}
        levels = list(dict(zip(texts, values, strict=True)).values())
        places = np.array([place[text] for text in texts], dtype=np.float64)
        return cls(path, places, levels, "", texts)


def _shown(text: str) -> str:
    """A value without regard to how its number is written: `5.0 mm` as `5 mm`."""
    number, _, unit = text.partition(" ")
    try:
        return f"{float(number)!r} {unit}"
    except ValueError:
        return text


def _is_scalar(value: Any) -> bool:
    """Which all designs have."""
    if is_quantity(value):
        return np.ndim(value.magnitude) == 0
    if is_with_unit(value):
        return np.ndim(value[0]) == 0
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


@lru_cache(maxsize=4)
def _prepared(parts: SourceParts, process: int) -> _engine.Study:
    return _engine.Study(source_of(parts))


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
    from concurrent.futures import as_completed

    study = _engine.Study(source)
    if not study.has_designs:
        return study, None
    show = progress_callback(progress)
    if executor is None:
        return study, study.run(thread_count(threads), show)
    if not hasattr(executor, "submit"):
        raise TypeError(f"got {executor!r}; expected an executor of concurrent.futures")
    parts = parts_of(source)
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
    from concurrent.futures import BrokenExecutor, CancelledError

    try:
        return future.result()
    except (BrokenExecutor, CancelledError):
        raise
    except Exception as error:
        reason = f"{type(error).__name__}: {error}".encode(errors="replace").decode()
        return study.failed_record(first, count, reason)
