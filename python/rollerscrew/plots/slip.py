"""Pictures of friction and dissipated power."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import (
    BLUE,
    DASHED,
    GREEN,
    ORANGE,
    PURPLE,
    SKY,
    SOLID,
    VERMILLION,
    canvas,
    keep_ticks,
    key,
    legend,
    numbers,
    shown,
    thread_axis,
)
from rollerscrew.plots._cases import INTERFACES, SIDES, Sweep, force_text, sense, sweeps

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.records import LoadCase, Slip

_SOURCES = {
    "screw": ("screw–roller", BLUE, ""),
    "nut": ("roller–nut", SKY, "////"),
    "carrier_roller": ("carrier–roller", ORANGE, ""),
    "carrier_screw": ("carrier–screw", GREEN, "\\\\\\\\"),
    "carrier_nut": ("carrier–nut", PURPLE, "...."),
}
_LOOKS: dict[str, dict[str, Any]] = {
    "screw": {"linestyle": SOLID, "marker": "o"},
    "nut": {"linestyle": DASHED, "marker": "s", "markerfacecolor": "white"},
}
_MOST_BARS = 12


def power(load_case: LoadCase, ax: Axes | None = None) -> Axes:
    """Power in W that each thread of one roller dissipates, at both interfaces."""
    slip = _slip_of(load_case)
    with canvas(ax) as on:
        handles: list[Artist] = []
        for side, colour in zip(INTERFACES, (BLUE, VERMILLION), strict=True):
            values = numbers(slip[side].power_W)
            handles += on.ax.plot(
                _threads(values), values, color=colour, label=SIDES[side], **_LOOKS[side]
            )
        thread_axis(on.ax, len(slip.screw.power_W))
        on.ax.set_ylim(bottom=0.0, auto=None)
        on.ax.set_ylabel("Power loss of a thread (W)")
        legend(on, handles)
        return on.ax


def friction(load_case: LoadCase, ax: Axes | None = None) -> Axes:
    """Friction coefficient (left) and sliding speed in mm/s (right) of each thread."""
    slip = _slip_of(load_case)
    with canvas(ax) as on:
        right = on.ax.twinx()
        right.spines["right"].set_visible(True)
        if on.own:
            keep_ticks(right)
        scales = (  # The room above keeps the lines apart.
            (on.ax, "friction_coefficient", "Friction coefficient", BLUE, 1.06),
            (right, "sliding_speed_mm_per_s", "Sliding speed (mm/s)", VERMILLION, 1.7),
        )
        handles: list[Artist] = []
        for axes, quantity, label, colour, room in scales:
            largest = 0.0
            for side in INTERFACES:
                values = numbers(slip[side][quantity])
                axes.plot(
                    _threads(values),
                    values,
                    color=colour,
                    label=f"{label}, {SIDES[side]}",
                    **_LOOKS[side],
                )
                largest = max(largest, float(np.nanmax(np.abs(values), initial=0.0)))
            top = room * largest if largest > 0.0 else 1.0
            axes.set_ylim(-0.04 * top, top)
            axes.set_ylabel(label, color=colour)
            axes.tick_params(axis="y", labelcolor=colour)
        for side in INTERFACES:
            handles.append(key(SIDES[side], color="black", **_LOOKS[side]))
        thread_axis(on.ax, len(slip.screw.friction_coefficient))
        legend(on, handles)
        return on.ax


def power_by_source(load_cases: Sequence[LoadCase], ax: Axes | None = None) -> Axes:
    """Dissipated power in W by source: a bar a load case, or areas over the loads of one sweep.

    Of many load cases in several sweeps, those with the largest load are shown.
    """
    groups = sweeps(load_cases, lambda case: "slip" in case and case.slip.converged)
    if not groups:
        raise ValueError("no load case has a converged slip equilibrium")
    cases = [case for group in groups for case in group.cases]
    powers = {source: _powers(cases, source) for source in _SOURCES}
    powers = {source: values for source, values in powers.items() if values.max() > 0.0}
    if len(groups) == 1 and len(cases) > 2:
        return _power_over_load(groups[0], powers, ax)
    named = [shown(case.name, 18) for case in cases]
    if len(cases) > _MOST_BARS and len(groups) < len(cases):
        chosen = [cases.index(group.last) for group in groups]
        powers = {source: values[chosen] for source, values in powers.items()}
        named = [f"{shown(group.name, 18)}\n{force_text(group.last)}" for group in groups]
    return _power_bars(named, powers, ax)


def _power_bars(
    named: list[str], powers: dict[str, npt.NDArray[np.float64]], ax: Axes | None
) -> Axes:
    with canvas(ax, height_mm=66.0) as on:
        places = np.arange(len(named))
        below = np.zeros(len(named))
        handles: list[Artist] = []
        for source, values in powers.items():
            label, colour, hatch = _SOURCES[source]
            bars = on.ax.bar(
                places, values, 0.6, below, color=colour, hatch=hatch, edgecolor="black",
                linewidth=0.4, label=label,
            )  # fmt: skip
            handles.append(bars)  # type: ignore[arg-type]
            below += values
        on.ax.set_xticks(places, named)
        if sum(map(len, named)) > 44:
            on.ax.tick_params(axis="x", labelrotation=90 if len(named) > 8 else 30)
            for text in on.ax.get_xticklabels():
                text.set_horizontalalignment("center" if len(named) > 8 else "right")
                text.set_rotation_mode("default" if len(named) > 8 else "anchor")
        on.ax.tick_params(axis="x", length=0)
        on.ax.set_xlim(-0.6, max(len(named) - 0.4, 1.6))
        on.ax.set_ylabel("Power loss (W)")
        legend(on, handles)
        return on.ax


def _power_over_load(
    group: Sweep, powers: dict[str, npt.NDArray[np.float64]], ax: Axes | None
) -> Axes:
    forces = np.array([sense(case) * case.axial_force_N / 1e3 for case in group.cases])
    with canvas(ax) as on:
        areas = on.ax.stackplot(
            np.abs(forces),
            *powers.values(),
            labels=[_SOURCES[source][0] for source in powers],
            colors=[_SOURCES[source][1] for source in powers],
            linewidth=0.4,
            edgecolor="black",
        )
        for area, source in zip(areas, powers, strict=True):
            area.set_hatch(_SOURCES[source][2])
        on.ax.set_xlim(np.abs(forces).min(), np.abs(forces).max())
        on.ax.set_ylim(bottom=0.0, auto=None)
        on.ax.set_xlabel("Axial load (kN)")
        on.ax.set_ylabel("Power loss (W)")
        legend(on, areas)
        return on.ax


def _slip_of(case: LoadCase) -> Slip:
    if "slip" not in case:
        raise ValueError(f"load case {case.name!r} has no slip: {case.status}")
    if not case.slip.converged or "screw" not in case.slip:
        raise ValueError(
            f"the slip of load case {case.name!r} did not converge: {case.slip.status}"
        )
    return case.slip


def _powers(cases: Sequence[LoadCase], source: str) -> npt.NDArray[np.float64]:
    return np.array(
        [case.slip.power_loss_W * case.slip.share_percent.get(source, 0.0) / 100 for case in cases]
    )


def _threads(values: npt.NDArray[np.float64]) -> npt.NDArray[np.int_]:
    return np.arange(1, len(values) + 1)


__all__ = ["friction", "power", "power_by_source"]
