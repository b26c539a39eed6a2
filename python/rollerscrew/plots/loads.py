"""Pictures of the load distribution, stiffness and displacement."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rollerscrew.plots._canvas import (
    COLOURS,
    DASHED,
    DASHES,
    MARKERS,
    REFERENCE,
    SOLID,
    Canvas,
    canvas,
    colour_bar,
    colours,
    key,
    legend,
    marks_every,
    numbers,
    shown,
    thread_axis,
)
from rollerscrew.plots._cases import (
    INTERFACES,
    SIDES,
    Sweep,
    case_labels,
    force_text,
    known_interface,
    loads_of,
    require_loads,
    sense,
    sweeps,
)

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.records import LoadCase

#: More single load cases than these are not told apart by markers.
_MOST_MARKED = len(MARKERS)

#: How the lines of an interface look: screw filled and solid, nut open and dashed.
INTERFACE_STYLES: dict[str, dict[str, Any]] = {
    "screw": {"linestyle": SOLID},
    "nut": {"linestyle": DASHED, "markerfacecolor": "white"},
}


def load_distribution(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Share of each thread in the load of a roller, in percent, with the mean share.

    Many loads of one sweep are told apart by a colour scale; of several sweeps the case with the
    largest load is shown.
    """
    cases = require_loads(load_cases)

    def mean(on: Canvas, threads: int) -> list[Artist]:
        return [on.ax.axhline(100.0 / threads, label="equal shares", **REFERENCE)]

    return _over_threads(cases, "load_rate_percent", "Share of the load (%)", ax, mean)


