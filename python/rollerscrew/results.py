"""What the commands answer: documents with data frames and pictures.

Written by scripts/reference.py from the program's list of analyses and from views.py.
"""

from __future__ import annotations

from rollerscrew import _engine, records, views
from rollerscrew.record import Result, Values
from rollerscrew.views import LoadCasesResult

__all__ = [
    "CheckResult",
    "CompareResult",
    "ContactResult",
    "DerivativesResult",
    "FitResult",
    "LifeResult",
    "LoadCasesResult",
    "MeasuresResult",
    "OptimizationResult",
    "PreloadResult",
    "ResponseResult",
    "Result",
    "SizeResult",
    "SlipResult",
    "SolveResult",
    "StudyResult",
]


class CheckResult(views.CheckViews):
    """What the case is ready for, what is unusual about it, every value with its default."""

    __slots__ = ()
    _command = "check"
    commands: Values
    verdict: records.Verdict | None
    derived: Values
    contact: records.Contacts
    threads: records.Threads | None


class ContactResult(views.ContactViews):
    """Contact points, backlash, curvatures; ellipses where materials and equal shares are given."""

    __slots__ = ()
    _command = "contact"
    _block = "contact"
    contact: records.Contacts | None
    threads: records.Threads | None
    model: records.Model | None
    load_cases: list[records.LoadCase]


class SolveResult(views.SolveViews):
    """Load distribution, pressures, displacement and stiffness of every load case.

    A load case that does not converge is a result with its status.
    """

    __slots__ = ()
    _command = "solve"
    _block = "load_cases"
    contact: records.Contacts | None
    threads: records.Threads | None
    model: records.Model | None
    load_cases: list[records.LoadCase]


class CompareResult(views.CompareViews):
    """The models of the bodies side by side: stiffness, shares and pressures of each.

    `influence` is among them where the case asks for it, or where its matrices are kept.
    """

    __slots__ = ()
    _command = "compare"
    _block = "comparison"
    contact: records.Contacts
    threads: records.Threads | None
    comparison: records.Comparison
    references: list[records.ComparedReference] | None


class SlipResult(views.SlipViews, SolveResult):
    """Slip, friction, lost power, efficiency and torques."""

    __slots__ = ()
    _command = "slip"
    _block = "load_cases"
    contact: records.Contacts | None
    threads: records.Threads | None
    model: records.Model | None
    load_cases: list[records.LoadCase]
    heat_cycle: records.HeatCycle | None


class PreloadResult(views.PreloadViews):
    """Preload: curve through zero, lost motion, opening loads."""

    __slots__ = ()
    _command = "preload"
    _block = "preload"
    contact: records.Contacts
    threads: records.Threads | None
    preload: records.Preload


class LifeResult(views.LifeViews):
    """Life under a load history or spectrum, static safety."""

    __slots__ = ()
    _command = "life"
    _block = "life"
    contact: records.Contacts
    threads: records.Threads | None
    life: records.Life


class MeasuresResult(views.MeasuresViews, SolveResult):
    """Capacity, life, weight, stiffness, inertia and the other design measures."""

    __slots__ = ()
    _command = "measures"
    _block = "measures"
    contact: records.Contacts | None
    threads: records.Threads | None
    model: records.Model | None
    load_cases: list[records.LoadCase]
    measures: records.Measures


class ResponseResult(views.ResponseViews):
    """The screw in its drive: motion, forces, impacts, energies over time; frequency response."""

    __slots__ = ()
    _command = "response"
    _block = "response"
    response: records.Response


class StudyResult(views.StudyViews):
    """A study: what its designs say together, and every one of them."""

    __slots__ = ()
    _command = "study"
    _block = "study"
    designs_shown: int | None
    designs: list[Values]


class DerivativesResult(views.DerivativesViews):
    """Responses of a case with their derivatives."""

    __slots__ = ()
    _command = "study"
    _block = "derivatives"


class OptimizationResult(views.OptimizationViews):
    """The Pareto front of an optimization and the compromise chosen on it."""

    __slots__ = ()
    _command = "optimize"
    _block = "optimize"
    initial: Values
    compromise: Values | None
    nearest: Values | None
    front: records.Array
    search: Values
    check: Values | None
    comparison: Values | None


class FitResult(views.FitViews):
    """Unknown inputs from measured curves, with their uncertainty."""

    __slots__ = ()
    _command = "fit"
    _block = "fit"
    fit: records.Fit


class SizeResult(views.SizeViews):
    """Which screw, and which motor: candidates against a requirement, the best first."""

    __slots__ = ()
    _command = "size"
    requirement: records.SizeRequirement
    counts: records.SizeCounts
    objective: Values
    nearest: records.NearestMiss | None
    relax: records.Relaxation | None
    curve: records.SizeCurve | None
    invalid: list[records.InvalidCandidate]
    candidates: list[records.SizedCandidate]


class Analyses:
    """The commands that a case answers in one call."""

    __slots__ = ()
    _case: _engine.Case

    def check(self) -> CheckResult:
        """What the case is ready for, what is unusual about it, every value with its default."""
        return CheckResult._answer(self, "check")

    def contact(self) -> ContactResult:
        """Contact points, backlash, curvatures; ellipses where materials and equal shares are given."""
        return ContactResult._answer(self, "contact")

    def solve(self) -> SolveResult:
        """Load distribution, pressures, displacement and stiffness of every load case.

        A load case that does not converge is a result with its status.
        """
        return SolveResult._answer(self, "solve")

    def slip(self) -> SlipResult:
        """Slip, friction, lost power, efficiency and torques."""
        return SlipResult._answer(self, "slip")

    def preload(self) -> PreloadResult:
        """Preload: curve through zero, lost motion, opening loads."""
        return PreloadResult._answer(self, "preload")

    def measures(self) -> MeasuresResult:
        """Capacity, life, weight, stiffness, inertia and the other design measures."""
        return MeasuresResult._answer(self, "measures")

    def response(self) -> ResponseResult:
        """The screw in its drive: motion, forces, impacts, energies over time; frequency response."""
        return ResponseResult._answer(self, "response")
