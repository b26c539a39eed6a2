"""Data frames and pictures of results, which take them by name: `SlipResult` those of `SlipViews`.

A docstring of views is that of the result and of the method of `Case` too; without one these have
the help of the program. Keys are annotated where methods here use them; `_block` is the key that
tells a document, where that is neither the command's name nor the last that must be there.

Every `plot_` method draws into `ax`, or all panels into a new figure, and returns the (first) axes.
`figures()` describes the pictures for other tools.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Self, Unpack

import numpy as np

from rollerscrew import _engine
from rollerscrew.designs import Designs, as_counts, study_designs
from rollerscrew.frames import Kinds, array_kinds, flat, frame_of, kinds_of
from rollerscrew.record import Look, Record, Result, Values
from rollerscrew.records import (
    ComparedModel,
    ComparedReference,
    Comparison,
    Contacts,
    Fit,
    FittedParameter,
    Heat,
    HeatCycle,
    InterfaceLife,
    InterfaceLoads,
    InterfaceSlip,
    Life,
    LoadCase,
    Measures,
    Mode,
    Model,
    Preload,
    PreloadPoint,
    ReferenceModel,
    Response,
    RollerLives,
    SizeCriterion,
    SizedCandidate,
    Slip,
    Threads,
)
from rollerscrew.values import place_among

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

    from rollerscrew.case import Case

INTERFACES = ("screw", "nut")

#: Records of a load case that have frames of their own.
_OF_OTHER_FRAMES = ("screw_", "nut_", "slip_", "heat_", "measures_", "travel_", "modes_")

#: What a travel has at each position, and vectors with the axes that they have.
_TRAVEL = ("angle_deg", "deviation_um", "tangent_stiffness_N_per_um")
_TRAVEL_VECTORS = {
    "screw_end_displacement_um": ("screw_end", "displacement_um", "xyz"),
    "screw_end_rotation_mrad": ("screw_end", "rotation_mrad", "yz"),
    "nut_force_N": ("nut_reaction", "force_N", "xyz"),
    "nut_moment_Nm": ("nut_reaction", "moment_Nm", "yz"),
}

#: What tells load cases apart: `loads` says `static`, of a screw at rest, or `running`.
_OF_CASE: Kinds = {"case": str, "axial_force_N": float, "loads": str}

#: Load cases by their places or names: one, or several.
Which = int | str | Iterable[int | str]


def _numbers(record: Record) -> dict[str, Any]:
    """The values of a record; of an array `normal[0]`, `normal[1]`, .."""
    numbers: dict[str, Any] = {}
    for name, value in record.items():
        if isinstance(value, np.ndarray):
            numbers.update({f"{name}[{k}]": number for k, number in enumerate(value)})
        else:
            numbers[name] = value
    return numbers


def _arrays(record: Record) -> dict[str, Any]:
    """The arrays over threads of a record, and the numbers of the threads, also of the rollers."""
    arrays = {name: value for name, value in record.items() if isinstance(value, np.ndarray)}
    grid = next((value for value in arrays.values() if value.ndim == 2), None)
    if grid is not None:
        rollers, threads = grid.shape
        return {
            "roller": np.repeat(np.arange(1, rollers + 1), threads),
            "thread": np.tile(np.arange(1, threads + 1), rollers),
            **{name: value.ravel() for name, value in arrays.items() if value.ndim == 2},
        }
    count = len(next(iter(arrays.values()), ()))
    return {"thread": np.arange(1, count + 1), **arrays}


def _threads_frame(
    parts: Iterable[tuple[Mapping[str, Any], Record]], told: Kinds, kind: type[Record]
) -> pd.DataFrame:
    """The threads of records, one below the other, behind columns that tell the records apart."""
    columns: dict[str, list[Any]] = {}
    rows = 0
    for names, record in parts:
        arrays = _arrays(record)
        count = len(arrays["thread"])
        for name, value in [*names.items(), *arrays.items()]:
            column = columns.setdefault(name, [np.full(rows, np.nan)] if rows else [])
            column.append(np.full(count, value) if name in told else value)
        rows += count
        for name, column in columns.items():
            if name not in names and name not in arrays:
                column.append(np.full(count, np.nan))
    if not columns:
        return frame_of([], {**told, **array_kinds(kind)})
    import pandas as pd

    return pd.DataFrame({name: np.concatenate(column) for name, column in columns.items()})


class InputValue(Record):
    """One value of the resolved case."""

    __slots__ = ()
    path: str
    value: str
    default: bool
    basis: str | None
    reason: str | None
    origin: str | None
    written: str | None


class CheckViews(Result):
    """What the case is ready for, what is unusual about it, every value with its default."""

    __slots__ = ()
    _block = "input"
    input: list[InputValue]

    def to_frame(self) -> pd.DataFrame:
        """Path, value, whether it is a default, and what the value rests on, one row per input."""
        return frame_of([value.to_dict() for value in self.input], kinds_of(InputValue))

    def plot_contact_points(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The contacts seen along the axis."""
        return self.plot_figure("contact_xy", ax, **look)