def pressures(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Peak pressure of each thread in MPa, both interfaces."""
    cases = require_loads(load_cases)
    for case in cases:
        if not any("peak_pressure_MPa" in loads_of(case, side) for side in INTERFACES):
            raise ValueError(
                f"load case {case.name!r} has no peak pressures: its contacts are given by Hertz "
                "constants and angles alone"
            )
    return _over_threads(cases, "peak_pressure_MPa", "Peak pressure (MPa)", ax)


def _over_threads(
    cases: list[LoadCase],
    quantity: str,
    label: str,
    ax: Axes | None,
    reference: Callable[[Canvas, int], list[Artist]] = lambda on, threads: [],
) -> Axes:
    """A quantity of both interfaces over the threads, a line a load case."""
    groups = sweeps(cases)
    by_force = len(cases) > _MOST_MARKED and len(groups) == 1
    named = case_labels(cases)
    title = None
    if len(cases) > _MOST_MARKED and len(groups) < len(cases) and not by_force:
        cases = [group.last for group in groups]
        named = [shown(group.name, 26) for group in groups]
        forces = list(dict.fromkeys(force_text(case) for case in cases))
        if len(forces) > 1:
            named = [f"{n}, {force_text(c)}" for n, c in zip(named, cases, strict=True)]
        else:
            title = f"axial load {forces[0]}"
    with canvas(ax) as on:
        threads = max(
            len(loads_of(case, side).axial_load_N) for case in cases for side in INTERFACES
        )
        extra = reference(on, threads)
        if by_force:
            handles = _lines_by_force(on, cases, quantity)
        else:
            handles = _lines_by_case(on, cases, named, quantity)
        thread_axis(on.ax, threads)
        on.ax.set_ylabel(label)
        legend(on, [*handles, *extra], title=title)
        return on.ax


def _lines_by_case(
    on: Canvas, cases: list[LoadCase], named: list[str], quantity: str
) -> list[Artist]:
    handles: list[Artist] = []
    marked = len(cases) <= _MOST_MARKED
    palette = colours(len(cases))
    for place, (case, name) in enumerate(zip(cases, named, strict=True)):
        look: dict[str, Any] = {"color": palette[place]}
        if marked:
            look["marker"] = MARKERS[place]
        for side in INTERFACES:
            _thread_line(on, case, side, quantity, f"{name}, {side}", look)
        handles.append(key(name, **look))
    if len(cases) == 1:
        handles = []
    for side in INTERFACES:
        look = {"color": palette[0] if len(cases) == 1 else "black", **INTERFACE_STYLES[side]}
        handles.append(key(SIDES[side], marker="o" if marked else "", **look))
    return handles


def _lines_by_force(on: Canvas, cases: list[LoadCase], quantity: str) -> list[Artist]:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    forces = [case.axial_force_N / 1e3 for case in cases]
    scale: Any = ScalarMappable(Normalize(min(forces), max(forces)), "viridis")
    for case, force in zip(cases, forces, strict=True):
        look = {"color": scale.to_rgba(force), "linewidth": 0.8}
        for side in INTERFACES:
            _thread_line(on, case, side, quantity, f"{shown(case.name)}, {side}", look)
    colour_bar(on, scale, "Axial load (kN)")
    return [
        key(SIDES[side], color="black", linestyle=INTERFACE_STYLES[side]["linestyle"])
        for side in INTERFACES
    ]


def _thread_line(
    on: Canvas, case: LoadCase, side: str, quantity: str, label: str, look: dict[str, Any]
) -> None:
    values = loads_of(case, side).get(quantity)
    if values is None:
        return
    on.ax.plot(
        np.arange(1, len(values) + 1),
        numbers(values),
        label=label,
        **look,
        **INTERFACE_STYLES[side],
    )


def stiffness(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Axial stiffness (force over displacement) in N/µm against the load in kN."""
    return _over_load(load_cases, "axial_stiffness_N_per_um", "Axial stiffness (N/µm)", ax)


def displacement(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Axial displacement in µm, > 0 in the direction of the load, against the load in kN."""
    return _over_load(load_cases, "axial_displacement_um", "Axial displacement (µm)", ax)


def _over_load(load_cases: Sequence[LoadCase], quantity: str, label: str, ax: Axes | None) -> Axes:
    groups = sweeps(load_cases, lambda case: quantity in case)
    if not groups:
        what = quantity.rsplit("_N_per_um")[0].removesuffix("_um").replace("_", " ")
        raise ValueError(
            f"no load case has an {what}: expected one that converged, not of equal shares"
        )
    configurations = list(dict.fromkeys(group.configuration for group in groups))
    palette = colours(len(configurations))
    with canvas(ax) as on:
        handles: list[Artist] = []
        for group in groups:
            place = configurations.index(group.configuration)
            compressed = group.direction == "compression"
            look: dict[str, Any] = {
                "color": palette[place],
                "marker": MARKERS[place % len(MARKERS)],
                "linestyle": "none" if len(group.cases) == 1 else DASHED if compressed else SOLID,
                "markevery": marks_every(len(group.cases)),
            }
            if compressed:
                look["markerfacecolor"] = "white"
            values = [float(case[quantity]) for case in group.cases]
            handles += on.ax.plot(group.forces_kN, values, label=shown(group.name), **look)
        on.ax.set_xlabel("Axial load (kN)")
        on.ax.set_ylabel(label)
        if len(handles) > 1:
            legend(on, handles)
        return on.ax


def butterfly(
    load_cases: Sequence[LoadCase], interface: str = "screw", ax: Axes | None = None
) -> Axes:
    """Load of each thread in percent of the mean, tension to the right, compression to the left."""
    known_interface(interface)
    groups = [group for group in sweeps(load_cases, lambda case: interface in case) if _wing(group)]
    if not groups:
        raise ValueError(
            "no sweep of loads: expected load cases with "
            "`axial_force: {from: .., to: .., steps: ..}` that converged"
        )
    configurations = list(dict.fromkeys(group.configuration for group in groups))
    threads = max(len(loads_of(group.last, interface).axial_load_N) for group in groups)
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm

    scale = ScalarMappable(
        BoundaryNorm(np.arange(0.5, threads + 1.0), threads),
        colormaps["viridis"].resampled(threads),
    )
    with canvas(ax, height_mm=68.0) as on:
        on.ax.axhline(100.0, **REFERENCE)
        for group in groups:
            place = configurations.index(group.configuration)
            _wing_lines(on, group, interface, scale, DASHES[place % len(DASHES)])
        if len({sense(group.last) for group in groups}) > 1:
            on.ax.axvline(0.0, **REFERENCE)
            on.ax.set_xlabel("Axial load (kN), compression < 0 < tension")
        else:
            direction = groups[0].direction
            on.ax.set_xlabel(f"Axial load (kN){f', {direction}' if direction else ''}")
        on.ax.set_ylabel(f"Thread load, {SIDES[interface]} (% of the mean)")
        ticks = sorted({1, *range(5, threads + 1, 5 * -(-threads // 40)), threads})
        colour_bar(on, scale, "Thread", ticks=ticks)
        if len(configurations) > 1:
            legend(
                on,
                [
                    key(shown(name), color="black", linestyle=DASHES[place % len(DASHES)])
                    for place, name in enumerate(configurations)
                ],
            )
        return on.ax


def _wing(group: Sweep) -> bool:
    return group.is_range and len(group.cases) > 1


def _wing_lines(on: Canvas, group: Sweep, interface: str, scale: Any, dashes: Any) -> None:
    forces = np.array([sense(case) * case.axial_force_N / 1e3 for case in group.cases])
    rates = np.array([loads_of(case, interface).load_rate_percent for case in group.cases])
    for thread, values in enumerate(rates.T * rates.shape[1], start=1):
        on.ax.plot(
            forces,
            values,
            color=scale.to_rgba(thread),
            linestyle=dashes,
            linewidth=1.0,
            label=f"{shown(group.name)}, thread {thread}",
        )


def convergence(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Relative residual after each linear solve, a line a load case."""
    cases = [case for case in load_cases if case.get("newton_history")]
    if not cases:
        raise ValueError(
            "no load case has a history of Newton's method; documents with many load cases, and "
            "equal shares, have none"
        )
    palette = colours(len(cases))
    with canvas(ax) as on:
        handles: list[Artist] = []
        longest = 0
        for place, (case, name) in enumerate(zip(cases, case_labels(cases), strict=True)):
            residuals = numbers([each.relative_residual for each in case.newton_history])
            longest = max(longest, len(residuals))
            handles += on.ax.plot(
                np.arange(1, len(residuals) + 1),
                np.where(residuals > 0.0, residuals, np.nan),
                color=palette[place],
                marker=MARKERS[place % len(MARKERS)],
                linestyle=DASHES[place % len(DASHES)],
                label=name,
            )
        on.ax.set_yscale("log")
        on.ax.set_xticks(range(1, longest + 1, -(-longest // 12)))
        on.ax.set_xlim(0.7, longest + 0.3)
        on.ax.set_xlabel("Linear solve")
        on.ax.set_ylabel("Relative residual")
        legend(on, handles if 1 < len(handles) <= 2 * len(COLOURS) else [])
        return on.ax


__all__ = [
    "butterfly",
    "convergence",
    "displacement",
    "load_distribution",
    "pressures",
    "stiffness",
]
