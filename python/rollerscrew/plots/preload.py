"""Pictures of a preloaded nut."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import (
    BLUE,
    DASHED,
    GREY,
    REFERENCE,
    SOLID,
    VERMILLION,
    Canvas,
    canvas,
    legend,
)

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.records import Preload, PreloadPoint


def preload_displacement(preload: Preload, ax: Axes | None = None) -> Axes:
    """Axial displacement in µm over the external load in kN, both > 0 in tension."""
    return _over_external_load(preload, "axial_displacement_um", "Axial displacement (µm)", ax)


def preload_stiffness(preload: Preload, ax: Axes | None = None) -> Axes:
    """Tangent stiffness in N/µm over the external load in kN, > 0 in tension."""
    return _over_external_load(
        preload, "tangent_stiffness_N_per_um", "Tangent stiffness (N/µm)", ax
    )


def _over_external_load(preload: Preload, quantity: str, label: str, ax: Axes | None) -> Axes:
    forces, values = _curve(preload.get("loads", []), quantity)
    if not np.isfinite(values).any():
        raise ValueError("no load of the preloaded nut converged")
    with canvas(ax) as on:
        on.ax.axvline(0.0, **REFERENCE)
        if quantity == "axial_displacement_um":
            on.ax.axhline(0.0, **REFERENCE)
        handles: list[Artist] = []
        has_play = "preload_force_N" not in preload
        look: dict[str, Any] = {"color": BLUE, "linestyle": SOLID, "linewidth": 1.4}
        handles += on.ax.plot(
            forces, values, label="with play" if has_play else "with preload", **look
        )
        if "without_preload" in preload:
            bare = _curve(preload.without_preload.get("loads", []), quantity)
            handles += on.ax.plot(*bare, color=GREY, linestyle=DASHED, label="without preload")
        handles += _openings(on, preload, forces, values)
        on.ax.set_xlabel("External axial load (kN), compression < 0 < tension")
        on.ax.set_ylabel(label)
        legend(on, handles)
        return on.ax


def _openings(
    on: Canvas,
    preload: Preload,
    forces: npt.NDArray[np.float64],
    values: npt.NDArray[np.float64],
) -> list[Artist]:
    """Where a side opens, on the curve."""
    opening = preload.get("opening_force_N")
    if opening is None:
        return []
    known = np.isfinite(values)
    senses = (("tension", 1.0), ("compression", -1.0))
    at = np.array([sign * opening[sense] / 1e3 for sense, sign in senses if sense in opening])
    at = at[(at >= forces[known].min()) & (at <= forces[known].max())]
    if not at.size:
        return []
    return [
        *on.ax.plot(
            at,
            np.interp(at, forces[known], values[known]),
            marker="o",
            linestyle="none",
            color=VERMILLION,
            markerfacecolor="white",
            label="a side opens",
        )
    ]


def _curve(
    points: Sequence[PreloadPoint], quantity: str
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Loads in kN, ascending, and values; NaN where a load did not converge."""
    ordered = sorted(points, key=lambda point: point.axial_force_N)
    forces = np.array([point.axial_force_N / 1e3 for point in ordered])
    return forces, np.array([point.get(quantity, np.nan) for point in ordered], dtype=np.float64)


__all__ = ["preload_displacement", "preload_stiffness"]
