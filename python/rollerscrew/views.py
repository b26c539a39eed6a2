"""Data frames and pictures of results, which take them by name: `SlipResult` those of `SlipViews`.

A docstring of views is that of the result and of the method of `Case` too; without one these have
the help of the program. Keys are annotated where methods here use them; `_block` is the key that
tells a document, where that is neither the command's name nor the last that must be there.

Every `plot_` method draws into `ax`, or all panels into a new figure, and returns the (first) axes.
`figures()` describes the pictures for other tools.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, Self

import numpy as np
import pandas as pd

from rollerscrew import _engine
from rollerscrew.designs import Designs, designs_of, study_inputs
from rollerscrew.record import Record, Result, Values
from rollerscrew.records import (
    Comparison,
    Contacts,
    HeatCycle,
    Life,
    LoadCase,
    Measures,
    Model,
    Preload,
    Threads,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rollerscrew.case import Case

INTERFACES = ("screw", "nut")

#: Load cases by their places or names: one, or several.
Which = int | str | Iterable[int | str]


def _flat(record: Record, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """The values of a record and the records in it that are no arrays or lists."""
    for name, value in record.items():
        if isinstance(value, Record):
            yield from _flat(value, f"{prefix}{name}_")
        elif not isinstance(value, np.ndarray | list):
            yield f"{prefix}{name}", value


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


def _interfaces(record: Record) -> pd.DataFrame:
    """The threads of both interfaces, one below the other."""
    frames = []
    for interface in INTERFACES:
        if interface in record:
            frame = pd.DataFrame(_arrays(record[interface]))
            frame.insert(0, "interface", interface)
            frames.append(frame)
    return pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()


class InputValue(Record):
    """One value of the resolved case."""

    __slots__ = ()
    path: str
    value: str
    default: bool
    basis: str
    reason: str
    origin: str
    written: str


class CheckViews(Result):
    """What the case is ready for, what is unusual about it, every value with its default."""

    __slots__ = ()
    _block = "input"
    input: list[InputValue]

    def to_frame(self) -> pd.DataFrame:
        """Path, value, whether it is a default, and what the value rests on, a row each."""
        return pd.DataFrame([value.to_dict() for value in self.input])

    def plot_contact_points(self, ax: Axes | None = None) -> Axes:
        """The contacts seen along the axis."""
        return self.plot_figure("contact_xy", ax)


class LoadCasesResult(Result):
    """A result with load cases."""

    __slots__ = ()
    contact: Contacts
    threads: Threads
    model: Model
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
            return range(len(names))[which]
        if which not in names:
            raise KeyError(f"no load case {which!r}; there is {', '.join(names) or 'none'}")
        return names.index(which)

    def _one(self, which: int | str | None) -> int | None:
        """None: the picture is that of the largest force."""
        return None if which is None else self._place(which)

    def _places(self, which: Which | None) -> list[int] | None:
        if which is None:
            return None
        chosen = [which] if isinstance(which, str | int) else which
        return [self._place(each) for each in chosen]

    @property
    def converged(self) -> bool:
        """Whether every load case did."""
        return all(load_case.converged for load_case in self._load_cases)

    def load_cases_frame(self) -> pd.DataFrame:
        """Force, status, displacement and stiffness, one row per load case."""
        skipped = {"screw", "nut", "slip", "measures"}
        rows = [
            {k: v for k, v in case.items() if k not in skipped and not isinstance(v, list)}
            for case in self._load_cases
        ]
        return pd.DataFrame(rows).rename(columns={"name": "case"})

    def threads_frame(self) -> pd.DataFrame:
        """Loads, ellipses and pressures, one row per load case, interface and thread."""
        return self._by_case((case, case) for case in self._load_cases)

    def plot_load_distribution(
        self, load_cases: Which | None = None, ax: Axes | None = None
    ) -> Axes:
        """Share of each thread in the load."""
        return self.plot_figure("load_distribution", ax, load_cases=self._places(load_cases))

    def plot_pressures(self, load_cases: Which | None = None, ax: Axes | None = None) -> Axes:
        """Peak pressure of each thread."""
        return self.plot_figure("peak_pressure", ax, load_cases=self._places(load_cases))

    def plot_ellipses(self, load_case: int | str | None = None, ax: Axes | None = None) -> Axes:
        """Contact ellipses of the threads, to scale."""
        return self.plot_figure("ellipses", ax, load_case=self._one(load_case))

    def plot_contact_points(self, ax: Axes | None = None) -> Axes:
        """The contacts seen along the axis."""
        return self.plot_figure("contact_xy", ax)

    def _by_case(self, threads: Iterable[tuple[LoadCase, Record]]) -> pd.DataFrame:
        """The threads of records of load cases, one below the other, with what tells them apart."""
        columns: dict[str, list[Any]] = {}
        rows = 0
        for case, record in threads:
            told = {"case": case.name}
            told |= {key: case.get(key) for key in ("axial_force_N", "direction", "position_mm")}
            for interface in INTERFACES:
                if interface not in record:
                    continue
                arrays = _arrays(record[interface])
                count = len(arrays["thread"])
                constant = {**told, "interface": interface}
                for name, value in [*constant.items(), *arrays.items()]:
                    column = columns.setdefault(name, [np.full(rows, np.nan)] if rows else [])
                    column.append(np.full(count, value) if name in constant else value)
                rows += count
                for name, column in columns.items():
                    if name not in constant and name not in arrays:
                        column.append(np.full(count, np.nan))
        return pd.DataFrame({name: np.concatenate(column) for name, column in columns.items()})


class ContactViews(LoadCasesResult):
    """Contact points, backlash, curvatures; ellipses where materials and equal shares are given."""

    __slots__ = ()

    def to_frame(self) -> pd.DataFrame:
        """Contact quantities, one column per interface; of pairs and vectors a row each number."""
        return pd.DataFrame({name: _numbers(self.contact[name]) for name in INTERFACES})


class SolveViews(LoadCasesResult):
    """Load distribution, pressures, displacement and stiffness of every load case.

    A load case that does not converge is a result with its status.
    """

    __slots__ = ()

    def plot_stiffness(self, ax: Axes | None = None) -> Axes:
        """Axial stiffness against the load, one line per sweep."""
        return self.plot_figure("stiffness", ax)

    def plot_displacement(self, ax: Axes | None = None) -> Axes:
        """Axial displacement against the load, one line per sweep."""
        return self.plot_figure("displacement", ax)

    def plot_butterfly(self, interface: str = "screw", ax: Axes | None = None) -> Axes:
        """Share of each thread against the load: they spread like wings as the load grows."""
        return self.plot_figure("butterfly", ax, interface=interface)

    def plot_convergence(self, ax: Axes | None = None) -> Axes:
        """Residual after each linear solve."""
        return self.plot_figure("convergence", ax)


class SlipViews(SolveViews):
    __slots__ = ()
    heat_cycle: HeatCycle  #: Where the case has a duty.

    def slip_frame(self) -> pd.DataFrame:
        """Slip ratio, efficiency, powers and torques, one row per load case."""
        rows = [
            {
                "case": case.name,
                "axial_force_N": case.get("axial_force_N"),
                **dict(_flat(case.slip)),
            }
            for case in self._load_cases
            if "slip" in case
        ]
        return pd.DataFrame(rows)

    def slip_threads_frame(self) -> pd.DataFrame:
        """Power, friction, sliding and film, one row per load case, interface and thread."""
        return self._by_case((case, case.slip) for case in self._load_cases if "slip" in case)

    def heat_frame(self) -> pd.DataFrame:
        """Steady temperatures and the heat that goes into each part, one row per load case."""
        rows = [
            {"case": case.name, **dict(_flat(case.heat))}
            for case in self._load_cases
            if "heat" in case
        ]
        return pd.DataFrame(rows)

    def heat_cycle_frame(self) -> pd.DataFrame:
        """Temperatures of the parts over the cycle of the duty, one row per time; empty without."""
        if "heat_cycle" not in self:
            return pd.DataFrame()
        cycle = self.heat_cycle
        return pd.DataFrame(
            {
                "time_s": cycle.time_s,
                **{f"{part}_degC": values for part, values in cycle.temperature_degC.items()},
            }
        )

    def plot_heat_cycle(self, ax: Axes | None = None) -> Axes:
        """Temperatures of the parts over the cycle of the duty."""
        return self.plot_figure("heat_cycle", ax)

    def plot_power(self, load_case: int | str = 0, ax: Axes | None = None) -> Axes:
        """Power that each thread of a roller dissipates."""
        return self.plot_figure("thread_power", ax, load_case=self._place(load_case))

    def plot_power_by_source(self, load_cases: Which | None = None, ax: Axes | None = None) -> Axes:
        """Where the power goes, a bar a load case."""
        return self.plot_figure("power_by_source", ax, load_cases=self._places(load_cases))

    def plot_friction(self, load_case: int | str | None = None, ax: Axes | None = None) -> Axes:
        """Friction coefficient and sliding speed of each thread."""
        return self.plot_figure("friction", ax, load_case=self._one(load_case))

    def plot_stribeck(self, load_case: int | str = 0, ax: Axes | None = None) -> Axes:
        """Friction, efficiency, power and film over the speed."""
        return self.plot_figure("stribeck", ax, load_case=self._place(load_case))


class MeasuresViews(SolveViews):
    __slots__ = ()
    measures: Measures

    def measures_frame(self) -> pd.DataFrame:
        """Measures of the mechanism, and of each load case under its name; units in the names."""
        rows = [("", name, value) for name, value in _flat(self.measures)]
        for case in self._load_cases:
            if "measures" in case:
                rows += [(case.name, name, value) for name, value in _flat(case.measures)]
        return pd.DataFrame(rows, columns=["load_case", "measure", "value"])

    def plot_stiffness_terms(self, ax: Axes | None = None) -> Axes:
        """The springs in series that make up the stiffness, by their part in the compliance."""
        return self.plot_figure("stiffness_terms", ax)


class SizeViews(Result):
    """Which screw, and which motor: candidates against a requirement, the best first."""

    __slots__ = ()
    _block = "candidates"

    def to_frame(self) -> pd.DataFrame:
        """Values of every candidate, one row each, by rank; units in the names."""
        return pd.DataFrame([dict(_flat(row)) for row in self["candidates"]])

    def criteria_frame(self) -> pd.DataFrame:
        """Value, limit, margin and status of every criterion of every candidate."""
        return pd.DataFrame(
            [
                {"rank": row.rank, "candidate": row.name, **criterion.to_dict()}
                for row in self["candidates"]
                for criterion in row.criteria
            ]
        )

    def plot_map(self, ax: Axes | None = None) -> Axes:
        """Candidates over diameter and lead, in the colour of what limits them."""
        return self.plot_figure("size_map", ax)

    def plot_curve(self, ax: Axes | None = None) -> Axes:
        """Force over speed of the first candidate, with what limits it."""
        return self.plot_figure("size_curve", ax)

    def plot_margins(self, ax: Axes | None = None) -> Axes:
        """Margins of the first five candidates."""
        return self.plot_figure("size_margins", ax)


class CompareViews(Result):
    """The models of the bodies side by side: stiffness, shares and pressures of each.

    `influence` is among them where the case asks for it, or where its matrices are kept.
    """

    __slots__ = ()
    comparison: Comparison

    def to_frame(self) -> pd.DataFrame:
        """Stiffness, displacement, largest shares, pressures: one row per load case and model."""
        rows = [
            {"load_case": load_case.name, **dict(_flat(model))}
            for load_case in self.comparison.load_cases
            for model in load_case.models
        ]
        return pd.DataFrame(rows)

    def plot_loads(self, load_case: int = 0, ax: Axes | None = None) -> Axes:
        """The share of each thread in a load case, one line per model."""
        return self.plot_figure("loads_by_model", ax, load_case=load_case)


class PreloadViews(Result):
    __slots__ = ()
    preload: Preload

    def to_frame(self) -> pd.DataFrame:
        """Displacement, stiffness and loads of the sides, one row per external load."""
        frame = pd.DataFrame([dict(_flat(point)) for point in self.preload.loads])
        if "without_preload" in self.preload:
            bare = pd.DataFrame([dict(_flat(p)) for p in self.preload.without_preload.loads])
            for name in ("axial_displacement_um", "tangent_stiffness_N_per_um"):
                frame[f"without_preload_{name}"] = bare[name]
        return frame

    def plot_displacement(self, ax: Axes | None = None) -> Axes:
        """Displacement over the external load, with preload and without."""
        return self.plot_figure("preload", ax, panel=0)

    def plot_stiffness(self, ax: Axes | None = None) -> Axes:
        """Tangent stiffness over the external load, with preload and without."""
        return self.plot_figure("preload", ax, panel=1)


class LifeViews(Result):
    __slots__ = ()
    life: Life

    def threads_frame(self) -> pd.DataFrame:
        """Equivalent load and life, one row per direction, interface and thread."""
        frames = []
        for direction in ("tension", "compression"):
            if direction in self.life:
                frame = _interfaces(self.life[direction])
                frame.insert(0, "direction", direction)
                frames.append(frame)
        return pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()

    def rollers_frame(self) -> pd.DataFrame:
        """The threads of all rollers of a full mechanism, a row each; empty of one sector."""
        frames = []
        for direction in ("tension", "compression"):
            for interface in INTERFACES:
                record = self.life[direction][interface] if direction in self.life else {}
                if "rollers" in record:
                    frame = pd.DataFrame(_arrays(record["rollers"]))
                    frame.insert(0, "interface", interface)
                    frame.insert(0, "direction", direction)
                    frames.append(frame)
        return pd.concat(frames, ignore_index=True) if frames else pd.DataFrame()

    def plot_lives(self, ax: Axes | None = None) -> Axes:
        """Life of each thread."""
        return self.plot_figure("thread_lives", ax)

    def plot_cycles(self, ax: Axes | None = None) -> Axes:
        """How many load cycles have which range and mean (rainflow)."""
        return self.plot_figure("rainflow", ax)


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
        return pd.DataFrame(rows)

    def plot_elasticities(self, response: str | None = None, ax: Axes | None = None) -> Axes:
        """What 1 % of each factor does to a response, in percent."""
        return self.plot_figure("elasticities", ax, response=response)


class StudyViews(Result):
    """A study: what its designs say together, and every one of them."""

    __slots__ = ("_designs", "_rows", "_study")
    study: Values
    summary: Values
    envelope: Values
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
        """Inputs and answers of all designs, the base case first.

        Of a result that was read from JSON, those that the document holds.
        """
        if self._designs is None:
            if self._rows is not None and self._study is not None:
                designs = designs_of(study_inputs(self._study), self._rows.designs())
            else:
                designs = _designs_of_document(self)
            object.__setattr__(self, "_designs", designs)
        assert self._designs is not None
        return self._designs

    def to_frame(self) -> pd.DataFrame:
        """Inputs, status, reason and responses, one row per design, the base case first."""
        return self.all_designs.to_frame()

    def statistics_frame(self) -> pd.DataFrame:
        """Mean, deviation, extremes and quantiles, one row per response."""
        rows = {}
        for response, statistics in self.summary["statistics"].items():
            row = dict(_flat(statistics))
            rows[response] = {
                name.replace("quantiles_", "quantile_"): value
                for name, value in row.items()
                if not name.startswith("histogram")
            }
        return pd.DataFrame.from_dict(rows, orient="index")

    def envelope_frame(self) -> pd.DataFrame:
        """The points of the envelope: design, inputs, measures and the envelope's value."""
        drawn = [i for factor in self.study.factors for i in (factor, *factor.get("with", []))]
        units = {each["path"]: each.get("unit", "") for each in drawn}
        rows = [
            {
                "name": point["name"],
                "design": point["design"],
                **{
                    _with_unit(path, units.get(path, "")): setting.get(
                        "number", setting.get("value")
                    )
                    for path, setting in point["settings"].items()
                },
                **point["responses"].to_dict(),
                "envelope": point["envelope"],
            }
            for point in (self.envelope.get("points", []) if "envelope" in self else [])
        ]
        return pd.DataFrame(rows)

    def plot(self, response: str | None = None, ax: Axes | None = None) -> Axes:
        """A response over the numeric factor with most values, a line each value of the others."""
        return self.plot_figure("lines", ax, response=response)

    def plot_map(
        self,
        response: str | None = None,
        x: str | None = None,
        y: str | None = None,
        ax: Axes | None = None,
    ) -> Axes:
        """A response of a grid over two factors, as filled contours."""
        return self.plot_figure("map", ax, response=response, x=x, y=y)

    def plot_histogram(self, response: str | None = None, ax: Axes | None = None) -> Axes:
        """How often a response has which value, with its quantiles."""
        return self.plot_figure("histogram", ax, response=response)

    def plot_contributions(self, response: str | None = None, ax: Axes | None = None) -> Axes:
        """Which factor moves a response, from its linear surface."""
        return self.plot_figure("contributions", ax, response=response)

    def plot_envelope(self, ax: Axes | None = None) -> Axes:
        """The envelope of several measures over two factors, with its points."""
        return self.plot_figure("envelope", ax)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._restored, (self.to_json(), self.all_designs)

    @classmethod
    def _restored(cls, text: str, designs: Designs) -> Self:
        return cls(_engine.Document.from_text(text), designs)