class LoadCasesResult(Result):
    """A result with load cases."""

    __slots__ = ()
    contact: Contacts | None
    threads: Threads | None
    model: Model | None
    load_cases: list[LoadCase]

    @property
    def _load_cases(self) -> list[LoadCase]:
        """None where the case has no loads."""
        cases: list[LoadCase] = self.get("load_cases", [])
        return cases

    def load_case(self, which: int | str = 0) -> LoadCase:
        """A load case by its place or its name."""
        return self._load_cases[self._place(which)]

    def _place(self, which: int | str) -> int:
        names = [load_case.name for load_case in self._load_cases]
        if not isinstance(which, str):
            return place_among(len(names), "load_case", which)
        if which not in names:
            raise KeyError(f"no load case {which!r}; there is {', '.join(names) or 'none'}")
        return names.index(which)

    def _one(self, which: int | str | None) -> int | None:
        """None: the picture is that of the largest force."""
        return None if which is None else self._place(which)

    def _places(self, which: Which | None) -> list[int] | None:
        if which is None:
            return None
        chosen = which if isinstance(which, Iterable) and not isinstance(which, str) else [which]
        return [self._place(each) for each in chosen]

    def load_cases_frame(self) -> pd.DataFrame:
        """Force, `loads` (static or running), displacement and stiffness, one row per load case."""
        kinds = {
            "case" if name == "name" else name: kind
            for name, kind in kinds_of(LoadCase).items()
            if not name.startswith(_OF_OTHER_FRAMES)
        }
        rows = [
            {
                "case" if name == "name" else name: value
                for name, value in flat(case)
                if not name.startswith(_OF_OTHER_FRAMES)
            }
            for case in self._load_cases
        ]
        return frame_of(rows, kinds)

    def _frame_of(self, key: str, kind: type[Record]) -> pd.DataFrame:
        """Values of a record, one row per load case; of one that failed its status."""
        rows = []
        for case in self._load_cases:
            row = {"case": case.name, "axial_force_N": case.axial_force_N, "loads": case.loads}
            failed = {} if case.converged else {"converged": False, "status": case.status}
            rows.append(row | (dict(flat(case[key])) if key in case else failed))
        return frame_of(rows, {**_OF_CASE, **kinds_of(kind)})

    def threads_frame(self) -> pd.DataFrame:
        """Loads, ellipses and pressures, one row per load case, interface and thread.

        The column `loads` says `static`, at rest, or `running`, with the friction of a screw that
        turns. None of a load case that did not converge, see `load_cases_frame`.
        """
        return self._by_case(((case, case) for case in self._load_cases), InterfaceLoads)

    def plot_load_distribution(
        self,
        load_cases: Which | None = None,
        ax: Axes | None = None,
        reference: Any = None,
        **look: Unpack[Look],
    ) -> Axes:
        """Share of each thread in the load.

        With a `reference`, as `Case.compare` takes it: its points, and a line for each model of the
        bodies.
        """
        if reference is not None:
            if load_cases is not None:
                raise ValueError("load_cases: got it with a reference, whose load cases are drawn")
            if self._case is None:
                raise ValueError("reference: got it of a result without its case; compute it anew")
            compared: Result = self._case.compare(reference)
            return compared.plot_figure("references", ax, **look)
        return self.plot_figure(
            "load_distribution", ax, **look, load_cases=self._places(load_cases)
        )

    def plot_pressures(
        self, load_cases: Which | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Peak pressure of each thread."""
        return self.plot_figure("peak_pressure", ax, **look, load_cases=self._places(load_cases))

    def plot_ellipses(
        self, load_case: int | str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Contact ellipses of the threads, to scale."""
        return self.plot_figure("ellipses", ax, **look, load_case=self._one(load_case))

    def plot_contact_points(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The contacts seen along the axis."""
        return self.plot_figure("contact_xy", ax, **look)

    def _by_case(
        self, threads: Iterable[tuple[LoadCase, Record]], kind: type[Record]
    ) -> pd.DataFrame:
        """The threads of records of load cases, with what tells these apart."""
        told: Kinds = {
            "case": str, "axial_force_N": float, "direction": str, "position_mm": float,
            "loads": str, "interface": str,
        }  # fmt: skip
        parts = (
            (
                {
                    "case": case.name,
                    "axial_force_N": case.get("axial_force_N", np.nan),
                    "direction": case.get("direction", ""),
                    "position_mm": case.get("position_mm", np.nan),
                    "loads": case.get("loads", ""),
                    "interface": interface,
                },
                record[interface],
            )
            for case, record in threads
            for interface in INTERFACES
            if interface in record
        )
        return _threads_frame(parts, told, kind)


class ContactViews(LoadCasesResult):
    """Contact points, backlash, curvatures; ellipses where materials and equal shares are given."""

    __slots__ = ()

    def to_frame(self) -> pd.DataFrame:
        """Contact quantities, one column per interface; a vector has one row per number."""
        import pandas as pd

        return pd.DataFrame({name: _numbers(self["contact"][name]) for name in INTERFACES})


class SolveViews(LoadCasesResult):
    """Load distribution, pressures, displacement and stiffness of every load case.

    A load case that does not converge is a result with its status.
    """

    __slots__ = ()

    def plot_stiffness(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Axial stiffness against the load, one line per sweep."""
        return self.plot_figure("stiffness", ax, **look)

    def plot_displacement(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Axial displacement against the load, one line per sweep."""
        return self.plot_figure("displacement", ax, **look)

    def plot_butterfly(
        self, interface: str = "screw", ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Share of each thread against the load: they spread like wings as the load grows."""
        if interface not in INTERFACES:
            raise ValueError(f"interface: got {interface!r}; expected 'screw' or 'nut'")
        return self.plot_figure("butterfly", ax, **look, interface=interface)

    def plot_convergence(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Residual after each linear solve."""
        return self.plot_figure("convergence", ax, **look)

    def travel_frame(self) -> pd.DataFrame:
        """Deviation, stiffness, forces and rotations, one row per load case and position."""
        rows: list[dict[str, Any]] = []
        for case in self._load_cases:
            travel = case.travel
            if travel is None or travel.angle_deg is None:
                continue
            columns: dict[str, Any] = {name: travel[name] for name in _TRAVEL}
            for prefix, (record, name, axes) in _TRAVEL_VECTORS.items():
                for k, axis in enumerate(axes):
                    columns[f"{prefix}_{axis}"] = travel[record][name][:, k]
            rows += [
                {"case": case.name, **{name: values[k] for name, values in columns.items()}}
                for k in range(len(travel.angle_deg))
            ]
        vectors = [
            f"{name}_{axis}" for name, (*_, axes) in _TRAVEL_VECTORS.items() for axis in axes
        ]
        numbers: Kinds = dict.fromkeys((*_TRAVEL, *vectors), float)
        return frame_of(rows, {"case": str, **numbers})

    def modes_frame(self) -> pd.DataFrame:
        """Natural frequencies, effective masses and shares of energy, one row per mode."""
        told: Kinds = {"case": str, "mode": int, **kinds_of(Mode)}
        rows = [
            {"case": case.name, "mode": number} | dict(flat(mode))
            for case in self._load_cases
            if case.modes is not None
            for number, mode in enumerate(case.modes.mode, 1)
        ]
        return frame_of(rows, told)

    def plot_travel_deviation(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Travel deviation over the turn, with its bands."""
        return self.plot_figure("travel_deviation", ax, **look)

    def plot_campbell(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Natural frequencies and the orders that meet them over the speed."""
        return self.plot_figure("campbell", ax, **look)


class SlipViews(SolveViews):
    __slots__ = ()
    heat_cycle: HeatCycle | None  #: Where the case has a duty.

    def slip_frame(self) -> pd.DataFrame:
        """Slip ratio, efficiency, powers and torques, one row per load case."""
        return self._frame_of("slip", Slip)

    def slip_threads_frame(self) -> pd.DataFrame:
        """Power, friction, sliding and film, one row per load case, interface and thread."""
        threads = ((case, case.slip) for case in self._load_cases if case.slip is not None)
        return self._by_case(threads, InterfaceSlip)

    def heat_frame(self) -> pd.DataFrame:
        """Steady temperatures and the heat that goes into each part, one row per load case.

        Without a block `heat` there are no rows.
        """
        if not any("heat" in case for case in self._load_cases):
            return frame_of([], {**_OF_CASE, **kinds_of(Heat)})
        return self._frame_of("heat", Heat)

    def heat_cycle_frame(self) -> pd.DataFrame:
        """Temperatures of the parts over the cycle of the duty, one row per time; empty without."""
        import pandas as pd

        cycle = self.heat_cycle
        if cycle is None or cycle.temperature_degC is None:
            parts = ("screw", "rollers", "nut", "ambient")
            return frame_of([], dict.fromkeys(["time_s", *(f"{p}_degC" for p in parts)], float))
        return pd.DataFrame(
            {
                "time_s": cycle.time_s,
                **{f"{part}_degC": values for part, values in cycle.temperature_degC.items()},
            }
        )

    def plot_heat_cycle(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Temperatures of the parts over the cycle of the duty."""
        return self.plot_figure("heat_cycle", ax, **look)

    def plot_power(
        self, load_case: int | str = 0, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Power that each thread of a roller dissipates."""
        return self.plot_figure("thread_power", ax, **look, load_case=self._place(load_case))

    def plot_power_by_source(
        self, load_cases: Which | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Where the power goes, one bar per load case."""
        return self.plot_figure("power_by_source", ax, **look, load_cases=self._places(load_cases))

    def plot_friction(
        self, load_case: int | str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Friction coefficient of each thread, and sliding speed at the centre of its contact."""
        return self.plot_figure("friction", ax, **look, load_case=self._one(load_case))

    def plot_stribeck(
        self, load_case: int | str = 0, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Friction, efficiency, power and film over the speed."""
        return self.plot_figure("stribeck", ax, **look, load_case=self._place(load_case))


class MeasuresViews(SolveViews):
    __slots__ = ()
    measures: Measures

    def measures_frame(self) -> pd.DataFrame:
        """Measures of the mechanism, and of each load case under its name, one row per measure.

        `value` is its number, `text` its word, `unit` that of the number. A load case that failed
        has its status.
        """
        rows = [self._measure("", name, value) for name, value in flat(self.measures)]
        for case in self._load_cases:
            if "measures" in case:
                rows += [self._measure(case.name, n, value) for n, value in flat(case["measures"])]
            else:
                rows.append(self._measure(case.name, "status", case.status))
        told = {"load_case": str, "measure": str, "value": float, "text": str, "unit": str}
        return frame_of(rows, told)

    @staticmethod
    def _measure(load_case: str, name: str, value: Any) -> dict[str, Any]:
        is_text = isinstance(value, str)
        return {
            "load_case": load_case,
            "measure": name,
            "value": None if is_text else value,
            "text": value if is_text else None,
            "unit": _engine.response_title(name)[1],
        }

    def plot_stiffness_terms(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The springs in series that make up the stiffness, by their part in the compliance."""
        return self.plot_figure("stiffness_terms", ax, **look)


class SizeViews(Result):
    """Which screw, and which motor: candidates against a requirement, the best first."""

    __slots__ = ()
    _block = "candidates"

    def to_frame(self) -> pd.DataFrame:
        """Values of every candidate, one row each, by rank; units in the names."""
        rows = [dict(flat(row)) for row in self["candidates"]]
        return frame_of(rows, kinds_of(SizedCandidate))

    def criteria_frame(self) -> pd.DataFrame:
        """Value, limit, margin and status of every criterion of every candidate."""
        rows = [
            {"rank": row.rank, "candidate": row.name, **criterion.to_dict()}
            for row in self["candidates"]
            for criterion in row.criteria
        ]
        return frame_of(rows, {"rank": int, "candidate": str, **kinds_of(SizeCriterion)})

    def plot_map(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Candidates over diameter and lead, in the colour of what limits them."""
        return self.plot_figure("size_map", ax, **look)

    def plot_curve(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Force over speed of the first candidate, with what limits it."""
        return self.plot_figure("size_curve", ax, **look)

    def plot_margins(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Margins of the first five candidates."""
        return self.plot_figure("size_margins", ax, **look)


class CompareViews(Result):
    """The models of the bodies side by side: stiffness, shares and pressures of each.

    `influence` is among them where the case asks for it, or where its matrices are kept.
    """

    __slots__ = ()
    comparison: Comparison
    references: list[ComparedReference] | None

    def references_frame(self) -> pd.DataFrame:
        """Deviations of each model from each reference, one row each."""
        own = ("name", "load_case", "response", "unit")
        rows = [
            {key: reference[key] for key in own} | dict(flat(model))
            for reference in self.get("references", [])
            for model in reference["models"]
        ]
        for row in rows:  # A word, since some models are held against no tolerance.
            row["met"] = ("met" if row["met"] else "not met") if "met" in row else ""
        return frame_of(rows, {**dict.fromkeys(own, str), **kinds_of(ReferenceModel), "met": str})

    def plot_references(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """References as points and models as lines, one panel per load case and response."""
        return self.plot_figure("references", ax, **look)

    def to_frame(self) -> pd.DataFrame:
        """Stiffness, displacement, largest shares, pressures: one row per load case and model."""
        rows = [
            {"load_case": load_case.name, **dict(flat(model))}
            for load_case in self.comparison.load_cases
            for model in load_case.models
        ]
        return frame_of(rows, {"load_case": str, **kinds_of(ComparedModel)})

    def plot_loads(self, load_case: int = 0, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The share of each thread in a load case, one line per model."""
        place = place_among(len(self.comparison.load_cases), "load_case", load_case)
        return self.plot_figure("loads_by_model", ax, **look, load_case=place)


class PreloadViews(Result):
    __slots__ = ()
    preload: Preload

    def to_frame(self) -> pd.DataFrame:
        """Displacement, stiffness and loads of the sides, one row per external load."""
        points = self.preload.get("loads", [])
        frame = frame_of([dict(flat(point)) for point in points], kinds_of(PreloadPoint))
        bare_points = self.preload.get("without_preload", {}).get("loads")
        if bare_points is not None:
            bare = frame_of([dict(flat(p)) for p in bare_points], kinds_of(PreloadPoint))
            for name in ("axial_displacement_um", "tangent_stiffness_N_per_um"):
                frame[f"without_preload_{name}"] = bare[name]
        return frame

    def plot_displacement(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Displacement over the external load, with preload and without."""
        return self.plot_figure("preload", ax, **look, panel=0)

    def plot_stiffness(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Tangent stiffness over the external load, with preload and without."""
        return self.plot_figure("preload", ax, **look, panel=1)


class ResponseViews(Result):
    __slots__ = ()
    response: Response

    def to_frame(self) -> pd.DataFrame:
        """One row per sample, one column per series under its key."""
        series = {k: v for k, v in self.response.items() if isinstance(v, np.ndarray)}
        rows = [dict(zip(series, row, strict=True)) for row in zip(*series.values(), strict=True)]
        return frame_of(rows, dict.fromkeys(series, float))

    def plot_motion(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Positions, speeds and deflection over time."""
        return self.plot_figure("response_motion", ax, **look)

    def plot_force(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Forces and torques over time, impacts marked."""
        return self.plot_figure("response_force", ax, **look)

    def plot_energy(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """What motor and load put in, what was stored and what was lost."""
        return self.plot_figure("response_energy", ax, **look)

    def plot_frequency_response(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The frequency response, with the block `frequency_response`."""
        return self.plot_figure("response_frequency", ax, **look)


def _fit_note(one: FittedParameter) -> str:
    """What an interval says of a value that counts as identified."""
    if not one.identified:
        return "not identified: the data do not determine it"
    if one.at_bound:
        return f"ends at its bound `{one.at_bound}`"
    if one.low is None or one.high is None:
        return ""
    start, low, high, end = one["from"] if "from" in one else -math.inf, one.low, one.high, one.to
    if start >= 0.0 >= low:
        return "hardly identified: its interval contains zero"
    if one.scale == "log":
        start, low, high, end = map(math.log, (start, low, high, end))
    share = (min(high, end) - max(low, start)) / (end - start)
    return (
        f"hardly identified: its interval covers {share:.0%} of the bounds" if share >= 0.5 else ""
    )


class FitViews(Result):
    """Unknown inputs from measured curves, with their uncertainty."""

    __slots__ = ()
    fit: Fit

    def parameters_frame(self) -> pd.DataFrame:
        """Values with deviations and intervals, one row per parameter, offsets last.

        `low` and `high` are the ends of the interval of `level`, 90 % unless the fit states another
        one: `fit.level_percent`.
        """
        return frame_of([dict(flat(one)) for one in self.fit.parameters], {"name": str})

    def to_frame(self) -> pd.DataFrame:
        """`parameters_frame` with a `note` where the data hardly determine a value."""
        return self.parameters_frame().assign(note=[*map(_fit_note, self.fit.parameters)])

    def __repr__(self) -> str:
        notes = [(one.name, _fit_note(one)) for one in self.fit.parameters]
        said = "".join(f"; {name}: {note}" for name, note in notes if note)
        return f"{super().__repr__()[:-1]}{said}>"

    def residuals_frame(self) -> pd.DataFrame:
        """Readings, fit and residuals, one row per reading."""
        rows: list[dict[str, Any]] = []
        for curve in self.fit.curves:
            arrays = {key: value for key, value in curve.items() if isinstance(value, np.ndarray)}
            for k, line in enumerate(curve.line):
                row = {"curve": curve.name, "line": int(line), "unit": curve.unit}
                row |= {
                    key: value[k]
                    for key, value in arrays.items()
                    if key != "line" and k < len(value)
                }
                rows.append(row)
        return frame_of(rows, {"curve": str, "line": int, "unit": str})

    def covariance_frame(self) -> pd.DataFrame:
        """Covariance of the values, in their units."""
        import pandas as pd

        names = list(self.fit.covariance.names)
        matrix = np.asarray(self.fit.covariance.matrix, dtype=float).reshape(len(names), len(names))
        return pd.DataFrame(matrix, index=names, columns=names)

    def bands_frame(self) -> pd.DataFrame:
        """Responses of `bands` with their uncertainty, one row per condition."""
        rows: list[dict[str, Any]] = []
        for band in self.fit.bands:
            for k, value in enumerate(band.value):
                row: dict[str, Any] = {"band": band.name, "unit": band.unit}
                for condition in band.conditions:
                    values = condition["values"]
                    row[condition.path] = values[k] if len(values) > 1 else values[0]
                row |= {"value": value}
                row |= {key: band[key][k] for key in ("standard_deviation", "low", "high")}
                rows.append(row)
        return frame_of(rows, {"band": str, "unit": str})

    @property
    def fitted_case(self) -> Case:
        """The case with the values in their places."""
        if not self.fit.converged:
            raise ValueError(f"the fit has the status {self.fit.status}: it has no fitted case")
        settings = [str(one.set).partition("=") for one in self.fit.parameters if "set" in one]
        return self._own_case().with_({path: value for path, _, value in settings})

    def plot_fit(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Each curve with its readings, its fit and its band."""
        return self.plot_figure("fit", ax, **look)

    def plot_residuals(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Residuals over the rows."""
        return self.plot_figure("residuals", ax, **look)

    def plot_correlation(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Correlation of the values."""
        return self.plot_figure("correlation", ax, **look)


class LifeViews(Result):
    __slots__ = ()
    life: Life

    def threads_frame(self) -> pd.DataFrame:
        """Equivalent load and life, one row per direction, interface and thread."""
        return _threads_frame(self._interfaces(), self._told, InterfaceLife)

    def rollers_frame(self) -> pd.DataFrame:
        """The threads of all rollers of a full mechanism, one row each; empty for a sector."""
        parts = [
            (names, each["rollers"]) for names, each in self._interfaces() if "rollers" in each
        ]
        return _threads_frame(parts, self._told, RollerLives)

    _told: ClassVar[Kinds] = {"direction": str, "interface": str}

    def _interfaces(self) -> Iterator[tuple[dict[str, str], Record]]:
        for direction in ("tension", "compression"):
            for interface in INTERFACES:
                if direction in self.life and interface in self.life[direction]:
                    names = {"direction": direction, "interface": interface}
                    yield names, self.life[direction][interface]

    def plot_lives(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """Life of each thread."""
        return self.plot_figure("thread_lives", ax, **look)

    def plot_cycles(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """How many load cycles have which range and mean (rainflow)."""
        return self.plot_figure("rainflow", ax, **look)


class DerivativesViews(Result):
    """Responses of a case with their derivatives."""

    __slots__ = ()
    derivatives: list[Values]

    def to_frame(self) -> pd.DataFrame:
        """Derivative, elasticity and error, one row per response and factor."""
        rows = [
            {"response": response.response, "value": response.get("value"), **by.to_dict()}
            for response in self.derivatives
            for by in response["by"]
        ]
        return frame_of(rows, {"response": str, "value": float, "path": str, "derivative": float})

    def plot_elasticities(
        self, response: str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """What 1 % of each factor does to a response, in percent."""
        return self.plot_figure("elasticities", ax, **look, response=response)


class StudyViews(Result):
    """A study: what its designs say together, and every one of them."""

    __slots__ = ("_designs", "_rows", "_study")
    study: Values
    summary: Values
    envelope: Values | None
    _designs: Designs | None
    _rows: _engine.StudyRows | None
    _study: _engine.Study | None

    def __init__(
        self,
        document: _engine.Document,
        designs: Designs | None = None,
        study: _engine.Study | None = None,
        rows: _engine.StudyRows | None = None,
    ) -> None:
        super().__init__(document)
        object.__setattr__(self, "_designs", designs)
        object.__setattr__(self, "_rows", rows)
        object.__setattr__(self, "_study", study)

    @property
    def all_designs(self) -> Designs:
        """Inputs and answers of all designs, without the base case.

        Of a result that was read from JSON, those that the document holds.
        """
        return self._with_base[1:]

    @property
    def base(self) -> Designs:
        """The base case, as one design."""
        return self._with_base[:1]

    @property
    def _with_base(self) -> Designs:
        """As the document has them: the base case first."""
        if self._designs is None:
            if self._rows is not None and self._study is not None:
                source = self._case._case.source
                designs = study_designs(source, self._study, self._rows, self.study.command)
            else:
                designs = _designs_of_document(self)
            object.__setattr__(self, "_designs", designs)
        assert self._designs is not None
        return self._designs

    def to_frame(self) -> pd.DataFrame:
        """Inputs, status, reason and responses, one row per design; the base case is `base`."""
        return self.all_designs.to_frame()

    def statistics_frame(self) -> pd.DataFrame:
        """Mean, deviation, extremes and quantiles, one row per response.

        `min_design` and `max_design` count the base case as 0: the first of `all_designs` is 1.
        """
        import pandas as pd

        rows = {}
        for response, statistics in self.summary["statistics"].items():
            row = dict(flat(statistics))
            rows[response] = {
                name.replace("quantiles_", "quantile_"): value
                for name, value in row.items()
                if not name.startswith("histogram")
            }
        frame = frame_of(rows.values())
        frame.index = pd.Index(list(rows), dtype="str")
        return frame

    def envelope_frame(self) -> pd.DataFrame:
        """The points of the envelope: design, inputs, measures and the envelope's value.

        `design` counts the base case as 0: the first of `all_designs` is 1.
        """
        drawn = [i for factor in self.study.factors for i in (factor, *factor.get("with", []))]
        units = {each["path"]: each.get("unit", "") for each in drawn}
        rows = [
            {
                "name": point["name"],
                "design": point.get("design"),
                **{
                    _with_unit(path, units.get(path, "")): setting.get(
                        "number", setting.get("value")
                    )
                    for path, setting in point["settings"].items()
                },
                **point["responses"].to_dict(),
                "envelope": point["envelope"],
            }
            for point in ([] if self.envelope is None else self.envelope.get("points", []))
        ]
        return frame_of(rows, {"name": str, "design": int, "envelope": float})

    def plot(
        self, response: str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """A response over the numeric factor with most values, one line per value of the others."""
        return self.plot_figure("lines", ax, **look, response=response)

    def plot_map(
        self,
        response: str | None = None,
        x: str | None = None,
        y: str | None = None,
        ax: Axes | None = None,
        **look: Unpack[Look],
    ) -> Axes:
        """A response of a grid over two factors, as filled contours."""
        return self.plot_figure("map", ax, **look, response=response, x=x, y=y)

    def plot_threads(
        self,
        response: str | None = None,
        factor: str | None = None,
        ax: Axes | None = None,
        **look: Unpack[Look],
    ) -> Axes:
        """An array such as `screw.load_rate_percent` over a factor, as filled contours."""
        return self.plot_figure("surface", ax, **look, response=response, x=factor)

    def plot_histogram(
        self, response: str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """How often a response has which value, with its quantiles."""
        return self.plot_figure("histogram", ax, **look, response=response)

    def plot_contributions(
        self, response: str | None = None, ax: Axes | None = None, **look: Unpack[Look]
    ) -> Axes:
        """Which factor moves a response, from its linear surface."""
        return self.plot_figure("contributions", ax, **look, response=response)

    def plot_envelope(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The envelope of several measures over two factors, with its points."""
        return self.plot_figure("envelope", ax, **look)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._restored, (self.to_json(), self._with_base)

    @classmethod
    def _restored(cls, text: str, designs: Designs) -> Self:
        return cls(_engine.Document.from_text(text), designs)


def _designs_of_document(result: StudyViews) -> Designs:
    rows = result["designs"] if "designs" in result else []
    responses = tuple(result.study["responses"])
    values = np.array(
        [[numbers.get(name, np.nan) for name in responses] for numbers in map(_numbers_of, rows)],
        dtype=np.float64,
    ).reshape(len(rows), len(responses))
    status = np.array([row["status"] for row in rows], dtype=object)
    reason = np.array([row.get("reason", "") for row in rows], dtype=object)
    return Designs(_inputs_of_document(result.study, rows), responses, values, status, reason)


def _numbers_of(row: Record) -> dict[str, float]:
    """Responses of a design, those that are arrays entry by entry."""
    numbers: dict[str, float] = row["responses"].to_dict()
    for path, entries in (row["arrays"].to_dict() if "arrays" in row else {}).items():
        numbers |= {f"{path}[{k}]": entry for k, entry in enumerate(entries)}
    return numbers


def _inputs_of_document(study: Record, rows: list[Record]) -> pd.DataFrame:
    """What `study_inputs` gives, of a study that was read from JSON."""
    import pandas as pd

    settings = [row["settings"].to_dict() for row in rows]
    uses = Counter(study["responses"])
    columns: dict[str, Any] = {}
    for factor in study["factors"]:
        inputs = [factor, *factor.get("with", [])]
        paths = {drawn["path"] for drawn in inputs}
        one_at_a_time = study["plan"] == "one_at_a_time"
        sets = [not one_at_a_time or paths == row.keys() for row in settings]
        for drawn in inputs:
            base = drawn["base"].to_dict() if "base" in drawn else {}
            values = [
                row.get(drawn["path"], base) if is_set else base
                for row, is_set in zip(settings, sets, strict=True)
            ]
            numeric = all("number" in value for value in values if value)
            name = _with_unit(drawn["path"], drawn.get("unit", "") if numeric else "")
            uses[name] += 1
            if uses[name] > 1:
                name += f"_{uses[name]}"
            found = [value.get("number" if numeric else "value") for value in values]
            columns[name] = as_counts(name, np.array(found, dtype=float)) if numeric else found
    return pd.DataFrame(columns)


def _with_unit(path: str, unit: str) -> str:
    return f"{path}_{_engine.unit_key(unit)}" if unit else path


class OptimizationViews(Result):
    """The Pareto front of an optimization and the compromise chosen on it."""

    __slots__ = ("_best",)
    optimize: Values
    _best: Any  # Case | None

    def __init__(self, document: _engine.Document, best: Case | None = None) -> None:
        super().__init__(document)
        object.__setattr__(self, "_best", best)

    @property
    def best_case(self) -> Case:
        """The case with the chosen design written into it.

        Of the compromise or, where no design keeps all limits, of the one nearest to it.
        """
        best: Case | None = self._best
        if best is None:
            raise ValueError("a result that was read from JSON has no case; run `optimize`")
        return best

    def front_frame(self) -> pd.DataFrame:
        """Variables and responses of the designs of the front: columns of `front.csv`.

        Its column `compromise` is not among them, `compromise.design` of the result is that
        design. The front is that of both searches, where there is a check.
        """
        tried = {
            design["design"]: design
            for search in ("search", "check")
            if search in self
            for design in self[search]["front"]
        }
        units = {variable["path"]: variable.get("unit", "") for variable in self.optimize.variables}
        rows = []
        for design in map(tried.__getitem__, self["front"]):
            row = {"design": design["design"]}
            for path, variable in design["variables"].items():
                name = _with_unit(path, units.get(path, ""))
                row[name] = variable.get("number", variable.get("value"))
            rows.append(row | design["responses"].to_dict())
        return frame_of(rows, {"design": int})

    def constraints_frame(self) -> pd.DataFrame:
        """Value and limit of each constraint, for the file's own design and the compromise."""
        rows = [
            {"of": of, **constraint.to_dict()}
            for of in ("initial", "compromise")
            for constraint in (self[of].get("constraints", []) if of in self else [])
        ]
        return frame_of(rows, {"of": str})

    def plot_front(self, ax: Axes | None = None, **look: Unpack[Look]) -> Axes:
        """The front in its first two objectives, with the file's own design and the compromise."""
        return self.plot_figure("front", ax, **look)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._restored, (self.to_json(), self._best)

    @classmethod
    def _restored(cls, text: str, best: Case | None) -> Self:
        return cls(_engine.Document.from_text(text), best)
