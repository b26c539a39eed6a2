"""Load cases as an engineer names them: sweeps, configurations, interfaces."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from rollerscrew.plots._canvas import shown

if TYPE_CHECKING:
    import numpy.typing as npt

    from rollerscrew.records import InterfaceLoads, LoadCase

INTERFACES = ("screw", "nut")
SIDES = {"screw": "screw–roller", "nut": "roller–nut"}

_POINT = re.compile(r"(?P<sweep>.+)\[\d+\]", re.DOTALL)


@dataclass(frozen=True)
class Sweep:
    """The load cases of one range of loads, `NAME[0]`, `NAME[1]`, ..., or a single one."""

    name: str
    direction: str | None
    is_range: bool
    cases: tuple[LoadCase, ...]

    @property
    def configuration(self) -> str:
        """The name without the direction at its end: `config1` of `config1-tension`."""
        if self.direction is None or not self.name.endswith(self.direction):
            return self.name
        return self.name.removesuffix(self.direction).rstrip("-_ .") or self.name

    @property
    def forces_kN(self) -> npt.NDArray[np.float64]:
        return np.array([case.axial_force_N / 1e3 for case in self.cases])

    @property
    def last(self) -> LoadCase:
        """The case with the largest load."""
        return max(self.cases, key=lambda case: abs(case.axial_force_N))


def sweeps(
    cases: Sequence[LoadCase], keep: Callable[[LoadCase], bool] = lambda case: True
) -> list[Sweep]:
    """The cases to keep, by ascending load within each sweep, sweeps in the order of the file."""
    found: dict[tuple[str, str | None], Sweep] = {}
    for place, case in enumerate(cases):
        if not keep(case):
            continue
        point = _POINT.fullmatch(case.name)
        name = point["sweep"] if point else case.name
        direction: str | None = case.get("direction")
        at = (name, direction) if point else (f"{place}\0{name}", direction)
        sweep = found.setdefault(at, Sweep(name, direction, point is not None, ()))
        found[at] = replace(sweep, cases=(*sweep.cases, case))
    return [
        replace(sweep, cases=tuple(sorted(sweep.cases, key=lambda case: case.axial_force_N)))
        for sweep in found.values()
    ]


def force_text(case: LoadCase) -> str:
    return f"{case.axial_force_N / 1e3:.4g} kN"


def case_labels(cases: Sequence[LoadCase]) -> list[str]:
    return [shown(case.name) for case in cases]


def sense(case: LoadCase) -> float:
    """+1 in tension, -1 in compression; without a direction the force has its sign."""
    return -1.0 if case.get("direction") == "compression" else 1.0


def loads_of(case: LoadCase, interface: str) -> InterfaceLoads:
    loads: InterfaceLoads = case[interface]
    return loads


def has_loads(case: LoadCase) -> bool:
    return "screw" in case and "nut" in case


def require_loads(cases: Sequence[LoadCase]) -> list[LoadCase]:
    """The cases; ValueError where there is none, or where one has no thread loads."""
    if not cases:
        raise ValueError(
            "no load case has thread loads: expected one that converged, or equal shares"
        )
    for case in cases:
        if not has_loads(case):
            raise ValueError(f"load case {case.name!r} has no thread loads: {case.status}")
    return list(cases)


def known_interface(interface: str) -> str:
    if interface not in INTERFACES:
        raise ValueError(f"no interface {interface!r}; there is {', '.join(INTERFACES)}")
    return interface