def _designs_of_document(result: StudyViews) -> Designs:
    rows = result["designs"] if "designs" in result else []
    responses = tuple(result.study["responses"])
    values = np.array(
        [[row["responses"].get(name, np.nan) for name in responses] for row in rows],
        dtype=np.float64,
    ).reshape(len(rows), len(responses))
    status = np.array([row["status"] for row in rows], dtype=object)
    reason = np.array([row.get("reason", "") for row in rows], dtype=object)
    return Designs(_inputs_of_document(result.study, rows), responses, values, status, reason)


def _inputs_of_document(study: Record, rows: list[Record]) -> pd.DataFrame:
    """What `study_inputs` gives, of a study that was read from JSON."""
    settings = [row["settings"].to_dict() for row in rows]
    uses = Counter(study["responses"])
    columns = {}
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
            key, missing = ("number", np.nan) if numeric else ("value", None)
            columns[name] = [value.get(key, missing) for value in values]
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

        The front is that of both searches, where there is a check.
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
        return pd.DataFrame(rows)

    def constraints_frame(self) -> pd.DataFrame:
        """Value and limit of each constraint, for the file's own design and the compromise."""
        rows = [
            {"of": of, **constraint.to_dict()}
            for of in ("initial", "compromise")
            for constraint in (self[of].get("constraints", []) if of in self else [])
        ]
        return pd.DataFrame(rows)

    def plot_front(self, ax: Axes | None = None) -> Axes:
        """The front in its first two objectives, with the file's own design and the compromise."""
        return self.plot_figure("front", ax)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._restored, (self.to_json(), self._best)

    @classmethod
    def _restored(cls, text: str, best: Case | None) -> Self:
        return cls(_engine.Document.from_text(text), best)
